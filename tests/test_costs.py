"""The fast set keeps a case of everything that is quick enough, and leaves out what the recorded costs say."""

from __future__ import annotations

import json
from pathlib import Path

import costs
import pytest

CHEAPEST = "tests/test_a.py::test_cases[two[x]]"
COSTS = {
    "tests/test_a.py::test_quick": costs.LIMIT,
    "tests/test_a.py::test_cases[one]": 3.0,
    CHEAPEST: costs.KEPT,
    "tests/test_a.py::test_cases[three]": costs.KEPT + 0.1,
    "tests/test_a.py::test_cases[four]": costs.LIMIT,
    "tests/test_a.py::test_heavy": 30.0,
    "tests/test_a.py::test_other_cases[one]": costs.LIMIT + 0.1,
    "tests/test_a.py::test_other_cases[two]": costs.LIMIT + 0.2,
}


def test_the_cheapest_case_of_a_test_stays() -> None:
    kept = {name.split("::")[1] for name in COSTS.keys() - costs.costly(COSTS)}
    assert kept == {"test_quick", "test_cases[four]", "test_other_cases[one]"}
    assert CHEAPEST not in costs.costly({name: cost for name, cost in COSTS.items() if "four" not in name})


def test_what_is_not_recorded_runs() -> None:
    assert "tests/test_a.py::test_new" not in costs.costly(COSTS)


def test_a_test_without_cases_stays_where_one_case_would() -> None:
    assert costs.costly({"a.py::test": costs.KEPT}) == frozenset()
    assert costs.costly({"a.py::test": costs.KEPT + 0.1}) == {"a.py::test"}


def test_the_record_names_tests_that_exist() -> None:
    """A file that was moved or removed has no row left behind."""
    root = Path(__file__).resolve().parents[1]
    files = {name.split("::")[0] for name in costs.recorded()}
    assert [name for name in files if not (root / name).is_file()] == []
    assert len(costs.recorded()) > 100


def test_the_record_is_canonical(tmp_path: Path) -> None:
    place = tmp_path / "costs.json"
    costs.record({"b": 1.234, "a": 0.5, "c": costs.LEAST / 2, f"d[{costs.ROOT}]": 1.0}, place)
    assert json.loads(place.read_text(encoding="utf-8")) == {"a": 0.5, "b": 1.23}
    assert costs.recorded(place) == {"a": 0.5, "b": 1.23}


@pytest.mark.parametrize(
    ("changed", "first"),
    [
        (["gspot_verified/numbers/dyadic.py"], ["gspot_verified/numbers/dyadic.py", "tests/numbers/test_dyadic.py"]),
        (["tests/numbers/test_dyadic.py"], ["tests/numbers/test_dyadic.py"]),
        (["proofs/taylor.md"], ["tests/proofs/test_proofs.py"]),
        (["README.md"], ["README.md", "tests/docs/test_readme.py"]),
        (["ARCHITECTURE.md"], ["tests/house/test_architecture.py"]),
    ],
)
def test_what_can_notice_a_change_comes_first(changed: list[str], first: list[str]) -> None:
    chosen = costs.noticing(changed)
    assert set(first) <= {*chosen}
    assert len({*chosen}) == len(chosen)


def test_a_budget_ends_the_list_of_files() -> None:
    every = costs.noticing(["gspot_verified/numbers/balls.py"])
    some = costs.within(every, costs.recorded(), 5.0)
    assert 0 < len(some) < len(every)
    assert some == every[: len(some)]


def test_a_command_is_noticed_by_the_tests_of_the_command_line() -> None:
    found = costs.noticing(["gspot_verified/cli/commands/sign_commands.py"])
    assert {"tests/cli/test_main.py", "tests/cli/test_signs.py", "tests/cli/test_schemas.py"} <= set(found)
