"""Progress at a terminal: one line with percentage, rate and time left that leaves nothing behind; plain elsewhere."""

from __future__ import annotations

import io
import os
import pty
import subprocess
import sys
import time
from contextlib import redirect_stderr, redirect_stdout
from pathlib import Path

import pytest
from flint import fmpq
from hypothesis import given
from hypothesis import strategies as st

from gspot_verified.cli.app import counted, progress, signs_of_life, warn
from gspot_verified.cli.progress_line import ProgressLine, advance, duration, line_at_terminal
from gspot_verified.cli.ranges_progress import RangesProgress
from gspot_verified.signs.cover.pieces import Column
from gspot_verified.signs.cover.subdivision import Subdivision
from gspot_verified.signs.zeros.zeros import zeros_on_range
from gspot_verified.work.executors import InProcessExecutor

ROOT = Path(__file__).resolve().parents[2]


class Screen(io.StringIO):
    """A terminal of one colour: what stands on it after carriage returns."""

    def isatty(self) -> bool:
        return True

    @property
    def lines(self) -> list[str]:
        """The lines as one sees them, without spaces at their ends."""
        return [self._seen(line).rstrip() for line in self.getvalue().split("\n")]

    @staticmethod
    def _seen(line: str) -> str:
        shown = ""
        for part in line.split("\r"):
            shown = part + shown[len(part) :]
        return shown


class Clock:
    """Time that passes when it is told to."""

    now = 0.0

    def __call__(self) -> float:
        return self.now


@pytest.fixture
def screen(monkeypatch: pytest.MonkeyPatch) -> Screen:
    monkeypatch.setenv("COLUMNS", "80")
    return Screen()


def test_the_line_says_how_far_and_how_long(screen: Screen) -> None:
    clock = Clock()
    line = ProgressLine(screen, clock)
    line.count("0 of 40", 0, 0.0)
    assert screen.lines == ["... 0%: 0 of 40"]
    clock.now = 5.0
    line.count("10 of 40", 10, 0.25)
    assert screen.lines == ["... 25%, 2/s, about 15 s left: 10 of 40"]
    clock.now = 20.0
    assert line.refresh()
    assert screen.lines == ["... 25%, 2 s each, about 1 min 0 s left: 10 of 40"]
    line.clear()
    assert screen.lines == [""]


def test_other_work_begins_to_count_anew(screen: Screen) -> None:
    clock = Clock()
    line = ProgressLine(screen, clock)
    for now, done in ((0.0, 5), (100.0, 9), (200.0, 1), (201.0, 3)):
        clock.now = now
        line.count("s", done, done / 10)
        if now == 200.0:
            assert screen.lines == ["... 10%: s"]
    assert screen.lines == ["... 30%, 2/s, about 4 s left: s"]


def test_steps_that_come_fast_are_shown_now_and_then_and_the_last_always(screen: Screen) -> None:
    clock = Clock()
    line = ProgressLine(screen, clock)
    for done in range(1, 101):
        clock.now += 0.01
        line.count(f"{done} of 100", done, done / 100)
    assert screen.lines == ["... 100%, 1e+02/s: 100 of 100"]
    assert 8 <= screen.getvalue().count("...") <= 14


def test_a_long_step_does_not_wrap(screen: Screen) -> None:
    ProgressLine(screen, Clock()).count("x" * 200, 1, 0.5)
    assert len(screen.lines[0]) == 79


def test_what_is_printed_takes_the_place_of_the_line(screen: Screen) -> None:
    with redirect_stdout(screen), redirect_stderr(screen), line_at_terminal():
        counted("1 of 2", 1, 0.5, said=False)
        assert screen.lines == ["... 50%: 1 of 2"]
        print("the result, or a part")
        counted("2 of 2", 2, 1.0, said=False)
        warn("in doubt")
        counted("3 of 3", 3, 1.0, said=False)
    assert screen.lines == ["the result, or a part", "warning: in doubt", ""]


def test_a_step_that_counts_is_counted_and_another_one_stays(screen: Screen) -> None:
    with redirect_stdout(screen), redirect_stderr(screen), line_at_terminal():
        progress("Section 1: done, 10 of 40 entries")
        assert screen.lines == ["... 25%: Section 1: done, 10 of 40 entries"]
        progress("the page")
        assert screen.lines == ["... the page", ""]
        progress("0 of 0 entries")
    assert screen.lines == ["... the page", "... 0 of 0 entries", ""]


def test_work_that_is_counted_to_its_end_gives_no_sign_of_life(screen: Screen) -> None:
    line = ProgressLine(screen, Clock())
    assert not line.refresh()
    line.count("2 of 3", 2, 2 / 3)
    assert line.refresh()
    line.count("3 of 3", 3, 1.0)
    assert not line.refresh()
    line.count("1 of 3", 1, 1 / 3)
    line.end()
    assert not line.refresh()
    assert screen.lines == [""]


def interrupted_at_terminal() -> None:
    with line_at_terminal():
        counted("1 of 2", 1, 0.5, said=False)
        raise KeyboardInterrupt


def test_a_long_piece_keeps_its_line(screen: Screen) -> None:
    """The sign of life is the line itself, with a new time."""
    with redirect_stdout(screen), redirect_stderr(screen), line_at_terminal(), signs_of_life(0.001):
        counted("1 of 2", 1, 0.5, said=False)
        while screen.getvalue().count("... 50%") < 3:
            time.sleep(0.001)
        assert "at work for" not in screen.getvalue().partition("50%")[2], "before the first line there is only time"


def test_the_streams_are_given_back_after_an_error(screen: Screen) -> None:
    with redirect_stdout(screen), redirect_stderr(screen):
        with pytest.raises(KeyboardInterrupt):
            interrupted_at_terminal()
        assert sys.stdout is sys.stderr is screen
    assert screen.lines == [""]


def test_elsewhere_lines_are_plain_and_only_some_are_said(capsys: pytest.CaptureFixture[str]) -> None:
    with line_at_terminal():
        counted("1 of 3", 1, 1 / 3, said=False)
        counted("2 of 3", 2, 2 / 3, said=True)
    assert capsys.readouterr() == ("", "... 2 of 3\n")


@given(st.integers(0, 10**6), st.floats(0, 1), st.floats(0, 1e6))
def test_no_step_is_too_small_or_too_large(done: int, share: float, seconds: float) -> None:
    text = advance(share, share / 2, done, seconds)
    assert text.startswith(f"{int(100 * share)}%")
    assert (("/s" in text) or ("s each" in text)) is (done > 0 and seconds > 0)
    assert ("left" in text) is (share / 2 > 0 and share < 1)


@pytest.mark.parametrize(
    ("seconds", "text"),
    [(0.2, "0 s"), (59.6, "1 min 0 s"), (3599.4, "59 min 59 s"), (3600, "1 h 0 min"), (90000, "25 h 0 min")],
)
def test_durations(seconds: float, text: str) -> None:
    assert duration(seconds) == text


@pytest.mark.parametrize("deepest", [0, 1, 3])
@pytest.mark.parametrize("cells", [1, 4, 49])
def test_the_settled_share_grows_to_one(monkeypatch: pytest.MonkeyPatch, cells: int, deepest: int) -> None:
    """Each range is settled when it has been cut so often: the shares are the parts of the width."""
    shares: list[float] = []
    monkeypatch.setattr("gspot_verified.cli.ranges_progress.counted", lambda _s, _d, share, _w: shares.append(share))
    tree = Subdivision([(fmpq(k), fmpq(k + 1)) for k in range(cells)], 1000)
    shown = RangesProgress()

    def examine(lower: fmpq | None, upper: fmpq, *_: object) -> Column | None:
        assert lower is not None
        return Column(lower, upper, ()) if upper - lower <= fmpq(1, 2**deepest) else None

    for step in tree.steps(examine, InProcessExecutor()):
        shown(step)
    assert shares == sorted(shares)
    assert shares[-1] == 1
    assert len(shares) == cells * (2 ** (deepest + 1) - 1)


def test_at_a_real_terminal() -> None:
    """The line is seen while the work lasts; what is left on the screen are the words and the result."""
    ours, theirs = pty.openpty()
    command = [sys.executable, "-m", "gspot_verified", "expand", "extended", "--order", "2"]
    process = subprocess.Popen(command, cwd=ROOT, stdin=theirs, stdout=theirs, stderr=theirs)
    os.close(theirs)
    seen = b""
    while True:
        try:
            part = os.read(ours, 4096)
        except OSError:  # how the end is told on Linux
            break
        if not part:
            break
        seen += part
    os.close(ours)
    assert process.wait() == 0
    text = Screen()
    text.write(seen.decode().replace("\r\n", "\n"))
    assert "... 50%: 1 of 2 orders" in text.getvalue()
    assert not any("%" in line for line in text.lines)
    plain = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=True)
    assert [line for line in text.lines if line] == [line.rstrip() for line in plain.stdout.splitlines() if line]
    assert plain.stderr == ""


def test_a_run_is_counted_by_its_time(screen: Screen) -> None:
    with redirect_stdout(screen), redirect_stderr(screen), line_at_terminal():
        progress("192 bits: slip at t = 0.125 of 0.5 after one step")
        assert screen.lines == ["... 25%: 192 bits: slip at t = 0.125 of 0.5 after one step"]


def test_elsewhere_a_run_is_told_in_plain_lines(capsys: pytest.CaptureFixture[str]) -> None:
    progress("192 bits: slip at t = 0.125 of 0.5 after 3 steps")
    assert capsys.readouterr().err == "... 192 bits: slip at t = 0.125 of 0.5 after 3 steps\n"


def test_one_range_and_one_tube_are_no_plural(monkeypatch: pytest.MonkeyPatch) -> None:
    said: list[str] = []
    monkeypatch.setattr("gspot_verified.cli.ranges_progress.counted", lambda text, *_: said.append(text))
    zeros_on_range("3/2..8/5", budget=10, progress=RangesProgress(tubes=True))
    assert said[-1].startswith("one range of β examined, 1 settled, 0 waiting; β in [3/2, 8/5]: one tube")


def test_rows_are_counted_and_share_the_way(monkeypatch: pytest.MonkeyPatch) -> None:
    said: list[tuple[str, float]] = []
    monkeypatch.setattr(
        "gspot_verified.cli.ranges_progress.counted", lambda text, _, share, __: said.append((text, share))
    )
    shown = RangesProgress(rows=3)

    def examine(lower: fmpq | None, upper: fmpq, *_: object) -> Column | None:
        assert lower is not None
        return Column(lower, upper, ()) if upper - lower <= fmpq(1, 2) else None

    for _ in range(3):
        for step in Subdivision([(fmpq(0), fmpq(1))], 10).steps(examine, InProcessExecutor()):
            shown(step)
    assert [text.split(",")[0] for text, _ in said[::3]] == [
        f"one range of β examined in row {row} of 3 of ε" for row in (1, 2, 3)
    ]
    assert [share for _, share in said] == pytest.approx([0, 1 / 6, 1 / 3, 1 / 3, 1 / 2, 2 / 3, 2 / 3, 5 / 6, 1])
