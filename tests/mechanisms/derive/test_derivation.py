"""The functions of Sec. 2 as expressions: against power series along the fields, and against the sympy route."""

from __future__ import annotations

import random
import subprocess
import sys
from collections.abc import Sequence
from typing import Any

import mpmath
import pytest
import sympy
from flint import arb, fmpq

from gspot_verified.expansion.series.terms import NumberTerms
from gspot_verified.functions.derivative import ONE, ZERO
from gspot_verified.functions.expressions import Expression, Variable, in_order
from gspot_verified.functions.power_series import SeriesOfFunctions
from gspot_verified.functions.rings import BALLS
from gspot_verified.mechanisms.derive.derivation import LagrangianInput, lagrangian_input
from gspot_verified.mechanisms.derive.lie_derivatives import derive
from gspot_verified.mechanisms.derive.to_system import Preparation, Shifted, angle_ball, shift
from gspot_verified.mechanisms.formulas.rewriting import simplified
from gspot_verified.mechanisms.input.given import lagrangian
from gspot_verified.mechanisms.input.mechanism import Lagrangian, Mechanism, MechanismError
from gspot_verified.mechanisms.shipped import shipped_mechanism, shipped_names, shipped_text
from gspot_verified.mechanisms.spots.classify import classify_g_spot
from gspot_verified.mechanisms.spots.g_spot import find_g_spot
from gspot_verified.numbers.balls import working_bits
from tests.mechanisms.chains import chain


def driven() -> Mechanism:
    """Time in the mass, the forces and the contact point; friction that depends on place and time; sparse M of 4."""
    return lagrangian(
        "driven", ["X", "Y", "a", "b"],
        [["2 + t^2", 0, "sin(a)", 0], [0, 3, "X/9", 0], ["sin(a)", "X/9", "2 + cos(b)", "1/5"], [0, 0, "1/5", 1]],
        ["-X_dot*a_dot + cos(t)", "-1 - Y_dot^3", "b*X_dot", "exp(-b)*t"], "X + cos(a + t)", "Y - sin(a - 2*t)*b",
        "1/2 + X^2/7 + t/10", time="t",
    )  # fmt: skip


SHIPPED = [name for name in shipped_names() if "slip_speed" not in shipped_text(name)]
MECHANISMS = {name: shipped_mechanism(name) for name in SHIPPED}
MECHANISMS |= {f"chain {links}": chain(links) for links in (1, 2, 5)} | {"driven": driven()}
RULES = [
    ("u", "F", "x", 1), ("v", "F", "y", 1), ("a", "F", "u", 1), ("b", "F", "v", 1), ("A", "G_T", "u", 1),
    ("B", "G_N", "u", 1), ("B", "G_T", "v", 1), ("C", "G_N", "v", 1), ("p", "G", "v", 1), ("alpha_1", "F", "p", 1),
    ("alpha_2", "F", "b", 1), ("alpha_3", "G", "b", -1),
]  # fmt: skip
WITHOUT_MASSES = ("model system", "extended system")
ZERO_RULES = [("G_T", "x"), ("G_N", "x"), ("G_T", "y"), ("G_N", "y"), ("G", "p")]


def random_point(mechanism: Mechanism, seed: int) -> list[arb]:
    source = random.Random(f"{mechanism.name} {seed}")
    return [arb(fmpq(source.randint(-60, 60), 64)) for _ in mechanism.state]


def values(expressions: Sequence[Expression], *orders: list[arb]) -> list[arb]:
    """The last order of the series of the functions."""
    series = SeriesOfFunctions(expressions, NumberTerms(BALLS), BALLS)
    for state in orders:
        series.extend(state)
    return [series[expression][-1] for expression in expressions]


def with_x(functions: Any, rules: Sequence[tuple[Any, ...]]) -> list[Any]:
    """The rules that hold where the slip velocity is given instead of x."""
    return [rule for rule in rules if functions.x is not None or "x" not in rule]


def narrow(value: arb) -> bool:
    return bool(value.is_finite() and value.rad() < arb(10) ** -30)


@pytest.mark.parametrize("name", MECHANISMS)
def test_each_function_is_the_derivative_along_its_field(name: str) -> None:
    """By power series along the field: no derivative of an expression is used."""
    shifted = shift(MECHANISMS[name])
    f = shifted.functions
    with working_bits(200):
        for seed in range(3):
            point = random_point(shifted.mechanism, seed)
            for result, field, function, sign in with_x(f, RULES):
                (wanted,) = derivative_along(shifted, field, function, point)
                (found,) = values(shifted.expressions([getattr(f, result)], BALLS), point)
                assert narrow(found), result
                assert narrow(wanted), result
                assert found.overlaps(sign * wanted), (result, field)
            for field, function in with_x(f, ZERO_RULES):
                (zero,) = derivative_along(shifted, field, function, point)
                assert narrow(zero)
                assert zero.contains(0)


def derivative_along(shifted: Shifted, field: str, function: str, point: list[arb]) -> list[arb]:
    expressions = shifted.expressions([getattr(shifted.functions, function)], BALLS)
    return values(expressions, point, field_at(shifted, field, point))


def field_at(shifted: Shifted, field: str, point: list[arb]) -> list[arb]:
    return values(shifted.expressions(getattr(shifted.functions, field), BALLS), point)


@pytest.mark.parametrize("name", [name for name in MECHANISMS if name not in WITHOUT_MASSES])
def test_the_fields_solve_the_equations_of_motion(name: str) -> None:
    """M q'' = f, M G_T = dx/dq (or du/dq'), M G_N = dy/dq, gradients by power series; F holds q' and 1 for time."""
    shifted = shift(MECHANISMS[name])
    f, motion = shifted.functions, shifted.mechanism.motion
    assert f.mass_matrix
    n, m = len(f.mass_matrix), len(shifted.mechanism.state)
    with working_bits(200):
        point = random_point(shifted.mechanism, 7)
        matrix = [values(shifted.expressions(row, BALLS), point) for row in f.mass_matrix]
        forces = values(shifted.expressions(shifted.prepare(motion.forces), BALLS), point)  # type: ignore[union-attr]
        gradients = {}
        tangential = ("G_T", f.u, n) if f.x is None else ("G_T", f.x, 0)
        for letter, function, first in (tangential, ("G_N", f.y, 0)):
            (expression,) = shifted.expressions([function], BALLS)
            unit = [[arb(int(i == first + j)) for i in range(m)] for j in range(n)]
            gradients[letter] = [values([expression], point, direction)[0] for direction in unit]
        for letter, right in (("F", forces), *gradients.items()):
            field = field_at(shifted, letter, point)
            for row, wanted in zip(matrix, right, strict=True):
                left = sum((entry * part for entry, part in zip(row, field[n : 2 * n], strict=True)), arb(0))
                assert narrow(left)
                assert left.overlaps(wanted)
            fixed = [*point[n : 2 * n], *[1] * (m - 2 * n)] if letter == "F" else [0] * (m - n)
            assert all(part == value for part, value in zip([*field[:n], *field[2 * n :]], fixed, strict=True))


@pytest.mark.parametrize("name", [*SHIPPED, "driven"])
def test_against_the_sympy_route(name: str) -> None:
    mechanism = MECHANISMS[name]
    shifted, second = shift(mechanism), derive(mechanism)
    references = [sympy.Symbol(angle.name) for angle in mechanism.angles]
    with working_bits(200), mpmath.workdps(50):
        point = random_point(mechanism, 3)
        numbers = [mpmath.mpf(value.str(45, radius=False)) for value in point]
        extra = []
        for angle in mechanism.angles:
            reference = mpmath.mpf(angle_ball(angle).str(45, radius=False))
            numbers[mechanism.state.index(angle.coordinate)] += reference
            extra.append(reference)
        letters = ["u", "v", "a", "b", "A", "B", "C", "p", "alpha_1", "alpha_2", "alpha_3", "mu", "y"]
        for letter in letters + ["x"] * (second.x is not None):
            function: Any = sympy.lambdify([*mechanism.symbols, *references], getattr(second, letter), "mpmath")
            (found,) = values(shifted.expressions([getattr(shifted.functions, letter)], BALLS), point)
            assert narrow(found)
            assert abs(mpmath.mpf(found.str(45, radius=False)) - function(*numbers, *extra)) < mpmath.mpf(10) ** -35


def test_p_depends_on_no_velocity_and_b_on_no_higher_power() -> None:
    from gspot_verified.mechanisms.formulas.symbol import variable_indices

    f = shift(chain(3)).functions
    assert variable_indices([f.p, f.A, f.B, f.C, f.x, f.y]) <= set(range(5))


def test_a_chain_of_five_links_is_small() -> None:
    """Seven coordinates: the graph of everything stays far below what products written out would need."""
    f = shift(chain(5)).functions
    assert len(in_order([*f.F, *f.G, f.p, f.b, f.alpha_1, f.alpha_2, f.alpha_3])) < 2000


BLOCK: dict[str, Any] = {
    "name": "block", "coordinates": ["X", "Y"], "mass_matrix": [[1, 0], [0, 1]], "forces": [0, -1], "x": "X", "y": "Y",
    "mu": 1,
}  # fmt: skip


@pytest.mark.parametrize(
    ("change", "part"),
    [
        ({"mu": "1/2 + X_dot"}, r"must not depend on velocities: L_G p must vanish .*mu'\(u\) B \(mu A - B\)"),
        ({"mu": "1/(1 + X_dot^2)"}, "eq. lagrangian2"),
        ({"x": "X + Y_dot"}, "x and y must not depend on velocities"),
        ({"y": "Y*X_dot"}, "x and y must not depend on velocities"),
        ({"mass_matrix": [["1 + X_dot", 0], [0, 1]]}, "the mass matrix must not depend on velocities"),
        ({"mass_matrix": [[1, 1], [1, 1]]}, "the mass matrix is singular"),
        ({"mass_matrix": [["sin(X)^2", "sin(X)*cos(X)"], ["cos(X)*sin(X)", "cos(X)^2"]]}, "singular"),
    ],
)
def test_what_the_theory_does_not_allow(change: dict[str, Any], part: str) -> None:
    with pytest.raises(MechanismError, match=part):
        shift(lagrangian(**BLOCK | change))


@pytest.mark.parametrize("mu", ["1/2 + X_dot - X_dot", "X^2 + 1", "1 + Y*X"])
def test_friction_that_depends_on_the_place_is_allowed(mu: str) -> None:
    shift(lagrangian(**BLOCK | {"mu": mu}))


def test_friction_that_depends_on_the_slip_velocity_breaks_the_lagrangian_character() -> None:
    """The formula that the message states: A, B, C depend on the configuration alone, and L_G u = B - mu A."""
    A, B, C, u = sympy.symbols("A B C u")
    mu = sympy.Function("mu")(u)
    along_g = sympy.diff(C - mu * B, u) * (B - mu * A)
    assert sympy.expand(along_g - sympy.diff(mu, u) * B * (mu * A - B)) == 0
    # At p = 0: mu A - B = (A C - B^2)/B.
    assert sympy.simplify((mu * A - B - (A * C - B**2) / B).subs(C, mu * B)) == 0


def test_a_chain_of_five_links_is_classified() -> None:
    """Fourteen components of the state: the G-spot is found and proved; M has LDL^T of seven rows."""
    angles, rates = ("-1.73", "-2.91", "-2.33", "-1.69", "-1.51"), ("-1.07", "-1.08", "-1.13", "-0.16", "-0.85")
    place = {"X": 0, "Y": "3.9", "X_dot": 9, "Y_dot": "-2"}
    place |= {f"a{i + 1}": angle for i, angle in enumerate(angles)}
    place |= {f"a{i + 1}_dot": rate for i, rate in enumerate(rates)}
    fixed = ["X", "X_dot", *(f"a{i}" for i in range(1, 5)), *(f"a{i}_dot" for i in range(1, 5))]
    mechanism = chain(5, place=place, search=True, fixed=fixed).with_parameters(mu="8/5")
    spot = find_g_spot(mechanism)
    assert not spot.exact
    with working_bits(spot.bits):
        assert all(value.contains(0) and narrow(value) for value in spot.system.values_at_point(spot.system.conditions))
    found = classify_g_spot(spot)
    assert found.case == "none"
    assert "alpha_1 is not negative" in found.reason
    assert found.fixed == tuple(fixed)


def test_sympy_is_not_needed() -> None:
    """Neither by a shipped file nor by the chain: a proof by sympy is for fields that do not simplify."""
    script = (
        "import sys\n"
        "from gspot_verified.mechanisms.spots.classify import classify\n"
        "from gspot_verified.mechanisms.shipped import shipped_mechanism, shipped_names\n"
        "for name in shipped_names():\n"
        "    if shipped_mechanism(name).place.values: classify(shipped_mechanism(name))\n"
        "print('sympy' in sys.modules)"
    )
    run = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True)
    assert run.stdout.strip() == "False"


# A mechanism with a mass matrix, prepared: which of its functions may depend on velocities.


BODY: dict[str, Any] = {
    "name": "body", "coordinates": ["X", "Y", "Z"], "mass_matrix": [[2, "X", 0], ["X", 3, "Z"], [0, "Z", 5]],
    "forces": ["X_dot", "Y_dot*Z_dot", "t"], "x": "X*Y - t^2", "y": "Y - Z", "mu": "1 + X^2", "time": "t",
    "constraints": ["X - Z*t"],
}  # fmt: skip
"""The state is X, Y, Z, X_dot, Y_dot, Z_dot, t."""


def prepared(**change: Any) -> LagrangianInput:
    made = lagrangian(**BODY | change)
    assert isinstance(made.motion, Lagrangian)
    return lagrangian_input(made, made.motion, Preparation(made))


def test_every_function_is_in_its_place() -> None:
    found = prepared()
    X, Y, Z, t = (Variable(i) for i in (0, 1, 2, 6))
    assert (found.n, found.m) == (3, 7)
    assert found.glide == (Variable(3), Variable(4), Variable(5), ZERO, ZERO, ZERO, ONE)
    assert [list(row) for row in found.rows] == [
        simplified(*row) for row in ([ONE + ONE, X, ZERO], [X, ONE + ONE + ONE, Z], [ZERO, Z, sum([ONE] * 4, ONE)])
    ]
    assert [list(found.forces), list(found.constraints)] == [
        simplified(Variable(3), Variable(4) * Variable(5), t), simplified(X - Z * t)
    ]  # fmt: skip
    assert [found.x, found.y, found.mu] == simplified(X * Y - t * t, Y - Z, ONE + X * X)
    assert [found.u] == simplified(Variable(3) * Y + X * Variable(4) - t - t)


def test_a_slip_velocity_stands_for_x() -> None:
    found = prepared(x=None, slip_velocity="X*X_dot + 2*Z_dot - t")
    assert found.x is None
    X, t = Variable(0), Variable(6)
    assert [found.u] == simplified(X * Variable(3) + (ONE + ONE) * Variable(5) - t)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"x": "X + Y_dot"}, "body: x and y must not depend on velocities"),
        ({"y": "Y + Z_dot"}, "body: x and y must not depend on velocities"),
        ({"x": None, "slip_velocity": "X_dot", "y": "Y + X_dot"}, "body: x and y must not depend on velocities"),
        ({"x": None, "slip_velocity": "X_dot*Z_dot"}, "body: the slip velocity must be linear in the velocities"),
        ({"x": None, "slip_velocity": "Z_dot^2"}, "body: the slip velocity must be linear in the velocities"),
        ({"constraints": ["Z_dot"]}, "body: a constraint must not depend on velocities"),
        (
            {"mass_matrix": [[2, 0, 0], [0, 3, 0], [0, 0, "1 + Z_dot^2"]]},
            "body: the mass matrix must not depend on vel",
        ),
        (
            {"mass_matrix": [["1 + X_dot^2", 0, 0], [0, 3, 0], [0, 0, 1]]},
            "body: the mass matrix must not depend on vel",
        ),
        ({"mu": "1 + X_dot^2"}, "body: the friction coefficient must not depend on velocities: L_G p must vanish"),
    ],
)
def test_what_must_not_depend_on_velocities_is_refused(change: dict[str, Any], message: str) -> None:
    with pytest.raises(MechanismError, match=message):
        prepared(**change)


def test_time_and_positions_are_no_velocities() -> None:
    found = prepared(
        mu="1 + t^2 + Z^2", y="Y - t", constraints=["X - t^2"], mass_matrix=[[1, 0, 0], [0, "1 + t^2", 0], [0, 0, 1]]
    )
    assert found.m == 7
