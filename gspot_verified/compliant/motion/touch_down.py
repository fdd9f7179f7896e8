"""The end of a flight: that there is exactly one touch-down, and a bracket of it.

Proof page: ``proofs/flight.md``, section 2.
"""

from __future__ import annotations

from dataclasses import dataclass

from flint import arb, fmpq

from gspot_verified.compliant.model.flight import ContactState, Flight
from gspot_verified.compliant.model.flight_pieces import landing
from gspot_verified.numbers.balls import ball_text, hull, sign_of, working_bits
from gspot_verified.numbers.evidence import at_most, equal, every, less, theorem
from gspot_verified.numbers.verdict import Evidence, NoTruthValue, Reason, Verdict

NEVER = "the flight never ends"
_PAGE = "proofs/flight.md"
_DOUBLINGS = 1_100  # of the time of flight, against endless work
_GUARD_BITS = 32  # bits beyond those asked for, lost on the way; any number is right


@dataclass(frozen=True, slots=True)
class FlightEnd(NoTruthValue):
    """How a flight ends. With a touch-down: it is the first one, u in [lower, upper], lambda = 0 and h' < 0 there, and
    ``state`` holds the state.

    Without: the verdict says that the flight never ends, or why the question is open.
    """

    verdict: Verdict
    lower: fmpq | None = None
    upper: fmpq | None = None
    state: ContactState | None = None


def flight_end(start: ContactState, bits: int) -> FlightEnd:
    """The touch-down of the flight from a lift-off state (lambda = 0, h' = V + Y > 0), bracketed to about 2^-bits of u.

    Proved are: exactly one touch-down (alpha_2 < 0, or alpha_2 = 0 and b < 0; Y <= 0), the first touch-down of any
    other flight, or none.
    """
    with working_bits(bits + _GUARD_BITS):
        flight = Flight(start)
        rate = flight.gap_rate(arb(0))
        rising = less(0, rate)
        if rising is None:
            detail = f"V + Y = {ball_text(rate)} > 0 at lift-off is not certain"
            return FlightEnd(Verdict.undecided("the end of the flight", Reason.HYPOTHESIS, detail))
        below = at_most(start.Y, 0)
        if (away := every([below, at_most(start.pull, 0), at_most(0, start.b)])) is not None:
            never = theorem(_PAGE, rising, away)
            return FlightEnd(Verdict.proved(NEVER, never, "alpha_2 >= 0 and b >= 0 at lift-off"))
        back = every([below, less(0, start.pull) or every([equal(start.pull, 0), less(start.b, 0)])])
        if back is None:
            return _any_flight(flight, rising, bits)
        bracket = _bracket(flight, bits)
        if bracket is None:
            return FlightEnd(Verdict.undecided("the bracket of the touch-down", Reason.WIDE_INPUT))
        return _landed(flight, "exactly one touch-down, with h' < 0", bracket, [rising, back])


def _any_flight(flight: Flight, rising: Evidence, bits: int) -> FlightEnd:
    """The end of a flight that is not concave from the start on, by pieces of time."""

    def narrowed(here: Flight, begin: fmpq, end: fmpq) -> tuple[fmpq, fmpq]:
        lower = _moved_on(here, begin, end, 1, bits)
        return lower, _moved_on(here, end, lower, -1, bits)

    found = landing(flight, narrowed)
    if isinstance(found, Reason):
        detail = "neither a first touch-down nor that there is none was shown by pieces of time"
        return FlightEnd(Verdict.undecided("the end of the flight", found, detail))
    if found.lower is None or found.upper is None:
        return FlightEnd(Verdict.proved(NEVER, theorem(_PAGE, rising, found.evidence), "by pieces of time"))
    text = "the first touch-down, with h' < 0"
    return _landed(flight, text, (found.lower, found.upper), [rising, found.evidence])


def _landed(flight: Flight, text: str, bracket: tuple[fmpq, fmpq], shown: list[Evidence]) -> FlightEnd:
    lower, upper = bracket
    place = hull([arb(lower), arb(upper)])
    closing = less(flight.gap_rate(place), 0)
    if closing is None:
        return FlightEnd(Verdict.undecided("the bracket of the touch-down", Reason.WIDE_INPUT, "h' < 0 is open"))
    return FlightEnd(Verdict.proved(text, theorem(_PAGE, *shown, closing)), lower, upper, flight.landed(place))


def _bracket(flight: Flight, bits: int) -> tuple[fmpq, fmpq] | None:
    """h >= 0 at the first (0 when nothing positive was found) and h < 0 at the second, certainly."""
    lower, upper = fmpq(0), fmpq(1)
    for _ in range(_DOUBLINGS):
        sign = sign_of(flight.gap(arb(upper)))
        if sign == -1:
            break
        if sign == 1:
            lower = upper
        upper = 2 * upper
    else:
        return None
    lower = _moved_on(flight, lower, upper, 1, bits)
    return lower, _moved_on(flight, upper, lower, -1, bits)


def _moved_on(flight: Flight, certain: fmpq, other: fmpq, wanted: int, bits: int) -> fmpq:
    """The last point from ``certain`` towards ``other`` at which h certainly has the sign ``wanted``, by bisection."""
    for _ in range(bits):
        middle = (certain + other) / 2
        if sign_of(flight.gap(arb(middle))) == wanted:
            certain = middle
        else:
            other = middle
    return certain
