"""Wrong spaces of right-hand sides, and another rest of z (Sec. 5)."""

from __future__ import annotations

from paper.bite import Bite, NotApplicable, Teeth, replaced, unseen_at

from gspot_verified.paper.section_5 import section_5_recursion
from gspot_verified.paper.section_5 import section_5_right_sides as ledger

ENTRIES = ledger.ENTRIES
_PRINTED, _INNER = ledger.PRINTED["5-inner-slow"], section_5_recursion.PRINTED["5-inner-system"]
_INDEX = "indices of spaces; a factor changes none"

TEETH: Teeth = {
    "5-right-sides": (
        NotApplicable("factor", _INDEX),
        NotApplicable("hidden factor", _INDEX),
        Bite("hypothesis", ledger.SERIES, "lambda", lambda _: (0, -3)),
        Bite("hypothesis", ledger.SERIES, "z", lambda _: (1, -1)),
        Bite("order", ledger.CLAIMED, "r", lambda _: (1, -6)),
        Bite("order", ledger.CLAIMED, "r_v", lambda _: (2, -3)),
        Bite("order", ledger.CLAIMED, "r_xi", lambda _: (0, -5)),
    ),
    "5-inner-slow": (
        Bite("factor", ledger.SLOW, "z0", replaced("/2", "*1000003/2000000")),
        Bite("factor", _PRINTED, "specialX", replaced("g*lam", "2*g*lam")),
        Bite("factor", _PRINTED, "specialV", replaced("b0", "2*b0")),
        Bite("hidden factor", _INNER, "specialZ", unseen_at("y0", (0, 1))),
        Bite("hidden factor", _PRINTED, "specialB", unseen_at("lam", (0, 1))),
        Bite("hypothesis", _INNER, "specialL", replaced("z0 - y0", "z0 + y0")),
        Bite("hypothesis", ledger, "FAST", lambda _: ("specialL",)),
        NotApplicable("order", "exact equations; no order of an error occurs"),
    ),
}
