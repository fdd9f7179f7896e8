"""Files whose bounds are as small as the checker takes them: one unit less, and only inward rounding would accept it.

Page: proofs/run_certificate.md, section 6.
"""

from __future__ import annotations

import copy
from fractions import Fraction
from functools import cache
from typing import Any

import pytest
from must_reject import runs

BITS, NAMES = 64, ("T", "V", "Y", "Z", "b")
PARAMETERS = {"alpha_1": "-1", "alpha_2": "-1/3", "beta": "1/2", "damping": "1", "k_1": "1", "k_2": "1"}
START = {"b": "-1/3", "p": "1/3", "v": "1/7", "y": "-1/3", "z": "1/5"}
H = Fraction(125, 131072)
SMALL = -50  # the entries of the basis are near 2^SMALL: an error of one unit is a long way in it
NODES = [(row, block) for row in (0, 1) for block in range(4)] * 2  # twice: the later ones change the earlier ones


def coefficients() -> dict[str, list[int]]:
    """The first two terms of the solution with ε = 1, rounded down."""
    at = {name: Fraction(value) for name, value in START.items()}
    of = {name: Fraction(value) for name, value in PARAMETERS.items()}
    force = of["k_2"] * (at["z"] - at["y"])
    rates = {
        "T": Fraction(1),
        "V": at["b"] + at["p"] * force,
        "Y": at["v"],
        "Z": (-of["k_1"] * at["z"] - force) / of["damping"],
    }
    rates["b"] = of["alpha_2"] + of["beta"] * force
    first = {"T": Fraction(0), "V": at["v"], "Y": at["y"], "Z": at["z"], "b": at["b"]}
    return {name: [int(first[name] * 2**BITS // 1), int(rates[name] * H * 2**BITS // 1)] for name in NAMES}


def whole() -> runs.Lines:
    """A run of one short step, in rough numbers."""
    statement = {
        "effects": ["compliant_contact", "lift_off"], "end": "time", "epsilon": "1", "events": [], "kind": "run",
        "parameters": PARAMETERS,
        "start": START, "until": str(H),
    }  # fmt: skip
    pages = runs.part("run").HYPOTHESES
    header = {"format": "gspot_verified certificate", "hypotheses": pages, "statement": statement, "version": 4}
    basis = [[8 if i == j else 3 * (i > j), SMALL - 3] for i in range(5) for j in range(5)]
    nodes = [[[3**63, -BITS]] * 4, [[3**64, -BITS]] * 4]
    piece = {"basis": basis, "blocks": [1, 2, 1, 1], "end": [1, 0], "nodes": nodes}
    step = {"h": [125, -17], "pieces": [piece], "unit": BITS, "x": coefficients()}
    phase = {"bracket": [], "cone": [], "event": "", "phase": "slip", "steps": 1}
    return [header, {"bits": BITS}, phase, step]


def with_node(lines: runs.Lines, place: tuple[int, int], units: int) -> runs.Lines:
    lines = copy.deepcopy(lines)
    lines[3]["pieces"][0]["nodes"][place[0]][place[1]] = [units, -BITS]
    return lines


def is_accepted(lines: runs.Lines, run: Any = None) -> bool:
    return runs.verdict(lines, run).startswith("VERIFIED")


@cache
def sharp() -> list[runs.Lines]:
    """One bound after the other made as small as it may be; each file then with one that is a unit smaller."""
    lines, found = whole(), []
    assert is_accepted(lines), runs.verdict(lines)
    for place in NODES:
        low, high = 0, lines[3]["pieces"][0]["nodes"][place[0]][place[1]][0]
        while high - low > 1:
            middle = (low + high) // 2
            low, high = (low, middle) if is_accepted(with_node(lines, place, middle)) else (middle, high)
        lines = with_node(lines, place, high)
        found.append(with_node(lines, place, low))
    return found


# The lower ends of products and of rational multiples change no bound of this file: tests/checker/test_intervals.py.
INWARD = {
    "return -(-n // d)": "return n // d",
    "return root + (root * root < n)": "return root",
    "up(max(ends), self.one)": "max(ends) >> self.bits",
    "up(q.numerator << self.bits, q.denominator)": "(q.numerator << self.bits) // q.denominator",
    "return [up(sum(": "return [(lambda n, d: n // d)(sum(",
}


@pytest.mark.slow
def test_a_unit_less_is_rejected() -> None:
    assert not any(is_accepted(lines) for lines in sharp())


@pytest.mark.slow
@pytest.mark.parametrize("outward", INWARD)
def test_inward_rounding_is_seen(outward: str) -> None:
    run = runs.changed((outward, INWARD[outward]), name="intervals")
    assert any(is_accepted(lines, run) for lines in sharp())
