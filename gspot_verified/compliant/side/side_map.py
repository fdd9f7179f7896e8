"""The exact side rule over (beta, epsilon) for the paper's initial data: certified signs at the points of a grid."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import ClassVar

from flint import fmpq

from gspot_verified.compliant.model.normal_form import Deviation
from gspot_verified.compliant.side.side_rule import coefficients
from gspot_verified.numbers.balls import sign_of, working_bits
from gspot_verified.numbers.verdict import NoTruthValue
from gspot_verified.numbers.written import Written
from gspot_verified.theta_function.gamma.reciprocal_gamma import reciprocal_gamma

PAPER_P = fmpq(1, 2)  # of the paper's initial data
_BITS = 40  # with which a sign is asked for at first
_FINER = 4  # times as many bits where the sign stayed open


@dataclass(frozen=True, slots=True)
class SidePoint(NoTruthValue, Written):
    """One point of the map: the certain signs of K and of its slow part C/Gamma(-beta), for b-hat/p = 1; None: open."""

    ask: ClassVar[str] = ".exact and .slow are 1, -1 or None"

    beta: fmpq
    epsilon: fmpq
    exact: int | None
    slow: int | None


def paper_deviation(beta: fmpq, epsilon: fmpq, p: fmpq = PAPER_P) -> Deviation:
    """The hats of the paper's initial data (y = 2 epsilon^2 b/p, z = epsilon^2 b/p, v = 0), scaled to b-hat = p.

    The data of the figures are this times b-hat/p = (1 - nu) mean force for beta > 1: K and C are linear in the hats.
    """
    return Deviation(beta, epsilon, p, p, fmpq(0), fmpq(2), fmpq(1))


def side_point(beta: fmpq, epsilon: fmpq) -> SidePoint:
    """The signs at one point, certain or None.

    >>> point = side_point(fmpq(13, 2), fmpq(1, 1000))
    >>> point.exact, point.slow
    (1, -1)
    """
    state = paper_deviation(beta, epsilon)
    for bits in (_BITS, _FINER * _BITS):
        slow, _, side = coefficients(state, bits)
        with working_bits(bits):
            part = slow * reciprocal_gamma(-beta, bits)
        signs = sign_of(side), sign_of(part)
        if None not in signs:
            break
    return SidePoint(beta, epsilon, *signs)


def side_map(
    betas: Sequence[fmpq], epsilons: Sequence[fmpq], progress: Callable[[int, int], None] | None = None
) -> list[SidePoint]:
    """The signs at every point of the grid, beta by beta; ``progress`` is told how many of how many betas are done."""
    points = []
    for done, beta in enumerate(betas, 1):
        points += [side_point(beta, epsilon) for epsilon in epsilons]
        if progress is not None:
            progress(done, len(betas))
    return points


def agreement_limits(points: Sequence[SidePoint]) -> dict[fmpq, fmpq | None]:
    """For each beta the largest epsilon of the grid from which on, downwards, both signs agree at every point; None
    where they differ, or one is open, at the smallest epsilon.

    >>> points = [side_point(fmpq(13, 2), fmpq(1, 10**n)) for n in (3, 5, 6)]
    >>> agreement_limits(points)
    {13/2: 1/100000}
    """
    limits: dict[fmpq, fmpq | None] = {}
    for beta in dict.fromkeys(point.beta for point in points):
        limits[beta] = None
        for point in sorted((p for p in points if p.beta == beta), key=lambda p: p.epsilon):
            if not point.exact or point.exact != point.slow:
                break
            limits[beta] = point.epsilon
    return limits
