"""Section 4.5: the three cases, signs of Γ(-β), the compliant model."""
