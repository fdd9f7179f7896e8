"""Steps whose error is bounded on a box around the solution."""
