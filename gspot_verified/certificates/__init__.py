"""Writing and reading certificates."""
