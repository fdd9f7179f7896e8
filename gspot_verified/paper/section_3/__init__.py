"""Section 3: the simulations, Table 1, flight after lift-off."""
