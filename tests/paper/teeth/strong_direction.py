"""Wrong directions and wrong signs for the strong stable manifold (Sec. 4.5)."""

from __future__ import annotations

from paper.bite import Bite, NotApplicable, Teeth, replaced, scaled, unseen_at

from gspot_verified.paper.section_1.section_1_cases import CASES, RATES
from gspot_verified.paper.section_4_5 import strong_direction as ledger

ENTRIES = ledger.ENTRIES

TEETH: Teeth = {
    "1-strong-stable": (
        Bite("factor", ledger.DIRECTION, "b", scaled),
        Bite("factor", RATES, "b", scaled),
        Bite("hidden factor", ledger.DIRECTION, "p", unseen_at("alpha2", range(-2, 3))),
        Bite("hypothesis", CASES, "1-case-I", lambda honest: {**honest, "alpha1": "u-w"}),
        Bite("hypothesis", CASES, "1-case-II", lambda honest: {**honest, "alpha3": "-3*u-w"}),
        NotApplicable("order", "an eigenvector; no order of an error occurs"),
    ),
    "1-case-II-beyond": (
        Bite("factor", ledger.BEYOND, "distance", scaled),
        Bite("factor", RATES, "b", scaled),
        Bite("hidden factor", ledger.BEYOND, "distance", unseen_at("alpha2", range(-2, 3))),
        Bite("hypothesis", ledger.BEYOND, "u K", replaced("n", "-n")),
        Bite("hypothesis", CASES, "1-case-II", lambda honest: {**honest, "alpha1": "u-w"}),
        NotApplicable("order", "a side of a line; no order of an error occurs"),
    ),
}
