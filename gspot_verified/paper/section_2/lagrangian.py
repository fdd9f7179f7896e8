"""Ledger of Section 2: the extended example system in the general form, and the relations it must satisfy.

G_T is written as H/(2 (1 - x5)), H a vector of polynomials: a Lie derivative along G_T is one along H, divided.
"""

from __future__ import annotations

from flint import fmpq_mpoly

from gspot_verified.expansion.series.terms import NumberTerms
from gspot_verified.functions.expressions import Constant, Expression, Variable
from gspot_verified.functions.power_series import SeriesOfFunctions
from gspot_verified.functions.symbols import RationalFunction, Symbols
from gspot_verified.paper.checks.entry import Builders, Entry, Section
from gspot_verified.paper.checks.identities import Algebra, Claim, Parts, rising_signs

SECTION = Section("Section 2")
_NAMES = "x1 x2 x3 x4 x5 x6 alpha1 alpha2 alpha3 chi c lam a kplus kminus pminus d"
ALGEBRA = Algebra(_NAMES)
_SYMBOLS = ALGEBRA.symbols
_STATE = tuple(f"x{i}" for i in range(1, 7))
_DENOMINATOR = ALGEBRA.read("2*(1-x5)")
_FIELDS: dict[str, str] = {
    "F1": "x2", "F2": "0*x1", "F3": "x4", "F4": "x6", "F5": "alpha1 + chi*x6", "F6": "alpha2",
    "H1": "0*x1", "H2": "3", "H3": "0*x1", "H4": "1-x5", "H5": "0*x1", "H6": "alpha3",
    "N1": "0*x1", "N2": "1/2", "N3": "0*x1", "N4": "(1+x5)/2", "N5": "0*x1", "N6": "-alpha3/2",
    "mu": "1-x5", "x": "x1", "y": "x3",
}  # fmt: skip
"""F, H = 2 (1 - x5) G_T, G_N, mu, x, y as printed."""
PRINTED: dict[str, dict[str, str]] = {
    "2-lagrangian": _FIELDS,
    "2-quantities": {
        **_FIELDS,
        "u": "x2", "v": "x4", "p": "x5", "b": "x6",
        "alpha_1": "alpha1 + chi*x6", "alpha_2": "alpha2", "alpha_3": "alpha3",
    },
    "2-extended": {**_FIELDS, "k+": "-1", "k-": "2", "p-": "1", "a": "0*x1"},
    "2-stick": {"numerator": "kminus*lam + a", "denominator": "(kminus-kplus)*lam"},
}  # fmt: skip


BELOW_ONE = {"x5": "1 - d"}
"""p < 1, by d > 0."""
APART = {"kminus": "kplus + d"}
"""k⁺ < k⁻, by d > 0."""
THIRD = "1 + 2*x5"
"""2 (1 - p) (AC - B²)."""
_UNDEFINED = "At ξ_5 = 1 the printed G_T is not defined."


def _under(value: fmpq_mpoly, hypothesis: dict[str, str]) -> fmpq_mpoly:
    """The value for what a hypothesis allows."""
    return ALGEBRA.substitute(value, {name: ALGEBRA.read(text) for name, text in hypothesis.items()})


def _zero_if(holds: bool) -> fmpq_mpoly:
    return ALGEBRA.constant(0 if holds else 1)


def _field(parts: Parts, letter: str) -> list[fmpq_mpoly]:
    return [parts[f"{letter}{i}"] for i in range(1, 7)]


def _lie(function: fmpq_mpoly, field: list[fmpq_mpoly]) -> fmpq_mpoly:
    return ALGEBRA.derivative(function, dict(zip(_STATE, field, strict=True)))


def _slip_field(parts: Parts) -> list[fmpq_mpoly]:
    """2 (1 - x5) (G_N - mu G_T)."""
    return [_DENOMINATOR * n - parts["mu"] * h for n, h in zip(_field(parts, "N"), _field(parts, "H"), strict=True)]


def _third(parts: Parts) -> fmpq_mpoly:
    """2 (1 - x5) (A C - B²), A = L_{G_T} u, B = L_{G_N} u, C = L_{G_N} v."""
    tangent, normal, drift = (_field(parts, letter) for letter in "HNF")
    u, v = (_lie(parts[name], drift) for name in "xy")
    return _lie(u, tangent) * _lie(v, normal) - _DENOMINATOR * _lie(u, normal) ** 2


def _relations(parts: Parts) -> list[fmpq_mpoly]:
    """What lagrangian1, B = B and lagrangian2 say is zero, each times powers of 2 (1 - x5)."""
    tangent, normal, drift, slip = _field(parts, "H"), _field(parts, "N"), _field(parts, "F"), _slip_field(parts)
    found = [_lie(parts[name], field) for name in ("x", "y") for field in (tangent, normal)]
    u, v = _lie(parts["x"], drift), _lie(parts["y"], drift)
    found.append(_DENOMINATOR * _lie(u, normal) - _lie(v, tangent))
    numerator = _lie(v, slip)  # 2 (1 - x5) p
    # p = numerator/D: D^2 L p = D L(numerator) - numerator L(D).
    found.append(_DENOMINATOR * _lie(numerator, slip) - numerator * _lie(_DENOMINATOR, slip))
    return found


def _quantity_residuals(parts: Parts) -> list[fmpq_mpoly]:
    drift, slip = _field(parts, "F"), _slip_field(parts)
    u, v = _lie(parts["x"], drift), _lie(parts["y"], drift)
    p, b = parts["p"], _lie(v, drift)
    return [
        u - parts["u"],
        v - parts["v"],
        _lie(v, slip) - _DENOMINATOR * p,
        b - parts["b"],
        _lie(p, drift) - parts["alpha_1"],
        _lie(b, drift) - parts["alpha_2"],
        _lie(b, slip) + _DENOMINATOR * parts["alpha_3"],
    ]


class _Flow:
    """Lie derivatives as first coefficients of power series: f(ξ + δ G) = f + δ L_G f + ..., ξ a point of symbols."""

    def __init__(self, parts: Parts) -> None:
        self._ring = Symbols(*_NAMES.split())
        self.parts = parts
        denominator = self.number(_DENOMINATOR)
        self.normal = [self.number(f) for f in _field(parts, "N")]
        self.tangent = [self.number(f) / denominator for f in _field(parts, "H")]
        self.drift = [self.number(f) for f in _field(parts, "F")]
        mu = self.number(parts["mu"])
        self.slip = [n - mu * t for n, t in zip(self.normal, self.tangent, strict=True)]

    def number(self, value: fmpq_mpoly) -> RationalFunction:
        """A polynomial of the algebra as a number of the ring."""
        total = self._ring.number(0)
        for exponents, coefficient in value.terms():
            term = self._ring.number(coefficient)
            for name, exponent in zip(_NAMES.split(), exponents, strict=True):
                if exponent:
                    term = term * self._ring.symbol(name) ** int(exponent)
            total = total + term
        return total

    def along(self, function: fmpq_mpoly, field: list[RationalFunction]) -> RationalFunction:
        """The first coefficient, by the library's series of expressions."""
        total: Expression = Constant(self._ring.number(0))
        for exponents, coefficient in function.terms():
            term: Expression = Constant(self._ring.number(coefficient))
            for i, (name, exponent) in enumerate(zip(_NAMES.split(), exponents, strict=True)):
                for _ in range(int(exponent)):
                    term = term * (Variable(i) if i < 6 else Constant(self._ring.symbol(name)))
            total = total + term
        series = SeriesOfFunctions((total,), NumberTerms(self._ring), self._ring)
        series.extend([self._ring.symbol(name) for name in _STATE])
        series.extend(field)
        found: RationalFunction = series[total][1]
        return found

    def equal(self, value: RationalFunction, wanted: fmpq_mpoly) -> fmpq_mpoly:
        """The numerator of the difference."""
        return ALGEBRA.bring((value - self.number(wanted)).numerator)


def _relations_by_flow(parts: Parts) -> list[fmpq_mpoly]:
    flow, zero = _Flow(parts), ALGEBRA.constant(0)
    found = [flow.equal(flow.along(parts[n], f), zero) for n in ("x", "y") for f in (flow.tangent, flow.normal)]
    u, v = (_lie(parts[name], _field(parts, "F")) for name in ("x", "y"))
    found.append(flow.equal(flow.along(u, flow.normal) - flow.along(v, flow.tangent), zero))
    p = flow.along(v, flow.slip)
    if not p.denominator.is_one():
        return [*found, ALGEBRA.bring(p.denominator)]
    return [*found, flow.equal(flow.along(ALGEBRA.bring(p.numerator), flow.slip), zero)]


def _quantities_by_flow(parts: Parts) -> list[fmpq_mpoly]:
    flow = _Flow(parts)
    pairs = [
        (parts["x"], flow.drift, "u", 1), (parts["y"], flow.drift, "v", 1), (parts["v"], flow.slip, "p", 1),
        (parts["v"], flow.drift, "b", 1), (parts["p"], flow.drift, "alpha_1", 1),
        (parts["b"], flow.drift, "alpha_2", 1),
        (parts["b"], flow.slip, "alpha_3", -1),
    ]  # fmt: skip
    return [flow.equal(flow.along(function, field), sign * parts[name]) for function, field, name, sign in pairs]


def _lagrangian() -> Entry:
    this = Claim(ALGEBRA, PRINTED["2-lagrangian"])
    return SECTION.settled(
        "2-lagrangian",
        "eq:lagrangian1, eq:lagrangian2",
        r"\mathcal L_{G_T}x=\mathcal L_{G_N}x=\mathcal L_{G_T}y=\mathcal L_{G_N}y=0,\ \mathcal L_Gp=0",
        "For p other than 1, where its G_T is defined, the extended example satisfies both relations, and L_{G_N} u = "
        "L_{G_T} v",
        this.check("Lie derivatives as polynomials, denominators cleared", _relations),
        this.check("first coefficients of power series along the fields, rational functions", _relations_by_flow),
        note=_UNDEFINED,
    )


def _quantities() -> Entry:
    this = Claim(ALGEBRA, PRINTED["2-quantities"])
    return SECTION.settled(
        "2-quantities",
        "line 706",
        r"u=\xi_2,\ v=\xi_4,\ p=\xi_5,\ b=\xi_6,\ \alpha_1=\alpha_1^*+\chi\xi_6,\ \ldots",
        "By the definitions of Sec. 2, for p other than 1, the extended example has u = ξ_2, v = ξ_4, p = ξ_5, b = "
        "ξ_6, α_1 = α_1* + χ ξ_6, α_2 = α_2* and α_3 = α_3*",
        this.check("Lie derivatives as polynomials, denominators cleared", _quantity_residuals),
        this.check("first coefficients of power series along the fields, rational functions", _quantities_by_flow),
        note=_UNDEFINED,
    )


def _extended() -> Entry:
    this = Claim(ALGEBRA, PRINTED["2-extended"])

    def model(parts: Parts) -> list[fmpq_mpoly]:
        """Eqs. xdot, udot, newex1 to newex4 with lambda+ = c lambda_N, lambda- = (1 - c) lambda_N."""
        c, force, p = _SYMBOLS["c"], _SYMBOLS["lam"], _SYMBOLS["x5"]
        other = 1 - c
        return [
            _SYMBOLS["x2"],
            parts["a"] + (parts["k+"] * c + parts["k-"] * other) * force,
            _SYMBOLS["x4"],
            _SYMBOLS["x6"] + (p * c + parts["p-"] * other) * force,
            ALGEBRA.read("alpha1 + chi*x6"),
            ALGEBRA.read("alpha2 - c*alpha3*lam"),
        ]

    def general(parts: Parts) -> list[fmpq_mpoly]:
        # lambda_T = -(2 c - 1) mu lambda_N: -mu in positive, +mu in negative slip, between in stick.
        share, force = (2 * _SYMBOLS["c"] - 1) * parts["mu"], _SYMBOLS["lam"]
        rows = zip(_field(parts, "F"), _field(parts, "N"), _field(parts, "H"), model(parts), strict=True)
        friction = all(rising_signs(_under(value, BELOW_ONE)) for value in (parts["mu"], _DENOMINATOR))
        return [
            _zero_if(friction),
            _third(parts) - ALGEBRA.read(THIRD),
            *(_DENOMINATOR * (f + n * force - m) - share * h * force for f, n, h, m in rows),
        ]

    def by_forces(parts: Parts) -> list[fmpq_mpoly]:
        # Each normal force brings its own friction: -mu lambda+ forwards, +mu lambda- backwards.
        flow = _Flow(parts)
        mu = flow.number(parts["mu"])
        forward, backward = (flow.number(ALGEBRA.read(text)) for text in ("c*lam", "(1-c)*lam"))
        # What falls with p alone, and is 0 at p = 1, is positive for p < 1.
        falls = all(
            rising_signs(-value.derivative("x5")) and ALGEBRA.substitute(value, {"x5": ALGEBRA.constant(1)}).is_zero()
            for value in (parts["mu"], _DENOMINATOR)
        )
        u, v = (_lie(parts[name], _field(parts, "F")) for name in "xy")
        third = flow.along(u, flow.tangent) * flow.along(v, flow.normal) - flow.along(u, flow.normal) ** 2
        found = [_zero_if(falls), flow.equal(third * flow.number(_DENOMINATOR), ALGEBRA.read(THIRD))]
        for wanted, f, n, t in zip(model(parts), flow.drift, flow.normal, flow.tangent, strict=True):
            found.append(flow.equal(f + (n - mu * t) * forward + (n + mu * t) * backward, wanted))
        return found

    return SECTION.settled(
        "2-extended",
        "lines 664 to 702, eq:newex6",
        r"\dot\xi=F+G_T\lambda_T+G_N\lambda_N",
        "For p < 1, where its μ = 1 - p is positive, the printed F, G_T, G_N, μ are the extended example in positive "
        "slip, negative slip and stick; their AC - B² is (1 + 2p)/(2 (1 - p)), which is positive for p > -1/2 alone",
        this.check("λ_T = -(2c - 1) μ λ_N for every c, as polynomials; μ and 2 (1 - p) at p = 1 - d, d > 0", general),
        this.check(
            "λ+ along G_N - μ G_T plus λ- along G_N + μ G_T for every c, as rational functions in all symbols; μ and "
            "2 (1 - p) fall to 0 at p = 1",
            by_forces,
        ),
        note=f"{_UNDEFINED} For p > 1 its μ is negative, as no friction is; eqs. newex1 to newex5 have no such bound.",
    )


def _stick() -> Entry:
    this = Claim(ALGEBRA, PRINTED["2-stick"])
    symbols = {name: _SYMBOLS[name] for name in ("a", "kplus", "kminus", "lam")}

    def no_acceleration(parts: Parts) -> list[fmpq_mpoly]:
        # u' = a + k+ c lambda + k- (1 - c) lambda, times the denominator of c.
        a, plus, minus, force = symbols.values()
        top, bottom = parts["numerator"], parts["denominator"]
        defined = rising_signs(_under(bottom, APART))
        return [_zero_if(defined), a * bottom + plus * top * force + minus * (bottom - top) * force]

    def linear(parts: Parts) -> list[fmpq_mpoly]:
        # u' is affine in c: its zero is -u'(0)/(u'(1) - u'(0)).
        a, plus, minus, force = symbols.values()
        at_0, at_1 = a + minus * force, a + plus * force
        one_zero = rising_signs(_under(at_0 - at_1, APART))
        return [_zero_if(one_zero), parts["numerator"] * (at_1 - at_0) + at_0 * parts["denominator"]]

    return SECTION.settled(
        "2-stick",
        "eq:cdot",
        r"c=(k^-+\lambda_N^{-1}a)/(k^--k^+)",
        "In stick, where du/dt = 0, for λ_N > 0 and k⁺ < k⁻ the share of the forward force is "
        "c = (k⁻ + a/λ_N)/(k⁻ - k⁺), and no other",
        this.check("put into eq. udot: the tangential acceleration vanishes", no_acceleration),
        this.check("the one zero of the affine function of c, from its values at c = 0 and 1", linear),
    )


ENTRIES: Builders = {
    "2-lagrangian": _lagrangian,
    "2-quantities": _quantities,
    "2-extended": _extended,
    "2-stick": _stick,
}
"""The extended example system."""
