"""Boxes of initial states on the contact: two components vary, the others are given or follow from y = v = 0.

Proof pages: ``proofs/fates.md``, section 1; ``proofs/krawczyk.md``.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import permutations

from flint import arb, fmpq

from gspot_verified.functions.box_program import BoxProgram
from gspot_verified.functions.expressions import Expression
from gspot_verified.functions.rings import BALLS
from gspot_verified.functions.straight_line import StraightLine
from gspot_verified.mechanisms.approach.slip_state import StateError, placed_components, solved_components
from gspot_verified.mechanisms.derive.to_system import Shifted
from gspot_verified.numbers.balls import ExactInput, hull


class Starts:
    """The states with ``given`` components, those of ``names`` in a box, and y = v = 0.

    :raises StateError: names that are none or given twice, other than two components left for y = v = 0 or such that
        y = v = 0 may have several solutions in them, a value that is no number, or constraints.
    """

    def __init__(self, shifted: Shifted, given: Mapping[str, ExactInput], names: Sequence[str]) -> None:
        mechanism = shifted.mechanism
        for word in (*given, *names):
            if word not in mechanism.state:
                raise StateError(
                    f"{mechanism.name}: {word[:40]!r} is no component of the state; "
                    f"it has: {', '.join(mechanism.state)}"
                )
        twice = sorted(set(given) & set(names))
        if twice:
            raise StateError(f"{mechanism.name}: {twice[0]} is given and varies, too")
        missing = [word for word in mechanism.state if word not in given and word not in names]
        if len(missing) != 2:
            raise StateError(
                f"{mechanism.name}: leave out two components, those that y = 0 and v = 0 determine; left out: "
                f"{', '.join(missing) or 'none'}"
            )
        if shifted.constraints:
            raise StateError(f"{mechanism.name}: no sweep over the states of a mechanism with constraints")
        self._names = [mechanism.state.index(word) for word in names]
        self._missing = [mechanism.state.index(word) for word in missing]
        # What varies is put to 0 here: an angle is counted from its reference, and its place is what is added.
        self._placed = placed_components(shifted, {**given, **dict.fromkeys(names, 0)}, missing)
        contact = shifted.expressions([shifted.functions.y, shifted.functions.v], BALLS)
        if not _solved_once(contact, self._missing):
            raise StateError(
                f"{mechanism.name}: y = 0 and v = 0 may have several solutions in {' and '.join(missing)}; leave out "
                "components in which they are linear"
            )
        self._program = BoxProgram(contact, len(self._placed))

    def whole(self, lower: Sequence[fmpq], upper: Sequence[fmpq]) -> list[arb] | None:
        """A box of all these states; None where y = v = 0 do not certainly determine the two for every one."""
        box = list(self._placed)
        for place, low, high in zip(self._names, lower, upper, strict=True):
            box[place] = box[place] + hull([arb(low), arb(high)])
        found = solved_components(self._program, box, self._missing)
        return None if found is None else list(found)


def _solved_once(contact: Sequence[Expression], places: Sequence[int]) -> bool:
    """Whether y = v = 0 has at most one solution in two components, if their Jacobian is regular where it has one: y
    holds one of them alone, and is affine in it; v is affine in the other."""
    code = StraightLine()
    height, speed = map(code.value, contact)
    for own, other in permutations(places):
        slopes = code.slope(height, own), code.slope(speed, other)
        pairs = zip(slopes, (own, other), strict=True)
        affine = all(slope is None or i not in code.depends(slope) for slope, i in pairs)
        if affine and other not in code.depends(height):
            return True
    return False
