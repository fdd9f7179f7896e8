"""Other signs on the side of the impact (Sec. 4.5)."""

from __future__ import annotations

from flint import fmpq
from paper.bite import Bite, NotApplicable, Teeth

from gspot_verified.paper.section_4_5 import same_situation as ledger

ENTRIES = ledger.ENTRIES
_SIGN = "a sign at one point; a positive factor changes none"

TEETH: Teeth = {
    "S-same-situation": (
        NotApplicable("factor", _SIGN),
        NotApplicable("hidden factor", _SIGN),
        Bite("hypothesis", ledger, "BETA", lambda _: fmpq(1, 2)),
        Bite("hypothesis", ledger, "BETA", lambda _: fmpq(9, 2)),
        Bite("hypothesis", ledger.FORCE, "zero", lambda honest: -honest),
        NotApplicable("order", _SIGN),
    ),
}
