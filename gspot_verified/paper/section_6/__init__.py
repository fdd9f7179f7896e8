"""Sections 6 and 7 and Appendix B: the oscillator and its runs."""
