"""The number of real zeros of dΘ/dτ(·, β), exactly, for every rational β.

Proof page: ``proofs/count_law.md`` (the theorem for non-integer β, section 4 for integer β).
"""

from __future__ import annotations

from flint import fmpq

from gspot_verified.numbers.balls import ExactInput, exact
from gspot_verified.signs.cover.statements import ZerosStatement
from gspot_verified.work.ranges import Range

MAX_CELLS = 1_000  # a limit of input: ValueError beyond it


def number_of_zeros(beta: ExactInput) -> int:
    """The number of distinct real zeros τ of dΘ/dτ(·, β).

    For a non-integer β > 0 and m = floor(β) it is (m mod 3) + floor(m/3), and all zeros are simple. For β < 0 it is 0.

    :param beta: a rational; int, Fraction, fmpq, string, or an exact ball.
    :raises TypeError: a float.
    :raises ValueError: a ball that is not one rational; or β = 0, where dΘ/dτ vanishes identically.

    >>> [number_of_zeros(beta) for beta in ("1/2", "3/2", "5/2", "7/2", "9/2", -3, 6, 7)]
    [0, 1, 2, 1, 2, 0, 2, 2]
    >>> number_of_zeros(0)
    Traceback (most recent call last):
    ...
    ValueError: beta: dΘ/dτ vanishes identically at β = 0
    """
    return negative_zeros(beta) + (multiplicity_at_zero(beta) > 0) + positive_zeros(beta)


def numbers_on(beta: Range | str) -> ZerosStatement:
    """The number of zeros for every β of a bounded range that is not an integer; at most 1000 cells (m, m + 1).

    :raises TypeError: neither a range nor a text.
    :raises ValueError: the range is not inside [0, ∞), is one integer, is unbounded, or has more cells.

    >>> numbers_on("300..303").counts
    ((300, 100), (301, 101), (302, 102))
    """
    beta = beta if isinstance(beta, Range) else Range.parse(beta, "beta")
    if beta.lower is None or beta.upper is None or beta.lower < 0:
        raise ValueError("beta: the range must lie inside [0, ∞) and be bounded")
    if beta.is_point and beta.lower.q == 1:
        raise ValueError(f"beta: at the integer {beta.lower} dΘ/dτ is a polynomial; ask for a range or another value")
    first, end = int(beta.lower.floor()), int(beta.upper.ceil())
    if end - first > MAX_CELLS:
        raise ValueError(f"beta: the range may hold at most {MAX_CELLS} cells between neighbouring integers")
    return ZerosStatement(beta, tuple((m, number_of_zeros(m + fmpq(1, 2))) for m in range(first, end)))


def positive_zeros(beta: ExactInput) -> int:
    """The number of zeros τ > 0 of dΘ/dτ(·, β), all simple; arguments and errors as in :func:`number_of_zeros`.

    >>> [positive_zeros(beta) for beta in ("5/2", "7/2", "9/2", 4, 7)]
    [1, 1, 2, 1, 2]
    """
    cell, integer = _cell(beta)
    return (cell - 1) // 3 if integer else (cell + 2) // 3


def negative_zeros(beta: ExactInput) -> int:
    """The number of zeros τ < 0 of dΘ/dτ(·, β), 0 or 1, simple; arguments and errors as in :func:`number_of_zeros`.

    >>> [negative_zeros(beta) for beta in ("3/2", "5/2", "7/2", 5)]
    [0, 1, 0, 0]
    """
    cell, integer = _cell(beta)
    return int(not integer and cell % 3 == 2)


def multiplicity_at_zero(beta: ExactInput) -> int:
    """The multiplicity of the zero τ = 0 of dΘ/dτ(·, β), 0 if it is none; arguments and errors as in the others.

    >>> [multiplicity_at_zero(beta) for beta in ("3/2", 1, 2, 3, 4)]
    [0, 0, 1, 2, 0]
    """
    cell, integer = _cell(beta)
    return (cell - 1) % 3 if integer else 0


def _cell(beta: ExactInput) -> tuple[int, bool]:
    """floor(β) and whether β is an integer, for β > 0. For β < 0, (0, False): there are no zeros, as in 0 < β < 1."""
    value = exact(beta, "beta")
    if not isinstance(value, fmpq):
        raise ValueError("beta: the number of zeros needs a rational, not a ball")
    if value == 0:
        raise ValueError("beta: dΘ/dτ vanishes identically at β = 0")
    if value < 0:
        return 0, False
    return int(value.p) // int(value.q), int(value.q) == 1
