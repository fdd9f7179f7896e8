"""Signs: Gamma side-switching."""
