"""Theorem 1: the distinguished trajectory as an expansion in exact coefficients."""
