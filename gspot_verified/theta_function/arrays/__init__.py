"""Θ at many points at once."""
