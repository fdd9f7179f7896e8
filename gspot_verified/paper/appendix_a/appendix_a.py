"""Ledger of Appendix A: the functions of th:3, their coefficients, the initial values; all its entries in order."""

from __future__ import annotations

from functools import partial

from flint import arb, fmpq, fmpq_poly

from gspot_verified.numbers.balls import certainly_less, relative_bits, working_bits
from gspot_verified.paper.appendix_a import appendix_a_asymptotics as asymptotics
from gspot_verified.paper.appendix_a import asymptotic_errors as errors
from gspot_verified.paper.appendix_a import hypergeometric as printed
from gspot_verified.paper.appendix_a.theta_pages import INITIAL_VALUES, LAPLACE, MOMENT, NEGATIVE, POWER
from gspot_verified.paper.checks.closed_forms import ClosedForm
from gspot_verified.paper.checks.entry import Builders, Entry, Rung, Section, all_of
from gspot_verified.paper.checks.formulas import Forms, FormulaClaim, closed_form, put
from gspot_verified.paper.checks.identities import in_greek
from gspot_verified.paper.checks.page import joined
from gspot_verified.theta_function.gamma.initial_values import initial_values
from gspot_verified.theta_function.value.asymptotic_coefficients import coefficient, coefficient_by_inversion
from gspot_verified.theta_function.value.routes import theta_by

SECTION = Section("Appendix A")
BETAS = tuple(fmpq(n, 20) for n in (-104, -34, -6, 1, 6, 10, 19, 30, 38, 50, 66, 94, 122))
COEFFICIENTS = 8


def _general_solution() -> Entry:
    claim = FormulaClaim(printed.FUNCTIONS)
    points = [(tau, beta) for tau in (fmpq(-9), fmpq(-7, 3), fmpq(1, 2), fmpq(8)) for beta in BETAS]
    agrees = all_of(
        _equal(
            printed.theta_by_fundamental_solutions(tau, beta, initial_values(beta, 256), 256),
            theta_by("laplace", tau, beta, digits=30),
        )
        for tau, beta in points
    )
    return SECTION.settled(
        "A-th3",
        "th:3, eq:btau",
        r"\theta=\theta(0)\,{}_1F_2(-\tfrac\beta3;\tfrac13,\tfrac23;\tfrac{\tau^3}9)+\ldots",
        "The three 1F2 of th:3 with their factors span the solutions of the differential equation, for every β",
        claim.check(
            "quotient of consecutive terms against the equation's recurrence, as rational functions of β and the "
            "index; the first terms are 1, τ, τ^2/2, so the initial values are unit vectors (proofs/connection.md)",
            lambda forms: [part for j in range(3) for part in (_term_quotient(j, forms), _first_term(j, forms))],
        ),
        Rung.POINTS.check(f"three FLINT 1F2 against the Laplace integral at {len(points)} points", agrees),
    )


def _first_term(j: int, forms: Forms) -> ClosedForm:
    return forms[f"front {j}"] / closed_form(f"tau^{j}/fac({j})")


def _term_quotient(j: int, forms: Forms) -> ClosedForm:
    """The quotient of the terms n + 1 and n of 1F2 number j over (k - β)/((k+1)(k+2)(k+3)) τ^3, k = j + 3n."""
    index = closed_form("n")
    upper, lower, other = (forms[f"{name} {j}"] + index for name in ("upper", "lower", "other lower"))
    found = upper / (lower * other * closed_form("1+n")) * forms["argument"]
    return found / closed_form(put("tau^3*(k-beta)/((k+1)*(k+2)*(k+3))", k=f"{j}+3*n"))


def _coefficients() -> Entry:
    dlmf = [printed.dlmf_coefficients(j, COEFFICIENTS) for j in range(3)]
    by_equation = [coefficient(k) for k in range(COEFFICIENTS)]
    by_inversion = [coefficient_by_inversion(k) for k in range(COEFFICIENTS)]
    return SECTION.settled(
        "A-coefficients",
        "eq:eier, eq:cisdef",
        r"c_0=1,\quad c_k \text{ from DLMF 16.11.4}",
        f"c_0 = 1, and DLMF 16.11.4 gives the same c_k(β) for the three functions (exactly, k < {COEFFICIENTS})",
        Rung.EXACT.check(
            "DLMF 16.11.4 for each 1F2 against the differential equation, as polynomials in β",
            all(row == by_equation for row in dlmf) and by_equation[0] == fmpq_poly([1]),
            f"c_1 = {by_equation[1]} (x is β)",
        ),
        Rung.EXACT.check("Lagrange inversion at the saddle point, as polynomials in β", by_inversion == by_equation),
        note="For every k: proofs/asymptotic_coefficients.md, with DLMF 16.11.8. In numbers for any k: "
        "theta_function.asymptotic_coefficients.",
    )


def _cancellation() -> Entry:
    claim = FormulaClaim(printed.INITIAL_VALUES)
    answers = []
    for beta in BETAS:
        values = printed.printed_initial_values(beta, 256)
        for part in ("real", "imaginary"):
            weights = [(printed.value_of(printed.SMALL[f"e {j}"], beta, 256), _weight(part, j, beta)) for j in range(3)]
            with working_bits(256):
                answers.append(_is_zero(sum((v * w[0] * w[1] for v, w in zip(values, weights, strict=True)), arb(0))))
    return SECTION.settled(
        "A-cancellation",
        "line 2446",
        r"\text{the coefficients of } e_r, e_i \text{ vanish}",
        "With the initial values t01-t03, β not an integer, the coefficients of e_r and e_i, the highly oscillatory "
        "terms, are 0",
        claim.check("both sums of the three coefficients, as closed forms in β", _sums_vanish),
        NEGATIVE.carries(
            claim.check(
                "Θ minus N terms of its power series is at most the next term, for every N > β/3; the initial values "
                "are those of proofs/laplace.md, as closed forms in β",
                lambda forms: [form / _page_initial_value(j) for j, form in enumerate(forms.values())],
            )
        ),
        Rung.POINTS.check(
            f"both coefficients in balls of radius below 1e-60 around 0 at {len(BETAS)} values of β", all_of(answers)
        ),
    )


def _weight(part: str, j: int, beta: fmpq) -> arb:
    return printed.value_of(printed.SMALL[f"{part} {j}"], beta, 256)


def _sums_vanish(forms: Forms) -> list[ClosedForm]:
    """1 minus each sum of Θ^(j)(0) (e j) (real j) and of Θ^(j)(0) (e j) (imaginary j), over its last term."""
    found = []
    for part in ("real", "imaginary"):
        terms = [
            form * closed_form(printed.SMALL[f"e {j}"]) * closed_form(printed.SMALL[f"{part} {j}"])
            for j, form in enumerate(forms.values())
        ]
        found.append(closed_form("1") + (terms[0] + terms[1] + terms[2]) / terms[2])
    return found


def _page_initial_value(j: int) -> ClosedForm:
    return closed_form(put(MOMENT, k=str(j)))


def _initial_value(j: int) -> Entry:
    label = f"t0{j + 1}"
    entire = printed.ENTIRE_INITIAL_VALUES[label]
    # The entire form is the library's addition: it is checked with the printed one.
    claim = FormulaClaim({"printed": printed.INITIAL_VALUES[label], "entire": entire})
    found = [
        (
            printed.printed_initial_values(beta, 256)[j],
            printed.value_of(entire, beta, 256),
            initial_values(beta, 256)[j],
        )
        for beta in BETAS
    ]
    at_integers = [(printed.value_of(entire, fmpq(n), 256), initial_values(fmpq(n), 256)[j]) for n in range(-4, 9)]
    derivative = (r"\Theta(0)", r"\Theta'(0)", r"\Theta''(0)")[j]
    return SECTION.settled(
        f"A-{label}",
        f"eq:{label}",
        rf"{derivative}=\Gamma(({j}-\beta)/3)/(3^{{({3 - j}+\beta)/3}}\Gamma(-\beta))",
        f"The initial value of eq. {label} is that of Θ, which is asymptotic to (-τ)^β as τ → −∞ without oscillatory "
        "terms (A-leading, A-cancellation), for every β that is not 0, 1, 2, ...",
        LAPLACE.carries(
            claim.check(
                "section 1 (substitution r^3/3): its value and the printed one, as closed forms in β",
                lambda forms: [forms["printed"] / _page_initial_value(j)],
            )
        ),
        INITIAL_VALUES.carries(
            claim.check(
                "the entire form, by Gauss's multiplication formula, as closed forms in β",
                lambda forms: [forms["entire"] / forms["printed"]],
            )
        ),
        Rung.POINTS.check(
            f"printed and entire form against the library's values at {len(BETAS)} values of β, the entire form "
            "also at the integers from -4 to 8",
            all_of(
                [
                    all_of(all_of([_equal(a, c), _equal(b, c)]) for a, b, c in found),
                    all_of(_same(*pair) for pair in at_integers),
                ]
            ),
        ),
        corrected=f"for every real β: {in_greek(entire)}",
        note=f"As printed it is ∞/∞ at β = {j}, {j + 3}, {j + 6}, ...; the entire form is not.",
    )


def _leading_behaviour() -> Entry:
    claim = FormulaClaim(printed.THETA)
    points = [(x, beta) for x in (fmpq(20), fmpq(80)) for beta in BETAS]
    return SECTION.settled(
        "A-leading",
        "eq:hdef, line 2459",
        r"\Theta(\tau,\beta)\sim 3^{1-\beta/3}\Gamma(1+\beta)h(\tau,\beta)\sim(-\tau)^\beta",
        "As τ → −∞ Θ is asymptotic to 3^(1-β/3) Γ(1+β) h and to (-τ)^β, for every β that is not -1, -2, ...",
        joined(
            NEGATIVE.carries(
                claim.check(
                    "the rest after N terms is at most the next term, once 3N > β; every term of "
                    "3^(1-β/3) Γ(1+β) h is a term of that page, as closed forms in β, k and x",
                    lambda forms: [forms["small front"] * closed_form(printed.SERIES["h"]) / closed_form(POWER)],
                )
            ),
            NEGATIVE.carries(
                claim.check(
                    "the term with k = 0 is (-τ)^β, as closed forms in β and x",
                    lambda forms: [
                        forms["small front"] * closed_form(put(printed.SERIES["h"], k="0")) / forms["small leading"]
                    ],
                )
            ),
        ),
        Rung.POINTS.check(
            f"three terms against the Laplace integral at {len(points)} points",
            all_of(errors.power_series_within(x, beta) for x, beta in points),
        ),
        note="At β = -1, -2, ... every term of h is 0 and Γ(1+β) infinite; the product keeps its limit.",
    )


def _equal(first: arb, second: arb) -> bool | None:
    """Whether two accurate enclosures overlap; ``None`` when one is not accurate enough to tell."""
    if min(relative_bits(first), relative_bits(second)) <= 60:
        return None
    return bool(first.overlaps(second))


def _same(first: arb, second: arb) -> bool | None:
    """As :func:`_equal`, and True when both are exactly 0."""
    return True if first.is_zero() and second.is_zero() else _equal(first, second)


def _is_zero(part: arb) -> bool | None:
    """False when the ball excludes 0, True when it holds 0 and is below 1e-60, ``None`` otherwise."""
    if part > 0 or part < 0:
        return False
    return True if certainly_less(part.abs_upper(), arb(fmpq(1, 10**60))) else None


def _small(j: int) -> Entry:
    return asymptotics.small(j, BETAS)


def _large(j: int) -> Entry:
    return asymptotics.large(j, BETAS)


def _theta_large() -> Entry:
    return asymptotics.theta_large(BETAS)


ENTRIES: Builders = {
    "A-th3": _general_solution,
    "A-coefficients": _coefficients,
    **{f"A-{name}": partial(_small, j) for j, name in enumerate(asymptotics.SMALL_NAMES)},
    "A-cancellation": _cancellation,
    **{f"A-{label}": partial(_initial_value, j) for j, label in enumerate(printed.INITIAL_VALUES)},
    "A-leading": _leading_behaviour,
    **{f"A-{name}": partial(_large, j) for j, name in enumerate(asymptotics.LARGE_NAMES)},
    "A-th5-condition": asymptotics.large_condition,
    "A-tlarge": _theta_large,
}
"""Every labelled formula of Appendix A, in the order of the paper."""
