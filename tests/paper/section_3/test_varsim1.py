"""The runs of Fig. varsim1: what is stated is what is checked, and each answer decides."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest
from flint import fmpq

from gspot_verified.compliant.model.normal_form import compliant_model
from gspot_verified.numbers.verdict import Outcome
from gspot_verified.paper.checks.entry import Rung
from gspot_verified.paper.numerics.paper_state import paper_state
from gspot_verified.paper.section_3 import varsim1

IMPACT, LIFT_OFF, TRIVIAL = (fmpq(3, 2), fmpq(1, 2)), (fmpq(3, 2), fmpq(2)), (fmpq(3, 2), fmpq(1))


@pytest.mark.parametrize("beta", list(varsim1.PANELS))
@pytest.mark.parametrize("nu", varsim1.FACTORS)
def test_the_initial_state_by_two_routes(beta: fmpq, nu: fmpq) -> None:
    epsilon = fmpq(1, 50)
    model, state = varsim1.initial_state(beta, nu, epsilon)
    assert model == compliant_model(beta, epsilon)
    assert state == paper_state(model, nu)


def test_the_runs_are_those_of_the_figure() -> None:
    assert {fmpq(1, 2): "a", fmpq(3, 2): "b", fmpq(5, 2): "c"} == varsim1.PANELS
    assert (fmpq(1, 4), fmpq(1, 2), 1, 2, 4) == varsim1.FACTORS
    assert {fmpq(1, 2): fmpq(1, 100), fmpq(3, 2): fmpq(1, 100), fmpq(5, 2): fmpq(1, 500)} == varsim1.EPSILON_0
    entry = varsim1.ENTRIES["3-varsim1c-1_4"]()
    assert entry.checks[0].rung is Rung.BALLS
    trivial = varsim1.ENTRIES["3-varsim1c-1"]()
    assert trivial.checks[0].rung is Rung.EXACT
    assert "every ε > 0" in trivial.statement
    assert f"every ε in (0, {varsim1.EPSILON_0[fmpq(5, 2)]}]" in entry.statement
    shown = ", ".join(f"10^-{len(str(int(1 / point))) - 1}" for point in varsim1.POINTS)
    assert entry.checks[1].what.endswith(f"at ε = {shown}")
    assert all(point == fmpq(1, 10 ** (len(str(int(1 / point))) - 1)) for point in varsim1.POINTS)


@pytest.mark.parametrize(("power", "time"), [(3, fmpq(2, 10**2)), (6, fmpq(2, 10**4)), (12, fmpq(2, 10**8))])
def test_a_time_near_two_in_the_scaled_one(power: int, time: fmpq) -> None:
    assert varsim1._some_time(fmpq(1, 10**power)) == time


def test_which_fate() -> None:
    fates = {nu: varsim1.expected(fmpq(3, 2), nu) for nu in varsim1.FACTORS}
    assert list(fates.values()) == ["impact", "impact", "trivial", "lift-off", "lift-off"]
    assert varsim1.expected(fmpq(1, 2), fmpq(1)) != "trivial"
    assert varsim1.expected(fmpq(1), fmpq(1)) != "trivial"


@pytest.mark.parametrize(("margin", "answer"), [(fmpq(1, 9), True), (fmpq(0), None), (fmpq(-1), None), (None, None)])
def test_a_margin_must_be_positive(monkeypatch: pytest.MonkeyPatch, margin: fmpq | None, answer: bool | None) -> None:
    monkeypatch.setattr(varsim1, "margin_up_to", lambda *_: margin)
    assert varsim1.for_every_epsilon(*IMPACT) is answer
    assert varsim1.for_every_epsilon(*TRIVIAL) is True


@pytest.mark.parametrize("part", ["b", "V", "Y", "Z"])
@pytest.mark.parametrize("position", range(3))
def test_a_deviation_in_one_part_is_not_trivial(monkeypatch: pytest.MonkeyPatch, part: str, position: int) -> None:
    hats = [SimpleNamespace(b=0, V=0, Y=0, Z=0) for _ in varsim1.POINTS]
    waiting = iter(hats)
    monkeypatch.setattr(varsim1, "deviation", lambda *_: next(waiting))
    assert varsim1._is_trivial(*TRIVIAL)
    setattr(hats[position], part, fmpq(1, 10**9))
    waiting = iter(hats)
    assert not varsim1._is_trivial(*TRIVIAL)


@pytest.mark.parametrize(
    ("run", "side", "lasts", "lower", "answer"),
    [
        (IMPACT, 1, True, None, True),
        (IMPACT, 1, False, None, None),
        (IMPACT, 0, True, None, None),
        (IMPACT, -1, True, None, False),
        (LIFT_OFF, -1, True, fmpq(1, 9), True),
        (LIFT_OFF, -1, True, None, None),
        (LIFT_OFF, -1, True, fmpq(0), False),
        (LIFT_OFF, -1, True, fmpq(-1), False),
        (LIFT_OFF, 0, True, fmpq(1, 9), None),
        (LIFT_OFF, 1, True, fmpq(1, 9), False),
        (TRIVIAL, 0, True, None, True),
        (TRIVIAL, 0, False, None, None),
    ],
)
def test_the_answer_at_points(
    monkeypatch: pytest.MonkeyPatch, run: Any, side: int, lasts: bool, lower: fmpq | None, answer: bool | None
) -> None:
    outcome = Outcome.PROVED if lasts else Outcome.UNDECIDED
    monkeypatch.setattr(varsim1, "side_rule", lambda *_: SimpleNamespace(side=side))
    monkeypatch.setattr(varsim1, "contact_lasts", lambda *_: SimpleNamespace(outcome=outcome))
    monkeypatch.setattr(varsim1, "first_zero", lambda *_, **__: SimpleNamespace(lower=lower))
    assert varsim1.at_points(*run) is answer
    at_first = iter([outcome])
    monkeypatch.setattr(varsim1, "contact_lasts", lambda *_: SimpleNamespace(outcome=next(at_first, Outcome.UNDECIDED)))
    if run is TRIVIAL:
        assert varsim1.at_points(*run) is None  # it lasts at the first point alone
