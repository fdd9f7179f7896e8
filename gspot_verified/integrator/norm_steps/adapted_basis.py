"""Bases in which errors grow no faster than they must: blocks of eigenvectors. Heuristic: any basis is correct.

Eigenvalues that are close to each other share a block: their eigenvectors nearly coincide. In such a block P > 0 with
AᵀP + PA = 2μP - W, W > 0, gives the norm (eᵀPe)^(1/2), in which an error e' = Ae grows at the rate μ at most, for any
μ above the real parts of the eigenvalues.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from operator import mul, truediv

import numpy as np
from numpy.linalg import eig
from numpy.typing import NDArray

Matrix = NDArray[np.float64]

_CLOSE = 0.3  # relative distance of eigenvalues that share a block
_EXCESS = 0.3  # growth beyond what is needed, as an exponent, from which on a piece is halved
_SWEEPS = 3  # over all components, for the units
_ZERO = 1e-7  # of the largest eigenvalue: less counts as 0
_LARGEST_CONDITION = 1e12  # of a basis that floats can invert; else the identity
_LEAST_COUPLING = 2.0**-14  # of the largest eigenvalue: a smaller entry that is not 0 counts as that


@dataclass(frozen=True, slots=True)
class AdaptedBasis:
    """The columns of S in blocks of the given sizes; ``values``: the eigenvalues, ``rate``: the largest real part."""

    rows: list[list[float]]
    blocks: tuple[int, ...]
    rate: float
    values: tuple[complex, ...]


@np.errstate(over="ignore", invalid="ignore")  # no number of it is believed
def adapted_basis(rows: Sequence[Sequence[float]]) -> AdaptedBasis:
    """A basis for errors e' = Ae of a real matrix A.

    Slow directions one by one; the unit vectors where no better basis is found.

    :raises numpy.linalg.LinAlgError: no basis could be computed, an entry is not finite, or a unit is beyond doubles.
    """
    given = np.array(rows)
    least = _LEAST_COUPLING * float(np.abs(np.linalg.eigvals(given)).max())
    try:
        scales = _balance(given, least)
    except (ArithmeticError, ValueError):  # ValueError: the quotient of two infinite sums
        raise np.linalg.LinAlgError("a unit is beyond doubles") from None
    matrix = given * scales / scales[:, None]
    values, vectors = eig(matrix)
    zero = _ZERO * float(np.abs(values).max())
    columns: list[Matrix] = []
    blocks: list[int] = []
    found: list[complex] = values.tolist()
    for cluster in _clusters(found, zero):
        first = found[cluster[0]]
        largest = max(abs(found[i]) for i in cluster)
        slow = largest <= zero
        block: Matrix
        if len(cluster) == 1:
            block = vectors[:, cluster].real
        elif len(cluster) == 2 and _conjugate(first, found[cluster[1]]):
            block = np.stack([vectors[:, cluster[0]].real, vectors[:, cluster[0]].imag], axis=1)
        else:
            block = _subspace(matrix, values[cluster])
            if not slow:
                inner: Matrix = np.array(np.linalg.lstsq(block, np.dot(matrix, block), rcond=None)[0], dtype=np.float64)
                block = np.dot(block, _norm_of_lyapunov(inner, _CLOSE * largest))
        blocks += [1] * len(cluster) if slow else [len(cluster)]
        columns.append(block)
    basis = np.concatenate(columns, axis=1)
    if not np.linalg.cond(basis) < _LARGEST_CONDITION:
        basis, blocks = np.eye(len(matrix)), [1] * len(matrix)
    basis = basis * scales[:, None]
    rate = float(values.real.max())
    return AdaptedBasis(basis.tolist(), tuple(blocks), rate, tuple(found))


def _balance(matrix: Matrix, least: float) -> NDArray[np.float64]:
    """Powers of 2 as units of the components, for rows and columns of like size.

    A coupling that is not 0 counts as at least ``least``: an entry of J may be as small as a part that has died out,
    and a tube that is narrow in one unit of 10^-80 is as wide as nothing can be proved of in the others. Large ones are
    not limited: a clock drives a force of 10^30 by as much, and its tube must be that much narrower.
    """
    sizes = np.where(matrix == 0, 0.0, np.maximum(np.abs(matrix), least))
    np.fill_diagonal(sizes, 0.0)
    rows, columns = sizes.tolist(), sizes.T.tolist()
    scales = [1.0] * len(rows)
    for _ in range(_SWEEPS):
        for i in range(len(rows)):
            row = sum(map(mul, rows[i], scales)) / scales[i]
            column = sum(map(truediv, columns[i], scales)) * scales[i]
            if row > 0 and column > 0:
                scales[i] *= 2.0 ** round(math.log2(row / column) / 2)
            elif row > 0 or column > 0:
                scales[i] *= 2.0 ** round(math.log2(row or 1 / column))
    return np.array(scales)


def spectral_basis(rows: Sequence[Sequence[float]], limit: float) -> tuple[Matrix, NDArray[np.bool_]] | None:
    """A basis of the fast directions, |eigenvalue| > limit, and the others; and which columns are the others'.

    None: there are no fast directions, or some of them are growing fast.
    """
    matrix = np.array(rows)
    values = np.linalg.eigvals(matrix)
    fast = np.abs(values) > limit
    if not fast.any() or fast.all() or bool((values[fast].real > limit).any()):
        return None
    parts = [_subspace(matrix, values[fast]), _subspace(matrix, values[~fast])]
    slow = np.array([False] * int(fast.sum()) + [True] * int((~fast).sum()))
    return np.concatenate(parts, axis=1), slow


def pieces_along(
    jacobian: NDArray[np.float64], h: float, most: int, dependency: float
) -> list[tuple[float, float, AdaptedBasis]]:
    """Pieces of [0, 1] with a basis for each, short enough for errors e' = hJ(τ)e to grow little beyond what they must.

    ``jacobian``: the coefficients of J by powers of τ; ``dependency``: how many times wider than J its enclosure is.
    """
    pieces: list[tuple[float, float, AdaptedBasis]] = []
    waiting = [(0.0, 1.0)]
    while waiting:
        a, b = waiting.pop()
        middle = _at(jacobian, (a + b) / 2)
        basis = adapted_basis([[float(entry) for entry in row] for row in middle])
        ends = [middle + dependency * (_at(jacobian, end) - middle) for end in (a, b)]
        excess = max(_growth(basis, end) for end in ends) - max(basis.rate, 0.0)
        if excess * h > _EXCESS and len(pieces) + len(waiting) < most:
            waiting += [((a + b) / 2, b), (a, (a + b) / 2)]
        else:
            pieces.append((a, b, basis))
    return pieces


def _at(jacobian: NDArray[np.float64], tau: float) -> Matrix:
    matrix: Matrix = np.tensordot(tau ** np.arange(len(jacobian)), jacobian, axes=1)
    return matrix


def _growth(basis: AdaptedBasis, matrix: Matrix) -> float:
    """The growth rate of the bounds of Theorem N1: the largest eigenvalue of the norms of the blocks."""
    S = np.array(basis.rows)
    turned = np.linalg.solve(S, matrix @ S)
    ends = np.cumsum([0, *basis.blocks])
    count = len(basis.blocks)
    norms = np.zeros((count, count))
    for i in range(count):
        for j in range(count):
            block = turned[ends[i] : ends[i + 1], ends[j] : ends[j + 1]]
            norms[i, j] = np.linalg.norm(block) if i != j else np.linalg.eigvalsh((block + block.T) / 2)[-1]
    return float(np.linalg.eigvals(norms).real.max())


def _clusters(values: Sequence[complex], zero: float) -> list[list[int]]:
    """Groups of eigenvalues that are close, or conjugate."""
    size = len(values)
    label = list(range(size))
    for i, value in enumerate(values):
        for j, other in enumerate(values[:i]):
            reach = _CLOSE * max(abs(value), abs(other)) + zero
            if _conjugate(value, other) or abs(value - other) <= reach:
                old, new = label[i], label[j]
                label = [new if x == old else x for x in label]
    return [[i for i in range(size) if label[i] == name] for name in sorted(set(label))]


def _conjugate(one: complex, other: complex) -> bool:
    """Whether they are the two of a pair, as the same floats."""
    return one.imag != 0 and one.real == other.real and one.imag == -other.imag


def _subspace(matrix: Matrix, values: NDArray[np.complex128]) -> Matrix:
    """A basis of the subspace of a group of eigenvalues: one component of each column is 1 where the others' are 0."""
    size = len(matrix)
    product = np.eye(size, dtype=complex)
    for value in values:
        product = product @ (matrix - value * np.eye(size))
    flat = np.linalg.svd(product.real)[2][size - len(values) :]
    rest, chosen = flat.copy(), []
    for _ in values:
        k = int(np.argmax(np.linalg.norm(rest, axis=0)))
        chosen.append(k)
        along = rest[:, k] / np.linalg.norm(rest[:, k])
        rest = rest - np.outer(along, along @ rest)
    columns: Matrix = np.linalg.solve(flat[:, chosen], flat).T
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
