"""How the parts are measured: turns, patience, places, memory. Nothing is asserted about times."""

from __future__ import annotations

import json
import subprocess
import sys
from dataclasses import replace
from functools import partial
from itertools import count

import pytest

from gspot_verified.cost import alone
from gspot_verified.cost.measurement import contest
from gspot_verified.cost.measurement.contest import QUICK, TimedRoute, compete, memory_alone, time_shares
from gspot_verified.cost.measurement.measurement import CERTIFIED, NO_BOUND
from gspot_verified.cost.run import blueprints, contestants_of
from gspot_verified.theta_function import theta as package_theta

EFFORT = replace(QUICK, seconds=0.0)


def double(number: int) -> int:
    return 2 * number


def test_every_route_is_asked_at_every_argument() -> None:
    asked: list[tuple[str, int]] = []

    def call(name: str, argument: int) -> int:
        asked.append((name, argument))
        return argument

    routes = [
        TimedRoute(name, CERTIFIED, (1, 2), lambda x, name=name: partial(call, name, x), more=(3,)) for name in "ab"
    ]
    found = compete("", tuple(routes), EFFORT)
    assert [[point.place for point in route.points] for route in found] == [[1, 2], [1, 2]]
    assert asked[-4:] == [("a", 1), ("a", 2), ("b", 1), ("b", 2)]
    full = compete("", tuple(routes), replace(EFFORT, full=True))
    assert [[point.place for point in route.points] for route in full] == [[1, 2, 3], [1, 2, 3]]


def test_further_calls_are_made_in_turn() -> None:
    asked: list[str] = []
    routes = [TimedRoute(name, CERTIFIED, (1,), lambda _, name=name: lambda: asked.append(name) or 1) for name in "ab"]
    found = compete("", tuple(routes), replace(QUICK, seconds=60.0))
    assert [route.points[0].repeats for route in found] == [15, 15]
    assert asked[4:10] == ["a", "b", "a", "b", "a", "b"]


def test_patience_ends_the_larger_arguments(monkeypatch: pytest.MonkeyPatch) -> None:
    """On a clock that each call moves on by its argument."""
    now = [0.0]
    monkeypatch.setattr(contest, "clock", lambda: now[0])

    def slow(argument: int) -> int:
        now[0] += argument
        return argument

    contestant = TimedRoute("slow", CERTIFIED, (0, 1, 2), lambda x: partial(slow, x))
    [route] = compete("", (contestant,), replace(EFFORT, patience=0.5))
    assert [(point.asked, point.best) for point in route.points] == [("0", 0.0), ("1", 1.0)]


def test_an_answer_that_is_none_is_no_point() -> None:
    def place(argument: int, result: int) -> float | None:
        return None if argument == 2 else float(result)

    routes = (
        TimedRoute("some", NO_BOUND, (1, 2, 3), lambda x: partial(double, x), place=place),
        TimedRoute("none", NO_BOUND, (1,), lambda _: lambda: None),
        TimedRoute("absent", NO_BOUND, (1,), lambda _: pytest.fail("was asked"), missing="not installed"),
    )
    some, none, absent = compete("", routes, EFFORT)
    assert [point.place for point in some.points] == [2, 6]
    assert some.note == "no answer: 2"
    assert (none.points, none.note) == ((), "no answer: 1")
    assert (absent.points, absent.note) == ((), "not installed")


def test_a_program_may_tell_its_own_time() -> None:
    [route] = compete("", (TimedRoute("own", CERTIFIED, (7,), lambda _: lambda: 3.0, seconds=float),), EFFORT)
    assert route.points[0].best == 3.0


def test_the_memory_of_a_program_that_tells_its_own_time_is_not_measured(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(contest, "memory_alone", lambda *_: 1024)
    routes = (
        TimedRoute("ours", CERTIFIED, (7, 8), lambda x: partial(double, x)),
        TimedRoute("other program", CERTIFIED, (7,), lambda _: lambda: 3.0, seconds=float),
        TimedRoute("without", CERTIFIED, (7,), lambda x: partial(double, x), has_memory=False),
    )
    found = compete("part", routes, EFFORT)
    assert [[point.memory for point in route.points] for route in found] == [[None, 1024], [None], [None]]


def test_caches_are_empty_before_each_call(monkeypatch: pytest.MonkeyPatch) -> None:
    emptied: list[str] = []
    monkeypatch.setattr(contest, "forget", lambda: emptied.append("now"))
    compete("", (TimedRoute("one", CERTIFIED, (1, 2), lambda x: partial(double, x)),), EFFORT)
    assert len(emptied) == 2


def test_parts_and_routes_have_different_names() -> None:
    for full in (False, True):
        keys = [blueprint.key for blueprint in blueprints(full)]
        assert len(set(keys)) == len(keys)
    for blueprint in blueprints(True):
        names = [contestant.own_name for contestant in blueprint.contestants()]
        assert len(set(names)) == len(names), blueprint.key
        assert all(contestant.arguments for contestant in blueprint.contestants() if not contestant.missing)
    with pytest.raises(ValueError, match="part: expected one of theta"):
        contestants_of("nothing")


def test_the_small_size_is_a_part_of_the_full_one() -> None:
    for blueprint in blueprints(False):
        known = {contestant.own_name for contestant in contestants_of(blueprint.key)}
        assert {contestant.own_name for contestant in blueprint.contestants()} <= known


@pytest.mark.slow
def test_memory_of_a_call_in_a_process_of_its_own() -> None:
    digits = contestants_of("theta")[0].all_arguments
    grown = memory_alone("theta", ("", "this library"), digits.index(15))
    assert grown is not None
    assert grown >= 0
    assert memory_alone("theta", ("", "no such route"), 0) is None


HOLDING = """
from gspot_verified.cost import alone, run
from gspot_verified.cost.measurement.contest import TimedRoute
route = TimedRoute("one", "certified", (1,), lambda _: lambda: b"x" * (alone.peak_bytes() + 2**26))
run.contestants_of = lambda _: [route]
print(alone.perform({"part": "", "panel": "", "route": "one", "position": 0})["grown"] >= 2**26)
"""


@pytest.mark.slow
def test_memory_that_a_call_holds_is_seen() -> None:
    """64 MB more than the process has ever had."""
    done = subprocess.run([sys.executable, "-c", HOLDING], capture_output=True, text=True, check=True)
    assert done.stdout == "True\n", done.stderr


def test_the_request_names_the_panel() -> None:
    request = {"part": "routes", "panel": "τ > 0", "route": "Taylor series at 0", "position": 0}
    assert json.loads(json.dumps(alone.perform(request)))["grown"] >= 0


def test_shares_of_the_time() -> None:
    """The clock counts how often it was read: so each share is a number of calls, however loaded the machine is."""
    clock = count(0.0).__next__
    shares = time_shares(partial(package_theta.theta, "7/3", "1/2", 0, 2_000), clock)
    assert sum(share.part for share in shares) == pytest.approx(1)
    assert any(share.words.startswith("theta_function.") for share in shares)
    assert shares[-1].words == "all the rest"
    assert [share.part for share in shares[:-1]] == sorted((share.part for share in shares[:-1]), reverse=True)


def test_a_call_that_took_no_time_has_no_shares() -> None:
    assert time_shares(lambda: None, lambda: 0.0) == ()
