"""Where to look for a tube. Heuristics only: whatever they choose, :func:`try_tube` decides."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from flint import arb, fmpq

from gspot_verified.mechanisms.zeros.tube import Equations, OnTube, Tube, try_tube
from gspot_verified.numbers.balls import approximate

_TRIES = 8  # each from what the last one says: a limit of effort
_MUCH_WIDER = 16  # boxes: what is known of a tube so much smaller is no guess
_WIDER = 2  # times the widths that are expected: room for Krawczyk's operator to contract into


@dataclass(frozen=True, slots=True)
class Origin:
    """A place at which a spot is (nearly) known: exact numbers that a process can send. ``widths``: of a tube there.

    ``half`` are the half sides of that tube's box.
    """

    place: tuple[fmpq, ...]
    centre: tuple[fmpq, ...]
    slopes: tuple[tuple[fmpq, ...], ...]
    half: tuple[fmpq, ...] = ()
    widths: tuple[float, ...] = ()

    @classmethod
    def of(cls, on: OnTube) -> Origin:
        """From a tube that was proved."""
        return cls.of_tube(on.tube)

    @classmethod
    def of_tube(cls, tube: Tube) -> Origin:
        """The same of the tube alone."""
        pairs = list(zip(tube.lower, tube.upper, strict=True))
        return cls(
            tuple((low + high) / 2 for low, high in pairs),
            tuple(_rational(value) for value in tube.centre),
            tuple(tuple(_rational(value) for value in row) for row in tube.slopes),
            tuple((high - low) / 2 for low, high in pairs),
            tuple(approximate(value.abs_upper()) for value in tube.found),
        )

    def as_wide_as(self, other: Origin) -> Origin:
        """With the widths of another one."""
        return replace(self, half=other.half, widths=other.widths)

    def distance(self, lower: Sequence[fmpq], upper: Sequence[fmpq]) -> fmpq:
        """How far the place is from the middle of a box, in its half sides."""
        return max(
            abs(2 * value - low - high) / (high - low) if high > low else abs(value - low)
            for value, low, high in zip(self.place, lower, upper, strict=True)
        )

    def predicted(self, place: Sequence[fmpq]) -> tuple[arb, ...]:
        """The centre at another place, by the slopes."""
        moves = [value - own for value, own in zip(place, self.place, strict=True)]
        return tuple(
            arb(start + sum((slope * move for slope, move in zip(row, moves, strict=True)), fmpq(0))).mid()
            for start, row in zip(self.centre, self.slopes, strict=True)
        )

    def expected(self, lower: Sequence[fmpq], upper: Sequence[fmpq]) -> tuple[arb, ...]:
        """Widths that a tube over the box may need: those known grow with the square of the side."""
        if not self.widths:
            return (arb(0),) * len(self.centre)
        ratio = max(
            approximate((high - low) / (2 * own)) if own else 1.0
            for low, high, own in zip(lower, upper, self.half, strict=True)
        )
        if ratio > _MUCH_WIDER:
            return (arb(0),) * len(self.centre)
        return tuple(
            arb(0, _WIDER * width * ratio * ratio + 2.0**-60 * (1 + abs(approximate(start))))
            for width, start in zip(self.widths, self.centre, strict=True)
        )


def proved_tube(
    equations: Equations, lower: tuple[fmpq, ...], upper: tuple[fmpq, ...], origin: Origin
) -> OnTube | None:
    """A tube over the box near the origin's spot, or None after some tries."""
    centre = origin.predicted([(low + high) / 2 for low, high in zip(lower, upper, strict=True)])
    slopes = tuple(tuple(arb(slope).mid() for slope in row) for row in origin.slopes)
    within = origin.expected(lower, upper)
    for _ in range(_TRIES):
        attempt = try_tube(equations, lower, upper, centre, slopes, within)
        if attempt is None:
            return None
        if attempt.proved is not None:
            return attempt.proved
        centre, slopes, within = attempt.centre, attempt.slopes, attempt.within
    return None


def _rational(point: arb) -> fmpq:
    mantissa, exponent = point.man_exp()
    return fmpq(mantissa) * fmpq(2) ** int(exponent)
