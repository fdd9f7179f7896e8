"""Numerical results that only the paper needs."""
