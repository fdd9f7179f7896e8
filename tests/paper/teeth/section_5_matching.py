"""Wrong formulas for the perturbation on the inner scale and the matching (Sec. 5)."""

from __future__ import annotations

from typing import Any

from paper.bite import Bite, Teeth, raised, replaced, scaled, unseen_at

from gspot_verified.paper.section_5 import section_5_matching as ledger

ENTRIES = ledger.ENTRIES
PERTURBATION, THETA, MATCHING = (
    ledger.PRINTED[identifier] for identifier in ("5-perturbation", "5-perturbation-theta", "5-matching")
)
FACTOR = ledger.CORRECTED["5-bpert-v"]


def other_v(honest: Any) -> Any:
    """v~ is twice the derivative of y~."""
    return lambda *a, **k: honest(*a, **k) | {"v": [[2 * x for x in row] for row in honest(*a, **k)["v"]]}


TEETH: Teeth = {
    "5-bpert-v": (
        Bite("factor", FACTOR, "factor", scaled),
        Bite("factor", ledger.PRINTED["5-bpert-v"], "factor", lambda _: "1"),
        Bite("hidden factor", FACTOR, "factor", unseen_at("delta", (0, 1))),
        Bite("hypothesis", ledger, "extended_terms", other_v),
        Bite("order", FACTOR, "factor", raised("delta")),
    ),
    "5-perturbation": (
        *(Bite("factor", PERTURBATION, part, scaled) for part in PERTURBATION),
        *(Bite("hidden factor", PERTURBATION, part, unseen_at("s", range(-2, 3))) for part in PERTURBATION),
        Bite("hypothesis", ledger, "DISTINGUISHED_P", replaced("w*q1", "q1")),
        Bite("hypothesis", ledger.TAYLOR, "a3", replaced("d1*w^2", "d1")),
        Bite("hypothesis", ledger.TAYLOR, "a2", replaced("c1*w^2", "c1")),
        Bite("hypothesis", ledger.TAYLOR, "a1", replaced("e1*w^2", "e1")),
        Bite("factor", ledger, "RATE_OF_P", scaled),
        Bite("order", ledger.DEVIATION_OF_P, "p", replaced("w^2*", "")),
        Bite("order", ledger.DEVIATION_OF_P, "p1", replaced("w^2*", "")),
        *(Bite("order", PERTURBATION, part, raised("s")) for part in PERTURBATION),
    ),
    "5-perturbation-theta": (
        *(Bite("factor", THETA, part, scaled) for part in THETA),
        Bite("hidden factor", THETA, "equation", unseen_at("tau", range(-2, 3))),
        Bite("hidden factor", THETA, "kappa cubed", unseen_at("alpha1", range(-2, 3))),
        Bite("hypothesis", PERTURBATION, "third order", replaced(" - alpha3/2*g0", "")),
        Bite("order", THETA, "equation", raised("tau")),
        Bite("order", THETA, "kappa cubed", raised("alpha1")),
    ),
    "5-matching": (
        *(Bite("factor", MATCHING, part, scaled) for part in MATCHING),
        *(Bite("hidden factor", MATCHING, part, unseen_at("beta", range(2, 8))) for part in MATCHING),
        Bite("hypothesis", ledger, "theta_polynomial", scaled),
        *(Bite("order", MATCHING, part, lambda text: f"{text} + 1", refutes=True) for part in MATCHING),
    ),
}
