"""Wrong bounds of the ways to a G-spot, and wrong Cases (Sec. 1)."""

from __future__ import annotations

from paper.bite import Bite, NotApplicable, Teeth, replaced, scaled, unseen_at

from gspot_verified.paper.section_1 import section_1_cases
from gspot_verified.paper.section_1 import section_1_open_sets as ledger
from gspot_verified.paper.section_2 import general_system

ENTRIES = ledger.ENTRIES

TEETH: Teeth = {
    "1-open-sets": (
        Bite("factor", ledger.INTEGRALS, "n", replaced("a1*n", "1000003/1000000*a1*n")),
        Bite("factor", section_1_cases.RATES, "b", scaled),
        Bite("factor", general_system.DEFINED, "LGb", scaled),
        Bite("hidden factor", ledger.INTEGRALS, "p", unseen_at("p", (0, 1))),
        Bite("hypothesis", ledger.DECAY, "a1", lambda _: "c + w"),
        Bite("hypothesis", ledger.DECAY, "a3", lambda _: "u"),
        Bite("hypothesis", ledger.SLOWEST, "n", replaced("- a3*n", "+ a3*n")),
        Bite("hypothesis", general_system.LAGRANGIAN, "LGp", lambda _: "v"),
        Bite("hypothesis", section_1_cases.CASES["1-case-I"], "alpha3", lambda _: "w"),
        Bite("hypothesis", section_1_cases.CASES["1-case-III"], "alpha2", lambda _: "m"),
        Bite("hypothesis", ledger.SYSTEM, "1-case-II", lambda honest: (honest[0], (honest[1][0], -honest[1][0] / 2))),
        NotApplicable("order", "exact bounds; no order of an error occurs"),
    ),
}
