"""What the pages on Θ state, as texts of formulas, and steps of their proofs as exact identities in β and k.

Each step is taken from the differential equation θ''' - τ θ' + β θ = 0, not from the printed formulas. x = -τ.
"""

from __future__ import annotations

from flint import fmpq, fmpq_mpoly, fmpq_poly

from gspot_verified.paper.appendix_a.hypergeometric import INTEGER_POLYNOMIAL
from gspot_verified.paper.checks.closed_forms import ALGEBRA as FORMULAS
from gspot_verified.paper.checks.formulas import closed_form, put
from gspot_verified.paper.checks.identities import Algebra
from gspot_verified.paper.checks.page import Page
from gspot_verified.theta_function.value.asymptotic_coefficients import coefficient_by_inversion

MOMENT = "3^((k-beta)/3-1)*Gamma((k-beta)/3)/Gamma(-beta)"
"""proofs/laplace.md, section 1: the derivative of order k of Θ at 0."""
POWER = "(-1)^k*Gamma(3*k-beta)/(Gamma(-beta)*3^k*fac(k))*x^(beta-3*k)"
"""proofs/negative.md: the term t_k."""
SADDLE = "sqrt(pi)/Gamma(-beta)*tau^(-beta/2)*tau^(-3/4)*e^(2*lam/3)*(3/2)^k*tau^(-3*k/2)"
"""proofs/positive.md: K √π g_k λ^(-k) with g_k = (3/2)^k c_k, without c_k."""
COEFFICIENTS = 8
"""How many c_k are tried in the recurrence of the equation."""
_ALGEBRA = Algebra("lam m beta r tau")
_SYMBOLS = _ALGEBRA.symbols


def equal(first: str, second: str) -> bool:
    """Whether two formulas are proved to be equal, for all values of their symbols."""
    return (closed_form(first) / closed_form(second)).is_one()


def moments_obey_the_equation() -> bool:
    """θ^(k+3)(0) = (k - β) θ^(k)(0), the value 1/2 of the integral of r² exp(-r³/3)/Γ(3) at β = -3, k = 0."""
    return equal(put(MOMENT, k="k+3"), f"(k-beta)*({MOMENT})") and equal(put(MOMENT, k="0", beta="-3"), "1/2")


def moments_move_with_beta() -> bool:
    """Θ'(β) = -β Θ(β - 1): the derivative of order k + 1 at 0."""
    return equal(put(MOMENT, k="k+1"), f"-beta*({put(MOMENT, beta='beta-1')})")


def integrand_is_a_derivative() -> bool:
    """-β r^(-β-1) + τ r^(-β) - r^(2-β) is the derivative of r^(-β) over the exponential: times r^(β+1)."""
    exponent = _ALGEBRA.read("r*tau - r^3/3")
    slope = -_SYMBOLS["beta"] + _SYMBOLS["r"] * exponent.derivative("r")
    return bool((slope - _ALGEBRA.read("-beta + tau*r - r^3")).is_zero())


def derivative_is_an_integral() -> bool:
    """-β Γ(-β) Θ(β - 1) is the integral of r^(-β) exp(r τ - r³/3): -β Γ(-β)/Γ(1 - β) = 1."""
    return equal("-beta*Gamma(-beta)", "Gamma(1-beta)")


def derivatives_are_integrals() -> bool:
    """Γ(-β) times the derivative of order n is Γ(n - β) Θ(β - n): one more derivative has the factor n - β."""
    return equal("(n-beta)*Gamma(n-beta)", "Gamma(n+1-beta)")


def powers_solve_the_equation() -> bool:
    """-θ_xxx - x θ_x + β θ = 0: 3 (k + 1) t_(k+1) = (β - 3k)(β - 3k - 1)(β - 3k - 2) t_k x^(-3); t_0 = x^β."""
    ratio = "(beta-3*k)*(beta-3*k-1)*(beta-3*k-2)/(3*(k+1)*x^3)"
    return equal(put(POWER, k="k+1"), f"({ratio})*({POWER})") and equal(put(POWER, k="0"), "x^beta")


def powers_move_with_beta() -> bool:
    """The derivative in τ of t_k for β is -β times t_k for β - 1."""
    return equal(f"-(beta-3*k)/x*({POWER})", f"-beta*({put(POWER, beta='beta-1')})")


def polynomial_solves_the_equation() -> bool:
    """The terms of Θ(τ, n): from τ^j to τ^(j-3), j = n - 3m, by -j (j - 1)(j - 2)/(3 (m + 1)); (-1)^n τ^n first."""
    ratio = "-(n-3*m)*(n-3*m-1)*(n-3*m-2)/(3*(m+1)*tau^3)"
    following = equal(put(INTEGER_POLYNOMIAL, m="m+1"), f"({ratio})*({INTEGER_POLYNOMIAL})")
    return following and equal(put(INTEGER_POLYNOMIAL, m="0"), "(-1)^n*tau^n")


def _euler(value: fmpq_mpoly) -> fmpq_mpoly:
    """λ d/dλ on exp(2λ/3) λ^m times the value."""
    return (_SYMBOLS["m"] + _SYMBOLS["lam"] * fmpq(2, 3)) * value + _SYMBOLS["lam"] * value.derivative("lam")


def _orders() -> dict[int, fmpq_mpoly]:
    """The equation times λ² on exp(2λ/3) λ^m, by powers of λ."""
    one = _ALGEBRA.constant(1)
    third = _euler(one)
    for shift in (fmpq(2, 3), fmpq(4, 3)):
        third = _euler(third) - shift * third
    square = _SYMBOLS["lam"] ** 2
    whole = fmpq(27, 8) * third - fmpq(3, 2) * square * _euler(one) + _SYMBOLS["beta"] * square
    return dict(_ALGEBRA.coefficients(whole, "lam"))


def saddle_has_the_exponents_of_the_equation() -> bool:
    """λ^(m+3) cancels, and λ^(m+2) has the factor -3k at the exponent of the term number k, for every k and β."""
    orders = _orders()
    if max(orders) != 2:
        return False
    tau, e = (closed_form(SADDLE).exponent(name) for name in ("tau", "e"))
    at_k = FORMULAS.substitute(FORMULAS.bring(orders[2]), {"m": tau * fmpq(2, 3)})
    return at_k == FORMULAS.read("-3*k") and e == FORMULAS.read("2*lam/3")


def saddle_obeys_the_recurrence() -> bool:
    """3k g_k = A_1(a - k + 1) g_(k-1) + A_0(a - k + 2) g_(k-2), with the c_k of the saddle point."""
    orders, beta = _orders(), fmpq_poly([0, 1])
    g = [fmpq_poly([0]), *(coefficient_by_inversion(k) * fmpq(3, 2) ** k for k in range(COEFFICIENTS))]
    start = -beta / 3 - fmpq(1, 2)

    def at(order: int, m: fmpq_poly) -> fmpq_poly:
        powers = _ALGEBRA.coefficients(orders[order], "m")
        return sum((value.leading_coefficient() * m**k for k, value in powers.items()), fmpq_poly([0]))

    return all(
        3 * k * g[k + 1] == at(1, start - k + 1) * g[k] + at(0, start - k + 2) * g[k - 1]
        for k in range(1, COEFFICIENTS)
    )


def fourier_transform_inverts() -> bool:
    """(1/3) Σ_m ω^(m (i - j)) is 1 for i = j and 0 for the other i, j = 0, 1, 2, with ω² = -ω - 1."""
    omega, modulus = fmpq_poly([0, 1]), fmpq_poly([1, 1, 1])

    def mean(i: int, j: int) -> fmpq_poly:
        return sum((omega ** (m * (i - j) % 3) for m in range(3)), fmpq_poly([0])) % modulus / 3

    means = [[mean(i, j) for j in range(3)] for i in range(3)]
    return means == [[fmpq_poly([int(i == j)]) for j in range(3)] for i in range(3)]


LAPLACE = Page("laplace", (integrand_is_a_derivative, moments_obey_the_equation, moments_move_with_beta))
NEGATIVE = Page("negative", (powers_solve_the_equation, powers_move_with_beta))
EVERY_K = Page("asymptotic_coefficients", (saddle_has_the_exponents_of_the_equation, saddle_obeys_the_recurrence))
POSITIVE = Page("positive", (saddle_has_the_exponents_of_the_equation, saddle_obeys_the_recurrence))
INITIAL_VALUES = Page("initial_values", (moments_obey_the_equation, polynomial_solves_the_equation))
CONNECTION = Page("connection", (fourier_transform_inverts, moments_obey_the_equation, moments_move_with_beta))
SIGNS_LEFT = Page("signs", (powers_solve_the_equation, powers_move_with_beta))
SIGNS_RIGHT = Page("signs", (derivative_is_an_integral, derivatives_are_integrals, *POSITIVE.steps))
SIGNS_INTEGRAL = Page("signs", (integrand_is_a_derivative, derivative_is_an_integral))
IWC = Page("iwc", POSITIVE.steps)
"""The pages with the steps that the ledger takes from each."""
