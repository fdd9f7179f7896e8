"""proofs/coq/check_in_coq.py on a run (proofs/run_certificate.md): what is read, what is written, what Coq answers."""

from __future__ import annotations

import json
import shutil
import subprocess
from collections.abc import Callable
from pathlib import Path
from types import ModuleType

import pytest
from must_reject import runs
from must_reject.mutate import text_of

COQ = Path(__file__).resolve().parents[2] / "proofs" / "coq"
RUN = COQ.parent / "run_fig_varsim1.cert"
CLASSIC = "Axioms:\nClassical_Prop.classic : forall P : Prop, P \\/ ~ P\n"


def without(change: Callable[[runs.Lines], object]) -> Callable[[], bytes]:
    """Makes a small run with a line changed."""

    def changed() -> bytes:
        lines = runs.flight()
        change(lines)
        return text_of(lines)

    return changed


def with_number(change: str, *path: str | int) -> Callable[[], bytes]:
    """Makes a small run with a number of its first line changed."""

    def put(lines: runs.Lines) -> None:
        at = lines[0]["statement"]
        for key in path[:-1]:
            at = at[key]
        assert at[path[-1]] != change
        at[path[-1]] = change

    return without(put)


def test_a_run_is_read(script: ModuleType) -> None:
    assert script.read(RUN.read_bytes()) == RUN.read_text("utf-8")
    assert script.read(text_of(runs.flight()))


def test_what_coq_gets_has_the_line_of_the_file(script: ModuleType) -> None:
    """Coq proves that it is the text of the scene, of which the theorem speaks."""
    text = script.read(RUN.read_bytes())
    line = text.partition("\n")[0]
    given = script.sources(text)["given.v"]
    doubled = line.replace('"', '""')
    assert f'\nDefinition given_line : string := "{doubled}"%string.\n' in given
    assert '\n  [("touch-down"%string, ((6931197563509536293260148489311669 # ' in given
    assert "]%Q (1 # 1) true.\n" in given
    assert "given_line = header_text given_header /\\ true_run_claim (its_scene given_header)." in given


FORGED = {
    "the bracket moved": with_number("4/5", "events", 0, 1),
    "another event": with_number("touch-down", "events", 0, 0),
    "another parameter": with_number("31/20", "parameters", "beta"),
    "another start": with_number("-1/49", "start", "y"),
    "another end": with_number("time", "end"),
    "a second flight": with_number("lift-off", "events", 1, 0),
    "a command": with_number('1"%string. Axiom cheat : False. (*', "until"),
    "no epsilon": with_number("0", "epsilon"),
    "a step less": without(lambda lines: lines.pop(4)),
    "a later phase that is not there": without(lambda lines: lines.pop()),
    "another hash": lambda: RUN.read_bytes()[:-10] + b"000000000\n",
    "a mechanism": with_number("run of a mechanism", "kind"),
}


@pytest.mark.parametrize("forged", FORGED.values(), ids=list(FORGED))
def test_what_the_checker_refuses_is_refused_before_coq_sees_it(
    script: ModuleType,
    forged: Callable[[], bytes],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    """Also where the fault comes after the first phase, of which the theorem does not speak."""
    monkeypatch.setattr(script, "proved", lambda *_: pytest.fail("Coq was started"))
    (tmp_path / "forged.cert").write_bytes(forged())
    assert script.main([str(tmp_path / "forged.cert")]) == 1
    assert capsys.readouterr().out.startswith("Not a certificate: ")


@pytest.mark.parametrize("make", [runs.stick, runs.rod], ids=["stick", "rod"])
def test_a_run_that_the_checker_in_coq_does_not_know(script: ModuleType, make: Callable[[], runs.Lines]) -> None:
    with pytest.raises(ValueError, match="The checker of runs in Coq knows a first lift-off"):
        script.read(text_of(make()))


def test_the_first_phase_of_a_run_has_limits(script: ModuleType, monkeypatch: pytest.MonkeyPatch) -> None:
    given = text_of(runs.flight())
    for name in script.MOST:
        monkeypatch.setitem(script.MOST, name, 2)
        with pytest.raises(ValueError, match=f"a first phase of up to 2 {name}, not "):
            script.read(given)
        monkeypatch.undo()
    with pytest.raises(ValueError, match="reads files of up to"):
        script.read(given + b" " * script.LONGEST_RUN)


def answer(line: str, claim: str, axioms: str = CLASSIC) -> str:
    """What Coq prints for the second source."""
    strings = "".join('     = "{}"%string\n     : string\n'.format(text.replace('"', '""')) for text in (line, claim))
    return strings + axioms


def coq_answers(script: ModuleType, monkeypatch: pytest.MonkeyPatch, printed: str) -> list[float]:
    """Coq is replaced by an answer; the limits of time with which it is run."""
    limits = []

    def run(command: list[str], _: Path, limit: float) -> subprocess.CompletedProcess[str]:
        limits.append(limit)
        return subprocess.CompletedProcess(command, 0, printed, "")

    monkeypatch.setattr(script, "run", run)
    return limits


def test_the_claim_is_the_scene_up_to_the_first_event(script: ModuleType, monkeypatch: pytest.MonkeyPatch) -> None:
    text = script.read(RUN.read_bytes())
    line = text.partition("\n")[0]
    claim = script.first_phase(json.loads(line)["statement"])
    assert claim.startswith('{"epsilon":"1/1000","first_event":["lift-off","26768541633135015082986594719272279/5')
    assert claim.endswith('"start":{"b":"-2","p":"1/2","v":"0","y":"-1/125000","z":"-1/250000"}}')
    assert "touch-down" not in claim
    limits = coq_answers(script, monkeypatch, answer(line, claim))
    assert script.proved(text, {}) == claim
    assert limits == [script.LIMIT_RUN] * 2
    for wrong in (
        answer(line.replace('"1/1000"', '"1/100"'), claim),
        answer(line, claim.replace('"1/1000"', '"1/100"')),
        answer(text, claim),
        answer(line, claim, ""),
        answer(line, claim, "Axioms:\ncheat : False\n"),
    ):
        coq_answers(script, monkeypatch, wrong)
        with pytest.raises(RuntimeError):
            script.proved(text, {})


def test_the_answer_says_how_much_is_proved(script: ModuleType) -> None:
    assert script.how_far(RUN.read_text("utf-8")) == ", of the first phase alone, contact and then the first lift-off"
    assert script.how_far((COQ.parent / "iwc_0_1.cert").read_text("utf-8")) == ""


def wrong_for_coq() -> dict[str, bytes]:
    """Files that only Coq judges here: proofs/checker is not asked."""
    first = "events", 0
    low, high = runs.flight()[0]["statement"]["events"][0][1:]
    return {
        "a bracket before the lift-off": with_number(low, *first, 2),
        "a bracket after the lift-off": with_number(high, *first, 1),
        "another beta": with_number("151/100", "parameters", "beta"),
        "another start": with_number("-21/10", "start", "b"),
    }


@pytest.mark.slow
@pytest.mark.skipif(shutil.which("coqc") is None, reason="Coq is not installed: the checker in Coq is not run")
def test_coq_accepts_a_run_and_no_wrong_one(
    script: ModuleType, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    prove = script.beside(COQ / "prove.py")
    if "proved by Coq" not in prove.state():
        pytest.skip("the proofs are not compiled here: make prove")
    good = text_of(runs.flight())
    (tmp_path / "good.cert").write_bytes(good)
    assert script.main([str(tmp_path / "good.cert")]) == 0
    said = capsys.readouterr().out
    claim = script.first_phase(runs.flight()[0]["statement"])
    assert said == f"Proved in Coq, of the first phase alone, contact and then the first lift-off: {claim}\n"
    _, library = prove.recorded()
    for name, data in wrong_for_coq().items():
        with pytest.raises((RuntimeError, ValueError)):
            assert not script.proved(data.decode(), library), name
