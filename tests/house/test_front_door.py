"""One front door: pages, the README and the examples of public names import from ``gspot_verified`` itself."""

from __future__ import annotations

import doctest
import inspect
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

import gspot_verified

ROOT = Path(__file__).resolve().parents[2]
PAGES = [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md")), *sorted((ROOT / "docs").glob("notebook*.py"))]
DOORS = ("gspot_verified", "gspot_verified.testing")
_IMPORT = re.compile(
    r"^\s*(?:>>> |\.\.\. )?\s*(?:from\s+(gspot_verified[\w.]*)\s+import|import\s+(gspot_verified[\w.]*))"
)


def deep_imports(text: str) -> list[str]:
    """The modules below the doors that lines of the text import from, in code, examples and fences alike."""
    found = [match[1] or match[2] for match in map(_IMPORT.match, text.splitlines()) if match is not None]
    return [module for module in found if module not in DOORS]


def examples(value: object) -> Iterator[str]:
    """The examples in the docstring of a function, or of a class and its public methods."""
    members = [value]
    if inspect.isclass(value):
        members += [member for name, member in vars(value).items() if not name.startswith("_")]
    for member in members:
        for example in doctest.DocTestParser().get_examples(inspect.getdoc(member) or ""):
            yield from example.source.splitlines()


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_a_page_takes_everything_from_the_front_door(page: Path) -> None:
    assert deep_imports(page.read_text(encoding="utf-8")) == []


def test_some_pages_import_something() -> None:
    imports = [page.name for page in PAGES if "from gspot_verified import " in page.read_text(encoding="utf-8")]
    assert {"README.md", "notebook.py", "scenes.md", "compliant_model.md"} <= set(imports)


@pytest.mark.parametrize("name", gspot_verified.__all__)
def test_the_examples_of_a_public_name_do_too(name: str) -> None:
    assert deep_imports("\n".join(examples(getattr(gspot_verified, name)))) == []


@pytest.mark.parametrize(
    ("text", "deep"),
    [
        ("```python\n>>> from gspot_verified.numbers.balls import approximate\n```", ["gspot_verified.numbers.balls"]),
        ("import gspot_verified.signs as signs", ["gspot_verified.signs"]),
        ("    from gspot_verified.cli import (\n        main,\n    )", ["gspot_verified.cli"]),
        (">>> from gspot_verified import theta\n>>> from gspot_verified.testing import systems", []),
        ("the module gspot_verified.signs has it", []),
    ],
)
def test_a_deep_import_is_seen(text: str, deep: list[str]) -> None:
    assert deep_imports(text) == deep
