"""Ledger of Section 4.4: the matching of the inner and the outer solution, and the powers of eps.

g0, g1, ... are b and its derivatives in s; c is the paper's C_1.
"""

from __future__ import annotations

from decimal import Decimal

from flint import fmpq, fmpq_mpoly

from gspot_verified.ledger.entry import Check, Entry, Rung, settled
from gspot_verified.ledger.identities import Claim, Parts
from gspot_verified.ledger.section_4_inner import INNER_SCALE, scaled
from gspot_verified.ledger.section_4_outer import ALGEBRA
from gspot_verified.ledger.section_4_outer import PRINTED as OUTER

SECTION = "Section 4"
_SYMBOLS = ALGEBRA.symbols
PRINTED: dict[str, dict[str, str]] = {
    "4-matching": {"beta = 2": "c*kappa^2*delta^4*s^2", "beta = 3": "-c*kappa^3*delta^6*s^3"},
    "4-matching-middle": {"beta = 2": "-c*delta^2*s", "beta = 3": "-c*delta^2*s"},
    "4-exponents": {
        "b": "2*beta", "y": "2*beta+4", "v": "2*beta+2", "z": "2*beta+4", "lambda": "2*beta-2",
    },
}  # fmt: skip
CORRECTED: dict[str, dict[str, str]] = {
    "4-matching-middle": {"beta = 2": "c*(-delta^2*s)^2", "beta = 3": "c*(-delta^2*s)^3"},
}
TABLE = (
    ("0.3333", "b", fmpq(1, 2)), ("1.0", "b", fmpq(3, 2)), ("1.6667", "b", fmpq(5, 2)),
    ("1.0", "v", fmpq(1, 2)), ("1.6667", "v", fmpq(3, 2)), ("2.3333", "v", fmpq(5, 2)),
    ("1.6667", "y", fmpq(1, 2)), ("2.3333", "y", fmpq(3, 2)), ("3.000", "y", fmpq(5, 2)),
)  # fmt: skip


def entries() -> list[Entry]:
    """The matching, in the order of the paper."""
    return [_matching(), _matching_middle(), _exponents()]


def _claim(identifier: str) -> Claim:
    return Claim(ALGEBRA, PRINTED[identifier], CORRECTED.get(identifier, {}))


def _powers_of_time(power: int) -> tuple[fmpq_mpoly, fmpq_mpoly]:
    """C (-kappa s)^beta eps^(2 beta/3) and C (-t)^beta at an integer beta."""
    inner = ALGEBRA.read(f"c*delta^{2 * power}*(-kappa*s)^{power}")
    outer = ALGEBRA.substitute(ALGEBRA.read(f"c*(-t)^{power}"), {"t": INNER_SCALE["t"]})
    return inner, outer


def _matching() -> Entry:
    this = _claim("4-matching")
    betas = {"beta = 2": 2, "beta = 3": 3}
    return settled(
        SECTION,
        "4-matching",
        "eq:bhat_inner",
        r"\hat b(s)=C_1\kappa^{-\beta}\epsilon^{2\beta/3}\Theta(\kappa s,\beta)\sim C_1(-t)^\beta",
        "The leading inner solution matches C_1 (-t)^β of the outer solution as s → −∞",
        this.check(
            "C_1 ε^(2β/3) (-κ s)^β in powers of δ, κ, s, at β = 2 and β = 3",
            lambda parts: [_powers_of_time(power)[0] - parts[name] for name, power in betas.items()],
            Rung.POINTS,
        ),
        this.check(
            "κ^β times C_1 (-t)^β with t = δ² s, at β = 2 and β = 3",
            lambda parts: [
                _SYMBOLS["kappa"] ** power * _powers_of_time(power)[1] - parts[name] for name, power in betas.items()
            ],
            Rung.POINTS,
        ),
        Check(Rung.PAGE, "proofs/negative.md: Θ(τ, β) ~ (-τ)^β as τ → −∞ (entry A-leading)", True),
    )


def _matching_middle() -> Entry:
    this = _claim("4-matching-middle")
    betas = {"beta = 2": 2, "beta = 3": 3}
    return settled(
        SECTION,
        "4-matching-middle",
        "eq:bhat_inner, line 1227",
        r"C_1\kappa^{-\beta}\epsilon^{2\beta/3}(-\kappa s)^\beta=C_1(-\epsilon^{2/3}s)=C_1(-t)^\beta",
        "The third form in eq. bhat_inner is C_1 (-ε^(2/3) s), without an exponent",
        this.check(
            "against the form on its left, times κ^β, at β = 2 and β = 3",
            lambda parts: [
                _powers_of_time(power)[0] - _SYMBOLS["kappa"] ** power * parts[name] for name, power in betas.items()
            ],
        ),
        this.check(
            "against the form on its right, C_1 (-t)^β, at β = 2 and β = 3",
            lambda parts: [_powers_of_time(power)[1] - parts[name] for name, power in betas.items()],
        ),
        corrected="C_1 (-ε^(2/3) s)^β",
        note="In the findings c is C_1 and δ = ε^(1/3).",
    )


def _exponents() -> Entry:
    this = _claim("4-exponents")
    orders = {"y": 0, "v": 0, "z": 0, "lambda": 0}

    def lowest(parts: Parts) -> list[fmpq_mpoly]:
        found = [parts["b"] - 2 * _SYMBOLS["beta"]]
        for name in orders:
            powers = ALGEBRA.coefficients(scaled(ALGEBRA.read(OUTER["4-deviation-recover"][name])), "delta")
            found.append(parts[name] - parts["b"] - (min(powers) - 8))
        return found

    def chain(parts: Parts) -> list[fmpq_mpoly]:
        # One derivative in t is a factor delta^(-2): lambda = -b'/alpha3, z = -eps^2 lambda, y = 2 z, v = y'.
        steps = [parts["b"] - 2 * _SYMBOLS["beta"], parts["lambda"] - parts["b"] + 2, parts["z"] - parts["lambda"] - 6]
        return [*steps, parts["y"] - parts["z"], parts["v"] - parts["y"] + 2]

    exact = {name: this.algebra.read(text) for name, text in PRINTED["4-exponents"].items()}
    rounded = []
    for text, name, beta in TABLE:
        numerator = ALGEBRA.substitute(exact[name], {"beta": ALGEBRA.constant(beta)}).leading_coefficient()
        half_unit = fmpq(1, 2 * 10 ** -int(Decimal(text).as_tuple().exponent))
        rounded.append(abs(numerator / 3 - fmpq(*Decimal(text).as_integer_ratio())) <= half_unit)
    return settled(
        SECTION,
        "4-exponents",
        "lines 1235 to 1239, tab:exponents(b)",
        r"\hat b,\hat y,\hat v,\hat z,\hat\lambda_N=O(\epsilon^{2\beta/3}),O(\epsilon^{(2\beta+4)/3}),"
        r"O(\epsilon^{(2\beta+2)/3}),O(\epsilon^{(2\beta+4)/3}),O(\epsilon^{(2\beta-2)/3})",
        "The powers of ε of the five deviations for s = O(1), and the theoretical values of the table",
        this.check("lowest power of δ in modelSysDevRecoverY, V, Z, LN on the inner scale", lowest),
        this.check("λ = -b'/α_3, z = -ε² λ, y = 2 z, v = y' with a factor δ^(-2) for each derivative", chain),
        Check(Rung.EXACT, "the nine printed decimals of the table are these exponents, rounded", all(rounded) or None),
    )
