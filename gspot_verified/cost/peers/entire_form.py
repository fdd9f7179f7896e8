"""What a user of FLINT alone would best do: the entire form of Theta, from three 1/Gamma and three 1F2.

The initial values are those of ``proofs/initial_values.md``, which are nowhere 0/0; the three 1F2 are those of
Theorem 4 (th:3) of the paper.
"""

from __future__ import annotations

from flint import arb, fmpq

from gspot_verified.cost.times.baseline import LOWER
from gspot_verified.numbers.balls import working_bits

_HALF = fmpq(1, 2)  # exact, made once


def entire_form(tau: fmpq, beta: fmpq, bits: int) -> arb:
    """One evaluation at one working precision; possibly wide, or not finite.

    >>> entire_form(fmpq(3), fmpq(2), 64).contains(arb(9))
    True
    """
    with working_bits(bits):
        first, second, third = (arb((j - beta) / 3).rgamma() for j in range(3))
        log = arb(3).log()
        root = (log / 3).exp()
        constant = 2 * arb.pi() * (log * arb(2 * beta / 3 - _HALF)).exp()
        point, argument = arb(tau), arb(tau**3 / 9)
        values = constant * third * second, constant * third * root * first, constant * root * root * first * second
        powers = arb(1), point, point * point / 2
        total = arb(0)
        for j, (value, power) in enumerate(zip(values, powers, strict=True)):
            total += value * power * argument.hypgeom([arb((j - beta) / 3)], [arb(b) for b in LOWER[j]])
        return total
