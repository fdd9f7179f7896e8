"""The equations that a certificate's writer has, against the equations of motion solved by hand in rational numbers.

A polynomial in sin(q) and cos(q) does not know that their squares add to 1: any numbers may stand for them.
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import pytest
from flint import fmpq, fmpq_mat

from gspot_verified.functions.derivative import ZERO
from gspot_verified.functions.expressions import Constant, Product, Sum, Variable
from gspot_verified.mechanisms.load import load
from gspot_verified.scenes.certificates.polynomial_mechanism import (
    INVERSE,
    SLIDE,
    NotPolynomial,
    PolynomialMechanism,
    PolynomialPhase,
    V,
    Y,
    Z,
    expression,
    number_of,
)

BENT = """
format = 1
name = "bent"
[angles.th]
sine = "3/5"
cosine = "4/5"
[lagrangian]
coordinates = ["X", "th", "H"]
mass_matrix = [[2, "sin(th)/8", 0], ["sin(th)/8", "3/4", "cos(th)/8 + X/16"], [0, "cos(th)/8 + X/16", 1]]
forces = ["X^3*X_dot/3 - 15/8", "3/8*cos(th) - th_dot^2/7 - (th - th_ref)/11", "H*H_dot/9 - 5/4"]
[contact]
x = "X + 5/4*cos(th) + X*sin(th)/3"
y = "2*H - 5/4*sin(th) + X^2/2"
mu = "1/2"
"""
PLAIN = """
format = 1
name = "plain"
[lagrangian]
coordinates = ["X", "H"]
mass_matrix = [[2, 1], [1, 3]]
forces = ["-X", "-1 - H_dot"]
[contact]
x = "X"
y = "H"
mu = "1/3"
"""
EPSILON = fmpq(1, 7)
CONTACT = {"k_1": fmpq(3, 2), "k_2": fmpq(5, 3), "damping": fmpq(7, 4)}
SIDE = {"slip": -1, "reverse slip": 1}
# th - th_ref, sin(th), cos(th): of one another they know nothing
X, TURN, SINE, COSINE, X_DOT, TH_DOT = (fmpq(*each) for each in ((1, 3), (1, 5), (5, 13), (-12, 13), (2, 7), (-4, 3)))
HEIGHT, SPEED, SPRING = fmpq(1, 5), fmpq(-2, 3), fmpq(9, 11)


Rows = Mapping[str, fmpq_mat]


def of(text: str, folder: Path) -> PolynomialMechanism:
    (folder / "given.toml").write_text(text)
    return PolynomialMechanism(load(folder / "given.toml"))


def column(*entries: fmpq | int) -> fmpq_mat:
    return fmpq_mat(len(entries), 1, [fmpq(each) for each in entries])


def dot(left: fmpq_mat, right: fmpq_mat) -> fmpq:
    return (left.transpose() * right)[0, 0]


def motion(
    mass: fmpq_mat,
    turning: fmpq_mat,
    rows: Mapping[str, fmpq_mat],
    turned: Mapping[str, fmpq_mat],
    mu: fmpq,
    phase: str,
) -> dict[str, fmpq]:
    """What is asked for, from M, its rate, x' and y' as gradients with their rates, forces and velocities."""
    x, y, f, dots = (rows[name] for name in ("x", "y", "f", "dots"))
    normal = fmpq(0) if phase == "flight" else CONTACT["k_2"] * (SPRING - HEIGHT)
    inverse, det = mass.inv(), mass.det()
    A = dot(x, inverse * x)
    free = dot(x, inverse * (f + normal * y)) + dot(turned["x"], dots)  # u' without friction
    tangential = -free / A if phase == "stick" else SIDE.get(phase, 0) * mu * normal
    acceleration = inverse * (f + normal * y + tangential * x)
    det_rate = det * sum(((inverse * turning)[i, i] for i in range(mass.nrows())), fmpq(0))
    A_rate = 2 * dot(turned["x"], inverse * x) - dot(x, inverse * turning * inverse * x)
    return {
        "V": dot(y, acceleration) + dot(turned["y"], dots),
        "Z": (-CONTACT["k_1"] * SPRING - normal) / CONTACT["damping"],
        "inverse": -EPSILON * det_rate / det**2,
        "slide": -EPSILON * (det_rate * A + det * A_rate) / (A * det) ** 2,
        "A det": A * det, "det": det, "u": dot(x, dots),
        "forwards": det * (mu * A * normal - free), "backwards": det * (mu * A * normal + free),
    } | {f"acceleration {i}": acceleration[i, 0] for i in range(mass.nrows())}  # fmt: skip


def bent(phase: str) -> tuple[dict[str, fmpq], dict[str, fmpq]]:
    """States of the bent mechanism where y = epsilon^2 Y, v = epsilon V, and its motion there."""
    half, s, c = fmpq(1, 2), SINE, COSINE
    H = half * (EPSILON**2 * HEIGHT + fmpq(5, 4) * s - X**2 / 2)
    H_dot = half * (EPSILON * SPEED + fmpq(5, 4) * c * TH_DOT - X * X_DOT)
    low, low_rate = c / 8 + X / 16, -s * TH_DOT / 8 + X_DOT / 16
    mass = fmpq_mat(3, 3, [fmpq(each) for each in (2, s / 8, 0, s / 8, fmpq(3, 4), low, 0, low, 1)])
    side = c * TH_DOT / 8
    turning = fmpq_mat(3, 3, [fmpq(each) for each in (0, side, 0, side, 0, low_rate, 0, low_rate, 0)])
    pull = fmpq(3, 8) * c - TH_DOT**2 / 7 - TURN / 11
    rows = {
        "x": column(1 + s / 3, X * c / 3 - fmpq(5, 4) * s, 0),
        "y": column(X, -fmpq(5, 4) * c, 2),
        "f": column(X**3 * X_DOT / 3 - fmpq(15, 8), pull, H * H_dot / 9 - fmpq(5, 4)),
        "dots": column(X_DOT, TH_DOT, H_dot),
    }
    turned = {
        "x": column(c * TH_DOT / 3, X_DOT * c / 3 - X * s * TH_DOT / 3 - fmpq(5, 4) * c * TH_DOT, 0),
        "y": column(X_DOT, fmpq(5, 4) * s * TH_DOT, 0),
    }
    found = motion(mass, turning, rows, turned, fmpq(1, 2), phase)
    states = {
        "X": X, "X_dot": X_DOT, "(th-th_ref)": TURN, "th_dot": TH_DOT, "sin(th)": s, "cos(th)": c,
        Y: HEIGHT, V: SPEED, Z: SPRING, INVERSE: 1 / found["det"], SLIDE: 1 / found["A det"],
    }  # fmt: skip
    return states, found | {"H_dot": H_dot}


def at(mechanism: PolynomialMechanism, function: object, states: Mapping[str, fmpq]) -> fmpq:
    """The function where all that has no state is 0: a number that hangs on it would be wrong."""
    value: fmpq = function(*(states.get(name, fmpq(0)) for name in mechanism.names))  # type: ignore[operator]
    return value


@pytest.mark.parametrize("phase", ["slip", "stick", "reverse slip", "flight"])
def test_rates_and_events_are_those_of_the_equations_of_motion(tmp_path: Path, phase: str) -> None:
    m = of(BENT, tmp_path)
    states, expected = bent(phase)
    found = PolynomialPhase(m, phase, EPSILON, CONTACT, follows=True)
    rates = {name: at(m, rate, states) for name, rate in found.rates.items()}
    assert rates.pop(Y) == SPEED
    assert rates.pop(V) == expected["V"]
    assert rates.pop(Z) == expected["Z"]
    assert rates.pop(INVERSE) == expected["inverse"]
    assert rates.pop(SLIDE) == (expected["slide"] if phase == "stick" else 0)
    for i, (q, speed) in enumerate((("X", X_DOT), ("th", TH_DOT), ("H", expected["H_dot"]))):
        assert rates.pop(m.place[q]) == EPSILON * speed
        assert rates.pop(f"{q}_dot") == EPSILON * expected[f"acceleration {i}"]
        assert rates.pop(f"sin({q})") == EPSILON * speed * states.get(f"cos({q})", 0)
        assert rates.pop(f"cos({q})") == -EPSILON * speed * states.get(f"sin({q})", 0)
    assert not rates
    gap, u = SPRING - HEIGHT, expected["u"]
    events = {
        "slip": {"lift-off": gap, "stick": u},
        "stick": {"lift-off": gap, "slip forwards": expected["forwards"], "slip backwards": expected["backwards"]},
        "reverse slip": {"lift-off": gap, "stick": -u},
        "flight": {"touch-down": -gap},
    }
    assert {name: at(m, function, states) for name, function in found.functions.items()} == events[phase]
    assert at(m, found.slip, states) == u
    assert at(m, found.divisor, states) == (expected["A det"] if phase == "stick" else 0)


def test_what_y_replaces_stands_in_no_function(tmp_path: Path) -> None:
    m = of(BENT, tmp_path)
    for phase in ("slip", "stick", "reverse slip", "flight"):
        found = PolynomialPhase(m, phase, EPSILON, CONTACT, follows=True)
        used = [found.rates[name] for name in found.rates if name not in ("sin(H)", "cos(H)")]
        names = m.names_in([*used, *found.functions.values(), found.divisor, found.slip])
        assert {Y, V, Z} <= names or phase == "flight"
        assert not names & {"H", "H_dot", "sin(H)", "cos(H)"}
        assert (SLIDE in names) == (phase == "stick")


def test_without_slip_that_is_followed_it_has_no_event(tmp_path: Path) -> None:
    m = of(BENT, tmp_path)
    for phase in ("slip", "reverse slip"):
        assert set(PolynomialPhase(m, phase, EPSILON, CONTACT, follows=False).functions) == {"lift-off"}


@pytest.mark.parametrize("phase", ["slip", "stick", "reverse slip", "flight"])
def test_divisors_that_are_numbers_need_no_state(tmp_path: Path, phase: str) -> None:
    m = of(PLAIN, tmp_path)
    found = PolynomialPhase(m, phase, EPSILON, CONTACT, follows=True)
    dots = column(X_DOT, EPSILON * SPEED)
    rest = column(0, 0)
    rows = {"x": column(1, 0), "y": column(0, 1), "f": column(-X, -1 - EPSILON * SPEED), "dots": dots}
    mass = fmpq_mat(2, 2, [2, 1, 1, 3])
    expected = motion(mass, fmpq_mat(2, 2), rows, {"x": rest, "y": rest}, fmpq(1, 3), phase)
    states = {"X": X, "X_dot": X_DOT, Y: HEIGHT, V: SPEED, Z: SPRING}
    assert at(m, found.rates[V], states) == expected["V"] == expected["acceleration 1"]
    assert at(m, found.rates["X_dot"], states) == EPSILON * expected["acceleration 0"]
    assert at(m, found.rates[INVERSE], states) == at(m, found.rates[SLIDE], states) == 0
    assert found.divisor == 0
    if phase == "stick":
        assert expected["acceleration 0"] == 0
        assert at(m, found.functions["slip forwards"], states) == expected["forwards"]
        assert at(m, found.functions["slip backwards"], states) == expected["backwards"]


def test_the_determinant_and_the_cofactors_are_those_of_a_matrix_of_numbers(tmp_path: Path) -> None:
    m = of(PLAIN, tmp_path)
    entries = [[2, -1, 5, 3], [7, 1, -4, 2], [1, 3, 6, -2], [0, 8, 1, 1]]
    matrix = fmpq_mat(4, 4, [fmpq(each) for row in entries for each in row])
    m.mass = [[m.number(each) for each in row] for row in entries]
    assert number_of(m.determinant(m.mass)) == matrix.det()
    assert [number_of(minor) for minor in m.minors()] == [
        fmpq_mat(k, k, [fmpq(each) for row in entries[:k] for each in row[:k]]).det() for k in (1, 2, 3, 4)
    ]
    inverse = (matrix.transpose().inv() * matrix.det()).tolist()  # cofactors are those of the entries, not transposed
    assert [[number_of(each) for each in row] for row in m.cofactors()] == inverse


def test_what_the_certificate_says_of_the_mechanism(tmp_path: Path) -> None:
    given = of(BENT, tmp_path).given
    assert given["angles"] == {"th": ["3/5", "4/5"]}
    assert given["coordinates"] == ["X", "th", "H"]
    assert given["mu"] == "1/2"
    assert given["forces"] == [
        "1/3*X*X*X*X_dot + -15/8",
        "-1/11*(th-th_ref) + -1/7*th_dot*th_dot + 3/8*cos(th)",
        "1/9*H*H_dot + -5/4",
    ]
    assert given["mass_matrix"][0] == ["2", "1/8*sin(th)", "0"]
    assert given["x"] == "1/3*X*sin(th) + 1*X + 5/4*cos(th)"
    assert given["y"] == "1/2*X*X + -5/4*sin(th) + 2*H"


def test_an_expression_has_the_variables_that_are_asked_for(tmp_path: Path) -> None:
    m = of(PLAIN, tmp_path)
    x, h = m.of("X"), m.of("H")
    numbers = {m.names.index("X"): 5, m.names.index("H"): 2}
    a, b = Variable(5), Variable(2)
    assert expression(m.number(0), numbers) is ZERO
    assert expression(m.number(3), numbers) is Constant(fmpq(3))
    assert expression(x, numbers) is a
    assert expression(x**2 * h, numbers) is Product(Product(a, a), b)
    minus, double = Product(Constant(fmpq(-1)), a), Product(Product(Constant(fmpq(2)), a), b)
    assert expression(-x, numbers) is minus
    assert expression(2 * x * h - x, numbers) == Sum((double, minus))


def test_sines_of_an_angle_that_is_counted_from_its_reference(tmp_path: Path) -> None:
    """sin(th - th_ref) = cos(th_ref) sin(th) - sin(th_ref) cos(th)."""
    m = of(BENT.replace("3/8*cos(th) - th_dot^2/7", "sin(th - th_ref) + 2*cos(th - th_ref)"), tmp_path)
    sine, cosine = m.of("sin(th)"), m.of("cos(th)")
    four, three = m.number(fmpq(4, 5)), m.number(fmpq(3, 5))
    assert m.forces[1] == four * sine - three * cosine + 2 * (four * cosine + three * sine) - m.of("(th-th_ref)") / 11


@pytest.mark.parametrize(
    ("old", "new", "why"),
    [
        ('"X^3*X_dot/3 - 15/8"', '"sin(X_dot)"', "sine of more than one coordinate"),
        ('"X^3*X_dot/3 - 15/8"', '"sin(X + H)"', "sine of more than one coordinate"),
        ('"X^3*X_dot/3 - 15/8"', '"exp(X)"', "polynomials of sin.q. and cos.q., not exponential of"),
        ('"X^3*X_dot/3 - 15/8"', '"1/(2 + X)"', "not a division or a root"),
        ("(th - th_ref)/11", "th/11", "not a reference angle outside of a sine or cosine"),
        ('mu = "1/2"', 'mu = "1/2 + X"', "need a friction coefficient that is a number"),
    ],
)
def test_what_is_no_such_polynomial(tmp_path: Path, old: str, new: str, why: str) -> None:
    with pytest.raises(NotPolynomial, match=why):
        of(BENT.replace(old, new), tmp_path)


@pytest.mark.parametrize("y", ["X*H - 5/4*sin(th)", "2*H - 5/4*sin(th) + sin(H)/3 + cos(X)", "sin(th) - X^2"])
def test_y_has_to_be_a_multiple_of_a_coordinate_beside_the_others(tmp_path: Path, y: str) -> None:
    m = of(BENT.replace("2*H - 5/4*sin(th) + X^2/2", y), tmp_path)
    with pytest.raises(NotPolynomial, match="of which y is a multiple beside the others"):
        m.normal(EPSILON)


def test_a_coordinate_whose_cosine_is_in_y_is_not_replaced(tmp_path: Path) -> None:
    m = of(BENT.replace("2*H - 5/4*sin(th) + X^2/2", "X + cos(X) + 3*H"), tmp_path)
    assert set(m.normal(EPSILON)) == {"H", "H_dot"}


@pytest.mark.parametrize(
    ("name", "why"),
    [
        ("stribeck_rod", "need a friction coefficient that is a number"),
        ("ellipse", "need x, not a slip velocity"),
        ("rod_on_a_shaken_base", "without constraints and time"),
        ("double_pendulum", "more than one coordinate"),
        ("model_system", "with a mass matrix and forces"),
    ],
)
def test_mechanisms_without_certificates(name: str, why: str) -> None:
    with pytest.raises(NotPolynomial, match=why):
        PolynomialMechanism(load(name))


def test_constraints_have_no_certificate(tmp_path: Path) -> None:
    tied = PLAIN.replace("[contact]", 'constraints = ["Q - X/2"]\n[contact]').replace('["X", "H"]', '["X", "H", "Q"]')
    tied = tied.replace("[[2, 1], [1, 3]]", "[[2, 1, 0], [1, 3, 0], [0, 0, 1]]").replace(
        '"-1 - H_dot"', '"-1 - H_dot", 0'
    )
    with pytest.raises(NotPolynomial, match="without constraints and time"):
        of(tied, tmp_path)


def test_a_sine_of_a_coordinate_without_a_reference_is_its_state(tmp_path: Path) -> None:
    m = of(PLAIN.replace('"-X"', '"2*sin(X) - cos(X)/3"'), tmp_path)
    assert m.forces[0] == 2 * m.of("sin(X)") - m.of("cos(X)") / 3
