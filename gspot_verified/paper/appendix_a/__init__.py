"""Appendix A: Θ, its hypergeometric form and its asymptotics."""
