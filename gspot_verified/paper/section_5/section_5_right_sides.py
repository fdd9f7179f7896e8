"""Ledger of Section 5: the spaces of the right-hand sides of Theorem 1's steps, and the slow system of the inner scale.

The term of order n = 2ν of a series is in P_(ν + e), that of order n = 2ν + 1 in P_(ν + o): a pair (e, o) for each
series. P_j lies in P_k when k - j is 0, 3, 6, ...; a product of P_j and P_k is in P_(j + k).
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from flint import fmpq_mpoly

from gspot_verified.paper.checks.entry import Builders, Entry, Rung, Section, all_of
from gspot_verified.paper.section_5 import explicit_expansions as explicit
from gspot_verified.paper.section_5 import section_5_recursion
from gspot_verified.paper.section_5.section_5_recursion import ALGEBRA as RECURSION

SECTION = Section("Section 5, Theorem 1")
Pair = tuple[int, int]
SERIES: dict[str, Pair] = {"alpha": (0, -4), "lambda": (0, -4), "p": (1, -3), "z": (0, -1)}
"""The spaces of Theorem 1, and of a function by Lemma 2."""
CLAIMED: dict[str, Pair] = {"r_b": (0, -4), "r_v": (1, -3), "r": (1, -3), "r_xi": (0, -4)}
"""Lines 1622, 1636, 1675 and 1718."""
ORDERS = range(24)
"""n, where the monomials are written out."""
FAST = ("specialZ", "specialL")
"""The equations of the inner scale that are not in the slow system."""
SLOW = {"z0": "y0/2", "lam": "-y0/2"}
"""Lines 2036 and 2045."""
PRINTED: dict[str, dict[str, str]] = {
    "5-inner-slow": {
        "specialX": "xi1 - (f + g*lam)", "specialPP": "p1 - a1", "specialB": "b1 - (a2 - a3*lam)",
        "specialY": "y1 - v0", "specialV": "v1 - (b0 + p*lam)",
    },
}  # fmt: skip
"""Lines 2039 to 2043, each with the equation of the inner scale that it is, F and G read without their tilde."""


def is_part_of(inner: int, outer: int) -> bool:
    """Whether P_inner lies in P_outer for every ν: the difference of the indices does not depend on ν."""
    return outer >= inner and (outer - inner) % 3 == 0


def product_of(first: Pair, second: Pair) -> tuple[list[int], list[int]]:
    """The indices less ν of the products of two terms whose orders have the sum 2ν, and 2ν + 1."""
    even = [first[0] + second[0], first[1] + second[1] - 1]  # two odd orders 2a + 1, 2b + 1: a + b = ν - 1
    return even, [first[0] + second[1], first[1] + second[0]]


def right_sides() -> dict[str, tuple[list[int], list[int]]]:
    """The indices less ν of all parts of r_b, r_v, r and r_ξ; F and G are functions of ξ as the α's are."""
    alpha, force, p, z = (SERIES[name] for name in ("alpha", "lambda", "p", "z"))
    sums_b, sums_v = product_of(alpha, force), product_of(p, force)
    r_b, r_v = CLAIMED["r_b"], CLAIMED["r_v"]
    # r = 2 r_b'' + α_3 z_(n-1)''' + α_1 s r_b + α_3 r_v; n - 1 = 2(ν - 1) + 1 for n = 2ν, and 2ν for n = 2ν + 1
    return {
        "r_b": ([alpha[0], *sums_b[0]], [alpha[1], *sums_b[1]]),
        "r_v": sums_v,
        "r_xi": ([alpha[0], *sums_b[0]], [alpha[1], *sums_b[1]]),
        "r": ([r_b[0] - 2, z[1] - 1 - 3, r_b[0] + 1, r_v[0]], [r_b[1] - 2, z[0] - 3, r_b[1] + 1, r_v[1]]),
    }


def by_indices(name: str) -> bool | None:
    """Whether each part lies in the claimed space, for every ν."""
    even, odd = right_sides()[name]
    return all(is_part_of(j, CLAIMED[name][0]) for j in even) and all(is_part_of(j, CLAIMED[name][1]) for j in odd)


def monomials(pair: Pair, n: int) -> set[int]:
    """The powers of s in the space of the term of order n."""
    return set(range(n // 2 + pair[n % 2], -1, -3)) if n >= 0 else set()


def _products(first: Pair, second: Pair, n: int) -> Iterator[int]:
    for k in range(n + 1):
        yield from (a + b for a in monomials(first, k) for b in monomials(second, n - k))


def by_monomials(name: str) -> bool | None:
    """The same, with all monomials of all products written out for the orders in ORDERS."""
    alpha, force, p, z = (SERIES[key] for key in ("alpha", "lambda", "p", "z"))
    answers = []
    for n in ORDERS:
        found: Iterable[int]
        if name in ("r_b", "r_xi"):
            found = {*monomials(alpha, n), *_products(alpha, force, n)}
        elif name == "r_v":
            found = _products(p, force, n)
        else:
            lower = {k - 2 for k in monomials(CLAIMED["r_b"], n)} | {k - 3 for k in monomials(z, n - 1)}
            found = lower | {k + 1 for k in monomials(CLAIMED["r_b"], n)} | monomials(CLAIMED["r_v"], n)
        answers.append({k for k in found if k >= 0} <= monomials(CLAIMED[name], n))
    return all_of(answers)


def in_systems(name: str) -> bool | None:
    """The same in nonlinear systems, from the left sides of the equations: what stands on the right is not asked."""
    rows = [row for recursion in explicit.recursions() for row in explicit.right_sides(recursion)[name]]
    return all_of(
        {k for k, value in enumerate(term.coeffs()) if value != 0} <= monomials(CLAIMED[name], n)
        for row in rows
        for n, term in enumerate(row)
    )


def _right_sides() -> Entry:
    return SECTION.settled(
        "5-right-sides",
        "lines 1622 to 1623, 1636 to 1637, 1675 to 1676, 1718 to 1719",
        r"r_{b,2\nu},r_{\xi,2\nu}\in P_\nu,\ r_{b,2\nu+1},r_{\xi,2\nu+1}\in P_{\nu-4};\ "
        r"r_{v,n},r_n:\ P_{\nu+1},\ P_{\nu-3}",
        "With the terms that stand in them in the spaces of Theorem 1, r_b, r_v, r and r_ξ of order n, r_ξ with the "
        "corrected sum of 5-xinprime, are in the stated spaces, for every n",
        Rung.EXACT.check(
            "the indices of the products of two terms, of derivatives and of s times a term, ν a symbol",
            all_of(by_indices(name) for name in CLAIMED),
        ),
        Rung.POINTS.check(f"all monomials for n < {len(ORDERS)}", all_of(by_monomials(name) for name in CLAIMED)),
        Rung.POINTS.check(
            "three nonlinear systems, all orders below 12: the left sides of specialBn, specialVn, third-order_b and "
            "the rate of ξ_n, with no term of the right sides",
            all_of(in_systems(name) for name in CLAIMED),
        ),
        note="r_b and r_v have terms of lower orders of λ and of p of the orders up to n (step 1); r_ξ has λ_n too "
        "(step 3).",
    )


def _special(name: str) -> fmpq_mpoly:
    """An equation of the inner scale, left minus right."""
    return RECURSION.read(section_5_recursion.PRINTED["5-inner-system"][name])


def _rate_and_force() -> tuple[fmpq_mpoly, fmpq_mpoly]:
    """δ z' by specialZ, and λ_N by specialL."""
    symbols = RECURSION.symbols
    return symbols["delta"] * symbols["z1"] - _special("specialZ"), symbols["lam"] - _special("specialL")


def rests_there() -> bool | None:
    """Whether z = y/2 and λ_N = -y/2 make the right-hand side of δ z' vanish, with λ_N = z - y."""
    images = {name: RECURSION.read(text) for name, text in SLOW.items()}
    rate, force = (RECURSION.substitute(value, images) for value in _rate_and_force())
    return rate.is_zero() and (force - images["lam"]).is_zero()


def goes_there() -> bool | None:
    """Whether the deviation d = z - y/2 at fixed y has δ d' = -2 d: one fast direction, which is stable."""
    rate, force = _rate_and_force()
    d = RECURSION.symbols["u0"]
    rate = RECURSION.substitute(rate, {"lam": force})
    return (RECURSION.substitute(rate, {"z0": RECURSION.read(SLOW["z0"]) + d}) + 2 * d).is_zero()


def others_are_slow() -> bool | None:
    """Whether specialX to specialV have neither z nor a factor δ, in front of a derivative or of a term."""
    equations = section_5_recursion.PRINTED["5-inner-system"]
    slow = [_special(name) for name in equations if name not in FAST]
    return bool(slow) and all(value.derivative(name).is_zero() for value in slow for name in ("z0", "z1", "delta"))


def is_the_slow_system() -> bool | None:
    """Whether the printed slow system has the equations of the inner scale but for specialZ and specialL, each once."""
    printed = PRINTED["5-inner-slow"]
    left = [name for name in section_5_recursion.PRINTED["5-inner-system"] if name not in FAST]
    same = sorted(printed) == sorted(left)
    return same and all((RECURSION.read(printed[name]) - _special(name)).is_zero() for name in left)


def by_forces_of_rest() -> bool | None:
    """Whether, with z and λ_N at rest, the printed lines are what z in λ_N = z - y makes of specialX to specialV."""
    rest = {name: RECURSION.read(text) for name, text in SLOW.items()}
    _, force = _rate_and_force()
    return all(
        (
            RECURSION.substitute(RECURSION.substitute(_special(name), {"lam": force}), {"z0": rest["z0"]})
            - RECURSION.substitute(RECURSION.read(text), {"lam": rest["lam"]})
        ).is_zero()
        for name, text in PRINTED["5-inner-slow"].items()
    )


def _inner_slow() -> Entry:
    return SECTION.settled(
        "5-inner-slow",
        "lines 2035 to 2045",
        r"\tilde z\to\tilde y/2,\quad\lambda_N=-\tilde y/2",
        "On the inner scale z is the one fast variable: at fixed y it goes to y/2 like e^(-2s/δ), and then λ_N = -y/2; "
        "specialX to specialV have z by λ_N alone, and no factor δ, and are the printed slow system",
        Rung.EXACT.check(
            "specialZ and specialL at rest; the symbols of specialX to specialV; the printed lines are these five",
            all_of([rests_there(), others_are_slow(), is_the_slow_system()]),
        ),
        Rung.EXACT.check(
            "the deviation of z from y/2 in specialZ; the symbols of specialX to specialV; these with z = y/2 put into "
            "λ_N = z - y are the printed lines with λ_N = -y/2",
            all_of([goes_there(), others_are_slow(), by_forces_of_rest()]),
        ),
        note="That there is no other z and no factor δ has one check, which stands in both. δ stands in "
        "ξ = ξ* + δ² ξ~ too. The printed slow system has F and G with a tilde, read here without it: 5-letters.",
    )


ENTRIES: Builders = {"5-right-sides": _right_sides, "5-inner-slow": _inner_slow}
"""Right-hand sides and the slow system."""
