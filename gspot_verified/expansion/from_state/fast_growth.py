"""Lemma 1: how fast the fast deviation of the model system grows or falls, in a norm, on a whole rectangle of (h, r).

Proof page: ``proofs/from_state.md``, sections 1 and 3. The matrices are exact polynomials; balls enter when they are
evaluated on boxes.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Generic, Protocol, TypeVar

from flint import arb, fmpq, fmpq_mpoly

from gspot_verified.expansion.from_state.slow_series import RING, Contact, H, R, change
from gspot_verified.functions.ball_polynomials import BallPolynomial
from gspot_verified.numbers.balls import ball, hull
from gspot_verified.numbers.evidence import Box, cover_by_boxes, every, less
from gspot_verified.numbers.verdict import Evidence

Polynomial = fmpq_mpoly | BallPolynomial
Matrix = list[list[Polynomial]]
_HALVINGS = 24  # of a box; then the inequality counts as not shown


@dataclass(frozen=True)
class Rectangle:
    """0 < h <= ``h``, 0 < r <= ``r``."""

    h: fmpq
    r: fmpq


class SlowPart(Protocol):
    """What B and M' need of a slow part: of the model system, or of section 8 at L = 0."""

    @property
    def balance(self) -> fmpq:
        """(beta - 1/2)/2, or a number near it: any is right."""

    @property
    def contact(self) -> Contact:
        """kappa, g, l."""

    @property
    def coupling(self) -> tuple[Polynomial, Polynomial, Polynomial]:
        """What x_2 feeds into x_1, x_2, x_3 besides r, 0, (l/g) r, over h r."""

    @property
    def level_fall(self) -> Polynomial:
        """-p'/(h r p)."""


Part = TypeVar("Part", bound=SlowPart, covariant=True)


@dataclass(frozen=True)
class Norm(Generic[Part]):
    """|x|_M with x = (r V, W, r phi): k_1, k_2 of the page.

    :raises ValueError: one of them is negative.
    """

    series: Part
    k_1: fmpq
    k_2: fmpq

    def __post_init__(self) -> None:
        if not (self.k_1 >= 0 and self.k_2 >= 0):
            raise ValueError(f"k_1 and k_2 must not be negative, got {self.k_1} and {self.k_2}")

    @property
    def matrix(self) -> list[list[fmpq_mpoly]]:
        """M."""
        contact, zero = self.series.contact, RING.constant(0)
        first = self.k_2 * contact.lag / contact.rate * R - self.series.balance * H
        second = -self.k_1 * R
        one, last = RING.constant(1), RING.constant(contact.rate**2 / contact.lag)
        return [[RING.constant(contact.kappa), first, zero], [first, one, second], [zero, second, last]]

    def shares(self, rectangle: Rectangle) -> tuple[arb, arb, arb] | None:
        """Bounds of |x_1|, |x_2|, |x_3| over |x|_M on the rectangle, (5); None where M may not be positive definite."""
        contact = self.series.contact
        rising = self.k_2 * contact.lag / contact.rate * rectangle.r
        falling = self.series.balance * rectangle.h
        first = max(rising, falling) ** 2 / contact.kappa
        second = (self.k_1 * rectangle.r) ** 2 * contact.lag / contact.rate**2
        rest = 1 - first - second
        if not rest > 0:
            return None
        squares = (1 / (contact.kappa * rest), 1 / rest, contact.lag / (contact.rate**2 * rest))
        parts = [ball(value).sqrt().upper() for value in squares]
        return parts[0], parts[1], parts[2]


@dataclass(frozen=True)
class Growth:
    """(|x|_M)' <= (h r ``rate`` - ``damping`` r^2)|x|_M is claimed; ``evidence``, or ``where`` it is not shown."""

    rate: fmpq
    damping: fmpq
    evidence: Evidence | None
    boxes: int
    where: str


def fast_matrix(series: SlowPart) -> Matrix:
    """B of (4): x' = B x + L (residual)."""
    contact, (first, second, third) = series.contact, series.coupling
    rest = -fmpq(1, 2) * H * R * series.level_fall
    return [
        [rest, R + H * R * first, RING.constant(0)],
        [-contact.kappa * R, H * R * second, -contact.rate * R],
        [RING.constant(0), contact.lag / contact.rate * R + H * R * third, rest - contact.rate],
    ]


def surplus(norm: Norm[SlowPart], rate: fmpq, damping: fmpq) -> Matrix:
    """N = 2 (h r rate - damping r^2) M - (M B + B^T M + M')."""
    gram, field, fall = norm.matrix, fast_matrix(norm.series), norm.series.level_fall
    factor = 2 * rate * H * R - 2 * damping * R * R
    product = [
        [sum((gram[i][k] * field[k][j] for k in range(3)), RING.constant(0)) for j in range(3)] for i in range(3)
    ]
    return [
        [factor * gram[i][j] - product[i][j] - product[j][i] - fall * change(gram[i][j]) for j in range(3)]
        for i in range(3)
    ]


def fast_growth(norm: Norm[SlowPart], rectangle: Rectangle, rate: fmpq, damping: fmpq) -> Growth:
    """Lemma 1 on the rectangle: N is positive definite there, in two charts, box by box."""
    matrix = surplus(norm, rate, damping)
    shown, boxes = list[Evidence | None](), 0
    for chart in (_Chart(matrix, True, rectangle.r, rectangle.h), _Chart(matrix, False, rectangle.h, rectangle.r)):
        parts, where = chart.positive()
        boxes += len(parts)
        shown += [*(evidence for _, evidence in parts)]
        shown.append(cover_by_boxes((box for box, _ in parts), chart.whole))
        if where:
            return Growth(rate, damping, None, boxes, where)
    evidence = every(shown)
    return Growth(rate, damping, evidence, boxes, "" if evidence else "the boxes do not cover the rectangle")


class _Chart:
    """h = u r, 0 <= u <= 1 (``steep``), or r = u h; (u, size) with size = r or h up to ``reach``, and where u size is
    above ``other`` the point lies outside of the rectangle."""

    def __init__(self, matrix: Matrix, steep: bool, reach: fmpq, other: fmpq) -> None:
        self._steep, self._other = steep, other
        self.whole: Box = ((fmpq(0), fmpq(0)), (fmpq(1), reach))
        self._block = [self._scaled(matrix[i][j], 2) for i, j in ((0, 0), (0, 1), (1, 1))]
        self._side = [self._scaled(matrix[i][2], 1) for i in (0, 1)]
        self._corner = self._scaled(matrix[2][2], 0)

    def _scaled(self, polynomial: Polynomial, power: int) -> list[tuple[int, int, arb]]:
        """The terms (exponent of u, of size, coefficient) of the entry over r^power, or over h^power u^(power/2); a
        side entry keeps u^(-1/2), which :meth:`minors` puts right."""
        terms = []
        for (x, y), value in polynomial.to_dict().items():
            i, j = int(x), int(y)
            first = i if self._steep else j - (1 if power else 0)
            if first < 0 or i + j < power:
                raise ArithmeticError(f"the entry has the monomial h^{i} r^{j}")
            terms.append((first, i + j - power, ball(value)))
        return terms

    def minors(self, u: arb, size: arb) -> tuple[arb, arb, arb]:
        """N_33, and the two minors of its Schur complement."""
        (a, b, d), (x, y), corner = (
            [_value(terms, u, size) for terms in self._block],
            [_value(terms, u, size) for terms in self._side],
            _value(self._corner, u, size),
        )
        weight = (1 if self._steep else u) / corner
        a, b, d = a - weight * x * x, b - weight * x * y, d - weight * y * y
        return corner, a, a * d - b * b

    def positive(self) -> tuple[list[tuple[Box, Evidence]], str]:
        """Boxes on which the minors are positive, or that lie outside; and the first box on which it is not shown."""
        parts: list[tuple[Box, Evidence]] = []
        left = [(self.whole, 0)]
        while left:
            box, depth = left.pop()
            (u_0, s_0), (u_1, s_1) = box
            outside = less(self._other, u_0 * s_0)
            minors = self.minors(hull([ball(u_0), ball(u_1)]), hull([ball(s_0), ball(s_1)]))
            shown = outside or every(less(0, minor) for minor in minors)
            if shown is not None:
                parts.append((box, shown))
            elif depth == _HALVINGS:
                return parts, self._text(box)
            else:
                left += [(part, depth + 1) for part in self._halves(box)]
        return parts, ""

    def _halves(self, box: Box) -> tuple[Box, Box]:
        (u_0, s_0), (u_1, s_1) = box
        if (u_1 - u_0) * self.whole[1][1] >= s_1 - s_0:
            middle = (u_0 + u_1) / 2
            return ((u_0, s_0), (middle, s_1)), ((middle, s_0), (u_1, s_1))
        middle = (s_0 + s_1) / 2
        return ((u_0, s_0), (u_1, middle)), ((u_0, middle), (u_1, s_1))

    def _text(self, box: Box) -> str:
        (u_0, s_0), (u_1, s_1) = box
        ratio, size = ("h/r", "r") if self._steep else ("r/h", "h")
        return f"N is not certainly positive definite for {u_0} <= {ratio} <= {u_1}, {s_0} <= {size} <= {s_1}"


def _value(terms: list[tuple[int, int, arb]], u: arb, size: arb) -> arb:
    return sum((value * u**i * size**j for i, j, value in terms), arb(0))
