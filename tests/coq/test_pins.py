"""proofs/coq/pins.py: which changes of a file of statements are seen, and which are none."""

from __future__ import annotations

from pathlib import Path
from types import ModuleType

import pytest

COQ = Path(__file__).resolve().parents[2] / "proofs" / "coq"

TEXT = """(** A file of statements. *)
From Coq Require Import Reals String.
Open Scope R_scope.

(** The greater half. *)
Definition half (x : R) : Prop := 1 / 2 <= x.
Definition says : string := "a" ++ "b".
Definition claim : Prop := forall x, 1 <= x -> half x.
"""


@pytest.fixture
def pins(monkeypatch: pytest.MonkeyPatch) -> ModuleType:
    """The module, which the scripts import from their own folder."""
    monkeypatch.syspath_prepend(str(COQ))
    import pins

    return pins


def changed(pins: ModuleType, old: str, new: str) -> list[str]:
    """What is said when a part of the text is replaced."""
    assert old in TEXT
    written, now = (pins.pinned({"File.v": text.encode()}, ["File"]) for text in (TEXT, TEXT.replace(old, new)))
    said: list[str] = pins.changes(written, now)
    return said


@pytest.mark.parametrize(
    ("old", "new"),
    [("greater half", "other half"), (" 1 / 2 <= x", "\n  1 / 2\n  <= x"), (" -> half", " -> (* so *) half")],
)
def test_comments_and_blanks_are_not_pinned(pins: ModuleType, old: str, new: str) -> None:
    assert changed(pins, old, new) == []


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("1 <= x ->", "1 < x ->", ["claim has another text"]),
        ("1 / 2", "1 / 3", ["half has another text"]),
        ("half (x", "halves (x", ["half is gone", "halves is new"]),
        ("Definition claim", "Definition more := 1.\nDefinition claim", ["more is new"]),
        ('"a" ++ "b"', '"b" ++ "a"', ["what is neither definition nor comment has another text"]),
        ("Reals", "ZArith", ["what is neither definition nor comment has another text"]),
        ("R_scope", "Z_scope", ["what is neither definition nor comment has another text"]),
    ],
)
def test_what_can_change_a_meaning_is_seen_and_said(pins: ModuleType, old: str, new: str, said: list[str]) -> None:
    assert sorted(changed(pins, old, new)) == sorted(f"File.v: {what}" for what in said)


def test_a_definition_that_moves_into_a_section_is_seen(pins: ModuleType) -> None:
    before, after = TEXT.split("Definition says")
    moved = f"Section S.\nVariable y : R.\n{before}End S.\nDefinition says{after}"
    outside = f"Section S.\nVariable y : R.\nEnd S.\n{TEXT}"
    one, two = (pins.pinned({"File.v": text.encode()}, ["File"]) for text in (outside, moved))
    assert pins.changes(one, two)


def test_another_order_and_a_second_line_are_seen(pins: ModuleType) -> None:
    written = pins.pinned({"File.v": TEXT.encode()}, ["File"])
    *first, one, two = written.splitlines(keepends=True)
    assert pins.changes(written, written) == []
    for other in ("".join([*first, two, one]), written + two):
        assert pins.changes(other, written) == ["their order is another, or one is listed twice"]


def test_a_list_that_is_none_is_refused(pins: ModuleType) -> None:
    now = pins.pinned({"File.v": TEXT.encode()}, ["File"])
    assert "File.v: claim is new" in pins.changes("", now)
    for written in ("nothing\n", "File.v claim\n"):
        with pytest.raises(ValueError, match="unpack"):
            pins.changes(written, now)
