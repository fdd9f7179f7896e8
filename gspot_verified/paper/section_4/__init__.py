"""Sections 4.1 to 4.4 of the paper."""
