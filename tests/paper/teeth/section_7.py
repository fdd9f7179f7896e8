"""Wrong claims on what follows the first flight (Sec. 7)."""

from __future__ import annotations

from typing import Any

from flint import fmpq
from paper.bite import Bite, NotApplicable, Teeth

from gspot_verified.paper.section_6 import section_7 as ledger

ENTRIES = ledger.ENTRIES


def without_the_last(honest: Any) -> Any:
    """The second lift-off is left out of each list."""
    return {case: events[:-1] for case, events in honest.items()}


TEETH: Teeth = {
    "7-lift-off-again": (
        Bite("factor", ledger, "RUNS", without_the_last),
        Bite("hidden factor", ledger, "FLOAT_NEAR", lambda _: fmpq(0)),
        Bite("hypothesis", ledger, "NU", lambda _: fmpq(4)),
        NotApplicable("order", "the claim is on events and their sequence; no order of an error occurs"),
    ),
}
