"""Models of G_b(tau; eta) for all b and eta of a rectangle: polynomials through exact points, with remainders.

Proof page: ``proofs/finite_epsilon_zeros.md``, section 5.
"""

from __future__ import annotations

from functools import partial

from flint import arb, arb_mat, fmpq, fmpq_mat

from gspot_verified.compliant.patches.interpolation import node_product, nodes, substitution
from gspot_verified.compliant.patches.slow_majorant import ComplexNeighbourhood, epsilon_difference, slow_majorant
from gspot_verified.compliant.slow.slow_jet import slow_jet
from gspot_verified.compliant.slow.slow_signs import CELL, SlowSigns
from gspot_verified.numbers.balls import add_remainder, approximate, working_bits

_BITS = 96  # of the polynomials in b and eta: their remainders are wider
_JET_BITS = 64  # of the values at the nodes, likewise
_SCALE_BITS = 30  # of the rational cube root: the side on which it lies is tested
_MORE_ORDERS = 11  # in tau, beyond b: with more the remainder is less; chosen by trial: any number is right
_DISTANCE = fmpq(2)  # R of proofs/finite_epsilon_zeros.md, 5.3: any R > 0 is right
_STEP = fmpq(1, 32)  # r of proofs/finite_epsilon_zeros.md, 5.4: any r > 0 is right
_NONE = fmpq(0)  # r = 0 of 5.4: real b alone
_B_NODES = {fmpq(1): 18, fmpq(1, 2): 14, fmpq(1, 4): 12, fmpq(1, 8): 10, fmpq(0): 1}
_LEAST_ETA_NODES = 6  # the bound of 5.2 needs b - 2, more make it less


class SlowPatch:
    """All b in [b_lower, b_upper], b_lower > 3/2, and all epsilon > 0 in [epsilon_lower, epsilon_upper]; 0 as the lower
    end stands for all small epsilon.

    Values at the nodes are made once for each cell of tau and shared by all parts of the rectangle.
    """

    def __init__(self, b_lower: fmpq, b_upper: fmpq, epsilon_lower: fmpq, epsilon_upper: fmpq) -> None:
        self._b = ((b_lower + b_upper) / 2, (b_upper - b_lower) / 2)
        self._b_count = next(count for width, count in sorted(_B_NODES.items()) if b_upper - b_lower <= width)
        self._largest_eta = rational_scale(epsilon_upper, 1)
        if epsilon_lower == epsilon_upper:
            self._eta_count, self._eta_radius = 1, fmpq(0)
            self._epsilons = [epsilon_upper]
        else:
            least = rational_scale(epsilon_lower, -1)
            middle, self._eta_radius = (least + self._largest_eta) / 2, (self._largest_eta - least) / 2
            # The bound of 5.2 needs at least b - 2 of them.
            self._eta_count = max(_LEAST_ETA_NODES, int(b_upper.ceil()) - 1)
            self._epsilons = [2 * (middle + self._eta_radius * y) ** 3 for y in nodes(self._eta_count).places]
        self.order = int(b_upper.ceil()) + _MORE_ORDERS
        self._values: dict[int, list[arb_mat]] = {}

    def signs(self, lower: fmpq, upper: fmpq) -> SlowSigns:
        """Of G for b in [lower, upper], a part of the patch, and all its eta.

        :raises ValueError: [lower, upper] is not in the patch.
        """
        self._check(lower, upper)
        return SlowSigns(partial(self._expansion, lower, upper, False), self.order, _BITS)

    def slopes(self, lower: fmpq, upper: fmpq) -> SlowSigns:
        """Of dG/db, likewise.

        :raises ValueError: [lower, upper] is not in the patch; the patch has one b only, so that its model is constant.
        """
        self._check(lower, upper)
        if not self._b[1]:
            raise ValueError("a patch of one b has no slopes in b")
        return SlowSigns(partial(self._expansion, lower, upper, True), self.order, _BITS)

    def _check(self, lower: fmpq, upper: fmpq) -> None:
        middle, radius = self._b
        if not middle - radius <= lower <= upper <= middle + radius:
            raise ValueError("the range of b must lie in the patch")

    def _at(self, k: int) -> list[arb_mat]:
        """For each order the matrix of values at the nodes of b (rows) and eta (columns)."""
        if k not in self._values:
            b, b_radius = self._b
            tau = (k + fmpq(1, 2)) * CELL
            jets = [
                [slow_jet(tau, b + b_radius * x, epsilon, self.order + 1, _JET_BITS) for epsilon in self._epsilons]
                for x in nodes(self._b_count).places
            ]
            self._values[k] = [
                arb_mat([[jet[order] for jet in row] for row in jets]) for order in range(self.order + 1)
            ]
        return self._values[k]

    def _expansion(self, lower: fmpq, upper: fmpq, in_b: bool, k: int) -> arb_mat:
        b, b_radius = self._b
        middle, radius = ((lower + upper) / 2 - b, (upper - lower) / 2)
        with working_bits(_BITS):
            scaled = (middle / b_radius, radius / b_radius) if b_radius else (fmpq(0), fmpq(0))
            left = _restricted(self._b_count, *scaled, b_radius if in_b else None)
            powers, count = nodes(self._eta_count).to_powers, self._eta_count
            right = arb_mat([[powers[i, j] for i in range(count)] for j in range(count)])
            rows = [(left * values * right).entries() for values in self._at(k)]
            rests = self._slope_rests(k) if in_b else self._rests(k)
            for row, rest in zip(rows, rests, strict=True):
                row[0] = add_remainder(row[0], rest)
            if in_b:
                rows[-1] = [rests[-1]] + [arb(0)] * (len(rows[-1]) - 1)
            return arb_mat(rows)

    def _region(self, k: int, distance: fmpq) -> ComplexNeighbourhood:
        b, b_radius = self._b
        return ComplexNeighbourhood(b - b_radius, b + b_radius, distance, self._largest_eta, (k + fmpq(1, 2)) * CELL)

    def _rests(self, k: int, distance: fmpq = _NONE) -> list[arb]:
        """For each order a bound of the distance between c_k and its model, for complex b within ``distance``."""
        (_, b_radius), eta_radius = self._b, self._eta_radius
        rests = [arb(0)] * (self.order + 1)
        if b_radius:
            weight = node_product(self._b_count, distance / b_radius) * (b_radius / _DISTANCE) ** self._b_count
            weight *= arb(nodes(self._eta_count).lebesgue)
            largest = slow_majorant(self._region(k, distance + _DISTANCE), self.order + 1)
            rests = [rest + weight * bound for rest, bound in zip(rests, largest, strict=True)]
        if eta_radius:
            factor = node_product(self._eta_count, fmpq(0)) * eta_radius**self._eta_count
            bounds = epsilon_difference(self._region(k, distance), self._eta_count, self.order + 1)
            rests = [rest + factor * bound for rest, bound in zip(rests, bounds, strict=True)]
        return rests

    def _slope_rests(self, k: int) -> list[arb]:
        """Cauchy's estimate on small circles; the last one bounds dc_K/db itself, for all tau to the left."""
        rests = [rest / _STEP for rest in self._rests(k, _STEP)]
        return [*rests[:-1], slow_majorant(self._region(k, _STEP), self.order + 1)[-1] / _STEP]


def _restricted(count: int, middle: fmpq, radius: fmpq, derivative_scale: fmpq | None) -> arb_mat:
    """From values at the nodes to the powers of the local variable of a part; of the derivative in b if a scale is
    given."""
    powers = nodes(count).to_powers
    if derivative_scale is not None:
        powers = _derivative(count, derivative_scale) * powers
    return arb_mat(substitution(count, middle, radius) * powers)


def _derivative(count: int, scale: fmpq) -> fmpq_mat:
    return fmpq_mat([[fmpq(j) / scale if j == i + 1 else fmpq(0) for j in range(count)] for i in range(count)])


def rational_scale(epsilon: fmpq, direction: int) -> fmpq:
    """A rational number near eta = (epsilon/2)^(1/3), not above it (direction -1) or not below it (1); exact at 0.

    >>> rational_scale(fmpq(2), 1) >= 1 >= rational_scale(fmpq(2), -1)
    True
    """
    if epsilon == 0:
        return fmpq(0)
    scale = fmpq(2) ** (_SCALE_BITS - int((1 / epsilon).ceil()).bit_length() // -3)
    root = fmpq(round(approximate(epsilon / 2 * scale**3) ** (1 / 3)) + direction)
    root /= scale
    if (2 * root**3 - epsilon) * direction < 0:
        raise ArithmeticError("the cube root was not enclosed; please report this")
    return root
