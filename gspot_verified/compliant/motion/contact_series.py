"""The motion in contact from any state, by power series in T with bounded remainders, step by step.

Proof page: ``proofs/contact_series.md``.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from flint import arb, arb_poly, fmpq

from gspot_verified.compliant.model.normal_form import Deviation
from gspot_verified.numbers.balls import add_remainder, approximate, nonfinite, working_bits

MAX_WORK = 10_000
"""The largest rate times duration (section 3 of the page) that is tried."""

_GUARD_BITS = 64  # bits beyond those asked for, lost on the way; any number is right
_LOST_BITS = 1.2  # for each unit of work; chosen by trial: any number is right
_STEPS_PER_BIT = 2  # how many steps for work as large as the bits; chosen by trial: any number is right


def series_rate(state: Deviation, duration: fmpq) -> fmpq:
    """L of the page, section 1, for the times from the state's T up to T + duration; the hypotheses hold for it."""
    size = max(abs(state.p), abs(state.p - state.epsilon * duration))
    guess = max(3.0, 2 * math.sqrt(approximate(size)), (4 * approximate(state.epsilon * state.beta)) ** (1 / 3))
    rate = fmpq(math.ceil(guess * 16) + 1, 16)
    while not _is_rate(rate, size, state):  # the guess is made of floats
        rate *= 2
    return rate


def _is_rate(rate: fmpq, size: fmpq, state: Deviation) -> bool:
    return bool(rate >= 3 and rate**2 >= 4 * size and rate**3 >= 4 * state.epsilon * state.beta)


def series_work(state: Deviation, duration: fmpq) -> fmpq:
    """Rate times duration: the bits that are lost and the number of terms grow with it."""
    return series_rate(state, duration) * duration


def _bits(work: fmpq, bits: int) -> int:
    """A working precision that leaves about ``bits`` bits of the size of the state after this work: a heuristic."""
    return bits + _GUARD_BITS + math.ceil(_LOST_BITS * approximate(work))


@dataclass(frozen=True, slots=True)
class SeriesCell:
    """b-hat, V-hat, Y-hat, Z-hat at T_0 + first + width x, 0 <= x <= 1: polynomials in x, and bounds of the rests."""

    first: fmpq
    width: fmpq
    variables: tuple[arb_poly, ...]
    rests: tuple[arb, ...]

    @property
    def last(self) -> fmpq:
        """The end of the cell, as a time since the state."""
        return self.first + self.width

    def at(self, x: arb) -> list[arb]:
        """b-hat, V-hat, Y-hat, Z-hat at x in [0, 1] (or enclosures over such a ball); not finite elsewhere."""
        if not (x >= 0 and x <= 1):
            return [nonfinite()] * 4
        return [add_remainder(poly(x), rest) for poly, rest in zip(self.variables, self.rests, strict=True)]


def series_cells(
    state: Deviation, duration: fmpq, steps: int, bits: int, later: tuple[fmpq, Sequence[fmpq | arb]] | None = None
) -> Iterator[SeriesCell]:
    """The motion from the state on, in ``steps`` cells of equal width; about ``bits`` bits are left at the end.

    ``later``: a time since the state, and b-hat, V-hat, Y-hat, Z-hat there; the cells then begin at that time.
    """
    first, values = later or (fmpq(0), (state.b, state.V, state.Y, state.Z))
    rate, width = series_rate(state, first + duration), duration / steps
    for k in range(steps):
        precision = _bits(rate * width * (steps - k), bits)
        with working_bits(precision):
            cell = _cell(state, [arb(value) for value in values], first + k * width, width, rate, precision)
            values = cell.at(arb(1))
        yield cell


def carried(state: Deviation, duration: fmpq, bits: int) -> dict[str, arb]:
    """The hats (b, force, V, Z) at the time ``duration`` >= 0 after the state, in T: a few steps.

    Near 2^-bits of the size of the state; where the motion is smaller than that, more bits are needed.
    """
    if duration == 0:
        with working_bits(bits):
            return {name: arb(getattr(state, name)) for name in ("b", "force", "V", "Z")}
    work = series_work(state, duration)
    steps = 1 + math.ceil(_STEPS_PER_BIT * approximate(work) / _bits(work, bits))
    for cell in series_cells(state, duration, steps, bits):
        last = cell
    with working_bits(bits + _GUARD_BITS):
        b, V, Y, Z = last.at(arb(1))
        return {"b": b, "force": Z - Y, "V": V, "Z": Z}


def _cell(state: Deviation, values: Sequence[arb], first: fmpq, width: fmpq, rate: fmpq, bits: int) -> SeriesCell:
    """The recurrence of section 1, each coefficient times its power of the width, and the remainder of section 2."""
    h, epsilon = arb(width), state.epsilon
    growth, press = h * (epsilon * state.beta), h * (state.p - epsilon * first)
    drift = h * h * epsilon
    spread = rate * width + 2 * epsilon * width**2 / rate
    number = _terms(approximate(spread), bits)
    b, V, Y, Z = values
    rows, previous = [(b, V, Y, Z)], arb(0)
    for n in range(1, number + 1):
        force = Z - Y
        following = (growth * force / n, (h * b + press * force - drift * previous) / n, h * V / n, h * (Y - 2 * Z) / n)
        b, V, Y, Z = following
        rows.append(following)
        previous = force
    weights = (2 * epsilon * state.beta / rate, rate, fmpq(1), fmpq(1))
    rest = _rest(rows, weights, spread / (number + 1))
    polynomials = tuple(arb_poly(list(column)) for column in zip(*rows, strict=True))
    return SeriesCell(first, width, polynomials, tuple(rest * weight for weight in weights))


def _rest(rows: Sequence[Sequence[arb]], weights: Sequence[fmpq], ratio: fmpq) -> arb:
    """2 m theta/(1 - theta), with m the larger one of the last two terms (section 2); hypotheses: the time does not
    run backwards, theta < 1."""
    if not 0 <= ratio < 1:
        return nonfinite()
    largest = arb(0)
    for row in rows[-2:]:
        for value, weight in zip(row, weights, strict=True):
            largest = largest.max((value / weight).abs_upper())
    return 2 * largest * ratio / (1 - ratio)


def _terms(spread: float, bits: int) -> int:
    """The first n > 2 spread with spread^n/n! < 2^-bits, about; any number is right."""
    low, high = int(2 * spread) + 2, int(2 * spread) + 2
    goal, rate = bits * math.log(2), math.log(max(spread, 1e-300))
    while math.lgamma(high + 1) - high * rate < goal:
        high *= 2
    while high - low > 1:
        middle = (low + high) // 2
        low, high = (low, middle) if math.lgamma(middle + 1) - middle * rate >= goal else (middle, high)
    return high
