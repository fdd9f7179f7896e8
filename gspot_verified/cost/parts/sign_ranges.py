"""The part on signs: dTheta/dtau < 0 on whole ranges of tau and beta."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np
from flint import fmpq

from gspot_verified.cost.measurement.contest import Blueprint, Call, TimedRoute
from gspot_verified.cost.measurement.measurement import CERTIFIED, NO_BOUND, Limit
from gspot_verified.cost.parts.theta_digits import ode_run
from gspot_verified.cost.parts.zero_parts import limit_of_pieces
from gspot_verified.cost.peers.bisection import Bisection, Choice, bisect
from gspot_verified.numbers.verdict import Outcome
from gspot_verified.signs.cover.sign import SignResult, sign

_HALF_WIDTHS = (1, 2, 4, 8, 16, 50)  # of the range of tau around 0
_BISECTED, _BISECTED_MORE = (1, 2, 3), (4,)  # half widths for the bisection; more in full
_BETA = (fmpq(1, 100), fmpq(99, 100))  # nearly 0..1, for bisection needs a closed range
_PATIENCE = 60.0  # seconds for a bisection
_POINTS_OF_A_UNIT, _CURVES, _TOLERANCE = 20, 11, 1e-9  # how densely scipy looks


def _words(width: int) -> str:
    return f"τ in [−{width}, {width}]"


def _ours(width: int) -> Callable[[], SignResult]:
    return partial(sign, f"[-{width}..{width}]", f"[{_BETA[0]}..{_BETA[1]}]")


def _proved(width: int, result: Any) -> float | None:
    return float(width) if result.verdict.outcome is Outcome.PROVED else None


def _bisected(width: int) -> Call:
    return partial(bisect, (fmpq(-width), fmpq(width), *_BETA), Choice.BETTER, _PATIENCE)


def _finished(width: int, bisection: Bisection) -> float | None:
    return float(width) if bisection.finished else None


def _sampled(width: int) -> Call:
    def call() -> bool:
        negative = True
        for k in range(_CURVES):
            beta = _BETA[0] + k * (_BETA[1] - _BETA[0]) / (_CURVES - 1)
            for end in (-float(width), float(width)):
                points = np.linspace(0.0, end, _POINTS_OF_A_UNIT * width)
                negative &= bool((ode_run(beta, end, _TOLERANCE, t_eval=points).y[1] < 0).all())
        return negative

    return call


def _contestants() -> tuple[TimedRoute, ...]:
    return (
        TimedRoute(
            "this library", CERTIFIED, _HALF_WIDTHS, _ours, place=_proved, words=_words,
            theory="the ends are covered by the series at infinity, so a wider range costs almost nothing",
            exponent=0.0,
        ),
        TimedRoute(
            "FLINT 1F2 of boxes, halved", CERTIFIED, _BISECTED, _bisected, _BISECTED_MORE, place=_finished,
            words=_words, theory="boxes shrink like exp(−2 T^(3/2)/3), so time grows faster than any power",
        ),
        TimedRoute(
            "scipy at points", NO_BOUND, _HALF_WIDTHS, _sampled, place=lambda width, _: float(width),
            words=_words, exponent=1.0, theory="points on a grid",
        ),
    )  # fmt: skip


def _limit(_: bool) -> Limit:
    width = _HALF_WIDTHS[-1]
    return limit_of_pieces(_words(width), _ours(width)().columns, _ours(width))


SIGNS = Blueprint(
    key="signs",
    title="A sign on a whole range",
    question="dΘ/dτ < 0 for every τ in [−T, T] and every β in [1/100, 99/100].",
    axis="half-width T of the range of τ",
    symbol="T",
    contestants=_contestants,
    profiled=lambda _: (_words(_HALF_WIDTHS[-1]), _ours(_HALF_WIDTHS[-1])),
    limit=_limit,
    remarks=(
        f"scipy looks at {_POINTS_OF_A_UNIT} τ in each unit for {_CURVES} β and says nothing about what lies between; "
        "that its time is less proves nothing, for its answer is not one to the question.",
    ),
)
