"""proofs/coq/prove.py, the script of `make prove`: what it refuses; where Coq is, small developments.

The whole job is `make prove`, which .ci/run runs. What a source may say is tested in test_source_rules.py, what the
programs of Coq print in test_coq_output.py.
"""

from __future__ import annotations

import hashlib
import importlib.util
import py_compile
import re
import shutil
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from types import ModuleType

import pytest

COQ = Path(__file__).resolve().parents[2] / "proofs" / "coq"
AXIOMS = {
    "ClassicalDedekindReals.sig_not_dec",
    "ClassicalDedekindReals.sig_forall_dec",
    "FunctionalExtensionality.functional_extensionality_dep",
    "Classical_Prop.classic",
}
"""Those of Coq's classical reals."""
WITHOUT_COQ = pytest.mark.skipif(shutil.which("coqc") is None, reason="Coq is not installed: nothing is compiled")


@pytest.fixture
def prove(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> ModuleType:
    """The script as a module, on a copy of the sources and with a build directory of its own."""
    shutil.copytree(COQ, tmp_path / "coq")
    monkeypatch.syspath_prepend(str(COQ))
    for certificate in COQ.parent.glob("*.cert"):
        shutil.copy(certificate, tmp_path)
    spec = importlib.util.spec_from_file_location("prove", tmp_path / "coq" / "prove.py")
    assert spec
    assert spec.loader
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    module.BUILD = tmp_path / "build"
    module.BUILD.mkdir()
    return module


def test_no_proof_is_left_out(prove: ModuleType) -> None:
    assert prove.unproved(prove.read_sources()) == []


def test_no_line_of_a_source_is_longer_than_120_characters(prove: ModuleType) -> None:
    """The text of a certificate has the lines of its file."""
    texts = {name: text.decode() for name, text in prove.read_sources().items() if name not in prove.CERTIFICATES}
    assert [(name, line) for name, text in texts.items() for line in text.splitlines() if len(line) > 120] == []


def refused(prove: ModuleType, capsys: pytest.CaptureFixture[str]) -> str:
    """What is said of sources that may not be compiled; an old record is gone."""
    (prove.BUILD / prove.RECORD).write_text("an old record")
    assert prove.prove(1, kernel=False) == 1
    assert not (prove.BUILD / prove.RECORD).exists()
    said = capsys.readouterr()
    assert not said.out
    return said.err


@pytest.mark.parametrize("words", ["Admitted.", "Unset Guard Checking.", "Load Another."])
def test_a_proof_left_out_is_found(prove: ModuleType, words: str, capsys: pytest.CaptureFixture[str]) -> None:
    with (prove.HERE / "Calculus.v").open("a") as file:
        file.write(f"\n{words}\n")
    assert refused(prove, capsys) == f"A source says what it may not:\nCalculus.v: {words.removesuffix('.')}\n"


def test_a_text_that_is_not_the_file_is_found(prove: ModuleType, capsys: pytest.CaptureFixture[str]) -> None:
    assert prove.other_texts(prove.read_sources()) == []
    (prove.HERE.parent / "iwc_0_1.cert").write_text("another\n")
    (prove.HERE / "zeros_1_2.cert").unlink()
    with (prove.HERE / "CertificateZeros.v").open("a") as file:
        file.write("\n")
    assert refused(prove, capsys) == (
        "A text is not that of the file:\nCertificateIWC.v: iwc_0_1.cert\nCertificateZeros.v: zeros_1_2.cert\n"
    )


def test_a_statement_with_another_text_is_found(prove: ModuleType, capsys: pytest.CaptureFixture[str]) -> None:
    assert prove.other_statements(prove.read_sources()) == []
    path = prove.HERE / "StatementStep.v"
    path.write_text(path.read_text().replace("0 <= T <= 1 ->", "0 <= T < 1 ->").replace("0 < h;", "0 <= h;"))
    assert refused(prove, capsys) == (
        "A statement is not the one of statements.txt:\n"
        "StatementStep.v: step_checked has another text\nStatementStep.v: validated_step has another text\n"
    )


def test_a_text_in_a_comment_is_not_the_one_that_coq_reads(prove: ModuleType) -> None:
    """The true text in a comment at the start of a line, another one as the definition."""
    texts = prove.read_sources()
    text = texts["CertificateIWC.v"]
    start = text.index(b"Definition iwc_0_1_file")
    held = text[start : text.index(b"%string.", start) + len(b"%string.")]
    texts["CertificateIWC.v"] = text.replace(held, b"(*\n" + held + b"\n*) " + held.replace(b"(0, 1)", b"(0, 2)"))
    assert prove.unproved(texts) == []
    assert prove.other_texts(texts) == ["CertificateIWC.v: iwc_0_1.cert"]


def extra_file(here: Path) -> None:
    (here / "Extra.v").write_text("Lemma trivial : True. Proof. exact I. Qed.\n")


def link(here: Path) -> None:
    (here / "Calculus.v").rename(here.parent / "Calculus.v")
    (here / "Calculus.v").symlink_to(here.parent / "Calculus.v")


def no_file(here: Path) -> None:
    (here / "Calculus.v").unlink()


def folder(here: Path) -> None:
    no_file(here)
    (here / "Calculus.v").mkdir()


def argument(here: Path) -> None:
    (here / "_CoqProject").write_text("-arg -type-in-type\n" + (here / "_CoqProject").read_text())


def other_place(here: Path) -> None:
    (here / "_CoqProject").write_text((here / "_CoqProject").read_text() + "../Elsewhere.v\n")


@pytest.mark.parametrize(
    ("spoil", "said"),
    [
        (extra_file, "Extra.v is not in _CoqProject"),
        (link, "Calculus.v is not a file here"),
        (no_file, "Calculus.v is not a file here"),
        (folder, "directory"),
        (argument, "_CoqProject is not"),
        (other_place, "_CoqProject is not"),
    ],
)
def test_the_sources_are_the_listed_files(
    prove: ModuleType, spoil: Callable[[Path], None], said: str, capsys: pytest.CaptureFixture[str]
) -> None:
    spoil(prove.HERE)
    assert said in refused(prove, capsys)


def test_each_statement_has_a_theorem_and_a_line_of_axioms(prove: ModuleType) -> None:
    names = prove.statements(prove.read_sources())
    assert {"IWC", "count_law", "count_law_integer", "zeros_continuous", "IWC_compliant", "case_II"} <= set(names)
    theorems = (prove.HERE / "Theorems.v").read_text(encoding="utf-8")
    assert [name for name, file in names.items() if f"Theorem {name} : {file}.{name}.\n" not in theorems] == []
    assert {*names.values()} == {*prove.STATED_IN}
    assert sorted(prove.listed()) == sorted(names)
    listed = (prove.HERE / "assumptions.txt").read_text(encoding="utf-8").splitlines()
    assert len([line for line in listed if ":" in line and not line.startswith("#")]) == len(names)
    assert all(set(axioms) <= AXIOMS for axioms in prove.listed().values())


def test_a_name_that_two_files_state_is_refused(prove: ModuleType) -> None:
    with (prove.HERE / "StatementCertificate.v").open("a") as file:
        file.write("\nDefinition IWC : Prop := True.\n")
    with pytest.raises(ValueError, match=r"Statement\.v and StatementCertificate\.v both state IWC"):
        prove.statements(prove.read_sources())


def test_the_table_of_the_checker_names_every_page_and_only_statements(prove: ModuleType) -> None:
    text = (COQ / "README.md").read_text(encoding="utf-8").partition("## What the checker rests on")[2]
    rows = re.findall(r"^\| \[(\w+)\]\(\.\./\w+\.md\) \| .*? \| (.*) \|$", text, re.MULTILINE)
    assert len(rows) == text.count("\n| [")
    checker = (COQ.parent / "checker" / "pieces.py").read_text(encoding="utf-8")
    named = re.search(r"^HYPOTHESES = \{(.*?)^\}", checker, re.MULTILINE | re.DOTALL)
    assert named
    assert {page for page, _ in rows} == {*re.findall(r'"(\w+)"', named[1]), "check"}
    for _, formal in rows:
        names = re.findall(r"`(\w+)`", formal)
        assert set(names) <= set(prove.statements(prove.read_sources()))
        assert names or formal == "prose"


def test_the_pages_name_statements_and_lemmas_that_exist(prove: ModuleType) -> None:
    """On the lines "Formal proof" only statements; on the page of the count law also lemmas."""
    lemmas = re.findall(
        r"^(?:Theorem|Lemma|Definition|Fixpoint) ([\w']+)",
        "\n".join(text.decode() for text in prove.read_sources().values()),
        re.MULTILINE,
    )
    noted = 0
    for page in COQ.parent.glob("*.md"):
        text = page.read_text(encoding="utf-8")
        for line in re.findall(r"^Formal proof \(`proofs/coq/`\): (.*)$", text, re.MULTILINE):
            noted += 1
            assert set(re.findall(r"`(\w+)`", line)) <= set(prove.statements(prove.read_sources())), page.name
    assert noted >= 8
    law = (COQ.parent / "count_law.md").read_text(encoding="utf-8")
    named = set(re.findall(r"`(\w+)`", law))
    assert {"step_tail", "step_head", "left_side", "positive_zeros", "Theta_zero_QQ"} <= named
    assert named - {"cell", "sg"} <= set(lemmas) | {"sg"}


def test_the_list_of_files_is_complete(prove: ModuleType) -> None:
    text = (COQ / "README.md").read_text(encoding="utf-8")
    listed = re.findall(r"`(\w+\.v)`", text)
    assert {*prove.read_sources()} - {prove.PROJECT} <= set(listed)


def test_other_axioms_are_refused(prove: ModuleType) -> None:
    good = {"first": ["Classical_Prop.classic"]}
    assert prove.differences(good, good) == []
    assert len(prove.differences(good, {"first": []})) == 1
    assert len(prove.differences(good, {})) == 1
    assert len(prove.differences({}, good)) == 1
    assert prove.differences({"first": ["mine"]}, {"first": ["mine"]}) == [
        "first: not an axiom of the classical reals: mine"
    ]


def test_without_coq_nothing_is_said_to_be_proved(
    prove: ModuleType, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    (prove.BUILD / prove.RECORD).write_text("an old record")
    monkeypatch.setattr(prove.shutil, "which", lambda _: None)
    assert prove.prove(1, kernel=False) == 2
    assert "apt-get install" in capsys.readouterr().out
    assert not (prove.BUILD / prove.RECORD).exists()
    assert prove.state() == "The formal proofs were not run here; `make prove` runs them."


@pytest.mark.parametrize("script", ["prove.py", "check_in_coq.py"])
@pytest.mark.parametrize("options", [[], ["-I"]])
def test_no_compiled_file_of_python_is_believed(tmp_path: Path, script: str, options: list[str]) -> None:
    """A file in __pycache__ that Python takes without looking at its source."""
    shutil.copytree(COQ, tmp_path / "coq", ignore=shutil.ignore_patterns("*.v", "__pycache__"))
    shutil.copytree(COQ.parent / "checker", tmp_path / "checker", ignore=shutil.ignore_patterns("__pycache__"))
    (tmp_path / "forged.py").write_text("print('The formal proofs: 130 theorems proved'); raise SystemExit(0)\n")
    for name in ("coq/source_rules", "coq/coq_output", "checker/reading"):
        cached = importlib.util.cache_from_source(str(tmp_path / f"{name}.py"))
        mode = py_compile.PycInvalidationMode.UNCHECKED_HASH
        py_compile.compile(str(tmp_path / "forged.py"), cached, invalidation_mode=mode)
    command = [sys.executable, *options, str(tmp_path / "coq" / script), *(["--state"] if script == "prove.py" else [])]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert "not run" in done.stdout.lower()
    assert "proved" not in done.stdout


def recorded(prove: ModuleType) -> dict[str, object]:
    """A record as a run on these sources leaves it, with compiled files of its own."""
    texts = prove.read_sources()
    names = [name for name in texts if name != prove.PROJECT]
    for name in names:
        (prove.BUILD / f"{name}o").write_text(name)
    built = prove.digests(prove.compiled(names, prove.BUILD))
    record = prove.known_run(texts, prove.listed()) | {"coq": "8.16.1", "kernel": False, "compiled": built}
    (prove.BUILD / prove.RECORD).write_text(prove.json.dumps(record))
    return dict(record)


def test_a_record_of_these_sources(prove: ModuleType) -> None:
    number = len(recorded(prove)["theorems"])
    assert prove.state() == f"The formal proofs: {number} theorems proved by Coq 8.16.1 from these sources."


@pytest.mark.parametrize("name", ["Calculus.v", "_CoqProject", "assumptions.txt"])
def test_a_record_of_other_sources_says_so(prove: ModuleType, name: str) -> None:
    recorded(prove)
    with (prove.HERE / name).open("a") as file:
        file.write("\n" if name != "assumptions.txt" else "more: Classical_Prop.classic\n")
    assert "on other sources" in prove.state()


@pytest.mark.parametrize("text", ["", "{}", "[]", "null", '{"sources": 1}', '{"coq": "8.16.1", "theorems": {}}'])
def test_what_is_no_record_shows_nothing(prove: ModuleType, text: str) -> None:
    recorded(prove)
    (prove.BUILD / prove.RECORD).write_text(text)
    assert "on other sources" in prove.state()


def test_compiled_files_that_are_not_those_of_the_record(prove: ModuleType) -> None:
    recorded(prove)
    (prove.BUILD / "Theorems.vo").write_text("another")
    assert prove.state() == "The compiled proofs are not those of the record; `make prove` makes them again."
    (prove.BUILD / "Theorems.vo").unlink()
    assert "theorems proved" not in prove.state()


def test_how_far_the_compilation_is(prove: ModuleType, tmp_path: Path) -> None:
    texts = {prove.PROJECT: b"\n" * 90, "First.v": b"\n" * 10, "Second.v": b"\n" * 30}
    assert prove.compiling(tmp_path, texts, 3) == "compiling the first of 2 files, 3 s"
    (tmp_path / "First.vo").touch()
    assert prove.compiling(tmp_path, texts, 20) == "1 of 2 files compiled in 20 s, First.v last; about 60 s still"
    (tmp_path / "Second.vo").touch()
    assert "2 of 2 files compiled in 80 s" in prove.compiling(tmp_path, texts, 80)
    assert prove.compiling(tmp_path, texts, 80).endswith("about 0 s still")


STATEMENT = "Definition claim : Prop := forall n : nat, n = n.\n"
PROOF = "From GSpot Require Import Statement.\n\nTheorem claim : Statement.claim.\nProof. intros n. reflexivity. Qed.\n"
FALSE = {"Statement.v": "Definition claim : Prop := False.\n"}
GUARD = {
    "Lemmas.v": "Unset Guard Checking.\nFixpoint absurd (n : nat) : False := absurd n.\nSet Guard Checking.\n",
    "Theorems.v": "From GSpot Require Import Statement Lemmas.\n\nTheorem claim : Statement.claim.\n"
    "Proof. exact (absurd 0). Qed.\n",
}


@pytest.fixture
def small(prove: ModuleType, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> ModuleType:
    """The script on a development of three short files, without Coquelicot."""
    monkeypatch.setattr(prove, "HERE", tmp_path / "small")
    monkeypatch.setattr(prove, "STATED_IN", ("Statement",))
    monkeypatch.setattr(prove, "CERTIFICATES", {})
    monkeypatch.setattr(prove, "other_statements", lambda _: [])
    monkeypatch.setattr(prove, "missing", lambda: "")
    prove.HERE.mkdir()
    write(prove, {"assumptions.txt": "claim:\n", "Statement.v": STATEMENT, "Lemmas.v": "", "Theorems.v": PROOF})
    write(prove, {"_CoqProject": "-R . GSpot\n\nStatement.v\nLemmas.v\nTheorems.v\n"})
    return prove


def write(prove: ModuleType, texts: dict[str, str]) -> None:
    for name, text in texts.items():
        (prove.HERE / name).write_text(text)


def hostile(prove: ModuleType, home: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """An environment, a home and a build folder that would let Coq and make accept what they should not."""
    shadow = home / "shadow"
    (shadow / "GSpot").mkdir(parents=True)
    (shadow / "GSpot" / "Statement.v").write_text("Definition claim : Prop := True.\n")
    for name in (".coqrc", "coqrc"):
        (home / name).write_text("Axiom cheat : False.\n")
    (home / "Makefile").write_text("Makefile %: ;\n")
    for name in ("Statement.vo", "Lemmas.vo", "Theorems.vo", "audit_0.vo", "Orphan.vo", "Makefile.local"):
        (prove.BUILD / name).write_text("stale")
    for name, value in {
        "MAKEFLAGS": "t",
        "GNUMAKEFLAGS": "-i",
        "MAKEFILES": str(home / "Makefile"),
        "COQPATH": str(shadow),
        "COQEXTRAFLAGS": "-type-in-type",
        "OTHERFLAGS": "-type-in-type",
        "COQLIB": str(shadow),
        "COQBIN": str(shadow) + "/",
        "OCAMLPATH": str(shadow),
        "XDG_DATA_HOME": str(home),
        "HOME": str(home),
    }.items():
        monkeypatch.setenv(name, value)


@WITHOUT_COQ
def test_neither_the_environment_nor_what_was_made_before_is_believed(
    small: ModuleType, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    hostile(small, tmp_path / "home", monkeypatch)
    truth = tmp_path / "truth"
    truth.mkdir()
    small.compile_all(small.read_sources(), truth, 1)
    for compiled in truth.glob("*.vo"):  # of a statement that was true, beside the sources
        shutil.copy(compiled, small.HERE)
    write(small, FALSE)
    assert small.prove(1, kernel=False) == 1
    said = capsys.readouterr()
    assert "theorems proved" not in said.out
    assert "does not compile" in said.err
    assert small.state() == "The formal proofs were not run here; `make prove` runs them."
    assert [path.name for path in small.BUILD.parent.glob("coq-*")] == []


@WITHOUT_COQ
def test_what_is_true_is_proved_in_any_environment(
    small: ModuleType, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    hostile(small, tmp_path / "home", monkeypatch)
    assert small.prove(1, kernel=False) == 0
    digest = hashlib.sha256((small.HERE / "Statement.v").read_bytes()).hexdigest()
    stated = f"Stated in Statement.v, SHA-256 {digest}"
    assert capsys.readouterr().out.startswith(f"claim: no axiom\n{stated}\n1 theorems proved by Coq")
    assert not (small.BUILD / "Orphan.vo").exists()
    assert "1 theorems proved" in small.state()


@pytest.mark.slow
@WITHOUT_COQ
def test_the_kernel_checker_on_a_small_development(small: ModuleType) -> None:
    """Without axioms it is accepted; what the kernel takes on trust is not, even if nothing else is asked."""
    names, folder = list(small.read_sources()), small.BUILD
    assert small.prove(1, kernel=True) == 0
    write(small, FALSE | GUARD)
    shutil.rmtree(folder)
    folder.mkdir()
    small.compile_all({name: (small.HERE / name).read_bytes() for name in names}, folder, 1)
    with pytest.raises(RuntimeError, match="coqchk does not accept the proofs"):
        small.check_kernel(folder)


BELIEVED_TOO_MUCH = {
    "recursion without end": (FALSE | GUARD, "is assumed to be guarded"),
    "a variable outside of a section": (
        FALSE
        | {
            "Lemmas.v": "Variable cheat : False.\n",
            "Theorems.v": GUARD["Theorems.v"].replace("absurd 0", "Lemmas.cheat"),
        },
        "is not understood: Lemmas.cheat : False",
    ),
    "type in type": (
        {
            "_CoqProject": "-R . GSpot\n-arg -type-in-type\n\nStatement.v\nLemmas.v\nTheorems.v\n",
            "Lemmas.v": "Definition big : Type := forall A : Type, A.\nDefinition less (b : big) : big := b big.\n",
            "Theorems.v": PROOF.replace("intros n.", "pose (Lemmas.less).")
            .replace("Statement.\n", "Statement Lemmas.\n", 1)
            .replace("reflexivity", "intros n. reflexivity"),
        },
        "Universe inconsistency",
    ),
    "a sign with another meaning": (
        {
            "Lemmas.v": "Notation same := (fun a b : nat => True).\n",
            "Statement.v": "From GSpot Require Import Lemmas.\n\n"
            "Definition claim : Prop := forall n : nat, same n (S n).\n",
            "Theorems.v": PROOF.replace("reflexivity", "exact I"),
        },
        "GSpot.Lemmas: same",
    ),
    "another type behind a name": (
        {
            "Lemmas.v": "Notation nat := (unit).\n",
            "Statement.v": "From GSpot Require Import Lemmas.\n\nDefinition claim : Prop := forall m n : nat, m = n.\n",
            "Theorems.v": PROOF.replace("intros n. reflexivity", "intros [] []. reflexivity"),
        },
        "GSpot.Lemmas: nat",
    ),
    "another constructor of this name": (
        {
            "Lemmas.v": "Inductive one := S.\n",
            "Statement.v": "From GSpot Require Import Lemmas.\n\nDefinition claim : Prop := forall n, n = S.\n",
            "Theorems.v": PROOF.replace("intros n. reflexivity", "intros []. reflexivity"),
        },
        "GSpot.Lemmas: S",
    ),
    "another definition of a name of Coq": (
        {
            "Lemmas.v": "Definition le (m n : nat) : Prop := True.\n",
            "Statement.v": "From GSpot Require Import Lemmas.\n\nDefinition claim : Prop := le 1 0.\n",
            "Theorems.v": PROOF.replace("intros n. reflexivity", "exact I"),
        },
        "GSpot.Lemmas: le",
    ),
    "a theorem that a module hides": (
        FALSE
        | {
            "Lemmas.v": "Module Statement.\nDefinition claim : Prop := True.\nEnd Statement.\n",
            "Theorems.v": "From GSpot Require Import Statement Lemmas.\n\nTheorem claim : Lemmas.Statement.claim.\n"
            "Proof. exact I. Qed.\nModule GSpot.\nModule Statement.\nDefinition claim := True.\n"
            "End Statement.\nEnd GSpot.\n",
        },
        "A statement is not proved",
    ),
}


@WITHOUT_COQ
@pytest.mark.parametrize(
    "case",
    [
        pytest.param(name, id=name, marks=[] if name == "recursion without end" else [pytest.mark.slow])
        for name in BELIEVED_TOO_MUCH
    ],
)
def test_what_coq_answers_is_a_refusal_also_where_the_rules_of_the_sources_are_passed(
    small: ModuleType, case: str, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    texts, said = BELIEVED_TOO_MUCH[case]
    write(small, texts)
    if "_CoqProject" in texts:
        names = ["_CoqProject", "Statement.v", "Lemmas.v", "Theorems.v"]
        monkeypatch.setattr(small, "read_sources", lambda: {name: (small.HERE / name).read_bytes() for name in names})
    monkeypatch.setattr(small, "unproved", lambda _: [])
    assert small.prove(1, kernel=False) == 1
    output = capsys.readouterr()
    assert said in output.err
    assert "theorems proved" not in output.out
    assert not (small.BUILD / small.RECORD).exists()
