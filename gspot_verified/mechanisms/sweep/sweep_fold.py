"""A fold: where the continued spot meets another one and vanishes as the parameter passes a value.

Proof page: ``proofs/sweep.md``, section 6. A component of the state takes the parameter's part: along the curve of
spots the parameter is a function of it, whose derivative passes zero once. On a line a fold is sought where the
continued spot's tubes end inside the range.
"""

from __future__ import annotations

from array import array
from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import groupby
from typing import ClassVar

from flint import arb, fmpq

from gspot_verified.functions.box_program import BoxProgram
from gspot_verified.functions.derivative import ONE, ZERO, lie_derivative, substitute
from gspot_verified.functions.expressions import Expression, Variable
from gspot_verified.functions.krawczyk import strictly_inside
from gspot_verified.mechanisms.derive.to_system import counted_from_zero
from gspot_verified.mechanisms.input.mechanism import Mechanism
from gspot_verified.mechanisms.spots.parametric_system import ParametricSystem
from gspot_verified.mechanisms.sweep.sweep_bracket import bracket
from gspot_verified.mechanisms.sweep.sweep_piece import Kind, SweepPiece
from gspot_verified.mechanisms.sweep.sweep_pieces import PieceStore, packed
from gspot_verified.mechanisms.sweep.sweep_start import Origin, proved_tube
from gspot_verified.mechanisms.zeros.tube import Equations, OnTube, Tube, try_tube
from gspot_verified.numbers.balls import approximate, ball_text, hull, working_bits
from gspot_verified.numbers.dyadic import Dyadic
from gspot_verified.numbers.verdict import NoTruthValue
from gspot_verified.numbers.written import Written

_STEPS = 12  # of Newton's method: a limit of effort
_REACH_BITS = 30  # of how far the other spot was followed: any number is correct, it is rounded towards the fold


@dataclass(frozen=True, slots=True)
class Fold(NoTruthValue, Written):
    """Exactly one fold: at one value of the parameter in ``value``, the continued spot meets another one.

    ``opens`` = 1: both are there for larger values up to ``reach``, as far as both were followed, none of the two for
    smaller ones; -1: the other way round. ``point`` encloses the state at the fold; in the result of a sweep angles are
    counted from 0.
    """

    ask: ClassVar[str] = ".value encloses the parameter at the fold"

    parameter: str
    value: Dyadic
    opens: int
    reach: fmpq
    point: tuple[tuple[str, Dyadic], ...]

    def bounds(self) -> tuple[fmpq, fmpq]:
        """The ends of ``value``."""
        lower, upper = self.value.endpoints()
        return fmpq(lower.numerator, lower.denominator), fmpq(upper.numerator, upper.denominator)

    def counted_from_zero(self, mechanism: Mechanism) -> Fold:
        """The same fold with the reference angles added to ``point``."""
        state = counted_from_zero(mechanism, [value.to_ball() for _, value in self.point])
        return replace(self, point=tuple(zip(mechanism.state, map(Dyadic.from_ball, state), strict=True)))

    def __str__(self) -> str:
        side = "larger" if self.opens > 0 else "smaller"
        point = ", ".join(f"{word} = {_text(value)}" for word, value in self.point)
        return (
            f"fold at {self.parameter} = {_text(self.value)}: the continued spot meets another one there and both "
            f"vanish; they are there for {side} {self.parameter}, as far as {self.reach}; {point}"
        )


def fold_next_to(system: ParametricSystem, equations: Equations, tube: Tube, end: fmpq, digits: int) -> Fold | None:
    """The fold of the curve of spots behind the end of the last tube on a line, or None where none was proved."""
    at = proved_tube(equations, (end,), (end,), _at_end(tube, end))
    if at is None or not tube.holds_at((end,), at.tube.zero_at((end,))):
        return None
    zero = at.tube.zero_at((end,))
    speeds = [slope[0] + turn[0] for slope, turn in zip(at.tube.slopes, at.turning, strict=True)]
    if not all(speed.is_finite() for speed in speeds):
        return None
    along = max(range(len(zero)), key=lambda i: abs(approximate(speeds[i])) / (1 + abs(approximate(zero[i]))))
    if not (speeds[along] > 0 or speeds[along] < 0):
        return None
    others = [i for i in range(len(zero)) if i != along]
    tangent = [speeds[i] / speeds[along] for i in others] + [1 / speeds[along]]
    known = [*(zero[i] for i in others), arb(end), *tangent]
    curve = turned(system, along)
    arc = _arc(curve, known, zero[along])
    if arc is None or not _on_curve(arc.tube, zero[along], known):
        return None
    cut = bracket(curve, arc, lambda on: on.quantities[0], digits)
    if cut is None or cut.ends is None or cut.before != -cut.direction or cut.after != cut.direction:
        return None
    short = proved_tube(curve, (cut.ends[0],), (cut.ends[1],), Origin.of(arc))
    if short is None or not _same_curve(arc.tube, short.tube):
        return None
    far = _other_end(curve, arc, zero[along], cut.ends)
    fold = _fold(system, short, along, cut.direction, end)
    if far is None or not _has_formulas(system, fold):
        return None
    return _as_far_as_both(fold, far[len(others)])


def turned(system: ParametricSystem, along: int) -> Equations:
    """The curve of zeros with the component ``along`` as its parameter, and its tangent.

    Unknowns: the other components, λ, and their derivatives by that component. Further function: dλ/ds.
    """
    m = system.dimension
    names: list[Expression] = []
    position = 0
    for i in range(m):
        names.append(Variable(2 * m if i == along else position))
        position += i != along
    names.append(Variable(m - 1))
    field: list[Expression] = [*(Variable(m + i) for i in range(m)), *[ZERO] * m, ONE]
    conditions = [substitute(condition, names) for condition in system.conditions]
    tangent = [lie_derivative(condition, field) for condition in conditions]
    return Equations(BoxProgram([*conditions, *tangent, Variable(2 * m - 1)], 2 * m + 1), 2 * m)


def _at_end(tube: Tube, end: fmpq) -> Origin:
    """The place to look from, at the end of a tube."""
    return Origin(
        (end,), tuple(map(_rational, tube.zero_at((end,)))), tuple(tuple(map(_rational, row)) for row in tube.slopes)
    )


def _arc(curve: Equations, known: list[arb], start: arb) -> OnTube | None:
    """A tube around a part of the curve that reaches from before ``start`` to as far behind the fold."""
    slopes = tuple((fmpq(0),) for _ in known)
    place = _rational(start)
    origin = Origin((place,), tuple(map(_rational, known)), slopes)
    for _ in range(_STEPS):
        at = proved_tube(curve, (place,), (place,), origin)
        if at is None:
            return None
        own = at.quantities[0]
        step = (at.value(own) / at.slopes(own)[0]).mid()
        if not step.is_finite():
            return None
        origin, moved = Origin.of(at), place - _rational(step)
        done = abs(moved - place) <= fmpq(1, 2**40) * (abs(place - _rational(start)) + fmpq(1, 2**40))
        place = moved
        if done:
            break
    reach = abs(_rational(start) - place) * fmpq(5, 4) + fmpq(1, 2**30)
    on = proved_tube(curve, (place - reach,), (place + reach,), origin)
    return None if on is None else _widened(curve, on)


def _widened(curve: Equations, on: OnTube) -> OnTube:
    """The same tube with wider sides where that can be proved: what is known of the spot must fit in."""
    tube = on.tube
    least = fmpq(1, 2**32)
    sides = [arb(0, (2 * side.rad() + arb(least) * (1 + abs(start))).upper()) for side, start in
             zip(tube.within, tube.centre, strict=True)]  # fmt: skip
    wider = try_tube(curve, tube.lower, tube.upper, tube.centre, tube.slopes, sides)
    return on if wider is None or wider.proved is None else wider.proved


def _on_curve(tube: Tube, value: arb, known: list[arb]) -> bool:
    """Whether a zero with the component ``value`` and all else in ``known`` certainly lies in the tube's interior."""
    (lower,), (upper,) = tube.lower, tube.upper
    if not (value > arb(lower) and value < arb(upper)):
        return False
    line = tube.line([value - arb((lower + upper) / 2)])
    return all(strictly_inside(own - start, width) for own, start, width in zip(known, line, tube.within, strict=True))


def _same_curve(tube: Tube, part: Tube) -> bool:
    middle = ((part.lower[0] + part.upper[0]) / 2,)
    return tube.holds_at(middle, part.zero_at(middle))


def _other_end(curve: Equations, arc: OnTube, start: arb, ends: tuple[fmpq, fmpq]) -> list[arb] | None:
    """The curve where the tube ends on the other side of the fold, which lies between ``ends``."""
    tube = arc.tube
    if not (start < arb(ends[0]) or start > arb(ends[1])):
        return None
    place = tube.upper if start < arb(ends[0]) else tube.lower
    at = proved_tube(curve, place, place, Origin.of(arc))
    if at is None or not tube.holds_at(place, at.tube.zero_at(place)):
        return None
    return at.tube.zero_at(place)


def _has_formulas(system: ParametricSystem, fold: Fold) -> bool:
    """Whether all formulas of the parameter have values from the fold as far as the continued spot was followed."""
    values = hull([fold.value.to_ball(), arb(fold.reach)])
    state = [arb(0)] * system.dimension
    return BoxProgram([system.domain], system.dimension + 1).values([*state, values])[0].is_finite()


def _as_far_as_both(fold: Fold, other: arb) -> Fold | None:
    """The fold with a reach to which the other spot was followed, too: as far as the parameter is ``other``."""
    low, high = fold.bounds()
    with working_bits(_REACH_BITS):
        bound = _rational(other.lower() if fold.opens > 0 else other.upper())
    reach = min(fold.reach, bound) if fold.opens > 0 else max(fold.reach, bound)
    return replace(fold, reach=reach) if (high < reach if fold.opens > 0 else reach < low) else None


def _fold(system: ParametricSystem, short: OnTube, along: int, direction: int, end: fmpq) -> Fold:
    """The fold from a tube over the bracket of the component ``along``."""
    m = system.dimension
    (lower,), (upper,) = short.tube.lower, short.tube.upper
    moves = [arb(0, arb((upper - lower) / 2).upper())]
    enclosure = [line + rest for line, rest in zip(short.tube.line(moves), short.tube.found, strict=True)]
    state = enclosure[: m - 1]
    state.insert(along, arb((lower + upper) / 2) + moves[0])
    point = tuple(zip(system.state, map(Dyadic.from_ball, state), strict=True))
    return Fold(system.parameters[0], Dyadic.from_ball(enclosure[m - 1]), direction, end, point)


def with_folds(
    system: ParametricSystem,
    equations: Equations,
    store: PieceStore,
    order: Sequence[int],
    own: Sequence[bool],
    digits: int,
) -> tuple[Sequence[int], list[Fold]]:
    """The pieces of a line in their order, those behind a fold said to be so, and the folds.

    ``own``: of each piece, by its number, whether it holds the continued spot; those are neighbours.
    """
    mine = [place for place, number in enumerate(order) if own[number]]
    if not mine:
        return order, []
    first, last = mine[0], mine[-1]
    folds, before, after = [], order[:first], order[last + 1 :]
    if before:
        fold = _behind(system, equations, store[order[first]], store.box(order[first])[0][0], digits)
        if fold is not None and fold.opens == 1:
            folds.append(fold)
            before = _vanished(store, before, fold)
    if after:
        fold = _behind(system, equations, store[order[last]], store.box(order[last])[1][0], digits)
        if fold is not None and fold.opens == -1:
            folds.append(fold)
            after = _vanished(store, after, fold)
    return array("I", (*before, *order[first : last + 1], *after)) if folds else order, folds


def _behind(system: ParametricSystem, equations: Equations, piece: SweepPiece, end: fmpq, digits: int) -> Fold | None:
    tube = piece.tube()
    return None if tube is None else fold_next_to(system, equations, tube, end, digits)


def _vanished(store: PieceStore, numbers: Sequence[int], fold: Fold) -> Sequence[int]:
    """The range between the continued spot's last piece and the end of the line: up to the fold, and behind it."""
    lower, upper = store.box(numbers[0])[0], store.box(numbers[-1])[1]
    turn = (fold.bounds()[0 if fold.opens > 0 else 1],)
    if not lower < turn < upper:
        return store.add(packed([[SweepPiece(lower, upper, Kind.FOLD)]]))
    kinds = (Kind.BEYOND, Kind.FOLD) if fold.opens > 0 else (Kind.FOLD, Kind.BEYOND)
    ends = zip((lower, turn), (turn, upper), kinds, strict=True)
    return store.add(packed([[SweepPiece(*piece) for piece in ends]]))


def without_gaps(store: PieceStore, order: Sequence[int]) -> Sequence[int]:
    """On a line: neighbours without a tube are one piece."""
    without = [what.kind is Kind.NO_TUBE for what in store.said]
    joined = array("I")
    for gap, run in groupby(order, key=lambda number: without[store.codes[number]]):
        numbers = list(run)
        if gap and len(numbers) > 1:
            lower, upper = store.box(numbers[0])[0], store.box(numbers[-1])[1]
            unsure = max(store.what(number).unsure for number in numbers)
            numbers = list(store.add(packed([[SweepPiece(lower, upper, Kind.NO_TUBE, unsure=unsure)]])))
        joined.extend(numbers)
    return joined


def _text(value: Dyadic) -> str:
    return ball_text(value.to_ball())


def _rational(value: arb) -> fmpq:
    mantissa, exponent = value.mid().man_exp()
    return fmpq(mantissa) * fmpq(2) ** int(exponent)
