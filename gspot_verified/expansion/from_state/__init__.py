"""From a state at a distance from the G-spot to lift-off or impact, for all epsilon at once: the model system."""
