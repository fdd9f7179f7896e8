"""What the paper says, claim by claim from its first line to its last, and what became of each claim.

The rows are data (``claims.toml``); the tests compare their lines with the paper's source where that is at hand.
"""

from __future__ import annotations

import enum
import tomllib
from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache
from importlib import resources
from typing import Any

from gspot_verified.numbers.verdict import Outcome


class Standing(enum.Enum):
    """What became of a claim."""

    PROVED = "proved"
    PROVED_UNDER = "proved under a condition"
    OVERTAKEN = "overtaken"
    REFUTED = "refuted"
    UNDECIDED = "undecided"
    PREMISE = "premise"
    NOT_CHECKABLE = "not checkable"


WHY = {Standing.PROVED_UNDER: "condition", Standing.OVERTAKEN: "known now"}
"""What the text beside a claim is, where its entries are proved and prove something else than its words."""


@dataclass(frozen=True, slots=True)
class PaperClaim:
    """A claim in lines ``first`` to ``last`` of the source, of which the first one begins with ``begins``.

    Either ``entries`` names entries of the ledger, or ``why`` says why there is none (a premise needs no reason).
    ``proved_as`` is the standing when all entries are proved: ``PROVED``; ``PROVED_UNDER`` where they prove less than
    the claim, and ``why`` is the condition; ``OVERTAKEN`` where the claim says that something is open or cannot be
    shown, and ``why`` is what is known now. Where ``why`` is not empty, it stands wherever the claim stands.
    """

    first: int
    last: int
    begins: str
    words: str
    entries: tuple[str, ...]
    without_entries: Standing | None
    why: str
    proved_as: Standing = Standing.PROVED

    def standing(self, outcomes: Mapping[str, Outcome]) -> Standing:
        """Refuted when one of its entries is, ``proved_as`` when all are proved; else undecided, or what the row says.

        >>> claim = PaperClaim(1, 2, "", "x", ("a", "b"), None, "")
        >>> claim.standing({"a": Outcome.PROVED, "b": Outcome.PROVED}), claim.standing({"a": Outcome.PROVED})
        (<Standing.PROVED: 'proved'>, <Standing.UNDECIDED: 'undecided'>)
        """
        if self.without_entries is not None:
            return self.without_entries
        found = {outcomes.get(name) for name in self.entries}
        if Outcome.REFUTED in found:
            return Standing.REFUTED
        return self.proved_as if found == {Outcome.PROVED} else Standing.UNDECIDED

    def to_json(self, outcomes: Mapping[str, Outcome]) -> dict[str, Any]:
        """Plain data for ``json.dumps``."""
        return {
            "lines": [self.first, self.last],
            "claim": self.words,
            "standing": self.standing(outcomes).value,
            "entries": list(self.entries),
            "why": self.why,
        }


_WITHOUT = {"premise": Standing.PREMISE, "not_checkable": Standing.NOT_CHECKABLE, "undecided": Standing.UNDECIDED}
_WITH = {"under": Standing.PROVED_UNDER, "overtaken": Standing.OVERTAKEN}


@lru_cache(maxsize=1)
def paper_claims() -> tuple[PaperClaim, ...]:
    """Every row of ``claims.toml``, in the order of the paper.

    >>> paper_claims()[0].first < paper_claims()[-1].first
    True
    """
    text = resources.files("gspot_verified.paper").joinpath("claims.toml").read_text(encoding="utf-8")
    return tuple(_claim(row) for row in tomllib.loads(text)["claims"])


def _claim(row: Mapping[str, Any]) -> PaperClaim:
    kind = next((key for key in _WITHOUT if key in row), None)
    limit = next((key for key in _WITH if key in row), None)
    why = row[limit] if limit else row[kind] if kind in ("not_checkable", "undecided") else ""
    first, last = row["lines"]
    return PaperClaim(
        first=first,
        last=last,
        begins=row["begins"],
        words=row["claim"],
        entries=tuple(row.get("entries", ())),
        without_entries=_WITHOUT[kind] if kind else None,
        why=why,
        proved_as=_WITH[limit] if limit else Standing.PROVED,
    )


def standing_counts(outcomes: Mapping[str, Outcome]) -> dict[str, int]:
    """How many claims of the paper have each standing."""
    found = [claim.standing(outcomes) for claim in paper_claims()]
    return {standing.value: found.count(standing) for standing in Standing}
