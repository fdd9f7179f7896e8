"""One derivation for many values of some parameters, which stay symbols of the functions."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import cache

from flint import arb

from gspot_verified.functions.straight_line import Given
from gspot_verified.mechanisms.derive.to_system import Preparation, Shifted, shift
from gspot_verified.mechanisms.formulas.simplify import rational_value
from gspot_verified.mechanisms.input.mechanism import Mechanism, MechanismError
from gspot_verified.numbers.balls import nonfinite


def shared_derivation(mechanism: Mechanism, parameters: Sequence[str]) -> Shifted | None:
    """The functions for all values of these parameters; None where they cannot be derived without the values.

    Each has a ball in which nothing is known, so that nothing is said where its number is not put in.
    """
    try:
        free = shift(mechanism.with_parameters(**dict.fromkeys(parameters)), free=True)
    except MechanismError:
        return None
    return replace(free, numbers=tuple((name, _any_number(name)) for name in parameters))


@cache
def _any_number(name: str) -> arb:  # noqa: ARG001
    """One ball for each name, as programs know it by its identity."""
    return nonfinite()


def with_numbers(shared: Shifted, mechanism: Mechanism) -> Shifted:
    """The functions with the values of one mechanism, which differs from the shared one in these parameters alone.

    Its formulas are prepared on their own: where one is not defined for these values, what was derived for others may
    have lost the divisor.

    :raises MechanismError: a division by zero, or a number that grows too large, with these parameters.
    """
    values = mechanism.parameter_values()
    prepare = Preparation(mechanism)
    prepare(mechanism.formulas)
    known = tuple((name, number) for name, _ in shared.numbers if (number := rational_value(values[name])) is not None)
    return replace(shared, mechanism=mechanism, prepare=prepare, numbers=known, shared=shared)


def given_numbers(shifted: Shifted) -> Given:
    """What stands for the balls of the one that is shared; nothing where none is."""
    return {id(_any_number(name)): number for name, number in shifted.numbers}
