"""The sign of p = C - mu B wherever there is contact in a region: p < 0 everywhere is the Painlevé paradox proper.

Proof page: ``proofs/sign_of_p.md``.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

from flint import arb

from gspot_verified.functions.box_program import BoxProgram
from gspot_verified.mechanisms.zeros.all_zeros import Box, covered, halves
from gspot_verified.numbers.evidence import differ, equal, every, signed
from gspot_verified.numbers.verdict import Evidence

DEFAULT_BUDGET = 2000  # boxes that are looked at: this is an extra where a search found no G-spot

Hypotheses = Callable[[Box], Evidence | str]
"""That the mass matrix is positive definite and mu >= 0 in every state of a box; in words, what is not certain."""


@dataclass(frozen=True)
class SignOfP:
    """p has this sign, 1 or -1, in every state of the region with y = 0, by what ``shown`` compared; and the mass
    matrix is positive definite there and mu >= 0."""

    sign: int
    shown: Evidence = field(compare=False, repr=False)

    def __str__(self) -> str:
        if self.sign < 0:
            return "p < 0 everywhere in contact there: the Painlevé paradox proper"
        return "p > 0 everywhere in contact there: no Painlevé paradox in positive slip"


def sign_of_p(
    program: BoxProgram, sides: Sequence[arb], hypotheses: Hypotheses, budget: int = DEFAULT_BUDGET
) -> SignOfP | None:
    """The sign of the program's first function, p, wherever its others vanish in the box of its variables.

    None: both signs occur, ``hypotheses`` are not certain wherever the others vanish, the budget ended, or nowhere in
    the box the others vanish.

    >>> from gspot_verified.functions.expressions import Variable
    >>> from gspot_verified.numbers.evidence import less
    >>> program = BoxProgram([Variable(0), Variable(0) + Variable(1)], 2)
    >>> print(sign_of_p(program, [arb(0, 3), arb(2, 1)], lambda box: less(0, box[1]) or "no mass"))
    p < 0 everywhere in contact there: the Painlevé paradox proper
    """
    waiting: list[Box] = [tuple(sides)]
    settled: list[Evidence | None] = []
    divided: list[Evidence | None] = []
    sign = 0
    for _ in range(budget):
        if not waiting:
            break
        box = waiting.pop()
        state = [arb(0)] * program.dimension
        for i, side in zip(program.variables, box, strict=True):
            state[i] = side
        p, *others = program.mean_values(state)
        away = next((shown for value in others if (shown := differ(0, value)) is not None), None)
        found = signed(p)
        if away is not None:
            settled.append(away)
        elif found is not None and (found[0] == 0 or found[0] == -sign):
            return None
        elif found is not None and isinstance(supposed := hypotheses(box), Evidence):
            sign = found[0]
            settled.append(every([found[1], supposed]))
        elif box:
            parts = halves(box, widest(box))
            divided.append(covered(parts, box))
            waiting += parts
        else:
            return None
    shown = every([equal(len(settled), len(divided) + 1), *settled, *divided])
    return None if waiting or sign == 0 or shown is None else SignOfP(sign, shown)


def widest(box: Box) -> int:
    """The number of a widest side: which one is divided; any choice is correct."""
    widest = 0
    for i, side in enumerate(box):
        if side.rad() > box[widest].rad():
            widest = i
    return widest
