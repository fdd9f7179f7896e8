"""A whole state from the components that a search has found: what follows from them, and what no condition holds.

Proof page: ``proofs/all_g_spots.md``, section 5.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from flint import arb

from gspot_verified.functions.box_program import BoxProgram
from gspot_verified.mechanisms.spots.search_region import Region
from gspot_verified.mechanisms.spots.spot_conditions import TakenApart
from gspot_verified.numbers.balls import nonfinite


class WholeState:
    """``place`` are the values that the mechanism gives for components, by name; ``words`` the names of all."""

    def __init__(self, apart: TakenApart, region: Region, place: Mapping[str, arb], words: Sequence[str]) -> None:
        self._apart, self._region, self._place, self._words = apart, region, place, words
        self._program = BoxProgram([each.value for each in apart.explicit], len(words), ())

    def state(self, values: Mapping[int, arb], free: Mapping[int, arb]) -> list[arb]:
        """The whole state: also the free components, and those that follow from the others."""
        known = {**values, **free}
        state = [known.get(i, arb(0)) for i in range(len(self._words))]
        for each, value in zip(self._apart.explicit, self._program.values(state), strict=True):
            state[each.index] = value
        return state

    def chosen_free(self) -> dict[int, arb]:
        """For each free component one value: that of the mechanism's place, or 0, or the middle of its interval."""
        chosen = {}
        for i in self._apart.free:
            value, side = self._place.get(self._words[i], arb(0)), self._region.given(i)
            chosen[i] = value if side is None or side.contains(value) else side.mid()
        return chosen

    def any_free(self) -> dict[int, arb]:
        """For each free component all of its values: its interval, or no information."""
        sides = {i: self._region.given(i) for i in self._apart.free}
        return {i: nonfinite() if side is None else side for i, side in sides.items()}

    def depends_on_free(self) -> bool:
        """Whether a component with an interval follows from free components."""
        return any(
            self._region.given(each.index) is not None and depends & set(self._apart.free)
            for each, depends in zip(self._apart.explicit, self._program.depends, strict=True)
        )
