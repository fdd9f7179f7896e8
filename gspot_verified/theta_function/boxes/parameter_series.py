"""The Taylor coefficients of Theta at tau = 0 as polynomials in the parameter b, on a disc of b.

Proof page: ``proofs/box.md``, sections 1 to 3.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from flint import arb, arb_mat, arb_poly, fmpq

from gspot_verified.numbers.balls import float_bounds, working_bits
from gspot_verified.theta_function.gamma.reciprocal_gamma import reciprocal_gamma_series

_CAUCHY_RADIUS = 6
"""The radius in b of the disc of Cauchy's estimate; 6/3 = 2 in the arguments of 1/Gamma."""

_LEAST_RECIPROCAL = fmpq(113, 100)  # g = 1.13 >= 1/Gamma on u > 0: proofs/box.md, section 1
_HALF = fmpq(1, 2)  # exact, made once


class ParameterModel(NamedTuple):
    """A function of eta: ``polynomial``, and ``error`` with |function - polynomial| <= error on |eta| <= 1."""

    polynomial: arb_poly
    error: arb

    def size(self) -> arb:
        """An upper bound of the function on the disc."""
        return sum((abs(value) for value in self.polynomial.coeffs()), self.error)


class ParameterSeries(NamedTuple):
    """Theta(tau, centre + radius eta) = sum over k of a_k(eta) tau^k, on |eta| <= 1.

    Row k < length of ``matrix`` holds the coefficients of the polynomial of a_k (``degree`` columns), then a bound on
    |a_k|, then its error. ``omitted`` bounds |a_k| for k = length, length + 1, length + 2.
    """

    centre: fmpq
    radius: fmpq
    degree: int
    length: int
    bits: int
    matrix: arb_mat
    omitted: tuple[arb, arb, arb]


def parameter_series(centre: fmpq, radius: fmpq, degree: int, length: int, bits: int) -> ParameterSeries:
    """The series with ``length`` coefficients in tau and ``degree`` in eta, at the working precision ``bits``.

    :raises ValueError: the radius is not in 0..3, or ``degree`` or ``length`` is too small.
    """
    if not 0 <= radius <= 3:
        raise ValueError("the radius in b must lie in 0..3")
    if degree < 1 or length < 3:
        raise ValueError("degree must be at least 1 and length at least 3")
    with working_bits(bits):
        models = list(initial_models(centre, radius, degree, bits))
        models[2] = ParameterModel(models[2].polynomial * arb(_HALF), models[2].error / 2)
        for k in range(length):
            models.append(_next_model(models[k], k, centre, radius, degree))
        rows = []
        for model in models[:length]:
            values = model.polynomial.coeffs()
            rows += [*values, *([arb(0)] * (degree - len(values))), model.size().upper(), model.error.upper()]
        first, second, third = (model.size().upper() for model in models[length:])
        matrix = arb_mat(length, degree + 2, rows)
    return ParameterSeries(centre, radius, degree, length, bits, matrix, (first, second, third))


def initial_models(
    centre: fmpq, radius: fmpq, degree: int, bits: int
) -> tuple[ParameterModel, ParameterModel, ParameterModel]:
    """Theta(0), Theta'(0), Theta''(0) as functions of eta; ``proofs/box.md``, section 2."""
    with working_bits(bits):
        arguments = [(j - centre) / 3 for j in range(3)]
        slope = arb(-radius / 3)
        series = [arb_poly(reciprocal_gamma_series(arb(y), slope, degree)) for y in arguments]
        bounds = [reciprocal_gamma_bound(y, arb(2)) for y in arguments]
        exponential = _exponential(arb(3).log() * arb(2 * radius / 3), degree)
        ratio = arb(radius) / _CAUCHY_RADIUS
        tail = ratio**degree / (1 - ratio)
        models = []
        for j, (first, second) in enumerate(((1, 2), (0, 2), (0, 1))):
            constant = 2 * arb.pi() * arb(3) ** arb(2 * centre / 3 - _HALF + fmpq(j, 3))
            product = (series[first] * series[second]).truncate(degree) * exponential
            bound = constant * 81 * bounds[first] * bounds[second]
            models.append(ParameterModel(product.truncate(degree) * constant, (bound * tail).upper()))
    return models[0], models[1], models[2]


def reciprocal_gamma_bound(y: fmpq, rho: arb) -> arb:
    """An upper bound of |1/Gamma(y + w)| for complex |w| <= rho; ``proofs/box.md``, section 1."""
    shift = max(0, _ceiling(rho + _HALF - arb(y)))
    product = arb(1)
    for i in range(shift):
        product *= abs(arb(y + i)) + rho
    leftmost = arb(y + shift) - rho
    least = leftmost.rgamma() if leftmost >= 2 else arb(_LEAST_RECIPROCAL)
    return (product * least * (arb.pi() * rho).cosh().sqrt()).upper()


def _ceiling(value: arb) -> int:
    """An integer that is at least the number, and less than it plus 2."""
    return math.floor(float_bounds(value)[1]) + 1


def _exponential(rate: arb, degree: int) -> arb_poly:
    """exp(rate eta) up to eta^(degree - 1)."""
    terms = [arb(1)]
    for i in range(1, degree):
        terms.append(terms[-1] * rate / i)
    return arb_poly(terms)


def _next_model(model: ParameterModel, k: int, centre: fmpq, radius: fmpq, degree: int) -> ParameterModel:
    """a_(k+3) = (k - b) a_k / ((k+1)(k+2)(k+3)) from a_k; ``proofs/box.md``, section 3."""
    product = (k + 1) * (k + 2) * (k + 3)
    full = model.polynomial * arb_poly([arb((k - centre) / product), arb(-radius / product)])
    error = model.error * arb((abs(k - centre) + radius) / product)
    values = full.coeffs()
    if len(values) > degree:
        error += abs(values[degree])
    return ParameterModel(full.truncate(degree), error.upper())
