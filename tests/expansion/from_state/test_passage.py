"""From a start of the model system to the hand-over (proofs/from_state.md, sections 4 to 6): what is handed on."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import pytest
from flint import arb, fmpq
from samples.cones import cone_of

from gspot_verified.expansion.from_state import passage as module
from gspot_verified.expansion.from_state.barrier import Start, Tube, start_bound
from gspot_verified.expansion.from_state.choice import LARGEST, Plan
from gspot_verified.expansion.from_state.fast_growth import Growth, Norm, Rectangle
from gspot_verified.expansion.from_state.passage import (
    ModelStart,
    Passage,
    checked_ratio,
    model_system,
    passage,
    rounded_up,
    trajectory_of,
    tube_from,
)
from gspot_verified.expansion.from_state.slow_series import Contact, slow_series
from gspot_verified.expansion.series.regularisation import PAPER, Regularisation
from gspot_verified.expansion.trajectory import expand_system
from gspot_verified.expansion.true_solutions.bound import rational
from gspot_verified.expansion.true_solutions.side_end import SideEnd
from gspot_verified.functions.box_program import BoxProgram
from gspot_verified.numbers.balls import working_bits
from gspot_verified.numbers.evidence import less

SPRINGS = Regularisation.of(2, 3, "1/2")
BETA, A, P, DELTA = fmpq(7, 3), fmpq(2), fmpq(1, 3), fmpq(1, 50)
SHOWN = less(0, 1)
assert SHOWN is not None
ENDED = SideEnd(DELTA / 2, DELTA, -1, fmpq(3, 2), cone_of(1), arb(20), arb(2), (), SHOWN)
RESIDUALS = SimpleNamespace(trajectory="trajectory")


@pytest.fixture(autouse=True)
def _bits() -> Iterator[None]:
    with working_bits(128):
        yield


def start_with(b: str = "-1") -> ModelStart:
    """The mean force is 9/8, and -b/p = 3 for b = -1, 3/4 for b = -1/4."""
    return ModelStart(BETA, -A, fmpq(-3), SPRINGS, P, rational(b, "b"), fmpq(1, 100))


def plan(growth: int = 1) -> Plan:
    return Plan(fmpq(1), fmpq(1, 2), fmpq(growth), fmpq(1, 10), 3, fmpq(5, 2))


def test_the_numbers_of_a_start() -> None:
    start = start_with()
    force, third = start.mean_force, BETA * -A
    assert force == fmpq(9, 8)
    assert start.alpha_2 - third * force == -start.alpha_1 * force  # b' = -p' lambda on b = -p lambda
    assert start.excess == 3 - fmpq(9, 8)
    wanted = -arb(fmpq(15, 8)) * arb(3) ** arb(fmpq(4, 3))  # -L p^(1 - beta)
    assert abs(start.c_1() - wanted) < arb("1e-30")
    assert start_with("-1/4").excess == fmpq(-3, 8)
    assert start_with("-1/4").c_1() > 0


def test_the_trajectory_is_that_of_the_starts_numbers() -> None:
    assert trajectory_of(start_with()).system.check() == (-A, -3, -BETA * A)
    assert trajectory_of(start_with()).system.regularisation == SPRINGS


def test_which_beta_is_looked_at() -> None:
    for beta in (fmpq(101, 100), fmpq(3, 2), fmpq(59, 2)):
        assert checked_ratio(beta) == beta
    for beta in (fmpq(1), fmpq(2), fmpq(1, 2), fmpq(30), fmpq(61, 2)):
        with pytest.raises(ValueError, match="beta must be"):
            checked_ratio(beta)


def test_what_is_rounded_up_lies_above_the_whole_ball() -> None:
    bit = fmpq(1, 2**30)
    for value in (arb(fmpq(1, 3)), arb("0.3", "0.01"), arb(5), arb(0), arb(-1) / 3):
        found = rounded_up(value)
        assert value <= arb(found)
        assert arb(found - 2 * bit) < value.upper() + arb("1e-20")
        assert (found * 2**30).q == 1
    assert rounded_up(arb(5)) == 5
    for none in (arb("nan"), arb("inf")):
        with pytest.raises(ValueError, match="too large"):
            rounded_up(none)


@pytest.mark.parametrize(
    ("b", "side", "share"), [("-1", 1, fmpq(5, 3)), ("-1/2", 1, fmpq(1, 3)), ("-1/4", -1, fmpq(1, 3))]
)
def test_what_theorem_b_is_asked(b: str, side: int, share: fmpq, monkeypatch: pytest.MonkeyPatch) -> None:
    """h_1 >= (a S^3)^(-1/2), r_1 >= sqrt(p_1), e_0 = a delta_0^3, (8), and each z_max, the smallest first."""
    asked: list[Any] = []

    def growth_of(norm: Norm, rectangle: Rectangle, rate: fmpq, damping: fmpq) -> Growth:
        asked.append((norm, rectangle, rate, damping))
        return Growth(rate, damping, SHOWN, 1, "")

    def refused(norm: Norm, growth: Growth, rectangle: Rectangle, start: Start, largest: fmpq) -> str:
        asked.append((norm, growth, rectangle, start, largest))
        return f"z_max = {largest}"

    monkeypatch.setattr(module, "fast_growth", growth_of)
    monkeypatch.setattr(module, "tube", refused)
    found = tube_from(start_with(b), DELTA, [plan()])
    (norm, rectangle, rate, damping), *tried = asked
    series = slow_series(BETA, Contact.of(SPRINGS), 3)
    assert norm == Norm(series, fmpq(1), fmpq(1, 2))
    assert (rate, damping) == (1, fmpq(1, 10))
    near = 1 + fmpq(1, 10**7)
    assert 1 <= rectangle.h**2 * A * fmpq(5, 2) ** 3 < near
    assert rectangle.r**2 >= P > rectangle.r**2 / near
    assert [largest for *_, largest in tried] == list(LARGEST)
    for again, growth, same, start, _ in tried:
        assert (again, same) == (norm, rectangle)
        assert growth.evidence is SHOWN
        z = start_bound(series, P, A * DELTA**3, fmpq(1, 100))
        assert (start.p, start.e, start.side, start.share) == (P, A * DELTA**3, side, share)
        assert start.z == z
    assert found == f"z_max = {LARGEST[-1]} ({plan().text})"


def test_the_first_plan_that_passes_is_taken(monkeypatch: pytest.MonkeyPatch) -> None:
    passed = object.__new__(Tube)

    def growth_of(_: Norm, __: Rectangle, rate: fmpq, damping: fmpq) -> Growth:
        return Growth(rate, damping, SHOWN if rate > 1 else None, 1, f"not at {rate}")

    def some(_: Norm, growth: Growth, __: Rectangle, ___: Start, largest: fmpq) -> Tube | str:
        return passed if growth.rate == 3 and largest > fmpq(1, 100) else "a; b"

    monkeypatch.setattr(module, "fast_growth", growth_of)
    monkeypatch.setattr(module, "tube", some)
    found = tube_from(start_with(), DELTA, [plan(n) for n in (1, 2, 3, 4)])
    assert found == (plan(3), passed)
    assert tube_from(start_with(), DELTA, [plan(0), plan(1)]) == f"not at 0 ({plan(0).text})"
    assert tube_from(start_with(), DELTA, [plan(0), plan(2)]) == f"a; b ({plan(2).text})"


def test_the_reason_is_the_one_that_fails_by_the_fewest_inequalities(monkeypatch: pytest.MonkeyPatch) -> None:
    def growth_of(_: Norm, __: Rectangle, rate: fmpq, damping: fmpq) -> Growth:
        return Growth(rate, damping, SHOWN, 1, "")

    def refused(_: Norm, growth: Growth, __: Rectangle, ___: Start, largest: fmpq) -> str:
        return ("a; b; c", "d; e", "f; g; h")[int(growth.rate.p)] + f" at {largest}"

    monkeypatch.setattr(module, "fast_growth", growth_of)
    monkeypatch.setattr(module, "tube", refused)
    found = tube_from(start_with(), DELTA, [plan(n) for n in (0, 1, 2)])
    assert found == f"d; e at {LARGEST[-1]} ({plan(1).text})"


class Staged:
    """Stand-ins for all that comes after Theorem B; what they were asked."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch) -> None:
        self.asked: dict[str, Any] = {}
        self.end: Any = ENDED
        self.tracked = SimpleNamespace(pieces=[SimpleNamespace(end=fmpq(n)) for n in (-2, -1, 7)], is_whole=True)
        monkeypatch.setattr(module, "DeviationEquations", lambda *given: self.note("equations", given))
        monkeypatch.setattr(module, "hand_over_set", self.hand_over)
        monkeypatch.setattr(module, "end_of_track", lambda *given: self.note("end", given))
        monkeypatch.setattr(module, "reach_for", lambda beta: ("reach", beta))
        monkeypatch.setattr(module, "track", self.track)
        monkeypatch.setattr(module, "first_end", self.first_end)

    def note(self, name: str, given: Any) -> Any:
        self.asked[name] = given
        return name

    def hand_over(self, *given: Any) -> Any:
        self.note("hand over", given)
        return SimpleNamespace(centre="centre", radii="radii", fast="fast", frame="frame")

    def track(self, *given: Any, **named: Any) -> Any:
        self.note("track", (given, named))
        return self.tracked

    def first_end(self, *given: Any) -> Any:
        self.note("first end", given)
        return self.end

    def passage(self, monkeypatch: pytest.MonkeyPatch, *found: Any) -> Passage | str:
        """As if the plans for one S after the other gave these tubes, or reasons."""
        given = list(found)
        monkeypatch.setattr(module, "plans", lambda *asked: [self.note("plans", asked)] * len(given))
        monkeypatch.setattr(module, "tube_from", lambda *_: given.pop(0))
        return passage(start_with(), RESIDUALS, DELTA / 2, DELTA, fmpq(11))  # type: ignore[arg-type]


def passed_tube() -> Tube:
    found = object.__new__(Tube)
    object.__setattr__(found, "evidence", less(1, 2))
    return found


def test_what_is_handed_from_theorem_to_theorem(monkeypatch: pytest.MonkeyPatch) -> None:
    staged, one = Staged(monkeypatch), passed_tube()
    found = staged.passage(monkeypatch, "too wide", (plan(), one), (plan(), one))
    assert isinstance(found, Passage)
    assert (found.tube, found.plan) == (one, plan())
    assert replace(found.end, evidence=ENDED.evidence) == ENDED
    assert str(found.end.evidence) == "1 < 2; 0 < 1"
    place, asked = fmpq(5, 2), staged.asked
    assert asked["plans"] == (BETA, A, Contact.of(SPRINGS))
    assert asked["equations"] == ("trajectory", DELTA, DELTA / 2, RESIDUALS)
    equations, tube, series, c_1, far = asked["hand over"]
    assert (equations, tube, far) == ("equations", one, place)
    assert series == slow_series(BETA, Contact.of(SPRINGS), 3)
    assert c_1.overlaps(start_with().c_1())
    assert c_1.rad() < arb("1e-30")
    assert asked["end"] == ("equations", ("reach", BETA))
    assert asked["track"] == (
        ("equations", 2 * BETA - 2, -place, "end"),
        {"centre": "centre", "radii": "radii", "fast": "fast", "frame": "frame"},
    )
    assert asked["first end"] == (staged.tracked, -place, 11)


def test_the_reason_is_that_of_the_nearest_place(monkeypatch: pytest.MonkeyPatch) -> None:
    staged, one = Staged(monkeypatch), passed_tube()
    assert staged.passage(monkeypatch, "too wide", "wider") == "Theorem B: too wide"
    staged.end = None
    text = staged.passage(monkeypatch, (plan(), one), "too wide")
    assert isinstance(text, str)
    assert text.startswith("Theorem U2: up to s = 7 the deviation lies in no cone")
    staged.tracked.is_whole = False
    text = staged.passage(monkeypatch, (plan(), one))
    assert isinstance(text, str)
    assert text.startswith("Theorem U1: its inequality is not certain from s = 7 on")
    staged.tracked.pieces = []
    assert "from s = -5/2 on" in str(staged.passage(monkeypatch, (plan(), one)))


def test_without_evidence_nothing_is_passed(monkeypatch: pytest.MonkeyPatch) -> None:
    staged = Staged(monkeypatch)
    staged.end = replace(ENDED, evidence=None)
    assert staged.passage(monkeypatch, (plan(), passed_tube())) == "nothing was compared"


FIRST, SECOND, THIRD = fmpq(-2), fmpq(-3), fmpq(-5)


def test_its_equations() -> None:
    """p' = alpha_1, b' = alpha_2 - alpha_3 lambda, y' = v, v' = b + p lambda."""
    system = model_system(FIRST, SECOND, THIRD, PAPER)
    force, state = fmpq(7), [fmpq(n, 11) for n in (13, 17, 19, 23)]
    p, b, _, v = state
    with working_bits(64):
        values = BoxProgram([*system.F, *system.G], 4).values([arb(value) for value in state])
        for k, rate in enumerate((FIRST, SECOND - THIRD * force, v, b + p * force)):
            assert (values[k] + values[4 + k] * force).contains(rate)


def test_its_distinguished_trajectory_is_exact() -> None:
    """lambda = alpha_2/(alpha_3 - alpha_1), p = alpha_1 t, b = -p lambda: nothing but the leading terms."""
    trajectory = expand_system(model_system(FIRST, SECOND, THIRD, PAPER), 8)
    leading = {"p": FIRST, "b": -FIRST, "lambda_n": fmpq(1)}  # b = -p lambda
    for name, value in leading.items():
        first, *others = trajectory.terms()[name]
        assert list(first.coefficients()) == ([value] if name == "lambda_n" else [0, value])
        assert all(not any(one.coefficients()) for one in others)


def test_where_one_place_leads_to_no_end_the_next_is_tried(monkeypatch: pytest.MonkeyPatch) -> None:
    """Whether it fails before the hand-over or after it; what the first one failed by is said."""
    ended = object.__new__(Passage)

    def from_plan(_: Any, __: Any, choices: Any) -> Any:
        return "no tube" if choices == ["a"] else (choices[0], None)

    monkeypatch.setattr(module, "tube_from", from_plan)
    monkeypatch.setattr(module, "DeviationEquations", lambda *_: None)
    monkeypatch.setattr(module, "_ended", lambda *given: ended if given[3] == "c" else "no end")

    def found(*names: str) -> Any:
        monkeypatch.setattr(module, "plans", lambda *_: [[name] for name in names])
        return passage(start_with(), RESIDUALS, fmpq(0), DELTA, fmpq(10))  # type: ignore[arg-type]

    assert found("a", "b", "c") is ended
    assert found("b", "a") == "no end"
    assert found("a", "b") == "Theorem B: no tube"
