"""Ledger of Section 4.5, second half: what follows in Cases I and II, and in Case III.

Formulas are closed forms, compared for all values of their symbols; a hypothesis is a parametrisation by positive
symbols (v: by a number in (0, 1)).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from flint import arb, fmpq

from gspot_verified.leading_order.iwc import leading_order_iwc
from gspot_verified.numbers.balls import float_bounds, rounded_text, sign_of, working_bits
from gspot_verified.numbers.verdict import Outcome
from gspot_verified.paper.appendix_a import hypergeometric as appendix
from gspot_verified.paper.appendix_a.theta_pages import IWC, SIGNS_INTEGRAL, SIGNS_RIGHT
from gspot_verified.paper.checks.closed_forms import ClosedForm, rational
from gspot_verified.paper.checks.entry import Builders, Check, Entry, Rung, Section, all_of, same_sign
from gspot_verified.paper.checks.formulas import Forms, FormulaClaim, closed_form, evaluate_text, mended, put, quotient
from gspot_verified.paper.checks.gamma_cells import induction
from gspot_verified.paper.checks.identities import in_greek
from gspot_verified.paper.section_4.section_4_inner import PRINTED as INNER
from gspot_verified.paper.section_4.section_4_matching import PRINTED as MATCHING
from gspot_verified.paper.section_4_5 import growth, lift_off
from gspot_verified.paper.section_4_5.section_4_5 import CORRECTED as CORRECTED_FORCE
from gspot_verified.paper.section_4_5.section_4_5 import PRINTED as FORCE
from gspot_verified.signs.cover.sign import sign as sign_on_ranges
from gspot_verified.signs.gamma.side import side as side_switching
from gspot_verified.theta_function.value.evaluate import evaluate

SECTION = Section("Section 4.5")
PRINTED: dict[str, dict[str, str]] = {
    "S-iwc": {"sign": "-1"},
    "S-wording": {
        "at 0": appendix.ENTIRE_INITIAL_VALUES["t01"],
        "far left": appendix.THETA["small leading"],
        "far right": appendix.THETA["large leading"],
    },
    "S-side": {"side": "C_1/Gamma(-beta)"},
    "S-iwc-case-III": {"side": "C_1/Gamma(-beta)"},
    "S-switching": {"function": "Gamma(-beta)"},
}
CORRECTED: dict[str, dict[str, str]] = {
    "S-wording": {
        "at 0": appendix.ENTIRE_INITIAL_VALUES["t02"],
        "far left": "-beta*x^(beta-1)",
        "far right": "-sqrt(pi)*beta/Gamma(1-beta)*e^(2/3*lam)*tau^(-(beta-1)/2-3/4)",
    }
}
"""S-wording speaks of Θ; what it says holds for dΘ/dτ = -β Θ(τ, β - 1)."""
CASE_III = {"beta": "1+u", "alpha1": "-w", "alpha2": "-x", "alpha3": "-(1+u)*w"}
HYPOTHESES: dict[str, dict[str, str]] = {
    "S-iwc": {"beta": "v"},
    "S-wording": {"beta": "v"},
    "S-side": CASE_III,
    "S-iwc-case-III": dict(CASE_III),
    "S-growth": {"beta": "1+u"},
}
BETA_RANGE = {"S-iwc": "0..1"}
SIDE_BETAS = (fmpq(3, 2), fmpq(5, 2), fmpq(7, 2), fmpq(9, 2), fmpq(7, 3))
IWC_BETAS = (fmpq(3, 2), fmpq(7, 3), fmpq(7, 2), fmpq(9, 2), fmpq(13, 2))
BELOW = fmpq(99, 100)
"""The ε that is tried is this share of the found ε_0."""
_ANSWERS = {Outcome.PROVED: True, Outcome.REFUTED: False, Outcome.UNDECIDED: None}


def _claim(identifier: str) -> FormulaClaim:
    claim = FormulaClaim(PRINTED[identifier], CORRECTED.get(identifier, {}))
    return claim.under(**HYPOTHESES.get(identifier, {}))


def _iwc() -> Entry:
    images = HYPOTHESES["S-iwc"]
    sign = sign_of(appendix.value_of(PRINTED["S-iwc"]["sign"], fmpq(1, 2), 64)) or 0
    cover = sign_on_ranges("-inf..inf", BETA_RANGE["S-iwc"], sign)
    pieces = [piece.kind.value for column in cover.columns for piece in column.pieces]
    return SECTION.settled(
        "S-iwc",
        "lines 1278 to 1291 (Cases I and II)",
        r"\frac{d\Theta}{d\tau}(\tau,\beta)<0\quad(\tau\in\mathbb R,\ 0<\beta<1)",
        "For 0 < β < 1 the derivative dΘ/dτ is negative at every real τ",
        SIGNS_INTEGRAL.carries(
            _claim("S-iwc").check_sign(
                "first proof: Γ(-β) dΘ/dτ is an integral with positive integrand, which converges for "
                "β < 1; Γ(-β) has the sign for every β in (0, 1)",
                lambda forms: [
                    closed_form(put("Gamma(-beta)", **images)) / forms["sign"],
                    closed_form(put("1-beta", **images)),
                ],
            )
        ),
        Rung.BALLS.check(
            "second proof: positive Taylor coefficients for τ >= 0, the enveloping series far left, a cover by Taylor "
            "models on boxes between",
            _ANSWERS[cover.verdict.outcome],
            "pieces from τ = −∞ to +∞: " + ", ".join(pieces),
        ),
        note='The paper has the sign for τ large, for τ = 0 and in numbers: "strong evidence that an impact must '
        'occur, although not quite a proof". With C_1 < 0 and S-deviation-force the deviation of the force is then '
        "positive for every τ at leading order; that it grows and outweighs the mean: S-plus-infinity, S-dominance. "
        "The impact in the compliant model: C-cases-I-II.",
    )


def is_the_derivative() -> bool | None:
    """Whether each corrected form is -β times that of Θ at β - 1, for a symbol β: dΘ/dτ is -β Θ(τ, β - 1)."""
    of_theta = {
        "at 0": appendix.ENTIRE_INITIAL_VALUES["t01"],
        "far left": appendix.THETA["small leading"],
        "far right": appendix.THETA["large leading"],
    }
    corrected = CORRECTED["S-wording"]
    return all(
        quotient(closed_form(corrected[name]), closed_form(f"-beta*({put(text, beta='beta-1')})")).is_one()
        for name, text in of_theta.items()
    )


def _theta_wording() -> Entry:
    places, beta = (-20, 0), fmpq(3, 10)
    values = [evaluate(tau, beta).value for tau in places]
    slopes = [evaluate(tau, beta, derivative=1).value for tau in (*places, 20)]

    def all_negative(forms: Forms) -> list[ClosedForm]:
        return [rational(-1) * form for form in forms.values()]

    vanishing = closed_form(put(CORRECTED["S-wording"]["far left"], **HYPOTHESES["S-wording"])).exponent("x")
    by_forms = _claim("S-wording").check_sign(
        "the entire form of Θ(0) and the leading forms (-τ)^β and eq. tlarge, for every β in (0, 1); "
        "the same for dΘ/dτ = -β Θ(τ, β - 1), with a negative power of -τ as τ → −∞",
        lambda forms: [*all_negative(forms), rational(-vanishing)],
        finding="Θ(0) > 0 and (-τ)^β > 0 for every β in (0, 1); dΘ/dτ is negative at all three places",
    )
    return SECTION.settled(
        "S-wording",
        "line 1287",
        r"\Theta \text{ is very negative for large } |\tau| \text{ and for } \tau=0",
        "For 0 < β < 1, Θ is negative for large |τ| and for τ = 0",
        by_forms if is_the_derivative() else replace(by_forms, agrees=None),
        Rung.BALLS.check(
            "Θ(-20, 3/10) and Θ(0, 3/10)",
            mended(_negative(values), _negative(slopes)),
            f"Θ > 0 at τ = {places[0]} and τ = {places[1]}, dΘ/dτ < 0 there and at τ = 20",
        ),
        corrected="it is dΘ/dτ that is negative there, and very negative only for τ → +∞: dΘ/dτ → 0 as τ → −∞, like "
        f"{in_greek(CORRECTED['S-wording']['far left']).replace('*', ' ')}, x = -τ",
    )


def _negative(values: Sequence[arb]) -> bool | None:
    return all_of(same_sign(sign_of(value), -1) for value in values)


def _force_far_right(identifier: str, side: ClosedForm) -> list[ClosedForm]:
    """λ_N as τ → +∞: the deviation over the side, its growth, the mean force, and κ³, under the hypotheses."""
    images = HYPOTHESES[identifier]
    slope = f"-beta*({put(appendix.THETA['large leading'], beta='beta-1')})"
    deviation = closed_form(put(put(FORCE["S-deviation-force"]["force"], slope=slope), **images))
    mean = closed_form(put(CORRECTED_FORCE["S-mean-force"]["force"], **images))
    cube = closed_form(put(INNER["4-theta"]["kappa cubed"], **images))
    return [deviation / side, rational(deviation.exponent("e")), mean, cube]


def _lift_off_side() -> Entry:
    answers = []
    for beta in SIDE_BETAS:
        slope = evaluate(60, beta, derivative=1).value
        for c_1 in (fmpq(-1), fmpq(1)):
            values: dict[str, fmpq | arb] = {
                "C_1": c_1,
                "beta": beta,
                "alpha1": fmpq(-1),
                "alpha2": fmpq(-1),
                "alpha3": -beta,
            }
            values |= {"kappa": fmpq(1), "epsilon": fmpq(1, 10**6), "slope": slope}
            mean = evaluate_text(CORRECTED_FORCE["S-mean-force"]["force"], values, 64).real
            deviation = evaluate_text(FORCE["S-deviation-force"]["force"], values, 64).real
            side = evaluate_text(PRINTED["S-side"]["side"], values, 64).real
            with working_bits(64):
                answers.append(same_sign(sign_of(mean + deviation), sign_of(side)))
    return SECTION.settled(
        "S-side",
        "line 1299 (Case III)",
        r"C_1/\Gamma(-\beta)<0",
        "In Case III, β not an integer, at leading order with the corrected mean force (S-mean-force), the contact "
        "lifts off when C_1/Γ(-β) < 0: λ_N becomes negative for τ large, and stays positive there for the other sign",
        SIGNS_RIGHT.carries(
            _claim("S-side").check_sign(
                "τ → +∞: S-deviation-force with the leading form of dΘ/dτ over C_1/Γ(-β) is positive and grows without "
                "bound; the corrected mean force and κ are positive (Case III, symbols α_1, α_2, β)",
                lambda forms: _force_far_right("S-side", forms["side"]),
            )
        ),
        Rung.POINTS.check(
            "certified sign of λ_N at τ = 60, ε = 1e-6, both signs of C_1, five values of β", all_of(answers)
        ),
        note="At leading order and for τ large; for all τ see S-iwc-case-III, for the compliant model C-lift-off.",
    )


def _other_side() -> Entry:
    results = {beta: leading_order_iwc(beta) for beta in IWC_BETAS}
    bounds = {beta: result.epsilon_0 for beta, result in results.items() if result.epsilon_0 is not None}
    sides = [
        sign_of(evaluate_text(PRINTED["S-iwc-case-III"]["side"], {"C_1": found.force.c1, "beta": beta}, 64).real)
        for beta, found in results.items()
    ]
    holds = all_of(
        _ANSWERS[leading_order_iwc(beta, epsilon=bound * BELOW).verdict.outcome] for beta, bound in bounds.items()
    )
    images = HYPOTHESES["S-iwc-case-III"]
    power = closed_form(put(FORCE["S-dominance"]["exponent"], **images))
    return SECTION.settled(
        "S-iwc-case-III",
        "lines 1304 to 1305 (Case III)",
        r"\text{the other sign of }C_1\Gamma(-\beta):\ \text{strong evidence that an IWC occurs}",
        "In Case III, β not an integer, C_1/Γ(-β) > 0, at leading order with the corrected mean force "
        "(S-mean-force): on every half-line [τ_0, ∞) the contact force λ_N is positive for all ε below an explicit "
        "ε_0",
        IWC.carries(
            _claim("S-iwc-case-III").check_sign(
                "C_1 dΘ/dτ is bounded below on [τ_0, ∞), since it tends to infinity with the sign of "
                "C_1/Γ(-β); the mean force, κ and the exponent of ε are positive (Case III, symbols α_1, α_2, β)",
                lambda forms: [*_force_far_right("S-iwc-case-III", forms["side"]), power],
            )
        ),
        Rung.POINTS.check(
            "certified minimum of C_1 dΘ/dτ on [-10, ∞) from all its critical points, at five values of β; "
            "α_1 = α_2 = -1, |C_1| = 1",
            all_of([holds, *(same_sign(side, 1) for side in sides)]) if len(bounds) == len(results) else None,
            "; ".join(f"β = {b}: ε_0 >= {rounded_text(float_bounds(arb(e))[0], -1, 4)}" for b, e in bounds.items()),
        ),
        note='The paper: "we are in the same situation as in above where there is strong evidence that an IWC occurs". '
        "ε_0 depends on τ_0 for odd ⌊β⌋: C_1 dΘ/dτ → −∞ as τ → −∞. For the compliant model: C-iwc-case-III.",
    )


def _rising(law: Check, positive: Check) -> Check:
    """A check of the law that holds where its rate and its power are positive too."""
    agrees = all_of([law.agrees, positive.agrees])
    return replace(law, agrees=agrees, finding=law.finding or positive.finding)


def _growth() -> Entry:
    claim = FormulaClaim(lift_off.PRINTED["S-growth"])
    brackets = lift_off.growth_brackets()
    leading = closed_form(put(appendix.THETA["large leading"], beta="beta-1"))
    exponent = closed_form(FORCE["S-deviation-force"]["force"]).exponent("epsilon")
    by_saddle = claim.check(
        "last section, first proof: (2/3) τ^(3/2) = ((2 β - 2)/3) ln(1/ε) with the exponents of eq. tlarge and of "
        "S-deviation-force, for a symbol β > 1",
        lambda forms: [
            closed_form("3/2") * forms["power"],
            rational(leading.exponent("e")) / closed_form("lam") * forms["rate"] / rational(exponent),
        ],
    )
    by_means = claim.check(
        "last section, second proof: the logarithmic derivative of dΘ/dτ is asymptotic to sqrt(τ), so that τ^(3/2) is "
        "3/2 times the exponent of λ_N in 4-exponents times ln(1/ε), for a symbol β > 1",
        lambda forms: [
            closed_form(f"1+{growth.ROOT}") * forms["power"],
            closed_form(f"(1+{growth.ROOT})*({MATCHING['4-exponents']['lambda']})/3") / forms["rate"],
        ],
    )
    positive = claim.under(**HYPOTHESES["S-growth"]).check_sign(
        "the rate and the power are positive", lambda forms: list(forms.values())
    )
    return SECTION.settled(
        "S-growth",
        "line 1302",
        r"\tau_{\text{lift-off}}\sim\log(\varepsilon)^{2/3}",
        "In Case III, β not an integer, C_1/Γ(-β) < 0, at leading order, the lift-off time, the last zero of λ_N, "
        "grows like |log ε|^(2/3) as ε → 0",
        SIGNS_RIGHT.carries(_rising(by_saddle, positive)),
        growth.GROWS.carries(_rising(by_means, positive)),
        Rung.POINTS.check(
            "certified brackets of a zero of λ_N beyond τ = 2, four ε for each of two β: the smaller ε, the nearer "
            "is its ratio to the law to 1",
            all_of(True if bracket.closer_than_before else None for bracket in brackets),
            "; ".join(str(bracket) for bracket in brackets),
        ),
        corrected=f"τ_lift-off ~ (({in_greek(claim.printed['rate'])}) ln(1/ε))^({claim.printed['power']}); log(ε) is "
        "negative, read |log(ε)|",
    )


def _switching() -> Entry:
    found = side_switching("1/2", "61/2")
    alternate = all(a.sign == -b.sign for a, b in zip(found.intervals, found.intervals[1:], strict=False))
    function = PRINTED["S-switching"]["function"]
    middles = [(i.lower + i.upper) / 2 for i in found.intervals]
    signs = [sign_of(appendix.value_of(function, fmpq(*beta.as_integer_ratio()), 64)) for beta in middles]
    by_ball = all_of(same_sign(sign, i.sign) for sign, i in zip(signs, found.intervals, strict=True))
    return SECTION.settled(
        "S-switching",
        "line 1309",
        r"\Gamma(-\beta)\text{ changes sign at every positive integer}",
        "Γ(-β), whose sign decides the side of lift-off in Case III at leading order (S-side), changes sign whenever β "
        "passes through a positive integer: for β > 0 it is positive for odd ⌊β⌋ and negative for even ⌊β⌋",
        _claim("S-switching").check_sign(
            "functional equation of Γ: the sign on (m, m + 1) is (-1)^(m + 1), by induction on m, the step for a "
            "symbol β (proofs/side_switching.md)",
            lambda _: induction(function),
        ),
        Rung.POINTS.check(
            "the intervals of [1/2, 61/2] alternate, and an enclosure of Γ(-β) at each midpoint has their sign",
            all_of([alternate and found.integers == tuple(range(1, 31)), by_ball]),
        ),
    )


ENTRIES: Builders = {
    "S-iwc": _iwc,
    "S-wording": _theta_wording,
    "S-side": _lift_off_side,
    "S-iwc-case-III": _other_side,
    "S-growth": _growth,
    "S-switching": _switching,
}
"""The statements on Cases I, II and III, in the order of the paper."""
