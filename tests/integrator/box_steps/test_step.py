"""Single steps: what is proved holds for solutions in closed form, and nothing is proved where a hypothesis fails.

Page: proofs/validated_step.md.
"""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

import pytest
from flint import acb, arb, arb_mat, arb_poly, fmpq
from hypothesis import given
from hypothesis import strategies as st
from samples.strategies import ends

from gspot_verified.functions.expressions import (
    Constant,
    Cosine,
    Exponential,
    Expression,
    Logarithm,
    Power,
    Sine,
    Variable,
)
from gspot_verified.integrator.box_steps.error_set import ErrorSet
from gspot_verified.integrator.box_steps.step import (
    Plan,
    PolynomialCurve,
    Step,
    _cauchy_bounds,
    _defect,
    _flow,
    _growth,
    _tail,
    _tube,
    certified_step,
)
from gspot_verified.integrator.field.field import VectorField
from gspot_verified.numbers.balls import working_bits
from gspot_verified.numbers.verdict import Evidence

x, y = Variable(0), Variable(1)
OSCILLATOR = VectorField([y, -x])


def rational(value: object) -> Constant:
    return Constant(fmpq(value) if not isinstance(value, Fraction) else fmpq(value.numerator, value.denominator))


def taylor_curve(order: int, h: Fraction, slip: Fraction = Fraction(0)) -> PolynomialCurve:
    """cos and -sin from (1, 0), with a deliberate error ``slip`` in the last coefficient."""
    rows: list[list[Fraction]] = [[], []]
    cosine, sine = Fraction(1), Fraction(0)
    for k in range(order + 1):
        rows[0].append(cosine)
        rows[1].append(sine)
        cosine, sine = sine * h / (k + 1), -cosine * h / (k + 1)
    rows[0][-1] += slip
    solution = tuple(arb_poly([arb(fmpq(c.numerator, c.denominator)).mid() for c in row]) for row in rows)
    flow = ((solution[0], -solution[1]), (solution[1], solution[0]))
    return PolynomialCurve(solution, flow)


def plan(tube: str = "1e-6", length: int = 40, **changes: object) -> Plan:
    chosen = Plan((arb(1), arb(1)), arb(tube).mid(), 4, length, length)
    return replace(chosen, **changes)  # type: ignore[arg-type]


def certain(step: Step | None) -> Step:
    assert step is not None
    return step


@pytest.mark.parametrize("bits", [64, 128, 400])
@pytest.mark.parametrize("slip", [0, Fraction(1, 10**9), Fraction(-1, 10**12)])
def test_the_oscillator(bits: int, slip: Fraction) -> None:
    with working_bits(bits):
        h = arb((1, -1))
        step = certain(certified_step(OSCILLATOR, taylor_curve(12, Fraction(1, 2), slip), [arb(0)] * 2, h, plan()))
        cosine, sine = h.cos(), h.sin()
        for value, true in zip(step.end(), (cosine, -sine), strict=True):
            assert value.is_finite()
            assert value.contains(true)
            assert value.rad() < 1e-7
        for entry, true in zip(step.flow.entries(), (cosine, sine, -sine, cosine), strict=True):
            assert entry.is_finite()
            assert entry.contains(true)
            assert entry.rad() < 1e-6
        for k in range(9):
            tau = arb(k) / 8
            at = step.enclosure(tau)
            assert at[0].is_finite()
            assert at[0].contains((h * tau).cos())
            assert at[1].contains(-(h * tau).sin())


def test_a_wrong_curve_is_paid_for() -> None:
    """The bound on the local error is never below the error that was put in."""
    with working_bits(100):
        for exponent in (3, 6, 12):
            slip = Fraction(1, 10**exponent)
            curve = taylor_curve(30, Fraction(1, 2), slip)
            step = certain(certified_step(OSCILLATOR, curve, [arb(0)] * 2, arb((1, -1)), plan("0.5")))
            assert step.local[0] >= arb(fmpq(1, 10**exponent)).mid() * arb("0.99")


def test_the_set_of_initial_values_is_covered() -> None:
    with working_bits(90):
        radius = [arb("0.01").upper(), arb("0.02").upper()]
        step = certain(certified_step(OSCILLATOR, taylor_curve(20, Fraction(1, 2)), radius, arb((1, -1)), plan("0.2")))
        h = arb((1, -1))
        for a, b in ((1, 1), (1, -1), (-1, 1), (-1, -1), (0, 1)):
            start = (1 + a * arb("0.01"), b * arb("0.02"))
            for k in range(5):
                angle = h * k / 4
                first = start[0] * angle.cos() + start[1] * angle.sin()
                enclosure = step.enclosure(arb(k) / 4)[0]
                assert enclosure.is_finite()
                assert enclosure.contains(first)


@pytest.mark.parametrize(
    "changes",
    [{"tube": arb(0)}, {"tube": arb("1e-60").mid()}, {"disc": 1}, {"weights": (arb(1), arb(0))},
     {"weights": (arb(1), arb(-1))}, {"tube": arb("nan")}, {"weights": (arb(1), arb("nan"))}],
)  # fmt: skip
def test_hypotheses_that_fail(changes: dict[str, object]) -> None:
    with working_bits(100):
        curve = taylor_curve(12, Fraction(1, 2), Fraction(1, 10**8))
        assert certified_step(OSCILLATOR, curve, [arb(0)] * 2, arb((1, -1)), plan(**changes)) is None  # type: ignore[arg-type]


def test_the_derivatives_begin_with_the_identity() -> None:
    with working_bits(100):
        good = taylor_curve(12, Fraction(1, 2))
        for entry in (arb_poly([2]), good.flow[0][0] + arb_poly([arb(0, "1e-30")])):
            wrong = PolynomialCurve(good.solution, ((entry, good.flow[0][1]), good.flow[1]))
            assert certified_step(OSCILLATOR, wrong, [arb(0)] * 2, arb((1, -1)), plan("0.5")) is None


@pytest.mark.parametrize("h", ["0", "-0.5", "nan"])
def test_a_length_that_is_not_certainly_positive(h: str) -> None:
    with working_bits(100):
        assert certified_step(OSCILLATOR, taylor_curve(12, Fraction(1, 2)), [arb(0)] * 2, arb(h), plan("0.5")) is None
        wide = arb(0, 1)
        assert certified_step(OSCILLATOR, taylor_curve(12, Fraction(1, 2)), [arb(0)] * 2, wide, plan("0.5")) is None


@pytest.mark.parametrize("value", ["nan", "inf"])
def test_nothing_that_is_not_finite_passes(value: str) -> None:
    with working_bits(100):
        h = arb((1, -1))
        curve = taylor_curve(12, Fraction(1, 2))
        assert certified_step(OSCILLATOR, curve, [arb(value), arb(0)], h, plan("0.5")) is None
        spoiled = PolynomialCurve((curve.solution[0] + arb_poly([0, arb(value)]), curve.solution[1]), curve.flow)
        assert certified_step(OSCILLATOR, spoiled, [arb(0)] * 2, h, plan("0.5")) is None
        flow = ((curve.flow[0][0] + arb_poly([0, arb(value)]), curve.flow[0][1]), curve.flow[1])
        assert certified_step(OSCILLATOR, PolynomialCurve(curve.solution, flow), [arb(0)] * 2, h, plan("0.5")) is None


def line(start: str, h: str, function: Expression) -> Step | None:
    """One step of a scalar equation with the straight line as the curve."""
    field = VectorField([function])
    with working_bits(80):
        at, size = arb(start).mid(), arb(h).mid()
        slope = (field.on_box([at])[0][0] * size).mid()
        if not slope.is_finite():
            slope = arb(0)
        curve = PolynomialCurve((arb_poly([at, slope]),), ((arb_poly([1]),),))
        return certified_step(field, curve, [arb(0)], size, Plan((arb(1),), arb("0.05").mid(), 2, 12, 12))


def test_a_logarithm_across_its_cut_is_not_holomorphic() -> None:
    """FLINT's logarithm of a complex ball across the negative axis is finite: Cauchy's estimate would not hold."""
    field = VectorField([Logarithm(x)])
    with working_bits(80):
        assert acb(arb(-1), arb(0, 1)).log().is_finite()
        for middle, good in (("-1", False), ("0.5", False), ("2", True)):
            box = [acb(arb(middle, "0.9"), arb(0, "0.9"))]
            assert field.values_on_complex_box(box)[0].is_finite() is good
            assert field.on_complex_box(box)[0][0].is_finite() is good
        assert not field.on_box([arb(1, 2)])[0][0].is_finite()
        assert line("1", "0.01", Logarithm(x)) is not None
        assert line("-1", "0.01", Logarithm(x)) is None


def test_singular_right_hand_sides() -> None:
    """x' = 1/x, sqrt(x), x^(1/3) near 0: nothing is proved when the curve's disc reaches 0, and something when not."""
    for function in (Power(x, fmpq(-1)), Power(x, fmpq(1, 2)), Power(x, fmpq(1, 3)), Power(x, fmpq(-3, 2))):
        assert line("0.0001", "0.01", function) is None or function == Power(x, fmpq(1, 3))
        assert line("0", "0.01", function) is None
        assert line("-1", "0.01", function) is None or function == Power(x, fmpq(-1))
        assert line("1", "0.01", function) is not None
    assert line("1", "0.01", Exponential(x) + Sine(x) * Cosine(x)) is not None


@given(st.integers(0, 2**32 - 1))
def test_lohners_set_contains_the_images(seed: int) -> None:
    """Theorem V4 on a step whose flow is a known matrix: points of the set go to points of the new set."""
    import random

    chance = random.Random(seed)
    with working_bits(70):
        box = [arb(chance.uniform(-1, 1), chance.uniform(0, 0.1)) for _ in range(2)]
        before = ErrorSet.of_box(box)
        matrix = [[chance.uniform(-2, 2) for _ in range(2)] for _ in range(2)]
        current: ErrorSet | None = before
        corners = [[box[0].mid() + a * box[0].rad(), box[1].mid() + b * box[1].rad()] for a in (-1, 1) for b in (-1, 1)]
        for _ in range(4):
            assert current is not None
            middle = [sum((arb(e) * m for e, m in zip(row, current.middle, strict=True)), arb(0)) for row in matrix]
            exact = tuple(value.mid() for value in middle)
            # x -> M x + (exact - M middle) moves the midpoint to an exact point: an affine map with the flow M.
            offset = [e - m for e, m in zip(exact, middle, strict=True)]
            curve = PolynomialCurve(tuple(arb_poly([m]) for m in exact), ())
            step = Step(
                curve,
                arb(1),
                (arb(0), arb(0)),
                (arb(0), arb(0)),
                arb_mat([[arb(e) for e in r] for r in matrix]),
                Evidence._of_facts(("for the test",)),
            )
            corners = [
                [
                    sum((arb(e) * c for e, c in zip(row, corner, strict=True)), d)
                    for row, d in zip(matrix, offset, strict=True)
                ]
                for corner in corners
            ]
            current = current.after(step)
            assert current is not None
            for corner in corners:
                for value, side in zip(corner, current.enclosure(), strict=True):
                    lower, upper = ends(side)
                    low, high = ends(value)
                    assert lower <= high
                    assert low <= upper


def scalar(function: Expression, *coefficients: int) -> tuple[VectorField, PolynomialCurve]:
    """A scalar equation and a polynomial beside it."""
    return VectorField([function]), PolynomialCurve((arb_poly(list(coefficients)),), ((arb_poly([1]),),))


def one_weight(length: int, tube: str = "0.25") -> Plan:
    return Plan((arb(1),), arb(tube), 4, length, length)


def test_the_tube_is_around_the_curve_at_all_times_of_the_step() -> None:
    """1 + 2 tau for tau in [0, 1], and 1/4 on both sides."""
    _, curve = scalar(x, 1, 2)
    (box,) = _tube(curve, one_weight(4))
    lower, upper = ends(box)
    assert Fraction(3, 4) - Fraction(1, 10**6) < lower <= Fraction(3, 4)
    assert Fraction(13, 4) <= upper < Fraction(13, 4) + Fraction(1, 10**6)
    nothing = Evidence._of_facts(("for the test",))
    step = Step(curve, arb(1), (arb("0.25"),), (arb(0),), arb_mat(1, 1), nothing)
    assert step.enclosure()[0].contains(box)


def test_cauchys_bounds_are_those_of_the_whole_disc() -> None:
    """x = 1 + tau has the value 5 on the disc of radius 4: |x^2| = 25 and |2 x| = 10 there."""
    field, curve = scalar(x * x, 1, 1)
    found = _cauchy_bounds(field, curve, one_weight(4))
    assert found is not None
    (value,), ((entry,),) = found
    assert value.is_finite()
    assert entry.is_finite()
    assert value >= 25
    assert entry >= 10


def test_one_bound_that_is_not_finite_is_enough_for_none() -> None:
    field = VectorField([y, Power(x, fmpq(-1))])
    flow = ((arb_poly([1]), arb_poly([])), (arb_poly([]), arb_poly([1])))
    for start, known in ((9, True), (3, False)):
        curve = PolynomialCurve((arb_poly([start, 1]), arb_poly([1])), flow)
        assert (_cauchy_bounds(field, curve, plan()) is not None) is known


def test_the_tail_is_the_sum_of_the_powers_left_out() -> None:
    """4^-3 + 4^-4 + ... = 1/48."""
    assert abs(_tail(one_weight(3), 3) - arb(1) / 48) < arb("1e-12")


def test_the_defect_is_that_of_the_page() -> None:
    """x' = x, h = 3, the line 1 + 3 tau, two terms: |3 (1 + 3 tau) - 3| = 9 tau, and 3 * 7 / 12 for the rest."""
    field, curve = scalar(x, 1, 3)
    (defect,) = _defect(field, curve, arb(3), [arb(7)], one_weight(2))
    assert abs(defect - arb(43) / 4) < arb("1e-12")


@pytest.mark.parametrize(("second", "norm"), [(1, 1), (4, 4), (fmpq(1, 4), 4)])
def test_the_growth_is_that_of_the_weighted_logarithmic_norm(second: object, norm: int) -> None:
    """The oscillator has the rows (0, 1) and (-1, 0): max(w_2/w_1, w_1/w_2), over half a unit of time."""
    growth = _growth(OSCILLATOR, [arb(0), arb(0)], arb(1) / 2, plan(weights=(arb(1), arb(second))))
    true = (arb(norm) / 2).exp()
    assert abs(growth - true) < arb("1e-6")


@pytest.mark.parametrize(("second", "radii"), [(1, (87, 87)), (100, (33, 3300))])
def test_the_bound_on_the_derivatives_is_that_of_the_page(second: int, radii: tuple[int, int]) -> None:
    """Theorem V2 with f = 0, h = 2, N/12 = ((1, 2), (3, 4)) and c = ((1/2, 1), (2, 3)); in the first column

    the norms of the polynomials are 1 and 5, of their derivatives 0 and 7: D = (33, 87).
    """
    still = VectorField([Constant(fmpq(0)), Constant(fmpq(0))])
    flow = ((arb_poly([1]), arb_poly([])), (arb_poly([0, 3, 2]), arb_poly([1])))
    curve = PolynomialCurve((arb_poly([1]), arb_poly([1])), flow)
    bounds = [[arb(12), arb(24)], [arb(36), arb(48)]]
    change = [[arb("0.5"), arb(1)], [arb(2), arb(3)]]
    chosen = plan(length=2, weights=(arb(1), arb(second)))
    found = _flow(still, curve, arb(2), bounds, change, arb(1), chosen)
    for row, (middle, radius) in enumerate(zip((1, 5), radii, strict=True)):
        assert abs(found[row, 0].mid() - middle) < arb("1e-6")
        assert abs(found[row, 0].rad() - radius) < arb("1e-5")
