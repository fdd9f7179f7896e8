"""Texts of the ledger as LaTeX in plain ASCII: words escaped, formulas as ``formulas`` reads them, printed forms.

A short LaTeX source of a printed form is set only if it holds nothing but known commands; else its source is shown.
"""

from __future__ import annotations

import re
import unicodedata

from gspot_verified.report.parts.formulas import TYPED, follows, index, runs

_GREEK_NAMES = (
    "alpha beta gamma delta varepsilon zeta eta theta iota kappa lambda mu nu xi pi rho sigma tau upsilon phi chi "
    "psi omega Gamma Delta Theta Lambda Xi Upsilon Phi Psi Omega"
)
_GREEK = dict(zip("αβγδεζηθικλμνξπρστυφχψωΓΔΘΛΞΥΦΨΩ", _GREEK_NAMES.split(), strict=True))
_GREEK |= {"ϕ": "phi", "ϑ": "vartheta", "ς": "varsigma"}
_SIGNS = {
    "≤": "le", "≥": "ge", "≠": "ne", "≈": "approx", "∼": "sim", "~": "sim", "±": "pm", "∓": "mp", "·": "cdot",
    "×": "times", "∈": "in", "∉": "notin", "⊂": "subset", "⊃": "supset", "∪": "cup", "∩": "cap", "→": "to",
    "↦": "mapsto", "∞": "infty", "∂": "partial", "∇": "nabla", "∫": "int", "√": "surd",
    "∑": "sum", "Σ": "sum", "∏": "prod", "Π": "prod",
    "‖": "|", "⌊": "lfloor", "⌋": "rfloor", "⌈": "lceil", "⌉": "rceil", "∝": "propto", "≡": "equiv", "∀": "forall",
    "∃": "exists", "…": "ldots", "{": "{", "}": "}", "%": "%", "#": "#", "&": "&", "$": "$", "\\": "backslash",
    "ℝ": "mathbb{R}", "ℂ": "mathbb{C}", "ℤ": "mathbb{Z}", "ℕ": "mathbb{N}",
}  # fmt: skip
_ALONE = {"−": "-", "^": r"\wedge ", "_": r"\_"}
_RAISED = dict(zip("⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻ⁿ", "0123456789+-n", strict=True))
_LOWERED = dict(zip("₀₁₂₃₄₅₆₇₈₉", "0123456789", strict=True))
_PRIMES = {"'": "'", "′": "'", "″": "''", "‴": "'''"}
_ACCENTS = {"\u0300": "grave", "\u0301": "acute", "\u0302": "hat", "\u0303": "tilde", "\u0304": "bar"}
_ACCENTS |= {"\u0305": "bar", "\u0307": "dot", "\u0308": "ddot", "\u030a": "mathring", "\u030c": "check"}
_TEXT_ACCENTS = {"\u0300": "`", "\u0301": "'", "\u0302": "^", "\u0303": "~", "\u0308": '"', "\u030b": "H"}
_FUNCTIONS = {"sin", "cos", "tan", "exp", "log", "ln", "min", "max", "det", "lim", "arg"}
_WORDS = {
    "\\": r"\textbackslash{}", "{": r"\{", "}": r"\}", "$": r"\$", "&": r"\&", "#": r"\#", "%": r"\%", "_": r"\_",
    "^": r"\textasciicircum{}", "~": r"\textasciitilde{}", "<": r"\textless{}", ">": r"\textgreater{}",
    "|": r"\textbar{}", "“": "``", "”": "''", "‘": "`", "’": "'", "–": r"\textendash{}", "—": r"\textemdash{}",
    "…": r"\ldots{}",
    "\u00a0": "~", "−": "$-$",
}  # fmt: skip
_OTHERS = (
    "text frac tfrac sqrt quad qquad ldots cdots dots epsilon mathcal mathbb mathrm operatorname dddot ddddot iff "
    "Rightarrow not leq geq ll left right big bigl bigr Big prime eps Pi Sigma"
)
_KNOWN = {*_GREEK_NAMES.split(), *_SIGNS.values(), *_FUNCTIONS, *_ACCENTS.values(), *_OTHERS.split(), *" ,;:!{}_|"}
"""Commands that a printed form may hold; none of them reads a file or defines anything."""
_COMMAND = re.compile(r"\\([A-Za-z]+|.)", re.DOTALL)


def text_latex(text: str) -> str:
    """A text of the ledger as LaTeX; every character that is not ASCII becomes a command.

    >>> text_latex("β = α_3/α_1, 100 % of it")
    '$\\\\beta = \\\\alpha_{3}/\\\\alpha_{1}$, 100 \\\\% of it'
    """
    return "".join(f"${formula_latex(part)}$" if is_formula else escaped(part) for is_formula, part in runs(text))


def escaped(text: str) -> str:
    """Words as LaTeX, outside of formulas.

    >>> escaped("Nordmark & Várkonyi_1")
    "Nordmark \\\\& V\\\\'{a}rkonyi\\\\_1"
    """
    pieces: list[str] = []
    opening = True
    for letter in _decomposed(text):
        if letter in _TEXT_ACCENTS and pieces:
            pieces.append(rf"\{_TEXT_ACCENTS[letter]}{{{pieces.pop()}}}")
        elif letter == '"':
            pieces.append("``" if opening else "''")
        elif letter in _WORDS:
            pieces.append(_WORDS[letter])
        elif " " <= letter <= "~" or letter == "\n":
            pieces.append(letter)
        else:
            pieces.append(f"${_sign(letter)}$")
        opening = letter.isspace() or letter in "(["
    return "".join(pieces).replace("--", "-{}-")  # no ligature


def formula_latex(source: str) -> str:
    """A formula in the ledger's notation (``ξ_n``, ``e^(−x²)``) as LaTeX for a line of text.

    >>> print(formula_latex("ε^(2β/3) v\u0302 <= sqrt(g l)"))
    \\varepsilon^{2\\beta/3} \\hat{v} \\le \\sqrt{g l}
    """
    source = _decomposed(source).replace("+/-", "±").replace("...", "…")
    source = re.sub(r"(?<=\d)e(-?\d+)", r"·10^(\1)", source)
    for typed, printed in TYPED.items():
        source = source.replace(typed, printed)
    pieces: list[str] = []
    at = 0
    while at < len(source):
        piece, at = _piece(source, at)
        if piece[0] in "^'" and pieces and pieces[-1][0] == "^":
            pieces.append("{}")  # TeX takes one raised index alone
        pieces.append(piece)
    found = re.sub(r" +", " ", "".join(pieces))
    return re.sub(r"(\\[A-Za-z]+) (?=[^A-Za-z\\=<>+-]|$)", r"\1", found).strip()


def _decomposed(text: str) -> str:
    """Letters apart from their accents; signs such as ≠ as they are."""
    return "".join(unicodedata.normalize("NFD", letter) if letter.isalpha() else letter for letter in text)


def _piece(source: str, at: int) -> tuple[str, int]:
    """What one sign, word or index becomes, and where it ends."""
    letter = source[at]
    if letter in "_^" and at + 1 < len(source):
        inner, end = index(source, at + 1, letter == "^")
        return f"{letter}{{{formula_latex(inner)}}}", end
    for table, mark in ((_RAISED, "^"), (_LOWERED, "_")):
        if letter in table:
            end = next((k for k in range(at, len(source)) if source[k] not in table), len(source))
            return f"{mark}{{{''.join(table[sign] for sign in source[at:end])}}}", end
    if letter in _PRIMES:
        return _PRIMES[letter], at + 1
    if letter == "√" and source[at + 1 : at + 2] == "(":
        return _root(source, at + 1)
    if letter == "*":
        return ((r"\," if follows(source, at + 1) else "^{*}"), at + 1)
    if letter.isspace():
        return (r"\allowbreak " if at and source[at - 1] in ",;" else " "), at + 1
    if letter.isascii() and letter.isalpha():
        return _word(source, at)
    return _accented(source, _sign(letter), at + 1)


def _word(source: str, at: int) -> tuple[str, int]:
    """Letters of a variable, with their accents; functions and words upright."""
    word = re.compile("[A-Za-z]+").match(source, at)[0]  # type: ignore[index]  # a letter stands there
    end = at + len(word)
    if word == "sqrt" and source[end : end + 1] == "(":
        return _root(source, end)
    if word in _FUNCTIONS:
        return rf"\{word} ", end
    if len(word) > 2:
        return rf"\text{{ {word} }}" if source[at - 1 : at] == " " else rf"\text{{{word}}}", end
    return word[:-1] + _accented(source, word[-1], end)[0], _accented(source, word[-1], end)[1]


def _root(source: str, at: int) -> tuple[str, int]:
    inner, end = index(source, at, True)
    return rf"\sqrt{{{formula_latex(inner.removeprefix('(').removesuffix(')'))}}}", end


def _accented(source: str, base: str, at: int) -> tuple[str, int]:
    while at < len(source) and source[at] in _ACCENTS:
        base, at = rf"\{_ACCENTS[source[at]]}{{{base.strip()}}}", at + 1
    return base, at


def _sign(letter: str) -> str:
    """A sign inside a formula; what is not known is named by its number."""
    if letter in _GREEK:
        return rf"\{_GREEK[letter]} "
    if letter in _SIGNS:
        return rf"\{_SIGNS[letter]} " if _SIGNS[letter].isalpha() else rf"\{_SIGNS[letter]}"
    if letter in _ALONE:
        return _ALONE[letter]
    return letter if " " < letter <= "}" else rf"\text{{[U+{ord(letter):04X}]}}"


def source_latex(source: str) -> str:
    r"""The short LaTeX source of a printed form, as words and formulas that can break between them.

    >>> print(source_latex(r"\input{b}"))
    \texttt{\textbackslash{}input\{b\}}
    >>> print(source_latex(r"\text{starts }b(0),\ y>0"))
    starts $b(0)$, $y>0$
    """
    if not _is_known(source):
        return rf"\texttt{{{escaped(source)}}}"
    pieces: list[str] = []
    depth, start, at = 0, 0, 0

    def close(end: int) -> None:
        formula = re.sub(r"^(\\ |\s)+|(\\ |\s)+$", "", source[start:end])
        if formula:
            pieces.append(f"${formula}$")

    while at < len(source):
        gap = re.compile(r"(,?)(\\ |\\q?quad(?![A-Za-z]))\s*").match(source, at)
        if depth == 0 and source.startswith(r"\text{", at):
            close(at)
            end = source.index("}", at)
            pieces.append(escaped(source[at + len(r"\text{") : end].replace(r"\_", "_")))
            at = start = end + 1
        elif depth == 0 and gap:
            close(at)
            pieces.append(f"{gap[1]} " if gap[1] or gap[2] == r"\ " else "; ")
            at = start = gap.end()
        else:
            depth += {"(": 1, "[": 1, "{": 1, ")": -1, "]": -1, "}": -1}.get(source[at], 0)
            at += 2 if source[at] == "\\" else 1
    close(at)
    return re.sub(r" +", " ", "".join(pieces)).strip()


def _is_known(source: str) -> bool:
    """Known commands, ASCII, braces with their partners, and texts that are words alone."""
    rest = _COMMAND.sub("", source)
    depth = 0
    for letter in rest:
        depth += {"{": 1, "}": -1}.get(letter, 0)
        if depth < 0:
            return False
    texts = re.findall(r"\\text\{([^}]*)", source)
    return (
        depth == 0
        and source.isascii()
        and source.isprintable()
        and not re.search(r"[$%#&~]|\^\^|\\$", rest)
        and all(name in _KNOWN for name in _COMMAND.findall(source))
        and not any(re.search(r"[\\{$]", text.replace(r"\_", "_")) for text in texts)
    )
