"""The run of the whole ledger: every part in its order, each announced, and the exit code."""

from __future__ import annotations

from dataclasses import replace
from functools import partial

import pytest

from gspot_verified.ledger import verify
from gspot_verified.ledger.entry import Check, Entry, Rung, settled


def toy(*answers: bool) -> Entry:
    """A proved, refuted or undecided entry."""
    checks = [Check(Rung.EXACT, f"check {n}", agrees) for n, agrees in enumerate(answers)]
    return settled("Section", "identifier", "line 1", "x", "statement", *checks)


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
    assert told == ["one", "two"]


def made(identifier: str) -> Entry:
    """An entry whose name the table gives it."""
    return replace(PROVED, identifier=identifier)


def test_the_function_that_makes_an_entry_is_named_also_where_the_table_gives_it_a_name() -> None:
    place = f"{__name__.replace('.', '/')}.py:made"
    assert verify.code_of(partial(made, "x")) == place
    assert verify.code_of(partial(partial(made), "x")) == place
