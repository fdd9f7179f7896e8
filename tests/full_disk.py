"""A disk that is full: one file takes so many bytes, the last line by half."""

from __future__ import annotations

import errno
import os
from pathlib import Path

import pytest


def full_after(size: int, path: Path, monkeypatch: pytest.MonkeyPatch) -> list[int]:
    """The file takes ``size`` bytes and no more. Returned: how many bytes each write has tried in vain."""
    honest, failed = os.write, list[int]()

    def write(descriptor: int, data: bytes) -> int:
        there = os.fstat(descriptor)
        if not path.exists() or not os.path.samestat(there, path.stat()):
            return honest(descriptor, data)
        if there.st_size >= size:
            failed.append(len(data))
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
        return honest(descriptor, data[: size - there.st_size])

    monkeypatch.setattr(os, "write", write)
    return failed
