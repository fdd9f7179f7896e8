"""The formulas of Appendix A as printed, as texts, and what they give at points.

The texts are evaluated by FLINT's hypergeometric and Γ functions and by truncated sums, so that they share no code with
the routes of :mod:`gspot_verified.theta_function`. Nothing here carries a remainder: these are printed formulas, not
enclosures of Theta. x is -τ, lam is x^(3/2) or τ^(3/2); a series is the sum over k of c_k times its text (h: without
c_k).
"""

from __future__ import annotations

from flint import acb, arb, fmpq, fmpq_poly

from gspot_verified.numbers.balls import working_bits
from gspot_verified.paper.checks.formulas import evaluate_text
from gspot_verified.theta_function.value.asymptotic_coefficients import coefficient

FUNCTIONS: dict[str, str] = {
    "upper 0": "-beta/3", "lower 0": "1/3", "other lower 0": "2/3", "front 0": "1",
    "upper 1": "1/3-beta/3", "lower 1": "2/3", "other lower 1": "4/3", "front 1": "tau",
    "upper 2": "2/3-beta/3", "lower 2": "4/3", "other lower 2": "5/3", "front 2": "tau^2/2",
    "argument": "tau^3/9",
}  # fmt: skip
"""The parameters of the three 1F2 of th:3."""
SERIES: dict[str, str] = {
    "h": "3^(beta/3-1)*x^beta/(fac(k)*3^k*x^(3*k)*Gamma(1+beta-3*k))",
    "e": "sqrt(pi)*3^(beta/3-1)*x^(-beta/2-3/4)*e^(i*(pi*beta/6+pi/4-2*lam/3))*i^k*3^k/(2^k*x^(3*k/2))",
    "e_1": "sqrt(pi)*3^(beta/3-1)*tau^(-beta/2-3/4)*e^(2*lam/3)*3^k/(2^k*tau^(3*k/2))",
}
SMALL: dict[str, str] = {
    "h 0": "3*Gamma((3+beta)/3)", "e 0": "3/Gamma(-beta/3)", "real 0": "2", "imaginary 0": "0",
    "h 1": "-3^(2/3)*Gamma((2+beta)/3)", "e 1": "-3^(2/3)/Gamma((1-beta)/3)",
    "real 1": "1", "imaginary 1": "-sqrt(3)",
    "h 2": "3^(1/3)*Gamma((1+beta)/3)", "e 2": "3^(1/3)/Gamma((2-beta)/3)",
    "real 2": "-1", "imaginary 2": "-sqrt(3)",
}  # fmt: skip
"""th:4: function j is (h j) h + (e j) ((real j) e_r + (imaginary j) e_i)."""
LARGE: dict[str, str] = {
    "factor 0": "3/Gamma(-beta/3)", "factor 1": "3^(2/3)/Gamma((1-beta)/3)", "factor 2": "3^(1/3)/Gamma((2-beta)/3)",
}  # fmt: skip
"""th:5: function j is (factor j) e_1."""
INITIAL_VALUES: dict[str, str] = {
    "t01": "Gamma(-beta/3)/(3^((3+beta)/3)*Gamma(-beta))",
    "t02": "Gamma((1-beta)/3)/(3^((2+beta)/3)*Gamma(-beta))",
    "t03": "Gamma((2-beta)/3)/(3^((1+beta)/3)*Gamma(-beta))",
}
ENTIRE_INITIAL_VALUES: dict[str, str] = {
    "t01": "2*pi*3^(2*beta/3-1/2)/(Gamma((1-beta)/3)*Gamma((2-beta)/3))",
    "t02": "2*pi*3^(2*beta/3-1/2)*3^(1/3)/(Gamma(-beta/3)*Gamma((2-beta)/3))",
    "t03": "2*pi*3^(2*beta/3-1/2)*3^(2/3)/(Gamma(-beta/3)*Gamma((1-beta)/3))",
}
"""The form of t01 to t03 for every β."""
THETA: dict[str, str] = {
    "small front": "3^(1-beta/3)*Gamma(1+beta)",
    "small leading": "x^beta",
    "large front": "3^(1-beta/3)/Gamma(-beta)",
    "large leading": "sqrt(pi)/Gamma(-beta)*e^(2/3*lam)*tau^(-beta/2-3/4)",
    "integer leading": "(-1)^n*tau^n",
}
"""Line 2459 and eq. tlarge: Θ is (front) times h or e_1, at leading order the power or the exponential; at β = n
(added here) the leading power."""
INTEGER_POLYNOMIAL = "(-1)^(n+m)*fac(n)/(fac(n-3*m)*3^m*fac(m))*tau^(n-3*m)"
"""proofs/initial_values.md: the terms of Θ(τ, n)."""


def value_of(text: str, beta: fmpq, bits: int, **values: fmpq | arb) -> arb:
    """A real formula in balls."""
    return evaluate_text(text, {"beta": beta, **values}, bits).real


def fundamental_solution(j: int, tau: fmpq, beta: fmpq, bits: int) -> arb:
    """y_j: its front times the 1F2 number j of th:3, as FLINT encloses it."""
    upper, lower, other, front = (
        value_of(FUNCTIONS[f"{name} {j}"], beta, bits, tau=tau) for name in ("upper", "lower", "other lower", "front")
    )
    argument = value_of(FUNCTIONS["argument"], beta, bits, tau=tau)
    with working_bits(bits):
        return front * argument.hypgeom([upper], [lower, other])


def theta_by_fundamental_solutions(tau: fmpq, beta: fmpq, values: tuple[arb, arb, arb], bits: int) -> arb:
    """Theta from th:3 and given initial values."""
    with working_bits(bits):
        return sum((values[j] * fundamental_solution(j, tau, beta, bits) for j in range(3)), arb(0))


def printed_initial_values(beta: fmpq, bits: int) -> tuple[arb, arb, arb]:
    """t01, t02, t03 as printed; not finite at β = j, j + 3, ..."""
    first, second, third = (value_of(text, beta, bits) for text in INITIAL_VALUES.values())
    return first, second, third


def h_terms(x: fmpq, beta: fmpq, count: int, bits: int) -> list[arb]:
    """The first terms of h at tau = -x (eq. hdef)."""
    return [value_of(SERIES["h"], beta, bits, x=x, k=fmpq(k)) for k in range(count)]


def e_terms(x: fmpq, beta: fmpq, count: int, bits: int) -> list[acb]:
    """The first terms of e_r + i e_i at tau = -x (eq. eier)."""
    with working_bits(bits):
        large = arb(x) * arb(x).sqrt()
        return [
            evaluate_text(SERIES["e"], {"beta": beta, "x": x, "lam": large, "k": fmpq(k)}, bits) * coefficient(k)(beta)
            for k in range(count)
        ]


def e_1_terms(tau: fmpq, beta: fmpq, count: int, bits: int) -> list[arb]:
    """The first terms of e_1 (th:5)."""
    with working_bits(bits):
        large = arb(tau) * arb(tau).sqrt()
        return [
            value_of(SERIES["e_1"], beta, bits, tau=tau, lam=large, k=fmpq(k)) * coefficient(k)(beta)
            for k in range(count)
        ]


def dlmf_coefficients(j: int, count: int) -> list[fmpq_poly]:
    """c_0 .. c_(count-1) of DLMF 16.11.4 for the 1F2 number j of th:3, as polynomials in beta.

    c_k = -1/(k kappa^kappa) sum_(m<k) c_m e_(k,m),
    e_(k,m) = sum_i (1 - nu - kappa b_i + m)_(kappa+k-m) (a - b_i)/prod_(l != i) (b_l - b_i), with
    b_3 = 1, kappa = 2, nu = a - b_1 - b_2 + 1/2.
    """
    lower = ((fmpq(1, 3), fmpq(2, 3)), (fmpq(2, 3), fmpq(4, 3)), (fmpq(4, 3), fmpq(5, 3)))[j]
    below = (*lower, fmpq(1))
    upper = fmpq_poly([fmpq(j, 3), fmpq(-1, 3)])
    nu = upper - lower[0] - lower[1] + fmpq(1, 2)
    found = [fmpq_poly([1])]
    for k in range(1, count):
        total = fmpq_poly([0])
        for m in range(k):
            inner = fmpq_poly([0])
            for i, b in enumerate(below):
                rising = fmpq_poly([1])
                for step in range(2 + k - m):
                    rising *= 1 - nu - 2 * b + m + step
                weight = fmpq(1)
                for other, value in enumerate(below):
                    weight *= value - b if other != i else 1
                inner += rising * (upper - b) / weight
            total += found[m] * inner
        found.append(-total / (4 * k))
    return found
