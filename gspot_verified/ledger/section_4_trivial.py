"""Ledger of the trivial solution (Sec. 2), and of Section 4.1: it is the only smooth one."""

from __future__ import annotations

from flint import fmpq_mpoly

from gspot_verified.ledger.entry import Entry, Rung, settled
from gspot_verified.ledger.extended_system import extended_terms
from gspot_verified.ledger.identities import Claim, Parts
from gspot_verified.ledger.section_4_outer import ALGEBRA
from gspot_verified.ledger.section_4_outer import PRINTED as OUTER

SECTION = "Section 4"
_SYMBOLS = ALGEBRA.symbols
PRINTED: dict[str, dict[str, str]] = {
    "2-trivial": {"p": "alpha1*t", "b": "c*alpha1*t", "v": "0*t"},
    "2-trivial-zy": {"z": "-eps^2*c"},
    "4-unique": {
        "order 0": "alpha3*b0 + alpha1*t*(alpha2-b1)",
        "order n": "alpha3*f0 - alpha1*t*f1",
        "b": "c*alpha1*t",
    },
}
CORRECTED: dict[str, dict[str, str]] = {"2-trivial-zy": {"z": "eps^2*c"}}


def entries() -> list[Entry]:
    """The trivial solution of Sec. 2."""
    return [_trivial(), _trivial_zy()]


def uniqueness_entries() -> list[Entry]:
    """Sec. 4.1."""
    return [_unique()]


def _claim(identifier: str) -> Claim:
    return Claim(ALGEBRA, PRINTED[identifier], CORRECTED.get(identifier, {}))


def _with_c(value: fmpq_mpoly) -> fmpq_mpoly:
    """alpha2 = c (alpha1 - alpha3): a symbol c for the quotient alpha2/(alpha1 - alpha3)."""
    return ALGEBRA.substitute(value, {"alpha2": ALGEBRA.read("c*(alpha1-alpha3)")})


def _in_model_system(p: fmpq_mpoly, b: fmpq_mpoly, v: fmpq_mpoly, z: fmpq_mpoly) -> list[fmpq_mpoly]:
    """modelsys1 to modelsys5 with y = 2 z, times eps^2 where lambda_N = (z - y)/eps^2 enters."""
    eps, force = _SYMBOLS["eps"], -z
    slope = {"t": ALGEBRA.constant(1)}
    found = [
        ALGEBRA.derivative(p, slope) - _SYMBOLS["alpha1"],
        eps**2 * (ALGEBRA.derivative(b, slope) - _SYMBOLS["alpha2"]) + _SYMBOLS["alpha3"] * force,
        2 * ALGEBRA.derivative(z, slope) - v,
        eps**2 * (ALGEBRA.derivative(v, slope) - b) - p * force,
        eps * ALGEBRA.derivative(z, slope) + z + force,
    ]
    return [_with_c(value) for value in found]


def _first_terms() -> dict[str, fmpq_mpoly]:
    """p_0, b_0, v_0, z_0 of Theorem 1's recursion for the model system (s for t), alpha2 = c (alpha1 - alpha3)."""
    terms = extended_terms(1, chi=False)
    first = {name: terms[name][0] for name in ("p", "b", "v", "z")}
    return {name: sum((ALGEBRA.bring(a) * _SYMBOLS["t"] ** k for k, a in enumerate(row)), start=ALGEBRA.constant(0))
            for name, row in first.items()}  # fmt: skip


def _trivial() -> Entry:
    this = _claim("2-trivial")
    first = _first_terms()
    z = ALGEBRA.read("eps^2*c")
    return settled(
        "Section 2",
        "2-trivial",
        "eqs. modelSysDistP, B, V",
        r"\bar p=\alpha_1^*t,\quad \bar b=\frac{\alpha_2^*}{\alpha_1^*-\alpha_3^*}\alpha_1^*t,\quad \bar v=0",
        "The trivial solution of the motivating example (with the corrected z, y of 2-trivial-zy)",
        this.check(
            "put into modelsys1 to modelsys5; c = α_2/(α_1 - α_3) is a symbol",
            lambda parts: _in_model_system(parts["p"], parts["b"], parts["v"], z),
        ),
        this.check(
            "the first terms of Theorem 1's recursion with symbols α_1, α_3, c (n = 0)",
            lambda parts: [parts[name] - first[name] for name in ("p", "b", "v")],
        ),
    )


def _trivial_zy() -> Entry:
    this = _claim("2-trivial-zy")
    first = _first_terms()

    def recovered(parts: Parts) -> list[fmpq_mpoly]:
        formula = ALGEBRA.read(OUTER["4-recover"]["z"])
        zero = ALGEBRA.constant(0)
        line = {"b0": ALGEBRA.read("c*alpha1*t"), "b1": ALGEBRA.read("c*alpha1"), "b2": zero, "b3": zero}
        return [_with_c(ALGEBRA.substitute(formula, line)) - _SYMBOLS["alpha3"] * parts["z"]]

    return settled(
        "Section 2",
        "2-trivial-zy",
        "eq:modelSysDistZY",
        r"\bar z=\frac{\bar y}2=-\epsilon^2\frac{\alpha_2^*}{\alpha_1^*-\alpha_3^*}",
        "The deformation of the trivial solution is -ε² α_2/(α_1 - α_3)",
        this.check(
            "put into modelsys1 to modelsys5; c = α_2/(α_1 - α_3) is a symbol",
            lambda parts: _in_model_system(
                ALGEBRA.read("alpha1*t"), ALGEBRA.read("c*alpha1*t"), ALGEBRA.constant(0), parts["z"]
            ),
        ),
        this.check("modelSysRecoverZ with b = c α_1 t", recovered),
        this.check(
            "the first term of Theorem 1's recursion with symbols α_1, α_3, c",
            lambda parts: [parts["z"] - _SYMBOLS["eps"] ** 2 * first["z"]],
        ),
        corrected="z = y/2 = ε² α_2/(α_1 - α_3), so that λ_N = (z - y)/ε² = α_2/(α_3 - α_1) > 0 in Case III",
        note="In the findings c is α_2/(α_1 - α_3). "
        "The example of Section 5 has the right sign: z_0 = -2 for α = (-1, -1, -3/2).",
    )


def _unique() -> Entry:
    this = _claim("4-unique")
    orders = 12

    def by_orders(parts: Parts) -> list[fmpq_mpoly]:
        line = [parts["b"], parts["b"].derivative("t"), *[ALGEBRA.constant(0)] * 3]
        eps = _SYMBOLS["eps"]
        images = {f"b{k}": line[k] + eps * _SYMBOLS[f"f{k}"] for k in range(5)}
        whole = ALGEBRA.read(OUTER["4-eliminated"]["equation"])
        found = ALGEBRA.coefficients(_with_c(ALGEBRA.substitute(whole, images)), "eps")
        zero = ALGEBRA.constant(0)
        # f = (-t)^beta has t f' = beta f: the coefficients of f0 and of f1 at t = 1, with alpha3 = beta alpha1.
        own = parts["order n"].derivative("f0") + _SYMBOLS["beta"] * parts["order n"].derivative("f1")
        exponent = ALGEBRA.substitute(own, {"t": ALGEBRA.constant(1), "alpha3": ALGEBRA.read("beta*alpha1")})
        return [
            parts["order 0"] - ALGEBRA.coefficient_of(whole, "eps", 0),
            found.get(0, zero),
            found.get(1, zero) - parts["order n"],
            exponent,
        ]

    def by_recursion(parts: Parts) -> list[fmpq_mpoly]:
        terms = extended_terms(orders, chi=False)
        later = [ALGEBRA.bring(a) for n in range(1, orders) for a in terms["b"][n]]
        return [_first_terms()["b"] - parts["b"], *later]

    return settled(
        SECTION,
        "4-unique",
        "lines 1021 to 1053",
        r"\bar b(t,\epsilon)=\frac{\alpha_2^*}{1-\beta}t",
        "For β not an integer, b = α_2 t/(1 - β) is the only solution that is smooth in t and ε",
        this.check(
            "modelSysTEliminated with b + ε f, by powers of ε: α_3 f = α_1 t f' at each order, solved by C (-t)^β only",
            by_orders,
        ),
        this.check(
            f"Theorem 1's recursion with symbols α_1, α_3, c: every b_n with 0 < n < {orders} vanishes",
            by_recursion,
            Rung.POINTS,
        ),
    )
