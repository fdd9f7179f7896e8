"""Where a certificate puts the bracket of an event.

Page: proofs/run_certificate.md, section 5.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from types import SimpleNamespace
from typing import Any

import pytest
from flint import arb, fmpq
from must_reject import runs

from gspot_verified.numbers.balls import working_bits
from gspot_verified.scenes.certificates.bounded_step import NotBounded
from gspot_verified.scenes.certificates.run_writer import RunWriter


@pytest.mark.parametrize("lines", [runs.flight, runs.stick])
def test_what_is_written_is_accepted(lines: Callable[[], runs.Lines]) -> None:
    said = runs.verdict(lines())
    assert said.startswith("VERIFIED")
    assert "lift-off at t in [" in said


@pytest.mark.parametrize("radius", [30, 77])
def test_the_written_bracket_is_hardly_wider_than_the_time(radius: int) -> None:
    writer: Any = SimpleNamespace(scene=SimpleNamespace(epsilon=fmpq(1, 3)), last=200)
    with working_bits(300):
        low, high = (Fraction(text) for text in RunWriter._bracket(writer, arb(7) / 4 + arb(0, arb(2) ** -radius)))
    width = Fraction(2, 3 * 2**radius)
    assert low <= Fraction(7, 12) - width / 2
    assert high >= Fraction(7, 12) + width / 2
    assert high - low < width * 103 / 100


@pytest.mark.parametrize("side", [-1, 1])
def test_the_nearest_point_with_a_certain_sign(side: int) -> None:
    """The function 1/2 - τ within 3 units; where no sign is certain inside of the step there is no bracket."""
    writer: Any = SimpleNamespace(last=20)
    middle, unit = arb(1) / 2, arb(2) ** -20
    found = RunWriter._first(writer, lambda tau: middle - tau + arb(0, 3 * unit), middle, side)
    assert found == middle + 4 * side * unit
    with pytest.raises(NotBounded, match="not inside of one step"):
        RunWriter._first(writer, lambda _: arb(0, 1), middle, side)
