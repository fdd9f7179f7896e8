"""The state of a mechanism as a function of p, b, y, v near its G-spot."""
