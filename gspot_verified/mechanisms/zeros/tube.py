"""Tubes: for every parameter value of a box exactly one zero of f(ξ, λ) near a linear function of λ.

Proof page: ``proofs/sweep.md``, sections 1 to 3.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from flint import arb, arb_mat, fmpq

from gspot_verified.functions.box_program import BoxProgram, common
from gspot_verified.functions.krawczyk import strictly_inside
from gspot_verified.numbers.balls import nonfinite

Rows = list[list[arb]]

_CONTRACTIONS = 3  # each makes the enclosure of the slopes narrower, none is needed: proofs/sweep.md


@dataclass(frozen=True, slots=True)
class Equations:
    """f(ξ, λ) = 0 with as many functions as unknowns ξ, and further functions g(ξ, λ); ξ are the first variables."""

    program: BoxProgram
    unknowns: int

    @property
    def parameters(self) -> int:
        """How many parameters there are."""
        return self.program.dimension - self.unknowns


@dataclass(frozen=True, slots=True)
class Tube:
    """The set of (ξ, λ) with λ in the box and ξ in centre + slopes (λ - middle) + within.

    For every λ of the box there is exactly one zero in it, and that lies in centre + slopes (λ - middle) + found.
    ``centre`` and ``slopes`` are exact.
    """

    lower: tuple[fmpq, ...]
    upper: tuple[fmpq, ...]
    centre: tuple[arb, ...]
    slopes: tuple[tuple[arb, ...], ...]
    within: tuple[arb, ...]
    found: tuple[arb, ...]

    def zero_at(self, place: Sequence[fmpq]) -> list[arb]:
        """An enclosure of the zero at one λ of the box."""
        return [line + rest for line, rest in zip(self.line_at(place), self.found, strict=True)]

    def line_at(self, place: Sequence[fmpq]) -> list[arb]:
        """centre + slopes (λ - middle)."""
        middle = [(low + high) / 2 for low, high in zip(self.lower, self.upper, strict=True)]
        return self.line([arb(value - own) for value, own in zip(place, middle, strict=True)])

    def line(self, moves: Sequence[arb]) -> list[arb]:
        """centre + slopes moves, ``moves`` enclosing λ - middle."""
        return [start + _dot(row, moves) for start, row in zip(self.centre, self.slopes, strict=True)]

    def holds_at(self, place: Sequence[fmpq], point: Sequence[arb]) -> bool:
        """Whether the points (ξ, λ), ξ in the given balls, certainly lie in the interior of the tube's section."""
        return all(
            strictly_inside(value - line, width)
            for value, line, width in zip(point, self.line_at(place), self.within, strict=True)
        )


@dataclass(frozen=True, slots=True)
class Quantity:
    """A function g(ξ, λ) next to a tube: at its middle, everywhere in it, and its derivatives everywhere in it.

    ``along`` are the derivatives by λ of g(centre + slopes (λ - middle) + z, λ), ``by_state`` those by ξ.
    """

    at_centre: arb
    over_tube: arb
    along: list[arb]
    by_state: list[arb]

    def __sub__(self, other: Quantity) -> Quantity:
        return self._combined(other, self.at_centre - other.at_centre, self.over_tube - other.over_tube, arb(1), arb(1))

    def __truediv__(self, other: Quantity) -> Quantity:
        over = self.over_tube / other.over_tube
        return self._combined(other, self.at_centre / other.at_centre, over, over, 1 / other.over_tube)

    def _combined(self, other: Quantity, at_centre: arb, over: arb, factor: arb, scale: arb) -> Quantity:
        """With the derivatives scale (own - factor other)."""
        along, by_state = (
            [(a - factor * b) * scale for a, b in zip(own, its, strict=True)]
            for own, its in ((self.along, other.along), (self.by_state, other.by_state))
        )
        return Quantity(at_centre, over, along, by_state)


@dataclass(frozen=True, slots=True)
class OnTube:
    """A proved tube and the further functions on it. ``turning`` encloses dz/dλ for its zeros, row by row."""

    tube: Tube
    quantities: list[Quantity]
    turning: Rows

    def value(self, quantity: Quantity) -> arb:
        """An enclosure of g(ξ(λ), λ) for every λ of the box, ξ(λ) being the tube's zero."""
        moves = _moves(self.tube.lower, self.tube.upper)
        mean = quantity.at_centre + _dot(quantity.along, moves) + _dot(quantity.by_state, self.tube.found)
        if mean.is_finite() and quantity.over_tube.is_finite():
            return common(mean, quantity.over_tube)
        return quantity.over_tube

    def slopes(self, quantity: Quantity) -> list[arb]:
        """Enclosures of d g(ξ(λ), λ) / dλ_j for every λ of the box; not finite where g itself has no enclosure."""
        if not quantity.over_tube.is_finite():
            return [nonfinite() for _ in quantity.along]
        return [
            slope + _dot(quantity.by_state, turn)
            for slope, turn in zip(quantity.along, zip(*self.turning, strict=True), strict=True)
        ]


@dataclass(frozen=True, slots=True)
class Attempt:
    """One try; what it suggests for the next one where nothing was proved."""

    proved: OnTube | None
    centre: tuple[arb, ...]
    slopes: tuple[tuple[arb, ...], ...]
    within: tuple[arb, ...]


def try_tube(
    equations: Equations,
    lower: Sequence[fmpq],
    upper: Sequence[fmpq],
    centre: Sequence[arb],
    slopes: Sequence[Sequence[arb]],
    within: Sequence[arb],
) -> Attempt | None:
    """Krawczyk's operator with parameters, once. None: the functions have no enclosure there, or f_ξ is singular.

    :raises ValueError: ``centre`` or ``slopes`` are not exact, or a ball of ``within`` does not hold 0.
    """
    n = equations.unknowns
    if not all(value.is_exact() for value in (*centre, *(slope for row in slopes for slope in row))):
        raise ValueError("the centre and the slopes of a tube must be exact")
    if not all(width.contains(0) for width in within):
        raise ValueError("the widths of a tube must hold 0")
    middle = [arb((low + high) / 2) for low, high in zip(lower, upper, strict=True)]
    moves = _moves(lower, upper)
    lines = [_dot(row, moves) for row in slopes]
    box = [start + line + width for start, line, width in zip(centre, lines, within, strict=True)]
    place = [value + move for value, move in zip(middle, moves, strict=True)]
    at_centre = equations.program.values([*centre, *middle])
    over_tube, rows = equations.program.gradients([*box, *place])
    if not all(value.is_finite() for value in (*at_centre[:n], *over_tube[:n])):
        return None
    by_state = arb_mat([row[:n] for row in rows[:n]])
    # d f(centre + slopes (λ - middle), λ) / dλ
    turned = iter((arb_mat([row[:n] for row in rows]) * arb_mat([list(row) for row in slopes])).entries())
    along = [[next(turned) + slope for slope in row[n:]] for row in rows]
    preconditioner = _middle_inverse(by_state, n)
    if preconditioner is None:
        return None
    residual = [value + _dot(slope, moves) for value, slope in zip(at_centre[:n], along[:n], strict=True)]
    error = arb_mat(n, n, [1 if i == j else 0 for i in range(n) for j in range(n)]) - preconditioner * by_state
    moved = preconditioner * arb_mat(n, 1, residual)
    spread = error * arb_mat(n, 1, list(within))
    rests = tuple(spread[i, 0] - moved[i, 0] for i in range(n))
    if not all(value.is_finite() for value in rests):
        return None
    if all(strictly_inside(new, old) for new, old in zip(rests, within, strict=True)):
        tube = Tube(tuple(lower), tuple(upper), tuple(centre), tuple(map(tuple, slopes)), tuple(within), rests)
        turning = _turning(error, preconditioner * arb_mat(along[:n]), within, len(moves))
        own = zip(at_centre[n:], over_tube[n:], along[n:], rows[n:], strict=True)
        quantities = [Quantity(value, over, line, row[:n]) for value, over, line, row in own]
        return Attempt(OnTube(tube, quantities, turning), (), (), ())
    return _next(centre, slopes, preconditioner, at_centre[:n], along[:n], rests)


def _turning(error: arb_mat, residual: arb_mat, within: Sequence[arb], k: int) -> Rows:
    """z' for the zeros centre + slopes (λ - middle) + z(λ): the solution of (I - E) z' = -Y (d f / dλ on the line).

    In the norm max |w_i| / r_i with the radii of ``within``, if ‖E‖ < 1 there; then z' = E z' - Y (...) again.
    """
    n = len(within)
    radii = [width.rad() for width in within]  # not 0: their interiors hold something
    norm = arb(0)
    for i in range(n):
        total = sum((abs(error[i, j]).upper() * radii[j] for j in range(n)), arb(0)) / radii[i]
        norm = norm.max(total.upper())
    if not norm < 1:
        return [[nonfinite()] * k for _ in range(n)]
    bounds = []
    for j in range(k):
        size = arb(0)
        for i in range(n):
            size = size.max((abs(residual[i, j]) / radii[i]).upper())
        bounds.append((size / (1 - norm)).upper())
    turning = arb_mat(n, k, [arb(0, (bounds[j] * radii[i]).upper()) for i in range(n) for j in range(k)])
    for _ in range(_CONTRACTIONS):
        turning = error * turning - residual
    return [[turning[i, j] for j in range(k)] for i in range(n)]


def _next(
    centre: Sequence[arb],
    slopes: Sequence[Sequence[arb]],
    preconditioner: arb_mat,
    at_centre: Sequence[arb],
    along: Sequence[Sequence[arb]],
    rests: Sequence[arb],
) -> Attempt:
    """A better centre, better slopes, and widths around what the operator gave. A heuristic: any choice is correct."""
    n, k = len(centre), len(slopes[0])
    step = preconditioner * arb_mat(n, 1, [value.mid() for value in at_centre])
    turn = preconditioner * arb_mat([[value.mid() for value in row] for row in along])
    new_centre = tuple((centre[i] - step[i, 0]).mid() for i in range(n))
    new_slopes = tuple(tuple((slopes[i][j] - turn[i, j]).mid() for j in range(k)) for i in range(n))
    tiny = arb(2) ** -60
    widths = []
    for i in range(n):
        width = (abs(rests[i] + step[i, 0]).upper() * 2 + tiny * (1 + abs(centre[i]))).upper()
        widths.append(arb(0, width))
    return Attempt(None, new_centre, new_slopes, tuple(widths))


def _middle_inverse(matrix: arb_mat, n: int) -> arb_mat | None:
    """An exact matrix near the inverse of the middle; any regular matrix may serve."""
    try:
        inverse = arb_mat(n, n, [value.mid() for value in matrix.entries()]).inv()
    except ZeroDivisionError:
        return None
    return arb_mat(n, n, [value.mid() for value in inverse.entries()])


def _dot(left: Sequence[arb], right: Sequence[arb]) -> arb:
    total = arb(0)
    for a, b in zip(left, right, strict=True):
        total = total + a * b
    return total


def _moves(lower: Sequence[fmpq], upper: Sequence[fmpq]) -> list[arb]:
    """λ - middle for all λ of the box."""
    return [arb(0, arb((high - low) / 2).upper()) for low, high in zip(lower, upper, strict=True)]
