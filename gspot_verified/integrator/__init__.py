"""Validated integration of ordinary differential equations dξ/dt = f(ξ), f a graph of expressions."""
