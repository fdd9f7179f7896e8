"""Wrong claims on the runs of Fig. varsim2."""

from __future__ import annotations

from typing import Any

from flint import fmpq
from paper.bite import Bite, NotApplicable, Teeth, Tooth

from gspot_verified.paper.section_3 import varsim2 as ledger

ENTRIES = ledger.ENTRIES
_NO_ORDER = NotApplicable("order", "the claim is on events and their sequence; no order of an error occurs")


def sequence(key: tuple[int, fmpq], events: tuple[str, ...]) -> Any:
    """Other events for one run."""
    return lambda honest: {**honest, key: events}


def faster(honest: Any) -> Any:
    """u is larger by 1 than the exact solution has it."""
    return lambda nu, time: honest(nu, time) + 1


def _run(chi: int, nu: fmpq) -> tuple[Tooth, ...]:
    wrong = (ledger.STICK, ledger.LIFT_OFF) if len(ledger.RUNS[chi, nu]) == 1 else ledger.RUNS[chi, nu][::-1]
    shorter = ledger.RUNS[chi, nu][:-1]
    return (
        Bite("factor", ledger, "RUNS", sequence((chi, nu), shorter), refutes=True),
        Bite("hidden factor", ledger, "slip_velocity", faster)
        if chi == 0
        else Bite("hidden factor", ledger, "_FLOAT_NEAR", lambda _: fmpq(0)),
        Bite("hypothesis", ledger, "BETA", lambda _: fmpq(5, 2) if nu < 1 else fmpq(3, 2))
        if chi == 0
        else Bite("hypothesis", ledger, "FIRST_SLIP", lambda _: fmpq(1, 10) if nu < 1 else fmpq(900)),
        Bite("factor", ledger, "RUNS", sequence((chi, nu), wrong), refutes=True),
        _NO_ORDER,
    )


TEETH: Teeth = {
    **{ledger.identifier(chi, nu): _run(chi, nu) for chi, nu in ledger.RUNS},
    "3-varsim2-caption": (
        Bite("factor", ledger, "WITHOUT_STICK", lambda honest: honest + 1, refutes=True),
        Bite("hidden factor", ledger, "_FLOAT_NEAR", lambda _: fmpq(0)),
        Bite("hypothesis", ledger, "FIRST_SLIP", lambda _: fmpq(900)),
        _NO_ORDER,
    ),
    "3-impact-to-stick": (
        Bite("factor", ledger, "RUNS", sequence((0, fmpq(4)), (ledger.STICK, ledger.LIFT_OFF))),
        Bite("hidden factor", ledger, "slip_velocity", faster),
        Bite("hypothesis", ledger, "BETA", lambda _: fmpq(3, 2)),
        Bite("hypothesis", ledger, "AT_SPOT", lambda _: fmpq(51, 100)),
        _NO_ORDER,
    ),
    "3-large-slip": (
        Bite("factor", ledger, "LIFT_OFF", lambda _: ledger.STICK),
        Bite("hidden factor", ledger, "_NEAR", lambda _: fmpq(0)),
        Bite("hypothesis", ledger, "FAST", lambda honest: (*honest, (fmpq(4), fmpq(70)))),
        Bite("hypothesis", ledger.SLIP, "b", lambda honest: f"{honest} + u"),
        Bite("hypothesis", ledger.SLIP, "u", lambda honest: f"{honest} - u"),
        _NO_ORDER,
    ),
}
