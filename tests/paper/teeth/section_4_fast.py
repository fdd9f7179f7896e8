"""Wrong formulas for the fast system of the outer scale (Sec. 4)."""

from __future__ import annotations

from typing import Any

from paper.bite import Bite, NotApplicable, Teeth, replaced, scaled, unseen_at

from gspot_verified.paper.section_4 import section_4_fast as ledger

_FAST = ledger.PRINTED["4-fast"]
_POLYNOMIAL = ledger.PRINTED["4-fast-polynomial"]
_DISCRIMINANT = ledger.PRINTED["4-discriminant"]
_ROOTS = ledger.PRINTED["4-roots-sum"]
_AT_INTEGERS = range(-3, 4)


ENTRIES = ledger.ENTRIES


def with_drift(honest: Any) -> Any:
    """With α_2: along all solutions, not only along deviations from the trivial one."""
    return lambda value, function, _free: honest(value, function, True)


def without_contact(honest: Any) -> Any:
    """λ_N = 0 in the equation of z."""
    return lambda free: {**honest(free), "z": ledger.ALGEBRA.read("-z")}


TEETH: Teeth = {
    "4-fast": (
        Bite("factor", _FAST, "equation", scaled),
        Bite("factor", _FAST, "equation", replaced("2*f3", "2000001/1000000*f3")),
        Bite("hidden factor", _FAST, "equation", unseen_at("p", _AT_INTEGERS)),
        Bite("hypothesis", ledger, "along", with_drift),
        Bite("order", _FAST, "equation", replaced("epsilon*", "epsilon^2*")),
    ),
    "4-fast-polynomial": (
        Bite("factor", _POLYNOMIAL, "polynomial", scaled),
        Bite("hidden factor", _POLYNOMIAL, "polynomial", unseen_at("p", _AT_INTEGERS)),
        Bite("hypothesis", ledger, "field", without_contact),
        Bite("order", _POLYNOMIAL, "polynomial", replaced("lam^2", "lam^3")),
    ),
    "4-stable": (
        Bite("factor", ledger, "CUBIC", scaled),
        Bite("hidden factor", ledger, "CUBIC", unseen_at("p", (1, 2, 3))),
        Bite("hypothesis", ledger.ALLOWED, "4-stable", lambda _: "x - w"),
        Bite("hypothesis", ledger, "field", without_contact),
        Bite("hypothesis", ledger.FAST_RATES, "z", lambda _: "-z"),
        Bite("order", ledger, "CUBIC", replaced("lam^2", "lam^4")),
    ),
    "4-discriminant": (
        Bite("factor", _DISCRIMINANT, "discriminant", scaled),
        Bite("factor", _DISCRIMINANT, "discriminant", replaced("13", "13000001/1000000")),
        Bite("hidden factor", _DISCRIMINANT, "discriminant", unseen_at("p", _AT_INTEGERS)),
        NotApplicable("hypothesis", "an identity for every p: the claim has no hypothesis"),
        Bite("order", _DISCRIMINANT, "discriminant", replaced("p^2", "p^3")),
    ),
    "4-roots-sum": (
        *(Bite("factor", _ROOTS, name, scaled) for name in ("sum", "product")),
        Bite("hidden factor", _ROOTS, "product", unseen_at("p", _AT_INTEGERS)),
        Bite("hypothesis", ledger.FAST_RATES, "z", lambda _: "-z"),
        Bite("order", _ROOTS, "product", replaced("-p", "-p^2")),
    ),
    "4-saddle": (
        Bite("factor", ledger, "CUBIC", scaled),
        Bite("hidden factor", ledger, "CUBIC", unseen_at("p", (-1, -2, -3))),
        Bite("hypothesis", ledger.ALLOWED, "4-saddle", lambda _: "x - w"),
        Bite("hypothesis", ledger, "field", without_contact),
        Bite("hypothesis", ledger.FAST_RATES, "z", lambda _: "-z"),
        Bite("order", ledger, "CUBIC", replaced("p*lam", "p*lam^2")),
    ),
}
