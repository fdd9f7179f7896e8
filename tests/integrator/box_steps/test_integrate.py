"""Runs against closed forms, first integrals and mpmath, and runs that must not be proved.

Page: proofs/validated_step.md.
"""

from __future__ import annotations

import itertools
import random
from collections.abc import Iterator

import mpmath
import pytest
from flint import arb, arb_mat, fmpq
from hypothesis import given, settings
from hypothesis import strategies as st
from witnesses.expressions import value_of

from gspot_verified.functions.expressions import Constant, Cosine, Exponential, Expression, Power, Sine, Variable
from gspot_verified.integrator.box_steps.integrate import Run, Segment, _reached, integrate
from gspot_verified.integrator.field.field import VectorField
from gspot_verified.numbers.balls import working_bits
from gspot_verified.numbers.verdict import Outcome

x, y, z = Variable(0), Variable(1), Variable(2)
OSCILLATOR = VectorField([y, -x])
PENDULUM = VectorField([y, -Sine(x)])


def number(value: str) -> Constant:
    return Constant(fmpq(*map(int, (value + "/1").split("/")[:2])))


def ended(field: VectorField, box: list[arb], time: arb) -> tuple[arb, ...]:
    found = integrate(field, box, time)
    assert found.verdict.outcome is Outcome.PROVED, found.verdict
    assert found.end is not None
    assert all(side.is_finite() for side in found.end)
    return found.end


@pytest.mark.parametrize("bits", [64, 128, 256, 400])
def test_linear_systems_against_the_matrix_exponential(bits: int) -> None:
    chance = random.Random(bits)
    for size in (1, 2, 4):
        rows = [[fmpq(chance.randint(-9, 9), 8) for _ in range(size)] for _ in range(size)]
        functions: list[Expression] = []
        for row in rows:
            total: Expression = Constant(fmpq(0))
            for j, entry in enumerate(row):
                total = total + Constant(entry) * Variable(j)
            functions.append(total)
        with working_bits(bits):
            start = [arb(chance.randint(-5, 5)) for _ in range(size)]
            end = ended(VectorField(functions), start, arb(fmpq(7, 3)))
        with working_bits(bits + 100):
            matrix = arb_mat([[arb(entry) * fmpq(7, 3) for entry in row] for row in rows]).exp()
            true = matrix * arb_mat([[value] for value in start])
            for side, value in zip(end, true.entries(), strict=True):
                assert side.contains(value)
                assert side.rad() < arb(2) ** (40 - bits)


@pytest.mark.parametrize("periods", [30, pytest.param(1000, marks=pytest.mark.slow)])
def test_periods_do_not_wrap(periods: int) -> None:
    with working_bits(100):
        radius = arb(1) / 1024
        end = ended(OSCILLATOR, [arb(1, radius), arb(0, radius)], 2 * periods * arb.pi())
        for side, middle in zip(end, (1, 0), strict=True):
            assert side.contains(arb(middle))
            assert side.rad() >= radius
            assert side.rad() < radius * arb("1.0001")
        point = ended(OSCILLATOR, [arb(1), arb(0)], 2 * periods * arb.pi())
        assert point[0].contains(1)
        assert point[0].rad() < 1e-20


def test_the_energy_of_the_pendulum() -> None:
    with working_bits(128):
        run = Run(PENDULUM, [arb(2), arb(fmpq(1, 3))], arb(30))
        for segment in run:
            states = segment.after.enclosure()
            value = states[1] * states[1] / 2 - states[0].cos()
            assert value.is_finite()
            assert value.contains(arb(fmpq(1, 18)) - arb(2).cos())
            assert value.rad() < 1e-28
        assert run.reason is None


FIELDS: list[tuple[str, list[Expression], list[str], str]] = [
    ("lorenz", [(y - x) * number("10"), x * (number("28") - z) - y, x * y - z * number("8/3")], ["1", "1", "1"], "1/4"),
    ("powers", [Power(x, fmpq(1, 2)) * y, Power(y, fmpq(-1)), Power(x + z, fmpq(-3, 2))], ["1", "2", "1/2"], "1/2"),
    ("exponential", [Exponential(-y) * Sine(x), Cosine(y + x), x * y * z], ["1/3", "1", "1"], "1/2"),
]


@pytest.mark.parametrize(("functions", "start", "time"), [row[1:] for row in FIELDS], ids=[row[0] for row in FIELDS])
@pytest.mark.parametrize("bits", [64, 90])
def test_against_mpmath(functions: list[Expression], start: list[str], time: str, bits: int) -> None:
    numbers = [tuple(map(int, f"{text}/1".split("/")[:2])) for text in (*start, time)]
    with working_bits(bits):
        *initial, last = [arb(fmpq(*pair)) for pair in numbers]
        end = ended(VectorField(functions), initial, last)
    with mpmath.workdps(30):
        *at, until = [mpmath.fdiv(*pair) for pair in numbers]
        true = mpmath.odefun(lambda _, state: [value_of(f, state) for f in functions], 0, at)(until)
        texts = [mpmath.nstr(value, 30) for value in true]
    with working_bits(300):
        for side, text in zip(end, texts, strict=True):
            assert side.overlaps(arb(text, "1e-25"))
            assert side.rad() < arb(2) ** (30 - bits)


@settings(max_examples=15)
@given(st.floats(-1, 1), st.floats(-1, 1), st.floats(0, 0.05), st.integers(0, 2**30))
def test_points_of_the_box_stay_in_the_enclosure(a: float, b: float, radius: float, seed: int) -> None:
    chance = random.Random(seed)
    box_radius = arb(radius)
    with working_bits(64):
        box = [arb(a, box_radius), arb(b, box_radius)]
        end = ended(PENDULUM, box, arb(fmpq(5, 2)))
        points = [
            [side.mid() + chance.choice((-1, 1, chance.uniform(-1, 1))) * side.rad() for side in box] for _ in range(3)
        ]
    with working_bits(128):
        for point in points:
            image = ended(PENDULUM, [value.mid() for value in point], arb(fmpq(5, 2)))
            for side, value in zip(end, image, strict=True):
                assert side.contains(value)


@pytest.mark.parametrize("bits", [64, 128])
@pytest.mark.parametrize("time", ["1", "2", "1.0000000001"])
def test_blow_up_is_never_a_finite_ball(bits: int, time: str) -> None:
    with working_bits(bits):
        found = integrate(VectorField([x * x]), [arb(1)], arb(time), max_steps=80)
        assert found.verdict.outcome is Outcome.UNDECIDED
        assert found.end is None
        assert found.time < 1 + arb(2) ** (-bits // 2)
        end = ended(VectorField([x * x]), [arb(1)], arb(fmpq(99, 100)))
        assert end[0].contains(100)


def test_the_box_reaches_the_blow_up() -> None:
    """1/(1 - t) at t = 9/10 is finite, but the box holds starts that blow up before."""
    with working_bits(64):
        found = integrate(VectorField([x * x]), [arb(1, "0.2")], arb(fmpq(9, 10)), max_steps=80)
        assert found.end is None


def test_a_square_root_that_ends() -> None:
    """x' = -sqrt(x) reaches 0 at t = 2 and is not analytic there."""
    with working_bits(64):
        found = integrate(VectorField([-Power(x, fmpq(1, 2))]), [arb(1)], arb(3), max_steps=80)
        assert found.end is None
        assert found.time < 2 + arb(2) ** -20
        assert ended(VectorField([-Power(x, fmpq(1, 2))]), [arb(1)], arb(1))[0].contains(arb(1) / 4)


@pytest.mark.parametrize("function", [Power(x, fmpq(-1)), Power(x, fmpq(1, 2))])
def test_a_start_without_a_series(function: Expression) -> None:
    """x' = 1/x and x' = sqrt(x) from 0: nothing is proved, and nothing is raised."""
    with working_bits(64):
        found = integrate(VectorField([function]), [arb(0)], arb(1))
        assert found.end is None
        assert found.verdict.outcome is Outcome.UNDECIDED


@pytest.mark.parametrize("box", [[arb("nan"), arb(0)], [arb(0), arb("inf")], [arb(0)], [arb(0)] * 3])
def test_boxes_that_are_refused(box: list[arb]) -> None:
    with pytest.raises(ValueError, match="box: "):
        integrate(OSCILLATOR, box, arb(1))


@pytest.mark.parametrize("time", [arb("nan"), arb(0), arb(-1), arb(0, 1), arb("inf")])
def test_times_that_are_refused(time: arb) -> None:
    with pytest.raises(ValueError, match="time: "):
        integrate(OSCILLATOR, [arb(1), arb(0)], time)


def test_fields_that_are_refused() -> None:
    with pytest.raises(ValueError, match="functions of a state"):
        VectorField([y])
    with pytest.raises(ValueError, match="functions of a state"):
        VectorField([])
    with pytest.raises(TypeError, match="no enclosure"):
        VectorField([Constant("chi")])


def test_a_budget_that_ends() -> None:
    with working_bits(64):
        found = integrate(OSCILLATOR, [arb(1), arb(0)], arb(100), max_steps=3)
        assert found.end is None
        assert "the budget of 3 steps ended" in str(found.verdict)
        with pytest.raises(TypeError, match="no truth value"):
            bool(found)


def test_the_steps_are_the_evidence_and_must_reach_the_end() -> None:
    """A step that is left out, or a run that was stopped before its time, cannot conclude."""
    with working_bits(64):
        found = integrate(OSCILLATOR, [arb(1), arb(0)], arb(3))
        assert found.verdict.evidence is not None
        steps = found.segments
        assert len(steps) > 3
        assert len(found.verdict.evidence.facts) == 2 * len(steps) + 1  # joined and proved, each; the time that is left
        assert _reached(steps, arb(3)) is not None
        for wrong in (steps[:-1], steps[1:], (*steps[:1], *steps[2:]), (*steps[:2], *steps[1:])):
            assert _reached(wrong, arb(3)) is None
        assert _reached(steps, arb("3.001")) is None
        assert _reached((), arb(3)) is None


def test_a_run_that_stops_early_and_says_nothing_is_undecided(monkeypatch: pytest.MonkeyPatch) -> None:
    whole = Run.__iter__

    def short(run: Run) -> Iterator[Segment]:
        return itertools.islice(whole(run), 2)

    monkeypatch.setattr(Run, "__iter__", short)
    with working_bits(64):
        found = integrate(OSCILLATOR, [arb(1), arb(0)], arb(3))
    assert (found.verdict.outcome, found.end) == (Outcome.UNDECIDED, None)


def test_a_wide_time_is_covered() -> None:
    """The end holds the states at every time of the ball."""
    with working_bits(64):
        end = ended(OSCILLATOR, [arb(1), arb(0)], arb(3, "0.01"))
        for shift in ("-0.0099", "0", "0.0099"):
            assert end[0].contains((arb(3) + arb(shift)).cos())


@pytest.mark.parametrize("least", [1, 2, 3, 5, 8, 12])
@pytest.mark.parametrize("wide", [0, 1, 6])
def test_an_uncertain_end_is_not_passed(least: int, wide: int) -> None:
    """Every step but the last ends certainly before the end; the last one has the length that is left, as a ball."""
    end = arb(least * (1 + wide), least * wide) / 2
    with working_bits(64):
        run = Run(OSCILLATOR, [arb(1), arb(0)], end)
        segments = list(run)
        for segment in segments if run.reason else segments[:-1]:
            assert segment.end_time < end
        if run.reason is None:
            assert segments[-1].end_time.contains(end)
        assert wide or run.reason is None


def test_a_run_without_an_end_goes_on_until_its_budget() -> None:
    with working_bits(64):
        run = Run(OSCILLATOR, [arb(1), arb(0)], max_steps=3)
        segments = list(run)
        assert [segment.end_time > segment.time for segment in segments] == [True] * 3
        assert run.reason == "the budget of 3 steps ended"


def test_one_component_without_a_series_is_enough_to_prove_nothing() -> None:
    """t' = 1, x' = sqrt(t) from t = 0: the series of t alone is finite."""
    with working_bits(64):
        run = Run(VectorField([Constant(fmpq(1)), Power(x, fmpq(1, 2))]), [arb(0), arb(1)])
        assert list(run) == []
        assert "no step could be proved" in (run.reason or "")


def test_a_ball_of_times_is_written_no_wider_than_it_is() -> None:
    """What is said holds for each time of the ball."""
    with working_bits(100):
        found = integrate(VectorField([x * x]), [arb(1)], arb("0.5", "0.0123456"))
    assert found.verdict.outcome is Outcome.PROVED
    assert found.verdict.statement == "every solution from the box exists up to the time [0.48766, 0.51234]"
