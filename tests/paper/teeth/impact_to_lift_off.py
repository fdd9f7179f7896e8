"""Wrong claims on impacts that end in lift-off."""

from __future__ import annotations

from typing import Any

from flint import fmpq
from paper.bite import Bite, NotApplicable, Teeth

from gspot_verified.paper.section_3 import impact_to_lift_off as ledger
from gspot_verified.paper.section_3 import varsim2

ENTRIES = ledger.ENTRIES


def other_order(honest: Any) -> Any:
    """The force has its largest value before v has its least."""
    return {name: honest[name] for name in ("p", "lambda_N", "v", "y")}


TEETH: Teeth = {
    "3-impact-to-lift-off": (
        Bite("factor", ledger, "PEAK", lambda honest: honest * 2, refutes=True),
        Bite("factor", ledger.AT_SPOT, "v", lambda honest: (honest[0] / 2, honest[1])),
        Bite("factor", ledger.LOST, fmpq(4), lambda honest: (honest[0], honest[1] - 1), refutes=True),
        Bite("hidden factor", ledger.RATES, "lambda_N", lambda honest: (1, lambda at: -honest[1](at))),
        Bite("hidden factor", ledger, "FLOAT_NEAR", lambda honest: honest / 1000),
        Bite("hypothesis", ledger, "CHI", lambda _: 0),
        Bite("hypothesis", varsim2.SLIP, "u", lambda _: "lam"),
        Bite("hypothesis", ledger, "BETA", lambda _: fmpq(3, 2)),
        Bite("factor", ledger, "RATES", other_order, refutes=True),
        NotApplicable("order", "the claim is on events and their sequence; no order of an error occurs"),
    ),
}
