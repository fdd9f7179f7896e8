"""Certificates that ask for much: each ends within a counted budget of work and of memory."""

from __future__ import annotations

import subprocess
import sys
import tracemalloc
from fractions import Fraction
from pathlib import Path

import pytest
from must_reject import hostile, mutate
from must_reject.hostile import DEEP
from must_reject.mutate import GOOD, text_of

check = mutate.checker()
BUDGET = 10**8
SMALL = check.limits.Limits(work=0, memory=8)


def answer(data: bytes, limits: check.limits.Limits) -> str:
    """The statement, or the reason against it."""
    try:
        return str(check.main.check_text(data, limits))
    except check.limits.Rejected as reason:
        return str(reason)


@pytest.fixture
def spent(monkeypatch: pytest.MonkeyPatch) -> list[int]:
    return mutate.work_of(check, monkeypatch)


@pytest.mark.parametrize("name", hostile.SHORT)
def test_work_and_memory_are_bounded(name: str, spent: list[int], monkeypatch: pytest.MonkeyPatch) -> None:
    data = hostile.SHORT[name]
    monkeypatch.setattr(check.limits, "WORK_PER_BYTE", BUDGET // len(data))
    tracemalloc.start()
    try:
        text = answer(data, SMALL)
        _, peak = tracemalloc.get_traced_memory()
    finally:
        tracemalloc.stop()
    assert peak < 3 * SMALL.memory * 10**6 // 2 + 20 * len(data) + 2_000_000
    assert sum(spent[:-1]) <= BUDGET
    if sum(spent) > BUDGET:
        assert "the limit work=0 (raise it on purpose: --limit work=NUMBER)" in text
    # One step is short against the whole.
    assert max(spent, default=0) < BUDGET // 4 or "limit" in text


def test_some_of_them_meet_each_limit(monkeypatch: pytest.MonkeyPatch) -> None:
    found = []
    for data in hostile.SHORT.values():
        monkeypatch.setattr(check.limits, "WORK_PER_BYTE", BUDGET // len(data))
        found.append(answer(data, SMALL))
    assert sum("limit work" in text for text in found) > 3
    assert sum("limit memory" in text for text in found) > 1


def test_a_true_statement_far_out_is_verified() -> None:
    """Pieces of width 2^-60 at τ = -200 in eleven cells: the accuracy that they need is low."""
    assert answer(hostile.far_left_in_each_cell(11, 22), check.limits.Limits()).startswith("dΘ/dτ < 0")


@pytest.mark.parametrize("name", ["deep left", "deep pieces", "deep pieces, deep β"])
def test_long_denominators_cost_no_more_than_short_ones(name: str, spent: list[int]) -> None:
    assert answer(hostile.SHORT[name], check.limits.Limits()).startswith("dΘ/dτ <")
    assert sum(spent) < 10 * BUDGET


def test_a_point_with_a_long_denominator_is_used_as_it_is(spent: list[int]) -> None:
    """Ten orders at one point with 2,000 digits: what its length costs, no more."""
    assert answer(hostile.deep_right(DEEP), check.limits.Limits()).startswith("dΘ/dτ < 0")
    assert sum(spent) < BUDGET


def test_work_grows_with_the_length_of_the_numbers(spent: list[int]) -> None:
    totals = []
    for bits in (60, 600, 6000):
        del spent[:]
        start = [check.theta.Model([value << bits, value], 0) for value in (3, -2, 5)]
        check.theta.moved(start * 3, Fraction(1, 3), bits, check.limits.Meter(SMALL, 10**12))
        totals.append(sum(spent))
    assert totals[2] - totals[1] > 50 * (totals[1] - totals[0])


def test_the_budget_is_one_for_all_columns(spent: list[int]) -> None:
    data = text_of(GOOD["iwc"])
    assert answer(data, check.limits.Limits()).startswith("dΘ/dτ <")
    total = sum(spent)
    _, statement, columns = check.pieces.read_certificate(data, check.limits.Limits())
    for workers in (1, 2):
        check.statements.check_sign(check.statements.Checker(statement, columns, check.limits.Limits(), total, workers))
        with pytest.raises(check.limits.Rejected, match="the limit work"):
            check.statements.check_sign(
                check.statements.Checker(statement, columns, check.limits.Limits(), total - 1, workers)
            )


def test_the_budget_can_be_raised(monkeypatch: pytest.MonkeyPatch) -> None:
    data = text_of(GOOD["brackets"])
    monkeypatch.setattr(check.limits, "WORK_PER_BYTE", 0)
    assert "the limit work=0 (raise it on purpose: --limit work=NUMBER)" in answer(data, check.limits.Limits(work=0))
    assert answer(data, check.limits.Limits(work=1)).startswith("dΘ/dτ at β = 7/3")


WITHIN = """
import resource, runpy, sys
resource.setrlimit(resource.RLIMIT_AS, (int(sys.argv[1]), int(sys.argv[1])))
del sys.argv[:2]
runpy.run_path(sys.argv[0], run_name="__main__")
"""
"""The checker, in a process that gets no more memory than this: with less it would end with status 64."""


def checked_within(memory: int, place: Path) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-I", "-c", WITHIN, str(memory), str(mutate.CHECKER), "--limit", "work=1", str(place)]
    return subprocess.run(command, capture_output=True, text=True, timeout=600, check=False)


@pytest.mark.slow
@pytest.mark.parametrize("name", hostile.LONG)
def test_files_up_to_the_limit_of_the_size(name: str, tmp_path: Path) -> None:
    place = tmp_path / "long.cert"
    place.write_bytes(hostile.LONG[name]())
    assert checked_within(400_000_000, place).returncode in (0, 1)
