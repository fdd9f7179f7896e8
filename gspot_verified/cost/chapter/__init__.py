"""What accuracy costs in time, and what it buys: one run over all parts of the library, kept as a file."""
