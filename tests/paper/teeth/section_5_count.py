"""Wrong counts of conditions (Sec. 5.1)."""

from __future__ import annotations

from paper.bite import Bite, NotApplicable, Teeth, scaled, unseen_at

from gspot_verified.paper.section_5 import section_5_count as ledger

ENTRIES = ledger.ENTRIES

TEETH: Teeth = {
    "5-count": (
        *(Bite("factor", ledger.PRINTED, name, scaled) for name in ("conditions", "equations", "left")),
        Bite("hidden factor", ledger.PRINTED, "conditions", unseen_at("m", (6,))),
        Bite("hypothesis", ledger.CONDITIONS, "G-spot fixed", lambda _: "m - 3"),
        Bite("hypothesis", ledger.EQUATIONS, "z", lambda _: "0*m"),
        NotApplicable("order", "numbers of equations; no order of an error occurs"),
    ),
}
