"""Theta, dTheta/dtau and d^2Theta/dtau^2 at tau = 0, for every real beta.

Proof page: ``proofs/initial_values.md``.
"""

from __future__ import annotations

from functools import lru_cache

from flint import arb, fmpq

from gspot_verified.numbers.balls import Exact, ball, working_bits
from gspot_verified.theta_function.gamma.power import positive_power
from gspot_verified.theta_function.gamma.reciprocal_gamma import reciprocal_gamma
from gspot_verified.theta_function.gamma.reduced_gamma import pays, reduced_initial_values

InitialValues = tuple[arb, arb, arb]

_HALF = fmpq(1, 2)  # exact, made once
_THIRD = fmpq(1, 3)  # likewise
_TWO_THIRDS = fmpq(2, 3)  # likewise
_REDUCED_FROM_BITS = 2_000  # from which on reduced_gamma.py is cheaper, where it pays
_FEW_BITS = 600  # below them Python's steps count
_FAR_FROM_POLES = 333  # 1/distance of beta to an integer up to which no argument of 1/Gamma is within 1/1000 of a zero


def initial_values(beta: Exact, bits: int) -> InitialValues:
    """Enclosures of Theta(0), Theta'(0), Theta''(0) with working precision ``bits``, finite for every real beta.

    The entire form: with c = 2 pi 3^(2 beta/3 - 1/2),

        Theta(0)   = c         / (Gamma((1-beta)/3) Gamma((2-beta)/3))
        Theta'(0)  = c 3^(1/3) / (Gamma( -beta /3) Gamma((2-beta)/3))
        Theta''(0) = c 3^(2/3) / (Gamma( -beta /3) Gamma((1-beta)/3))

    It is the paper's t01-t03 with Gauss's multiplication formula (DLMF 5.5.6) put in, so that nothing is 0/0.
    A ball for beta may hold integers.

    >>> value, slope, curvature = initial_values(fmpq(3), 64)
    >>> value.overlaps(arb(2)), slope.is_zero(), curvature.is_zero()
    (True, True, True)
    """
    if isinstance(beta, fmpq):
        return rational_initial_values(int(beta.p), int(beta.q), bits)
    return _entire_form(beta, bits)


@lru_cache(maxsize=64)
def rational_initial_values(p: int, q: int, bits: int) -> InitialValues:
    """The same at beta = p/q in lowest terms, q > 0; kept. By integers: the hash of an fmpq takes longer."""
    if bits <= _FEW_BITS and _FAR_FROM_POLES * min(p % q, -p % q) >= q:
        with working_bits(bits):
            return _few_bits(p, q)
    beta = fmpq(p, q)
    if bits > _REDUCED_FROM_BITS and pays(beta):
        with working_bits(bits):
            return reduced_initial_values(beta, bits)
    return _entire_form(beta, bits)


def _entire_form(beta: Exact, bits: int) -> InitialValues:
    with working_bits(bits):
        third, three = beta / 3, arb(3)
        first = reciprocal_gamma(-third, bits)
        second = reciprocal_gamma(_THIRD - third, bits)
        other = reciprocal_gamma(_TWO_THIRDS - third, bits)
        constant = 2 * arb.pi() * positive_power(three, 2 * third - _HALF)
        return _products(first, second, other, constant, three.root(3))


def _few_bits(p: int, q: int) -> InitialValues:
    """The entire form at p/q at the current precision, with fewer steps: no argument of 1/Gamma is next to a zero."""
    beta, log = arb(p) / q, arb(3).log()
    first, second, other = (beta / -3).rgamma(), ((1 - beta) / 3).rgamma(), ((2 - beta) / 3).rgamma()
    constant = 2 * arb.pi() * (log * (4 * beta - 3) / 6).exp()
    return _products(first, second, other, constant, (log / 3).exp())


def _products(first: arb, second: arb, other: arb, constant: arb, cube_root: arb) -> InitialValues:
    outer, inner = constant * other, cube_root * first
    return outer * second, outer * inner, constant * cube_root * inner * second


def paper_initial_values(beta: Exact, bits: int) -> InitialValues:
    """The paper's own formulas t01, t02, t03: Gamma((j-beta)/3) / (3^((3-j+beta)/3) Gamma(-beta)).

    Defined away from beta = 0, 1, 2, ... and, for t01-t03 one each, away from beta = j, j + 3, j + 6, ...; where one
    is not defined (or the ball holds such a point) the result is not finite.

    >>> own, papers = initial_values(fmpq(1, 2), 64), paper_initial_values(fmpq(1, 2), 64)
    >>> all(one.overlaps(other) for one, other in zip(own, papers, strict=True))
    True
    """
    with working_bits(bits):
        center = ball(beta)
        outer = (-center).rgamma()
        values = [((j - center) / 3).gamma() * outer / arb(3) ** ((3 - j + center) / 3) for j in range(3)]
        return values[0], values[1], values[2]
