"""Many mechanisms that differ in the values of their parameters: a table of them, classified row by row."""
