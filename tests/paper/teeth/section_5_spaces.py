"""Wrong formulas for the lemma, the spaces of Theorem 1 and the corollary (Sec. 5)."""

from __future__ import annotations

from paper.bite import Bite, NotApplicable, Teeth, replaced, scaled, unseen_at

from gspot_verified.paper.section_5 import section_5_spaces as ledger
from gspot_verified.paper.section_5.explicit_expansions import LEMMA, SPACES

ENTRIES = ledger.ENTRIES
_NO_FACTOR = NotApplicable("factor", "spaces: a constant factor changes no exponent")
_NOTHING_HIDDEN = NotApplicable("hidden factor", "a space is one pair of shifts for all orders: none can be left out")

TEETH: Teeth = {
    "5-lemma-orders": (
        Bite("factor", ledger.LOWEST, "highest k", scaled, refutes=True),
        Bite("hidden factor", ledger.LOWEST, "highest k", unseen_at("n", range(8)), refutes=True),
        Bite("hypothesis", ledger.LOWEST, "order of xi_k", lambda _: "k + 1"),
        Bite("order", ledger.LOWEST, "highest k", lambda text: f"{text} + 1", refutes=True),
    ),
    "5-lemma": (
        _NO_FACTOR,
        _NOTHING_HIDDEN,
        Bite("hypothesis", SPACES, "xi", lambda _: (4, -3), refutes=True),
        Bite("hypothesis", SPACES, "xi", lambda _: (1, 0), refutes=True),
        Bite("order", LEMMA, "f", lambda shift: (shift[0] + 1, shift[1]), refutes=True),
        Bite("order", LEMMA, "f", lambda shift: (shift[0], shift[1] + 1), refutes=True),
        Bite("order", LEMMA, "f", lambda shift: (shift[0], shift[1] - 3), refutes=True),
        *(Bite("order", ledger.PROOF, name, replaced("9", "8")) for name in ledger.PROOF),
    ),
    "5-initial-values": (
        *(Bite("factor", ledger.STEP_4, name, scaled, refutes=True) for name in ledger.STEP_4),
        *(Bite("hidden factor", ledger.STEP_4, name, unseen_at("n", range(6)), refutes=True) for name in "pbyv"),
        Bite("hypothesis", ledger.LOWEST, "order of xi_k", lambda _: "k + 1"),
        *(Bite("order", ledger.STEP_4, name, lambda text: f"{text} + 1", refutes=True) for name in ledger.STEP_4),
    ),
    "5-theorem-1-spaces": (
        _NO_FACTOR,
        _NOTHING_HIDDEN,
        Bite("hypothesis", LEMMA, "f", lambda shift: (shift[0] + 3, shift[1])),
        Bite("hypothesis", LEMMA, "f", lambda shift: (shift[0], shift[1] + 3)),
        *(Bite("order", SPACES, name, lambda shift: (shift[0] + 1, shift[1]), refutes=True) for name in SPACES),
        *(Bite("order", SPACES, name, lambda shift: (shift[0], shift[1] + 1), refutes=True) for name in SPACES),
        *(Bite("order", SPACES, name, lambda shift: (shift[0], shift[1] - 3), refutes=True) for name in SPACES),
    ),
    "5-corollary": (
        *(Bite("factor", row, name, scaled, refutes=True) for row in ledger.COROLLARY.values() for name in row),
        *(
            Bite("hidden factor", row, name, unseen_at("sigma", range(4)), refutes=True)
            for row in ledger.COROLLARY.values()
            for name in row
        ),
        Bite("hypothesis", SPACES, "p", lambda shift: (shift[0] + 1, shift[1]), refutes=True),
        Bite("hypothesis", SPACES, "y", lambda shift: (shift[0] + 9, shift[1]), refutes=True),
        *(
            Bite("order", row, name, lambda text: f"{text} + 1", refutes=True)
            for row in ledger.COROLLARY.values()
            for name in row
        ),
    ),
}
