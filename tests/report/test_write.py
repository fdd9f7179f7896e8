import html
import json
import os
import re
from html.parser import HTMLParser

import pytest

from gspot_verified.ledger.entry import Check, Rung, settled
from gspot_verified.report import write
from gspot_verified.report.data import report_data


@pytest.fixture(scope="module")
def written(entries, pictures, tmp_path_factory):
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(write, "pictures", lambda _: pictures)
        directory = tmp_path_factory.mktemp("out") / "report"
        said = []
        assert write.write_report(entries, directory, said.append) == directory / "index.html"
        assert said[-2:] == ["writing report.json", "writing index.html"]
        return directory


@pytest.fixture(scope="module")
def page(written):
    return (written / "index.html").read_text(encoding="utf-8")


def row(page, entry):
    """The table row of an entry."""
    [found] = [part for part in re.findall(r"<tr id=.*?</tr>", page, re.S) if html.escape(entry.label) in part]
    return found


class Tags(HTMLParser):
    VOID = frozenset({"meta", "img", "br", "link"})

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
        assert self.open.pop() == tag


def parsed(page):
    tags = Tags()
    tags.feed(page)
    assert tags.open == []
    return tags


def test_files(written, pictures):
    found = sorted(str(path.relative_to(written)) for path in written.rglob("*") if path.is_file())
    assert found == sorted(["index.html", "report.json", *(f"figures/{p.name}.png" for p in pictures)])


def test_page_is_well_formed_and_asks_for_nothing_outside(page):
    assert page.startswith("<!DOCTYPE html>")
    tags = parsed(page)
    assert len(tags.ids) == len(set(tags.ids))
    assert all(link.startswith(("#", "data:image/svg+xml;base64,")) for link in tags.links)
    assert not {"script", "link", "iframe", "object"} & {tag for tag, _ in tags.seen}
    assert not any(name.startswith("on") for _, attributes in tags.seen for name in attributes)
    assert sum(link.startswith("data:") for link in tags.links) == 6


def test_links_inside_the_page_arrive(page):
    from urllib.parse import unquote

    tags = parsed(page)
    assert {unquote(link[1:]) for link in tags.links if link.startswith("#")} <= set(tags.ids)


def test_statements_are_shown_and_escaped(page, entries):
    for entry in entries:
        printed = [quotation.latex for quotation in entry.cited.quotations] or [entry.source]
        for text in (entry.statement, entry.label, entry.cited.printed, *printed, entry.corrected, entry.note):
            assert str(write._template().environment.from_string("{{ x }}").render(x=text)) in page
    assert "<script" not in page
    assert "<img src=x" not in page
    assert "<b>" not in page
    assert "found &lt;b&gt;it&lt;/b&gt;" in page


def test_counts_are_shown(page):
    shown = re.findall(r'<dt>(\w+)</dt><dd class="number">(\d+)</dd>', page)
    assert shown == [("proved", "1"), ("refuted", "1"), ("undecided", "2")]
    assert "4 statements in all." in page


def test_each_entry_has_its_own_badge_and_no_other(page, entries):
    for entry in entries:
        badges = re.findall(r'class="badge (\w+)">(\w+)<', row(page, entry))
        assert badges == [(entry.verdict.outcome.value,) * 2]


def test_verbatim_and_transcribed_are_told_apart(page, entries):
    assert [entry.verbatim for entry in entries[:2]] == [True, False]
    assert "Printed, verbatim: line 2453 of the source" in row(page, entries[0])
    assert "Printed, transcribed" not in row(page, entries[0])
    assert "eq. (A.8)" in row(page, entries[0])
    assert "Printed, transcribed" in row(page, entries[1])
    assert r"\Gamma(-\beta)&lt;0" in row(page, entries[1])
    assert f"{sum(entry.verbatim for entry in entries)} of\n4 statements" in page


def test_each_entry_says_what_it_rests_on(page, entries):
    shown = [re.findall(r'<span class="rests">(.*?)</span>', row(page, entry)) for entry in entries]
    assert shown == [["on a proof page alone"], ["on exact identity or certificate; balls over the whole set"], [], []]


def test_the_summary_counts_the_rungs(page):
    [table] = re.findall(r'<table class="rungs">.*?</table>', page, re.S)
    rows = re.findall(r'<th scope="row">(.*?)</th><td>(\d+)</td><td>(\d+)</td>', table)
    assert [row[1:] for row in rows] == [("0", "0"), ("0", "1"), ("1", "0"), ("0", "0"), ("0", "0")]
    assert "<strong>1</strong> of them rests on a proof page alone" in page


def test_a_refutation_at_points_is_a_counterexample():
    checks = [Check(Rung.POINTS, what, False, "f") for what in ("one point", "another point")]
    page = write.render_html(report_data([settled("Section", "a", "line 1", "x", "s", *checks)], []))
    assert '<span class="rests">on a counterexample at points</span>' in page
    assert page.count("By single points: one certain counterexample is enough.") == 2


def test_undecided_is_not_shown_as_passed(page, entries):
    rate = row(page, entries[2])
    assert "could not tell" in rate
    assert "agrees" not in rate
    assert "proved" not in rate
    assert "The stated budget ended before the question was settled." in rate
    assert "Boxes left (7, the first 5;" in rate
    assert "Nothing follows from this report about the undecided ones." in page
    assert "This is not a pass." in page


def test_refuted_shows_printed_corrected_witness_and_second_derivation(page):
    [section] = re.findall(r'<section id="refuted">.*?</section>', page, re.S)
    for text in (r"\Gamma(-\beta)&lt;0", r"\Gamma(-\beta)&gt;0", "4 &gt; 0", "all &gt; 0"):
        assert text in section
    assert "eq:t01" not in section


def test_the_undecided_section_holds_the_undecided_ones_and_no_other(page):
    [section] = re.findall(r'<section id="undecided">.*?</section>', page, re.S)
    assert "line 1302" in section
    assert "&lt;img src=x&gt;" in section
    assert "eq:t01" not in section
    assert "line 1271" not in section


def test_an_empty_ledger_shows_nothing_about_the_paper():
    page = write.render_html(report_data([], []))
    parsed(page)
    assert "shows nothing about the paper" in page
    assert "No statement is refuted." in page


def test_one_entry_reads_well(entries):
    page = write.render_html(report_data(entries[2:3], []))
    assert "1 statement in all." in page
    assert "the undecided one." in page


def test_json_is_sorted_and_the_same_twice(written, entries, pictures, tmp_path, monkeypatch):
    monkeypatch.setattr(write, "pictures", lambda _: pictures)
    write.write_report(entries, tmp_path)
    text = (written / "report.json").read_text(encoding="utf-8")
    assert (tmp_path / "report.json").read_text(encoding="utf-8") == text
    assert json.dumps(json.loads(text), indent=1, sort_keys=True, ensure_ascii=False) + "\n" == text


def test_json_round_trip_renders_the_same_page(written, tmp_path, page):
    path = write.render_from_json(written / "report.json", tmp_path / "again")
    assert path == tmp_path / "again" / "index.html"
    assert path.read_text(encoding="utf-8") == page


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (b"", "report.json: Expecting value"),
        (b"{", "report.json: "),
        (b"[]", "report.json: report: expected an object, got list"),
        (b'{"schema": 7}', "reads schema 3, the file has schema 7"),
        (b"\xff\xfe", "report.json: not UTF-8 text"),
        (b'{"schema": 3}', "expected a list under 'entries'"),
        (b"[" * 200_000, "report.json: nested too deeply"),
    ],
)
def test_a_bad_file_is_rejected_and_the_page_is_kept(tmp_path, content, message):
    (tmp_path / "report.json").write_bytes(content)
    (tmp_path / "index.html").write_text("good")
    with pytest.raises(ValueError, match=message):
        write.render_from_json(tmp_path / "report.json", tmp_path)
    assert (tmp_path / "index.html").read_text() == "good"


def test_a_file_that_is_too_large_is_rejected_before_it_is_read(tmp_path, monkeypatch):
    monkeypatch.setattr(write, "_MAX_FILE_BYTES", 3)
    (tmp_path / "report.json").write_text("[[[[")
    with pytest.raises(ValueError, match="larger than 3 bytes"):
        write.render_from_json(tmp_path / "report.json", tmp_path)


def test_a_failed_write_keeps_the_good_file_and_leaves_no_draft(tmp_path, monkeypatch):
    (tmp_path / "index.html").write_text("good")

    def fail(_):
        raise OSError("disk full")

    monkeypatch.setattr(os, "fsync", fail)
    with pytest.raises(OSError, match="disk full"):
        write._replace(tmp_path / "index.html", b"partial")
    assert [path.name for path in tmp_path.iterdir()] == ["index.html"]
    assert (tmp_path / "index.html").read_text() == "good"


def test_a_file_is_replaced_and_not_written_over(tmp_path):
    (tmp_path / "index.html").write_text("good")
    os.link(tmp_path / "index.html", tmp_path / "held")
    write._replace(tmp_path / "index.html", b"new")
    assert (tmp_path / "index.html").read_text() == "new"
    assert (tmp_path / "held").read_text() == "good"


def test_duplicate_entries_touch_no_file(entries, pictures, tmp_path, monkeypatch):
    monkeypatch.setattr(write, "pictures", lambda _: pictures)
    with pytest.raises(ValueError, match="occurs 2 times"):
        write.write_report([entries[0]] * 2, tmp_path)
    assert list(tmp_path.iterdir()) == []
