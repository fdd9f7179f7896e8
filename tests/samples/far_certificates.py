"""Honest certificates at the ends of the checker's range, built from pieces that are true: the search for them takes
minutes there. The pieces are chosen by signs of ``evaluate``."""

from __future__ import annotations

from itertools import pairwise

from flint import fmpq

from gspot_verified.certificates.text import certificate_text
from gspot_verified.numbers.balls import sign_of
from gspot_verified.signs.cover.pieces import Column, ColumnPiece, Kind
from gspot_verified.signs.cover.statements import BracketsStatement, SignStatement
from gspot_verified.theta_function.value.evaluate import evaluate
from gspot_verified.work.ranges import Range

Interval = tuple[fmpq, fmpq]


def sign_certificate(tau: Interval, beta: Interval) -> bytes:
    """One piece over the whole of both ranges; the sign is that in the middle."""
    sign = sign_of_f(sum(tau, fmpq(0)) / 2, sum(beta, fmpq(0)) / 2 - 1)
    ranges = [Range(low, high, low == high, low == high) for low, high in (tau, beta)]
    column = Column(*beta, (ColumnPiece(Kind.SIGN, *tau, sign),))
    return certificate_text(SignStatement(ranges[0], ranges[1], -sign), [column]).encode()


def brackets_certificate(beta: fmpq, left: fmpq, right: fmpq) -> bytes:
    """All zeros at one beta inside (left, right): around each a monotone piece, around each extremum a sign."""
    zeros, extrema = changes(beta - 1, 0, right), changes(beta - 1, 1, right)
    first, last = zeros[0][0] - fmpq(1, 4), zeros[-1][1] + fmpq(1, 4)
    pieces, start = [ColumnPiece(Kind.LEFT, None, left), sign_piece(beta, left, first)], first
    for one, two in pairwise(zeros):
        ((low, high),) = [e for e in extrema if one[1] <= e[0] and e[1] <= two[0]]
        before, after = (one[1] + low) / 2, (high + two[0]) / 2
        pieces += [monotone_piece(beta, start, before), sign_piece(beta, before, after)]
        start = after
    pieces += [
        monotone_piece(beta, start, last),
        sign_piece(beta, last, right),
        ColumnPiece(Kind.RIGHT, right, None, 0),
    ]
    return certificate_text(BracketsStatement(beta, tuple(zeros)), [Column(beta, beta, tuple(pieces))]).encode()


def sign_of_f(tau: fmpq, b: fmpq, derivative: int = 0) -> int:
    sign = sign_of(evaluate(tau, b, derivative=derivative, digits=3).value)
    assert sign in (1, -1)
    return sign


def sign_piece(beta: fmpq, low: fmpq, high: fmpq) -> ColumnPiece:
    return ColumnPiece(Kind.SIGN, low, high, sign_of_f((low + high) / 2, beta - 1))


def monotone_piece(beta: fmpq, low: fmpq, high: fmpq) -> ColumnPiece:
    return ColumnPiece(Kind.MONOTONE, low, high, sign_of_f((low + high) / 2, beta - 1, 1))


def changes(b: fmpq, derivative: int, right: fmpq) -> list[Interval]:
    """Intervals of width 1/64 where F or F' changes its sign, from -2 on."""
    points = [fmpq(k, 8) - fmpq(129, 64) for k in range(int((8 * right).floor()) + 17)]
    signs = [sign_of_f(point, b, derivative) for point in points]
    found = []
    for (low, before), (high, after) in pairwise(zip(points, signs, strict=True)):
        if before != after:
            while high - low > fmpq(1, 64):
                middle = (low + high) / 2
                low, high = (middle, high) if sign_of_f(middle, b, derivative) == before else (low, middle)
            found.append((low, high))
    return found
