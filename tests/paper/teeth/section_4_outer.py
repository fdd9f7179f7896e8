"""Wrong formulas for the elimination and the deviations (Sec. 4)."""

from __future__ import annotations

from typing import Any

from paper.bite import Bite, Teeth, raised, replaced, scaled, unseen_at

from gspot_verified.paper.section_4 import section_4_outer as ledger

_PRINTED = ledger.PRINTED
_AT_INTEGERS = range(-3, 4)


ENTRIES = ledger.ENTRIES


def without_contact(honest: Any) -> Any:
    """λ_N = 0 in the equation of z: without the hypothesis of contact."""
    return lambda free: {**honest(free), "z": ledger.ALGEBRA.read("-z")}


def in_flight(honest: Any) -> Any:
    """λ_N = 0 in the equation of b: the same, where z has no part."""
    return lambda free: {**honest(free), "b0": ledger.ALGEBRA.read("epsilon*alpha2")}


def without_alpha_3(honest: Any) -> Any:
    """α_3 = 0: without the hypothesis α_3 < 0."""
    zero = {"alpha3": ledger.ALGEBRA.constant(0)}
    return lambda free: {name: ledger.ALGEBRA.substitute(rate, zero) for name, rate in honest(free).items()}


def of_equation(identifier: str) -> tuple[Bite, ...]:
    """Bites at a single equation."""
    return (
        Bite("factor", _PRINTED[identifier], "equation", scaled),
        Bite("factor", _PRINTED[identifier], "equation", replaced("2*epsilon^2", "2000001/1000000*epsilon^2")),
        Bite("hidden factor", _PRINTED[identifier], "equation", unseen_at("t", _AT_INTEGERS)),
        Bite("hidden factor", _PRINTED[identifier], "equation", unseen_at("epsilon", (0, 1))),
        Bite("hypothesis", ledger, "field", without_contact),
        Bite("order", _PRINTED[identifier], "equation", replaced("epsilon^3", "epsilon^4")),
        Bite("order", _PRINTED[identifier], "equation", raised("t")),
    )


def of_recovery(identifier: str) -> tuple[Bite, ...]:
    """Bites at the four formulas for y, v, z, λ_N."""
    names = tuple(_PRINTED[identifier])
    return (
        *(Bite("factor", _PRINTED[identifier], name, scaled) for name in names),
        *(Bite("hidden factor", _PRINTED[identifier], name, unseen_at("t", _AT_INTEGERS)) for name in names),
        Bite("hypothesis", ledger, "field", without_contact),
        *(Bite("order", _PRINTED[identifier], name, raised("epsilon")) for name in names),
    )


TEETH: Teeth = {
    "4-difference": tuple(
        Bite("hypothesis", ledger, "field", in_flight) if bite.kind == "hypothesis" else bite
        for bite in of_recovery("4-difference")
    ),
    "4-eliminated": of_equation("4-eliminated"),
    "4-order": (
        Bite("factor", ledger.CORRECTED["4-order"], "order", scaled),
        Bite("factor", _PRINTED["4-order"], "order", lambda _: "4"),
        Bite("hidden factor", ledger.CORRECTED["4-order"], "order", unseen_at("epsilon", (0, 1))),
        Bite("hypothesis", ledger, "field", without_alpha_3),
        Bite("order", ledger.CORRECTED["4-order"], "order", lambda _: "5"),
        Bite("order", _PRINTED["4-eliminated"], "equation", replaced("epsilon^3*b4", "epsilon^3*b5")),
    ),
    "4-recover": of_recovery("4-recover"),
    "4-deviation": of_equation("4-deviation"),
    "4-deviation-recover": of_recovery("4-deviation-recover"),
}
