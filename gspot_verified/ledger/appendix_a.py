"""Ledger of Appendix A: Theorems 3, 4, 5 and the initial values."""

from __future__ import annotations

from flint import arb, fmpq, fmpq_poly

from gspot_verified.balls import ball_text, certainly_less, relative_bits, working_bits
from gspot_verified.ledger import asymptotic_errors as errors
from gspot_verified.ledger import hypergeometric as printed
from gspot_verified.ledger.entry import Check, Entry, Rung, all_of, settled
from gspot_verified.theta_function.asymptotic_coefficients import coefficient, coefficient_by_inversion
from gspot_verified.theta_function.initial_values import initial_values, paper_initial_values
from gspot_verified.theta_function.reciprocal_gamma import reciprocal_gamma
from gspot_verified.theta_function.routes import theta_by
from gspot_verified.theta_function.taylor import taylor_coefficients

SECTION = "Appendix A"
BETAS = tuple(fmpq(n, 20) for n in (-104, -34, -6, 1, 6, 10, 19, 30, 38, 50, 66, 94, 122))
_SMALL = ("bsmall1", "bsmall2", "bsmall3")
_LARGE = ("blarge1", "blarge2", "blarge3")
_SMALL_SOURCE = (
    r"{}_1F_2(-\beta/3;1/3,2/3;\tau^3/9) \sim 3\Gamma((3+\beta)/3)h + (3/\Gamma(-\beta/3)) 2e_r",
    r"\tau{}_1F_2(\ldots) \sim -3^{2/3}\Gamma((2+\beta)/3)h - (3^{2/3}/\Gamma((1-\beta)/3))(e_r-\sqrt{3}e_i)",
    r"(\tau^2/2){}_1F_2(\ldots) \sim 3^{1/3}\Gamma((1+\beta)/3)h + (3^{1/3}/\Gamma((2-\beta)/3))(-e_r-\sqrt{3}e_i)",
)


def entries() -> list[Entry]:
    """Every labelled formula of Appendix A, in the order of the paper."""
    found = [_theorem_3(), _coefficients(), *(_small(j) for j in range(3)), _cancellation()]
    found += [*(_initial_value(j) for j in range(3)), _leading_behaviour()]
    return [*found, *(_large(j) for j in range(3)), _large_condition(), _theta_large()]


def _theorem_3() -> Entry:
    statement = "The three 1F2 of Theorem 3 span the solutions of the differential equation, for every β"
    lower = ((fmpq(1, 3), fmpq(2, 3)), (fmpq(2, 3), fmpq(4, 3)), (fmpq(4, 3), fmpq(5, 3)))
    # Both sides are polynomials of degree 1 in beta and 4 in i: 3 x 5 points prove the identity.
    exact_holds = all(
        ((j - beta) / 3 + i) * (k + 1) * (k + 2) * (k + 3)
        == (k - beta) * 9 * (lower[j][0] + i) * (lower[j][1] + i) * (1 + i)
        for j in range(3)
        for beta in (fmpq(0), fmpq(1, 2), fmpq(7, 3))
        for i in range(5)
        for k in (j + 3 * i,)
    )
    points = [(tau, beta) for tau in (fmpq(-9), fmpq(-7, 3), fmpq(1, 2), fmpq(8)) for beta in BETAS]
    agrees = all_of(
        _equal(
            printed.theta_by_theorem_3(tau, beta, initial_values(beta, 256), 256),
            theta_by("laplace", tau, beta, digits=30),
        )
        for tau, beta in points
    )
    return settled(
        SECTION,
        "A-theorem-3",
        "th:3, eq:btau",
        r"\theta=\theta(0)\,{}_1F_2(-\tfrac\beta3;\tfrac13,\tfrac23;\tfrac{\tau^3}9)+\ldots",
        statement,
        Check(
            Rung.EXACT, "quotient of consecutive terms against the equation's recurrence, as polynomials", exact_holds
        ),
        Check(Rung.POINTS, f"three FLINT 1F2 against the Laplace integral at {len(points)} points", agrees),
    )


def _coefficients() -> Entry:
    count = 8
    dlmf = [printed.dlmf_coefficients(j, count) for j in range(3)]
    by_equation = [coefficient(k) for k in range(count)]
    by_inversion = [coefficient_by_inversion(k) for k in range(count)]
    return settled(
        SECTION,
        "A-coefficients",
        "eq:eier, eq:cisdef",
        r"c_0=1,\quad c_k \text{ from DLMF 16.11.4}",
        "c_0 = 1, and DLMF 16.11.4 gives the same c_k(β) for the three functions (exactly, k < 8)",
        Check(
            Rung.EXACT,
            "DLMF 16.11.4 for each 1F2 against the differential equation, as polynomials in β",
            all(row == by_equation for row in dlmf),
            f"c_1 = {by_equation[1]} (x is β)",
        ),
        Check(Rung.EXACT, "Lagrange inversion at the saddle point, as polynomials in β", by_inversion == by_equation),
        note="proofs/asymptotic_coefficients.md; any k: theta.asymptotic_coefficients",
    )


def _small(j: int) -> Entry:
    checked = [(x, beta) for x in (fmpq(30), fmpq(60)) for beta in BETAS]
    agrees = all_of(errors.small_error_within(j, x, beta) for x, beta in checked)
    return settled(
        SECTION,
        f"A-{_SMALL[j]}",
        f"th:4, eq:{_SMALL[j]}",
        _SMALL_SOURCE[j],
        "The formula holds as τ → −∞ for every β that is not an integer",
        Check(Rung.PAGE, "proofs/connection.md, Theorem 4: DLMF 16.11.8 with the parameters put in", True),
        Check(
            Rung.POINTS,
            f"4 terms of e_r + i e_i and 9 of h at {len(checked)} points: the error is at most twice the "
            "first omitted terms",
            agrees,
        ),
        note="Not being an integer is sufficient, not necessary: the formula also holds at β = 0, 1, 2, ...",
    )


def _cancellation() -> Entry:
    answers = []
    for beta in BETAS:
        first, second, third = paper_initial_values(beta, 256)
        with working_bits(256):
            outer = [arb((j - beta) / 3).rgamma() * arb(3) ** arb(fmpq(3 - j, 3)) for j in range(3)]
            real = 2 * first * outer[0] - second * outer[1] - third * outer[2]
            imaginary = second * outer[1] - third * outer[2]
            answers += [_is_zero(part) for part in (real, imaginary)]
    agrees = all_of(answers)
    return settled(
        SECTION,
        "A-cancellation",
        "line 2446",
        r"\text{the coefficients of } e_r, e_i \text{ vanish}",
        "With the initial values t01-t03 the highly oscillatory terms cancel",
        Check(
            Rung.PAGE,
            "proofs/negative.md: Θ minus N terms of its power series is below the next term, for every N",
            True,
        ),
        Check(
            Rung.POINTS,
            f"both coefficients in balls of radius below 1e-60 around 0 at {len(BETAS)} values of β",
            agrees,
        ),
    )


def _initial_value(j: int) -> Entry:
    label = f"t0{j + 1}"
    agrees = all_of(_equal(paper_initial_values(beta, 256)[j], initial_values(beta, 256)[j]) for beta in BETAS)
    power = ("", "3^(1/3) ", "3^(2/3) ")[j]
    factors = ("Γ((1-β)/3) Γ((2-β)/3)", "Γ(-β/3) Γ((2-β)/3)", "Γ(-β/3) Γ((1-β)/3)")[j]
    derivative = (r"\Theta(0)", r"\Theta'(0)", r"\Theta''(0)")[j]
    return settled(
        SECTION,
        f"A-{label}",
        f"eq:{label}",
        rf"{derivative}=\Gamma(({j}-\beta)/3)/(3^{{({3 - j}+\beta)/3}}\Gamma(-\beta))",
        f"{label} gives the solution without oscillatory terms, for every β that is not 0, 1, 2, ...",
        Check(Rung.PAGE, "proofs/laplace.md section 1 (substitution r^3/3) and proofs/initial_values.md", True),
        Check(Rung.POINTS, f"printed form against the entire form at {len(BETAS)} values of β, 70 digits", agrees),
        corrected=f"for every real β: 2π 3^(2β/3 - 1/2) {power}/ ({factors})",
        note=f"As printed it is ∞/∞ at β = {j}, {j + 3}, {j + 6}, ...; the entire form is not.",
    )


def _leading_behaviour() -> Entry:
    # Gamma(1+beta)/Gamma(1+beta-3k) = beta (beta-1)..(beta-3k+1) = (-1)^(3k) (-beta)_(3k), as polynomials.
    identity = True
    falling, rising = fmpq_poly([1]), fmpq_poly([1])
    for i in range(30):
        falling *= fmpq_poly([-i, 1])
        rising *= fmpq_poly([i, -1])
        identity &= falling == rising * (-1) ** (i + 1)
    points = [(x, beta) for x in (fmpq(20), fmpq(80)) for beta in BETAS]
    agrees = all_of(errors.power_series_within(x, beta) for x, beta in points)
    return settled(
        SECTION,
        "A-leading",
        "eq:hdef, line 2459",
        r"\Theta(\tau,\beta)\sim 3^{1-\beta/3}\Gamma(1+\beta)h(\tau,\beta)\sim(-\tau)^\beta",
        "Θ ~ 3^(1-β/3) Γ(1+β) h ~ (-τ)^β as τ → −∞, β not -1, -2, ...",
        Check(Rung.PAGE, "proofs/negative.md: the rest after N terms is at most the next term, once 3N > β", True),
        Check(
            Rung.EXACT,
            "the terms of 3^(1-β/3) Γ(1+β) h are those of that page, as polynomials (k <= 10)",
            identity,
        ),
        Check(Rung.POINTS, f"three terms against the Laplace integral at {len(points)} points", agrees),
        note="At β = -1, -2, ... every term of h is 0 and Γ(1+β) infinite; the product keeps its limit.",
    )


def _large(j: int) -> Entry:
    points = [(tau, beta) for tau in (fmpq(30), fmpq(60)) for beta in BETAS]
    agrees = all_of(errors.large_error_within(j, tau, beta) for tau, beta in points)
    left = (r"{}_1F_2", r"\tau\,{}_1F_2", r"\tfrac{\tau^2}2{}_1F_2")[j]
    return settled(
        SECTION,
        f"A-{_LARGE[j]}",
        f"th:5, eq:{_LARGE[j]}",
        rf"{left}(\ldots)\sim 3^{{({3 - j})/3}}e_1/\Gamma(({j}-\beta)/3)",
        "The formula holds as τ → +∞ for every β that is not an integer",
        Check(Rung.PAGE, "proofs/connection.md, Theorem 5, from proofs/positive.md", True),
        Check(
            Rung.POINTS,
            f"4 terms of e_1 at {len(points)} points: the error is at most twice the first omitted term",
            agrees,
        ),
        corrected=f"needs a condition, which Theorem 5 does not state: it fails at β = {j}, {j + 3}, {j + 6}, ...",
    )


def _large_condition() -> Entry:
    value = printed.theorem_3_function(0, fmpq(30), fmpq(0), 128)
    reciprocal = arb(0).rgamma()
    # At beta = 0 the coefficient of tau^3 is (0 - beta)/6 = 0, and every later one is a multiple of it.
    third = taylor_coefficients(fmpq(0), 4, 64)[3]
    constant = third.is_zero() and reciprocal_gamma(fmpq(0), 64).is_zero()
    return settled(
        SECTION,
        "A-theorem-5-condition",
        "th:5",
        r"\text{(no condition on } \beta \text{)}",
        "Theorem 5 holds for every β, as printed without a condition",
        Check(
            Rung.EXACT,
            "β = 0: the factor (k - β) of the recurrence is 0 at k = 0, so y_0 = 1; 1/Γ(0) = 0",
            False if constant else None,
            "β = 0: the left side of blarge1 is 1, the right side is 0",
        ),
        Check(
            Rung.BALLS,
            "FLINT's 1F2 and 1/Γ at β = 0, τ = 30",
            False if value == 1 and reciprocal.is_zero() else None,
            f"left {ball_text(value)}, right has the factor 1/Γ(0) = {reciprocal}",
        ),
        corrected="Theorem 5 holds for every β that is not an integer. blarge1, blarge2, blarge3 fail at "
        "β = 0, 3, 6, ..., at 1, 4, 7, ..., and at 2, 5, 8, ...; tlarge fails at 0, 1, 2, ...",
    )


def _theta_large() -> Entry:
    points = [(tau, beta) for tau in (fmpq(40), fmpq(90)) for beta in BETAS]
    agrees = all_of(errors.theta_error_within(tau, beta) for tau, beta in points)
    return settled(
        SECTION,
        "A-tlarge",
        "eq:tlarge",
        r"\Theta\sim\frac{3^{1-\beta/3}}{\Gamma(-\beta)}e_1\sim\frac{\sqrt\pi}{\Gamma(-\beta)}e^{(2/3)\tau^{3/2}}\tau^{-\beta/2-3/4}",
        "Both asymptotic forms hold as τ → +∞ for every β that is not 0, 1, 2, ...",
        Check(Rung.PAGE, "proofs/positive.md: explicit remainder", True),
        Check(
            Rung.POINTS,
            f"4 terms against the Taylor series at {len(points)} points: the error is at most twice the first "
            "omitted term",
            agrees,
        ),
        corrected="needs the condition β not in {0, 1, 2, ...}; at β = n, Θ is a polynomial ~ (-τ)^n",
    )


def _equal(first: arb, second: arb) -> bool | None:
    """Whether two accurate enclosures overlap; ``None`` when one is not accurate enough to tell."""
    if min(relative_bits(first), relative_bits(second)) <= 60:
        return None
    return bool(first.overlaps(second))


def _is_zero(part: arb) -> bool | None:
    """False when the ball excludes 0, True when it holds 0 and is below 1e-60, ``None`` otherwise."""
    if part > 0 or part < 0:
        return False
    return True if certainly_less(part.abs_upper(), arb(fmpq(1, 10**60))) else None
