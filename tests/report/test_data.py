import copy
import json

import pytest

from gspot_verified.paper.checks.formal_proof import RUN_HERE
from gspot_verified.paper.claims import paper_claims
from gspot_verified.report.data import checked, report_data, versions

BARE = next(k for k, claim in enumerate(paper_claims()) if not claim.entries)
"""A claim that no entry checks."""


@pytest.fixture
def report(entries, pictures, certificates):
    return json.loads(json.dumps(report_data(entries, pictures, certificates)))


def test_counts_and_keys(report, entries):
    assert report["counts"] == {"proved": 1, "refuted": 1, "undecided": 2}
    parts = [
        "certificates",
        "claims",
        "counts",
        "entries",
        "figures",
        "hard_cases",
        "page_alone",
        "proofs",
        "rungs",
        "schema",
        "standings",
        "versions",
    ]
    assert sorted(report) == parts
    bare = [{key: value for key, value in entry.items() if key != "dependencies"} for entry in report["entries"]]
    assert bare == [json.loads(json.dumps(entry.to_json())) for entry in entries]
    assert report["entries"][0]["dependencies"] == {
        "pages": ["signs"], "certificates": [], "entries": ["rate"], "see_also": []
    }  # fmt: skip
    assert report["entries"][1]["dependencies"]["see_also"] == ["t01"]
    assert "svg" not in json.dumps(report["figures"])


def test_versions_name_the_arithmetic():
    import flint

    assert versions()["FLINT"] == flint.__FLINT_VERSION__
    assert versions()["python-flint"] == flint.__version__


def test_two_entries_with_one_identifier_are_rejected(entries):
    with pytest.raises(ValueError, match="'t01' occurs 2 times"):
        report_data([entries[0], entries[0]], [])


def set_in(report, path, value):
    for key in path[:-1]:
        report = report[key]
    report[path[-1]] = value


@pytest.mark.parametrize(
    ("path", "value", "message"),
    [
        (["schema"], 1, "reads schema 8"),
        (["standings", "premise"], 1, "standings: the file says"),
        (["entries", 0, "from_cache"], None, r"entries\[0\].from_cache: expected true or false"),
        (["schema"], True, "reads schema 8"),
        (["schema"], "1", "reads schema 8"),
        (["counts"], {"proved": 3, "refuted": 1, "undecided": 0}, "its entries give"),
        (["counts"], {"proved": True, "refuted": 1, "undecided": 2}, "its entries give"),
        (["counts"], None, "counts: expected an object"),
        (["page_alone"], 0, "page_alone: the file says 0, its entries give 1"),
        (["page_alone"], True, "page_alone: the file says True, its entries give 1"),
        (["rungs", "proved", "page"], 0, "rungs: the file says"),
        (["rungs", "proved", "points"], 1, "rungs: the file says"),
        (["rungs", "refuted"], {}, "rungs: the file says"),
        (["rungs"], None, "rungs: expected an object"),
        (["entries", 0, "rests_on"], None, "expected a list under 'rests_on'"),
        (["entries", 0, "rests_on"], ["guess"], r"rests_on: expected one of"),
        (["entries", 0, "rests_on"], [], r"entries\[0\].rung: expected the first of rests_on"),
        (["entries", 1, "rests_on"], ["balls", "exact"], "the strongest first"),
        (["entries", 1, "rests_on"], ["exact", "exact"], "each rung once"),
        (["entries", 1, "rung"], "balls", r"entries\[1\].rung: expected the first of rests_on, got 'balls'"),
        (["entries"], {}, "expected a list under 'entries'"),
        (["entries", 0], "x", r"entries\[0\]: expected an object"),
        (["entries", 0, "statement"], None, r"entries\[0\]: expected text under 'statement'"),
        (["entries", 2, "verdict", "outcome"], "passed", "expected one of proved, refuted, undecided"),
        (["entries", 2, "verdict", "reason"], None, "expected one of budget"),
        (["entries", 2, "verdict", "remaining"], [[1]], "expected lists of texts"),
        (["entries", 1, "verdict", "witness"], None, "expected text under 'witness'"),
        (["entries", 0, "verdict"], {"outcome": "proved", "statement": "", "detail": ""}, "'witness' is missing"),
        (["entries", 0, "checks", 0, "rung"], "guess", r"checks\[0\].rung: expected one of"),
        (["entries", 0, "checks", 0, "agrees"], "yes", "expected true, false or null"),
        (["entries", 1, "identifier"], "t01", "occurs 2 times"),
        (["entries", 0, "printed"], None, "expected text under 'printed'"),
        (["entries", 0, "verbatim"], False, r"entries\[0\].verbatim: False with 1 quotations"),
        (["entries", 1, "verbatim"], True, r"entries\[1\].verbatim: True with 0 quotations"),
        (["entries", 0, "quotations"], [], r"entries\[0\].lines: expected the lines"),
        (["entries", 0, "quotations"], None, "expected a list under 'quotations'"),
        (["entries", 0, "quotations", 0, "latex"], None, r"quotations\[0\]: expected text under 'latex'"),
        (["entries", 0, "quotations", 0, "first"], 9999, "first not after last"),
        (["entries", 0, "quotations", 0, "first"], True, "expected line numbers"),
        (["figures", 0, "caption"], 1, r"figures\[0\]: expected text under 'caption'"),
        (["figures", 0, "name"], "../index", r"figures\[0\].name: expected letters, digits"),
        (["certificates", 0, "name"], "../../x.cert", r"certificates\[0\].name: expected letters, digits"),
        (["certificates", 0, "verified"], "yes", r"certificates\[0\].verified: expected true or false"),
        (["certificates", 1, "verified"], True, r"certificates\[1\].said: it does not go with verified"),
        (["certificates", 0, "said"], "REJECTED", r"certificates\[0\].said: it does not go with verified"),
        (["claims", BARE, "standing"], "proved", rf"claims\[{BARE}\].standing: proved without an entry"),
        (["claims", 0, "lines"], [1], r"claims\[0\].lines: expected two line numbers"),
        (
            ["claims", 1, "standing"],
            "proved",
            r"claims\[1\].standing: the file says proved, its entries give undecided",
        ),
        (
            ["claims", 1, "standing"],
            "overtaken",
            r"claims\[1\].standing: the file says overtaken, its entries give undecided",
        ),
        (["claims", BARE, "standing"], "overtaken", rf"claims\[{BARE}\].standing: overtaken without an entry"),
        (["claims"], None, "expected a list under 'claims'"),
        (["claims", 0, "entries"], [["t01"]], r"claims\[0\].entries: expected texts"),
        (["standings", "refuted"], False, "standings: the file says"),
        (["entries", 0, "checks", 0], None, r"checks\[0\]: expected an object"),
        (["entries", 0, "routes", 0, "run"], False, r"entries\[0\].routes: they are not those of the checks"),
        (["entries", 0, "routes"], None, r"entries\[0\].routes: they are not those of the checks"),
        (["proofs", "a/b"], 64 * "0", "proofs: expected letters, digits"),
        (["entries", 0, "dependencies", "pages"], [1], r"entries\[0\].dependencies.pages: expected texts"),
        (["entries", 0, "lines"], [], r"entries\[0\].lines: expected the lines of the quotations"),
        (["entries", 0, "consequence"], {"reach": 1}, r"entries\[0\].consequence: expected text under 'reach'"),
        (
            ["entries", 0, "consequence"],
            {"reach": "none", "reason": 1, "why": "", "table": ""},
            r"entries\[0\].consequence: expected text under 'reason'",
        ),
        (
            ["entries", 0, "consequence"],
            {"reach": "far", "reason": "", "why": "", "table": ""},
            r"entries\[0\].consequence.reach: expected one of none, local, changes a conclusion",
        ),
        (["versions"], {"python": "3"}, "versions: expected text under"),
    ],
)
def test_malformed_data_is_rejected(report, path, value, message):
    broken = copy.deepcopy(report)
    set_in(broken, path, value)
    with pytest.raises(ValueError, match=message):
        checked(broken)
    assert checked(report) is report


@pytest.mark.parametrize("value", [None, [], "report", 1, {}])
def test_other_json_is_rejected(value):
    with pytest.raises(ValueError, match="report:"):
        checked(value)


def test_a_check_without_an_answer_is_rejected(report):
    del report["entries"][0]["checks"][0]["agrees"]
    with pytest.raises(ValueError, match="expected true, false or null"):
        checked(report)


@pytest.mark.parametrize("key", ["consequence", "formal"])
def test_an_entry_without_a_part_is_rejected(report, key):
    del report["entries"][0][key]
    with pytest.raises(ValueError, match=rf"entries\[0\]: {key!r} is missing"):
        checked(report)


def test_a_proof_on_points_and_a_verdict_on_nothing_are_rejected(report):
    on_points = copy.deepcopy(report)
    on_points["entries"][0] |= {"rests_on": ["points"], "rung": "points"}
    with pytest.raises(ValueError, match="a proof never rests on points"):
        checked(on_points)
    on_nothing = copy.deepcopy(report)
    on_nothing["entries"][0] |= {"rests_on": [], "rung": None}
    with pytest.raises(ValueError, match=r"rests_on: \[\] does not go with the outcome proved"):
        checked(on_nothing)
    undecided = copy.deepcopy(report)
    undecided["entries"][2] |= {"rests_on": ["page"], "rung": "page"}
    with pytest.raises(ValueError, match="does not go with the outcome undecided"):
        checked(undecided)


def test_the_rungs_are_counted_by_outcome(report):
    assert report["page_alone"] == 1
    assert {rung for rung, number in report["rungs"]["proved"].items() if number} == {"page"}
    assert {rung for rung, number in report["rungs"]["refuted"].items() if number} == {"exact"}


@pytest.mark.parametrize("standing", ["proved under a condition", "overtaken"])
def test_a_condition_without_words_is_no_condition(report, standing):
    row = report["claims"][1]
    row.update(entries=["t01"], standing=standing, why="β > 1")
    report["standings"] = {
        name: sum(row["standing"] == name for row in report["claims"]) for name in report["standings"]
    }
    assert checked(report) is report
    row["why"] = " "
    with pytest.raises(ValueError, match=rf"claims\[1\].why: {standing}, and nothing says by what"):
        checked(report)


def test_a_verdict_that_its_checks_do_not_give_is_rejected(report):
    """The counts agree: the row itself says more than what was checked."""
    alone = copy.deepcopy(report)
    alone["entries"][0]["checks"] = alone["entries"][0]["checks"][:1]
    with pytest.raises(ValueError, match=r"entries\[0\].verdict: the file says proved, its checks give undecided"):
        checked(alone)
    once = copy.deepcopy(report)
    once["entries"][1]["checks"][1]["agrees"] = None
    with pytest.raises(ValueError, match=r"entries\[1\].verdict: the file says refuted, its checks give undecided"):
        checked(once)
    bare = copy.deepcopy(report)
    bare["entries"][3]["verdict"] |= {"outcome": "proved", "reason": None}
    bare["entries"][3] |= {"rests_on": ["page"], "rung": "page"}
    bare["counts"] |= {"proved": 2, "undecided": 1}
    bare["rungs"]["proved"]["page"] = bare["page_alone"] = 2
    with pytest.raises(ValueError, match=r"entries\[3\].verdict: the file says proved, its checks give undecided"):
        checked(bare)


def test_a_rung_that_no_check_stands_on_is_rejected(report):
    report["entries"][0] |= {"rests_on": ["exact"], "rung": "exact"}
    report["rungs"]["proved"] |= {"exact": 1, "page": 0}
    report["page_alone"] = 0
    with pytest.raises(
        ValueError, match=r"entries\[0\].rests_on: the file says \['exact'\], its checks give \['page'\]"
    ):
        checked(report)


@pytest.mark.parametrize(
    ("run", "state"),
    [(1, "not run here"), ("no", "not run here"), (None, "not run here"), (True, "not run here"), (False, RUN_HERE)],
)
def test_a_formal_proof_that_no_check_rests_on_was_not_run(report, run, state):
    """A value that pages take for true is not true, and the words say the same."""
    formal = {"theorems": [{"name": "IWC", "statement": "", "file": ""}], "run": False, "state": "not run here"}
    entry = report["entries"][0]
    entry["formal"] = formal
    entry["routes"].append({"rung": "formal proof", "what": "IWC", "run": False})
    assert checked(report) is report
    formal |= {"run": run, "state": state}
    with pytest.raises(ValueError, match=r"entries\[0\].formal: run is"):
        checked(report)
