"""Sentences on the simulations: what each step must refuse, and that what could not be told is left open."""

from __future__ import annotations

from dataclasses import replace
from itertools import chain
from types import SimpleNamespace
from typing import Any

import pytest
from flint import fmpq

from gspot_verified.numbers.verdict import Outcome
from gspot_verified.paper.section_3 import section_3_sentences as ledger
from gspot_verified.paper.section_3 import varsim1
from gspot_verified.scenes.scene.run import IMPACT

read = ledger.ALGEBRA.read


@pytest.mark.parametrize(
    ("text", "answer"),
    [
        ("-p*(4*p^2 - 13*p + 32)", True),
        ("-p*(p^2 + 1)", True),
        ("-p*(4*p^2 - 13*p + 10)", False),  # two real zeros
        ("-p*(p^2 - 2*p + 1)", False),  # a double zero
        ("-p*(p^2 - 5*p + 1)", False),
        ("p*(4*p^2 - 13*p + 32)", False),
        ("-p*(4*p^2 - 13*p + 32) + 1", False),
        ("-p^2*(4*p^2 - 13*p + 32)", False),
        ("0*p", False),
    ],
)
def test_negative_for_every_positive_p(text: str, answer: bool) -> None:
    assert ledger.negative_for_positive_p(read(text)) is answer


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("DISCRIMINANT", "-p*(4*p^2 - 13*p + 33)"),
        ("CUBIC", "r^3 + 2*r^2 + p*r + 2*p"),
        ("CUBIC", "r^3 + 3*r^2 + p*r + p"),
        ("CUBIC", "r^3 + 2*r^2 + p*r + p^2"),
    ],
)
def test_another_cubic_has_other_roots(monkeypatch: pytest.MonkeyPatch, name: str, text: str) -> None:
    assert ledger.rates_of_the_contact()
    assert ledger.one_real_root_below_minus_one()
    monkeypatch.setattr(ledger, name, text)
    assert not ledger.one_real_root_below_minus_one()
    assert ledger.rates_of_the_contact() is (name == "DISCRIMINANT")


def test_signs_at_the_ends_of_an_interval() -> None:
    below, above = read("-p"), read("1+p")
    assert ledger._opposite(below, above)
    assert not ledger._opposite(above, below)
    assert not ledger._opposite(below, below)
    assert not ledger._opposite(above, above)
    assert not ledger._opposite(below, read("1-p"))


@pytest.mark.parametrize(
    ("cubic", "answer"),
    [
        ("(r+3)*(2*r^2 + r + 5)", True),
        ("(r+3)*(r^2 - r + 5)", False),  # growing
        ("(r+3)*(r^2 + 4*r + 5)", False),  # damped too fast
        ("(r+1)*(r+2)*(r+3)", False),  # no oscillation
        ("2*r^2 + r + 5", False),  # a pair alone
    ],
)
def test_damped_oscillations_by_their_roots(monkeypatch: pytest.MonkeyPatch, cubic: str, answer: bool) -> None:
    monkeypatch.setattr(ledger, "CUBIC", cubic)
    assert ledger.damped_and_oscillating(fmpq(1, 2)) is answer


def test_the_roots_at_one_p() -> None:
    assert all(ledger.damped_and_oscillating(p) for p in (*ledger.AT, fmpq(22, 7)))
    assert not ledger.damped_and_oscillating(fmpq(-1))


MIXED = {
    "as claimed": (("impact", "impact", "lift-off", "lift-off"), True),
    "the other way": (("lift-off", "lift-off", "impact", "impact"), True),
    "one fate": (("impact",) * 4, False),
    "one of each on each side": (("impact", "lift-off", "impact", "lift-off"), False),
    "exchanged": (("impact", "lift-off", "lift-off", "impact"), False),
    "another fate": (("impact", "impact", "trivial", "trivial"), False),
    "one unknown": (("impact", "impact", "lift-off", None), None),
}
"""Fates of ν = 1/4, 1/2, 2, 4."""


@pytest.mark.parametrize(("fates", "answer"), MIXED.values(), ids=MIXED)
def test_two_sides_are_parted(
    monkeypatch: pytest.MonkeyPatch, fates: tuple[str | None, ...], answer: bool | None
) -> None:
    fate_of = dict(zip(chain(*ledger.SIDES), fates, strict=True))
    monkeypatch.setattr(varsim1, "proved_fate", lambda _, nu: fate_of[nu])
    assert ledger.parted(fmpq(3, 2)) is answer


@pytest.mark.parametrize(
    ("signs", "answer"),
    [
        ((1, 1, -1, -1), True),
        ((-1, -1, 1, 1), True),
        ((1, -1, 1, -1), False),
        ((-1, -1, -1, -1), False),
        ((1, 1, 0, 0), False),
        ((1, 1, -1, None), None),
    ],
)
def test_sides_differ_at_every_epsilon(
    monkeypatch: pytest.MonkeyPatch, signs: tuple[int | None, ...], answer: bool | None
) -> None:
    tried = []
    sign_at = dict(zip(chain(*ledger.SIDES), signs, strict=True))

    def side_rule(nu: fmpq, epsilon: fmpq) -> Any:
        tried.append(epsilon)
        return SimpleNamespace(side=sign_at[nu])

    monkeypatch.setattr(varsim1, "initial_state", lambda _, nu, epsilon: (nu, epsilon))
    monkeypatch.setattr(ledger, "side_rule", side_rule)
    monkeypatch.setattr(ledger, "sign_of", lambda side: side)
    assert ledger.sides_differ(fmpq(3, 2)) is answer
    assert set(tried) == set(varsim1.POINTS)


def test_the_statement_has_the_epsilon_that_the_proof_reaches(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(ledger, "parted", lambda *_: True)
    monkeypatch.setattr(ledger, "sides_differ", lambda *_: True)
    before = "β = 3/2 (every ε <= 1/100), β = 5/2 (every ε <= 1/500): "
    assert ledger.ENTRIES["3-separatrix"]().statement.startswith(before)
    monkeypatch.setitem(varsim1.EPSILON_0, fmpq(5, 2), fmpq(1, 700))
    assert ledger.ENTRIES["3-separatrix"]().statement.startswith(before.replace("500", "700"))


@pytest.mark.parametrize(
    ("outcome", "fate", "answer"),
    [
        (Outcome.PROVED, IMPACT, True),
        (Outcome.PROVED, "lift-off", False),
        (Outcome.UNDECIDED, IMPACT, None),
        (Outcome.UNDECIDED, "lift-off", None),
    ],
)
def test_the_fate_of_a_certified_run(
    monkeypatch: pytest.MonkeyPatch, outcome: Outcome, fate: str, answer: bool | None
) -> None:
    asked: dict[str, Any] = {}

    def load(name: str, **values: Any) -> str:
        asked.update(values, name=name)
        return "scene"

    def run(scene: str, *_: Any) -> Any:
        assert scene == "scene"
        return SimpleNamespace(fate=fate, verdict=SimpleNamespace(outcome=outcome))

    monkeypatch.setattr(ledger, "load_scene", load)
    monkeypatch.setattr(ledger, "certified_run", run)
    assert ledger.attracted_takes_an_impact(fmpq(2), fmpq(1, 1000)) is answer
    case = {"beta": fmpq(1, 2), "nu": fmpq(2), "epsilon": fmpq(1, 1000), "alpha_2": fmpq(1)}
    assert asked == case | {"name": "fig-varsim1"}


@pytest.mark.parametrize(
    ("upper", "answer"), [(None, None), (fmpq(-1, 9), True), (fmpq(0), False), (fmpq(1, 2), False)]
)
def test_lift_off_before_the_g_spot(monkeypatch: pytest.MonkeyPatch, upper: fmpq | None, answer: bool | None) -> None:
    monkeypatch.setattr(ledger, "first_zero", lambda *_, **__: SimpleNamespace(upper=upper))
    assert ledger.other_lifts_off_before(fmpq(1, 4), fmpq(1, 1000)) is answer


@pytest.mark.parametrize(
    ("lower", "answer"), [(None, None), (fmpq(-1, 9), False), (fmpq(0), False), (fmpq(1, 2), True)]
)
def test_lift_off_after_the_g_spot(monkeypatch: pytest.MonkeyPatch, lower: fmpq | None, answer: bool | None) -> None:
    monkeypatch.setattr(ledger, "first_zero", lambda *_, **__: SimpleNamespace(lower=lower, upper=fmpq(2)))
    assert ledger.lost_after(ledger.NEAR, fmpq(1, 1000)) is answer
    assert ledger._passes_and_lifts_off(fmpq(1, 1000)).agrees is (False if answer else None)


def test_a_flight_that_ends_refutes_no_impact(monkeypatch: pytest.MonkeyPatch) -> None:
    """Lost contact is no end of it: an impact can follow a touch-down."""
    assert ledger.flies_for_ever(ledger.NEAR, fmpq(1, 1000)) is True
    assert ledger.flies_for_ever(fmpq(101, 100), fmpq(1, 1000)) is None
    monkeypatch.setattr(ledger, "flies_for_ever", lambda *_: None)
    assert ledger._passes_and_lifts_off(fmpq(1, 1000)).agrees is None


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("b", "r*p"),
        ("v", "r*p"),
        ("y", "2*e^2*r"),
        ("z", "e^2*r"),
        ("y", "-e^2*r"),
        ("alpha_1", "-x"),  # α_3 = α_1: no trivial solution
        ("alpha_2", "-y"),
        ("alpha_3", "-u - 2*x"),  # Case III
        ("alpha_3", "x"),
    ],
)
def test_the_trivial_solution_of_case_ii(monkeypatch: pytest.MonkeyPatch, name: str, text: str) -> None:
    assert ledger.trivial_keeps_contact() is True
    monkeypatch.setitem(ledger.TRIVIAL if name in ledger.TRIVIAL else ledger.CASE_II_SIGNS, name, text)
    assert ledger.trivial_keeps_contact() is None


def test_close_to_the_trivial_solution_of_case_ii_the_side_changes() -> None:
    model, trivial = ledger.case_ii(fmpq(1), fmpq(1, 1000))
    assert model.mean_force == 2
    hats = ledger.deviation(model, trivial)
    assert (hats.b, hats.V, hats.Y, hats.Z) == (0, 0, 0, 0)
    assert ledger.lost_after(fmpq(99, 100), fmpq(1, 1000)) is True
    assert ledger.side_is(fmpq(101, 100), fmpq(1, 1000), 1) is True


@pytest.mark.parametrize(
    ("change", "answer"),
    [({}, True), ({"V": fmpq(1, 9)}, None), ({"Y": fmpq(1)}, None), ({"Z": fmpq(1)}, None), ({"b": fmpq(7)}, None)],
)
def test_another_start_has_another_share(
    monkeypatch: pytest.MonkeyPatch, change: dict[str, fmpq], answer: bool | None
) -> None:
    honest = ledger.deviation
    monkeypatch.setattr(ledger, "deviation", lambda *state: replace(honest(*state), **change))
    assert ledger.same_share() is answer


def test_the_share_is_that_of_every_alpha_2(monkeypatch: pytest.MonkeyPatch) -> None:
    honest = ledger.case_ii
    monkeypatch.setattr(ledger, "case_ii", lambda nu, epsilon, _=1: honest(nu, epsilon))
    assert ledger.same_share() is None


@pytest.mark.parametrize(("share", "answer"), [(None, None), (-1, None), (0, None), (1, True)])
def test_the_share_must_be_positive(monkeypatch: pytest.MonkeyPatch, share: int | None, answer: bool | None) -> None:
    monkeypatch.setattr(ledger, "least_share", lambda *_: share)
    assert ledger.share_grows() is answer


@pytest.mark.parametrize(("side", "answers"), [(1, [True, False]), (-1, [False, True]), (None, [None, None])])
def test_the_side_of_a_start(monkeypatch: pytest.MonkeyPatch, side: int | None, answers: list[bool | None]) -> None:
    monkeypatch.setattr(ledger, "side_rule", lambda *_: SimpleNamespace(side=side))
    monkeypatch.setattr(ledger, "sign_of", lambda value: value)
    assert [ledger.side_is(fmpq(2), fmpq(1, 1000), sign) for sign in (1, -1)] == answers


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("b", "b + alpha2*u^2"),
        ("v", "v + b*u + alpha2*u^2"),
        ("y", "y + v*u + b*u^2 + alpha2*u^3/6"),
        ("b", "1 + b + alpha2*u"),  # solves the equations from another state
        ("y", "1 + y + v*u + b*u^2/2 + alpha2*u^3/6"),
    ],
)
def test_another_motion_is_not_that_of_the_flight(monkeypatch: pytest.MonkeyPatch, name: str, text: str) -> None:
    assert ledger.free_motion()
    monkeypatch.setitem(ledger.FLIGHT, name, text)
    assert not ledger.free_motion()


def test_the_flight_ends_for_a_falling_b_alone() -> None:
    assert ledger.falls_for_ever()
    assert not ledger.falls_for_ever(alpha_2_is_negative=False)
    assert ledger.below_a_line()


@pytest.mark.parametrize(
    ("name", "text", "falls"),
    [
        ("y", "y + v*u + b*u^2/2 + alpha2*u^3/7", True),
        ("v", "v + b*u + alpha2*u^2/3", True),
        ("y", "y + v*u + b*u^2/2 - alpha2*u^3/6", False),
        ("v", "v + b*u - alpha2*u^2/2", False),
    ],
)
def test_v_and_y_fall_both(monkeypatch: pytest.MonkeyPatch, name: str, text: str, falls: bool) -> None:
    monkeypatch.setitem(ledger.FLIGHT, name, text)
    assert ledger.falls_for_ever() is falls
    assert not ledger.below_a_line()
