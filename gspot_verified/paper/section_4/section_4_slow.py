"""Ledger of the slow system on the outer scale of Section 4, and of its exponent beta."""

from __future__ import annotations

from flint import fmpq_mpoly

from gspot_verified.paper.checks.entry import Builders, Entry, Section
from gspot_verified.paper.checks.identities import Claim, Parts
from gspot_verified.paper.section_4.section_4_outer import ALGEBRA, field
from gspot_verified.paper.section_4.section_4_outer import PRINTED as OUTER

_SYMBOLS = ALGEBRA.symbols
_WITH_BETA = {"alpha3": ALGEBRA.read("beta*alpha1")}
PRINTED: dict[str, dict[str, str]] = {
    "1-beta": {"numerator": "alpha1", "denominator": "alpha3"},
    "4-slow": {
        "equation": "alpha3*b0 - alpha1*t*b1", "y": "2*b0", "v": "0*b0", "z": "b0", "lambda": "-b0",
        "exponent": "beta",
    },
}  # fmt: skip
CORRECTED: dict[str, dict[str, str]] = {"1-beta": {"numerator": "alpha3", "denominator": "alpha1"}}


def _claim(identifier: str) -> Claim:
    return Claim(ALGEBRA, PRINTED[identifier], CORRECTED.get(identifier, {}))


def phase_plane() -> list[list[fmpq_mpoly]]:
    """The matrix of Gspot1, Gspot2 in (p, b): p d/dt of p and of b, with p lambda_N = -b in rigid slip."""
    rates = [ALGEBRA.read("alpha1*p"), ALGEBRA.read("alpha2*p - alpha3*(-b0)")]
    return [[rate.derivative(name) for name in ("p", "b0")] for rate in rates]


def _beta() -> Entry:
    this = _claim("1-beta")

    def outer(parts: Parts) -> list[fmpq_mpoly]:
        # (-t)^beta in alpha3 b - alpha1 t b' = 0: alpha3 - alpha1 beta, times the denominator of beta.
        equation = ALGEBRA.read(OUTER["4-deviation"]["equation"])
        powers = [_SYMBOLS["t"] * parts["denominator"], parts["numerator"]]
        return [ALGEBRA.replaced(ALGEBRA.coefficient_of(equation, "epsilon", 0), "b", powers, ALGEBRA.constant(0))]

    def rigid(parts: Parts) -> list[fmpq_mpoly]:
        # dt = p ds, lambda_N = -b/p: p' = alpha1 p, b' = alpha2 p + alpha3 b. b = p^beta needs alpha3 = beta alpha1.
        matrix = phase_plane()
        return [matrix[1][1] * parts["denominator"] - matrix[0][0] * parts["numerator"]]

    return Section("Section 1").settled(
        "1-beta",
        "line 380",
        r"\beta=\alpha_1/\alpha_3",
        "The β of the Introduction, the exponent of the outer solution (-t)^β, is α_1/α_3",
        this.check(
            "the exponent of the outer solution (-t)^β of modelSysDev at ε = 0",
            outer,
            fault="(-t)^β solves that equation for β = α_3/α_1 alone",
        ),
        this.check(
            "the ratio of the eigenvalues of Gspot1, Gspot2, from modelsys with y = v = 0 and dt = p ds",
            rigid,
            fault="the eigenvalue of b is α_3 and that of p is α_1: the deviation of b from its line is a "
            "multiple of p^β with β = α_3/α_1",
        ),
        corrected="β = α_3/α_1, as in eq. beta (line 758), Sec. 4 and Theorem 1",
        note="In Case III α_1/α_3 lies between 0 and 1 and passes no positive integer. That the places of "
        "side-switching are the integers of α_3/α_1: S-switching, S-side, 5-rule.",
    )


def _slow() -> Entry:
    this = _claim("4-slow")
    product = ALGEBRA.read("alpha1*t")

    def powers_solve(parts: Parts) -> fmpq_mpoly:
        # b = (-t)^exponent or t^exponent: t b' = exponent b.
        equation = ALGEBRA.substitute(parts["equation"], _WITH_BETA)
        return ALGEBRA.replaced(equation, "b", [_SYMBOLS["t"], parts["exponent"]], ALGEBRA.constant(0))

    def nothing_else_solves(parts: Parts) -> fmpq_mpoly:
        # x = |t|^(-exponent): t d/dt of b x is zero on solutions, so b x is constant on either side of 0.
        euler = {"b0": ALGEBRA.read("t*b1"), "x": -parts["exponent"] * _SYMBOLS["x"]}
        rate = ALGEBRA.derivative(ALGEBRA.read("b0*x"), euler)
        return _SYMBOLS["alpha1"] * rate + _SYMBOLS["x"] * ALGEBRA.substitute(parts["equation"], _WITH_BETA)

    def limits(parts: Parts) -> list[fmpq_mpoly]:
        found = [
            parts["equation"] - ALGEBRA.coefficient_of(ALGEBRA.read(OUTER["4-deviation"]["equation"]), "epsilon", 0)
        ]
        for name, power in (("y", 2), ("v", 1), ("z", 2), ("lambda", 0)):
            orders = ALGEBRA.coefficients(ALGEBRA.read(OUTER["4-deviation-recover"][name]), "epsilon")
            # b' = alpha3 b/(alpha1 t), all times alpha1 t.
            leading = orders.get(power, ALGEBRA.constant(0))
            value = ALGEBRA.replaced(leading, "b", [product * _SYMBOLS["b0"], ALGEBRA.read("alpha3*b0")], product)
            lower = [orders[k] for k in sorted(orders) if k < power]
            found += [*lower, value - _SYMBOLS["alpha3"] * parts[name]]
        return [*found, powers_solve(parts), nothing_else_solves(parts)]

    def balance(parts: Parts) -> list[fmpq_mpoly]:
        # The system at epsilon = 0: v = 0, b + p lambda = 0, lambda = z - y, 0 = -z - lambda; all times alpha1 t.
        scaled = {"y": parts["y"], "v": parts["v"], "z": parts["z"]}
        limit = {"epsilon": ALGEBRA.constant(0), "b0": product * _SYMBOLS["b0"], **scaled}
        rates = {name: ALGEBRA.substitute(rate, limit) for name, rate in field(False).items() if name in "yvz"}
        force = parts["lambda"]
        # b' = -alpha3 lambda, so t b' = exponent b is -alpha3 lambda = exponent b alpha1, times alpha1 t.
        slope = ALGEBRA.substitute(parts["equation"], {"b1": ALGEBRA.constant(0)}) * product
        slope += parts["equation"].derivative("b1") * (-_SYMBOLS["alpha3"] * force)
        power = ALGEBRA.read("-alpha3") * force - _SYMBOLS["alpha1"] * parts["exponent"] * _SYMBOLS["b0"]
        balanced = [*rates.values(), force - parts["z"] + parts["y"], slope, ALGEBRA.substitute(power, _WITH_BETA)]
        return [*balanced, nothing_else_solves(parts)]

    return Section("Section 4").settled(
        "4-slow",
        "eq:example_outer, lines 1117 to 1136",
        r"\hat b=C_1(-t)^\beta,\ C_2t^\beta;\ \frac{\hat y}{\epsilon^2}=\frac{2\hat b}{\alpha_1^*t},\ \hat v=0,\ "
        r"\frac{\hat z}{\epsilon^2}=\frac{\hat b}{\alpha_1^*t},\ \hat\lambda_N=-\frac{\hat b}{\alpha_1^*t}",
        "For t ≠ 0 and α_1 not 0 the slow system, ε → 0, has the solutions b = C_1 (-t)^β and C_2 t^β, β = α_3/α_1, "
        "and no others; on them, of the deviations as in 4-deviation-recover, y/ε² is 2b/(α_1 t), v/ε is 0, z/ε² is "
        "b/(α_1 t) and λ_N is -b/(α_1 t)",
        this.check(
            "modelSysDev and modelSysDevRecoverY to modelSysDevRecoverLN at leading order in ε; t b' = β b", limits
        ),
        this.check("the system of the deviations itself at ε = 0; (|t|^(-β) b)' = 0", balance),
    )


RATIO_ENTRIES: Builders = {"1-beta": _beta}
"""The ratio beta as Sec. 1 prints it."""


ENTRIES: Builders = {"4-slow": _slow}
"""The slow system."""
