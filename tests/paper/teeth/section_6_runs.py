"""Wrong claims on the simulations and the Cases of the oscillator (Sec. 6)."""

from __future__ import annotations

from typing import Any

from flint import fmpq
from paper.bite import Bite, NotApplicable, Teeth, Tooth, raised, replaced

from gspot_verified.paper.section_6 import section_6_runs as ledger

ENTRIES = ledger.ENTRIES
_OTHER = {"6-first-start": "-1/2", "6-second-start": "-9/10"}


def later(honest: Any) -> Any:
    """The float run lifts off 10^-3 later."""
    return lambda: honest() + fmpq(1, 10**3)


def other_events(name: str) -> Any:
    """Another order of events in the float run, the same first one."""
    return lambda honest: {**honest, name: (honest[name][0], ledger.TOUCH_DOWN)}


def _start(name: str) -> tuple[Tooth, ...]:
    return (
        Bite("factor", ledger, "SEQUENCES", lambda honest: {**honest, name: (*honest[name][::-1], "x")}),
        Bite("hidden factor", ledger, "SEQUENCES", other_events(name)),
        Bite("hypothesis", ledger, "STARTS", lambda honest: {**honest, name: _OTHER[name]}),
        NotApplicable("order", "the claim is on the side of a start at leading order; no order of an error occurs"),
    )


TEETH: Teeth = {
    "6-classes": (
        Bite("factor", ledger.ALPHAS, "alpha_2", replaced("9450*beta*kappa", "-9450*beta*kappa")),
        Bite("hidden factor", ledger.ALPHAS, "alpha_3", lambda honest: f"({honest})*(1 + (beta-1/2)*(beta-7/3))"),
        Bite("hypothesis", ledger.MEMBERS, "II", lambda _: (fmpq(1, 2), fmpq(0))),
        Bite("order", ledger.ALPHAS, "alpha_2", raised("kappa")),
    ),
    "6-first-start": _start("6-first-start"),
    "6-second-start": _start("6-second-start"),
    "6-lift-off-time": (
        Bite("factor", ledger, "PRINTED_TIME", lambda honest: honest * fmpq(11, 10), refutes=True),
        Bite("hidden factor", ledger, "simulated_delay", later),
        Bite("hypothesis", ledger, "STARTS", lambda honest: {**honest, "6-first-start": "-8/10"}),
        Bite("order", ledger, "EPSILON", lambda honest: 2 * honest),
        Bite("factor", ledger, "PRINTED_TIME", lambda honest: honest / 2, refutes=True),
    ),
}
