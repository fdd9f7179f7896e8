"""The paper's formulas for the frictional impact oscillator as printed.

Sec. 6 (lines 2117 to 2190 of the paper's source) and Appendix B (lines 2505 to 2556). The ledger's entries on Section 6
compare them with derived ones.
"""

from __future__ import annotations

from typing import Any

from gspot_verified.mechanisms.formulas.in_sympy import sympy_formula
from gspot_verified.mechanisms.shipped import shipped_mechanism

_E = "(k_phi*(phi - phi_0) + c_phi*phi_dot)"
_P = "(k_psi*psi + c_psi*psi_dot)"
_D = "(m_2 + m_1*cos(phi)^2)"

APPENDIX_B = {
    "v": ("2505-2507", "psi_dot + l*sin(phi)*phi_dot"),
    "p": ("2508-2510", f"(m_1*cos(phi)^2 + m_2*sin(phi)*(sin(phi) - mu*cos(phi)))/(m_1*{_D})"),
    "b": ("2511-2516", f"(m_1*l*cos(phi)*(m_2*l*phi_dot^2 - cos(phi)*{_P}) - m_2*sin(phi)*{_E})/(m_1*l*{_D}) - g"),
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


def printed_formula(name: str) -> Any:
    """The formula of Appendix B as a sympy function of the state and the parameters; phi_0 is phi_ref + offset.

    >>> printed_formula("v")
    l*phi_dot*sin(phi) + psi_dot
    """
    import sympy

    mechanism = shipped_mechanism("frictional impact oscillator, all parameters")
    names = {name: sympy.Symbol(name) for name in (*mechanism.state, *(name for name, _ in mechanism.parameters))}
    return sympy_formula(APPENDIX_B[name][1], names | {"phi_0": sympy.Symbol("phi_ref") + sympy.Symbol("offset")})
