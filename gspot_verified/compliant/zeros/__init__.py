"""The real zeros of the slow solution, at one epsilon and over ranges."""
