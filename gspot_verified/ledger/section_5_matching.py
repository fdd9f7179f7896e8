"""Ledger of Section 5, last part: the perturbation of the distinguished trajectory on the inner scale, and matching.

g0, g1, ... are the hatted b and its derivatives in s; h0, h1, ... are theta's in tau.
"""

from __future__ import annotations

from flint import fmpq_mpoly

from gspot_verified.ledger.entry import Check, Entry, Rung, settled
from gspot_verified.ledger.extended_system import extended_terms
from gspot_verified.ledger.identities import Claim, Parts
from gspot_verified.ledger.section_4_inner import PRINTED as SECTION_4
from gspot_verified.ledger.section_5_outer import ALGEBRA, put

SECTION = "Section 5, outer system and matching"
_SYMBOLS = ALGEBRA.symbols
_ZERO, _ONE = ALGEBRA.constant(0), ALGEBRA.constant(1)
PRINTED: dict[str, dict[str, str]] = {
    "5-bpert-v": {"factor": "delta^4"},
    "5-perturbation": {
        "b'": "alpha3*y/2", "y'": "v", "v'": "g0 - alpha1*s*y/2", "third order": "g3 + alpha1/2*s*g1 - alpha3/2*g0",
    },
    "5-perturbation-theta": {"equation": "h3 - tau*h1 + beta*h0", "kappa cubed": "-alpha1/2"},
}  # fmt: skip
CORRECTED: dict[str, dict[str, str]] = {
    "5-bpert-v": {"factor": "1"},
}


def entries() -> list[Entry]:
    """The perturbation, in the order of the paper."""
    return [_bpert_v(), _perturbation(), _perturbation_theta()]


def _claim(identifier: str) -> Claim:
    return Claim(ALGEBRA, PRINTED[identifier], CORRECTED.get(identifier, {}))


def _bpert_v() -> Entry:
    this = _claim("5-bpert-v")

    def jets(parts: Parts) -> list[fmpq_mpoly]:
        # Without the hatted terms specialY must give y~' = v~; x1 is the derivative of y-bar.
        return [_SYMBOLS["x1"] - parts["factor"] * _SYMBOLS["x1"]]

    def example(parts: Parts) -> list[fmpq_mpoly]:
        terms = extended_terms(6, chi=True)
        s, delta = _SYMBOLS["s"], _SYMBOLS["delta"]

        def series(name: str) -> fmpq_mpoly:
            pieces = (
                ALGEBRA.bring(a) * s**k * delta**n for n, row in enumerate(terms[name]) for k, a in enumerate(row)
            )
            return sum(pieces, start=_ZERO)

        difference = series("y").derivative("s") - parts["factor"] * series("v")
        return [ALGEBRA.coefficient_of(difference, "delta", n) for n in range(6)]

    return settled(
        SECTION,
        "5-bpert-v",
        "line 2056",
        r"\tilde v=\epsilon^{4/3}\tilde{\bar v}(s,\epsilon^{1/3})+\epsilon^{2(\beta-1)/3}\hat v(s)",
        "The distinguished trajectory enters the scaled v with the factor ε^(4/3)",
        this.check("specialY without the hatted terms: y-bar' must be the distinguished part of v", jets),
        this.check("the extended example through δ⁵", example),
        corrected="v~ is the distinguished v~ plus ε^(2(β-1)/3) v^: no ε^(4/3) = δ⁴, which belongs to the unscaled v",
        note='The other three lines are consistent; "^{(2(β-1)/3}" in two of them has an unmatched parenthesis. '
        "In the findings x1 is the derivative of y-bar.",
    )


def _perturbation() -> Entry:
    this = _claim("5-perturbation")

    def derive(parts: Parts) -> list[fmpq_mpoly]:
        # specialB, specialY, specialV minus the distinguished trajectory, p = alpha1 s, lambda = -y/2.
        force = ALGEBRA.read("-y/2")
        images = {
            "s": _ONE,
            "g0": -_SYMBOLS["alpha3"] * force,
            "y": _SYMBOLS["v"],
            "v": _SYMBOLS["g0"] + ALGEBRA.read("alpha1*s") * force,
        }
        powers = [ALGEBRA.derivative(_SYMBOLS["g0"], images, k) for k in range(4)]
        lines = [parts["b'"] - images["g0"], parts["y'"] - images["y"], parts["v'"] - images["v"]]
        return [*lines, ALGEBRA.replaced(parts["third order"], "g", powers, _ONE)]

    def section_4(parts: Parts) -> list[fmpq_mpoly]:
        # -2 times the equation is eqn:de_inner; and the three lines give it with alpha3 y = 2 b'.
        inner = ALGEBRA.read(SECTION_4["4-inner-slow"]["equation"])
        force = put(parts["v'"], y="2*g1") - _SYMBOLS["g0"]  # times alpha3: g0 enters once
        third = 2 * _SYMBOLS["g3"] - _SYMBOLS["alpha3"] * _SYMBOLS["g0"] - force
        slope = 2 * parts["b'"] - _SYMBOLS["alpha3"] * _SYMBOLS["y"]
        return [inner + 2 * parts["third order"], third - 2 * parts["third order"], slope, parts["y'"] - _SYMBOLS["v"]]

    return settled(
        SECTION,
        "5-perturbation",
        "lines 2063 to 2071",
        r"\hat b'=\alpha_3^*\hat y/2,\ \hat y'=\hat v,\ \hat v'=\hat b-\alpha_1^*s\hat y/2;\quad "
        r"\hat b'''+\tfrac{\alpha_1^*}2s\hat b'-\tfrac{\alpha_3^*}2\hat b=0",
        "The equations of the perturbation, and the elimination of y and v",
        this.check(
            "specialB, specialY, specialV at leading order with λ_N = -y/2, and along this vector field", derive
        ),
        this.check("-2 times the result is eq. de_inner; elimination with α_3 y = 2 b'", section_4),
    )


def _perturbation_theta() -> Entry:
    this = _claim("5-perturbation-theta")
    printed = ALGEBRA.read(PRINTED["5-perturbation"]["third order"])

    def chain_rule(parts: Parts) -> list[fmpq_mpoly]:
        # g3 = kappa^3 h3 and s g1 = tau h1.
        value = parts["kappa cubed"] * _SYMBOLS["h3"] + ALGEBRA.read("alpha1/2*tau*h1 - alpha3/2*h0")
        return [put(value, alpha3="beta*alpha1") + ALGEBRA.read("alpha1/2") * parts["equation"]]

    def monomials(parts: Parts) -> list[fmpq_mpoly]:
        found, place = [parts["kappa cubed"] + _SYMBOLS["alpha1"] / 2], ALGEBRA.read("kappa*s")
        for j in range(5):
            b = [ALGEBRA.derivative(place**j, {"s": _ONE}, k) for k in range(4)]
            theta = [ALGEBRA.derivative(_SYMBOLS["tau"] ** j, {"tau": _ONE}, k) for k in range(4)]
            right = put(ALGEBRA.replaced(parts["equation"], "h", theta, _ZERO), tau="kappa*s")
            difference = ALGEBRA.replaced(printed, "g", b, _ZERO) + _SYMBOLS["alpha1"] / 2 * right
            found.append(put(put(difference, alpha3="beta*alpha1"), alpha1="-2*kappa^3"))
        return found

    return settled(
        SECTION,
        "5-perturbation-theta",
        "lines 2072 to 2083",
        r"\theta'''-\tau\theta'+\beta\theta=0,\hat b=b_0\kappa^{-\beta}\epsilon^{2\beta/3}\Theta(\kappa s,\beta)",
        "The perturbation satisfies eq. hypergeomeqn, and matches b_0 (-t)^β of the outer solution",
        this.check("chain rule", chain_rule),
        this.check("both operators on 1, s, ..., s⁴", monomials),
        Check(Rung.PAGE, "proofs/negative.md: Θ(τ, β) ~ (-τ)^β; the powers as in entry 4-matching", True),
        note="The matched b is the unscaled deviation: ε^(2β/3) times the hatted b of lines 2053 to 2071.",
    )
