"""From a state of the model system to its fate (proofs/from_state.md), beside the exact side rule."""

from __future__ import annotations

from typing import Any

import pytest
from flint import arb, fmpq

from gspot_verified.compliant.model.normal_form import compliant_model, compliant_state
from gspot_verified.compliant.side.side_rule import side_rule
from gspot_verified.expansion.from_state import model_side as module
from gspot_verified.expansion.from_state.choice import plans
from gspot_verified.expansion.from_state.model_side import ModelSide, model_side
from gspot_verified.expansion.from_state.passage import ModelStart, tube_from
from gspot_verified.expansion.from_state.slow_series import Contact
from gspot_verified.expansion.series.regularisation import PAPER
from gspot_verified.numbers.balls import working_bits
from gspot_verified.numbers.verdict import Outcome

BETA = fmpq(3, 2)


def at_rest(beta: fmpq, epsilon: fmpq, p: fmpq, b: fmpq) -> str | None:
    """The side of the exact rule for the start at rest, v = 0, lambda = -b/p, y = -2 epsilon^2 lambda, z = y/2."""
    force = -b / p
    state = compliant_state(p, b, -2 * epsilon**2 * force, 0, -(epsilon**2) * force)
    found = side_rule(compliant_model(beta, epsilon), state)
    return None if found.verdict.outcome is not Outcome.PROVED else "lift-off" if found.side < 0 else "impact"


CASES = [
    ("3/2", "-2", "lift-off", "1e-6"),
    ("3/2", "-1/2", "impact", "1e-7"),
    ("5/2", "-2/3", "impact", "1e-8"),
    ("5/2", "-1/6", "lift-off", "1e-9"),
    ("7/3", "-3/4", "impact", "1e-8"),
]


@pytest.mark.parametrize(
    ("beta", "b", "side", "epsilon"), [CASES[0], *(pytest.param(*case, marks=pytest.mark.slow) for case in CASES[1:])]
)
def test_the_side_is_that_of_the_exact_rule(beta: str, b: str, side: str, epsilon: str) -> None:
    """At several epsilon up to epsilon_0."""
    found = model_side(beta, "1/2", b, epsilon=epsilon)
    assert found.verdict.outcome is Outcome.PROVED
    assert found.side == side
    ratio, place = found.start.beta, found.start.b
    for factor in (1, 7, 1000):
        assert at_rest(ratio, found.epsilon / factor, fmpq(1, 2), place) == side


def test_the_sentence_says_what_its_letters_are() -> None:
    """phi, kappa, g, l and the units of the contact: without them nobody can tell whether a start belongs to it."""
    found = model_side("7/4", "1/2", "-1/3", epsilon="1e-9")
    assert found.side == "impact"
    statement = found.verdict.statement
    assert "(k_1 epsilon^2, k_2 epsilon^2, c epsilon) = (1, 1, 1)" in statement
    assert "phi = lambda_N + kappa y/epsilon^2 + (l/g) v/epsilon, kappa = 1/2, g = 2, l = 1/2" in statement
    assert "0 < epsilon <= 1/1000000000" in statement
    assert "until it exceeds 40/3;" in statement


def test_large_epsilon_is_undecided_and_says_why() -> None:
    found = model_side("5/2", "1/2", "-2/3", epsilon="1/100")
    assert found.side is None
    assert found.verdict.outcome is Outcome.UNDECIDED
    assert "Theorem B" in found.verdict.detail
    assert "stays below" in found.verdict.detail
    with pytest.raises(ValueError, match="nothing is proved"):
        found.latest("1e-9")


def test_a_force_that_is_nearly_zero_at_the_start_is_not_decided() -> None:
    """L = -0.97 of the mean force: contact may be lost at once."""
    found = model_side("5/2", "1/2", "-1/100", epsilon="1e-9")
    assert found.side is None
    assert "the force stays positive" in found.verdict.detail


def test_where_the_fast_part_decides_nothing_is_claimed() -> None:
    """beta = 13/2, epsilon = 1/1000: the exact rule gives the side that the slow part does not."""
    exact = at_rest(fmpq(13, 2), fmpq(1, 1000), fmpq(1, 2), fmpq(-2, 11))
    small = at_rest(fmpq(13, 2), fmpq(1, 10**6), fmpq(1, 2), fmpq(-2, 11))
    assert exact != small
    assert model_side("13/2", "1/2", "-2/11", epsilon="1/1000").side is None


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("3", "1/2", "-1"), "no integer"),
        (("1/2", "1/2", "-1"), "above 1"),
        (("61/2", "1/2", "-1"), "beta must be at most 30"),
        (("10001/2", "1/2", "-1"), "beta must be at most 30"),
        (("3/2", "0", "-1"), "p must be positive"),
        (("3/2", "1/2", "-1"), "distinguished trajectory"),
        (("3/2", "1/2", "-2", {"alpha_2": 1}), "mean force"),
        (("3/2", "1/2", "-2", {"within": -1}), "within"),
        (("3/2", "1/2", "-2", {"force": 1}), "force"),
        (("3/2", "1/2", "-2", {"epsilon": 0}), "epsilon"),
        (("3/2", "1/2", "-2", {"contact": (1, 1, 0)}), "damper"),
    ],
)
def test_bad_input(arguments: tuple[Any, ...], message: str) -> None:
    words = arguments[3] if len(arguments) > 3 else {}
    with pytest.raises(ValueError, match=message):
        model_side(*arguments[:3], **words)


def test_the_time_by_which_it_happens() -> None:
    """It falls with epsilon, and the exact slow lift-off lies before it."""
    found = model_side("3/2", "1/2", -2, epsilon="1e-6")
    assert found.latest("1e-6") < 0.01
    assert found.latest("1e-9") < found.latest("1e-6")
    with pytest.raises(ValueError, match="epsilon must lie"):
        found.latest("1e-5")


def test_the_way_to_the_hand_over_does_not_depend_on_the_unit_of_time() -> None:
    """alpha_1 = -8, half of everything per time: e = a epsilon is the same, and so is the barrier."""
    with working_bits(128):
        one = tube_from(_of(-1), fmpq(1, 100), next(plans(BETA, fmpq(1), Contact.of(PAPER))))
        eight = tube_from(_of(-8), fmpq(1, 200), next(plans(BETA, fmpq(8), Contact.of(PAPER))))
    assert not isinstance(one, str)
    assert not isinstance(eight, str)
    assert one[0].place == 2 * eight[0].place
    assert one[1].barrier == eight[1].barrier
    assert one[1].layer(arb("0.1")) == eight[1].layer(arb("0.1"))


def _of(alpha_1: int) -> ModelStart:
    return ModelStart(BETA, fmpq(alpha_1), fmpq(alpha_1), PAPER, fmpq(1, 2), fmpq(-2), fmpq(1, 100))


def test_a_search_ends_at_the_largest_that_is_proved(monkeypatch: pytest.MonkeyPatch) -> None:
    """The list is searched by halves; here a stand-in decides."""
    asked: list[fmpq] = []

    def decided(start: Any, _: Any, epsilon: fmpq, delta: fmpq, __: fmpq) -> Any:
        asked.append(delta)
        side = "impact" if delta <= fmpq(1, 50) else None
        return ModelSide(start, epsilon, start.c_1(), side, None, None, None, None, None, object())  # type: ignore[arg-type]

    monkeypatch.setattr(module, "_side", decided)
    assert model_side("5/2", "1/2", "-2/3").epsilon == fmpq(1, 125000)
    assert len(asked) < 7
