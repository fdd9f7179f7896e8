"""Wrong formulas for the uniqueness of the trivial solution (Sec. 4.1)."""

from __future__ import annotations

from typing import Any

from paper.bite import Bite, NotApplicable, Teeth, raised, replaced, scaled, unseen_at

from gspot_verified.paper.section_4 import section_4_unique as ledger
from gspot_verified.paper.section_4.section_4_outer import QUOTIENT

UNIQUE = ledger.PRINTED["4-unique"]
_AT_INTEGERS = range(-3, 4)


ENTRIES = ledger.ENTRIES


def at_an_integer(honest: Any) -> Any:
    """β = 3: C t³ is a smooth solution too, so the term C s³ of order 4 of b is free (C = 1)."""

    def terms(orders: int, chi: bool) -> Any:
        found = {name: [list(row) for row in rows] for name, rows in honest(orders, chi).items()}
        if orders > 4:
            one = found["z"][0][0] ** 0
            found["b"][4] = [0 * one, 0 * one, 0 * one, one]
        return found

    return terms


def without_quotient(_: Any) -> Any:
    """α_2 = c α_1: without c = α_2/(α_1 - α_3)."""
    return ledger.ALGEBRA.read("c*alpha1")


TEETH: Teeth = {
    "4-unique": (
        *(Bite("factor", UNIQUE, part, scaled) for part in UNIQUE),
        *(Bite("hidden factor", UNIQUE, part, unseen_at("t", _AT_INTEGERS)) for part in UNIQUE),
        Bite("hypothesis", ledger.FRACTION, "numerator", lambda _: "0*x"),
        Bite("hypothesis", ledger, "extended_terms", at_an_integer),
        Bite("hypothesis", QUOTIENT, "alpha2", without_quotient),
        *(Bite("order", UNIQUE, part, raised("t")) for part in UNIQUE),
    ),
    "4-unique-smooth": (
        *(Bite("factor", ledger.STEPS, part, scaled) for part in ("field", "recurrence")),
        *(Bite("hidden factor", ledger.STEPS, part, unseen_at("epsilon", (1, 2))) for part in ("field", "recurrence")),
        Bite("hidden factor", ledger.STEPS, "recurrence", unseen_at("k", range(12))),
        Bite("factor", ledger.STEPS, "first", replaced("(k+1)^3", "25*(k+1)^3")),
        Bite("factor", ledger.STEPS, "second", replaced("(k+2)^3", "4*(k+2)^3")),
        Bite("order", ledger.STEPS, "second", replaced("^3", "^4")),
        Bite("order", ledger.STEPS, "recurrence", replaced("epsilon*", "epsilon^2*")),
        Bite("order", ledger.STEPS, "radius", replaced("2*(4+x)^3", "2*(4+x)^4")),
        NotApplicable("hypothesis", "the second solution exists for every β: the claim fails without a hypothesis too"),
    ),
}
