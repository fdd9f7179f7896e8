"""Short certificates of the right form that ask the checker for as much work and memory as they can."""

from __future__ import annotations

from fractions import Fraction
from itertools import pairwise

from must_reject.mutate import lines_of, text_of

DEEP = 10**1999 + 7  # denominators as long as the format allows, after a sum of two of them


def sign(beta: str, tau: str, *columns: tuple[list[str], list[object]], value: int = -1) -> bytes:
    return text_of(lines_of({"beta": beta, "kind": "sign", "sign": value, "tau": tau}, *columns))


def zeros(beta: str, counts: list[list[int]], *columns: tuple[list[str], list[object]]) -> bytes:
    return text_of(lines_of({"beta": beta, "counts": counts, "kind": "zeros"}, *columns))


def far_left_in_each_cell(first: int, last: int) -> bytes:
    """One piece of width 2^-60 next to τ = -200 in each cell."""
    end = -200 + Fraction(1, 2**60)
    columns = [([str(n), str(n + 1)], [["sign", "-200", str(end), 1]]) for n in range(first, last)]
    return sign(f"({first}, {last})", f"(-200, {end})", *columns)


def far_right_in_each_cell(first: int, last: int, width: Fraction) -> bytes:
    """One piece that ends at τ = 200 in each cell."""
    start = 200 - width
    columns = [([str(n), str(n + 1)], [["sign", str(start), "200", 1]]) for n in range(first, last)]
    return sign(f"({first}, {last})", f"({start}, 200)", *columns)


def widest_piece(beta: str, low: str, high: str) -> bytes:
    """One piece from -200 to 200."""
    return sign(beta, "(-200, 200)", ([low, high], [["sign", "-200", "200", 1]]))


def below_zero(low: int) -> bytes:
    """A column as wide as there is."""
    return sign(f"[{low}, 0)", "[-3, 3]", ([str(low), "0"], [["sign", "-3", "3", 1]]), value=1)


def nearly_equal_columns(number: int, beta: int) -> bytes:
    """Columns whose ends differ in the last of 1,999 digits, each with a tail on the right."""
    ends = [str(beta + Fraction(k + 1, DEEP)) for k in range(number + 1)]
    columns = [([low, high], [["right", "200", 0]]) for low, high in pairwise(ends)]
    return sign(f"[{ends[0]}, {ends[-1]}]", "(200, inf)", *columns)


def deep_pieces(number: int, beta: str, deep: int) -> bytes:
    """Pieces next to each other at points with long denominators."""
    points = [str(Fraction(deep // 3 + k, deep)) for k in range(number + 1)]
    pieces: list[object] = [["sign", low, high, 1] for low, high in pairwise(points)]
    return sign(f"[{beta}, {beta}]", f"({points[0]}, {points[-1]})", ([beta, beta], pieces))


def deep_left(number: int, deep: int) -> bytes:
    """Tails on the left whose threshold and columns have long denominators."""
    ends = [str(200 - Fraction(number - k, deep)) for k in range(number + 1)]
    tail = str(-199 - Fraction(deep // 7, deep))
    columns = [([low, high], [["left", tail]]) for low, high in pairwise(ends)]
    return sign(f"[{ends[0]}, {ends[-1]}]", f"(-inf, {tail})", *columns)


def deep_integer(deep: int) -> bytes:
    """The integer polynomial at β = 200 at a point with a long denominator."""
    point = Fraction(deep // 3, deep)
    return sign("[200, 200]", f"[{point}, {point}]", value=1)


def right_tail(beta: str, tau: str, value: int) -> bytes:
    """All coefficients of a cell far out."""
    end = str(Fraction(beta) + Fraction(1, 64))
    return sign(f"({beta}, {end})", f"({tau}, inf)", ([beta, end], [["right", tau, value]]))


def deep_right(deep: int) -> bytes:
    """All coefficients of a cell at one point; it and β have long denominators and are used as they are."""
    beta, tau = str(Fraction(21, 2) + Fraction(1, deep)), str(20 + Fraction(1, deep))
    return sign(f"[{beta}, {beta}]", f"[{tau}, inf)", ([beta, beta], [["right", tau, 0]]))


def exact_zero() -> bytes:
    """A piece on both sides of the zero τ = 0 at β = 2: no accuracy is enough."""
    return sign("[2, 2]", "(-1, 1)", (["2", "2"], [["sign", "-1", "1", 1]]))


def widest_fold(beta: int) -> bytes:
    """A fold that reaches over the whole range."""
    end = str(beta + Fraction(1, 2))
    return sign(f"({beta}, {end})", "(-200, 200)", ([str(beta), end], [["fold", "-200", "200"]]))


def many_brackets(number: int) -> bytes:
    """Many brackets, and pieces that hold no zero."""
    pairs = [[str(Fraction(k, number)), str(Fraction(2 * k + 1, 2 * number))] for k in range(number)]
    column = (["1/2", "1/2"], [["laplace"]])
    return text_of(lines_of({"beta": "1/2", "brackets": pairs, "kind": "brackets"}, column))


def deep_brackets(digits: int) -> bytes:
    """One bracket as narrow as the format allows, around the zero at β = 3/2."""
    start = Fraction(10**digits // 2, 10**digits)
    pair = [str(start), str(start + Fraction(1, 10**digits))]
    pieces = [["left", "-5/8"], ["sign", "-5/8", "0", 1], ["monotone", "0", "3/2", -1], ["right", "3/2", 0]]
    column = (["3/2", "3/2"], pieces)
    return text_of(lines_of({"beta": "3/2", "brackets": [pair], "kind": "brackets"}, column))


def many_columns(number: int, tail: str) -> bytes:
    """As many columns as the limit on lists allows, each one short."""
    ends = [str(5 + Fraction(k, number)) for k in range(number + 1)]
    columns = [([low, high], [["left", tail]]) for low, high in pairwise(ends)]
    return sign("(5, 6)", f"(-inf, {tail})", *columns)


SHORT = {
    "far left in each cell": far_left_in_each_cell(11, 22),
    "far left in all cells": far_left_in_each_cell(1, 200),
    "far right in each cell": far_right_in_each_cell(1, 200, Fraction(1, 2**60)),
    "far right, wide": far_right_in_each_cell(1, 9, Fraction(1)),
    "widest piece": widest_piece("(3, 4)", "3", "4"),
    "widest piece, large β": widest_piece("(199, 200)", "199", "200"),
    "widest piece at a point": widest_piece("[5/2, 5/2]", "5/2", "5/2"),
    "below zero": below_zero(-200),
    "nearly equal columns": nearly_equal_columns(20, 7),
    "deep pieces": deep_pieces(20, "7/2", DEEP),
    "deep pieces, deep β": deep_pieces(5, str(Fraction(7, 2) + Fraction(1, DEEP)), DEEP),
    "deep left": deep_left(20, DEEP),
    "deep integer": deep_integer(10**3998 + 7),
    "right tail": right_tail("199", "200", 0),
    "right tail at an integer": right_tail("100", "60", 1),
    "exact zero": exact_zero(),
    "widest fold": widest_fold(198),
    "deep brackets": deep_brackets(3000),
}
"""Files of at most 200 kB, most of them under 2 kB."""

LONG = {
    "many brackets": lambda: many_brackets(99_000),
    "many columns": lambda: many_columns(60_000, "-200"),
    "many pieces": lambda: deep_pieces(180_000, "7/2", 10**30 + 57),
    "many deep columns": lambda: nearly_equal_columns(2_400, 7),
}
"""Files up to the limit of the size."""
