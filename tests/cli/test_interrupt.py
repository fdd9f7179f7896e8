"""Ctrl-C: the exit code is 130 and never 1, which is "refuted"; no process is left; how to go on is said."""

from __future__ import annotations

import os
import select
import signal
import subprocess
import sys
from functools import partial
from pathlib import Path
from typing import Any

import pytest

from gspot_verified.__main__ import run
from gspot_verified.cli import main

ROOT = Path(__file__).resolve().parents[2]
LONG = ("zeros", "--beta", "20..150", "--budget", "1000000")
POINT = ("sign", "--tau", "[0..1]", "--beta", "1/2")


def interrupt(*_: Any, **__: Any) -> None:
    raise KeyboardInterrupt


@pytest.mark.parametrize(
    ("words", "work"),
    [
        (POINT, "signs.cover.sign.sign"),
        (("zeros", "--beta", "1..2"), "signs.zeros.zeros.zeros_on_range"),
        (("zeros", "--beta", "4..5", "--eps", "1/10"), "compliant.zeros.zero_map.zero_map"),
        (("sweep", "oscillator", "--over", "beta=9/4..11/4:4"), "mechanisms.sweep.sweep.sweep"),
        (("simulate", "fig-varsim1"), "scenes.simulate.simulate"),
    ],
)
def test_how_to_go_on_is_said(
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
    tmp_path: Path,
    words: tuple[str, ...],
    work: str,
) -> None:
    monkeypatch.setattr(f"gspot_verified.{work}", interrupt)
    for more, said in (
        ((), "with --journal FILE it would go on where it was interrupted"),
        (("--journal", str(tmp_path / "kept")), "the same command goes on where it was interrupted"),
    ):
        assert main([*words, *more]) == 130
        output, errors = capsys.readouterr()
        assert output == ""
        assert said in errors
        assert errors.splitlines()[-1] == "interrupted"


def test_work_that_keeps_nothing_promises_nothing(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("gspot_verified.signs.gamma.side.side", interrupt)
    assert main(["side", "1/2"]) == 130
    assert capsys.readouterr().err.split() == ["interrupted"]


_DURING_THE_IMPORT = """
import os, signal, sys
from importlib.abc import MetaPathFinder
signal.signal(signal.SIGINT, signal.default_int_handler)

class Interrupt(MetaPathFinder):
    def find_spec(self, name, path=None, target=None):
        if name == MODULE:
            try:
                os.kill(os.getpid(), signal.SIGINT)
            except KeyboardInterrupt:
                raise ERROR

sys.meta_path.insert(0, Interrupt())
from gspot_verified.__main__ import run
run()
"""


@pytest.mark.parametrize(
    ("module", "error"),
    [
        ("gspot_verified.cli", "KeyboardInterrupt"),
        ("typer", "KeyboardInterrupt"),
        ("typer", "ImportError('what a library made of it')"),
        ("gspot_verified.cli.commands.sign_commands", "KeyboardInterrupt"),
        ("flint", "KeyboardInterrupt"),
        ("flint", "ImportError('what a library made of it')"),
        ("gspot_verified.signs.cover.sign", "SyntaxError('without unicodedata')"),
    ],
)
def test_an_interrupt_during_imports_is_no_refutation(module: str, error: str) -> None:
    program = _DURING_THE_IMPORT.replace("MODULE", repr(module)).replace("ERROR", error)
    command = [sys.executable, "-c", program, *POINT]
    done = subprocess.run(command, capture_output=True, text=True, env=environment(), check=False)
    assert done.returncode == 130, done.stderr
    assert done.stdout == ""
    assert done.stderr.split() == ["interrupted"]


def test_an_interrupt_while_the_program_leaves(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """A second one, while the first is being told, or one between the result and the end."""
    monkeypatch.setattr(sys.modules["gspot_verified.cli.main"], "main", interrupt)
    monkeypatch.setattr("gspot_verified.__main__.listen", lambda: None)
    monkeypatch.setattr(sys, "argv", ["gspot-verified", *POINT])
    with pytest.raises(SystemExit) as left:
        run()
    assert left.value.code == 130
    assert capsys.readouterr().err.split() == ["interrupted"]


def test_an_error_that_is_no_interrupt_is_not_called_one(monkeypatch: pytest.MonkeyPatch) -> None:
    def broken() -> int:
        raise ImportError("typer")

    monkeypatch.setattr(sys.modules["gspot_verified.cli.main"], "main", broken)
    monkeypatch.setattr("gspot_verified.__main__.listen", lambda: None)
    monkeypatch.setattr(sys, "argv", ["gspot-verified", *POINT])
    with pytest.raises(ImportError, match="typer"):
        run()


def environment() -> dict[str, str]:
    return {**os.environ, "PYTHONPATH": str(ROOT)}


@pytest.mark.slow
def test_an_interrupt_of_two_workers_leaves_no_process(tmp_path: Path) -> None:
    """As a terminal sends it: to the whole group of the program."""
    command = [sys.executable, "-m", "gspot_verified", *LONG, "--workers", "2", "--journal", str(tmp_path / "kept")]
    with subprocess.Popen(
        command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=environment(), start_new_session=True,
        # A job in the background inherits that SIGINT is ignored.
        preexec_fn=partial(signal.signal, signal.SIGINT, signal.SIG_DFL),
    ) as run:  # fmt: skip
        assert run.stderr is not None
        try:
            while "examined" not in (line := run.stderr.readline()):
                assert line
            os.killpg(run.pid, signal.SIGINT)
            assert run.wait(300) == 130
        finally:
            run.kill()  # where it goes on, the test fails and does not wait for ever
        # The workers hold the pipe as well: it ends when nobody does; the limit is for a failure alone.
        said = ""
        while select.select([run.stderr], [], [], 300)[0] and (text := run.stderr.read()):
            said += text
        assert "the same command goes on where it was interrupted" in said
        assert "Traceback" not in said
