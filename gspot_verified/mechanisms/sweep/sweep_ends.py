"""Both ends of the continued spot on a line: a fold is sought where its tubes end inside the range.

Proof page: ``proofs/sweep.md``, section 6.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace

from flint import fmpq

from gspot_verified.mechanisms.spots.parametric_system import ParametricSystem
from gspot_verified.mechanisms.sweep.sweep_fold import Fold, fold_next_to
from gspot_verified.mechanisms.sweep.sweep_piece import Kind, SweepPiece
from gspot_verified.mechanisms.zeros.tube import Equations


def with_folds(
    system: ParametricSystem, equations: Equations, pieces: Sequence[SweepPiece], own: Collection[int], digits: int
) -> tuple[list[SweepPiece], list[Fold]]:
    """The pieces of a line, those behind a fold said to be so, and the folds.

    ``own`` are the numbers of the pieces that hold the continued spot: a run of neighbours.
    """
    if not own:
        return list(pieces), []
    first, last = min(own), max(own)
    folds = []
    kept = list(pieces[first : last + 1])
    before, after = list(pieces[:first]), list(pieces[last + 1 :])
    if before:
        fold = _behind(system, equations, pieces[first], pieces[first].lower[0], digits)
        if fold is not None and fold.opens == 1:
            folds.append(fold)
            before = _vanished(before[0].lower[0], before[-1].upper[0], fold)
    if after:
        fold = _behind(system, equations, pieces[last], pieces[last].upper[0], digits)
        if fold is not None and fold.opens == -1:
            folds.append(fold)
            after = _vanished(after[0].lower[0], after[-1].upper[0], fold)
    return [*before, *kept, *after], folds


def _behind(system: ParametricSystem, equations: Equations, piece: SweepPiece, end: fmpq, digits: int) -> Fold | None:
    tube = piece.tube()
    return None if tube is None else fold_next_to(system, equations, tube, end, digits)


def _vanished(lower: fmpq, upper: fmpq, fold: Fold) -> list[SweepPiece]:
    """The range between the continued spot's last piece and the end of the line: up to the fold, and behind it."""
    turn = fold.bounds()[0 if fold.opens > 0 else 1]
    if not lower < turn < upper:
        return [SweepPiece((lower,), (upper,), Kind.FOLD)]
    kinds = (Kind.BEYOND, Kind.FOLD) if fold.opens > 0 else (Kind.FOLD, Kind.BEYOND)
    return [SweepPiece((start,), (end,), kind) for start, end, kind in
            zip((lower, turn), (turn, upper), kinds, strict=True)]  # fmt: skip


def without_gaps(pieces: Sequence[SweepPiece]) -> list[SweepPiece]:
    """On a line: neighbours without a tube are one piece."""
    joined: list[SweepPiece] = []
    for piece in pieces:
        if joined and joined[-1].kind is piece.kind is Kind.NO_TUBE:
            joined[-1] = replace(joined[-1], upper=piece.upper, unsure=max(joined[-1].unsure, piece.unsure))
        else:
            joined.append(piece)
    return joined
