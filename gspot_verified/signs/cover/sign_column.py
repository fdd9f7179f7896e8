"""Pieces over a range of tau that give F one sign, for one range of beta inside a cell."""

from __future__ import annotations

from dataclasses import dataclass

from flint import fmpq

from gspot_verified.signs.cover.column_models import ColumnModels
from gspot_verified.signs.cover.pieces import Column, ColumnPiece, Kind, cell_of, fold_integer
from gspot_verified.signs.cover.tails import left_threshold
from gspot_verified.signs.cover.zero_column import (
    FOLD_HALF_WIDTHS,
    LEAST_LEFT_OF_FOLD,
    grid,
    grid_along,
    reach_of_cell,
    right_tail,
)
from gspot_verified.work.ranges import Range

MAX_REACH = 60
"""Pieces between the tails are sought for |tau| up to here."""

_NEAR_INTEGER = fmpq(1, 16)  # in beta: the right tail may begin further out there
_LEAST_WIDTH = fmpq(1, 2**9)  # of a piece in tau; a column that needs narrower ones is cut
_POINT_HALF_WIDTHS = tuple(fmpq(1, 2**j) for j in (3, 6, 12, 24, 48))

Found = Column | tuple[fmpq, fmpq] | None
"""A column; or a point (tau, beta) where F has the other sign; or nothing."""


@dataclass(frozen=True, slots=True)
class SignQuestion:
    """Does F = Theta(., beta - 1) have the sign ``sign`` on the two ranges? ``by_theorem``: beta <= 1 is settled by the
    Laplace integral at once, and not by numbers."""

    tau: Range
    beta: Range
    sign: int
    by_theorem: bool = False


def sign_column(question: SignQuestion, lower: fmpq | None, upper: fmpq, along: Column | None = None) -> Found:
    """The answer over beta in [lower, upper], a part of the closure of the question's range.

    ``along``: pieces to try first. Nothing is taken from them but where to cut.
    """
    if lower is None or (upper <= 1 and (question.by_theorem or lower < 0 or upper == 0)):
        point = fmpq(-1) if lower is None else (lower + upper) / 2
        if question.sign < 0:
            return (_inner(question.tau), point if lower is not None else upper - 1)
        return Column(lower, upper, (ColumnPiece(Kind.LAPLACE, None, None),))
    return _SignSearch(question, lower, upper, along).run()


def _inner(tau: Range) -> fmpq:
    """A point inside the range."""
    if tau.lower is None:
        return fmpq(-1) if tau.upper is None else tau.upper - 1
    return tau.lower + 1 if tau.upper is None else (tau.lower + tau.upper) / 2


class _SignSearch:
    """The search in one column; ``witness`` is set when a wrong sign was met."""

    def __init__(self, question: SignQuestion, lower: fmpq, upper: fmpq, along: Column | None) -> None:
        self.question = question
        self.along = along
        self.tau = question.tau
        self.sign = question.sign
        self.lower, self.upper = lower, upper
        self.n = cell_of(lower, upper)
        self.reach = self._reach()
        self.models = ColumnModels(lower - 1, upper - 1, self.reach)
        self.witness: tuple[fmpq, fmpq] | None = None

    def _reach(self) -> fmpq:
        """How far pieces between the tails are sought: not beyond the tails, where a tail piece takes over."""
        usual = reach_of_cell(max(self.n, 0))
        ends = [abs(end) for end in (self.tau.lower, self.tau.upper) if end is not None]
        # Next to an integer the right tail may be further out than usual: a finite range is then covered by boxes.
        touches = self.n >= 0 and self.lower - 1 - self.n < _NEAR_INTEGER
        return max([usual, *(end + 1 for end in ends if touches and end <= MAX_REACH)])

    def run(self) -> Found:
        """Tails first, then what lies between them."""
        left = -left_threshold(self.lower - 1, self.upper - 1, self.n, 64 if self.n < 0 else 8)
        right, tail = self._right()
        if self.tau.upper is not None and self.tau.upper <= left:
            return self._whole(ColumnPiece(Kind.LEFT, None, left), 1)
        if tail is not None and self.tau.lower is not None and self.tau.lower >= right:
            return self._whole(tail, self._tail_sign())
        if self._fold_allowed():
            left = min(left, LEAST_LEFT_OF_FOLD)
        before: list[ColumnPiece] = []
        after: list[ColumnPiece] = []
        begin, end = self.tau.lower, self.tau.upper
        if begin is None or begin < left:
            if self.sign < 0:
                return self._refuted(_inner(Range(begin, left, False, False)))
            before, begin = [ColumnPiece(Kind.LEFT, None, left)], left
        if tail is not None and (end is None or end > right):
            if self._tail_sign() != self.sign:
                return self._refuted(_inner(Range(right, end, False, False)))
            after, end = [tail], right
        if end is None or max(-begin, end) > MAX_REACH:
            return None
        middle = self._middle(begin, end)
        if self.witness is not None:
            return self.witness
        return None if middle is None else Column(self.lower, self.upper, (*before, *middle, *after))

    def _right(self) -> tuple[fmpq, ColumnPiece | None]:
        if self.upper <= 1:
            return fmpq(0), ColumnPiece(Kind.TAYLOR, fmpq(0), None)
        right = right_tail(self.models, self.n, self.reach, 0, self.along)
        return (fmpq(0), None) if right is None else (right, ColumnPiece(Kind.RIGHT, right, None, 0))

    def _tail_sign(self) -> int:
        return 1 if self.upper <= 1 or self.n % 2 else -1

    def _whole(self, piece: ColumnPiece, sign: int) -> Found:
        if sign != self.sign:
            return self._refuted(_inner(self.tau))
        return Column(self.lower, self.upper, (piece,))

    def _refuted(self, tau: fmpq) -> tuple[fmpq, fmpq]:
        self.witness = (tau, (self.lower + self.upper) / 2)
        return self.witness

    def _point(self, tau: fmpq) -> tuple[ColumnPiece, ...] | None:
        """A single tau: a short interval around it; at 0 a hinge serves where F has a zero at an integer."""
        for half_width in _POINT_HALF_WIDTHS:
            if self.models.sign(tau - half_width, tau + half_width) == self.sign:
                return (ColumnPiece(Kind.SIGN, tau - half_width, tau + half_width, self.sign),)
            for begin, end in ((-half_width, tau), (tau, half_width)):
                if tau == 0 and self._hinge(begin, end):
                    return (ColumnPiece(Kind.HINGE, begin, end),)
        if self.models.sign_at_centre(tau) == -self.sign:
            self._refuted(tau)
        return None

    def _middle(self, begin: fmpq, end: fmpq) -> tuple[ColumnPiece, ...] | None:
        if begin <= 0 <= end and self.sign > 0 and self._fold_allowed():
            for half_width in FOLD_HALF_WIDTHS:
                # A fold may reach beyond the range of tau, but not into the pieces of the tails.
                apart = (begin < -half_width or begin == self.tau.lower) and (half_width < end or end == self.tau.upper)
                if apart and self.models.fold(-half_width, half_width):
                    fold = (ColumnPiece(Kind.FOLD, -half_width, half_width),)
                    return self._joined((begin, -half_width), fold, (half_width, end))
        if begin == end:
            return self._point(begin)
        if begin < 0 < end:
            return self._joined((begin, fmpq(0)), (), (fmpq(0), end))
        return self._cover(begin, end)

    def _joined(
        self, first: tuple[fmpq, fmpq], between: tuple[ColumnPiece, ...], second: tuple[fmpq, fmpq]
    ) -> tuple[ColumnPiece, ...] | None:
        """Covers of two intervals, each possibly empty, with a piece between them."""
        before = self._cover(*first) if first[0] < first[1] else ()
        if before is None:
            return None
        after = self._cover(*second) if second[0] < second[1] else ()
        return None if after is None else (*before, *between, *after)

    def _fold_allowed(self) -> bool:
        """The fold's integer is the lower end of the range of b, and the double zero at (0, n) is not asked for."""
        n = fold_integer(self.lower, self.upper)
        asked = self.tau.contains(fmpq(0)) and self.question.beta.contains(self.lower)
        return n is not None and n == self.lower - 1 < self.upper - 1 and not asked

    def _hinge(self, lower: fmpq, upper: fmpq) -> bool:
        """The hypotheses of the hinge of ``proofs/fold.md``."""
        if self.n < 0 or 0 not in (lower, upper):
            return False
        direction = self.models.sign(lower, upper, 1)
        if direction is None or self.sign != (direction if lower == 0 else -direction):
            return False
        if self.sign != (-1 if self.n % 3 == 1 else 1):
            return False
        zeros_at_0 = (b for b in (self.n, self.n + 1) if b % 3 and self.lower - 1 <= b <= self.upper - 1)
        return not (self.tau.contains(fmpq(0)) and any(self.question.beta.contains(fmpq(b + 1)) for b in zeros_at_0))

    def _cover(self, begin: fmpq, end: fmpq) -> tuple[ColumnPiece, ...] | None:
        waiting = grid(begin, end) if self.along is None else grid_along(begin, end, self.along)
        pieces: list[ColumnPiece] = []
        least = min(_LEAST_WIDTH, (end - begin) / 64)
        while waiting:
            lower, upper = waiting.pop()
            middle = (lower + upper) / 2
            sign = self.models.sign(lower, upper)
            if sign == self.sign:
                pieces.append(ColumnPiece(Kind.SIGN, lower, upper, sign))
            elif sign == -self.sign or self.models.sign_at_centre(middle) == -self.sign:
                self._refuted(middle)
                return None
            elif self._hinge(lower, upper):
                pieces.append(ColumnPiece(Kind.HINGE, lower, upper))
            elif upper - lower <= least:
                return None
            else:
                waiting += [(middle, upper), (lower, middle)]
        return tuple(pieces)
