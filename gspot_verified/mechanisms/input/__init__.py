"""A mechanism as a user writes it."""
