"""The laws hold on drawn systems, and each check notices what it is there for."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest
from flint import arb, fmpq
from hypothesis import given, settings
from hypothesis import strategies as st

from gspot_verified import expand, load
from gspot_verified.expansion.series.recursion import ObstructedOrderError, space_of
from gspot_verified.expansion.series.spaces import SpacePolynomial
from gspot_verified.expansion.series.system import GSpotError, System
from gspot_verified.expansion.trajectory import Trajectory, expand_system
from gspot_verified.functions.expressions import Constant, Expression, Power, Variable
from gspot_verified.functions.rings import BALLS
from gspot_verified.functions.symbols import Symbols
from gspot_verified.testing import (
    check_expansion,
    check_lie_derivatives,
    check_spaces,
    check_synchronisation,
    check_trajectory,
    extended_example,
    systems,
)

one = Constant(fmpq(1))


@given(systems(), st.integers(1, 9))
def test_polynomial_systems(system: System, order: int) -> None:
    assert check_expansion(system, order).order == order


@settings(max_examples=30)
@given(systems(analytic=True), st.integers(1, 9))
def test_analytic_systems(system: System, order: int) -> None:
    check_expansion(system, order)


@pytest.mark.parametrize("chi", [0, 1, "-7/5"])
def test_a_longer_expansion(chi: int | str) -> None:
    check_expansion(extended_example(chi), 31)


def test_balls_and_symbols() -> None:
    base = extended_example("1/3")
    check_expansion(replace(base, point=(arb(0),) * 6, ring=BALLS), 9)
    ring = Symbols("chi")
    slope = Constant(fmpq(-1)) + Constant(ring.symbol("chi")) * Variable(5)
    zero = ring.number(0)
    check_expansion(replace(base, F=(*base.F[:4], slope, base.F[5]), alpha_1=slope, point=(zero,) * 6, ring=ring), 9)


@pytest.mark.parametrize("name", ["v", "p", "alpha_1", "alpha_2", "alpha_3"])
def test_a_wrong_function_is_seen_where_parameters_are_symbols(name: str) -> None:
    """The change is of degree 3 at the G-spot: no term of the orders asked for knows of it."""
    system = expand(load("extended", chi=None), 3).system
    check_expansion(system, 3)
    cube = Constant(fmpq(1, 1000)) * Variable(5) * Variable(5) * Variable(5)
    with pytest.raises(AssertionError, match="fails near the G-spot"):
        check_expansion(replace(system, **{name: getattr(system, name) + cube}), 3)


@st.composite
def wrong_terms(draw: st.DrawFn) -> Trajectory:
    """A right expansion with one coefficient changed inside its space."""
    good = expand_system(draw(systems()), 8)
    name = draw(st.sampled_from([*good.terms()]))
    variable = "xi" if name.startswith("xi") else name.removesuffix("_n")
    n = draw(st.sampled_from([n for n in range(8) if space_of(variable, n) >= 0]))
    space = space_of(variable, n)
    k = draw(st.sampled_from(range(space % 3, space + 1, 3)))
    change = SpacePolynomial.from_list(space, [0] * k + [draw(st.sampled_from([fmpq(1), fmpq(-1, 10**20)]))])
    if variable == "xi":
        i = int(name[3:]) - 1
        terms = [list(row) for row in good.xi]
        terms[i][n] = terms[i][n] + change
        return replace(good, xi=tuple(tuple(row) for row in terms))
    scalars = list(good.terms()[name])
    scalars[n] = scalars[n] + change
    return replace(good, **{name: tuple(scalars)})


@given(wrong_terms())
def test_the_terms_are_the_only_ones(wrong: Trajectory) -> None:
    """Uniqueness: no coefficient can be changed alone."""
    with pytest.raises(AssertionError, match="drawn"):
        check_trajectory(wrong)


def test_a_term_outside_its_space() -> None:
    good = expand_system(extended_example(1), 5)
    wrong = replace(good, b=(*good.b[:4], SpacePolynomial.from_list(1, [0, 1])))
    with pytest.raises(AssertionError, match=r"b_4 has a term in s\^1, which P_3 does not have"):
        check_spaces(wrong)


def test_terms_that_are_not_finite_keep_no_law() -> None:
    """A ball that is not finite excludes nothing: such terms passed all laws."""
    good = expand(load("genot_brogliato_rod"), 3)
    wrong = replace(good, b=(*good.b[:2], good.b[2].scale(arb("nan"))))
    for check in (check_spaces, check_trajectory):
        with pytest.raises(AssertionError, match="b_2 is not finite, so nothing is compared with it"):
            check(wrong)
    with pytest.raises(AssertionError, match=r"b and its function of xi differ at delta\^4"):
        check_synchronisation(wrong)


# Each law of the functions, broken alone.
_BROKEN: dict[str, dict[str, Expression]] = {
    "L_F y = v": {"v": Variable(3) + Variable(1)},
    "L_G v = p": {"p": Variable(4) + Power(Variable(1), fmpq(2))},
    "L_F v = b": {"b": Variable(5) + Variable(0)},
    "L_F p = alpha_1": {"alpha_1": Constant(fmpq(-1)) + Variable(4)},
    "L_F b = alpha_2": {"alpha_2": Constant(fmpq(-2))},
    "L_G b = -alpha_3": {"alpha_3": Constant(fmpq(-4, 3))},
}


@pytest.mark.parametrize("law", _BROKEN)
def test_a_wrong_function_is_named(law: str) -> None:
    system = replace(extended_example(1), **_BROKEN[law])
    with pytest.raises(AssertionError, match=f"extended example: {law} fails|extended example: L_"):
        check_expansion(system, 4)
    with pytest.raises(AssertionError, match=f"{law} fails" if law[2] == "F" or "alpha" in law else "fails"):
        check_lie_derivatives(system)


def test_the_structure_of_the_control() -> None:
    base = extended_example(1)
    for index, law in ((2, "L_G y = 0"), (4, "L_G p = 0")):
        control = list(base.G)
        control[index] = Variable(0) + one
        with pytest.raises(AssertionError, match=f"{law} fails"):
            check_lie_derivatives(replace(base, G=tuple(control)))


@pytest.mark.parametrize("missing", [Power(Variable(0) * Variable(0) * -one, fmpq(1, 2)), Constant(arb("nan"))])
def test_nothing_compared_is_no_law(missing: Expression) -> None:
    """A function that is defined nowhere near the G-spot, or is NaN there, agrees with nothing."""
    base = extended_example(1)
    wrong = replace(base, ring=BALLS, point=(arb(0),) * 6, v=base.v + missing)
    with pytest.raises(AssertionError, match="no point near the G-spot was found"):
        check_lie_derivatives(wrong)


def test_without_synchronisation() -> None:
    """alpha_2 with a wrong value at the G-spot gives another b than the function of xi."""
    wrong = replace(extended_example(1), alpha_2=Constant(fmpq(-2)))
    with pytest.raises(AssertionError, match=r"b and its function of xi differ at delta\^2"):
        check_synchronisation(expand_system(wrong, 4))


@pytest.mark.parametrize("name", ["extended", "rod", "oscillator", "genot_brogliato_rod"])
def test_a_mechanism(name: str) -> None:
    """As the pages call it: the terms are those of expand, also where the G-spot is a box."""
    found = check_expansion(load(name), 5)
    assert found.terms().keys() == expand(load(name), 5).terms().keys()
    assert found.order == 5
    exact = isinstance(found.system.point[0], fmpq)
    assert exact == (name != "genot_brogliato_rod")
    assert not exact or found.terms() == expand(load(name), 5).terms()


def test_a_mechanism_with_symbols_and_one_of_its_other_spots() -> None:
    assert [str(value) for value in check_expansion(load("extended", chi=None), 3).p[2].coefficients()] == [
        "0",
        "0",
        "chi",
    ]
    with pytest.raises(GSpotError, match="alpha_1"):
        check_expansion(load("genot_brogliato_rod"), 3, spot=2)


def test_a_wrong_function_is_seen_in_the_box_of_a_mechanism() -> None:
    system = expand(load("genot_brogliato_rod"), 3).system
    check_expansion(system, 3)
    with pytest.raises(AssertionError, match="L_F p = alpha_1 fails"):
        check_expansion(replace(system, alpha_1=system.alpha_1 + Constant(fmpq(-1, 2**40)) * one), 3)


@pytest.mark.parametrize("source", [None, "rod", 3])
def test_neither_a_mechanism_nor_a_system(source: Any) -> None:
    with pytest.raises(TypeError, match="expected a Mechanism or a System"):
        check_expansion(source, 3)


def test_hypotheses_are_reported_as_such() -> None:
    with pytest.raises(ObstructedOrderError):
        check_expansion(extended_example(1, (-1, -1, -2)), 5)
    with pytest.raises(GSpotError, match="alpha_1"):
        check_expansion(extended_example(1, (1, -1, -2)), 5)
