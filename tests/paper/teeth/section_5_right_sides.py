"""Wrong spaces of right-hand sides, and another rest of z (Sec. 5)."""

from __future__ import annotations

from paper.bite import Bite, NotApplicable, Teeth, replaced, unseen_at

from gspot_verified.paper.section_5 import section_5_right_sides as ledger

ENTRIES = ledger.ENTRIES
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
        Bite("factor", ledger.SLOW, "z", replaced("/2", "*1000003/2000000")),
        Bite("hidden factor", ledger.SCALED, "specialZ", unseen_at("y", (0, 1))),
        Bite("hypothesis", ledger.SCALED, "specialL", replaced("z - y", "z + y")),
        NotApplicable("order", "exact equations; no order of an error occurs"),
    ),
}
