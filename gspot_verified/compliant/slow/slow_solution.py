"""The slow solution F_b(T; epsilon) of the compliant model, at every epsilon > 0: chooses a route and raises precision.

Proof pages: ``proofs/exact_solution.md`` (what it is), ``proofs/slow_integral.md``, ``proofs/epsilon_series.md``.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar, cast, overload

from flint import arb, fmpq

from gspot_verified.compliant.slow.grid import scale
from gspot_verified.compliant.slow.routes import ROUTES, approximate_scaled
from gspot_verified.numbers.balls import (
    Exact,
    ExactInput,
    approximate,
    ball,
    ball_text,
    bits_for_digits,
    certainly_less,
    exact,
    is_exact,
    relative_bits,
    shrink_to_bits,
    working_bits,
)
from gspot_verified.numbers.evidence import signed
from gspot_verified.numbers.verdict import NoTruthValue, Reason, Verdict
from gspot_verified.numbers.written import Written
from gspot_verified.theta_function.value.routes import shifted_parameter

if TYPE_CHECKING:
    from numpy import ndarray

MAX_TENS = 300  # decimal exponent of 1/epsilon and of -T: plans are made in floats
MAX_EPSILON = 10**6  # a limit of input: ValueError beyond it
MAX_B = 200  # of |b|; a limit of input: ValueError beyond it
MAX_DERIVATIVE = 100  # a limit of input: ValueError beyond it
MAX_SCALED_TIME = 10**6  # of tau; a limit of input: ValueError beyond it
MAX_DIGITS = 1_000  # a limit of input: ValueError beyond it
_SERIES_BELOW = 1e-9  # epsilon, below which the series in eta comes first; any number is right
_SERIES_FROM_TAU = -30.0  # tau, from which on it does; any number is right


@dataclass(frozen=True, slots=True)
class SlowValue(NoTruthValue, Written):
    """The result of :func:`slow_value`: a ball that contains the exact value, always, and how it was found.

    ``reached``: its relative radius is at most 10^-digits; otherwise ``reason`` says why not.
    """

    ask: ClassVar[str] = ".sign is a Verdict, .reached says whether the accuracy was reached"
    written: ClassVar[str] = "value=__str__ enclosure=value digits reached route reason"

    value: arb
    digits: int
    reached: bool
    route: str
    reason: Reason | None = None

    @property
    def sign(self) -> Verdict:
        """The certified sign: proved, or undecided with the reason."""
        certain_sign = signed(self.value)
        if certain_sign is None:
            return Verdict.undecided("the sign", self.reason or Reason.WIDE_INPUT, f"value in {self}")
        return Verdict.proved(f"the value is {('zero', 'positive', 'negative')[certain_sign[0]]}", certain_sign[1])

    def __str__(self) -> str:
        return ball_text(self.value, self.digits)


def slow_value(
    time: ExactInput, b: ExactInput, epsilon: ExactInput, derivative: int = 0, digits: int = 15
) -> SlowValue:
    """d^k F_b/dT^k (T; epsilon), T = t/epsilon, with relative accuracy 10^-digits, and how it was found.

    F_b = (1/Gamma(-b)) fp int_0^oo r^(-b-1) e^(psi(r)/epsilon + r T) dr, psi(r) = r - r^2/2 - r^3/3 - ln(1 + r), is up
    to a factor the only solution of the model's equation for b-hat that grows slower than e^(|T|/2) backwards in time;
    (epsilon/2)^(b/3) F_b tends to Theta(tau, b), T = (epsilon/2)^(-1/3) tau, as epsilon tends to 0.

    :param time: T; tau = (epsilon/2)^(1/3) T at most 10^6.
    :param b: |b| <= 200, integers and balls included.
    :param epsilon: 10^-300 <= epsilon <= 10^6, also a ball.
    :param derivative: k, 0..100.
    :param digits: 1..1000.
    :raises TypeError: a float argument.
    :raises ValueError: an argument outside its domain.

    Source: ``proofs/exact_solution.md``; routes and bounds: ``proofs/slow_integral.md``, ``proofs/epsilon_series.md``.

    >>> print(slow_value(0, "1/2", "1/1000", digits=10))
    [1.871825138 +/- 5.66e-11]
    >>> slow_value("3/2", 2, "1/10").value.overlaps(arb(fmpq(9, 4)))
    True
    """
    goal, point, parameter, small = _checked(time, b, epsilon, derivative, digits)
    value, route, reason = _enclose(point, parameter, small, derivative, goal)
    reached = relative_bits(value) >= goal
    if reached:
        reason = None
    elif reason is None:
        reason = Reason.BUDGET if all(map(is_exact, (point, parameter, small))) else Reason.WIDE_INPUT
    return SlowValue(value, digits, reached, route, reason)


def _checked(
    time: ExactInput, b: ExactInput, epsilon: ExactInput, derivative: int, digits: int
) -> tuple[int, Exact, Exact, Exact]:
    if not 1 <= digits <= MAX_DIGITS:
        raise ValueError(f"digits must lie in 1..{MAX_DIGITS}, got {digits}")
    if isinstance(derivative, bool) or not isinstance(derivative, int):
        raise TypeError(f"derivative must be an int, got {type(derivative).__name__}")
    if not 0 <= derivative <= MAX_DERIVATIVE:
        raise ValueError(f"derivative must lie in 0..{MAX_DERIVATIVE}, got {derivative}")
    point, parameter, small = exact(time, "T"), exact(b, "b"), exact(epsilon, "epsilon")
    if not (fmpq(10) ** -MAX_TENS <= small and small <= MAX_EPSILON):
        raise ValueError(f"epsilon: expected a number in [1e-{MAX_TENS}, {MAX_EPSILON}]")
    if not (parameter >= -MAX_B and parameter <= MAX_B):
        raise ValueError(f"b: the library covers |b| <= {MAX_B}")
    with working_bits(1_024):  # 10^300 is exact in them
        # tau <= 10^6 as tau^3 = (epsilon/2) T^3 <= 10^18: exact for rationals; a ball T may reach a little beyond.
        limit = 2 * MAX_SCALED_TIME**3 * (1 if isinstance(point, fmpq) else 1 + fmpq(1, 2**20))
        if not (point >= -(fmpq(10) ** MAX_TENS) and small * point * point * point <= limit):
            raise ValueError(f"T: expected -1e{MAX_TENS} <= T and (epsilon/2)^(1/3) T <= {MAX_SCALED_TIME}")
    return bits_for_digits(digits), point, parameter, small


def _enclose(time: Exact, b: Exact, epsilon: Exact, derivative: int, goal: int) -> tuple[arb, str, Reason | None]:
    shifted, factor = shifted_parameter(b, derivative, goal)
    if isinstance(factor, fmpq) and factor == 0:
        return arb(0), "polynomial", None
    value, route, reason = _approach(time, shifted, epsilon, goal + 4)
    with working_bits(goal + 64):
        value = value * factor * scale(epsilon) ** -ball(shifted)
    return shrink_to_bits(value, goal + 16), route, reason


def _approach(time: Exact, b: Exact, epsilon: Exact, goal: int) -> tuple[arb, str, Reason | None]:
    """G_b by the preferred route, with rising precision until ``goal`` bits are certain or nothing is gained."""
    route = _preferred(time, b, epsilon)
    value = ROUTES[route](time, b, epsilon, goal)
    following = "integral" if route == "series" else route
    if not value.is_finite() and route == "series":
        route, value = following, ROUTES[following](time, b, epsilon, goal)
    wanted, certain = goal, relative_bits(value)
    while certain < goal:
        wanted = wanted + max(goal - certain, 16) + 8 if certain > 0 else 2 * wanted + 64
        if wanted > 8 * goal + 4_096:
            return value, route, Reason.BUDGET
        finer = ROUTES[following](time, b, epsilon, wanted)
        if not all(map(is_exact, (time, b, epsilon))) and not certainly_less(4 * finer.rad(), value.rad()):
            return finer if finer.is_finite() else value, following, Reason.WIDE_INPUT
        value, route, certain = finer, following, relative_bits(finer)
    return value, route, None


def _preferred(time: Exact, b: Exact, epsilon: Exact) -> str:
    if isinstance(b, fmpq) and b.q == 1 and b >= 0:
        return "polynomial"
    place = approximate_scaled(time, epsilon)[0]
    return "series" if approximate(epsilon) < _SERIES_BELOW and place > _SERIES_FROM_TAU else "integral"


@overload
def slow_solution(
    time: ExactInput, b: ExactInput, epsilon: ExactInput, derivative: int = 0, digits: int = 15
) -> arb: ...


@overload
def slow_solution(
    time: ndarray[Any, Any], b: ExactInput, epsilon: ExactInput, derivative: int = 0, digits: int = 15
) -> ndarray[Any, Any]: ...


def slow_solution(
    time: ExactInput | ndarray[Any, Any], b: ExactInput, epsilon: ExactInput, derivative: int = 0, digits: int = 15
) -> Any:
    """An enclosure of d^k F_b/dT^k (T; epsilon), as an ``arb``; arguments and errors: :func:`slow_value`.

    A numpy array for ``time`` gives an object array of balls of the same shape; floats in it stand for their exact
    binary values.

    >>> slow_solution(2, 2, "1/1000").overlaps(arb(4))
    True
    """
    if type(time).__name__ == "ndarray":  # by name: numpy is not imported before someone uses it
        import numpy as np

        points = cast("ndarray[Any, Any]", time)
        values = np.empty(points.shape, dtype=object)
        for index, entry in np.ndenumerate(points):
            values[index] = slow_value(_entry(entry), b, epsilon, derivative, digits).value
        return values
    return slow_value(cast("ExactInput", time), b, epsilon, derivative, digits).value


def _entry(value: Any) -> ExactInput:
    """An entry of an array; a float on purpose, as its exact binary value."""
    if isinstance(value, float):
        if value - value != 0:
            raise ValueError(f"T: every entry must be finite, got {value}")
        return fmpq(*value.as_integer_ratio())
    return int(value) if hasattr(value, "__index__") else cast("ExactInput", value)
