"""Wrong signs of A, C and AC - B² (Sec. 1)."""

from __future__ import annotations

from paper.bite import GENERIC, Bite, NotApplicable, Teeth, replaced, unseen_at

from gspot_verified.paper.section_1 import section_1_mass_matrix as ledger

ENTRIES = ledger.ENTRIES

TEETH: Teeth = {
    "1-mass-matrix": (
        Bite("factor", ledger, "THIRD", replaced("B^2", f"{GENERIC}*B^2")),
        Bite("hidden factor", ledger, "THIRD", unseen_at("A", (1, 2))),
        Bite("hypothesis", ledger.NORMAL, "h", lambda _: "0*k"),
        Bite("hypothesis", ledger.GRAM, "C", lambda _: ("t", "n")),
        Bite("hypothesis", ledger.MASS, 3, lambda honest: (*honest[:2], ("m12", "m23", "m33"))),
        NotApplicable("order", "exact signs; no order of an error occurs"),
    ),
}
