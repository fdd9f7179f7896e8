"""Where a row's G-spot is looked for: at the place that the mechanism names, with the row's values, then at its own."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import pytest
from flint import arb, fmpq

from gspot_verified import load
from gspot_verified.mechanisms.input.mechanism import Mechanism
from gspot_verified.mechanisms.spots.parametric_system import parametric_system
from gspot_verified.mechanisms.sweep.sweep_cell import BITS
from gspot_verified.mechanisms.sweep.sweep_first import first_spot, with_place_of
from gspot_verified.mechanisms.sweep.sweep_work import compiled
from gspot_verified.mechanisms.table import row_search as module
from gspot_verified.mechanisms.table.row_search import Start, is_sought, middle_of, searched
from gspot_verified.numbers.balls import ball, working_bits

ROD = load("rod")  # at rest in the angle of its reference, Y = 3 l/5, for mu = 73/36 and l = 1
COLUMNS = ("mu", "l")


@pytest.fixture(autouse=True)
def _bits() -> Iterator[None]:
    with working_bits(BITS):
        yield


def start_of(mechanism: Mechanism) -> Start:
    first = first_spot(mechanism, None)
    return Start(with_place_of(mechanism, first), COLUMNS, first.fixed, middle_of(first))


def tried(start: Start, values: tuple[fmpq, ...], monkeypatch: pytest.MonkeyPatch) -> list[list[arb]]:
    """From where the search goes if it finds nothing."""
    points: list[list[arb]] = []
    monkeypatch.setattr(module, "newton_origin", lambda *given: points.append(given[2]))
    assert searched(compiled(start.mechanism, COLUMNS, start.fixed), start, values) is None
    return points


def test_the_middle_of_a_spot_lies_in_its_box() -> None:
    first = first_spot(load("genot_brogliato_rod"), None)
    middle = middle_of(first)
    assert len(middle) == len(first.system.point)
    assert all(ball(value).contains(number) for value, number in zip(first.system.point, middle, strict=True))
    assert middle_of(first_spot(ROD, None))[1] != 0


def test_it_is_found_where_the_conditions_vanish() -> None:
    start = start_of(ROD)
    for values in ((fmpq(8, 5), fmpq(1)), (fmpq(2), fmpq(7, 3))):
        on = searched(compiled(start.mechanism, COLUMNS, start.fixed), start, values)
        assert on is not None
        point = on.tube.zero_at(values)
        conditions = parametric_system(start.mechanism, COLUMNS, start.fixed).conditions
        program = module.BoxProgram(conditions, len(point) + 2)
        assert all(value.contains(0) for value in program.values([*point, *map(arb, values)]))


def test_first_at_the_place_with_the_rows_values(monkeypatch: pytest.MonkeyPatch) -> None:
    """Y = 3 l/5, Y' = 4 l/5: angles are counted from the reference."""
    named, own = tried(start_of(ROD), (fmpq(2), fmpq(5)), monkeypatch)
    state = dict(zip(ROD.state, named, strict=True))
    for word, value in {"X": 0, "Y": 3, "theta": 0, "X_dot": 2, "Y_dot": 4, "theta_dot": 1}.items():
        assert state[word].is_exact()
        assert abs(state[word] - value) < arb("1e-20")
    middle = middle_of(first_spot(ROD, None))
    assert all(abs(value - number) < arb("1e-20") for value, number in zip(own, middle, strict=True))
    assert all(value.is_exact() for value in own)


def test_a_tube_of_another_spot_is_not_what_is_sought() -> None:
    """The rod has a G-spot with theta_dot and Y_dot of the other sign."""
    here, values = start_of(ROD), (fmpq(2), fmpq(1))
    there = {word: -value if word in ("Y_dot", "theta_dot") else value for word, value in ROD.place.values}
    mirrored = start_of(replace(ROD, place=replace(ROD.place, values=tuple(there.items()))))
    equations = compiled(here.mechanism, COLUMNS, here.fixed)
    own, other = (searched(equations, start, values) for start in (here, mirrored))
    assert own is not None
    assert other is not None
    assert is_sought(here, values, own)
    assert not is_sought(here, values, other)
    assert is_sought(mirrored, values, other)
    nowhere = replace(here, mechanism=load("rod", g=0), own=(fmpq(0),) * len(here.own))
    assert not is_sought(nowhere, values, own)


def test_a_place_that_is_no_number_is_left_out(monkeypatch: pytest.MonkeyPatch) -> None:
    """Y = 2/(3 l/5) is not finite for l = 0."""
    start = start_of(ROD)
    values = dict(start.mechanism.place.values)
    values["Y"] = values["X_dot"] / values["Y"]
    infinite, partial = (
        replace(start, mechanism=replace(start.mechanism, place=replace(start.mechanism.place, values=tuple(given))))
        for given in (values.items(), ((word, values[word]) for word in start.fixed))
    )
    assert len(tried(infinite, (fmpq(2), fmpq(0)), monkeypatch)) == 1
    assert len(tried(infinite, (fmpq(2), fmpq(1)), monkeypatch)) == 2
    assert len(tried(partial, (fmpq(2), fmpq(1)), monkeypatch)) == 1
