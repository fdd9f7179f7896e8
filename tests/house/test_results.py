"""Every public result is short at a prompt, has a page for a notebook, and comes back from a pickle as it was."""

from __future__ import annotations

import copy
import pickle
from copyreg import dispatch_table
from dataclasses import replace
from enum import Enum
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from flint import fmpq, fmpz
from house.results import RESULTS, result, result_types
from house.test_truth_values import classes

from gspot_verified import check_report, expand, load
from gspot_verified.functions.expressions import Constant, Variable
from gspot_verified.functions.symbols import Symbols
from gspot_verified.testing import extended_example

LONGEST = 400
_SLOW = {"Picture", "SceneRun", "WrongSides"}
_LEAVES = (type(None), bool, int, float, str, bytes, type, fmpq, fmpz, Fraction, Enum, Path)


def content(value: object, known: dict[int, tuple[object, object]]) -> object:
    """All that a value is made of, balls exactly: what pickle would write of it, without what it shares."""
    if isinstance(value, _LEAVES) or (callable(value) and hasattr(value, "__qualname__")):
        return value
    if id(value) in known:
        return known[id(value)][1]
    found: object
    if isinstance(value, np.ndarray):
        found = ("array", value.dtype.str, value.shape, value.tobytes())
    elif isinstance(value, tuple | list):
        found = (type(value).__name__, [content(each, known) for each in value])
    elif isinstance(value, dict):
        found = {content_key(key, known): content(each, known) for key, each in value.items()}
    else:
        reduce = dispatch_table.get(type(value))
        parts: Any = reduce(value) if reduce else value.__reduce_ex__(4)
        found = (type(value), [content(part, known) for part in parts])
    known[id(value)] = value, found  # the value too: its place in memory stays its own
    return found


def content_key(key: object, known: dict[int, tuple[object, object]]) -> object:
    return key if isinstance(key, _LEAVES) else repr(content(key, known))


def same(first: object, second: object) -> bool:
    return content(first, {}) == content(second, {})


def test_every_public_result_has_an_example() -> None:
    assert {kind.__name__ for kind in result_types()} == set(RESULTS)


SHOWN = [pytest.param(name, marks=pytest.mark.slow if name in _SLOW else ()) for name in RESULTS]


@pytest.mark.parametrize("name", SHOWN)
def test_a_result_is_short_has_a_page_and_comes_back_from_a_pickle(name: str) -> None:
    value: Any = result(name)
    assert type(value).__name__ == name
    assert name in repr(value)
    assert 0 < len(repr(value)) <= LONGEST
    assert "\n" not in repr(value)
    html = value._repr_html_() if hasattr(value, "_repr_html_") else None
    assert html is None or html.startswith(("<pre", "<table>"))
    # In one test: each worker of the suite would make the result once more.
    for found in (pickle.loads(pickle.dumps(value)), copy.deepcopy(value)):
        assert type(found) is type(value)
        assert same(found, value)
        if name != "PreparedTheta":  # it is a function: its name is its place in memory
            assert (str(found), repr(found)) == (str(value), repr(value))
        if hasattr(value, "to_json"):
            assert found.to_json() == value.to_json()


def test_a_long_expansion_is_short_at_a_prompt() -> None:
    trajectory = expand(load("rod"), 12)
    assert len(str(trajectory)) > 5_000
    assert len(repr(trajectory)) <= LONGEST


def test_expansions_over_balls_and_symbols_come_back() -> None:
    ring = Symbols("chi")
    slope = Constant(fmpq(-1)) + Constant(ring.symbol("chi")) * Variable(5)
    rates = (*extended_example(1).F[:4], slope, extended_example(1).F[5])
    over_symbols = replace(extended_example(1), F=rates, alpha_1=slope, point=(ring.number(0),) * 6, ring=ring)
    for trajectory in (expand(load("genot_brogliato_rod", mu="7/5"), 3), expand(over_symbols, 6)):
        assert same(pickle.loads(pickle.dumps(trajectory)), trajectory)


def test_prepared_values_come_back() -> None:
    prepared: Any = result("PreparedTheta")
    found = pickle.loads(pickle.dumps(prepared))
    assert same(found("1/3"), prepared("1/3"))


def test_what_differs_is_not_the_same() -> None:
    """The comparison sees one digit of one ball, which ``==`` of flint does not tell from any other."""
    first, second = result("Evaluation"), result("CompliantForce")
    assert not same(first, second)
    assert not same(expand(load("rod"), 3), expand(load("rod"), 4))
    assert not same([first], [first, first])


@pytest.mark.parametrize(
    "kind", [kind for kind in classes() if issubclass(kind, BaseException)], ids=lambda k: k.__name__
)
def test_an_error_comes_back(kind: type[BaseException]) -> None:
    """Where one did not, ``multiprocessing.Pool`` would wait for ever."""
    error = kind("what was wrong")
    found = pickle.loads(pickle.dumps(error))
    assert (type(found), found.args) == (kind, ("what was wrong",))


def test_errors_that_are_raised_come_back() -> None:
    with pytest.raises(ValueError, match="no file") as raised:
        check_report(Path("nowhere"))
    assert str(pickle.loads(pickle.dumps(raised.value))) == str(raised.value)
