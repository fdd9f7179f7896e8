"""Formal proofs in the ledger: said to be run only with a record of these very sources, and never without."""

from __future__ import annotations

import hashlib
import json
import shutil
from collections.abc import Callable
from pathlib import Path

import pytest

from gspot_verified import Outcome
from gspot_verified.ledger.entry import Check, Entry, Rung, conclude
from gspot_verified.ledger.formal_proof import AXIOMS, COQ, RECORD, formal_proof, statement_of
from gspot_verified.ledger.formal_routes import CARRIED, CONTRADICTED, with_formal_proof
from gspot_verified.ledger.verify import PARTS

REPOSITORY = Path(__file__).resolve().parents[2]
NAMES = sorted(
    {name for names in CARRIED.values() for name in names} | {n for ns, _ in CONTRADICTED.values() for n in ns}
)


@pytest.fixture
def place(tmp_path: Path) -> tuple[Path, Path]:
    """A copy of the sources, and the record of a run on them."""
    coq, record = tmp_path / "coq", tmp_path / "record.json"
    shutil.copytree(COQ, coq)
    sources = {path.name: hashlib.sha256(path.read_bytes()).hexdigest() for path in coq.glob("*.v")}
    theorems = {name: sorted(AXIOMS) for name in NAMES}
    record.write_text(json.dumps({"coq": "8.16.1", "sources": sources, "theorems": theorems}))
    return coq, record


def entry(identifier: str, agrees: bool = True) -> Entry:
    checks = (Check(Rung.EXACT, "one", agrees, "found"), Check(Rung.BALLS, "two", agrees, "found"))
    return Entry(identifier, "line 1", "Section 4.5", "x", "y", checks, conclude("y", checks))


def test_the_sources_that_were_proved(place: tuple[Path, Path]) -> None:
    found = formal_proof(["IWC"], *place)
    assert found.run
    assert found.state == "run here, by make prove"
    [(name, statement, file)] = found.theorems
    assert (name, file) == ("IWC", "Statement.v")
    assert statement.endswith("forall b theta, 0 < b < 1 -> is_Theta b theta -> forall t, Derive theta t < 0.")


def changed_source(coq: Path) -> None:
    with (coq / "Calculus.v").open("a") as file:
        file.write("\n")


def new_source(coq: Path) -> None:
    (coq / "More.v").write_text("\n")


@pytest.mark.parametrize("spoil", [changed_source, new_source])
def test_other_sources_were_not_run(place: tuple[Path, Path], spoil: Callable[[Path], None]) -> None:
    spoil(place[0])
    not_run(*place)


@pytest.mark.parametrize(
    "text",
    [
        None,
        "{",
        "[]",
        {"theorems": {"count_law": []}},
        {"theorems": {"IWC": ["Mine.axiom"]}},
        {"theorems": []},
        {"sources": {}},
        {"sources": None},
    ],
)
def test_another_record_shows_nothing(place: tuple[Path, Path], text: str | dict[str, object] | None) -> None:
    _, record = place
    if isinstance(text, dict):
        record.write_text(json.dumps(json.loads(record.read_text()) | text))
    elif text is None:
        record.unlink()
    else:
        record.write_text(text)
    not_run(*place)


def not_run(coq: Path, record: Path) -> None:
    found = formal_proof(["IWC"], coq, record)
    assert not found.run
    assert found.state.startswith("not run here: ")
    before = entry("S-iwc")
    after = with_formal_proof(before, coq, record)
    assert after.checks == before.checks
    assert after.verdict == before.verdict
    assert after.rung is Rung.EXACT
    assert after.routes[-1] == ("formal proof", "IWC", False)


def test_without_the_folder(tmp_path: Path) -> None:
    found = formal_proof(["IWC"], tmp_path / "coq", tmp_path / "record.json")
    assert not found.run
    assert found.theorems == (("IWC", "", ""),)


def test_an_unknown_theorem_is_an_error(place: tuple[Path, Path]) -> None:
    with pytest.raises(ValueError, match="no IWC_side is stated"):
        formal_proof(["IWC_side"], *place)  # a definition with arguments, no statement


@pytest.mark.parametrize("identifier", CARRIED)
def test_a_claim_that_is_carried(place: tuple[Path, Path], identifier: str) -> None:
    found = with_formal_proof(entry(identifier), *place)
    assert found.verdict.outcome is Outcome.PROVED
    assert found.rung is Rung.FORMAL
    assert found.formal is not None
    assert found.formal.run
    assert [run for _, _, run in found.routes] == [True, True, True]
    against = with_formal_proof(entry(identifier, agrees=False), *place)
    assert against.verdict.outcome is Outcome.UNDECIDED


@pytest.mark.parametrize("identifier", CONTRADICTED)
def test_a_claim_that_is_contradicted(place: tuple[Path, Path], identifier: str) -> None:
    found = with_formal_proof(entry(identifier, agrees=False), *place)
    assert found.verdict.outcome is Outcome.REFUTED
    assert found.rung is Rung.FORMAL
    against = with_formal_proof(entry(identifier), *place)
    assert against.verdict.outcome is Outcome.UNDECIDED


def test_the_record_is_where_make_prove_leaves_it() -> None:
    assert COQ == REPOSITORY / "proofs" / "coq"
    assert RECORD == REPOSITORY / "build" / "coq" / "record.json"
    assert "build/coq/record.json" in (COQ / "prove.py").read_text(encoding="utf-8")


def test_other_entries_stay_as_they_are(place: tuple[Path, Path]) -> None:
    assert with_formal_proof(entry("A-th3"), *place) == entry("A-th3")


def test_the_entries_and_the_statements_exist() -> None:
    known = {identifier for part in PARTS.values() for identifier in part}
    assert {*CARRIED, *CONTRADICTED} <= known
    assert {statement_of(name)[1] for name in NAMES} == {"Statement.v", "StatementCompliant.v", "StatementFlight.v"}
    assert statement_of("sign_certificate")[1] == "StatementCertificate.v"
