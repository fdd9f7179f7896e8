"""The relaxation of the surface: each of the two routes asks for the rest, the rate and the phase."""

from __future__ import annotations

import pytest

from gspot_verified.paper.section_2 import section_2_contact as ledger


@pytest.mark.parametrize(
    ("phase", "table", "text", "relaxes", "springs"),
    [
        ("contact", "REST", "1/3*y", False, False),
        ("flight", "REST", "1/3*y", False, False),
        ("contact", "RATE", "-z - 2*(z - y)", False, True),
        ("contact", "RATE", "-z - (z - y) + 1", False, True),
        ("flight", "RATE", "-2*z", False, True),
        ("contact", "SPRINGS", "-k1*z - 2*k2*(z - y)", True, False),
        ("contact", "SPRINGS", "-2*k1*z - 2*k2*(z - y)", True, False),  # the same rest, twice the rate
        ("contact", "SPRINGS", "-k1*z - k2*(z - y) + k1*y", True, False),  # the same rate, another rest
        ("flight", "SPRINGS", "-2*k1*z", True, False),
        ("flight", "SPRINGS", "-k1*z + k2*y", True, False),
    ],
)
def test_other_formulas(
    monkeypatch: pytest.MonkeyPatch, phase: str, table: str, text: str, relaxes: bool, springs: bool
) -> None:
    assert ledger.relaxes(phase) is ledger.of_the_springs(phase) is True
    monkeypatch.setitem(getattr(ledger, table), phase, text)
    assert ledger.relaxes(phase) is relaxes
    assert ledger.of_the_springs(phase) is springs


@pytest.mark.parametrize(("phase", "decay"), [("contact", 1), ("contact", 3), ("flight", 2), ("flight", 0)])
def test_other_rates(monkeypatch: pytest.MonkeyPatch, phase: str, decay: int) -> None:
    monkeypatch.setitem(ledger.DECAY, phase, decay)
    assert ledger.relaxes(phase) is ledger.of_the_springs(phase) is False


@pytest.mark.parametrize(
    ("phase", "rate", "rest", "answer"),
    [
        ("contact", "-2*z + 4*y", "2*y", False),  # at y = -1 a rest below y: the contact would be lost
        ("contact", "-2*z + 2*y", "y", False),
        ("contact", "-2*z + y", "1/2*y", True),
        ("contact", "-2*z + y - 1/2", "1/2*y - 1/4", False),  # above y at y = -1, and below it at y = -1/4
        ("flight", "-z + 2*y", "2*y", False),  # at y = 1 a rest above y
        ("flight", "-z + y", "y", False),
        ("flight", "-z + 1/2*y", "1/2*y", True),
        ("flight", "-z + 1/2", "1/2+0*y", False),
    ],
)
def test_a_rest_in_the_other_phase(
    monkeypatch: pytest.MonkeyPatch, phase: str, rate: str, rest: str, answer: bool
) -> None:
    monkeypatch.setitem(ledger.RATE, phase, rate)
    monkeypatch.setitem(ledger.REST, phase, rest)
    assert ledger.relaxes(phase) is answer


@pytest.mark.parametrize(
    ("phase", "rate", "answer"),
    [
        ("contact", "-z - (z - y)", True),
        ("contact", "-z", True),
        ("contact", "-1/2*z", False),  # at z = y > 0 slower than y/ε
        ("contact", "z", False),
        ("flight", "-z", True),
        ("flight", "0*z", False),  # z never comes back to y
        ("flight", "-z - 1", False),
    ],
)
def test_a_start_in_the_other_phase(monkeypatch: pytest.MonkeyPatch, phase: str, rate: str, answer: bool) -> None:
    monkeypatch.setitem(ledger.RATE, phase, rate)
    assert ledger.leaves_the_other_phase("flight" if phase == "contact" else "contact") is answer
