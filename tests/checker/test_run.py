"""The checker of runs: what it accepts, and what it must reject.

Page: proofs/run_certificate.md.
"""

from __future__ import annotations

import copy
from collections import Counter

import pytest
from must_reject import runs
from must_reject.mutate import text_of

MAKERS = {"flight": runs.flight, "stick": runs.stick}
MECHANISMS = {"rod": runs.rod, "oscillator": runs.oscillator}
THOROUGH = {"flight": 3, "stick": 3, "rod": 8, "oscillator": 8}
"""One of so many in the slow tests; ``accepted(base, 0, 1)`` asks all, in a quarter of an hour."""


def test_good_certificates() -> None:
    said = runs.verdict(runs.flight())
    assert said.startswith("VERIFIED the model system with compliant_contact, lift_off, ε = 1/20"), said
    assert "just these changes of phase: lift-off at t in [0.75318" in said
    assert "touch-down at t in [" in said
    assert "for ever" in said
    said = runs.verdict(runs.stick())
    assert "just these changes of phase: stick at t in [" in said, said
    assert said.endswith("until t = 2")


def accepted(base: str, start: int, stride: int) -> list[str]:
    """Those of the wrong certificates that the checker does not reject."""
    good = (MAKERS | MECHANISMS)[base]()
    found, same = [], text_of(good)
    for name, change in list(runs.changes(good))[start::stride]:
        lines = copy.deepcopy(good)
        change(lines)
        data = text_of(lines)
        assert data != same, name
        if not runs.verdict(data).startswith("REJECTED"):
            found.append(name)
    return found


@pytest.mark.parametrize("base", MAKERS)
def test_some_that_are_wrong(base: str) -> None:
    assert accepted(base, 3, 23) == []


def test_some_of_a_mechanism_that_are_wrong() -> None:
    assert accepted("oscillator", 5, 31) == []


@pytest.mark.slow
@pytest.mark.parametrize("base", THOROUGH)
def test_more_that_are_wrong(base: str) -> None:
    names = Counter(name for name, _ in runs.changes((MAKERS | MECHANISMS)[base]()))
    assert names.total() >= 190
    assert set(names.values()) == {1}, names.most_common(3)
    assert accepted(base, 1, THOROUGH[base]) == []


def test_work_is_counted_before_it_is_done() -> None:
    lines = runs.flight()
    poor = runs.changed(("WORK, WORK_PER_BYTE = 10**8, 10_000", "WORK, WORK_PER_BYTE = 10**5, 100"))
    assert "out of the checker's range: the limit work=15" in runs.verdict(lines, poor)
    lines[0]["statement"]["parameters"]["beta"] = f"1/{10**450}"
    assert runs.verdict(lines) == "REJECTED a number of the scene has more than 400 characters"
