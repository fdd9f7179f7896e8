"""Certificates of false statements, with numbers chosen so that a careless step of a checker would confirm them."""

from __future__ import annotations

from fractions import Fraction
from itertools import pairwise
from typing import Any

from must_reject.mutate import GOOD, Lines, lines_of, text_of

LONG = 10**31
"""A denominator beyond 2^64, the accuracy at which a check begins."""
BEYOND = Fraction(1, 10**1000)

PAGES_OF_THE_FORCE = [
    *("certificate", "exact_solution", "identities", "initial_values", "laplace", "monotone", "negative", "tails")
]
PAGES_OF_THE_SLOW_ZEROS = [
    *("certificate", "epsilon_series", "exact_solution", "finite_epsilon_zeros"),
    *("identities", "initial_values", "laplace", "negative"),
]


def slow_zeros(beta: str, epsilon: str, eta: str, *columns: tuple[list[str], list[Any]]) -> Lines:
    """Two zeros of the slow solution."""
    lines = lines_of({"beta": beta, "epsilon": epsilon, "eta": eta, "kind": "slow_zeros"}, *columns)
    lines[0] |= {"hypotheses": PAGES_OF_THE_SLOW_ZEROS, "version": 3}
    return lines


def slow_zeros_for_a_large_epsilon(first: Fraction, last: Fraction, columns: int) -> bytes:
    """False near β = 5 for every ε > 32, and at β = 9/2 for ε = 10^6 (finite_epsilon_zeros.md, section 4)."""
    place = ["dip", str(Fraction(17, 10) + Fraction(3, LONG)), str(Fraction(11, 5) + Fraction(1, LONG))]
    ends = [first + (last - first) * k / columns for k in range(columns + 1)]
    cells = [([str(low), str(high)], [place]) for low, high in pairwise(ends)]
    beta = f"[{first}, {last}]" if first == last else f"({first}, {last})"
    return text_of(slow_zeros(beta, "1000000", "100", *cells))


def of_the_force(kind: str, c1: str, level: str, epsilon: str, tau: str, *pieces: list[Any]) -> bytes:
    """The contact force at β = 5/2."""
    statement = {"alpha": ["-1", "-1", "-5/2"], "c1": c1, "epsilon": epsilon, "kind": kind, "level": level, "tau": tau}
    lines = lines_of(statement, (["5/2", "5/2"], list(pieces)))
    lines[0] |= {"hypotheses": PAGES_OF_THE_FORCE, "version": 2}
    return text_of(lines)


def sign(beta: str, tau: str, value: int, *columns: tuple[list[str], list[Any]]) -> bytes:
    return text_of(lines_of({"beta": beta, "kind": "sign", "sign": value, "tau": tau}, *columns))


def zeros(beta: str, counts: list[list[int]], *columns: tuple[list[str], list[Any]]) -> bytes:
    return text_of(lines_of({"beta": beta, "counts": counts, "kind": "zeros"}, *columns))


NARROW = str(2 + BEYOND)  # b = 1 + 10^-1000: F(0, b) is not 0, its sign is lost in every rounding
BELOW, ABOVE = (column["pieces"] for column in GOOD["fold"][1:])
NO_ZERO = [["left", "-5/8"], ["sign", "-5/8", "0", 1]]
VALLEY = Fraction(5, 8) + Fraction(1, 3 * LONG)  # at β = 5/2 F is -0.57 there, and G_b at ε = 1 is -0.525
AFTER = VALLEY + Fraction(1, 7 * LONG)

FORGED = {
    "a slope in another unit": slow_zeros_for_a_large_epsilon(Fraction(9, 2), Fraction(9, 2), 1),
    "a slope in another unit, on a range": slow_zeros_for_a_large_epsilon(Fraction(4), Fraction(5), 16),
    "the lift-off at a long point": of_the_force("lift_off", "1", "1/2", "1", str(VALLEY), ["level", str(VALLEY), "4"]),
    "the force at a long point": of_the_force(
        "force", "-1", "47/100", "1", f"[{VALLEY}, {VALLEY}]", ["level", str(VALLEY), str(AFTER)]
    ),
    "the sign where it is not seen": sign(
        f"[{NARROW}, {NARROW}]", "[0, 0]", -1, ([NARROW] * 2, [["sign", "-1", "1", 1]])
    ),
    "the other sign at a long point": sign(
        "[5/2, 5/2]", f"[{VALLEY}, {VALLEY}]", -1, (["5/2"] * 2, [["sign", str(VALLEY), str(AFTER), 1]])
    ),
    "a hinge at a zero": sign("[2, 9/4]", "[-1/4, 0]", -1, (["2", "9/4"], [["hinge", "-1/4", "0"]])),
    "a hinge on the wrong side": sign("(1, 2)", "[0, 5/4]", -1, (["1", "2"], [["hinge", "0", "5/4"]])),
    "a fold for both sides": sign("[47/16, 3]", "(-1/4, 0)", -1, (["47/16", "3"], [["fold", "-1/4", "1/4"]])),
    "a fold below counted as above": zeros("(95/32, 3)", [[2, 0]], (["95/32", "3"], BELOW)),
    "a fold above counted as below": zeros("(3, 49/16)", [[3, 3]], (["3", "49/16"], ABOVE)),
    "a zero that comes from infinity": sign("(2, 17/8]", "[3, inf)", -1, (["2", "17/8"], [["right", "3", 0]])),
    "a zero that is not counted": zeros("[3/2, 3/2]", [[1, 0]], (["3/2", "3/2"], [*NO_ZERO, ["right", "0", 0]])),
}
"""Each is false, and nothing but the mathematics is wrong with it."""
