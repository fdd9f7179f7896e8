"""An initial state as text: five numbers in their order, and no other count of them."""

from __future__ import annotations

import pytest
from flint import fmpq

from gspot_verified.compliant.model.state_text import state_from_text


def test_the_five_numbers_in_their_order() -> None:
    found = state_from_text("1/2, -0.1, -2e-6, 1/7, -1e-6")
    assert (found.p, found.b, found.y, found.v, found.z) == (
        fmpq(1, 2), fmpq(-1, 10), fmpq(-2, 10**6), fmpq(1, 7), fmpq(-1, 10**6),
    )  # fmt: skip


@pytest.mark.parametrize(("text", "count"), [("1/2, -0.1, -2e-6, 0", 4), ("1/2, -0.1, -2e-6, 0, -1e-6, 0", 6), ("", 1)])
def test_another_count_is_refused(text: str, count: int) -> None:
    with pytest.raises(ValueError, match=f"state: expected five numbers p,b,y,v,z, got {count}"):
        state_from_text(text)
