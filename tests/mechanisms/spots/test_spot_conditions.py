"""The conditions taken apart: what is solved for, in which order, and that the zeros stay the same.

proofs/all_g_spots.md, sections 1 and 2.
"""

from __future__ import annotations

from flint import arb, fmpq

from gspot_verified.functions.box_program import BoxProgram
from gspot_verified.functions.expressions import Constant, Expression, Sine, Variable
from gspot_verified.mechanisms.spots.spot_conditions import Stage, take_apart

A, B, C, D, E = (Variable(i) for i in range(5))
TWO = Constant(fmpq(2))


def test_a_translation_and_its_velocity_are_solved_for() -> None:
    conditions: dict[str, Expression] = {"p": Sine(A) - C, "b": D * D - A, "y": TWO * B + Sine(A), "v": C + D * Sine(A)}
    apart = take_apart(conditions, 5)
    assert {(each.index, each.condition) for each in apart.explicit} == {(1, "y"), (2, "v")}
    assert apart.stages == (Stage(("p", "b"), (0, 3)),)
    assert apart.free == (4,)
    at = [arb("0.3"), arb(0), arb(0), arb("0.7"), arb(0)]
    for each in apart.explicit:
        at[each.index] = BoxProgram([each.value], 5).values(at)[0]
    for name, value in zip(conditions, BoxProgram(list(conditions.values()), 5).values(at), strict=True):
        rest = apart.functions.get(name)
        assert value.overlaps(arb(0) if rest is None else BoxProgram([rest], 5).values(at)[0])


def test_p_and_b_are_never_solved_for() -> None:
    apart = take_apart({"p": A - TWO, "b": B - A, "y": C, "v": D}, 4)
    assert {each.condition for each in apart.explicit} == {"y", "v"}
    assert apart.stages == (Stage(("p",), (0,)), Stage(("b",), (1,)))


def test_kept_components_are_solved_for_last() -> None:
    assert take_apart({"y": A + B}, 2).explicit[0].index == 1
    assert take_apart({"y": A + B}, 2, kept=[1]).explicit[0].index == 0
    assert take_apart({"y": A * A + B}, 2, kept=[1]).explicit[0].index == 1


def test_values_that_use_each_other_use_only_what_remains() -> None:
    apart = take_apart({"y": A + B + Sine(D), "v": B - C * D}, 4)
    remaining = {2, 3}
    for each in apart.explicit:
        assert BoxProgram([each.value], 4).depends[0] <= remaining


def test_more_unknowns_than_conditions_come_last() -> None:
    apart = take_apart({"p": Sine(A), "b": B * C * D}, 5)
    assert apart.stages == (Stage(("p",), (0,)), Stage(("b",), (1, 2, 3)))
    assert [stage.dimension for stage in apart.stages] == [0, 2]


def test_a_condition_without_unknowns_is_a_stage_of_its_own() -> None:
    assert take_apart({"p": TWO, "b": Sine(A)}, 1).stages[0] == Stage(("p",), ())
