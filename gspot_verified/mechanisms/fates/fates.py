"""Where rigid slip ends, for every state of a range of one component or a rectangle of two: certified box by box.

Proof page: ``proofs/fates.md``.
"""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import Executor
from functools import partial
from math import prod
from pathlib import Path

from gspot_verified.mechanisms.approach.slip_state import StateInput
from gspot_verified.mechanisms.fates.fate_piece import OPEN, FatePiece, StartBox, blocks
from gspot_verified.mechanisms.fates.fate_work import FateQuestion, examine, open_journal, proved_again, read_line
from gspot_verified.mechanisms.fates.fates_result import Fates
from gspot_verified.mechanisms.fates.spot_sides import spot_sides
from gspot_verified.mechanisms.input.mechanism import Mechanism, exact_rational, require_mechanism
from gspot_verified.mechanisms.spots.chosen_spot import at_spot
from gspot_verified.mechanisms.sweep.sweep_grid import Grid, Ranges, axes_of
from gspot_verified.numbers.balls import ExactInput
from gspot_verified.work.executors import InProcessExecutor
from gspot_verified.work.kept_portions import kept_results

BUDGET = 0  # open cells that are divided again, where no budget is given
_PORTION = 16  # open cells of one task, and of one line of the journal


def fates(
    mechanism: Mechanism,
    state: StateInput,
    over: Ranges,
    *,
    surface_velocity: ExactInput = 0,
    spot: int | None = None,
    budget: int = BUDGET,
    executor: Executor | None = None,
    journal: str | Path | None = None,
    progress: Callable[[int, int], None] | None = None,
) -> Fates:
    """Where positive slip in contact ends, from every state of a range or a rectangle.

    ``state`` gives the components that do not vary, but for two that y = 0 and v = 0 determine. ``over``: one or two
    components to "lower..upper", "lower..upper:cells" or (lower, upper, cells); the ends belong to the range. An angle
    with a reference is given whole: phi, not phi - phi_ref.
    ``surface_velocity``: slip stops at u = surface_velocity. ``spot``: which of all G-spots the sides are about, by its
    number (left out: that at the mechanism's place).

    Proved of each piece, for every state in it: slip reaches a G-spot, with C_1 < 0 or C_1 > 0 or a sign that is open;
    or it lifts off, or slip stops, first; or at the start slip is not positive, the contact opens at once, or p < 0
    (nothing more is said there). The rest is undecided.
    Blocks of cells are divided until they have one fate or are cells; ``budget`` open cells (and parts) are divided
    again. ``journal``, ``executor``, ``progress``: as for :func:`sweep`.

    :raises StateError: names that are none, or not two components left for y = 0 and v = 0.
    :raises GSpotError: there is no G-spot at the mechanism's place.
    :raises MechanismError: the mechanism is not complete.
    :raises ValueError: not one or two components, an empty range, too many cells, or a budget below 0.

    >>> from gspot_verified import load
    >>> result = fates(load("model system"), {"x": 0, "u": 3, "p": "1/2"}, {"b": "-5/2..-3/2:2"})
    >>> [piece.fate.value for piece in result.pieces]
    ['spot, C1 < 0']
    """
    require_mechanism(mechanism)
    axes = axes_of(over)
    if type(budget) is not int or budget < 0:
        raise ValueError(f"budget must be an int >= 0, got {budget!r}")
    given = tuple((word, _text(word, value)) for word, value in state.items())
    velocity = exact_rational(surface_velocity, "surface_velocity")
    question = FateQuestion(at_spot(mechanism, spot), given, Grid(axes), velocity)
    question.check()
    sides = spot_sides(question.mechanism)
    workers = executor or InProcessExecutor()
    first, again = partial(examine, question), partial(proved_again, question)
    count, done = len(question.grid), 0
    pieces: list[FatePiece] = []
    with open_journal(journal, question) as kept:
        work = [[block] for block in blocks(question.grid)]
        for (block,), answer in zip(work, kept_results(work, workers, kept, first, again, read_line), strict=True):
            pieces += answer.pieces
            done += prod(block.cells)
            if progress is not None:
                progress(done, count)
        number, left = len(work), budget
        while left and (waiting := [k for k, piece in enumerate(pieces) if piece.fate in OPEN]):
            chosen = waiting[:left]
            groups = [chosen[i : i + _PORTION] for i in range(0, len(chosen), _PORTION)]
            work = [[half for k in group for half in _halves(question, pieces[k])] for group in groups]
            parts: dict[int, list[FatePiece]] = {}
            answers = kept_results(work, workers, kept, first, again, read_line, number)
            for group, answer in zip(groups, answers, strict=True):
                parts |= {k: answer.pieces[2 * i : 2 * i + 2] for i, k in enumerate(group)}
                left -= len(group)
                if progress is not None:
                    progress(count + budget - left, count + budget)
            pieces = [part for k, piece in enumerate(pieces) for part in parts.get(k, [piece])]
            number += len(work)
    return Fates(
        name=mechanism.name,
        axes=axes,
        state=given,
        surface_velocity=velocity,
        sides=sides,
        pieces=tuple(pieces),
        notes=mechanism.notes,
    )


def _text(word: str, value: ExactInput) -> str:
    return value if isinstance(value, str) else str(exact_rational(value, word))


def _halves(question: FateQuestion, piece: FatePiece) -> tuple[StartBox, StartBox]:
    return StartBox(piece.lower, piece.upper, (1,) * len(piece.lower)).halves(question.sides)
