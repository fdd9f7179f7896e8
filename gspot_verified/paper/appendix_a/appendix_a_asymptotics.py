"""Ledger of Appendix A, second half: the asymptotic series of th:4 and th:5, the condition of th:5, eq. tlarge.

Where a formula rests on a proof page, the check compares it with the page's statement as closed forms, for all β and k.
"""

from __future__ import annotations

from collections.abc import Sequence

from flint import arb, fmpq

from gspot_verified.numbers.balls import ball_text, certainly_less, working_bits
from gspot_verified.paper.appendix_a import asymptotic_errors as errors
from gspot_verified.paper.appendix_a import hypergeometric as printed
from gspot_verified.paper.appendix_a.theta_pages import (
    COEFFICIENTS,
    CONNECTION,
    EVERY_K,
    INITIAL_VALUES,
    POSITIVE,
    SADDLE,
)
from gspot_verified.paper.checks.closed_forms import ALGEBRA, ClosedForm
from gspot_verified.paper.checks.entry import Check, Entry, Rung, Section, all_of
from gspot_verified.paper.checks.formulas import Forms, FormulaClaim, closed_form, mended, put, quotient
from gspot_verified.paper.checks.identities import in_greek
from gspot_verified.paper.checks.page import joined

SECTION = Section("Appendix A")
EXCEPTIONS: dict[str, str] = {"0": "3*m", "1": "1+3*m", "2": "2+3*m"}
"""The β = j + 3m, m = 0, 1, 2, ..., at which formula j + 1 of th:5 fails."""
CITED = "which is cited and not proved here"
"""What stands beside a theorem of another work."""
TRIED = 3
"""How many m, and how many times three integers β, are tried in balls."""
SMALL_NAMES = ("bsmall1", "bsmall2", "bsmall3")
LARGE_NAMES = ("blarge1", "blarge2", "blarge3")
_SMALL_SOURCE = (
    r"{}_1F_2(-\beta/3;1/3,2/3;\tau^3/9) \sim 3\Gamma((3+\beta)/3)h + (3/\Gamma(-\beta/3)) 2e_r",
    r"\tau{}_1F_2(\ldots) \sim -3^{2/3}\Gamma((2+\beta)/3)h - (3^{2/3}/\Gamma((1-\beta)/3))(e_r-\sqrt{3}e_i)",
    r"(\tau^2/2){}_1F_2(\ldots) \sim 3^{1/3}\Gamma((1+\beta)/3)h + (3^{1/3}/\Gamma((2-\beta)/3))(-e_r-\sqrt{3}e_i)",
)


STEPS: dict[str, str] = {"e": "3*i/(2*x^(3/2))", "e_1": "3/(2*tau^(3/2))"}
"""From one term of a series to the next, without c_k: 3/(2 λ) with λ = τ^(3/2), which is -i x^(3/2) at τ = x e^(iπ)."""


def every_coefficient(series: str) -> Check:
    """That the c_k of a series are those of the equation for every k, not for the ones alone that were computed."""
    claim = FormulaClaim({series: printed.SERIES[series]})
    return EVERY_K.carries(
        claim.check(
            f"the c_k of the series: for k < {COEFFICIENTS} by calculation, for every k since the equation determines "
            "c_k from those before it, with a factor 3k, where DLMF 16.11.8 holds",
            lambda forms: [
                closed_form(put(printed.SERIES[series], k="k+1")) / forms[series] / closed_form(STEPS[series])
            ],
        )
    )


def small(j: int, betas: Sequence[fmpq]) -> Entry:
    """Formula j + 1 of th:4."""
    claim = FormulaClaim(printed.SMALL)
    checked = [(x, beta) for x in (fmpq(30), fmpq(60)) for beta in [*betas, *_allowed_integers(j)]] if betas else []
    return SECTION.settled(
        f"A-{SMALL_NAMES[j]}",
        f"th:4, eq:{SMALL_NAMES[j]}",
        _SMALL_SOURCE[j],
        f"By DLMF 16.11.8, {CITED}, the asymptotic form of eq. {SMALL_NAMES[j]} holds as τ → −∞ for every β that is "
        "not an integer",
        joined(
            CONNECTION.carries(
                claim.check(
                    "DLMF 16.11.8 with the parameters of th:3 put in, as closed forms in β, k and x",
                    lambda forms: _by_dlmf(j, forms),
                )
            ),
            every_coefficient("e"),
        ),
        Rung.POINTS.check(
            f"4 terms of e_r + i e_i and 9 of h at {len(checked)} points, integers β among them: the error is at most "
            "twice the first omitted terms",
            all_of(errors.small_error_within(j, x, beta) for x, beta in checked),
        ),
        note=f"At β = {j - 3}, {j - 6}, {j - 9}, ... the right side as printed is 0 times a pole of Γ. That it fails "
        "at another integer is not shown: at the points tried the error is as small at β = "
        f"{', '.join(map(str, _allowed_integers(j)))}.",
    )


def _by_dlmf(j: int, forms: Forms) -> list[ClosedForm]:
    """DLMF 16.11.8: Γ(a)/(Γ(b) Γ(b')) 1F2(a; b, b'; -z) ~ H(z) + E(z e^(-iπ)) + E(z e^(iπ)), z = x^3/9.

    The two E are conjugate, so their sum is twice the real part of the first, which holds e^(-2i lam/3).
    """
    a, b, other = (f"({printed.FUNCTIONS[f'{name} {j}']})" for name in ("upper", "lower", "other lower"))
    front = closed_form(f"Gamma({b})*Gamma({other})/Gamma({a})*({put(printed.FUNCTIONS[f'front {j}'], tau='-x')})")
    algebraic = closed_form(
        f"(-1)^k/fac(k)*Gamma({a}+k)/(Gamma({b}-{a}-k)*Gamma({other}-{a}-k))*x^(3*(-{a}-k))*9^({a}+k)"
    )
    nu = f"({a}-{b}-{other}+1/2)"
    oscillating = closed_form(
        f"2^(-1/2)*pi^(-1/2)*2^(-{nu}-1/2)*e^(-2/3*i*lam)*2^({nu}-k)*3^(k-{nu})*x^(3/2*({nu}-k))*e^(-i*pi*({nu}-k)/2)"
    )
    weight = front * oscillating / (forms[f"e {j}"] * closed_form(printed.SERIES["e"]))
    # 2 Re(W (e_r + i e_i)) = 2 Re(W) e_r - 2 Im(W) e_i
    real, imaginary = weight.turned() or (weight, weight)
    return [
        front * algebraic / (forms[f"h {j}"] * closed_form(printed.SERIES["h"])),
        quotient(closed_form("2") * real, forms[f"real {j}"]),
        quotient(closed_form("-2") * imaginary, forms[f"imaginary {j}"]),
    ]


def large(j: int, betas: Sequence[fmpq]) -> Entry:
    """Formula j + 1 of th:5."""
    claim = FormulaClaim(printed.LARGE)
    tried = [*betas, *_allowed_integers(j), fmpq(-1), fmpq(-2), fmpq(-3)]
    points = [(tau, beta) for tau in (fmpq(30), fmpq(60)) for beta in tried] if betas else []
    left = (r"{}_1F_2", r"\tau\,{}_1F_2", r"\tfrac{\tau^2}2{}_1F_2")[j]
    return SECTION.settled(
        f"A-{LARGE_NAMES[j]}",
        f"th:5, eq:{LARGE_NAMES[j]}",
        rf"{left}(\ldots)\sim 3^{{({3 - j})/3}}e_1/\Gamma(({j}-\beta)/3)",
        f"The asymptotic form of eq. {LARGE_NAMES[j]} holds as τ → +∞ for every β except {j}, {j + 3}, {j + 6}, ..., "
        "where the c_k with k >= 8 are those of the equation by DLMF 16.11.8, which is cited and not proved here",
        joined(
            CONNECTION.carries(
                claim.check(
                    "β < 0: a third of eq. tlarge over the initial value; e_1 as in proofs/positive.md: "
                    "closed forms in β, k and τ",
                    lambda forms: [_by_connection(j) / forms[f"factor {j}"], _by_saddle_point()],
                )
            ),
            CONNECTION.carries(
                claim.check(
                    "the step from β - 1 to β: d/dτ takes the formula for β to that for β - 1, as closed forms in β",
                    lambda forms: [_step(j, forms)],
                )
            ),
            every_coefficient("e_1"),
        ),
        Rung.POINTS.check(
            f"4 terms of e_1 at {len(points)} points, integers β among them: the error is at most twice the first "
            "omitted term",
            all_of(errors.large_error_within(j, tau, beta) for tau, beta in points),
        ),
        corrected=f"needs a condition, which th:5 does not state: it fails at β = {j}, {j + 3}, {j + 6}, ... "
        "(A-th5-condition)",
    )


def _by_connection(j: int) -> ClosedForm:
    value = list(printed.INITIAL_VALUES.values())[j]
    return closed_form(f"({printed.THETA['large front']})/(3*({value}))")


def _by_saddle_point() -> ClosedForm:
    """The terms of eq. tlarge over those of the page, for all k."""
    return closed_form(printed.THETA["large front"]) * closed_form(printed.SERIES["e_1"]) / closed_form(SADDLE)


def _step(j: int, forms: Forms) -> ClosedForm:
    """y_j' = y_(j-1)(τ, β - 1) for j = 1, 2 and -β y_2(τ, β - 1) for j = 0; (e^(2 lam/3))' = τ^(1/2) e^(2 lam/3)."""
    before = (j - 1) % 3
    slope = closed_form("-beta" if j == 0 else "1")
    lower = closed_form(f"({put(printed.LARGE[f'factor {before}'], beta='beta-1')})*({_leading_e_1('beta-1')})")
    return slope * lower / (forms[f"factor {j}"] * closed_form(f"({_leading_e_1('beta')})*tau^(1/2)"))


def _leading_e_1(beta: str) -> str:
    return put(printed.SERIES["e_1"], k="0", beta=beta)


def _allowed_integers(j: int) -> list[fmpq]:
    """The integers β = 0, 1, ... below 3 TRIED that are not among the exceptions of formula j + 1."""
    texts = (put(EXCEPTIONS[str(j)], m=str(m)) for m in range(TRIED))
    exceptions = [printed.value_of(text, fmpq(0), 64) for text in texts]
    return [fmpq(n) for n in range(3 * TRIED) if not any(value == n for value in exceptions)]


def large_condition() -> Entry:
    """That th:5 states no condition on β; where it fails, exactly."""
    return SECTION.settled(
        "A-th5-condition",
        "th:5",
        r"\text{(no condition on } \beta \text{)}",
        "The three formulas of th:5 hold for every β, as printed without a condition",
        Rung.EXACT.check(
            "β = j + 3m, for all m: the right side has the factor 1/Γ(-m) = 0; the recurrence's factor k - β is 0 at "
            "k = j + 3m, so the left side is a polynomial that begins with τ^j/j!",
            False if all(_vanishes(j) for j in range(3)) else None,
            "β = 0: the left side of blarge1 is 1, the right side is 0",
        ),
        Rung.BALLS.check(
            "FLINT's 1F2 and the right sides at τ = 30, β = j, j + 3, j + 6 for each formula; at τ = 60 for the "
            f"other integers from 0 to {3 * TRIED - 1}",
            mended(*_at_exceptions()),
            f"at β = 0: left {ball_text(printed.fundamental_solution(0, fmpq(30), fmpq(0), 128))}, right "
            f"{ball_text(printed.value_of(printed.LARGE['factor 0'], fmpq(0), 128))}; at the other integers from 0 "
            f"to {3 * TRIED - 1} the formulas hold to the accuracy of the series",
        ),
        corrected="With m = 0, 1, 2, ...: "
        + ", ".join(
            f"eq. {LARGE_NAMES[int(j)]} needs β other than {text.replace('*', '')}" for j, text in EXCEPTIONS.items()
        ),
        note="That the formulas hold with these conditions: A-blarge1 to A-blarge3; eq. tlarge needs β other than "
        "0, 1, 2, ... (A-tlarge). Proof: proofs/connection.md.",
    )


def _vanishes(j: int) -> bool:
    """Whether the right side is a number without zeros times 1/Γ(a), and a = -m at the exceptions, for all m."""
    upper, exception = printed.FUNCTIONS[f"upper {j}"], EXCEPTIONS[str(j)]
    number = closed_form(f"({printed.LARGE[f'factor {j}']})*Gamma({upper})")
    own = closed_form(put(upper, beta=exception)) / closed_form("-m")
    index = ALGEBRA.read(f"{j}+3*m") - ALGEBRA.read(exception)
    return number.is_positive() and own.is_one() and bool(index.is_zero())


def _at_exceptions() -> tuple[bool | None, bool | None]:
    """Whether the formulas hold at the exceptions, and whether they hold at the other integers."""
    at_exceptions: list[bool | None] = []
    elsewhere: list[bool | None] = []
    for j in range(3):
        for m in range(TRIED):
            beta = fmpq(j + 3 * m)
            left = printed.fundamental_solution(j, fmpq(30), beta, 128)
            right = printed.value_of(printed.LARGE[f"factor {j}"], beta, 128)
            at_exceptions.append(False if right.is_zero() and (left > 0 or left < 0) else None)
        elsewhere += [errors.large_error_within(j, fmpq(60), beta) for beta in _allowed_integers(j)]
    return all_of(at_exceptions) if None not in at_exceptions else None, all_of(elsewhere)


def theta_large(betas: Sequence[fmpq]) -> Entry:
    """Eq. tlarge."""
    claim = FormulaClaim(printed.THETA)
    points = [(tau, beta) for tau in (fmpq(40), fmpq(90)) for beta in betas]
    return SECTION.settled(
        "A-tlarge",
        "eq:tlarge",
        r"\Theta\sim\frac{3^{1-\beta/3}}{\Gamma(-\beta)}e_1\sim\frac{\sqrt\pi}{\Gamma(-\beta)}e^{(2/3)\tau^{3/2}}\tau^{-\beta/2-3/4}",
        "Both asymptotic forms hold as τ → +∞ for every β that is not 0, 1, 2, ..., where the c_k with k >= "
        f"{COEFFICIENTS} are those of the equation by DLMF 16.11.8, {CITED}",
        joined(
            POSITIVE.carries(
                claim.check(
                    "(explicit remainder): each term, as a closed form in β, k and τ",
                    lambda forms: [_by_saddle_point(), forms["large leading"] / closed_form(put(SADDLE, k="0"))],
                )
            ),
            POSITIVE.carries(
                claim.check(
                    "the second form is the first with k = 0, as closed forms in β and τ",
                    lambda forms: [forms["large front"] * closed_form(_leading_e_1("beta")) / forms["large leading"]],
                )
            ),
            INITIAL_VALUES.carries(
                claim.check(
                    "the leading term of the polynomial at β = n, for all n",
                    lambda forms: [closed_form(put(printed.INTEGER_POLYNOMIAL, m="0")) / forms["integer leading"]],
                )
            ),
            every_coefficient("e_1"),
        ),
        Rung.POINTS.check(
            f"4 terms against the Taylor series at {len(points)} points: the error is at most twice the first "
            "omitted term, and the leading form agrees with the first term",
            all_of(all_of([errors.theta_error_within(tau, beta), _leading_agrees(tau, beta)]) for tau, beta in points),
        ),
        corrected="needs the condition β not in {0, 1, 2, ...}; at β = n, Θ is a polynomial with leading term "
        f"{in_greek(printed.THETA['integer leading'])}",
    )


def _leading_agrees(tau: fmpq, beta: fmpq) -> bool | None:
    first = printed.e_1_terms(tau, beta, 1, 256)[0]
    with working_bits(256):
        large = arb(tau) * arb(tau).sqrt()
    front = printed.value_of(printed.THETA["large front"], beta, 256)
    leading = printed.value_of(printed.THETA["large leading"], beta, 256, tau=tau, lam=large)
    with working_bits(256):
        return certainly_less(abs(front * first - leading), abs(leading) * fmpq(1, 10**40))
