"""The critical friction: closed forms of the rod and the oscillator, a scan of the two-link arm, absence, refusal.

proofs/critical_friction.md.
"""

from __future__ import annotations

import json
import math
from dataclasses import replace
from fractions import Fraction
from typing import Any

import pytest
from flint import arb
from hypothesis import given, settings
from hypothesis import strategies as st
from samples.strategies import to_fmpq

from gspot_verified.functions.box_program import BoxProgram
from gspot_verified.functions.expressions import Constant, Variable
from gspot_verified.mechanisms.input.given import lagrangian
from gspot_verified.mechanisms.input.mechanism import Mechanism
from gspot_verified.mechanisms.shipped import shipped_mechanism
from gspot_verified.mechanisms.spots.critical_friction import CriticalFriction, _Maximum, critical_friction
from gspot_verified.numbers.balls import working_bits


def rod(
    inertia: Fraction, half: Fraction = Fraction(1), mass: Fraction = Fraction(1), angle: str = "theta"
) -> Mechanism:
    return lagrangian(
        "rod", ["X", "Y", "theta"], [[str(mass), 0, 0], [0, str(mass), 0], [0, 0, str(inertia)]],
        [0, f"-{mass}", 0], f"X + {half}*cos({angle})", f"Y - {half}*sin({angle})", 1,
    )  # fmt: skip


@settings(deadline=None, max_examples=20)
@given(
    st.fractions(Fraction(1, 50), 5, max_denominator=50),
    st.sampled_from([Fraction(1), Fraction(1, 1000), Fraction(13, 3)]),
    st.sampled_from([Fraction(1), Fraction(7, 100)]),
)
def test_rods_with_any_inertia(inertia: Fraction, half: Fraction, mass: Fraction) -> None:
    """mu_c = 2 sqrt(1 + k)/k with k = m l^2/I, where tan(theta) = sqrt(1 + k); 4/3 for r^2 = l^2/3."""
    found = critical_friction(rod(inertia, half, mass))
    k = mass * half**2 / inertia
    assert found.value is not None
    with working_bits(150):
        root = (1 + arb(to_fmpq(k))).sqrt()
        assert found.value.is_finite()
        assert found.value.overlaps(2 * root / arb(to_fmpq(k)))
        assert found.value.rad() < abs(found.value) * arb(2) ** -90
        assert len(found.places) == 2


def test_the_slender_rod() -> None:
    found = critical_friction(shipped_mechanism("genot_brogliato_rod", mu="13/10"))
    assert found.value is not None
    assert (found.value * 3 - 4).contains(0)
    assert found.is_below is True
    assert "mu = [1.3" in str(found)
    assert "below mu_c" in str(found)
    assert critical_friction(shipped_mechanism("genot_brogliato_rod", mu=2)).is_below is False
    assert critical_friction(shipped_mechanism("genot_brogliato_rod", mu="4/3")).is_below is None
    turned = critical_friction(rod(Fraction(1, 3), angle="1 - theta"))
    assert turned.value is not None
    assert turned.value.overlaps(found.value)


@pytest.mark.parametrize(("first", "second"), [(1, 1), (4, 1), (1, 100), (3, 7)])
def test_the_oscillator_with_any_masses(first: int, second: int) -> None:
    """C/B = (m_1 + m_2 t^2)/(m_2 t) with t = tan(phi): its least value is 2 sqrt(m_1/m_2)."""
    found = critical_friction(
        shipped_mechanism("frictional_impact_oscillator_all_parameters", m_1=first, m_2=second, l=Fraction(3, 7))
    )
    assert found.value is not None
    with working_bits(150):
        assert found.value.overlaps(2 * (arb(first) / second).sqrt())


def arm(height: str) -> Mechanism:
    return lagrangian(
        "two-link arm", ["a", "c"], [["4/3", "cos(a - c)/2"], ["cos(a - c)/2", "1/3"]],
        ["-sin(a - c)*c_dot^2/2 - 3*sin(a)/2", "sin(a - c)*a_dot^2/2 - sin(c)/2"],
        "sin(a) + sin(c)", "h - cos(a) - cos(c)", "3/10", {"h": height},
    )  # fmt: skip


def scanned(height: float) -> float:
    least = math.inf
    end = math.acos(height - 1)
    for side in (-1, 1):
        for k in range(20_001):
            a = -end + 2 * end * k / 20_000
            c = side * math.acos(min(1.0, height - math.cos(a)))
            coupling = math.cos(a - c) / 2
            inverse = ((1 / 3, -coupling), (-coupling, 4 / 3))
            x, y = (math.cos(a), math.cos(c)), (math.sin(a), math.sin(c))
            C = sum(y[i] * inverse[i][j] * y[j] for i in range(2) for j in range(2))
            B = sum(y[i] * inverse[i][j] * x[j] for i in range(2) for j in range(2))
            least = min(least, C / B if B > 0 else math.inf)
    return least


@pytest.mark.parametrize("height", ["1/2", "1", "6/5", "3/2", "19/10"])
def test_a_constraint_that_cannot_be_solved_explicitly(height: str) -> None:
    """The arm touches the surface where y = 0 only: two routes, Lagrange's condition in balls and a scan in floats."""
    found = critical_friction(arm(height))
    expected = scanned(float(Fraction(height)))
    assert found.value is not None
    assert found.value.rad() < 1e-20
    assert float(found.value) == pytest.approx(expected, rel=1e-6)
    assert float(found.value) <= expected + 1e-12


def test_no_friction_is_enough_or_there_is_no_contact() -> None:
    block = lagrangian("block", ["X", "Y"], [[1, 0], [0, 1]], [0, -1], "X", "Y", 5)
    found = critical_friction(block)
    assert found.value is not None
    assert not found.value.is_finite()
    assert found.is_below is True
    assert "infinite (for every mu >= 0 p > 0 in every configuration" in str(found)
    away = critical_friction(arm("3"))
    assert away.value is not None
    assert not away.value.is_finite()
    assert "no configuration has y = 0" in str(away)


def test_what_is_not_covered_is_refused_with_its_reason() -> None:
    found = critical_friction(shipped_mechanism("model"))
    assert found.value is None
    assert found.is_below is None
    assert "not periodic in p" in str(found)
    stopped = critical_friction(arm("1"), budget=3)
    assert stopped.value is None
    assert stopped.reason


def test_plain_data_and_no_truth_value() -> None:
    found: Any = critical_friction(shipped_mechanism("rod"))
    assert json.loads(json.dumps(found.to_json()))["infinite"] is False
    with pytest.raises(TypeError, match="is_below"):
        bool(found)


def test_constraints_with_multipliers_are_refused() -> None:
    tied = lagrangian(
        "tied", ["X", "Y", "theta"], [[1, 0, 0], [0, 1, 0], [0, 0, "1/3"]], [0, -1, 0], "X + cos(theta)",
        "Y - sin(theta)", 2, constraints=["X - sin(theta)"],
    )  # fmt: skip
    found = critical_friction(tied)
    assert found.value is None
    assert "constraints" in found.reason


def test_a_negative_coefficient_is_not_below() -> None:
    """Nothing is said of p there: by the mirror image, p of the rod vanishes where p of mu = +2 does."""
    found = critical_friction(shipped_mechanism("genot_brogliato_rod", mu=-2))
    assert found.value is not None
    assert found.value.overlaps(arb(4) / 3)
    assert found.is_below is None
    assert "lies below" not in str(found)
    assert found.to_json()["below"] is None
    assert critical_friction(shipped_mechanism("genot_brogliato_rod", mu=0)).is_below is True


@pytest.mark.parametrize(("mass", "inertia"), [("-1", "-1/12"), ("-1", "-1/1000")])
def test_a_mass_matrix_that_is_negative_definite_has_no_critical_friction(mass: str, inertia: str) -> None:
    """p = C - mu B changes its sign with the mass matrix: B/C and its maximum do not, but C < 0."""
    made = lagrangian(
        "rod", ["X", "Y", "theta"], [[mass, 0, 0], [0, mass, 0], [0, 0, inertia]], [0, -1, 0], "X + cos(theta)/2",
        "Y - sin(theta)/2", 1,
    )  # fmt: skip
    found = critical_friction(made)
    assert found.value is None
    assert found.is_below is None
    assert found.reason == "the mass matrix is not certainly positive definite where B/C is largest"
    assert found.mass_matrix == "the mass matrix is not positive definite in any configuration"


def bent(x: str, y: str, inertia: int = 1) -> Mechanism:
    """A body whose contact point moves on it: B = -x'(theta) y'(theta)/I, C = 1 + y'(theta)^2/I."""
    return lagrangian(
        "bent", ["X", "Y", "theta"], [[1, 0, 0], [0, 1, 0], [0, 0, inertia]], [0, -1, 0], f"X + {x}", f"Y - ({y})", 1
    )


def test_a_rough_value_names_the_function_that_searches_longer() -> None:
    rough, sharp = (CriticalFriction("a", arb(0.7, radius), (), None) for radius in (0.4, 1e-9))
    assert rough.in_short().endswith(" (found roughly; critical_friction takes longer and may say more)")
    assert sharp.in_short() == "critical friction mu_c = 0.700000"


def test_a_friction_below_the_critical_one_is_not_written_above_it() -> None:
    """With six digits 1.234567 is 1.23457, above 1.2345675."""
    found = CriticalFriction("a", arb("1.2345675", 1e-12), (), arb("1.234567"))
    assert found.is_below
    assert "; mu lies below it: p > 0" in found.in_short()
    assert "1.23457 lies" not in found.in_short()
    assert "mu = [1.23456700000000 +/- " in str(found)


def test_of_several_places_one_is_shown_to_have_the_largest_value() -> None:
    one, other = (("theta", "1"),), (("theta", "2"),)
    assert "attained at theta = 1" in str(CriticalFriction("a", arb("0.7", 1e-9), (one,), None))
    two = str(CriticalFriction("a", arb("0.7", 1e-9), (one, other), None))
    assert "attained at one of these places, at least: theta = 1; theta = 2" in two


def test_only_the_largest_of_several_maxima_is_named() -> None:
    """x = cos, y = sin + sin(2 theta): B/C has maxima of different height, which the search proves."""
    found = critical_friction(bent("cos(theta)", "sin(theta) + sin(2*theta)"))
    slopes = [(math.cos(t) + 2 * math.cos(2 * t), math.sin(t)) for t in (2 * math.pi * k / 5000 for k in range(5000))]
    assert found.value is not None
    assert float(found.value) == pytest.approx(1 / max(f * s / (1 + f * f) for f, s in slopes), rel=1e-5)
    assert len(found.places) == 1


def test_where_the_largest_ratio_is_zero_nothing_is_said() -> None:
    """x = cos, y = cos: B = -sin^2 touches 0, so p > 0 for every mu, but no ball shows it."""
    found = critical_friction(bent("cos(theta)", "cos(theta)"))
    assert found.value is None
    assert found.reason == "B may vanish where B/C is largest"


def test_a_ratio_that_is_not_bounded_is_said() -> None:
    """I = -1: C = 1 - 4 cos(theta)^2 vanishes at pi/3, where B does not."""
    found = critical_friction(bent("2*cos(theta)", "2*sin(theta)", -1), budget=10**6)
    assert found.value is None
    assert found.reason == "B/C is not bounded on a box that is left: C may vanish"
    assert "budget" in critical_friction(bent("2*cos(theta)", "2*sin(theta)", -1), budget=10).reason


def test_of_nothing_found_it_is_not_said_that_it_is_infinite() -> None:
    found = CriticalFriction("?", None, (), None, "not looked for")
    assert found.infinite is False
    assert found.finite_value is None


def test_where_the_gradients_are_parallel_every_minor_vanishes() -> None:
    """Lagrange's condition in three variables: B/C = x + 2 y + 3 z and the constraint twice that."""
    x, y, z = (Variable(i) for i in range(3))
    maximum = object.__new__(_Maximum)
    maximum._size, maximum._variables = 3, [0, 1, 2]
    maximum._ratio = x + Constant(2) * y + Constant(3) * z
    for last, stationary in ((6, True), (5, False)):
        maximum._constraint = Constant(2) * x + Constant(4) * y + Constant(last) * z
        values = BoxProgram(maximum._stationary()[1:], 3, ()).values([arb(0)] * 3)
        assert len(values) == 2
        assert all(value == 0 for value in values) is stationary


def test_the_sentence_speaks_of_a_positive_definite_mass_matrix_alone() -> None:
    """y = 0 at f = 0, with the mass 1, and at f = pi, with the mass -1: there p = cos(f) - mu < 0 at every mu >= 0."""
    body = lagrangian("two places", ["f", "s"], [["cos(f)", 0], [0, 1]], [0, 0], "f", "sin(f)", "1/10")
    found = critical_friction(body)
    assert found.value is not None
    assert found.value.overlaps(arb(1))
    assert found.is_below is True
    wanted = "p > 0 in every configuration in contact with a positive definite mass matrix"
    for text in (str(found), found.in_short()):
        assert wanted in text
    level = lagrangian("level", ["f", "s"], [[2, 0], [0, 1]], [0, 0], "s", "sin(f)", "1/10")
    assert wanted in str(critical_friction(level))
    assert "not positive definite everywhere in contact: not somewhere at f = [3.14" in found.mass_matrix
    assert found.mass_matrix in str(found)
    assert critical_friction(level).mass_matrix == ""


def with_masses(first: str, last: str) -> Mechanism:
    """The rod with a fourth coordinate s that the contact does not feel."""
    rows = [[first, 0, 0, 0], [0, 1, 0, 0], [0, 0, "1/3", 0], [0, 0, 0, last]]
    x, y = "X + cos(theta)", "Y - sin(theta)"
    return lagrangian("rod and s", ["X", "Y", "theta", "s"], rows, [0, -1, 0, 0], x, y, 1)


@pytest.mark.parametrize(
    ("first", "last", "places", "said"),
    [
        ("1", "1", 2, ""),
        ("1", "3/2 + cos(theta)", 2, ""),
        ("1", "1/2 + sin(theta)", 1, "not somewhere at theta = ["),  # at one of the two places
        ("1/2 - cos(theta)^2/4", "3/4 - sin(theta)^2", 0, "not somewhere at theta = ["),  # 3/4 < sin^2 = 4/5 at both
        ("1", "cos(s)", 0, "not somewhere at s = ["),
        ("-1", "1", 0, "in any configuration"),
        ("1", "-cos(theta)^2 - 1", 0, "everywhere in contact: not somewhere at theta"),
    ],
)
def test_a_mass_matrix_that_is_indefinite_somewhere_is_said(first: str, last: str, places: int, said: str) -> None:
    """B/C is that of the rod, largest at tan(theta) = 2: mu_c = 4/3 only where a mass matrix is positive definite."""
    found = critical_friction(with_masses(first, last))
    assert said in found.mass_matrix
    assert bool(said) is bool(found.mass_matrix)
    assert said in str(found)
    assert len(found.places) == places
    assert (found.value is None) is (places == 0)
    if found.value is not None:
        assert found.value.overlaps(arb(4) / 3)
    else:
        assert found.reason == "the mass matrix is not certainly positive definite where B/C is largest"


@pytest.mark.parametrize(
    ("given", "shown"), [("0", "0"), ("1/2", "0.5"), ("2^(1/2)", "[1.41421356237310 +/- 4.96e-15]")]
)
def test_a_fixed_component_counts(given: str, shown: str) -> None:
    """A telescope of the length l = 1 + s: C/B = (1 + k + 2 t^2)/((k - 1) t), k = 3 l^2, t = tan(theta)."""
    made = lagrangian(
        "telescope", ["X", "Y", "theta", "s"], [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, "1/3", 0], [0, 0, 0, 1]],
        [0, -1, 0, 0], "X + (1 + s)*cos(theta)", "Y - (1 + s)*sin(theta)", 1,
        place={"X": 0, "X_dot": 1, "s": given, "s_dot": 0}, fixed=["X", "X_dot", "s", "s_dot"],
    )  # fmt: skip
    found = critical_friction(made)
    assert found.value is not None
    with working_bits(100):
        k = 3 * (1 + {"0": arb(0), "1/2": arb("0.5"), "2^(1/2)": arb(2).sqrt()}[given]) ** 2
        assert found.value.overlaps(2 * (2 * (1 + k)).sqrt() / (k - 1))
        assert found.value.rad() < arb("1e-20")
    assert found.held == (("s", shown),)
    assert f"; with s = {shown} fixed" in found.in_short()
    free = critical_friction(replace(made, place=replace(made.place, fixed=("X", "X_dot"))))
    assert free.reason == "B, C and y are not periodic in s"


@pytest.mark.parametrize(("given", "said"), [("2", "no configuration has y = 0"), ("1", "y = 0 holds no component")])
def test_a_height_that_fixed_components_alone_hold(given: str, said: str) -> None:
    made = lagrangian(
        "post", ["X", "s"], [[1, "1/4"], ["1/4", 1]], [0, 0], "X", "s^2 - 1", 1,
        place={"s": given, "s_dot": 0}, fixed=["s", "s_dot"],
    )  # fmt: skip
    found = critical_friction(made)
    assert said in found.reason
    assert found.infinite is (given == "2")
    assert f"with s = {given} fixed" in str(found)
