"""A certificate of lift-off or impact from a state of the model system, for all small epsilon.

The producer's side of ``proofs/from_state.md``, section 11. Nothing here is part of a proof: the checker makes its own.
"""

from __future__ import annotations

import math
from functools import reduce
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from flint import arb, fmpq, fmpq_mpoly

from gspot_verified.certificates.checker import check
from gspot_verified.certificates.text import SIDE_VERSION, sealed, write_text
from gspot_verified.expansion.from_state.model_side import ModelSide, Way
from gspot_verified.expansion.from_state.passage import ModelStart, rounded_up
from gspot_verified.expansion.from_state.slow_series import Contact, SlowSeries, slow_series, terms_of
from gspot_verified.expansion.true_solutions.bound import BITS
from gspot_verified.expansion.true_solutions.side_end import SideEnd
from gspot_verified.numbers.balls import approximate, ball, working_bits

_SHORT, _LAST, _FINE = 2**20, 2**60, 2**40  # denominators: of bounds, of p at the end of the rectangle, of cones
_MORE = fmpq(17, 16)  # of the time by which it happens: any number that the checker accepts is right
_PIECES = 21  # in a unit of tau


def side_certificate(side: ModelSide) -> str:
    """The text of a certificate that ``gspot-verified check`` reads: what ``side`` says, and by when.

    :raises ValueError: ``side`` is undecided, or the checker does not confirm it: its own bounds are coarser here and
        there, and its work is limited.

    >>> from gspot_verified import model_side
    >>> print(side_certificate(model_side("3/2", "1/2", -2, epsilon="1e-8"))[:36])
    {"format":"gspot_verified certificat
    """
    if not side.ends:
        raise ValueError(f"no side is proved for epsilon up to {side.epsilon}")
    with working_bits(BITS):
        statement = _statement(side, reduce(arb.max, (_latest(end, side.start.beta) for end in side.ends)))
        ranges = [_range(side.start, end, way) for end, way in zip(side.ends, side.ways, strict=True)]
        text = sealed(SIDE_VERSION, statement, ranges)
    with TemporaryDirectory() as folder:
        file = Path(folder, "side.cert")
        write_text(file, text)
        confirmed = check(file)
    if not confirmed.verified:
        raise ValueError(f"the checker does not confirm it: {confirmed.text}")
    return text


def _statement(side: ModelSide, latest: arb) -> dict[str, Any]:
    start, springs = side.start, side.start.regularisation
    return {
        "alpha": _texts(start.alpha_1, start.alpha_2, start.beta * start.alpha_1),
        "b": str(start.b),
        "by": str(rounded_up(latest, _SHORT << max(0, -math.frexp(approximate(latest))[1]))),
        "contact": _texts(springs.k_1, springs.k_2, springs.c),
        "epsilon": str(side.epsilon),
        "kind": "side",
        "p": str(start.p),
        "reaches": "0" if side.ends[0].side < 0 else str(side.force),
        "within": str(start.within),
    }


def _latest(end: SideEnd, beta: fmpq) -> arb:
    """By when it happens for every epsilon of a range: at the largest one, with some room."""
    return ball(end.most) ** 2 * end.latest(end.most**3, 2 * (beta - 1)) * ball(_MORE)


def _range(start: ModelStart, end: SideEnd, way: Way) -> dict[str, Any]:
    """One range of delta = epsilon^(1/3)."""
    place, contact = way.plan.place, Contact.of(start.regularisation)
    series = slow_series(start.beta, contact, way.plan.order)
    last = (ball(-start.alpha_1 * end.most**3 / way.tube.rectangle.h) ** 2).root(3)
    unit: float = approximate(-start.alpha_1 * contact.kappa) ** (1 / 3)
    cone = (end.cone.a, end.cone.c, end.cone.B, end.cone.C)
    return {
        "cone": _texts(*(rounded_up(value, _FINE) for value in cone)),
        "delta": str(end.most),
        "end": str(end.entered),
        "passage": _passage(way, series, rounded_up(last, _LAST)),
        "pieces": math.ceil(max(_PIECES * unit, 1) * approximate(ball(end.entered + place)) * 1.001),
        "scaled": str(place),
        "top": str(rounded_up(end.cone.top, _FINE)),
    }


def _passage(way: Way, series: SlowSeries, least: fmpq) -> dict[str, Any]:
    """What was chosen for Theorem B."""
    plan, tube = way
    return {
        "damping": str(plan.damping),
        "f": _terms(series.f),
        "growth": str(plan.growth),
        "largest": str(tube.largest),
        "least": str(least),
        "norm": _texts(plan.k_1, plan.k_2),
        "rate": str(rounded_up(tube.rate, _LAST)),
        "rectangle": _texts(tube.rectangle.h, tube.rectangle.r),
        "v": _terms(series.v),
        "w": _terms(series.w),
    }


def _texts(*values: fmpq) -> list[str]:
    return [str(value) for value in values]


def _terms(polynomial: fmpq_mpoly) -> list[list[Any]]:
    return [[*key, str(value)] for key, value in sorted(terms_of(polynomial).items())]
