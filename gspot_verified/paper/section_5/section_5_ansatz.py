"""Ledger of Section 5: the deviation from the distinguished trajectory at epsilon = 0, near the G-spot.

w is -t, and T is w^(r - 1) with the unknown exponent r > 0: every hatted variable is a coefficient times a power of w
times T. m is the derivative of alpha_1 at ξ* (a covector: m xi0, m G). The functions of ξ enter by their Taylor terms.
"""

from __future__ import annotations

from flint import fmpq_mpoly

from gspot_verified.paper.checks.entry import Builders, Entry, Section
from gspot_verified.paper.checks.identities import Algebra, Claim, Parts
from gspot_verified.paper.checks.leading_order import leading
from gspot_verified.paper.section_5.section_5_outer import PRINTED as OUTER

SECTION = Section("Section 5, outer system and matching")
ALGEBRA = Algebra(
    "w T r t beta alpha1 alpha2 alpha3 xi0 p0 b0 lambda0 m G F chi p b f1 f2 g1 g2 m2 a1 a2 c1 c2 e1 e2 q2 n0 n1 X L P"
)
_SYMBOLS = ALGEBRA.symbols
ANSATZ = {"xi": "xi0*w*T", "p": "p0*w^2*T", "b": "b0*w*T", "lambda": "lambda0*T"}
"""Lines 2003 to 2006."""
DISTINGUISHED = {"xi": "e1*w + e2*w^2", "p": "-alpha1*w + q2*w^2", "lambda": "n0 + n1*w"}
"""The distinguished trajectory at epsilon = 0: xi - xi*, p (0 at the G-spot, with the slope alpha1 in t), lambda_N."""
TAYLOR = {
    "F": "F + f1*xi + f2*xi^2", "G": "G + g1*xi + g2*xi^2", "alpha1": "alpha1 + m*xi + m2*xi^2",
    "alpha2": "alpha2 + a1*xi + a2*xi^2", "alpha3": "alpha3 + c1*xi + c2*xi^2",
}  # fmt: skip
"""The functions of xi - xi*; a term of degree j >= 3 in the deviation has the factor w^j T^j, of higher order too."""
PRINTED: dict[str, dict[str, str]] = {
    "5-ansatz": {
        "xi": "-r*xi0 - G*lambda0",
        "p": "-(r+1)*p0 - m*xi0",
        "b": "-r*b0 + alpha3*lambda0",
        "balance": "-b0 + alpha1*lambda0",
    },
    "5-ansatz-solution": {"r": "beta", "alpha3 xi0": "-G*b0", "alpha1 lambda0": "b0"},
    "5-ansatz-p0": {"alpha3 (r+1) p0": "0*b0"},
}  # fmt: skip
CORRECTED: dict[str, dict[str, str]] = {"5-ansatz-p0": {"alpha3 (r+1) p0": "m*G*b0"}}
_BETA = {"alpha3": ALGEBRA.read("beta*alpha1")}


def _claim(identifier: str) -> Claim:
    return Claim(ALGEBRA, PRINTED[identifier], CORRECTED.get(identifier, {}))


def slope(value: fmpq_mpoly) -> fmpq_mpoly:
    """w times the derivative in t: w goes to -w, and T = w^(r - 1) to -(r - 1) T."""
    return ALGEBRA.derivative(value, {"w": -_SYMBOLS["w"], "T": ALGEBRA.read("-(r-1)*T")})


def slow_equations() -> dict[str, tuple[fmpq_mpoly, int]]:
    """The four slow equations for the deviation, left minus right, and the power of w in front of T at leading order.

    The first three are multiplied by w.
    """
    hat = {name: ALGEBRA.read(text) for name, text in ANSATZ.items()}
    bar = {name: ALGEBRA.read(text) for name, text in DISTINGUISHED.items()}

    def of_state(name: str, state: fmpq_mpoly) -> fmpq_mpoly:
        text = TAYLOR[name].replace("xi", "X")
        return ALGEBRA.substitute(ALGEBRA.read(text), {"X": state})

    before, after = bar["xi"], bar["xi"] + hat["xi"]
    force_before, force_after = bar["lambda"], bar["lambda"] + hat["lambda"]

    def change(name: str) -> fmpq_mpoly:
        return of_state(name, after) - of_state(name, before)

    def change_with_force(name: str) -> fmpq_mpoly:
        return of_state(name, after) * force_after - of_state(name, before) * force_before

    w = _SYMBOLS["w"]
    p_force = (bar["p"] + hat["p"]) * force_after - bar["p"] * force_before
    return {
        "xi": (slope(hat["xi"]) - w * (change("F") + change_with_force("G")), 1),
        "p": (slope(hat["p"]) - w * change("alpha1"), 2),
        "b": (slope(hat["b"]) - w * (change("alpha2") - change_with_force("alpha3")), 1),
        "balance": (-(hat["b"] + p_force), 1),
    }


def _ansatz() -> Entry:
    this = _claim("5-ansatz")

    def general(parts: Parts) -> list[fmpq_mpoly]:
        found = []
        for name, (equation, power) in slow_equations().items():
            coefficient, rest = leading(ALGEBRA, equation, power)
            found += [coefficient - parts[name], *rest]
        return found

    def explicit(parts: Parts) -> list[fmpq_mpoly]:
        # Polynomials in t for r = 1, ..., 5 in the equations linearised at xi*; both sides have degree at most 4 in r.
        found, in_time, minus = [], {"t": ALGEBRA.constant(1)}, -_SYMBOLS["t"]
        for value in parts.values():
            found += [high for degree, high in ALGEBRA.coefficients(value, "r").items() if degree > 4]
        for r in range(1, 6):
            powers = {"xi0": r, "p0": r + 1, "b0": r, "lambda0": r - 1}
            xi, p, b, force = (_SYMBOLS[name] * minus**power for name, power in powers.items())
            equations = {
                "xi": (ALGEBRA.derivative(xi, in_time) - _SYMBOLS["G"] * force, r - 1),
                "p": (ALGEBRA.derivative(p, in_time) - _SYMBOLS["m"] * xi, r),
                "b": (ALGEBRA.derivative(b, in_time) + _SYMBOLS["alpha3"] * force, r - 1),
                "balance": (-(b + ALGEBRA.read("alpha1*t") * force), r),
            }
            for name, (value, power) in equations.items():
                found.append(value - ALGEBRA.substitute(parts[name], {"r": ALGEBRA.constant(r)}) * minus**power)
        return found

    return SECTION.settled(
        "5-ansatz",
        "lines 2013 to 2016",
        r"-r\xi_0-G^*\lambda_0,\ -(r+1)p_0-{\alpha_1}_\xi^*\xi_0,\ \ldots",
        "Where the functions of ξ and the distinguished trajectory at ε = 0 have Taylor terms at the G-spot, its p "
        "with the slope α_1*, for every exponent r > 0 the ansatz in powers of -t satisfies the slow equations at "
        "leading order exactly when its coefficients satisfy the four printed equations",
        this.check(
            "the ansatz in the slow equations with Taylor terms: what else there is has a higher order", general
        ),
        this.check("linearised at ξ*, in polynomials of t for r = 1, ..., 5; degree at most 4 in r", explicit),
    )


def _solution() -> Entry:
    this = _claim("5-ansatz-solution")
    alpha1, alpha3, b0 = (_SYMBOLS[name] for name in ("alpha1", "alpha3", "b0"))

    def equations(parts: Parts) -> list[fmpq_mpoly]:
        # Times alpha1 alpha3: X is alpha3 xi0 and L is alpha1 lambda0. The last two have a solution with b0 not 0 only
        # where their determinant is 0: it has the one zero r of the claim.
        lines = {name: ALGEBRA.read(text) for name, text in PRINTED["5-ansatz"].items()}
        images = {"xi0": alpha1 * parts["alpha3 xi0"], "lambda0": alpha3 * parts["alpha1 lambda0"]}
        images |= {"b0": alpha1 * alpha3 * b0}
        values = [ALGEBRA.substitute(lines[name], images) for name in ("xi", "b", "balance")]
        rows = [[lines[name].derivative(unknown) for unknown in ("b0", "lambda0")] for name in ("b", "balance")]
        determinant = ALGEBRA.substitute(ALGEBRA.determinant(rows), _BETA)
        only = determinant - alpha1 * (parts["r"] - _SYMBOLS["r"])
        return [only, *(ALGEBRA.substitute(ALGEBRA.substitute(v, {"r": parts["r"]}), _BETA) for v in values)]

    def slow_subsystem(parts: Parts) -> list[fmpq_mpoly]:
        # p xi' = -G b, p b' = alpha3 b, p lambda = -b for the deviation, with p = -alpha1 w; G, alpha3 at xi*.
        sides = {name: ALGEBRA.read(OUTER["5-slow-manifold"][name]) for name in ("xi", "b", "z")}
        in_b = {name: value.derivative("b") for name, value in sides.items()}
        hat = {name: ALGEBRA.read(text) for name, text in ANSATZ.items()}
        p = ALGEBRA.read("-alpha1*w")
        rate = _SYMBOLS["w"] * in_b["b"] * hat["b"] - p * slope(hat["b"])
        # d xi/d b is the quotient of the right sides, and both deviations are 0 at the G-spot.
        quotient = in_b["b"] * parts["alpha3 xi0"] - alpha3 * in_b["xi"] * b0
        # lambda = -z_o: p lambda0 T = -b.
        force = p * parts["alpha1 lambda0"] * _SYMBOLS["T"] + alpha1 * in_b["z"] * hat["b"]
        return [ALGEBRA.substitute(ALGEBRA.substitute(rate, {"r": parts["r"]}), _BETA), quotient, force]

    return SECTION.settled(
        "5-ansatz-solution",
        "lines 2019 to 2023, eq:outerb_gen",
        r"r=\beta,\quad \xi_0=-\frac{G^*}{\alpha_3^*}b_0,\quad \lambda_0=\frac{b_0}{\alpha_1^*}",
        "For α_1*, α_3* not 0, with b_0 not 0, the exponent of the ansatz is β, and ξ_0 = -G b_0/α_3, λ_0 = b_0/α_1, "
        "at the G-spot",
        this.check("put into the leading-order equations; their determinant has the zero r = β only", equations),
        this.check("the slow subsystem with λ_N = -b/p: p b' = α_3 b, dξ/db = -G/α_3", slow_subsystem),
    )


def _p0() -> Entry:
    this = _claim("5-ansatz-p0")

    def equation(parts: Parts) -> list[fmpq_mpoly]:
        # P = alpha3 (r + 1) p0 in alpha3 times the second equation, with alpha3 xi0 of the solution.
        line = ALGEBRA.read(PRINTED["5-ansatz"]["p"])
        state = ALGEBRA.read(PRINTED["5-ansatz-solution"]["alpha3 xi0"])
        by_p0 = line.derivative("p0") + _SYMBOLS["r"] + 1
        return [by_p0, -parts["alpha3 (r+1) p0"] + line.derivative("xi0") * state]

    def example(parts: Parts) -> list[fmpq_mpoly]:
        # p' = alpha1 + chi b, so m G = -chi alpha3, and the deviation of p has p' = chi b.
        value = ALGEBRA.substitute(
            parts["alpha3 (r+1) p0"], {"m": ALGEBRA.read("-chi*alpha3"), "G": ALGEBRA.constant(1)}
        )
        hat = {name: ALGEBRA.read(text) for name, text in ANSATZ.items()}
        rate = slope(hat["p"]) - _SYMBOLS["w"] * _SYMBOLS["chi"] * hat["b"]  # (-(r+1) p0 - chi b0) w^2 T
        coefficient, rest = leading(ALGEBRA, rate, 2)
        by_p0 = coefficient.derivative("p0")
        free = ALGEBRA.substitute(coefficient, {"p0": ALGEBRA.constant(0)})
        return [by_p0 + _SYMBOLS["r"] + 1, *rest, -value + _SYMBOLS["alpha3"] * free]

    return SECTION.settled(
        "5-ansatz-p0",
        "line 2022",
        r"p_0=0",
        "The leading term of the deviation of p, of order (-t)^(β+1), vanishes",
        this.check(
            "the second leading-order equation (line 2014) with ξ_0 = -G b_0/α_3",
            equation,
            fault="it gives (β + 1) α_3 p_0 = (α_1)_ξ G b_0, which is not 0 in general",
        ),
        this.check(
            "the extended example: eq. newex1 integrated",
            example,
            fault="its p_0 is -χ b_0/(β + 1), which is 0 only for χ = 0",
        ),
        corrected="p_0 = (α_1)_ξ G b_0/((β + 1) α_3) at ξ*; for b_0 not 0 it is 0 only when the derivative of α_1 "
        "along G vanishes there (in the extended example p_0 = -χ b_0/(β + 1))",
        note="p_0 enters at a higher order only: r, ξ_0, λ_0 hold.",
    )


ENTRIES: Builders = {"5-ansatz": _ansatz, "5-ansatz-solution": _solution, "5-ansatz-p0": _p0}
"""The ansatz and its solution, in the order of the paper."""
