"""Section 1 of the paper."""
