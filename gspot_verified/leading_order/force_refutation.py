"""A point at which the contact force at leading order is certainly < 0, against a statement that it is positive."""

from __future__ import annotations

from collections.abc import Iterable

from flint import fmpq

from gspot_verified.leading_order.contact_force import ContactForce
from gspot_verified.leading_order.force_over_balls import FOR_ALL, ForceOverBalls
from gspot_verified.numbers.evidence import less
from gspot_verified.signs.cover.refutation import Failure, Refutation, refutation
from gspot_verified.work.ranges import Range

_DIGITS = 40  # of the force, whose sign is wanted


def force_refutation(
    force: ContactForce | ForceOverBalls, statement: str, asked: Range, places: Iterable[fmpq], epsilon: fmpq
) -> Refutation | None:
    """Refute "lambda_N > 0 for every tau in ``asked``" by the first of the places that is in it and has lambda_N < 0.

    None when no place serves, certainly. Over balls: lambda_N < 0 there for every system of them.
    """
    words = f"λ_N < 0 {FOR_ALL}" if isinstance(force, ForceOverBalls) else "λ_N < 0"

    def failure(tau: fmpq) -> Failure:
        return words, less(force.value(tau, epsilon, _DIGITS), 0)

    return refutation(statement, {"τ": asked}, ((tau,) for tau in places), failure)
