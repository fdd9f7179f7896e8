"""Ctrl-C is heard and kept in mind; who ignores it or takes it in another way goes on doing so."""

from __future__ import annotations

import os
import signal
from collections.abc import Iterator
from typing import Any

import pytest

from gspot_verified.work import interrupt


@pytest.fixture(autouse=True)
def as_before(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    monkeypatch.setattr(interrupt, "_heard", [])
    before = signal.getsignal(signal.SIGINT)
    yield
    signal.signal(signal.SIGINT, before)


def test_what_was_heard_is_kept_in_mind() -> None:
    signal.signal(signal.SIGINT, signal.default_int_handler)
    interrupt.listen()
    assert not interrupt.was_interrupted()
    with pytest.raises(KeyboardInterrupt):
        os.kill(os.getpid(), signal.SIGINT)
    assert interrupt.was_interrupted()


@pytest.mark.parametrize("theirs", [signal.SIG_IGN, lambda *_: None])
def test_who_takes_it_in_another_way_goes_on(theirs: Any) -> None:
    signal.signal(signal.SIGINT, theirs)
    interrupt.listen()
    os.kill(os.getpid(), signal.SIGINT)
    assert signal.getsignal(signal.SIGINT) is theirs
    assert not interrupt.was_interrupted()
