"""How much slip a compliant contact loses at most within a time: the force's impulse is what b's motion says it is.

Proof page: ``proofs/chart.md``, section 5.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import reduce

from flint import arb

from gspot_verified.functions.box_program import BoxProgram
from gspot_verified.functions.derivative import lie_derivative
from gspot_verified.functions.rings import BALLS
from gspot_verified.mechanisms.derive.to_system import Shifted
from gspot_verified.numbers.evidence import less

_ZERO = arb(0)  # exact, made once


class SlipLoss:
    """u' = f + g lambda_N and b' = alpha_2 - alpha_3 lambda_N in positive slip, evaluated on boxes."""

    def __init__(self, shifted: Shifted) -> None:
        own = shifted.functions
        size = len(own.F)
        u, b, second, third, *fields = shifted.expressions(
            [own.u, own.b, own.alpha_2, own.alpha_3, *own.F, *own.G], BALLS
        )
        pushes = [lie_derivative(u, field) for field in (fields[:size], fields[size:])]
        self._program = BoxProgram([*pushes, b, second, third], size)

    @property
    def components(self) -> frozenset[int]:
        """The components of the state on which they depend."""
        return frozenset[int]().union(*self._program.depends)

    def largest(self, boxes: Sequence[Sequence[arb]], time: arb) -> arb | None:
        """What u is smaller by than at the beginning, at most, as long as the state is in the boxes, in contact and in
        positive slip, up to this time; None: it is not certain.

        :raises ValueError: there is no box.
        """
        free, pushed, b, second, third = zip(*(self._program.mean_values(list(box)) for box in boxes), strict=True)
        if any(less(one, 0) is None for one in third):
            return None
        gained = _most(b) - _least(b) + time * _most([_ZERO, *(-one for one in second)])
        impulse = gained / -_most(third)
        lost = time * _most([_ZERO, *(-one for one in free)]) + impulse * _most([_ZERO, *(-one for one in pushed)])
        return lost.upper() if lost.is_finite() else None


def _most(values: Sequence[arb]) -> arb:
    return reduce(arb.max, (one.upper() for one in values))


def _least(values: Sequence[arb]) -> arb:
    return reduce(arb.min, (one.lower() for one in values))
