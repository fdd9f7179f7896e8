"""What the sign atlas shows, read off certified columns: areas of one sign, tubes of zeros, and curves inside them.

What a piece proves: ``proofs/certificate.md``; values: ``proofs/box.md``. The areas come from the pieces alone; a point
of a curve is the middle of an interval, inside a tube, between two certain opposite signs.
"""

from __future__ import annotations

import enum
import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import accumulate
from operator import mul

from flint import arb, arb_poly, fmpq

from gspot_verified.numbers.balls import add_remainder, approximate, sign_of, working_bits
from gspot_verified.signs.cover.pieces import Column, ColumnPiece, Kind, cell_of, end_signs, fold_integer
from gspot_verified.signs.cover.witness import sign_at
from gspot_verified.theta_function.boxes.box import omitted_terms
from gspot_verified.theta_function.boxes.box_choice import bits_for_box, length_for_box
from gspot_verified.theta_function.boxes.parameter_series import parameter_series

_WIDTH = fmpq(1, 2**10)  # of the interval around a drawn zero: less than a pixel
_SAMPLES_PER_UNIT = 24  # points of a curve of zeros in a unit of beta
_LEAST_SAMPLES = 2  # of a column, however low
_FOLD_SAMPLES = 12  # points of each branch at a fold, dense towards it
_TAIL_STEPS = (*[fmpq(5, 8)] * 10, *[fmpq(1, 4)] * 24)


class Colour(enum.Enum):
    """What is certain of dTheta/dtau on an area."""

    NEGATIVE = "negative"
    POSITIVE = "positive"
    ONE_ZERO = "one zero"
    TWO_ZEROS = "two zeros"


@dataclass(frozen=True, slots=True)
class Area:
    """A box of (tau, beta); ``None`` as an end is infinity. ``ONE_ZERO``: one at each beta (``TWO_ZEROS``: two)."""

    colour: Colour
    left: fmpq | None
    right: fmpq | None
    lower: fmpq | None
    upper: fmpq


ZeroCurve = tuple[tuple[float, float], ...]
"""Points (tau, beta) within 1/2000 in tau of a zero, in the order of beta."""


def areas(column: Column) -> list[Area]:
    """The areas of one column of :func:`signs.zeros.zeros.zeros_on_range`; what is left out is not settled."""
    joined: list[Area] = []
    n = 0 if column.lower is None else cell_of(column.lower, column.upper)
    factor = 1 if column.lower is None or column.lower < 0 else -1  # dTheta/dtau = -beta F
    run: list[ColumnPiece] = []
    before = 0
    for piece in column.pieces:
        if piece.kind is Kind.MONOTONE:
            run.append(piece)
            continue
        left, right = end_signs(piece, n)
        if run:
            _add(joined, column, _run_colour(factor, before, left), run[0].lower, run[-1].upper)
            run = []
        before = right
        if piece.kind is Kind.FOLD and _two_zeros(column):
            _add(joined, column, Colour.TWO_ZEROS, piece.lower, piece.upper)
        elif not (piece.kind is Kind.RIGHT and piece.mark):
            whole = piece.kind is Kind.LAPLACE
            _add(joined, column, _sign_colour(factor * left), None if whole else piece.lower, piece.upper)
    return joined


def _add(joined: list[Area], column: Column, colour: Colour | None, left: fmpq | None, right: fmpq | None) -> None:
    """Append an area, joined to its neighbour where both have one sign."""
    if colour is None:
        return
    last = joined[-1] if joined else None
    signs = (Colour.NEGATIVE, Colour.POSITIVE)
    if last is not None and last.colour is colour and colour in signs and last.right is not None and last.right == left:
        joined.pop()
        left = last.left
    joined.append(Area(colour, left, right, column.lower, column.upper))


def _run_colour(factor: int, before: int, after: int) -> Colour | None:
    """A monotone function between two equal signs keeps the sign; between different ones it has one zero."""
    if 0 in (before, after):
        return None
    return Colour.ONE_ZERO if before != after else _sign_colour(factor * before)


def _sign_colour(sign: int) -> Colour:
    return Colour.POSITIVE if sign > 0 else Colour.NEGATIVE


def _two_zeros(column: Column) -> bool:
    """Whether the fold's integer is the upper end of the column, so that the fold box holds two zeros."""
    return column.lower is not None and fold_integer(column.lower, column.upper) == column.upper - 1


def folds(columns: Sequence[Column]) -> list[fmpq]:
    """The beta at which two zeros meet at tau = 0 in a certified fold box."""
    betas = set()
    for column in columns:
        if column.lower is not None and any(piece.kind is Kind.FOLD for piece in column.pieces):
            n = fold_integer(column.lower, column.upper)
            betas |= set() if n is None else {n + 1}
    return [fmpq(beta) for beta in sorted(betas)]


def entries(columns: Sequence[Column]) -> list[fmpq]:
    """The integers beta above which a column leaves exactly one zero beyond its last piece: it comes in from +inf."""
    return [
        column.lower for column in columns
        if column.lower is not None and column.lower.q == 1 and column.lower < column.upper and _in_tail(column)
    ]  # fmt: skip


def has_open_tail(columns: Sequence[Column]) -> bool:
    """Whether some column leaves one zero beyond its last piece: the sign there is not settled."""
    return any(_in_tail(column) for column in columns)


def _in_tail(column: Column) -> bool:
    last = column.pieces[-1]
    return last.kind is Kind.RIGHT and last.mark == 1


def zero_curves(column: Column, limit: fmpq) -> list[ZeroCurve]:
    """The zeros of one column as curves, up to tau = ``limit``. Between two points a zero is in the same tube."""
    if column.lower is None:
        return []
    height = column.upper - column.lower
    count = max(_LEAST_SAMPLES, math.ceil(_SAMPLES_PER_UNIT * approximate(height)))
    even = [column.lower + height * fmpq(i, count) for i in range(count + 1)]
    tubes = [(even, left, right) for left, right in column.tubes()]
    if _two_zeros(column):
        # The curve has a horizontal tangent at the fold.
        betas = [column.upper - height * fmpq(i, _FOLD_SAMPLES) ** 2 for i in range(_FOLD_SAMPLES, -1, -1)]
        for piece in column.pieces:
            if piece.kind is Kind.FOLD and piece.lower is not None and piece.upper is not None:
                tubes += [(betas, piece.lower, fmpq(0)), (betas, fmpq(0), piece.upper)]
    last = column.pieces[-1].lower
    if _in_tail(column) and last is not None and last < limit:
        # The zero goes to infinity very fast near an integer: the distances to it shrink geometrically.
        steps = accumulate(_TAIL_STEPS, mul, initial=height)
        betas = [column.lower + step for step in steps][::-1]
        tubes.append((betas, last, limit))
    reach = max((abs(end) for _, left, right in tubes for end in (left, right)), default=fmpq(0))
    models: dict[fmpq, _Slope] = {}
    curves: list[ZeroCurve] = []
    for betas, left, right in tubes:
        curve = []
        for beta in betas:
            if beta not in models:
                models[beta] = _Slope(beta, reach)
            tau = _zero(models[beta], left, right)
            if tau is not None:
                curve.append((approximate(tau), approximate(beta)))
        curves += [tuple(curve)] if len(curve) > 1 else []
    return curves


class _Slope:
    """dTheta/dtau at one beta > 0, for |tau| <= reach, by its Taylor polynomial at 0: ``proofs/box.md``, section 4."""

    def __init__(self, beta: fmpq, reach: fmpq) -> None:
        self.beta = beta
        size, far = approximate(abs(beta - 1)), approximate(reach)
        bits = bits_for_box(far, size)
        self._series = parameter_series(beta - 1, fmpq(0), 1, length_for_box(far, size, bits), bits)
        with working_bits(bits):
            values = [add_remainder(row[0], row[2]) for row in self._series.matrix.table()]
            self._polynomial = arb_poly(values)
            self._omitted = omitted_terms(self._series, arb(reach), 0)

    def sign(self, tau: fmpq) -> int | None:
        """The certain sign, 0 included at an integer beta, or None."""
        if self.beta.q == 1:
            return sign_at(tau, self.beta)
        with working_bits(self._series.bits):
            sign = sign_of(add_remainder(self._polynomial(arb(tau)), self._omitted))
        return None if sign is None else -sign  # dTheta/dtau = -beta F


def _zero(slope: _Slope, left: fmpq, right: fmpq) -> fmpq | None:
    """The middle of an interval of width 1/1024 with certain opposite signs at its ends; None if there is no change."""
    before, after = slope.sign(left), slope.sign(right)
    if before == 0 or after == 0:
        return left if before == 0 else right
    if before is None or after is None or before == after:
        return None
    while right - left > _WIDTH:
        middle = (left + right) / 2
        sign = slope.sign(middle)
        if not sign:
            return None if sign is None else middle
        left, right = (middle, right) if sign == before else (left, middle)
    return (left + right) / 2
