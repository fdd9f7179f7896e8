"""Sections 6 and 7 and Appendix B of the paper."""
