"""What is new against the paper: each result with its proof pages, the command that runs it again, and its figure."""

from __future__ import annotations

import tomllib
from dataclasses import dataclass
from functools import lru_cache
from importlib import resources
from typing import NamedTuple

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
