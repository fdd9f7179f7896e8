"""A ``report.json`` made by hand: rows that are proved without evidence, with counts that agree; markup in every text,
paths in names. Refused; or the pages show it as text, and say that they show a file and check nothing."""

from __future__ import annotations

import json
import os
import re
import tempfile
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from random import Random
from typing import Any

from attack.answers import AGREED, Answer, Attack, undecided, wrong

from gspot_verified.numbers.verdict import Outcome
from gspot_verified.paper.checks.entry import Check, Rung, Section
from gspot_verified.report.certificates import CheckedCertificate
from gspot_verified.report.data import report_data
from gspot_verified.report.write import render_report

SHOWS_A_FILE = "writing them checks nothing"
"""What every page says."""

_MARK = "<x-attack"
_MARKUP = (
    f"{_MARK}>", f'">{_MARK} a="', f"'>{_MARK}>", f"</code></pre>{_MARK}>", f"-->{_MARK}>", f"]]>{_MARK}>",
    rf"\text{{<!-->{_MARK}/>-->}}", rf"$\text{{<!-->{_MARK}/>-->}}$", rf"\mathrm{{<!-->{_MARK}/>-->}}",
    rf"$\text{{<![CDATA[{_MARK}>]]>}}$", rf"\text{{<?a?>{_MARK}/>}}", rf"\text{{<mi/>{_MARK}/>}}",
    rf"$\mbox{{a}}$ {_MARK}> \emph{{{_MARK}>}} \section{{{_MARK}>}}", rf"\begin{{theorem}}[{_MARK}>] x \end{{theorem}}",
    rf"\item[{_MARK}>] y", rf"\begin{{tabular}}{{l}} {_MARK}> & \multicolumn{{2}}{{l}}{{{_MARK}>}} \end{{tabular}}",
    f"x_{{{_MARK}>}} = e^({_MARK}>)", f"α_{_MARK}> ≤ β", "{{ 7 * 7 }}", "{% raw %}", "javascript:alert(1)", "\0",
    "\ud800", "&lt;x-attack>", "&#60;x-attack>", f"<!--{_MARK}>", f"<svg/onload=alert(1)>{_MARK}>",
)  # fmt: skip
_PATHS = (
    "../outside", "../../outside", "/tmp/outside", "a/b", "..", ".", "", "a\0b", "a.svg", "a" * 300, "%2e%2e%2fx",
    "C:\\x", "..\\x", "~root", "a\n", "a b", "index.html", "-rf",
)  # fmt: skip
_ROWS = ("proved", "refuted")


class _Outside(Exception):
    """A file was written outside of the folder of the pages."""


def attack(random: Random) -> Attack:
    """One forgery of a whole report."""
    make = random.choice((_without_evidence, _without_evidence, _with_markup, _with_markup, _with_paths, _with_links))
    seed = random.getrandbits(32)
    return Attack(f"report of {make.__name__.strip('_')}, Random({seed})", lambda: make(Random(seed)))


def _true_report(random: Random) -> dict[str, Any]:
    """A small report, as ``verify`` would write it."""
    rungs = [random.choice(list(Rung)[1:]) for _ in range(12)]
    entries = []
    for number in range(random.randint(1, 4)):
        agree = random.choice((True, True, False, None))
        checks = tuple(
            Check(rungs[3 * number + k], f"check {k} of {number}", random.choice((agree, agree, None)), f"finding {k}")
            for k in range(random.randint(0, 3))
        )
        section = random.choice(("Section 2", "Section 4.5", "Appendix A"))
        label = random.choice(("eq:t01", "line 1271", "nowhere"))
        says = f"S-{number}", label, r"\alpha = \frac{1}{2}", f"statement {number}"
        entries.append(Section(section).settled(*says, *checks, corrected="α > 0", note="a note"))
    certificates = [CheckedCertificate("one.cert", "a" * 64, True, "VERIFIED dΘ/dτ < 0", b"one")]
    report: dict[str, Any] = json.loads(json.dumps(report_data(entries, (), certificates)))
    report |= {"proofs": {}, "claims": [], "standings": dict.fromkeys(report["standings"], 0)}
    return report


def counted(report: dict[str, Any]) -> dict[str, Any]:
    """The same with counts that agree with the rows."""
    rows = report["entries"]
    outcomes = Counter(row["verdict"]["outcome"] for row in rows)
    report["counts"] = {name: outcomes[name] for name in report["counts"]}
    at = Counter((row["verdict"]["outcome"], row["rung"]) for row in rows)
    report["rungs"] = {name: {rung: at[name, rung] for rung in report["rungs"][name]} for name in report["rungs"]}
    report["page_alone"] = sum(row["rests_on"] == ["page"] for row in rows)
    standings = Counter(claim["standing"] for claim in report["claims"])
    report["standings"] = {name: standings[name] for name in report["standings"]}
    return report


def _written(report: dict[str, Any], folder: Path) -> dict[str, str] | None:
    """The pages; None: refused."""
    given = folder / "given"
    given.mkdir(exist_ok=True)
    (folder / "outside.svg").write_text("what a name leads to")
    (given / "report.json").write_text(json.dumps(report), encoding="utf-8")
    before = set(folder.rglob("*"))
    try:
        render_report(given / "report.json", given / "pages")
    except ValueError:
        return None
    except OSError as error:
        if error.strerror == "File name too long":
            return None
        raise
    more = set(folder.rglob("*")) - before - {given / "pages"}
    if any((given / "pages") not in path.parents for path in more):
        raise _Outside
    return {path.name: path.read_text(encoding="utf-8") for path in (given / "pages").glob("*.html")}


def _judged(report: dict[str, Any]) -> Answer:
    """Refused; or markup is text and every page says what it is."""
    with tempfile.TemporaryDirectory() as folder:
        try:
            made = _written(report, Path(folder))
        except _Outside:
            return wrong("a file was written outside of the folder of the pages")
    return AGREED if made is None else shown_as_text(made)


def shown_as_text(made: Mapping[str, str]) -> Answer:
    """No markup of the data is markup, no address leads out, and no page says more than that it shows a file."""
    for name, page in made.items():
        if _MARK in page:
            place = page.index(_MARK)
            return wrong(f"{name}: markup of the data: {page[max(0, place - 200) : place + 100]}")
        links = re.findall(r'(?:href|src|action)\s*=\s*"([^"]*)"', page)
        bad = [link for link in links if re.match(r"\s*[a-z][a-z0-9+.-]*:|/", link, re.I) or ".." in link.split("/")]
        if bad:
            return wrong(f"{name}: links to {bad[:3]}")
        if "49" in re.findall(r">\s*(49)\s*<", page):
            return wrong(f"{name}: a text was run as a template")
        if SHOWS_A_FILE not in page:
            return wrong(f"{name} does not say that it shows a file and checks nothing")
    return AGREED


def _without_evidence(random: Random) -> Answer:
    """A verdict that the row's checks do not give, with rungs and counts that agree with it."""
    report = _true_report(random)
    row = random.choice(report["entries"])
    wanted = random.choice(_ROWS)
    if row["verdict"]["outcome"] == wanted:
        row["checks"] = _taken_away(row["checks"], wanted, random)
        if _gives(row["checks"]) == wanted:
            return undecided("the checks that are left are enough")
    else:
        rungs = ["exact"] if random.random() < 0.5 else sorted(
            {check["rung"] for check in row["checks"]} - {"points"} or {"page"},
            key=[rung.name.lower() for rung in Rung].index,
        )  # fmt: skip
        row |= {"rests_on": rungs, "rung": rungs[0]}
        row["verdict"] |= {"outcome": wanted, "reason": None, "witness": "x = 1" if wanted == "refuted" else None}
    with tempfile.TemporaryDirectory() as folder:
        made = _written(counted(report), Path(folder))
    if made is None:
        return AGREED
    return wrong(f"a row that is {wanted} with the checks {row['checks']} is shown")


def _taken_away(checks: Sequence[dict[str, Any]], wanted: str, random: Random) -> list[dict[str, Any]]:
    kept = [dict(check) for check in checks]
    match random.randrange(4):
        case 0:
            return []
        case 1:
            return kept[:1]
        case 2:
            return [check | {"agrees": None} for check in kept]
        case _:
            return [check | {"agrees": wanted != "proved"} for check in kept]


def _gives(checks: Sequence[Mapping[str, Any]]) -> str:
    """The rule of the ledger, in the referee's own words: two different ones, one that settles, none that says no."""
    yes = [check for check in checks if check["agrees"] is True]
    no = [check for check in checks if check["agrees"] is False]
    settling = [check for check in yes if check["rung"] != "points"]
    if len({check["what"] for check in no}) > 1 and not settling:
        return "refuted"
    whole = len(yes) == len(checks) and len({check["what"] for check in yes}) > 1
    return "proved" if whole and settling else "undecided"


def _texts(data: Any, path: tuple[Any, ...] = ()) -> Iterator[tuple[Any, ...]]:
    """Where texts are."""
    for key, child in data.items() if isinstance(data, dict) else enumerate(data):
        if isinstance(child, dict | list):
            yield from _texts(child, (*path, key))
        elif isinstance(child, str):
            yield (*path, key)


def _put(report: Any, path: Sequence[Any], value: Any) -> None:
    for key in path[:-1]:
        report = report[key]
    report[path[-1]] = value


def _with_markup(random: Random) -> Answer:
    """Markup in one text, or in many."""
    report = _true_report(random)
    places = list(_texts(report))
    many = random.random() < 0.5
    for path in random.sample(places, len(places) // 3 if many else 1):
        if path[-1] in ("outcome", "rung", "reason") or {"rests_on", "routes"} & set(path) or path[0] == "schema":
            continue
        if (path[0], path[-1]) == ("certificates", "name"):  # that of a file: _with_paths
            continue
        _put(report, path, random.choice(_MARKUP))
    for row in report["entries"]:
        for route, check in zip(row["routes"], row["checks"], strict=False):  # else each forgery is refused for this
            route["what"] = check["what"]
        for quotation in row["quotations"]:
            quotation["latex"] = random.choice((quotation["latex"], random.choice(_MARKUP)))
    return _judged(report)


def _with_paths(random: Random) -> Answer:
    """Names that lead elsewhere, and a link in the place of a figure."""
    report = _true_report(random)
    bad = random.choice(random.choice((_PATHS[:2], _PATHS)))
    which = random.randrange(6)
    if which == 0:
        report["certificates"][0]["name"] = bad
    elif which == 1:
        report["figures"] = [{"name": bad, "title": "t", "caption": "c", "alternative": "a"}]
    elif which == 2:
        report["proofs"] = {bad: "0" * 64}
    elif which == 3:
        random.choice(report["entries"])["code"] = f"gspot_verified/paper/{bad}.py:f"
    elif which == 4:
        random.choice(report["entries"])["section"] = bad
    else:
        return _linked(report)
    return _judged(report)


def _linked(report: dict[str, Any]) -> Answer:
    """A figure that is a link to a file elsewhere: its text must not come into the pages."""
    report["figures"] = [{"name": "drawn", "title": "t", "caption": "c", "alternative": "a"}]
    with tempfile.TemporaryDirectory() as folder:
        secret = Path(folder) / "secret"
        secret.write_text("SECRET")
        given = Path(folder) / "given"
        (given / "figures").mkdir(parents=True)
        os.symlink(secret, given / "figures" / "drawn.svg")
        made = _written(report, Path(folder))
        copied = given / "pages" / "figures" / "drawn.svg"
        if made is not None and copied.is_file() and "SECRET" in copied.read_text():
            return wrong("a link out of the report's folder was followed")
    return AGREED


def _with_links(random: Random) -> Answer:
    """Entries, pages and certificates that are named and not there, or that collide with the report's own pages."""
    report = _true_report(random)
    row = random.choice(report["entries"])
    for key in row["dependencies"]:
        row["dependencies"][key] = [random.choice((*_MARKUP[:5], *_PATHS, "S-0", "S-1")) for _ in range(2)]
    for other in report["entries"]:
        other["section"] = random.choice(("index", "Statements", "proof majorant", "Section 2", "section-2", "STYLE"))
    made_outcomes = Counter(other["verdict"]["outcome"] for other in report["entries"])
    with tempfile.TemporaryDirectory() as folder:
        made = _written(report, Path(folder))
    if made is None:
        return AGREED
    shown = shown_as_text(made)
    if shown != AGREED:
        return shown
    refuted = sum(page.count('class="entry refuted" id=') for page in made.values())
    if refuted < made_outcomes[Outcome.REFUTED.value]:
        return wrong(f"of {made_outcomes['refuted']} refuted rows {refuted} are shown in their sections")
    return AGREED
