"""A G-spot followed over one or two parameters."""
