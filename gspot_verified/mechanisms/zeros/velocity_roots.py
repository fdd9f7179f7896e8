"""All zeros of k - 1 affine functions and one quadratic function of k variables, in closed form: no bound is needed.

Proof page: ``proofs/all_g_spots.md``, section 4. In a Lagrangian mechanism v is affine and b quadratic in
the velocities.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from flint import arb, arb_mat

from gspot_verified.functions.box_program import BoxProgram
from gspot_verified.functions.derivative import partial_derivative
from gspot_verified.functions.expressions import Expression
from gspot_verified.functions.straight_line import StraightLine
from gspot_verified.numbers.balls import add_remainder
from gspot_verified.numbers.evidence import differ, every, less, signed
from gspot_verified.numbers.verdict import Evidence

Point = tuple[arb, ...]


@dataclass(frozen=True)
class Roots:
    """All zeros, one in each ball of ``points``; or ``open``: why the balls leave their number open.

    ``near`` is then a place that holds all zeros: two meet there, or nearly meet. ``shown`` is what was compared: by it
    the zeros are those of ``points``, or all lie in ``near``.
    """

    points: tuple[Point, ...]
    open: str | None = None
    near: Point | None = None
    shown: Evidence | None = None


class VelocityRoots:
    """The zeros in ``variables``, for given values of the other components.

    Make one with :meth:`of`, which says whether the functions have this form.
    """

    def __init__(
        self, affine: Sequence[Expression], quadratic: Expression | None, dimension: int, variables: Sequence[int]
    ) -> None:
        self._variables = tuple(variables)
        self._affine = BoxProgram(affine, dimension, variables)
        self._quadratic = None if quadratic is None else BoxProgram([quadratic], dimension, variables)
        slopes = [partial_derivative(quadratic, i, dimension) for i in variables] if quadratic is not None else []
        self._slopes = BoxProgram(slopes, dimension, variables)

    @classmethod
    def of(cls, functions: Sequence[Expression], dimension: int, variables: Sequence[int]) -> VelocityRoots | None:
        """The closed form, where all but one of the functions are affine and that one is quadratic or affine."""
        degrees = [_degree(function, variables) for function in functions]
        if None in degrees or degrees.count(2) > 1 or len(functions) != len(variables):
            return None
        affine = [function for function, degree in zip(functions, degrees, strict=True) if degree != 2]
        quadratic = next((function for function, degree in zip(functions, degrees, strict=True) if degree == 2), None)
        return cls(affine, quadratic, dimension, variables)

    def all_roots(self, given: Sequence[arb]) -> Roots:
        """All zeros for each choice of numbers in the balls ``given`` (those of ``variables`` are not read)."""
        state = list(given)
        for i in self._variables:
            state[i] = arb(0)
        constants, rows = self._affine.gradients(state)
        if self._quadratic is None:
            solved = _solved(rows, [[-value] for value in constants])
            if solved is None:
                return Roots((), "the affine conditions may be dependent")
            return Roots((tuple(row[0] for row in solved[0]),), shown=every(solved[1]))
        line = _line(rows, constants, len(self._variables))
        if line is None:
            return Roots((), "the affine conditions may be dependent")
        start, direction, regular = line
        for i, value in zip(self._variables, start, strict=True):
            state[i] = value
        (constant,) = self._quadratic.values(state)
        slopes, hessian = self._slopes.gradients(state)
        linear = _dot(slopes, direction)
        curvature = _dot([_dot(row, direction) for row in hessian], direction) / 2
        roots = quadratic_roots(curvature, linear, constant)
        return Roots(
            tuple(_along(start, direction, s) for s in roots.points),
            roots.open,
            None if roots.near is None else _along(start, direction, roots.near),
            every([*regular, roots.shown]),
        )


@dataclass(frozen=True)
class ScalarRoots:
    """The zeros of a quadratic polynomial, as in :class:`Roots`."""

    points: tuple[arb, ...]
    open: str | None = None
    near: arb | None = None
    shown: Evidence | None = field(default=None, compare=False, repr=False)


def quadratic_roots(a: arb, b: arb, c: arb) -> ScalarRoots:
    """All real zeros of a s^2 + b s + c, in disjoint balls, for every choice of the coefficients in their balls.

    >>> roots = quadratic_roots(arb(1), arb(-3), arb(2))
    >>> roots.points[0].overlaps(arb(1)), roots.points[1].overlaps(arb(2)), roots.open
    (True, True, None)
    >>> quadratic_roots(arb(1), arb(0), arb(1))
    ScalarRoots(points=(), open=None, near=None)
    """
    leading, slope, constant = signed(a), signed(b), signed(c)
    if leading is None:
        return ScalarRoots((), "the quadratic coefficient may vanish: a root may come from infinity")
    if leading[0] == 0:
        if slope is not None and slope[0] != 0:
            return ScalarRoots((-c / b,), shown=every([leading[1], slope[1]]))
        if slope is not None and constant is not None and constant[0] != 0:
            return ScalarRoots((), shown=every([leading[1], slope[1], constant[1]]))
        return ScalarRoots((), "the polynomial may be constant in the velocity")
    discriminant = b * b - 4 * a * c
    none = less(discriminant, 0)
    if none is not None:
        return ScalarRoots((), shown=every([leading[1], none]))
    # Every root lies here: |s + b/(2 a)| = sqrt(discriminant)/(2 |a|).
    near = add_remainder(-b, discriminant.abs_upper().sqrt()) / (2 * a)
    two = less(0, discriminant)
    if two is None:
        return ScalarRoots((), "two roots meet, or nearly meet, or there are none", near, leading[1])
    root = discriminant.sqrt()
    if slope is not None and slope[0] != 0:  # no cancellation: the larger root first, the other from the product c/a
        large = -(b + root) / 2 if slope[0] > 0 else (root - b) / 2
        pair = (large / a, c / large)
    else:
        pair = ((-b - root) / (2 * a), (root - b) / (2 * a))
    for first, second in (pair, pair[::-1]):
        apart = less(first, second)
        if apart is not None:
            return ScalarRoots((first, second), shown=every([leading[1], two, apart]))
    return ScalarRoots((), "two roots meet, or nearly meet", near, leading[1])


def _line(
    rows: Sequence[Sequence[arb]], constants: Sequence[arb], size: int
) -> tuple[list[arb], list[arb], list[Evidence | None]] | None:
    """A point w_0 and a direction n: rows w + constants = 0 exactly for w = w_0 + s n; and that this is regular."""
    best = None
    for j in range(size):
        others = [k for k in range(size) if k != j]
        solved = _solved(
            [[row[k] for k in others] for row in rows],
            [[-value, -row[j]] for value, row in zip(constants, rows, strict=True)],
        )
        if solved is None:
            continue
        start, direction = [arb(0)] * size, [arb(0)] * size
        direction[j] = arb(1)
        for k, (value, slope) in zip(others, solved[0], strict=True):
            start[k], direction[k] = value, slope
        size_of = max((float(x.abs_upper()) for x in direction), default=1.0)
        if best is None or size_of < best[0]:
            best = (size_of, start, direction, solved[1])
    return None if best is None else best[1:]


def _solved(
    rows: Sequence[Sequence[arb]], right: Sequence[Sequence[arb]]
) -> tuple[list[list[arb]], list[Evidence | None]] | None:
    """The solution of a linear system for several right sides, and that the determinant is not 0 (nothing, for an empty
    system); None when the matrix is not certainly regular."""
    if not rows:
        return [], []
    matrix = arb_mat([list(row) for row in rows])
    try:
        solution = matrix.solve(arb_mat([list(row) for row in right]))
    except ZeroDivisionError:
        return None
    solved = [[solution[i, j] for j in range(len(right[0]))] for i in range(len(rows))]
    finite = all(value.is_finite() for row in solved for value in row)
    return (solved, [differ(0, matrix.det())]) if finite else None


def _dot(left: Sequence[arb], right: Sequence[arb]) -> arb:
    return sum((x * y for x, y in zip(left, right, strict=True)), arb(0))


def _along(start: Sequence[arb], direction: Sequence[arb], s: arb) -> Point:
    return tuple(x + n * s for x, n in zip(start, direction, strict=True))


def _degree(function: Expression, variables: Sequence[int]) -> int | None:
    """1 or 2, when the function is seen to be a polynomial of at most this degree in the variables."""
    code = StraightLine()
    root, chosen = code.value(function), set(variables)
    slopes = [slope for i in variables if (slope := code.slope(root, i)) is not None]
    if not any(code.depends(slope) & chosen for slope in slopes):
        return 1
    second = [curvature for slope in slopes for i in variables if (curvature := code.slope(slope, i)) is not None]
    return None if any(code.depends(curvature) & chosen for curvature in second) else 2
