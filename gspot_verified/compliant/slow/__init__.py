"""The slow solution at one epsilon: routes, plans, bounds."""
