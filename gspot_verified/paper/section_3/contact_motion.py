"""The contact force of the motivating example near the trivial solution, by two power series with bounded remainders.

Page: proofs/contact_motion.md. Setting of Sec. 3: alpha1 = alpha2 = -1, alpha3 = -beta, p = 1/2 at the start, beta > 1.
Exponential growth of the balls is met by the working precision.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache

from flint import arb, arb_mat, arb_poly, fmpq

from gspot_verified.numbers.balls import add_remainder, nonfinite, working_bits

START = fmpq(-1, 2)
BITS = 2900
_STEP = fmpq(3, 100)
_TERMS = 1000
_TERMS_FROM_CENTRE = 4500


@lru_cache
def force_by_system(beta: fmpq, epsilon: fmpq, end: fmpq) -> tuple[arb, ...]:
    """Enclosures of l(t) at the ends of the steps from START to ``end``, by section 1 of the page.

    :raises ValueError: ``end`` is not reached by whole steps.
    """
    steps = (end - START) / _STEP
    if steps.q != 1 or steps <= 0:
        raise ValueError(f"end must be {START} plus a positive multiple of {_STEP}, not {end}")
    with working_bits(BITS):
        state, found = [arb(value) for value in _initial(beta)], []
        for k in range(int(steps)):
            state = _one_step(state, START + k * _STEP, beta, epsilon)
            found.append(state[3] - state[1])
    return tuple(found)


def _initial(beta: fmpq) -> tuple[fmpq, fmpq, fmpq, fmpq]:
    """b, Y, V, Z at the start for nu - 1 = 1: b is that of the trivial solution there, -1 t/(1 - beta)."""
    b, p = -START / (1 - beta), -START
    return b, 2 * b / p, fmpq(0), b / p


def _one_step(state: Sequence[arb], start: fmpq, beta: fmpq, epsilon: fmpq) -> list[arb]:
    """The state one step later, by the series with its remainder; not finite when the ratio is not below 1."""
    h, rate = arb(_STEP), 1 / arb(epsilon)
    term, force_before = list(state), arb(0)
    total, sizes = list(state), [_size(state)]
    power = h
    for k in range(_TERMS):
        b, y, v, z = term
        force = z - y
        scaled = rate / (k + 1)
        term = [beta * force / (k + 1), v * scaled, (b - start * force - force_before) * scaled, (y - 2 * z) * scaled]
        force_before = force
        total = [value + coefficient * power for value, coefficient in zip(total, term, strict=True)]
        sizes = [sizes[-1], _size(term) * power]
        power *= h
    first = max(2 * beta, (3 + 2 * abs(start)) / epsilon)
    ratio = (first * _STEP + 2 * _STEP**2 / epsilon) / (_TERMS + 1)
    if not ratio < 1:
        return [nonfinite()] * 4
    rest = 2 * _largest(sizes) * arb(ratio / (1 - ratio))
    return [add_remainder(value, rest) for value in total]


@lru_cache
def force_by_single_equation(beta: fmpq, epsilon: fmpq, end: fmpq) -> arb:
    """An enclosure of l(end), by section 2 of the page; not finite when a hypothesis is open.

    :raises ValueError: |end| is 0 or above 1/2: the remainder is taken there.
    """
    if end == 0 or abs(end) > abs(START):
        raise ValueError(f"end must be in [-1/2, 1/2] without 0, not {end}")
    with working_bits(BITS):
        rows = [_coefficients([arb(i == j) for j in range(4)], beta, epsilon) for i in range(4)]
        matrix = arb_mat([[_derivative(row, START, j, beta, epsilon) for row in rows] for j in range(4)])
        b, y, _, z = _initial(beta)
        wanted = arb_mat([[arb(b)], [arb(beta * (z - y))], [arb(0)], [arb(0)]])
        try:
            first = matrix.solve(wanted)
        except ZeroDivisionError:  # the balls are too wide to tell that the four are independent
            return nonfinite()
        slope = arb(0)
        for i, row in enumerate(rows):
            slope += first[i, 0] * _derivative(row, end, 1, beta, epsilon)
        return slope / beta


def _coefficients(first: list[arb], beta: fmpq, epsilon: fmpq) -> list[arb]:
    """A_k of smooth_trajectory.md, section 3, divided by k!."""
    found = [first[0], first[1], first[2] / 2, first[3] / 6]
    small = arb(epsilon)
    for k in range(_TERMS_FROM_CENTRE):
        drive = (k + 1 - beta) * found[k + 1] * (k + 1) + (k - beta) * found[k]
        forward = -2 * (k + 3) * (k + 2) * found[k + 3] * (k + 1) + small * drive
        found.append(forward / ((k + 1) * (k + 2) * (k + 3) * (k + 4)))
    return found


def _derivative(row: list[arb], t: fmpq, order: int, beta: fmpq, epsilon: fmpq) -> arb:
    """The derivative of Σ A_k (t/epsilon)^k/k! of an order up to 3, with its remainder."""
    x, number, series = t / epsilon, len(row) - 4, arb_poly(row)
    for _ in range(order):
        series = series.derivative()
    size, small = abs(x), epsilon * (1 + beta) * abs(x) ** 3
    ratio = 2 * size / (number + 4) + small / ((number + 3) * (number + 4))
    ratio += small * size / ((number + 2) * (number + 3) * (number + 4))
    ratio *= fmpq(102, 100)
    if number < 1000 or not ratio < 1:
        return nonfinite()
    weights = [abs(row[k]) * arb(size) ** k * k**3 for k in range(number, number + 4)]
    rest = 4 * _largest(weights) * arb(ratio / (1 - ratio)) / arb(abs(t)) ** order
    return add_remainder(series(arb(x)) / arb(epsilon) ** order, rest)


def _size(values: Sequence[arb]) -> arb:
    return _largest([abs(value) for value in values])


def _largest(values: Sequence[arb]) -> arb:
    """An upper bound of all of them."""
    found = values[0].upper()
    for value in values[1:]:
        found = found.max(value.upper())
    return found
