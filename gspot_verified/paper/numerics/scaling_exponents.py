"""How b-hat, v-hat, y-hat at the G-spot scale with epsilon, from the paper's initial data: bounds for all small ones.

Proof page: ``proofs/scaling_exponents.md`` (Theorems E1 to E3, E5).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from flint import arb, fmpq

from gspot_verified.compliant.fast.decaying_coefficient import real_saddle
from gspot_verified.compliant.fast.fast_coefficient import saddle
from gspot_verified.compliant.fast.fast_part import fast_bound_at
from gspot_verified.compliant.model.normal_form import Deviation
from gspot_verified.compliant.slow.grid import scale
from gspot_verified.compliant.slow.slow_solution import slow_value
from gspot_verified.numbers.balls import nonfinite, working_bits
from gspot_verified.theta_function.value.evaluate import evaluate

NAMES = ("b", "v", "y")
LEAST_RATIO = fmpq(101, 100)
"""Neighbours of a series of epsilon differ by this factor at least (Theorem E3)."""
LARGEST_OF_BOUND = fmpq(1, 1024)
"""For p = 1/2 the bound of the fast coefficients is the same for all epsilon up to here."""
_START = fmpq(1, 2)
_BITS = 96
_DIGITS = 20


@dataclass(frozen=True, slots=True)
class Quantity:
    """q-hat at p = 0 is, up to a constant, C eta^power N, N = G_c or the integral with 1 + 1/(1+x) (page, section 1).

    ``index``: c; ``extra``: the power of epsilon that stands beside C; ``power``: that of eta; ``factor``: whether the
    factor 1 + 1/(1+x) is there.
    """

    index: fmpq
    extra: fmpq
    power: fmpq
    factor: bool


def quantity(beta: fmpq, name: str) -> Quantity:
    """b-hat, v-hat or y-hat as such an integral."""
    shift = {"b": 0, "v": 2, "y": 1}[name]
    extra = fmpq(1) if name == "y" else fmpq(0)
    return Quantity(beta - shift, extra, shift - beta, name != "b")


def limit_exponent(beta: fmpq, name: str) -> fmpq:
    """The exponent of epsilon in the limit: that of C, of the factor beside it, and a third of that of eta."""
    found = quantity(beta, name)
    return beta + found.extra + found.power / 3


def exponent_error(beta: fmpq, name: str, largest: fmpq) -> arb:
    """Theorem E1: a bound of |d ln|q|/d ln(epsilon) - limit| on (0, ``largest``], q the slow part of q-hat at p = 0.

    Not finite where a hypothesis fails; 0 < beta < 4, not an integer.
    """
    with working_bits(_BITS):
        found = quantity(beta, name)
        eta = scale(largest)
        slope = _slope_bound(found, largest, eta)
        least = _least_integral(found, eta, slope)
        if not least > 0:
            return nonfinite()
        return (eta / 3 * slope / least + _coefficient_error(beta, largest)).abs_upper()


def fast_share(beta: fmpq, name: str, largest: fmpq) -> arb:
    """Theorem E2: |fast part/slow part| of q-hat at p = 0 is at most this for every epsilon in (0, ``largest``]."""
    with working_bits(_BITS):
        if largest > LARGEST_OF_BOUND or not 3 * largest < _rate():
            return nonfinite()
    return share_at(beta, name, largest)


def share_at(beta: fmpq, name: str, epsilon: fmpq) -> arb:
    """The same at one epsilon alone, of any size (page, section 5)."""
    with working_bits(_BITS):
        found = quantity(beta, name)
        mean = fmpq(1)  # the size of b-hat over p at the start: both parts are proportional to it
        start = Deviation(beta, epsilon, _START, mean * _START, fmpq(0), 2 * mean, mean)
        hats = fast_bound_at(start, fmpq(0))
        fast = {"b": hats["b"], "v": epsilon * hats["V"], "y": epsilon**2 * (hats["force"] + hats["Z"])}[name]
        eta = scale(epsilon)
        least = _least_integral(found, eta, _slope_bound(found, epsilon, eta))
        slow = mean * epsilon * (arb(epsilon) / _START) ** (beta - 1) * _least_h(beta, epsilon) * eta**found.power
        slow = slow * arb(epsilon) ** found.extra * least
        if name != "b":
            slow = slow * _rising_size(beta, found.index) / beta
        if not slow > 0:
            return nonfinite()
        return (fast / slow).abs_upper()


def regression_error(beta: fmpq, name: str, largest: fmpq) -> arb:
    """Theorem E3: the slope of the regression of ln|q-hat| on ln(epsilon) at p = 0 differs from the limit by at most
    this, for every series of epsilon in (0, ``largest``] whose neighbours differ by a factor 101/100 or more."""
    with working_bits(_BITS):
        return (exponent_error(beta, name, largest) + _fast_change(beta, name, largest)).abs_upper()


def series_error(beta: fmpq, name: str, epsilons: Sequence[fmpq]) -> arb:
    """Theorem E1 and :func:`share_at` for one series (page, section 5): a bound of |slope - limit|, no epsilon being
    excluded by Theorem E2."""
    with working_bits(_BITS):
        shares = [share_at(beta, name, epsilon) for epsilon in epsilons]
        if not all(share < 1 for share in shares):
            return nonfinite()
        changes = [-(1 - share).log() for share in shares]
        weights = [
            abs(regression_slope([arb(int(k == place)) for k in range(len(epsilons))], epsilons))
            for place in range(len(epsilons))
        ]
        fast = sum((w * change for w, change in zip(weights, changes, strict=True)), arb(0))
        return (exponent_error(beta, name, max(epsilons)) + fast).abs_upper()


def pair_error(beta: fmpq, largest: fmpq) -> arb:
    """Theorem E5: the slopes of v-hat at beta + 1 and of y-hat at beta over one series as in E3 differ by at most this:
    their integrals N are the same."""
    with working_bits(_BITS):
        coefficients = _coefficient_error(beta, largest) + _coefficient_error(beta + 1, largest)
        changes = _fast_change(beta, "y", largest) + _fast_change(beta + 1, "v", largest)
        return (coefficients + changes).abs_upper()


def _fast_change(beta: fmpq, name: str, largest: fmpq) -> arb:
    """How much the fast part changes a slope between neighbours (page, section 5)."""
    share = fast_share(beta, name, largest)
    return -2 * (1 - share).log() / arb(LEAST_RATIO).log() if share < 1 else nonfinite()


def regression_slope(logarithms: Sequence[arb], epsilons: Sequence[fmpq]) -> arb:
    """The slope of the least-squares line through (ln epsilon, logarithm).

    >>> regression_slope([arb(2).log() * 3, arb(0), arb(2).log() * -3], [fmpq(2), fmpq(1), fmpq(1, 2)]).contains(3)
    True
    """
    places = [arb(epsilon).log() for epsilon in epsilons]
    middle = sum(places, arb(0)) / len(places)
    shifted = [place - middle for place in places]
    top = sum((x * f for x, f in zip(shifted, logarithms, strict=True)), arb(0))
    return top / sum((x * x for x in shifted), arb(0))


def _slope_bound(found: Quantity, largest: fmpq, eta: arb) -> arb:
    """A bound of |dN/d eta| on (0, eta] (page, section 3)."""
    c = found.index
    if not c < 4:
        return nonfinite()
    height = abs(_rising(-c, 4)) / 8 * _integral(c - 4, largest, eta)
    if not found.factor:
        return height
    if not c < 2:
        return nonfinite()
    first = _largest_size(c - 1, largest, eta)
    second = 2 * eta * abs(_rising(-c, 2)) * _integral(c - 2, largest, eta)
    return abs(c) * first + second + 2 * height


def _largest_size(c: fmpq, largest: fmpq, eta: arb) -> arb:
    """A bound of |G_c| at tau = 0 on (0, eta]: Gamma(-c) G_c increases in eta for c < 4, so an end is the largest."""
    return abs(evaluate(0, c, digits=_DIGITS).value).max(abs(_integral(c, largest, eta)))


def _integral(c: fmpq, largest: fmpq, eta: arb) -> arb:
    """G_c at tau = 0 and epsilon = ``largest``; for c < 0 it is positive and increases in eta."""
    return slow_value(0, c, largest, digits=_DIGITS).value * eta**c


def _least_integral(found: Quantity, eta: arb, slope: arb) -> arb:
    """|N| >= |N(0)| - eta sup |dN/d eta|, N(0) = G_c or 2 G_c at eta = 0, where G_c is Theta(0, c)."""
    start = abs(evaluate(0, found.index, digits=_DIGITS).value)
    return (2 if found.factor else 1) * start - eta * slope


def _coefficient_error(beta: fmpq, largest: fmpq) -> arb:
    """A bound of |d ln C/d ln(epsilon) - beta| on (0, ``largest``] (page, section 2)."""
    small, p = arb(largest), arb(_START)
    least = _least_h(beta, largest)
    tail = _tail(beta, largest)
    if not (least > 0 and tail.is_finite()):
        return nonfinite()
    share = small**2 / p**3 * beta * (beta + 1)
    below = beta * (3 * share + tail) / least
    above = (share * (beta + 2) * (p + fmpq(3, 4)) / p + tail) / least
    return below.max(above)


def _least_h(beta: fmpq, largest: fmpq) -> arb:
    """h_0: Gamma(beta) (epsilon/p)^beta h_0 is below J for every epsilon <= ``largest`` (page, section 2)."""
    small, p = arb(largest), arb(_START)
    return (1 - small**2 / p**3 * beta * (beta + 1) * (beta + 2) - _tail(beta, largest)).lower()


def _tail(beta: fmpq, largest: fmpq) -> arb:
    """A bound of what lies beyond x = 1/2 in each of the integrals, over p Gamma(beta) (epsilon/p)^beta."""
    small, p = arb(largest), arb(_START)
    if not (beta < 4 and (beta + 2) * largest < _START / 4):
        return nonfinite()
    return 25 / (p * arb(beta).gamma()) * (p / small) ** (beta - 1) * (-p / (2 * small)).exp()


def _rate() -> arb:
    """The lesser of Re g(r_+) and |r_3| p_0: how fast the fast parts fall with 1/epsilon."""
    top, p = saddle(_START), _START
    height: arb = (top * (1 - p - top / 2 - top * top / 3) - (1 + top).log()).real
    return height.min(-real_saddle(p) * p)


def _rising(a: fmpq, count: int) -> fmpq:
    found = fmpq(1)
    for k in range(count):
        found *= a + k
    return found


def _rising_size(beta: fmpq, index: fmpq) -> arb:
    """|(-beta)_n| with n = beta - index."""
    return abs(arb(_rising(-beta, int((beta - index).p))))
