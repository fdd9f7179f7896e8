"""Ledger of Section 4.5, first half: the force at leading order, then the signs of dTheta/dtau and of Gamma(-beta).

Formulas are closed forms, compared for all values of their symbols; a hypothesis is a parametrisation by positive
symbols.
"""

from __future__ import annotations

from flint import arb, fmpq

from gspot_verified.numbers.balls import certainly_less, working_bits
from gspot_verified.paper.checks.closed_forms import ALGEBRA, ClosedForm, rational
from gspot_verified.paper.checks.entry import Builders, Entry, Rung, Section, all_of
from gspot_verified.paper.checks.formulas import (
    Forms,
    FormulaClaim,
    closed_form,
    evaluate_text,
    put,
    quotient,
    rational_value,
)
from gspot_verified.paper.checks.identities import in_greek
from gspot_verified.paper.section_4.section_4_inner import PRINTED as INNER_SCALE
from gspot_verified.paper.section_4.section_4_matching import PRINTED as MATCHING
from gspot_verified.paper.section_4.section_4_trivial import PRINTED as TRIVIAL
from gspot_verified.paper.section_4_5 import section_4_5_signs
from gspot_verified.theta_function.value.evaluate import evaluate

SECTION = Section("Section 4.5")
PRINTED: dict[str, dict[str, str]] = {
    "S-mean-force": {"force": "alpha2/(alpha1-alpha3)"},
    "S-deviation-force": {"force": "-C_1/alpha3*kappa^(1-beta)*epsilon^((2*beta-2)/3)*slope"},
    "S-force-sign": {"sign of": "C_1*slope"},
    "S-dominance": {"exponent": "(2*beta-2)/3"},
}
CORRECTED: dict[str, dict[str, str]] = {"S-mean-force": {"force": "alpha2/(alpha3-alpha1)"}}
HYPOTHESES: dict[str, dict[str, str]] = {
    "S-force-sign": {"alpha3": "-w"},
    "S-dominance": {"dominates": "1-u", "is dominated": "1+u"},
}
"""u and w are positive: α_3 < 0; β < 1 and β > 1."""
INNER = {"front": "C_1*kappa^(-beta)*epsilon^(2*beta/3)", "tau": "kappa*t*epsilon^(-2/3)"}
"""b = front Θ(tau, β): eq. bhat_inner with κ s = κ t ε^(-2/3) (entries 4-matching, 4-theta)."""
_SYSTEM = {
    "C_1": fmpq(3), "alpha3": fmpq(-2), "kappa": fmpq(4, 5), "epsilon": fmpq(1, 64),
}  # fmt: skip


def _mean_force() -> Entry:
    claim = FormulaClaim(PRINTED["S-mean-force"], CORRECTED["S-mean-force"])
    mean = {"c": "alpha2/(alpha1-alpha3)"}
    b, p = TRIVIAL["2-trivial"]["b"], TRIVIAL["2-trivial"]["p"]
    slope = closed_form(put(str(ALGEBRA.derivative(ALGEBRA.read(b), {"t": ALGEBRA.constant(1)})), **mean))
    balance = closed_form(f"-({put(b, **mean)})/({p})")
    values = {"alpha1": fmpq(-1), "alpha2": fmpq(-1), "alpha3": fmpq(-3, 2)}
    printed, corrected = (rational_value(table["S-mean-force"]["force"], **values) for table in (PRINTED, CORRECTED))
    example = f"at α = (-1, -1, -3/2) the equations give {corrected}, the printed form {printed}"
    return SECTION.settled(
        "S-mean-force",
        "line 1250",
        r"\bar\lambda_N=\frac{\alpha_2^*}{\alpha_1^*-\alpha_3^*}",
        "The mean force of the distinguished trajectory is α_2/(α_1 - α_3)",
        claim.check(
            "α_3 λ = α_2 - db/dt along eq. modelSysDistB, for symbols α_1, α_2, α_3",
            lambda forms: [(closed_form("alpha2") + closed_form("-alpha3") * forms["force"]) / slope],
            finding=example,
        ),
        claim.check(
            "λ = -b/p (eq. pain_par+) along modelSysDistP, modelSysDistB, for symbols α_1, α_2, α_3",
            lambda forms: [forms["force"] / balance],
            finding=f"λ = {in_greek(str(balance))}; {example}",
        ),
        corrected=f"{in_greek(CORRECTED['S-mean-force']['force'])}, for α_1 ≠ α_3, positive in Case III, as in "
        "Section 1 (Case III)",
        note="The same sign error is in eq. modelSysDistZY.",
    )


def _deviation_force() -> Entry:
    claim = FormulaClaim(PRINTED["S-deviation-force"])
    betas = (fmpq(1, 2), fmpq(3, 2), fmpq(7, 3))
    return SECTION.settled(
        "S-deviation-force",
        "line 1251",
        r"\hat\lambda_N=-\frac{C_1}{\alpha_3^*}\kappa^{1-\beta}\varepsilon^{(2\beta-2)/3}\frac{d\Theta}{d\tau}",
        "In the leading inner solution the deviation of the force is -(C_1/α_3) κ^(1-β) ε^((2 β-2)/3) dΘ/dτ",
        claim.check(
            "α_3 λ = -db/dt with b = C_1 κ^(-β) ε^(2 β/3) Θ(κ t ε^(-2/3), β): exponents linear in a symbol β",
            lambda forms: [quotient(closed_form(chain_rule_text()), forms["force"]), _linear_in_time()],
        ),
        claim.check(
            "eq. inner_scaling: δ² α_3 λ = -db/ds with δ = ε^(1/3), t = ε^(2/3) s, for a symbol β",
            lambda forms: [_by_inner_scaling() / forms["force"]],
        ),
        Rung.POINTS.check(
            "difference quotient of C_1 κ^(-β) ε^(2 β/3) Θ(κ t ε^(-2/3)) in t, in balls",
            all_of(_difference_quotient(beta) for beta in betas),
        ),
    )


def chain_rule_text() -> str:
    """-(db/dt)/α_3: front dΘ/dτ dτ/dt, where τ is linear in t."""
    return f"-({INNER['front']})*slope*({INNER['tau']})/t/alpha3"


def _linear_in_time() -> ClosedForm:
    return rational(closed_form(INNER["tau"]).exponent("t"))


def _by_inner_scaling() -> ClosedForm:
    tau = put(INNER["tau"], t="epsilon^(2/3)*s")
    slope = f"({INNER['front']})*slope*({tau})/s"
    printed = INNER_SCALE["4-inner-scaling"]
    right, factor = put(printed["lambda"], g1=slope), put(printed["lambda factor"], delta="epsilon^(1/3)")
    return closed_form(f"({right})/(({factor})*alpha3)")


def _difference_quotient(beta: fmpq) -> bool | None:
    """-(db/dt)/alpha_3 as a difference quotient against the printed form: they differ by O(step^2): 1e-12 is ample."""
    time, step, values = fmpq(1, 20), fmpq(1, 10**9), {**_SYSTEM, "beta": beta}
    front = evaluate_text(INNER["front"], values, 192).real
    places = [evaluate_text(INNER["tau"], {**values, "t": t}, 192).real for t in (time - step, time, time + step)]
    before, after = (evaluate(place, beta, digits=40).value for place in (places[0], places[2]))
    slope = evaluate(places[1], beta, derivative=1, digits=40).value
    stated = evaluate_text(PRINTED["S-deviation-force"]["force"], {**values, "slope": slope}, 192).real
    with working_bits(192):
        found = -front * (after - before) / (2 * step) / _SYSTEM["alpha3"]
        return certainly_less(abs(found - stated), abs(stated) * fmpq(1, 10**12))


def _force_sign() -> Entry:
    claim = FormulaClaim(PRINTED["S-force-sign"]).under(**HYPOTHESES["S-force-sign"])
    images = HYPOTHESES["S-force-sign"]
    return SECTION.settled(
        "S-force-sign",
        "line 1255",
        r"\operatorname{sign}\hat\lambda_N=\operatorname{sign}(C_1\,d\Theta/d\tau)",
        "In the leading inner solution the deviation of the force has the sign of C_1 dΘ/dτ (α_3 < 0, κ > 0)",
        claim.check_sign(
            "the formula of S-deviation-force over C_1 dΘ/dτ: positive powers of κ, ε and -α_3, for a symbol β",
            lambda forms: [closed_form(put(PRINTED["S-deviation-force"]["force"], **images)) / forms["sign of"]],
        ),
        claim.check_sign(
            "-(db/dt)/α_3 by the chain rule over C_1 dΘ/dτ, for a symbol β",
            lambda forms: [closed_form(put(chain_rule_text(), **images)) / forms["sign of"]],
        ),
    )


def _dominance() -> Entry:
    claim = FormulaClaim(PRINTED["S-dominance"])
    exponent, images = PRINTED["S-dominance"]["exponent"], HYPOTHESES["S-dominance"]
    force = closed_form(PRINTED["S-deviation-force"]["force"])

    def signs(_: Forms) -> list[ClosedForm]:
        below, above = (closed_form(put(exponent, beta=images[name])) for name in ("dominates", "is dominated"))
        return [rational(-1) * below, above]

    return SECTION.settled(
        "S-dominance",
        "lines 1253, 1285 and 1296",
        r"\varepsilon^{(2\beta-2)/3}",
        "In the leading inner solution, for small ε at fixed τ with dΘ/dτ not 0 (C_1, α_2 not 0), the deviation of the "
        "force dominates the mean force when β < 1, and the mean force dominates when β > 1",
        claim.check_sign(
            "the exponent (2 β - 2)/3 of ε is negative for β = 1 - u, positive for β = 1 + u, u > 0", signs
        ),
        claim.check(
            "it is the exponent of ε in S-deviation-force, and that of λ_N in 4-exponents, for a symbol β",
            lambda forms: [
                forms["exponent"] / rational(force.exponent("epsilon")),
                forms["exponent"] / closed_form(f"({MATCHING['4-exponents']['lambda']})/3"),
            ],
        ),
        Rung.POINTS.check(
            "size of the power at ε = 1e-6, β = 0.1, ..., 12.9 without 1",
            all_of(_is_large(beta) for beta in section_4_5_signs.GRID if beta != 1),
        ),
    )


def _is_large(beta: fmpq) -> bool | None:
    """Whether ε^exponent is above 1 for β < 1 and below 1 for β > 1; ``None`` when the ball cannot tell."""
    power = evaluate_text(
        f"epsilon^({PRINTED['S-dominance']['exponent']})", {"beta": beta, "epsilon": fmpq(1, 10**6)}, 64
    )
    above = certainly_less(arb(1), power.real)
    return None if above is None else above is (beta < 1)


ENTRIES: Builders = {
    "S-mean-force": _mean_force,
    "S-deviation-force": _deviation_force,
    "S-force-sign": _force_sign,
    "S-dominance": _dominance,
    **section_4_5_signs.ENTRIES,
}
"""The formulas and stated signs before the case distinction, in the order of the paper."""
