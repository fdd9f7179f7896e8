"""Models of the slow solution over rectangles of its parameters."""
