"""Deviations followed from piece to piece: proofs/uniform.md, Theorem U1."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from flint import arb, arb_mat, fmpq

from gspot_verified.expansion.true_solutions.equations import DeviationEquations
from gspot_verified.expansion.true_solutions.frames import identity, number_of_pieces
from gspot_verified.expansion.true_solutions.piece import Deviations, Rules, TrackPiece, advance
from gspot_verified.numbers.balls import Exact


@dataclass(frozen=True)
class Track:
    """The pieces from the start on, up to the end or to where the inequality failed."""

    equations: DeviationEquations
    power: Exact
    end: fmpq
    pieces: tuple[TrackPiece, ...]

    @property
    def is_whole(self) -> bool:
        """Whether the end was reached."""
        return bool(self.pieces) and bool(self.pieces[-1].end == self.end)

    def z_deviation(self, piece: TrackPiece) -> arb:
        """The deviation of z, delta^-mu times: z = y + lambda/k_2."""
        k_2 = arb(self.equations.trajectory.system.regularisation.k_2)
        y = piece.deviations[self.equations.y]
        return piece.force / k_2 + y if piece.force.is_finite() else piece.force


def track(
    equations: DeviationEquations,
    power: Exact,
    start: fmpq,
    end: fmpq,
    centre: Sequence[arb],
    radii: Sequence[arb],
    fast: arb,
    frame: arb_mat | None = None,
) -> Track:
    """All solutions with |u - centre| <= radii, e delta^-mu = frame u, and |phi| delta^-mu <= fast at ``start``.

    Centre and frame are exact; without a frame u is e delta^-mu itself.
    """
    rules = Rules(equations, power)
    turned = identity(equations.size) if frame is None else frame
    state = Deviations(tuple(centre), tuple(radii), turned, fast, fmpq(0), arb(0))
    count = number_of_pieces(equations, start, end)
    step, pieces = (end - start) / count, list[TrackPiece]()
    for k in range(count):
        piece = advance(rules, state, start + step * k, start + step * (k + 1))
        if piece is None:
            break
        pieces.append(piece)
        state = piece.at_end
    return Track(equations, power, end, tuple(pieces))
