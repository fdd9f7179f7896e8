"""The recursion of Theorem 1 and the spaces of its terms."""
