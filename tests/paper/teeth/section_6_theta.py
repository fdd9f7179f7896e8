"""Wrong claims on the expansion and the scaled Θ beside the simulations of the oscillator (Sec. 6)."""

from __future__ import annotations

from typing import Any

from flint import fmpq
from paper.bite import Bite, Teeth

from gspot_verified.paper.section_6 import section_6_theta as ledger

ENTRIES = ledger.ENTRIES


def larger_later(honest: Any) -> Any:
    """The scaled Θ with a factor that is 1 at t = 0."""
    return lambda t: honest(t) * (1 + float(int(t.p)) / float(int(t.q)) * 200)


TEETH: Teeth = {
    "6-order-15": (
        Bite("factor", ledger, "DIFFERENCE", lambda honest: honest / 10),
        Bite("hidden factor", ledger, "order_15", lambda honest: lambda t: honest(t) * 1.01),
        Bite("hypothesis", ledger, "DRAWN", lambda honest: 2 * honest),
        Bite("order", ledger, "ORDER", lambda _: 11),
    ),
    "6-theta-fit": (
        Bite("factor", ledger, "FIT", lambda honest: honest / 2),
        Bite("hidden factor", ledger, "scaled_theta", larger_later),
        Bite("order", ledger, "scaled_theta", lambda honest: lambda t: honest(t) / 100),
        Bite("hypothesis", ledger, "DELTA", lambda _: fmpq(1, 20)),
    ),
}
