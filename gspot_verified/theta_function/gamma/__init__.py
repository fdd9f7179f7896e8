"""Γ, and the initial values of Θ that are made of it."""
