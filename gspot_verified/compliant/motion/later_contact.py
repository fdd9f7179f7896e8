"""How a contact goes on from balls of its state, after a touch-down: it is lost, or it lasts for ever.

Proof page: ``proofs/flight.md``, section 9.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field

from flint import arb, arb_poly, fmpq

from gspot_verified.compliant.model.flight import ContactState
from gspot_verified.compliant.model.normal_form import Deviation
from gspot_verified.compliant.motion.contact_series import SeriesCell, series_cells
from gspot_verified.compliant.motion.lasting_contact import lasting_contact
from gspot_verified.compliant.motion.lift_off_state import contact_box
from gspot_verified.compliant.motion.zero_by_series import (
    Piece,
    Shown,
    bracket,
    cell_count,
    duration_of,
    not_positive,
)
from gspot_verified.numbers.balls import working_bits
from gspot_verified.numbers.evidence import cover, every, less
from gspot_verified.numbers.verdict import Evidence, Outcome, Reason

_GUARD_BITS = 64  # bits beyond those asked for, lost on the way; any number is right
_STRETCHES = (30, 100, 300, 1_000)  # work after which the contact is followed anew and further; any numbers are right
_WORK_OF_A_CELL = 18  # rate times time of the power series; chosen by trial: any number is right
_COARSER = 3  # digits fewer of a bracket, where the balls do not give more
_LEAST_DIGITS = 3  # of a bracket, in T


@dataclass(frozen=True, slots=True)
class LaterContact:
    """lambda > 0 from the touch-down up to ``lower``, in T since the end of its bracket, with the state there.

    ``lasts``: why the contact lasts for ever from there on; None: lambda falls through 0 between ``lower`` and
    ``upper``.
    """

    lower: fmpq
    upper: fmpq
    state: ContactState
    evidence: Evidence
    lasts: str | None


@dataclass(frozen=True, slots=True)
class TouchDown:
    """A contact that began with lambda = 0 within ``duration``, in T, before p: the balls of its state hold all of that
    time. ``p`` is exact, in the normal form."""

    landed: ContactState
    duration: fmpq
    p: fmpq


@dataclass(slots=True)
class _Course:
    """The contact from the touch-down on: b-hat, V-hat, Y-hat, Z-hat at p in balls, ``begun`` shows lambda >= 0."""

    landed: ContactState
    p: fmpq
    mean: fmpq
    hats: Sequence[arb]
    begun: Evidence
    bits: int
    lasts: tuple[ContactState, Evidence, str, fmpq] | None = field(default=None)

    def zero(self) -> Deviation:
        """The trivial solution at p."""
        nothing = fmpq(0)
        return Deviation(self.landed.beta, self.landed.epsilon, self.p, nothing, nothing, nothing, nothing)

    def cells(self, duration: fmpq) -> Iterator[SeriesCell]:
        """The motion as the sum of four, from the unit states, each times its ball."""
        start, unit, none = self.zero(), fmpq(1), fmpq(0)
        states = [
            Deviation(start.beta, start.epsilon, start.p, *(unit if k == j else none for k in range(4)))
            for j in range(4)
        ]
        count = cell_count(start, duration, _WORK_OF_A_CELL)
        columns = (series_cells(state, duration, count, self.bits) for state in states)
        for parts in zip(*columns, strict=True):
            with working_bits(self.bits + _GUARD_BITS):
                cell = self._sum(parts)
            yield cell

    def _sum(self, parts: Sequence[SeriesCell]) -> SeriesCell:
        variables, rests = [arb_poly([])] * 4, [arb(0)] * 4
        for factor, part in zip(self.hats, parts, strict=True):
            variables = [total + poly * factor for total, poly in zip(variables, part.variables, strict=True)]
            rests = [total + rest * abs(factor) for total, rest in zip(rests, part.rests, strict=True)]
        return SeriesCell(parts[0].first, parts[0].width, tuple(variables), tuple(rests))

    def state(self, cell: SeriesCell, x: fmpq) -> ContactState:
        """The state at a point of a cell, without hats."""
        landed, p = self.landed, arb(self.p - self.landed.epsilon * (cell.first + x * cell.width))
        b, V, Y, Z = cell.at(arb(x))
        force, b = Z - Y + self.mean, b - p * self.mean
        Y = Y - 2 * self.mean
        return ContactState(
            beta=landed.beta, epsilon=landed.epsilon, alpha_2=landed.alpha_2, p=p, b=b, V=V, Y=Y, force=force
        )

    def stops(self, cell: SeriesCell) -> bool:
        """Whether the contact lasts for ever from the end of the cell on."""
        with working_bits(self.bits + _GUARD_BITS):
            there = self.state(cell, fmpq(1))
            may_last = there.p < 0 and there.V < 0 and there.force_rate > 0  # elsewhere it is in none of the sets
        found = lasting_contact(there, self.bits) if may_last else None
        if found is not None and found.outcome is Outcome.PROVED and found.evidence is not None:
            self.lasts = there, found.evidence, found.detail, cell.last
        return self.lasts is not None


def later_contact(start: TouchDown, mean: fmpq, digits: int, bits: int, budget: int) -> LaterContact | Reason:
    """How the contact after a touch-down goes on, or why that stays open. ``mean``: of the force, in the normal form.

    ``budget``: the work, rate times time, up to which it is followed.
    """
    course = _begun(start, mean, bits)
    if course is None:
        return Reason.WIDE_INPUT
    for work in (*(stretch for stretch in _STRETCHES if stretch < budget), budget):
        shown = Shown()
        cells = course.cells(duration_of(course.zero(), work))
        piece = not_positive(cells, mean, bits, shown, course.stops, rising=True)
        if course.lasts is not None:
            there, lasting, detail, time = course.lasts
            covered = cover(shown.pieces, (fmpq(0), time))
            evidence = every([course.begun, covered, *shown.evidence, lasting])
            return Reason.WIDE_INPUT if evidence is None else LaterContact(time, time, there, evidence, detail)
        if piece is not None:
            return _lost(course, piece, shown, digits) or Reason.WIDE_INPUT
    return Reason.BUDGET


def _begun(start: TouchDown, mean: fmpq, bits: int) -> _Course | None:
    """The state at the end of the bracket of the touch-down: lambda' > 0 since lambda was 0."""
    with working_bits(bits + _GUARD_BITS):
        landed = start.landed
        b, V, Y, Z = contact_box(landed, start.duration, bits + _GUARD_BITS)
        rises = less(0, Y - 2 * Z - V)
        if rises is None:
            return None
        hats = (b + mean * start.p, V, Y + 2 * mean, Z + mean)
        return _Course(landed, start.p, mean, hats, rises, bits)


def _lost(course: _Course, piece: Piece, shown: Shown, digits: int) -> LaterContact | None:
    """The bracket of the lift-off, as short as the balls give it."""
    for accuracy in range(digits, 0, -_COARSER):
        width = fmpq(1, 10 ** (accuracy + _LEAST_DIGITS))
        found = bracket(piece, width / piece.cell.width, course.bits, shown)
        if found is not None:
            with working_bits(course.bits + _GUARD_BITS):
                there = course.state(piece.cell, (found.lower - piece.cell.first) / piece.cell.width)
            evidence = every([course.begun, found.evidence])
            return None if evidence is None else LaterContact(found.lower, found.upper, there, evidence, None)
    return None
