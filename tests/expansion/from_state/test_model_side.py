"""From a state of the model system to its fate (proofs/from_state.md), beside the exact side rule."""

from __future__ import annotations

import math
from types import SimpleNamespace
from typing import Any

import pytest
from flint import arb, fmpq

from gspot_verified.compliant.model.normal_form import compliant_model, compliant_state
from gspot_verified.compliant.side.side_rule import side_rule
from gspot_verified.expansion.from_state import model_side as module
from gspot_verified.expansion.from_state.choice import DELTAS, plans
from gspot_verified.expansion.from_state.model_side import ModelSide, model_side
from gspot_verified.expansion.from_state.passage import ModelStart, tube_from
from gspot_verified.expansion.from_state.slow_series import Contact
from gspot_verified.expansion.series.regularisation import PAPER
from gspot_verified.numbers.balls import working_bits
from gspot_verified.numbers.evidence import less
from gspot_verified.numbers.verdict import Outcome, Reason, Verdict

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


def fabricated(**changes: Any) -> ModelSide:
    """A result whose numbers are round: by t = epsilon^(2/3) (3/2 + log(ratio/epsilon^(1/3))/rate)."""
    with working_bits(128):
        start = _of(-1)
        given = {
            "side": "lift-off", "entered": fmpq(3, 2), "drift": arb(0), "rate": arb("1.25"), "ratio": arb(17, 1),
            "force": arb(0), "verdict": Verdict.undecided("words", Reason.BUDGET, "why"),
        }  # fmt: skip
        return ModelSide(start, fmpq(1, 1000), start.c_1(), **(given | changes))


def test_the_time_is_that_of_the_page() -> None:
    found = fabricated(ratio=arb(18))
    for epsilon in (fmpq(1, 1000), fmpq(1, 10**6)):
        size = float(epsilon.p) / float(epsilon.q)
        wanted = size ** (2 / 3) * (1.5 + math.log(18 / size ** (1 / 3)) / 1.25)
        with working_bits(128):
            assert math.isclose(float(found.latest(epsilon)), wanted, rel_tol=1e-14)
            assert found.latest(epsilon).is_exact()
    for epsilon in (fmpq(0), fmpq(-1), fmpq(1001, 10**6)):
        with pytest.raises(ValueError, match=r"epsilon must lie in \(0, 1/1000\]"):
            found.latest(epsilon)
    for missing in ("entered", "rate", "ratio"):
        with pytest.raises(ValueError, match="nothing is proved"):
            fabricated(**{missing: None}).latest(fmpq(1, 1000))


def test_the_time_is_rounded_upward() -> None:
    """The largest number in the ball of the ratio counts."""
    narrow, wide = fabricated(ratio=arb(18)), fabricated(ratio=arb(17, 1))
    with working_bits(128):
        assert 0 <= wide.latest("1e-3") - narrow.latest("1e-3") < arb("1e-8")
        assert narrow.latest("1e-3") < fabricated(ratio=arb("18.01")).latest("1e-3")


def test_what_is_printed() -> None:
    lines = str(fabricated()).splitlines()
    assert lines[-2].startswith("  C_1 = ")
    assert lines[-1].startswith("  at epsilon = 1/1000 by t = ")
    assert "by t" not in str(fabricated(entered=None))


def test_what_stands_where_nothing_is_given(monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[Any] = []

    def noted(*given: Any) -> Any:
        asked.append(given)
        return "found"

    monkeypatch.setattr(module, "_side", noted)
    assert model_side("5/2", "1/2", "-2/3", epsilon="1/8") == "found"
    ((start, _, epsilon, delta, factor),) = asked
    assert (start.alpha_1, start.alpha_2, start.regularisation) == (-1, -1, PAPER)
    assert (start.within, factor, epsilon) == (fmpq(1, 100), 10, fmpq(1, 8))
    assert fmpq(1, 2) <= delta < fmpq(1, 2) + fmpq(1, 10**8)
    asked.clear()
    model_side("5/2", "1/2", "-2/3", epsilon="1/3", force="1000001/1000000", alpha_1="-1/7", alpha_2="-1/9", within=0)
    ((start, _, epsilon, delta, factor),) = asked
    assert delta**3 >= epsilon
    assert (delta - fmpq(1, 10**8)) ** 3 < epsilon
    assert (start.alpha_1, start.alpha_2, start.within) == (fmpq(-1, 7), fmpq(-1, 9), 0)
    model_side("5/2", "1/10", "-1/100", epsilon="1/1000000")  # p < 1, L = -17/30


@pytest.mark.parametrize(
    ("words", "message"),
    [
        ({"alpha_1": 0}, "mean force"),
        ({"alpha_1": 1}, "mean force"),
        ({"alpha_2": 0}, "mean force"),
        ({"within": "-1/1000"}, "within"),
        ({"force": "1"}, "force"),
        ({"epsilon": "-1/9"}, "epsilon"),
        ({"p": "-1/9"}, "p must be positive"),
    ],
)
def test_what_is_refused_at_the_edges(words: dict[str, Any], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        model_side("3/2", words.pop("p", "1/2"), "-2", **words)


def staged_passage(side: int) -> Any:
    return SimpleNamespace(
        entry=SimpleNamespace(side=side, place=fmpq(3, 2), Y=arb("0.5", "0.25")),
        cone=SimpleNamespace(top=arb(9, 1), a=arb("1.25")),
        handed=SimpleNamespace(coefficient=arb("1.5", "0.25")),
        force=arb(77),
        evidence=less(0, 1),
    )


@pytest.mark.parametrize(("side", "word"), [(-1, "lift-off"), (1, "impact")])
def test_what_is_made_of_a_passage(side: int, word: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Y_max/Y_1 is at most 10/(1/4), and C_1 moves from 5/2 to 5/4 at most."""
    monkeypatch.setattr(module, "passage", lambda *_: staged_passage(side))
    monkeypatch.setattr(ModelStart, "c_1", lambda _: arb(fmpq(5, 2)))
    with working_bits(128):
        found = module._side(_of(-1), None, fmpq(1, 27), fmpq(1, 3), fmpq(11))  # type: ignore[arg-type]
        assert found.side == word
        assert found.verdict.outcome is Outcome.PROVED
        assert (found.entered, found.force, found.rate) == (fmpq(3, 2), arb(77), arb("1.25"))
        assert abs(found.ratio - 40) < arb("1e-7")
        assert found.ratio >= 40
        assert abs(found.drift - arb(2).log()) < arb("1e-7")
        assert found.drift >= arb(2).log()
    ends = "it vanishes later: contact is lost" if side < 0 else "until it exceeds 22; p < 0 there"
    assert found.verdict.statement.endswith(ends)


@pytest.mark.parametrize("last", range(len(DELTAS) + 1))
def test_a_search_finds_the_largest_wherever_it_stands(last: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """DELTAS[last:] are proved; past the end: none."""
    asked: list[fmpq] = []

    def decided(start: Any, _: Any, epsilon: fmpq, delta: fmpq, __: fmpq) -> Any:
        asked.append(delta)
        assert epsilon == delta**3
        side = "impact" if delta in DELTAS[last:] else None
        return ModelSide(start, epsilon, start.c_1(), side, None, None, None, None, None, object())  # type: ignore[arg-type]

    monkeypatch.setattr(module, "_side", decided)
    found = model_side("5/2", "1/2", "-2/3")
    assert found.side == ("impact" if last < len(DELTAS) else None)
    assert found.epsilon == DELTAS[min(last, len(DELTAS) - 1)] ** 3
    assert asked[0] == DELTAS[-1]
    assert len(asked) <= (6 if last < len(DELTAS) else 1)
    assert len(set(asked[1:])) == len(asked) - 1
