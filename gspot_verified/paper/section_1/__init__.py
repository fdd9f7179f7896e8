"""Section 1: the signs of α, the cases, the mass matrix, p < 0."""
