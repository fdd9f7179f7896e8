"""Statements about the true solutions near the truncated expansion, for all delta in (0, delta_0] at once."""
