"""What heuristics chose for one step, as text: nothing that is proved, so that a stored choice is proved again.

Any choice is correct (``proofs/norm_step.md``): a choice that somebody changed can cost a run its narrowness or its
step, not its truth.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

from flint import arb, arb_mat, arb_poly

from gspot_verified.integrator.norm_steps.fast_decay import DecayState
from gspot_verified.integrator.norm_steps.norm_step import Basis, NormPlan

_LARGEST_EXPONENT = 10**6  # of a number in a journal, which may hold anything
_LARGEST_TEXT = 10**5  # digits of its mantissa, likewise


@dataclass(frozen=True, slots=True)
class ChosenStep:
    """``h``: the length, None where it is all the time that is left; ``length`` and ``decay``: what the choice of the
    following step starts from.
    """

    solution: tuple[arb_poly, ...]
    h: arb | None
    plan: NormPlan
    length: float
    decay: DecayState

    def to_json(self) -> dict[str, Any]:
        """Exact numbers as [mantissa in hexadecimal digits, exponent of 2]; floats as Python writes them."""
        return {
            "solution": [_written(p.coeffs()) for p in self.solution],
            "h": None if self.h is None else _written([self.h]),
            "ends": _written(self.plan.ends),
            "bases": [[list(basis.blocks), _written(basis.S.entries())] for basis in self.plan.bases],
            "margins": _written(self.plan.margins),
            "series": [self.plan.disc, self.plan.length],
            "length": self.length,
            "decay": self.decay.to_json(),
        }

    @classmethod
    def from_json(cls, data: Any) -> ChosenStep:
        """The choice that was written.

        :raises ValueError: it is not of this form; that it is a good choice is not checked.
        """
        try:
            return cls._read(data)
        except (TypeError, KeyError, IndexError, AttributeError, OverflowError) as error:
            raise ValueError(f"not a step: {error}") from None

    @classmethod
    def _read(cls, data: Any) -> ChosenStep:
        solution = tuple(arb_poly(_read(values)) for values in data["solution"])
        size = len(solution)
        bases = []
        for blocks, entries in data["bases"]:
            numbers = _read(entries)
            if not (all(type(b) is int and b > 0 for b in blocks) and sum(blocks) == size and len(numbers) == size**2):
                raise ValueError("a basis of another size")
            bases.append(Basis(arb_mat(size, size, numbers), tuple(blocks)))
        ends, margins = tuple(_read(data["ends"])), tuple(_read(data["margins"]))
        covers = bool(ends) and ends[0] == 0 and ends[-1] == 1 and all(a < b for a, b in pairwise(ends))
        if not (covers and len(ends) == len(bases) + 1 == len(margins) + 1):
            raise ValueError("the pieces do not fill the step")
        disc, series = data["series"]
        if not (type(disc) is type(series) is int and 2 <= disc <= 2**10 and 1 <= series <= 10**5):
            raise ValueError("a disc or a length out of range")
        h = None if data["h"] is None else _read(data["h"])[0]
        length = data["length"]
        if not (type(length) is float and 0 < length < math.inf):
            raise ValueError("a length out of range")
        plan = NormPlan(ends, tuple(bases), margins, disc, series)
        return cls(solution, h, plan, length, DecayState.from_json(data["decay"]))


class Steps:
    """Where the steps of a run come from and go to: here none is known beforehand and none is kept.

    ``budget``: how many may be made in all; ``left``: from here on.
    """

    def __init__(self, budget: int) -> None:
        self.budget = self.left = budget

    def known(self) -> ChosenStep | None:
        """What was chosen for the next step in a run before this one; None: nothing is known from here on."""
        return None

    def proved(self, step: ChosenStep, time: arb) -> None:  # noqa: ARG002
        """One more step was proved, to this time of the phase."""
        self.left -= 1


def _written(values: Sequence[arb]) -> list[list[Any]]:
    written = []
    for value in values:
        mantissa, exponent = value.mid().man_exp()
        written.append([format(int(mantissa), "x"), int(exponent)])
    return written


def _read(values: Any) -> list[arb]:
    """Exact numbers.

    :raises ValueError: an entry is no number, or one of a hostile size.
    """
    numbers = []
    for digits, exponent in values:
        if type(exponent) is not int or abs(exponent) > _LARGEST_EXPONENT or len(digits) > _LARGEST_TEXT:
            raise ValueError("a number out of range")
        numbers.append(arb((int(digits, 16), exponent)))
    return numbers
