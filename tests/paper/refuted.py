"""The entries of the ledger whose printed statement is refuted; every other one is proved."""

REFUTED = {
    *("A-th5-condition", "S-mean-force", "S-gamma-intervals", "S-wording", "1-beta", "2-trivial-zy", "4-order"),
    *("4-inner-fast", "4-inner-scaling-v", "4-matching-middle", "5-monomial", "5-xinprime", "5-example-b-error"),
    *("5-fast-system", "5-ansatz-p0", "5-bpert-v", "6-sign-of-G", "4-unique-smooth", "4-behaves-like", "3-sides"),
    *("3-case-II", "3-table-1-one-series", "3-table-1-y-1_2"),
    *("1-stiffness", "1-poisson", "1-colours", "2-unilateral", "2-contact-part", "2-coupling", "3-trivial-shown"),
    *("3-caption-equations", "4-reference", "5-kinds", "5-brackets", "5-letters", "6-attribution"),
    *("6-colours", "S-gamma-name"),
    *("1-scalars", "5-typesetting", "5-approaching-side", "5-manifold-names"),
}
