"""From a state in slip to a G-spot, lift-off or the end of slip."""
