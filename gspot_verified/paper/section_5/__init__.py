"""Section 5: Theorem 1, its recursion and spaces, matching with the outer solution."""
