"""Ledger of Section 1: which initial values in slip are attracted to the G-spot, and with what force, in each Case.

Rigid slip is Gspot1, Gspot2: p' = α_1 p, b' = α_2 p + α_3 b with constants. q, -n (or its part below the line) are the
initial p and b, E = e^((α_3 - α_1) s) is 1 + x or 1/(1 + x), x from 0 to infinity; u, w, m, n, q, x are positive.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import partial

from flint import fmpq_mpoly

from gspot_verified.paper.checks.entry import Builders, Entry, Rung, Section, all_of
from gspot_verified.paper.checks.identities import Algebra, rising_signs

SECTION = Section("Section 1")
ALGEBRA = Algebra("u w m n q x r c p b alpha1 alpha2 alpha3")
_SYMBOLS = ALGEBRA.symbols
CASES: dict[str, dict[str, str]] = {
    "1-case-I": {"alpha1": "-u-w", "alpha2": "-m", "alpha3": "-w"},
    "1-case-II": {"alpha1": "-u-w", "alpha2": "m", "alpha3": "-w"},
    "1-case-III": {"alpha1": "-w", "alpha2": "-m", "alpha3": "-u-w"},
}
"""The sign conditions, by positive symbols: u = |α_3 - α_1|."""
START = {"1-case-I": "-n*u", "1-case-II": "-m*q-n*u", "1-case-III": "-n*u"}
"""u b(0): every b < 0; in Case II every b with α_2 p < (α_1 - α_3) b."""
LINES = {"1-case-I": "lines 275 to 277", "1-case-II": "lines 278 to 280", "1-case-III": "lines 281 to 284"}
ENDS = {"1-case-I": "λ_N → ∞ and p/b → 0", "1-case-II": "λ_N → ∞ and p/b → 0", "1-case-III": "λ_N → α_2/(α_3 - α_1)"}
WHO = {
    "1-case-I": "every initial value with p > 0, b < 0",
    "1-case-II": "every initial value with p > 0 and α_2 p < (α_1 - α_3) b",
    "1-case-III": "every initial value with p > 0, b < 0",
}
GROWS = {"1-case-I": True, "1-case-II": True, "1-case-III": False}
RATES = {"p": "alpha1*p", "b": "alpha2*p + alpha3*b"}
"""Gspot1 and Gspot2."""
DIRECTIONS = {"alpha1": {"p": "alpha1 - alpha3", "b": "alpha2"}, "alpha3": {"p": "0*b", "b": "1 + 0*b"}}
"""The eigenvectors, by their rates."""
STRONG = {"1-case-I": ("alpha1", "alpha3"), "1-case-II": ("alpha1", "alpha3"), "1-case-III": ("alpha3", "alpha1")}
"""The rate of the strong direction, and that of the weak one."""


def in_case(name: str, text: str) -> fmpq_mpoly:
    """A formula in the symbols of one Case."""
    images = {key: ALGEBRA.read(value) for key, value in CASES[name].items()}
    return ALGEBRA.substitute(ALGEBRA.read(text), images)


def slope_of_the_force() -> fmpq_mpoly:
    """d(-b/p)/ds times p², from Gspot1 and Gspot2."""
    rates = {key: ALGEBRA.read(text) for key, text in RATES.items()}
    return -(rates["b"] * _SYMBOLS["p"] - _SYMBOLS["b"] * rates["p"])


def force_over_line(name: str) -> tuple[fmpq_mpoly, fmpq_mpoly]:
    """u q λ_N = -u q b/p as numerator and denominator: -u q (c + (b(0)/q - c) E), c (α_1 - α_3) = α_2."""
    drift = in_case(name, "alpha1 - alpha3")  # -u or u
    second = in_case(name, "alpha2")
    line = second if drift == _SYMBOLS["u"] else -second  # u c
    start = ALGEBRA.read(START[name])  # u b(0)
    away = start - line * _SYMBOLS["q"]
    grown = 1 + _SYMBOLS["x"]
    if GROWS[name]:
        return -(line * _SYMBOLS["q"] + away * grown), ALGEBRA.constant(1)
    return -(line * _SYMBOLS["q"] * grown + away), grown


def solves(name: str) -> bool | None:
    """Whether b = c p + (b(0) - c q) e^(α_3 s) solves Gspot2: the line b = c p is invariant for c (α_1 - α_3) = α_2."""
    on_line = {"b": _SYMBOLS["c"] * _SYMBOLS["p"]}
    left = _SYMBOLS["c"] * ALGEBRA.read(RATES["p"]) - ALGEBRA.substitute(ALGEBRA.read(RATES["b"]), on_line)
    wanted = _SYMBOLS["p"] * ALGEBRA.read("c*(alpha1 - alpha3) - alpha2")
    second = ALGEBRA.read(RATES["b"]).derivative("b") - _SYMBOLS["alpha3"]
    exponent = in_case(name, "alpha3 - alpha1")
    return left == wanted and second.is_zero() and rising_signs(exponent if GROWS[name] else -exponent)


def stays_and_ends(name: str) -> bool | None:
    """Whether λ_N > 0 for every x, and its limit as x → ∞ is infinite, or (Case III) α_2/(α_3 - α_1)."""
    top, bottom = force_over_line(name)
    if not (rising_signs(top) and rising_signs(bottom)):
        return False
    highest = ALGEBRA.coefficient_of(top, "x", 1)
    if GROWS[name]:
        return rising_signs(highest)
    mean = -in_case(name, "alpha2")  # u α_2/(α_3 - α_1), since α_3 - α_1 = -u
    below = ALGEBRA.coefficient_of(bottom, "x", 1)
    return highest == mean * _SYMBOLS["q"] * below and in_case(name, "alpha3 - alpha1") == -_SYMBOLS["u"]


def force_moves(name: str) -> bool | None:
    """The same by the scalar equation r' = -α_2 + (α_3 - α_1) r of r = λ_N = -b/p."""
    at_force = ALGEBRA.substitute(slope_of_the_force(), {"b": -_SYMBOLS["r"] * _SYMBOLS["p"]})
    rate = ALGEBRA.read("-alpha2 + (alpha3 - alpha1)*r")
    if at_force != rate * _SYMBOLS["p"] ** 2:
        return False
    here = in_case(name, "-alpha2 + (alpha3 - alpha1)*r")
    if name == "1-case-I":  # r' >= m > 0
        return rising_signs(here)
    if name == "1-case-II":  # u r = m + u y with y > 0 from the condition: r' = u y
        above = here - (_SYMBOLS["u"] * _SYMBOLS["r"] - _SYMBOLS["m"])
        return above.is_zero() and rising_signs(-(ALGEBRA.read(START[name]) + _SYMBOLS["m"] * _SYMBOLS["q"]))
    # r' = m - u r: a stable point r = m/u > 0, which is reached from every r > 0 without crossing 0
    return here == _SYMBOLS["m"] - _SYMBOLS["u"] * _SYMBOLS["r"]


def reaches(images: Mapping[str, str]) -> bool | None:
    """Whether α_1, α_3 < 0: p = q e^(α_1 s) → 0, t is its integral, and b, of e^(α_1 s) and e^(α_3 s), → 0 too."""
    return all_of(rising_signs(-ALGEBRA.read(images[name])) for name in ("alpha1", "alpha3"))


def is_stable(name: str) -> bool | None:
    """The same by Hurwitz: the matrix of Gspot1, Gspot2 has trace < 0 < determinant; so p decays, and t is finite."""
    rows = [[ALGEBRA.read(RATES[rate]).derivative(by) for by in "pb"] for rate in "pb"]
    trace, determinant = (in_case(name, str(value)) for value in (rows[0][0] + rows[1][1], ALGEBRA.determinant(rows)))
    return rising_signs(-trace) and rising_signs(determinant)


def _case(name: str) -> Entry:
    return SECTION.settled(
        name,
        LINES[name],
        r"p/b\to0,\ \lambda_N\to\infty" if GROWS[name] else r"\lambda_N\to\alpha_2/(\alpha_3-\alpha_1)",
        f"Case {name.rpartition('-')[2]}, rigid slip with constant α's: {WHO[name]} keeps p > 0 and λ_N > 0 and, "
        f"as long as slip is positive, reaches the G-spot in finite time, and {ENDS[name]}",
        Rung.EXACT.check(
            "the solution b = c p + (b(0) - c p(0)) e^(α_3 s) of Gspot1, Gspot2, c = α_2/(α_1 - α_3), for all values",
            all_of([solves(name), stays_and_ends(name), reaches(CASES[name])]),
        ),
        Rung.EXACT.check(
            "the equation λ_N' = -α_2 + (α_3 - α_1) λ_N of the force: its sign, or its one stable point; the trace and "
            "the determinant of Gspot1, Gspot2",
            all_of([force_moves(name), is_stable(name)]),
        ),
        note="On the one line α_2 p = (α_1 - α_3) b the G-spot is reached with this force in Case II too "
        "(2-trivial-contact), and for α_1 < 0 < α_3, α_2 > 0 (1-attracting-signs)."
        if name == "1-case-III"
        else "",
    )


def directions_are_kept() -> bool | None:
    """Whether the flow takes each direction into itself, at its rate."""
    rates = {name: ALGEBRA.read(text) for name, text in RATES.items()}
    found = []
    for rate, parts in DIRECTIONS.items():
        vector = {name: ALGEBRA.read(text) for name, text in parts.items()}
        found += [ALGEBRA.substitute(rates[name], vector) - _SYMBOLS[rate] * vector[name] for name in "pb"]
        found += [ALGEBRA.constant(1)] if all(value.is_zero() for value in vector.values()) else []
    return all(value.is_zero() for value in found)


def strong_and_weak(name: str) -> bool | None:
    """Whether both rates are negative in a Case, that of the strong direction below the other one."""
    strong, weak = (in_case(name, rate) for rate in STRONG[name])
    return rising_signs(weak - strong) and rising_signs(-weak)


def directions_by_the_matrix() -> bool | None:
    """The same by Cayley and Hamilton: (M - α_1)(M - α_3) = 0, so each column of one factor has the other's rate."""
    rows = [[ALGEBRA.read(RATES[rate]).derivative(by) for by in "pb"] for rate in "pb"]
    rates = list(DIRECTIONS)
    found = []
    for rate, other in (rates, rates[::-1]):
        column = 0 if rate == "alpha1" else 1  # the other column is 0, or a multiple of this one
        p, b = (ALGEBRA.read(text) for text in DIRECTIONS[rate].values())
        left = [rows[k][column] - (_SYMBOLS[other] if k == column else 0) for k in range(2)]
        found.append(left[0] * b - left[1] * p)
    trace, determinant = rows[0][0] + rows[1][1], ALGEBRA.determinant(rows)
    found += [trace - _SYMBOLS[rates[0]] - _SYMBOLS[rates[1]], determinant - _SYMBOLS[rates[0]] * _SYMBOLS[rates[1]]]
    return all(value.is_zero() for value in found)


def states_come_along_the_weak_one(name: str) -> bool | None:
    """Whether λ_N = -b/p grows without bound where p = 0 is the weak direction, and tends to that of the line else."""
    return GROWS[name] == (STRONG[name][1] == "alpha3") and all_of([stays_and_ends(name), is_stable(name)])


def _directions() -> Entry:
    return SECTION.settled(
        "1-eigendirections",
        "lines 294 to 296",
        r"\text{eigenvectors: the strong stable and the weak stable direction}",
        "In each of Cases I, II and III, with constant α's, Gspot1 and Gspot2 have two eigenvectors, both stable: that "
        "of α_2 p = (α_1 - α_3) b with the rate α_1, and that of p = 0 with the rate α_3; the first is the strong one "
        "in Cases I and II, the second in Case III",
        Rung.EXACT.check(
            "the flow on each direction is its rate times it; the signs of the rates and of their difference",
            all_of([directions_are_kept(), *map(strong_and_weak, CASES)]),
        ),
        Rung.EXACT.check(
            "the columns of M - α_3 and of M - α_1, M the matrix of the flow; trace and determinant; by the limit of "
            "λ_N = -b/p states come along the weak direction",
            all_of([directions_by_the_matrix(), *map(states_come_along_the_weak_one, CASES)]),
        ),
        note="Which of its lines Figure 3 draws with double arrows is not checked.",
    )


ENTRIES: Builders = {**{name: partial(_case, name) for name in CASES}, "1-eigendirections": _directions}
"""Cases I, II and III, and their eigendirections."""
