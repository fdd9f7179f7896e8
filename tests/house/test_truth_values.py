"""No result is silently true: ``if result:`` raises for every result type that claims or leaves open something."""

from __future__ import annotations

import importlib
import inspect
import pkgutil
import re
import typing
from collections.abc import Callable, Iterator
from enum import Enum

import pytest

import gspot_verified
from gspot_verified import Verdict, evaluate, iwc, side
from gspot_verified import sign as sign_on_ranges
from gspot_verified.numbers.verdict import NoTruthValue
from gspot_verified.signs.zeros.brackets import zeros_at
from gspot_verified.signs.zeros.integer_zeros import zeros_at_integer
from gspot_verified.signs.zeros.zeros import zeros_on_range

PLAIN = {
    "cost.times.rows.Benchmark": "times that were measured",
    "certificates.text.Statement": "what any statement has, not a class of results",
    "compliant.model.normal_form.CompliantModel": "four numbers of a model, which claim nothing",
    "compliant.model.normal_form.CompliantState": "five numbers of a state, which claim nothing",
    "cost.measurement.measurement.Measurement": "times that were measured",
    "cost.times.rows.TimeCurve": "times that were measured",
    "cost.benchmarks.theta.CostReport": "times that were measured",
    "cost.benchmarks.expand.ExpandCost": "times that were measured",
    "cost.peers.external.ExternalTime": "times that were measured",
    "cost.times.growth.FittedGrowth": "times that were measured",
    "cli.commands.cost_command.Measured": "the shape of a cost report, not a class of results",
    "paper.checks.paper.Quotation": "words of the paper",
    "paper.claims.PaperClaim": "words of the paper; what became of them is .standing(outcomes)",
    "paper.checks.consequences.Consequence": "a reading of the paper, in words",
    "paper.dependencies.Dependencies": "names",
    "report.pictures.canvas.Picture": "a drawing",
    "hard_cases.catalogue.Family": "words, and the levels of a question",
    "cost.benchmarks.sign.SignCost": "times that were measured",
    "cost.benchmarks.expand.Size": "times that were measured",
    "expansion.time_series.TimeSeries": "coefficients; what is claimed of them is in the trajectory's accuracy",
    "integrator.norm_steps.chosen_step.ChosenStep": "what heuristics chose, which claims nothing",
    "integrator.norm_steps.fast_decay.DecayState": "numbers that a heuristic goes on from",
    "cost.times.measure.Timing": "times that were measured",
    "compliant.zeros.zero_map.Row": "a part of a map; what is claimed is the map's verdict",
    "mechanisms.approach.approach_result.SlipPath": "enclosures at some times",
    "mechanisms.spots.g_spot.GSpot": "a place; its proof is that it exists",
    "mechanisms.sweep.sweep_grid.Axis": "a range that was asked for",
    "numbers.written.Written": "what any written class has, not a class of results",
    "expansion.trajectory.Trajectory": "coefficients; what is claimed of them is in .accuracy",
}
NO_TRUTH = r"no truth value|three outcomes"
THREE_VALUED = re.compile(r"\bVerdict\b|\bOutcome\b|\bbool \| None\b|\bOptional\[bool\]")


def classes() -> Iterator[type]:
    """Every class that a module of the package defines."""
    for module in pkgutil.walk_packages(gspot_verified.__path__, "gspot_verified."):
        if module.name.endswith("__main__"):
            continue
        found = importlib.import_module(module.name)
        for value in vars(found).values():
            if inspect.isclass(value) and value.__module__ == found.__name__:
                yield value


def name_of(kind: type) -> str:
    """``cost.theta.CostReport``: without the name of the package."""
    return f"{kind.__module__}.{kind.__name__}".removeprefix("gspot_verified.")


def says_something(kind: type) -> bool:
    """Whether the class is a result: it has ``to_json``, or a field or property that holds one of three outcomes."""
    notes = [str(note) for note in getattr(kind, "__annotations__", {}).values()]
    for value in vars(kind).values():
        if isinstance(value, property) and value.fget is not None:
            notes.append(str(value.fget.__annotations__.get("return", "")))
    return hasattr(kind, "to_json") or any(THREE_VALUED.search(note) for note in notes)


RESULTS = [
    kind
    for kind in classes()
    if says_something(kind) and not issubclass(kind, Enum | BaseException | tuple | dict) and name_of(kind) not in PLAIN
]


def test_the_scan_sees_the_results() -> None:
    names = {kind.__name__ for kind in RESULTS}
    expected = {
        "Verdict",
        "SignResult",
        "ZerosResult",
        "IwcResult",
        "LiftOff",
        "Brackets",
        "IntegerZeros",
        "Evaluation",
    }
    assert expected | {"Entry", "Check", "Classification", "CheckResult", "Refutation", "Accuracy"} <= names
    assert "Row" in names


def test_every_plain_type_exists() -> None:
    assert set(PLAIN) <= {name_of(kind) for kind in classes()}


@pytest.mark.parametrize("kind", RESULTS, ids=lambda kind: kind.__name__)
def test_no_result_is_a_truth_value(kind: type) -> None:
    empty = object.__new__(kind)
    with pytest.raises(TypeError, match=NO_TRUTH) as raised:
        bool(empty)
    # What the message names can be asked.
    named = re.search(r"\.([a-z_0-9]+)", str(raised.value))
    assert named is not None
    assert hasattr(kind, named[1]) or named[1] in typing.get_type_hints(kind)


@pytest.mark.parametrize("kind", [kind for kind in RESULTS if issubclass(kind, NoTruthValue)], ids=lambda k: k.__name__)
def test_the_message_begins_with_the_name(kind: type) -> None:
    with pytest.raises(TypeError, match=rf"^{kind.__name__} has no truth value: \.[a-z]"):
        bool(object.__new__(kind))


REAL_RESULTS: list[Callable[[], object]] = [
    lambda: evaluate(1, "1/2"),
    lambda: evaluate(1, "1/2").sign,
    lambda: iwc("5/2"),
    lambda: iwc("3/2", c1=-1).leading.lift_off,
    lambda: sign_on_ranges("0..1", "1/2"),
    lambda: side("1/2", 2),
    lambda: zeros_at("1/2", 3),
    lambda: zeros_at_integer(1, 3),
    lambda: zeros_on_range("1/2", budget=0),
]


@pytest.mark.parametrize("made", REAL_RESULTS)
def test_real_results(made: Callable[[], object]) -> None:
    """Also where there is nothing in it: no zero, nothing settled."""
    result = made()
    with pytest.raises(TypeError, match=NO_TRUTH):
        assert result
    with pytest.raises(TypeError, match=NO_TRUTH):
        print(not result)
    with pytest.raises(TypeError, match=NO_TRUTH):
        any([result])


def test_a_new_type_cannot_forget_it() -> None:
    class Forgotten:
        def to_json(self) -> None: ...

    class Hidden:
        agrees: bool | None

    class Wrapped:
        @property
        def sign(self) -> Verdict:
            raise NotImplementedError

    class Number:
        size: int

    assert says_something(Forgotten)
    assert says_something(Hidden)
    assert says_something(Wrapped)
    assert not says_something(Number)
