"""Ledger of Section 4.5: the sign of dTheta/dtau at minus infinity, 0 and infinity, and the sign of Gamma(-beta).

Formulas are closed forms, compared for all values of their symbols.
"""

from __future__ import annotations

from flint import arb, fmpq

from gspot_verified.numbers.balls import ball_text, sign_of, working_bits
from gspot_verified.paper.appendix_a import hypergeometric as appendix
from gspot_verified.paper.appendix_a.theta_pages import INITIAL_VALUES, SIGNS_LEFT, SIGNS_RIGHT
from gspot_verified.paper.checks.closed_forms import ClosedForm, rational
from gspot_verified.paper.checks.entry import Builders, Entry, Rung, Section, all_of, same_sign
from gspot_verified.paper.checks.formulas import FormulaClaim, closed_form, mended, put, quotient, rational_value
from gspot_verified.paper.checks.gamma_cells import induction, is_cell, sign_on_cell
from gspot_verified.paper.checks.identities import in_greek
from gspot_verified.paper.checks.words import Place, held_against
from gspot_verified.signs.cover.tails import left_threshold
from gspot_verified.signs.gamma.side import gamma_sign_by_ball
from gspot_verified.theta_function.value.evaluate import evaluate

SECTION = Section("Section 4.5")
PRINTED: dict[str, dict[str, str]] = {
    "S-minus-infinity": {"sign": "-1"},
    "S-zero": {"sign of": "Gamma((1-beta)/3)/Gamma(-beta)"},
    "S-plus-infinity": {"sign of": "1/Gamma(-beta)"},
    "S-gamma-intervals": {
        "negative from": "2*n-1", "negative to": "2*n", "positive from": "2*n-2", "positive to": "2*n",
    },
}  # fmt: skip
CORRECTED: dict[str, dict[str, str]] = {
    "S-gamma-intervals": {
        "negative from": "2*n-2", "negative to": "2*n-1", "positive from": "2*n-1", "positive to": "2*n",
    },
}  # fmt: skip
AT_INTEGERS: dict[str, dict[str, str]] = {
    "S-zero": {"0": "0", "1": "-1", "2": "0"},
    "S-plus-infinity": {"leading": "(-1)^n*n*tau^(n-1)"},
}
"""What holds at integers β, where the printed quotients say nothing: S-zero by β mod 3, S-plus-infinity at β = n."""
HYPOTHESES: dict[str, dict[str, str]] = {"S-minus-infinity": {"beta": "u"}}
"""u is positive: β > 0."""
_RELATION = {"-1": "<", "0": "=", "1": ">"}
NAMED = "lines 1262 to 1271"
NAME = Place("line 1268", r"Here \$(\\?[A-Za-z]+)\$ represents the Gamma function")
USED = (
    Place("eq. dTheta_sign", r"has sign of \}\\frac\{(\\?[A-Za-z]+)\\left"),
    Place("the next sentence", r"that \$(\\?[A-Za-z]+)\(-\\beta\)\$ is negative"),
)
"""What the Gamma function is called."""
GRID = tuple(fmpq(n, 10) for n in range(1, 130))
NOT_INTEGER = tuple(beta for beta in GRID if beta.q != 1)


def _sign_at_minus_infinity() -> Entry:
    claim = FormulaClaim(PRINTED["S-minus-infinity"]).under(**HYPOTHESES["S-minus-infinity"])
    leading = f"-beta*({put(appendix.THETA['small leading'], beta='beta-1')})"
    sign = PRINTED["S-minus-infinity"]["sign"]
    # At tau = -T(beta) itself, T from proofs/signs.md rounded up.
    agrees = all_of(
        same_sign(
            sign_of(evaluate(-_threshold(beta), beta, derivative=1).value), sign_of(appendix.value_of(sign, beta, 64))
        )
        for beta in GRID
    )
    return SECTION.settled(
        "S-minus-infinity",
        "eq:dTheta_sign, first row",
        r"\frac{d\Theta}{d\tau}<0\ (\tau\to-\infty)",
        "dΘ/dτ is negative for τ large and negative, for every β > 0",
        SIGNS_LEFT.carries(
            claim.check_sign(
                "an explicit T(β), from the enveloping series of -β Θ(τ, β - 1), whose first term "
                "-β (-τ)^(β-1) has the sign for every β > 0",
                lambda forms: [closed_form(put(leading, **HYPOTHESES["S-minus-infinity"])) / forms["sign"]],
            )
        ),
        Rung.POINTS.check("certified sign at -T(β) for β = 0.1, 0.2, ..., 12.9", agrees),
    )


def _threshold(beta: fmpq) -> fmpq:
    """An integer T with dTheta/dtau < 0 on (-oo, -T], by the statement of the proof page."""
    b = beta - 1
    return left_threshold(b, b, int(b.floor()), denominator=1)


def _sign_at_zero() -> Entry:
    claim = FormulaClaim(PRINTED["S-zero"])
    text = PRINTED["S-zero"]["sign of"]
    agrees = all_of(
        same_sign(sign_of(appendix.value_of(text, beta, 128)), sign_of(evaluate(0, beta, derivative=1).value))
        for beta in NOT_INTEGER
    )
    at_integers = AT_INTEGERS["S-zero"]
    integers = all_of(
        same_sign(sign_of(evaluate(0, n, derivative=1).value), int(rational_value(at_integers[str(n % 3)]).p))
        for n in range(1, 16)
    )
    return SECTION.settled(
        "S-zero",
        "eq:dTheta_sign, second row",
        r"\operatorname{sign}\frac{d\Theta}{d\tau}(0)=\operatorname{sign}\frac{\Gamma((1-\beta)/3)}{\Gamma(-\beta)}",
        "At τ = 0 dΘ/dτ has the sign of Γ((1-β)/3)/Γ(-β), for β not an integer",
        claim.check_sign(
            "t02 over that quotient is a power of 3, for a symbol β",
            lambda forms: [closed_form(appendix.INITIAL_VALUES["t02"]) / forms["sign of"]],
        ),
        claim.check_sign(
            "the entire form of Θ'(0) over it is positive, by Gauss's multiplication formula, for a symbol β",
            lambda forms: [closed_form(appendix.ENTIRE_INITIAL_VALUES["t02"]) / forms["sign of"]],
        ),
        Rung.POINTS.check("both signs certified at β = 0.1, ..., 12.9 without the integers", agrees),
        Rung.POINTS.check(
            "at integers: the coefficient of τ in Θ(τ, 3 m + 1) for all m >= 0, and the exact values at β = 1, ..., 15",
            integers if _coefficient_at_integers().sign() == 1 else None,
        ),
        corrected="at β = 1, 4, 7, ... the quotient is infinite over infinite: there dΘ/dτ(0) "
        f"{_RELATION[at_integers['1']]} 0; at β = 2, 5, ... dΘ/dτ(0) {_RELATION[at_integers['2']]} 0, "
        f"at β = 3, 6, ... dΘ/dτ(0) {_RELATION[at_integers['0']]} 0",
    )


def _coefficient_at_integers() -> ClosedForm:
    """The coefficient of τ^1 at n = 3m + 1 over the stated sign; at the other n there is no power τ^1."""
    term = put(appendix.INTEGER_POLYNOMIAL, n="3*m+1", tau="1")
    return quotient(closed_form(term), closed_form(AT_INTEGERS["S-zero"]["1"]))


def _sign_at_infinity() -> Entry:
    claim = FormulaClaim(PRINTED["S-plus-infinity"])
    text = PRINTED["S-plus-infinity"]["sign of"]
    growth = closed_form(f"-beta*({put(appendix.THETA['large leading'], beta='beta-1')})")
    agrees = all_of(
        same_sign(sign_of(evaluate(60, beta, derivative=1).value), sign_of(appendix.value_of(text, beta, 64)))
        for beta in NOT_INTEGER
    )
    leading = closed_form(f"({put(appendix.INTEGER_POLYNOMIAL, m='0')})*n/tau")
    at_integers = AT_INTEGERS["S-plus-infinity"]["leading"]
    return SECTION.settled(
        "S-plus-infinity",
        "eq:dTheta_sign, third row",
        r"\frac{d\Theta}{d\tau}\to\infty\cdot\frac1{\Gamma(-\beta)}",
        "dΘ/dτ is very large with the sign of 1/Γ(-β) for τ large and positive, β > 0 not an integer",
        SIGNS_RIGHT.carries(
            claim.check_sign(
                "-β times the leading form of Θ(τ, β - 1) over 1/Γ(-β) is positive "
                "and grows like e^(2/3 τ^(3/2)), for a symbol β",
                lambda forms: [growth / forms["sign of"], rational(growth.exponent("e"))],
            )
        ),
        Rung.POINTS.check("certified sign at τ = 60 for β = 0.1, ..., 12.9 without the integers", agrees),
        INITIAL_VALUES.carries(
            FormulaClaim({"leading": at_integers}).check(
                "the leading term of dΘ/dτ at β = n, for all n", lambda forms: [leading / forms["leading"]]
            )
        ),
        corrected=f"at an integer β = n, dΘ/dτ is a polynomial with leading term {in_greek(at_integers)}",
    )


def _gamma_intervals() -> Entry:
    claim = FormulaClaim(PRINTED["S-gamma-intervals"], CORRECTED["S-gamma-intervals"])
    with working_bits(64):
        values = [arb(fmpq(n, 2)).gamma() for n in (-1, -3)]
    texts = {name: text.replace("*", "") for name, text in CORRECTED["S-gamma-intervals"].items()}
    return SECTION.settled(
        "S-gamma-intervals",
        "line 1269",
        r"\Gamma(-\beta)<0 \text{ on } (2n-1,2n),\quad \Gamma(-\beta)>0 \text{ on } (2n-2,2n)",
        "Γ(-β) is negative for β in (2n-1, 2n) and positive for β in (2n-2, 2n), n = 1, 2, ...",
        claim.check_sign(
            "functional equation of Γ, by induction for a symbol n (proofs/side_switching.md)",
            lambda forms: [
                *induction("Gamma(-beta)"),
                is_cell(forms["negative from"], forms["negative to"]),
                is_cell(forms["positive from"], forms["positive to"]),
                rational(-1) * sign_on_cell(forms["negative from"]),
                sign_on_cell(forms["positive from"]),
            ],
            finding="Γ(-β) > 0 on (2n-1, 2n), and (2n-2, 2n) holds a pole and both signs; the corrected form holds for "
            "all n",
        ),
        Rung.BALLS.check(
            "enclosures of Γ(-β) at two points of each interval, n = 1, ..., 4",
            mended(_signs_by_ball(PRINTED["S-gamma-intervals"]), _signs_by_ball(CORRECTED["S-gamma-intervals"])),
            f"Γ(-1/2) in {ball_text(values[0], 8)}, Γ(-3/2) in {ball_text(values[1], 8)}",
        ),
        corrected=f"Γ(-β) is negative on ({texts['negative from']}, {texts['negative to']}) and positive on "
        f"({texts['positive from']}, {texts['positive to']}), n = 1, 2, ...",
        note="The sign printed for (2n-1, 2n) is wrong; the other interval is too long, and overlaps it. With the "
        "printed signs the paper's own argument for 0 < β < 1 would fail.",
    )


def _gamma_name() -> Entry:
    return SECTION.settled(
        "S-gamma-name",
        NAMED,
        r"\text{Here }Gamma\text{ represents the Gamma function}",
        "The sign that line 1268 explains is the one that stands in eq. dTheta_sign and in the next sentence",
        *(held_against(NAMED, f"line 1268 and {place.name}", NAME, place) for place in USED),
        corrected="Here Γ represents the Gamma function",
    )


def _signs_by_ball(texts: dict[str, str]) -> bool | None:
    answers = []
    for name, sign in (("negative", -1), ("positive", 1)):
        for n in range(1, 5):
            lower, upper = (rational_value(texts[f"{name} {end}"], n=n) for end in ("from", "to"))
            answers += [same_sign(gamma_sign_by_ball(beta), sign) for beta in (lower + fmpq(1, 4), upper - fmpq(1, 4))]
    return all_of(answers)


ENTRIES: Builders = {
    "S-minus-infinity": _sign_at_minus_infinity,
    "S-zero": _sign_at_zero,
    "S-plus-infinity": _sign_at_infinity,
    "S-gamma-intervals": _gamma_intervals,
    "S-gamma-name": _gamma_name,
}
"""The stated signs before the case distinction, in the order of the paper."""
