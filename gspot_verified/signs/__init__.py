"""Certain signs: of Γ(-β), of dΘ/dτ on ranges, and its zeros."""
