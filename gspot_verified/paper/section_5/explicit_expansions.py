"""Theorem 1 and its lemma on explicit nonlinear systems, for the ledger: spaces, equations, conditions.

A shift (e, o) says: the term of order n = 2 nu is in P_(nu + e), that of order n = 2 nu + 1 in P_(nu + o).
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

from flint import fmpq, fmpq_poly

from gspot_verified.expansion.series.recursion import Recursion
from gspot_verified.expansion.series.spaces import NoCommonSpace, SpacePolynomial
from gspot_verified.expansion.series.system import System
from gspot_verified.expansion.series.terms import PolynomialTerms
from gspot_verified.functions.convolution import Series, TermByTerm, Weights
from gspot_verified.functions.expressions import Constant, Exponential, Expression, Power, Product, Sine, Sum, Variable
from gspot_verified.functions.power_series import SeriesOfFunctions
from gspot_verified.functions.rings import RATIONALS
from gspot_verified.paper.checks.identities import Algebra

Shift = tuple[int, int]
SPACES: dict[str, Shift] = {
    "p": (1, -3), "b": (1, -3), "xi": (1, -3), "y": (0, -1), "z": (0, -1), "v": (-1, -2), "lambda_n": (0, -4),
}  # fmt: skip
"""Theorem 1, lines 1511 to 1521."""
LEMMA: dict[str, Shift] = {"f": (0, -4)}
"""Lemma thm:expansion: the terms f_n of a function of xi."""


def _number(value: int | fmpq) -> Expression:
    return Constant(fmpq(value))


def random_systems() -> list[System]:
    """Systems in the coordinates (p, b, y, v, w): there any alpha_1, alpha_2, alpha_3 have the form of Sec. 5."""
    p, b, y, v, w = (Variable(i) for i in range(5))
    choices = (
        (_number(-1) + b + p * w, _number(-1) + y + w, _number(fmpq(-3, 2)) + b + w * w, b + w, p + _number(2)),
        (_number(-2) + Sine(w), _number(3) - Exponential(p), _number(-5) + b * b + v, _number(1) + p, w - b),
        (_number(-3) + Power(_number(1) + w + y, fmpq(-1)), _number(fmpq(1, 2)) - w, _number(-1) - b, w, _number(1)),
    )
    return [
        System(
            name=f"random {i}",
            F=(first, second, v, b, drift),
            G=(_number(0), -third, _number(0), p, control),
            y=y,
            v=v,
            p=p,
            b=b,
            alpha_1=first,
            alpha_2=second,
            alpha_3=third,
            J=(w,),
            point=(fmpq(0),) * 5,
        )
        for i, (first, second, third, drift, control) in enumerate(choices)
    ]


def recursions(orders: int = 12) -> list[Recursion]:
    """The terms n < orders of the random systems; p and λ_N have no odd ones before the order 9."""
    found = []
    for system in random_systems():
        recursion = Recursion(system)
        for _ in range(orders):
            recursion.advance()
        found.append(recursion)
    return found


def rows_of(recursion: Recursion) -> list[tuple[str, list[list[fmpq]]]]:
    """The coefficients of s^0, s^1, ... of the terms of each variable, and of each component of ξ."""
    found = [(name, [term.coefficients() for term in getattr(recursion, name)]) for name in SPACES if name != "xi"]
    return found + [("xi", [term[i].coefficients() for term in recursion.xi]) for i in range(len(recursion.xi[0]))]


def outside_their_spaces(rows: Iterable[tuple[str, Sequence[Sequence[Any]]]]) -> list[str]:
    """The terms, by name and order, that are not in the spaces of ``SPACES``."""
    found = []
    for name, terms in rows:
        for n, coefficients in enumerate(terms):
            index = n // 2 + SPACES[name][n % 2]
            powers = [k for k, value in enumerate(coefficients) if value != 0]
            if any(k > index or (index - k) % 3 for k in powers):
                found.append(f"{name} of the order {n}")
    return found


def equations_hold(recursion: Recursion) -> bool:
    """Eqs. specialX to specialL and pbc for all terms found, by ordinary polynomials and no step of the recursion."""
    terms = len(recursion.p)
    rests = residuals(recursion, terms, terms)
    return all(value.is_zero() for row in rests for value in row) and all(plain(term)[0] == 0 for term in recursion.p)


def residuals(recursion: Recursion, terms: int, orders: int) -> list[list[fmpq_poly]]:
    """The coefficients of delta^n, n < orders, of specialX to specialL for the sums of the first ``terms`` terms."""
    zero = fmpq_poly([])

    def row(found: list[SpacePolynomial]) -> list[fmpq_poly]:
        return [plain(term) for term in found[:terms]] + [zero] * (orders - terms)

    series = {name: row(getattr(recursion, name)) for name in SPACES if name != "xi"}
    system = recursion.system
    state = [row([term[i] for term in recursion.xi]) for i in range(len(system.point))]
    values = SeriesOfFunctions(
        (*system.F, *system.G, system.alpha_1, system.alpha_2, system.alpha_3), _Plain(), RATIONALS
    )
    for n in range(orders):
        values.extend([zero if n < 2 else component[n - 2] for component in state])
    force = series["lambda_n"]

    def product_term(left: list[fmpq_poly], n: int) -> fmpq_poly:
        return sum((left[n - k] * force[k] for k in range(n + 1)), start=zero)

    found = []
    for n in range(orders):
        z_before = series["z"][n - 1].derivative() if n else zero
        found.append([
            series["p"][n].derivative() - values[system.alpha_1][n],
            series["b"][n].derivative() - values[system.alpha_2][n] + product_term(values[system.alpha_3], n),
            series["y"][n].derivative() - series["v"][n],
            series["v"][n].derivative() - series["b"][n] - product_term(series["p"], n),
            z_before + series["z"][n] + force[n],
            force[n] - series["z"][n] + series["y"][n],
            *(
                component[n].derivative() - values[f][n] - product_term(values[g], n)
                for component, f, g in zip(state, system.F, system.G, strict=True)
            ),
        ])  # fmt: skip
    return found


def right_sides(recursion: Recursion) -> dict[str, list[list[fmpq_poly]]]:
    """r_b, r_v, r and the components of r_ξ, by the orders: the left sides of their equations, without the sums."""
    system = recursion.system
    at = SeriesOfFunctions((system.alpha_1, system.alpha_3), _Plain(), RATIONALS)
    at.extend([fmpq_poly([])] * len(system.point))
    first, third = (at[f][0] for f in (system.alpha_1, system.alpha_3))
    s = fmpq_poly([0, 1])
    b, v, force = ([plain(term) for term in getattr(recursion, name)] for name in ("b", "v", "lambda_n"))
    return {
        "r_b": [[u.derivative() + third * w for u, w in zip(b, force, strict=True)]],
        "r_v": [[u.derivative() - c - first * s * w for u, c, w in zip(v, b, force, strict=True)]],
        "r": [[2 * u.derivative().derivative().derivative() + first * s * u.derivative() - third * u for u in b]],
        "r_xi": [[plain(term[i]).derivative() for term in recursion.xi] for i in range(len(system.point))],
    }


def synchronised(recursion: Recursion) -> bool:
    """The components p, b, y, v of xi~ are p~, b~, delta^4 y~, delta^2 v~ for every s, and w(0) = 0."""
    rows = [[plain(term[i]) for term in recursion.xi] for i in range(5)]
    places = (("p", 0), ("b", 0), ("y", 4), ("v", 2))
    for row, (name, later) in zip(rows, places, strict=False):
        own = [plain(term) for term in getattr(recursion, name)]
        if any(row[n] != (own[n - later] if n >= later else 0) for n in range(len(row))):
            return False
    return all(value[0] == 0 for value in rows[4])


class _Plain:
    """Ordinary polynomials in s as terms of a series."""

    def constant(self, value: fmpq) -> fmpq_poly:
        return fmpq_poly([value])

    def zero(self, _: int) -> fmpq_poly:
        return fmpq_poly([])

    def scale(self, term: fmpq_poly, factor: fmpq) -> fmpq_poly:
        return term * factor

    def convolution(self, left: Series, right: Series, weights: Weights | None = None) -> TermByTerm:
        return TermByTerm(left, right, self, RATIONALS, weights)

    def is_zero(self, term: fmpq_poly) -> bool:
        return bool(term.is_zero())

    def at_start(self, term: fmpq_poly) -> fmpq:
        return term[0]


def plain(term: SpacePolynomial) -> fmpq_poly:
    """A term as an ordinary polynomial in s."""
    return fmpq_poly(term.coefficients())


def highest_in_a_quartic(orders: int = 8, scale: int = 2) -> dict[int, int]:
    """By n: the highest k with ξ_k in f_n, f = c0 + c1 u + ... + c4 u^4 at u = sum of xi_k delta^(k + scale).

    Only where f_n holds some ξ_k, the highest one times c1 alone; otherwise -1.
    """
    algebra = Algebra("delta c0 c1 c2 c3 c4 " + " ".join(f"x{k}" for k in range(orders)))
    delta = algebra.symbols["delta"]
    u = sum((algebra.symbols[f"x{k}"] * delta ** (k + scale) for k in range(orders)), start=algebra.constant(0))
    f = sum((algebra.symbols[f"c{j}"] * u**j for j in range(5)), start=algebra.constant(0))
    terms = algebra.coefficients(f, "delta")
    found = {}
    for n in range(orders):
        slopes = [terms.get(n, algebra.constant(0)).derivative(f"x{k}") for k in range(orders)]
        held = [k for k, slope in enumerate(slopes) if not slope.is_zero()]
        if held:
            found[n] = held[-1] if slopes[held[-1]] == algebra.symbols["c1"] else -1
    return found


def lemma_on_functions(orders: int = 10) -> bool | None:
    """Nonlinear functions of two components with terms in the spaces of xi: f_n is in its space, linear in xi_(n-2).

    ``None``: with these spaces the terms of one order of a function are in no common one.
    """
    x, w = Variable(0), Variable(1)
    functions: tuple[Expression, ...] = (
        Product(x, w), Sine(x), Exponential(x - w), Power(_number(1) + x, fmpq(-2)), Sum((x * x * w, w)),
    )  # fmt: skip
    slopes = ((0, 0), (1, 0), (1, -1), (-2, 0), (0, 1))
    probe = [_terms(orders, seed) for seed in (1, 2)]
    try:
        found = _series(functions, probe, orders)
    except NoCommonSpace:
        return None
    for f, slope in zip(functions, slopes, strict=True):
        for n in range(orders):
            index = n // 2 + LEMMA["f"][n % 2]
            if any(value != 0 and (k > index or (index - k) % 3) for k, value in enumerate(found[f][n].coefficients())):
                return False
        changed = [[*row[:-1], row[-1] + row[-1]] for row in probe]
        other = _series(functions, changed, orders)
        wanted = plain(probe[0][-1]) * slope[0] + plain(probe[1][-1]) * slope[1]
        if any(found[f][n] != other[f][n] for n in range(orders - 1)):
            return False
        if plain(other[f][orders - 1]) - plain(found[f][orders - 1]) != wanted:
            return False
    return True


def _terms(orders: int, seed: int) -> list[SpacePolynomial]:
    """The terms of orders 0 to orders - 1 of delta^2 xi~ in the spaces of Theorem 1."""
    found = [SpacePolynomial.zero(0), SpacePolynomial.zero(-4)]
    for n in range(orders - 2):
        index = n // 2 + SPACES["xi"][n % 2]
        powers = range(index % 3, index + 1, 3) if index >= 0 else ()
        row = [fmpq(0)] * (index + 1 if index >= 0 else 0)
        for k in powers:
            row[k] = fmpq(3 * seed + k - n, k + seed)
        found.append(SpacePolynomial.from_list(index, list(row)))
    return found


def _series(functions: tuple[Expression, ...], rows: list[list[SpacePolynomial]], orders: int) -> SeriesOfFunctions:
    series = SeriesOfFunctions(functions, PolynomialTerms(RATIONALS), RATIONALS)
    for n in range(orders):
        series.extend([row[n] for row in rows])
    return series
