"""Certificates for the contact force on the slow manifold, uniform in epsilon: pieces found by evaluation in balls.

What the pieces prove: ``proofs/certificate.md``, force and lift_off; Theorem C: ``proofs/monotone.md``. Nothing here is
trusted: ``proofs/checker`` checks each piece again without this package.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from pathlib import Path
from typing import ClassVar, Literal

from flint import arb, fmpq

from gspot_verified.certificates.text import certificate_text, write_certificate
from gspot_verified.compliant.contact.threshold import rounded
from gspot_verified.leading_order.contact_force import ContactForce
from gspot_verified.leading_order.iwc import IwcResult
from gspot_verified.numbers.balls import approximate, hull, sign_of, working_bits
from gspot_verified.numbers.verdict import NoTruthValue
from gspot_verified.numbers.written import Shown, Written
from gspot_verified.signs.cover.column_models import ColumnModels
from gspot_verified.signs.cover.pieces import Column, ColumnPiece, Kind, cell_of
from gspot_verified.signs.cover.tails import left_threshold
from gspot_verified.signs.cover.zero_column import reach_of_cell, right_tail
from gspot_verified.theta_function.value.evaluate import evaluate
from gspot_verified.work.ranges import Range

_NOT_HERE = "is what is stated; that it holds is proved elsewhere"


@dataclass(frozen=True, slots=True)
class ForceStatement(NoTruthValue, Written):
    """On the slow manifold lambda > 0 for every tau of the range and every epsilon in (0, epsilon]; |F| <= level where
    F has the sign that lowers the force."""

    version: ClassVar[int] = 2
    kind: ClassVar[Literal["force"]] = "force"
    ask: ClassVar[str] = f".epsilon {_NOT_HERE}"
    written: ClassVar[str] = "kind alpha=force.alphas c1=force.c1 epsilon level tau"

    force: ContactForce
    tau: Range
    epsilon: fmpq
    level: fmpq

    def __str__(self) -> str:
        return f"{_on_the_manifold(self.force)}, λ > 0 for every τ in {self.tau} and every ε in (0, {self.epsilon}]"


@dataclass(frozen=True, slots=True)
class LiftOffStatement(NoTruthValue, Written):
    """On the slow manifold lambda < 0 at tau for every epsilon >= epsilon; |F| >= level."""

    version: ClassVar[int] = 2
    kind: ClassVar[Literal["lift_off"]] = "lift_off"
    ask: ClassVar[str] = f".epsilon {_NOT_HERE}"
    written: ClassVar[str] = "kind alpha=force.alphas c1=force.c1 epsilon level tau"

    force: ContactForce
    tau: fmpq
    epsilon: fmpq
    level: fmpq

    def __str__(self) -> str:
        return f"{_on_the_manifold(self.force)}, λ < 0 at τ = {self.tau} for every ε ≥ {self.epsilon}"


def _on_the_manifold(force: ContactForce) -> str:
    numbers = f"({force.alpha_1}, {force.alpha_2}, {force.alpha_3})"
    scale = f"τ = κ t ε^(-2/3), κ^3 = {-force.alpha_1 / 2}"
    return f"on the slow manifold of the compliant model with α = {numbers} and C1 = {force.c1}, {scale}"


_DIGITS = 12  # of values whose signs are wanted
_LEAST_WIDTH = fmpq(1, 2**20)  # of a piece in tau; where a narrower one is needed nothing is provable
_FIRST_WIDTH = fmpq(1, 2)  # of a piece in tau; halved where nothing is certain


class NotProvable(ValueError):
    """No certificate of this kind was found; the text says why. It does not mean that the statement is false."""


@dataclass(frozen=True, slots=True)
class ForceCertificate(Shown):
    """A statement and the one column that proves it."""

    statement: ForceStatement | LiftOffStatement
    column: Column

    def __str__(self) -> str:
        return f"a certificate of: {self.statement}"

    def text(self) -> str:
        """The certificate as it stands in a file."""
        return certificate_text(self.statement, [self.column])

    def write(self, path: Path) -> None:
        """Write it as a file; see :func:`gspot_verified.certificates.text.write_certificate`."""
        write_certificate(path, self.statement, [self.column])


def force_certificate(force: ContactForce, start: fmpq | None, epsilon: fmpq) -> ForceCertificate:
    """That lambda > 0 on [start, infinity), None: on the line, on the slow manifold for every epsilon up to this one.

    :raises ValueError: not 1 < beta < 5, or the side of lift-off; the whole line with an odd floor(beta), where the
        force is not bounded below.
    :raises NotProvable: the pieces were not found; at a larger epsilon than the exact one there are none.

    >>> from gspot_verified.leading_order.contact_force import contact_force
    >>> certificate = force_certificate(contact_force("5/2", c1=-1), fmpq(-10), fmpq(4, 5))
    >>> str(certificate.statement).endswith("for every τ in [-10, inf) and every ε in (0, 4/5]")
    True
    """
    _checked(force, 1)
    b, sign = force.beta - 1, (-1) ** int(force.beta.floor())
    if start is None and sign < 0:
        raise ValueError("tau: on the whole line the force is bounded below only where floor(beta) is even")
    level = _level(force, epsilon, -1)
    cell = cell_of(force.beta, force.beta)
    tail = right_tail(ColumnModels(b, b, reach_of_cell(cell)), cell, reach_of_cell(cell), 0)
    if tail is None:
        raise NotProvable("the signs of the derivatives far to the right are not certain")
    first = -left_threshold(b, b, cell) if start is None else start
    tail = max(tail, first)
    pieces = [*_middle(b, sign, level, first, tail), ColumnPiece(Kind.RIGHT, tail, None, 0)]
    if start is None:
        pieces.insert(0, ColumnPiece(Kind.LEFT, None, first))
    column = Column(force.beta, force.beta, tuple(pieces))
    return ForceCertificate(ForceStatement(force, Range(start, None, start is not None, False), epsilon, level), column)


def lift_off_certificate(force: ContactForce, tau: fmpq, epsilon: fmpq) -> ForceCertificate:
    """That lambda < 0 at tau on the slow manifold for every epsilon from the given one on.

    :raises ValueError: not 1 < beta < 5, or the side of the impact.
    :raises NotProvable: |Theta(tau, beta - 1)| is not certainly large enough with the right sign.
    """
    _checked(force, -1)
    b, sign = force.beta - 1, (-1) ** int(force.beta.floor())
    level = _level(force, epsilon, 1)
    value = evaluate(tau, b, digits=2 * _DIGITS).value
    if not sign * value > level:
        raise NotProvable(f"at τ = {tau} the deviation does not certainly exceed the mean force at ε = {epsilon}")
    column = Column(force.beta, force.beta, (ColumnPiece(Kind.LEVEL, tau, tau + 1),))
    return ForceCertificate(LiftOffStatement(force, tau, epsilon, level), column)


def iwc_certificate(leading: IwcResult) -> ForceCertificate:
    """A certificate beside a result at leading order: the same half-line, epsilon a little below epsilon_0, or the end
    of the lift-off bracket, rounded to two or three places.

    :raises ValueError: not 1 < beta < 5.
    :raises NotProvable: no epsilon_0 or no bracket was found, or no pieces.

    >>> from gspot_verified import iwc
    >>> str(iwc_certificate(iwc("5/2", c1=1).leading).statement).rpartition(", ")[2]
    'λ < 0 at τ = 5537/1000 for every ε ≥ 1/1000'
    """
    if leading.force.takes_impact:
        if leading.every_epsilon or leading.epsilon_0 is None:
            raise NotProvable("there is no least upper bound of ε to certify")
        return force_certificate(leading.force, leading.start, rounded(leading.epsilon_0 * fmpq(99, 100), 2))
    time = leading.lift_off
    if time is None or time.upper is None:
        raise NotProvable("no lift-off time was bracketed")
    return lift_off_certificate(leading.force, fmpq(int((time.upper * 1000).floor()) + 1, 1000), time.epsilon)


def check_ratio(beta: fmpq) -> None:
    """Passes for a beta that a certificate of the force may have: it can be asked before the work.

    :raises ValueError: not 1 < beta < 5.
    """
    if not 1 < beta < 5:
        raise ValueError(f"beta: a certificate of the force needs 1 < beta < 5, got {beta}")


def _checked(force: ContactForce, side: int) -> None:
    check_ratio(force.beta)
    if force.takes_impact is not (side == 1):
        raise ValueError("c1: this is the other side of C_1/Gamma(-beta)")


def _level(force: ContactForce, epsilon: fmpq, direction: int) -> fmpq:
    """mean/(A epsilon^p beta), rounded to a short rational: down (direction -1) or up."""
    exact = force.level(epsilon, 2 * _DIGITS)
    with working_bits(128):
        value = exact / force.beta
        digits = _DIGITS - math.floor(approximate(value.log() / arb(10).log()))  # a double may not hold the value
        scaled = value * arb(10) ** digits
        number = scaled.lower().floor() if direction < 0 else scaled.upper().ceil()
        whole = number.unique_fmpz()
    assert whole is not None
    return fmpq(whole) * fmpq(10) ** -digits


def _middle(b: fmpq, sign: int, level: fmpq, start: fmpq, end: fmpq) -> list[ColumnPiece]:
    """Pieces sign and level from start to end, as wide as the evaluation over them allows."""
    pieces: list[ColumnPiece] = []
    tau, width = start, _FIRST_WIDTH
    while tau < end:
        upper = min(tau + width, end)
        kind = _kind(b, sign, level, tau, upper)
        if kind is None:
            width /= 2
            if width < _LEAST_WIDTH:
                raise NotProvable(f"next to τ = {approximate(tau):.6g} neither the sign nor the level is certain")
            continue
        pieces.append(ColumnPiece(kind, tau, upper, sign if kind is Kind.SIGN else 0))
        tau, width = upper, min(2 * width, _FIRST_WIDTH)
    return pieces


def _kind(b: fmpq, sign: int, level: fmpq, lower: fmpq, upper: fmpq) -> Kind | None:
    with working_bits(128):
        place = hull([arb(lower), arb(upper)])
    value = evaluate(place, b, digits=_DIGITS).value
    if sign_of(sign * value) == 1:
        return Kind.SIGN
    return Kind.LEVEL if abs(value).upper() < level else None
