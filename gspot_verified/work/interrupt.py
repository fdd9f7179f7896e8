"""Ctrl-C, as Python hears it, and kept in mind: an import that is interrupted may fail with another error.

Nothing but the standard library is imported here, so that Ctrl-C is heard before the rest is loaded.
"""

from __future__ import annotations

import signal

INTERRUPTED = 130  # 128 + SIGINT, as shells show it

_heard: list[int] = []


def listen() -> None:
    """From now on Ctrl-C is kept in mind; who ignores it, or takes it in another way, goes on doing so."""
    if signal.getsignal(signal.SIGINT) is signal.default_int_handler:
        signal.signal(signal.SIGINT, _interrupt)


def was_interrupted() -> bool:
    """Whether Ctrl-C was heard since :func:`listen`."""
    return bool(_heard)


def _interrupt(number: int, _: object) -> None:
    _heard.append(number)
    raise KeyboardInterrupt
