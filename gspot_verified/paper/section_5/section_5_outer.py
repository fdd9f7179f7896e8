"""Ledger of Section 5, the outer system: its fast and its slow part.

xd, pd, bd are the derivatives of ξ, p, b in t, and yd, vd, zd ε times those of y_o, v_o, z_o.
"""

from __future__ import annotations

from flint import fmpq_mpoly

from gspot_verified.paper.checks.entry import Builders, Entry, Section
from gspot_verified.paper.checks.identities import Algebra, Claim, Parts
from gspot_verified.paper.section_4 import section_4_fast
from gspot_verified.paper.section_5 import section_5_recursion

SECTION = Section("Section 5, outer system and matching")
ALGEBRA = Algebra(
    "alpha1 alpha2 alpha3 beta epsilon delta kappa s tau p b y v z lam q G F K w T "
    "xd pd bd yd vd zd f g a1 g0 g1 g2 g3 h0 h1 h2 h3 x1 chi a2 a3 d2 d3 c0"
)
_SYMBOLS = ALGEBRA.symbols
_ZERO, _ONE = ALGEBRA.constant(0), ALGEBRA.constant(1)
PRINTED: dict[str, dict[str, str]] = {
    "5-outer-system": {
        "xi": "f + g*lam", "p": "a1", "b": "a2 - a3*lam",
        "y": "v", "v": "b + p*lam", "z": "-z - lam", "lambda": "z - y",
    },
    "5-fast-system": {"y": "v", "v": "-p*y + p*z", "z": "y - 2*z"},
    "5-fast-polynomial": {"polynomial": "lam^3 + 2*lam^2 + p*lam + p"},
    "5-slow-manifold": {
        "y": "2*b", "v": "0*b", "z": "b", "xi": "p*F - G*b", "p": "p*alpha1", "b": "p*alpha2 + alpha3*b",
    },
}  # fmt: skip
OUTER_LINES = {
    "xi": ("specialX", "xd", 0, 0), "p": ("specialPP", "pd", 0, 0), "b": ("specialB", "bd", 0, 0),
    "y": ("specialY", "yd", 1, 1), "v": ("specialV", "vd", 0, 2),
    "z": ("specialZ", "zd", 2, 0), "lambda": ("specialL", "lam", 2, 0),
}  # fmt: skip
"""By the right side: the equation, its left side, and the powers of ε and of δ that genSys and the inner form have in
front of it."""
IN_OUTER = {
    "y": "epsilon^2*y", "v": "epsilon*v", "z": "epsilon^2*z", "yd": "epsilon*yd", "vd": "vd", "zd": "epsilon*zd",
}  # fmt: skip
"""y, v, z and their derivatives in t by the outer variables (line 1926)."""
IN_INNER = {
    "b": "delta^2*b0", "p": "delta^2*p", "y": "y0", "v": "delta*v0", "z": "z0",
    "xd": "xi1", "pd": "p1", "bd": "b1", "yd": "delta*y1", "vd": "delta^2*v1", "zd": "delta*z1",
}  # fmt: skip
"""The outer variables by those of the inner scale, δ³ = ε: ε d/dt is δ d/ds."""
CORRECTED: dict[str, dict[str, str]] = {"5-fast-system": {"v": "-p*y + p*z + b"}}


def _claim(identifier: str) -> Claim:
    return Claim(ALGEBRA, PRINTED[identifier], CORRECTED.get(identifier, {}))


def put(value: fmpq_mpoly, **texts: str) -> fmpq_mpoly:
    """The value with formulas in place of some symbols."""
    return ALGEBRA.substitute(value, {name: ALGEBRA.read(text) for name, text in texts.items()})


def _jacobian(values: list[fmpq_mpoly]) -> list[list[fmpq_mpoly]]:
    return [[value.derivative(name) for name in "yvz"] for value in values]


def _outer_system() -> Entry:
    this = _claim("5-outer-system")

    def general(parts: Parts) -> list[fmpq_mpoly]:
        return [
            put(ALGEBRA.read(section_5_recursion.GENERAL[equation][0]), **IN_OUTER)
            - _SYMBOLS["epsilon"] ** power * (_SYMBOLS[unknown] - parts[name])
            for name, (equation, unknown, power, _) in OUTER_LINES.items()
        ]

    def inner(parts: Parts) -> list[fmpq_mpoly]:
        algebra, scaled = section_5_recursion.ALGEBRA, section_5_recursion.PRINTED["5-inner-system"]
        images = {name: algebra.read(text) for name, text in IN_INNER.items()}
        return [
            algebra.substitute(algebra.bring(_SYMBOLS[unknown]) - algebra.bring(parts[name]), images)
            - algebra.symbols["delta"] ** power * algebra.read(scaled[equation])
            for name, (equation, unknown, _, power) in OUTER_LINES.items()
        ]

    return SECTION.settled(
        "5-outer-system",
        "lines 1926 to 1935",
        r"\dot\xi=F+G\lambda_N,\ \dot p=\alpha_1,\ \dot b=\alpha_2-\alpha_3\lambda_N,"
        r"\ \epsilon\dot y_o=v_o,\ \epsilon\dot v_o=b+p\lambda_N,\ \epsilon\dot z_o=-z_o-\lambda_N,\ \lambda_N=z_o-y_o",
        "The outer variables turn genSysXi to genSysLN into the printed fast-slow system",
        this.check("ε² y_o, ε v_o, ε² z_o put into genSysXi to genSysLN", general),
        this.check("from the inner form specialX to specialL", inner),
    )


def _fast_system() -> Entry:
    this = _claim("5-fast-system")

    def right_sides(parts: Parts) -> list[fmpq_mpoly]:
        outer = PRINTED["5-outer-system"]
        return [put(ALGEBRA.read(outer[name]), lam=outer["lambda"]) - parts[name] for name in "yvz"]

    def equilibrium(parts: Parts) -> list[fmpq_mpoly]:
        # The slow manifold y_o = 2 b/p, v_o = 0, z_o = b/p must be its equilibrium; b = p q.
        return [put(parts[name], b="p*q", y="2*q", v="0*q", z="q") for name in "yvz"]

    return SECTION.settled(
        "5-fast-system",
        "line 1942",
        r"\epsilon(\dot y_o,\dot v_o,\dot z_o)^T=M(y_o,v_o,z_o)^T",
        "With ξ, p, b constant the fast system is M (y_o, v_o, z_o)",
        this.check(
            "the right-hand sides of the outer system with λ_N = z_o - y_o",
            right_sides,
            fault="that of v_o has the term b too",
        ),
        this.check(
            "the equilibrium: the slow manifold of line 1969",
            equilibrium,
            fault="on it the printed right-hand side of v_o is -b, so that it is no equilibrium",
        ),
        corrected="M (y_o, v_o, z_o) + (0, b, 0): the constant b is left out; M is right, and so is its "
        "characteristic polynomial",
        note="As printed it holds for the deviations from the slow manifold, p not 0, or for b = 0.",
    )


def _fast_polynomial() -> Entry:
    this = _claim("5-fast-polynomial")
    matrix = _jacobian([ALGEBRA.read(PRINTED["5-fast-system"][name]) for name in "yvz"])
    lam = _SYMBOLS["lam"]
    rows = [[lam * int(i == j) - value for j, value in enumerate(row)] for i, row in enumerate(matrix)]

    def eigenvector(parts: Parts) -> list[fmpq_mpoly]:
        # The first and the third row of lambda I - M vanish on it; the second gives the polynomial.
        vector = [ALGEBRA.read("lam+2"), ALGEBRA.read("lam*(lam+2)"), _ONE]
        images = [sum((a * b for a, b in zip(row, vector, strict=True)), start=_ZERO) for row in rows]
        return [images[0], images[2], images[1] - parts["polynomial"]]

    def section_4(parts: Parts) -> list[fmpq_mpoly]:
        whole = ALGEBRA.read(section_4_fast.PRINTED["4-fast-polynomial"]["polynomial"])
        return [whole + lam * parts["polynomial"]]

    return SECTION.settled(
        "5-fast-polynomial",
        "lines 1949 to 1957",
        r"\det(\lambda I-M)=\lambda^3+2\lambda^2+p\lambda+p",
        "The characteristic polynomial of M is λ³ + 2 λ² + p λ + p, the second factor of the one of Section 4, which "
        "belongs to the fast system there",
        this.check(
            "determinant of λ I - M", lambda parts: [ALGEBRA.determinant(rows) - parts["polynomial"], *section_4(parts)]
        ),
        this.check("an eigenvector ((λ + 2), λ (λ + 2), 1)", lambda parts: [*eigenvector(parts), *section_4(parts)]),
        note="Its roots for p > 0 and for p < 0: entries 4-stable and 4-saddle.",
    )


def _rate_of_p(equation: str, derivative: str) -> fmpq_mpoly:
    """p times the rate of p by genSysP or by its scaled form, which have no force; α_1 as on the manifold."""
    algebra = section_5_recursion.ALGEBRA
    rate = algebra.substitute(algebra.symbols[derivative] - algebra.read(equation), {"a1": algebra.symbols["alpha1"]})
    return _SYMBOLS["p"] * ALGEBRA.bring(rate)


def _times_p(rate: fmpq_mpoly, force: fmpq_mpoly) -> fmpq_mpoly:
    """p times a rate of ξ or b, by p times the force in it."""
    named = put(rate, f="F", g="G", a2="alpha2", a3="alpha3")
    return _SYMBOLS["p"] * put(named, lam="0*p") + named.derivative("lam") * force


def _inner_rate(equation: str, derivative: str) -> fmpq_mpoly:
    """The rate in an equation of the inner scale, left minus right."""
    algebra = section_5_recursion.ALGEBRA
    line = algebra.read(section_5_recursion.PRINTED["5-inner-system"][equation])
    return ALGEBRA.bring(algebra.symbols[derivative] - line)


def _slow_manifold() -> Entry:
    this = _claim("5-slow-manifold")

    def balance(parts: Parts) -> list[fmpq_mpoly]:
        # The parts are p times the printed right-hand sides: so is b, and v_o is 0; the force is lambda = z_o - y_o.
        outer = PRINTED["5-outer-system"]
        on_it = {name: parts[name] for name in "yvz"} | {"b": ALGEBRA.read("p*b")}
        rates = [ALGEBRA.substitute(put(ALGEBRA.read(outer[name]), lam=outer["lambda"]), on_it) for name in "yvz"]
        force = ALGEBRA.substitute(ALGEBRA.read(outer["lambda"]), on_it)
        return [
            *rates,
            parts["xi"] - _times_p(ALGEBRA.read(outer["xi"]), force),
            parts["p"] - _rate_of_p(section_5_recursion.GENERAL["specialPP"][0], "pd"),
            parts["b"] - _times_p(ALGEBRA.read(outer["b"]), force),
        ]

    def cramer(parts: Parts) -> list[fmpq_mpoly]:
        outer = PRINTED["5-outer-system"]
        # The fast part of the outer system is linear: M x = -(its value at 0); det M = -p.
        sides = [put(ALGEBRA.read(outer[name]), lam=outer["lambda"]) for name in "yvz"]
        matrix, right = _jacobian(sides), [-put(side, y="0*y", v="0*v", z="0*z") for side in sides]
        determinant = ALGEBRA.determinant(matrix)
        found = []
        for j, name in enumerate("yvz"):
            replaced = [[*row[:j], value, *row[j + 1 :]] for row, value in zip(matrix, right, strict=True)]
            found.append(_SYMBOLS["p"] * ALGEBRA.determinant(replaced) - determinant * parts[name])
        # p times F + G lambda and alpha2 - alpha3 lambda, with p lambda = -b.
        force = -_SYMBOLS["b"]
        slopes = {
            "xi": _times_p(_inner_rate("specialX", "xi1"), force),
            "b": _times_p(_inner_rate("specialB", "b1"), force),
        }
        slopes["p"] = _rate_of_p(section_5_recursion.PRINTED["5-inner-system"]["specialPP"], "p1")
        return [*found, *(parts[name] - value for name, value in slopes.items())]

    return SECTION.settled(
        "5-slow-manifold",
        "lines 1968 to 1978",
        r"y_o=2b/p,\ v_o=0,\ z_o=b/p;\quad \dot\xi=F-Gb/p,\ \dot p=\alpha_1,\ \dot b=\alpha_2+\alpha_3b/p",
        "In the limit ε → 0, for p other than 0, the slow manifold of the outer system is y_o = 2b/p, v_o = 0, "
        "z_o = b/p, and the motion on it is given by dξ/dt = F - G b/p, dp/dt = α_1 and db/dt = α_2 + α_3 b/p",
        this.check("the outer system at ε = 0, times p; p by genSysP", balance),
        this.check(
            "Cramer's rule for the equilibrium, and λ_N = -b/p (eq. pain_par+) in specialX, specialPP and specialB",
            cramer,
        ),
    )


ENTRIES: Builders = {
    "5-outer-system": _outer_system,
    "5-fast-system": _fast_system,
    "5-fast-polynomial": _fast_polynomial,
    "5-slow-manifold": _slow_manifold,
}
"""The outer system, in the order of the paper."""
