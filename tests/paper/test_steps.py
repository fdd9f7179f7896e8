"""A step that fails shows that a route fails, not that the claim does: it must leave a check open, and refute none."""

from __future__ import annotations

import dis
import inspect
from collections.abc import Callable, Iterator
from functools import cache, partial
from itertools import pairwise
from types import CodeType, FunctionType, ModuleType
from typing import Any

import pytest
from paper.bite import answers_with
from paper.refuted import REFUTED
from paper.tables import TABLES, table
from paper.test_teeth import LONG, forget

from gspot_verified.paper.checks import closed_forms, entry, formulas, identities, leading_order, page
from gspot_verified.paper.checks.entry import Entry
from gspot_verified.paper.checks.page import Page
from gspot_verified.paper.section_3 import varsim1, varsim2
from gspot_verified.paper.section_6 import section_6

LEDGER = "gspot_verified.paper."
FRAME = (entry, page, identities, formulas, closed_forms)
"""What all entries rest on has its own tests."""
CLAIMED = {
    (section_6, "in_case_iii"),
    (section_6, "approached_with_finite_force"),
    (leading_order, "is_dominated"),  # what is not of higher order belongs to the leading order, and is not printed
}
"""What the paper itself claims: when it fails, the claim does."""
LIFT_OFFS = frozenset(
    varsim1.identifier(beta, nu)
    for beta, fates in varsim1.FATES.items()
    for nu, fate in fates.items()
    if fate != varsim1.IMPACT
)
COUPLED = frozenset(identifier for identifier in varsim2.ENTRIES if identifier.startswith("3-varsim2-1-"))
NOT_ASKED = {
    (varsim1, "surface_stays_below"): LIFT_OFFS,
    (varsim1, "surface_by_an_integral"): LIFT_OFFS,
    (varsim2, "grows_after_the_spot"): COUPLED,
}
"""Named, and asked of other entries alone: y where the fate is an impact, the growth of the force where chi = 0."""
Step = tuple[ModuleType, str]


def _open(value: Any) -> Any:
    """The step that fails: a page without proof, a question answered with no, or left open where it may be."""
    if isinstance(value, Page):
        return Page(value.name, (lambda: False,))
    return lambda *_, **__: None if "None" in str(inspect.signature(value).return_annotation) else False


def _is_step(module: ModuleType, name: str) -> bool:
    value = vars(module).get(name)
    if isinstance(value, Page):
        return True
    if not isinstance(value, FunctionType) or value.__module__ in {frame.__name__ for frame in FRAME}:
        return False
    return value.__module__.startswith(LEDGER) and str(value.__annotations__.get("return")) in ("bool", "bool | None")


def _named(code: CodeType) -> Iterator[tuple[str, str | None]]:
    """The global names in a code, each with the attribute that is read of it there, if one is."""
    instructions = list(dis.get_instructions(code))
    for here, following in pairwise([*instructions, None]):
        if here is not None and here.opname == "LOAD_GLOBAL":
            attribute = following is not None and following.opname in ("LOAD_ATTR", "LOAD_METHOD")
            yield str(here.argval), str(following.argval) if following is not None and attribute else None
    for part in code.co_consts:
        if isinstance(part, CodeType):
            yield from _named(part)


@cache
def _globals_of(function: FunctionType) -> list[Step]:
    """What a function names: in its own module, and in the modules of the ledger that it names."""
    own = inspect.getmodule(function)
    assert own is not None
    found = []
    for name, attribute in _named(function.__code__):
        value = vars(own).get(name)
        if isinstance(value, ModuleType) and value.__name__.startswith(LEDGER) and attribute is not None:
            found.append((value, attribute))
        elif value is not None:
            found.append((own, name))
    return found


def steps_of(build: Callable[[], Entry]) -> list[Step]:
    """The steps that the entry names, also through functions of the ledger; what a step names is its own matter."""
    function = build.func if isinstance(build, partial) else build
    found, seen, waiting = [], set[Any](), [function]
    while waiting:
        for module, name in _globals_of(waiting.pop()):
            value = vars(module)[name]
            if (module, name) in seen:
                continue
            seen.add((module, name))
            if _is_step(module, name):
                found.append((module, name))
            elif isinstance(value, FunctionType) and value.__module__.startswith(LEDGER):
                waiting.append(value)
    return [step for step in found if step not in CLAIMED]


def _rows() -> Iterator[Any]:
    for part in TABLES:
        for identifier, build in table(part).ENTRIES.items():
            if identifier in table(part).TEETH:
                for module, name in steps_of(build):
                    if identifier in NOT_ASKED.get((module, name), ()):
                        continue
                    slow = [pytest.mark.slow] if part in LONG else []
                    marks = [pytest.mark.part(part), *slow]
                    yield pytest.param(part, identifier, module, name, id=f"{identifier}: {name}", marks=marks)


def test_what_is_not_asked_of_some_is_asked_of_others() -> None:
    asked = {(module, name) for _, identifier, module, name in (row.values for row in _rows())}
    assert set(NOT_ASKED) <= asked


@cache
def _honest(part: str, identifier: str) -> list[bool | None]:
    """What the checks of a refuted entry answer; ``test_ledger.py`` finds that those of the others all say yes."""
    return [check.agrees for check in table(part).ENTRIES[identifier]().checks]


@pytest.mark.parametrize(("part", "identifier", "module", "name"), list(_rows()))
def test_a_step_that_fails_leaves_a_check_open(part: str, identifier: str, module: ModuleType, name: str) -> None:
    forget()
    try:
        answers = answers_with(module, name, _open(vars(module)[name]), table(part).ENTRIES[identifier])
    finally:
        forget()
    assert None in answers
    honest = _honest(part, identifier) if identifier in REFUTED else [True] * len(answers)
    assert [new for new, old in zip(answers, honest, strict=True) if new not in (old, None)] == []
