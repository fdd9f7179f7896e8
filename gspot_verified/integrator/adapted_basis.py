"""Bases in which errors grow no faster than they must: blocks of eigenvectors. Heuristic: any basis is correct.

Eigenvalues that are close to each other share a block: their eigenvectors nearly coincide. In such a block P > 0 with
AᵀP + PA = 2μP - W, W > 0, gives the norm (eᵀPe)^(1/2), in which an error e' = Ae grows at the rate μ at most, for any
μ above the real parts of the eigenvalues.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.linalg import eig
from numpy.typing import NDArray

Matrix = NDArray[np.float64]

_CLOSE = 0.3
_ZERO = 1e-13


@dataclass(frozen=True, slots=True)
class AdaptedBasis:
    """The columns of S in blocks of the given sizes; ``rate``: the largest real part of an eigenvalue."""

    rows: list[list[float]]
    blocks: tuple[int, ...]
    rate: float


def adapted_basis(rows: Sequence[Sequence[float]]) -> AdaptedBasis:
    """A basis for errors e' = Ae of a real matrix A.

    :raises numpy.linalg.LinAlgError: no basis could be computed, or an entry is not finite.
    """
    matrix = np.array(rows)
    if not np.isfinite(matrix).all():
        raise np.linalg.LinAlgError("an entry is not finite")
    values, vectors = eig(matrix)
    inverse = np.linalg.inv(vectors)
    zero = _ZERO * float(np.abs(values).max())
    columns: list[Matrix] = []
    blocks: list[int] = []
    for cluster in _clusters(values, zero):
        if len(cluster) == 1:
            found = vectors[:, cluster].real
        elif len(cluster) == 2 and values[cluster[0]].imag != 0:
            found = np.stack([vectors[:, cluster[0]].real, vectors[:, cluster[0]].imag], axis=1)
        else:
            found = _subspace((vectors[:, cluster] @ inverse[cluster]).real, len(cluster))
        largest = float(np.abs(values[cluster]).max())
        if len(cluster) > 1 and largest <= zero:
            blocks += [1] * len(cluster)
        else:
            blocks.append(len(cluster))
            if len(cluster) > 2 or (len(cluster) == 2 and values[cluster[0]].imag == 0):
                inner = np.linalg.lstsq(found, matrix @ found, rcond=None)[0]
                found = found @ _norm_of_lyapunov(inner, _CLOSE * largest)
        columns.append(found)
    S = [[float(entry) for entry in row] for row in np.concatenate(columns, axis=1)]
    return AdaptedBasis(S, tuple(blocks), float(values.real.max()))


def _clusters(values: NDArray[np.complex128], zero: float) -> list[list[int]]:
    """Groups of eigenvalues that are close, or conjugate."""
    size = len(values)
    label = list(range(size))
    for i in range(size):
        for j in range(i):
            reach = _CLOSE * max(abs(values[i]), abs(values[j])) + zero
            conjugate = values[i].imag != 0 and values[i] == np.conj(values[j])
            if conjugate or abs(values[i] - values[j]) <= reach:
                old, new = label[i], label[j]
                label = [new if x == old else x for x in label]
    return [[i for i in range(size) if label[i] == name] for name in sorted(set(label))]


def _subspace(projector: Matrix, size: int) -> Matrix:
    """Columns of a projector that span its range: those that are left longest by the ones before."""
    rest, chosen = projector.copy(), []
    for _ in range(size):
        k = int(np.argmax(np.linalg.norm(rest, axis=0)))
        chosen.append(k)
        along = rest[:, k] / np.linalg.norm(rest[:, k])
        rest = rest - np.outer(along, along @ rest)
    columns: Matrix = projector[:, chosen] / np.linalg.norm(projector[:, chosen], axis=0)
    return columns


def _norm_of_lyapunov(matrix: Matrix, slack: float) -> Matrix:
    """S with |S⁻¹e|₂ = (eᵀPe)^(1/2), μ = the largest real part + ``slack``; the symmetric part of S⁻¹AS diagonal."""
    size = len(matrix)
    unit = np.eye(size)
    shifted = matrix - (float(np.linalg.eigvals(matrix).real.max()) + slack) * unit
    lyapunov = np.kron(shifted.T, unit) + np.kron(unit, shifted.T)
    P = np.linalg.solve(lyapunov, -slack * unit.ravel()).reshape(size, size)
    S = np.linalg.inv(np.linalg.cholesky((P + P.T) / 2)).T
    turned = np.linalg.solve(S, matrix @ S)
    basis: Matrix = S @ np.linalg.eigh(turned + turned.T)[1]
    return basis
