"""Formal proofs in the ledger: they count only where this program has run them, whatever lies on the disk."""

from __future__ import annotations

import hashlib
import json
import re
import shutil
from pathlib import Path

import pytest

from gspot_verified import Outcome
from gspot_verified.paper.checks.entry import Check, Entry, Rung, conclude
from gspot_verified.paper.checks.formal_proof import (
    COQ,
    NOT_ASKED,
    ProofRun,
    formal_proof,
    run_proofs,
    stated_in,
    statement_of,
)
from gspot_verified.paper.checks.formal_routes import CARRIED, CONTRADICTED, with_formal_proof
from gspot_verified.paper.verify import PARTS

REPOSITORY = Path(__file__).resolve().parents[3]
NAMES = sorted(
    {name for names in CARRIED.values() for name in names} | {n for ns, _ in CONTRADICTED.values() for n in ns}
)


STATED = {name: hashlib.sha256((COQ / name).read_bytes()).hexdigest() for name in stated_in()}
PASSED = ProofRun(frozenset(NAMES), "", STATED)


@pytest.fixture
def coq(tmp_path: Path) -> Path:
    """A copy of the sources, where no proof was run."""
    folder = tmp_path / "proofs" / "coq"
    shutil.copytree(COQ, folder)
    return folder


def entry(identifier: str, agrees: bool = True) -> Entry:
    checks = (Check(Rung.EXACT, "one", agrees, "found"), Check(Rung.BALLS, "two", agrees, "found"))
    return Entry(identifier, "line 1", "Section 4.5", "x", "y", checks, conclude("y", checks))


def test_what_was_proved_in_this_run(coq: Path) -> None:
    found = formal_proof(["IWC"], PASSED, coq)
    assert found.run
    assert found.state == "run here, by proofs/coq/prove.py"
    [(name, statement, file)] = found.theorems
    assert (name, file) == ("IWC", "Statement.v")
    assert statement.endswith("forall b theta, 0 < b < 1 -> is_Theta b theta -> forall t, Derive theta t < 0.")


def not_run(coq: Path, proofs: ProofRun, why: str) -> None:
    found = formal_proof(["IWC"], proofs, coq)
    assert not found.run
    assert found.state == f"not run here: {why}"
    before = entry("S-iwc")
    after = with_formal_proof(before, proofs, coq)
    assert after.checks == before.checks
    assert after.verdict == before.verdict
    assert after.rung is Rung.EXACT
    assert after.routes[-1] == ("formal proof", "IWC", False)


def test_a_record_made_by_hand_shows_nothing(coq: Path) -> None:
    """With the right hashes of all sources, and of compiled files that somebody put there."""
    build = coq.parents[1] / "build" / "coq"
    build.mkdir(parents=True)
    sources = {path.name: hashlib.sha256(path.read_bytes()).hexdigest() for path in coq.glob("*.v")}
    compiled = {}
    for name in sources:
        (build / f"{name}o").write_bytes(b"forged")
        compiled[f"{name}o"] = hashlib.sha256(b"forged").hexdigest()
    record = {"coq": "8.16.1", "sources": sources, "compiled": compiled, "theorems": {name: [] for name in NAMES}}
    (build / "record.json").write_text(json.dumps(record))
    not_run(coq, ProofRun(), NOT_ASKED)
    (coq / "prove.py").write_text("print('IWC: no axiom')\nraise SystemExit(1)\n")
    found = run_proofs(coq)
    assert not found.theorems
    not_run(coq, found, "prove.py ended with 1: IWC: no axiom")


@pytest.mark.parametrize(
    ("script", "theorems", "failure"),
    [
        ("print('IWC: sig_not_dec, classic')\nprint('gamma_sign: no axiom')\nprint('Record: /x')", NAMES[:0], ""),
        ("raise SystemExit(2)", None, "prove.py ended with 2: it said nothing"),
        ("print('were not run: Coq')\nraise SystemExit(2)", None, "prove.py ended with 2: were not run: Coq"),
        ("import os; os.kill(os.getpid(), 9)", None, "prove.py ended with -9: it said nothing"),
    ],
)
def test_what_a_run_shows(tmp_path: Path, script: str, theorems: list[str] | None, failure: str) -> None:
    (tmp_path / "prove.py").write_text(script)
    expected = frozenset() if theorems is None else frozenset({"IWC", "gamma_sign"})
    assert run_proofs(tmp_path) == ProofRun(expected, failure)


def test_a_run_says_which_files_it_held_the_theorems_against(tmp_path: Path) -> None:
    (tmp_path / "prove.py").write_text(f"print('IWC: no axiom\\nStated in Statement.v, SHA-256 {'a' * 64}')")
    assert run_proofs(tmp_path) == ProofRun(frozenset({"IWC"}), "", {"Statement.v": "a" * 64})


def test_a_statement_that_was_changed_after_the_run_was_not_proved(coq: Path) -> None:
    """As where somebody edits it while ``verify --formal`` is still at work on the entries."""
    file = coq / "Statement.v"
    text = file.read_text(encoding="utf-8")
    file.write_text(text.replace("forall b theta, 0 < b < 1 ->", "forall b theta, 0 < b < 9 ->"), encoding="utf-8")
    assert file.read_text(encoding="utf-8") != text
    not_run(coq, PASSED, "Statement.v was changed after prove.py had read it")
    not_run(coq, ProofRun(frozenset(NAMES), ""), "Statement.v was changed after prove.py had read it")
    assert formal_proof(["flight_persists"], PASSED, coq).run


def test_a_run_does_not_see_what_acts_on_python(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "sitecustomize.py").write_text("print('IWC: no axiom'); raise SystemExit(0)")
    (tmp_path / "prove.py").write_text("import os, sys\nprint(sys.flags.isolated, 'COQLIB' in os.environ)\nsys.exit(1)")
    monkeypatch.setenv("PYTHONPATH", str(tmp_path))
    monkeypatch.setenv("COQLIB", str(tmp_path))
    assert run_proofs(tmp_path).failure == "prove.py ended with 1: 1 False"


def test_without_the_script(tmp_path: Path) -> None:
    assert run_proofs(tmp_path) == ProofRun(failure="proofs/coq/ is not here")


def test_a_theorem_that_the_run_did_not_show(coq: Path) -> None:
    not_run(coq, ProofRun(frozenset(NAMES) - {"IWC"}, ""), "prove.py did not prove IWC")


def test_without_the_folder(tmp_path: Path) -> None:
    found = formal_proof(["IWC"], PASSED, tmp_path / "coq")
    assert not found.run
    assert found.theorems == (("IWC", "", ""),)


def test_an_unknown_theorem_is_an_error(coq: Path) -> None:
    with pytest.raises(ValueError, match="no IWC_side is stated"):
        formal_proof(["IWC_side"], PASSED, coq)  # a definition with arguments, no statement


@pytest.mark.parametrize("identifier", CARRIED)
def test_a_claim_that_is_carried(coq: Path, identifier: str) -> None:
    found = with_formal_proof(entry(identifier), PASSED, coq)
    assert found.verdict.outcome is Outcome.PROVED
    assert found.rung is Rung.FORMAL
    assert found.formal is not None
    assert found.formal.run
    assert [run for _, _, run in found.routes] == [True, True, True]
    against = with_formal_proof(entry(identifier, agrees=False), PASSED, coq)
    assert against.verdict.outcome is Outcome.UNDECIDED


@pytest.mark.parametrize("identifier", CONTRADICTED)
def test_a_claim_that_is_contradicted(coq: Path, identifier: str) -> None:
    found = with_formal_proof(entry(identifier, agrees=False), PASSED, coq)
    assert found.verdict.outcome is Outcome.REFUTED
    assert found.rung is Rung.FORMAL
    against = with_formal_proof(entry(identifier), PASSED, coq)
    assert against.verdict.outcome is Outcome.UNDECIDED


def test_the_folder_is_that_of_the_repository() -> None:
    assert COQ == REPOSITORY / "proofs" / "coq"


def test_other_entries_stay_as_they_are(coq: Path) -> None:
    assert with_formal_proof(entry("A-th3"), PASSED, coq) == entry("A-th3")


def test_the_entries_and_the_statements_exist() -> None:
    known = {identifier for part in PARTS.values() for identifier in part}
    assert {*CARRIED, *CONTRADICTED} <= known
    assert {statement_of(name)[1] for name in NAMES} == {"Statement.v", "StatementCompliant.v", "StatementFlight.v"}
    assert statement_of("sign_certificate")[1] == "StatementCertificate.v"


def test_the_files_of_statements_are_those_that_the_proofs_are_held_against(coq: Path) -> None:
    """A file more in the folder is one more to read; prove.py has its own list."""
    listed = re.search(r"^STATED_IN = \((.*?)^\)", (COQ / "prove.py").read_text(encoding="utf-8"), re.M | re.S)
    assert listed
    assert stated_in() == sorted(f"{name}.v" for name in re.findall(r'"(\w+)"', listed[1]))
    (coq / "StatementMore.v").write_text("Definition more : Prop := True.\n", encoding="utf-8")
    assert statement_of("more", coq) == ("Definition more : Prop := True.", "StatementMore.v")
