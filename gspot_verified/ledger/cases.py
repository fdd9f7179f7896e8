"""Ledger of Section 4.5, second half: what follows in Cases I and II, and in Case III."""

from __future__ import annotations

from flint import arb, fmpq

from gspot_verified.balls import sign_of, working_bits
from gspot_verified.ledger.entry import Check, Entry, Kind, all_of, same_sign, settled
from gspot_verified.ledger.iwc_cover import cover_compact_piece, left_piece_reaches, right_piece_is_positive
from gspot_verified.ledger.lift_off import growth_brackets
from gspot_verified.signs.side import gamma_sign, gamma_sign_by_ball, side_switching
from gspot_verified.theta.evaluate import evaluate

SECTION = "Section 4.5"


def entries() -> list[Entry]:
    """The statements on Cases I, II and III, in the order of the paper."""
    return [_iwc(), _theta_wording(), _lift_off_side(), _growth(), _switching()]


def _iwc() -> Entry:
    cover = cover_compact_piece()
    pieces = left_piece_reaches() and right_piece_is_positive()
    return settled(
        SECTION,
        "S-iwc",
        "line 1278 (Cases I and II)",
        r"\frac{d\Theta}{d\tau}(\tau,\beta)<0\quad(\tau\in\mathbb R,\ 0<\beta<1)",
        "For 0 < beta < 1, dTheta/dtau < 0 for every real tau",
        Check(Kind.PROOF, "proofs/signs.md, first proof: positive integrand", True),
        Check(
            Kind.BALLS,
            "second proof: positive Taylor coefficients for tau >= 0, enveloping series for tau <= -2^(1/3), "
            "a cover by boxes between",
            True if cover.complete and pieces else None,
            f"{len(cover.positive)} boxes, {len(cover.remaining)} left",
        ),
        note='The paper calls this "strong evidence, although not quite a proof". With C_1 < 0 and '
        "S-deviation-force the deviation of the force is then positive for every tau at leading order: "
        "an impact without collision.",
    )


def _theta_wording() -> Entry:
    far, near = evaluate(-20, "3/10"), evaluate(0, "3/10")
    return settled(
        SECTION,
        "S-wording",
        "line 1287",
        r"\Theta \text{ is very negative for large } |\tau| \text{ and for } \tau=0",
        "For 0 < beta < 1, Theta is negative for large |tau| and for tau = 0",
        Check(
            Kind.EXACT,
            "Theta(0) = c/(Gamma((1-beta)/3) Gamma((2-beta)/3)): both arguments positive at beta = 0 "
            "and at beta = 1 - 1/1000, linear between",
            False if all((j - beta) / 3 > 0 for j in (1, 2) for beta in (fmpq(0), fmpq(999, 1000))) else None,
            "Theta(0) > 0 for 0 < beta < 1",
        ),
        Check(
            Kind.BALLS,
            "Theta(-20, 3/10) and Theta(0, 3/10)",
            False if sign_of(far.value) == 1 and sign_of(near.value) == 1 else None,
            f"{far} and {near}",
        ),
        corrected="it is dTheta/dtau that is negative there, and very negative only for tau -> +oo: "
        "dTheta/dtau -> 0 as tau -> -oo",
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
        "For beta > 1 not an integer, at leading order, the contact lifts off when C_1/Gamma(-beta) < 0: "
        "lambda_N becomes negative for tau large, and stays positive there for the other sign",
        Check(Kind.PROOF, "proofs/signs.md (tau -> +oo) with S-deviation-force and the corrected S-mean-force", True),
        Check(
            Kind.POINTS,
            "certified sign of lambda_N at tau = 60, epsilon = 1e-6, both signs of C_1, five values of beta",
            agrees,
        ),
        note="At leading order and for tau large; the claim for all tau and beta > 1 is not decided here.",
    )


def _growth() -> Entry:
    brackets = growth_brackets()
    ratios = "; ".join(str(bracket) for bracket in brackets)
    return settled(
        SECTION,
        "S-growth",
        "line 1302",
        r"\tau_{\text{lift-off}}\sim\log(\varepsilon)^{2/3}",
        "The lift-off time grows like |log epsilon|^(2/3) as epsilon -> 0",
        Check(Kind.PROOF, "proofs/signs.md, last section", True),
        Check(
            Kind.POINTS,
            "certified brackets of a zero of lambda_N beyond tau = 2: "
            "its ratio to ((beta-1) ln(1/eps))^(2/3) tends to 1",
            True if all(bracket.closer_than_before for bracket in brackets) else None,
            ratios,
        ),
        corrected="tau_lift-off ~ ((beta - 1) ln(1/epsilon))^(2/3); log(epsilon) is negative, read |log(epsilon)|",
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
        "Gamma(-beta) changes sign whenever beta passes through a positive integer, so the side of lift-off "
        "switches there",
        Check(Kind.PROOF, "proofs/side_switching.md", True),
        Check(
            Kind.EXACT, "the intervals of [1/2, 61/2] alternate", alternate and found.integers == tuple(range(1, 31))
        ),
        Check(Kind.POINTS, "an enclosure of 1/Gamma(-beta) at each midpoint", by_ball),
    )
