"""Integrals of holomorphic functions by FLINT's Petras quadrature."""

from __future__ import annotations

from collections.abc import Callable

from flint import acb, arb

MAX_EVALUATIONS = 50_000  # of one integrand, against endless work: beyond them the ball gets wide


def holomorphic_integral(
    integrand: Callable[[acb, bool], acb], lower: arb, upper: arb, max_evaluations: int = MAX_EVALUATIONS
) -> acb:
    """The integral of ``integrand`` over [lower, upper], by FLINT's Petras quadrature, at the current precision.

    ``integrand(z, analytic)`` must return an enclosure over the box z, and, when ``analytic`` is true, a non-finite
    ball unless the function is holomorphic on the whole box. A wrapper, so that this contract is stated at each use:
    ignoring ``analytic`` gives a wrong ball without any warning. Near ``max_evaluations`` the ball gets wide.
    """
    return acb.integral(integrand, acb(lower), acb(upper), eval_limit=max_evaluations)
