"""Sizes of F against a level; more in tests/compliant/zeros.

Page: proofs/check.md.
"""

from __future__ import annotations

from fractions import Fraction

import pytest
from must_reject import mutate
from samples.checker_models import (
    on_a_column,
)

check = mutate.checker()


def test_the_scale_of_the_time_is_said() -> None:
    """κ³ = -α_1/2: without it nobody could compare τ with t."""
    system = check.force.System([Fraction(-3), Fraction(-1), Fraction(-9, 2)], Fraction(1), Fraction(3, 2))
    assert system.words().endswith(" and C_1 = 1, τ = κ t ε^(-2/3), κ^3 = 3/2")


@pytest.mark.parametrize("sign", [-1, 1])
def test_a_value_far_beyond_a_level_is_seen_at_the_first_accuracy(sign: int) -> None:
    """Neither more bits nor smaller boxes are asked for: the error is a small part of the value."""
    asked, b = [], Fraction(3, 2)

    def parts(*question: object) -> check.theta.Value:
        asked.append(question)
        return check.theta.Value(sign << 20, 1, 0, 10, check.theta.Scale(4, 20, Fraction(1)))

    checker = on_a_column()
    checker.value = parts  # type: ignore[method-assign]
    box = (b, b, Fraction(1), Fraction(2))
    assert not check.force.within(checker, box, Fraction(7), splits=4)  # |F| is near 4^b = 8
    assert len(asked) == 1
    assert check.force.within(checker, box, Fraction(9), splits=4)
