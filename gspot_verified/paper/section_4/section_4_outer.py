"""Ledger of Section 4, elimination: one equation for b, the other variables from b, and the same for deviations.

b0, b1, ... are b and its derivatives in t; epsilon^2 y, epsilon v, epsilon^2 z are the paper's y, v, z.
"""

from __future__ import annotations

from flint import fmpq_mpoly

from gspot_verified.paper.checks.entry import Builders, Entry, Section
from gspot_verified.paper.checks.identities import Algebra, Claim, Parts

SECTION = Section("Section 4")
ALGEBRA = Algebra(
    "alpha1 alpha2 alpha3 beta epsilon delta t s tau p c lam kappa k x w y v z Y0 Y1 V0 V1 Z0 Z1 "
    "b0 b1 b2 b3 b4 b5 f0 f1 f2 f3 f4 g0 g1 g2 g3 g4 h0 h1 h2 h3"
)
_SYMBOLS = ALGEBRA.symbols
PRINTED: dict[str, dict[str, str]] = {
    "4-eliminated": {
        "equation": "alpha3*b0 + alpha1*t*(alpha2-b1) + epsilon*(alpha3*b1 + alpha1*(alpha2-b1) - alpha1*t*b2)"
        " - 2*epsilon^2*b3 - epsilon^3*b4"
    },
    "4-difference": {"0": "epsilon^2*(alpha2-b1)", "1": "-epsilon^2*b2", "2": "-epsilon^2*b3"},
    "4-recover": {
        "y": "epsilon^2*(alpha3*b0 + alpha1*t*(alpha2-b1) - 2*(alpha2-b1)) - epsilon^3*b2 - epsilon^4*b3",
        "v": "-epsilon*(alpha3*b0 + alpha1*t*(alpha2-b1)) + 2*epsilon^2*b2 + epsilon^3*b3",
        "z": "epsilon^2*(alpha3*b0 + alpha1*t*(alpha2-b1) - (alpha2-b1)) - epsilon^3*b2 - epsilon^4*b3",
        "lambda": "alpha2 - b1",
    },
    "4-order": {"order": "3"},
    "4-deviation": {
        "equation": "alpha3*b0 - alpha1*t*b1 + epsilon*((alpha3-alpha1)*b1 - alpha1*t*b2)"
        " - 2*epsilon^2*b3 - epsilon^3*b4"
    },
    "4-deviation-recover": {
        "y": "epsilon^2*(alpha3*b0 - alpha1*t*b1 + 2*b1) - epsilon^3*b2 - epsilon^4*b3",
        "v": "-epsilon*(alpha3*b0 - alpha1*t*b1) + 2*epsilon^2*b2 + epsilon^3*b3",
        "z": "epsilon^2*(alpha3*b0 - alpha1*t*b1 + b1) - epsilon^3*b2 - epsilon^4*b3",
        "lambda": "-b1",
    },
}
QUOTIENT = {"alpha2": ALGEBRA.read("c*(alpha1-alpha3)")}
"""c = alpha2/(alpha1 - alpha3), for alpha1 ≠ alpha3."""
TRIVIAL = ALGEBRA.read("c*alpha1*t")
"""The trivial solution's b (entry 2-trivial)."""
CORRECTED: dict[str, dict[str, str]] = {"4-order": {"order": "4"}}


def claim(identifier: str) -> Claim:
    """The formulas of an entry of this file."""
    return Claim(ALGEBRA, PRINTED[identifier], CORRECTED.get(identifier, {}))


def along(value: fmpq_mpoly, function: str = "b", free: bool = True) -> fmpq_mpoly:
    """epsilon^4 times a formula in b0, b1, ... (for ``function`` b) along every solution of modelsys1 to modelsys5.

    Other letters: the derivatives are those in fast time, epsilon d/dt, and nothing is multiplied. Without ``free`` the
    term alpha2 is left out: the system of the deviations.
    """
    images = field(free)
    powers = [ALGEBRA.derivative(_SYMBOLS["b0"], images, k) for k in range(5)]
    if function != "b":
        return ALGEBRA.replaced(value, function, powers, ALGEBRA.constant(1))
    epsilon = _SYMBOLS["epsilon"]
    return ALGEBRA.replaced(value, "b", [epsilon ** (4 - k) * power for k, power in enumerate(powers)], epsilon**4)


def field(free: bool) -> dict[str, fmpq_mpoly]:
    """The derivation epsilon d/dt of the model system, with lambda_N = z - y in the scaled y, z."""
    drift = "alpha2" if free else "0*t"
    texts = {
        "t": "epsilon",
        "b0": f"epsilon*({drift} - alpha3*(z-y))",
        "y": "v",
        "v": "b0 + alpha1*t*(z-y)",
        "z": "-z - (z-y)",
    }
    return {name: ALGEBRA.read(text) for name, text in texts.items()}


def _d(value: fmpq_mpoly, times: int = 1) -> fmpq_mpoly:
    return ALGEBRA.derivative(value, ALGEBRA.jets("t", "b"), times)


def _eliminated() -> Entry:
    def operators(parts: Parts) -> list[fmpq_mpoly]:
        force = ALGEBRA.read("alpha2 - b1")
        base = ALGEBRA.read("alpha3*b0") + ALGEBRA.read("alpha1*t") * force
        epsilon = _SYMBOLS["epsilon"]
        return [
            parts["equation"] - base - epsilon * _d(base) - 2 * epsilon**2 * _d(force, 2) - epsilon**3 * _d(force, 3)
        ]

    this = claim("4-eliminated")
    return SECTION.settled(
        "4-eliminated",
        "eq:modelSysTEliminated",
        r"\alpha_3^*b+\alpha_1^*t(\alpha_2^*-\dot b)+\epsilon[\ldots]-2\epsilon^2\dddot b-\epsilon^3\ddddot b=0",
        "Along every solution in contact b alone satisfies the equation of line 984",
        this.check("(ε d/dt + 1) y'' with ε y' + y = -2 ε² λ - ε³ λ', y'' = b + p λ, α_3 λ = α_2 - b'", operators),
        this.check(
            "b and its four derivatives along the vector field, as polynomials in t and the state",
            lambda parts: [along(parts["equation"])],
        ),
        note="The equation has a label and no number: references to it print the number of its section, (4), "
        "which is also that of another equation (line 168).",
    )


def _order() -> Entry:
    this = claim("4-order")

    def highest(parts: Parts) -> list[fmpq_mpoly]:
        equation = ALGEBRA.read(PRINTED["4-eliminated"]["equation"])
        occurring = [k for k in range(6) if not equation.derivative(f"b{k}").is_zero()]
        return [parts["order"] - max(occurring)]

    def independent(parts: Parts) -> list[fmpq_mpoly]:
        images, states = field(True), ("b0", "y", "v", "z")
        powers = [ALGEBRA.derivative(_SYMBOLS["b0"], images, k) for k in range(len(states))]
        rows = [[power.derivative(name) for name in states] for power in powers]
        # A monomial in alpha3 and epsilon: not 0 for any epsilon > 0 and alpha3 < 0.
        terms = ALGEBRA.determinant(rows).to_dict()
        return [parts["order"] - len(states)] if len(terms) == 1 else []

    return SECTION.settled(
        "4-order",
        "line 986",
        r"\text{a more convenient 3rd-order single equation for } b(t)",
        "The single equation for b is of third order in t",
        this.check(
            "the highest derivative that occurs in line 984",
            highest,
            fault="the printed equation has order 4: its last term is -ε³ times the fourth derivative of b",
        ),
        this.check(
            "Jacobian determinant of (b, b', b'', b''') with respect to (b, y, v, z): a monomial in α_3 and ε, so that "
            "no equation of order 3 or less holds for all solutions at any ε > 0",
            independent,
            fault="b and its first three derivatives can be chosen freely, so the order is at least 4",
        ),
        corrected="fourth order in t",
        note="Third is the degree in ε.",
    )


def _modulo(value: fmpq_mpoly, equation: fmpq_mpoly) -> fmpq_mpoly:
    """Zero exactly when the value vanishes wherever the equation, solved for b4, holds."""
    return value * equation.derivative("b4") - equation * value.derivative("b4")


def _solve_the_system(parts: Parts, equation: fmpq_mpoly, drift: str) -> list[fmpq_mpoly]:
    """The recovered variables in the equations of the system, times alpha3."""
    y, v, z, force, epsilon = parts["y"], parts["v"], parts["z"], parts["lambda"], _SYMBOLS["epsilon"]
    return [
        force - ALGEBRA.read(f"{drift} - b1"),
        z - y - epsilon**2 * force,
        _modulo(_d(y) - v, equation),
        _modulo(_d(v) - ALGEBRA.read("alpha3*b0") - ALGEBRA.read("alpha1*t") * force, equation),
        _modulo(epsilon * _d(z) + z + epsilon**2 * force, equation),
    ]


def _on_solutions(parts: Parts, free: bool) -> list[fmpq_mpoly]:
    values = {"y": "epsilon^2*y", "v": "epsilon*v", "z": "epsilon^2*z", "lambda": "z-y"}
    return [along(parts[name], "b", free) - ALGEBRA.read(f"epsilon^4*alpha3*({text})") for name, text in values.items()]


def _difference() -> Entry:
    this = claim("4-difference")

    def differentiated(parts: Parts) -> list[fmpq_mpoly]:
        first, second, third = (parts[name] for name in "012")
        z, y = (ALGEBRA.read(PRINTED["4-recover"][name]) for name in "zy")
        return [first - (z - y), second - _d(first), third - _d(second)]

    def on_solutions(parts: Parts) -> list[fmpq_mpoly]:
        # z - y is epsilon^2 times that of the scaled variables; the field is epsilon d/dt, and along has epsilon^4.
        states, epsilon = ALGEBRA.read("z - y"), _SYMBOLS["epsilon"]
        rates = [ALGEBRA.derivative(states, field(True), k) for k in range(3)]
        wanted = [_SYMBOLS["alpha3"] * epsilon ** (6 - k) * rate for k, rate in enumerate(rates)]
        return [along(parts[str(k)]) - value for k, value in enumerate(wanted)]

    return SECTION.settled(
        "4-difference",
        "lines 978 to 980",
        r"\alpha_3^*(z-y)=\epsilon^2(\alpha_2-\dot b),\ \alpha_3^*(\dot z-\dot y)=-\epsilon^2\ddot b,\ \ldots",
        "In contact z - y and its first two derivatives are given by the first three of b, as printed",
        this.check("the difference of modelSysRecoverZ and modelSysRecoverY, twice differentiated", differentiated),
        this.check("along the vector field of the system", on_solutions),
    )


def _recover() -> Entry:
    this = claim("4-recover")
    equation = ALGEBRA.read(PRINTED["4-eliminated"]["equation"])
    return SECTION.settled(
        "4-recover",
        "eqs. modelSysRecoverY to modelSysRecoverLN",
        r"\alpha_3^*y=\epsilon^2[\ldots],\ \ldots,\ \alpha_3^*\lambda_N=\alpha_2^*-\dot b",
        "In contact, for α_3 not 0, the four formulas of lines 990 to 993 recover y, v, z, λ_N from b",
        this.check(
            "put into modelsys2 to modelsys5, modulo the equation of line 984",
            lambda parts: _solve_the_system(parts, equation, "alpha2"),
        ),
        this.check("along the vector field of the system", lambda parts: _on_solutions(parts, True)),
    )


def with_c(value: fmpq_mpoly) -> fmpq_mpoly:
    """The formula with a symbol c for the quotient alpha2/(alpha1 - alpha3)."""
    return ALGEBRA.substitute(value, QUOTIENT)


def around(value: fmpq_mpoly, line: fmpq_mpoly, size: fmpq_mpoly) -> fmpq_mpoly:
    """A formula in b at b = line + size f, the line a polynomial in t, with the symbol c for the quotient."""
    slope = {"t": ALGEBRA.constant(1)}
    images = {f"b{k}": ALGEBRA.derivative(line, slope, k) + size * _SYMBOLS[f"f{k}"] for k in range(5)}
    return with_c(ALGEBRA.substitute(value, images))


def _deviation() -> Entry:
    this = claim("4-deviation")
    whole = ALGEBRA.read(PRINTED["4-eliminated"]["equation"])
    as_f = {f"b{k}": _SYMBOLS[f"f{k}"] for k in range(5)}
    return SECTION.settled(
        "4-deviation",
        "eq:modelSysDev",
        r"\alpha_3^*\hat b-\alpha_1^*t\dot{\hat b}+\epsilon[\ldots]-\ldots=0",
        "In contact, for α_1 ≠ α_3, the deviation of b from the trivial solution satisfies eq. modelSysDev",
        this.check(
            "the equation of line 984 with the trivial solution plus a deviation in the place of b",
            lambda parts: [around(whole, TRIVIAL, ALGEBRA.constant(1)) - ALGEBRA.substitute(parts["equation"], as_f)],
        ),
        this.check(
            "along the vector field of the deviations (the system without α_2)",
            lambda parts: [along(parts["equation"], "b", False)],
        ),
    )


def _deviation_recover() -> Entry:
    this = claim("4-deviation-recover")
    equation = ALGEBRA.read(PRINTED["4-deviation"]["equation"])
    return SECTION.settled(
        "4-deviation-recover",
        "eqs. modelSysDevRecoverY to modelSysDevRecoverLN",
        r"\alpha_3^*\hat y=\ldots,\ \ldots,\ \alpha_3^*\hat\lambda_N=-\dot{\hat b}",
        "In contact, for α_3 not 0, the four formulas of lines 1073 to 1076 recover the deviations of y, v, z, λ_N "
        "from that of b; they are deviations from the trivial solution with the corrected z, y (2-trivial-zy) and "
        "mean force (S-mean-force)",
        this.check(
            "put into the system without α_2, modulo modelSysDev",
            lambda parts: _solve_the_system(parts, equation, "0*t"),
        ),
        this.check("along the vector field of the deviations", lambda parts: _on_solutions(parts, False)),
    )


ENTRIES: Builders = {
    "4-eliminated": _eliminated,
    "4-order": _order,
    "4-difference": _difference,
    "4-recover": _recover,
    "4-deviation": _deviation,
    "4-deviation-recover": _deviation_recover,
}
"""Elimination and deviations, in the order of the paper."""
