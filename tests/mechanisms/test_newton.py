"""Newton's method towards a G-spot, and the box that proves it; a zero that is none is not proved.

proofs/krawczyk.md.
"""

from __future__ import annotations

import pytest
from flint import arb, fmpq

from gspot_verified.balls import working_bits
from gspot_verified.expansion.box_program import BoxProgram
from gspot_verified.expansion.expressions import Constant, Variable
from gspot_verified.mechanisms.g_spot import find_g_spot
from gspot_verified.mechanisms.newton import NotFoundError, proved_box
from gspot_verified.mechanisms.shipped import shipped_mechanism

X = Variable(0)


def test_a_box_around_a_zero_and_none_around_another_point() -> None:
    program = BoxProgram([X * X - Constant(fmpq(2))], 1)
    with working_bits(100):
        root = arb(2).sqrt()
        found = proved_box(program, [root.mid()])
        assert found is not None
        assert found[0].is_finite()
        assert (found[0] * found[0] - 2).contains(0)
        assert found[0].rad() < 1e-20
        assert proved_box(BoxProgram([X * X], 1), [arb(0)]) is None
        assert proved_box(BoxProgram([X * X + Constant(fmpq(1))], 1), [arb(0)]) is None


def test_without_a_g_spot_the_error_says_that_none_was_found() -> None:
    with pytest.raises(NotFoundError, match="finds no G-spot from the given start"):
        find_g_spot(shipped_mechanism("genot_brogliato_rod", mu="13/10"))
