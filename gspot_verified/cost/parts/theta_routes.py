"""The part on Theta by route: 50 digits at every distance from 0, by each of the library's own series."""

from __future__ import annotations

from functools import partial
from typing import Any

from flint import arb, fmpq

from gspot_verified.cost.measurement.contest import Blueprint, Call, TimedRoute, best_time
from gspot_verified.cost.measurement.measurement import CERTIFIED, Limit
from gspot_verified.cost.times.baseline import flint_theta
from gspot_verified.numbers.balls import working_bits
from gspot_verified.theta_function.theta import theta
from gspot_verified.theta_function.value.routes import theta_by

BETA, DIGITS = fmpq(7, 3), 50  # of every value
_NEAR = (1, 3, 10, 30, 100, 300)  # |tau| for the series around 0
_ALL = (*_NEAR, 1_000, 10_000, 1_000_000)  # |tau| for the routes that reach everywhere
_MORE = (1_000,)  # in full
_LIMIT_TAU, _LIMIT_BITS = -1_000_000, 200  # where the asymptotic series needs hardly more than (-tau)^beta
_PANELS = {-1: "τ < 0", 1: "τ > 0"}
_ROUTES = {
    "taylor": ("Taylor series at 0", 1.5, "|τ|^(3/2) terms, for the largest term is like exp(2 |τ|^(3/2)/3)"),
    "laplace": ("Laplace integral", None, ""),
    "negative": ("series at τ → −∞", 0.0, "fewer terms the farther out"),
    "positive": ("series at τ → +∞", 0.0, "fewer terms the farther out"),
}


def _by(route: str, sign: int) -> TimedRoute:
    name, exponent, theory = _ROUTES[route]
    panel = _PANELS[sign]

    def call(distance: int) -> Call:
        return partial(theta_by, route, fmpq(sign * distance), BETA, digits=DIGITS)

    far = route in ("negative", "positive")
    return TimedRoute(
        name, CERTIFIED, _ALL if far else _NEAR, call, () if far else _MORE,
        place=_distance, words=lambda distance: f"τ = {sign * distance}", exponent=exponent, theory=theory, panel=panel,
    )  # fmt: skip


def _distance(distance: int, value: Any) -> float | None:
    return float(distance) if not isinstance(value, arb) or value.is_finite() else None


def _chosen(sign: int) -> TimedRoute:
    def call(distance: int) -> Call:
        return partial(theta, fmpq(sign * distance), BETA, 0, DIGITS)

    panel = _PANELS[sign]
    return TimedRoute(
        "this library’s choice", CERTIFIED, _ALL, call,
        words=lambda distance: f"τ = {sign * distance}", panel=panel,
    )  # fmt: skip


def _flint(sign: int) -> TimedRoute:
    def call(distance: int) -> Call:
        return partial(flint_theta, fmpq(sign * distance), BETA, 0, DIGITS, 1 << 14)

    panel = _PANELS[sign]
    return TimedRoute(
        "FLINT, three 1F2", CERTIFIED, _NEAR, call, _MORE,
        words=lambda distance: f"τ = {sign * distance}", panel=panel, exponent=1.5, theory="the same terms",
    )  # fmt: skip


def _contestants() -> tuple[TimedRoute, ...]:
    routes = []
    for sign, far in ((-1, "negative"), (1, "positive")):
        routes += [_chosen(sign), _by("taylor", sign), _by(far, sign), _by("laplace", sign), _flint(sign)]
    return tuple(routes)


def _limit(_: bool) -> Limit:
    def needed() -> None:
        with working_bits(_LIMIT_BITS):
            (arb(-_LIMIT_TAU).log() * arb(BETA)).exp()

    tau = fmpq(_LIMIT_TAU)
    words = f"one logarithm and one exponential of {_LIMIT_BITS} bits, for (−τ)^β"
    took = best_time(partial(theta, tau, BETA, 0, DIGITS), 15)
    return Limit(f"τ = {_LIMIT_TAU}, {DIGITS} digits", words, best_time(needed, 50, fresh=False), took)


ROUTES = Blueprint(
    key="routes",
    title="Θ by route",
    question=f"Θ(τ, 7/3) to {DIGITS} digits at τ = ∓d, by each series on its own and by the library’s choice "
    "among them.",
    axis="distance d from τ = 0",
    symbol="d",
    contestants=_contestants,
    profiled=None,
    limit=_limit,
    remarks=(
        "A series at infinity has no answer near 0, where its best accuracy is less than asked; for τ < 0 the Taylor "
        "series and the 1F2 lose about |τ|^(3/2) digits. A route makes one attempt, which may reach less than asked.",
    ),
)
