"""The result of a sweep: pieces, stretches, crossings, folds, as text, JSON and CSV."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass, field
from functools import partial
from itertools import groupby
from typing import Any, ClassVar

from flint import fmpq

from gspot_verified.expansion.series.regularisation import NO_DAMPER
from gspot_verified.mechanisms.spots.classify import GIVEN_CONDITIONS
from gspot_verified.mechanisms.sweep.sweep_cell import BOXES, BOXES_BEYOND
from gspot_verified.mechanisms.sweep.sweep_fold import Fold
from gspot_verified.mechanisms.sweep.sweep_grid import Axis
from gspot_verified.mechanisms.sweep.sweep_piece import (
    ENDED,
    NUMBERS,
    Kind,
    Passing,
    PieceRow,
    SweepPiece,
    columns,
    piece_row,
)
from gspot_verified.mechanisms.sweep.sweep_pieces import PackedPortion, Said, SweptPieces
from gspot_verified.numbers.balls import ExactInput, approximate, float_bounds
from gspot_verified.numbers.counted import counted
from gspot_verified.numbers.dyadic import Dyadic
from gspot_verified.numbers.evidence import cover_by_boxes
from gspot_verified.numbers.verdict import NoTruthValue, Reason, Verdict
from gspot_verified.numbers.written import Written, form, rows_text, under
from gspot_verified.signs.gamma.side import side_text
from gspot_verified.work.executors import InProcessExecutor, in_order

_SHORT, _DECIMALS = 12, 16  # a rational of so many characters is shown as it is, a longer one with so many decimals
_SHORT_PIECE = fmpq(1, 10**6)  # of the range: a shorter piece next to a fold counts as its bracket
_IN_FLIGHT = 32  # portions that are being written, each some hundred kB
_SUMMARY = "name parameters=axes start=start_values spot verdict crossings notes warnings folds"
_UNKNOWN = (Kind.OPEN, Kind.NO_TUBE)
_OF_ALL = (Kind.SETTLED, Kind.BEYOND)  # what is said of a piece holds for every value in it


@dataclass(frozen=True, slots=True)
class ZeroOnLine(NoTruthValue, Written):
    """Where a quantity passes zero on a line: between ``lower`` and ``upper``, where it is strictly monotone."""

    ask: ClassVar[str] = ".proved says whether it certainly vanishes there, and then exactly once"
    written: ClassVar[str] = "quantity lower upper direction exactly_once=proved"

    quantity: str
    lower: fmpq
    upper: fmpq
    direction: int
    before: int | None
    after: int | None

    @property
    def proved(self) -> bool:
        """Whether it vanishes in the bracket, exactly once; otherwise it vanishes there at most once."""
        return self.before == -self.direction and self.after == self.direction

    def text(self, name: str) -> str:
        """In words."""
        what = _QUANTITIES.get(self.quantity, self.quantity.replace(" - ", " passes "))
        times = "exactly once" if self.proved else "at most once (it may do so at the end of the range)"
        return f"{what} in {name} = {_bracket(self.lower, self.upper)}, {times}"


_QUANTITIES = {
    "alpha_1": "alpha_1 passes 0",
    "alpha_2": "alpha_2 passes 0",
    "alpha_3": "alpha_3 passes 0",
    "alpha_3 - alpha_1": "alpha_3 - alpha_1 passes 0 (beta passes 1)",
}


@dataclass(frozen=True, slots=True)
class Sweep(NoTruthValue, Written):
    """The result of :func:`sweep`. ``pieces`` cover the range, in the order of their lower ends.

    ``start`` is where the spot was proved first, ``spot`` its state there. ``folds``: where it meets another one and
    vanishes (one parameter). ``notes`` say how the mechanism was read. ``budget``: that which ended before all pieces
    that might have been divided were; None: none is left of those. ``fixed``: components that keep their value, or
    ``given_conditions`` in their place: where G-spots form a curve or a surface, others are other ones, and may be of
    another Case.
    """

    ask: ClassVar[str] = ".verdict.outcome says whether Case and side are settled on the whole range"
    written: ClassVar[str] = f"{_SUMMARY} pieces=piece_rows"

    name: str
    axes: tuple[Axis, ...]
    start: tuple[fmpq, ...]
    spot: Mapping[str, str]
    pieces: Sequence[SweepPiece]
    folds: tuple[Fold, ...] = ()
    notes: tuple[str, ...] = ()
    budget: int | None = None
    fixed: tuple[str, ...] = ()
    given_conditions: bool = False
    _verdict: list[Verdict] = field(default_factory=list, init=False, repr=False, compare=False)

    def __post_init__(self) -> None:
        """All pieces are kept in the same way."""
        if not isinstance(self.pieces, SweptPieces):
            object.__setattr__(self, "pieces", SweptPieces.of(self.axes, self.pieces))

    @property
    def _swept(self) -> SweptPieces:
        assert isinstance(self.pieces, SweptPieces)
        return self.pieces

    @property
    def start_values(self) -> dict[str, fmpq]:
        """The start by the parameters' names."""
        return {axis.name: value for axis, value in zip(self.axes, self.start, strict=True)}

    @property
    def piece_rows(self) -> list[PieceRow]:
        """The pieces without their tubes."""
        return [piece_row(piece) for piece in self.pieces]

    @property
    def verdict(self) -> Verdict:
        """Proved when Case and side are settled on some piece, and nothing is left but brackets in which one quantity
        passes zero; of two parameters, pieces on which one may, and is monotone."""
        if not self._verdict:  # what it covers is looked through once
            self._verdict.append(self._judged())
        return self._verdict[0]

    @property
    def asked(self) -> str:
        """What is settled on the pieces, and of which G-spot."""
        what = "Case" if any(map(_names_no_side, self._swept.counts())) else "Case and side"
        held = f" with {', '.join(self.fixed)} fixed" if self.fixed else ""
        return f"{what} of the continued G-spot{held or f' {GIVEN_CONDITIONS}' * self.given_conditions}"

    def _judged(self) -> Verdict:
        over = ", ".join(f"{axis.name} in [{axis.lower}, {axis.upper}]" for axis in self.axes)
        on_line = "brackets where one quantity passes zero or the spot vanishes"
        besides = on_line if len(self.axes) == 1 else "pieces along curves where one quantity may pass zero"
        ended = ", or that it is no more," if self._count(Kind.BEYOND) else ""
        counts = self._swept.counts()
        statement = f"{self.name}: {self.asked}{ended} for every {over}, except in the {besides}"
        left = sum(count for said, count in counts.items() if said.kind in _UNKNOWN) + self._wide_folds()
        half = sum(not crossing.proved for crossing in self.crossings)
        if not left and not half:
            whole = tuple(axis.lower for axis in self.axes), tuple(axis.upper for axis in self.axes)
            covered = cover_by_boxes((box for _, box in self._swept.boxes()), whole)
            if covered is None:
                return Verdict.undecided(statement, Reason.HYPOTHESIS, "the pieces leave a part of the range out")
            if not any(said.kind is Kind.SETTLED for said in counts):
                return Verdict.undecided(statement, Reason.HYPOTHESIS, "no piece is settled")
            crossed = self._count(Kind.CROSSING) if len(self.axes) > 1 else 0
            detail = f"{crossed} of {len(self.pieces)} pieces are open" if crossed else ""
            return Verdict.proved(statement, covered, detail)
        finer = ", ".join(f"{axis.name}={axis.lower}..{axis.upper}:{2 * axis.cells}" for axis in self.axes)
        them = "it" if left == 1 else "them"
        pieces = f"{_left(left, len(self.pieces))} left; "
        if self.budget is not None:
            pieces += f"the budget of {counted(self.budget, 'divided piece')} ended: a larger one may settle {them}"
        elif not self._cells_ended:
            pieces += (
                f"dividing {them} again has not settled {them}; {self._fold_between() or f'more cells may: {finer}'}"
            )
        if self._cells_ended:
            pieces += "; " * (self.budget is not None)
            pieces += f"{ENDED}, {BOXES} and {BOXES_BEYOND} divided beyond them; more cells may settle {them}: {finer}"
        brackets = f"in {counted(half, 'bracket')} at most one zero is shown"
        reason = Reason.HYPOTHESIS if self.budget is None and not self._cells_ended else Reason.BUDGET
        return Verdict.undecided(statement, reason, "; ".join([pieces] * bool(left) + [brackets] * bool(half)))

    @property
    def _cells_ended(self) -> bool:
        """Whether pieces are left because the boxes of their cell ended."""
        return any(ENDED in what.unsure for what in self._swept.counts())

    def _count(self, kind: Kind) -> int:
        return sum(count for what, count in self._swept.counts().items() if what.kind is kind)

    def _fold_between(self) -> str:
        """Of two parameters, where the continued spot is followed up to some pieces and not beyond: what is known of
        that. Empty where it is found on all pieces, or of one parameter, whose folds are sought."""
        without = self._count(Kind.NO_TUBE)
        if not without or len(self.axes) == 1:
            return ""
        names = [axis.name for i, axis in enumerate(self.axes) if self._loses_the_spot_along(i)]
        alone = " or ".join(names or [axis.name for axis in self.axes])
        return (
            f"on {counted(without, 'piece')} no continued spot was found: it may end before, at a fold, where it meets "
            "another one and both vanish, and then more cells settle nothing; over two parameters folds are not "
            f"sought, over {alone} alone they are"
        )

    def _loses_the_spot_along(self, i: int) -> bool:
        """Whether the spot was not found somewhere on the line through the start along this axis."""
        across = [(j, value) for j, value in enumerate(self.start) if j != i]
        return any(
            all(lower[j] <= value <= upper[j] for j, value in across)
            for _, (lower, upper) in self._swept.boxes(lambda what: what.kind is Kind.NO_TUBE)
        )

    def _wide_folds(self) -> int:
        """How many pieces next to a fold, where Case and side are not settled, are more than brackets."""
        folds = self._swept.boxes(lambda what: what.kind is Kind.FOLD)
        short = (self.axes[0].upper - self.axes[0].lower) * _SHORT_PIECE
        return sum(bool(upper[0] - lower[0] > short) for _, (lower, upper) in folds)

    @property
    def crossings(self) -> tuple[ZeroOnLine, ...]:
        """On a line: the brackets in which Case or side change."""
        zeros: list[ZeroOnLine] = []
        crossings = self._swept.boxes(lambda what: what.passing is not None)
        for what, ((lower, *_), (upper, *_)) in crossings if len(self.axes) == 1 else ():
            passing = what.passing
            assert passing is not None
            last = zeros[-1] if zeros else None
            if last is not None and last.upper == lower and _same(last, passing):
                lower, before = last.lower, last.before
                zeros.pop()
            else:
                before = passing.before
            zeros.append(ZeroOnLine(passing.quantity, lower, upper, passing.direction, before, passing.after))
        return tuple(zeros)

    @property
    def warnings(self) -> tuple[str, ...]:
        """What makes a motion through the G-spot impossible, or not certainly possible, where it is, or may be, in a
        Case."""
        maybe = (Kind.SETTLED, Kind.CROSSING, Kind.OPEN)
        counts = self._swept.counts().items()
        cases = [(what, count) for what, count in counts if what.kind in maybe and what.case != "none"]
        tensile = sum(count for what, count in cases if what.case == "I")
        wrong = sum(count for what, count in cases if what.slip_sign in (-1, 0))
        unknown = sum(count for what, count in cases if what.slip_sign is None)
        texts = []
        if tensile:
            where = f"in Case I ({counted(tensile, 'piece')})"
            texts.append(f"{where} the mean force is tensile (negative), no contact does that")
        if wrong or unknown:
            where = f"on {counted(wrong, 'piece')}, perhaps on {unknown} more"
            texts.append(f"u <= 0 at the G-spot {where}: no positive slip on a surface at rest")
        return tuple(texts)

    def at(self, **values: ExactInput) -> SweepPiece:
        """A piece that holds these parameter values.

        :raises ValueError: a value is missing, or outside of the range.
        """
        place = [axis.value_in(values) for axis in self.axes]
        boxes = enumerate(box for _, box in self._swept.boxes())
        return self.pieces[next(k for k, (lower, upper) in boxes if _holds(lower, place, upper))]

    def stretches(self) -> list[tuple[fmpq, fmpq, SweepPiece]]:
        """On a line: maximal ranges on which kind, Case and side are the same, with their first pieces."""
        stretches: list[tuple[fmpq, fmpq, SweepPiece]] = []
        runs = groupby(enumerate(self._swept.said()), key=lambda numbered: _alike(numbered[1]))
        for _, run in runs if len(self.axes) == 1 else ():
            numbers = [k for k, _ in run]
            first, last = self.pieces[numbers[0]], self.pieces[numbers[-1]]
            stretches.append((first.lower[0], last.upper[0], first))
        return stretches

    def __str__(self) -> str:
        where = ", ".join(f"{axis.name} = {value}" for axis, value in zip(self.axes, self.start, strict=True))
        lines = [str(self.verdict), f"  the spot at {where}: " + ", ".join(f"{k} = {v}" for k, v in self.spot.items())]
        if len(self.axes) == 1:
            name = self.axes[0].name
            lines += [
                f"  {name} in {(_inner if piece.kind in _OF_ALL else _bracket)(lower, upper)}: {_piece_text(piece)}"
                for lower, upper, piece in self.stretches()
                if piece.passing is None
            ]
            lines += [f"  {text}" for text in (*(crossing.text(name) for crossing in self.crossings), *self.folds)]
        else:
            lines += [f"  {counted(count, 'piece')}: {text}" for text, count in self._counts().items()]
        return "\n".join(
            [
                *lines,
                *(f"  note: {note}" for note in self.notes),
                *(f"  warning: {warning}" for warning in self.warnings),
            ]
        )

    def _counts(self) -> dict[str, int]:
        counts: dict[str, int] = {}
        for what, count in self._swept.counts().items():
            text = _piece_text(what)
            counts[text] = counts.get(text, 0) + count
        return counts

    def to_csv(self) -> str:
        """One line for each piece: its ends exactly and as the nearest doubles, bounds of the numbers rounded outward.

        Where a parameter has the name of a number, as beta, the columns of that begin with ``spot_``.
        """
        return "".join(self.csv_lines())

    def csv_lines(self, executor: Executor | None = None) -> Iterator[str]:
        """The lines of :meth:`to_csv` with their line feeds, some at a time, made by the executor."""
        names = [axis.name for axis in self.axes]
        ends = [f"{name}_{end}{form}" for name in names for end in ("lower", "upper") for form in ("", "_exact")]
        words = ["kind", "case", "lift_off_sign_of_C1", "impact_sign_of_C1", "unsure"]
        bounds = [f"{name}_{end}" for name in NUMBERS for end in ("lower", "upper")]
        yield ",".join(columns(("", ends), ("answer_", words), ("spot_", bounds))) + "\n"
        yield from self._written(_csv_lines, executor)

    def in_parts(self, executor: Executor | None = None) -> tuple[dict[str, Any], Iterator[str]]:
        """The plain data without the pieces, and that of the pieces as JSON, some at a time, made by the executor."""
        return SweepSummary(self).to_json(), self._written(_json_rows, executor)

    def _written(self, write: Callable[[PackedPortion], str], executor: Executor | None) -> Iterator[str]:
        calls = (partial(write, part) for part in self._swept.portions())
        return in_order(executor or InProcessExecutor(), calls, _IN_FLIGHT)


@dataclass(frozen=True, slots=True)
class SweepSummary(NoTruthValue, Written):
    """What a sweep says of its range as a whole: its plain data without the pieces."""

    ask: ClassVar[str] = ".sweep.verdict.outcome says whether Case and side are settled on the whole range"
    written: ClassVar[str] = under("sweep", _SUMMARY)

    sweep: Sweep


def _left(left: int, total: int) -> str:
    if total == 1:
        return "the only piece is"
    return f"{left} of {total} pieces {'is' if left == 1 else 'are'}"


def _same(last: ZeroOnLine, passing: Passing) -> bool:
    return (last.quantity, last.direction) == (passing.quantity, passing.direction)


def _alike(what: Said) -> object:
    """The same for pieces of one stretch."""
    return what.kind, what.answer, what.unsure, what.passing is None


def _holds(lower: Sequence[fmpq], place: Sequence[fmpq], upper: Sequence[fmpq]) -> bool:
    return all(low <= value <= high for low, value, high in zip(lower, place, upper, strict=True))


def _names_no_side(piece: Said | SweepPiece) -> bool:
    """Whether a Case is settled and no side belongs to it: the contact has no damper."""
    return piece.kind is Kind.SETTLED and piece.case != "none" and piece.impact_sign is None


def _piece_text(piece: Said | SweepPiece) -> str:
    if piece.kind is Kind.NO_TUBE:
        return f"no continued spot was found{f': {ENDED}' if ENDED in piece.unsure else ''}"
    if piece.kind is Kind.BEYOND:
        return "the continued spot is no more: it vanished at the fold"
    if piece.kind is Kind.FOLD:
        return "up to a fold: Case and side are not settled"
    if piece.kind is Kind.CROSSING:
        passes = _QUANTITIES.get(piece.unsure[0], piece.unsure[0].replace(" - ", " passes "))
        return passes.replace("passes", "may pass")  # of two parameters: that it does is not shown
    if piece.kind is Kind.OPEN:
        return f"undecided: {', '.join(piece.unsure)}"
    if piece.case == "none":
        return "no Case"
    if _names_no_side(piece):
        return f"Case {piece.case}: no side: {NO_DAMPER}"
    sides = side_text(piece.lift_off_sign, piece.impact_sign)
    return sides if piece.case == "III" else f"Case {piece.case}{sides.removeprefix('Cases I and II')}"


def _csv_lines(pieces: Iterable[SweepPiece]) -> str:
    return "".join(f"{_csv_line(piece)}\n" for piece in pieces)


def _json_rows(pieces: Iterable[SweepPiece]) -> str:
    return rows_text(form(PieceRow).write(piece_row(piece)) for piece in pieces)


def _csv_line(piece: SweepPiece) -> str:
    ends = [
        text
        for low, high in zip(piece.lower, piece.upper, strict=True)
        for end in (low, high)
        for text in (repr(approximate(end)), str(end))
    ]
    signs = ["" if sign is None else str(sign) for sign in (piece.lift_off_sign, piece.impact_sign)]
    words = [piece.kind.value, piece.case or "", *signs, "; ".join(piece.unsure)]
    bounds = [text for number in piece.numbers for text in _bounds(number)]
    return ",".join([*ends, *words, *bounds])


def _bounds(number: Dyadic | None) -> tuple[str, str]:
    if number is None:
        return "", ""
    lower, upper = float_bounds(number.to_ball())
    return repr(lower), repr(upper)


def _bracket(lower: fmpq, upper: fmpq) -> str:
    """The range in decimals where its ends are long, rounded outward."""
    return f"[{_decimal(lower, -1)}, {_decimal(upper, 1)}]"


def _inner(lower: fmpq, upper: fmpq) -> str:
    """The same rounded inward, where something holds for every value; exactly where little would be left."""
    if upper - lower < fmpq(2, 10**_DECIMALS):
        return f"[{lower}, {upper}]"
    return f"[{_decimal(lower, 1)}, {_decimal(upper, -1)}]"


def _decimal(value: fmpq, direction: int) -> str:
    if len(str(value)) <= _SHORT:
        return str(value)
    scaled = value * 10**_DECIMALS
    whole = int(scaled.floor() if direction < 0 else scaled.ceil())
    digits = f"{abs(whole):0{_DECIMALS + 1}d}"
    return f"{'-' if whole < 0 else ''}{digits[:-_DECIMALS]}.{digits[-_DECIMALS:]}"
