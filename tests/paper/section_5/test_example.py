"""The example after the corollary: a series that contradicts the scaling is not compared, it fails."""

from __future__ import annotations

import pytest
from flint import fmpq_poly

from gspot_verified.paper.section_5 import example
from gspot_verified.paper.section_5.double_series import example_series


@pytest.mark.parametrize("j", [0, 1])
def test_z_has_the_factor_eps_squared(monkeypatch: pytest.MonkeyPatch, j: int) -> None:
    def with_a_term(weight: int) -> dict[str, dict[tuple[int, int], fmpq_poly]]:
        found = example_series(weight)
        return {**found, "z": {(1, j): fmpq_poly([1]), **found["z"]}}

    monkeypatch.setattr(example, "example_series", with_a_term)
    assert [check.agrees for check in example.ENTRIES["5-example-zbar"]().checks] == [True, False]
