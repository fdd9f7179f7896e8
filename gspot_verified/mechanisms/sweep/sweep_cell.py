"""One cell of a sweep: subdivided until Case and side hold on each piece, or a budget ends.

Which tubes are tried and where a cell is cut are free choices. What a piece says comes from :func:`try_tube` and
:func:`findings` on that piece, and from monotone quantities: ``proofs/sweep.md``, sections 1 to 5.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import partial

from flint import fmpq

from gspot_verified.mechanisms.sweep.sweep_bracket import Cut, bracket
from gspot_verified.mechanisms.sweep.sweep_findings import HYPOTHESES, SEVERAL, TOO_LARGE, findings, quantity
from gspot_verified.mechanisms.sweep.sweep_piece import ENDED, Kind, Passing, SweepPiece
from gspot_verified.mechanisms.sweep.sweep_start import Origin, proved_tube
from gspot_verified.mechanisms.sweep.sweep_trace import Choice, TubeTrace
from gspot_verified.mechanisms.zeros.tube import Equations, OnTube, Tube
from gspot_verified.numbers.balls import approximate, sign_of, working_bits

BITS = 80  # working precision: any is correct, 53 would be too few for brackets of 15 digits
BOXES = 128  # of one cell: a limit against endless work
BOXES_BEYOND = 256  # divided in a cell of a line once these are used up, where no tube is found: folds took up to 92
_DEPTH_OF_A_LINE, _DEPTH_OF_A_MAP, _DEPTH_OF_A_TUBE = 24, 4, 8  # halvings of a cell: limits of effort
_HOPELESS_FROM = 3  # halvings of a cell: any number is correct
_TINY = 2.0**-40  # of a quantity at a centre, which is next to the spot; any number is correct
_FAR_STEEPER = 8  # times: then only this side is halved; any factor is correct
_NOT_A_BOUNDARY = (*HYPOTHESES, TOO_LARGE, SEVERAL)

Box = tuple[tuple[fmpq, ...], tuple[fmpq, ...]]


@dataclass(frozen=True, slots=True)
class Known:
    """Signs of some quantities at the zeros of a tube over a larger box; empty where there is no tube."""

    tube: Tube | None = None
    signs: Mapping[str, int] = field(default_factory=dict)

    def concerns(self, tube: Tube) -> bool:
        """Whether the zeros of a tube over a part of the box are those of the larger tube: at one place, so at all."""
        if self.tube is None:
            return True
        middle = [(low + high) / 2 for low, high in zip(tube.lower, tube.upper, strict=True)]
        return self.tube.holds_at(middle, tube.zero_at(middle))

    def further(self, tube: Tube, boundary: str, sign: int) -> Known:
        """One sign more, at the zeros of a tube inside that are those of this one."""
        return Known(tube, {**self.signs, boundary: sign})


@dataclass(frozen=True, slots=True)
class Cell:
    """A box of parameter values and a place near which the spot is known; None: it is not known anywhere near.

    ``boxes``: how many may be examined; fewer for an undecided piece of another cell, of which it is asked from the
    start whether smaller ones could say more.
    """

    lower: tuple[fmpq, ...]
    upper: tuple[fmpq, ...]
    origin: Origin | None
    boxes: int = BOXES

    @property
    def hopeless_from(self) -> int:
        """After how many halvings it is asked whether smaller pieces could say more."""
        return _HOPELESS_FROM if self.boxes >= BOXES else 0


@dataclass
class Examination:
    """The examination of cells, one after the other. What is tried first depends on the cells before, so the same cells
    in the same order give the same pieces."""

    equations: Equations
    digits: int
    damped: bool = True
    """Whether the contact is; else no side is named."""
    origins: list[Origin] = field(default_factory=list)
    sides: list[fmpq] = field(default_factory=list)
    left: int = BOXES
    """Boxes that may still be examined."""
    beyond: int = BOXES_BEYOND
    """Boxes without a tube that may still be divided on a line where none is left."""
    hopeless_from: int = _HOPELESS_FROM
    """Of the cell."""
    kept_tubes: TubeTrace = field(default_factory=TubeTrace)
    """The tubes of the last cell, as choices."""

    def pieces(self, cell: Cell, known: Sequence[Choice] = ()) -> list[SweepPiece]:
        """Pieces that cover the cell, in the order of their lower ends.

        ``known``: the tubes of an earlier examination; each is proved again.
        """
        self.kept_tubes = TubeTrace(known)
        if cell.origin is None:
            return [SweepPiece(cell.lower, cell.upper, Kind.NO_TUBE)]
        # The widths of the last tube are a good guess at those of the next, where none are known there.
        guessed = bool(self.origins) and not cell.origin.widths
        self.origins = [cell.origin.as_wide_as(self.origins[-1]) if guessed else cell.origin]
        self.left, self.beyond, self.hopeless_from = cell.boxes, BOXES_BEYOND, cell.hopeless_from
        self.sides = [high - low for low, high in zip(cell.lower, cell.upper, strict=True)]
        with working_bits(BITS):
            pieces = self._examine((cell.lower, cell.upper), 0, Known())
        return sorted(pieces, key=lambda piece: piece.lower)

    def _examine(self, box: Box, depth: int, known: Known) -> list[SweepPiece]:
        lower, upper = box
        line = len(lower) == 1
        last = depth >= (_DEPTH_OF_A_LINE if line else _DEPTH_OF_A_MAP) or self.left <= 0
        ended = self.left <= 0 and (self.beyond <= 0 or not line)
        deep = depth >= (_DEPTH_OF_A_LINE if line else _DEPTH_OF_A_TUBE) or ended
        origin = min(self.origins, key=lambda known_origin: known_origin.distance(lower, upper))
        on = self._tube(self.equations, lower, upper, origin)
        self.left -= 1
        if on is None or not known.concerns(on.tube):
            if deep:
                return [SweepPiece(lower, upper, Kind.NO_TUBE, unsure=(ENDED,) if ended and line else ())]
            self.beyond -= self.left < 0
            return self._halves(box, depth, known, self._longest(box))
        self.origins.append(Origin.of(on))
        facts = findings(on, known.signs, damped=self.damped)
        if not facts.unsure:
            return [facts.piece(on, Kind.SETTLED)]
        boundary = facts.unsure[0] if len(facts.unsure) == 1 and facts.unsure[0] not in _NOT_A_BOUNDARY else None
        if boundary is not None:
            if line:
                cut = bracket(self.equations, on, partial(quantity, name=boundary), self.digits, self._tube)
                if cut is not None:
                    return self._cut(on, boundary, cut, depth, known)
            elif last:
                passing = _graph(on, boundary)
                if passing is not None:
                    return [_with_passing(facts.piece(on, Kind.CROSSING), passing)]
        if last or (depth >= self.hopeless_from and _hopeless(on, facts.unsure)):
            return [facts.piece(on, Kind.OPEN)]
        steepest = _steepest(on, facts.unsure) if self.hopeless_from else None
        return self._halves(box, depth, known, self._longest(box) if steepest is None else steepest)

    def _tube(
        self, equations: Equations, lower: tuple[fmpq, ...], upper: tuple[fmpq, ...], origin: Origin
    ) -> OnTube | None:
        return self.kept_tubes.tube(equations, lower, upper, partial(proved_tube, equations, lower, upper, origin))

    def _halves(self, box: Box, depth: int, known: Known, side: int) -> list[SweepPiece]:
        """The two halves, that next to what is known first; on a line nothing is sought behind a place without tube."""
        halves = _halved(box, side)
        nearest = min(self.origins, key=lambda origin: origin.distance(*box))
        first, second = sorted(halves, key=lambda half: nearest.distance(*half))
        kept = self.left // 2  # what the first half may not use up
        self.left -= kept
        pieces = self._examine(first, depth + 1, known)
        self.left = max(self.left, 0) + kept
        if len(box[0]) == 1:
            facing = min(pieces, key=lambda piece: _gap(piece, second))
            if facing.kind is Kind.NO_TUBE:
                return [*pieces, SweepPiece(*second, Kind.NO_TUBE, unsure=facing.unsure)]
        pieces += self._examine(second, depth + 1, known)
        if all(piece.kind is Kind.NO_TUBE for piece in pieces):
            return [SweepPiece(*box, Kind.NO_TUBE, unsure=max(piece.unsure for piece in pieces))]
        return pieces

    def _longest(self, box: Box) -> int:
        """The side that was cut least often."""
        lower, upper = box
        parts = [(high - low) / side for low, high, side in zip(lower, upper, self.sides, strict=True)]
        return max(range(len(parts)), key=parts.__getitem__)

    def _cut(self, on: OnTube, boundary: str, cut: Cut, depth: int, known: Known) -> list[SweepPiece]:
        """The parts before and after a bracket, where a monotone quantity lies between its values at the ends."""
        (lower,), (upper,) = on.tube.lower, on.tube.upper
        parts: list[SweepPiece] = []
        sides = [(lower, upper)] if cut.ends is None else [(lower, cut.ends[0]), (cut.ends[1], upper)]
        for (start, end), sign in zip(sides, cut.signs, strict=True):
            if start < end:
                parts += self._examine(((start,), (end,)), depth + 1, known.further(on.tube, boundary, sign))
        if cut.ends is not None:
            (start, end), inside = cut.ends, Known(on.tube)
            between = self._tube(self.equations, (start,), (end,), Origin.of(on))
            if between is None or not inside.concerns(between.tube):
                return [*parts, SweepPiece((start,), (end,), Kind.NO_TUBE)]
            passing = Passing(boundary, 0, cut.direction, cut.before, cut.after)
            parts.append(
                _with_passing(findings(between, {}, damped=self.damped).piece(between, Kind.CROSSING), passing)
            )
        return parts


def _with_passing(piece: SweepPiece, passing: Passing) -> SweepPiece:
    return SweepPiece(
        lower=piece.lower,
        upper=piece.upper,
        kind=piece.kind,
        case=None,
        lift_off_sign=None,
        impact_sign=None,
        unsure=(passing.quantity,),
        passing=passing,
        numbers=piece.numbers,
        record=piece.record,
    )


def _graph(on: OnTube, boundary: str) -> Passing | None:
    """The boundary's derivative by one parameter has a certain sign on the whole piece."""
    for along, slope in enumerate(on.slopes(quantity(on, boundary))):
        sign = sign_of(slope)
        if sign in (1, -1):
            return Passing(boundary, along, sign)
    return None


def _hopeless(on: OnTube, unsure: Sequence[str]) -> bool:
    """Whether a quantity seems to vanish on the whole piece, so that smaller pieces say no more. A heuristic."""
    for name in unsure:
        if name in _NOT_A_BOUNDARY:
            continue
        own = quantity(on, name)
        vanishes = own.at_centre.contains(0) or abs(own.at_centre) < _TINY
        if vanishes and all(slope.contains(0) for slope in on.slopes(own)):
            return True
    return False


def _steepest(on: OnTube, unsure: Sequence[str]) -> int | None:
    """The parameter with which what is unsure seems to change far more than with others. A heuristic."""
    name = next((name for name in unsure if name not in _NOT_A_BOUNDARY), "beta")
    slopes = on.slopes(quantity(on, name))
    sides = [approximate(high - low) for low, high in zip(on.tube.lower, on.tube.upper, strict=True)]
    sizes = [abs(approximate(slope)) * side for slope, side in zip(slopes, sides, strict=True)]
    largest = max(range(len(sizes)), key=sizes.__getitem__)
    rest = max((size for j, size in enumerate(sizes) if j != largest), default=0.0)
    return largest if _FAR_STEEPER * rest < sizes[largest] < math.inf else None


def _halved(box: Box, side: int) -> tuple[Box, Box]:
    """Both halves, cut across one side."""
    lower, upper = box
    middle = (lower[side] + upper[side]) / 2
    return (
        (lower, (*upper[:side], middle, *upper[side + 1 :])),
        ((*lower[:side], middle, *lower[side + 1 :]), upper),
    )


def _gap(piece: SweepPiece, box: Box) -> fmpq:
    """On a line: how far the piece is from the box."""
    (start,), (end,) = box
    return max(start - piece.upper[0], piece.lower[0] - end, fmpq(0))
