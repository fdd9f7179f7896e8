"""From a state in slip to a G-spot, lift-off or stick."""
