"""The extended example as a power series in (t, epsilon), from one equation for b: no inner scale, no spaces P_n.

With lambda = (alpha2 - b')/alpha3, p' = alpha1 + chi b, p(0) = 0, the system gives (as in Sec. 4, with this p)
epsilon (b + p lambda)' + (b + p lambda) + 2 epsilon^2 lambda'' + epsilon^3 lambda''' = 0. The coefficient of
t^i epsilon^j determines b_ij, by the factor (alpha3 - i alpha1)/alpha3. Numbers are polynomials in chi.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache

from flint import fmpq, fmpq_mpoly, fmpq_poly

from gspot_verified.paper.checks.identities import Algebra

ALPHA = (fmpq(-1), fmpq(-1), fmpq(-3, 2))
Table = dict[tuple[int, int], fmpq_poly]
"""The coefficient of t^i epsilon^j under (i, j)."""
POWER_OF_DELTA = {"p": 2, "b": 2, "y": 6, "v": 4, "z": 6, "lam": 6}
"""In front of the scaled variables, lines 1385 to 1390; lam stands for epsilon^2 lambda_N."""
_ZERO = fmpq_poly([])


def scaled_series(algebra: Algebra, name: str, orders: int) -> fmpq_mpoly:
    """The terms n < orders of a scaled variable in the symbols s, delta, chi: t^i epsilon^j is
    s^i delta^(2 i + 3 j)."""
    s, delta, chi = (algebra.symbols[symbol] for symbol in ("s", "delta", "chi"))
    tables = example_series(orders + 2)
    table = tables[name] if name != "lam" else _difference(tables["z"], tables["y"])
    total = algebra.constant(0)
    for (i, j), value in table.items():
        n = 2 * i + 3 * j - POWER_OF_DELTA[name]
        if n < orders:
            # A negative n would be a contradiction to the scaling: the power then raises an error.
            in_chi = sum((a * chi**k for k, a in enumerate(value.coeffs())), start=algebra.constant(0))
            total += in_chi * s**i * delta**n
    return total


def _difference(left: Table, right: Table) -> Table:
    """z - y, which is epsilon^2 lambda."""
    return {key: left.get(key, _ZERO) - right.get(key, _ZERO) for key in {**left, **right}}


@lru_cache
def example_series(weight: int) -> dict[str, Table]:
    """The coefficients of b, p, y, v, z with 2 i + 3 j <= weight for b and p, and what they give for y, v, z."""
    first, second, third = ALPHA
    chi = fmpq_poly([0, 1])
    b: Table = {}
    p: Table = {(1, 0): fmpq_poly([first])}
    force: Table = {(0, 0): fmpq_poly([second / third])}

    def moment(i: int, j: int) -> fmpq_poly:
        """The coefficient of b + p lambda, from what is known."""
        total = b.get((i, j), _ZERO)
        for (k, m), value in p.items():
            if k <= i and m <= j:
                total += value * force.get((i - k, j - m), _ZERO)
        return total

    for j in range(weight // 3 + 1):
        for i in range((weight - 3 * j) // 2 + 1):
            rest = moment(i, j)
            if j >= 1:
                rest += (i + 1) * moment(i + 1, j - 1)
            if j >= 2:
                rest += 2 * (i + 1) * (i + 2) * force.get((i + 2, j - 2), _ZERO)
            if j >= 3:
                rest += (i + 1) * (i + 2) * (i + 3) * force.get((i + 3, j - 3), _ZERO)
            # b_ij stands in b, and in alpha1 t lambda through -i b_ij/alpha3.
            value = rest * (-third / (third - i * first))
            if value.is_zero():
                continue
            b[i, j] = value
            p[i + 1, j] = p.get((i + 1, j), _ZERO) + chi * value * fmpq(1, i + 1)
            if i:
                force[i - 1, j] = force.get((i - 1, j), _ZERO) - value * (i / third)
    v, y = _recovered(force, moment, weight)
    z = {key: y.get(key, _ZERO) + force.get((key[0], key[1] - 2), _ZERO) for key in _keys(weight + 4)}
    return {name: {key: a for key, a in table.items() if not a.is_zero()}
            for name, table in (("b", b), ("p", p), ("y", y), ("v", v), ("z", z))}  # fmt: skip


def _recovered(force: Table, moment: Callable[[int, int], fmpq_poly], weight: int) -> tuple[Table, Table]:
    """V = -2 epsilon^2 lambda' - epsilon^3 lambda'' - epsilon (b + p lambda),
    y = -2 epsilon^2 lambda - epsilon^3 lambda' - epsilon v."""
    v: Table = {}
    y: Table = {}
    for i, j in _keys(weight + 4):
        slope, curvature = (
            (i + 1) * force.get((i + 1, j - 2), _ZERO),
            (i + 1) * (i + 2) * force.get((i + 2, j - 3), _ZERO),
        )
        v[i, j] = -2 * slope - curvature - (moment(i, j - 1) if j else _ZERO)
    for i, j in _keys(weight + 4):
        slope = (i + 1) * force.get((i + 1, j - 3), _ZERO)
        y[i, j] = -2 * force.get((i, j - 2), _ZERO) - slope - v.get((i, j - 1), _ZERO)
    return v, y


def _keys(weight: int) -> list[tuple[int, int]]:
    return [(i, j) for j in range(weight // 3 + 1) for i in range((weight - 3 * j) // 2 + 1)]
