"""What conclusions about a mechanism suppose of its states: a positive definite mass matrix, no negative friction.

Proof page: ``proofs/mechanism_hypotheses.md``.
"""

from __future__ import annotations

from collections.abc import Sequence
from copy import copy

from flint import arb, fmpq

from gspot_verified.functions.box_program import BoxProgram
from gspot_verified.functions.periods import period_factor
from gspot_verified.functions.rings import BALLS
from gspot_verified.functions.straight_line import Given
from gspot_verified.mechanisms.derive.mass_matrix import positive_definite
from gspot_verified.mechanisms.derive.to_system import Shifted
from gspot_verified.numbers.evidence import at_most, every
from gspot_verified.numbers.verdict import Evidence

MASS_MATRIX = "the mass matrix is not certainly positive definite on the way"
FRICTION = "the friction coefficient mu may be negative on the way"


class SlipHypotheses:
    """Evaluates them on boxes; where no mass matrix is given, A, B, B, C take its place (paper, Sec. 1.1)."""

    def __init__(self, shifted: Shifted) -> None:
        f = shifted.functions
        self._dimension = len(f.F)
        self._functions = shifted.expressions([*(entry for row in f.inertia for entry in row), f.mu], BALLS)
        self._program = BoxProgram(self._functions, self._dimension)

    def at(self, given: Given) -> SlipHypotheses:
        """The same with numbers in the place of some constants, as :meth:`BoxProgram.at`."""
        other = copy(self)
        other._program = self._program.at(given)
        return other

    @property
    def components(self) -> frozenset[int]:
        """The components of the state on which they depend."""
        return frozenset[int]().union(*self._program.depends)

    def repeats(self, index: int, period: fmpq) -> bool:
        """Whether they certainly have the period 2 pi ``period`` in this component."""
        own = period_factor(self._functions, index)
        return index not in self.components if own is None else bool((period / own).q == 1)

    def checked(self, box: Sequence[arb]) -> Evidence | str:
        """That they hold for every state of the box; or, in words, which one is not certain."""
        *entries, friction = self._program.mean_values(list(box[: self._dimension]))
        definite, pushes = positive_definite(entries), at_most(0, friction)
        if definite is None:
            return MASS_MATRIX
        return every([definite, pushes]) or FRICTION
