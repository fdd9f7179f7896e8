"""Existence and uniqueness of a zero in a box, by Krawczyk's operator.

Proof page: ``proofs/krawczyk.md``.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from flint import arb, arb_mat

from gspot_verified.numbers.evidence import every, in_interior
from gspot_verified.numbers.verdict import Evidence

Vector = list[arb]
Matrix = list[list[arb]]


def krawczyk(
    function: Callable[[Vector], Vector],
    jacobian: Callable[[Vector], Matrix],
    box: Sequence[arb],
) -> Vector | None:
    """A box K inside the given one that holds its only zero, or None when that could not be shown.

    ``function`` encloses the values and ``jacobian`` the derivatives at every point of a box; a ValueError from them
    (a hypothesis of theirs fails on the box) means None.

    >>> from gspot_verified.numbers.balls import working_bits
    >>> with working_bits(80):
    ...     root = krawczyk(lambda x: [x[0] * x[0] - 2], lambda x: [[2 * x[0]]], [arb("1.41", "0.01")])
    >>> root is not None and root[0].overlaps(arb(2).sqrt())
    True
    """
    proved = proved_zero(function, jacobian, box)
    return None if proved is None else proved[0]


def proved_zero(
    function: Callable[[Vector], Vector],
    jacobian: Callable[[Vector], Matrix],
    box: Sequence[arb],
) -> tuple[Vector, Evidence] | None:
    """The box K of :func:`krawczyk`, and that it lies in the interior of the given one."""
    middle = [side.mid() for side in box]
    try:
        at_middle = function(middle)
        over_box = jacobian(list(box))
        at_centre = jacobian(middle)
    except ValueError:
        return None
    image = krawczyk_operator(at_middle, over_box, at_centre, box)
    if image is None:
        return None
    inclusion = every(in_interior(new, old) for new, old in zip(image, box, strict=True))
    return None if inclusion is None else (image, inclusion)


def krawczyk_operator(
    at_middle: Sequence[arb],
    over_box: Sequence[Sequence[arb]],
    near_middle: Sequence[Sequence[arb]],
    box: Sequence[arb],
) -> Vector | None:
    """The box K that holds every zero in the given box; None where no matrix Y was found, or K is not finite.

    ``at_middle`` encloses the values at the midpoint, ``over_box`` the derivatives on the box; ``near_middle`` serves
    to choose Y only.
    """
    size = len(box)
    try:
        inverse = arb_mat([list(row) for row in near_middle]).inv()
    except ZeroDivisionError:
        return None
    # Any matrix serves as Y; the midpoints make it an exact one.
    y = inverse.mid()
    middle = [side.mid() for side in box]
    moves = [side - centre for side, centre in zip(box, middle, strict=True)]
    shrunk = arb_mat(size, size, [int(i == j) for i in range(size) for j in range(size)]) - y * arb_mat(over_box)
    image = (_column(middle) - y * _column(at_middle) + shrunk * _column(moves)).entries()
    return image if all(side.is_finite() for side in image) else None


def _column(values: Sequence[arb]) -> arb_mat:
    return arb_mat(len(values), 1, list(values))


def strictly_inside(inner: arb, outer: arb) -> bool:
    """Whether the first ball certainly lies in the interior of the second."""
    return bool(inner.is_finite() and outer.is_finite() and outer.contains_interior(inner))
