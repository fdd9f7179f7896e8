"""The compliant motion from a state of the user's to the starts near the G-spot."""
