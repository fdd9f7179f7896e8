"""The fast solutions and the coefficients of a state in them."""
