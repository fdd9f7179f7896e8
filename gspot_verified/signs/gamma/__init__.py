"""The sign of Γ(-β), and how many zeros dΘ/dτ has."""
