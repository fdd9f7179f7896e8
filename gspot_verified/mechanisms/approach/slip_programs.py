"""What following slip needs of one mechanism at one precision, compiled once: rows of a table share it."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property, lru_cache

from gspot_verified.functions.straight_line import Given
from gspot_verified.integrator.field.field import VectorField
from gspot_verified.mechanisms.approach.slip_flow import SlipFlow, SlipNumbers
from gspot_verified.mechanisms.derive.component_names import names_of_other_things
from gspot_verified.mechanisms.derive.shared_derivation import given_numbers
from gspot_verified.mechanisms.derive.slip_hypotheses import SlipHypotheses
from gspot_verified.mechanisms.derive.to_system import Shifted
from gspot_verified.numbers.balls import current_bits

_KEPT = 8  # mechanisms and precisions


@dataclass(frozen=True)
class SlipPrograms:
    """The flow, its values on boxes, the hypotheses, and components that are called like something else; nothing of any
    state."""

    flow: SlipFlow
    numbers: SlipNumbers
    hypotheses: SlipHypotheses
    other_names: frozenset[str]

    def at(self, given: Given) -> SlipPrograms:
        """The same with numbers in the place of some constants, as :meth:`BoxProgram.at`; not so in the flow."""
        if not given:
            return self
        other = replace(self, numbers=self.numbers.at(given), hypotheses=self.hypotheses.at(given))
        vars(other).update(desingularised=self.desingularised.at(given), by_p=self.by_p.at(given))
        return other

    @cached_property
    def desingularised(self) -> VectorField:
        """:meth:`SlipFlow.desingularised`."""
        return self.flow.desingularised()

    @cached_property
    def by_p(self) -> VectorField:
        """:meth:`SlipFlow.by_p`."""
        return self.flow.by_p()


def slip_programs(shifted: Shifted) -> SlipPrograms:
    """The programs of a mechanism; constants that are balls have the precision in force, so each precision has its own.

    >>> from gspot_verified.mechanisms.derive.to_system import shift
    >>> from gspot_verified.mechanisms.shipped import shipped_mechanism
    >>> from gspot_verified.numbers.balls import working_bits
    >>> model = shift(shipped_mechanism("model system"))
    >>> with working_bits(100):
    ...     first = slip_programs(model)
    ...     slip_programs(model) is first
    True
    """
    return _at_precision(shifted.shared or shifted, current_bits()).at(given_numbers(shifted))


@lru_cache(_KEPT)
def _at_precision(shifted: Shifted, bits: int) -> SlipPrograms:  # noqa: ARG001
    flow = SlipFlow.of(shifted)
    return SlipPrograms(flow, SlipNumbers(flow), SlipHypotheses(shifted), names_of_other_things(shifted))
