"""Section 4.5 of the paper."""
