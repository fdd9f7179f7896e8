"""Wrong formulas for the runs of Fig. varsim1."""

from __future__ import annotations

from typing import Any

from flint import fmpq
from paper.bite import Bite, NotApplicable, Teeth, Tooth

from gspot_verified.paper.section_3 import varsim1 as ledger

ENTRIES = ledger.ENTRIES
_OTHER = {"impact": "lift-off", "lift-off": "impact", "trivial": "lift-off"}


def other_fate(nu: fmpq) -> Any:
    """The other curve of the figure for one run."""
    return lambda honest: {**honest, nu: _OTHER[honest[nu]]}


def only_at_points(honest: Any) -> Any:
    """The fate is another one where single ε are looked at, and the same in the theorem."""
    return lambda *run: _OTHER[honest(*run)]


def _teeth(beta: fmpq, nu: fmpq) -> tuple[Tooth, ...]:
    trivial = beta > 1 and nu == 1
    hypothesis = (
        Bite("hypothesis", ledger, "initial_state", lambda honest: lambda b, n, e: honest(b, 2 * n, e))
        if trivial
        else Bite("hypothesis", ledger, "EPSILON_0", lambda honest: dict.fromkeys(honest, fmpq(1, 2)))
    )
    return (
        Bite("hidden factor", ledger, "fate_at", only_at_points),
        hypothesis,
        Bite("factor", ledger.FATES, beta, other_fate(nu), refutes=True),
        NotApplicable("order", "the claim is on what a run does for every ε ≤ ε0; no order of an error occurs"),
    )


TEETH: Teeth = {ledger.identifier(beta, nu): _teeth(beta, nu) for beta in ledger.PANELS for nu in ledger.FACTORS}
