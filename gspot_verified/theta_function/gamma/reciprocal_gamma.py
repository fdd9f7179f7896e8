"""1/Gamma, entire, with full relative accuracy next to its zeros.

Source: DLMF 5.5.3 (reflection). Proof page: ``proofs/initial_values.md``.
"""

from __future__ import annotations

from flint import arb, arb_series

from gspot_verified.numbers.balls import Exact, hull, series_length

_MAX_HALVINGS = 12  # of a wide ball, against endless work; then it is not finite
# Nearer to a zero than 1/1000 the reflection is used.
_NEARNESS = 1_000
# From here on Gamma of a rational by its own series (gamma_fmpq) is faster than Gamma of a ball.
_RATIONAL_BITS = 2_000


def reciprocal_gamma(z: Exact, bits: int) -> arb:
    """An enclosure of 1/Gamma(z) at the current precision ``bits``; exactly 0 at z = 0, -1, -2, ...

    Next to such a zero n, z = n + f, 1/Gamma(z) = (-1)^n sin(pi f) Gamma(1 - z)/pi with the exact f of a rational z,
    so the relative accuracy does not suffer however near the zero is.
    """
    if isinstance(z, arb):
        return _of_ball(z, _MAX_HALVINGS)
    if (z.q == 1 or z.q > _NEARNESS) and z.p <= 0:  # else no zero is so near
        numerator, denominator = int(z.p), int(z.q)
        above = numerator % denominator  # z = integer + above/denominator
        if above == 0:
            return arb(0)
        if _NEARNESS * min(above, denominator - above) < denominator:
            nearest = (2 * numerator + denominator) // (2 * denominator)
            product = arb(z - nearest).sin_pi() * arb(1 - z).gamma() / arb.pi()
            return -product if nearest % 2 else product
    return 1 / arb.gamma_fmpq(z) if bits > _RATIONAL_BITS else arb(z).rgamma()


def _of_ball(z: arb, halvings: int) -> arb:
    """FLINT's enclosure, or, where it knows nothing about a wide ball, the hull of those of two halves."""
    value = z.rgamma()
    if value.is_finite() or halvings == 0:
        return value
    middle, quarter = z.mid(), z.rad() / 2
    halves = arb(middle - quarter, quarter), arb(middle + quarter, quarter)
    return hull(_of_ball(half, halvings - 1) for half in halves)


def reciprocal_gamma_series(argument: arb, slope: arb, length: int) -> list[arb]:
    """Enclosures of the first ``length`` Taylor coefficients of 1/Gamma(argument + slope t) at t = 0."""
    with series_length(length):
        coefficients = list(arb_series([argument, slope], length).rgamma().coeffs())
    return coefficients + [arb(0)] * (length - len(coefficients))  # flint leaves out exact zeros at the end
