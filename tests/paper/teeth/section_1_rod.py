"""Wrong formulas of the falling rod (Sec. 1)."""

from __future__ import annotations

from flint import fmpq
from paper.bite import Bite, NotApplicable, Teeth, replaced, scaled, unseen_at

from gspot_verified.paper.section_1 import section_1_rod as ledger

ENTRIES = ledger.ENTRIES

TEETH: Teeth = {
    "1-rod": (
        Bite("factor", ledger.PARTS, "p", replaced("3*mu", "3000003/1000000*mu")),
        Bite("factor", ledger.FRICTION, "top", scaled),
        Bite("hidden factor", ledger.AT_THE_SPOT, "2 α_2/w³", unseen_at("C", (0, 1))),
        Bite("hypothesis", ledger, "THRESHOLD", lambda _: fmpq(2, 7)),
        Bite("hypothesis", ledger, "BOUND", lambda _: fmpq(16, 9)),
        Bite("hypothesis", ledger, "PLACE_OF_LEAST", lambda _: fmpq(1, 4)),
        Bite("hypothesis", ledger, "LEAST", lambda _: fmpq(2)),
        Bite("hypothesis", ledger, "INERTIA", lambda _: fmpq(1, 3)),
        NotApplicable("order", "exact identities; no order of an error occurs"),
    ),
}
