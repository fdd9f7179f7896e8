"""Wrong formulas for the sides of the simulations (Sec. 3)."""

from __future__ import annotations

from typing import Any

from paper.bite import Bite, NotApplicable, Teeth

from gspot_verified.paper.section_3 import section_3 as ledger

ENTRIES = ledger.ENTRIES


def other_sign_at_the_end(honest: Any) -> Any:
    """A factor that is 1 at all steps but the last."""
    return lambda beta: (*honest(beta)[:-1], -honest(beta)[-1])


TEETH: Teeth = {
    "3-sides": (
        Bite("factor", ledger.IMPACT, "printed", lambda _: ledger.IMPACT["corrected"]),
        Bite("factor", ledger.IMPACT, "corrected", lambda honest: {beta: -side for beta, side in honest.items()}),
        Bite("hidden factor", ledger, "by_steps", other_sign_at_the_end),
        Bite("hypothesis", ledger, "FACTORS", lambda honest: (*honest, 1)),
        NotApplicable("order", "the claim is on signs at one ε; no order of an error occurs"),
    ),
}
