from __future__ import annotations

import json

import pytest

from gspot_verified.cost.times import child, measure
from gspot_verified.cost.times.measure import Contestant, Timing, clear_caches, run_child, timing
from gspot_verified.theta_function.gamma import initial_values
from gspot_verified.theta_function.sums import taylor
from gspot_verified.theta_function.theta import theta
from gspot_verified.theta_function.value import choice


def test_clear_caches_finds_every_cache_of_theta() -> None:
    for tau in ("7/3", "5/3", "4/3", "2/3"):  # the polynomial is made when a beta comes again
        theta(tau, "1/2")
    theta(-50, "1/2")
    theta(50, "1/2")
    theta(1, 3)
    caches = [initial_values.rational_initial_values, taylor._cached_polynomial, choice.saddle_plan]
    assert all(cache.cache_info().currsize > 0 for cache in caches)
    assert clear_caches() >= 6
    assert all(cache.cache_info().currsize == 0 for cache in caches)


def test_the_caches_of_the_series_are_members_of_the_module() -> None:
    """clear_caches looks at the members of the modules: that is where the caches of the Taylor series are."""
    found = {name for name in vars(taylor) if hasattr(getattr(taylor, name), "cache_clear")}
    assert found == {"_triples", "_cached_polynomial"}


def test_the_value_is_the_same_after_clearing() -> None:
    first = theta("7/3", "1/2", digits=40)
    clear_caches()
    again = theta("7/3", "1/2", digits=40)
    assert first.is_finite()
    assert str(first) == str(again)


def test_contestants_take_turns_and_are_prepared(monkeypatch: pytest.MonkeyPatch) -> None:
    log: list[str] = []
    ticks = iter(range(1000))
    monkeypatch.setattr(measure.time, "perf_counter", lambda: float(next(ticks)))
    times = measure.measure(
        {
            "a": Contestant(lambda: log.append("a"), lambda: log.append("prepare a"), 3),
            "b": Contestant(lambda: log.append("b"), None, 2),
        },
        seconds=100.0,
    )
    assert log == ["prepare a", "a", "b", "prepare a", "a", "b", "prepare a", "a"]
    assert times == {"a": Timing(1.0, 1.0, 3), "b": Timing(1.0, 1.0, 2)}


def test_a_slow_contestant_is_called_once(monkeypatch: pytest.MonkeyPatch) -> None:
    ticks = iter(range(0, 10_000, 10))
    monkeypatch.setattr(measure.time, "perf_counter", lambda: float(next(ticks)))
    assert measure.measure({"slow": Contestant(lambda: None, None, 9)}, seconds=5.0)["slow"].repeats == 1


def test_timing_is_the_median_and_the_best() -> None:
    assert timing([5.0, 1.0, 2.0, 3.0]) == Timing(2.5, 1.0, 4)
    assert json.loads(json.dumps(timing([1.0]).to_json())) == {"median": 1.0, "best": 1.0, "repeats": 1}


@pytest.mark.parametrize("who", ["ours", "baseline", "mpmath"])
def test_a_child_answers(who: str) -> None:
    run = run_child({"who": who, "tau": "7/3", "beta": "1/2", "digits": 30}, 120.0)
    assert run.note == ""
    assert run.seconds is not None
    assert run.peak_bytes is not None
    assert run.peak_bytes > 1_000_000
    assert (run.first_attempt is not None) == (who == "baseline")


def test_a_child_that_cannot_answer_says_so() -> None:
    run = run_child({"who": "baseline", "tau": "1", "beta": "2", "digits": 20}, 120.0)
    assert run.seconds is None
    assert run.note.startswith("no answer")


def test_a_child_that_fails_or_is_too_slow_is_a_note() -> None:
    wrong = run_child({"who": "ours", "tau": "x", "beta": "1/2", "digits": 30}, 120.0)
    assert wrong.seconds is None
    assert wrong.note.startswith("failed: ValueError")
    slow = run_child({"who": "ours", "tau": "7/3", "beta": "1/2", "digits": 30}, 0.001)
    assert slow.seconds is None
    assert slow.note == "no answer within 0.001 s"


def test_the_request_of_a_child_is_checked() -> None:
    with pytest.raises(KeyError):
        child.perform({"who": "nobody", "tau": "1", "beta": "1/2", "digits": 10})


def test_import_is_timed_in_fresh_processes() -> None:
    assert measure.import_seconds(repeats=1).repeats == 1


def test_machine_load_is_words() -> None:
    assert "core(s)" in measure.machine_load()
