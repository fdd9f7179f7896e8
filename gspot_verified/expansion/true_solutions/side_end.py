"""Where followed deviations end, in lift-off or impact, for all delta of a range; and ranges put together.

Proof page: ``proofs/uniform.md``, Theorem U2 and Corollary 2.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from flint import arb, fmpq

from gspot_verified.expansion.true_solutions.cone_choice import cones
from gspot_verified.expansion.true_solutions.growth import DeviationCone, entry_of, grows, ranges_of
from gspot_verified.expansion.true_solutions.track import Track
from gspot_verified.numbers.balls import Exact, ball, hull
from gspot_verified.numbers.evidence import cover, every, less
from gspot_verified.numbers.verdict import Evidence

_ROOM = fmpq(13, 10)  # above the force that is to be reached, for what is subtracted from it


@dataclass(frozen=True)
class SideEnd:
    """For every delta > 0 from ``least`` to ``most``: lambda_N > 0 up to s_1 = ``entered``; then e_lambda has the sign
    ``side`` and lambda_N vanishes (-1), or exceeds ``force`` without vanishing before (1), with p < 0, by the s of
    Theorem U2 with ``cone``; ``ratio`` bounds Y_max/Y_1. From the begin of the run to there the states lie in
    ``states``."""

    least: fmpq
    most: fmpq
    side: int
    entered: fmpq
    cone: DeviationCone
    ratio: arb
    force: arb
    states: tuple[arb, ...]
    evidence: Evidence

    def latest(self, epsilon: fmpq, power: Exact) -> arb:
        """The s_+ of Theorem U2 at delta = epsilon^(1/3), mu = ``power``."""
        shrunk = ball(epsilon) ** (ball(power) / 3)
        return (ball(self.entered) + (self.ratio / shrunk).log() / self.cone.a).upper()


def first_end(tracked: Track, start: fmpq, factor: fmpq) -> SideEnd | None:
    """At the first end of a piece at which Theorem U2 applies, contact being kept until then; ``force`` is ``factor``
    times the mean force."""
    equations = tracked.equations
    scale = hull([equations.delta ** ball(tracked.power), arb(0)])
    before: list[Evidence] = []
    for index, piece in enumerate(tracked.pieces):
        pressing = less(0, piece.mean + scale * piece.force)
        if pressing is None:
            return None
        before.append(pressing)
        entry = entry_of(tracked, index)
        if entry is None:
            continue
        wanted = equations.mean_force * (1 if entry.side < 0 else factor)
        top = (_ROOM * wanted / equations.kappa).upper()
        for cone in cones(equations, entry, tracked.power, top):
            grown = grows(equations, entry, tracked.power, cone)
            ranges = ranges_of(equations, entry, tracked.power, cone)
            if grown is None or ranges is None:
                continue
            reached, grows_until = grown
            if entry.side < 0:
                ended = every([less(ranges.force, reached)])
            else:
                ended = every([less(0, ranges.force), less(wanted, reached + ranges.force)])
                reached = wanted.lower()
            parts = tracked.pieces[: index + 1]
            whole = cover(((part.start, part.end) for part in parts), (start, piece.end))
            evidence = every([*before, whole, grows_until, ended])
            if evidence is not None:
                return SideEnd(
                    least=equations.least,
                    most=equations.exact_delta,
                    side=entry.side,
                    entered=entry.place,
                    cone=cone,
                    ratio=(cone.top / entry.Y.lower()).upper(),
                    force=reached,
                    states=tuple(
                        hull(values) for values in zip(ranges.state, *(part.states for part in parts), strict=True)
                    ),
                    evidence=evidence,
                )
    return None


def joined(ends: Sequence[SideEnd], top: fmpq) -> Evidence | None:
    """That the ends are those of all delta in (0, top], on one side."""
    if len({end.side for end in ends}) != 1:
        return None
    return every([cover(((end.least, end.most) for end in ends), (fmpq(0), top)), *(end.evidence for end in ends)])


def proved_so_far(ends: Sequence[SideEnd]) -> str:
    """Up to which epsilon the same is proved, in words; "" without ends."""
    if not ends or joined(ends, ends[-1].most) is None:
        return ""
    return f"; it is proved up to epsilon = {ends[-1].most ** 3}"


def first_entered(ends: Sequence[SideEnd]) -> fmpq | None:
    """The smallest s_1; None without ends."""
    found: fmpq | None = None
    for end in ends:
        if found is None or end.entered < found:
            found = end.entered
    return found


def latest_at(ends: Sequence[SideEnd], epsilon: fmpq, power: Exact) -> arb:
    """The s by which it has happened at this epsilon.

    :raises ValueError: nothing is proved at it.
    """
    for end in ends:
        if epsilon > 0 and end.least**3 <= epsilon <= end.most**3:
            return end.latest(epsilon, power)
    raise ValueError(f"nothing is proved at epsilon = {epsilon}")
