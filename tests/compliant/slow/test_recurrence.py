"""The recurrence in b, against the integrals themselves for b < 0. Page: proofs/exact_solution.md, section 3."""

from __future__ import annotations

import mpmath
import pytest
from flint import arb, fmpq
from witnesses.theta import contains_witness, to_fraction

from gspot_verified.compliant.slow.recurrence import climbed
from gspot_verified.numbers.balls import working_bits


def _value(b: mpmath.mpf, tau: mpmath.mpf, eta: mpmath.mpf) -> mpmath.mpf:
    """G_b = (1/Gamma(-b)) int rho^(-b-1) e^(-rho^3/3 + rho tau + h) drho, b < 0."""

    def integrand(r: mpmath.mpf) -> mpmath.mpf:
        x = eta * r
        cubic = (x - x**2 / 2 - x**3 / 3 - mpmath.log1p(x)) / (2 * eta**3)
        return r ** (-b - 1) * mpmath.exp(cubic + r * tau)

    return mpmath.quad(integrand, [0, 1, 2, 4, 8, 12]) * mpmath.rgamma(-b)


@pytest.mark.parametrize("steps", [0, 1, 3])
@pytest.mark.parametrize("tau", [fmpq(-3, 2), fmpq(2)])
def test_steps_up_against_quadrature(steps: int, tau: fmpq) -> None:
    b, eta = fmpq(-5, 4), fmpq(1, 5)
    with mpmath.workdps(40), working_bits(130):
        place, small = mpmath.mpf(int(tau.p)) / int(tau.q), mpmath.mpf(1) / 5
        powers = [mpmath.mpf(-5) / 4 - j for j in range(steps + 4)]
        values = [_value(power, place, small) for power in powers]
        lowest = [arb(fmpq(f.numerator, f.denominator)) for f in map(to_fraction, values[steps:])]
        found = climbed(lowest, b, steps, arb(tau), arb(eta))
        assert len(found) == 4
        for value, witness in zip(found, values, strict=False):
            assert contains_witness(value, to_fraction(witness), 25)
