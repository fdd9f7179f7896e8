"""Sums over products of the terms of two series, for every order n at once.

A sum is the total of left_i right_j over k = first, ..., last, where i, j, first, last are formulas in n and k. Two
ways to see which products occur: the set of pairs (i, j), and the sum for the geometric series left_i = x^i,
right_j = y^j. No product is lost there: different pairs have different monomials x^i y^j.
"""

from __future__ import annotations

from collections.abc import Mapping

from flint import fmpq_mpoly

from gspot_verified.paper.checks.identities import Algebra

NAMES = ("left", "right", "first", "last")
_GEOMETRIC = Algebra("x y X Y")
_SHIFT = 16
"""Exponents may be negative: every monomial is multiplied by one with this exponent, in x, y, x^n and y^n."""

Sum = Mapping[str, fmpq_mpoly]
Exponents = tuple[int, int]
"""(a, c) for the exponent a n + c."""


def all_pairs(algebra: Algebra, of: Sum, least: int) -> list[fmpq_mpoly]:
    """Zero when k runs once through all pairs (i, j) with i + j = n, i >= ``least``, j >= 0.

    j = k in all of it, from 0 (k = first) to n - least (where i = least), and i + j = n: these are identities in n, k.
    """
    at_first = {"k": of["first"]}
    at_last = {"k": of["last"]}
    return [
        of["left"] + of["right"] - algebra.symbols["n"],
        of["right"].derivative("k") - 1,
        algebra.substitute(of["right"], at_first),
        algebra.substitute(of["left"], at_last) - least,
    ]


def product_of_geometric_series(algebra: Algebra, of: Sum, least: int) -> list[fmpq_mpoly]:
    """Zero when the sum, for x^i and y^j, is the coefficient of delta^n in a product of two geometric series.

    1/((1 - x delta)(1 - y delta)) has the coefficient C = (x^(n+1) - y^(n+1))/(x - y). With ``least`` = 1 the term
    i = 0 is not in the sum: there it is C - y^n. X and Y are x^n and y^n, so the answer is for every n.
    """
    found = [_read(algebra, of[name], allowed) for name, allowed in zip(NAMES, ("nk", "nk", "n", "n"), strict=True)]
    if any(value is None for value in found):
        return [_GEOMETRIC.constant(1)]
    left, right, first, last = (value for value in found if value is not None)
    step_x, step_y = left["k"], right["k"]
    if max(abs(v) for row in found if row for v in row.values()) > 3 or step_x == step_y == 0:
        return [_GEOMETRIC.constant(1)]

    def term(k: dict[str, int], later: int) -> fmpq_mpoly:
        """x^left y^right at k + later."""
        exponents = [(row["n"] + row["k"] * k["n"], row[""] + row["k"] * (k[""] + later)) for row in (left, right)]
        return _monomial(exponents[0], exponents[1])

    # S (1 - q) = term(first) - term(last + 1), where q is the quotient of neighbours.
    one, quotient = _monomial((0, 0), (0, 0)), _monomial((0, step_x), (0, step_y))
    telescoped = term(first, 0) - term(last, 1)
    x, y, big_x, big_y = (_GEOMETRIC.symbols[name] for name in ("x", "y", "X", "Y"))
    whole = x * big_x - y * big_y - (x - y) * (big_y if least else 0)
    return [(x - y) * telescoped - whole * (one - quotient)]


def _monomial(x: Exponents, y: Exponents) -> fmpq_mpoly:
    symbols = _GEOMETRIC.symbols
    powers = {"X": x[0], "x": x[1], "Y": y[0], "y": y[1]}
    total = _GEOMETRIC.constant(1)
    for name, power in powers.items():
        total *= symbols[name] ** (power + _SHIFT)
    return total


def _read(algebra: Algebra, value: fmpq_mpoly, allowed: str) -> dict[str, int] | None:
    """The integer coefficients of n, k and 1 in an index; ``None`` when it has anything else."""
    coefficients: dict[str, int] = {"n": 0, "k": 0, "": 0}
    names = list(algebra.symbols)
    for exponents, number in value.terms():
        used = [(name, power) for name, power in zip(names, exponents, strict=True) if power]
        name = used[0][0] if used else ""
        if len(used) > 1 or (used and used[0][1] != 1) or (name and name not in allowed) or number.q != 1:
            return None
        coefficients[name] = int(number.p)
    return coefficients
