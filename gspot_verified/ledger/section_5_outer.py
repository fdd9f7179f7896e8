"""Ledger of Section 5, the outer system: its fast and slow part, and the ansatz near the G-spot.

In the ansatz every hatted variable is a coefficient times a power of -t; m is the derivative of alpha_1 along G at ξ*.
"""

from __future__ import annotations

from flint import fmpq_mpoly

from gspot_verified.ledger.entry import Entry, settled
from gspot_verified.ledger.identities import Algebra, Claim, Parts

SECTION = "Section 5, outer system and matching"
ALGEBRA = Algebra(
    "alpha1 alpha2 alpha3 beta eps delta kappa s t tau p b y v z lam chi r m q c G K F f xi0 p0 b0 lambda0 "
    "yd vd zd g0 g1 g2 g3 h0 h1 h2 h3 x0 x1 x2 x3 a1 a3"
)
_SYMBOLS = ALGEBRA.symbols
_ZERO, _ONE = ALGEBRA.constant(0), ALGEBRA.constant(1)
PRINTED: dict[str, dict[str, str]] = {
    "5-outer-system": {"y": "v", "v": "b + p*lam", "z": "-z - lam", "lambda": "z - y"},
    "5-fast-system": {"y": "v", "v": "-p*y + p*z", "z": "y - 2*z"},
    "5-fast-polynomial": {"polynomial": "lam^3 + 2*lam^2 + p*lam + p"},
    "5-slow-manifold": {"y": "2*b", "v": "0*b", "z": "b", "xi": "p*F - G*b", "b": "p*alpha2 + alpha3*b"},
    "5-ansatz": {
        "xi": "-r*xi0 - G*lambda0",
        "p": "-(r+1)*p0 - m*xi0",
        "b": "-r*b0 + alpha3*lambda0",
        "balance": "-b0 + alpha1*lambda0",
    },
    "5-ansatz-solution": {"r": "beta", "alpha3 xi0": "-G*b0", "alpha1 lambda0": "b0"},
    "5-ansatz-p0": {"alpha3 (r+1) p0": "0*b0"},
}  # fmt: skip
CORRECTED: dict[str, dict[str, str]] = {
    "5-fast-system": {"v": "-p*y + p*z + b"},
    "5-ansatz-p0": {"alpha3 (r+1) p0": "m*b0"},
}


def entries() -> list[Entry]:
    """The outer system, in the order of the paper."""
    return [_outer_system(), _fast_system(), _fast_polynomial(), _slow_manifold(), _ansatz(), _solution(), _p0()]


def _claim(identifier: str) -> Claim:
    return Claim(ALGEBRA, PRINTED[identifier], CORRECTED.get(identifier, {}))


def put(value: fmpq_mpoly, **texts: str) -> fmpq_mpoly:
    """The value with formulas in place of some symbols."""
    return ALGEBRA.substitute(value, {name: ALGEBRA.read(text) for name, text in texts.items()})


def _outer_system() -> Entry:
    this = _claim("5-outer-system")
    eps = _SYMBOLS["eps"]

    def general(parts: Parts) -> list[fmpq_mpoly]:
        # genSysY to genSysLN in y = eps^2 y_o, v = eps v_o, z = eps^2 z_o; yd, vd, zd are eps times the derivatives.
        y, v, z = (
            ALGEBRA.read(text) for text in ("eps*yd - eps*v", "vd - (b + p*lam)", "eps^2*zd + eps^2*z + eps^2*lam")
        )
        force = ALGEBRA.read("eps^2*lam - (eps^2*z - eps^2*y)")
        return [
            y - eps * (_SYMBOLS["yd"] - parts["y"]),
            v - (_SYMBOLS["vd"] - parts["v"]),
            z - eps**2 * (_SYMBOLS["zd"] - parts["z"]),
            force - eps**2 * (_SYMBOLS["lam"] - parts["lambda"]),
        ]

    def inner(parts: Parts) -> list[fmpq_mpoly]:
        # From specialY to specialL: y~ = y_o, v~ = delta^(-1) v_o, b~ = delta^(-2) b, p~ = delta^(-2) p, and
        # d/ds = delta^(-1) eps d/dt. Each times a power of delta.
        delta = _SYMBOLS["delta"]
        return [
            delta * parts["y"] - ALGEBRA.read("delta*v"),
            delta**2 * parts["v"] - ALGEBRA.read("delta^2*b + delta^2*p*lam"),
            parts["z"] + ALGEBRA.read("z + lam"),
            parts["lambda"] - ALGEBRA.read("z - y"),
        ]

    return settled(
        SECTION,
        "5-outer-system",
        "lines 1926 to 1935",
        r"\epsilon\dot y_o=v_o,\ \epsilon\dot v_o=b+p\lambda_N,\ \epsilon\dot z_o=-z_o-\lambda_N,\ \lambda_N=z_o-y_o",
        "The outer variables turn genSysY to genSysLN into a fast-slow system",
        this.check("ε² y_o, ε v_o, ε² z_o put into genSysY to genSysLN", general),
        this.check("from the inner form specialY to specialL", inner),
    )


def _fast_system() -> Entry:
    this = _claim("5-fast-system")

    def right_sides(parts: Parts) -> list[fmpq_mpoly]:
        return [put(ALGEBRA.read(PRINTED["5-outer-system"][n]), lam="z-y") - parts[n] for n in "yvz"]

    def equilibrium(parts: Parts) -> list[fmpq_mpoly]:
        # The slow manifold y_o = 2 b/p, v_o = 0, z_o = b/p must be its equilibrium; b = p q.
        return [put(parts[name], b="p*q", y="2*q", v="0*q", z="q") for name in "yvz"]

    return settled(
        SECTION,
        "5-fast-system",
        "line 1942",
        r"\epsilon(\dot y_o,\dot v_o,\dot z_o)^T=M(y_o,v_o,z_o)^T",
        "With ξ, p, b constant the fast system is M (y_o, v_o, z_o)",
        this.check("the right-hand sides of the outer system with λ_N = z_o - y_o", right_sides),
        this.check("the equilibrium: the slow manifold of line 1969", equilibrium),
        corrected="M (y_o, v_o, z_o) + (0, b, 0): the constant b is left out. M itself is right, and so are its "
        "eigenvalues and the conclusions on stability",
        note="As printed it holds for the deviations from the slow manifold, or for b = 0. In the findings q = b/p.",
    )


def _fast_polynomial() -> Entry:
    this = _claim("5-fast-polynomial")
    rows = [[ALGEBRA.read(text) for text in row.split()] for row in ("lam -1+0*p 0*p", "p lam -p", "-1+0*p 0*p lam+2")]

    def eliminated(parts: Parts) -> list[fmpq_mpoly]:
        # v = lam y and y = (lam + 2) z from the first and third row; the second, times 1/z.
        y = ALGEBRA.read("lam+2")
        second = _SYMBOLS["lam"] * (_SYMBOLS["lam"] * y) + _SYMBOLS["p"] * y - _SYMBOLS["p"]
        return [second - parts["polynomial"]]

    return settled(
        SECTION,
        "5-fast-polynomial",
        "lines 1949 to 1957",
        r"\det(\lambda I-M)=\lambda^3+2\lambda^2+p\lambda+p",
        "The characteristic polynomial of M, the same as in Section 4",
        this.check("determinant of λ I - M", lambda parts: [ALGEBRA.determinant(rows) - parts["polynomial"]]),
        this.check("an eigenvector ((λ + 2), λ (λ + 2), 1)", eliminated),
        note="Its roots for p > 0 and for p < 0: entries 4-stable and 4-saddle.",
    )


def _slow_manifold() -> Entry:
    this = _claim("5-slow-manifold")

    def balance(parts: Parts) -> list[fmpq_mpoly]:
        # The parts are p times the printed right-hand sides; the force is lambda = z_o - y_o.
        y, v, z = parts["y"], parts["v"], parts["z"]
        force = z - y
        return [
            v, _SYMBOLS["b"] + force, z + force,
            parts["xi"] - ALGEBRA.read("p*F") - _SYMBOLS["G"] * force,
            parts["b"] - ALGEBRA.read("p*alpha2") + _SYMBOLS["alpha3"] * force,
        ]  # fmt: skip

    def cramer(parts: Parts) -> list[fmpq_mpoly]:
        # M x = -(0, b, 0) with the corrected fast system; det M = -p.
        matrix = [
            [ALGEBRA.read(text) for text in row.split()] for row in ("0*p 1+0*p 0*p", "-p 0*p p", "1+0*p 0*p -2+0*p")
        ]
        right = [_ZERO, -_SYMBOLS["b"], _ZERO]
        determinant = ALGEBRA.determinant(matrix)
        found = []
        for j, name in enumerate("yvz"):
            replaced = [[*row[:j], value, *row[j + 1 :]] for row, value in zip(matrix, right, strict=True)]
            found.append(_SYMBOLS["p"] * ALGEBRA.determinant(replaced) - determinant * parts[name])
        slope = parts["b"] - ALGEBRA.read("p*alpha2 + alpha3*b")  # b' = alpha2 - alpha3 lambda with lambda = -b/p
        return [*found, slope, parts["xi"] - ALGEBRA.read("p*F - G*b")]

    return settled(
        SECTION,
        "5-slow-manifold",
        "lines 1968 to 1978",
        r"y_o=2b/p,\ v_o=0,\ z_o=b/p;\quad \dot\xi=F-Gb/p,\ \dot b=\alpha_2+\alpha_3b/p",
        "The slow manifold and the slow dynamics on it",
        this.check("the outer system at ε = 0, times p", balance),
        this.check("Cramer's rule for the equilibrium, and λ_N = -b/p (eq. pain_par+)", cramer),
    )


def _ansatz() -> Entry:
    this = _claim("5-ansatz")

    def by_rate(parts: Parts) -> list[fmpq_mpoly]:
        # d/dt of (-t)^e is -e (-t)^(e-1).
        texts = ("-r*xi0 - G*lambda0", "-(r+1)*p0 - m*xi0", "-r*b0 - (-alpha3*lambda0)", "-(b0 - alpha1*lambda0)")
        return [parts[name] - ALGEBRA.read(text) for name, text in zip(("xi", "p", "b", "balance"), texts, strict=True)]

    def explicit(parts: Parts) -> list[fmpq_mpoly]:
        # r = 1, 2, 3: the identities have degree 1 in r.
        found, slope, minus = [], {"t": _ONE}, -_SYMBOLS["t"]
        for r in (1, 2, 3):
            xi, p, b, force = (
                _SYMBOLS[name] * minus**power
                for name, power in (("xi0", r), ("p0", r + 1), ("b0", r), ("lambda0", r - 1))
            )
            equations = {
                "xi": (ALGEBRA.derivative(xi, slope) - _SYMBOLS["G"] * force, r - 1),
                "p": (ALGEBRA.derivative(p, slope) - _SYMBOLS["m"] * xi, r),
                "b": (ALGEBRA.derivative(b, slope) + _SYMBOLS["alpha3"] * force, r - 1),
                "balance": (-(b + ALGEBRA.read("alpha1*t") * force), r),
            }
            for name, (value, power) in equations.items():
                found.append(value - ALGEBRA.substitute(parts[name], {"r": ALGEBRA.constant(r)}) * minus**power)
        return found

    return settled(
        SECTION,
        "5-ansatz",
        "lines 2013 to 2016",
        r"-r\xi_0-G^*\lambda_0,\ -(r+1)p_0-{\alpha_1}_\xi^*\xi_0,\ \ldots",
        "The leading-order equations of the ansatz in powers of -t",
        this.check("by the rule for the derivative of a power", by_rate),
        this.check("explicit powers r = 1, 2, 3 in the slow equations", explicit),
    )


def _solution() -> Entry:
    this = _claim("5-ansatz-solution")

    def equations(parts: Parts) -> list[fmpq_mpoly]:
        a1, a3 = _SYMBOLS["alpha1"], _SYMBOLS["alpha3"]
        r, xi, force, b0 = parts["r"], parts["alpha3 xi0"], parts["alpha1 lambda0"], _SYMBOLS["b0"]
        found = [-a1 * r * xi - a3 * _SYMBOLS["G"] * force, -a1 * r * b0 + a3 * force, force - b0]
        return [put(value, alpha3="beta*alpha1") for value in found]

    def kernel(parts: Parts) -> list[fmpq_mpoly]:
        # The equations for (b0, lambda0) have a solution only when their determinant -alpha1 r + alpha3 is 0.
        rows = [[-parts["r"], _SYMBOLS["alpha3"]], [-_ONE, _SYMBOLS["alpha1"]]]
        slow = put(ALGEBRA.determinant(rows), alpha3="beta*alpha1")
        # d(xi)/d(b) = G lambda/(-alpha3 lambda) along the leading terms.
        ratio = parts["alpha3 xi0"] + _SYMBOLS["G"] * _SYMBOLS["b0"]
        return [slow, ratio, parts["alpha1 lambda0"] - _SYMBOLS["b0"]]

    return settled(
        SECTION,
        "5-ansatz-solution",
        "lines 2019 to 2023, eq:outerb_gen",
        r"r=\beta,\quad \xi_0=-\frac{G^*}{\alpha_3^*}b_0,\quad \lambda_0=\frac{b_0}{\alpha_1^*}",
        "The exponent is β, and the leading terms of ξ and λ_N are as stated",
        this.check("put into the leading-order equations, α_3 = β α_1", equations),
        this.check("determinant of the equations for (b_0, λ_0); dξ/db = -G/α_3", kernel),
    )


def _p0() -> Entry:
    this = _claim("5-ansatz-p0")

    def equation(parts: Parts) -> list[fmpq_mpoly]:
        # -(r + 1) p0 - m' xi0 = 0 with alpha3 xi0 = -G b0; m is alpha_1's derivative along G.
        return [-parts["alpha3 (r+1) p0"] + _SYMBOLS["m"] * _SYMBOLS["b0"]]

    def example(parts: Parts) -> list[fmpq_mpoly]:
        # p' = alpha1 + chi b: the deviation of p has p^' = chi b0 (-t)^r, so (r + 1) p0 = -chi b0; m = -chi alpha3.
        value = put(parts["alpha3 (r+1) p0"], m="-chi*alpha3")
        return [value + ALGEBRA.read("chi*alpha3*b0")]

    return settled(
        SECTION,
        "5-ansatz-p0",
        "line 2022",
        r"p_0=0",
        "The leading term of the deviation of p, of order (-t)^(β+1), vanishes",
        this.check("the second leading-order equation (line 2014) with ξ_0 = -G b_0/α_3", equation),
        this.check("the extended example: eq. newex1 integrated", example),
        corrected="p_0 = (α_1)_ξ G b_0/((β + 1) α_3) at ξ*; it is 0 only when the derivative of α_1 along G vanishes "
        "there (in the extended example p_0 = -χ b_0/(β + 1))",
        note="m in the findings is (α_1)_ξ G at ξ*. p_0 enters at a higher order only: r, ξ_0, λ_0 hold.",
    )
