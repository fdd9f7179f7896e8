"""Wrong flows of rigid slip (Sec. 1)."""

from __future__ import annotations

from paper.bite import Bite, NotApplicable, Teeth, replaced, scaled, unseen_at

from gspot_verified.paper.section_1 import section_1_cases
from gspot_verified.paper.section_1 import section_1_outcomes as ledger

ENTRIES = ledger.ENTRIES
_EXACT = "exact signs and solutions; no order of an error occurs"

TEETH: Teeth = {
    "1-three-outcomes": (
        Bite("factor", ledger, "JORDAN", replaced("alpha2*q*s", "1000003/1000000*alpha2*q*s")),
        Bite("hidden factor", ledger.RATES, "p", unseen_at("p", (0, 1))),
        Bite("hypothesis", ledger, "SIGNS", lambda honest: (*honest, 0)),
        Bite("hypothesis", ledger.RATES, "p", lambda honest: f"{honest} + b"),
        Bite("hypothesis", section_1_cases.CASES["1-case-II"], "alpha3", lambda _: "w"),
        Bite("hypothesis", ledger, "RESTS", lambda honest: (honest[0], (honest[0][0], honest[1][1]))),
        Bite("hypothesis", ledger, "RESTS", lambda honest: ((honest[0][0], {"p": "q*E", "b": "q*E"}), honest[1])),
        Bite("order", ledger, "JORDAN", replaced("q*s", "q*s^2")),
    ),
    "1-attracting-signs": (
        Bite("factor", ledger.RATES, "b", scaled),
        Bite("hidden factor", ledger.RATES, "p", unseen_at("p", (0, 1))),
        Bite("hypothesis", ledger.FOURTH, "alpha2", lambda _: "-m"),
        Bite("hypothesis", ledger.FOURTH, "alpha1", lambda _: "-u-w-w"),
        Bite("hypothesis", ledger.FOURTH, "alpha1", lambda _: "w"),
        Bite("hypothesis", section_1_cases.CASES["1-case-I"], "alpha2", lambda _: "m"),
        Bite("hypothesis", section_1_cases.CASES["1-case-III"], "alpha1", lambda _: "-u-w-w"),
        Bite("hypothesis", ledger, "UNSTABLE", lambda honest: (honest[0], {**honest[1], "p": "q*E"})),
        Bite("hypothesis", ledger.LINE, "alpha1", lambda _: "w"),
        Bite("hypothesis", ledger.LINE, "alpha3", lambda _: "-u"),
        NotApplicable("order", _EXACT),
    ),
    "1-rescaled-time": (
        Bite("factor", ledger.RATES, "p", scaled),
        Bite("hidden factor", ledger.RATES, "p", unseen_at("p", (0, 1))),
        Bite("hypothesis", ledger.RATES, "p", lambda honest: f"{honest} + b"),
        NotApplicable("order", _EXACT),
    ),
}
