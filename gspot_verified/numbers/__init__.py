"""Exact numbers, balls and verdicts: what everything else is said in."""
