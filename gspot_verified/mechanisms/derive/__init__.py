"""The functions of Sec. 2 of the paper, derived from a mechanism."""
