"""Runs by norm steps against the other integrator, closed forms and the exact model solution; runs not to be proved.

Page: proofs/norm_step.md.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import islice
from typing import Any

import numpy as np
import pytest
from flint import arb, arb_mat, fmpq

from gspot_verified.functions.expressions import Constant, Cosine, Exponential, Expression, Power, Sine, Variable
from gspot_verified.integrator.box_steps.integrate import integrate
from gspot_verified.integrator.field.event import Crossing, Watch
from gspot_verified.integrator.field.field import VectorField
from gspot_verified.integrator.norm_steps import norm_run
from gspot_verified.integrator.norm_steps.adapted_basis import AdaptedBasis, adapted_basis
from gspot_verified.integrator.norm_steps.chosen_step import ChosenStep, Steps
from gspot_verified.integrator.norm_steps.norm_run import NormRun
from gspot_verified.integrator.norm_steps.norm_step import NormPlan, defect_bounds, norm_step
from gspot_verified.integrator.norm_steps.taylor_curve import TaylorCurve
from gspot_verified.numbers.balls import working_bits

x, y, z = Variable(0), Variable(1), Variable(2)
OSCILLATOR = VectorField([y, -x])


def ended(field: VectorField, box: list[arb], time: arb) -> list[arb]:
    run = NormRun(field, box, time)
    *_, last = run
    assert run.reason is None
    assert not last.end_time < time
    found = last.states(arb(1))
    assert all(side.is_finite() for side in found)
    return found


def test_a_stiff_linear_system_against_the_matrix_exponential() -> None:
    """Rates -40, 0 and a turning pair: errors of the fast part decay, the others do not grow."""
    rows = [[-40, 1, 0, 2], [0, 0, 1, 0], [0, -1, 0, 0], [1, 0, 0, -1]]
    functions: list[Expression] = []
    for row in rows:
        total: Expression = Constant(fmpq(0))
        for j, entry in enumerate(row):
            total = total + Constant(fmpq(entry)) * Variable(j)
        functions.append(total)
    with working_bits(160):
        end = ended(VectorField(functions), [arb(1), arb(2), arb(3), arb(4)], arb(25))
    with working_bits(400):
        true = (arb_mat(rows) * 25).exp() * arb_mat([[1], [2], [3], [4]])
        for side, value in zip(end, true.entries(), strict=True):
            assert side.contains(value)
            assert side.rad() < 1e-30


def test_periods_do_not_wrap() -> None:
    with working_bits(128):
        radius = arb(1) / 1024
        end = ended(OSCILLATOR, [arb(1, radius), arb(0, radius)], 60 * arb.pi())
        for side, middle in zip(end, (1, 0), strict=True):
            assert side.contains(arb(middle))
            assert radius <= side.rad() < radius * arb("2.01")


FIELDS: list[tuple[str, list[Expression], list[fmpq], fmpq]] = [
    ("lorenz", [
        (y - x) * Constant(fmpq(10)), x * (Constant(fmpq(28)) - z) - y, x * y - z * Constant(fmpq(8, 3))
    ], [fmpq(1)] * 3, fmpq(1, 2)),
    ("powers", [
        Power(x, fmpq(1, 2)) * y, Power(y, fmpq(-1)), Power(x + z, fmpq(-3, 2))
    ], [fmpq(1), fmpq(2), fmpq(1, 2)], fmpq(1, 2)),
    ("exponential", [
        Exponential(-y) * Sine(x), Cosine(y + x), x * y * z
    ], [fmpq(1, 3), fmpq(1), fmpq(1)], fmpq(1, 2)),
]  # fmt: skip


@pytest.mark.parametrize(("functions", "start", "time"), [row[1:] for row in FIELDS], ids=[row[0] for row in FIELDS])
def test_two_integrators_overlap(functions: list[Expression], start: list[fmpq], time: fmpq) -> None:
    field = VectorField(functions)
    with working_bits(128):
        box = [arb(value) for value in start]
        known = integrate(field, box, arb(time)).end
        assert known is not None
        for side, other in zip(ended(field, box, arb(time)), known, strict=True):
            assert side.overlaps(other)
            assert side.rad() < 1e-20


@pytest.mark.parametrize("time", ["1", "2", "1.0000000001"])
def test_blow_up_is_never_passed(time: str) -> None:
    with working_bits(96):
        run = NormRun(VectorField([x * x]), [arb(1)], arb(time), steps=Steps(150))
        for segment in run:
            assert segment.end_time < 1
        assert run.reason is not None
        assert ended(VectorField([x * x]), [arb(1)], arb(fmpq(99, 100)))[0].contains(100)


def test_a_square_root_that_ends() -> None:
    with working_bits(96):
        run = NormRun(VectorField([-Power(x, fmpq(1, 2))]), [arb(1)], arb(3), steps=Steps(150))
        assert all(segment.end_time < 2 + arb(2) ** -20 for segment in run)
        assert run.reason is not None


@pytest.mark.parametrize("function", [Power(x, fmpq(-1)), Power(x, fmpq(1, 2))])
def test_a_start_without_a_series(function: Expression) -> None:
    with working_bits(96):
        run = NormRun(VectorField([function]), [arb(0)], arb(1))
        assert list(run) == []
        assert run.reason is not None
        assert not run.budget_ended
        assert run.at_end is None


def test_a_state_too_large_for_the_precision() -> None:
    """Components of 2^200 leave no bits after the point: a reason, and no other error than that of the series."""
    with working_bits(96):
        run = NormRun(OSCILLATOR, [arb(2) ** 200, arb(0)], arb(1))
        assert list(run) == []
        assert run.reason is not None
        assert run.reason.startswith("no step could be proved")


@pytest.mark.parametrize("box", [[arb("nan"), arb(0)], [arb(0), arb("inf")], [arb(0)], [arb(0)] * 3])
def test_boxes_that_are_refused(box: list[arb]) -> None:
    with pytest.raises(ValueError, match="box: "):
        NormRun(OSCILLATOR, box, arb(1))


def test_a_budget_that_ends() -> None:
    with working_bits(96):
        run = NormRun(OSCILLATOR, [arb(1), arb(0)], arb(1000), steps=Steps(3))
        assert len(list(run)) == 3
        assert run.reason == "the budget of 3 steps ended"
        assert run.budget_ended
        assert run.at_end is None


@pytest.mark.parametrize("bits", [96, 160])
def test_the_zero_of_the_cosine(bits: int) -> None:
    with working_bits(bits):
        watch = Watch("event", -x, OSCILLATOR)
        found = next(filter(None, map(watch.along, NormRun(OSCILLATOR, [arb(1), arb(0)], arb(20)))))
        assert isinstance(found, Crossing)
        assert found.time.is_finite()
        assert found.time.contains(arb.pi() / 2)
        assert found.time.rad() < arb(2) ** (50 - bits)
        assert found.rate.contains(1)


def test_a_coupling_that_dies_out_does_not_stretch_the_basis() -> None:
    """x' = z y - x, y' = x - y, z' = -z: rows and columns of J become as unequal as z = e^-t is small. Units that make
    them equal would let the tube of one component, common to all blocks, be as large as 1/z in another one."""
    with working_bits(192):
        run = NormRun(VectorField([z * y - x, x - y, -z]), [arb(1)] * 3, arb(60))
        segments = list(run)
        assert run.reason is None
        assert len(segments) < 40
        end = run.set.enclosure()
        assert all(side.rad() < 1e-40 for side in end)
        assert end[2].contains(arb(-60).exp())
    for tiny in (1e-20, 1e-80, 1e-300):
        for rows in ([[-1.0, tiny], [1.0, -2.0]], [[-1.0, tiny], [0.0, -2.0]]):
            sizes = [max(map(abs, row)) for row in adapted_basis(rows).rows]
            assert 2.0**-20 < min(sizes) <= max(sizes) < 2.0**20


@pytest.mark.parametrize("least", [1, 2, 3, 5, 8, 12, 18, 27])
@pytest.mark.parametrize("wide", [0, 6])
def test_an_uncertain_end_is_not_passed(least: int, wide: int) -> None:
    """Every step but the last ends certainly before the end; the last one has the length that is left, as a ball."""
    end = arb(least * (1 + wide), least * wide)
    with working_bits(100):
        run = NormRun(OSCILLATOR, [arb(1), arb(0)], end)
        segments = list(run)
        for segment in segments if run.reason else segments[:-1]:
            assert segment.end_time < end
        if run.reason is None:
            assert segments[-1].end_time.contains(end)
        assert wide or run.reason is None


@pytest.mark.parametrize(
    "rows",
    [
        [[0.0, 1e300], [1e-300, 0.0]],
        [[0.0, 1e300, 0.0], [0.0, 0.0, 1e300], [1.0, 1.0, 0.0]],
        [[0.0, 1e308, 1e308], [1e308, 0.0, 1e308], [1e308, 1e308, 0.0]],
    ],
)
def test_units_beyond_doubles_are_no_basis(rows: list[list[float]]) -> None:
    """Or a basis is found: any other error ended the whole command."""
    try:
        found = adapted_basis(rows)
    except np.linalg.LinAlgError:
        return
    assert np.isfinite(found.rows).all()


def test_a_clock_that_drives_a_large_state() -> None:
    """x' = t x + 1 from 10^30, the clock a state: J is [[t, 10^30], [0, 0]], and the clock's unit is as small."""
    with working_bits(192):
        run = NormRun(VectorField([x * y + Constant(fmpq(1)), Constant(fmpq(1))]), [arb(10) ** 30, arb(0)], arb(2))
        assert len(list(run)) < 20
        assert run.reason is None
        found = run.set.enclosure()
        assert found[0].is_finite()
        rest = (arb.pi() / 2).sqrt() * arb(2).sqrt().erf()  # the integral of e^(-s^2/2) over [0, 2]
        assert found[0].contains(arb(2).exp() * (arb(10) ** 30 + rest))
        assert found[0].rad() < found[0] * 1e-12
    sizes = [max(map(abs, row)) for row in adapted_basis([[1.0, 1e30], [0.0, 0.0]]).rows]
    assert sizes[1] < sizes[0] * 1e-20


class Kept(Steps):
    """Keeps what is proved."""

    def __init__(self) -> None:
        super().__init__(50)
        self.steps: list[ChosenStep] = []

    def proved(self, step: ChosenStep, time: arb) -> None:
        super().proved(step, time)
        self.steps.append(step)


def test_the_step_to_the_end_is_kept_without_a_length() -> None:
    """It is as long as what is left, which may be a ball: a length in its place would not reach the end again."""
    with working_bits(64):
        kept = Kept()
        segments = list(NormRun(OSCILLATOR, [arb(1), arb(0)], arb.pi(), kept))
        assert len(kept.steps) == len(segments) > 1
        assert [step.h is None for step in kept.steps] == [False] * (len(segments) - 1) + [True]


class Known(Kept):
    """Gives what another run has chosen, step by step."""

    def __init__(self, chosen: Sequence[ChosenStep]) -> None:
        super().__init__()
        self._chosen = iter(chosen)

    def known(self) -> ChosenStep | None:
        return next(self._chosen, None)


def kept_steps(end: arb | None) -> list[ChosenStep]:
    """What a run of the oscillator to this time has chosen, or the first three steps of one without an end."""
    kept = Kept()
    for _ in islice(NormRun(OSCILLATOR, [arb(1), arb(0)], end, kept), None if end is not None else 3):
        pass
    return kept.steps


def test_the_set_at_the_start_is_the_box() -> None:
    with working_bits(96):
        box = [arb(1, 0.25), arb(-3) / 7]
        for side, found in zip(box, NormRun(OSCILLATOR, box).set.enclosure(), strict=True):
            assert found.contains(side)
            assert found.rad() < side.rad() * 1.000001 + arb(2) ** -50


def test_a_run_without_an_end() -> None:
    with working_bits(64):
        run = NormRun(OSCILLATOR, [arb(1), arb(0)])
        segments = list(islice(run, 4))
        assert len(segments) == 4
        assert run.reason is None
        assert run.at_end is None
        for side, value in zip(run.set.enclosure(), (run.time.cos(), -run.time.sin()), strict=True):
            assert side.overlaps(value)
            assert side.rad() < 1e-6


def test_the_evidence_of_the_end_comes_with_the_last_step() -> None:
    """That what was left is positive, which may be much less than 1; a run that is cut short has none."""
    with working_bits(64):
        for end in (arb("0.01"), arb(2), arb.pi()):
            run = NormRun(OSCILLATOR, [arb(1), arb(0)], end)
            seen = [run.at_end for _ in run]
            assert run.reason is None
            assert seen[:-1] == [None] * (len(seen) - 1)
            assert seen[-1] is not None


def test_slow_steps_are_taken_where_the_fast_part_has_died_out() -> None:
    """x' = -x/10^5, y' = 100 (x - y): steps of the fast scale alone would be shorter than 1 for ever."""
    with working_bits(128):
        slow = Constant(fmpq(1, 10**5)) * x
        field = VectorField([-slow, Constant(fmpq(100)) * (x - y)])
        resolved = NormRun(field, [arb(1), arb(2)], arb(4), slow=False)
        assert all(segment.step.h < 1 for segment in resolved)
        run = NormRun(field, [arb(1), arb(2)], arb(1000))
        lengths = [float(segment.step.h.mid()) for segment in run]
        assert run.reason is None
        assert max(lengths) > 10
        end = run.set.enclosure()
        assert end[0].contains(arb(fmpq(-1, 100)).exp())
        assert end[1].contains(arb(fmpq(-1, 100)).exp() / (1 - arb(fmpq(1, 10**7))))


def test_no_pieces_are_tried_where_the_defect_is_not_bounded(monkeypatch: pytest.MonkeyPatch) -> None:
    """They could not help; and pieces of one step share the bound, which is that of the step alone."""
    bounds: list[list[arb] | None] = []
    made: list[int] = []

    def bounded(*given: Any) -> list[arb] | None:
        bounds.append(None if not bounds else defect_bounds(*given))
        return bounds[-1]

    def based(rows: Sequence[Sequence[float]]) -> AdaptedBasis:
        made.append(len(bounds))
        return adapted_basis(rows)

    monkeypatch.setattr(norm_run, "defect_bounds", bounded)
    monkeypatch.setattr(norm_run, "adapted_basis", based)
    with working_bits(64):
        run = NormRun(OSCILLATOR, [arb(1), arb(0)], arb(2) * arb.pi())
        first = next(iter(run))
        plan = run._plan_in_use
        assert made == [2]
        assert bounds[1] == defect_bounds(OSCILLATOR, first.step.solution, first.step.h, plan.disc, plan.length)
        start = NormRun(OSCILLATOR, [arb(1), arb(0)]).set
        again = norm_step(OSCILLATOR, first.step.solution, start, first.step.h, plan)
        assert again is not None
        assert (again.tube, again.radii) == (first.step.tube, first.step.radii)


def test_steps_that_are_known_are_proved_and_not_chosen_again(monkeypatch: pytest.MonkeyPatch) -> None:
    with working_bits(64):
        chosen = kept_steps(arb(2) * arb.pi())

        def chooses(*_: object) -> None:
            raise AssertionError("a step was chosen")

        monkeypatch.setattr(TaylorCurve, "advance", chooses)
        known = Known(chosen)
        run = NormRun(OSCILLATOR, [arb(1), arb(0)], arb(2) * arb.pi(), known)
        assert len(list(run)) == len(chosen) > 3
        assert run.reason is None
        assert run.at_end is not None
        assert [step.to_json() for step in known.steps] == [step.to_json() for step in chosen]
        assert run._curve.length == chosen[-1].length
        assert run._decay.state == chosen[-1].decay
        for side, value in zip(run.set.enclosure(), (1, 0), strict=True):
            assert side.contains(arb(value))
            assert side.rad() < 1e-6


def test_a_known_step_that_is_of_no_use_is_chosen_again() -> None:
    """Of another field, of a tube that is too narrow, beyond the end, as long as the end, or without a length where
    there is no end: the run is the one that knows nothing, from the length that it would have begun with."""
    with working_bits(64):
        first, *_ = kept_steps(None)
        plan = first.plan
        narrow = NormPlan(plan.ends, plan.bases, tuple(arb((1, -60)) for _ in plan.margins), plan.disc, plan.length)
        assert first.h is not None
        h = first.h
        far = 2 * h
        for step, end in (
            (replace(first, solution=first.solution[:1]), far),
            (replace(first, solution=(*first.solution, first.solution[0])), far),
            (replace(first, plan=narrow, length=1e-9), far),
            (replace(first, h=2 * far, length=1e-9), far),
            (replace(first, length=1e-9), h),
        ):
            expected = [segment.step.h for segment in NormRun(OSCILLATOR, [arb(1), arb(0)], end)]
            run = NormRun(OSCILLATOR, [arb(1), arb(0)], end, Known([step]))
            assert [segment.step.h for segment in run] == expected
            assert run.reason is None
        endless = NormRun(OSCILLATOR, [arb(1), arb(0)], None, Known([replace(first, h=None, length=1e-9)]))
        found = next(iter(endless))
        assert found.step.h == h
