"""Ledger of Section 5: the inner scale of a general system and the steps of Theorem 1's recursion.

b, y, v, z, l, r, w, q with a number are b_n, y_n, v_n, z_n, lambda_n, r_{b,n}, r_{v,n}, z_{n-1} and derivatives in s.
"""

from __future__ import annotations

from math import comb, factorial

from flint import fmpq, fmpq_mpoly

from gspot_verified.ledger.entry import Entry, settled
from gspot_verified.ledger.extended_system import extended_terms
from gspot_verified.ledger.identities import Algebra, Claim, Parts

SECTION = "Section 5, Theorem 1"
ALGEBRA = Algebra(
    "alpha1 alpha3 delta eps s k chi u0 u2 u3 b0 b1 b2 b3 r0 r1 r2 w0 q0 q1 q2 q3 l0 l1 l2 y0 y1 y2 y3 v0 v1 z0 z1 "
    "F0 F1 F2 F3 F4 G0 G1 G2 G3 G4 A0 A1 A2 A3 B3 P1 P2 P3 L0 L1 L2 L3 L4 "
    "xi1 f g lam a1 a2 a3 p p1 b y v z pd bd yd vd zd xd"
)
_SYMBOLS = ALGEBRA.symbols
PRINTED: dict[str, dict[str, str]] = {
    "5-inner-system": {
        "specialX": "xi1 - (f + g*lam)", "specialPP": "p1 - a1", "specialB": "b1 - (a2 - a3*lam)",
        "specialY": "y1 - v0", "specialV": "v1 - (b0 + p*lam)",
        "specialZ": "delta*z1 + z0 + lam", "specialL": "lam - (z0 - y0)",
    },
    "5-orders": {"r_b": "B3 - (A3*L0 + A2*L1 + A1*L2)", "r_v": "P3*L0 + P2*L1 + P1*L2", "p_0": "alpha1*s"},
    "5-third-order": {
        "specialYnbis": "alpha3*y2 - alpha3*b0 + alpha1*s*b1 - (alpha1*s*r0 + alpha3*w0)",
        "line 1667": "alpha3*y0 - 2*b1 - (-alpha3*q1 - 2*r0)",
        "third-order_b": "2*b3 + alpha1*s*b1 - alpha3*b0 - (2*r2 + alpha3*q3 + alpha1*s*r0 + alpha3*w0)",
    },
    "5-monomial": {"image": "(k*alpha1 - alpha3)*u3 + k*(k-1)*(k-2)*u0"},
    "5-step-3": {
        "y": "2*(b1-r0) - alpha3*q1", "v": "2*(b2-r1) - alpha3*q2", "lambda": "r0 - b1", "z": "b1 - r0 - alpha3*q1",
    },
    "5-xinprime": {"sum": "F4 + (G4+G3+G2+G1+G0)*L4"},
}  # fmt: skip
CORRECTED: dict[str, dict[str, str]] = {
    "5-monomial": {"image": "(k*alpha1 - alpha3)*u3 + 2*k*(k-1)*(k-2)*u0"},
    "5-xinprime": {"sum": "F4 + G4*L0 + G3*L1 + G2*L2 + G1*L3 + G0*L4"},
}


def entries() -> list[Entry]:
    """The inner scale and the recursion, in the order of the paper."""
    return [_inner_system(), _orders(), _third_order(), _monomial(), _step_3(), _xinprime()]


def _claim(identifier: str) -> Claim:
    return Claim(ALGEBRA, PRINTED[identifier], CORRECTED.get(identifier, {}))


def _d(value: fmpq_mpoly, times: int = 1) -> fmpq_mpoly:
    return ALGEBRA.derivative(value, ALGEBRA.jets("s", "b", "r", "q", "l", "y", "v", "z"), times)


def _inner_system() -> Entry:
    this = _claim("5-inner-system")
    # genSysXi to genSysLN, and the power of delta that each has more than its scaled form.
    general = {
        "specialX": ("xd - (f + g*lam)", 0),
        "specialPP": ("pd - a1", 0),
        "specialB": ("bd - (a2 - a3*lam)", 0),
        "specialY": ("yd - v", 4),
        "specialV": ("vd - (b + p*lam)", 2),
        "specialZ": ("eps*zd + z + eps^2*lam", 6),
        "specialL": ("eps^2*lam - (z - y)", 6),
    }
    texts = {
        "eps": "delta^3", "xd": "xi1", "pd": "p1", "bd": "b1", "yd": "delta^4*y1", "vd": "delta^2*v1",
        "zd": "delta^4*z1", "p": "delta^2*p", "b": "delta^2*b0", "y": "delta^6*y0",
        "v": "delta^4*v0", "z": "delta^6*z0",
    }  # fmt: skip
    images = {name: ALGEBRA.read(text) for name, text in texts.items()}

    def chain_rule(parts: Parts) -> list[fmpq_mpoly]:
        return [
            ALGEBRA.substitute(ALGEBRA.read(text), images) - _SYMBOLS["delta"] ** power * parts[name]
            for name, (text, power) in general.items()
        ]

    def back(parts: Parts) -> list[fmpq_mpoly]:
        # Solve the printed forms for the derivatives in s; d/dt is delta^(-2) d/ds of the unscaled variables.
        delta = _SYMBOLS["delta"]
        labels = {"xi": "X", "p": "PP", "b": "B", "y": "Y", "v": "V", "z": "Z"}
        solved = {
            name: -ALGEBRA.substitute(parts[f"special{label}"], {f"{name}1": ALGEBRA.constant(0)})
            for name, label in labels.items()
        }
        return [
            solved["xi"] - ALGEBRA.read("f + g*lam"),
            solved["p"] - ALGEBRA.read("a1"),
            solved["b"] - ALGEBRA.read("a2 - a3*lam"),
            delta**4 * solved["y"] - delta**4 * _SYMBOLS["v0"],
            delta**2 * solved["v"] - ALGEBRA.read("delta^2*b0 + delta^2*p*lam"),
            delta**6 * solved["z"] + ALGEBRA.read("delta^6*z0 + delta^6*lam"),
            delta**6 * parts["specialL"] - ALGEBRA.read("delta^6*lam - (delta^6*z0 - delta^6*y0)"),
        ]

    return settled(
        SECTION,
        "5-inner-system",
        "eqs. specialX to specialL",
        r"\tilde\xi'=F+G\lambda_N,\ldots,\ \delta\tilde z'=-\tilde z-\lambda_N,\ \lambda_N=\tilde z-\tilde y",
        "The scaled variables turn genSysXi to genSysLN into specialX to specialL",
        this.check("the scaled variables put into genSysXi to genSysLN", chain_rule),
        this.check("specialX to specialL solved for the derivatives, put back into the unscaled variables", back),
    )


def _orders() -> Entry:
    this = _claim("5-orders")
    delta = _SYMBOLS["delta"]

    def series(letter: str, first: int = 0, start: str = "") -> fmpq_mpoly:
        total = ALGEBRA.read(start) if start else ALGEBRA.constant(0)
        return sum((_SYMBOLS[f"{letter}{k}"] * delta**k for k in range(first, 4)), start=total)

    third, force, slope = series("A"), series("L"), series("P", 1, PRINTED["5-orders"]["p_0"])

    def products(parts: Parts) -> list[fmpq_mpoly]:
        in_b = _SYMBOLS["B3"] - ALGEBRA.coefficient_of(third * force, "delta", 3)
        in_v = ALGEBRA.coefficient_of(slope * force, "delta", 3)
        known = ALGEBRA.read("A0*L3"), ALGEBRA.read("alpha1*s*L3")
        return [in_b + known[0] - parts["r_b"], in_v - known[1] - parts["r_v"]]

    def leibniz(parts: Parts) -> list[fmpq_mpoly]:
        def at_zero(value: fmpq_mpoly, times: int) -> fmpq_mpoly:
            slopes = ALGEBRA.derivative(value, {"delta": ALGEBRA.constant(1)}, times)
            return ALGEBRA.substitute(slopes, {"delta": ALGEBRA.constant(0)})

        def third_order(left: fmpq_mpoly) -> fmpq_mpoly:
            terms = (comb(3, k) * at_zero(left, 3 - k) * at_zero(force, k) for k in range(3))
            return sum(terms, start=ALGEBRA.constant(0)) * fmpq(1, factorial(3))

        slope_0 = at_zero(slope, 0) - ALGEBRA.read("alpha1*s")
        return [_SYMBOLS["B3"] - third_order(third) - parts["r_b"], third_order(slope) - parts["r_v"], slope_0]

    return settled(
        SECTION,
        "5-orders",
        "eqs. specialBn, specialVn (and Yn, Zn, Ln)",
        r"r_{b,n}={\alpha_2}_n-\sum_{k=0}^{n-1}{\alpha_3}_{n-k}\lambda_k,\ r_{v,n}=\sum_{k=0}^{n-1}p_{n-k}\lambda_k",
        "The right-hand sides of the terms of order δ^n",
        this.check("coefficient of δ³ in the products of generic series (n = 3; the pattern of a product)", products),
        this.check("Leibniz' rule for the third derivative in δ at 0", leibniz),
        note="specialYn, specialZn and specialLn are linear: the orders do not mix, but for z_(n-1)' from δ z'.",
    )


def _equations() -> dict[str, fmpq_mpoly]:
    """SpecialBn to specialLn, left minus right."""
    texts = {
        "B": "b1 + alpha3*l0 - r0",
        "Y": "y1 - v0",
        "V": "v1 - b0 - alpha1*s*l0 - w0",
        "Z": "-z0 - l0 - q1",
        "L": "l0 - z0 + y0",
    }
    return {name: ALGEBRA.read(text) for name, text in texts.items()}


def _general_solution(value: fmpq_mpoly) -> fmpq_mpoly:
    """All solutions of specialBn to specialLn: b, lambda and z_(n-1) are free, the rest follows."""
    images = {f"r{k}": ALGEBRA.read(f"b{k + 1}") + ALGEBRA.read(f"alpha3*l{k}") for k in range(3)}
    images |= {f"y{k}": ALGEBRA.read(f"-2*l{k} - q{k + 1}") for k in range(3)}
    images |= {f"v{k}": images[f"y{k + 1}"] for k in range(2)}
    images["z0"] = ALGEBRA.read("-l0 - q1")
    images["w0"] = images["v1"] - ALGEBRA.read("b0 + alpha1*s*l0")
    return ALGEBRA.substitute(value, images)


def _third_order() -> Entry:
    this = _claim("5-third-order")

    def combined(parts: Parts) -> list[fmpq_mpoly]:
        e, a1s, a3 = _equations(), ALGEBRA.read("alpha1*s"), _SYMBOLS["alpha3"]
        second = a3 * (_d(e["Y"]) + e["V"]) + a1s * e["B"]
        first = a3 * (e["L"] - e["Z"]) - 2 * e["B"]
        third = second - _d(first, 2)
        return [parts["specialYnbis"] - second, parts["line 1667"] - first, parts["third-order_b"] - third]

    return settled(
        SECTION,
        "5-third-order",
        "eqs. specialYnbis, third-order_b, line 1667",
        r"2b_n'''+\alpha_1^*sb_n'-\alpha_3^*b_n=2r_{b,n}''+\alpha_3^*z_{n-1}'''+\alpha_1^*sr_{b,n}+\alpha_3^*r_{v,n}",
        "The elimination of y_n, v_n, z_n, λ_n",
        this.check("each equation as a combination of specialBn to specialLn and their derivatives", combined),
        this.check(
            "the general solution of specialBn to specialLn (b_n, λ_n, z_(n-1) free) put in",
            lambda parts: [_general_solution(value) for value in parts.values()],
        ),
    )


def _monomial() -> Entry:
    this = _claim("5-monomial")
    operator = ALGEBRA.read("2*b3 + alpha1*s*b1 - alpha3*b0")
    s = _SYMBOLS["s"]

    def explicit(parts: Parts) -> list[fmpq_mpoly]:
        found = []
        for k in range(7):
            powers = [ALGEBRA.derivative(s**k, {"s": ALGEBRA.constant(1)}, j) for j in range(4)]
            images = {"k": ALGEBRA.constant(k), "u3": s**k, "u0": s ** max(k - 3, 0)}
            found.append(ALGEBRA.replaced(operator, "b", powers, s) - ALGEBRA.substitute(parts["image"], images))
        return found

    def symbolic(parts: Parts) -> list[fmpq_mpoly]:
        # u0 = s^(k-3); each derivative lowers the exponent by one and brings it down as a factor.
        power, factor, values = 3, ALGEBRA.constant(1), []
        for j in range(4):
            values.append(factor * s ** (power - j) * _SYMBOLS["u0"])
            factor = factor * (_SYMBOLS["k"] - j)
        image = ALGEBRA.substitute(parts["image"], {"u3": s**3 * _SYMBOLS["u0"]})
        return [ALGEBRA.replaced(operator, "b", values, s) - image]

    return settled(
        SECTION,
        "5-monomial",
        "line 1691",
        r"(k\alpha_1^*-\alpha_3^*)s^k+k(k-1)(k-2)s^{k-3}",
        "The left-hand side of third-order_b at b_n = s^k",
        this.check("s^k for k = 0, ..., 6", explicit),
        this.check("s^k with k as a symbol", symbolic),
        corrected="(k α_1 - α_3) s^k + 2 k (k-1) (k-2) s^(k-3): the factor 2 of 2 b_n''' is missing",
        note="The coefficient of s^k is right, and with it the conclusion: it is not 0 for β not an integer. In the "
        "findings u0 is s^(k-3).",
    )


def _step_3() -> Entry:
    this = _claim("5-step-3")
    names = {"y": "y0", "v": "v0", "lambda": "l0", "z": "z0"}

    def solved(parts: Parts) -> list[fmpq_mpoly]:
        return [_general_solution(ALGEBRA.read(f"alpha3*{symbol}") - parts[name]) for name, symbol in names.items()]

    def equations(parts: Parts) -> list[fmpq_mpoly]:
        y, v, force, z = (parts[name] for name in names)
        a3 = _SYMBOLS["alpha3"]
        slope = _d(v) - a3 * _SYMBOLS["b0"] - ALGEBRA.read("alpha1*s") * force - a3 * _SYMBOLS["w0"]
        return [
            ALGEBRA.read("b1 - r0") + force,
            _d(y) - v,
            slope - ALGEBRA.read(PRINTED["5-third-order"]["third-order_b"]),
            z + force + ALGEBRA.read("alpha3*q1"),
            force - z + y,
        ]

    return settled(
        SECTION,
        "5-step-3",
        "lines 1704 to 1707",
        r"\alpha_3^*y_n=2(b_n'-r_{b,n})-\alpha_3^*z_{n-1}',\ \ldots,\ \alpha_3^*\lambda_n=r_{b,n}-b_n',\ \ldots",
        "The four formulas recover y_n, v_n, λ_n, z_n from b_n",
        this.check("on the general solution of specialBn to specialLn", solved),
        this.check("put into specialBn to specialLn, modulo third-order_b", equations),
    )


def _xinprime() -> Entry:
    this = _claim("5-xinprime")
    delta = _SYMBOLS["delta"]

    def product(parts: Parts) -> list[fmpq_mpoly]:
        f, g, force = (
            sum((_SYMBOLS[f"{x}{k}"] * delta**k for k in range(5)), start=ALGEBRA.constant(0)) for x in "FGL"
        )
        return [ALGEBRA.coefficient_of(f + g * force, "delta", 4) - parts["sum"]]

    def example(parts: Parts) -> list[fmpq_mpoly]:
        # xi_4 = V is v itself: F is b and G is p there, scaled by delta^2, and the term of order 4 of xi_4~ is v_2.
        terms = {
            name: [sum((ALGEBRA.bring(a) * _SYMBOLS["s"] ** k for k, a in enumerate(row)), start=ALGEBRA.constant(0))
                   for row in rows] for name, rows in extended_terms(5, chi=True).items()
        }  # fmt: skip
        zero = ALGEBRA.constant(0)
        images = {"F4": terms["b"][2], "G0": zero, "G1": zero}
        images |= {f"G{k + 2}": terms["p"][k] for k in range(3)}
        images |= {f"L{k}": terms["lambda_n"][k] for k in range(5)}
        return [terms["v"][2].derivative("s") - ALGEBRA.substitute(parts["sum"], images)]

    return settled(
        SECTION,
        "5-xinprime",
        "eq:xinprime",
        r"\xi_n'=F_n+\sum_{k=0}^nG_{n-k}\lambda_n",
        "The term of order δ^n of specialX",
        this.check("coefficient of δ⁴ in F + G λ_N for generic series (n = 4)", product),
        this.check("the extended example, component v of ξ, n = 4: against v_2' from step 3", example),
        corrected="ξ_n' = F_n + Σ G_(n-k) λ_k: the index of λ is k",
    )
