"""Formulas: read, named, simplified."""
