"""The three Gamma values behind the initial values at a rational beta, for thousands of digits.

With phi = -beta mod 1 and x = phi/3, Theta^(j)(0) is a power of 3 times a rational times Gamma(x + i/3)/Gamma(phi).
Proof page: ``proofs/initial_values.md``, section "Many digits".
"""

from __future__ import annotations

from flint import arb, fmpq

from gspot_verified.theta_function.gamma_ratio import gamma_ratio
from gspot_verified.theta_function.power import positive_power

# From here on two accelerated series are cheaper than two values of FLINT's gamma_fmpq.
_RATIOS_FROM_BITS = 5_000
_MAX_BETA = 100
_MAX_DENOMINATOR = 1_000
# Denominators at which FLINT knows Gamma through elliptic integrals.
_CHEAP = (1, 2, 3, 4, 6)


def pays(beta: fmpq) -> bool:
    """True where this form is cheaper than three Gamma values: not at integers, nor where x is a cheap rational."""
    if beta.q == 1 or abs(beta) > _MAX_BETA or beta.q > _MAX_DENOMINATOR:
        return False
    return int((_fraction(-beta) / 3).q) not in _CHEAP


def reduced_initial_values(beta: fmpq, bits: int) -> tuple[arb, arb, arb]:
    """Enclosures of Theta(0), Theta'(0), Theta''(0) at the current precision ``bits``, for a beta that ``pays``."""
    phi = _fraction(-beta)
    outer = arb.gamma_fmpq(phi)
    ratios = _over_outer(phi, outer, bits)
    reciprocal_shift = _gamma_shift(phi, -beta)
    cube_root, power = arb(3).root(3), positive_power(arb(3), -beta / 3 - 1)
    values = []
    for j in range(3):
        z = (j - beta) / 3
        i = int((3 * (_fraction(z) - phi / 3)).p)  # z = x + i/3 mod 1, i = 0, 1, 2
        values.append(power * ratios[i] * (_gamma_shift(phi / 3 + fmpq(i, 3), z) / reciprocal_shift))
        power *= cube_root
    return values[0], values[1], values[2]


def _over_outer(phi: fmpq, outer: arb, bits: int) -> list[arb]:
    """Gamma(x + i/3)/Gamma(phi), i = 0, 1, 2: two of them fresh, the third from Gauss's formula

    Gamma(x) Gamma(x + 1/3) Gamma(x + 2/3) = 2 pi 3^(1/2 - phi) Gamma(phi),   phi = 3x.
    """
    x = phi / 3
    product = 2 * arb.pi() * positive_power(arb(3), fmpq(1, 2) - phi)
    if bits < _RATIOS_FROM_BITS:
        first, second = arb.gamma_fmpq(x), arb.gamma_fmpq(x + fmpq(1, 3))
        return [first / outer, second / outer, product / (first * second)]
    near, far = gamma_ratio(x, bits), gamma_ratio(x + fmpq(1, 3), bits)
    first = (product / (outer * outer * near * near * far)).root(3)
    return [first, first * near, first * near * far]


def _fraction(value: fmpq) -> fmpq:
    return value - value.floor()


def _gamma_shift(start: fmpq, end: fmpq) -> fmpq:
    """Gamma(end)/Gamma(start), a rational, for end - start an integer."""
    steps = int((end - start).p)
    shift = fmpq(1)
    for i in range(abs(steps)):
        shift *= min(start, end) + i
    return shift if steps >= 0 else 1 / shift
