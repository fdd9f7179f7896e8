"""Sums over matrix products by binary splitting, against the sum of fractions.

Page: proofs/splitting.md.
"""

from __future__ import annotations

from fractions import Fraction

from flint import fmpz_poly
from hypothesis import given
from hypothesis import strategies as st
from samples.strategies import holds

from gspot_verified.theta_function.sums.matrix_splitting import MatrixBlock, split_matrix_sum

_LINE = st.lists(st.integers(-9, 9), min_size=1, max_size=3)
_ROW = st.tuples(_LINE, _LINE)
_Row = tuple[list[int], list[int]]


def _at(line: list[int], k: int) -> Fraction:
    return Fraction(sum(c * k**i for i, c in enumerate(line)))


@given(
    st.tuples(_ROW, _ROW), st.lists(_ROW, min_size=1, max_size=2), _LINE, st.sampled_from([1, 2, 4]), st.integers(1, 6)
)
def test_the_sums_are_the_fractions(
    matrix: tuple[_Row, _Row], rows: list[_Row], below: list[int], length: int, blocks: int
) -> None:
    denominator = [1_000, *map(abs, below)]  # no zero at an index >= 0
    product = [[Fraction(1), Fraction(0)], [Fraction(0), Fraction(1)]]
    sums = [[Fraction(0)] * 2 for _ in rows]
    for k in range(length * blocks):
        d = _at(denominator, k)
        for total, row in zip(sums, rows, strict=True):
            for j in range(2):
                total[j] += sum((_at(row[i], k) * product[i][j] for i in range(2)), Fraction(0)) / d
        product = [
            [sum((_at(matrix[i][m], k) * product[m][j] for m in range(2)), Fraction(0)) / d for j in range(2)]
            for i in range(2)
        ]

    def polynomials(given_rows: object) -> tuple[tuple[fmpz_poly, fmpz_poly], ...]:
        return tuple((fmpz_poly(a), fmpz_poly(b)) for a, b in given_rows)  # type: ignore[attr-defined]

    steps = MatrixBlock(polynomials(matrix), fmpz_poly(denominator), polynomials(rows)).of_length(length)
    for bits in (30, 2_000):
        found = split_matrix_sum(steps, blocks, bits)
        for i, total in enumerate(sums):
            for j in range(2):
                assert holds(found[i, j], total[j])
                assert bits == 30 or float(found[i, j].rad()) <= 1e-290 * (1 + abs(total[j]))
