"""From a state of the model system to its fate (proofs/from_state.md), beside the exact side rule."""

from __future__ import annotations

import math
from fractions import Fraction
from types import SimpleNamespace
from typing import Any

import pytest
from flint import arb, fmpq
from samples.cones import cone_of
from samples.strategies import ends as exact_ends

from gspot_verified.compliant.model.normal_form import compliant_model, compliant_state
from gspot_verified.compliant.side.side_rule import side_rule
from gspot_verified.expansion.from_state import model_side as module
from gspot_verified.expansion.from_state.choice import LARGEST_DELTA, plans
from gspot_verified.expansion.from_state.model_side import ModelSide, model_side
from gspot_verified.expansion.from_state.passage import ModelStart, tube_from
from gspot_verified.expansion.from_state.slow_series import Contact
from gspot_verified.expansion.series.regularisation import PAPER
from gspot_verified.expansion.true_solutions.delta_ranges import smallest
from gspot_verified.expansion.true_solutions.side_end import SideEnd, latest_at
from gspot_verified.numbers.balls import working_bits
from gspot_verified.numbers.evidence import less
from gspot_verified.numbers.verdict import Outcome, Reason, Verdict

BETA, PLACE = fmpq(3, 2), fmpq(3, 2)
SHOWN = less(0, 1)
assert SHOWN is not None


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
    # near the largest that ranges of epsilon reach
    ("5/4", "-3", "lift-off", "1/2500"),
    ("3/2", "-2", "lift-off", "1/3000"),
    ("3/2", "-1/2", "impact", "1/4500"),
    ("7/3", "-3/4", "impact", "1/32000"),
    ("5/2", "-1/6", "lift-off", "1/70000"),
    ("7/2", "-2/5", "lift-off", "1/54000000"),
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
    assert "fast = lambda_N + kappa y/epsilon^2 + (l/g) v/epsilon, kappa = 1/2, g = 2, l = 1/2" in statement
    assert "0 < epsilon <= 1/1000000000" in statement
    # A start with b < -p 40/3 exceeds it already, with p > 0: the sentence is about later times.
    assert "where p = alpha_1 epsilon^(2/3) s; after that it stays so until it exceeds 40/3; p < 0 there" in statement


def test_large_epsilon_is_undecided_and_says_why() -> None:
    found = model_side("3/2", "1/20", "-1/8", epsilon="1/100")
    assert found.side is None
    assert found.verdict.outcome is Outcome.UNDECIDED
    assert "a smaller epsilon may do; it is proved up to epsilon = " in found.verdict.detail
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


def staged(side: int, until: fmpq) -> Any:
    """A stand-in for ``passage``: ranges up to ``until`` are proved."""

    def decided(_: Any, __: Any, least: fmpq, most: fmpq, ___: fmpq) -> Any:
        if most > until:
            return "too large"
        end = SideEnd(least, most, side, PLACE + least, cone_of("1.25"), arb(40), arb(77), (), SHOWN)
        return SimpleNamespace(end=end, plan=None, tube=None, handed=SimpleNamespace(coefficient=arb("1.5", "0.25")))

    return decided


@pytest.mark.parametrize("until", [LARGEST_DELTA, fmpq(1, 50), fmpq(1, 511), fmpq(1, 30000)])
def test_without_epsilon_ranges_are_followed_as_far_as_they_go(until: fmpq, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "passage", staged(1, until))
    found = model_side("5/2", "1/2", "-2/3")
    assert found.side == "impact"
    reached = found.ends[-1].most
    assert found.epsilon == reached**3
    assert until * fmpq(9, 10) < reached <= until
    assert f"for every 0 < epsilon <= {reached**3}," in found.verdict.statement
    assert found.entered == fmpq(3, 2)


def test_without_any_range_nothing_is_proved(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "passage", staged(1, fmpq(0)))
    found = model_side("5/2", "1/2", "-2/3")
    assert (found.side, found.ends, found.verdict.outcome) == (None, (), Outcome.UNDECIDED)
    assert found.verdict.detail == "too large"
    assert found.epsilon == smallest(LARGEST_DELTA) ** 3


def test_an_epsilon_beyond_what_is_proved_is_undecided(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "passage", staged(-1, fmpq(1, 50)))
    found = model_side("5/2", "1/2", "-2/3", epsilon="1/64000")
    assert (found.side, found.ends) == (None, ())
    assert found.verdict.detail.startswith("too large; it is proved up to epsilon = ")
    assert model_side("5/2", "1/2", "-2/3", epsilon="1/126000").side == "lift-off"


def test_ranges_on_different_sides_prove_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    one, other = staged(1, fmpq(1, 400)), staged(-1, fmpq(1, 50))
    monkeypatch.setattr(module, "passage", lambda *given: (one if given[2] == 0 else other)(*given))
    found = model_side("5/2", "1/2", "-2/3", epsilon="1/1000000")
    assert found.side is None
    assert found.verdict.detail == "different epsilon have different sides"


def fabricated(ends: tuple[SideEnd, ...] | None = None, **changes: Any) -> ModelSide:
    """A result whose numbers are round: by t = epsilon^(2/3) (3/2 + log(ratio/epsilon^(1/3))/rate)."""
    with working_bits(128):
        start = _of(-1)
        given = {
            "least": fmpq(0), "most": fmpq(1, 10), "side": -1, "entered": fmpq(3, 2), "cone": cone_of("1.25"),
            "ratio": arb(17, 1), "force": arb(0), "states": (), "evidence": SHOWN,
        }  # fmt: skip
        undecided = Verdict.undecided("words", Reason.BUDGET, "why")
        ends = (SideEnd(**(given | changes)),) if ends is None else ends
        return ModelSide(start, fmpq(1, 1000), fmpq(20), start.c_1(), "lift-off", ends, (), arb(0), undecided)


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
    with pytest.raises(ValueError, match="nothing is proved"):
        fabricated(ends=()).latest(fmpq(1, 1000))


def test_the_time_is_that_of_the_range_of_epsilon() -> None:
    parts = ((fmpq(0), fmpq(1, 20)), (fmpq(1, 20), fmpq(1, 10)))
    ends = tuple(SideEnd(*part, -1, fmpq(k), cone_of(1), arb(2), arb(0), (), SHOWN) for k, part in enumerate(parts, 1))
    found = fabricated(ends=ends)
    assert found.entered == 1
    for epsilon, place in ((fmpq(1, 8000), 1.0), (fmpq(1, 7999), 2.0), (fmpq(1, 1000), 2.0)):
        size = float(epsilon.p) / float(epsilon.q)
        wanted = size ** (2 / 3) * (place + math.log(2 / size ** (1 / 3)))
        assert math.isclose(float(found.latest(epsilon)), wanted, rel_tol=1e-12)


def test_the_time_is_rounded_upward() -> None:
    """The largest number in the ball of the ratio counts."""
    narrow, wide = fabricated(ratio=arb(18)), fabricated(ratio=arb(17, 1))
    with working_bits(128):
        assert 0 <= wide.latest("1e-3") - narrow.latest("1e-3") < arb("1e-8")
        assert narrow.latest("1e-3") < fabricated(ratio=arb("18.01")).latest("1e-3")
        scaled = latest_at(narrow.ends, fmpq(1, 1000), 2 * (narrow.start.beta - 1))
    (given, _), (wanted, _) = exact_ends(narrow.latest("1e-3")), exact_ends(scaled)
    assert 0 <= 100 * given - wanted < Fraction(1, 2**100)  # epsilon^(2/3) = 1/100


def test_what_is_printed() -> None:
    lines = str(fabricated()).splitlines()
    assert lines[-2].startswith("  C_1 = ")
    assert lines[-1].startswith("  at epsilon = 1/1000 by t = ")
    assert "by t" not in str(fabricated(ends=()))


def test_what_stands_where_nothing_is_given(monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[Any] = []

    def noted(*given: Any) -> Any:
        asked.append(given)
        return "found"

    monkeypatch.setattr(module, "_side", noted)
    assert model_side("5/2", "1/2", "-2/3", epsilon="1/8") == "found"
    ((start, epsilon, delta, factor),) = asked
    assert (start.alpha_1, start.alpha_2, start.regularisation) == (-1, -1, PAPER)
    assert (start.within, factor, epsilon) == (fmpq(1, 100), 10, fmpq(1, 8))
    assert fmpq(1, 2) <= delta < fmpq(1, 2) + fmpq(1, 10**8)
    asked.clear()
    model_side("5/2", "1/2", "-2/3", epsilon="1/3", force="1000001/1000000", alpha_1="-1/7", alpha_2="-1/9", within=0)
    ((start, epsilon, delta, factor),) = asked
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


@pytest.mark.parametrize(("side", "word"), [(-1, "lift-off"), (1, "impact")])
def test_what_is_made_of_a_passage(side: int, word: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """C_1 moves from 5/2 to 5/4 at most."""
    monkeypatch.setattr(module, "passage", staged(side, fmpq(1, 3)))
    monkeypatch.setattr(ModelStart, "c_1", lambda _: arb(fmpq(5, 2)))
    with working_bits(128):
        found = module._side(_of(-1), fmpq(1, 27), fmpq(1, 3), fmpq(11))
        assert found.side == word
        assert found.verdict.outcome is Outcome.PROVED
        assert (found.entered, found.ends[0].force, found.ends[0].cone.a) == (fmpq(3, 2), arb(77), arb("1.25"))
        assert found.drift is not None
        assert abs(found.drift - arb(2).log()) < arb("1e-7")
        assert found.drift >= arb(2).log()
    ends = "it vanishes later: contact is lost" if side < 0 else "until it exceeds 22; p < 0 there"
    assert found.verdict.statement.endswith(ends)
