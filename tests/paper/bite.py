"""Wrong formulas on purpose: what a check of the ledger must notice.

The checked formula of an entry is a module-level text, number or function, or an entry of a module-level mapping. A
bite replaces it by a wrong one; the entry's verdict must then be another one. A refuted entry bites at its corrected
form (a wrong corrected form must leave it undecided), at a formula that one of its derivations rests on, or at the
printed form with the misprint mended.

The four kinds:

- "factor": a generic factor near 1 in front of the formula or of one of its terms;
- "hidden factor": a factor that is 1 at the points that a check by values samples (or that one would sample);
- "hypothesis": one hypothesis of the claim is dropped, or replaced by a weaker one;
- "order": the order of an error term, a power or a number of terms is raised by one.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, MutableMapping, Sequence
from dataclasses import dataclass
from typing import Any, Literal, get_args

import pytest

from gspot_verified.paper.checks.entry import Entry

Kind = Literal["factor", "hidden factor", "hypothesis", "order"]
KINDS: tuple[Kind, ...] = get_args(Kind)
GENERIC = "1000003/1000000"
"""The factor near 1, as a text of FLINT."""


@dataclass(frozen=True)
class Bite:
    """A wrong value in place of the checked formula.

    ``target`` is a module, a class or an object, with ``name`` its attribute, or a mapping, with ``name`` its key.
    ``change`` makes the wrong value from the honest one. A mapping is changed in place: whoever imported it sees that.
    ``refutes``: the wrong value is another claim, which the checks must refute; open is not enough.
    """

    kind: Kind
    target: Any
    name: str
    change: Callable[[Any], Any]
    refutes: bool = False

    def apply(self, patch: pytest.MonkeyPatch) -> None:
        """Put the wrong value in place until ``patch`` is undone."""
        if isinstance(self.target, MutableMapping):
            patch.setitem(self.target, self.name, self.change(self.target[self.name]))
        else:
            patch.setattr(self.target, self.name, self.change(getattr(self.target, self.name)))


@dataclass(frozen=True)
class NotApplicable:
    """No bite of this kind exists for the entry, and the argument why."""

    kind: Kind
    why: str


Tooth = Bite | NotApplicable
Teeth = dict[str, tuple[Tooth, ...]]


def scaled(honest: Any) -> Any:
    """The generic factor in front of a text, a number, the result of a function, or each member of a collection."""
    from flint import fmpq

    if isinstance(honest, bool) or honest is None:
        raise TypeError(f"a factor in front of {honest!r} means nothing")
    if isinstance(honest, str):
        return f"{GENERIC}*({honest})"
    if isinstance(honest, dict):
        return {key: scaled(value) for key, value in honest.items()}
    if isinstance(honest, list | tuple):
        return type(honest)(scaled(value) for value in honest)
    if callable(honest):
        return lambda *arguments, **options: scaled(honest(*arguments, **options))
    return honest * fmpq(*(int(part) for part in GENERIC.split("/")))


def unseen_at(symbol: str, points: Iterable[int]) -> Callable[[str], str]:
    """A factor in front of a text that is 1 where the symbol is one of the points.

    >>> unseen_at("t", (0, 2))("a + t")
    '(1 + (t-(0))*(t-(2)))*(a + t)'
    """
    vanishing = "*".join(f"({symbol}-({point}))" for point in points)
    return lambda honest: f"(1 + {vanishing})*({honest})"


def raised(symbol: str) -> Callable[[str], str]:
    """One more power of the symbol in front of a text.

    >>> raised("epsilon")("epsilon^2*c")
    'epsilon*(epsilon^2*c)'
    """
    return lambda honest: f"{symbol}*({honest})"


def replaced(old: str, new: str) -> Callable[[str], str]:
    """The text with one part of it replaced; the part must occur.

    >>> replaced("epsilon^2", "epsilon^3")("epsilon^2*c")
    'epsilon^3*c'
    """

    def change(honest: str) -> str:
        if old not in honest:
            raise ValueError(f"{old!r} does not occur in {honest!r}")
        return honest.replace(old, new)

    return change


def reads_as(old: str, new: str, then: tuple[str, str] | None = None) -> Callable[[Any], Any]:
    """The paper's words with one of them replaced, wherever a function gives them; the word must occur."""

    def change(honest: Any) -> Any:
        def words(label: str) -> str:
            text = replaced(old, new)(honest(label))
            return replaced(*then)(text) if then else text

        return words

    return change


def missing_kinds(teeth: Sequence[Tooth]) -> list[Kind]:
    """The kinds for which there is neither a bite nor an argument why there is none."""
    present = {tooth.kind for tooth in teeth if isinstance(tooth, Bite) or tooth.why.strip()}
    return [kind for kind in KINDS if kind not in present]


def answers_with(target: Any, name: str, wrong: Any, build: Callable[[], Entry]) -> list[bool | None]:
    """What each check of the entry answers with another value in place of the target's attribute of this name."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(target, name, wrong)
        return [check.agrees for check in build().checks]
