"""Mechanisms that other programs wrote: the equations of sympy.mechanics, robots in URDF and MJCF."""
