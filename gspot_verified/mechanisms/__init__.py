"""Mechanical systems with one frictional contact: their G-spots, their case, and the step to Theorem 1's expansion."""
