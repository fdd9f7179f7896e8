"""Wrong smoothness of the graphs b(p) (Sec. 5)."""

from __future__ import annotations

from paper.bite import GENERIC, Bite, Teeth, replaced, scaled, unseen_at

from gspot_verified.paper.section_5 import section_5_smoothest as ledger

ENTRIES = ledger.ENTRIES

TEETH: Teeth = {
    "5-smoothest-graph": (
        Bite("factor", ledger.SLIP, "b", replaced("alpha3*b", f"{GENERIC}*alpha3*b")),
        Bite("factor", ledger, "LINE", lambda honest: (scaled(honest[0]), honest[1])),
        Bite("factor", ledger.LOGARITHMIC, "w", scaled),
        Bite("hidden factor", ledger, "RATE", unseen_at("k", (0, 1, 2))),
        Bite("hypothesis", ledger, "FRACTION", lambda _: ("0*x", "1 + x")),
        Bite("hypothesis", ledger, "FRACTION", lambda _: ("1 + x", "1 + x")),
        Bite("order", ledger, "FIRST_ABOVE", lambda _: "m"),
        Bite("order", ledger, "FIRST_ABOVE", lambda _: "m + 2"),
    ),
}
