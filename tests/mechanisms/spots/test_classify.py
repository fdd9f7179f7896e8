"""The three cases, the numbers that go with them, and clear errors where there are none."""

from __future__ import annotations

import json
from dataclasses import replace
from fractions import Fraction
from importlib import resources
from typing import Any

import pytest
from flint import arb, fmpq

from gspot_verified.expansion.series.recursion import ObstructedOrderError, Recursion
from gspot_verified.expansion.series.regularisation import NO_DAMPER, Regularisation
from gspot_verified.expansion.series.system import GSpotError
from gspot_verified.functions.expressions import Constant
from gspot_verified.mechanisms.expand import expand
from gspot_verified.mechanisms.input.file import parse_mechanism
from gspot_verified.mechanisms.input.given import lagrangian
from gspot_verified.mechanisms.input.mechanism import MechanismError
from gspot_verified.mechanisms.shipped import shipped_mechanism, shipped_names, shipped_system
from gspot_verified.mechanisms.spots.classify import MAX_BETA, _integer_in, classify, sides_of
from gspot_verified.numbers.balls import working_bits


def holds(ball: arb, number: fmpq) -> bool:
    """Whether the ball contains p/q: exact integers, because contains() rounds a rational first."""
    return bool(ball.is_finite() and (ball * number.q - number.p).contains(0))


@pytest.mark.parametrize(
    ("alphas", "case", "reason"),
    [
        (("-3/2", -1, -1), "I", "alpha_1 < alpha_3 < 0"),
        (("-3/2", 1, -1), "II", "alpha_2 > 0"),
        ((-1, -1, "-3/2"), "III", "alpha_3 < alpha_1 < 0"),
        ((-1, 1, "-3/2"), "none", "alpha_2 > 0 and alpha_3 < alpha_1"),
        ((1, -1, "-3/2"), "none", "alpha_1 is not negative"),
        ((0, -1, "-3/2"), "none", "alpha_1 is not negative"),
        ((-1, -1, "3/2"), "none", "alpha_3 is not negative"),
        ((-1, -1, 0), "none", "alpha_3 is not negative"),
        ((-1, 0, "-3/2"), "none", "alpha_2 = 0"),
        ((-1, -1, -1), "none", "beta = 1"),
    ],
)
def test_cases_of_the_extended_system(alphas: tuple[Any, Any, Any], case: str, reason: str) -> None:
    first, second, third = alphas
    found = classify(shipped_mechanism("extended", alpha_1=first, alpha_2=second, alpha_3=third))
    assert found.case == case
    assert reason in found.reason
    numbers = [Fraction(value) for value in alphas]
    assert [Fraction(int(v.p), int(v.q)) for v in (found.alpha_1, found.alpha_2, found.alpha_3)] == numbers
    if numbers[0] != 0:
        beta = numbers[2] / numbers[0]
        assert found.beta == fmpq(beta.numerator, beta.denominator)
    else:
        assert found.beta is None
    # A side is given in Case III only; in Cases I and II C_1 < 0 takes an IWC; in no Case nothing is said.
    assert (found.lift_off_sign, found.impact_sign) == {"III": (-1, 1), "none": (None, None)}.get(case, (None, -1))
    data = json.loads(json.dumps(found.to_json()))
    assert (data["lift_off_sign_of_C1"], data["impact_sign_of_C1"]) == (found.lift_off_sign, found.impact_sign)
    assert ("lifts off" in str(found)) == (case == "III")
    assert ("IWC" in str(found)) == (case != "none")


@pytest.mark.parametrize(
    ("beta", "kappa", "case"),
    [("7/3", 0, "III"), ("1/2", 0, "I"), ("1/2", 40, "II"), ("5/2", 40, "none"), ("12/5", -1, "III")],
)
def test_the_oscillator_may_be_in_any_class(beta: str, kappa: int, case: str) -> None:
    """Paper, Sec. 6, line 2183."""
    found = classify(shipped_mechanism("oscillator", beta=beta, kappa=kappa))
    assert found.case == case
    assert str(found.beta) == beta
    assert found.exact


def test_the_printed_point_of_the_oscillator() -> None:
    found = classify(shipped_mechanism("oscillator"))
    assert [str(v) for v in (found.alpha_1, found.alpha_2, found.alpha_3)] == [
        "-175/408",
        "-186037/99144",
        "-1225/1224",
    ]
    assert found.lift_off_sign == 1
    assert found.mean_force is not None
    assert found.mean_force > 0
    assert found.slip_velocity == fmpq(-3, 5)


def test_a_tensile_mean_force_is_warned_of() -> None:
    """Paper, Sec. 3.1: in Case I the trivial solution is unphysical; also for beta > 1 with alpha_2 > 0."""
    for alphas, tensile in (((-1, "-1/2"), True), ((1, "-1/2"), False), ((-1, "-3/2"), False), ((1, "-3/2"), True)):
        found = classify(shipped_mechanism("extended", alpha_2=alphas[0], alpha_3=alphas[1]))
        assert found.mean_force is not None
        assert (found.mean_force < 0) == tensile
        warned = [warning for warning in found.warnings if "tensile" in warning]
        assert len(warned) == tensile
        assert ("tensile" in str(found)) == tensile
        assert found.to_json()["warnings"] == list(found.warnings)


@pytest.mark.parametrize(("u", "words"), [("-1", "u < 0 at"), ("0", "u = 0 at"), ("1/3", None)])
def test_no_positive_slip_on_a_surface_at_rest_is_warned_of(u: str, words: str | None) -> None:
    toml = resources.files("gspot_verified.mechanisms").joinpath("data", "extended_system.toml").read_text("utf-8")
    found = classify(parse_mechanism(toml.replace("\nu = 1\n", f'\nu = "{u}"\n')))
    assert found.slip_velocity == fmpq(Fraction(u).numerator, Fraction(u).denominator)
    assert [words] * (words is not None) == [w[: len(words or "")] for w in found.warnings]
    assert found.to_json()["warnings"] == list(found.warnings)
    assert ("no positive slip on a surface at rest" in str(found)) == (words is not None)


def test_a_slip_velocity_and_a_mean_force_of_unknown_sign_are_warned_of() -> None:
    found = replace(classify(shipped_mechanism("model")), slip_velocity=arb(0, 1), mean_force=arb(0, 1))
    assert "may be tensile" in found.warnings[0]
    assert "not certainly positive" in found.warnings[1]


def test_mean_force_is_the_force_of_the_expansion() -> None:
    """λ_0 for constant alphas is alpha_2/(alpha_3 - alpha_1), not its opposite as in eq. modelSysDistZY (line 604)."""
    found = classify(shipped_mechanism("model"))
    recursion = expand(shipped_mechanism("model"), 1)
    assert found.mean_force == recursion.lambda_n[0].at_zero() == 2


def test_balls_and_rationals_agree() -> None:
    exact = classify(shipped_mechanism("oscillator"))
    balls = classify(shipped_mechanism("frictional impact oscillator, all parameters"))
    assert exact.exact
    assert not balls.exact
    assert balls.case == exact.case == "III"
    with working_bits(200):
        for name in ("alpha_1", "alpha_2", "alpha_3", "beta", "mean_force", "slip_velocity"):
            ball, number = getattr(balls, name), getattr(exact, name)
            assert holds(ball, number)
            assert ball.rad() < 1e-30


def test_expansions_in_balls_contain_the_rational_ones() -> None:
    exact = expand(shipped_mechanism("oscillator"), 10)
    balls = expand(shipped_mechanism("frictional impact oscillator, all parameters"), 10)
    with working_bits(200):
        for mine, theirs in zip(exact.b, balls.b, strict=True):
            for k in range(len(theirs.coefficients())):
                ball = theirs.coefficients()[k]
                number = mine.coefficients()[k] if k < len(mine.coefficients()) else fmpq(0)
                assert holds(ball, number)


@pytest.mark.parametrize("beta", [1, 2, 3, 4, 5])
def test_integer_beta_names_the_obstructed_order(beta: int) -> None:
    mechanism = shipped_mechanism("extended", alpha_3=-beta)
    found = classify(mechanism)
    assert found.integer_beta == beta
    assert found.obstructed_order == 2 * (beta - 1)
    assert found.lift_off_sign is None
    with pytest.raises(ObstructedOrderError, match=f"integer {beta}.*order {found.obstructed_order} "):
        expand(mechanism, 16)
    recursion = Recursion(shipped_system("extended", alpha_3=-beta))
    for _ in range(2 * (beta - 1)):
        recursion.advance()
    with pytest.raises(ObstructedOrderError):
        recursion.advance()


def test_an_integer_beta_in_balls_is_not_overlooked() -> None:
    """alpha_3 of the oscillator at beta = 2: offset and damping of the family, in balls."""
    mechanism = shipped_mechanism("frictional impact oscillator, all parameters", offset="77/60", c_psi="25/27")
    found = classify(mechanism)
    assert not found.exact
    assert found.integer_beta == 2
    with pytest.raises(ObstructedOrderError):
        expand(mechanism, 5)


def test_balls_that_leave_the_case_open_say_so() -> None:
    """The rod at mu = 8/(3 sqrt 3), where alpha_1 = alpha_3: no precision settles the sign of their difference."""
    source = shipped_mechanism("genot_brogliato_rod")
    mu = lagrangian("mu", ["X"], [[1]], [0], "X", "X", "8/(3*sqrt(3))").mu
    place = replace(source.place, values=(*source.place.values[:2], ("theta", Constant(fmpq(85, 100))),
                                          *source.place.values[3:]))  # fmt: skip
    found = classify(replace(source, mu=mu, place=place))
    assert found.case is None
    assert "alpha_3 - alpha_1 open" in found.reason
    assert "undecided" in str(found)
    assert found.mean_force is None
    assert found.integer_beta == 1
    assert found.lift_off_sign is None
    assert found.to_json()["case"] is None


@pytest.mark.parametrize("order", [-1, 0, 2001, 1.5, "3", True])
def test_bad_orders(order: Any) -> None:
    with pytest.raises((ValueError, TypeError), match=r"order must (be an int|lie in)"):
        expand(shipped_mechanism("model"), order)


def test_expansion_needs_negative_alphas() -> None:
    with pytest.raises(GSpotError, match="alpha_1 = 1 must be negative"):
        expand(shipped_mechanism("extended", alpha_1=1), 3)


@pytest.mark.parametrize("matrix", [[[-1, 0], [0, 1]], [[1, 0], [0, -1]], [[1, 2], [2, 1]]])
def test_indefinite_mass_matrix(matrix: list[list[int]]) -> None:
    block = lagrangian("block", ["X", "Y"], matrix, [0, 0], "X", "Y", 1, place={"X": 0, "Y": 0, "X_dot": 0, "Y_dot": 0})
    with pytest.raises(MechanismError, match="not positive definite"):
        classify(block)


@pytest.mark.parametrize("name", [name for name in shipped_names() if name != "rod with Stribeck friction"])
def test_every_shipped_mechanism_is_classified(name: str) -> None:
    found = classify(shipped_mechanism(name))
    assert found.case in ("I", "II", "III", "none")
    json.dumps(found.to_json())
    assert name in str(found)


def test_the_falling_rod_is_in_case_ii_only_for_enough_friction() -> None:
    """At p = 0 beta = 2 s^2/(5 c^2 - 1), mu = (1 + 3 c^2)/(3 s c): beta < 1 exactly for mu > 8/(3 sqrt 3)."""
    for m, n in [(1, 2), (1, 3), (2, 3), (2, 5), (3, 5), (5, 12), (4, 7), (5, 8)]:
        s, c = Fraction(2 * m * n, m * m + n * n), Fraction(n * n - m * m, m * m + n * n)
        if 5 * c * c <= 1:
            continue
        mu = (1 + 3 * c * c) / (3 * s * c)
        rod = lagrangian(
            "rod", ["X", "Y", "theta"], [[1, 0, 0], [0, 1, 0], [0, 0, "1/3"]], [0, "-g", 0],
            "X + cos(theta)", "Y - sin(theta)", "mu", {"mu": mu, "g": s}, {"theta": (s, c)},
            {"X": 0, "Y": "sin(theta_ref)", "theta": "theta_ref", "X_dot": 2, "Y_dot": "cos(theta_ref)",
             "theta_dot": 1},
        )  # fmt: skip
        found = classify(rod)
        beta = 2 * s * s / (5 * c * c - 1)
        assert found.exact
        assert found.beta == fmpq(beta.numerator, beta.denominator)
        assert found.alpha_2 == fmpq(c.numerator, c.denominator)
        assert (found.case == "II") == (27 * mu * mu > 64 and 7 * c * c > 3)
        assert found.case == ("II" if beta < 1 else "none")


def test_an_irrational_alpha_at_a_rational_point_is_a_ball() -> None:
    toml = resources.files("gspot_verified.mechanisms").joinpath("data", "extended_system.toml").read_text("utf-8")
    found = classify(parse_mechanism(toml.replace('"-3/2"', '"-sqrt(2)"')))
    assert (found.case, found.exact, found.lift_off_sign) == ("III", False, -1)
    assert found.beta is not None
    assert isinstance(found.beta, arb)
    assert (found.beta**2).contains(2)
    with pytest.raises(ObstructedOrderError, match="integer 3"):
        expand(parse_mechanism(toml.replace('"-3/2"', '"sqrt(2) + sqrt(3) - sqrt(5 + 2*sqrt(6)) - 3"')), 5)


@pytest.mark.parametrize(("alpha_1", "alpha_3"), [(1, "1/2"), (1, 3), (2, "7/2")])
def test_no_side_and_no_obstruction_where_theorem_1_does_not_hold(alpha_1: int, alpha_3: int | str) -> None:
    found = classify(shipped_mechanism("extended system", alpha_1=alpha_1, alpha_3=alpha_3))
    assert (found.case, found.lift_off_sign, found.integer_beta, found.obstructed_order) == ("none", None, None, None)


def test_a_negative_friction_coefficient_is_refused() -> None:
    toml = resources.files("gspot_verified.mechanisms").joinpath("data", "falling_rod.toml").read_text("utf-8")
    mirrored = toml.replace('"X + l*cos(theta)"', '"-X - l*cos(theta)"').replace('mu = "73/36"', 'mu = "-73/36"')
    with pytest.raises(
        MechanismError, match=r"friction coefficient mu must not be negative at the G-spot, it is -73/36"
    ):
        classify(parse_mechanism(mirrored))


@pytest.mark.parametrize(
    ("middle", "radius", "holds_one"),
    [
        ("2.5", "0.4", False),
        ("2.5", "0.6", True),
        ("2.9", "0.2", True),
        ("2.1", "0.2", True),
        ("0.4", "0.7", True),
        ("-0.3", "1.5", True),
        ("-3", "3.5", False),
    ],
)
def test_an_integer_that_beta_may_be_is_not_lost(middle: str, radius: str, holds_one: bool) -> None:
    """On both sides of the midpoint; also where that is below 1 and the ball reaches beyond it."""
    found = _integer_in(arb(middle, radius))
    assert (found is not None) is holds_one
    assert found is None or found >= 1


def test_a_mean_force_that_is_negative_is_said_to_be() -> None:
    found = classify(shipped_mechanism("extended", alpha_2=-1, alpha_3="-1/2"))
    assert found.warnings[0].startswith("the mean force is tensile")


def test_without_a_damper_no_side_is_named() -> None:
    """Case and beta do not depend on the damper; what follows as ε → 0 does."""
    for name, case in (("falling rod", "II"), ("oscillator", "III")):
        damped = shipped_mechanism(name)
        found = classify(replace(damped, regularisation=Regularisation.of(1, 1, 0)))
        assert (found.case, found.beta) == (case, classify(damped).beta)
        assert found.what_happens == f"the side is open: {NO_DAMPER}"
        assert f"\n  no side: {NO_DAMPER}\n" in str(found)
        data = found.to_json()
        assert (data["impact_sign_of_C1"], data["lift_off_sign_of_C1"]) == (None, None)
        assert NO_DAMPER in data["notes"][-1]
        assert " side" not in data["notes"][-1]


def test_json_has_every_number_as_text() -> None:
    found = classify(shipped_mechanism("falling rod"))
    data = found.to_json()
    numbers = {"alpha_1": "-55/12", "alpha_2": "4/5", "alpha_3": "-3/2", "beta": "18/55", "mean_force": "48/185",
               "slip_velocity": "7/5"}  # fmt: skip
    assert {name: data[name] for name in numbers} == numbers
    assert replace(found, beta=None).to_json()["beta"] is None


def test_a_beta_beyond_the_largest_has_no_side_and_no_integer() -> None:
    """No answer where Gamma(-beta) is not evaluated, also for balls."""
    inside, beyond = fmpq(2 * MAX_BETA - 1, 2), fmpq(2 * MAX_BETA + 1, 2)
    assert sides_of("III", inside) == (-1, 1)  # Gamma > 0 on (-n - 1, -n) for an odd n, here 999999
    for beta in (beyond, arb(beyond), arb(MAX_BETA, 1)):
        assert sides_of("III", beta) == (None, None)
    assert _integer_in(arb(MAX_BETA + 1)) is None
    assert _integer_in(arb(MAX_BETA, 1)) is None
    assert _integer_in(arb(MAX_BETA)) == MAX_BETA


def test_the_text_says_what_there_is_and_no_more() -> None:
    """One line for each thing that is known, in the order of the fields."""
    whole = classify(shipped_mechanism("extended", alpha_3=-3))
    assert whole.integer_beta == 3
    lines = str(replace(whole, fixed=("x", "u"), notes=("one", "two"))).splitlines()
    assert lines[0] == "extended system: Case III (alpha_2 < 0, alpha_3 < alpha_1 < 0)"
    assert lines[-4:] == [
        "  beta is, or may be, the integer 3: no unique expansion, obstructed at order 4 of delta",
        "  fixed components (conditions J): x, u",
        "  note: one",
        "  note: two",
    ]
    assert "lifts off" not in str(whole)
    assert "IWC" not in str(whole)
    assert len(str(replace(whole, fixed=(), notes=(), integer_beta=None)).splitlines()) == 7
    none = str(classify(shipped_mechanism("extended", alpha_1=1)))
    assert none.startswith("extended system: no Case (trajectories do not approach in the three ways: ")
    assert len(none.splitlines()) == 7 + ("fixed" in none)


def test_the_integer_that_an_exact_beta_is() -> None:
    for k in (1, 2, 17, MAX_BETA):
        assert _integer_in(fmpq(k)) == k
        assert _integer_in(fmpq(2 * k + 1, 2)) is None
    for k in (0, -1, -2, MAX_BETA + 1):
        assert _integer_in(fmpq(k)) is None


def test_without_a_beta_nothing_is_said() -> None:
    """A ball of alpha_1 that holds 0 has no quotient."""
    assert _integer_in(None) is None
    assert sides_of("III", None) == (None, None)
