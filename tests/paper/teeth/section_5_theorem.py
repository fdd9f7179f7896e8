"""Wrong formulas for Theorem 1: existence, uniqueness, orders of the residual."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from paper.bite import Bite, Teeth, raised, replaced, scaled, unseen_at

from gspot_verified.paper.section_5 import section_5_recursion as recursion
from gspot_verified.paper.section_5 import section_5_theorem as ledger

ENTRIES = ledger.ENTRIES
IMAGE = recursion.CORRECTED["5-monomial"]
ORDERS = ledger.RESIDUAL_ORDERS


def without(key: str) -> Callable[[dict[str, Any]], dict[str, Any]]:
    """The mapping without one key."""
    return lambda honest: {name: value for name, value in honest.items() if name != key}


TEETH: Teeth = {
    "5-theorem-1": (
        Bite("factor", IMAGE, "image", replaced("k*alpha1", "1000003/1000000*k*alpha1")),
        Bite("hidden factor", IMAGE, "image", unseen_at("k", range(6))),
        *(Bite("hypothesis", ledger, "HYPOTHESES", without(key), key == "k - beta") for key in ledger.HYPOTHESES),
        Bite("order", IMAGE, "image", raised("k")),
    ),
    "5-theorem-1-orders": (
        *(Bite("factor", ORDERS, kind, scaled) for kind in ORDERS),
        *(Bite("hidden factor", ORDERS, kind, unseen_at("M", (2, 4, 6))) for kind in ORDERS),
        Bite("hypothesis", ledger.KNOWN_BEFORE, "conditions", lambda honest: honest | {"xi": 1}),
        Bite("hypothesis", ledger.KNOWN_BEFORE, "equations", lambda honest: honest | {"z": -1}),
        *(Bite("order", ORDERS, kind, lambda text: f"{text} + 1", refutes=True) for kind in ORDERS),
    ),
}
