"""A statement of the ledger is a sentence about the mechanics: not a heading, and without labels of the source."""

from __future__ import annotations

import json
import re

import pytest
from paper.paper_citations import DATA

from gspot_verified.paper.checks.entry import Entry
from gspot_verified.paper.checks.paper import with_printed_numbers
from gspot_verified.paper.claims import paper_claims

VERBS = (
    "is are was has have accelerates attract becomes begins belong can change changes connects controls couples "
    "depend depends differ differs diverge do does dominates ends enters exists explains falls fits follow follows "
    "gives goes grows hold holds involves lasts leads leaves lie lies lift lifts lose loses makes matches moves name "
    "occurs reach reaches recover relaxes satisfies satisfy scales settles shows span stands stays switches take "
    "takes tend tends turn turns vanish vanishes were"
)
"""The finite verbs of the ledger; a statement, or a claim, with another one adds it here."""
VERB = re.compile(rf"\b(?:{VERBS.replace(' ', '|')})\b")
WORDS = {"beta", "example", "exponents", "expansion", "distinguished", "Coulomb"}
"""Labels of the source that are words, and numbers, of sections."""


def is_a_sentence(statement: str) -> bool:
    """Whether each of its parts has a verb of its own, and it begins with no label."""
    parts = re.sub(r"\band that\b[^;]*|\([^()]*\)", "", statement).split(";")
    return all(VERB.search(part) for part in parts) and not re.match(r"(?:eqs?|fig|line)s?\b", statement, re.IGNORECASE)


def labels() -> set[str]:
    """The labels of the source, whole and without what stands before their colon, that are no words."""
    numbers = json.loads(DATA.read_text(encoding="utf-8"))["numbers"]
    found = {name for label in numbers for name in (label, label.partition(":")[2] or label)}
    return {name for name in found - WORDS if not re.fullmatch(r"[\d.]+", name)}


def left_over(text: str, names: set[str]) -> list[str]:
    """The labels that a text still has."""
    return [name for name in re.findall(r"(?<![\w:/-])[A-Za-z][\w:]*(?![\w:-])", text) if name in names]


def beyond_its_runs(note: str, own: bool, on_runs: set[str]) -> list[str]:
    """The sentences of a note that repeat an entry on runs, or speak of the model system in one, without the runs."""
    found = []
    for sentence in re.split(r"(?<=\.)\s+(?=[A-Z])", note):
        named = any(re.search(rf"(?<![\w-]){re.escape(name)}(?![\w-])", sentence) for name in on_runs)
        if (named or (own and "the model system" in sentence)) and not re.search(r"\bruns?\b", sentence):
            found.append(sentence)
    return found


def test_a_note_on_runs_says_so(whole_ledger: list[Entry]) -> None:
    """What is shown of some runs is not shown of a system."""
    on_runs = {entry.identifier for entry in whole_ledger if re.search(r"\bruns?\b", entry.statement)}
    assert {"3-after-lift-off", "3-separatrix"} <= on_runs
    notes = {
        entry.identifier: beyond_its_runs(entry.note, entry.identifier in on_runs, on_runs) for entry in whole_ledger
    }
    assert {name: found for name, found in notes.items() if found} == {}


def shows_a_drawing(statement: str) -> bool:
    """Whether a statement is on what a figure shows, and names none of the paper's words as the witness.

    No figure is at hand: where caption and text say different things, neither of them is shown to be wrong.
    """
    drawn = re.search(r"\bFigures? \d", statement) and re.search(r"\b(?:line|curve|colour)s?\b", statement)
    return bool(drawn) and not re.search(r"\b(?:captions?|text)\b", statement)


def test_what_a_figure_shows_is_by_the_papers_words(whole_ledger: list[Entry]) -> None:
    assert [entry.statement for entry in whole_ledger if shows_a_drawing(entry.statement)] == []


@pytest.mark.parametrize(
    ("statement", "found"),
    [
        ("The distinguished trajectory is the dashed red line of Figures 3 and 4", True),
        ("The distinguished trajectory is the dashed red line of Figures 3 and 4, as their captions say", False),
        ("Each of the panels of Figure 6 has the trivial solution as a dot-dashed line", True),
        ("By the text each of the panels of Figure 6 has the trivial solution as a dot-dashed line", False),
        ("The α's of Figure 6 are in Case I", False),
    ],
)
def test_what_is_a_drawing(statement: str, found: bool) -> None:
    assert shows_a_drawing(statement) is found


def test_every_statement_is_a_sentence(whole_ledger: list[Entry]) -> None:
    assert [entry.statement for entry in whole_ledger if not is_a_sentence(entry.statement)] == []


def test_every_claim_is_a_sentence() -> None:
    """A heading says nothing that could be proved or refuted."""
    assert [claim.words for claim in paper_claims() if not is_a_sentence(claim.words)] == []


def test_no_label_of_the_source_is_left_in_the_texts_of_an_entry(whole_ledger: list[Entry]) -> None:
    names = labels()
    assert {"modelSysTEliminated", "pbc", "varsim1", "t01", "th:5"} <= names
    found = {}
    for entry in whole_ledger:
        texts = [entry.statement, entry.corrected, entry.note]
        texts += [text for check in entry.checks for text in (check.what, check.finding)]
        if wrong := [name for text in texts for name in left_over(text, names)]:
            found[entry.identifier] = wrong
    assert found == {}


def bare_names(source: str) -> list[str]:
    """Greek letters of a LaTeX text by name, without their backslash."""
    return re.findall(
        r"(?<![A-Za-z\\])(?:\d*)((?:alpha|beta|epsilon|delta|kappa|tau|lambda|nu|mu|chi)(?![a-z]))", source
    )


def test_the_printed_form_of_an_entry_has_greek_letters(whole_ledger: list[Entry]) -> None:
    assert {entry.identifier: wrong for entry in whole_ledger if (wrong := bare_names(entry.source))} == {}


@pytest.mark.parametrize(
    ("source", "wrong"),
    [
        (r"\gamma\to 2beta/3", ["beta"]),
        (r"\gamma\to (2beta+2)/3, alpha_1", ["beta", "alpha"]),
        (r"\gamma\to (2\beta+2)/3,\ \mu b", []),
        (r"\text{number}", []),
    ],
)
def test_which_names_are_bare(source: str, wrong: list[str]) -> None:
    assert bare_names(source) == wrong


@pytest.mark.parametrize(
    ("text", "passes"),
    [
        ("eq. (52) in the fast time ds = δ ds_f", False),
        ("Eq. (52) is the equation of the fast time", False),
        ("The slow equation of the inner scale", False),
        ("The quantities of Sec. 2 for the extended example", False),
        ("The alphas for β = 7/3, κ = 0, rounded; they are in Case III", False),
        ("The characteristic polynomial of M, and that it is the one of Section 4", False),
        ("α_1 at the G-spot, for all β, κ, m_1, l, g", False),
        ("Step 2: the spaces of r_b", False),
        ("Theorem 5: the three formulas", False),
        ("In rigid slip, dt = p ds: dp/ds = α_1 p", False),
        ("", False),
        ("In the inner time s eq. (46) becomes eq. (52)", True),
        ("For p < 0 the three roots are real; exactly one is positive", True),
    ],
)
def test_what_is_a_sentence(text: str, passes: bool) -> None:
    assert is_a_sentence(text) is passes


@pytest.mark.parametrize(
    ("text", "left"),
    [
        ("along modelSysTEliminated, th:1 and eq:pbc", ["modelSysTEliminated", "th:1", "eq:pbc"]),
        (with_printed_numbers("along eq. pbc of Theorem 1 (th:1), fig. varsim2"), ["th:1"]),
        ("the exponents of the expansion with Coulomb's law, beta", []),
        ("entry A-t01, tests/varsim1 and 3-varsim1a-1", []),
    ],
)
def test_which_labels_are_left(text: str, left: list[str]) -> None:
    assert left_over(text, labels()) == left


@pytest.mark.parametrize(
    ("note", "own", "found"),
    [
        ("Contact is open. In the model system it is not lost again (3-a).", False, 1),
        ("In the runs of the model system it is not lost again (3-a).", False, 0),
        ("In the model system it is not.", True, 1),
        ("In the model system it is not.", False, 0),
        ("That it ends soon: 3-a. Its length: 3-a-b.", False, 1),
    ],
)
def test_what_a_note_on_runs_must_say(note: str, own: bool, found: int) -> None:
    assert len(beyond_its_runs(note, own, {"3-a"})) == found
