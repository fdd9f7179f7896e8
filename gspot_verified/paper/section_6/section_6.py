"""Ledger of Section 6 and Appendix B: every formula and value of the frictional impact oscillator.

The routes are in ``oscillator``; all are identities in the state, the parameters and the units.
"""

from __future__ import annotations

from functools import partial

from flint import fmpq, fmpq_mpoly

from gspot_verified.paper.checks.entry import Builders, Entry, Rung, Section
from gspot_verified.paper.checks.identities import Claim, Parts, in_latex
from gspot_verified.paper.numerics.oscillator_formulas import APPENDIX_B, PRINTED_NUMBERS, SECTION_6
from gspot_verified.paper.section_6 import oscillator
from gspot_verified.paper.section_6.oscillator import ALGEBRA, CORRECTED, PRINTED, along, at_g_spot, normal

SECTION = Section("Section 6 and Appendix B")
_SYMBOLS = ALGEBRA.symbols
_ZERO = ALGEBRA.constant(0)
_LATEX = {"v": "v", "p": "p", "b": "b", "alpha_1": r"\alpha_1", "alpha_2": r"\alpha_2", "alpha_3": r"\alpha_3"}
ENERGIES = {
    "potential": "m1*g*(psi + l*(1 - C)) + m2*g*psi + kphi*e^2/2 + kpsi*psi^2/2",
    "loss": "cphi*w^2/2 + cpsi*x^2/2",
}
"""Gravity and springs; half the power that the dampers take."""
FORCES = {"1": "-kphi*e - cphi*w", "2": "-kpsi*psi - cpsi*x - m2*g - m2*A2"}
"""Generalised forces of springs and dampers, with weight and inertia of m_2, which moves with ψ."""
CASE = {"beta": fmpq(7, 3), "kappa": fmpq(0)}
"""Line 2190."""


def _claim(identifier: str) -> Claim:
    return Claim(ALGEBRA, PRINTED[identifier], CORRECTED.get(identifier, {}))


_RATES = {"phi": _SYMBOLS["w"], "psi": _SYMBOLS["x"], "w": _SYMBOLS["A1"], "x": _SYMBOLS["A2"]}


def _gradient(value: fmpq_mpoly) -> tuple[fmpq_mpoly, fmpq_mpoly]:
    return along(value, {"phi": ALGEBRA.constant(1)}), value.derivative("psi")


def _left_sides(parts: Parts) -> list[fmpq_mpoly]:
    """M q'' - f, as printed."""
    return [parts[f"M{i}1"] * _SYMBOLS["A1"] + parts[f"M{i}2"] * _SYMBOLS["A2"] - parts[f"f{i}"] for i in ("1", "2")]


def _motion() -> Entry:
    this = _claim("6-motion")

    def lagrange(parts: Parts) -> list[fmpq_mpoly]:
        velocity = [along(parts[name], _RATES) for name in ("x", "y")]
        kinetic = (_SYMBOLS["m1"] * (velocity[0] ** 2 + velocity[1] ** 2) + ALGEBRA.read("m2*x^2")) / 2
        potential, loss = (ALGEBRA.read(ENERGIES[name]) for name in ("potential", "loss"))
        found = []
        for i, rate in enumerate("wx"):
            force = _gradient(kinetic - potential)[i] - loss.derivative(rate)
            found.append(along(kinetic.derivative(rate), _RATES) - force - _left_sides(parts)[i])
            found += [parts[f"QT{i + 1}"] - _gradient(parts["x"])[i], parts[f"QN{i + 1}"] - _gradient(parts["y"])[i]]
        return [normal(value) for value in found]

    def virtual_power(parts: Parts) -> list[fmpq_mpoly]:
        # m_1 is at the contact point: its inertia and weight, and the contact forces, have the power of its velocity.
        velocity = [along(parts[name], _RATES) for name in ("x", "y")]
        acceleration = [along(value, _RATES) for value in velocity]
        inertia = [_SYMBOLS["m1"] * acceleration[0], _SYMBOLS["m1"] * (acceleration[1] + _SYMBOLS["g"])]
        found = []
        for i, rate in enumerate("wx"):
            shares = [value.derivative(rate) for value in velocity]
            own = inertia[0] * shares[0] + inertia[1] * shares[1] - ALGEBRA.read(FORCES[str(i + 1)])
            found += [own - _left_sides(parts)[i], parts[f"QT{i + 1}"] - shares[0], parts[f"QN{i + 1}"] - shares[1]]
        return [normal(value) for value in found]

    return SECTION.settled(
        "6-motion",
        "lines 2117 to 2142",
        r"M(q)\ddot q=f(q,\dot q)+Q_N\lambda_N+Q_T\lambda_T",
        "With m_1 at the contact point, at the printed x(q), y(q), m_2 moving upwards with ψ, and a spring and a "
        "damper on φ and on ψ, the oscillator moves by the printed equation with the printed M, f, Q_N and Q_T",
        this.check("Lagrange's equations of the energies of masses, springs and dampers", lagrange),
        this.check("d'Alembert's principle: the power of inertia and forces", virtual_power),
    )


def _sign_of_g() -> Entry:
    this = _claim("6-sign-of-G")

    def equation_of_motion(parts: Parts) -> list[fmpq_mpoly]:
        # Q_N λ_N + Q_T λ_T with λ_T = -mu λ_N, λ_N = 1; M G is the printed bracket.
        return [ALGEBRA.read("QN - mu*QT") - parts["M G"]]

    def acceleration(parts: Parts) -> list[fmpq_mpoly]:
        # L_G v must be p of Appendix B.
        rows = [oscillator.tangential(name, str(parts["M G"])) for name in ("1", "2")]
        control = oscillator.solved((rows[0], rows[1]))
        v = ALGEBRA.read(PRINTED["B-v"]["formula"])
        slope = along(v, {"w": control[0], "x": control[1]})
        return [*oscillator.determinant_is_right(), normal(slope - ALGEBRA.read(PRINTED["B-p"]["formula"]))]

    return SECTION.settled(
        "6-sign-of-G",
        "lines 2145 to 2148",
        r"G=(0,0,M^{-1}(-Q_N+\mu Q_T))^T",
        "In positive slip the oscillator has G = (0, 0, M^-1(-Q_N + μ Q_T))",
        this.check(
            "the equation of motion with λ_T = -μ λ_N, λ_N = 1",
            equation_of_motion,
            fault="the force is Q_N - μ Q_T: both signs are the other ones",
        ),
        this.check(
            "L_G v is the printed p, as an identity",
            acceleration,
            fault="with the printed G it is not the p of Appendix B",
        ),
        corrected="G = (0, 0, M^(-1)(Q_N - μ Q_T)): λ_T = -μ λ_N",
    )


def _place() -> Entry:
    lie = oscillator.by_lie_derivatives()
    y = ALGEBRA.read(oscillator.MOTION["y"])
    derived = [at_g_spot(value) for value in (lie["p"], lie["b"], y, lie["v"])]
    printed = [at_g_spot(ALGEBRA.read(text)) for text in (*(PRINTED[f"B-{n}"]["formula"] for n in "pbv"), str(y))]
    consistent = oscillator.g_spot_is_consistent()

    def vanish(values: list[fmpq_mpoly]) -> bool:
        return all(value.is_zero() for value in (*values, *consistent))

    return SECTION.settled(
        "6-G-spot",
        "lines 2155 to 2174",
        r"\cos\phi^*=3/5,\ \sin\phi^*=4/5,\ \dot\phi^*=-\sqrt{g/l},\ \psi^*=-2l/5,\ \dot\psi^*=\tfrac45\sqrt{gl}",
        "With the printed m_2, μ, φ_0, k, c the printed point is a G-spot of positive slip for all β, κ, m_1, l, g",
        Rung.EXACT.check("p, b, v by Lie derivatives and y vanish there, all parameters as symbols", vanish(derived)),
        Rung.EXACT.check("p, b, v of Appendix B and y vanish there, all parameters as symbols", vanish(printed)),
        note="u* = -3/5 sqrt(g l): positive slip needs a belt that moves below that velocity. c_ψ < 0 for β > 18/7.",
    )


def _by_the_sign_of_g(name: str) -> str:
    """The condition of what changes its sign with G: p, α_1 and α_3."""
    return ", with the corrected sign of G (6-sign-of-G)" if name in ("p", "alpha_1", "alpha_3") else ""


def _value(name: str) -> Entry:
    lie, motion = oscillator.by_lie_derivatives(), oscillator.by_the_motion()
    this = _claim(f"6-{name}")
    lines, text = SECTION_6[name]
    appendix = ALGEBRA.read(PRINTED[f"B-{name}"]["formula"])

    def differs(value: fmpq_mpoly) -> list[fmpq_mpoly]:
        return [at_g_spot(value), *oscillator.g_spot_is_consistent(), *oscillator.determinant_is_right()]

    return SECTION.settled(
        f"6-{name}",
        f"line {lines}",
        f"{_LATEX[name]}^*={in_latex(text)}",
        f"The printed {name.replace('alpha', 'α')} is that of the oscillator at its G-spot, for all β, κ, m_1, l, g"
        f"{_by_the_sign_of_g(name)}",
        this.check(
            "Lie derivatives of y along F and G, with the inverse of M",
            lambda parts: differs(parts["value"] - lie[name]),
        ),
        this.check(
            "y''' under a constant force, from the differentiated equations of motion"
            if name != "alpha_1"
            else "the slope in φ of the factor of λ in y''",
            lambda parts: differs(parts["value"] - motion[name]),
        ),
        this.check("the formula of Appendix B at the G-spot", lambda parts: differs(parts["value"] - appendix)),
        note="In the units m_1 = l = g = 1 of the formula; checked with m_1^-1 sqrt(g/l), g sqrt(g/l).",
    )


def in_case_iii(alpha_1: fmpq, alpha_2: fmpq, alpha_3: fmpq) -> bool:
    """Sec. 1: alpha_2 < 0 and alpha_3 < alpha_1 < 0."""
    return alpha_2 < 0 and alpha_3 < alpha_1 < 0


def approached_with_finite_force(alpha_1: fmpq, alpha_2: fmpq, alpha_3: fmpq) -> bool:
    """The line b = alpha_2 p/(alpha_1 - alpha_3) attracts in p' = alpha_1 p, b' = alpha_2 p + alpha_3 b, from slip.

    Both eigenvalues are negative, the line is the weak direction, and -b/p on it is positive (p > 0, b < 0).
    """
    eigenvalues = (alpha_1, alpha_3)
    return max(eigenvalues) < 0 and max(eigenvalues) == alpha_1 != alpha_3 and alpha_2 / (alpha_3 - alpha_1) > 0


def _number(value: fmpq_mpoly) -> fmpq:
    """The value for the printed β and κ in the units m_1 = l = g = 1."""
    units = {name: ALGEBRA.constant(1) for name in ("m1", "I", "l", "J", "om", "g")}
    pair = {name: ALGEBRA.constant(number) for name, number in CASE.items()}
    found = ALGEBRA.substitute(at_g_spot(value), units | pair)
    return fmpq(0) if found.is_zero() else found.leading_coefficient()


def decimal(text: str) -> tuple[fmpq, fmpq]:
    """A printed decimal and half a unit of its last digit."""
    digits = len(text.partition(".")[2])
    return fmpq(int(text.replace(".", "")), 10**digits), fmpq(1, 2 * 10**digits)


def _decimals() -> Entry:
    lie = oscillator.by_lie_derivatives()
    printed = {name: _number(ALGEBRA.read(PRINTED[f"6-{name}"]["value"])) for name in SECTION_6}
    derived = {name: _number(lie[name]) for name in SECTION_6}

    def rounded(exact: dict[str, fmpq]) -> bool:
        pairs = {name: decimal(text) for name, text in PRINTED_NUMBERS.items()}
        return all(abs(exact[name] - value) <= half for name, (value, half) in pairs.items())

    return SECTION.settled(
        "6-decimals",
        "lines 2190 to 2191",
        r"\alpha_1^*=-0.4289,\ \alpha_2^*=-1.8764,\ \alpha_3^*=-1.0008",
        "For β = 7/3, κ = 0 the printed decimals are the α's, rounded, and the oscillator is in Case III"
        f"{_by_the_sign_of_g('alpha_1')}",
        Rung.EXACT.check(
            "the printed functions of β and κ, rounded; α_2 < 0 and α_3 < α_1 < 0",
            rounded(printed) and in_case_iii(*printed.values()),
        ),
        Rung.EXACT.check(
            "the Lie derivatives, rounded; the weak direction of eqs. Gspot1, Gspot2 attracts with a positive force",
            rounded(derived) and approached_with_finite_force(*derived.values()),
        ),
        note="; ".join(f"{name} = {value}" for name, value in derived.items()),
    )


def _formula(name: str) -> Entry:
    lie, motion = oscillator.by_lie_derivatives(), oscillator.by_the_motion()
    this = _claim(f"B-{name}")
    lines = APPENDIX_B[name][0]
    value = ALGEBRA.read(PRINTED[f"6-{name}"]["value"]) if name in SECTION_6 else _ZERO
    how = {
        "v": "Q_N q'",
        "p": "the factor of λ in y'', from the equations of motion with a constant force λ",
        "b": "y'' without force, from the equations of motion",
        "alpha_1": "the slope in φ of the factor of λ in y''",
    }
    return SECTION.settled(
        f"B-{name}",
        f"lines {lines}",
        rf"{_LATEX[name]}(\phi,\psi,\dot\phi,\dot\psi)=\ldots",
        f"The {name.replace('alpha', 'α')} of Appendix B is that of the oscillator, in every state and for all "
        f"parameters{_by_the_sign_of_g(name)}",
        this.check(
            "Lie derivatives of y along F and G, with the inverse of M",
            lambda parts: [normal(parts["formula"] - lie[name]), *oscillator.determinant_is_right()],
        ),
        this.check(
            how.get(name, "y''' under a constant force, from the differentiated equations of motion"),
            lambda parts: [normal(parts["formula"] - motion[name]), *oscillator.determinant_is_right()],
        ),
        this.check(
            "at the G-spot it takes the value of Sec. 6 (0 for v, p, b), with β and κ as symbols",
            lambda parts: [at_g_spot(parts["formula"] - value)],
            Rung.POINTS,
        ),
        note="line 2538 has a closing parenthesis too many after φ - φ_0" if name == "alpha_2" else "",
    )


ENTRIES: Builders = {
    "6-motion": _motion,
    "6-sign-of-G": _sign_of_g,
    "6-G-spot": _place,
    **{f"6-{name}": partial(_value, name) for name in SECTION_6},
    "6-decimals": _decimals,
    **{f"B-{name}": partial(_formula, name) for name in APPENDIX_B},
}
"""The entries in the order of the paper, Appendix B last."""
