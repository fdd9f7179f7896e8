"""Wrong signs of the α's (Sec. 1)."""

from __future__ import annotations

from paper.bite import Bite, NotApplicable, Teeth, replaced, scaled, unseen_at

from gspot_verified.paper.section_1 import section_1_alpha_signs as ledger

ENTRIES = ledger.ENTRIES

TEETH: Teeth = {
    "1-alpha-signs": (
        Bite("factor", ledger.ALPHAS, "alpha_3", scaled),
        Bite("factor", ledger.DRIFT, "S", scaled),
        Bite("hidden factor", ledger.ALPHAS, "alpha_1", unseen_at("w", (1, -1))),
        Bite("hypothesis", ledger, "RATES", lambda honest: honest[:1]),
        Bite("hypothesis", ledger, "SHAPES", lambda honest: (honest[0], (*honest[1][:2], honest[0][2]))),
        Bite("hypothesis", ledger.CONTACT, "x", replaced("- s*S", "- s*S + U")),
        Bite("hypothesis", ledger, "EXAMPLE_VALUES", lambda _: (1, 2)),
        NotApplicable("order", "exact values; no order of an error occurs"),
    ),
}
