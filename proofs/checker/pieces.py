"""Pieces of a column: how they are read, and what each proves of F on its part (certificate.md, Columns and Pieces).

The lemmas that they rest on are proved on laplace.md, signs.md, tails.md and fold.md.
"""

from __future__ import annotations

import math
from collections import namedtuple
from collections.abc import Sequence
from fractions import Fraction
from itertools import pairwise
from typing import Any

from limits import Limits, require
from reading import INFINITY, check_cover, entries, one_of, rational, read_header, read_line, read_lines
from theta import Box, Theta

HYPOTHESES = {
    1: ["certificate", "fold", "identities", "initial_values", "laplace", "negative", "tails"],
    2: ["certificate", "exact_solution", "identities", "initial_values", "laplace", "monotone", "negative", "tails"],
    3: [
        *("certificate", "epsilon_series", "exact_solution", "finite_epsilon_zeros"),
        *("identities", "initial_values", "laplace", "negative"),
    ],
}  # by version
POINTS = {"laplace": 0, "taylor": 0, "left": 1, "right": 1, "sign": 2, "monotone": 2, "fold": 2, "hinge": 2}
POINTS |= {"level": 2, "dip": 2}  # of the points that a piece of each kind names: how many
VALUES: dict[str, tuple[int, ...]] = {"right": (0, 1), "sign": (-1, 1), "monotone": (-1, 1)}  # of v, s and d

Piece = namedtuple("Piece", "start end kind points value")  # covers [start, end] in τ; value is its s, d or v, or 0
Column = namedtuple("Column", "start end cell pieces")  # β in [start, end]; b in [cell, cell + 1] or in (-∞, 0]


def read_piece(value: Any) -> Piece:
    """The shape of one piece."""
    kind = value[0] if isinstance(value, list) and value else ""
    require(isinstance(kind, str) and kind in POINTS, f"unknown piece {value!a:.50}")
    arguments, length, values = value[1:], POINTS[kind], VALUES.get(kind, ())
    require(len(arguments) == length + bool(values), f"a piece {kind} has {len(arguments)} arguments")
    points = [rational(point) for point in arguments[:length]]
    last = one_of(arguments[length], values, f"the last entry of a piece {kind}") if values else 0
    start: Any = points[0] if points else -INFINITY
    end: Any = points[-1] if points else INFINITY
    if kind == "left":
        start = -INFINITY
    if kind == "right":
        end = INFINITY
    if kind == "taylor":
        start = Fraction(0)
    require(start < end, f"a piece {kind} does not go from left to right")
    return Piece(start, end, kind, points, last)


def read_column(line: bytes) -> Column:
    """One column and its place in a cell."""
    beta, pieces = entries(read_line(line), "a column", "beta", "pieces")
    require(isinstance(beta, list) and len(beta) == 2 and isinstance(pieces, list), "a column has not its two lists")
    end = rational(beta[1])
    if beta[0] == "-inf":
        require(pieces == [["laplace"]], "a column that begins at -inf is not the piece laplace alone")
        start: Any = -INFINITY
        cell = -1
    else:
        start = rational(beta[0])
        is_integer = start == end and start.denominator == 1
        cell = math.floor(start) - 2 if is_integer else math.floor(start) - 1
    require(start <= end, f"the column {beta!a:.50} ends before it begins")
    require(end <= cell + 2 or end <= 1, f"the column {beta!a:.50} crosses an integer")
    return Column(start, end, cell, [read_piece(piece) for piece in pieces])


def read_certificate(data: bytes, limits: Limits) -> tuple[int, Any, list[Column]]:
    """The version, the statement and the columns."""
    lines = read_lines(data, limits)
    number, pages, statement = read_header(lines[0])
    version = one_of(number, tuple(HYPOTHESES), "the version")
    require(pages == HYPOTHESES[version], "the hypotheses are not the pages that this checker knows")
    return version, statement, [read_column(line) for line in lines[1:]]


class ColumnCheck(Theta):
    """One column: what its pieces give, within a budget of work."""

    def __init__(self, column: Column, limits: Limits, budget: int) -> None:
        super().__init__(limits, budget)
        self.column = column

    def begin(self, start: Any, end: Any, points: Sequence[Fraction] = ()) -> None:
        """The pieces cover [start, end]; the limits in β and τ; a heuristic first accuracy."""
        column = self.column
        check_cover(column.pieces, start, end, "pieces")
        distances = [*map(abs, points), *(abs(x) for piece in column.pieces for x in piece.points)]
        if distances:
            self.limits.keep("beta", max(abs(column.start), abs(column.end)))
            self.limits.keep("tau", max(distances))
            right = max([0, *points, *(x for piece in column.pieces for x in piece.points)])
            self.bits = min(12 + int(0.2 * float(right) ** 1.5 + 0.6 * float(max(column.end, 0))), self.limits.bits)

    def left_holds(self, low: Fraction, high: Fraction, cell: int, x: Fraction) -> bool:
        """The hypothesis of tails.md, τ → -∞, in units of 2^-256: its greater side from above, the other from below."""
        if low < -1 or x <= 0:
            return False
        n = 3 * max(1, cell // 3 + 1)
        factors = [math.ceil(max(abs(low - i), abs(high - i)) * 2**256) for i in range(n)]
        left = self.meter.product((math.floor(x * 2**256), n), (3, n // 3), (math.factorial(n // 3), 1))
        return left > self.meter.product(*((factor, 1) for factor in factors))

    def right_signs(self, box: Box, n: int) -> list[int]:
        """The certain signs of c_0, ..., c_n, (-1)^(n+1) (tails.md); one between opposite signs may be open."""
        for splits in (0, 3):
            signs = [*(self.sign(box, k, splits) for k in range(n + 1)), (-1) ** (n + 1)]
            if all(sign or (k and signs[k - 1] * signs[k + 1] == -1) for k, sign in enumerate(signs)):
                return [sign for sign in signs if sign]
        return []

    def fold_holds(self, box: Box) -> bool:
        """The hypotheses of fold.md beyond its place; ∂F/∂b with a weight, on a wider range of b (section 4)."""
        low, high, start, end = box
        wide = (low, max(high, low + Fraction(1, 256)), start, end)
        return (
            self.sign((low, high, start, start), 0) == 1
            and self.sign((low, high, end, end), 0) == 1
            and self.sign(box, 2) == 1
            and self.sign(wide, -1) == 1
        )

    def piece_sign(self, piece: Piece) -> int:
        """Check the hypotheses of a piece. The sign of F that it gives at its ends, or 0 for a piece monotone."""
        start, end, kind, points, value = piece
        column = self.column
        low, high, cell = column.start - 1, column.end - 1, column.cell
        require(kind not in ("level", "dip"), f"a piece {kind} gives no sign")
        name = f"the piece {kind} from τ = {start!s:.50} to {end!s:.50} of the column from β = {column.start!s:.50}"
        if kind in ("laplace", "taylor"):
            require(high <= 0, f"{name} needs b ≤ 0")
            return 1
        require(high > 0 or kind in ("left", "sign"), f"{name} is not allowed for b ≤ 0")
        if kind == "left":
            require(self.left_holds(low, high, cell, -points[0]), f"{name}: the remainder is too large")
            return 1
        box = (low, high, points[0], points[-1])
        if kind == "right":
            signs = self.right_signs(box, cell)
            require(signs, f"{name}: the signs of c_0, ..., c_{cell} are not confirmed {self.limits.effort()}")
            changes = sum(a != b for a, b in pairwise(signs))
            require(changes == value, f"{name}: {changes} changes of sign, not {value}")
            return signs[0]
        if kind == "fold":
            at_an_end = 0 in (column.start % 3, column.end % 3)
            require(start < 0 < end and at_an_end, f"{name} is not around τ = 0 at β = 3, 6, 9, ...")
            require(self.fold_holds(box), f"{name}: a hypothesis of the fold is not confirmed {self.limits.effort()}")
            return 1
        sign_on_box = self.sign(box, 0 if kind == "sign" else 1)
        require(sign_on_box, f"{name}: no sign is confirmed {self.limits.effort()}")
        if kind == "hinge":
            require(0 in points, f"{name} does not begin or end at τ = 0")
            sign = sign_on_box if start == 0 else -sign_on_box
            require(sign == (-1 if cell % 3 == 1 else 1), f"{name}: F(0, b) has the other sign")
            return sign
        require(sign_on_box == value, f"{name}: the sign is {sign_on_box}, not {value}")
        return sign_on_box if kind == "sign" else 0
