"""A mechanism's G-spot over one or two parameters: α_i*, β, Case and side for every value, not only at points.

Proof page: ``proofs/sweep.md``. The spot at one parameter value is proved first and then continued through tubes.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import Executor
from itertools import islice
from pathlib import Path

from flint import arb, fmpq

from gspot_verified.functions.box_program import BoxProgram
from gspot_verified.functions.expressions import Expression, Variable
from gspot_verified.mechanisms.formulas.rewriting import replaced
from gspot_verified.mechanisms.formulas.simplify import rational_value
from gspot_verified.mechanisms.formulas.symbol import Symbol, symbol_names
from gspot_verified.mechanisms.input.mechanism import Mechanism, MechanismError, exact_rational, require_mechanism
from gspot_verified.mechanisms.spots.parametric_system import ParametricSystem, parametric_system
from gspot_verified.mechanisms.sweep.sweep_cell import BITS
from gspot_verified.mechanisms.sweep.sweep_division import Patchwork
from gspot_verified.mechanisms.sweep.sweep_first import first_spot, with_place_of
from gspot_verified.mechanisms.sweep.sweep_fold import Fold, with_folds, without_gaps
from gspot_verified.mechanisms.sweep.sweep_grid import Axis, Grid, Ranges, axes_of, cells
from gspot_verified.mechanisms.sweep.sweep_pieces import SweptPieces
from gspot_verified.mechanisms.sweep.sweep_result import Sweep
from gspot_verified.mechanisms.sweep.sweep_work import Question, open_journal, portions, results
from gspot_verified.numbers.balls import Exact, ExactInput, hull, working_bits
from gspot_verified.work.executors import InProcessExecutor

BUDGET = 500  # pieces that are divided again, where no budget is given
_MAX_DIGITS = 15  # of a bracket: BITS = 80 leave about 24 decimals
_HOLDS: dict[str, Callable[[arb], bool]] = {
    "positive": lambda value: value > 0,
    "negative": lambda value: value < 0,
    "nonnegative": lambda value: value >= 0,
    "nonpositive": lambda value: value <= 0,
    "nonzero": lambda value: not value.contains(0),
}
"""What sympy assumes, as a test of a ball; that a value is an integer holds on no range."""


def sweep(
    mechanism: Mechanism,
    parameters: Ranges,
    *,
    start: Mapping[str, ExactInput] | None = None,
    spot: int | None = None,
    digits: int = 12,
    budget: int = BUDGET,
    executor: Executor | None = None,
    journal: str | Path | None = None,
    progress: Callable[[int, int], None] | None = None,
) -> Sweep:
    """Follow the mechanism's G-spot over a range of one parameter or a rectangle of two.

    ``parameters``: name to "lower..upper", "lower..upper:cells" or (lower, upper, cells); the ends belong to the range.
    Each cell is divided further until Case and side hold for all its parameter values. What stays undecided in it is
    divided again, piece by piece, until it is settled, too small, or ``budget`` pieces have been divided; what is left
    is said, also where the boxes of a cell ended, next to a place at which the spot is lost. ``start``: parameter
    values of the range at which the spot is proved first (the mechanism's own, or the nearest, if left out). ``spot``:
    its number in the list of all G-spots there (left out: that at the mechanism's place). ``digits``: of the brackets
    in which Case or side change. ``journal``: a killed sweep goes on from this file, also with a larger budget; what it
    recalls is proved again. ``executor``: where cells are examined; the result is the same for every one. ``progress``
    is told how many cells and pieces are done, of how many that are known so far.

    :raises GSpotError: there is no G-spot, or a degenerate one, at the start.
    :raises MechanismError: no such parameter, or the mechanism is not complete.
    :raises ValueError: not one or two parameters, an empty range, too many cells, or a budget below 0.

    >>> from gspot_verified import load
    >>> result = sweep(load("oscillator"), {"beta": "9/4..11/4:4"})
    >>> print(result.verdict)
    proved: frictional impact oscillator: Case and side of the continued G-spot for every beta in [9/4, 11/4], except \
in the brackets where one quantity passes zero or the spot vanishes
    >>> result.at(beta="5/2").case, result.at(beta="5/2").lift_off_sign
    ('III', 1)
    """
    require_mechanism(mechanism)
    axes = _axes(mechanism, parameters)
    if type(budget) is not int or budget < 0:
        raise ValueError(f"budget must be an int >= 0, got {budget!r}")
    if type(digits) is not int or not 1 <= digits <= _MAX_DIGITS:
        raise ValueError(f"digits must be an int in 1..{_MAX_DIGITS}")
    place = _start(mechanism, axes, start or {})
    names = [axis.name for axis in axes]
    first = first_spot(mechanism.with_parameters(**dict(zip(names, place, strict=True))), spot)
    mechanism = with_place_of(mechanism, first)
    question = Question(mechanism, Grid(axes), first.fixed, digits)
    with working_bits(BITS):
        point = [_ball(value) for value in first.system.point]
    system = parametric_system(mechanism, names, first.fixed)
    work = portions(cells(question.conditions(), question.grid, place, point))
    workers = executor or InProcessExecutor()
    count = len(question.grid)
    patchwork = Patchwork(question.grid, question.equations(), place, point)
    number = done = 0
    with open_journal(journal, question, place, first.to_json()) as kept:
        for answer in results(question, work, workers, kept):
            with working_bits(BITS):
                patchwork.add_cells(answer.block, answer.groups)
            number += 1
            done += len(answer.block.counts)
            if progress is not None:
                progress(done, count)
        left = budget
        while True:
            with working_bits(BITS):
                waiting = patchwork.divisible()
            if not waiting or left == 0:
                break
            chosen, known = waiting[:left], min(budget, budget - left + len(waiting))
            parts = portions([cell for _, cell in chosen])
            numbers = iter([divided for divided, _ in chosen])
            for answer in results(question, parts, workers, kept, number):
                number += 1
                with working_bits(BITS):
                    patchwork.replace(list(islice(numbers, len(answer.block.counts))), answer.block, answer.groups)
                left -= len(answer.block.counts)
                if progress is not None:
                    progress(count + budget - left, count + known)
    return _assembled(question, system, place, first.to_json(), patchwork, budget if waiting else None)


def _assembled(
    question: Question,
    system: ParametricSystem,
    place: tuple[fmpq, ...],
    spot: Mapping[str, str],
    patchwork: Patchwork,
    ended: int | None,
) -> Sweep:
    """The pieces that hold the continued spot are kept; of the others it is said that they may hold another."""
    own, order, store = patchwork.own(), patchwork.order(), patchwork.store
    store.unsay(number for number in order if not own[number])
    mechanism, folds = question.mechanism, list[Fold]()
    if len(question.grid.axes) == 1:
        with working_bits(BITS):
            order, found = with_folds(system, question.equations(), store, order, own, question.digits)
            folds = [fold.counted_from_zero(mechanism) for fold in found]
        order = without_gaps(store, order)
    return Sweep(
        name=mechanism.name,
        axes=question.grid.axes,
        start=place,
        spot=dict(spot),
        pieces=SweptPieces(store, order),
        folds=tuple(folds),
        notes=mechanism.notes,
        budget=ended,
        fixed=question.fixed,
        given_conditions=bool(mechanism.place.conditions),
    )


def _axes(mechanism: Mechanism, parameters: Ranges) -> tuple[Axis, ...]:
    mechanism.with_parameters(**dict.fromkeys(parameters))
    axes = axes_of(parameters)
    for axis in axes:
        low, high = axis.lower, axis.upper
        for value in (low, high, low + min(fmpq(1), high - low) / 2, max(low, min(high, fmpq(0)))):
            mechanism.with_parameters(**{axis.name: value})  # refused where formulas assume another sign, or an integer
    _check_assumed_between(mechanism, axes)
    return axes


def _check_assumed_between(mechanism: Mechanism, axes: Sequence[Axis]) -> None:
    """What formulas were simplified under holds on the whole range, for parameters that follow those that vary.

    :raises MechanismError: it does not, or not certainly.
    """
    varying = {axis.name: Variable(i) for i, axis in enumerate(axes)}
    free = mechanism.with_parameters(**dict.fromkeys(varying)).parameter_values()
    for name, word in mechanism.assumed:
        value = free.get(name)
        if value is None or name in varying or not symbol_names([value]) & {*varying}:
            continue
        table: dict[Expression, Expression] = {Symbol(each): variable for each, variable in varying.items()}
        with working_bits(BITS):
            box = [hull([arb(axis.lower), arb(axis.upper)]) for axis in axes]
            found = BoxProgram(replaced([value], table), len(axes)).values(box)[0]
        holds = _HOLDS.get(word)
        if holds is None or not holds(found):
            over = ", ".join(f"{axis.name} in [{axis.lower}, {axis.upper}]" for axis in axes)
            raise MechanismError(
                f"{mechanism.name}: sympy's symbol {name} is assumed {word}; its value may not be, for {over}"
            )


def _start(mechanism: Mechanism, axes: Sequence[Axis], given: Mapping[str, ExactInput]) -> tuple[fmpq, ...]:
    """The place at which the spot is proved first."""
    unknown = set(given) - {axis.name for axis in axes}
    if unknown:
        raise ValueError(f"start: {', '.join(sorted(unknown))} does not vary in this sweep")
    own = mechanism.parameter_values()
    place = []
    for axis in axes:
        if axis.name in given:
            value = exact_rational(given[axis.name], axis.name)
            if not axis.lower <= value <= axis.upper:
                raise ValueError(f"start: {axis.name} = {value} lies outside of {axis.lower}..{axis.upper}")
        else:
            stated = rational_value(own[axis.name]) if axis.name in own else None
            value = (axis.lower + axis.upper) / 2 if stated is None else stated
            value = min(max(value, axis.lower), axis.upper)
        place.append(value)
    return tuple(place)


def _ball(value: Exact) -> arb:
    return arb(value)
