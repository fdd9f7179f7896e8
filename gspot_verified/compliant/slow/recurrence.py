"""The recurrence in b that leads from integrals with b < 0 up to every b.

Proof page: ``proofs/exact_solution.md``, section 3.
"""

from __future__ import annotations

from collections.abc import Sequence

from flint import arb

from gspot_verified.numbers.balls import Exact


def climbed(lowest: Sequence[arb], b: Exact, steps: int, tau: arb, eta: arb) -> list[arb]:
    """G_b, G_(b-1), G_(b-2), G_(b-3) from G_(b-n), ..., G_(b-n-3), n = ``steps``, by

    G_c = -tau G_(c-1) + (c-1)(c-2) G_(c-3) + eta (c-1) [tau G_(c-2) + G_(c-1) - (c-2)(c-3)/2 G_(c-4)].
    """
    first, second, third, fourth = lowest
    for k in range(steps - 1, -1, -1):
        c = b - k
        following = (
            (eta * (c - 1) - tau) * first
            + eta * (c - 1) * tau * second
            + (c - 1) * (c - 2) * (third - eta * (c - 3) / 2 * fourth)
        )
        first, second, third, fourth = following, first, second, third
    return [first, second, third, fourth]
