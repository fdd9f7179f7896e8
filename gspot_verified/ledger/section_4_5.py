"""Ledger of Section 4.5, first half: the force at leading order, the sign of dTheta/dtau and of Gamma(-beta)."""

from __future__ import annotations

from flint import arb, fmpq

from gspot_verified.balls import ball_text, certainly_less, sign_of, working_bits
from gspot_verified.ledger.entry import Check, Entry, Rung, all_of, same_sign, settled
from gspot_verified.signs.side import gamma_sign, gamma_sign_by_ball
from gspot_verified.signs.tails import left_threshold
from gspot_verified.theta_function.evaluate import evaluate

SECTION = "Section 4.5"
_SYSTEMS = tuple(
    (fmpq(-1), alpha_2, alpha_1_times * fmpq(-1))
    for alpha_2 in (fmpq(-1), fmpq(-3, 2), fmpq(-2))
    for alpha_1_times in (fmpq(3, 2), fmpq(5, 2), fmpq(7, 3))
)
_GRID = tuple(fmpq(n, 10) for n in range(1, 130))
_NOT_INTEGER = tuple(beta for beta in _GRID if beta.q != 1)


def entries() -> list[Entry]:
    """The formulas and stated signs before the case distinction, in the order of the paper."""
    return [
        _mean_force(),
        _deviation_force(),
        _force_sign(),
        _dominance(),
        _sign_at_minus_infinity(),
        _sign_at_zero(),
        _sign_at_infinity(),
        _gamma_intervals(),
    ]


def _mean_force() -> Entry:
    # b-bar = alpha_2 alpha_1 t/(alpha_1 - alpha_3), p-bar = alpha_1 t (eqs. modelSysDistB, modelSysDistP).
    by_equation, by_balance, printed, corrected = [], [], [], []
    for alpha_1, alpha_2, alpha_3 in _SYSTEMS:
        slope = alpha_2 * alpha_1 / (alpha_1 - alpha_3)
        by_equation.append((alpha_2 - slope) / alpha_3)  # db/dt = alpha_2 - alpha_3 lambda_N
        by_balance.append(-slope / alpha_1)  # lambda_N = -b/p (eq. pain_par+)
        printed.append(alpha_2 / (alpha_1 - alpha_3))
        corrected.append(alpha_2 / (alpha_3 - alpha_1))
    holds = "agrees" if by_equation == corrected and by_balance == corrected else "DISAGREES"
    statement = "The mean force of the distinguished trajectory is α_2/(α_1 - α_3)"
    return settled(
        SECTION,
        "S-mean-force",
        "line 1250",
        r"\bar\lambda_N=\frac{\alpha_2^*}{\alpha_1^*-\alpha_3^*}",
        statement,
        Check(
            Rung.EXACT,
            "α_3 λ = α_2 - db/dt along eq. modelSysDistB",
            by_equation == printed,
            f"α = (-1, -1, -3/2): the equation gives {by_equation[0]}, the printed form {printed[0]}; "
            f"the corrected form {holds} at {len(_SYSTEMS)} systems",
        ),
        Check(
            Rung.EXACT,
            "λ = -b/p (eq. pain_par+) along modelSysDistP, modelSysDistB",
            by_balance == printed,
            f"α = (-1, -1, -3/2): -b/p = {by_balance[0]}",
        ),
        corrected="α_2/(α_3 - α_1), positive in Case III, as in Section 1 (Case III)",
        note="The same sign error is in eq. modelSysDistZY.",
    )


def _deviation_force() -> Entry:
    betas = (fmpq(1, 2), fmpq(3, 2), fmpq(7, 3))
    agrees = all_of(_chain_rule(beta) for beta in betas)
    return settled(
        SECTION,
        "S-deviation-force",
        "line 1251",
        r"\hat\lambda_N=-\frac{C_1}{\alpha_3^*}\kappa^{1-\beta}\varepsilon^{(2\beta-2)/3}\frac{d\Theta}{d\tau}",
        "The deviation of the force is -(C_1/α_3) κ^(1-β) ε^((2 β-2)/3) dΘ/dτ",
        Check(
            Rung.EXACT,
            "d/dt of C_1 κ^(-β) ε^(2 β/3) Θ(κ t ε^(-2/3)) with τ^m in place of Θ, in exact "
            "rationals: the identity is linear in Θ and a power of κ and ε for each β",
            all(_monomial_identity(beta, m) for beta in (2, 4, 5) for m in (1, 2, 3)),
        ),
        Check(
            Rung.POINTS,
            "difference quotient of C_1 κ^(-β) ε^(2 β/3) Θ(κ t ε^(-2/3)) in t, in balls",
            agrees,
        ),
    )


def _monomial_identity(beta: int, m: int) -> bool:
    """The printed force against -(db/dt)/alpha_3 for b = C_1 kappa^(-beta) eps^(2 beta/3) (kappa t eps^(-2/3))^m."""
    kappa, root, charge, alpha_3, time = fmpq(2, 3), fmpq(1, 5), fmpq(3), fmpq(-2), fmpq(7, 4)  # eps = root^3
    tau = kappa * time / root**2
    deviation = charge / kappa**beta * root ** (2 * beta) * tau**m
    slope = m * tau ** (m - 1)
    printed = -charge / alpha_3 * kappa / kappa**beta * root ** (2 * beta - 2) * slope
    return -(m * deviation / time) / alpha_3 == printed


def _chain_rule(beta: fmpq) -> bool | None:
    """-(db/dt)/alpha_3 as a difference quotient against the printed form: they differ by O(step^2): 1e-12 is ample."""
    charge, alpha_3, time, step = 3, -2, fmpq(1, 20), fmpq(1, 10**9)
    with working_bits(192):
        epsilon, kappa = arb(fmpq(1, 64)), arb(fmpq(4, 5))
        scale = kappa * epsilon ** arb(fmpq(-2, 3))
        front = charge * kappa ** arb(-beta) * epsilon ** arb(2 * beta / 3)
        values = [front * evaluate(scale * t, beta, digits=40).value for t in (time - step, time + step)]
        quotient = -(values[1] - values[0]) / (2 * step) / alpha_3
        slope = evaluate(scale * time, beta, derivative=1, digits=40).value
        stated = -arb(charge) / alpha_3 * kappa ** arb(1 - beta) * epsilon ** arb((2 * beta - 2) / 3) * slope
        return certainly_less(abs(quotient - stated), abs(stated) * fmpq(1, 10**12))


def _force_sign() -> Entry:
    agrees = all(
        (-fmpq(c) / alpha_3 * slope > 0) == (c * slope > 0)
        for _, _, alpha_3 in _SYSTEMS
        for c in (-1, 1)
        for slope in (-1, 1)
    )
    return settled(
        SECTION,
        "S-force-sign",
        "line 1255",
        r"\operatorname{sign}\hat\lambda_N=\operatorname{sign}(C_1\,d\Theta/d\tau)",
        "The deviation of the force has the sign of C_1 dΘ/dτ (α_3 < 0, κ > 0)",
        Check(Rung.EXACT, "all sign combinations", agrees),
        Check(Rung.PAGE, "S-deviation-force: the factors in front are positive", True),
    )


def _dominance() -> Entry:
    powers = {beta: (2 * beta - 2) / 3 for beta in _GRID}
    epsilon = fmpq(1, 10**6)
    with working_bits(64):
        sizes = {beta: arb(epsilon) ** arb(power) for beta, power in powers.items() if beta != 1}
    return settled(
        SECTION,
        "S-dominance",
        "lines 1253 and 1284",
        r"\varepsilon^{(2\beta-2)/3}",
        "For small ε at fixed τ the deviation of the force dominates the mean force when β < 1, and the "
        "mean force dominates when β > 1",
        Check(
            Rung.EXACT,
            "the exponent (2 β - 2)/3 is increasing in β and 0 at β = 1",
            powers[fmpq(1)] == 0 and list(powers.values()) == sorted(powers.values()),
        ),
        Check(
            Rung.POINTS,
            "size of the power at ε = 1e-6, β = 0.1, ..., 12.9",
            all_of(_is_large(size, beta < 1) for beta, size in sizes.items()),
        ),
    )


def _is_large(size: arb, expected: bool) -> bool | None:
    """Whether the size is above 1 as expected, or below 1 as expected; ``None`` when the ball cannot tell."""
    above = certainly_less(arb(1), size)
    return None if above is None else above is expected


def _sign_at_minus_infinity() -> Entry:
    # At tau = -T(beta) itself, T from proofs/signs.md rounded up.
    agrees = all_of(same_sign(sign_of(evaluate(-_threshold(beta), beta, derivative=1).value), -1) for beta in _GRID)
    return settled(
        SECTION,
        "S-minus-infinity",
        "eq:dTheta_sign, first row",
        r"\frac{d\Theta}{d\tau}<0\ (\tau\to-\infty)",
        "dΘ/dτ is negative for τ large and negative, for every β > 0",
        Check(Rung.PAGE, "proofs/signs.md: an explicit T(β), from the enveloping series", True),
        Check(Rung.POINTS, "certified sign at -T(β) for β = 0.1, 0.2, ..., 12.9", agrees),
    )


def _threshold(beta: fmpq) -> fmpq:
    """An integer T with dTheta/dtau < 0 on (-oo, -T], by the statement of the proof page."""
    b = beta - 1
    return left_threshold(b, b, int(b.floor()), denominator=1)


def _sign_at_zero() -> Entry:
    answers = []
    for beta in _NOT_INTEGER:
        with working_bits(128):
            printed = sign_of(arb((1 - beta) / 3).gamma() * arb(-beta).rgamma())
        answers.append(same_sign(printed, sign_of(evaluate(0, beta, derivative=1).value)))
    agrees = all_of(answers)
    return settled(
        SECTION,
        "S-zero",
        "eq:dTheta_sign, second row",
        r"\operatorname{sign}\frac{d\Theta}{d\tau}(0)=\operatorname{sign}\frac{\Gamma((1-\beta)/3)}{\Gamma(-\beta)}",
        "At τ = 0 the sign is that of Γ((1-β)/3)/Γ(-β), for β not an integer",
        Check(Rung.PAGE, "proofs/signs.md, from the entire form of the initial values", True),
        Check(Rung.POINTS, "both signs certified at β = 0.1, ..., 12.9 without the integers", agrees),
        corrected="at β = 1, 4, 7, ... the quotient is infinite over infinite: there dΘ/dτ(0) < 0; "
        "at β = 2, 3, 5, 6, ... dΘ/dτ(0) = 0",
    )


def _sign_at_infinity() -> Entry:
    agrees = all_of(
        same_sign(sign_of(evaluate(60, beta, derivative=1).value), gamma_sign(beta)) for beta in _NOT_INTEGER
    )
    return settled(
        SECTION,
        "S-plus-infinity",
        "eq:dTheta_sign, third row",
        r"\frac{d\Theta}{d\tau}\to\infty\cdot\frac1{\Gamma(-\beta)}",
        "dΘ/dτ is very large with the sign of 1/Γ(-β) for τ large and positive, β > 0 not an integer",
        Check(Rung.PAGE, "proofs/signs.md: Γ(-β) dΘ/dτ exceeds every power of τ", True),
        Check(Rung.POINTS, "certified sign at τ = 60 for β = 0.1, ..., 12.9 without the integers", agrees),
        corrected="at an integer β = n, dΘ/dτ is a polynomial with leading term (-1)^n n τ^(n-1)",
    )


def _gamma_intervals() -> Entry:
    # The printed signs at beta = 1/2 and 3/2 are + and -.
    exact_signs = [gamma_sign("1/2"), gamma_sign("3/2")]
    ball_signs = [gamma_sign_by_ball("1/2"), gamma_sign_by_ball("3/2")]
    by_parity, by_ball = (
        all_of(same_sign(found, printed) for found, printed in zip(signs, (1, -1), strict=True))
        for signs in (exact_signs, ball_signs)
    )
    with working_bits(64):
        values = [arb(fmpq(n, 2)).gamma() for n in (-1, -3)]
    return settled(
        SECTION,
        "S-gamma-intervals",
        "line 1269",
        r"\Gamma(-\beta)<0 \text{ on } (2n-1,2n),\quad \Gamma(-\beta)>0 \text{ on } (2n-2,2n)",
        "Γ(-β) is negative for β in (2n-1, 2n) and positive for β in (2n-2, 2n), n = 1, 2, ...",
        Check(
            Rung.EXACT,
            "functional equation of Γ (proofs/side_switching.md)",
            by_parity,
            f"sign Γ(-1/2) = {exact_signs[0]}, sign Γ(-3/2) = {exact_signs[1]}",
        ),
        Check(
            Rung.BALLS,
            "enclosures of Γ(-1/2) and Γ(-3/2)",
            by_ball,
            f"Γ(-1/2) in {ball_text(values[0], 8)}, Γ(-3/2) in {ball_text(values[1], 8)}",
        ),
        corrected="Γ(-β) is negative on (2n-2, 2n-1) and positive on (2n-1, 2n), n = 1, 2, ...",
        note="Both signs are exchanged, and the two printed intervals overlap. With the printed signs the paper's own "
        "argument for 0 < β < 1 would fail.",
    )
