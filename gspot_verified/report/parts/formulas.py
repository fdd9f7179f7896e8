"""Mathematics as the proof pages and the ledger write it (``ξ_n``, ``e^(−x²)``, ``Σ_{n<M}``), typeset as HTML.

No script and no font from elsewhere: italic variables, raised and lowered indices. A page can be read without a
network, and a line of text can break inside a formula. Every character of the source stays, but for the marks
``_``, ``^`` and the braces around an index; ``<=``, ``*`` and their like become the signs that they stand for.
"""

from __future__ import annotations

import html
import re
from functools import lru_cache

_GREEK = "α-ωϑϕϱϵΑ-Ω"
_OPERATORS = "=<>≤≥≠≈∼~±∓·×∈∉⊂⊃∪∩→↦∞∂∇∫∑Σ∏Π√‖⌊⌋⌈⌉−∝≡∀∃"
_MARKS = re.compile(
    rf"[{_GREEK}{_OPERATORS}₀-₉⁰¹²³⁴-⁹⁺⁻ⁿℝℂℤℕ^]|[A-Za-z)\]]_[{{(A-Za-z0-9]|[|+\u0300-\u036f]|(?<![a-z])/|/(?![a-z])|(?<![A-Za-z])[A-Za-z]/[A-Za-z](?![A-Za-z])|\d[A-Za-z](?![A-Za-z])|"
    r"^[-−]?[A-Za-z]['′]*\("
)
_LETTER = re.compile(r"[A-Za-z]['′″]*")
_NUMBER = re.compile(r"[-−+]?\d[\d./]*[%]?")
_NAME = re.compile(r"[A-Za-z]{2,}(_[A-Za-z]{2,})+|[A-Za-z]{3,}/[A-Za-z]{3,}|\w+\.(md|py|toml|cert)|https?:.*")
_WORDS_OF_PROSE = {"a", "A", "I"}
_LISTED = re.compile(r"[(\[]*[aA],")
"""No article has a comma after it."""
_PANEL = re.compile(r"\([a-e]\)[.,;:!?]*")
"""A letter in brackets alone names a panel, or a part of a theorem."""
_TRAILING = ".,;:!?"
TYPED = {"<=": "≤", ">=": "≥", "!=": "≠", "->": "→", "-": "−"}
_LONG = re.compile(r"[A-Za-z]{4,}")
_PLURAL = r"['’]s(?![\w(])"
"""As in "the α's": no part of the formula before it."""


@lru_cache(maxsize=16_384)  # the same texts stand on several pages, and proof pages in every report
def typeset(text: str) -> str:
    """The text as HTML, its formulas typeset.

    >>> print(typeset("Let p_n be a term of e^(2x)."))
    Let <span class="formula"><i>p</i><sub><i>n</i></sub></span> be a term of \
<span class="formula"><i>e</i><sup>2<i>x</i></sup></span>.
    """
    return "".join(
        f'<span class="formula">{formula(part)}</span>' if is_formula else html.escape(part, quote=False)
        for is_formula, part in runs(text)
    )


def runs(text: str) -> list[tuple[bool, str]]:
    """The text in pieces, each with whether it is a formula.

    >>> runs("Let p_n be")
    [(False, 'Let'), (False, ' '), (True, 'p_n'), (False, ''), (False, ' '), (False, 'be')]
    """
    parts = re.split(rf"(\s+|{_PLURAL})", text)
    kinds = [_kind(part) for part in parts]
    pieces: list[tuple[bool, str]] = []
    run: list[str] = []

    def close() -> None:
        spaces = []
        while run and run[-1].isspace():
            spaces.append(run.pop())
        if run:
            words = "".join(run)
            body = words.rstrip(_TRAILING)
            pieces.extend([(True, body), (False, words[len(body) :])])
            run.clear()
        pieces.extend((False, space) for space in reversed(spaces))

    for index, (part, kind) in enumerate(zip(parts, kinds, strict=True)):
        following = next((k for k in kinds[index + 1 :] if k != "space"), "prose")
        if kind == "formula" or (run and kind == "number") or (kind == "number" and following == "formula"):
            run.append(part)
            if part[-1] in _TRAILING and not _is_open(run):
                close()
        elif run and (kind == "space" or (kind != "plural" and _is_open(run) and not _LONG.search(part))):
            run.append(part)
        else:
            close()
            pieces.append((False, part))
    close()
    return pieces


def _is_open(run: list[str]) -> bool:
    """Whether a bracket is open, so that the formula goes on after a comma; an interval may close with another."""
    text = "".join(run)
    return any(
        sum(map(text.count, opening)) > sum(map(text.count, closing)) for opening, closing in (("([", ")]"), ("{", "}"))
    )


def _kind(word: str) -> str:
    if word == "" or word.isspace():
        return "space"
    if re.fullmatch(_PLURAL, word):
        return "plural"
    bare = word.strip(_TRAILING + "()[]“”\"'")
    if _NAME.fullmatch(bare) or (re.search(r"[A-Za-z]{4,}", bare) and not re.search(rf"[{_GREEK}^=<>]", bare)):
        return "prose"
    if _MARKS.search(bare):
        return "formula"
    if _NUMBER.fullmatch(bare) or bare == "-":
        return "number"
    if (
        _LETTER.fullmatch(bare)
        and not _PANEL.fullmatch(word)
        and (bare not in _WORDS_OF_PROSE or _LISTED.fullmatch(word))
    ):
        return "formula"
    return "prose"


def formula(source: str) -> str:
    """A formula as HTML."""
    for typed, printed in TYPED.items():
        source = source.replace(typed, printed)
    pieces, place = [], 0
    while place < len(source):
        letter = source[place]
        if letter in "_^" and place + 1 < len(source):
            inner, place = index(source, place + 1, letter == "^")
            tag = "sub" if letter == "_" else "sup"
            pieces.append(f"<{tag}>{formula(inner)}</{tag}>")
        elif letter == "*" and place and source[place - 1].isalnum() and not follows(source, place + 1):
            pieces.append("<sup>*</sup>")
            place += 1
        elif letter == "*" and follows(source, place + 1):
            pieces.append("·")
            place += 1
        elif _is_letter(letter):
            end = place + 1
            while end < len(source) and (letter.isascii() and source[end].isascii() and source[end].isalpha()):
                end += 1
            while end < len(source) and "̀" <= source[end] <= "ͯ":  # an accent belongs to its letter
                end += 1
            pieces.append(_word(source[place:end]))
            place = end
        else:
            pieces.append(html.escape(letter, quote=False))
            place += 1
    return "".join(pieces)


def follows(source: str, place: int) -> bool:
    """Whether a factor comes next, so that a star is a product."""
    return place < len(source) and (source[place].isalnum() or source[place] == "(")


def _is_letter(letter: str) -> bool:
    return letter.isalpha() and letter != "ⁿ" and letter not in "ℝℂℤℕ"


def _word(word: str) -> str:
    """One or two letters are variables; capital Greek letters and longer words stand upright."""
    upright = (word.isascii() and len(word) > 2) or "Α" <= word[0] <= "Ω"
    return html.escape(word, quote=False) if upright else f"<i>{html.escape(word, quote=False)}</i>"


def index(source: str, start: int, raised: bool) -> tuple[str, int]:
    """The index that begins at ``start``, without its braces, and where it ends."""
    if source[start] in "{(":
        opening, closing = source[start], "}" if source[start] == "{" else ")"
        depth = 0
        for end in range(start, len(source)):
            depth += (source[end] == opening) - (source[end] == closing)
            if depth == 0:
                inner = source[start + 1 : end]
                # f^(n) is a derivative, e^(n + 1) a power.
                keep = raised and opening == "(" and re.fullmatch(r"\w|\d+", inner)
                return (source[start : end + 1] if keep else inner), end + 1
    pattern = r"[-−+]?(\d+|[A-Za-z]{3,}|[^\W\d_])[̀-ͯ]*['′]*(?:[*](?![\w(]))?" if raised else r"[^\W_]+[̀-ͯ]*|."
    match = re.compile(pattern).match(source, start)
    if match is None:
        return source[start], start + 1
    return match[0], match.end()
