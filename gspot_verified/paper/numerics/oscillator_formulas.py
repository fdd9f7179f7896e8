"""The paper's formulas for the frictional impact oscillator as printed, compared with the derived ones.

Sec. 6 (lines 2117 to 2190 of the paper's source) and Appendix B (lines 2505 to 2556). Each comparison is an identity
in all parameters, shown exactly: the numerator of the difference is reduced by sin^2 + cos^2 = 1 to 0.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache
from typing import Any, ClassVar

from flint import fmpq

from gspot_verified.mechanisms.derive.derived import Derived
from gspot_verified.mechanisms.derive.lie_derivatives import Reader, derive, vanishes_identically
from gspot_verified.mechanisms.formulas.in_sympy import sympy_formula
from gspot_verified.mechanisms.input.mechanism import Lagrangian, Mechanism
from gspot_verified.mechanisms.shipped import shipped_mechanism
from gspot_verified.mechanisms.symbolic import symbolic_system
from gspot_verified.numbers.verdict import NoTruthValue

_E = "(k_phi*(phi - phi_0) + c_phi*phi_dot)"
_P = "(k_psi*psi + c_psi*psi_dot)"
_D = "(m_2 + m_1*cos(phi)^2)"

APPENDIX_B = {
    "v": ("2505-2507", "psi_dot + l*sin(phi)*phi_dot"),
    "p": ("2508-2510", f"(m_1*cos(phi)^2 + m_2*sin(phi)*(sin(phi) - mu*cos(phi)))/(m_1*{_D})"),
    "b": (
        "2511-2516",
        f"(m_1*l*cos(phi)*(m_2*l*phi_dot^2 - cos(phi)*{_P}) - m_2*sin(phi)*{_E})/(m_1*l*{_D}) - g",
    ),
    "alpha_1": (
        "2517-2520",
        f"-m_2*(mu*(cos(phi)^2*(m_1 + 2*m_2) - m_2) - 2*m_2*sin(phi)*cos(phi))/(m_1*{_D}^2)*phi_dot",
    ),
    "alpha_2": (
        "2521-2543",
        f"1/(m_1^2*l^3*{_D}^2)*("
        f"m_1^2*{_D}*l^3*g*c_psi*cos(phi)^2"
        f" - m_1^2*{_D}*l^3*k_psi*cos(phi)^2*psi_dot"
        " + m_1^3*l^4*c_psi*cos(phi)^3*phi_dot^2"
        f" - m_1^2*l^2*c_psi*cos(phi)^2*sin(phi)*{_E}"
        f" + m_1^2*l^3*c_psi*cos(phi)^2*{_P}"
        f" - m_1*m_2*l*c_phi*sin(phi)^2*{_P}"
        " - m_1^2*m_2*l^2*c_phi*cos(phi)*sin(phi)^2*phi_dot^2"
        " - m_1^2*m_2^2*l^4*sin(phi)*phi_dot^3"
        f" + m_2*(m_1 + m_2)*c_phi*sin(phi)*{_E}"
        f" + 4*m_1^2*m_2*l^3*cos(phi)*sin(phi)*phi_dot*{_P}"
        f" - 3*m_1*m_2^2*l^2*cos(phi)*phi_dot*{_E}"
        " + 3*m_1^3*m_2*l^4*cos(phi)^2*sin(phi)*phi_dot^3"
        f" + m_1^2*m_2*l^2*cos(phi)^3*phi_dot*{_E}"
        f" - m_1*m_2*{_D}*l^2*k_phi*sin(phi)*phi_dot"
        f" - 4*m_1^2*m_2*l^2*cos(phi)*phi_dot*{_E})",
    ),
    "alpha_3": (
        "2544-2556",
        f"1/(m_1^2*l^2*{_D}^2)*("
        "m_1^2*l^2*c_psi*cos(phi)^3*(mu*sin(phi) + cos(phi))"
        " + 2*m_1^2*m_2*l^2*mu*cos(phi)^2*phi_dot"
        " + 2*m_1*m_2^2*l^2*cos(phi)*(mu*cos(phi) - sin(phi))*phi_dot"
        " - m_2*(m_1 + m_2)*c_phi*mu*cos(phi)*sin(phi)"
        " + m_2^2*c_phi*sin(phi)^2)",
    ),
}
"""Lines of the paper and the printed formula, by name. A closing parenthesis too many (line 2538) is left out."""

SECTION_6 = {
    "alpha_1": ("2177", "-175/408"),
    "alpha_2": ("2179", "(30625*beta^2 + 9450*beta*kappa - 61425*beta + 8262*kappa - 126765)/55080"),
    "alpha_3": ("2178", "-175*beta/408"),
}
"""The values at the G-spot in the units m_1 = l = g = 1."""

PRINTED_NUMBERS = {"alpha_1": "-0.4289", "alpha_2": "-1.8764", "alpha_3": "-1.0008"}
"""Lines 2190 and 2191: the values for beta = 7/3, kappa = 0."""


@dataclass(frozen=True, slots=True)
class Comparison(NoTruthValue):
    """One printed formula against the derived one."""

    ask: ClassVar[str] = ".holds says whether the printed formula holds"

    label: str
    lines: str
    printed: str
    holds: bool
    note: str = ""

    def __str__(self) -> str:
        return f"{self.label} (lines {self.lines}): {'holds' if self.holds else 'WRONG as printed'}" + (
            f"; {self.note}" if self.note else ""
        )


def printed_formula(name: str) -> Any:
    """The formula of Appendix B as a sympy function of the state and the parameters; phi_0 is phi_ref + offset.

    >>> printed_formula("v")
    l*phi_dot*sin(phi) + psi_dot
    """
    return _parse(APPENDIX_B[name][1])


def compare_appendix_b() -> tuple[Comparison, ...]:
    """v, p, b, alpha_1, alpha_2, alpha_3 of Appendix B, as identities in the state and in all parameters.

    >>> [row.label for row in compare_appendix_b() if not row.holds]
    []
    """
    derived = _derived()
    notes = {"alpha_2": "line 2538 has a closing parenthesis too many after phi - phi_0"}
    return tuple(
        Comparison(name, lines, text, vanishes_identically(printed_formula(name) - getattr(derived, name)),
                   notes.get(name, ""))
        for name, (lines, text) in APPENDIX_B.items()
    )  # fmt: skip


def compare_section_6() -> tuple[Comparison, ...]:
    """The data of Sec. 6: equations of motion, the sign of G, the G-spot and the alphas there, the printed decimals.

    >>> [row.label for row in compare_section_6() if not row.holds]
    ['G = M^-1(-Q_N + mu Q_T)']
    """
    checks: tuple[Callable[[], Comparison | tuple[Comparison, ...]], ...] = (
        compare_equations_of_motion, compare_sign_of_g, compare_g_spot, compare_values, compare_decimals,
    )  # fmt: skip
    found: list[Comparison] = []
    for check in checks:
        rows = check()
        found += [rows] if isinstance(rows, Comparison) else rows
    return tuple(found)


def compare_equations_of_motion() -> Comparison:
    """M and f against Lagrange's equations of the energies of the two masses, springs and dampers."""
    import sympy

    mechanism = _mechanism()
    motion = mechanism.motion
    assert isinstance(motion, Lagrangian)
    read = Reader(mechanism, substitute=False)
    q, rates = mechanism.symbols[:2], mechanism.symbols[2:]
    kinetic = _parse("m_1*((l*cos(phi)*phi_dot)^2 + (psi_dot + l*sin(phi)*phi_dot)^2)/2 + m_2*psi_dot^2/2")
    potential = _parse("m_1*g*(psi + l*(1 - cos(phi))) + m_2*g*psi + k_phi*(phi - phi_0)^2/2 + k_psi*psi^2/2")
    loss = _parse("c_phi*phi_dot^2/2 + c_psi*psi_dot^2/2")
    holds = True
    for i in range(2):
        momentum = sympy.diff(kinetic, rates[i])
        force = sympy.diff(kinetic - potential, q[i]) - sympy.diff(loss, rates[i])
        force -= sympy.Add(*(sympy.diff(momentum, q[j]) * rates[j] for j in range(2)))
        holds &= vanishes_identically(force - read(motion.forces[i]))
        for j in range(2):
            holds &= vanishes_identically(sympy.diff(momentum, rates[j]) - read(motion.mass_matrix[i][j]))
    return Comparison("M(q) and f(q, q')", "2117-2127", "M, f of Sec. 6", holds)


def compare_sign_of_g() -> Comparison:
    """The printed G = M^-1(-Q_N + mu Q_T) against eq. genx and the printed p: it has the wrong sign."""
    import sympy

    derived = _derived()
    printed_g = [-component for component in derived.G]  # M^-1(-Q_N + mu Q_T)
    along = sympy.Add(*(g * sympy.diff(derived.v, s) for g, s in zip(printed_g, _mechanism().symbols, strict=True)))
    printed_p = printed_formula("p")
    holds = vanishes_identically(along - printed_p)
    opposite = vanishes_identically(along + printed_p)
    note = "L_G v is minus the printed p; right is G = M^-1(Q_N - mu Q_T)" if opposite else ""
    return Comparison("G = M^-1(-Q_N + mu Q_T)", "2145-2148", "M^-1(-Q_N + mu Q_T)", holds, note)


def compare_g_spot() -> Comparison:
    """p = b = y = v = 0 at the printed point, for all beta and kappa (Symbols ring; also by substitution)."""
    system = symbolic_system(_family())
    return Comparison(
        "G-spot", "2155-2174", "mu, phi_0, phi*, psi*, phi_dot*, psi_dot*",
        all(value == 0 for value in system.values_at_point(system.conditions)), "for all beta and kappa",
    )  # fmt: skip


def compare_values() -> tuple[Comparison, ...]:
    """alpha_1*, alpha_2*, alpha_3* as functions of beta and kappa."""
    import sympy

    system = symbolic_system(_family())
    values = system.values_at_point((system.alpha_1, system.alpha_2, system.alpha_3))
    names = {name: sympy.Symbol(name) for name in ("beta", "kappa")}
    found = []
    for (name, (lines, text)), value in zip(SECTION_6.items(), values, strict=True):
        difference = sympy_formula(text, names) - sympy_formula(str(value), names)
        found.append(Comparison(f"{name}*", lines, text, bool(sympy.expand(difference) == 0)))
    return tuple(found)


def compare_decimals() -> tuple[Comparison, ...]:
    """The printed decimals for beta = 7/3, kappa = 0: right to the last digit when off by at most half a unit of it."""
    import sympy

    at = {sympy.Symbol("beta"): sympy.Rational(7, 3), sympy.Symbol("kappa"): sympy.Integer(0)}
    names = {str(symbol): symbol for symbol in at}
    found = []
    for name, text in PRINTED_NUMBERS.items():
        value = sympy_formula(SECTION_6[name][1], names).xreplace(at)
        error = abs(fmpq(int(value.p), int(value.q)) - fmpq(int(text.replace(".", "")), 10**4))
        found.append(Comparison(f"{name}* at beta = 7/3, kappa = 0", "2190-2191", text, error <= fmpq(1, 20000),
                                f"exactly {value}"))  # fmt: skip
    return tuple(found)


@lru_cache(maxsize=1)
def _mechanism() -> Mechanism:
    return shipped_mechanism("frictional impact oscillator, all parameters")


@lru_cache(maxsize=1)
def _derived() -> Derived[Any]:
    return derive(_mechanism(), substitute=False)


def _family() -> Mechanism:
    return shipped_mechanism("frictional impact oscillator", beta=None, kappa=None)


def _parse(text: str) -> Any:
    import sympy

    mechanism = _mechanism()
    names = {name: sympy.Symbol(name) for name in (*mechanism.state, *(name for name, _ in mechanism.parameters))}
    return sympy_formula(text, names | {"phi_0": sympy.Symbol("phi_ref") + sympy.Symbol("offset")})
