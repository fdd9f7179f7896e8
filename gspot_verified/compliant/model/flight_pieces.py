"""The first touch-down of any flight, or that there is none, by pieces of time that cover it.

Proof page: ``proofs/flight.md``, Theorem F7.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

from flint import arb, fmpq

from gspot_verified.compliant.model.flight import Flight
from gspot_verified.numbers.balls import hull, sign_of
from gspot_verified.numbers.evidence import Ends, at_most, cover, every, less
from gspot_verified.numbers.verdict import Evidence, Reason

_DOUBLINGS = 100  # of the time that is looked at, against endless work
_MOST_PIECES = 2_000  # against endless work; then nothing is said

Narrowed = Callable[[Flight, fmpq, fmpq], tuple[fmpq, fmpq]]
"""Two times at which h certainly is > 0 and < 0, inside the two that are given."""


@dataclass(frozen=True, slots=True)
class Landing:
    """h > 0 on (0, lower], h(upper) < 0, h' < 0 between; without ends: h > 0 for ever."""

    evidence: Evidence
    lower: fmpq | None = None
    upper: fmpq | None = None


@dataclass(slots=True)
class _Shown:
    """The pieces on which h > 0 was shown (0 itself apart), and how."""

    pieces: list[Ends] = field(default_factory=list)
    evidence: list[Evidence] = field(default_factory=list)


def landing(flight: Flight, narrowed: Narrowed) -> Landing | Reason:
    """The first zero of h after 0, or that there is none, or why neither is shown. Hypothesis: h'(0) > 0."""
    last, never = fmpq(1), None
    for _ in range(_DOUBLINGS):
        never = _positive_from(flight, last)
        if never is not None or flight.gap(arb(last)) < 0:
            break
        last *= 2
    shown, waiting = _Shown(), [(fmpq(0), last)]
    for _ in range(_MOST_PIECES):
        if not waiting:
            break
        begin, end = waiting.pop()
        place = hull([arb(begin), arb(end)])
        rate = flight.gap_rate(place)
        if (positive := _positive(flight, begin, end, rate)) is not None:
            shown.pieces.append((begin, end))
            shown.evidence.append(positive)
        elif rate < 0 and flight.gap(arb(end)) < 0:
            lower, upper = narrowed(flight, begin, end)
            signs = (less(rate, 0), less(0, flight.gap(arb(lower))), less(flight.gap(arb(upper)), 0))
            covered = cover([*shown.pieces, (begin, lower)], (fmpq(0), lower))
            evidence = every([covered, *shown.evidence, *signs])
            return Reason.WIDE_INPUT if evidence is None else Landing(evidence, lower, upper)
        else:
            middle = (begin + end) / 2
            waiting += [(middle, end), (begin, middle)]
    if waiting:
        return Reason.WIDE_INPUT if _blurred(flight, waiting[-1][1]) else Reason.BUDGET
    evidence = every([cover(shown.pieces, (fmpq(0), last)), *shown.evidence, never])
    return Reason.BUDGET if evidence is None else Landing(evidence)


def _blurred(flight: Flight, time: fmpq) -> bool:
    """Whether the state is no single point, and h has no certain sign at a time."""
    start = flight.start
    exact = all(value.is_exact() for value in (start.b, start.V, start.Y))
    return not exact and sign_of(flight.gap(arb(time))) not in (1, -1)


def _positive(flight: Flight, begin: fmpq, end: fmpq, rate: arb) -> Evidence | None:
    """h > 0 on [begin, end], or on (0, end]: by its rate from h(0) = 0 on, by the mean value, or by one end."""
    if begin == 0:
        return less(0, rate)
    middle, half = (begin + end) / 2, (end - begin) / 2
    near = flight.gap(arb(middle)) + rate * hull([arb(-half), arb(half)])
    falls = every([less(rate, 0), less(0, flight.gap(arb(end)))])
    return less(0, near) or falls or every([less(0, rate), less(0, flight.gap(arb(begin)))])


def _positive_from(flight: Flight, time: fmpq) -> Evidence | None:
    """h > 0 from a time on for ever: h''' >= 0 from there on, and h'', h' >= 0 and h > 0 there."""
    start = flight.start
    fall = start.Y * arb(-time).exp()
    third, second = fall - start.pull, start.b - start.pull * arb(time) - fall
    signs = [at_most(0, value) for value in (third, second, flight.gap_rate(arb(time)))]
    return every([at_most(start.pull, 0), *signs, less(0, flight.gap(arb(time)))])
