"""Wrong equations of p, b, y, v in positive slip (Sec. 2)."""

from __future__ import annotations

from paper.bite import Bite, Teeth, replaced, scaled, unseen_at

from gspot_verified.paper.section_2 import general_system as ledger

ENTRIES = ledger.ENTRIES

TEETH: Teeth = {
    "2-slip-equations": (
        *(Bite("factor", ledger.PRINTED, name, scaled, refutes=True) for name in "pbyv"),
        Bite("factor", ledger.PRINTED, "b", replaced("alpha3*r", "1000003/1000000*alpha3*r"), refutes=True),
        Bite("hidden factor", ledger.PRINTED, "v", unseen_at("r", range(-2, 3))),
        Bite("hypothesis", ledger.LAGRANGIAN, "LGp", lambda _: "LGp"),
        Bite("hypothesis", ledger.LAGRANGIAN, "LGy", lambda _: "LGy"),
        *(Bite("hypothesis", ledger.ROD, name, scaled) for name in ledger.ROD),
        *(Bite("hypothesis", ledger.NEWTON, name, scaled) for name in ledger.NEWTON),
        Bite("order", ledger.PRINTED, "v", replaced("p*r", "p*r^2")),
    ),
}
