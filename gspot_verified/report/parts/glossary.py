"""The glossary: what each term of the paper and of this report means, and where the paper defines it."""

from __future__ import annotations

import html
import re
import tomllib
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import lru_cache
from importlib import resources
from typing import NamedTuple

from gspot_verified.paper.checks.paper import printed_number

_MAIN = '<main id="main">'
_NO_LINK = "a|h1|h2|h3|figcaption|code|summary|label"
"""Elements in which no term is linked: titles, other links, and what only repeats the text."""


class Printed(NamedTuple):
    """A formula of the paper's source, and the lines in which it stands."""

    first: int
    last: int
    latex: str

    @property
    def formula(self) -> str:
        """The formula without the mark at which a display is aligned."""
        return self.latex.replace("&", "")


@dataclass(frozen=True, slots=True)
class Term:
    """An entry of the glossary. ``words``: how a text writes it; ``markup``: the same, as it is typeset.

    ``cites``: labels of the paper, or lines of its source; ``printed``: a formula that stands there; ``pages``: the
    proof pages that define it.
    """

    key: str
    title: str
    words: tuple[str, ...]
    meaning: str
    cites: tuple[str, ...]
    printed: Printed | None
    pages: tuple[str, ...]
    markup: tuple[str, ...] = ()

    @property
    def cited(self) -> tuple[str, ...]:
        """What the paper prints for the labels; lines as they are.

        :raises KeyError: the paper has no such label.
        """
        return tuple(name if name.startswith("line") else printed_number(name) or name for name in self.cites)

    @property
    def pattern(self) -> re.Pattern[str] | None:
        """The term in a page: as a word, or as it is typeset; None for one that is not told from other words."""
        words = (rf"(?<![\w-]){re.escape(html.escape(word, quote=False))}(?![\w-])" for word in self.words)
        forms = [*map(re.escape, self.markup), *words]
        return re.compile("|".join(forms)) if forms else None


@lru_cache(maxsize=1)
def glossary() -> tuple[Term, ...]:
    """The terms, in the order of the page.

    >>> [term.title for term in glossary()][:2]
    ['G-spot', 'Painlevé parameter p']
    """
    text = resources.files("gspot_verified.report").joinpath("pages", "glossary.toml").read_text(encoding="utf-8")
    return tuple(
        Term(
            key=row["key"],
            title=row["title"],
            words=tuple(row["words"]),
            meaning=row["meaning"],
            cites=tuple(row["cites"]),
            printed=Printed(*row["printed"]) if "printed" in row else None,
            pages=tuple(row.get("pages", ())),
            markup=tuple(row.get("markup", ())),
        )
        for row in tomllib.loads(text)["terms"]
    )


def linked_at_first_use(page: str, terms: Iterable[Term]) -> str:
    """The page with a link to the glossary where each term first stands in its main text.

    >>> linked_at_first_use('<main id="main"><h1>Canard</h1><p>The canard, a canard.</p></main>', glossary())
    '<main id="main"><h1>Canard</h1><p>The <a href="glossary.html#canard">canard</a>, a canard.</p></main>'
    """
    for term in terms:
        if term.pattern is None:
            continue
        closed = [found.span() for found in re.finditer(rf"<({_NO_LINK})\b.*?</\1>|<[^>]*>", page, re.DOTALL)]
        places = term.pattern.finditer(page, page.index(_MAIN) + len(_MAIN), page.index("</main>"))
        first = next((place for place in places if _is_text(place.span(), closed)), None)
        if first is not None:
            link = f'<a href="glossary.html#{term.key}">{first[0]}</a>'
            page = page[: first.start()] + link + page[first.end() :]
    return page


def _is_text(place: tuple[int, int], closed: Sequence[tuple[int, int]]) -> bool:
    """Outside of every tag and of every element in which no term is linked; the place's own tags are whole."""
    return not any(start < place[1] and place[0] < end and not _within((start, end), place) for start, end in closed)


def _within(inner: tuple[int, int], outer: tuple[int, int]) -> bool:
    return outer[0] <= inner[0] and inner[1] <= outer[1]
