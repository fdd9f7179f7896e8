"""A supplement to the paper as LaTeX: the errata, and what is proved beyond it with its formal statements.

Both texts are made from the entries of a ``report.json`` and say nothing but what these say.
"""

from __future__ import annotations

import re
import textwrap
from collections.abc import Mapping, Sequence
from typing import Any

from gspot_verified.numbers.verdict import Outcome
from gspot_verified.paper.checks.consequences import Reach
from gspot_verified.paper.checks.paper import paper_hash
from gspot_verified.report.data import checked
from gspot_verified.report.parts.errata_items import TITLES, Item, errata, places_of
from gspot_verified.report.parts.latex_text import escaped, source_latex, text_latex
from gspot_verified.report.parts.proof_page import proof_text

PAPER = (
    "A. Nordmark, P. L. Várkonyi, A. R. Champneys: “Dynamics beyond dynamic jam; unfolding the Painlevé paradox "
    "singularity”"
)
VERSION = "manuscript of 10th May 2017 (arXiv:1707.08343, doi:10.48550/arXiv.1707.08343)"
THEOREMS: tuple[tuple[str, tuple[str, ...]], ...] = (
    ("An impact in Cases I and II", ("S-iwc", "C-cases-I-II")),
    ("Case II from the paper’s initial values", ("3-case-II-starts", "3-flight-persists")),
    ("The side of the lift-off in Case III", ("S-side", "S-switching", "C-lift-off")),
    ("The side for every mechanism of Case III, and near the expansion, for all small ε", ("5-rule", "5-side")),
    ("The impact in Case III, below an explicit ε", ("S-iwc-case-III", "C-iwc-case-III")),
    ("Which trajectory is distinguished", ("4-unique", "4-unique-smooth", "4-behaves-like")),
    ("The expansion of Theorem 1", ("5-theorem-1", "5-theorem-1-orders", "5-theorem-1-spaces")),
)
"""What is new, by the entries that say it."""
PAGES = ("count_law",)
"""Proof pages with a theorem that no entry says."""
ERRATA_PAGES = 2
"""What a journal prints."""
SHOWN = "This text shows what report.json says: writing it checks nothing. "
"""In both texts: whoever can write the file can write anything there."""
_WIDTH = 124
"""Letters of a line of a formal statement in the size and on the page of ``theorems.tex``."""
_PREAMBLE = r"""\documentclass[10pt,a4paper%(options)s]{article}
\usepackage[margin=%(margin)s]{geometry}
\usepackage{amsmath,amssymb}
\renewcommand{\epsilon}{\varepsilon}
\newcommand{\eps}{\varepsilon}
\newcommand{\becomes}{$\;\longrightarrow\;$ }
\setlength{\parindent}{0pt}
\setlength{\emergencystretch}{3em}
\raggedbottom
\raggedright
\frenchspacing
\begin{document}
"""


def supplement(report: dict[str, Any]) -> dict[str, str]:
    """``errata.tex`` and ``theorems.tex`` from the data of a ``report.json``; plain ASCII, for pdfLaTeX.

    :raises ValueError: the data is not a report of this schema.
    """
    report = checked(report)
    return {"errata.tex": errata_text(report), "theorems.tex": theorems_text(report)}


def errata_text(report: Mapping[str, Any]) -> str:
    """The errata: printed form, correct form, reason and the command that shows it, for each refuted statement."""
    groups = errata(report["entries"])
    number = sum(len(items) for items in groups.values())
    pieces = [
        _PREAMBLE % {"options": ",twocolumn", "margin": "15mm"},
        r"\setlength{\columnsep}{7mm}\pagestyle{empty}" + "\n",
        r"\newcounter{item}\newcommand{\erratum}[4]{\stepcounter{item}\par\vspace{2.2pt plus 1pt}"
        r"\textbf{\arabic{item}. #1}: #2 \emph{#3} \texttt{[#4]}}" + "\n",
        r"\twocolumn[{\Large\bfseries Errata}\par\smallskip" + "\n",
        f"{escaped(PAPER)}, {escaped(VERSION)}.\\par\\smallskip\n",
        r"{\footnotesize " + _about_the_errata(number, report) + r"\par}\medskip]" + "\n",
        r"\footnotesize" + "\n",
    ]
    if not groups:
        pieces.append("No statement of the paper is refuted.\n")
    for reach, items in groups.items():
        pieces.append(f"\\par\\medskip\\textbf{{\\normalsize {escaped(TITLES[reach])}}}\\par\n")
        pieces += [_erratum(item, reach) for item in items]
    return "".join([*pieces, "\\end{document}\n"])


def _about_the_errata(number: int, report: Mapping[str, Any]) -> str:
    return escaped(
        f"{SHOWN}{number} item{'' if number == 1 else 's'}: printed form, corrected form, reason. Sections, equations, "
        f"figures and l. (lines of the LaTeX source, SHA-256 {paper_hash()[:16]}…) are those of this manuscript; the "
        "journal’s version was not compared, so that its numbers may differ and its pages are not given. Each item "
        "was found by two derivations, and can be run again with the name in brackets: "
    ) + (
        rf"\texttt{{gspot-verified verify NAME}} (version {escaped(report['versions']['gspot-verified'])}); "
        "it ends with exit code 1 where the printed form is refuted. How far an error reaches is a reading of the "
        "paper, not a proof."
    )


def _erratum(item: Item, reach: Reach | None) -> str:
    forms = " ".join(
        _sentence(source_latex(entry["source"]) + r" \becomes{}" + text_latex(entry["corrected"] or "not recorded"))
        for entry in item.entries
    )
    reasons = [text_latex(entry["consequence"]["reason"]) for entry in item.entries if entry["consequence"]]
    if reach is Reach.CONCLUSION:
        reasons += [text_latex(entry["consequence"]["why"]) for entry in item.entries]
    names = ", ".join(escaped(entry["identifier"]) for entry in item.entries)
    lines = f" (l.~{escaped(item.lines)})" if item.lines else ""
    arguments = (escaped(item.places) + lines, forms, " ".join(reasons), names)
    return r"\erratum" + "".join(f"{{{argument}}}" for argument in arguments) + "\n"


def _sentence(text: str) -> str:
    return text if text.endswith(".") else f"{text}."


def theorems_text(report: Mapping[str, Any]) -> str:
    """What is proved beyond the paper, each with its entries, its proof pages and its formal statements in full."""
    by_name = {entry["identifier"]: entry for entry in report["entries"]}
    pieces = [
        _PREAMBLE % {"options": "", "margin": "22mm"},
        r"{\Large\bfseries What is proved beyond the paper}\par\smallskip" + "\n",
        f"{escaped(PAPER)}, {escaped(VERSION)}.\\par\\medskip\n",
        escaped(
            f"{SHOWN}The numbers are those of this manuscript. A statement is a sentence of the ledger, with its "
            "verdict; its name in brackets runs its checks again: "
        )
        + rf"\texttt{{gspot-verified verify NAME}} (version {escaped(report['versions']['gspot-verified'])}). "
        + escaped(
            "Formal statements are Coq’s, in proofs/coq/ of the source; the terms that they use are defined in the "
            f"files that are named. Their proofs were {_of_the_proofs(report)}."
        )
        + "\\par\n",
    ]
    formal: dict[str, Mapping[str, str]] = {}
    for title, names in THEOREMS:
        entries = [by_name[name] for name in names if name in by_name]
        if entries:
            pieces.append(f"\\section*{{{text_latex(title)}}}\n")
        for entry in entries:
            pieces.append(_theorem(entry))
            formal |= {one["name"]: one for one in (entry["formal"] or {"theorems": []})["theorems"]}
    for name in PAGES:
        pieces.append(_page_theorem(name, report["proofs"].get(name, "")))
    if formal:
        pieces.append("\\section*{The formal statements}\n")
        pieces += [_formal_statement(one) for one in formal.values()]
    return "".join([*pieces, "\\end{document}\n"])


def _of_the_proofs(report: Mapping[str, Any]) -> str:
    """Whether the formal proofs were run for the report, in the words of its entries."""
    states = dict.fromkeys(entry["formal"]["state"] for entry in report["entries"] if entry["formal"])
    return "; ".join(states) or "not run here"


def _theorem(entry: Mapping[str, Any]) -> str:
    outcome = entry["verdict"]["outcome"]
    words = text_latex(entry["statement"])
    if outcome == Outcome.REFUTED.value:
        words = f"{words}: \\textbf{{not as printed}}. Correct: {text_latex(entry['corrected'])}"
    elif entry["corrected"]:
        words += f". Precisely: {text_latex(entry['corrected'])}"
    where = "; ".join(dict.fromkeys(places_of(entry)))
    rests = ", ".join(f"proofs/{page}.md" for page in entry["dependencies"]["pages"])
    said = [f"{outcome}; {where}"] + ([f"proof: {rests}"] if rests else [])
    if entry["formal"]:
        names = ", ".join(one["name"] for one in entry["formal"]["theorems"])
        said.append(f"formal: {names}" if entry["formal"]["run"] else f"formal, not run here: {names}")
    last = f"\\emph{{{escaped('. '.join(said))}.}} \\texttt{{[{escaped(entry['identifier'])}]}}"
    return f"\\par\\smallskip {_sentence(words)}\\\\ {{\\small{last}}}\n"


def _page_theorem(name: str, digest: str) -> str:
    """The theorem of a proof page and the names of its formal statements, where the page that was meant is here."""
    page = proof_text(name, digest) or ""
    theorem = re.search(r"^\*\*Theorem\.\*\* (.*?)(?:\n\n|\Z)", page, re.M | re.S)
    if theorem is None:
        return ""
    formal = re.search(r"^\*\*Formal proof\.\*\*(.*?)\n\n", page, re.M | re.S)
    names = re.findall(r"`(\w+)`", formal[1].split(" of `")[0]) if formal else []
    title = next(line.removeprefix("# ") for line in page.splitlines() if line.startswith("# "))
    said = f"proof: proofs/{name}.md" + (f". formal: {', '.join(names)} (proofs/coq/Statement.v)" if names else "")
    words = text_latex(" ".join(theorem[1].split()))
    return f"\\section*{{{text_latex(title)}}}\n{words}\\\\ {{\\small\\emph{{{escaped(said)}.}}}}\n"


def _formal_statement(one: Mapping[str, str]) -> str:
    """A statement of Coq, verbatim; its name alone where the source was not there."""
    statement = one["statement"].encode("ascii", "backslashreplace").decode()
    if not statement or r"\end{verbatim}" in statement:
        return f"\\par \\texttt{{{escaped(one['name'])}}}: its text is not in this report.\n"
    lines = [part for line in statement.splitlines() for part in _wrapped(line)]
    body = "\n".join(lines)
    return (
        f"\\par\\smallskip\\texttt{{{escaped(one['file'])}}}\n"
        f"{{\\scriptsize\\begin{{verbatim}}\n{body}\n\\end{{verbatim}}}}\n"
    )


def _wrapped(line: str) -> Sequence[str]:
    return textwrap.wrap(line, _WIDTH, subsequent_indent=" " * 6, break_on_hyphens=False) or [""]
