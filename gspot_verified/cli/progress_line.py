"""The line at a terminal that says how far counted work is; the next thing that is printed takes its place."""

from __future__ import annotations

import shutil
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any, TextIO

_PAUSE = 0.1  # seconds between two changes of the line


class ProgressLine:
    """One line on a stream, written over by each step."""

    def __init__(self, stream: TextIO, clock: Callable[[], float] = time.monotonic) -> None:
        self._stream, self._clock = stream, clock
        self._lock = threading.RLock()
        self._width = 0  # of what is on the screen
        self._shown = clock()
        self._first = self._shown, 0, 0.0  # when, how many pieces, which share
        self._last: tuple[str, int, float] | None = None

    def count(self, step: str, done: int, share: float) -> None:
        """So many pieces are done, this share of the work; where the number does not grow, other work has begun."""
        with self._lock:
            now = self._clock()
            if self._last is None or done <= self._last[1]:
                self._first = now, done, share
            self._last = step, done, share
            if share >= 1 or not self._width or now - self._shown >= _PAUSE:
                self._render()

    def refresh(self) -> bool:
        """The same with the time that has passed; False if nothing is counted, or all of it is done."""
        with self._lock:
            if self._last is None or self._last[2] >= 1:
                return False
            self._render()
            return True

    def end(self) -> None:
        """What was counted is over."""
        with self._lock:
            self._last = None
            self.clear()

    def clear(self) -> None:
        """Take the line away."""
        with self._lock:
            if self._width:
                self._stream.write("\r" + " " * self._width + "\r")
                self._stream.flush()
                self._width = 0

    def _render(self) -> None:
        if self._last is None:
            return
        (step, done, share), (begun, at_first, share_at_first) = self._last, self._first
        now = advance(share, share - share_at_first, done - at_first, self._clock() - begun)
        text = f"... {now}: {step}"[: shutil.get_terminal_size().columns - 1]
        self.clear()
        self._stream.write(text)
        self._stream.flush()
        self._width, self._shown = len(text), self._clock()


def advance(share: float, gained: float, done: int, seconds: float) -> str:
    """Percentage, rate and time left, as if the rest went on like the last ``seconds``, which ``gained`` a share by
    ``done`` pieces.

    >>> advance(0.25, 0.125, 30, 10.0)
    '25%, 3/s, about 1 min 0 s left'
    >>> advance(0.25, 0.0, 0, 10.0)
    '25%'
    """
    said = [f"{int(100 * share)}%"]
    if done > 0 and seconds > 0:
        said.append(f"{done / seconds:.2g}/s" if done >= seconds else f"{seconds / done:.2g} s each")
    if gained > 0 and share < 1:
        said.append(f"about {duration(max(seconds * (1 - share) / gained, 1))} left")
    return ", ".join(said)


def duration(seconds: float) -> str:
    """A time to wait, in its two largest units.

    >>> duration(59.4), duration(61), duration(7260)
    ('59 s', '1 min 1 s', '2 h 1 min')
    """
    whole = round(seconds)
    if whole < 60:
        return f"{whole} s"
    minutes, rest = divmod(whole, 60)
    return f"{minutes} min {rest} s" if minutes < 60 else f"{minutes // 60} h {minutes % 60} min"


class _AfterTheLine:
    """A stream at the same terminal: before anything is written the line is gone."""

    def __init__(self, stream: TextIO, line: ProgressLine) -> None:
        self._stream, self._line = stream, line

    def write(self, text: str) -> int:
        self._line.clear()
        return self._stream.write(text)

    def __getattr__(self, name: str) -> Any:
        return getattr(self._stream, name)


_lines: list[ProgressLine] = []


def at_terminal() -> ProgressLine | None:
    """The line, where stderr is a terminal."""
    return _lines[-1] if _lines else None


@contextmanager
def line_at_terminal() -> Iterator[None]:
    """Around a command: there is a line if stderr is a terminal."""
    out, err = sys.stdout, sys.stderr
    if not err.isatty():
        yield
        return
    line = ProgressLine(err)
    _lines.append(line)
    sys.stderr = _AfterTheLine(err, line)
    if out.isatty():
        sys.stdout = _AfterTheLine(out, line)
    try:
        yield
    finally:
        line.clear()
        _lines.pop()
        sys.stdout, sys.stderr = out, err
