"""The conditions of a G-spot, taken apart: what can be solved for explicitly, and in which order the rest is solved.

Proof page: ``proofs/all_g_spots.md``, sections 1 and 2. Which component is solved for, and the order, are free choices.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations

from flint import fmpq

from gspot_verified.functions.derivative import substitute, times
from gspot_verified.functions.expressions import Constant, Expression, Variable
from gspot_verified.functions.straight_line import StraightLine


@dataclass(frozen=True)
class Explicit:
    """One component of the state as a function of others, by one of the conditions."""

    index: int
    condition: str
    value: Expression


@dataclass(frozen=True)
class Stage:
    """Conditions that hold no unknowns but these, once the stages before are solved."""

    conditions: tuple[str, ...]
    variables: tuple[int, ...]

    @property
    def dimension(self) -> int:
        """How many more unknowns than conditions there are: 0 for isolated solutions."""
        return len(self.variables) - len(self.conditions)


@dataclass(frozen=True)
class TakenApart:
    """The conditions after components were solved for.

    ``functions`` are the remaining conditions by name, ``explicit`` the components that are functions of others,
    ``stages`` the order of solution, ``free`` the components that no remaining condition holds.
    """

    functions: Mapping[str, Expression]
    explicit: tuple[Explicit, ...]
    stages: tuple[Stage, ...]
    free: tuple[int, ...]


def take_apart(conditions: Mapping[str, Expression], dimension: int, kept: Sequence[int] = ()) -> TakenApart:
    """Solve for what the conditions give explicitly, and order the rest.

    ``kept`` are components that are solved for only where there is no other choice.
    """
    remaining = dict(conditions)
    explicit: list[Explicit] = []
    while (affine := _affine(remaining, dimension, kept)) is not None:
        explicit = [Explicit(old.index, old.condition, _with(old.value, affine, dimension)) for old in explicit]
        explicit.append(affine)
        del remaining[affine.condition]
        remaining = {name: _with(function, affine, dimension) for name, function in remaining.items()}
    unknowns = {name: components_of(function) for name, function in remaining.items()}
    solved = {each.index for each in explicit}
    used = frozenset[int]().union(*unknowns.values())
    free = tuple(i for i in range(dimension) if i not in solved and i not in used)
    return TakenApart(remaining, tuple(explicit), _stages(unknowns), free)


def _affine(remaining: Mapping[str, Expression], dimension: int, kept: Sequence[int]) -> Explicit | None:
    """A condition k xi_i + g = 0, with a rational k that is not 0 and a g without xi_i: xi_i = -g/k."""
    # p and b are left for the search: solved for a component, they would hide the bounds on it from the search.
    order = [*(i for i in reversed(range(dimension)) if i not in kept), *reversed(kept)]
    for name in (name for name in reversed(list(remaining)) if name not in ("p", "b")):
        code = StraightLine()
        root = code.value(remaining[name])
        for i in order:
            slope = code.slope(root, i)
            number = None if slope is None else code.number(slope)
            if number is not None and number != 0:
                rest = _replaced(remaining[name], i, Constant(fmpq(0)), dimension)
                return Explicit(i, name, times(Constant(-1 / number), rest))
    return None


def _with(function: Expression, explicit: Explicit, dimension: int) -> Expression:
    return _replaced(function, explicit.index, explicit.value, dimension)


def _replaced(function: Expression, index: int, value: Expression, dimension: int) -> Expression:
    return substitute(function, [value if i == index else Variable(i) for i in range(dimension)])


def components_of(function: Expression) -> frozenset[int]:
    """The components of the state on which a function depends, or may depend: cancellations are not seen."""
    code = StraightLine()
    return code.depends(code.value(function))


def _stages(depends: Mapping[str, frozenset[int]]) -> tuple[Stage, ...]:
    """Again and again the fewest conditions that hold no more unknowns than they are; at last what is left."""
    open_names, known = list(depends), frozenset[int]()
    stages: list[Stage] = []
    while open_names:
        names = _closed(open_names, depends, known) or tuple(open_names)
        variables = frozenset[int]().union(*(depends[name] for name in names)) - known
        stages.append(Stage(names, tuple(sorted(variables))))
        known |= variables
        open_names = [name for name in open_names if name not in names]
    return tuple(stages)


def _closed(
    names: Sequence[str], depends: Mapping[str, frozenset[int]], known: frozenset[int]
) -> tuple[str, ...] | None:
    for size in range(1, len(names) + 1):
        for chosen in combinations(names, size):
            if len(frozenset[int]().union(*(depends[name] for name in chosen)) - known) <= size:
                return chosen
    return None
