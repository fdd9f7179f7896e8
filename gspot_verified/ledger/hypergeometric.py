"""The paper's own building blocks, transcribed as printed: 1F2 of Theorem 3, h, e_r + i e_i, e_1.

They are evaluated by FLINT's hypergeometric functions and by truncated sums, so that they share no code with the routes
of :mod:`gspot_verified.theta_function`. Nothing here carries a remainder: these are printed formulas, not enclosures of
Theta.
"""

from __future__ import annotations

from flint import acb, arb, fmpq, fmpq_poly

from gspot_verified.balls import working_bits
from gspot_verified.theta_function.asymptotic_coefficients import coefficient


def theorem_3_function(j: int, tau: fmpq, beta: fmpq, bits: int) -> arb:
    """y_j: tau^j/j! times the 1F2 number j of Theorem 3, as FLINT encloses it."""
    lower = ((fmpq(1, 3), fmpq(2, 3)), (fmpq(2, 3), fmpq(4, 3)), (fmpq(4, 3), fmpq(5, 3)))[j]
    with working_bits(bits):
        value = arb(tau**3 / 9).hypgeom([arb((j - beta) / 3)], [arb(b) for b in lower])
        return value * (tau**j / (1 + (j > 1)))


def theta_by_theorem_3(tau: fmpq, beta: fmpq, values: tuple[arb, arb, arb], bits: int) -> arb:
    """Theta from Theorem 3 and given initial values."""
    with working_bits(bits):
        return sum((values[j] * theorem_3_function(j, tau, beta, bits) for j in range(3)), arb(0))


def h_terms(x: fmpq, beta: fmpq, count: int, bits: int) -> list[arb]:
    """The first terms of h at tau = -x (eq. hdef)."""
    with working_bits(bits):
        front = arb(3) ** arb(beta / 3 - 1) * arb(x) ** arb(beta)
        return [
            front * arb(1 + beta - 3 * k).rgamma() / (arb.fac_ui(k) * arb(3) ** k * arb(x) ** (3 * k))
            for k in range(count)
        ]


def e_terms(x: fmpq, beta: fmpq, count: int, bits: int) -> list[acb]:
    """The first terms of e_r + i e_i at tau = -x (eq. eier)."""
    with working_bits(bits):
        large = arb(x) * arb(x).sqrt()
        phase = arb.pi() * beta / 6 + arb.pi() / 4 - 2 * large / 3
        front = arb.pi().sqrt() * arb(3) ** arb(beta / 3 - 1) * arb(x) ** arb(-beta / 2 - fmpq(3, 4))
        turn = acb(0, phase).exp()
        return [
            front * turn * acb(0, 1) ** k * (coefficient(k)(beta) * fmpq(3, 2) ** k) / large**k for k in range(count)
        ]


def e_1_terms(tau: fmpq, beta: fmpq, count: int, bits: int) -> list[arb]:
    """The first terms of e_1 (Theorem 5)."""
    with working_bits(bits):
        large = arb(tau) * arb(tau).sqrt()
        front = arb.pi().sqrt() * arb(3) ** arb(beta / 3 - 1) * arb(tau) ** arb(-beta / 2 - fmpq(3, 4))
        front *= (2 * large / 3).exp()
        return [front * (coefficient(k)(beta) * fmpq(3, 2) ** k) / large**k for k in range(count)]


def dlmf_coefficients(j: int, count: int) -> list[fmpq_poly]:
    """c_0 .. c_(count-1) of DLMF 16.11.4 for the 1F2 number j of Theorem 3, as polynomials in beta.

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
