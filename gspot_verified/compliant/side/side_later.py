"""K of a state at any p, after the G-spot as well: by quadrature on its own contour over the positive axis.

Proof page: ``proofs/flight.md``, section 6.
"""

from __future__ import annotations

import math
from collections.abc import Callable

from flint import acb, arb, fmpq

from gspot_verified.compliant.model.flight import ContactState
from gspot_verified.compliant.model.kernel import Kernel, kernel
from gspot_verified.compliant.model.normal_form import Deviation
from gspot_verified.compliant.slow.slow_coefficient import cubic_coefficients, cubic_quotient
from gspot_verified.numbers.balls import add_remainder, approximate, nonfinite, working_bits
from gspot_verified.theta_function.sums.quadrature import holomorphic_integral

_GUARD_BITS = 32  # bits beyond those asked for, lost on the way; any number is right
_BISECTIONS = 80  # beyond the bits of a double; any start > 0 is right
_SERIES_BELOW = fmpq(2, 5)  # |s| on the whole path: the series holds below 1/2, and boxes are wide


def side(state: ContactState, bits: int) -> arb:
    """K = -(beta/pi) Im int s^(beta-1) e^((-psi(s) + p s)/epsilon) k(s) ds from s_0 > 0 to infinity e^(i pi/3).

    Its sign is that of lambda as T tends to infinity along the contact. The absolute accuracy is near 2^-bits times
    the integral of the modulus, or what the balls of the state allow.
    """
    with working_bits(_bits(state.epsilon, bits)):
        return _side(_hats(state), bits)


def side_of_deviation(state: Deviation, bits: int) -> arb:
    """The same of an exact state that is given as its deviation from the trivial solution."""
    with working_bits(_bits(state.epsilon, bits)):
        return _side(kernel(state), bits)


def _bits(epsilon: fmpq, bits: int) -> int:
    """The exponent is a difference of numbers of the size of 1/epsilon."""
    return bits + max(0, math.ceil(-math.log2(approximate(epsilon)))) + _GUARD_BITS


def _side(data: Kernel, bits: int) -> arb:
    small, p = approximate(data.epsilon), approximate(data.p)
    start = arb(_start(small, p))
    last = arb(_last(small, p, approximate(start), approximate(data.beta), bits))
    exponent = _near_exponent(data, bits) if start + last < _SERIES_BELOW else _exponent(data)
    height = exponent(acb(start), False).real.mid()
    half = _half(data, start, last, exponent, height)
    rest = _beyond(data, start, last, height)
    return -data.beta / arb.pi() * height.exp() * add_remainder(half.imag, rest)


def _hats(state: ContactState) -> Kernel:
    """The state minus the trivial solution at the same p, which exists for beta other than 1."""
    mean = arb(state.alpha_2 / (1 - state.beta))
    small = (arb(state.beta), arb(state.epsilon))
    return Kernel(*small, state.p, state.b + state.p * mean, state.V, state.Y + 2 * mean, state.force - mean)


Exponent = Callable[[acb, bool], acb]


def _exponent(data: Kernel) -> Exponent:
    """(-psi(s) + p s)/epsilon in closed form."""
    return lambda s, analytic: data.exponent(s, (1 + s).log(analytic))


def _near_exponent(data: Kernel, bits: int) -> Exponent:
    """The same for |s| < 1/2 with -psi(s) = s^3 (2/3 - s/4 + s^2/5 - ...): on wide boxes nothing cancels."""
    series = cubic_coefficients(4 + bits)
    return lambda s, _: s * (s * s * cubic_quotient(-s, series) + data.p) / data.epsilon


def _half(data: Kernel, start: arb, last: arb, exponent: Exponent, height: arb) -> acb:
    """s = s_0 + e^(i pi/3) rho for 0 <= rho <= R, divided by e^height."""
    direction = _direction()

    def integrand(rho: acb, analytic: bool) -> acb:
        s = start + direction * rho
        total = (data.beta - 1) * s.log(analytic) + exponent(s, analytic) - height
        return total.exp() * (data.b + s * data.V + s * s * (data.Y - s * data.force) / (1 + s))

    return direction * holomorphic_integral(integrand, arb(0), last)


def _beyond(data: Kernel, start: arb, last: arb, height: arb) -> arb:
    """The rest beyond rho = R >= s_0, divided by e^height: -Re dE/d rho >= d(rho), E = epsilon exponent."""
    s = start + _direction() * last
    slope = last * last + start * last - start * start / 2 - data.p / 2
    growth = (data.beta - 1).max(arb(0))
    rate = slope / data.epsilon - (2 + growth) / last
    if not (start > 0 and last >= start and slope > 0 and rate > 0):
        return nonfinite()
    power = (2 * last) ** growth * last ** (data.beta - 1).min(arb(0))
    exponent = data.exponent(s, (1 + s).log()).real - height
    return data.size * (1 + 2 * last) ** 2 * power * exponent.exp() / rate


def _direction() -> acb:
    """e^(i pi/3)."""
    return acb(arb(1) / 2, arb(3).sqrt() / 2)


def _start(epsilon: float, p: float) -> float:
    """Near the positive saddle of p <= 0, and of the size of epsilon^(1/3) at least; any positive number is right."""
    lower, upper = 0.0, 2.0 + math.sqrt(abs(p))
    for _ in range(_BISECTIONS):
        s = (lower + upper) / 2
        if s**3 + 2 * s * s + p * s + p < 0:
            lower = s
        else:
            upper = s
    return max(lower, math.cbrt(epsilon / 2))


def _last(epsilon: float, p: float, start: float, beta: float, bits: int) -> float:
    """Where the cube has won; any number is right."""
    goal = (bits + 8 + 8 * beta) * math.log(2)
    return 2 * start + math.sqrt(max(p, 0.0)) + math.cbrt(6 * epsilon * goal)
