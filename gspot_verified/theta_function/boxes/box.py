"""Taylor models of Theta and its tau-derivatives on boxes (tau, b), re-centred along tau.

Proof page: ``proofs/box.md``, sections 4 and 5.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache

from flint import arb, arb_mat, fmpq

from gspot_verified.numbers.balls import add_remainder, nonfinite, working_bits
from gspot_verified.theta_function.boxes.parameter_series import ParameterSeries

_HIGHEST_DERIVATIVE = 2  # in tau: proofs/box.md, section 4, has rows for 0, 1, 2
_HALF = fmpq(1, 2)  # exact, made once
_KEPT_ENTRIES = 12_000  # of a matrix that is kept: many of them fit in memory


@dataclass(frozen=True, slots=True)
class TaylorModel:
    """A function g(u, eta) on |u| <= 1, |eta| <= 1, where tau = tau0 + half_width u and b = centre + radius eta.

    ``coefficients[i][j]`` belongs to u^i eta^j; the function differs from the polynomial by at most ``remainder`` for
    every real u with |u| <= 1 and every complex eta with |eta| <= 1.
    """

    tau0: fmpq
    half_width: fmpq
    centre: fmpq
    radius: fmpq
    coefficients: tuple[tuple[arb, ...], ...]
    remainder: arb
    bits: int

    def enclosure(self) -> arb:
        """A ball that contains every value of the function on the box."""
        with working_bits(self.bits):
            spread = sum((abs(value) for row in self.coefficients for value in row), -abs(self.coefficients[0][0]))
            return add_remainder(add_remainder(self.coefficients[0][0], spread), self.remainder)

    def value(self, tau: fmpq, b: fmpq) -> arb:
        """An enclosure of the function at one point of the box.

        :raises ValueError: the point is outside the box.
        """
        if abs(tau - self.tau0) > self.half_width or abs(b - self.centre) > self.radius:
            raise ValueError("the point must lie in the box")
        with working_bits(self.bits):
            u = arb((tau - self.tau0) / self.half_width) if self.half_width else arb(0)
            eta = arb((b - self.centre) / self.radius) if self.radius else arb(0)
            total = arb(0)
            for row in reversed(self.coefficients):
                inner = arb(0)
                for value in reversed(row):
                    inner = inner * eta + value
                total = total * u + inner
            return add_remainder(total, self.remainder)

    def beta_derivative(self) -> TaylorModel:
        """The derivative in b, on the half of the range of b: centre +- radius/2.

        Cauchy's estimate: ``proofs/box.md``, section 5.

        :raises ValueError: the model has no width in b.
        """
        if not self.radius:
            raise ValueError("a model of radius 0 in b has no derivative in b")
        with working_bits(self.bits):
            inverse = 1 / arb(self.radius)
            rows = tuple(
                tuple(j * value * inverse / 2 ** (j - 1) for j, value in enumerate(row) if j) or (arb(0),)
                for row in self.coefficients
            )
            remainder = (2 * self.remainder * inverse).upper()
        return TaylorModel(self.tau0, self.half_width, self.centre, self.radius * _HALF, rows, remainder, self.bits)


def taylor_model(series: ParameterSeries, lower: fmpq, upper: fmpq, order: int, derivative: int = 0) -> TaylorModel:
    """The model of the ``derivative``-th tau-derivative of Theta on [lower, upper] x (range of b of ``series``).

    ``order`` is the number of powers of u that are kept for Theta itself. The remainder is not finite where the
    ratio test of the series fails: ``series.length`` is too small for max(|lower|, |upper|).

    :raises ValueError: lower > upper, or the derivative is not 0, 1, 2, or order <= derivative.

    >>> from gspot_verified.theta_function.boxes.parameter_series import parameter_series
    >>> series = parameter_series(fmpq(-1, 2), fmpq(1, 2), 12, 40, 64)
    >>> taylor_model(series, fmpq(-1, 4), fmpq(0), 10).enclosure() > 0
    True
    """
    lower, upper = fmpq(lower), fmpq(upper)  # TypeError for floats, whose middle would be rounded
    if lower > upper:
        raise ValueError("the box is reversed: lower > upper")
    if not 0 <= derivative <= _HIGHEST_DERIVATIVE or order <= derivative:
        raise ValueError("the derivative must be 0, 1 or 2, and order larger")
    tau0, half_width = (lower + upper) / 2, (upper - lower) / 2
    with working_bits(series.bits):
        # At a single point any scale of u serves: only u = 0 is asked.
        scale = half_width or fmpq(1)
        rows = _recentring(tau0, scale, series.length, order, series.bits) * series.matrix
        degree = series.degree
        powers = range(derivative, order if half_width else derivative + 1)
        factors = [math.perm(i, derivative) / arb(scale) ** derivative for i in powers]
        coefficients = tuple(
            tuple(rows[i, j] * factor for j in range(degree))
            if derivative
            else tuple(rows[i, j] for j in range(degree))
            for i, factor in zip(powers, factors, strict=True)
        )
        # At u = 0 no omitted power of u contributes.
        omitted_powers = rows[order + 2 * derivative, degree] if half_width else arb(0)
        errors = rows[order + 2 * derivative + 1, degree + 1]
        reach = arb(abs(tau0) + scale)
        remainder = (omitted_powers + errors + omitted_terms(series, reach, derivative)).upper()
    return TaylorModel(tau0, half_width, series.centre, series.radius, coefficients, remainder, series.bits)


def omitted_terms(series: ParameterSeries, reach: arb, derivative: int) -> arb:
    """V_d of ``proofs/box.md``, section 4: the terms k >= length of the d-th derivative for |tau| <= reach."""
    first = series.length
    if first <= derivative:
        return nonfinite()
    size = abs(series.centre) + series.radius
    bound = arb(size if size > 1 else 1)
    ratio = (first + bound) * reach**3 / math.prod(first + i - derivative for i in (1, 2, 3))
    if not ratio < 1:  # the hypothesis of the ratio test, certain or not used
        return nonfinite()
    terms = [
        math.perm(first + j, derivative) * value * reach ** (first + j - derivative)
        for j, value in enumerate(series.omitted)
    ]
    return (terms[0] + terms[1] + terms[2]) / (1 - ratio)


def _recentring(tau0: fmpq, half_width: fmpq, length: int, order: int, bits: int) -> arb_mat:
    """The matrix of :func:`_recentring_matrix`, kept when it is small enough for many to fit in memory."""
    make = _kept_recentring if length * order <= _KEPT_ENTRIES else _recentring_matrix
    return make(tau0, half_width, length, order, bits)


def _recentring_matrix(tau0: fmpq, half_width: fmpq, length: int, order: int, bits: int) -> arb_mat:
    """The matrix that takes the coefficients at 0 to those at tau0; ``proofs/box.md``, section 4.

    Row i < order: C(k, i) tau0^(k-i) s^i. Then for d = 0, 1, 2 a row of w_(k,d)/s^d and one of k!/(k-d)! X^(k-d).
    """
    del bits  # part of the key only
    scale = arb(half_width)
    rows = _binomial_rows(arb(tau0), scale, length, order)
    kept = arb_mat(order, length, [abs(value) for row in rows for value in row])
    reach = arb(abs(tau0) + half_width)
    powers = [arb(1)]
    for _ in range(length):
        powers.append(powers[-1] * reach)
    derivatives = range(_HIGHEST_DERIVATIVE + 1)
    # The d-th derivative in tau of the kept powers of (|tau0| + s u)^k at u = 1.
    factors = [math.perm(i, d) / scale**d for d in derivatives for i in range(order)]
    parts = arb_mat(len(derivatives), order, factors) * kept
    bounds: list[arb] = []
    for d in derivatives:
        whole = [arb(0)] * min(d, length) + [math.perm(k, d) * powers[k - d] for k in range(d, length)]
        # For k < order every power is kept.
        rest = [arb(0) if k < order else abs(whole[k] - parts[d, k]) for k in range(length)]
        bounds += rest + whole
    return arb_mat(order + 2 * len(derivatives), length, [value for row in rows for value in row] + bounds)


_kept_recentring = lru_cache(maxsize=256)(_recentring_matrix)


def _binomial_rows(tau0: arb, half_width: arb, length: int, order: int) -> list[list[arb]]:
    """C(k, i) tau0^(k-i) s^i for i < order (rows), k < length, by Pascal's rule: each entry from two before it."""
    rows = [[arb(1)]]
    for k in range(1, length):
        rows[0].append(rows[0][k - 1] * tau0)
    for i in range(1, order):
        row = [arb(0)] * min(i, length)
        for k in range(i, length):
            # C(k,i) t^(k-i) s^i = t * C(k-1,i) t^(k-1-i) s^i + s * C(k-1,i-1) t^(k-i) s^(i-1)
            row.append(tau0 * row[k - 1] + half_width * rows[i - 1][k - 1])
        rows.append(row)
    return rows
