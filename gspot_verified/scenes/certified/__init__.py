"""Certified runs by the validated integrator."""
