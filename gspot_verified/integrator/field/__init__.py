"""A vector field in several arithmetics, and the events of its solutions."""
