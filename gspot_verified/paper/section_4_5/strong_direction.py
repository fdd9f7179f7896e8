"""Ledger of the distinguished trajectory in Cases I and II (Sec. 4.5): the strong stable manifold of the G-spot.

In Case II: what becomes of the states beyond it, C_1 > 0.
"""

from __future__ import annotations

from gspot_verified.paper.checks.entry import Builders, Entry, Rung, Section, all_of
from gspot_verified.paper.checks.identities import rising_signs
from gspot_verified.paper.section_1.section_1_cases import (
    ALGEBRA,
    CASES,
    RATES,
    in_case,
    slope_of_the_force,
    solves,
)

_SYMBOLS = ALGEBRA.symbols
DIRECTION = {"p": "alpha1 - alpha3", "b": "alpha2"}
"""The line α_2 p = (α_1 - α_3) b of the distinguished trajectory."""
BEYOND = {"distance": "alpha2*p - (alpha1 - alpha3)*b", "u K": "n*u"}
"""Case II, C_1 > 0: the distance is positive; b = c p + K e^(α_3 s) with c (α_1 - α_3) = α_2 and u K = n u > 0."""


def _is_a_line() -> bool | None:
    """Whether p does not vanish along it, in Cases I and II."""
    return all_of(rising_signs(-in_case(name, DIRECTION["p"])) for name in ("1-case-I", "1-case-II"))


def _is_eigenvector() -> bool:
    """Whether the line is an eigenvector of Gspot1, Gspot2 for the rate α_1, for all α's."""
    line = {name: ALGEBRA.read(text) for name, text in DIRECTION.items()}
    rates = {name: ALGEBRA.substitute(ALGEBRA.read(text), line) for name, text in RATES.items()}
    return all(rates[name] == _SYMBOLS["alpha1"] * line[name] for name in "pb")


def _is_strong() -> bool | None:
    """Whether α_1 < α_3 < 0 in Cases I and II: of two stable rates α_1 is the faster."""
    found = [in_case(name, text) for name in ("1-case-I", "1-case-II") for text in ("alpha3 - alpha1", "-alpha3")]
    return all_of(rising_signs(value) for value in found)


def _leaves_the_line() -> bool:
    """Whether b (α_1 - α_3) - α_2 p, the distance from the line, has the rate α_3 alone."""
    distance = ALGEBRA.read("b*(alpha1 - alpha3) - alpha2*p")
    rates = {name: ALGEBRA.read(text) for name, text in RATES.items()}
    rate = sum((distance.derivative(name) * value for name, value in rates.items()), start=ALGEBRA.constant(0))
    on_line = ALGEBRA.substitute(distance, {name: ALGEBRA.read(text) for name, text in DIRECTION.items()})
    return bool(rate == _SYMBOLS["alpha3"] * distance) and on_line.is_zero()


def _strong_stable() -> Entry:
    return Section("Section 4.5").settled(
        "1-strong-stable",
        "lines 1278 to 1281",
        r"\alpha_2p=(\alpha_1-\alpha_3)b",
        "Cases I and II, Gspot1 and Gspot2: the distinguished trajectory α_2 p = (α_1 - α_3) b is the strong stable "
        "manifold of the G-spot",
        Rung.EXACT.check(
            "the line is an eigenvector for the rate α_1, and α_1 < α_3 < 0",
            all_of([_is_a_line(), _is_eigenvector(), _is_strong()]) or None,
        ),
        Rung.EXACT.check(
            "the distance from the line has the slower rate α_3, so that only on the line is the approach as e^(α_1 s)",
            all_of([_is_a_line(), _leaves_the_line(), _is_strong()]) or None,
        ),
        note="Which trajectories are attracted in slip: entries 1-case-I and 1-case-II.",
    )


def force_falls_to_zero() -> bool | None:
    """Whether p² dλ_N/ds = -p d, d the distance, and d/p grows as λ_N falls: then it falls at a rate below -d(0)/p(0).

    So λ_N > 0 is 0 at some s, and p, whose rate is a multiple of p, is positive there.
    """
    on_force = {"b": ALGEBRA.read("-r*p")}
    distance, slope = (
        ALGEBRA.substitute(value, on_force) for value in (ALGEBRA.read(BEYOND["distance"]), slope_of_the_force())
    )
    falls = slope + _SYMBOLS["p"] * distance
    images = {name: ALGEBRA.read(text) for name, text in CASES["1-case-II"].items()}
    faster = ALGEBRA.substitute(-distance.derivative("r"), images)
    stays = ALGEBRA.substitute(ALGEBRA.read(RATES["p"]), {"p": ALGEBRA.constant(0)})
    return (falls.is_zero() and stays.is_zero() and rising_signs(faster)) or None


def solution_crosses_zero() -> bool | None:
    """Whether u q b/p is u b(0) + u K x, e^((α_3 - α_1) s) = 1 + x, with u K > 0: for b(0) < 0 it is 0 at one x > 0.

    u K is the distance at the start, m q + u b(0), in which u stands for α_3 - α_1.
    """
    case, q, u = "1-case-II", _SYMBOLS["q"], _SYMBOLS["u"]
    line, away = -in_case(case, "alpha2") * q, ALGEBRA.read(BEYOND["u K"])  # u c q, as α_1 - α_3 = -u
    value = line + away * (1 + _SYMBOLS["x"])
    start, rise = (ALGEBRA.coefficient_of(value, "x", power) for power in (0, 1))
    distance = ALGEBRA.substitute(in_case(case, BEYOND["distance"]), {"p": q}) - u * _SYMBOLS["b"] + start
    return (solves(case) and (distance - away).is_zero() and rising_signs(rise)) or None


def _lifts_off() -> Entry:
    return Section("Section 4.5").settled(
        "1-case-II-beyond",
        "lines 1278 to 1281",
        r"\text{all trajectories of interest have }C_1<0",
        "Case II, rigid slip with constant α's: every state with p > 0, b < 0 and α_2 p > (α_1 - α_3) b, C_1 > 0, "
        "comes, as long as slip is positive, to b = 0, where λ_N is 0, with p > 0: it lifts off, and does not reach "
        "the G-spot in slip",
        Rung.EXACT.check(
            "the rate of λ_N = -b/p is the distance from the line over -p; it grows in size as λ_N falls",
            force_falls_to_zero(),
        ),
        Rung.EXACT.check(
            "the solution b = c p + K e^(α_3 s) of Gspot1, Gspot2, c = α_2/(α_1 - α_3), K > 0: b/p rises without bound",
            solution_crosses_zero(),
        ),
        note="At b = 0 db/dt is α_2 > 0. At a given ε > 0 the compliant model has states with C_1 > 0 that pass p = 0 "
        "and lift off (3-case-II-starts).",
    )


ENTRIES: Builders = {"1-strong-stable": _strong_stable, "1-case-II-beyond": _lifts_off}
"""The strong direction, and the states beyond it."""
