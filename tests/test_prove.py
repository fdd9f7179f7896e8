"""proofs/coq/prove.py, the script of `make prove`: what it refuses; where Coq is, the whole job in the long run."""

from __future__ import annotations

import importlib.util
import re
import shutil
from pathlib import Path
from types import ModuleType

import pytest

COQ = Path(__file__).resolve().parents[1] / "proofs" / "coq"


@pytest.fixture
def prove(tmp_path: Path) -> ModuleType:
    """The script as a module, on a copy of the sources and with a build directory of its own."""
    shutil.copytree(COQ, tmp_path / "coq")
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
    assert prove.unproved() == []


@pytest.mark.parametrize(
    "word", ["Admitted.", "admit.", "Axiom a : False.", "Parameter p : R.", "Unset Guard Checking."]
)
def test_a_proof_left_out_is_found(prove: ModuleType, word: str) -> None:
    with (prove.HERE / "Calculus.v").open("a") as file:
        file.write(f"\n{word}\n")
    assert len(prove.unproved()) == 1


def test_a_text_that_is_not_the_file_is_found(prove: ModuleType) -> None:
    assert prove.other_texts() == []
    (prove.HERE.parent / "iwc_0_1.cert").write_text("another\n")
    assert prove.other_texts() == ["CertificateIWC.v: iwc_0_1.cert"]
    (prove.HERE / "zeros_1_2.cert").unlink()
    assert prove.other_texts() == ["CertificateIWC.v: iwc_0_1.cert", "CertificateZeros.v: zeros_1_2.cert"]
    (prove.HERE / "CertificateZeros.v").write_text("")
    assert prove.other_texts() == ["CertificateIWC.v: iwc_0_1.cert", "no text of zeros_1_2.cert is held"]


def test_comments_may_say_the_words(prove: ModuleType) -> None:
    with (prove.HERE / "Calculus.v").open("a") as file:
        file.write("\n(* Admitted (* nested: Axiom *) Parameter *)\n")
    assert prove.unproved() == []


def test_a_file_that_is_not_compiled_is_found(prove: ModuleType) -> None:
    (prove.HERE / "Extra.v").write_text("Lemma trivial : True. Proof. exact I. Qed.\n")
    assert prove.unproved() == ["Extra.v is not in _CoqProject"]


def test_each_statement_has_a_theorem_and_a_line_of_axioms(prove: ModuleType) -> None:
    names = prove.statements()
    assert {"IWC", "count_law", "count_law_integer", "zeros_continuous", "IWC_compliant", "case_II"} <= set(names)
    theorems = (prove.HERE / "Theorems.v").read_text(encoding="utf-8")
    assert [name for name, file in names.items() if f"Theorem {name} : {file}.{name}.\n" not in theorems] == []
    assert {*names.values()} == {*prove.STATED_IN}
    assert sorted(prove.listed()) == sorted(names)
    listed = (prove.HERE / "assumptions.txt").read_text(encoding="utf-8").splitlines()
    assert len([line for line in listed if ":" in line and not line.startswith("#")]) == len(names)
    assert all(set(axioms) <= prove.AXIOMS for axioms in prove.listed().values())


def test_a_name_that_two_files_state_is_refused(prove: ModuleType) -> None:
    with (prove.HERE / "StatementCertificate.v").open("a") as file:
        file.write("\nDefinition IWC : Prop := True.\n")
    with pytest.raises(ValueError, match=r"Statement\.v and StatementCertificate\.v both state IWC"):
        prove.statements()


def test_the_table_of_the_checker_names_every_page_and_only_statements(prove: ModuleType) -> None:
    text = (COQ / "README.md").read_text(encoding="utf-8").partition("## What the checker rests on")[2]
    rows = re.findall(r"^\| \[(\w+)\]\(\.\./\w+\.md\) \| .*? \| (.*) \|$", text, re.MULTILINE)
    assert len(rows) == text.count("\n| [")
    checker = (COQ.parent / "check.py").read_text(encoding="utf-8")
    named = re.search(r"^HYPOTHESES = \{(.*?)^\}", checker, re.MULTILINE | re.DOTALL)
    assert named
    assert {page for page, _ in rows} == {*re.findall(r'"(\w+)"', named[1]), "check"}
    for _, formal in rows:
        names = re.findall(r"`(\w+)`", formal)
        assert set(names) <= set(prove.statements())
        assert names or formal == "prose"


def test_the_pages_name_statements_and_lemmas_that_exist(prove: ModuleType) -> None:
    """On the lines "Formal proof" only statements; on the page of the count law also lemmas."""
    lemmas = re.findall(
        r"^(?:Theorem|Lemma|Definition|Fixpoint) ([\w']+)",
        "\n".join(path.read_text(encoding="utf-8") for path in prove.sources()),
        re.MULTILINE,
    )
    noted = 0
    for page in COQ.parent.glob("*.md"):
        text = page.read_text(encoding="utf-8")
        for line in re.findall(r"^Formal proof \(`proofs/coq/`\): (.*)$", text, re.MULTILINE):
            noted += 1
            assert set(re.findall(r"`(\w+)`", line)) <= set(prove.statements()), page.name
    assert noted >= 8
    law = (COQ.parent / "count_law.md").read_text(encoding="utf-8")
    named = set(re.findall(r"`(\w+)`", law))
    assert {"step_tail", "step_head", "left_side", "positive_zeros", "Theta_zero_QQ"} <= named
    assert named - {"cell", "sg"} <= set(lemmas) | {"sg"}


def test_the_list_of_files_is_complete(prove: ModuleType) -> None:
    text = (COQ / "README.md").read_text(encoding="utf-8")
    listed = re.findall(r"`(\w+\.v)`", text)
    assert {path.name for path in prove.sources()} <= set(listed)


ANSWER = """theorem first
Axioms:
ClassicalDedekindReals.sig_not_dec
  : forall P : Prop, {~ ~ P} + {~ P}
Classical_Prop.classic : forall P : Prop, P \\/ ~ P
theorem second
Closed under the global context
"""


def test_what_coq_prints_is_read(prove: ModuleType) -> None:
    first = ["ClassicalDedekindReals.sig_not_dec", "Classical_Prop.classic"]
    assert prove.axioms_printed(ANSWER) == {"first": sorted(first), "second": []}
    with pytest.raises(RuntimeError, match="third"):
        prove.axioms_printed("theorem third\nSection Variables:\nx : R\n")


SUMMARY = """CONTEXT SUMMARY
===============

* Theory: Set is predicative
  
* Axioms:
    Coq.Logic.FunctionalExtensionality.functional_extensionality_dep
    Coq.Reals.ClassicalDedekindReals.sig_not_dec
  
* Constants/Inductives relying on type-in-type: <none>
  
* Constants/Inductives relying on unsafe (co)fixpoints: <none>
  
* Inductives whose positivity is assumed: <none>
"""  # noqa: W293


def test_the_summary_of_the_kernel_checker_is_read(prove: ModuleType) -> None:
    assert prove.kernel_accepts(SUMMARY)
    assert not prove.kernel_accepts(SUMMARY.replace("Coq.Reals.ClassicalDedekindReals.sig_not_dec", "Mine.axiom"))
    assert not prove.kernel_accepts(SUMMARY.replace("Coq.Reals.Classical", "GSpot.Classical"))
    assert not prove.kernel_accepts(SUMMARY.replace("assumed: <none>", "assumed: GSpot.t"))
    assert not prove.kernel_accepts("")


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


def test_a_record_of_other_sources_says_so(prove: ModuleType) -> None:
    text = prove.json.dumps({"coq": "8.16.1", "sources": prove.hashes(), "theorems": {"IWC": []}})
    (prove.BUILD / prove.RECORD).write_text(text)
    assert "1 theorems proved by Coq 8.16.1 from these sources" in prove.state()
    with (prove.HERE / "Calculus.v").open("a") as file:
        file.write("\n")
    assert "on other sources" in prove.state()


@pytest.mark.slow
@pytest.mark.skipif(shutil.which("coqc") is None, reason="Coq is not installed: the formal proofs are not run")
def test_the_whole_job_with_the_kernel_checker(prove: ModuleType, capsys: pytest.CaptureFixture[str]) -> None:
    assert prove.prove(2, kernel=True) == 0
    assert "theorems proved" in capsys.readouterr().out
    assert "from these sources" in prove.state()
