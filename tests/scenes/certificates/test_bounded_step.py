"""Steps as a certificate holds them: what is written is on the grid, and the checker accepts it.

Page: proofs/run_certificate.md, section 2.
"""

from __future__ import annotations

import pytest
from flint import arb
from must_reject import runs

from gspot_verified.scenes.certificates.bounded_step import grid, pair


@pytest.mark.parametrize(
    ("value", "bits", "found"), [(arb(3) / 4, 1, 1), (-arb(3) / 4, 1, -2), (arb(5), 3, 40), (arb(5), -1, 2)]
)
def test_the_grid(value: arb, bits: int, found: int) -> None:
    assert grid(value, bits) == found


def test_pairs_are_exact() -> None:
    assert pair(arb(3) / 8) == [3, -3]
    assert pair(arb(0)) == [0, 0]


def test_what_is_written_is_accepted() -> None:
    """With u exactly 0 in flight: a polynomial without coefficients."""
    assert runs.verdict(runs.stick()).startswith("VERIFIED")
