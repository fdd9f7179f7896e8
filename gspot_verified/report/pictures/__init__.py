"""The canvas, and pictures of a user's own results."""
