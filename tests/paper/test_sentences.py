"""Every sentence of the paper is in a row of the list of claims, or makes none."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import pytest
from paper.sentences import CLASSES, DATA, IN_A_ROW, Sentence, marked, rows_of, sentences, text_of

from gspot_verified.paper.claims import PaperClaim, paper_claims

PAPER = Path(__file__).resolve().parents[3] / "shared" / "paper.tex"
UNIVERSAL = r"\b(?:all|every|always|for ever|from rest|runs?|states?|starts?)\b"
KEPT = DATA.read_text(encoding="utf-8")
PROPERTIES = {
    "non-local": "non-local",
    "confirms": "confirm",
    "dominat": "dominat",
    r"\bstable(?! manifold theory| eigen| direction)": "stab",
    "instantaneously": "instantaneously|can begin",
    "momentarily": "momentar",
    "immediately": "[Ii]mmediately",
    r"(?<!highly )\brapid(?:ly)?(?! changes| oscillat|ly oscillat)": "rapid|ε\\^",
    "uniformly": "uniformly",
    "(?:violently|wildly|highly) unstable": "of size 1/ε",
    "extreme sensitivity": "sensitivity.*not shown",
    "minimise": "have no smaller ones",
    "regular asymptotic expansion|regular power series": "regular",
    "sign throughout": "throughout",
    "typically": "where p = 0",
    "in accordance with": "in accordance|is β",
    "balanced by": "balance",
    "codimension(?!-two)": "codimension",
    "generalised hypergeometric": "hypergeometric|1F2",
    r"C\^\\infty": r"C\^∞",
    "theoretical predictions": "theoretical",
    "we can derive expressions": "procedure",
    "(?:always|all trajectories|all initial conditions)": UNIVERSAL,
    "goes directly": "directly",
    "quickly": "quick|within",
    "nearly perfect": "nearly",
    "infinitely smooth": "smooth",
    "smoothest": "smoothest",
    r"eventually\s+cause": "in the end",
    r"is very large": "very large",
    r"very large growth": "growth",
    r"very\s+slowly": "slowly",
    "fit each other very well": "%",
    "vanishingly": "vanish|ε\\^",
    "lead rapidly": r"rapid|ε\^",
    "corners": "corner",
    r"diverges\s+to\s+\$-": "-∞",
    "special polynomial classes": r"y_\(n-4\)",
    "three freedoms": "three freedoms",
    r"plays the role": "role",
    r"in the same way": "induction of",
    "transitions from slip": "transition",
    "further into": "further into",
    "is conceivable that in": "can be",
    "imperfections": "imperfections",
    r"mechanical\s+degrees\s+of\s+freedom": "degrees of freedom",
    "scales like": "scale",
    r"general class\s+of": "general class",
    "sensitivity": "sensitiv",
    r"smooth both in": "smooth both in",
}
"""A property that a sentence claims, where it is no part of a name, and how a row says it: qualifying words too."""


def found(text: str) -> list[tuple[int, int, str]]:
    return [(sentence.first, sentence.last, sentence.words) for sentence in sentences(text)]


def test_prose() -> None:
    text = r"""See Fig.~\ref{a}. We (i.e. you
and Leine {\em et al.}\/) ask: is $a. B$ so? It
is so, cf. Sec. 2 % not. This
and more."""
    assert found(text) == [(1, 1, "See Fig. ref a"), (2, 2, "We (i.e. you and"), (3, 4, "It is so, cf.")]


def test_displays() -> None:
    text = r"""We have
\beq
a = b. \label{x}
\eeq
Then
\begin{equation*} c, \end{equation*}
Here $d$, and
$$ e $$
This is new. Now
\begin{align} f \end{align}
\begin{align} g \end{align}
End."""
    lines = [(first, last) for first, last, _ in found(text)]
    assert lines == [(1, 4), (5, 8), (9, 9), (10, 10), (11, 11), (12, 12)]


def test_environments_items_captions_and_headings() -> None:
    text = r"""\begin{document}
\section{A title. It is not a sentence}
\label{sec}
\begin{figure}
\includegraphics{a. B}
\caption{One curve. Another \label{c}
curve}
\end{figure}
A theorem:
\begin{theorem}[Name. It]
Two are three
\end{theorem}
\begin{description}
\item[Case I.] first
\item[Case II.] second

\end{description}
\paragraph*{Example.} Third
\begin{tabular}{c}
1. A & 2. B
\end{tabular}
\end{document}
Nothing."""
    assert [(first, last) for first, last, _ in found(text)] == [
        *((6, 6), (7, 7), (9, 9), (11, 11), (14, 14), (15, 15), (18, 18), (19, 21))
    ]


def test_a_line_belongs_to_the_sentence_with_the_most_of_it() -> None:
    assert [
        row[:2] for row in found("A is a long sentence here. B is\nshort. C is\n a sentence with the end of it.")
    ] == [*((1, 1), (2, 2), (3, 3))]


def test_another_word_is_another_sum() -> None:
    one, other = sentences("It is so indeed, and now."), sentences("It is so indeed, and then.")
    assert one[0].words == other[0].words
    assert one[0].sum != other[0].sum


def test_the_file_can_be_written_and_read() -> None:
    assert text_of(marked(KEPT)) == KEPT
    with pytest.raises(ValueError, match="unpack"):
        marked("1\t2\tclaim\n")


def test_every_sentence_is_in_a_row_or_makes_no_claim() -> None:
    """And no row is there without a sentence."""
    kept, claims = marked(KEPT), paper_claims()
    assert len(kept) > 500
    assert {mark for _, mark in kept} - {IN_A_ROW, *CLASSES} == set()
    assert set(CLASSES) - {mark for _, mark in kept} == set()
    claiming = [sentence for sentence, mark in kept if mark == IN_A_ROW]
    assert [sentence for sentence in claiming if not rows_of(sentence, claims)] == []
    held = {claim for sentence in claiming for claim in rows_of(sentence, claims)}
    assert [claim for claim in claims if claim not in held] == []


def unsaid_properties(lines: Sequence[str], claims: Sequence[PaperClaim]) -> list[tuple[int, str]]:
    """The claiming sentences with a property that no row of theirs names."""
    found = []
    for sentence in (sentence for sentence, mark in marked(KEPT) if mark == IN_A_ROW):
        printed = " ".join(lines[sentence.first - 1 : sentence.last])
        said = " ".join(f"{claim.words} {claim.why}" for claim in rows_of(sentence, claims))
        found += [
            (sentence.first, word)
            for pattern, word in PROPERTIES.items()
            if re.search(pattern, printed) and not re.search(word, said)
        ]
    return found


def test_a_property_that_a_sentence_claims_is_named_by_its_row() -> None:
    if not PAPER.is_file():
        pytest.skip("the paper's source is not at hand")
    lines, claims = PAPER.read_text(encoding="utf-8").splitlines(), paper_claims()
    assert unsaid_properties(lines, claims) == []
    silent = [replace(claim, words="its roots") if claim.first == 1163 else claim for claim in claims]
    assert (1166, "stab") in unsaid_properties(lines, silent)
    at_last = [
        replace(claim, words="some lift off", why="") if claim.first in (775, 777) else claim for claim in claims
    ]
    assert {(775, "[Ii]mmediately"), (775, "rapid|ε\\^")} <= set(unsaid_properties(lines, at_last))


def without_a_work(lines: Sequence[str], claims: Sequence[PaperClaim]) -> list[int]:
    """The sentences of rows on other works that name none, in them or in the three lines before."""
    found = []
    for claim in (claim for claim in claims if claim.why == "a statement about other works"):
        for sentence in (sentence for sentence, _ in marked(KEPT) if rows_of(sentence, [claim])):
            if not any(r"\cite" in line for line in lines[sentence.first - 4 : sentence.last + 1]):
                found.append(sentence.first)
    return found


def test_a_statement_about_other_works_names_one() -> None:
    """What the paper holds to be possible is open; it is not said of another work."""
    if not PAPER.is_file():
        pytest.skip("the paper's source is not at hand")
    lines, claims = PAPER.read_text(encoding="utf-8").splitlines(), paper_claims()
    assert without_a_work(lines, claims) == []
    longer = [replace(claim, first=2288) if claim.first == 2291 else claim for claim in claims]
    assert without_a_work(lines, longer) == [2288]


def test_a_sentence_without_a_row_is_seen() -> None:
    claims = paper_claims()
    assert rows_of(Sentence(claims[0].first, claims[0].first, "", ""), claims) != []
    assert rows_of(Sentence(1, 40, "", ""), claims) == []


def test_the_sentences_are_those_of_the_source() -> None:
    if not PAPER.is_file():
        pytest.skip("the paper's source is not at hand")
    assert sentences(PAPER.read_text(encoding="utf-8")) == [sentence for sentence, _ in marked(KEPT)]
