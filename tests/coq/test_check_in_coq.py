"""proofs/coq/check_in_coq.py (proofs/check.md, sections 7, 8): the data it writes; in the long run Coq's answer."""

from __future__ import annotations

import json
import re
import shutil
import subprocess
import sys
import threading
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from fractions import Fraction
from hashlib import sha256
from pathlib import Path
from types import ModuleType

import pytest
from must_reject import mutate

COQ = Path(__file__).resolve().parents[2] / "proofs" / "coq"
IWC, ZEROS = COQ.parent / "iwc_0_1.cert", COQ / "zeros_1_2.cert"
FOLDS = COQ.parent / "zeros_1_13.cert"
FORCE, LIFT_OFF, DIPS = (COQ.parent / f"{name}.cert" for name in ("force_5_2", "lift_off_5_2", "zeros_4_5"))
RUN = COQ.parent / "run_fig_varsim1.cert"
DATA = {
    IWC: "CertificateIWC.v",
    ZEROS: "CertificateZeros.v",
    FORCE: "DataForce.v",
    LIFT_OFF: "DataLiftOff.v",
    DIPS: "DataSlowZeros.v",
}


@pytest.mark.parametrize(("file", "data"), [*DATA.items(), (RUN, "DataRun.v")], ids=[*DATA.values(), "DataRun.v"])
def test_the_data_of_the_development_are_those_of_the_files(script: ModuleType, file: Path, data: str) -> None:
    written = script.source(file.stem, file.read_text(encoding="utf-8"))
    assert (COQ / data).read_text(encoding="utf-8") == written


def test_both_checkers_know_the_certificate_of_zeros() -> None:
    assert "N = 1 on (1, 2)" in mutate.checker().main.check_text(ZEROS.read_bytes())


def test_a_script_that_is_loaded_is_not_loaded_twice(script: ModuleType) -> None:
    """A second module of that name took the place of the first: what the first one had made could not be pickled."""
    pieces = mutate.checker().pieces
    assert script.read_certificate is pieces.read_certificate
    prove = script.beside(COQ / "prove.py")
    assert script.beside(COQ / "prove.py") is prove is sys.modules["prove"]


def test_numbers_and_pieces_as_terms(script: ModuleType) -> None:
    script = script.beside(COQ / "certificate_source.py")
    assert [script.number(text) for text in ("0", "-81/64", "3")] == ["(0 # 1)", "((-81) # 64)", "(3 # 1)"]
    assert script.entry(["sign", "-1", "1/2", -1]) == "Sign ((-1) # 1) (1 # 2) false"
    assert script.entry(["right", "3/2", 1]) == "Right (3 # 2) 1"
    assert script.entry(["taylor"]) == "Taylor"
    assert script.interval("[1/2, inf)") == "(Interval (At (1 # 2)) PlusInfinity true false)"
    assert script.claim({"beta": "(1, 2)", "counts": [[1, 1]], "kind": "zeros"}).endswith("[(1, 1)%nat]")


def test_pieces_and_powers_of_the_force_as_terms(script: ModuleType) -> None:
    script = script.beside(COQ / "certificate_source.py")
    assert script.part(["level", "-1/8", "1/8"]) == "Level ((-1) # 8) (1 # 8)"
    assert script.part(["left", "-1"]) == "Known (Left ((-1) # 1))"
    dip = {"beta": ["4", "129/32"], "pieces": [["dip", "147/64", "189/64"]]}
    numbers = [Fraction(*map(int, pair)) for pair in re.findall(r"\((\d+) # (\d+)\)", script.powers(dip))]
    below, longest, above, shortest = numbers
    assert shortest <= 2 <= Fraction(65, 32) <= longest
    assert below**8 < Fraction(7, 9) ** int(longest * 8) < Fraction(7, 9) ** int(shortest * 8) < above**8
    assert above - below < Fraction(1, 10)
    no_dip = {"beta": ["1", "2"], "pieces": [["dip", "-1", "0"]]}
    assert [script.powers(no_dip), script.powers(no_dip | {"pieces": []})] == ["0 0 0 0", "0 0 0 0"]


@pytest.mark.parametrize("file", DATA, ids=DATA.values())
def test_a_certificate_is_read(script: ModuleType, file: Path) -> None:
    assert script.read(file.read_bytes()) == file.read_text("utf-8")


@pytest.mark.parametrize("arguments", [[], ["one", "two"], ["/no/such/file"], [str(COQ)]])
def test_without_one_file_nothing_is_run(
    script: ModuleType, arguments: list[str], capsys: pytest.CaptureFixture[str]
) -> None:
    assert script.main(arguments) == 2
    assert capsys.readouterr().out.startswith("Not run: ")


def test_without_the_compiled_proofs_nothing_is_said_to_be_proved(
    script: ModuleType, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    script.BUILD = tmp_path
    assert script.main([str(IWC)]) == 2
    assert capsys.readouterr().out.startswith("Not run")


def test_a_fold_is_known_for_a_number_of_zeros_only(script: ModuleType) -> None:
    """The count law answers; a sign needs the piece."""
    folds = FOLDS.read_bytes()
    assert script.has_fold(script.read(folds))
    assert not script.has_fold(script.read(ZEROS.read_bytes()))
    with pytest.raises(ValueError, match="does not know"):
        script.read(changed(FOLDS, '"kind":"zeros"', '"kind":"sign"'))


def changed(file: Path, before: str, after: str) -> bytes:
    """A certificate with another text and the right hash."""
    body = file.read_bytes()[:-72].replace(before.encode(), after.encode())
    assert body != file.read_bytes()[:-72]
    return body + b"sha256 " + sha256(body).hexdigest().encode() + b"\n"


NOT_KNOWN = {
    "brackets": changed(ZEROS, '"kind":"zeros"', '"kind":"brackets"'),
    "a kind that is a list": changed(IWC, '"kind":"sign"', '"kind":["sign"]'),
    "a level for a sign": changed(IWC, '["taylor"]', '["level","0","1"]'),
    "a force of the zeros": changed(DIPS, '"kind":"slow_zeros"', '"kind":"force"'),
    "monotone for the force": changed(FORCE, '["level","1/8","3/8"]', '["monotone","1/8","3/8",1]'),
    "a dip for the force": changed(FORCE, '["level","1/8","3/8"]', '["dip","1/8","3/8"]'),
    "a sign for the lift-off": changed(LIFT_OFF, '"level","5537/1000","6537/1000"', '"sign","5537/1000","6537/1000",1'),
    "a level for the zeros": changed(DIPS, '["dip","35/16","45/16"]', '["level","35/16","45/16"]'),
}


@pytest.mark.parametrize("data", NOT_KNOWN.values(), ids=list(NOT_KNOWN))
def test_other_kinds_and_pieces_are_not_known(script: ModuleType, data: bytes) -> None:
    with pytest.raises(ValueError, match="does not know"):
        script.read(data)


COMMAND = '1, 1)%nat]) []. Axiom cheat : forall A : Prop, A. Tactic Notation "reflexivity" := apply cheat. (*'
NOT_OF_THE_FORMAT = {
    "a command in place of a number": changed(ZEROS, "[[1,1]]", f"[[{json.dumps(COMMAND)},1]]"),
    "a command in a piece": changed(IWC, '["taylor"]', '["taylor. Abort. Goal True"]'),
    "a command after the hash": IWC.read_bytes()[:-1] + b'"%string. Abort. Goal True. exists "\n',
    "no hash": IWC.read_bytes()[:-72] + b"\nsha256 0\n",
    "another hash": IWC.read_bytes().replace(b"sha256 4e", b"sha256 4f"),
    "a cell twice": changed(ZEROS, "[[1,1]]", "[[1,1],[1,5]]"),
    "no cell": changed(ZEROS, "[[1,1]]", "[]"),
    "an empty range": changed(IWC, '"tau":"(-inf, inf)"', '"tau":"(3, 1)"'),
    "a sign that is no sign": changed(IWC, '"sign":-1', '"sign":"-1"'),
    "one key more": changed(IWC, '"sign":-1', '"note":"","sign":-1'),
    "other line ends": IWC.read_bytes().replace(b"\n", b"\r\n"),
    "nothing": b"",
    "two numbers of the system": changed(FORCE, '["-1","-1","-5/2"]', '["-1","-5/2"]'),
    "a command in a level": changed(FORCE, '"5892556509887/10000000000000"', '"1. Abort. Goal True"'),
    "a command in the system": changed(LIFT_OFF, '"c1":"1"', '"c1":"1) 1 1). Abort. Goal True"'),
    "a range in place of a point": changed(LIFT_OFF, '"tau":"5537/1000"', '"tau":"(-inf, inf)"'),
    "a point in place of a range": changed(FORCE, '"tau":"(-inf, inf)"', '"tau":"1"'),
    "no epsilon": changed(DIPS, '"epsilon":"10",', ""),
    "an eta that is no number": changed(DIPS, '"eta":"3672145385/2147483648"', '"eta":"2/4"'),
}


@pytest.mark.parametrize("data", NOT_OF_THE_FORMAT.values(), ids=list(NOT_OF_THE_FORMAT))
def test_what_has_not_the_format_is_refused_before_coq_sees_it(script: ModuleType, data: bytes) -> None:
    with pytest.raises(ValueError, match="Not a certificate"):
        script.read(data)


OUT_OF_RANGE = {
    "a range of beta": changed(ZEROS, '"beta":"(1, 2)"', '"beta":"(1, 300000000)"'),
    "a number of zeros": changed(ZEROS, "[[1,1]]", "[[1,10000000000]]"),
    "a column": changed(IWC, '"beta":["3/4","1"]', '"beta":["300000000","300000001"]'),
    "a point": changed(IWC, '["left","-81/64"]', '["left","-300000000"]'),
    "a long file": b"x" * 600_000,
    "a time of a lift-off": changed(LIFT_OFF, '"tau":"5537/1000"', '"tau":"5537"'),
    "a range of the zeros": changed(DIPS, '"beta":"(4, 5)"', '"beta":"(4, 500)"'),
    "an unbounded range of the zeros": changed(DIPS, '"beta":"(4, 5)"', '"beta":"(4, inf)"'),
    "a level of many digits": changed(FORCE, '"5892556509887/10000000000000"', f'"{"1" * 61}"'),
    "a denominator of the force": changed(FORCE, '["5/2","5/2"]', '["163/65","163/65"]'),
    "a denominator of the zeros": changed(DIPS, '["4","129/32"]', '["4","2068/513"]'),
}


@pytest.mark.parametrize("given", OUT_OF_RANGE.values(), ids=list(OUT_OF_RANGE))
def test_large_numbers_are_refused_before_any_work(
    script: ModuleType,
    given: bytes,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.setattr(script, "proved", lambda *_: pytest.fail("Coq was started"))
    few = lambda *ends: range(*ends) if max(ends) < 300 else pytest.fail("the cells were counted")  # noqa: E731
    monkeypatch.setattr(script, "range", few, raising=False)
    (tmp_path / "large.cert").write_bytes(given)
    assert script.main([str(tmp_path / "large.cert")]) == 1
    assert capsys.readouterr().out.startswith("Out of range: the checker in Coq reads ")


@pytest.mark.parametrize("beta", ["(1, inf)", "(-inf, 2)", "(1/2, 10000000000000000000000000000)"])
def test_an_infinite_range_has_no_cells(script: ModuleType, beta: str) -> None:
    with pytest.raises(ValueError, match=r"not bounded|Out of range"):
        script.read(changed(ZEROS, '"beta":"(1, 2)"', f'"beta":"{beta}"'))


CLAIM = '{""beta"":""(0, 1)"",""kind"":""sign"",""sign"":-1,""tau"":""(-inf, inf)""}'
CLASSIC = "Axioms:\nClassical_Prop.classic : forall P : Prop, P \\/ ~ P\n"


def answer(text: str, claim: str = CLAIM, axioms: str = CLASSIC) -> str:
    """What Coq prints for the second source."""
    doubled = text.replace('"', '""')
    return f'     = "{doubled}"%string\n     : string\n     = "{claim}"%string\n     : string\n{axioms}'


def run_by(
    printed: Callable[[list[str], Path], str], script: ModuleType, monkeypatch: pytest.MonkeyPatch
) -> list[Path]:
    """Coq is replaced by a function; the folders in which it is run."""
    folders = []

    def run(command: list[str], folder: Path, _: float) -> subprocess.CompletedProcess[str]:
        folders.append(folder)
        return subprocess.CompletedProcess(command, 0, printed(command, folder), "")

    monkeypatch.setattr(script, "run", run)
    return folders


def test_the_claim_is_the_one_that_coq_printed(script: ModuleType, monkeypatch: pytest.MonkeyPatch) -> None:
    text = script.read(IWC.read_bytes())
    folders = run_by(lambda *_: answer(text), script, monkeypatch)
    assert script.proved(text, {}) == CLAIM.replace('""', '"')
    assert script.proved(text, {}) == CLAIM.replace('""', '"')
    assert folders[0] == folders[1] != folders[2]
    assert not any(folder.exists() for folder in folders)


def test_coq_sees_the_compiled_proofs_of_the_record_and_no_other_file(
    script: ModuleType, monkeypatch: pytest.MonkeyPatch
) -> None:
    """An orphan, a file of another kind or a folder beside them in build/coq would be found by Coq too."""
    text, seen = script.read(IWC.read_bytes()), []

    def printed(_: list[str], folder: Path) -> str:
        seen.append({path.name: path.read_bytes() for path in (folder.parent / "proofs").iterdir()})
        return answer(text)

    run_by(printed, script, monkeypatch)
    script.proved(text, {"Checker.vo": b"one", "Statement.vo": b"two"})
    assert seen == [{"Checker.vo": b"one", "Statement.vo": b"two"}] * 2


OTHER_ANSWERS = {
    "another claim": lambda text: answer(text, CLAIM.replace("-1", "1")),
    "another text": lambda text: answer(text.replace('"sign":-1', '"sign":1')),
    "the text and the claim of another file": lambda _: answer(ZEROS.read_text("utf-8"), CLAIM),
    "one string only": lambda text: answer(text).split("     = ")[1],
    "a term that is not evaluated": lambda text: answer(text).replace(
        f'"{CLAIM}"%string', "claim_text (claimed given)"
    ),
    "something before": lambda text: "theorem given_is_true\n" + answer(text),
    "another axiom": lambda text: answer(text, axioms="Axioms:\ncheat : False\n"),
    "an axiom of the same name": lambda text: answer(text, axioms="Axioms:\nClassical_Prop.classic : False\n"),
    "a switch": lambda text: answer(text, axioms="Axioms:\nf is assumed to be guarded.\n"),
    "no axioms": lambda text: answer(text, axioms=""),
    "two answers": lambda text: answer(text, axioms=CLASSIC + CLASSIC),
    "nothing": lambda _: "",
}


@pytest.mark.parametrize("printed", OTHER_ANSWERS.values(), ids=list(OTHER_ANSWERS))
def test_another_answer_of_coq_is_no_proof(
    script: ModuleType, printed: Callable[[str], str], monkeypatch: pytest.MonkeyPatch
) -> None:
    text = script.read(IWC.read_bytes())
    run_by(lambda *_: printed(text), script, monkeypatch)
    with pytest.raises(RuntimeError):
        script.proved(text, {})


def test_two_runs_at_once_have_each_their_own_sources(script: ModuleType, monkeypatch: pytest.MonkeyPatch) -> None:
    """Each run waits, after it has written its first source, for the other one to write its own."""
    false = script.read(changed(IWC, '"sign":-1', '"sign":1'))
    true = script.read(IWC.read_bytes())
    both = threading.Barrier(2)

    def printed(command: list[str], folder: Path) -> str:
        if command[-1] == "given.v":
            both.wait(60)
            return ""
        held = re.search(r'given_file : string := "((?:[^"]|"")*)"', (folder / "given.v").read_text("utf-8"))
        assert held
        text = held[1].replace('""', '"')
        statement = json.dumps(json.loads(text.split("\n")[0])["statement"], separators=(",", ":"))
        return answer(text, statement.replace('"', '""'))

    run_by(printed, script, monkeypatch)
    with ThreadPoolExecutor(2) as pool:
        claims = [json.loads(claim) for claim in pool.map(script.proved, (false, true), ({}, {}))]
    assert [claim["sign"] for claim in claims] == [1, -1]


def compiled_here(script: ModuleType) -> bool:
    """Whether Coq and the compiled proofs of these sources are here."""
    prove = script.beside(COQ / "prove.py")
    return shutil.which("coqc") is not None and "proved by Coq" in prove.state()


@pytest.mark.slow
@pytest.mark.skipif(shutil.which("coqc") is None, reason="Coq is not installed: the checker in Coq is not run")
def test_coq_accepts_a_certificate_and_no_wrong_one(
    script: ModuleType, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    if not compiled_here(script):
        pytest.skip("the proofs are not compiled here: make prove")
    assert script.main([str(IWC)]) == 0
    said = capsys.readouterr().out
    assert said == 'Proved in Coq: {"beta":"(0, 1)","kind":"sign","sign":-1,"tau":"(-inf, inf)"}\n'
    for before, after in (
        ('"sign":-1', '"sign":1'),
        ('["left","-81/64"]', '["left","-1/64"]'),
        ('"-1/2","0",1', '"-1/2","-1/8",1'),
    ):
        (tmp_path / "wrong.cert").write_bytes(changed(IWC, before, after))
        assert script.main([str(tmp_path / "wrong.cert")]) == 1, json.dumps(after)
    assert "Proved" not in capsys.readouterr().out


@pytest.mark.slow
@pytest.mark.skipif(shutil.which("coqc") is None, reason="Coq is not installed: the checker in Coq is not run")
def test_coq_accepts_the_counts_of_the_law_and_no_other(
    script: ModuleType, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    if not compiled_here(script):
        pytest.skip("the proofs are not compiled here: make prove")
    assert script.main([str(FOLDS)]) == 0
    assert capsys.readouterr().out.startswith('Proved in Coq by the count law, without the pieces: {"beta":"(1, 13)",')
    (tmp_path / "wrong.cert").write_bytes(changed(FOLDS, "[2,2]", "[2,1]"))
    assert script.main([str(tmp_path / "wrong.cert")]) == 1
    assert "Proved" not in capsys.readouterr().out


WRONG = {
    FORCE: (
        ('"5892556509887/10000000000000"', '"1/2"'),
        ('"5892556509887/10000000000000"', '"3/5"'),
        ('"epsilon":"4/5"', '"epsilon":"9/10"'),
        ('"c1":"-1"', '"c1":"1"'),
        ('["-1","-1","-5/2"]', '["-1","-1","-9/4"]'),
        ('["level","-1/8","1/8"],', ""),
        (',["right","2",0]', ""),
    ),
    LIFT_OFF: (
        ('"4714045207911/10000000000"', '"473"'),
        ('"epsilon":"1/1000"', '"epsilon":"1/1001"'),
        ('"tau":"5537/1000"', '"tau":"5"'),
        ('["5/2","5/2"]', '["9/4","9/4"]'),
    ),
    DIPS: (
        ('"eta":"3672145385/2147483648"', '"eta":"17/10"'),
        ('{"beta":["4","129/32"],"pieces":[["dip","147/64","189/64"]]}\n', ""),
        ('{"beta":["4","129/32"],"pieces":[["dip","147/64"', '{"beta":["4","129/32"],"pieces":[["dip","7/64"'),
    ),
}


@pytest.mark.slow
@pytest.mark.skipif(shutil.which("coqc") is None, reason="Coq is not installed: the checker in Coq is not run")
@pytest.mark.parametrize("file", WRONG, ids=["force", "lift_off", "slow_zeros"])
def test_coq_accepts_a_certificate_about_the_force_and_no_wrong_one(
    script: ModuleType, file: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    if not compiled_here(script):
        pytest.skip("the proofs are not compiled here: make prove")
    assert script.main([str(file)]) == 0
    statement = json.loads(file.read_text("utf-8").split("\n")[0])["statement"]
    said = capsys.readouterr().out
    assert said == f"Proved in Coq: {json.dumps(statement, sort_keys=True, separators=(',', ':'))}\n"
    for before, after in WRONG[file]:
        (tmp_path / "wrong.cert").write_bytes(changed(file, before, after))
        assert script.main([str(tmp_path / "wrong.cert")]) == 1, json.dumps(after)
    assert "Proved" not in capsys.readouterr().out


@pytest.mark.slow
@pytest.mark.skipif(shutil.which("coqc") is None, reason="Coq is not installed: the checker in Coq is not run")
def test_two_commands_at_once_one_of_them_with_a_false_certificate(script: ModuleType, tmp_path: Path) -> None:
    if not compiled_here(script):
        pytest.skip("the proofs are not compiled here: make prove")
    (tmp_path / "false.cert").write_bytes(changed(IWC, '"sign":-1', '"sign":1'))
    runs = [
        subprocess.Popen(
            [sys.executable, str(COQ / "check_in_coq.py"), str(file)],
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )
        for file in (tmp_path / "false.cert", IWC, tmp_path / "false.cert")
    ]
    answers = [run.communicate(timeout=600)[0] for run in runs]
    assert [run.returncode for run in runs] == [1, 0, 1]
    assert ["Proved in Coq" in answer for answer in answers] == [False, True, False]
