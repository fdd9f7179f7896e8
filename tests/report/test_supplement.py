"""The supplement: errata and theorems as LaTeX, from the entries of a report and from nothing else."""

from __future__ import annotations

import json
import re
import shutil
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from paper.refuted import REFUTED

from gspot_verified.paper.checks.entry import Check, Entry, Rung, Section
from gspot_verified.paper.checks.formal_proof import FormalProof, Theorem
from gspot_verified.paper.checks.paper import paper_hash
from gspot_verified.paper.verify import PARTS
from gspot_verified.report import write
from gspot_verified.report.data import report_data
from gspot_verified.report.site import new_results
from gspot_verified.report.supplement import ERRATA_PAGES, PAGES, THEOREMS, supplement
from gspot_verified.report.write import PROGRAM, Pdf, pdf_of

needs_latex = pytest.mark.skipif(shutil.which(PROGRAM) is None, reason=f"there is no {PROGRAM} here")
HOSTILE = r"}\input{/etc/passwd} \end{document} 50 % & #1 $ ^^5c é ☃ \\ _^~<>"


def refuted(identifier: str, label: str, source: str, corrected: str) -> Entry:
    checks = [Check(Rung.EXACT, what, False, "f") for what in ("one", "another")]
    return Section("Section 4").settled(identifier, label, source, "says it", *checks, corrected=corrected)


def proved(identifier: str, label: str) -> Entry:
    checks = [Check(Rung.EXACT, what, True) for what in ("proofs/signs.md: one", "another")]
    return Section("Section 4.5").settled(identifier, label, "x", "For 0 < β < 1, dΘ/dτ < 0", *checks)


ENTRIES = [
    refuted("4-order", "line 986", r"\text{3rd-order equation for } b(t)", "fourth order in t"),
    refuted("S-gamma-intervals", "line 1269", r"\Gamma(-\beta)<0", "Γ(-β) > 0"),
    refuted("3-table-1-one-series", "lines 844 to 847", r"\text{a series}", "the series differ."),
    refuted("3-table-1-y-1_2", "line 894 (β = 1/2)", r"\gamma=1.6538", "1.6653"),
    replace(
        proved("S-iwc", "line 1287"),
        formal=FormalProof((Theorem("IWC", "Definition IWC : Prop := \\end{x} é.", "Statement.v"),), False, "not run"),
    ),
]


@pytest.fixture(scope="module")
def texts() -> dict[str, str]:
    return supplement(data(ENTRIES))


def data(entries: list[Entry]) -> dict[str, Any]:
    found: dict[str, Any] = json.loads(json.dumps(report_data(entries, [])))
    return found


def items(text: str) -> list[str]:
    return re.findall(r"^\\erratum\{.*$", text, re.M)


def test_the_items_are_sorted_by_consequence_and_a_table_is_one(texts: dict[str, str]) -> None:
    found = items(texts["errata.tex"])
    assert [re.findall(r"\{([^{}]*)\}$", item)[0] for item in found] == [
        "S-gamma-intervals",
        r"3-table-1-one-series, 3-table-1-y-1\_2",
        "4-order",
    ]
    titles = re.findall(r"\\normalsize ([^}]*)\}", texts["errata.tex"])
    assert [title.split()[0] for title in titles] == ["Errors", "Local", "Misprints"]


def test_an_item_says_where_what_and_why(texts: dict[str, str]) -> None:
    assert items(texts["errata.tex"])[2] == (
        r"\erratum{Sec. 4 (l.~986)}{3rd-order equation for $b(t)$ \becomes{}fourth order in $t$.}"
        r"{The equation contains the fourth derivative of $b$; three is its degree in $\varepsilon$.}{4-order}"
    )
    assert "{Table 1(a) (l.~" in items(texts["errata.tex"])[1]
    assert r"a series \becomes{}the series differ. $\gamma=1.6538$ \becomes{}1.6653." in items(texts["errata.tex"])[1]


def test_what_the_numbers_are_is_said(texts: dict[str, str]) -> None:
    for said in (
        "3 items",
        "10th May 2017",
        "doi:10.48550/arXiv.1707.08343",
        paper_hash()[:16],
        "was not compared",
        "verify NAME",
    ):
        assert said in texts["errata.tex"], said
    assert texts["errata.tex"].lower().count("doi") == 1, "the journal's is not known here"


def test_both_texts_say_that_they_show_a_file(texts: dict[str, str]) -> None:
    for text in texts.values():
        assert "This text shows what report.json says: writing it checks nothing." in text


def test_a_report_without_errata_says_so() -> None:
    found = supplement(data([proved("S-iwc", "line 1287")]))["errata.tex"]
    assert "No statement of the paper is refuted." in found
    assert items(found) == []


def test_a_theorem_has_its_verdict_its_page_and_its_formal_statement(texts: dict[str, str]) -> None:
    text = texts["theorems.tex"]
    assert r"For $0 < \beta < 1$, $d\Theta/d\tau < 0$." in text
    assert "proved; Sec. 4.5, after eq. (58). proof: proofs/signs.md. formal, not run here: IWC" in text
    assert "Their proofs were not run." in text
    assert "Definition IWC : Prop := \\end{x} \\xe9." in text
    assert "The number of real zeros" in text
    assert r"count\_law\_with\_signs" in text


def test_a_refuted_statement_is_no_theorem() -> None:
    entry = refuted("4-unique-smooth", "lines 1015 to 1018", "x", "not among smooth functions")
    text = supplement(data([entry]))["theorems.tex"]
    assert r"says it: \textbf{not as printed}. Correct: not among smooth functions." in text


def test_every_theorem_is_an_entry_of_the_ledger() -> None:
    known = {identifier for part in PARTS.values() for identifier in part}
    assert {name for _, names in THEOREMS for name in names} <= known


def test_what_is_new_is_in_it() -> None:
    """Each result of the page that says what is new, by an entry or by its proof page; and the rule for mechanisms."""
    listed = {name for _, names in THEOREMS for name in names}
    missing = [
        result.key
        for result in new_results()
        if not listed & set(result.entries) and not {passage.page for passage in result.passages} & set(PAGES)
    ]
    assert missing == []
    assert "5-rule" in listed


def test_a_formal_statement_cannot_end_its_frame() -> None:
    theorem = Theorem("IWC", r"Definition IWC : Prop := \end{verbatim}\input{x}.", "Statement.v")
    entry = replace(proved("S-iwc", "line 1287"), formal=FormalProof((theorem,), False, "not run"))
    text = supplement(data([entry]))["theorems.tex"]
    assert r"\input" not in text
    assert "its text is not in this report" in text


@pytest.fixture(scope="module")
def hostile() -> dict[str, str]:
    entry = replace(refuted("4-order", "line 986", HOSTILE, HOSTILE), identifier=HOSTILE, label=HOSTILE)
    theorem = replace(proved("S-iwc", "line 1287"), statement=HOSTILE, corrected=HOSTILE)
    formal = FormalProof((Theorem(HOSTILE, HOSTILE, HOSTILE),), False, HOSTILE)
    return supplement(data([entry, replace(theorem, formal=formal)]))


def test_texts_of_the_data_are_text(texts: dict[str, str], hostile: dict[str, str]) -> None:
    for name, text in [*texts.items(), *hostile.items()]:
        assert text.isascii(), name
        outside = re.sub(r"\\begin\{verbatim\}.*?\\end\{verbatim\}", "", text, flags=re.S)
        assert r"\input" not in outside, name
        assert outside.count(r"\end{document}") == 1, name


@needs_latex
def test_latex_takes_the_errata(texts: dict[str, str]) -> None:
    found = pdf_of(texts["errata.tex"])
    assert (found.content[:4], found.pages) == (b"%PDF", 1)


@needs_latex
@pytest.mark.slow
def test_latex_takes_all_texts(texts: dict[str, str], hostile: dict[str, str]) -> None:
    for name, text in [*texts.items(), *hostile.items()]:
        found = pdf_of(text)
        assert found.content.startswith(b"%PDF"), (name, found.said)


@needs_latex
@pytest.mark.slow
def test_the_errata_of_the_paper_fit_on_two_pages_and_no_line_is_cut() -> None:
    entries = [build() for part in PARTS.values() for name, build in part.items() if name in REFUTED]
    assert len(entries) == len(REFUTED)
    for name, text in supplement(data(entries)).items():
        found = pdf_of(text)
        assert found.content.startswith(b"%PDF"), (name, found.said)
        if name == "errata.tex":
            assert 1 < found.pages <= ERRATA_PAGES
            wide = re.findall(r"Overfull \\hbox \(([\d.]+)pt too wide\)", found.said)
            assert all(float(width) < 2 for width in wide), wide
            assert "U+" not in text
            assert r"\texttt{\textbackslash" not in text, "a printed form with an unknown command"


def test_the_files_are_written_and_a_missing_latex_is_said(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    (tmp_path / "report.json").write_text(json.dumps(data(ENTRIES)), encoding="utf-8")
    monkeypatch.setattr(write, "pdf_of", lambda _: Pdf(b"", "there is no pdflatex"))
    made = write.write_supplement(tmp_path / "report.json", tmp_path / "out")
    assert [path.name for path in made.files] == ["errata.tex", "theorems.tex"]
    assert made.warnings == ("errata.tex: there is no pdflatex", "theorems.tex: there is no pdflatex")
    assert (tmp_path / "out" / "errata.tex").read_text(encoding="ascii") == supplement(data(ENTRIES))["errata.tex"]


def test_the_pdf_is_written_and_a_third_page_is_said(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    (tmp_path / "report.json").write_text(json.dumps(data(ENTRIES)), encoding="utf-8")
    monkeypatch.setattr(write, "pdf_of", lambda _: Pdf(b"made", "", 3))
    made = write.write_supplement(tmp_path / "report.json", tmp_path / "out")
    assert [path.name for path in made.files] == ["errata.tex", "errata.pdf", "theorems.tex", "theorems.pdf"]
    assert made.warnings == ("errata.tex: 3 pages, more than 2",)
    assert (tmp_path / "out" / "errata.pdf").read_bytes() == b"made"


def test_a_file_that_is_no_report_is_refused(tmp_path: Path) -> None:
    (tmp_path / "report.json").write_text("{}", encoding="utf-8")
    with pytest.raises(ValueError, match=r"report\.json: report: this version reads schema"):
        write.write_supplement(tmp_path / "report.json", tmp_path / "out")
    assert not (tmp_path / "out").exists()
