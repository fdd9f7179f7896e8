"""The real zeros of dΘ/dτ: how many, and brackets of them."""
