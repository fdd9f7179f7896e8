"""What was chosen for a step, written and read again; texts that are not of this form are refused.

Page: proofs/norm_step.md.
"""

from __future__ import annotations

import json
import math
from collections.abc import Callable
from typing import Any

import pytest
from flint import arb, arb_mat, arb_poly, fmpq

from gspot_verified.integrator.norm_steps.chosen_step import ChosenStep, Steps
from gspot_verified.integrator.norm_steps.fast_decay import DecayState, FastDecay
from gspot_verified.integrator.norm_steps.norm_step import Basis, NormPlan
from gspot_verified.numbers.balls import working_bits

Change = Callable[[dict[str, Any]], None]


def text() -> dict[str, Any]:
    """A step of two components in two pieces, the first in one block."""
    return {
        "solution": [[["1", 0], ["-3", -2]], [["1f", 4]]],
        "h": [["3", -5]],
        "ends": [["0", 0], ["1", -1], ["1", 0]],
        "bases": [[[2], [["1", 0], ["5", -3], ["0", 0], ["1", 2]]], [[1, 1], [["1", 0]] * 4]],
        "margins": [["3", -1], ["5", -2]],
        "series": [4, 30],
        "length": 0.25,
        "decay": [[[-1.5, 2.0], [-3.0, 0.0]], [0.5, 4.0], 1.0, 0.125, math.inf],
    }


def same(one: ChosenStep, other: ChosenStep) -> bool:
    """Exactly the same numbers."""
    pairs = zip(one.plan.bases, other.plan.bases, strict=True)
    return (
        [p.coeffs() for p in one.solution] == [p.coeffs() for p in other.solution]
        and (one.h is None) == (other.h is None)
        and (one.h is None or one.h == other.h)
        and one.plan.ends == other.plan.ends
        and one.plan.margins == other.plan.margins
        and all(a.S == b.S and a.blocks == b.blocks for a, b in pairs)
        and (one.plan.disc, one.plan.length) == (other.plan.disc, other.plan.length)
        and (one.length, one.decay) == (other.length, other.decay)
    )


def test_each_number_stands_in_its_place() -> None:
    read = ChosenStep.from_json(text())
    quarters = [arb(-3) / 4, arb(5) / 8, arb(5) / 4]
    bases = (Basis(arb_mat(2, 2, [1, quarters[1], 0, 4]), (2,)), Basis(arb_mat(2, 2, [1, 1, 1, 1]), (1, 1)))
    plan = NormPlan((arb(0), arb(0.5), arb(1)), bases, (arb(1.5), quarters[2]), 4, 30)
    decay = DecayState((-1.5 + 2j, -3 + 0j), (0.5, 4.0), 1.0, 0.125, math.inf)
    made = ChosenStep((arb_poly([1, quarters[0]]), arb_poly([496])), arb(3) / 32, plan, 0.25, decay)
    assert same(read, made)
    assert json.loads(json.dumps(made.to_json())) == text()


def test_what_is_written_is_read_unchanged_at_any_precision() -> None:
    with working_bits(500):
        long = [arb(fmpq(1, 3)).mid(), arb(7).sqrt().mid() * arb((1, -900))]
    plan = ChosenStep.from_json(text()).plan
    with working_bits(53):
        made = ChosenStep((arb_poly(long), arb_poly([0])), None, plan, 1e-300, FastDecay().state)
        assert same(ChosenStep.from_json(json.loads(json.dumps(made.to_json()))), made)


def setting(key: str, value: Any) -> Change:
    return lambda data: data.__setitem__(key, value)


def third_piece(end: list[Any]) -> Change:
    """One more end before the last one, with a basis and a margin of its own."""

    def change(data: dict[str, Any]) -> None:
        data["ends"].insert(2, end)
        data["bases"].append(data["bases"][1])
        data["margins"].append(["1", 1])

    return change


@pytest.mark.parametrize(
    "change",
    [
        setting("h", None),
        setting("series", [2, 1]),
        setting("series", [2**10, 10**5]),
        setting("length", 5e-324),
        setting("margins", [["1", 10**6], ["1", -(10**6)]]),
        setting("margins", [["1", 0], ["1" * 10**5, 0]]),
        third_piece(["3", -2]),
    ],
)
def test_steps_that_are_read(change: Change) -> None:
    data = text()
    change(data)
    assert ChosenStep.from_json(data).to_json() == data


@pytest.mark.parametrize(
    ("change", "reason"),
    [
        *((setting("series", series), "a disc or a length out of range") for series in [
            [1, 30], [2**10 + 1, 30], [4, 0], [4, 10**5 + 1], [4.0, 30], [4, 30.0], [True, 30], [4, True]
        ]),
        *((setting("length", length), "a length out of range") for length in [
            0.0, -0.25, math.inf, math.nan, 1, True
        ]),
        *((setting("bases", [[blocks, [["1", 0]] * 4]] * 2), "a basis of another size") for blocks in [
            [1], [1, 2], [0, 2], [3, -1], [2.0], [1, 1.0], [True, True], []
        ]),
        *((setting("bases", [[[2], [["1", 0]] * count]] * 2), "a basis of another size") for count in [0, 3, 5]),
        *((setting("ends", ends), "the pieces do not fill the step") for ends in [
            [], [["1", -2], ["1", -1], ["1", 0]], [["0", 0], ["1", -1], ["3", -2]], [["0", 0], ["1", -1], ["1", 1]],
            [["0", 0], ["1", 0]], [["0", 0], ["1", -2], ["1", -1], ["1", 0]],
        ]),
        *((third_piece(end), "the pieces do not fill the step") for end in [["1", -1], ["1", -2], ["1", 0], ["-1", 0]]),
        (setting("margins", [["1", 0]]), "the pieces do not fill the step"),
        (setting("margins", [["1", 0]] * 3), "the pieces do not fill the step"),
        (setting("bases", [text()["bases"][0]]), "the pieces do not fill the step"),
        *((setting("h", [number]), "a number out of range") for number in [
            ["1", 10**6 + 1], ["1", -(10**6) - 1], ["1", 0.0], ["1", True], ["1" * (10**5 + 1), 0]
        ]),
        *((setting("h", h), "not a step: ") for h in [[], 3, [3], [[3, 0]]]),
        (setting("h", [["", 0]]), "invalid literal"),
        (setting("decay", [[], [], 1.0, 2.0]), "not the state of a decay"),
        (lambda data: data.pop("ends"), "not a step: 'ends'"),
        (lambda data: data.pop("solution"), "not a step: 'solution'"),
    ],
)  # fmt: skip
def test_texts_that_are_no_step(change: Change, reason: str) -> None:
    data = text()
    change(data)
    with pytest.raises(ValueError, match=reason):
        ChosenStep.from_json(data)


@pytest.mark.parametrize("data", [None, [], "step", 3])
def test_data_that_is_no_step(data: Any) -> None:
    with pytest.raises(ValueError, match="not a step: "):
        ChosenStep.from_json(data)


def test_steps_that_are_counted() -> None:
    steps = Steps(3)
    assert steps.known() is None
    assert (steps.budget, steps.left) == (3, 3)
    steps.proved(ChosenStep.from_json(text()), arb(1))
    assert (steps.budget, steps.left) == (3, 2)
