"""The list of the paper's claims: complete, in order, and in step with the ledger and with the source."""

import re
import tomllib
from collections.abc import Mapping, Sequence
from dataclasses import replace
from importlib import resources
from pathlib import Path

import pytest

from gspot_verified.numbers.verdict import Outcome
from gspot_verified.paper.checks.entry import Entry
from gspot_verified.paper.checks.paper import _places
from gspot_verified.paper.claims import PaperClaim, Standing, paper_claims, standing_counts
from gspot_verified.paper.verify import PARTS

PAPER = Path(__file__).resolve().parents[3] / "shared" / "paper.tex"
ENTRIES = [identifier for builders in PARTS.values() for identifier in builders]
KEYS = {"lines", "begins", "claim", "entries", "premise", "not_checkable", "undecided", "under", "overtaken"}
VALUE = r"\b(?:[εβνχ]|u\(0\)) ?(?:=|<=) ?\d|ε in \(0|10\^-\d"
RESTRICTIONS = {
    "at leading order": "leading order",
    "slow manifold": "slow manifold",
    "constant α's": "constant|rigid slip",
    "formal series|expansion in polynomials": "series|expansion|polynomial|Theorem 1|Step",
    "begins with": "at lift-off",
    r"β not |that is not (?:-?\d|an integer)|β except": r"integer|β not|β [<>=]|< β|Theorem [156]|Step|Lemma|expansion",
    "[Aa]t (?:a|every) fixed|p fixed|at fixed τ": r"fixed|τ = O\(1\)|at the p of the starts",
    "fixed p > 0 and b|p and b fixed": "fixed p and b|and b held fixed|fixed p > 0 and b",
    "constant p|μ constant|forces other than": "fixed|constant|forces other|rigid",
    "in the scale ε²": "scale",
    "k < 8": "k < 8",
    "cited and not proved": "cited and not proved",
    "derivative dΘ/dτ is negative": "C_1 < 0|dΘ",
    "^In Cases II and III": "Cases II and III",
    "^In Case III": "Case III",
    "^In the leading inner solution": "inner solution|leading order",
    "λ_N the only force": "only force|depends on p",
    "y = z = 0": "y = z = 0",
    "smooth near ξ": "Theorem 1|Step|smooth|coefficient is not 0|complementary function",
    "regular Jacobian": "Theorem 1|Step|[Jj]acobian|coefficient is not 0|complementary function",
    "from that of order": "that of order",
    "fixed τ with dΘ/dτ not 0": r"dΘ/dτ is not 0|τ = O\(1\)|at a fixed τ",
    "half-line|each ε_0 at leading order": "τ_0",
    "belt that is fast enough": "belt",
    "^With m_1 at the contact point": "m_1 at the contact point",
    "^The oscillator in positive slip": "positive slip",
    "at most of the sizes": r"at most|O\(|leading order, where",
    "defined for p < 0 too": "p < 0|p = 0 is reached",
    "analytic functions": "analytic functions",
    "corrected sign of G": "sign of (?:its )?G",
    "far from rest": "far from rest",
    "slip being positive": "positive there too",
    r"C_1, α_2 not 0": "α_2 not 0|mean force|fixed τ",
    r"runs of Figure \d": r"\bruns?\b|start|Figure|[Pp]anel",
    "ansatz": "ansatz",
    "^For p < 1": "p < 1",
    "continuously differentiable": "continuously differentiable",
    "continuous λ_N": "λ_N continuous",
    r"^For a function f in C\^n": r"C\^n|Lemma|Step|coefficient of δ",
    "r_ξ with the corrected sum": "corrected sum|Step 2",
    "the last zero": "the last zero",
    r"C_1/Γ\(-β\)": "C_1",
    "with the corrected z|the trivial solution with the corrected": "corrected (?:sign|z|y)|right sign",
    r"as long as slip is positive": "slip (?:is )?positive|positive slip",
    r"AC - B² (?:> 0|stays)|A p < AC": r"AC - B²|near the G-spot",
    r"once z has come": "z has come",
    r"[Ff]or α_1 ≠ α_3": "α_1 and α_3 not equal|Cases?|α_1 ≠ α_3|corrected",
    r"p (?:other than|not) 0": r"p not 0|p > 0|p < 0|p bounded|λ_N > 0|p ≠ 0|2b/p",
    r"p other than 1": "p not 1|p < 1|at the G-spot",
    r"from a start at which": "start at which λ_N > 0|not later",
    VALUE: f"{VALUE}|Figure|Table|panel|Panel|start|[βε] <|β = ",
}
"""What a statement is restricted by, and one of the words by which a claim that is proved by it says so."""
AMONG = {"(?:some|one) series": "ε <=|10\\^-6", "1 % apart": "1 % apart", "chosen parameters": "chosen parameters"}
"""What a refuted statement says that there is, and the words by which its claim says among what it was looked for."""
ELSEWHERE = {("3-case-II", 77), ("3-case-II", 366), ("2-trivial-zy", 1054)}
"""Refuted entries with claims in other lines that say the same: an error of one line refutes no other one by itself."""
BRACKETED = r"(?<!\w)\([^()]*(?:[^\W\d_]{2}|[<>=≠≤≥→])"
"""A bracket with a word or a comparison in it; those of formulas, of panels and of places in a plane have none."""
PRINTED = {
    "leading order": r"leading.order|leading-order",
    "fixed": "fixed",
    r"constant\b": "constant",
    "not an integer": r"not an\s+integer",
    "small": "small",
    "slow manifold": "slow manifold|slow dynamics|critical manifold|y=2b|2b/p",
}
"""Words of a condition, and how the paper's lines say it."""
UNIVERSAL = r"\b(?:all|every|always|never|any|each|only|none|no other|exactly|for ever|unique|whenever)\b"


@pytest.fixture
def source():
    if not PAPER.is_file():
        pytest.skip("the paper's source is not at hand")
    return PAPER.read_text(encoding="utf-8").splitlines()


def rows_of_the_file():
    text = resources.files("gspot_verified.paper").joinpath("claims.toml").read_text(encoding="utf-8")
    return tomllib.loads(text)["claims"]


def test_rows_are_well_formed_and_in_order():
    for row in rows_of_the_file():
        assert set(row) <= KEYS
        assert len({"entries", "premise", "not_checkable", "undecided"} & set(row)) == 1, row
        assert row.get("premise", True) is True
        assert row.get("entries", ["x"])
        limits = {"under", "overtaken"} & set(row)
        assert len(limits) == 0 or (len(limits) == 1 and "entries" in row and row[limits.pop()].strip()), row
    claims = paper_claims()
    assert [claim.first for claim in claims] == sorted(claim.first for claim in claims)
    assert all(claim.first <= claim.last and claim.words for claim in claims)
    assert all(claim.why for claim in claims if claim.without_entries in (Standing.NOT_CHECKABLE, Standing.UNDECIDED))


def test_no_part_of_a_proved_claim_has_no_entry():
    """A condition narrows a claim; a part that nothing shows is a row of its own."""
    assert [claim.words for claim in paper_claims() if re.search(r"\bno entry\b", claim.why) and claim.entries] == []


def test_every_named_entry_exists_and_every_entry_is_named():
    named = {name for claim in paper_claims() for name in claim.entries}
    assert named <= set(ENTRIES)
    assert set(ENTRIES) - named == set()


def test_lines_are_those_of_the_source(source):
    for claim in paper_claims():
        assert claim.begins, claim
        assert source[claim.first - 1].strip().startswith(claim.begins), claim
        assert claim.last <= len(source)


def test_every_label_of_the_source_is_in_a_claim(source):
    """But for the names of sections."""
    labels = [(n, label) for n, line in enumerate(source, 1) for label in re.findall(r"\\label\s*\{([^}]*)\}", line)]
    assert len(labels) == 142
    left = [label for n, label in labels if not any(claim.first <= n <= claim.last for claim in paper_claims())]
    assert [label for label in left if not re.match(r"sec:|subsec:|A:", label)] == []


def test_every_display_of_the_source_is_in_a_claim(source):
    """Each displayed formula states something."""
    found = []
    start = source.index(r"\begin{document}")
    for number, line in enumerate(source[start:], start + 1):
        if re.search(r"\\begin\{(equation|align|eqnarray|multline)\*?\}|\\beq\b", line):
            following = next(
                n for n in range(number + 1, number + 9) if not source[n - 1].strip().startswith("\\label")
            )
            found.append(following)
    missing = [n for n in found if not any(claim.first <= n <= claim.last for claim in paper_claims())]
    assert len(found) > 90
    assert missing == []


@pytest.mark.parametrize(
    ("outcomes", "standing"),
    [
        ((Outcome.PROVED, Outcome.PROVED), Standing.PROVED),
        ((Outcome.PROVED, Outcome.REFUTED), Standing.REFUTED),
        ((Outcome.REFUTED, Outcome.UNDECIDED), Standing.REFUTED),
        ((Outcome.PROVED, Outcome.UNDECIDED), Standing.UNDECIDED),
        ((Outcome.PROVED, None), Standing.UNDECIDED),
    ],
)
def test_standing(outcomes, standing):
    claim = PaperClaim(1, 1, "", "x", ("a", "b"), None, "")
    known = {name: outcome for name, outcome in zip("ab", outcomes, strict=True) if outcome}
    assert claim.standing(known) is standing
    assert PaperClaim(1, 1, "", "x", (), Standing.PREMISE, "").standing(known) is Standing.PREMISE
    for limited in (Standing.PROVED_UNDER, Standing.OVERTAKEN):
        found = replace(claim, proved_as=limited, why="β > 1").standing(known)
        assert found is (limited if standing is Standing.PROVED else standing)


def test_no_condition_stands_in_brackets() -> None:
    """What the paper's words do not say is a condition, with the standing that says so."""
    assert [claim.words for claim in paper_claims() if re.search(BRACKETED, claim.words)] == []


@pytest.mark.parametrize(
    ("words", "condition"),
    [
        ("three outcomes (constant α's)", True),
        ("z relaxes (y fixed)", True),
        ("Θ ~ (-τ)^β (β not -1, -2, where Γ(1 + β) is infinite)", True),
        ("λ-hat > 0 (β < 1)", True),
        ("Table 1(b): b = (α_1 - α_3) p in the (b, p)-plane of panel (a), O(ε^(2β/3)) as (-τ)^β, z_(-1)", False),
    ],
)
def test_a_condition_in_brackets_is_seen(words: str, condition: bool) -> None:
    assert bool(re.search(BRACKETED, words)) is condition


def unprinted(claim: PaperClaim, lines: Sequence[str]) -> list[str]:
    """The conditions in the words of a claim that no line of the paper has, of the claim or shortly before it."""
    printed = " ".join(lines[max(claim.first - 30, 0) : claim.last])
    return [word for word, said in PRINTED.items() if re.search(word, claim.words) and not re.search(said, printed)]


def test_a_condition_of_a_claim_that_stands_plainly_proved_is_the_papers(source: list[str]) -> None:
    plain = [claim for claim in paper_claims() if claim.entries and not claim.why]
    assert len(plain) > 100
    assert {claim.first: found for claim in plain if (found := unprinted(claim, source))} == {}
    roots = next(claim for claim in plain if claim.first == 1107)
    assert unprinted(replace(roots, words="at a fixed y, at leading order"), source) == ["leading order", "fixed"]


def unsaid(claim: PaperClaim, statements: Mapping[str, str]) -> list[str]:
    """The restrictions of the entries of a claim that neither its words nor its condition say."""
    said = f"{claim.words} {claim.why}"
    return [
        f"{name}: {restriction}"
        for name in claim.entries
        for restriction, words in RESTRICTIONS.items()
        if re.search(restriction, statements[name]) and not re.search(words, said)
    ]


MEAN = {"negative": "3-case-I-trivial", "positive": "2-trivial-contact"}
"""The sign of the mean force, in Case I and in the others, and the entry on it."""


def mean_without_an_entry(claim: PaperClaim) -> list[str]:
    """The signs of the mean force that a claim speaks of without the entry that has them."""
    found = re.findall(r"\bthe mean(?: force)? is (negative|positive)", f"{claim.words} {claim.why}")
    return [sign for sign in found if MEAN[sign] not in claim.entries]


def test_a_sign_of_the_mean_force_has_its_entry() -> None:
    spoken = [claim for claim in paper_claims() if re.search(r"\bthe mean(?: force)? is ", claim.why)]
    assert len(spoken) == 4
    assert {claim.first: found for claim in spoken if (found := mean_without_an_entry(claim))} == {}
    claim = PaperClaim(1, 1, "", "an impact", ("C-cases-I-II", "2-trivial-contact"), None, "the mean is negative")
    assert mean_without_an_entry(claim) == ["negative"]
    assert mean_without_an_entry(replace(claim, why="the mean force is positive")) == []


def test_a_rate_that_grows_as_epsilon_falls_has_an_entry_on_the_fast_time(whole_ledger: list[Entry]) -> None:
    """The roots of a polynomial are rates of a motion where an entry says so, and in which time."""
    fast = {entry.identifier for entry in whole_ledger if re.search(r"t/ε", entry.statement)}
    spoken = [claim for claim in paper_claims() if re.search(r"\brates?\b.* of size 1/ε", claim.why)]
    assert len(spoken) > 2
    assert [claim.first for claim in spoken if not fast & {*claim.entries}] == []
    assert "4-discriminant" not in fast


def lacks_the_bridge(claim: PaperClaim) -> bool:
    """Whether a claim on a system in general rests on the leading order of the motivating example alone."""
    in_the_example = 714 <= claim.first < 1316  # Sections 3 and 4
    example = any(name.startswith("S-") for name in claim.entries) and "leading order" in f"{claim.words} {claim.why}"
    return example and not in_the_example and not {"5-perturbation-theta", "5-matching"} <= set(claim.entries)


def test_a_claim_on_general_systems_names_what_leads_there_from_the_example() -> None:
    assert [claim.first for claim in paper_claims() if lacks_the_bridge(claim)] == []
    bridge = ("5-perturbation-theta", "5-matching")
    claim = PaperClaim(80, 82, "", "it divides them", ("S-side", *bridge), None, "at leading order")
    assert not lacks_the_bridge(claim)
    assert lacks_the_bridge(replace(claim, entries=("S-side", bridge[0])))
    assert not lacks_the_bridge(replace(claim, first=1299, last=1301, entries=("S-side",)))


def quantified(claim: PaperClaim, statements: Mapping[str, str]) -> bool:
    """Whether a claim on all of something has an entry on all of something, or a condition."""
    found = " ".join(statements[name] for name in claim.entries)
    return bool(claim.why or not re.search(UNIVERSAL, claim.words) or re.search(UNIVERSAL, found, re.IGNORECASE))


def test_a_claim_that_stands_proved_says_what_its_entries_are_restricted_by(whole_ledger: list[Entry]) -> None:
    statements = {entry.identifier: entry.statement for entry in whole_ledger}
    outcomes = {entry.identifier: entry.verdict.outcome for entry in whole_ledger}
    proved = [
        claim
        for claim in paper_claims()
        if claim.entries and claim.standing(outcomes) not in (Standing.REFUTED, Standing.UNDECIDED)
    ]
    assert len(proved) > 100
    assert {claim.first: missing for claim in proved if (missing := unsaid(claim, statements))} == {}
    assert [claim for claim in proved if not quantified(claim, statements)] == []
    limited = {claim for claim in paper_claims() if claim.proved_as is not Standing.PROVED}
    assert limited <= set(proved), "a condition where nothing is proved"


def unnamed(word: str, claims: Sequence[PaperClaim], lines: Sequence[str]) -> list[int]:
    """The lines with a word, within claims, that no claim of theirs says it of."""
    found = []
    for number, line in enumerate(lines, 1):
        around = [claim for claim in claims if claim.first <= number <= claim.last]
        if around and word in line and not any(word in f"{claim.words} {claim.why}" for claim in around):
            found.append(number)
    return found


OPEN = r"\b(?:in general (?:it|this) is open|(?:is|are) open|is unclear|neither (?:proved|excluded))\b"


def test_what_is_open_still_is_not_overtaken() -> None:
    """Single cases do not settle what is said to be open in general."""
    overtaken = [claim for claim in paper_claims() if claim.proved_as is Standing.OVERTAKEN]
    assert [claim.first for claim in overtaken if re.search(OPEN, claim.why, re.IGNORECASE)] == []
    assert overtaken
    assert re.search(OPEN, "of single runs: it is lost. In general it is open", re.IGNORECASE)


def test_what_is_assumed_is_not_refuted(whole_ledger: list[Entry]) -> None:
    """An assumption can contradict another one; by itself it is not false."""
    outcomes = {entry.identifier: entry.verdict.outcome for entry in whole_ledger}
    refuted = [claim for claim in paper_claims() if claim.standing(outcomes) is Standing.REFUTED]
    assert [claim.words for claim in refuted if re.search(r"\b(?:[Aa]ssum|[Ss]uppos)", claim.begins)] == []


def test_what_the_paper_calls_a_canard_is_claimed_to_be_one(source: list[str]) -> None:
    """It is more than a solution that divides two fates: it leads from a stable manifold to one that is not.

    Line 382 speaks of the one of line 377 again.
    """
    assert unnamed("canard", paper_claims(), source) == [382]
    claim = PaperClaim(1, 2, "", "C_1 = 0 divides them", ("a",), None, "")
    lines = ["by setting C_1 = 0 is the dividing", "canard trajectory"]
    assert unnamed("canard", [claim], lines) == [2]
    assert unnamed("canard", [replace(claim, words="the canard C_1 = 0 divides them")], lines) == []
    assert unnamed("canard", [], lines) == []


def apart(claim: PaperClaim, entry: Entry) -> bool:
    """Whether the quoted lines of an entry are others than those of a claim."""
    quoted = entry.cited.quotations
    return bool(quoted) and all(claim.last < lines.first or lines.last < claim.first for lines in quoted)


def test_a_refuted_claim_is_where_its_error_is(whole_ledger: list[Entry]) -> None:
    refuted = [entry for entry in whole_ledger if entry.verdict.outcome is Outcome.REFUTED]
    pairs = [(entry, claim) for entry in refuted for claim in paper_claims() if entry.identifier in claim.entries]
    assert len(pairs) > len(refuted) > 30
    assert {(entry.identifier, claim.first) for entry, claim in pairs if apart(claim, entry)} == ELSEWHERE


def test_an_entry_is_named_by_a_claim_of_its_lines(whole_ledger: list[Entry]) -> None:
    """What an entry quotes is what it speaks of."""
    quoting = [entry for entry in whole_ledger if entry.cited.quotations]
    assert len(quoting) > 200
    claims = paper_claims()
    lost = [e.identifier for e in quoting if all(apart(c, e) for c in claims if e.identifier in c.entries)]
    assert lost == []


def test_a_refuted_claim_that_there_is_something_says_among_what(whole_ledger: list[Entry]) -> None:
    """None among these is less than none at all."""
    refuted = {entry.identifier: entry.statement for entry in whole_ledger if entry.verdict.outcome is Outcome.REFUTED}
    pairs = [(claim, refuted[name]) for claim in paper_claims() for name in claim.entries if name in refuted]
    missing = [
        claim.words
        for claim, statement in pairs
        for there_is, words in AMONG.items()
        if re.search(there_is, statement) and not re.search(words, f"{claim.words} {claim.why}")
    ]
    assert missing == []
    assert any(re.search(there_is, statement) for _, statement in pairs for there_is in AMONG)


@pytest.mark.parametrize(
    ("words", "why", "statement", "passes"),
    [
        ("all starts take an impact", "", "β = 1/2, ν = 2 and 4: an impact", False),
        ("all starts take an impact", "β = 1/2, ν = 2 and 4", "β = 1/2, ν = 2 and 4: an impact", True),
        ("Figure 6: the five runs", "", "Panel (a), ν = 1/4: an impact", True),
        ("the canard divides them", "", "at leading order it lifts off", False),
        ("the canard divides them", "at leading order", "at leading order it lifts off", True),
        ("the force grows", "", "on the slow manifold the force grows", False),
        ("there is one of them", "", "For functions of ξ that are smooth near ξ* there is one", False),
        ("there is one trajectory", "", "there is exactly one expansion in polynomials", False),
        ("Θ grows", "", "Θ grows for every β that is not 0, 1, 2, ...", False),
        ("Θ grows", "", "Θ grows for every β that is not -1, -2, ...", False),
        ("the start goes to an impact", "", "slip, positive on a belt that is fast enough, reaches it", False),
        ("the sizes of b and v", "", "b and v are at most of the sizes 1 and ε", False),
        ("b and v are O(1) and O(ε)", "", "b and v are at most of the sizes 1 and ε", True),
        ("Θ grows", "β not 0, 1, 2, ...", "Θ grows for every β that is not 0, 1, 2, ...", True),
        ("the contact oscillates", "", "at every fixed p > 0 the contact oscillates", False),
        ("the contact oscillates at a fixed p", "", "at every fixed p > 0 and b it oscillates", False),
        ("it oscillates", "at fixed p and b", "at every fixed p > 0 and b it oscillates", True),
        ("the contact oscillates at a fixed p", "", "at every fixed p > 0 the contact oscillates", True),
        ("impacts are elastic", "", "an impact with constant p > 0 is elastic", False),
        ("y diverges", "", "in the scale ε² of y: y diverges", False),
        ("the c_k are those", "", "the c_k are those (k < 8)", False),
        ("Θ has this form", "", "By DLMF 16.11.8, which is cited and not proved here, Θ has it", False),
        ("Θ has this form", "DLMF, cited and not proved", "which is cited and not proved here", True),
        ("λ-hat > 0 for all τ", "", "the derivative dΘ/dτ is negative at every real τ", False),
        ("λ-hat > 0 for all τ, C_1 < 0", "", "the derivative dΘ/dτ is negative at every real τ", True),
        ("it is a canard", "", "In Cases II and III it is in contact", False),
        ("it is a canard", "Cases II and III", "In Cases II and III it is in contact", True),
        ("it lifts off", "β > 1", "In Case III, β not an integer, it lifts off", False),
        ("it lifts off", "Case III, β not an integer", "In Case III, β not an integer, it lifts off", True),
        ("the force has this sign", "", "In the leading inner solution the force has this sign", False),
        ("impacts are inelastic", "", "e of an impact (λ_N the only force) tends to 0", False),
        ("impacts are inelastic", "λ_N the only force", "e of an impact from y = z = 0 tends to 0", False),
        ("it is the trajectory", "", "its b differs by less than 1/2 from that of order 31", False),
        ("an impact occurs", "ε below an ε_0", "on every half-line [τ_0, ∞), for ε below an ε_0", False),
        ("an impact occurs", "from τ_0 on, ε below an ε_0", "on every half-line [τ_0, ∞), for ε below an ε_0", True),
        ("it is defined for p > 0 alone", "", "its formulas are defined for p < 0 too", False),
        ("y diverges", "", "runs of Figure 6 other than ν = 1: y diverges", False),
        ("y diverges", "in the runs of Figure 7", "runs of Figure 6 other than ν = 1: y diverges", True),
        ("b on the outer scale", "", "the exponent of the ansatz is β", False),
        ("the lift-off time grows", "", "the lift-off time, the last zero of λ_N, grows", False),
        ("it is the only one near by", "", "For continuously differentiable functions it is", False),
        ("it lifts off or takes an impact", "", "it lifts off when C_1/Γ(-β) < 0", False),
        ("it lifts off or takes an impact", "C_1 not 0", "it lifts off when C_1/Γ(-β) < 0", True),
        ("it lifts off", "Case III", "In Case III, the contact not far from rest, it lifts off", False),
        ("it has the general form", "", "For p < 1 it has the printed fields", False),
        ("it has the general form", "p < 1", "For p < 1 it has the printed fields", True),
        ("every state reaches it", "", "the state p = 1 reaches it", False),
        ("every state reaches it", "", "every initial value reaches it", True),
        ("every state reaches it", "", "every initial value reaches it, for constant α's", False),
    ],
)
def test_what_a_claim_must_say(words: str, why: str, statement: str, passes: bool) -> None:
    claim = PaperClaim(1, 1, "", words, ("a",), None, why)
    assert (unsaid(claim, {"a": statement}) == [] and quantified(claim, {"a": statement})) is passes


def test_a_figure_is_named_by_the_number_that_the_paper_prints():
    floats = [(first, last, name) for first, last, name in _places() if name.startswith(("Figure", "Table"))]
    held = 0
    for claim in paper_claims():
        around = [name for first, last, name in floats if first <= claim.first and claim.last <= last]
        for named in re.findall(r"(?:Figure|Table) \d+", f"{claim.words} {claim.why}"):
            assert named in {name for _, _, name in floats}, claim.words
        if around and (first := re.match(r"(?:Caption of )?((?:Figure|Table) \d+)", claim.words)):
            assert first[1] == around[0], claim.words
            held += 1
    assert held > 3


def test_the_counts_have_the_denominator():
    counts = standing_counts({})
    assert sum(counts.values()) == len(paper_claims()) > 200
    assert counts["proved"] == counts["refuted"] == 0
    for word in ("premise", "not_checkable"):
        assert counts[word.replace("_", " ")] == sum(word in row for row in rows_of_the_file()) > 0
    assert standing_counts(dict.fromkeys(ENTRIES, Outcome.PROVED))["proved"] > 100
