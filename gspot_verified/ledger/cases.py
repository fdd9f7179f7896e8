"""Ledger of Section 4.5, second half: what follows in Cases I and II, and in Case III."""

from __future__ import annotations

from flint import arb, fmpq

from gspot_verified.balls import approximate, sign_of, working_bits
from gspot_verified.ledger.entry import Check, Entry, Rung, all_of, same_sign, settled
from gspot_verified.ledger.lift_off import growth_brackets
from gspot_verified.signs.iwc import iwc
from gspot_verified.signs.side import gamma_sign, gamma_sign_by_ball, side_switching
from gspot_verified.signs.sign import sign_on_ranges
from gspot_verified.theta_function.evaluate import evaluate
from gspot_verified.verdict import Outcome

SECTION = "Section 4.5"


def entries() -> list[Entry]:
    """The statements on Cases I, II and III, in the order of the paper."""
    return [_iwc(), _theta_wording(), _lift_off_side(), _other_side(), _growth(), _switching()]


def _iwc() -> Entry:
    cover = sign_on_ranges("-inf..inf", "0..1")
    pieces = [piece.kind.value for column in cover.columns for piece in column.pieces]
    return settled(
        SECTION,
        "S-iwc",
        "line 1278 (Cases I and II)",
        r"\frac{d\Theta}{d\tau}(\tau,\beta)<0\quad(\tau\in\mathbb R,\ 0<\beta<1)",
        "For 0 < β < 1, dΘ/dτ < 0 for every real τ",
        Check(Rung.PAGE, "proofs/signs.md, first proof: positive integrand", True),
        Check(
            Rung.BALLS,
            "second proof: positive Taylor coefficients for τ >= 0, enveloping series for τ <= -2^(1/3), "
            "a cover by Taylor models on boxes between",
            True if cover.verdict.outcome is Outcome.PROVED else None,
            "pieces from τ = −∞ to +∞: " + ", ".join(pieces),
        ),
        note='The paper calls this "strong evidence, although not quite a proof". With C_1 < 0 and '
        "S-deviation-force the deviation of the force is then positive for every τ at leading order: "
        "an impact without collision.",
    )


def _theta_wording() -> Entry:
    far, near = evaluate(-20, "3/10"), evaluate(0, "3/10")
    return settled(
        SECTION,
        "S-wording",
        "line 1287",
        r"\Theta \text{ is very negative for large } |\tau| \text{ and for } \tau=0",
        "For 0 < β < 1, Θ is negative for large |τ| and for τ = 0",
        Check(
            Rung.EXACT,
            "Θ(0) = c/(Γ((1-β)/3) Γ((2-β)/3)): both arguments positive at β = 0 and at β = 1 - 1/1000, linear between",
            False if all((j - beta) / 3 > 0 for j in (1, 2) for beta in (fmpq(0), fmpq(999, 1000))) else None,
            "Θ(0) > 0 for 0 < β < 1",
        ),
        Check(
            Rung.BALLS,
            "Θ(-20, 3/10) and Θ(0, 3/10)",
            False if sign_of(far.value) == 1 and sign_of(near.value) == 1 else None,
            f"{far} and {near}",
        ),
        corrected="it is dΘ/dτ that is negative there, and very negative only for τ → +∞: dΘ/dτ → 0 as τ → −∞",
    )


def _lift_off_side() -> Entry:
    answers = []
    for beta in (fmpq(3, 2), fmpq(5, 2), fmpq(7, 2), fmpq(9, 2), fmpq(7, 3)):
        slope = evaluate(60, beta, derivative=1).value
        for c_1 in (-1, 1):
            with working_bits(64):  # alpha_3 = -beta, kappa = 1, epsilon = 10^-6, mean force 1/(beta - 1)
                force = 1 / arb(beta - 1) + c_1 / arb(beta) * arb(10) ** arb(-6 * (2 * beta - 2) / 3) * slope
            answers.append(same_sign(sign_of(force), -1 if c_1 * (gamma_sign(beta) or 0) < 0 else 1))
    agrees = all_of(answers)
    return settled(
        SECTION,
        "S-side",
        "line 1299 (Case III)",
        r"C_1/\Gamma(-\beta)<0",
        "For β > 1 not an integer, at leading order, the contact lifts off when C_1/Γ(-β) < 0: "
        "λ_N becomes negative for τ large, and stays positive there for the other sign",
        Check(Rung.PAGE, "proofs/signs.md (τ → +∞) with S-deviation-force and the corrected S-mean-force", True),
        Check(
            Rung.POINTS,
            "certified sign of λ_N at τ = 60, ε = 1e-6, both signs of C_1, five values of β",
            agrees,
        ),
        note="At leading order and for τ large; for all τ of a half-line see S-iwc-case-III.",
    )


def _other_side() -> Entry:
    betas = ("3/2", "7/3", "7/2", "9/2", "13/2")
    results = {beta: iwc(beta) for beta in betas}
    bounds = {beta: result.epsilon_0 for beta, result in results.items() if result.epsilon_0 is not None}
    holds = all_of(
        True if iwc(beta, epsilon=bound * fmpq(99, 100)).verdict.outcome is Outcome.PROVED else None
        for beta, bound in bounds.items()
    )
    return settled(
        SECTION,
        "S-iwc-case-III",
        "line 1303 (Case III)",
        r"\hat\lambda_N>0\quad(C_1/\Gamma(-\beta)>0)",
        "For β > 1 not an integer and C_1/Γ(-β) > 0, at leading order: on every half-line [τ_0, ∞) the contact force "
        "λ_N is positive for all ε below an explicit ε_0",
        Check(Rung.PAGE, "proofs/iwc.md: C_1 dΘ/dτ is bounded below on [τ_0, ∞)", True),
        Check(
            Rung.BALLS,
            "certified minimum of C_1 dΘ/dτ on [-10, ∞) from all its critical points; α_1 = α_2 = -1, |C_1| = 1",
            holds if len(bounds) == len(betas) else None,
            "; ".join(f"β = {beta}: ε_0 >= {approximate(bound):.4g}" for beta, bound in bounds.items()),
        ),
        note='The paper: "we are in the same situation as in above where there is strong evidence that an IWC occurs". '
        "ε_0 depends on τ_0 when ⌊β⌋ is odd: there C_1 dΘ/dτ → −∞ as τ → −∞.",
    )


def _growth() -> Entry:
    brackets = growth_brackets()
    ratios = "; ".join(str(bracket) for bracket in brackets)
    return settled(
        SECTION,
        "S-growth",
        "line 1302",
        r"\tau_{\text{lift-off}}\sim\log(\varepsilon)^{2/3}",
        "The lift-off time grows like |log ε|^(2/3) as ε → 0",
        Check(Rung.PAGE, "proofs/signs.md, last section", True),
        Check(
            Rung.POINTS,
            "certified brackets of a zero of λ_N beyond τ = 2: its ratio to ((β-1) ln(1/ε))^(2/3) tends to 1",
            True if all(bracket.closer_than_before for bracket in brackets) else None,
            ratios,
        ),
        corrected="τ_lift-off ~ ((β - 1) ln(1/ε))^(2/3); log(ε) is negative, read |log(ε)|",
    )


def _switching() -> Entry:
    found = side_switching("1/2", "61/2")
    alternate = all(a.sign == -b.sign for a, b in zip(found.intervals, found.intervals[1:], strict=False))
    by_ball = all_of(same_sign(gamma_sign_by_ball((i.lower + i.upper) / 2), i.sign) for i in found.intervals)
    return settled(
        SECTION,
        "S-switching",
        "line 1309",
        r"\Gamma(-\beta)\text{ changes sign at every positive integer}",
        "Γ(-β) changes sign whenever β passes through a positive integer, so the side of lift-off switches there",
        Check(Rung.PAGE, "proofs/side_switching.md", True),
        Check(
            Rung.EXACT, "the intervals of [1/2, 61/2] alternate", alternate and found.integers == tuple(range(1, 31))
        ),
        Check(Rung.POINTS, "an enclosure of 1/Γ(-β) at each midpoint", by_ball),
    )
