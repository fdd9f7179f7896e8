"""What is not compared with the paper's LaTeX, and why."""

from __future__ import annotations

NOT_QUOTED = "no entry's label cites these lines, so the data of the ledger do not hold them"
DEFINITION = "a definition or a premise; no entry holds it as a text"
NO_TEXT = "held as code, not as a text"
IN_A_SENTENCE = "in a sentence: compared in test_typed_numbers.py"
BY_CODE = (1021, 1202, 1726, 1731, 1942, 1988, 2004, 2026, 2113)
"""Displays that a row with entries claims: their code has the equation."""
UNREAD: dict[int, str] = {
    **dict.fromkeys((194, 246, 501, 757, 841, 1184, 1353, 1360, 1366, 1375, 1409, 1427, 1996, 2107), DEFINITION),
    **dict.fromkeys((460, 478, 1496, 1530, *BY_CODE), NO_TEXT),
    967: "eq. compl2 again",
    2194: IN_A_SENTENCE,
    1030: "held by cases, t <= 0 and t >= 0",
    **dict.fromkeys((1794, 1801, 1808), "two terms side by side in one formula"),
    2051: "brackets that do not match (lines 2054 to 2056)",
    2418: "c_0 = 1: held as the first of computed coefficients",
}
"""Displays by their first line, and why none of their formulas is compared."""
UNREAD_LINES: dict[int, str] = {
    **dict.fromkeys((538, 581), "no force out of contact: held as code"),
    1125: "the branch t >= 0, which is that of t <= 0 for -t",
    **dict.fromkeys((1262, 1263), "words: held as signs"),
    **dict.fromkeys((2141, 2144), "ξ and F: held as code"),
}
"""Lines of displays that are compared elsewhere, and why these are not."""
UNTYPED: dict[tuple[str, str], str] = {
    **{("4-roots-sum", part): IN_A_SENTENCE for part in ("sum", "product")},
    **{("1-beta", part): IN_A_SENTENCE for part in ("numerator", "denominator")},
    **{
        ("5-orders", f"{sum_} {part}"): "in the name of the sum"
        for sum_ in "bv"
        for part in ("left", "right", "first", "last")
    },
    **{("5-xinprime", part): "in the name of the sum" for part in ("left", "right", "first", "last")},
    **{("5-matching", f"power of {name}"): "read as one product" for name in ("kappa", "epsilon")},
    **{("2-stick", part): "read as one quotient" for part in ("numerator", "denominator")},
    **{
        ("S-gamma-intervals", f"{sign} {end}"): IN_A_SENTENCE
        for sign in ("negative", "positive")
        for end in ("from", "to")
    },
    ("4-order", "order"): IN_A_SENTENCE,
    ("5-orders", "p_0"): NOT_QUOTED,
    ("5-example-b", "error"): "the order of 5-example-b-error in its corrected form",
    ("5-example-b-error", "term 7"): "what the printed order says: no term of order 7",
    ("5-ansatz-solution", "r"): "a formula in a sentence that is not quoted alone",
    ("5-bpert-v", "factor"): "brackets that do not match (line 2056)",
}
"""Parts of the tables of polynomials that no row reads, and why."""
