"""Ledger of Section 1: what a positive definite mass matrix says of A, B and C.

By virtual work the forces λ_T and λ_N act along the gradients t and n of the coordinates x and y of the contact point:
M q'' = Q + t λ_T + n λ_N. So A = <t, t>, B = <t, n>, C = <n, n> with the inner product of M^-1 (u' = t.q'' + ...).
"""

from __future__ import annotations

from flint import fmpq_mpoly

from gspot_verified.paper.checks.entry import Builders, Entry, Rung, Section, all_of
from gspot_verified.paper.checks.identities import Algebra, rising_signs

SECTION = Section("Section 1")
ALGEBRA = Algebra("A B C a h k t1 t2 t3 n1 n2 n3 m11 m12 m13 m22 m23 m33")
_SYMBOLS = ALGEBRA.symbols
GRAM = {"A": ("t", "t"), "B": ("t", "n"), "C": ("n", "n")}
"""The coefficients of the projected equations as inner products."""
THIRD = "A*C - B^2"
"""The third quantity."""
NORMAL = {"t": "k", "h": "1+0*k"}
"""n = k t + h with h orthogonal to t; h is not 0, as n and t are independent."""
MASS = {2: (("m11", "m12"), ("m12", "m22")), 3: (("m11", "m12", "m13"), ("m12", "m22", "m23"), ("m13", "m23", "m33"))}


def third(found: dict[str, fmpq_mpoly]) -> fmpq_mpoly:
    """A C - B² of given A, B, C."""
    return ALGEBRA.substitute(ALGEBRA.read(THIRD), found)


def split() -> dict[str, fmpq_mpoly]:
    """A, B, C by a = <t, t> > 0, h = <h, h> > 0, <t, h> = 0."""
    parts = {"t": {"t": ALGEBRA.constant(1)}, "n": {name: ALGEBRA.read(text) for name, text in NORMAL.items()}}
    squares = {"t": _SYMBOLS["a"], "h": _SYMBOLS["h"]}
    zero = ALGEBRA.constant(0)
    return {
        name: sum((parts[x].get(e, zero) * parts[y].get(e, zero) * square for e, square in squares.items()), start=zero)
        for name, (x, y) in GRAM.items()
    }


def positive_by_projection() -> bool | None:
    """Whether A, C and A C - B² are positive for every a, h > 0 and every k: k > 0, k < 0 and k = 0."""
    found = split()
    wanted = (found["A"], found["C"], third(found))
    images = (_SYMBOLS["k"], -_SYMBOLS["k"], ALGEBRA.constant(0))
    return all(rising_signs(ALGEBRA.substitute(value, {"k": image})) for value in wanted for image in images)


def vanishes_if_dependent() -> bool | None:
    """Whether A C - B² is 0 for n = k t (h = 0) and for t = 0 (a = 0)."""
    value = third(split())
    return all(ALGEBRA.substitute(value, {name: ALGEBRA.constant(0)}).is_zero() for name in "ha")


def sum_of_squares() -> bool | None:
    """Whether A C - B² is the sum of (t_i n_j - t_j n_i)² over the pairs i < j, where M is the identity.

    M = L L^T makes it so, with L^-1 t and L^-1 n for t and n. D = A C - B² is a quadratic form of (A, B, C), and that
    is the sum of the x_i of the single places: D is the sum of D(x_i) = 0 and, over the pairs, of D(x_i + x_j) -
    D(x_i) - D(x_j). So one place and two places show it in any dimension.
    """
    vectors = {name: [_SYMBOLS[f"{name}{i}"] for i in (1, 2)] for name in "tn"}

    def at(*places: int) -> dict[str, fmpq_mpoly]:
        zero = ALGEBRA.constant(0)
        return {name: sum((vectors[x][i] * vectors[y][i] for i in places), start=zero) for name, (x, y) in GRAM.items()}

    quadratic = all(sum(exponents) == 2 for exponents, _ in ALGEBRA.read(THIRD).terms())
    (t_1, t_2), (n_1, n_2) = vectors["t"], vectors["n"]
    square = (t_1 * n_2 - t_2 * n_1) ** 2
    return bool(quadratic and third(at(0)).is_zero() and (third(at(0, 1)) - square).is_zero())


def squares_of_length() -> bool | None:
    """Whether A and C are sums of squares there, of the entries of t and of n."""
    return GRAM["A"] == ("t", "t") and GRAM["C"] == ("n", "n")


def _adjugate(rows: list[list[fmpq_mpoly]]) -> list[list[fmpq_mpoly]]:
    def minor(i: int, j: int) -> list[list[fmpq_mpoly]]:
        return [[*row[:i], *row[i + 1 :]] for k, row in enumerate(rows) if k != j]

    size = range(len(rows))
    return [[(-1) ** (i + j) * ALGEBRA.determinant(minor(i, j)) for j in size] for i in size]


def by_the_mass_matrix(dimension: int) -> bool | None:
    """Whether (A C - B²) det M = w^T M w with w = t x n in dimension 3, and (t_1 n_2 - t_2 n_1)² in dimension 2."""
    mass = [[_SYMBOLS[name] for name in row] for row in MASS[dimension]]
    inverse, determinant = _adjugate(mass), ALGEBRA.determinant(mass)
    vectors = {name: [_SYMBOLS[f"{name}{i + 1}"] for i in range(dimension)] for name in "tn"}
    places = [(i, j) for i in range(dimension) for j in range(dimension)]
    zero = ALGEBRA.constant(0)
    found = {
        name: sum((vectors[x][i] * inverse[i][j] * vectors[y][j] for i, j in places), start=zero)
        for name, (x, y) in GRAM.items()
    }  # times det M
    t, n = vectors["t"], vectors["n"]
    if dimension == 2:
        return bool((third(found) - determinant * (t[0] * n[1] - t[1] * n[0]) ** 2).is_zero())
    w = [t[i - 2] * n[i - 1] - t[i - 1] * n[i - 2] for i in range(3)]
    form = sum((w[i] * mass[i][j] * w[j] for i, j in places), start=zero)
    return bool((third(found) - determinant * form).is_zero())


def _mass_matrix() -> Entry:
    return SECTION.settled(
        "1-mass-matrix",
        "lines 149 to 152",
        r"A>0,\quad C>0,\quad AC-B^2>0",
        "For every positive definite mass matrix, of any size, A, C and AC - B² are positive where the gradients of "
        "the tangential and of the normal coordinate of the contact point are linearly independent; where they are "
        "not, AC - B² is 0",
        Rung.EXACT.check(
            "n = k t + h, h orthogonal to t in the inner product of the inverse mass matrix: A = <t, t>, "
            "C = k² A + <h, h>, AC - B² = A <h, h>",
            all_of([positive_by_projection(), vanishes_if_dependent()]),
        ),
        Rung.EXACT.check(
            "where the mass matrix is the identity: A and C are sums of squares, and AC - B² that of the minors "
            "t_i n_j - t_j n_i, pair by pair in any dimension",
            all_of([squares_of_length(), sum_of_squares()]),
        ),
        Rung.POINTS.check(
            "with 2 and 3 degrees of freedom and every mass matrix M: (AC - B²) det M is the square of the minor, and "
            "the form of M at the cross product of t and n",
            all_of(by_the_mass_matrix(dimension) for dimension in MASS),
        ),
        note="The paper does not state the independence; it means that the contact point can slide and lift off "
        "independently.",
    )


ENTRIES: Builders = {"1-mass-matrix": _mass_matrix}
"""The signs of A, C and AC - B²."""
