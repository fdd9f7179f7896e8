"""Ledger of Section 4.5 for the compliant model itself: what holds on its slow manifold at every ε, without the words
"at leading order".

The page is proofs/monotone.md; its steps on coefficients and exponents are run here exactly.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import pairwise

from flint import acb, arb, fmpq

from gspot_verified.compliant.contact.lower_polynomial import lower_terms
from gspot_verified.compliant.contact.slow_lift_off import slow_lift_off
from gspot_verified.compliant.contact.threshold import exact_threshold, slow_force
from gspot_verified.compliant.slow.epsilon_series import series_coefficients
from gspot_verified.leading_order.contact_force import ContactForce, contact_force
from gspot_verified.leading_order.iwc import leading_order_iwc
from gspot_verified.leading_order.lift_off import lift_off
from gspot_verified.numbers.balls import (
    approximate,
    certainly_less,
    float_bounds,
    nonfinite,
    rounded_text,
    sign_of,
    working_bits,
)
from gspot_verified.numbers.verdict import Outcome
from gspot_verified.paper.checks.closed_forms import ClosedForm
from gspot_verified.paper.checks.entry import Builders, Entry, Rung, Section, all_of, same_sign
from gspot_verified.paper.checks.formulas import Forms, FormulaClaim, closed_form, evaluate_text, put
from gspot_verified.paper.checks.page import Page
from gspot_verified.paper.section_4 import section_4_outer as outer
from gspot_verified.theta_function.sums.quadrature import holomorphic_integral

SECTION = Section("Section 4.5")
PRINTED: dict[str, dict[str, str]] = {
    "C-cases-I-II": {"side": "1"},
    "C-iwc-case-III": {"side": "C_1/Gamma(-beta)"},
    "C-lift-off": {"side": "C_1/Gamma(-beta)"},
}
HYPOTHESES: dict[str, dict[str, str]] = {
    "C-cases-I-II": {"beta": "v", "C_1": "-u"},
    "C-iwc-case-III": {"beta": "5*v"},
    "C-lift-off": {"beta": "5*v"},
}
DEVIATION = "-C_1/Gamma(1-beta)"
"""On the slow manifold λ̂ is this times a positive integral (β < 1), and λ̂ minus its value at leading order is this
times a positive integral (β < 5)."""
WEIGHT = {"power": "-beta-1", "exponent": "k - k^2/2 - k^3/3"}
"""The integrand r^power e^(ψ(r)/(ε|α_1|) + rt/ε) of b̂; ψ(r) is the exponent, with k for r, less log(1 + r)."""
BETAS = (fmpq(3, 2), fmpq(5, 2), fmpq(7, 2))
BELOW_ONE = (fmpq(1, 2), fmpq(3, 4), fmpq(9, 10))
"""β of Cases I and II with a whole 1/(1 - β): the quadrature has no branch point."""
TAUS = (fmpq(-20), fmpq(0), fmpq(6))
_FAR = 12
"""F: from this ρ on the integral is bounded by hand."""
EPSILON = fmpq(1, 1000)
START = fmpq(-10)
BELOW = fmpq(99, 100)
"""The ε that is tried is this share of the exact ε_0."""
_MOST = 12


def coefficients_of_the_exponential() -> bool:
    """c_(k,m) of e^h by multiplying powers of h out, h = Σ (-1)^(j+1) η^j ρ^(j+3)/(2 (j+3)); the signs alternate."""
    log = [fmpq(0)] + [fmpq((-1) ** (j + 1), 2 * (j + 3)) for j in range(1, _MOST + 1)]
    power = [fmpq(1)] + [fmpq(0)] * _MOST
    for m in range(1, _MOST + 1):
        power = [sum((log[j] * power[k - j] for j in range(1, k + 1)), fmpq(0)) / m for k in range(_MOST + 1)]
        for k in range(m, _MOST + 1):
            if series_coefficients(k)[m - 1] != power[k] or not power[k] * (-1) ** (k + m) > 0:
                return False
    return True


def orders_of_the_polynomial() -> bool:
    """For each m the terms of P reach ρ^b, the last one is negative, and no term is needed for b < 4."""
    for twice in range(1, 24, 2):
        b, terms = fmpq(twice, 2), lower_terms(fmpq(twice, 2))
        for m in range(1, 4):
            last = max((t.power for t in terms if t.order == t.power + 3 * m), default=None)
            if last is None and not 4 * m > b:
                return False
            if last is not None and not (last + 1 + 3 * m > b and (last - m) % 2 == 1):
                return False
        if b < 4 and terms:
            return False
    return True


def exponents_of_the_units() -> bool:
    """−β + 2b/3 = −1 − b/3 for b = β − 1: both sides are linear, so two values settle it."""
    return all(-beta + 2 * (beta - 1) / 3 == -1 - (beta - 1) / 3 for beta in (fmpq(2), fmpq(7, 2)))


def integrand_solves_the_equation() -> bool:
    """eq. modelSysDev under the integral, t e^(rt/ε) = ε d/dr e^(rt/ε), is a derivative in r: α_1 = -x, α_3 = -β x.

    With a + t c for the equation and w for the integrand at t = 0 that is a w = ε (c w)', here times r (1 + r) x.
    """
    read, r, x, epsilon = outer.ALGEBRA.read, *(outer.ALGEBRA.symbols[name] for name in ("k", "x", "epsilon"))
    equation = outer.ALGEBRA.substitute(
        read(outer.PRINTED["4-deviation"]["equation"]), {"alpha1": -x, "alpha3": read("-beta*x")}
    )
    powers = [epsilon ** (4 - order) * r**order for order in range(5)]
    in_time = outer.ALGEBRA.coefficients(outer.ALGEBRA.replaced(equation, "b", powers, read("0*k")), "t")
    slope = read(WEIGHT["power"]) * (1 + r) * x * epsilon + r * ((1 + r) * read(WEIGHT["exponent"]).derivative("k") - 1)
    by_parts = epsilon * x * r * (1 + r) * in_time[1].derivative("k") + in_time[1] * slope
    return set(in_time) == {0, 1} and bool(in_time[0] * r * (1 + r) * x == by_parts)


def force_is_its_derivative() -> bool:
    """α_3 λ̂ = -b̂', α_3 = -β x, and b̂ is C_1/Γ(-β) times the integral: λ̂ has the factor C_1/(β Γ(-β))."""
    force = outer.ALGEBRA.read(outer.PRINTED["4-deviation-recover"]["lambda"])
    factor = closed_form(DEVIATION) / closed_form("C_1/(beta*Gamma(-beta))")
    return bool(force == -outer.ALGEBRA.symbols["b1"]) and factor.is_one()


STEPS = (coefficients_of_the_exponential, orders_of_the_polynomial, exponents_of_the_units)
MONOTONE = Page("monotone", (integrand_solves_the_equation, force_is_its_derivative, *STEPS))


def _claim(identifier: str) -> FormulaClaim:
    return FormulaClaim(PRINTED[identifier]).under(**HYPOTHESES[identifier])


def _over_the_side(identifier: str, forms: Forms, room: str) -> list[ClosedForm]:
    """The factor of the positive integral over the side, and what must be positive for it to converge at 0."""
    images = HYPOTHESES[identifier]
    return [closed_form(put(DEVIATION, **images)) / forms["side"], closed_form(put(room, **images))]


def weight_of(epsilon: fmpq, tau: fmpq, power: int) -> Callable[[acb, bool], acb]:
    """x ↦ e^(ψ(r)/ε + ρτ), ψ(r) = r - r²/2 - r³/3 - log(1 + r), r = ηρ, ρ = x^power; not finite at a cut of log."""
    eta = (arb(epsilon) / 2).root(3)

    def weight(x: acb, analytic: bool) -> acb:
        r = eta * x**power
        return ((r - r**2 / 2 - r**3 / 3 - (1 + r).log(analytic)) / epsilon + x**power * tau).exp()

    return weight


def positive_integral(beta: fmpq, tau: fmpq, epsilon: fmpq) -> arb:
    """ε^(β-1) times the integral of r^(-β) e^(ψ(r)/ε + rT), α_1 = -1, by quadrature in x = ρ^(1-β), r = ηρ, τ = ηT."""
    with working_bits(64):
        power = int((1 / (1 - beta)).p)
        near = holomorphic_integral(weight_of(epsilon, tau, power), arb(0), arb(_FAR) ** arb(1 - beta)).real * power
        # log(1 + r) >= r - r²/2, so ψ(r) <= -r³/3 and, as η³ = ε/2, the exponent is at most g = -ρ³/6 + ρτ. For ρ >= F
        # its slope is at most -(F²/2 - τ) < 0: the rest is at most F^(-β) e^(g(F))/(F²/2 - τ).
        falls = fmpq(_FAR**2, 2) - tau
        if falls <= 0:
            return nonfinite()
        rest = arb(_FAR) ** arb(-beta) * arb(_FAR * tau - fmpq(_FAR**3, 6)).exp() / falls
        scale = 2 * (arb(epsilon) / 2).root(3) ** 2
        return (near + rest * arb(fmpq(1, 2), fmpq(1, 2))) * scale ** arb(beta - 1)


def is_the_factor_times_an_integral(force: ContactForce, values: Sequence[arb], epsilon: fmpq) -> bool | None:
    """Whether the forces at TAUS are DEVIATION times the integrals, to 10^-8, and have the stated sign and rise."""
    symbols = {"C_1": force.c1, "beta": force.beta}
    factor, side = (evaluate_text(text, symbols, 64).real for text in (DEVIATION, PRINTED["C-cases-I-II"]["side"]))
    answers = [same_sign(sign_of(value), sign_of(side)) for value in values]
    with working_bits(64):
        answers += [certainly_less(abs(a), abs(b)) for a, b in pairwise(values)]
        for tau, value in zip(TAUS, values, strict=True):
            difference = factor * positive_integral(force.beta, tau, epsilon) - value
            answers.append(certainly_less(abs(difference), abs(value) * fmpq(1, 10**8)))
    return all_of(answers)


def _cases_one_and_two() -> Entry:
    forces = [contact_force(beta, alpha_2=0) for beta in BELOW_ONE]
    runs = [(force, epsilon) for force in forces for epsilon in (EPSILON, fmpq(10))]
    rows = [(force, [slow_force(force, tau, epsilon) for tau in TAUS], epsilon) for force, epsilon in runs]
    return SECTION.settled(
        "C-cases-I-II",
        "lines 1278 to 1291 (Cases I and II)",
        r"\hat\lambda_N>0\quad(0<\beta<1,\ C_1<0)",
        "For 0 < β < 1 and C_1 < 0, on the slow manifold of the compliant model, for every ε > 0 and every t: the "
        "deviation of the contact force is positive and increases from 0 to infinity",
        MONOTONE.carries(
            _claim("C-cases-I-II").check_sign(
                "Theorem A: the deviation is a factor, positive for C_1 < 0, times an integral of a positive function, "
                "which converges at 0 for β < 1",
                lambda forms: _over_the_side("C-cases-I-II", forms, "1-beta"),
            )
        ),
        Rung.POINTS.check(
            "certified values on the slow manifold at three β, τ = -20, 0, 6, ε = 1/1000 and 10: their sign, that they "
            "rise, and that they are the factor times the integral, which is found by quadrature",
            all_of(is_the_factor_times_an_integral(*row) for row in rows),
        ),
        note='S-iwc without the words "at leading order". In Case II the contact holds for every t; in Case I it holds '
        "for ever once λ_N > 0. The deviations are linear in C_1, so for C_1 > 0 they have the other signs "
        "(proofs/monotone.md, Theorem A). Other initial states are not covered.",
    )


def _side_at(identifier: str, force: ContactForce, wanted: int) -> bool | None:
    side = evaluate_text(PRINTED[identifier]["side"], {"C_1": force.c1, "beta": force.beta}, 64)
    return same_sign(sign_of(side.real), wanted)


def _case_three() -> Entry:
    answers: list[bool | None] = []
    shown = []
    for beta in BETAS:
        leading = leading_order_iwc(beta)
        if leading.epsilon_0 is None:
            answers.append(None)
            continue
        exact = exact_threshold(leading.force, START, leading.epsilon_0, 5)
        if exact.lower is None or exact.place is None:
            answers.append(None)
            continue
        tried = [slow_force(leading.force, tau, exact.lower * BELOW) for tau in (START, exact.place)]
        answers += [same_sign(sign_of(value), 1) for value in tried]
        answers += [True if exact.lower >= leading.epsilon_0 else None, _side_at("C-iwc-case-III", leading.force, 1)]
        shown.append(f"β = {beta}: ε_0 >= {rounded_text(float_bounds(arb(exact.lower))[0], -1, 4)}")
    return SECTION.settled(
        "C-iwc-case-III",
        "lines 1304 to 1305 (Case III)",
        r"\text{the other sign of }C_1\Gamma(-\beta):\ \text{strong evidence that an IWC occurs}",
        "For 0 < β < 5 not an integer and C_1/Γ(-β) > 0, the contact force on the slow manifold of the compliant model "
        "is larger than at leading order at every τ and every ε: each ε_0 at leading order holds unchanged",
        MONOTONE.carries(
            _claim("C-iwc-case-III").check_sign(
                "Theorem C: the force minus that at leading order is a factor with the sign of C_1/Γ(-β) times an "
                "integral of a positive function, which converges at 0 for β < 5",
                lambda forms: _over_the_side("C-iwc-case-III", forms, "4-(beta-1)"),
            )
        ),
        Rung.POINTS.check(
            "the exact ε_0 for τ >= -10 at three values of β, not below that at leading order; certified values of the "
            "force just below it",
            all_of(answers),
            "; ".join(shown),
        ),
        note='S-iwc-case-III without the words "at leading order". For 5 < β < 13 an exact ε_0 is found by cells of ε '
        "(command iwc); at β = 21/4 it is smaller than that at leading order.",
    )


def _lift_off() -> Entry:
    answers: list[bool | None] = []
    shown = []
    for beta in BETAS:
        force = contact_force(beta, c1=-contact_force(beta).c1)
        leading = lift_off(force, EPSILON, START, 6)
        found = slow_lift_off(force, leading, START, 6)
        proved = found.uniform is not None and found.uniform.outcome is Outcome.PROVED
        before = found.upper is not None and leading.upper is not None and found.upper <= leading.upper
        answers += [True if proved and before else None, _side_at("C-lift-off", force, -1)]
        if found.lower is not None:
            shown.append(
                f"β = {beta}: τ_lo = {approximate(found.lower):.4f}, κ = {approximate(arb(found.kappa or 0)):.3g}"
            )
    return SECTION.settled(
        "C-lift-off",
        "line 1299 (Case III)",
        r"C_1/\Gamma(-\beta)<0",
        "In Case III, β < 5 not an integer, C_1/Γ(-β) < 0, the contact force on the slow manifold of the compliant "
        "model is smaller than at leading order at every τ and every ε: from a start at which it is positive contact "
        "is lost, not later than at leading order",
        MONOTONE.carries(
            _claim("C-lift-off").check_sign(
                "Theorem C: the force minus that at leading order is a factor with the sign of C_1/Γ(-β) times an "
                "integral of a positive function, which converges at 0 for β < 5",
                lambda forms: _over_the_side("C-lift-off", forms, "4-(beta-1)"),
            )
        ),
        Rung.POINTS.check(
            "certified lift-off times at ε = 1/1000, three values of β; for every smaller ε the time lies between "
            "τ_LO - κ (η/8) τ_LO^(3/2) and τ_LO, that at leading order",
            all_of(answers),
            "; ".join(shown),
        ),
        note="S-side without the words 'at leading order'. There is such a start for every small ε; for even ⌊β⌋ not "
        "for every large one: at β = 9/2, α = (-1, -1, -9/2), C_1 = 1, ε = 20000 the force is negative at every τ. "
        "At these three β the two bounds make the law of S-growth hold for the compliant model, since (η/8) "
        "τ_LO^(3/2) tends to 0.",
    )


ENTRIES: Builders = {"C-cases-I-II": _cases_one_and_two, "C-iwc-case-III": _case_three, "C-lift-off": _lift_off}
