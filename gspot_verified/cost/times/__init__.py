"""Taking times, and the rows that they are written in."""
