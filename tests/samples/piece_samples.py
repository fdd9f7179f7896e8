"""Points of a piece at which ``evaluate`` must agree with what the piece says: another route to every sign."""

from __future__ import annotations

import random

from flint import fmpq

from gspot_verified.numbers.balls import sign_of
from gspot_verified.signs.cover.pieces import Column, ColumnPiece, Kind, cell_of, fold_integer
from gspot_verified.theta_function.value.evaluate import evaluate


def sign_of_f(tau: fmpq, b: fmpq, derivative: int = 0) -> int | None:
    """The sign of F, F' or F'' at one point, F = Theta(., b)."""
    value = evaluate(tau, b, derivative=derivative, digits=5).value
    assert value.is_finite()
    return sign_of(value)


def between(lower: fmpq, upper: fmpq, source: random.Random) -> fmpq:
    """A number of [lower, upper], the ends often."""
    return lower + (upper - lower) * fmpq(source.choice((0, 64, *range(65))), 64)


def assert_column(column: Column, lower: fmpq | None, upper: fmpq | None, seed: int = 1) -> None:
    """The pieces follow each other without a gap, cover [lower, upper], and each one agrees with ``evaluate``."""
    first, last = column.pieces[0], column.pieces[-1]
    assert first.lower is None or (lower is not None and first.lower <= lower)
    assert last.upper is None or (upper is not None and last.upper >= upper)
    for piece, following in zip(column.pieces, column.pieces[1:], strict=False):
        assert piece.upper == following.lower
    source = random.Random(seed)
    for piece in column.pieces:
        for _ in range(3):
            assert_piece(piece, column, source)


def assert_piece(piece: ColumnPiece, column: Column, source: random.Random) -> None:
    """One random point of the piece."""
    low = column.upper - 3 if column.lower is None else column.lower
    b = between(low, column.upper, source) - 1
    start = piece.lower if piece.lower is not None else (piece.upper or fmpq(0)) - 20
    end = piece.upper if piece.upper is not None else start + 20
    assert start < end
    tau = between(start, end, source)
    n = -2 if column.lower is None else cell_of(column.lower, column.upper)
    match piece.kind:
        case Kind.LAPLACE | Kind.TAYLOR | Kind.LEFT:
            assert sign_of_f(tau, b) == 1
        case Kind.SIGN:
            assert sign_of_f(tau, b) == piece.mark
        case Kind.MONOTONE:
            # In beta: F' = Theta'(., beta - 1), and dTheta/dtau = -beta F, so its derivative has the sign -F'.
            assert sign_of_f(tau, b, 1) == piece.mark
            assert sign_of_f(tau, b + 1, 2) == -piece.mark
        case Kind.FOLD:
            assert start < 0 < end
            assert sign_of_f(tau, b, 2) == 1
            assert sign_of_f(start, b) == sign_of_f(end, b) == 1
            integer = fold_integer(low, column.upper)
            assert integer in (low - 1, column.upper - 1)
            if b != integer:
                assert sign_of_f(fmpq(0), b) == (1 if b > integer else -1)
        case Kind.HINGE:
            assert 0 in (start, end)
            sign = -1 if n % 3 == 1 else 1
            if tau != 0:
                assert sign_of_f(tau, b) == sign
            assert sign_of_f(tau, b, 1) == (sign if start == 0 else -sign)
        case Kind.RIGHT:
            last = (-1) ** (n + 1)
            assert sign_of_f(start, b) == (-last if piece.mark else last)
            if not piece.mark:
                assert sign_of_f(tau, b) == last
