"""The pages of the report, from the data of ``report.json`` and the files that it names."""

from __future__ import annotations

import base64
import hashlib
import re
import tomllib
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from functools import lru_cache
from importlib import resources
from typing import TYPE_CHECKING, Any, NamedTuple
from urllib.parse import quote

from flint import fmpq

from gspot_verified.cost.measurement.file import recorded
from gspot_verified.cost.measurement.measurement import Measurement
from gspot_verified.numbers.balls import Exact, ball_text
from gspot_verified.numbers.verdict import Outcome, Reason
from gspot_verified.paper.checks.entry import Rung
from gspot_verified.paper.checks.paper import printed_number
from gspot_verified.paper.claims import WHY, Standing
from gspot_verified.report.data import checked
from gspot_verified.report.parts.cost_page import shown_measurement
from gspot_verified.report.parts.dependency_graph import Node, graph_svg
from gspot_verified.report.parts.errata_items import TITLES, errata
from gspot_verified.report.parts.formulas import typeset
from gspot_verified.report.parts.glossary import glossary, linked_at_first_use
from gspot_verified.report.parts.latex import NotTypeset, latex_formula, latex_html
from gspot_verified.report.parts.latex_text import source_latex
from gspot_verified.report.parts.proof_page import linked_pages, page_title, proof_html, proof_text

if TYPE_CHECKING:
    from jinja2 import Environment
    from markupsafe import Markup


MACHINE_CHECKED = "machine-checked"
"""The result whose statements are formal ones: they stand beside it in full."""


class Passage(NamedTuple):
    """Words of a page of ``proofs/``, exactly as they stand there."""

    page: str
    text: str


@dataclass(frozen=True, slots=True)
class NewResult:
    """A result: ``before`` is what the paper has, ``says`` the result in short, ``passages`` its precise statement.

    ``entries``: statements of the ledger that carry it; ``command`` runs it again and then ``prints`` so; ``figure``:
    the name of a figure of the report.
    """

    key: str
    title: str
    before: str
    says: str
    passages: tuple[Passage, ...]
    entries: tuple[str, ...]
    command: str
    prints: str
    figure: str


@lru_cache(maxsize=1)
def new_results() -> tuple[NewResult, ...]:
    """The results, in the order of the page.

    >>> [result.key for result in new_results()][:2]
    ['sign', 'count-law']
    """
    text = resources.files("gspot_verified.report").joinpath("pages", "new.toml").read_text(encoding="utf-8")
    return tuple(
        NewResult(
            key=row["key"],
            title=row["title"],
            before=row["before"],
            says=row["says"],
            passages=tuple(Passage(one["page"], one["text"].strip()) for one in row["passages"]),
            entries=tuple(row["entries"]),
            command=row["command"],
            prints=row["prints"],
            figure=row["figure"],
        )
        for row in tomllib.loads(text)["results"]
    )


_LEDGER = re.compile(r"gspot_verified/paper/((?:\w+/)?)(\w+)\.py")


def code_address(path: str, function: str = "") -> str:
    """Where the page of a module is, and a function on it.

    >>> code_address("gspot_verified/paper/section_3/section_3.py", "_sides")
    'code-section_3.html#function-_sides'
    """
    match = _LEDGER.fullmatch(path)
    name = match[2] if match else "unknown"
    return f"code-{name}.html" + (f"#function-{function}" if function else "")


@lru_cache(maxsize=100)
def code_page(path: str) -> str:
    """The highlighted source as HTML; "" for what is no module of the ledger here."""
    from pygments import highlight
    from pygments.formatters import HtmlFormatter
    from pygments.lexers import PythonLexer

    match = _LEDGER.fullmatch(path)
    place = resources.files("gspot_verified.paper").joinpath(f"{match[1]}{match[2]}.py") if match else None
    if place is None or not place.is_file():
        return ""
    shown: str = highlight(place.read_text(encoding="utf-8"), PythonLexer(), HtmlFormatter(nowrap=True))
    lines = []
    for number, line in enumerate(shown.splitlines(), 1):
        name = re.match(
            r'<span class="k">def</span>\s*(?:<span class="w"> </span>)?<span class="nf">(\w+)</span>', line
        )
        address = f' id="function-{name[1]}"' if name else ""
        lines.append(f'<span class="line"{address}><i>{number}</i>{line}</span>')
    return "\n".join(lines)


SECTIONS = {
    "Section 1": "Introduction",
    "Section 2": "Preliminaries",
    "Section 3": "Numerical results for motivating example",
    "Section 4": "Asymptotic analysis of the motivating example",
    "Section 5": "Asymptotic analysis of a general system",
    "Section 6": "Application to a frictional impact oscillator, and Appendix B",
    "Section 7": "Conclusion",
    "Appendix A": "Generalised hypergeometric functions",
}
_ANSWERS = {True: "agrees", False: "fails", None: "could not tell"}
_COUNTEREXAMPLE = "single points: one certain counterexample is enough"
_COUNTEREXAMPLE_SHORT = "a counterexample at points"  # points carry no other verdict


def pages(report: dict[str, Any], measurement: Measurement | None = None) -> dict[str, str]:
    """Every page, by the name of its file. Texts are escaped; no page loads anything from elsewhere.

    :param measurement: what the page on cost shows; None: the one that comes with the package.
    :raises ValueError: the data is not a report of this schema, or a section has the address of another page.
    """
    report = checked(report)
    entries = [_shown(entry) for entry in report["entries"]]
    _link(entries, report)
    sections = _by_section(entries)
    proofs = _proofs(report, entries)
    claims = _claims(report["claims"], entries)
    common = {
        "entries": entries,
        "by_name": {entry["identifier"]: entry for entry in entries},
        "counts": report["counts"],
        "sections": {title: _address(title) for title in sections},
        "titles": SECTIONS,
        "versions": report["versions"],
        "proofs": proofs,
        "certificates": report["certificates"],
        "standings": {name.value: report["standings"][name.value] for name in Standing},
        "figures": report["figures"],
    }
    by_address = {page["address"]: _page("proof", common, name=name, page=page) for name, page in proofs.items()}
    for path in dict.fromkeys(entry["file"] for entry in entries if entry["code_address"]):
        by_address[code_address(path)] = _page("code", common, path=path, listing=code_page(path))
    start = _page("start", common, rungs=_rungs(report), page_alone=report["page_alone"])
    by_address |= {
        "index.html": linked_at_first_use(start, glossary()),
        "statements.html": _page("statements", common, **_script()),
        "claims.html": _page("claims", common, claims=claims),
        "new.html": _page("new", common, results=_new_results(common["by_name"], list(proofs))),
        "errata.html": _page("errata", common, errata=errata(entries), reach_titles=TITLES),
        "open.html": _page(
            "open",
            common,
            undecided=_with_outcome(entries, Outcome.UNDECIDED),
            undecided_claims=[claim for claim in claims if claim["standing"] == Standing.UNDECIDED.value],
        ),
        "glossary.html": _page("glossary", common, terms=glossary(), rungs=list(Rung)),
        "proofs.html": _page("proofs", common),
        "certificates.html": _page("certificates", common),
        "graph.html": _page("graph", common, graph=_safe(_graph(entries, proofs))),
        "figures.html": _page("figures", common),
        "cost.html": _page("cost", common, cost=shown_measurement(measurement or recorded())),
        "hard.html": _page("hard", common, hard=report["hard_cases"]),
        "trusted.html": _page("trusted", common),
    }
    for title, parts in sections.items():
        if _address(title) in by_address:
            raise ValueError(f"entries: the section {title[:60]!r} would hide the page {_address(title)[:80]}")
        by_address[_address(title)] = _page("section", common, title=title, parts=parts)
    return by_address


def style() -> str:
    """The style sheet of all pages."""
    return resources.files("gspot_verified.report").joinpath("pages", "style.css").read_text(encoding="utf-8")


def _page(template: str, common: dict[str, Any], **more: Any) -> str:
    return rendered(template, **{"script_hash": None, **common, **more})


def rendered(template: str, **values: Any) -> str:
    """The template ``<name>.html.j2`` with these values; texts are escaped."""
    return _environment().get_template(f"{template}.html.j2").render(values)


def _shown(entry: dict[str, Any]) -> dict[str, Any]:
    """An entry with the words that the page shows for its codes."""
    verdict = entry["verdict"]
    rests_on = [Rung[rung.upper()] for rung in entry["rests_on"]]
    file, _, function = entry["code"].partition(":")
    reason = verdict["reason"]
    return {
        **entry,
        "anchor": "entry-" + quote(entry["identifier"], safe=""),
        "address": _address(_main_section(entry)),
        "outcome": verdict["outcome"],
        "witness": verdict["witness"],
        "detail": verdict["detail"],
        "reason": Reason[reason.upper()].value.capitalize() + "." if reason else None,
        "remaining": [" × ".join(box) for box in verdict["remaining"]],
        "checks": [
            {**check, "rung": _rung_words(check), "answer": _ANSWERS[check["agrees"]]} for check in entry["checks"]
        ],
        "rests_on": [_COUNTEREXAMPLE_SHORT if rung is Rung.POINTS else rung.short for rung in rests_on],
        "rung_name": rests_on[0].short if rests_on else "none",
        "page_alone": rests_on == [Rung.PAGE],
        "formal": entry.get("formal"),
        "routes": entry.get("routes", []),
        "file": file,
        "function": function,
        "code_address": code_address(file, function) if code_page(file) else None,
    }


def _link(entries: Sequence[dict[str, Any]], report: dict[str, Any]) -> None:
    """What an entry names becomes links: to entries, pages and certificates that are there; and the way back."""
    by_name = {entry["identifier"]: entry for entry in entries}
    for entry in entries:
        named = entry["dependencies"]
        entry["used_by"] = []
        entry["depends_on"] = [by_name[name] for name in named["entries"] if name in by_name]
        entry["see_also"] = [by_name[name] for name in named["see_also"] if name in by_name]
        entry["pages"] = [name for name in named["pages"] if name in report["proofs"]]
        known = {certificate["name"] for certificate in report["certificates"]}
        entry["named_certificates"] = [name for name in named["certificates"] if name in known]
    for entry in entries:
        for other in entry["depends_on"]:
            other["used_by"].append(entry)


def _proofs(report: dict[str, Any], entries: Sequence[dict[str, Any]]) -> dict[str, dict[str, Any]]:
    """The proof pages that are here in the version that was meant, with who uses them."""
    texts = {name: proof_text(name, digest) for name, digest in report["proofs"].items()}
    here = {name: text for name, text in texts.items() if text is not None}
    by_name: dict[str, dict[str, Any]] = {}
    for name, text in here.items():
        by_name[name] = {
            "address": f"proof-{name}.html",
            "title": page_title(text),
            "body": _safe(proof_html(name, text, list(here))),
            "links": [other for other in linked_pages(text) if other in here],
            "used_by_entries": [entry for entry in entries if name in entry["pages"]],
        }
    for name, page in by_name.items():
        page["used_by_pages"] = [other for other, known in by_name.items() if name in known["links"]]
    return by_name


def _graph(entries: Sequence[dict[str, Any]], proofs: dict[str, dict[str, Any]]) -> str:
    statements = [
        Node(entry["identifier"], f"{entry['address']}#{quote(entry['anchor'])}", entry["outcome"]) for entry in entries
    ]
    nodes = statements + [Node(f"{name}.md", page["address"], "page") for name, page in proofs.items()]
    arrows = {
        entry["identifier"]: [other["identifier"] for other in entry["depends_on"]]
        + [f"{name}.md" for name in entry["pages"]]
        for entry in entries
    }
    arrows |= {f"{name}.md": [f"{other}.md" for other in page["links"]] for name, page in proofs.items()}
    return graph_svg(nodes, arrows)


def _claims(claims: Sequence[dict[str, Any]], entries: Sequence[dict[str, Any]]) -> list[dict[str, Any]]:
    by_name = {entry["identifier"]: entry for entry in entries}
    labels = {standing.value: words.capitalize() for standing, words in WHY.items()}
    return [
        {
            **claim,
            "entries": [by_name[name] for name in claim["entries"] if name in by_name],
            "named": [entry for name, entry in by_name.items() if _names(claim["why"], name)],
            "label": labels.get(claim["standing"], ""),
        }
        for claim in claims
    ]


def _names(words: str, name: str) -> bool:
    """Whether a text names an entry."""
    return name in words and re.search(rf"(?<![\w-]){re.escape(name)}(?![\w-])", words) is not None


def _new_results(by_name: dict[str, dict[str, Any]], proofs: Sequence[str]) -> list[dict[str, Any]]:
    """What is new, its passages set from the Markdown of the proof pages; formal statements where a report has them."""
    return [
        {
            **asdict(result),
            "passages": [
                {"page": page, "body": _safe(proof_html(page, text, proofs))} for page, text in result.passages
            ],
            "formal": [by_name[name] for name in result.entries if name in by_name and by_name[name]["formal"]]
            if result.key == MACHINE_CHECKED
            else [],
        }
        for result in new_results()
    ]


def _rungs(report: dict[str, Any]) -> list[tuple[Rung, int, int]]:
    rows = report["rungs"]
    return [(rung, rows["proved"][rung.name.lower()], rows["refuted"][rung.name.lower()]) for rung in Rung]


def _rung_words(check: dict[str, Any]) -> str:
    rung = Rung[check["rung"].upper()]
    return _COUNTEREXAMPLE if rung is Rung.POINTS and check["agrees"] is False else rung.value


def _with_outcome(entries: Sequence[dict[str, Any]], outcome: Outcome) -> list[dict[str, Any]]:
    return [entry for entry in entries if entry["outcome"] == outcome.value]


def _main_section(entry: dict[str, Any]) -> str:
    match = re.match(r"Section \d+|Appendix [A-Z]", entry["section"])
    return match[0] if match else entry["section"]


def _address(section: str) -> str:
    return re.sub(r"[^a-z0-9]+", "-", section.lower()).strip("-") + ".html"


def _by_section(entries: Sequence[dict[str, Any]]) -> dict[str, dict[str, list[dict[str, Any]]]]:
    """The entries under the sections of the paper and their parts, in order of first appearance."""
    sections: dict[str, dict[str, list[dict[str, Any]]]] = {}
    for entry in entries:
        sections.setdefault(_main_section(entry), {}).setdefault(entry["section"], []).append(entry)
    return sections


@lru_cache(maxsize=1)
def _environment() -> Environment:
    from jinja2 import Environment, PackageLoader, StrictUndefined

    environment = Environment(
        loader=PackageLoader("gspot_verified.report", "pages"),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
    )
    environment.filters |= {
        "typeset": _typeset,
        "formula": _formula,
        "passage": _passage,
        "transcription": _transcription,
        "inline": _safe,
        "exactly": _exactly,
    }
    return environment


def _safe(markup: str) -> Markup:
    """Markup made here, from escaped text."""
    from markupsafe import Markup

    return Markup(markup)


def _exactly(value: Exact) -> str:
    return str(value) if isinstance(value, fmpq) else ball_text(value)


def _typeset(text: str) -> Markup:
    return _safe(typeset(text))


def _formula(source: str) -> Markup | None:
    try:
        return _safe(latex_formula(source, display=True))
    except NotTypeset:
        return None


def _passage(source: str) -> Markup | None:
    try:
        return _safe(latex_html(source, _number))
    except NotTypeset:
        return None


def _transcription(source: str) -> Markup | None:
    """The short LaTeX of a printed form as words and formulas, so that a line can break between them."""
    return _passage(source_latex(source))


def _number(label: str) -> str | None:
    try:
        return printed_number(label) or "(unnumbered)"
    except KeyError:
        return None


def _script() -> dict[str, str]:
    """The search of the statements' page, and its hash: the page allows this script and no other."""
    script = resources.files("gspot_verified.report").joinpath("pages", "search.js").read_text(encoding="utf-8")
    digest = base64.b64encode(hashlib.sha256(script.encode()).digest()).decode()
    return {"script": _safe(script), "script_hash": f"sha256-{digest}"}
