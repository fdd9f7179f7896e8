"""proofs/coq/coq_run.py: what a program of Coq sees of the caller, and how long it runs."""

from __future__ import annotations

import contextlib
import os
import sys
from pathlib import Path

import pytest

COQ = Path(__file__).resolve().parents[2] / "proofs" / "coq"


@pytest.fixture(autouse=True)
def on_the_path(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.syspath_prepend(str(COQ))


def test_nothing_of_the_environment_is_passed_on_but_the_path(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from coq_run import run

    for name in ("MAKEFLAGS", "COQPATH", "COQLIB", "OCAMLPATH", "OCAMLRUNPARAM", "CAML_LD_LIBRARY_PATH", "LD_PRELOAD"):
        monkeypatch.setenv(name, "")
    done = run([sys.executable, "-c", "import os; print(*sorted(os.environ))"], tmp_path)
    assert done.stdout.split() == ["HOME", "LC_ALL", "PATH", "XDG_DATA_HOME"]
    done = run([sys.executable, "-c", "import os; print(os.environ['HOME'], os.getcwd())"], tmp_path)
    assert done.stdout.split() == [str(tmp_path)] * 2


def test_the_answer_is_handed_on(tmp_path: Path) -> None:
    from coq_run import run

    done = run([sys.executable, "-c", "import sys; print('out'); sys.exit('error')"], tmp_path)
    assert (done.returncode, done.stdout, done.stderr) == (1, "out\n", "error\n")


def test_a_step_that_does_not_end_is_given_up(tmp_path: Path) -> None:
    from coq_run import TooLong, run

    with pytest.raises(TooLong, match=r"^sleep was given up after 0 s, the limit of a step$"):
        run(["sleep", "1000"], tmp_path, 0.1)


def test_a_long_step_shows_that_it_goes_on_and_keeps_its_output(tmp_path: Path) -> None:
    from coq_run import run

    called: list[int] = []
    program = "print('first', flush=True); open('gate').read(); print('last')"
    os.mkfifo(tmp_path / "gate")

    def alive() -> None:
        called.append(1)
        with contextlib.suppress(OSError):  # the program is not there yet
            os.close(os.open(tmp_path / "gate", os.O_WRONLY | os.O_NONBLOCK))

    done = run([sys.executable, "-c", program], tmp_path, alive=alive, every=0.05)
    assert done.stdout == "first\nlast\n"
    assert called
    with pytest.raises(TimeoutError):
        run(["sleep", "1000"], tmp_path, alive=interrupted, every=0.05)


def interrupted() -> None:
    raise TimeoutError
