"""The set of states at one time: a midpoint, and errors in coordinates that turn with the flow (Lohner's method).

Proof page: ``proofs/validated_step.md``, Theorem V4.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from flint import arb, arb_mat

from gspot_verified.integrator.box_steps.choice import turned_basis
from gspot_verified.integrator.box_steps.step import Step
from gspot_verified.numbers.balls import add_remainder


@dataclass(frozen=True, slots=True)
class ErrorSet:
    """The states middle + C r + Q e with r in ``initial`` and e in ``errors``; middle, C, Q are exact.

    r is the deviation of the initial value of the whole run, so its box is carried along without wrapping.
    """

    middle: tuple[arb, ...]
    C: arb_mat
    initial: arb_mat
    Q: arb_mat
    errors: arb_mat

    @classmethod
    def of_box(cls, box: Sequence[arb]) -> ErrorSet:
        """All states of a box."""
        size = len(box)
        middle = tuple(side.mid() for side in box)
        radii = [[add_remainder(arb(0), side.rad())] for side in box]
        return cls(middle, _identity(size), arb_mat(radii), _identity(size), arb_mat(size, 1))

    def deviations(self) -> list[arb]:
        """A box of the deviations from the midpoint."""
        return list((self.C * self.initial + self.Q * self.errors).entries())

    def enclosure(self) -> list[arb]:
        """A box of the states."""
        return [m + deviation for m, deviation in zip(self.middle, self.deviations(), strict=True)]

    def after(self, step: Step) -> ErrorSet | None:
        """The set after a step that was proved for all of it, or None when its coordinates could not be turned."""
        end = step.end()
        middle = tuple(value.mid() for value in end)
        moved = step.flow * self.C
        C = moved.mid()
        turned = step.flow * self.Q
        rest = (moved - C) * self.initial + arb_mat([[a - b] for a, b in zip(end, middle, strict=True)])
        Q = arb_mat(turned_basis(turned.mid().table(), [e.rad() for e in self.errors.entries()]))
        try:
            inverse = Q.inv()
        except ZeroDivisionError:
            return None
        errors = (inverse * turned) * self.errors + inverse * rest
        if not all(value.is_finite() for value in errors.entries()):
            return None
        return ErrorSet(middle, C, self.initial, Q, errors)


def _identity(size: int) -> arb_mat:
    return arb_mat(size, size, [int(i == j) for i in range(size) for j in range(size)])
