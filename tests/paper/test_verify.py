"""The run of the whole ledger: every part in its order, each announced, and the exit code."""

from __future__ import annotations

import pickle
from dataclasses import replace
from functools import partial
from pathlib import Path

import pytest

from gspot_verified.paper import verify
from gspot_verified.paper.cache import Cache
from gspot_verified.paper.checks.entry import Check, Entry, Rung, Section
from gspot_verified.work.executors import executor


def toy(*answers: bool) -> Entry:
    """A proved, refuted or undecided entry."""
    checks = [Check(Rung.EXACT, f"check {n}", agrees) for n, agrees in enumerate(answers)]
    return Section("Section").settled("identifier", "line 1", "x", "statement", *checks)


PROVED, REFUTED, OPEN = toy(True, True), toy(False, False), toy(True)


@pytest.mark.parametrize(
    ("entries", "code"),
    [
        ([], 0),
        ([PROVED], 0),
        ([PROVED, OPEN], 2),
        ([OPEN, PROVED], 2),
        ([PROVED, REFUTED], 1),
        ([OPEN, REFUTED], 1),
    ],
)
def test_exit_code(entries: list[Entry], code: int) -> None:
    assert verify.exit_code(entries) == code


def test_every_part_is_run_in_its_order_and_announced(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(
        verify, "PARTS", {"one": {"a": lambda: PROVED, "b": lambda: OPEN}, "two": {"c": lambda: REFUTED}}
    )
    told: list[str] = []
    found = verify.verify_paper(told.append)
    assert found == verify.verify_paper()
    assert [replace(entry, code="") for entry in found] == [PROVED, OPEN, REFUTED]
    assert told == ["one: done, 2 of 3 entries", "two: done, 3 of 3 entries"]


def made(identifier: str) -> Entry:
    """An entry whose name the table gives it."""
    return replace(PROVED, identifier=identifier)


def test_the_function_that_makes_an_entry_is_named_also_where_the_table_gives_it_a_name() -> None:
    place = f"{__name__.replace('.', '/')}.py:made"
    assert verify.code_of(partial(made, "x")) == place
    assert verify.code_of(partial(partial(made), "x")) == place


def test_two_workers_find_the_same_entries_in_the_same_order(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    few = {name: verify.PARTS[name] for name in ("Section 1, the mass matrix", "Section 2, the surface", "Appendix A")}
    monkeypatch.setattr(verify, "PARTS", few)
    with executor(2) as pool:
        found = verify.verify_paper(cache=Cache(tmp_path, sources=()), pool=pool)
    assert found == verify.verify_paper()
    assert [entry.identifier for entry in found] == [name for part in few.values() for name in part]
    again = verify.verify_paper(cache=Cache(tmp_path, sources=()))
    assert [replace(entry, from_cache=False) for entry in again] == found
    assert all(entry.from_cache for entry in again)


def test_every_entry_can_be_found_by_a_worker(whole_ledger: list[Entry]) -> None:
    """What is sent to it and what comes back are the same after a pickle."""
    for part in verify.PARTS.values():
        for build in part.values():
            assert verify.code_of(pickle.loads(pickle.dumps(build))) == verify.code_of(build)
    assert pickle.loads(pickle.dumps(whole_ledger)) == whole_ledger


def test_the_longest_entries_begin_first(monkeypatch: pytest.MonkeyPatch) -> None:
    begun: list[str] = []

    def builder(name: str) -> Entry:
        begun.append(name)
        return made(name)

    names = ("a", verify.LONGEST[1], "b", verify.LONGEST[0])
    monkeypatch.setattr(verify, "PARTS", {"one": {name: partial(builder, name) for name in names}})
    assert [entry.identifier for entry in verify.verify_paper()] == [*names]
    assert begun == [verify.LONGEST[0], verify.LONGEST[1], "a", "b"]


def test_the_longest_entries_exist() -> None:
    known = [name for part in verify.PARTS.values() for name in part]
    assert set(verify.LONGEST) <= set(known)


def test_an_entry_that_fails_is_named_and_those_before_are_kept(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setattr(verify, "PARTS", {"one": {"a": partial(made, "a"), "b": lambda: 1 // 0, "c": lambda: OPEN}})  # type: ignore[dict-item]
    cache = Cache(tmp_path, sources=())
    with pytest.raises(RuntimeError, match=r"^b: ZeroDivisionError: "):
        verify.verify_paper(cache=cache)
    assert cache.recall("a") is not None
