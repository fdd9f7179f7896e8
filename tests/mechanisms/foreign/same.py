"""Whether two mechanisms are the same: all that is derived of them, at states."""

from __future__ import annotations

from collections.abc import Sequence

from flint import arb, fmpq

from gspot_verified.functions.box_program import BoxProgram
from gspot_verified.functions.rings import BALLS
from gspot_verified.mechanisms.derive.to_system import shift
from gspot_verified.mechanisms.input.mechanism import Mechanism
from gspot_verified.numbers.balls import working_bits

SCALARS = ("y", "u", "v", "a", "b", "A", "B", "C", "p", "alpha_1", "alpha_2", "alpha_3", "mu")


def derived_values(mechanism: Mechanism, states: Sequence[Sequence[fmpq]]) -> list[arb]:
    """F, G_N, G_T and the functions of Sec. 2 at the states, one after the other, to some 50 digits."""
    shifted = shift(mechanism)
    f = shifted.functions
    functions = [*f.F, *f.G_N, *f.G_T, *(getattr(f, name) for name in SCALARS)]
    program = BoxProgram(shifted.expressions(functions, BALLS), len(mechanism.state))
    return [value for state in states for value in program.values([arb(number) for number in state])]


def same(first: Mechanism, second: Mechanism) -> bool:
    """Whether they agree at two states to 1e-40; the names of the states may differ."""
    size = len(first.state)
    assert size == len(second.state)
    states = [[fmpq((3 + 5 * turn + 7 * i) % 11 + 1, 9 + turn) for i in range(size)] for turn in range(2)]
    with working_bits(200):
        one, other = derived_values(first, states), derived_values(second, states)
        assert all(value.is_finite() for value in (*one, *other))
        return all(abs(a - b) < arb("1e-40") * (1 + abs(a)) for a, b in zip(one, other, strict=True))
