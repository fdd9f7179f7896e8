"""Newton's method towards a G-spot, and the box that proves it; a zero that is none is not proved.

proofs/krawczyk.md.
"""

from __future__ import annotations

import pytest
from flint import arb, fmpq

from gspot_verified.expansion.series.system import System
from gspot_verified.functions.box_program import BoxProgram
from gspot_verified.functions.expressions import Constant, Variable
from gspot_verified.functions.rings import BALLS
from gspot_verified.mechanisms.shipped import shipped_mechanism
from gspot_verified.mechanisms.spots.g_spot import find_g_spot
from gspot_verified.mechanisms.zeros.newton import NotFoundError, newton_point, proved_box
from gspot_verified.numbers.balls import working_bits

X = Variable(0)


def test_a_box_around_a_zero_and_none_around_another_point() -> None:
    program = BoxProgram([X * X - Constant(fmpq(2))], 1)
    with working_bits(100):
        root = arb(2).sqrt()
        proved = proved_box(program, [root.mid()])
        assert proved is not None
        found, shown = proved
        assert "lies in the interior of" in str(shown)
        assert found[0].is_finite()
        assert (found[0] * found[0] - 2).contains(0)
        assert found[0].rad() < 1e-20
        assert proved_box(BoxProgram([X * X], 1), [arb(0)]) is None
        assert proved_box(BoxProgram([X * X + Constant(fmpq(1))], 1), [arb(0)]) is None


def test_without_a_g_spot_the_error_says_that_none_was_found() -> None:
    with pytest.raises(NotFoundError, match="finds no G-spot from the given start"):
        find_g_spot(shipped_mechanism("genot_brogliato_rod", mu="13/10"))


@pytest.mark.parametrize("bits", [64, 200, 1000])
def test_newtons_method_reaches_the_zero_and_the_box_holds_it(bits: int) -> None:
    """x^2 = 2, xy = 3, y + z = 0, xw = 1 from a point nearby: coupled, of both signs."""
    x, y, z, w = map(Variable, range(4))
    one, two, three = (Constant(fmpq(k)) for k in (1, 2, 3))
    with working_bits(bits):
        start = tuple(arb(text) for text in ("1.3", "2", "-2.5", "0.9"))
        conditions = (x * x - two, x * y - three, y + z, x * w - one)
        p, b, v, other = conditions
        system = System("four", (x,) * 4, (x,) * 4, v, other, p, b, one, one, one, (), start, BALLS)
        program = BoxProgram(system.conditions, 4)
        point = newton_point(system, program)
        root = arb(2).sqrt()
        exact = (root, 3 / root, -3 / root, 1 / root)
        assert all(value.is_exact() for value in point)
        assert all(abs(found - value) < arb(2) ** (30 - bits) for found, value in zip(point, exact, strict=True))
        proved = proved_box(program, point)
        assert proved is not None
        box, _ = proved
        assert all(ball.is_finite() and ball.overlaps(value) for ball, value in zip(box, exact, strict=True))


def test_a_larger_box_is_tried_where_a_small_one_holds_no_zero() -> None:
    program = BoxProgram([Variable(0) - Constant(fmpq(1))], 1)
    with working_bits(100):
        for distance in (2**-90, 2**-60, 2**-30):
            found = proved_box(program, [arb(1) + arb(distance)])
            assert found is not None
            assert found[0][0].contains(1)
        assert proved_box(program, [arb(10**9)]) is None
