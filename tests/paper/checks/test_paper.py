"""The printed numbers and the quoted lines that the ledger ships are those of the paper's source."""

from __future__ import annotations

import hashlib
import json
import re
from pathlib import Path

import pytest
from paper.paper_citations import DATA, citation, name_of, source_data, text_of
from paper.paper_reader import Document, read

from gspot_verified.paper.checks import paper
from gspot_verified.paper.checks.entry import Entry

ROOT = Path(__file__).resolve().parents[3]
PAPER = ROOT.parent / "shared" / "paper.tex"
AGAIN = "write the data again: PYTHONPATH=.:tests python -m paper.paper_citations ../shared/paper.tex"
needs_the_paper = pytest.mark.skipif(not PAPER.is_file(), reason="the paper's source is not beside the repository")

SOURCE = r"""
\documentclass{article}
\newtheorem{theorem}{Theorem}
\newtheorem{lemma}[theorem]{Lemma}
\newtheorem{observation}{Observation}[section]
\newcommand{\beq}{\begin{equation}}
\newcommand{\eeq}{\end{equation}}
\begin{document}
\section{One}\label{sec:one}
\beq a=1 \label{first} \eeq % \begin{equation} in a comment \label{none} \end{equation}
\begin{align}
  x &= \begin{cases} 1 \\ 2 \end{cases} \label{row1} \\
  y &= 2 \nonumber \\
  z &= \sqrt{2} \notag \label{silent} \\[2pt]
  w &= 3 \tag{$*$} \label{tagged} \\
  u &= 4
  \label{row5}
\end{align}
\begin{equation*} 1=1 \label{starred} \end{equation*}
\[ 2=2 \] $$ 3=3 $$
\begin{subequations}\label{both}
\begin{align} p \label{suba} \\ q \label{subb} \end{align}
\begin{equation} r \label{subc} \end{equation}
\end{subequations}
\begin{theorem}[A name] \label{th:a} \begin{equation} s \label{inside} \end{equation} \end{theorem}
\subsection{Sub} \label{sub}
\begin{lemma} \label{th:b} 100\% of it. \end{lemma}
\begin{figure} \caption{x} \label{fig:a} \end{figure}
\begin{table} \caption{x} \label{tab:a} \end{table}
\begin{observation} \label{rem:a} x \end{observation}
\section*{No number}
\begin{eqnarray} a&=&b \label{array1} \\ c&=&d \label{array2} \end{eqnarray}
\begin{multline} a \\ b \label{multi} \end{multline}
\begin{gather} a \\ b \label{gather2} \end{gather}
\section{Two} \label{sec:two}
\begin{theorem} \label{th:c} x \end{theorem}
\begin{observation} \label{rem:b} x \end{observation}
\appendix
\numberwithin{equation}{section}
\section{App} \label{A:a}
\begin{equation} a \label{eq:app} \end{equation}
\subsection{App sub} \label{A:sub}
\section{Bpp} \label{A:b}
\begin{equation} a \label{eq:bpp} \end{equation}
\begin{lemma} \label{th:d} x \end{lemma}
\end{document}
"""
PRINTED = {
    "sec:one": "1", "first": "1", "row1": "2", "silent": None, "tagged": "$*$", "row5": "3", "starred": None,
    "both": "4", "suba": "4a", "subb": "4b", "subc": "4c", "th:a": "1", "inside": "5", "sub": "1.1", "th:b": "2",
    "fig:a": "1", "tab:a": "1", "rem:a": "1.1", "array1": "6", "array2": "7", "multi": "8", "gather2": "10",
    "sec:two": "2", "th:c": "3", "rem:b": "2.1", "A:a": "A", "eq:app": "A.1", "A:sub": "A.1", "A:b": "B",
    "eq:bpp": "B.1", "th:d": "4",
}  # fmt: skip
"""What LaTeX prints (amsmath, amsthm); None for a row without a number (``\\ref`` gives another object's there)."""


@pytest.fixture(scope="module")
def entries(whole_ledger: list[Entry]) -> list[Entry]:
    return whole_ledger


@pytest.fixture(scope="module")
def document() -> Document:
    return read(PAPER.read_text(encoding="utf-8"))


def test_the_reader_counts_as_latex_does() -> None:
    found = {item.label: item.number for item in read(SOURCE).numbered if item.label}
    assert found == PRINTED


def test_the_reader_finds_rows_and_displays() -> None:
    found = read(SOURCE)
    assert found.labelled("row1").first == found.labelled("row1").last == 12
    assert (found.labelled("row5").first, found.labelled("row5").last) == (16, 17)
    assert found.labelled("first").first == 10
    assert found.labelled("th:a").kind == "Theorem"
    with pytest.raises(KeyError, match="0 labels"):
        found.labelled("none")


def test_names_of_objects() -> None:
    found = read(SOURCE)
    names = {label: name_of(found.labelled(label)) for label in ("th:b", "eq:app", "fig:a", "sub", "A:a", "silent")}
    assert list(names.values()) == ["Lemma 2", "eq. (A.1)", "Figure 1", "Section 1.1", "Appendix A", None]


def test_a_second_label_is_refused() -> None:
    with pytest.raises(ValueError, match="a second label"):
        read(SOURCE.replace(r"\label{sub}", r"\label{sub}\label{again}"))


@needs_the_paper
def test_the_data_are_those_of_the_paper(entries: list[Entry]) -> None:
    text = PAPER.read_text(encoding="utf-8")
    assert hashlib.sha256(text.encode()).hexdigest() == json.loads(DATA.read_text(encoding="utf-8"))["sha256"]
    assert text_of(source_data(text, [e.label for e in entries])) == DATA.read_text(encoding="utf-8"), AGAIN


@needs_the_paper
def test_quotations_are_lines_of_the_paper(entries: list[Entry]) -> None:
    lines = PAPER.read_text(encoding="utf-8").split("\n")
    for entry in entries:
        for quotation in entry.cited.quotations:
            assert quotation.latex == "\n".join(lines[quotation.first - 1 : quotation.last])
        for number in re.findall(r"lines? (\d+)", entry.label):
            assert any(q.first <= int(number) <= q.last for q in entry.cited.quotations), entry.identifier


@needs_the_paper
def test_theorems_share_one_counter(document: Document) -> None:
    labels = ("th:1", "thm:expansion", "th:3", "th:4", "th:5")
    assert [name_of(document.labelled(label)) for label in labels] == [
        "Theorem 1", "Lemma 2", "Theorem 4", "Theorem 5", "Theorem 6",
    ]  # fmt: skip
    assert [paper.printed_number(label) for label in labels] == [name_of(document.labelled(label)) for label in labels]


@needs_the_paper
@pytest.mark.parametrize(
    ("label", "printed", "lines"),
    [
        ("th:5, eq:blarge1", "Theorem 6, eq. (A.11)", [(2474, 2478)]),
        ("th:5", "Theorem 6", [(2465, 2489)]),
        ("th:3, eq:btau", "Theorem 4, eq. (A.1)", [(2370, 2373), (2378, 2390)]),
        ("eqs. specialX to specialL", "eqs. (70) to (76)", [(1397, 1403)]),
        ("eqs. modelSysDistP, modelSysDistB", "eqs. (27) and (28)", [(602, 603)]),
        ("lines 1777 to 1842", "Corollary 3", [(1777, 1842)]),
        ("line 2022", "eq. (108)", [(2022, 2022)]),
        ("line 1250", "", [(1249, 1252)]),
        ("line 1108", "", [(1107, 1109)]),
        ("lines 1253 and 1309", "", [(1253, 1255), (1308, 1310)]),
        ("line 1853", "", [(1853, 1858)]),
        ("tab:exponents(b)", "Table 1", [(881, 904)]),
        ("eq:modelSysTEliminated", "", [(983, 985)]),
    ],
)
def test_labels_of_entries_are_read(document: Document, label: str, printed: str, lines: list[tuple[int, int]]) -> None:
    found = citation(document, label)
    assert found["printed"] == printed
    assert [(quotation["first"], quotation["last"]) for quotation in found["quotations"]] == lines


@needs_the_paper
def test_an_unknown_label_is_refused(document: Document) -> None:
    with pytest.raises(ValueError, match="'eq:nonsense' is no label of the source"):
        citation(document, "eq:nonsense")


def test_every_label_of_the_ledger_is_in_the_data(entries: list[Entry]) -> None:
    assert {e.label for e in entries} == set(json.loads(DATA.read_text(encoding="utf-8"))["citations"]), AGAIN
    assert all(entry.verbatim for entry in entries)


def test_a_label_that_the_data_do_not_hold_cites_nothing() -> None:
    assert paper.citation("no such label") == paper.Citation()
    with pytest.raises(KeyError):
        paper.printed_number("th:2")


@pytest.mark.parametrize(
    ("text", "wanted"),
    [
        ("put into eq. udot: it vanishes", "put into eq. (33): it vanishes"),
        ("eqs. xdot, udot, newex1 to newex4", "eqs. (31), (33), (35) to (38)"),
        ("t01-t03 and bsmall1", "eqs. (A.8)-(A.10) and (A.5)"),
        ("eq:btau", "eq. (A.1)"),
        ("Eq. de_inner", "Eq. (53)"),
        ("entry A-t01, beta, tlarge", "entry A-t01, beta, tlarge"),
        ("eq. modelSysTEliminated", "eq. modelSysTEliminated"),
        ("modelSysDevInner, not modelSysDevInnermost", "eq. (52), not modelSysDevInnermost"),
        ("th:3 and thm:expansion, Theorem 6 (th:5)", "Theorem 4 and Lemma 2, Theorem 6 (th:5)"),
        ("Coulomb friction, β = 3/2", "Coulomb friction, β = 3/2"),
        ("Coulomb friction, beta and xdot as words", "Coulomb friction, beta and xdot as words"),
        ("sec:4 and fig:varsim1 of eq:modelSysTEliminated", "sec:4 and fig:varsim1 of eq:modelSysTEliminated"),
    ],
)
def test_labels_in_texts_become_printed_numbers(text: str, wanted: str) -> None:
    assert paper.with_printed_numbers(text) == wanted


def test_theorems_are_named_by_printed_number_and_label() -> None:
    """From Theorem 2 on a number alone is taken for the label's: texts say "Theorem 6 (th:5)"."""
    files = [
        p for folder in ("gspot_verified", "proofs") for p in (ROOT / folder).rglob("*") if p.suffix in (".py", ".md")
    ]
    files = [path for path in [*files, ROOT / "README.md", ROOT / "CHANGELOG.md"] if path.name != "paper.py"]
    found = [
        (path.name, number, label)
        for path in files
        for number, label in re.findall(r"(Theorems? [2-9])(?: \(`?(th:\d)`?\))?", path.read_text(encoding="utf-8"))
    ]
    assert len(found) > 5
    assert [row for row in found if row[2] == "" or paper.printed_number(row[2]) != row[1]] == []


def test_places_are_named_by_the_numbers_of_the_paper() -> None:
    assert paper.place(1192, 1197) == "Sec. 4.3, eq. (55)"
    assert paper.place(1395, 1405) == "Sec. 5.1, eqs. (70) to (76)"
    assert paper.place(1160, 1162) == "Sec. 4.3, after eq. (52)"
    assert paper.place(332, 335) == "Sec. 1.3", "no equation stands before it in its section"
    assert paper.place(734, 737) == "Sec. 3.1, Figure 6"
    assert paper.place(2465, 2489) == "Appendix A, Theorem 6"
    assert paper.place(1, 2) == "", "before the first section"


@needs_the_paper
def test_the_places_are_those_of_the_paper(document: Document) -> None:
    found = [(item.first, item.last, name_of(item)) for item in document.numbered if item.number is not None]
    assert paper._places() == found
    assert paper.paper_hash() == hashlib.sha256(PAPER.read_bytes()).hexdigest()


@pytest.mark.parametrize("name", ["paper_citations", "sentences"])
def test_a_file_that_says_how_to_run_it_does_something_when_it_is_run(name: str) -> None:
    text = (ROOT / "tests" / "paper" / f"{name}.py").read_text(encoding="utf-8")
    assert f"python -m paper.{name}" in text
    assert '\nif __name__ == "__main__":\n' in text
