"""Wrong formulas for the statements on the compliant model."""

from __future__ import annotations

from flint import fmpq
from paper.bite import Bite, Teeth, raised, replaced, scaled, unseen_at

from gspot_verified.paper.section_4 import section_4_outer as outer
from gspot_verified.paper.section_4_5 import compliant_model as ledger

_PRINTED, _HYPOTHESES = ledger.PRINTED, ledger.HYPOTHESES

ENTRIES = ledger.ENTRIES


def one_at_a_half(honest: str) -> str:
    """A factor that is 1 at β = 1/2 and changes its sign between 0 and 1."""
    return f"(1-8*(beta-1/2)^2)*({honest})"


MODEL = (
    Bite("factor", outer.PRINTED["4-deviation"], "equation", replaced("2*epsilon^2*b3", "3*epsilon^2*b3")),
    Bite("factor", outer.PRINTED["4-deviation-recover"], "lambda", lambda _: "b1"),
    Bite("hidden factor", ledger.WEIGHT, "exponent", unseen_at("k", (0, 1))),
    Bite("order", ledger.WEIGHT, "power", lambda text: f"{text} + 1"),
)
"""Another equation of the deviations, or another integrand, than those that go together."""
TEETH: Teeth = {
    "C-cases-I-II": (
        *MODEL,
        Bite("factor", ledger, "DEVIATION", scaled),
        Bite("hidden factor", _PRINTED["C-cases-I-II"], "side", one_at_a_half),
        Bite("hidden factor", ledger, "DEVIATION", one_at_a_half),
        Bite("hypothesis", _HYPOTHESES["C-cases-I-II"], "beta", lambda _: "2*v"),
        Bite("hypothesis", _HYPOTHESES["C-cases-I-II"], "C_1", lambda _: "x-1"),
        Bite("order", _PRINTED["C-cases-I-II"], "side", raised("C_1")),
        Bite("factor", _PRINTED["C-cases-I-II"], "side", lambda _: "-1", refutes=True),
    ),
    "C-iwc-case-III": (
        *MODEL,
        Bite("factor", ledger, "BELOW", lambda share: share * fmpq(102, 100)),
        Bite("hidden factor", _PRINTED["C-iwc-case-III"], "side", unseen_at("beta", ("3/2", "5/2", "7/2"))),
        Bite("hypothesis", _HYPOTHESES["C-iwc-case-III"], "beta", lambda _: "6*v"),
        Bite("order", _PRINTED["C-iwc-case-III"], "side", raised("C_1")),
        Bite("order", ledger, "lower_terms", lambda honest: lambda b: honest(b)[:-1]),
    ),
    "C-lift-off": (
        *MODEL,
        Bite("hidden factor", _PRINTED["C-lift-off"], "side", unseen_at("beta", ("3/2", "5/2", "7/2"))),
        Bite("hypothesis", _HYPOTHESES["C-lift-off"], "beta", lambda _: "6*v"),
        Bite("order", _PRINTED["C-lift-off"], "side", raised("C_1")),
        Bite("order", ledger, "series_coefficients", lambda honest: lambda k: honest(k + 1)[:k]),
    ),
}
