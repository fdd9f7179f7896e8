"""C, the coefficient of the slow solution in any state of the contact phase: an integral over (0, 1).

Proof page: ``proofs/first_integrals.md``, sections 2 and 3.
"""

from __future__ import annotations

import math

from flint import acb, acb_poly, arb, fmpq

from gspot_verified.compliant.model.kernel import Kernel, kernel
from gspot_verified.compliant.model.normal_form import Deviation
from gspot_verified.numbers.balls import add_remainder, approximate, nonfinite, working_bits
from gspot_verified.theta_function.sums.quadrature import holomorphic_integral

_GUARD_BITS = 32  # bits beyond those asked for, lost on the way; any number is right
_FARTHEST_X = fmpq(1, 16)  # a hypothesis: x_1 <= 1/16, proofs/first_integrals.md, section 3
_BISECTIONS = 80  # beyond the bits of a double; any height is right


def slow_coefficient(state: Deviation, bits: int) -> arb:
    """C = (1/Gamma(beta)) int_0^1 x^(beta-1) e^((-psi(-x) - p x)/epsilon) k(-x) dx.

    The absolute accuracy is near 2^-bits times the same integral with |b| + |V| + |Y| + |lambda| for (1 - x) k: C
    itself may be smaller, or 0.
    """
    # With p > 0 everything happens at x of the size of epsilon/p: far enough below 1/16, or the whole of (0, 1).
    if state.p > 32 * state.epsilon * (bits + fmpq(4) * state.beta):
        with working_bits(bits + _GUARD_BITS):
            data = kernel(state)
            return _scaled(data, bits) * data.beta.rgamma()
    # x/epsilon is large where the integrand lives: as many bits more.
    lost = max(0, math.ceil(-math.log2(approximate(state.epsilon))))
    with working_bits(bits + lost + _GUARD_BITS):
        data = kernel(state)
        return _logistic(data, bits) * data.beta.rgamma()


def _scaled(data: Kernel, bits: int) -> arb:
    """x = epsilon e^u up to x_1 <= 1/16, a bound beyond (section 3); hypotheses: p > 0, epsilon <= 1/2."""
    beta, epsilon, p = data.beta, data.epsilon, data.p
    height = (beta * (beta / p).log() - beta).mid()
    goal = (bits + 8) * math.log(2) + abs(approximate(height))
    lower = arb(-goal / approximate(beta) - 1)
    reach = 2 * (goal + 4 * approximate(beta)) / approximate(p)
    upper = arb(reach).log().min((_FARTHEST_X / epsilon).log().lower()).mid()
    series = cubic_coefficients(3 + math.ceil(bits / 3))

    def integrand(u: acb, _: bool) -> acb:
        y = u.exp()
        x = epsilon * y
        exponent = beta * u - p * y - x * x * y * cubic_quotient(x, series) - height
        return exponent.exp() * (data.b - x * data.V + x * x * (data.Y + x * data.force) / (1 - x))

    middle = height.exp() * holomorphic_integral(integrand, lower, upper).real
    last = epsilon * upper.exp()
    if not (p > 0 and last <= _FARTHEST_X and epsilon * lower.exp() <= fmpq(1, 2) and epsilon <= fmpq(1, 2)):
        return nonfinite()
    left = 2 * data.size * (beta * lower).exp() / beta
    rate = p / epsilon - (beta - 1).max(arb(0)) / last
    if not rate > 0:
        return nonfinite()
    right = data.size * last ** (beta - 1) * (fmpq(3, 2) - p * last / epsilon).exp() / rate
    return add_remainder(epsilon**beta * add_remainder(middle, left), right)


def cubic_coefficients(length: int) -> acb_poly:
    """psi(-x)/x^3 = 2/3 + x/4 + x^2/5 + ...: ``length`` terms."""
    return acb_poly([fmpq(2, 3)] + [fmpq(1, j) for j in range(4, length + 3)])


def cubic_quotient(x: acb, series: acb_poly) -> acb:
    """psi(-x)/x^3 for complex |x| < 1/2: the rest is at most |x|^n/((n + 3)(1 - |x|)) after n terms."""
    size, length = x.abs_upper(), series.degree() + 1
    if not size < fmpq(1, 2):
        return acb(nonfinite())
    rest = size**length / ((length + 3) * (1 - size))
    return series(x) + acb(add_remainder(arb(0), rest), add_remainder(arb(0), rest))


def _logistic(data: Kernel, bits: int) -> arb:
    """x = 1/(1 + e^(-u)), u in R, and bounds of both ends (section 2)."""
    beta, epsilon, p = data.beta, data.epsilon, data.p
    height = arb(_peak_height(*(approximate(v) for v in (beta, epsilon, p))))
    push = (-p).max(arb(0)) / epsilon
    goal = (bits + 8) * math.log(2)
    lower = arb(-(goal - min(0.0, approximate(height))) / approximate(beta) - 1)
    upper = arb(approximate(16 * epsilon / 3 * (goal + push - height)) + 1)

    def integrand(u: acb, analytic: bool) -> acb:
        # The smaller one of e^u and e^-u, so that wide boxes stay away from the pole of 1/(1 + e^u). The flag makes
        # the logarithm answer NaN on a box that meets u = +-pi i.
        if u.real.mid() > 0:
            small = (-u).exp()
            x, rest = 1 / (1 + small), small / (1 + small)
            log_x = -(1 + small).log(analytic)
            log_rest = log_x - u
        else:
            small = u.exp()
            x, rest = small / (1 + small), 1 / (1 + small)
            log_rest = -(1 + small).log(analytic)
            log_x = log_rest + u
        exponent = beta * log_x + data.exponent(-x, log_rest) - height
        return exponent.exp() * data.polynomial(-x, rest)

    middle = height.exp() * holomorphic_integral(integrand, lower, upper).real
    if not upper >= 0:
        return nonfinite()
    left = data.size * (push * lower.exp() + beta * lower).exp() / beta
    right = data.size * (push - 3 * upper / (16 * epsilon)).exp() * 16 * epsilon / 3
    return add_remainder(add_remainder(middle, left), right)


def _peak_height(beta: float, epsilon: float, p: float) -> float:
    """About the largest value of beta log x + (-psi(-x) - p x)/epsilon on (0, 1): a heuristic, any number is right."""
    lower, upper = 1e-320, 1.0
    for _ in range(_BISECTIONS):
        x = math.sqrt(lower * upper)
        rising = beta * epsilon * (1 - x) > x * (x * x * (2 - x) + p * (1 - x))
        lower, upper = (x, upper) if rising else (lower, x)
    cubic = x**3 * (2 / 3 + x / 4) if x < 1e-3 else -math.log1p(-x) - x - x * x / 2 + x**3 / 3
    return beta * math.log(x) - (cubic + p * x) / epsilon
