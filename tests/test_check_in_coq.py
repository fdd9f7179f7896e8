"""proofs/coq/check_in_coq.py (proofs/check.md, section 7): the data that it writes; in the long run Coq's answer."""

from __future__ import annotations

import importlib.util
import json
import shutil
from hashlib import sha256
from pathlib import Path
from types import ModuleType

import pytest
from must_reject import mutate

COQ = Path(__file__).resolve().parents[1] / "proofs" / "coq"
IWC, ZEROS = COQ.parent / "iwc_0_1.cert", COQ / "zeros_1_2.cert"


@pytest.fixture
def script() -> ModuleType:
    """The script as a module."""
    spec = importlib.util.spec_from_file_location("check_in_coq", COQ / "check_in_coq.py")
    assert spec
    assert spec.loader
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.mark.parametrize(("file", "data"), [(IWC, "CertificateIWC.v"), (ZEROS, "CertificateZeros.v")])
def test_the_data_of_the_development_are_those_of_the_files(script: ModuleType, file: Path, data: str) -> None:
    written = script.source(file.stem, file.read_text(encoding="utf-8"))
    assert (COQ / data).read_text(encoding="utf-8") == written


def test_both_checkers_know_the_certificate_of_zeros() -> None:
    assert "N = 1 on (1, 2)" in mutate.checker().check_text(ZEROS.read_bytes())


def test_numbers_and_pieces_as_terms(script: ModuleType) -> None:
    assert [script.number(text) for text in ("0", "-81/64", "3")] == ["(0 # 1)", "((-81) # 64)", "(3 # 1)"]
    assert script.entry(["sign", "-1", "1/2", -1]) == "Sign ((-1) # 1) (1 # 2) false"
    assert script.entry(["right", "3/2", 1]) == "Right (3 # 2) 1"
    assert script.entry(["taylor"]) == "Taylor"
    assert script.interval("[1/2, inf)") == "(Interval (At (1 # 2)) PlusInfinity true false)"
    assert script.claim({"beta": "(1, 2)", "counts": [[1, 1]], "kind": "zeros"}).endswith("[(1, 1)%nat]")


def test_a_certificate_is_read(script: ModuleType) -> None:
    assert [script.read(file.read_bytes()) for file in (IWC, ZEROS)] == [
        file.read_text("utf-8") for file in (IWC, ZEROS)
    ]


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


@pytest.mark.parametrize("name", ["zeros_1_13", "force_5_2", "zeros_4_5"])
def test_other_kinds_and_pieces_are_not_known(script: ModuleType, name: str) -> None:
    with pytest.raises(ValueError, match="does not know"):
        script.read((COQ.parent / f"{name}.cert").read_bytes())


def changed(file: Path, before: str, after: str) -> bytes:
    """A certificate with another text and the right hash."""
    body = file.read_bytes()[:-72].replace(before.encode(), after.encode())
    assert body != file.read_bytes()[:-72]
    return body + b"\nsha256 " + sha256(body + b"\n").hexdigest().encode() + b"\n"


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
}


@pytest.mark.parametrize("data", NOT_OF_THE_FORMAT.values(), ids=list(NOT_OF_THE_FORMAT))
def test_what_has_not_the_format_is_refused_before_coq_sees_it(script: ModuleType, data: bytes) -> None:
    with pytest.raises(ValueError, match="Not a certificate"):
        script.read(data)


@pytest.mark.slow
@pytest.mark.skipif(shutil.which("coqc") is None, reason="Coq is not installed: the checker in Coq is not run")
def test_coq_accepts_a_certificate_and_no_wrong_one(script: ModuleType, tmp_path: Path) -> None:
    if script.main([str(IWC)]) == 2:
        pytest.skip("the proofs are not compiled here: make prove")
    assert script.main([str(IWC)]) == 0
    for before, after in (
        ('"sign":-1', '"sign":1'),
        ('["left","-81/64"]', '["left","-1/64"]'),
        ('"-1/2","0",1', '"-1/2","-1/8",1'),
    ):
        (tmp_path / "wrong.cert").write_bytes(changed(IWC, before, after))
        assert script.main([str(tmp_path / "wrong.cert")]) == 1, json.dumps(after)
