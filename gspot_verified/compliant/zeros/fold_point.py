"""The beta at which two zeros of the slow solution meet and vanish, at one epsilon, in a certified bracket.

Curves of such points leave (beta, epsilon) = (6, 0), (9, 0), ... to the left.

Proof page: ``proofs/finite_epsilon_zeros.md``, section 6.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import reduce

from flint import arb, fmpq

from gspot_verified.compliant.patches.slow_patch import SlowPatch
from gspot_verified.compliant.slow.slow_jet import slow_jet
from gspot_verified.compliant.slow.slow_signs import SlowSigns
from gspot_verified.compliant.zeros.fold_column import fold_parts, is_fold, nearest_minimum
from gspot_verified.compliant.zeros.zero_count import checked_point
from gspot_verified.leading_order.stretches import narrowed
from gspot_verified.numbers.balls import ExactInput, bits_for_digits, working_bits

MAX_DIGITS = 40  # of beta; a limit of input: ValueError beyond it
MEETINGS = (6, 9)
_LEAST_EPSILON, _MAX_EPSILON = fmpq(1, 10**9), fmpq(500)  # limits of input: ValueError beyond them
_SEARCH_STEP = fmpq(1, 8)  # in beta, downwards from the meeting: a heuristic
_SEARCHES = 6  # bisections of that step: a heuristic
# The curve from 9 passes beta = 8 here, a double zero of F_7; beyond, the curve from 12 comes into (8, 9).
_LEAVES_8 = fmpq(1527, 1000)
_HALF_WIDTHS = (fmpq(1, 16), fmpq(1, 64), fmpq(1, 256))
_TAU_WIDTHS = (fmpq(1, 4), fmpq(1, 8), fmpq(1, 2))
_SPARE_BITS = 64  # bits beyond those asked for, lost on the way; any number is right


@dataclass(frozen=True, slots=True)
class FoldPoint:
    """lower < beta_f < upper: the only beta of ``range`` at which F_(beta-1) has a double zero with tau in ``tau``; on
    the range it has two simple zeros there for beta < beta_f and none for beta > beta_f."""

    epsilon: fmpq
    lower: fmpq
    upper: fmpq
    range: tuple[fmpq, fmpq]
    tau: tuple[fmpq, fmpq]


def fold_point(epsilon: ExactInput, digits: int = 8, meeting: int = 6) -> FoldPoint | None:
    """The fold that starts from beta = ``meeting`` at epsilon = 0, to 10^-digits in beta; None: it was not certified.

    That the point lies on the curve from ``meeting`` is how it was sought; certified is what FoldPoint says. The
    bracket is wider where a sign stayed open, as at epsilon = 32, where beta_f is 5 exactly.

    :param epsilon: 10^-9 <= epsilon <= 500, one number.
    :param meeting: 6 or 9.
    :raises ValueError: an argument outside its domain.

    >>> fold = fold_point(1, 5)
    >>> fold is not None and fold.lower < fmpq(5670239, 10**6) < fold.upper
    True
    """
    small = checked_point(epsilon, "epsilon")
    if not _LEAST_EPSILON <= small <= _MAX_EPSILON:
        raise ValueError(f"epsilon: expected a number in [1e-9, {_MAX_EPSILON}]")
    if type(digits) is not int or not 1 <= digits <= MAX_DIGITS:
        raise ValueError(f"digits must be an int and lie in 1..{MAX_DIGITS}")
    if meeting not in MEETINGS:
        raise ValueError(f"meeting: expected one of {MEETINGS}, got {meeting}")
    centre, place = _search(small, meeting)
    for b_width in _HALF_WIDTHS:
        lower, upper = centre - b_width, centre + b_width
        patch = SlowPatch(lower, upper, small, small)
        signs, slopes = patch.signs(lower, upper), patch.slopes(lower, upper)
        for tau_width in _TAU_WIDTHS:
            begin, end = place - tau_width, place + tau_width
            if is_fold(signs, slopes, begin, end):
                return _narrowed(small, (lower, upper), (begin, end), _convexity(signs, begin, end), digits)
    return None


def _search(epsilon: fmpq, meeting: int) -> tuple[fmpq, fmpq]:
    """b and tau near the fold. A heuristic: from the meeting downwards the first minimum becomes negative there."""
    start = fmpq(meeting - 1 if meeting == 6 or epsilon < _LEAVES_8 else 7)
    high, low, place, found = start, start, fmpq(0), False
    while not found and low > meeting - 4:
        high, low = low, low - _SEARCH_STEP
        place, found = _negative_minimum(low, epsilon, place)
    for _ in range(_SEARCHES):
        middle = (low + high) / 2
        place, found = _negative_minimum(middle, epsilon, place)
        low, high = (middle, high) if found else (low, middle)
    return (low + high) / 2, place


def _negative_minimum(b: fmpq, epsilon: fmpq, place: fmpq) -> tuple[fmpq, bool]:
    """Where the first minimum is if it is negative; else ``place`` and False."""
    minimum, value = nearest_minimum(b, epsilon)
    return (minimum, True) if minimum is not None and value < 0 else (place, False)


def _convexity(signs: SlowSigns, begin: fmpq, end: fmpq) -> arb:
    """A positive lower bound of G''/2 on the interval and for all b of the box."""
    first, *others = [signs.coefficients(a, b, 3)[2].lower() for a, b in fold_parts(begin, end)]
    return reduce(arb.min, others, first)


def _narrowed(
    epsilon: fmpq, b: tuple[fmpq, fmpq], tau: tuple[fmpq, fmpq], convexity: arb, digits: int
) -> FoldPoint | None:
    def beyond(beta: fmpq) -> bool | None:
        return _is_positive(beta - 1, epsilon, tau, convexity, bits_for_digits(digits) + _SPARE_BITS)

    lower, upper = b[0] + 1, b[1] + 1
    if not convexity > 0 or beyond(lower) is not False or beyond(upper) is not True:
        return None
    ends = narrowed(beyond, lower, upper, digits)
    return FoldPoint(epsilon, *ends, (lower, upper), tau)


def _is_positive(b: fmpq, epsilon: fmpq, tau: tuple[fmpq, fmpq], convexity: arb, bits: int) -> bool | None:
    """Whether G > 0 on the interval of tau; False when it is negative at a point of it; None when that stays open."""
    place = (tau[0] + tau[1]) / 2
    for _ in range(3 + bits.bit_length()):
        value, slope, half_curvature = slow_jet(place, b, epsilon, 3, bits)
        if value < 0:
            return False
        with working_bits(bits):
            # G(tau) >= c_0 + c_1 x + m x^2 >= c_0 - c_1^2/(4 m), m > 0 a lower bound of G''/2.
            if value - slope * slope / (4 * convexity) > 0:
                return True
            step = slope / (2 * half_curvature)
        if not step.is_finite():
            return None
        following = place - _rounded(step, bits)
        if not tau[0] < following < tau[1] or following == place:
            return None
        place = following
    return None


def _rounded(value: arb, bits: int) -> fmpq:
    with working_bits(4 * bits + 64):
        scaled = (value.mid() * 2**bits).floor().unique_fmpz()
    assert scaled is not None  # an exact number
    return fmpq(scaled, 2**bits)
