"""A reference to a display with a number (Sec. 4)."""

from __future__ import annotations

from paper.bite import Bite, NotApplicable, Teeth, reads_as

from gspot_verified.paper.section_4 import section_4_reference as ledger

ENTRIES = ledger.ENTRIES
_WORDS = "a number of the paper; there is no formula"

TEETH: Teeth = {
    "4-reference": (
        NotApplicable("factor", _WORDS),
        NotApplicable("hidden factor", _WORDS),
        Bite("hypothesis", ledger, "NAME", lambda _: "eq:modelSysDev"),
        Bite("hypothesis", ledger, "quoted", reads_as("equation*", "equation")),
        NotApplicable("order", _WORDS),
    ),
}
