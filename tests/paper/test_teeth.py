"""Every entry of the ledger notices a wrong formula: its verdict changes when the checked formula does."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from functools import lru_cache, partial
from types import SimpleNamespace

import pytest
from paper.bite import KINDS, Bite, NotApplicable, Teeth, missing_kinds, raised, replaced, scaled, unseen_at
from paper.refuted import REFUTED
from paper.tables import TABLES, table

from gspot_verified.numbers.verdict import Outcome
from gspot_verified.paper.checks.entry import Check, Entry, Rung, Section
from gspot_verified.paper.verify import PARTS

_CACHED = type(lru_cache(len))
LONG = {
    *("after_lift_off", "section_3_sentences", "section_5_side", "section_6_runs", "section_6_theta", "section_7"),
    *("impact_to_lift_off", "table_1", "varsim1", "varsim2"),
}
"""Modules whose entries run a simulation for each change: one wrong formula an entry always, the others and the steps
are slow tests."""
PENDING: set[str] = set()
"""Modules of the ledger whose table is not complete yet."""


def honest_outcome(identifier: str) -> Outcome:
    """What ``test_ledger.py`` finds of the entry as it stands."""
    return Outcome.REFUTED if identifier in REFUTED else Outcome.PROVED


def bites() -> Iterator[tuple[str, str, Bite]]:
    for name in TABLES:
        for identifier, teeth in table(name).TEETH.items():
            yield from ((name, identifier, tooth) for tooth in teeth if isinstance(tooth, Bite))


def marks(name: str, identifier: str, bite: Bite) -> list[pytest.MarkDecorator]:
    """The part of the ledger; slow for all bites but the last one of an entry that takes long."""
    last = [tooth for tooth in table(name).TEETH[identifier] if isinstance(tooth, Bite)][-1]
    return [pytest.mark.part(name), *([pytest.mark.slow] if name in LONG and bite is not last else [])]


def forget() -> None:
    """Empty the caches of the library: a value from before the bite must not answer for the one after it."""
    for name, module in list(sys.modules.items()):
        if name.startswith("gspot_verified.") and module is not None:
            for value in list(vars(module).values()):
                if isinstance(value, _CACHED):
                    value.cache_clear()


def outcome_after(bite: Bite, build: Callable[[], Entry]) -> Outcome:
    """The outcome of the entry with the wrong formula in place; an exception is passed on."""
    forget()
    try:
        with pytest.MonkeyPatch.context() as patch:
            bite.apply(patch)
            return build().verdict.outcome
    finally:
        forget()


@pytest.mark.parametrize(
    ("name", "identifier", "bite"),
    [pytest.param(*row, id=f"{row[1]}: {row[2].kind}, {row[2].name}", marks=marks(*row)) for row in bites()],
)
def test_a_wrong_formula_changes_the_verdict(name: str, identifier: str, bite: Bite) -> None:
    found = outcome_after(bite, table(name).ENTRIES[identifier])
    assert found is Outcome.REFUTED if bite.refutes else found is not honest_outcome(identifier)


@pytest.mark.parametrize("name", [name for name in TABLES if name not in PENDING])
def test_the_table_of_a_module_is_complete(name: str) -> None:
    teeth: Teeth = table(name).TEETH
    assert set(teeth) == set(table(name).ENTRIES)
    assert {identifier: missing_kinds(row) for identifier, row in teeth.items() if missing_kinds(row)} == {}


def test_every_part_of_the_paper_has_a_table_or_is_pending() -> None:
    identifiers = {identifier for part in PARTS.values() for identifier in part}
    assert sum(len(part) for part in PARTS.values()) == len(identifiers)
    bitten = [set(table(name).TEETH) for name in TABLES]
    assert set().union(*bitten) <= identifiers
    assert sum(map(len, bitten)) == len(set().union(*bitten))
    assert PENDING or set().union(*bitten) == identifiers


def _toy(what: SimpleNamespace) -> Entry:
    agrees = what.formula == "2*x"
    checks = [Check(Rung.EXACT, "a", agrees, "f"), Check(Rung.EXACT, "b", agrees if what.looks else True, "f")]
    return Section("Section").settled("toy", "eq", "2x", "toy", *checks)


def test_a_bite_that_goes_unnoticed_is_found() -> None:
    what = SimpleNamespace(formula="2*x", looks=True)
    build = partial(_toy, what)
    assert build().verdict.outcome is Outcome.PROVED
    assert outcome_after(Bite("factor", what, "formula", scaled), build) is Outcome.REFUTED
    assert outcome_after(Bite("factor", what, "formula", lambda honest: honest), build) is Outcome.PROVED
    what.looks = False
    assert outcome_after(Bite("factor", what, "formula", scaled), build) is Outcome.UNDECIDED
    assert what.formula == "2*x"
    with pytest.raises(AttributeError):
        outcome_after(Bite("factor", what, "no such name", scaled), build)


def test_a_cached_value_does_not_answer_for_a_wrong_formula(monkeypatch: pytest.MonkeyPatch) -> None:
    from gspot_verified.paper.section_2 import extended_system

    calls = []
    counted = lru_cache(lambda: calls.append(1))
    monkeypatch.setattr(extended_system, "extended_terms", counted)
    for _ in range(2):
        extended_system.extended_terms()  # type: ignore[call-arg]
        forget()
    assert len(calls) == 2


def test_an_empty_argument_is_no_argument() -> None:
    assert missing_kinds(()) == list(KINDS)
    assert "order" in missing_kinds((NotApplicable("order", " "),))
    assert "order" not in missing_kinds((NotApplicable("order", "no orders occur"),))


def test_changes_of_texts_and_numbers() -> None:
    from flint import fmpq

    assert scaled("a+b") == "1000003/1000000*(a+b)"
    assert scaled({"x": (fmpq(2), [fmpq(1)])}) == {"x": (fmpq(1000003, 500000), [fmpq(1000003, 1000000)])}
    assert scaled(lambda x: x + 1)(fmpq(1)) == fmpq(1000003, 500000)
    assert unseen_at("t", (1,))("a") == "(1 + (t-(1)))*(a)"
    assert raised("t")("a+b") == "t*(a+b)"
    with pytest.raises(ValueError, match="does not occur"):
        replaced("x", "y")("a")
    for wrong in (True, None):
        with pytest.raises(TypeError, match="means nothing"):
            scaled(wrong)
