"""Ledger of the distinguished trajectory in Cases I and II (Sec. 4.5): the strong stable manifold of the G-spot."""

from __future__ import annotations

from gspot_verified.paper.checks.entry import Builders, Entry, Rung, Section, all_of
from gspot_verified.paper.checks.identities import rising_signs
from gspot_verified.paper.section_1.section_1_cases import ALGEBRA, RATES, in_case

_SYMBOLS = ALGEBRA.symbols
DIRECTION = {"p": "alpha1 - alpha3", "b": "alpha2"}
"""The line α_2 p = (α_1 - α_3) b of the distinguished trajectory."""


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


ENTRIES: Builders = {"1-strong-stable": _strong_stable}
"""The strong direction."""
