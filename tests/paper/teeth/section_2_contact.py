"""Wrong relaxations and deformations of the surface (Sec. 2)."""

from __future__ import annotations

from paper.bite import GENERIC, Bite, Teeth, raised, replaced, scaled, unseen_at

from gspot_verified.paper.section_2 import section_2_contact as ledger

ENTRIES = ledger.ENTRIES

TEETH: Teeth = {
    "2-relaxation": (
        Bite("factor", ledger.REST, "contact", replaced("1/2", "500001/1000000")),
        Bite("factor", ledger.SPRINGS, "contact", replaced("k2*", "1000003/1000000*k2*")),
        Bite("hidden factor", ledger.RATE, "contact", unseen_at("y", (-1, 1))),
        Bite("hypothesis", ledger.RATE, "flight", lambda _: ledger.RATE["contact"]),
        Bite("hypothesis", ledger.RATE, "contact", replaced("-z", "z")),
        Bite("order", ledger.DECAY, "contact", lambda honest: honest + 1),
    ),
    "2-compliant": (
        Bite("factor", ledger.COMPLIANT, "z", replaced("epsilon^2*lam", f"{GENERIC}*epsilon^2*lam"), refutes=True),
        Bite("factor", ledger.COMPLIANT, "force", scaled, refutes=True),
        Bite("hidden factor", ledger.COMPLIANT, "z", unseen_at("epsilon", (0, 1)), refutes=True),
        Bite("hypothesis", ledger.CONSTANTS, "c", lambda _: 0),
        Bite("hypothesis", ledger.CONSTANTS, "k2", lambda _: -1),
        Bite("order", ledger.COMPLIANT, "z", replaced("epsilon^2", "epsilon"), refutes=True),
    ),
    "2-deformation": (
        Bite("factor", ledger.GIVEN, "z", scaled),
        Bite("factor", ledger.BALANCE, "y", replaced("k2*", f"{GENERIC}*k2*")),
        Bite("hidden factor", ledger, "UNDER_FORCE", unseen_at("epsilon", (0, 1))),
        Bite("hypothesis", ledger.CONSTANTS, "k1", lambda _: 0),
        Bite("hypothesis", ledger.CONSTANTS, "c", lambda _: 0),
        Bite("order", ledger.GIVEN, "y", raised("epsilon")),
    ),
}
