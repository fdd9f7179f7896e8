"""Sections 4.1 to 4.4: slow, fast, inner and outer expansions, and their matching."""
