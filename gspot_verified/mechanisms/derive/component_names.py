"""Which components of a mechanism's state have a name that statements use for something else, and how they are written.

A coordinate may be called y; in a statement y is the gap. Where the component is that function itself, as in the model
system, one name serves both.
"""

from __future__ import annotations

from collections.abc import Iterable

from gspot_verified.functions.expressions import Variable
from gspot_verified.mechanisms.derive.to_system import Shifted

_FUNCTIONS = ("y", "v", "p", "b", "u")
_OTHERS = ("C", "C1", "C_1", "L", "Lambda", "beta", "c", "epsilon", "fast", "g", "k_1", "k_2", "kappa", "l", "lambda_N")
_TIMES = ("s", "t")  # since the start, or since the G-spot: also where the component is a time


def names_of_other_things(shifted: Shifted) -> frozenset[str]:
    """Names of components that are no such function, but are called as it is in statements."""
    state, functions = shifted.mechanism.state, shifted.functions
    used = [name for name in (*_OTHERS, *_TIMES) if name in state]
    return frozenset(used).union(
        name for name in _FUNCTIONS if name in state and getattr(functions, name) is not Variable(state.index(name))
    )


def component(word: str, others: Iterable[str]) -> str:
    """The component's name in a statement.

    >>> component("y", {"y"}), component("theta", {"y"})
    ('the component y', 'theta')
    """
    return f"the component {word}" if word in others else word
