from __future__ import annotations

import json
import shutil
import subprocess
from typing import Any

import pytest
from flint import fmpq

from gspot_verified.cost.peers import external
from gspot_verified.cost.peers.external import NOT_INSTALLED, ORE_ALGEBRA, PARI, PROGRAMS, Program, ask

HALF, POINT = fmpq(1, 2), fmpq(-7, 3)


@pytest.mark.parametrize("program", PROGRAMS, ids=lambda program: program.name)
def test_an_absent_program_is_reported(program: Program, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(external.shutil, "which", lambda _: None)
    answer = ask(program, POINT, HALF, 20)
    assert (answer.first, answer.again, answer.right, answer.note) == (None, None, None, NOT_INSTALLED)
    assert json.loads(json.dumps(answer.to_json()))["note"] == NOT_INSTALLED


def _pretend(monkeypatch: pytest.MonkeyPatch, **outcome: Any) -> None:
    monkeypatch.setattr(external.shutil, "which", lambda name: "/nowhere/" + name)
    done = subprocess.CompletedProcess([], outcome.get("code", 0), outcome.get("out", ""), outcome.get("err", ""))

    def run(*_: Any, **__: Any) -> subprocess.CompletedProcess[str]:
        if "error" in outcome:
            raise outcome["error"]
        return done

    monkeypatch.setattr(external.subprocess, "run", run)


def test_an_answer_is_read_and_its_right_digits_counted(monkeypatch: pytest.MonkeyPatch) -> None:
    # Theta(0, -1) = 3^(-2/3) Gamma(1/3), with a wrong tenth digit.
    _pretend(monkeypatch, out="0.25\n0.125\n1.287899317 E0\n")
    answer = ask(PARI, fmpq(0), fmpq(-1), 20)
    assert (answer.first, answer.again) == (0.25, 0.125)
    assert answer.right is not None
    assert 7 <= answer.right <= 10


def test_what_went_wrong_is_the_note(monkeypatch: pytest.MonkeyPatch) -> None:
    _pretend(
        monkeypatch,
        code=1,
        err="  *** hypergeom: Warning: increasing stack\n  ***   at top-level: x\n"
        "  *** hypergeom: the PARI stack overflows !\n  current stack size: 1\n  [hint] more\n",
    )
    assert ask(PARI, POINT, HALF, 20).note == "failed: hypergeom: the PARI stack overflows !"
    _pretend(monkeypatch, code=1, err="Traceback\nModuleNotFoundError: No module named 'ore_algebra'\n")
    assert ask(ORE_ALGEBRA, POINT, HALF, 20).note == "failed: ModuleNotFoundError: No module named 'ore_algebra'"
    _pretend(monkeypatch, code=3)
    assert ask(PARI, POINT, HALF, 20).note == "failed: exit code 3"
    _pretend(monkeypatch, error=OSError("not for this machine"))
    assert ask(PARI, POINT, HALF, 20).note == "cannot be started: not for this machine"
    _pretend(monkeypatch, error=subprocess.TimeoutExpired("gp", 2.0))
    assert ask(PARI, POINT, HALF, 20, 2.0).note == "no answer within 2 s"


@pytest.mark.parametrize("program", PROGRAMS, ids=lambda program: program.name)
def test_the_scripts_hold_the_question(program: Program) -> None:
    text = program.text(POINT, HALF, 33)
    assert "-7/3" in text
    assert "1/2" in text
    assert str(33 + program.guard_digits) in text


def test_the_script_of_sage_is_python() -> None:
    compile(ORE_ALGEBRA.text(POINT, HALF, 33), "sage", "exec")


@pytest.mark.skipif(shutil.which("gp") is None, reason="PARI/GP is not installed")
@pytest.mark.parametrize("digits", [15, 200])
def test_pari_agrees_with_theta(digits: int) -> None:
    for tau in (POINT, -POINT):
        answer = ask(PARI, tau, HALF, digits, 120.0)
        assert answer.note == ""
        assert answer.right == digits
        assert answer.first is not None
        assert answer.again is not None
        assert answer.first >= answer.again > 0  # its clock shows whole milliseconds
