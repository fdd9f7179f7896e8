"""Theta and its derivatives to a given relative accuracy: chooses a route and raises precision until it is met."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache, partial
from typing import Any, ClassVar, cast, overload

from flint import acb, arb, fmpq, fmpq_poly, fmpz

from gspot_verified.numbers.balls import (
    Exact,
    ExactInput,
    ball_text,
    bits_for_digits,
    checked_bits,
    is_exact,
    relative_bits,
    shrink_to_bits,
    working_bits,
)
from gspot_verified.numbers.complex_numbers import ComplexInput, exact_complex, is_complex, is_real
from gspot_verified.numbers.evidence import signed
from gspot_verified.numbers.verdict import NoTruthValue, Reason, Verdict
from gspot_verified.numbers.written import Written
from gspot_verified.theta_function.value.approach import approach, attempt, bits_of_input, tighter
from gspot_verified.theta_function.value.complex_value import ComplexEvaluation, EnclosedComplex, complex_value
from gspot_verified.theta_function.value.integer import polynomial
from gspot_verified.theta_function.value.mean_value import mean_value_form
from gspot_verified.theta_function.value.near import near_value
from gspot_verified.theta_function.value.routes import checked_arguments, shifted_parameter

_EXACT_POLYNOMIAL_BITS = 100_000  # of an integer polynomial's value that is cheap; beyond it the routes
# A value with no more bits than these above the goal is handed out as it is.
_FEW_MORE_BITS = 32


RealNumber = int | Fraction | fmpq | fmpz | arb
"""What stands for a real number, whatever its value."""


@dataclass(frozen=True, slots=True)
class Evaluation(NoTruthValue, Written):
    """The result of :func:`evaluate`.

    ``value`` contains the exact result for every exact input in the input balls, always. ``reached`` says whether its
    relative radius is at most 10^-digits. When it is not, ``reason`` says why: near a zero of Theta the absolute
    accuracy is what the ball shows, and the sign is undecided.
    """

    ask: ClassVar[str] = ".sign is a Verdict, .reached says whether the accuracy was reached"
    written: ClassVar[str] = "value=__str__ enclosure=value digits reached route working_bits reason"

    value: arb
    digits: int
    reached: bool
    route: str
    working_bits: int
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


@overload
def evaluate(
    tau: RealNumber, beta: ExactInput, derivative: int = 0, digits: int = 15, max_bits: int | None = None
) -> Evaluation: ...


@overload
def evaluate(
    tau: ComplexInput, beta: ExactInput, derivative: int = 0, digits: int = 15, max_bits: int | None = None
) -> ComplexEvaluation: ...


@overload  # a text may stand for a real or a complex number
def evaluate(tau: str, beta: ExactInput, derivative: int = 0, digits: int = 15, max_bits: int | None = None) -> Any: ...


def evaluate(
    tau: ExactInput | ComplexInput,
    beta: ExactInput,
    derivative: int = 0,
    digits: int = 15,
    max_bits: int | None = None,
) -> Evaluation | ComplexEvaluation:
    """d^k Theta/dtau^k (tau, beta) with relative accuracy 10^-digits, and how it was found.

    :param tau: |tau| <= 10^12; int, Fraction, fmpq, "decimal" or "fraction" string, or arb. Or complex, with real and
        imaginary part of at most 10^12: a string such as "1+2i" or "3/2-5/7i", acb, or mpc of mpmath; the result is
        then a :class:`~gspot_verified.theta_function.value.complex_value.ComplexEvaluation`.
    :param beta: |beta| <= 10^4, same types; integers and balls that hold integers included.
    :param derivative: k, 0..1000.
    :param digits: 1..10^6.
    :param max_bits: the budget: a route is asked for at most this many bits, the first one too (default 8 times the
        asked bits plus 16,384). Inside, a route adds what its own cancellation costs.
    :raises TypeError: a float or complex argument.
    :raises ValueError: an argument outside its domain.
    :raises BudgetError: the request would not fit in memory; raised beforehand. Of complex tau that is so where |tau|
        is some hundreds or more and the angle to the positive axis at most about 60 degrees.

    Source: paper, Appendix A; the routes and their bounds: ``proofs/``.

    >>> evaluate(-50, "7/3", digits=30).route
    'negative'
    >>> evaluate(0, 1).value
    0
    >>> print(evaluate("1+2i", "7/3", digits=10))
    [0.1550477658 +/- 4.01e-11] + [6.813060144 +/- 4.40e-10]i
    """
    goal = bits_for_digits(digits)
    if max_bits is not None:
        max_bits = checked_bits(max_bits, 64, name="max_bits")
    if is_complex(tau):
        place, route, bits, reason = _enclose_complex(tau, beta, derivative, goal, max_bits)
        reached = relative_bits(place) >= goal
        return ComplexEvaluation(place, digits, reached, route, bits, None if reached else reason or Reason.WIDE_INPUT)
    point, parameter = checked_arguments(cast("ExactInput", tau), beta, derivative)
    value, route, bits, reason = _enclose(point, parameter, derivative, goal, max_bits)
    reached = relative_bits(value) >= goal
    if reached:
        reason = None
    elif reason is None:
        reason = Reason.BUDGET if is_exact(point) and is_exact(parameter) else Reason.WIDE_INPUT
    return Evaluation(value, digits, reached, route, bits, reason)


def enclosure(tau: ExactInput | ComplexInput, beta: ExactInput, derivative: int, digits: int) -> arb | acb:
    """The value of :func:`evaluate` alone, in fewer steps; the same arguments and errors."""
    goal = bits_for_digits(digits)
    if is_complex(tau):
        return _enclose_complex(tau, beta, derivative, goal, None)[0]
    point, parameter = checked_arguments(cast("ExactInput", tau), beta, derivative)
    return _enclose(point, parameter, derivative, goal, None)[0]


def _enclose_complex(
    tau: object, beta: ExactInput, derivative: int, goal: int, max_bits: int | None
) -> EnclosedComplex:
    """Both arguments read exactly, each part of tau in the domain of a real one; on the real axis by its routes."""
    number = exact_complex(tau, "tau")
    checked_arguments(number.imaginary, beta, derivative)
    point, parameter = checked_arguments(number.real, beta, derivative)
    if not is_real(number):
        return complex_value(number, parameter, derivative, goal, max_bits)
    value, route, bits, reason = _enclose(point, parameter, derivative, goal, max_bits)
    return acb(value), route, bits, reason


_Enclosed = tuple[arb, str, int, Reason | None]
"""An enclosure, its route, the bits that were asked of the route, and why it is wider than asked (if it is)."""


def _enclose(tau: Exact, beta: Exact, derivative: int, goal: int, max_bits: int | None) -> _Enclosed:
    if derivative and isinstance(beta, fmpq) and beta.q == 1 and 0 <= beta.p < derivative:
        return arb(0), "polynomial", 0, None
    shifted, factor = shifted_parameter(beta, derivative, goal) if derivative else (beta, fmpq(1))
    enclosed: _Enclosed | None = None
    if max_bits is None and isinstance(tau, fmpq) and isinstance(shifted, fmpq):
        near = near_value(tau, shifted, goal + 2)
        if near is not None and relative_bits(near[0]) >= goal + 2:
            enclosed = near[0], "taylor", near[1], None
    if enclosed is None:
        enclosed = _exact_polynomial(tau, shifted, goal)
    if enclosed is None:
        worth = min(goal + 2, bits_of_input(tau, shifted))
        enclosed = _of_inputs(tau, shifted, worth, max_bits)
        if (
            worth < goal + 2 and relative_bits(enclosed[0]) >= worth
        ):  # the result depends on its inputs less than most do
            finer = _of_inputs(tau, shifted, goal + 2, max_bits)
            enclosed = (tighter(finer[0], enclosed[0]), *finer[1:])
    value, route, bits, reason = enclosed
    if derivative:
        with working_bits(goal + 32):
            value = value * factor
    elif bits <= goal + _FEW_MORE_BITS and route == "taylor":
        return enclosed
    return shrink_to_bits(value, goal + 16), route, bits, reason


def _of_inputs(tau: Exact, beta: Exact, goal: int, max_bits: int | None) -> _Enclosed:
    enclosed = _approach(tau, beta, goal, max_bits)
    if isinstance(tau, arb) and not tau.is_exact():
        return _centred(enclosed, tau, beta, goal, max_bits)
    return enclosed


@lru_cache(maxsize=64)
def _cached_polynomial(n: int) -> fmpq_poly:
    return polynomial(n)


def _exact_polynomial(tau: Exact, beta: Exact, goal: int) -> _Enclosed | None:
    """Theta at an integer beta and a rational tau, exactly, while its integers stay small."""
    if not (isinstance(tau, fmpq) and isinstance(beta, fmpq) and beta.q == 1 and beta.p >= 0):
        return None
    n = int(beta.p)
    if n * (tau.height_bits() + n.bit_length()) > _EXACT_POLYNOMIAL_BITS:
        return None
    with working_bits(goal + 32):
        return arb(_cached_polynomial(n)(tau)), "polynomial", goal, None


def _approach(tau: Exact, beta: Exact, goal: int, max_bits: int | None) -> _Enclosed:
    return approach(partial(attempt, tau, beta), is_exact(tau) and is_exact(beta), goal, max_bits)


def _centred(enclosed: _Enclosed, tau: arb, beta: Exact, goal: int, max_bits: int | None) -> _Enclosed:
    """The common part with the mean value form over the ball tau."""
    center = _approach(tau.mid(), beta, goal, max_bits)[0]
    with working_bits(goal + 64):
        below = beta - 1
    form = mean_value_form(beta, tau.rad(), center, attempt(tau, below, goal)[1], goal + 64)
    return tighter(enclosed[0], form), *enclosed[1:]
