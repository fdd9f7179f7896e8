"""The parts on zeros: their number over a range of beta (the atlas), and brackets at one beta."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from typing import Any

from flint import fmpq

from gspot_verified.certificates.text import certificate_text
from gspot_verified.cost.measurement.contest import Blueprint, Call, TimedRoute, best_time
from gspot_verified.cost.measurement.measurement import CERTIFIED, NO_BOUND, Limit
from gspot_verified.cost.parts.theta_digits import TOLERANCES, ode_zeros, right_decimals
from gspot_verified.cost.times.baseline import mpmath_theta
from gspot_verified.numbers.balls import approximate, bits_for_digits, working_bits
from gspot_verified.signs.cover.pieces import Column
from gspot_verified.signs.zeros.brackets import zeros_at
from gspot_verified.signs.zeros.zeros import zeros_on_range
from gspot_verified.theta_function.arrays.prepared import PreparedTheta
from gspot_verified.theta_function.theta import theta

_ENDS, _MORE_ENDS = (2, 3, 4, 5), (7, 9, 11, 13)  # atlases for beta in (1, end); more in full
_CURVES_OF_A_UNIT, _TOLERANCE = 20, 1e-9  # how densely scipy looks
BETA = fmpq(5, 2)  # of the zeros that are bracketed
_DIGITS, _MORE_DIGITS = (15, 50, 200, 500), (1_000, 2_000)  # more in full
_FEW, _FEW_MORE = (15, 50), (200,)  # fewer digits: mpmath is slower
_CALLS = 1_000  # timed together: one is too short
_LIMIT_DIGITS = {False: 500, True: 2_000}  # by whether the measurement is full


def atlas_text(end: int) -> str | None:
    """The certificate of the zeros for every beta in (1, end); None where nothing is proved."""
    zeros = zeros_on_range(f"1..{end}")
    return None if zeros.statement is None else certificate_text(zeros.statement, zeros.columns)


def _counted_by_ode(end: int) -> Call:
    def call() -> list[int]:
        steps = _CURVES_OF_A_UNIT * (end - 1)
        betas = (1 + fmpq(2 * k + 1, 2 * _CURVES_OF_A_UNIT) for k in range(steps))
        return [len(ode_zeros(beta, -10.0, 10.0, _TOLERANCE)) for beta in betas]

    return call


def _atlas_contestants() -> tuple[TimedRoute, ...]:
    def words(end: int) -> str:
        return f"β in (1, {end})"

    return (
        TimedRoute(
            "this library", CERTIFIED, _ENDS, lambda end: partial(atlas_text, end), _MORE_ENDS,
            words=words, exponent=3.0,
            theory="a cell (m, m + 1) has about m zeros, pieces and terms in a piece: m² at most, k³ in all",
        ),
        TimedRoute(
            "scipy at points", NO_BOUND, _ENDS, _counted_by_ode, (7,), words=words,
            place=lambda end, _: float(end), exponent=1.0, theory="points on a grid",
        ),
    )  # fmt: skip


def limit_of_pieces(asked: str, columns: Sequence[Column], call: Call) -> Limit:
    """One value of Theta for each piece: less cannot tell a sign on it."""
    pieces = sum(len(column.pieces) for column in columns)
    prepared = PreparedTheta(BETA, 15, 10)
    at = fmpq(17, 7)
    value = best_time(lambda: [prepared(at) for _ in range(_CALLS)], 5, fresh=False) / _CALLS
    return Limit(
        asked, f"one value of Θ with 15 digits for each of the {pieces} pieces", pieces * value, best_time(call)
    )


def _atlas_limit(_: bool) -> Limit:
    end = _ENDS[-1]
    return limit_of_pieces(f"β in (1, {end})", zeros_on_range(f"1..{end}").columns, partial(atlas_text, end))


ATLAS = Blueprint(
    key="atlas",
    title="The atlas of zeros",
    question="How many real zeros dΘ/dτ has, and where, for every β in (1, k), with the text of the certificate.",
    axis="k",
    symbol="k",
    contestants=_atlas_contestants,
    profiled=lambda _: (f"β in (1, {_ENDS[-1]})", partial(atlas_text, _ENDS[-1])),
    limit=_atlas_limit,
    remarks=(
        f"scipy counts changes of sign between its steps at {_CURVES_OF_A_UNIT} β in each unit: two zeros within a "
        "step are not seen, and nothing is said between the β.",
    ),
)


def _brackets(digits: int) -> Call:
    return partial(zeros_at, BETA, digits)


def _findroot(digits: int) -> Call:
    import mpmath  # type: ignore[import-untyped]

    starts = (-0.3, 1.5)

    def slope(tau: Any) -> Any:
        exact = fmpq(*(int(part) for part in mpmath.libmp.to_rational(tau._mpf_)))
        return mpmath_theta(exact, BETA, 1, digits)

    def call() -> list[Any]:
        with mpmath.workdps(digits):
            return [mpmath.findroot(slope, (x, x + 0.01), tol=mpmath.mpf(10) ** (3 - 2 * digits)) for x in starts]

    return call


def _of_the_ode(_: float, zeros: Any) -> float | None:
    known = zeros_at(BETA, 18).brackets
    if len(zeros) != len(known):
        return None
    digits = [right_decimals(x, approximate(lower)) for x, (lower, _) in zip(zeros, known, strict=True)]
    return min((d for d in digits if d is not None), default=None) if None not in digits else None


def _bracket_contestants() -> tuple[TimedRoute, ...]:
    return (
        TimedRoute(
            "this library", CERTIFIED, _DIGITS, _brackets, _MORE_DIGITS, exponent=1.0,
            theory="Newton’s steps double the digits, so a few values of that accuracy: like Θ itself",
        ),
        TimedRoute(
            "mpmath findroot", NO_BOUND, _FEW, _findroot, _FEW_MORE, exponent=2.0,
            theory="about ten values by mpmath’s 1F2 for each zero",
        ),
        TimedRoute(
            "scipy DOP853, events", NO_BOUND, TOLERANCES,
            lambda tolerance: partial(ode_zeros, BETA, -5.0, 5.0, tolerance),
            place=_of_the_ode, words=lambda tolerance: f"tolerance {tolerance:g}",
        ),
    )  # fmt: skip


def _limit(full: bool) -> Limit:
    digits = _LIMIT_DIGITS[full]
    with working_bits(bits_for_digits(digits) + 32):
        places = [(lower + upper) / 2 for lower, upper in zeros_at(BETA, digits).brackets]

    def values() -> None:
        for place in places:
            for derivative in (1, 2):
                theta(place, BETA, derivative, digits)

    words = f"dΘ/dτ and its derivative once at each of the {len(places)} zeros, with {digits} digits"
    return Limit(f"{digits} digits", words, best_time(values), best_time(_brackets(digits)))


BRACKETS = Blueprint(
    key="brackets",
    title="Brackets of zeros",
    question="Both real zeros of dΘ/dτ at β = 5/2 in brackets of width 10^−D, and that there are no others.",
    axis="digits D",
    symbol="D",
    contestants=_bracket_contestants,
    profiled=lambda full: (f"{_LIMIT_DIGITS[full]} digits", _brackets(_LIMIT_DIGITS[full])),
    limit=_limit,
    remarks=("mpmath and scipy return numbers near zeros; that there are no other zeros is not among what they say.",),
)
