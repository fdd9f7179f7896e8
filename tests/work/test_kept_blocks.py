"""Blocks of bytes come back as they were, from memory, from a file, and where no file can be written."""

from __future__ import annotations

import os
from typing import Any

import pytest

from gspot_verified.work import kept_blocks
from gspot_verified.work.kept_blocks import KeptBlocks


def blocks(count: int) -> list[bytes]:
    return [bytes([k % 256]) * (7 * k % 11) for k in range(count)]


@pytest.mark.parametrize("in_memory", [1, 8, 10**6])
def test_blocks_come_back(in_memory: int, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(kept_blocks, "_IN_MEMORY", in_memory)
    kept = KeptBlocks()
    for k, data in enumerate(blocks(50)):
        kept.append(data)
        assert len(kept) == k + 1
        assert kept[-1] == data
    assert list(kept) == blocks(50)
    assert kept[3:40:5] == blocks(50)[3:40:5]
    with pytest.raises(IndexError):
        kept[50]


@pytest.mark.parametrize("after", [0, 1, 3])
def test_what_cannot_be_written_stays(after: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """The disk is full after some writes, each of which takes a few bytes only."""
    monkeypatch.setattr(kept_blocks, "_IN_MEMORY", 8)
    true, left = os.pwrite, iter([True] * after)

    def full(descriptor: int, data: bytes, place: int) -> int:
        if not next(left, False):
            raise OSError(28, "No space left on device")
        return true(descriptor, data[:5], place)

    monkeypatch.setattr(kept_blocks.os, "pwrite", full)
    kept = KeptBlocks()
    for data in blocks(50):
        kept.append(data)
    assert list(kept) == blocks(50)


def test_a_file_that_was_cut_is_said(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(kept_blocks, "_IN_MEMORY", 1)
    kept: Any = KeptBlocks()
    kept.append(b"some bytes")
    kept._file.truncate(4)
    with pytest.raises(OSError, match="4 bytes of 10"):
        kept[0]


def test_blocks_are_moved_when_there_are_so_many_bytes(monkeypatch: pytest.MonkeyPatch) -> None:
    """From 8 bytes in memory on, each time; written in pieces of 3 bytes."""
    monkeypatch.setattr(kept_blocks, "_IN_MEMORY", 8)
    true, written = os.pwrite, list[int]()

    def slowly(descriptor: int, data: bytes, place: int) -> int:
        written.append(place)
        return true(descriptor, data[:3], place)

    monkeypatch.setattr(kept_blocks.os, "pwrite", slowly)
    kept = KeptBlocks()
    for data, places in ((b"1234567", []), (b"8", [0, 3, 6]), (b"abcdefg", []), (b"", []), (b"hi", [8, 11, 14])):
        kept.append(data)
        assert written == places
        written.clear()
    assert list(kept) == [b"1234567", b"8", b"abcdefg", b"", b"hi"]


def test_after_a_full_disk_it_is_not_tried_again(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(kept_blocks, "_IN_MEMORY", 1)
    tried: list[int] = []

    def full(_: int, data: bytes, __: int) -> int:
        tried.append(len(data))
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(kept_blocks.os, "pwrite", full)
    kept = KeptBlocks()
    for data in (b"one", b"two", b"three"):
        kept.append(data)
    assert tried == [3]
    assert list(kept) == [b"one", b"two", b"three"]
