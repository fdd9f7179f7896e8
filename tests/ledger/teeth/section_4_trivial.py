"""Wrong formulas for the trivial solution (Sec. 2) and its uniqueness (Sec. 4.1)."""

from __future__ import annotations

from typing import Any

from ledger.bite import Bite, Teeth, raised, replaced, scaled, unseen_at

from gspot_verified.ledger import section_4_trivial as ledger
from gspot_verified.ledger.entry import Entry

TRIVIAL, CORRECTED_ZY, UNIQUE = (
    ledger.PRINTED["2-trivial"],
    ledger.CORRECTED["2-trivial-zy"],
    ledger.PRINTED["4-unique"],
)
_AT_INTEGERS = range(-3, 4)


def ENTRIES() -> list[Entry]:
    """The entries of the module."""
    return [*ledger.entries(), *ledger.uniqueness_entries()]


def without_quotient(_: Any) -> Any:
    """α_2 a free symbol: without α_2 = c (α_1 - α_3)."""
    return lambda value: value


def at_an_integer(honest: Any) -> Any:
    """β = 3: C t³ is a smooth solution too, so the term C s³ of order 4 of b is free (C = 1)."""

    def terms(orders: int, chi: bool) -> Any:
        found = {name: [list(row) for row in rows] for name, rows in honest(orders, chi).items()}
        if orders > 4:
            one = found["z"][0][0] ** 0
            found["b"][4] = [0 * one, 0 * one, 0 * one, one]
        return found

    return terms


TEETH: Teeth = {
    "2-trivial": (
        Bite("factor", TRIVIAL, "p", scaled),
        Bite("factor", TRIVIAL, "b", scaled),
        Bite("hidden factor", TRIVIAL, "p", unseen_at("t", _AT_INTEGERS)),
        Bite("hidden factor", TRIVIAL, "b", unseen_at("alpha1", _AT_INTEGERS)),
        Bite("hypothesis", ledger, "_with_c", without_quotient),
        Bite("order", TRIVIAL, "p", raised("t")),
        Bite("order", TRIVIAL, "b", raised("eps")),
    ),
    "2-trivial-zy": (
        Bite("factor", CORRECTED_ZY, "z", scaled),
        Bite("factor", ledger.PRINTED["2-trivial-zy"], "z", lambda _: ledger.CORRECTED["2-trivial-zy"]["z"]),
        Bite("hidden factor", CORRECTED_ZY, "z", unseen_at("eps", _AT_INTEGERS)),
        Bite("hypothesis", ledger, "_with_c", without_quotient),
        Bite("order", CORRECTED_ZY, "z", replaced("eps^2", "eps^3")),
    ),
    "4-unique": (
        *(Bite("factor", UNIQUE, part, scaled) for part in UNIQUE),
        *(Bite("hidden factor", UNIQUE, part, unseen_at("t", _AT_INTEGERS)) for part in UNIQUE),
        Bite("hypothesis", ledger, "extended_terms", at_an_integer),
        Bite("hypothesis", ledger, "_with_c", without_quotient),
        *(Bite("order", UNIQUE, part, raised("t")) for part in UNIQUE),
    ),
}
