"""The frictional impact oscillator in exact polynomials: the printed formulas of Sec. 6 and Appendix B, and two routes.

S, C are sine and cosine of φ, w and x the rates of φ and ψ, e is φ - φ_0, om is sqrt(g/l); I, J, R are 1/m_1, 1/l and
1/(m_2 + m_1 cos² φ). Functions of the state are polynomials in these, modulo S² + C² = 1 and what I, J, R are.

- *Lie derivatives* of y along F and G, with the inverse of M (Sec. 2);
- *the motion* with a constant contact force λ: its equations, solved by Cramer's rule, and once differentiated, give
  the second and the third derivative of y: y'' = b + p λ, y''' = α_2 + (α_1 - α_3) λ.
"""

from __future__ import annotations

from collections.abc import Mapping

from flint import fmpq_mpoly

from gspot_verified.paper.checks.identities import Algebra
from gspot_verified.paper.numerics.oscillator_formulas import APPENDIX_B, SECTION_6

ALGEBRA = Algebra("S C w x psi e m1 m2 l g mu kphi cphi kpsi cpsi I J R A1 A2 J1 J2 lam beta kappa om QN QT")
_SYMBOLS = ALGEBRA.symbols
_ZERO, _ONE = ALGEBRA.constant(0), ALGEBRA.constant(1)
_DETERMINANT = "m2 + m1*C^2"
"""det M is m_1 l² times this."""
MOTION = {
    "M11": "m1*l^2", "M12": "m1*l*S", "M21": "m1*l*S", "M22": "m1 + m2",
    "f1": "-kphi*e - cphi*w - m1*g*l*S", "f2": "-kpsi*psi - cpsi*x - (m1 + m2)*g - m1*l*C*w^2",
    "QT1": "l*C", "QT2": "0*l", "QN1": "l*S", "QN2": "1+0*l",
    "x": "l*S", "y": "psi + l*(1 - C)",
}  # fmt: skip
"""Lines 2117 to 2142."""
PARAMETERS = {
    "m2": "m1", "mu": "25/12", "e": "-(49/20 - 7*beta/12 - 9*kappa/50)", "kphi": "m1*g*l", "cphi": "0*m1",
    "kpsi": "kappa*m1*g*J", "cpsi": "25*(18 - 7*beta)*m1*om/108",
}  # fmt: skip
"""Lines 2155 to 2161; e is φ* - φ_0."""
G_SPOT = {"C": "3/5", "S": "4/5", "w": "-om", "psi": "-2*l/5", "x": "4*l*om/5"}
"""Lines 2168 to 2174; sqrt(g l) is l om."""


def flint_text(text: str) -> str:
    """A formula of Appendix B, as it is kept for sympy, in the symbols of this page."""
    exchange = (
        ("(m_2 + m_1*cos(phi)^2)", "D"), ("sin(phi)", "S"), ("cos(phi)", "C"), ("phi_dot", "w"), ("psi_dot", "x"),
        ("(phi - phi_0)", "e"), ("m_1", "m1"), ("m_2", "m2"), ("k_phi", "kphi"), ("c_phi", "cphi"), ("k_psi", "kpsi"),
        ("c_psi", "cpsi"), ("1/(m1^2*l^3*D^2)", "I^2*J^3*R^2"), ("1/(m1^2*l^2*D^2)", "I^2*J^2*R^2"),
        ("/(m1*D^2)", "*I*R^2"), ("/(m1*l*D)", "*I*J*R"), ("/(m1*D)", "*I*R"), ("D", f"({_DETERMINANT})"),
    )  # fmt: skip
    for old, new in exchange:
        text = text.replace(old, new)
    return text


_UNITS = {"alpha_1": "om*I", "alpha_2": "l*om^3", "alpha_3": "om*I"}
PRINTED: dict[str, dict[str, str]] = {
    "6-motion": MOTION,
    "6-sign-of-G": {"M G": "-QN + mu*QT"},
    **{f"6-{name}": {"value": f"({text})*{_UNITS[name]}"} for name, (_, text) in SECTION_6.items()},
    **{f"B-{name}": {"formula": flint_text(text)} for name, (_, text) in APPENDIX_B.items()},
}
CORRECTED = {"6-sign-of-G": {"M G": "QN - mu*QT"}}


def normal(value: fmpq_mpoly) -> fmpq_mpoly:
    """The function times powers of m_1, l and m_2 + m_1 cos² φ, with S² = 1 - C²: 0 only for the function 0."""
    for inverse, text in (("R", _DETERMINANT), ("I", "m1"), ("J", "l")):
        powers = ALGEBRA.coefficients(value, inverse)
        highest, base = max(powers, default=0), ALGEBRA.read(text)
        value = sum((part * base ** (highest - power) for power, part in powers.items()), start=_ZERO)
    in_sine = ALGEBRA.coefficients(value, "S")
    square = ALGEBRA.read("1 - C^2")
    terms = (part * square ** (power // 2) * _SYMBOLS["S"] ** (power % 2) for power, part in in_sine.items())
    return sum(terms, start=_ZERO)


def along(value: fmpq_mpoly, rates: Mapping[str, fmpq_mpoly]) -> fmpq_mpoly:
    """The derivative of a function of the state for the given rates of phi, psi, w, x (and of A1, A2)."""
    phi = rates.get("phi", _ZERO)
    images = {"S": _SYMBOLS["C"] * phi, "C": -_SYMBOLS["S"] * phi, "e": phi, "R": ALGEBRA.read("2*m1*C*S*R^2") * phi}
    return ALGEBRA.derivative(value, images | {name: rate for name, rate in rates.items() if name != "phi"})


def parts_of_motion() -> dict[str, fmpq_mpoly]:
    """M, f, Q_T, Q_N, x, y as printed."""
    return {name: ALGEBRA.read(text) for name, text in MOTION.items()}


def solved(right: tuple[fmpq_mpoly, fmpq_mpoly]) -> tuple[fmpq_mpoly, fmpq_mpoly]:
    """The solution of M a = right, by Cramer's rule; 1/det M is I J² R for the printed M."""
    m = parts_of_motion()
    inverse = ALGEBRA.read("I*J^2*R")
    return (m["M22"] * right[0] - m["M12"] * right[1]) * inverse, (m["M11"] * right[1] - m["M21"] * right[0]) * inverse


def determinant_is_right() -> list[fmpq_mpoly]:
    """Zero when I J² R is 1/det M."""
    m = parts_of_motion()
    return [normal((m["M11"] * m["M22"] - m["M12"] * m["M21"]) * ALGEBRA.read("I*J^2*R") - 1)]


def tangential(name: str, right: str = CORRECTED["6-sign-of-G"]["M G"]) -> fmpq_mpoly:
    """Row ``name`` (1 or 2) of the generalised force in positive slip for λ_N = 1."""
    m = parts_of_motion()
    return ALGEBRA.substitute(ALGEBRA.read(right), {"QN": m[f"QN{name}"], "QT": m[f"QT{name}"]})


def by_lie_derivatives() -> dict[str, fmpq_mpoly]:
    """v, p, b, alpha_1, alpha_2, alpha_3 by Sec. 2."""
    m = parts_of_motion()
    drift, control = solved((m["f1"], m["f2"])), solved((tangential("1"), tangential("2")))
    F = {"phi": _SYMBOLS["w"], "psi": _SYMBOLS["x"], "w": drift[0], "x": drift[1]}
    G = {"w": control[0], "x": control[1]}
    v = along(m["y"], F)
    p, b = along(v, G), along(v, F)
    return {"v": v, "p": p, "b": b, "alpha_1": along(p, F), "alpha_2": along(b, F), "alpha_3": -along(b, G)}


def by_the_motion() -> dict[str, fmpq_mpoly]:
    """The same functions from the second and the third derivative of y under a constant force."""
    m, lam = parts_of_motion(), _SYMBOLS["lam"]
    force = [m[f"f{i}"] + tangential(str(i)) * lam for i in (1, 2)]
    a = solved((force[0], force[1]))
    rates = {"phi": _SYMBOLS["w"], "psi": _SYMBOLS["x"], "w": _SYMBOLS["A1"], "x": _SYMBOLS["A2"]}
    # M a = f + Q λ, once differentiated: M a' = (f + Q λ)' - M' a.
    later = [
        along(force[i], rates)
        - along(m[f"M{i + 1}1"], rates) * _SYMBOLS["A1"]
        - along(m[f"M{i + 1}2"], rates) * _SYMBOLS["A2"]
        for i in (0, 1)
    ]
    jerk = solved((later[0], later[1]))
    second = along(along(m["y"], rates), rates)
    third = along(second, rates | {"A1": _SYMBOLS["J1"], "A2": _SYMBOLS["J2"]})
    third = ALGEBRA.substitute(third, {"J1": jerk[0], "J2": jerk[1]})
    second, third = (ALGEBRA.substitute(value, {"A1": a[0], "A2": a[1]}) for value in (second, third))
    p = ALGEBRA.coefficient_of(second, "lam", 1)
    slope = along(p, {"phi": _SYMBOLS["w"]})  # p depends on φ only
    return {
        "v": m["QN1"] * _SYMBOLS["w"] + m["QN2"] * _SYMBOLS["x"],
        "p": p,
        "b": ALGEBRA.coefficient_of(second, "lam", 0),
        "alpha_1": slope,
        "alpha_2": ALGEBRA.coefficient_of(third, "lam", 0),
        "alpha_3": slope - ALGEBRA.coefficient_of(third, "lam", 1),
    }


def at_g_spot(value: fmpq_mpoly) -> fmpq_mpoly:
    """The value at the printed G-spot with the printed parameters: a polynomial in beta, kappa, m_1, 1/m_1, l, om."""
    first = {name: ALGEBRA.read(text) for name, text in (PARAMETERS | G_SPOT).items()}
    value = ALGEBRA.substitute(value, first)
    value = ALGEBRA.substitute(value, {"g": ALGEBRA.read("l*om^2"), "R": ALGEBRA.read("25/34*I")})
    return without_quotients(value)


def g_spot_is_consistent() -> list[fmpq_mpoly]:
    """Zero when the printed sine and cosine have S² + C² = 1, and 25/(34 m_1) is 1/(m_2 + m_1 cos² φ) there."""
    circle = at_g_spot(ALGEBRA.read("S^2 + C^2 - 1"))
    return [circle, at_g_spot(ALGEBRA.read(f"R*({_DETERMINANT}) - 1"))]


def without_quotients(value: fmpq_mpoly) -> fmpq_mpoly:
    """m_1 I = 1 and l J = 1 used in every term."""
    for inverse, name in (("I", "m1"), ("J", "l")):
        found = _ZERO
        for power, part in ALGEBRA.coefficients(value, inverse).items():
            for other, rest in ALGEBRA.coefficients(part, name).items():
                common = min(power, other)
                found += rest * _SYMBOLS[inverse] ** (power - common) * _SYMBOLS[name] ** (other - common)
        value = found
    return value
