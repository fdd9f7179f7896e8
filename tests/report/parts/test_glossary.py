"""The glossary: every term is where the paper has it, and linked where the start page first uses it."""

import re
from collections.abc import Sequence
from importlib import resources
from pathlib import Path

import pytest

from gspot_verified.paper.checks.entry import Rung
from gspot_verified.paper.claims import PaperClaim, Standing, paper_claims
from gspot_verified.report.data import report_data
from gspot_verified.report.parts.formulas import typeset
from gspot_verified.report.parts.glossary import glossary, linked_at_first_use
from gspot_verified.report.parts.latex import latex_formula
from gspot_verified.report.parts.proof_page import PROOFS
from gspot_verified.report.site import pages

PAPER = Path(__file__).resolve().parents[4] / "shared" / "paper.tex"
WANTED = {
    "g-spot", "c1", "side-number", "slow-manifold", "distinguished-trajectory", "canard", "cases", "beta", "inner-zone",
    "outer-zone", "impact-without-collision", "lift-off", "painleve-parameter", "free-normal-acceleration", "side",
    "certificate", "ball", "proved", "refuted", "undecided", "rung",
}  # fmt: skip
START = '<main id="main">{}</main>'
NOT_CHECKABLE = {
    "^a drawing; ": "drawing",
    "^a statement about other works$": "other works",
    "no exact meaning|no measure": "exact meaning",
}
"""Why a claim cannot be checked, and how the pages name that."""


@pytest.fixture(scope="module")
def site():
    return pages(report_data([], []))


def test_the_terms_are_there_once_and_say_something():
    keys = [term.key for term in glossary()]
    assert len(keys) == len(set(keys))
    assert set(keys) >= WANTED
    assert all(term.title and term.meaning.endswith((".", ":")) for term in glossary())


def test_places_exist():
    for term in glossary():
        assert len(term.cited) == len(term.cites)
        assert not any(place.startswith("eq:") for place in term.cited), term.key
        assert all((PROOFS / f"{name}.md").is_file() for name in term.pages), term.key
        assert term.printed is None or term.cites, term.key


def unnamed(claims: Sequence[PaperClaim], page: str) -> list[str]:
    """The reasons of claims that are not checkable which the words of a page do not name."""
    reasons = [claim.why for claim in claims if claim.without_entries is Standing.NOT_CHECKABLE]
    named = [reason for reason, word in NOT_CHECKABLE.items() if word in page]
    return [why for why in reasons if not any(re.search(reason, why) for reason in named)]


def test_the_pages_name_every_reason_for_which_a_claim_is_not_checkable():
    page = resources.files("gspot_verified.report.pages").joinpath("start.html.j2").read_text(encoding="utf-8")
    [shown] = re.findall(r'"not checkable": "([^"]*)"', page)
    [told] = re.findall(r"Not checkable: (.*)", next(term.meaning for term in glossary() if term.key == "claim"))
    assert [unnamed(paper_claims(), text) for text in (shown, told)] == [[], []]
    assert len(unnamed(paper_claims(), "A drawing, or about other works.")) > 1


def test_what_is_overtaken_in_part_is_said_to_be_so():
    """What is known now has conditions, which the claim has not."""
    partly = [claim for claim in paper_claims() if claim.proved_as is Standing.OVERTAKEN and "0 < β" in claim.why]
    assert partly != []
    folder = resources.files("gspot_verified.report.pages")
    texts = [folder.joinpath(f"{page}.html.j2").read_text(encoding="utf-8") for page in ("start", "claims")]
    texts.append(next(term.meaning for term in glossary() if term.key == "claim"))
    told = [re.findall(r"[Oo]vertaken[^.]*[.]", text) for text in texts]
    assert [any("in part" in sentence for sentence in sentences) for sentences in told] == [True] * 3


def test_a_printed_formula_stands_in_its_lines():
    if not PAPER.is_file():
        pytest.skip("the paper's source is not at hand")
    source = PAPER.read_text(encoding="utf-8").splitlines()
    printed = [term.printed for term in glossary() if term.printed is not None]
    assert len(printed) > 15
    for first, last, latex in printed:
        assert latex in "\n".join(source[first - 1 : last])


def test_every_printed_formula_can_be_set():
    for term in glossary():
        if term.printed is not None:
            assert "<math" in latex_formula(term.printed.formula, display=True), term.key


def test_the_page_has_every_term_and_every_rung(site):
    page = site["glossary.html"]
    assert re.findall(r'<dt id="([\w-]+)">', page) == [term.key for term in glossary()]
    assert page.count("<math") == sum(term.printed is not None for term in glossary())
    for rung in Rung:
        assert rung.value in page
    for term in glossary():
        assert typeset(term.meaning) in page


def test_it_is_in_the_navigation_and_at_the_first_use_on_the_start_page(site):
    assert all('<a href="glossary.html">Glossary</a>' in page for page in site.values())
    start = site["index.html"].split("<main", 1)[1]
    for key, words in (("g-spot", "G-spot"), ("painleve-parameter", None), ("beta", None), ("claim", "claims")):
        found = re.findall(rf'<a href="glossary.html#{key}">([^<]+|<i>.*?</i>)</a>', start)
        assert len(found) == (words is not None or key == "beta"), key
        assert words is None or found == [words]


@pytest.mark.parametrize(
    ("text", "linked"),
    [
        ("<p>a canard</p>", '<p>a <a href="glossary.html#canard">canard</a></p>'),
        ('<p title="canard">none</p>', '<p title="canard">none</p>'),
        ('<p><a href="x">the <b>canard</b></a></p>', '<p><a href="x">the <b>canard</b></a></p>'),
        ("<h2>Canard, canard</h2>", "<h2>Canard, canard</h2>"),
        ("<p>canards, S-canard</p>", "<p>canards, S-canard</p>"),
        (
            f"<p>{typeset('sign of C_1.')}</p>",
            '<p>sign of <span class="formula"><a href="glossary.html#c1"><i>C</i><sub>1</sub></a></span>.</p>',
        ),
    ],
)
def test_only_a_word_of_the_text_is_linked(text, linked):
    assert linked_at_first_use(START.format(text), glossary()) == START.format(linked)


def test_nothing_outside_of_the_main_text_is_linked():
    page = f"<nav>canard</nav>{START.format('<p>canard, canard</p>')}<footer>canard</footer>"
    done = linked_at_first_use(page, glossary())
    assert done.count("glossary.html#canard") == 1
    assert done.startswith("<nav>canard</nav>")
    assert '<p><a href="glossary.html#canard">canard</a>, canard</p>' in done
