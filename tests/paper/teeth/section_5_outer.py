"""Wrong formulas for the outer system, its fast and its slow part (Sec. 5)."""

from __future__ import annotations

from paper.bite import Bite, Teeth, raised, replaced, scaled, unseen_at

from gspot_verified.paper.section_4 import section_4_fast
from gspot_verified.paper.section_5 import section_5_outer as ledger
from gspot_verified.paper.section_5 import section_5_recursion

ENTRIES = ledger.ENTRIES
OUTER, POLYNOMIAL, SLOW = (
    ledger.PRINTED[identifier] for identifier in ("5-outer-system", "5-fast-polynomial", "5-slow-manifold")
)
FAST = ledger.CORRECTED["5-fast-system"]
_POINTS = range(-2, 3)

TEETH: Teeth = {
    "5-outer-system": (
        *(Bite("factor", OUTER, part, scaled) for part in OUTER),
        *(Bite("hidden factor", OUTER, part, unseen_at("epsilon", _POINTS)) for part in OUTER),
        Bite("hypothesis", section_5_recursion.GENERAL, "specialV", lambda honest: ("vd - (b + 2*p*lam)", honest[1])),
        Bite("hypothesis", section_5_recursion.PRINTED["5-inner-system"], "specialZ", replaced("delta*z1", "z1")),
        *(Bite("order", OUTER, part, raised("epsilon")) for part in OUTER),
    ),
    "5-fast-system": (
        Bite("factor", FAST, "v", scaled),
        Bite("factor", ledger.PRINTED["5-fast-system"], "v", lambda _: ledger.CORRECTED["5-fast-system"]["v"]),
        *(Bite("factor", ledger.PRINTED["5-fast-system"], part, scaled) for part in "yz"),
        Bite("hidden factor", FAST, "v", unseen_at("p", _POINTS)),
        Bite("hypothesis", OUTER, "lambda", replaced("z - y", "z")),
        Bite("order", FAST, "v", raised("p")),
    ),
    "5-fast-polynomial": (
        Bite("factor", POLYNOMIAL, "polynomial", scaled),
        Bite("factor", section_4_fast.PRINTED["4-fast-polynomial"], "polynomial", scaled),
        Bite("hidden factor", POLYNOMIAL, "polynomial", unseen_at("p", _POINTS)),
        Bite("hypothesis", ledger.PRINTED["5-fast-system"], "z", replaced("2*z", "z")),
        Bite("order", POLYNOMIAL, "polynomial", raised("lam")),
    ),
    "5-slow-manifold": (
        *(Bite("factor", SLOW, part, scaled) for part in ("y", "z", "xi", "p", "b")),
        Bite("factor", SLOW, "v", lambda _: "1/1000000*b"),
        *(Bite("hidden factor", SLOW, part, unseen_at("p", _POINTS)) for part in ("y", "z", "xi", "b")),
        Bite("hypothesis", OUTER, "lambda", replaced("z - y", "z - 2*y")),
        Bite("hypothesis", OUTER, "b", replaced("- a3", "+ a3")),
        Bite("hypothesis", section_5_recursion.PRINTED["5-inner-system"], "specialX", replaced("+ g", "- g")),
        Bite("hypothesis", OUTER, "z", replaced("- lam", "- 2*lam")),
        *(Bite("order", SLOW, part, raised("p")) for part in ("y", "z", "xi", "p", "b")),
    ),
}
