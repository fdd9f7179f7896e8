"""Certificates of runs: what a checker that trusts nothing of the run needs to prove it again."""
