"""The Taylor coefficients of a solution at a point, from the first three: for numbers, and for functions of beta.

Proof pages: ``proofs/carried_series.md``, section 2; ``proofs/local_series.md``, L1.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TypeVar

from flint import arb, arb_poly

Coefficient = TypeVar("Coefficient", arb, arb_poly)


def continued(
    start: Sequence[Coefficient],
    factors: Sequence[Coefficient],
    middle: arb,
    settled: Callable[[Coefficient], Coefficient] | None = None,
) -> list[Coefficient]:
    """a_0, a_1, ... with a_(k+3) = factors[k] a_k + middle a_(k+1)/((k+2)(k+3)), ``start`` being a_0, a_1 and a_2.

    For F(point + s u) = sum a_k u^k and F''' = tau F' - beta F: factors[k] = s^3 (k - beta)/((k+1)(k+2)(k+3)) and
    middle = s^2 point. ``settled`` is applied to each coefficient as it comes: it may only widen.
    """
    zero, one, two = start
    coefficients = [zero, one, two]
    for k, factor in enumerate(factors):
        following = zero * factor + one * (middle / ((k + 2) * (k + 3)))
        zero, one, two = one, two, following if settled is None else settled(following)
        coefficients.append(two)
    return coefficients
