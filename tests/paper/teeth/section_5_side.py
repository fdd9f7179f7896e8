"""Wrong claims on the side of families near the expansion (Sec. 5)."""

from __future__ import annotations

from flint import arb, fmpq
from paper.bite import Bite, Teeth

from gspot_verified.paper.section_5 import section_5_side as ledger

ENTRIES = ledger.ENTRIES

TEETH: Teeth = {
    "5-side": (
        Bite("factor", ledger, "FIRST_EVENT", lambda honest: {-sign: event for sign, event in honest.items()}),
        Bite("hidden factor", ledger, "LARGEST_DELTA", lambda honest: 5 * honest),
        Bite("hypothesis", ledger, "WITHIN", lambda _: fmpq(4)),
        Bite("order", ledger, "ORDER", lambda _: 2),
    ),
    "5-rule": (
        Bite("factor", ledger, "FIRST_EVENT", lambda honest: {-sign: event for sign, event in honest.items()}),
        Bite("hidden factor", ledger, "WEIGHTS", lambda honest: (honest[0], fmpq(1, 20))),
        Bite("hypothesis", ledger, "RULE_BETAS", lambda honest: (*honest, arb(2, fmpq(1, 2)))),
        Bite("order", ledger, "CONE", lambda honest: (honest[0], 2 * honest[1])),
    ),
}
