"""Wrong claims about what follows lift-off (Sec. 3)."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from paper.bite import Bite, Teeth

from gspot_verified.paper.section_3 import after_lift_off as ledger

ENTRIES = ledger.ENTRIES


def upwards_at_the_least_epsilon(honest: Any) -> Any:
    """The velocity at touch-down with the other sign, in the last run of each kind only."""

    def changed(beta: Any, nu: Any, epsilon: Any) -> Any:
        run = honest(beta, nu, epsilon)
        if epsilon != ledger.EPSILONS[-1]:
            return run
        last = replace(run.events[-1], velocity=-run.events[-1].velocity)
        return replace(run, events=(*run.events[:-1], last))

    return changed


TEETH: Teeth = {
    "3-after-lift-off": (
        Bite("factor", ledger, "MOST", lambda honest: honest / 2),
        Bite("factor", ledger, "MOST_FREE", lambda honest: honest / 2),
        Bite("factor", ledger, "MOST_TIME", lambda honest: honest / 2),
        Bite("order", ledger, "TIME_POWER", lambda honest: honest + 1),
        Bite("order", ledger, "FREE_POWER", lambda honest: honest + 1),
        Bite("factor", ledger.CLAIM, "events", lambda _: "one flight, then a contact that is lost again"),
        Bite("hidden factor", ledger, "run_of", upwards_at_the_least_epsilon),
        Bite("hypothesis", ledger, "LIFTING", lambda honest: {beta: (*nus, 1) for beta, nus in honest.items()}),
        Bite("order", ledger, "POWER", lambda honest: honest + 1),
    ),
}
