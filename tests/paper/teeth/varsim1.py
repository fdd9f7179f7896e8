"""Wrong formulas for the runs of Fig. varsim1."""

from __future__ import annotations

from typing import Any

from flint import fmpq
from paper.bite import Bite, NotApplicable, Teeth, Tooth

from gspot_verified.paper.section_3 import varsim1 as ledger

ENTRIES = ledger.ENTRIES
_OTHER = {"impact": "lift-off", "lift-off": "impact", "trivial": "lift-off"}


def other_fate(honest: Any) -> Any:
    """The other curve of the figure for every run."""
    return lambda beta, nu: _OTHER[honest(beta, nu)]


def only_at_points(honest: Any) -> Any:
    """The fate is wrong where the points are looked at, and right for the theorem."""
    return lambda beta, nu: False if honest(beta, nu) is True else honest(beta, nu)


def _teeth(beta: fmpq, nu: fmpq) -> tuple[Tooth, ...]:
    trivial = beta > 1 and nu == 1
    hypothesis = (
        Bite("hypothesis", ledger, "initial_state", lambda honest: lambda b, n, e: honest(b, 2 * n, e))
        if trivial
        else Bite("hypothesis", ledger, "EPSILON_0", lambda honest: dict.fromkeys(honest, fmpq(1, 2)))
    )
    return (
        Bite("factor", ledger, "expected", other_fate),
        Bite("hidden factor", ledger, "at_points", only_at_points),
        hypothesis,
        NotApplicable("order", "the claim is on what a run does for every ε ≤ ε0; no order of an error occurs"),
    )


TEETH: Teeth = {ledger.identifier(beta, nu): _teeth(beta, nu) for beta in ledger.PANELS for nu in ledger.FACTORS}
