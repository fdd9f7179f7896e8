"""The part on expansions: the order of Theorem 1's expansion against time, exact, in balls, and in sympy."""

from __future__ import annotations

from functools import partial

from gspot_verified.cost.measurement.contest import Blueprint, Call, TimedRoute, best_time
from gspot_verified.cost.measurement.measurement import CERTIFIED, Limit
from gspot_verified.cost.peers.sympy_expansion import sympy_extended
from gspot_verified.expansion.series.recursion import Recursion
from gspot_verified.expansion.trajectory import expand_in_balls, first_bits
from gspot_verified.mechanisms.shipped import shipped_system

_ORDERS, _MORE = (8, 15, 30, 60), (90, 120, 200)  # of delta; more in full
_SYMPY, _SYMPY_MORE = (4, 6), (8, 10)  # fewer orders: sympy is slow
_SYSTEM, _DIGITS = "extended", 15
_LIMIT_ORDER = {False: 60, True: 120}  # by whether the measurement is full


def _exact(order: int) -> Call:
    return partial(exact_terms, order)


def exact_terms(order: int) -> Recursion:
    """All terms below the order, in exact rationals."""
    recursion = Recursion(shipped_system(_SYSTEM))
    for _ in range(order):
        recursion.advance()
    return recursion


def _in_balls(order: int) -> Call:
    return partial(expand_in_balls, shipped_system(_SYSTEM), order, first_bits(order, _DIGITS))


def _contestants() -> tuple[TimedRoute, ...]:
    return (
        TimedRoute(
            "this library, exact", CERTIFIED, _ORDERS, _exact, _MORE, exponent=5.0,
            theory="n/18 products for each of n/18 blocks, coefficients of about n^2 bits: n^5 with fast products",
        ),
        TimedRoute(
            "this library, in balls", CERTIFIED, _ORDERS, _in_balls, _MORE, exponent=4.0,
            theory="n orders, n products each, with a number of bits that grows like n",
        ),
        TimedRoute(
            "sympy, exact", CERTIFIED, _SYMPY, lambda order: partial(sympy_extended, order), _SYMPY_MORE,
            theory="expressions are expanded before a coefficient is taken from them",
        ),
    )  # fmt: skip


def _limit(full: bool) -> Limit:
    order = _LIMIT_ORDER[full]
    terms = exact_terms(order).b

    def products() -> None:
        for n in range(2, order):
            for k in range(n + 1):
                terms[k] * terms[n - k]

    words = "one product of series at every order n, all b_j b_k with j + k = n"
    return Limit(f"order {order}", words, best_time(products, 1, fresh=False), best_time(_exact(order), 1))


EXPANSIONS = Blueprint(
    key="expansions",
    title="Expansions",
    question="All terms of Theorem 1 of order below n, extended system; in balls with 15 digits.",
    axis="order n",
    symbol="n",
    contestants=_contestants,
    profiled=lambda full: (f"order {_LIMIT_ORDER[full]}, exact", _exact(_LIMIT_ORDER[full])),
    limit=_limit,
)
