"""Wrong sentences on smoothness at the G-spot (Sec. 3.2)."""

from __future__ import annotations

from typing import Any

from flint import arb, fmpq
from paper.bite import Bite, Teeth, Tooth

from gspot_verified.numbers.balls import working_bits
from gspot_verified.paper.section_3 import section_3_smoothness as ledger

ENTRIES = ledger.ENTRIES


def smaller_at_the_figure(honest: Any) -> Any:
    """The values at the ε of the figure only, times ε."""

    def changed(beta: fmpq, nu: fmpq, epsilon: fmpq) -> dict[str, arb]:
        with working_bits(64):
            factor = epsilon if epsilon == ledger.SHOWN[-1] else fmpq(1)
            return {name: value * factor for name, value in honest(beta, nu, epsilon).items()}

    return changed


def _teeth(beta: fmpq) -> tuple[Tooth, ...]:
    other = 1 if ledger.DIVERGES[beta] == 0 else ledger.DIVERGES[beta] - 1
    return (
        Bite("factor", ledger, "DIVERGES", lambda honest: {**honest, beta: other}),
        Bite("hidden factor", ledger, "deviations", smaller_at_the_figure),
        Bite("hypothesis", ledger, "LARGEST", lambda _: fmpq(1, 2)),
        Bite("order", ledger, "limit_exponent", lambda honest: lambda *arguments: honest(*arguments) + 1),
    )


TEETH: Teeth = {ledger.smoothness_identifier(beta): _teeth(beta) for beta in ledger.DIVERGES}
