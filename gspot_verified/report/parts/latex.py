"""LaTeX of the paper as HTML, its formulas as MathML: no script and no font from elsewhere.

A passage that holds something this file does not know is not typeset: the caller shows its source then.
"""

from __future__ import annotations

import html
import re
import xml.etree.ElementTree as ElementTree
from collections.abc import Callable

_MACROS = {
    "eps": r"\varepsilon", "epsilon": r"\varepsilon", "Rset": r"\mathbb{R}", "pain": "Painlevé ",
    "cA": "A", "cB": "B", "cC": "C", "cD": "D",
    "pP": r"\mathcal{P}", "bB": r"\mathcal{B}", "yY": r"\mathcal{Y}", "vV": r"\mathcal{V}", "jJ": r"\mathcal{J}",
    "beq": r"\begin{equation}", "eeq": r"\end{equation}",
    "mathsterling": "£", "mbox": r"\text", "bf": "", "nonumber": "", "dddot": r"\dddot", "allowbreak": "",
}  # fmt: skip
# How many children each element has.
_PARTS = {"mfrac": 2, "msub": 2, "msup": 2, "msubsup": 3, "munder": 2, "mover": 2, "munderover": 3, "mroot": 2}
_WORDS = {"mi", "mo", "mn", "mtext"}  # which hold text alone
_ELEMENTS = {*_PARTS, *_WORDS, "math", "mrow", "mspace", "msqrt", "mtable", "mtr", "mtd", "mstyle"}
_ELEMENTS |= {"mpadded", "mphantom", "menclose"}
_ATTRIBUTES = {
    "display", "mathvariant", "displaystyle", "scriptlevel", "columnalign", "rowspacing", "columnspacing", "rowlines",
    "columnlines", "stretchy", "fence", "form", "separator", "accent", "accentunder", "movablelimits", "width",
    "minsize", "maxsize", "linethickness", "largeop", "symmetric", "lspace", "rspace", "notation", "mathsize",
}  # fmt: skip
_DISPLAYS = "equation|align|multline|eqnarray|gather|displaymath"
_FORMULA = re.compile(
    rf"\\begin\{{(?P<name>{_DISPLAYS})\*?\}}(?P<display>.*?)\\end\{{(?P=name)\*?\}}"
    r"|\$\$(?P<dollars>.+?)\$\$|\\\[(?P<brackets>.+?)\\\]|\$(?P<inline>.+?)\$|\\\((?P<round>.+?)\\\)",
    re.DOTALL,
)
_TABULAR = re.compile(r"\\begin\{tabular\}\{[^}]*\}(.*?)\\end\{tabular\}", re.DOTALL)
_TITLED = {"theorem": "Theorem", "lemma": "Lemma", "corollary": "Corollary", "proof": "Proof", "remark": "Remark"}
_DROPPED = (
    r"\\(?:label|includegraphics|vspace|hspace|cite)(?:\[[^\]]*\])?\{[^}]*\}",
    r"\\(?:begin|end)\{(?:center|figure|table)\*?\}(?:\[[^\]]*\])?",
    r"\\(?:noindent|centering|bigskip|medskip|smallskip|newpage)\b",
    r"\\/",
)


class NotTypeset(ValueError):
    """The passage holds a command that is not known here."""


def latex_formula(source: str, display: bool = False) -> str:
    """One formula as a MathML element.

    :raises NotTypeset: a command is unknown, or a brace is not closed.

    >>> "<mfrac>" in latex_formula(r"\\frac{\\alpha}{2}")
    True
    >>> latex_formula(r"\\unknown{x}")
    Traceback (most recent call last):
    ...
    gspot_verified.report.parts.latex.NotTypeset: \\unknown
    """
    from latex2mathml.converter import convert
    from latex2mathml.exceptions import (
        DenominatorNotFoundError,
        DoubleSubscriptsError,
        DoubleSuperscriptsError,
        ExtraLeftOrMissingRightError,
        InvalidAlignmentError,
        InvalidStyleForGenfracError,
        InvalidWidthError,
        LimitsMustFollowMathOperatorError,
        MissingEndError,
        MissingSuperScriptOrSubscriptError,
        NoAvailableTokensError,
        NumeratorNotFoundError,
    )

    faults = (
        DenominatorNotFoundError, DoubleSubscriptsError, DoubleSuperscriptsError, ExtraLeftOrMissingRightError,
        InvalidAlignmentError, InvalidStyleForGenfracError, InvalidWidthError, LimitsMustFollowMathOperatorError,
        MissingEndError, MissingSuperScriptOrSubscriptError, NoAvailableTokensError, NumeratorNotFoundError,
        IndexError, StopIteration,
    )  # fmt: skip
    try:
        element = convert(_prepared(source), display="block" if display else "inline")
    except faults as error:
        raise NotTypeset(str(error) or type(error).__name__) from error
    unknown = re.search(r"\\[A-Za-z]+", html.unescape(element))
    if unknown:
        raise NotTypeset(unknown[0])
    _check(element)
    return element


def _check(markup: str) -> None:
    """That the markup is MathML with all its parts and nothing else: texts in a formula are not escaped by the reader.
    And that HTML reads it as XML does: a comment ``<!-->`` ends at once there, and in a text ``<mi/>`` stays open.

    :raises NotTypeset: it is not.
    """
    if re.search(r"<[!?]", markup):
        raise NotTypeset("a comment, or its like")
    try:
        elements = list(ElementTree.fromstring(markup).iter())
    except ElementTree.ParseError as error:
        raise NotTypeset(f"no MathML: {error}") from error
    for element in elements:
        name = element.tag.rpartition("}")[2]
        if name not in _ELEMENTS or not _ATTRIBUTES.issuperset(element.attrib):
            raise NotTypeset(f"no element of a formula: {name} {' '.join(element.attrib)}")
        if len(element) != (0 if name in _WORDS else _PARTS.get(name, len(element))):
            raise NotTypeset(f"{name} with {len(element)} parts")


def latex_html(source: str, number: Callable[[str], str | None]) -> str:
    """A passage as HTML paragraphs with MathML; ``number`` gives the printed number of a label.

    :raises NotTypeset: something in it is not known here.
    """
    text = _expanded(re.sub(r"(?<!\\)%.*", "", source))
    text = re.sub(r"\\item\[([^\]]*)\]", r"\\item \1", text)  # the title may hold formulas
    if r"\multicolumn" in text and not _TABULAR.search(text):
        return _table(text, number)  # lines from inside a table
    words = re.sub(r"\\(?:ref|eqref|cite)\{[^}]*\}", "", text)  # names may hold an underscore
    if not _FORMULA.search(words) and re.search(r"[_^]|&\s*=", words):
        return f"<p>{_display(text)}</p>"  # lines from inside an alignment
    parts = _TABULAR.split(text)
    return "\n".join(
        _table(part, number) if index % 2 else _paragraphs(part, number)
        for index, part in enumerate(parts)
        if part.strip()
    )


def _paragraphs(text: str, number: Callable[[str], str | None]) -> str:
    paragraphs = [part.strip() for part in re.split(r"\n\s*\n", _line(text, number))]
    return "\n".join(f"<p>{part}</p>" for part in paragraphs if part)


def _line(text: str, number: Callable[[str], str | None]) -> str:
    """Words and formulas, without paragraphs."""
    pieces: list[str] = []
    place = 0
    for match in _FORMULA.finditer(text):
        pieces.append(_prose(text[place : match.start()], number))
        pieces.append(_formula(match))
        place = match.end()
    pieces.append(_prose(text[place:], number))
    return "".join(pieces)


def _table(body: str, number: Callable[[str], str | None]) -> str:
    """The rows of a tabular; cells over several columns keep their width."""
    body = re.sub(r"\\(?:hline|cline\{[^}]*\})", "", body)
    rows = []
    for row in re.split(r"\\\\", body):
        if not row.strip():
            continue
        cells = []
        for cell in row.split("&"):
            wide = re.fullmatch(r"\s*\\multicolumn\{(\d+)\}\{[^}]*\}\{(.*)\}\s*", cell, re.DOTALL)
            span = f' colspan="{wide[1]}"' if wide and wide[1] != "1" else ""
            cells.append(f"<td{span}>{_line(wide[2] if wide else cell, number).strip()}</td>")
        rows.append(f"<tr>{''.join(cells)}</tr>")
    return f'<div class="scroll"><table>{"".join(rows)}</table></div>'


def _formula(match: re.Match[str]) -> str:
    inline = match["inline"] or match["round"]
    if inline is not None:
        return latex_formula(inline)
    return _display(match["display"] or match["dollars"] or match["brackets"])


def _display(body: str) -> str:
    """A displayed formula, of several lines where it has them."""
    body = re.sub(r"&\s*=\s*&", "&=", body.strip()).removesuffix(r"\\")
    if re.search(r"&|\\\\", re.sub(r"\\begin\{(\w+)\}.*?\\end\{\1\}", "", body, flags=re.DOTALL)):
        body = rf"\begin{{align*}}{body}\end{{align*}}"
    parts = re.split(r"(?<=,)\s*\\q?quad(?![A-Za-z])", body) if r"\begin" not in body else [body]
    if len(parts) > 1 and all(_closed(part) for part in parts):
        formulas = (f'<span class="part">{latex_formula(part, display=True)}</span>' for part in parts)
        return f'<span class="display">{"".join(formulas)}</span>'  # a line can break between them
    return f'<span class="display">{latex_formula(body, display=True)}</span>'


def _closed(part: str) -> bool:
    """Whether no group goes on in the next part."""
    bare = re.sub(r"\\[{}]", "", part)
    return bare.count("{") == bare.count("}") and part.count(r"\left") == part.count(r"\right")


def _expanded(text: str) -> str:
    for name, meaning in _MACROS.items():
        text = re.sub(rf"\\{name}(?![A-Za-z])", meaning.replace("\\", r"\\"), text)
    return text


def _prepared(source: str) -> str:
    """Without labels, without macros, and with no formula inside a text."""
    text = _expanded(re.sub(r"\\label\{[^}]*\}", "", source))

    def opened(match: re.Match[str]) -> str:
        pieces = match[1].split("$")
        return "".join(piece if i % 2 else rf"\text{{{piece}}}" for i, piece in enumerate(pieces) if piece)

    return re.sub(r"\\text\{([^{}]*\$[^{}]*)\}", opened, text)


def _prose(text: str, number: Callable[[str], str | None]) -> str:
    for pattern in _DROPPED:
        text = re.sub(pattern, "", text)

    def reference(match: re.Match[str]) -> str:
        label = number(match[2])
        if label is None:
            return f"[{match[2]}]"
        bare = label.rpartition(" ")[2].strip("()")
        return bare if match[1] == "ref" else f"({bare})"

    text = re.sub(r"\\(eqref|eq|ref|autoref)\{([^}]*)\}", reference, text)
    text = re.sub(r"\\'\{?e\}?", "é", text).replace("``", "“").replace("''", "”").replace("~", "\u00a0")
    text = text.replace("---", "—").replace("--", "–").replace(r"\&", "&").replace(r"\%", "%")
    text = html.escape(text, quote=False)
    text = re.sub(r"\\begin\{(\w+)\}(?:\[([^\]]*)\])?", _opening, text)
    text = re.sub(r"\\end\{(theorem|lemma|corollary|proof|remark|itemize|enumerate|description)\}", "\n\n", text)
    text = re.sub(r"\\item\b", "\n\n• ", text)
    text = re.sub(r"\\(?:sub)*section\*?\{([^{}]*)\}", r"<b>\1.</b>", text)
    text = re.sub(r"\\(?:emph|textit)\{([^{}]*)\}|\{\\(?:em|it)\b\s*([^{}]*)\}", r"<em>\1\2</em>", text)
    text = re.sub(r"\\(?:textbf|paragraph\*?)\{([^{}]*)\}", r"<b>\1</b>", text)
    text = re.sub(r"\\(?:caption|footnote|text)\{", "{", text).replace(r"\\", " ")
    unknown = re.search(r"\\[A-Za-z]+|\\.", text)
    if unknown:
        raise NotTypeset(unknown[0])
    return text.replace("{", "").replace("}", "")


def _opening(match: re.Match[str]) -> str:
    if match[1] in ("itemize", "enumerate", "description"):
        return ""
    if match[1] not in _TITLED:
        raise NotTypeset(match[0])
    title = _TITLED[match[1]] + (f" ({match[2]})" if match[2] else "")
    return f"\n\n<b>{title}.</b> "
