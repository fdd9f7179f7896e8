"""The three Gamma values behind the initial values at a rational beta, for thousands of digits.

With phi = -beta mod 1 and x = phi/3, Theta^(j)(0) is a power of 3 times a rational times Gamma(x + i/3)/Gamma(phi).
Proof page: ``proofs/initial_values.md``, section "Many digits".
"""

from __future__ import annotations

from flint import arb, fmpq

from gspot_verified.theta_function.gamma.gamma_ratio import scaled_gamma_ratio
from gspot_verified.theta_function.gamma.power import positive_power

# Up to 3,456 bits FLINT has a table; from here on two accelerated series are cheaper than two values of its Gamma.
_RATIOS_FROM_BITS = 3_457
_MAX_BETA = 100  # so far the shifts by integers are cheap
_MAX_DENOMINATOR = 1_000  # so far the series with its powers of q is cheap
# Denominators of x at which FLINT knows Gamma(x), Gamma(x + 1/3), Gamma(x + 2/3) through elliptic integrals.
_CHEAP = (1, 2, 3, 6)
_TWELFTHS = (4, 12)  # those of x at which the three arguments are twelfths, phi is 1/4 or 3/4


def pays(beta: fmpq) -> bool:
    """True where this form is cheaper than three Gamma values: not at integers, nor where x is a cheap rational."""
    if beta.q == 1 or abs(beta) > _MAX_BETA or beta.q > _MAX_DENOMINATOR:
        return False
    return int((_fraction(-beta) / 3).q) not in _CHEAP


def reduced_initial_values(beta: fmpq, bits: int) -> tuple[arb, arb, arb]:
    """Enclosures of Theta(0), Theta'(0), Theta''(0) at the current precision ``bits``, for a beta that ``pays``."""
    phi = _fraction(-beta)
    if int((phi / 3).q) in _TWELFTHS:
        first, ratios = _from_twelfths(phi, -beta)
    else:
        first, ratios = (_from_gamma if bits < _RATIOS_FROM_BITS else _from_series)(phi, -beta, bits)
    reciprocal_shift = _gamma_shift(phi, -beta)
    cube_root = arb(3).root(3)
    values = []
    for j in range(3):
        z = (j - beta) / 3
        i = int((3 * (_fraction(z) - phi / 3)).p)  # z = x + i/3 mod 1, i = 0, 1, 2
        values.append(first * ratios[i] * (_gamma_shift(phi / 3 + fmpq(i, 3), z) / reciprocal_shift))
        first *= cube_root
    return values[0], values[1], values[2]


_Ratios = tuple[arb, list[arb]]
"""A factor f and f_0, f_1, f_2 with f f_i = 3^(-beta/3 - 1) Gamma(x + i/3)/Gamma(phi), phi = 3x."""


def _from_gamma(phi: fmpq, minus_beta: fmpq, _: int) -> _Ratios:
    """From two values of Gamma beside Gamma(phi); the third by Gauss's formula:

    Gamma(x) Gamma(x + 1/3) Gamma(x + 2/3) = 2 pi 3^(1/2 - phi) Gamma(phi).
    """
    x, three = phi / 3, arb(3)
    first, second = arb.gamma_fmpq(x), arb.gamma_fmpq(x + fmpq(1, 3))
    product = 2 * arb.pi() * positive_power(three, fmpq(1, 2) - phi)
    outer = arb.gamma_fmpq(phi)
    return positive_power(three, minus_beta / 3 - 1) / outer, [first, second, product * outer / (first * second)]


def _from_series(phi: fmpq, minus_beta: fmpq, bits: int) -> _Ratios:
    """From the series of S_1 = Gamma(2/3) Gamma(x + 1/3)/Gamma(x) and S_2, the same at x + 1/3.

    f is the cube root of 2 pi 3^(1/2 - phi - beta - 3) Gamma(2/3)^3/(Gamma(phi)^2 S_1^2 S_2); phi + beta is an integer.
    """
    x = phi / 3
    near, far = scaled_gamma_ratio(x, bits), scaled_gamma_ratio(x + fmpq(1, 3), bits)
    unit = arb.gamma_fmpq(fmpq(2, 3))
    outer = unit if phi == fmpq(2, 3) else arb.gamma_fmpq(phi)
    power = fmpq(3) ** int((minus_beta - phi).p - 3)
    square = outer * near
    cube = 2 * arb.pi() * arb(3).sqrt() * power * unit**3 / (square * square * far)
    second = near / unit
    return cube.root(3), [arb(1), second, second * far / unit]


def _from_twelfths(phi: fmpq, minus_beta: fmpq) -> _Ratios:
    """From Gamma(1/4) and Gamma(1/3), for phi = 1/4 and 3/4: Gamma(1/12) and Gamma(5/12) by product and quotient."""
    quarter = arb.gamma_fmpq(fmpq(1, 4))
    product = (2 * arb(3).sqrt()).sqrt() * quarter**2
    high_sine = arb.sin_pi_fmpq(fmpq(5, 12))
    quotient = positive_power(arb(2), fmpq(5, 6)) * high_sine * arb.gamma_fmpq(fmpq(1, 6)) / arb.pi().sqrt()
    first, fifth = (product * quotient).sqrt(), (product / quotient).sqrt()
    three_quarters = arb.pi() * arb(2).sqrt() / quarter
    factor = positive_power(arb(3), minus_beta / 3 - 1)
    if phi == fmpq(1, 4):
        return factor / quarter, [first, fifth, three_quarters]
    seventh, eleventh = arb.pi() / (high_sine * fifth), arb.pi() / (arb.sin_pi_fmpq(fmpq(1, 12)) * first)
    return factor / three_quarters, [quarter, seventh, eleventh]


def _fraction(value: fmpq) -> fmpq:
    return value - value.floor()


def _gamma_shift(start: fmpq, end: fmpq) -> fmpq:
    """Gamma(end)/Gamma(start), a rational, for end - start an integer."""
    steps = int((end - start).p)
    shift = fmpq(1)
    for i in range(abs(steps)):
        shift *= min(start, end) + i
    return shift if steps >= 0 else 1 / shift
