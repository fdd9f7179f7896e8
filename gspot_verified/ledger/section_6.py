"""Ledger of Section 6 and Appendix B: every formula and value of the frictional impact oscillator."""

from __future__ import annotations

from typing import Any

from flint import fmpq

from gspot_verified.ledger.entry import Check, Entry, Rung, settled
from gspot_verified.mechanisms.oscillator_formulas import (
    APPENDIX_B,
    SECTION_6,
    Comparison,
    compare_appendix_b,
    compare_decimals,
    compare_equations_of_motion,
    compare_g_spot,
    compare_sign_of_g,
    compare_values,
    printed_formula,
)
from gspot_verified.mechanisms.shipped import shipped_system

SECTION = "Section 6 and Appendix B"

_PAIRS = ((fmpq(7, 3), fmpq(0)), (fmpq(1, 2), fmpq(20)), (fmpq(5, 2), fmpq(-3, 2)))
_LATEX = {"v": "v", "p": "p", "b": "b", "alpha_1": r"\alpha_1", "alpha_2": r"\alpha_2", "alpha_3": r"\alpha_3"}


def entries() -> list[Entry]:
    """The entries in the order of the paper, Appendix B last."""
    return [
        _motion(),
        _sign_of_g(),
        _place(),
        *(_value(row) for row in compare_values()),
        _decimals(),
        *(_formula(row) for row in compare_appendix_b()),
    ]


def _motion() -> Entry:
    row = compare_equations_of_motion()
    return settled(
        SECTION,
        "6-motion",
        f"lines {row.lines}",
        r"M(q)\ddot q=f(q,\dot q)+Q_N\lambda_N+Q_T\lambda_T",
        "M and f of the oscillator",
        Check(
            Rung.EXACT, "Lagrange's equations of the energies of masses, springs and dampers, as identities", row.holds
        ),
        Check(Rung.EXACT, "p and b of Appendix B follow from them, as identities", _holds("p", "b")),
    )


def _sign_of_g() -> Entry:
    row = compare_sign_of_g()
    system = shipped_system("oscillator")
    first, second = system.values_at_point(system.G[2:])
    # The second row of M at the G-spot is (sin φ*, 2); the second components of Q_N and Q_T are 1 and 0.
    force = first * fmpq(4, 5) + second * 2
    return settled(
        SECTION,
        "6-sign-of-G",
        f"lines {row.lines}",
        r"G=(0,0,M^{-1}(-Q_N+\mu Q_T))^T",
        "G of the oscillator in positive slip",
        Check(Rung.EXACT, "with it L_G v is the printed p, as an identity", row.holds, row.note),
        Check(
            Rung.EXACT,
            "the equation of motion with λ_T = -μ λ_N: second row of M G at the G-spot",
            force == -1,
            f"it is {force}, as in Q_N - μ Q_T; the printed G gives -1",
        ),
        corrected="G = (0, 0, M^-1(Q_N - μ Q_T)): λ_T = -μ λ_N",
    )


def _place() -> Entry:
    row = compare_g_spot()
    systems = [shipped_system("oscillator", beta=beta, kappa=kappa) for beta, kappa in _PAIRS]
    vanish = all(value == 0 for s in systems for value in s.values_at_point((s.p, s.b, s.y, s.v)))
    return settled(
        SECTION,
        "6-G-spot",
        f"lines {row.lines}",
        r"\cos\phi^*=3/5,\ \sin\phi^*=4/5,\ \dot\phi^*=-\sqrt{g/l},\ \psi^*=-2l/5,\ \dot\psi^*=\tfrac45\sqrt{gl}",
        "With the printed μ, φ_0, k, c the printed point is a G-spot for all β and κ",
        Check(Rung.EXACT, "p, b, y, v vanish there with β and κ as symbols", row.holds),
        Check(Rung.POINTS, "p, b, y, v vanish there in exact rationals for three pairs (β, κ)", vanish),
        note="u* = -3/5 sqrt(g l): positive slip needs a belt that moves below that velocity. c_ψ < 0 for β > 18/7.",
    )


def _value(row: Comparison) -> Entry:
    name = row.label.rstrip("*")
    agrees = all(_printed_value(name, beta, kappa) == _found_value(name, beta, kappa) for beta, kappa in _PAIRS)
    return settled(
        SECTION,
        f"6-{name}",
        f"line {row.lines}",
        f"{_LATEX[name]}^*={row.printed}",
        f"{name} at the G-spot, in the units m_1 = l = g = 1, for all β and κ",
        Check(Rung.EXACT, "Lie derivatives at the G-spot with β and κ as symbols", row.holds),
        Check(Rung.POINTS, "exact rational values for three pairs (β, κ)", agrees),
    )


def _printed_value(name: str, beta: fmpq, kappa: fmpq) -> fmpq:
    return _rational(_parsed(SECTION_6[name][1], {"beta": beta, "kappa": kappa}))


def _found_value(name: str, beta: fmpq, kappa: fmpq) -> Any:
    system = shipped_system("oscillator", beta=beta, kappa=kappa)
    return system.values_at_point([getattr(system, name)])[0]


def _decimals() -> Entry:
    rows = compare_decimals()
    exact = [_found_value(name, fmpq(7, 3), fmpq(0)) for name in SECTION_6]
    printed = (fmpq(-4289, 10000), fmpq(-18764, 10000), fmpq(-10008, 10000))
    near = all(abs(value - decimal) <= fmpq(1, 20000) for value, decimal in zip(exact, printed, strict=True))
    return settled(
        SECTION,
        "6-decimals",
        f"lines {rows[0].lines}",
        r"\alpha_1^*=-0.4289,\ \alpha_2^*=-1.8764,\ \alpha_3^*=-1.0008",
        "The alphas for β = 7/3, κ = 0: Case III",
        Check(Rung.EXACT, "the printed functions of β and κ, rounded", all(row.holds for row in rows)),
        Check(Rung.EXACT, "the values at the G-spot from the equations of motion, rounded", near),
        note="; ".join(f"{name} = {value}" for name, value in zip(SECTION_6, exact, strict=True)),
    )


def _formula(row: Comparison) -> Entry:
    name = row.label
    checks = [_at_g_spot(name, beta, kappa) for beta, kappa in _PAIRS]
    return settled(
        SECTION,
        f"B-{name}",
        f"lines {row.lines}",
        rf"{_LATEX[name]}(\phi,\psi,\dot\phi,\dot\psi)=\ldots",
        f"{name} of Appendix B",
        Check(
            Rung.EXACT, "Lie derivatives from M, f, Q_N, Q_T: an identity in the state and all parameters", row.holds
        ),
        Check(
            Rung.POINTS, "at the G-spot it takes the values of Sec. 6 (0 for v, p, b), three pairs (β, κ)", all(checks)
        ),
        note=row.note,
    )


def _at_g_spot(name: str, beta: fmpq, kappa: fmpq) -> bool:
    """The printed formula of Appendix B at the printed G-spot against the printed value of Sec. 6."""
    import sympy

    values = {
        "m_1": 1, "m_2": 1, "l": 1, "g": 1, "mu": "25/12", "k_phi": 1, "c_phi": 0, "k_psi": "kappa",
        "c_psi": "25*(18 - 7*beta)/108", "psi": "-2/5", "phi_dot": -1, "psi_dot": "4/5",
    }  # fmt: skip
    pair = {"beta": beta, "kappa": kappa}
    offset = _parsed("49/20 - 7*beta/12 - 9*kappa/50", pair)
    place = {sympy.Symbol(key): _parsed(str(value), pair) for key, value in values.items()}
    formula = printed_formula(name)
    phi = sympy.Symbol("phi")
    formula = formula.subs({sympy.sin(phi): sympy.Rational(4, 5), sympy.cos(phi): sympy.Rational(3, 5)})
    # phi - phi_0 = phi* - (phi* + offset)
    formula = formula.subs(phi, sympy.Symbol("phi_ref")).subs(sympy.Symbol("offset"), offset).subs(place)
    found = sympy.nsimplify(sympy.expand(formula))
    if not found.is_Rational:
        return False
    wanted = _printed_value(name, beta, kappa) if name in SECTION_6 else fmpq(0)
    return bool(_rational(found) == wanted)


def _parsed(text: str, values: dict[str, fmpq]) -> Any:
    import sympy

    from gspot_verified.mechanisms.formula import parse_formula

    return parse_formula(text, {name: sympy.Rational(int(v.p), int(v.q)) for name, v in values.items()})


def _rational(value: Any) -> fmpq:
    return fmpq(int(value.p), int(value.q))


def _holds(*names: str) -> bool:
    return all(row.holds for row in compare_appendix_b() if row.label in names) and set(names) <= set(APPENDIX_B)
