"""Cases in which a bound of a step is attained almost exactly, or up to a small factor: a bound that is too small would
exclude a solution in closed form here.

``tests/house/test_sabotage.py`` runs this file with each radius shrunk on purpose and wants it red.
Pages: proofs/validated_step.md, proofs/norm_step.md.
"""

from __future__ import annotations

import pytest
from flint import arb, arb_mat, arb_poly, fmpq

from gspot_verified.functions.expressions import Constant, Expression, Power, Variable
from gspot_verified.integrator.box_steps import step as steps
from gspot_verified.integrator.box_steps.error_set import ErrorSet
from gspot_verified.integrator.box_steps.step import Plan, PolynomialCurve, Step, certified_step
from gspot_verified.integrator.field.field import VectorField
from gspot_verified.integrator.norm_steps import norm_step as norm_steps
from gspot_verified.integrator.norm_steps.norm_step import Basis, NormPlan, NormStep, StateSet, norm_step
from gspot_verified.numbers.balls import working_bits
from gspot_verified.numbers.verdict import Evidence

x, y = Variable(0), Variable(1)
ONE, ZERO = Constant(fmpq(1)), Constant(fmpq(0))
GROWTH = VectorField([x])
LINE = Basis(arb_mat([[1]]), (1,))
TINY = arb((1, -60))
SHOWN = Evidence._of_facts(("for the test",))


def exponential(order: int) -> arb_poly:
    """The Taylor polynomial of e^τ."""
    terms = [fmpq(1)]
    for k in range(1, order + 1):
        terms.append(terms[-1] / k)
    return arb_poly([arb(term).mid() for term in terms])


def lohner(field: VectorField, p: arb_poly, radius: arb, h: arb, plan: Plan) -> Step:
    found = certified_step(field, PolynomialCurve((p,), ((arb_poly([1]),),)), [radius], h, plan)
    assert found is not None
    return found


def by_norms(field: VectorField, p: arb_poly, radius: arb, h: arb, length: int = 60, disc: int = 2) -> NormStep | None:
    plan = NormPlan((arb(0), arb(1)), (LINE,), (arb(64),), disc, length)
    return norm_step(field, [p], StateSet((p(arb(0)),), LINE, (radius,)), h, plan)


def certain(step: NormStep | None) -> NormStep:
    assert step is not None
    return step


def holds(side: arb, value: arb) -> bool:
    """Whether a number is in a ball; it may be known a little less accurately than the ball's end."""
    return bool(side.is_finite() and arb(side.mid(), side.rad() * (1 + arb((1, -28)))).contains(value.mid()))


def test_deviations_at_the_start_grow_as_they_must() -> None:
    """x' = x: a solution that starts at 1 + r is at e (1 + r) at τ = 1; both integrators allow it, and hardly more."""
    r = arb((1, -10))
    with working_bits(128):
        e = arb(1).exp()
        tube = lohner(GROWTH, exponential(40), r, arb(1), Plan((arb(1),), arb(1), 2, 60, 60)).enclosure(arb(1))[0]
        step = certain(by_norms(GROWTH, exponential(40), r, arb(1)))
        end = step.end([step.solution[0](arb(1)).mid()]).enclosure()[0]
        for side in (tube, end, step.enclosure(arb(1))[0]):
            for sign in (-1, 1):
                assert holds(side, e * (1 + sign * r))
        for side in (tube, end):
            assert side.rad() < e * r * (1 + arb((1, -20)))


def test_a_defect_that_grows() -> None:
    """x' = x from 1 along the constant 1: the defect is 1, the error at τ = 1 is e - 1 = 1.718..., and e is allowed."""
    constant = arb_poly([1])
    with working_bits(128):
        true = arb(1).exp()
        step = lohner(GROWTH, constant, arb(0), arb(1), Plan((arb(1),), arb(8), 2, 60, 60))
        assert holds(step.enclosure(arb(1))[0], true)
        assert holds(step.end()[0], true)
        assert step.tube[0] < arb("2.7183")
        found = certain(by_norms(GROWTH, constant, arb(0), arb(1)))
        assert holds(found.enclosure(arb(1))[0], true)
        assert holds(found.end([arb(1)]).enclosure()[0], true)


def test_a_defect_that_does_not_grow() -> None:
    """x' = 1 along a constant: the error is the defect h, exactly."""
    field, constant, h = VectorField([ONE]), arb_poly([1]), arb((1, -3))
    with working_bits(128):
        step = lohner(field, constant, arb(0), h, Plan((arb(1),), arb(1), 2, 60, 60))
        for side in (step.end()[0], step.enclosure(arb(1))[0]):
            assert holds(side, 1 + h)
            assert side.rad() < h * (1 + arb((1, -20)))
        found = certain(by_norms(field, constant, arb(0), h))
        assert holds(found.end([arb(1)]).enclosure()[0], 1 + h)


def test_derivatives_along_a_flow_that_does_not_grow() -> None:
    """x' = y, y' = 0 with the identity for the derivatives: the entry x, y is wrong by h, exactly."""
    h, unit = arb((1, -2)), ((arb_poly([1]), arb_poly([])), (arb_poly([]), arb_poly([1])))
    with working_bits(128):
        plan = Plan((arb(1), arb((1, -24))), arb(1), 2, 60, 60)
        step = certified_step(VectorField([y, ZERO]), PolynomialCurve((arb_poly([0]),) * 2, unit), [TINY] * 2, h, plan)
        assert step is not None
        assert holds(step.flow[0, 1], h)
        assert step.flow[0, 1].rad() < h * (1 + arb((1, -20)))


def pole(a: int) -> VectorField:
    """x' = 1/(a - x)."""
    return VectorField([Power(Constant(fmpq(a)) - x, fmpq(-1))])


@pytest.mark.parametrize("length", [1, 2, 3])
def test_the_tail_of_a_pole_just_outside_the_disc(length: int) -> None:
    """1/(128 - τ) on the disc |τ| <= 64: the terms from τ^L on are a few percent of Cauchy's bound at least; a bound
    that is a power of 64 smaller is below them."""
    field, curve, h = pole(128), arb_poly([0, 1]), arb(1)
    with working_bits(128):
        terms = [arb(128) ** -(k + 1) for k in range(60)]
        kept, left_out = sum(terms[:length], arb(0)), sum(terms[length:], arb(0))
        shown = abs(terms[0] - 1) + (kept - terms[0])  # of h f - dx/dτ, term by term
        plan = Plan((arb(1),), arb(1), 64, length, length)
        bounds = steps._cauchy_bounds(field, PolynomialCurve((curve,), ()), plan)
        assert bounds is not None
        first = steps._defect(field, PolynomialCurve((curve,), ()), h, bounds[0], plan)[0]
        second = norm_steps.defect_bounds(field, [curve], h, 64, length)
        assert second is not None
        for bound in (first, second[0]):
            assert shown + left_out <= bound < shown + 64 * left_out


@pytest.mark.parametrize("change", [arb(0), arb((1, -18))])
def test_the_tail_of_the_derivatives(change: arb) -> None:
    """x' = 1/(128 - x): the derivative along x = τ is 1/(128 - τ)², of which a short series leaves most out; how far it
    may change on the tube is added."""
    field, h = pole(128), arb(1)
    with working_bits(128):
        curve = PolynomialCurve((arb_poly([0, 1]),), ((arb_poly([1]),),))
        for length in (1, 2):
            plan = Plan((arb(1),), arb((1, -40)), 64, 60, length)
            bounds = steps._cauchy_bounds(field, curve, plan)
            assert bounds is not None
            found = steps._flow(field, curve, h, bounds[1], [[change]], arb(1), plan)[0, 0]
            kept = sum((arb(k + 1) * arb(128) ** -(k + 2) for k in range(length)), arb(0))
            whole = sum((arb(k + 1) * arb(128) ** -(k + 2) for k in range(60)), arb(0))
            assert whole + change <= found.rad() * (1 + arb((1, -28)))
            assert found.rad() < kept + 2**12 * (whole - kept) + 2 * change


@pytest.mark.parametrize("weights", [(1, 1), (fmpq(1, 4), fmpq(1, 8))])
def test_deviations_that_grow_by_what_is_beside_the_diagonal(weights: tuple[fmpq, fmpq]) -> None:
    """u' = v, v' = u for u = x/w_1, v = y/w_2: the deviation (1, 1) r grows exactly as e^τ."""
    first, second = weights
    ratio = fmpq(first) / fmpq(second)
    field = VectorField([Constant(ratio) * y, Constant(1 / ratio) * x])
    unit, r = ((arb_poly([1]), arb_poly([])), (arb_poly([]), arb_poly([1]))), arb((1, -10))
    with working_bits(128):
        w = (arb(first), arb(second))
        plan = Plan(w, arb(1), 2, 60, 60)
        step = certified_step(field, PolynomialCurve((arb_poly([0]),) * 2, unit), [r * one for one in w], arb(1), plan)
        assert step is not None
        for side, one in zip(step.enclosure(arb(1)), w, strict=True):
            true = arb(1).exp() * r * one
            assert holds(side, true)
            assert side.rad() < true * (1 + arb((1, -20)))


def test_an_enclosure_is_of_the_whole_step() -> None:
    """x = 4 τ goes from 0 to 4, in both kinds of step."""
    line, none = arb_poly([0, 4]), arb(0)
    for step in (
        Step(PolynomialCurve((line,), ((arb_poly([1]),),)), arb(1), (none,), (none,), arb_mat([[1]]), SHOWN),
        NormStep((line,), arb(1), (none,), LINE, (none,)),
    ):
        (side,) = step.enclosure()
        assert side.contains(0)
        assert side.contains(4)
        assert side.rad() < 3


@pytest.mark.parametrize("power", [2, 4, 5])
def test_a_polynomial_of_the_degree_of_the_length(power: int) -> None:
    """x' = 1 + x^k along x = τ/8: a series of k terms leaves all of x^k out, one of k + 1 terms nothing."""
    total: Expression = ONE
    product: Expression = x
    for _ in range(power - 1):
        product = product * x
    field, curve, h = VectorField([total + product]), arb_poly([0, arb((1, -3))]), arb((1, -3))
    assert field.degrees([1]) == [power]
    with working_bits(128):
        least = h + h ** (power + 1) / (power + 1)  # x > t, so x' > 1 + t^k
        for length in (power, power + 1, power + 2):
            step = certain(by_norms(field, curve, arb(0), h, length))
            assert step.enclosure(arb(1))[0].upper() > least
            assert step.end([h]).enclosure()[0].upper() > least
            assert (length == power) is bool(step.tube[0] > 100 * (least - h))


def test_another_midpoint_costs_its_distance() -> None:
    """The set about an exact point 2^-10 away holds the end of the solution, and hardly more."""
    moved = arb((1, -10))
    with working_bits(128):
        quarter = Basis(arb_mat([[arb((1, -2))]]), (1,))
        plan = NormPlan((arb(0), arb(1)), (quarter,), (arb(64),), 2, 60)
        step = certain(norm_step(GROWTH, [exponential(40)], StateSet((arb(1),), LINE, (arb(0),)), arb(1), plan))
        end = step.solution[0](arb(1)).mid()
        for sign in (-1, 1):
            side = step.end([end + sign * moved]).enclosure()[0]
            assert holds(side, arb(1).exp())
            assert side.rad() < moved * (1 + arb((1, -20)))


def test_the_local_error_and_the_midpoint_enter_lohners_set() -> None:
    """A step that ends in 1 ± 2^-5 about 1/3, which is no exact number: the set holds both ends."""
    with working_bits(64):
        local, third = arb((1, -5)), arb(1) / 3
        curve = PolynomialCurve((arb_poly([third]),), ((arb_poly([1]),),))
        step = Step(curve, arb(1), (local,), (local,), arb_mat([[1]]), SHOWN)
        after = ErrorSet.of_box([arb(0)]).after(step)
        assert after is not None
        for sign in (-1, 1):
            assert holds(after.enclosure()[0], third + sign * local)
        assert after.enclosure()[0].contains(third)
        assert after.enclosure()[0].rad() < local * (1 + arb((1, -20)))


def test_changing_the_basis_takes_all_of_the_set() -> None:
    """A turning pair from the basis of the axes to that of the diagonals: the corner of the square is 2^(1/2) away."""
    axes = Basis(arb_mat([[1, 0], [0, 1]]), (1, 1))
    diagonals = Basis(arb_mat([[1, 1], [1, -1]]), (1, 1))
    still = VectorField([ZERO, ZERO])
    r = arb((1, -6))
    with working_bits(128):
        plan = NormPlan((arb(0), arb(1)), (diagonals,), (arb(64),), 2, 10)
        step = norm_step(still, [arb_poly([1]), arb_poly([2])], StateSet((arb(1), arb(2)), axes, (r, r)), arb(1), plan)
        assert step is not None
        # (r, r) = r (1, 1) and (r, -r) = r (1, -1): each radius is r, exactly.
        for radius in step.radii:
            assert r <= radius * (1 + arb((1, -60)))
            assert radius < r * (1 + arb((1, -20)))


def test_the_set_of_a_box_is_the_box() -> None:
    """Two sides of different widths, each its own."""
    box = [arb(1, "0.5"), arb(2, "0.25")]
    with working_bits(64):
        for found, side in zip(ErrorSet.of_box(box).enclosure(), box, strict=True):
            assert holds(found, side.lower())
            assert holds(found, side.upper())
            assert found.rad() < side.rad() * (1 + arb((1, -20)))


def test_the_local_error_is_taken_into_turned_coordinates() -> None:
    """A flow that turns by an eighth: the new coordinates are turned, the local error lies along the first axis."""
    local = arb((1, -5))
    with working_bits(64):
        c = (arb(1) / 2).sqrt().mid()
        unit = ((arb_poly([1]), arb_poly([])), (arb_poly([]), arb_poly([1])))
        curve = PolynomialCurve((arb_poly([0]),) * 2, unit)
        turn = arb_mat([[c, -c], [c, c]])
        after = ErrorSet.of_box([arb(0), arb(0)]).after(Step(curve, arb(1), (local,) * 2, (local, arb(0)), turn, SHOWN))
        assert after is not None
        for sign in (-1, 1):
            assert holds(after.enclosure()[0], sign * local)
        assert after.enclosure()[0].rad() < local * (1 + arb((1, -20)))
        for value in (arb("inf"), arb("nan")):
            step = Step(curve, arb(1), (local,) * 2, (local, value), turn, SHOWN)
            assert ErrorSet.of_box([arb(0), arb(0)]).after(step) is None
