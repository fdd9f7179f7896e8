"""The pages: what they show, that they are whole, and that nothing in the data becomes markup."""

import html
import json
import re
from dataclasses import replace
from html.parser import HTMLParser
from importlib import resources
from urllib.parse import quote, unquote

import pytest

from gspot_verified.paper.checks.entry import Check, Rung, Section
from gspot_verified.paper.checks.formal_proof import RUN_HERE, FormalProof, Theorem
from gspot_verified.paper.claims import WHY, Standing, paper_claims
from gspot_verified.paper.verify import PARTS
from gspot_verified.report.data import report_data
from gspot_verified.report.parts.formulas import typeset
from gspot_verified.report.site import _passage, pages, style

IN_EVERY_FOLDER = {"style.css", "figures", "certificates", "cost.json"}


@pytest.fixture(scope="module")
def site(entries, pictures, certificates, hard):
    return pages(json.loads(json.dumps(report_data(entries, pictures, certificates, hard))))


def article(page, identifier):
    """The part of a page about one entry."""
    parts = re.findall(r"<article .*?</article>", page, re.S)
    [found] = [part for part in parts if f'id="{html.escape(anchor(identifier))}"' in part]
    return found


def anchor(identifier):
    return identifier if identifier.endswith(".cert") else "entry-" + quote(identifier, safe="")


class Tags(HTMLParser):
    VOID = frozenset({"meta", "img", "br", "link", "input", "rect", "path", "hr"})

    def __init__(self):
        super().__init__()
        self.open, self.seen, self.ids, self.links = [], [], [], []

    def handle_starttag(self, tag, attrs):
        self.seen.append((tag, dict(attrs)))
        self.ids += [value for name, value in attrs if name == "id"]
        self.links += [value for name, value in attrs if name in ("href", "src")]
        if tag not in self.VOID:
            self.open.append(tag)

    def handle_endtag(self, tag):
        if tag not in self.VOID:
            assert self.open.pop() == tag


def parsed(page):
    tags = Tags()
    tags.feed(page)
    assert tags.open == []
    return tags


def test_pages_are_well_formed_and_ask_for_nothing_outside(site):
    for name, page in site.items():
        assert page.startswith("<!DOCTYPE html>"), name
        tags = parsed(page)
        assert len(tags.ids) == len(set(tags.ids)), name
        assert not {"iframe", "object", "embed", "base"} & {tag for tag, _ in tags.seen}
        assert not any(key.startswith("on") or key == "style" for _, attributes in tags.seen for key in attributes)
        policy = next(attributes["content"] for tag, attributes in tags.seen if "http-equiv" in attributes)
        assert policy.startswith("default-src 'none'; style-src 'self' file:; img-src 'self' file:")
        assert ("script-src" in policy) == (name == "statements.html")
        assert page.count("<script>") == (name == "statements.html")


def test_every_link_arrives(site):
    ids = {name: set(parsed(page).ids) for name, page in site.items()}
    for name, page in site.items():
        for link in parsed(page).links:
            file, _, place = link.partition("#")
            file = file or name
            if file.partition("/")[0] in IN_EVERY_FOLDER:
                continue
            assert file in site, f"{name}: {link}"
            assert not place or unquote(place) in ids[file], f"{name}: {link}"


def test_the_script_is_the_one_that_the_page_allows(site):
    import base64
    import hashlib

    page = site["statements.html"]
    [script] = re.findall(r"<script>(.*?)</script>", page, re.S)
    digest = base64.b64encode(hashlib.sha256(script.encode()).digest()).decode()
    assert f"script-src &#39;sha256-{digest}&#39;" in page or f"script-src 'sha256-{digest}'" in page


def test_markup_in_the_data_is_text(site):
    for page in site.values():
        for bad in ("<script>alert", "<img src=x", "<b>it", "<at>", "<b>cover", "<n>", "<c>"):
            assert bad not in page
    assert "found <b>it</b>" in said(site["appendix-a.html"])
    assert "<b>cover</b>" in said(site["certificates.html"])


def said(page):
    """What a reader sees."""
    return html.unescape(re.sub(r"<[^>]*>", "", page))


def test_counts_are_shown(site):
    claims, statements = map(shown_counts, re.findall(r'<dl class="counts.*?</dl>', site["index.html"], re.S))
    assert claims == {
        standing.value: sum(claim.standing({}) is standing for claim in paper_claims()) for standing in Standing
    }
    assert sum(claims.values()) == len(paper_claims())
    assert statements == {"proved": 1, "refuted": 1, "undecided": 2}
    assert "checked by 4 statements of this report" in site["index.html"]
    for page in site.values():
        footer = said(page.split("<footer", 1)[1])
        assert footer.index(f"The paper’s {len(paper_claims())} claims: ") < footer.index("4 statements of this report")


def shown_counts(markup):
    shown = re.findall(r'<dt>(.*?)</dt><dd class="number">(\d+)</dd>', markup)
    return {said(name): int(number) for name, number in shown}


def test_each_entry_has_its_own_badge_and_no_other(site, entries):
    page = site["section-4.html"] + site["appendix-a.html"]
    for entry in entries:
        badges = re.findall(r'class="badge (\w+)">(\w+)<', article(page, entry.identifier))
        assert badges == [(entry.verdict.outcome.value,) * 2]


def test_verbatim_and_transcribed_are_told_apart(site):
    quoted = article(site["appendix-a.html"], "t01")
    assert "Printed: line 2453 of the source" in quoted
    assert "<math" in quoted
    assert r"\frac{\Gamma" in quoted  # the LaTeX behind it
    assert "eq. (A.8)" in quoted
    written = article(site["section-4.html"], "gamma sign")
    assert "Printed, transcribed" in written
    assert r"\Gamma(-\beta)&lt;0" in written


def test_what_cannot_be_typeset_is_shown_as_it_is(site, entries):
    strange = article(site["section-4.html"], entries[3].identifier)
    assert "&lt;/code&gt;&lt;script&gt;" in strange


def test_each_entry_says_what_it_rests_on(site, entries):
    page = site["section-4.html"] + site["appendix-a.html"]
    shown = [re.findall(r'<span class="rests">(.*?)</span>', article(page, entry.identifier)) for entry in entries]
    assert shown == [["on a proof page alone"], ["on exact identity or certificate; balls over the whole set"], [], []]


def test_the_summary_counts_the_rungs(site):
    [table] = re.findall(r"What the verdicts rest on.*?</table>", site["index.html"], re.S)
    rows = re.findall(r'<th scope="row">(.*?)</th><td>(\d+)</td><td>(\d+)</td>', table)
    assert [row[1:] for row in rows] == [("0", "0"), ("0", "1"), ("1", "0"), ("0", "0"), ("0", "0")]
    assert "<strong>1</strong> of them rests on a proof page alone" in site["index.html"]


def test_an_entry_leads_to_its_code_its_page_and_other_entries(site):
    quoted = article(site["appendix-a.html"], "t01")
    assert 'href="proof-signs.html"' in quoted
    assert '<dt>Its checks name</dt><dd><a href="section-4.html#entry-rate">rate</a></dd>' in quoted
    assert 'Named by the checks of</dt><dd><a href="appendix-a.html#entry-t01">' in article(
        site["section-4.html"], "rate"
    )
    assert 'href="code-section_4_5_signs.html#function-_gamma_intervals"' in site["section-4.html"]
    assert 'id="function-_gamma_intervals"' in site["code-section_4_5_signs.html"]
    assert 'href="appendix-a.html#entry-t01">t01</a>' in site["proof-signs.html"]


def test_a_refutation_at_points_is_a_counterexample():
    checks = [Check(Rung.POINTS, what, False, "f") for what in ("one point", "another point")]
    page = pages(report_data([Section("Section").settled("a", "line 1", "x", "s", *checks)], []))["section.html"]
    assert '<span class="rests">on a counterexample at points</span>' in page
    assert page.count("By single points: one certain counterexample is enough.") == 2


def test_undecided_is_not_shown_as_passed(site):
    rate = article(site["section-4.html"], "rate")
    assert "could not tell" in rate
    assert "agrees" not in rate
    assert "proved" not in rate
    assert "The stated budget ended before the question was settled." in rate
    assert "Boxes left (7, the first 5;" in rate
    assert "and 2 of the statements. This is not a pass." in site["open.html"]
    assert "This is not a pass." in site["index.html"]


def test_the_errata_hold_the_refuted_ones_and_no_other(site):
    page = site["errata.html"]
    assert page.split('<ul class="evidence">')[1].count("<li>") == 2
    for text in ("at beta", "4 &gt; 0", "Errors whose consequence is not recorded"):
        assert text in page
    assert "Γ" in html.unescape(page), "the transcribed form is set"
    assert page.count("<article") == 1
    assert "eq. (A.8)" not in page.split("<main", 1)[1]


def test_an_erratum_says_how_far_it_reaches():
    checks = [Check(Rung.EXACT, what, False, "f") for what in ("one", "another")]
    refuted = Section("Section 4").settled("4-order", "line 986", "x", "third order", *checks, corrected="fourth order")
    page = pages(report_data([refuted], []))["errata.html"]
    assert "Consequence: none" in page
    assert "The printed equation is of fourth order" in page
    assert "The equation contains the fourth derivative of" in page
    assert "<h2>Misprints and slips without a consequence</h2>" in page
    assert "gspot-verified verify 4-order" in page


def refuted_entry(identifier, label, source="x"):
    checks = [Check(Rung.EXACT, what, False, f"{what} fails") for what in ("one", "another")]
    return Section("Section 4").settled(identifier, label, source, "s", *checks, corrected="c")


def test_the_errata_are_sorted_by_consequence_and_a_table_is_one_item():
    labels = {
        "4-order": "line 986", "3-table-1-y-1_2": "line 894 (β = 1/2)", "1-beta": "line 380",
        "3-sides": "lines 782 to 785", "3-table-1-one-series": "lines 844 to 847",
    }  # fmt: skip
    page = pages(report_data([refuted_entry(name, label) for name, label in labels.items()], []))["errata.html"]
    main = page.split("<main", 1)[1]
    articles = re.findall(r"<article .*?</article>", main, re.S)
    named = [re.findall(r"gspot-verified verify ([\w-]+)", article) for article in articles]
    assert named == [["3-sides"], ["1-beta"], ["3-table-1-one-series", "3-table-1-y-1_2"], ["4-order"]]
    assert "Table 1(a)" in articles[2]
    assert re.findall(r"<h2>(.*?)</h2>", main) == [
        "Errors that change a conclusion",
        "Local errors: what is printed there is wrong, and no conclusion changes",
        "Misprints and slips without a consequence",
    ]
    assert "one: <strong>one fails</strong>" in articles[0]
    assert "another: <strong>another fails</strong>" in articles[0]


@pytest.mark.parametrize(
    ("identifier", "label", "wrong"),
    [
        ("4-inner-scaling-v", "eq:inner_scaling (v)", r"\delta^{2}\alpha_3^*\frac{\hat{v}}{\epsilon}"),
        ("4-matching-middle", "eq:bhat_inner, line 1227", r"C_1(-\epsilon^{2/3} s)"),
        ("4-inner-fast", "line 1161", r"+\delta^2\alpha_1^*s"),
    ],
)
def test_the_printed_lines_of_an_erratum_hold_the_wrong_part(identifier, label, wrong):
    page = pages(report_data([refuted_entry(identifier, label)], []))["errata.html"]
    assert wrong in html.unescape(page)


def test_a_long_printed_line_breaks_at_its_commas_or_can_be_moved():
    page = pages(report_data([refuted_entry("4-inner-scaling-v", "eq:inner_scaling (v)")], []))["errata.html"]
    assert page.count('<span class="part">') == 4
    assert ".display { display: block; overflow-x: auto" in style()
    assert "::-webkit-scrollbar-thumb" in style()


def test_a_printed_form_is_words_and_formulas():
    source = r"\text{lower } b(0) \text{ in (b)},\ \text{higher } b(0)"
    page = pages(report_data([refuted_entry("3-sides", "lines 782 to 785", source)], []))["errata.html"]
    [shown] = re.findall(r'<div class="wide">(.*?)</div>', page, re.S)
    words = html.unescape(re.sub(r"<[^>]*>", " ", shown))
    assert " ".join(words.split()).startswith("lower b ( 0 ) in (b), higher b")


def test_the_open_page_holds_the_undecided_ones_and_no_other(site):
    page = site["open.html"].split("<h2>Statements</h2>", 1)[1]
    assert "line 1302" in page
    assert page.count("<article") == 2
    assert "line 1271" not in page


def proved_entry(name):
    """Of two of them there are formal theorems, and those of the first were proved in this run."""
    checks = [Check(Rung.EXACT, what, True) for what in ("one", "two")]
    entry = Section("Section 4.5").settled(name, "line 1", "x", f"says {name}", *checks, corrected=f"only for {name}")
    if name not in FORMAL:
        return entry
    run_here = name == FORMAL[0]
    theorem = Theorem(f"formal_{name}", "Definition x.", "Statement.v")
    proof = FormalProof((theorem,), run_here, RUN_HERE if run_here else "not run here")
    run = (Check(Rung.FORMAL, "Coq", True),) if proof.run else ()
    return replace(entry, formal=proof, checks=(*checks, *run))


FORMAL = ("S-minus-infinity", "S-plus-infinity")


@pytest.fixture(scope="module")
def all_proved():
    """The pages of a report in which every entry that a claim names is proved."""
    names = dict.fromkeys(name for claim in paper_claims() for name in claim.entries)
    return pages(report_data([proved_entry(name) for name in names], []))


def claim_row(site, claim):
    rows = re.findall(r'<tr id="line-.*?</tr>', site["claims.html"], re.S)
    [row] = [row for row in rows if f'<td class="words">{typeset(claim.words)}</td>' in row]
    return row


def test_the_open_page_holds_the_undecided_claims():
    """Also where no statement is undecided: a claim can be without one."""
    report = report_data([proved_entry("4-unique")], [])
    row = next(row for row in report["claims"] if row["standing"] == "premise")
    row |= {"standing": "undecided", "why": "order by order 4-unique shows it, and 4-unique-smooth is not there"}
    report["standings"] |= {
        name: sum(row["standing"] == name for row in report["claims"]) for name in ("premise", "undecided")
    }
    page = pages(report)["open.html"].split("<main", 1)[1]
    undecided = [row for row in report["claims"] if row["standing"] == "undecided"]
    assert page.count("<article") == len(undecided)
    assert f"about {len(undecided)} of the paper’s claims and 0 of the statements" in page
    for claim in undecided:
        assert typeset(claim["claim"]) in page
        assert typeset(claim["why"]) in page
    assert (
        'is not there</span><span class="soft">; see <a href="section-4.html#entry-4-unique">4-unique</a></span>'
        in page
    )


def test_beside_a_claim_stands_what_exactly_was_proved(all_proved):
    claims = [claim for claim in paper_claims() if claim.entries and not {*FORMAL} & {*claim.entries}]
    for claim in claims[::10]:
        items = [
            " ".join(said(item).split()) for item in re.findall(r"<li.*?</li>", claim_row(all_proved, claim), re.S)
        ]
        assert items == [f"proved {n} says {n} Condition or precise form: only for {n}" for n in claim.entries]


def test_a_formal_proof_stands_beside_a_claim_only_where_it_was_run(all_proved):
    run, not_run = FORMAL
    rows = [said(claim_row(all_proved, claim)) for claim in paper_claims() if {*FORMAL} & {*claim.entries}]
    assert any(run in row for row in rows)
    assert any(not_run in row for row in rows)
    for row in rows:
        assert (f"(formal: formal_{run})" in row) is (run in row)
        assert (" exists; its proof was not run here." in row) is (not_run in row)
    assert f"formal_{not_run}" not in all_proved["claims.html"]


def test_the_claims_have_their_denominator(site):
    rows = re.findall(r'<tr id="line-.*?</tr>', site["claims.html"], re.S)
    assert len(rows) == len(paper_claims())
    assert f"<strong>{len(paper_claims())}</strong> claims" in site["index.html"]
    assert not any("badge proved" in row for row in rows)  # none of the ledger's entries is in this report


def test_a_condition_stands_beside_its_claim(all_proved):
    limited = [claim for claim in paper_claims() if claim.proved_as is not Standing.PROVED]
    assert limited
    for claim in limited:
        row = claim_row(all_proved, claim)
        assert f'<span class="label">{WHY[claim.proved_as].capitalize()}:</span>' in row
        assert typeset(claim.why) in row
        assert f">{claim.proved_as.value}</span>" in row
    for standing in WHY:
        number = sum(claim.proved_as is standing for claim in limited)
        assert shown_counts(all_proved["index.html"])[standing.value] == number


def test_certificates_are_listed_with_what_the_checker_said(site):
    page = site["certificates.html"]
    assert 'href="certificates/iwc_0_1.cert"' in page
    assert "rejected" in article(page, "bad.cert")
    assert "verified" in article(page, "iwc_0_1.cert")


def test_an_empty_ledger_shows_nothing_about_the_paper():
    site = pages(report_data([], []))
    for page in site.values():
        parsed(page)
    assert "shows nothing about the paper" in site["index.html"]
    assert "No statement is refuted." in site["errata.html"]
    assert "What happens after the G-spot" not in site["index.html"]


@pytest.mark.parametrize("sections", [("index", "Section 2"), ("Section 2", "section-2"), ("Errata", "Section 2")])
def test_no_section_hides_another_page(entries, sections):
    renamed = [replace(entry, section=name) for entry, name in zip(entries, sections, strict=False)]
    with pytest.raises(ValueError, match=r"entries: the section '.*' would hide the page"):
        pages(report_data(renamed, []))


def test_every_page_says_that_it_shows_a_file(site):
    """Whoever wrote report.json could write anything: no page may vouch for it."""
    for name, page in site.items():
        assert "These pages show what <code>report.json</code> says: writing them checks nothing." in page, name
    assert "were run for this report" not in site["index.html"]
    assert "when this report was written" not in site["certificates.html"]


def test_one_entry_reads_well(entries):
    site = pages(report_data(entries[2:3], []))
    assert "checked by 1 statement of this report" in site["index.html"]
    assert "and 1 of the statements. This is not a pass." in site["open.html"]


def test_a_finding_of_the_start_is_the_statement_of_its_entry():
    start = resources.files("gspot_verified.report").joinpath("pages", "start.html.j2").read_text(encoding="utf-8")
    names = [name for found in re.findall(r"{% set (?:after|way) = (.*?) %}", start) for name in json.loads(found)]
    ledger = {identifier for builders in PARTS.values() for identifier in builders}
    assert set(names) <= ledger
    assert {"S-iwc", "C-cases-I-II", "3-case-II", "5-theorem-1"} <= set(names)
    holds = (Check(Rung.EXACT, "one", True), Check(Rung.PAGE, "two", True))
    fails = (Check(Rung.EXACT, "one", False, "f"), Check(Rung.PAGE, "two", False, "f"))
    outcomes = {name: (holds, fails, holds[:1])[k % 3] for k, name in enumerate(names)}
    entries = [
        Section("Section 4.5").settled(n, "line 1", "x", f"says {n}", *outcomes[n], corrected=f"for {n}") for n in names
    ]
    page = pages(report_data(entries, []))["index.html"]
    shown = re.findall(r"<li>(<a class=\"chip.*?)</li>", page.replace("\n", " "))
    assert len(shown) == page.count("<li>", page.index("What happens after")) == len(names)
    for item, entry in zip(shown, entries, strict=True):
        text = " ".join(re.sub(r"<[^>]*>", " ", item).split())
        outcome = entry.verdict.outcome.value
        mended = f" Correct: {typeset(entry.corrected)}" if outcome == "refuted" else ""
        assert text == f"{entry.identifier}: {outcome} {typeset(entry.statement)}{mended}"


MECHANICS = (
    r"[Α-Ωα-ω]|\b(?:impacts?|lifts?|contact|force|trajector\w+|slip|stick|canard|expansion|smooth\w*|unique\w*)\b"
)
WITHOUT_CLAIM = {
    "Θ(τ, β), the solution of θ‴ − τθ′ + βθ = 0 whose initial values are the paper’s eqs.",  # what Θ is
    "next to an integer, a zero, a fold or the canard, where terms cancel, where numbers leave the range of doubles, "
    "where a Jacobian is nearly singular.",  # what is asked
    "exp, log, sin(πx), π;",  # functions of FLINT
    "Γ and 1/Γ, factorials and rising factorials;",
    "A G-spot is a state p = b = y = v = 0, where the force of rigid slip, −b/p, is 0/0.",  # what a G-spot is
    "β = α3/α1.",  # what β is
    "impact without collision.",  # what IWC stands for
    "β",  # over columns
    "Takes an impact",
}


def sentences_of(template):
    """What a template says by itself, without headings and without what it takes from the data, block by block."""
    text = re.sub(r"\{%.*?%\}|\{\{.*?\}\}|\{#.*?#\}|<(cite|h\d)\b.*?</\1>", " ", template, flags=re.S)
    for block in re.split(r"</?(?:p|li|dd|dt|figcaption|t[dhr]|ul|ol|dl|table|summary|div)\b[^>]*>", text):
        plain = html.unescape(re.sub(r"<[^>]+>", "", block)).replace("\xa0", " ")
        yield from re.split(r"(?<=[.;:?!])\s+", " ".join(plain.split()))


def test_no_page_claims_anything_but_through_an_entry():
    """A sentence on mechanics that stands in a template is nobody's statement: nothing has checked it."""
    folder = resources.files("gspot_verified.report").joinpath("pages")
    templates = {file.name: file.read_text(encoding="utf-8") for file in folder.iterdir() if file.name.endswith(".j2")}
    assert len(templates) > 10
    found = {
        (name, said) for name, text in templates.items() for said in sentences_of(text) if re.search(MECHANICS, said)
    }
    assert {row for row in found if row[1] not in WITHOUT_CLAIM} == set()
    assert {said for _, said in found} == WITHOUT_CLAIM
    old = "<p>So on the impact side of Cases I and II the contact force never\nvanishes, at every ε.</p>"
    assert [said for said in sentences_of(old) if re.search(MECHANICS, said)]


def test_colours_of_text_have_contrast():
    """WCAG's ratio of at least 4.5 for every colour of text on every ground, light and dark."""
    light, dark = re.findall(r":root \{(.*?)\}", style(), re.S)
    for block in (light, dark):
        colours = dict(re.findall(r"--(\w+): (#\w+);", block))
        for ground in ("paper", "panel"):
            for ink in ("ink", "soft", "link", "proved", "refuted", "undecided"):
                assert ratio(colours[ground], colours[ink]) >= 4.5, (ground, ink)


def ratio(first, second):
    low, high = sorted(map(luminance, (first, second)))
    return (high + 0.05) / (low + 0.05)


def luminance(colour):
    parts = [int(colour[i : i + 2], 16) / 255 for i in (1, 3, 5)]
    linear = [part / 12.92 if part <= 0.04045 else ((part + 0.055) / 1.055) ** 2.4 for part in parts]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


def test_hard_cases_have_a_row_each_and_say_what_is_undecided(site, hard):
    page = site["hard.html"]
    rows = [row for family in hard["families"] for row in family["rows"]]
    assert page.count('<th scope="row">') == len(rows) + len(hard["families"])
    assert page.count("<math ") >= len(hard["families"])
    assert page.count('class="badge undecided"') == 2  # in its row, and in the table of all families
    wrong = sum(row["double_right"] is False for row in rows)
    assert wrong > 0
    assert page.count(">wrong</strong>") == wrong + sum(
        f["rows"][-1]["double_right"] is False for f in hard["families"]
    )
    summary = hard["summary"]
    assert f"<strong>{summary['rows']}</strong> cases {summary['decided']}" in page
    assert r"\frac" not in page


def test_a_report_without_hard_cases_says_so(entries, pictures, certificates):
    made = pages(json.loads(json.dumps(report_data(entries, pictures, certificates))))
    assert "This report was made without them." in made["hard.html"]


def test_a_reference_to_a_display_without_a_number_says_so() -> None:
    """What LaTeX prints there is the number of the section."""
    assert _passage(r"into \eqref{eq:modelSysTEliminated}, or \eqref{eq:btau}") == "<p>into (unnumbered), or (A.1)</p>"
    assert _passage(r"into \eqref{eq:nowhere}") == "<p>into [eq:nowhere]</p>"
