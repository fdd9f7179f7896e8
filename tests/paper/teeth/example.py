"""Wrong coefficients and orders in the example after the corollary (Sec. 5)."""

from __future__ import annotations

from typing import Any

from paper.bite import Bite, Teeth, raised, scaled, unseen_at

from gspot_verified.paper.section_5 import double_series
from gspot_verified.paper.section_5 import example as ledger

ENTRIES = ledger.ENTRIES
ZBAR = ledger.PRINTED["5-example-zbar"]
B_ERROR = ledger.CORRECTED["5-example-b-error"]


def twice_alpha_2(honest: Any) -> Any:
    """Another α_2 than the stated one."""
    return (honest[0], 2 * honest[1], honest[2])


OTHER_SYSTEM = Bite("hypothesis", double_series, "ALPHA", twice_alpha_2)

TEETH: Teeth = {
    **{
        f"5-example-{name}": (
            Bite("factor", ledger.PRINTED[f"5-example-{name}"], "series", scaled),
            Bite("hidden factor", ledger.PRINTED[f"5-example-{name}"], "series", unseen_at("chi", (0, 1))),
            Bite("hidden factor", ledger.PRINTED[f"5-example-{name}"], "series", unseen_at("s", (0, 1))),
            OTHER_SYSTEM,
            Bite("order", ledger.PRINTED[f"5-example-{name}"], "error", raised("delta")),
        )
        for name in ("p", "b", "y", "v", "z")
    },
    "5-example-b-error": (
        Bite("factor", B_ERROR, "term 7", scaled),
        Bite("factor", ledger.PRINTED["5-example-b"], "series", scaled),
        Bite("hidden factor", B_ERROR, "term 7", unseen_at("chi", (0, 1))),
        OTHER_SYSTEM,
        Bite("order", B_ERROR, "error", raised("delta")),
    ),
    "5-example-trivial": (
        *(Bite("factor", ledger.PRINTED[f"5-example-{name}"], "series", scaled, refutes=True) for name in "pbyz"),
        Bite("hidden factor", ledger.PRINTED["5-example-p"], "series", unseen_at("s", (0, 1)), refutes=True),
        Bite("hidden factor", ledger.PRINTED["5-example-v"], "series", lambda text: f"{text} + s*(s-1)"),
        OTHER_SYSTEM,
        Bite("order", ledger.PRINTED["5-example-z"], "series", raised("delta"), refutes=True),
    ),
    "5-example-zbar": (
        *(Bite("factor", ZBAR, part, scaled) for part in ("scaled", "first", "second")),
        *(Bite("hidden factor", ZBAR, part, unseen_at("t", (0, 1))) for part in ("first", "second")),
        Bite("hidden factor", ZBAR, "scaled", unseen_at("s", (0, 1))),
        OTHER_SYSTEM,
        Bite("order", ZBAR, "error", raised("delta")),
        *(
            Bite("order", ledger.STATED_ERROR, "5-example-zbar", lambda _, wrong=wrong: wrong)
            for wrong in (
                ((5, 0), (2, 1), (1, 2), (0, 3)),
                ((4, 0), (3, 1), (1, 2), (0, 3)),
                ((4, 0), (2, 1), (2, 2), (0, 3)),
                ((4, 0), (2, 1), (1, 2), (0, 4)),
            )
        ),
    ),
}
