"""Wrong formulas for the slow system of the outer scale and its exponent (Secs. 1 and 4)."""

from __future__ import annotations

from paper.bite import Bite, NotApplicable, Teeth, raised, replaced, scaled, unseen_at

from gspot_verified.paper.section_4 import section_4_slow as ledger

_BETA = ledger.CORRECTED["1-beta"]
_SLOW = ledger.PRINTED["4-slow"]
_AT_INTEGERS = range(-3, 4)


ENTRIES = {**ledger.RATIO_ENTRIES, **ledger.ENTRIES}


TEETH: Teeth = {
    "1-beta": (
        *(Bite("factor", _BETA, part, scaled) for part in _BETA),
        *(Bite("hidden factor", _BETA, part, unseen_at("alpha1", _AT_INTEGERS)) for part in _BETA),
        NotApplicable("hypothesis", "an identity in α_1 and α_3; α_1 ≠ 0 is what makes β a number"),
        *(Bite("order", _BETA, part, raised("alpha1")) for part in _BETA),
    ),
    "4-slow": (
        *(Bite("factor", _SLOW, part, scaled) for part in _SLOW if part != "v"),
        Bite("factor", _SLOW, "v", lambda _: "b0/1000000"),
        *(Bite("hidden factor", _SLOW, part, unseen_at("t", _AT_INTEGERS)) for part in _SLOW if part != "v"),
        Bite("hidden factor", _SLOW, "exponent", unseen_at("beta", _AT_INTEGERS)),
        Bite("hypothesis", ledger, "_WITH_BETA", lambda _: {}),
        Bite("order", _SLOW, "exponent", replaced("beta", "beta + 1")),
        *(Bite("order", _SLOW, part, raised("t")) for part in _SLOW if part != "v"),
    ),
}
