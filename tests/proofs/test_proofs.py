"""Every page in proofs/ is listed once, and names the tests of its steps, which name the page."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
PROOFS = ROOT / "proofs"
PAGES = sorted(path for path in PROOFS.glob("*.md") if path.stem != "README")


def files_of(page: Path) -> list[Path]:
    """The files of the line "Tested in"."""
    found = re.search(r"^Tested in (.*)$", page.read_text(encoding="utf-8"), re.MULTILINE)
    return [ROOT / name for name in re.findall(r"`(tests/[\w/]+\.py)`", found[1])] if found else []


@pytest.mark.parametrize("page", PAGES, ids=lambda path: path.stem)
def test_a_page_names_its_tests_and_they_name_the_page(page: Path) -> None:
    files = files_of(page)
    assert files, f"{page.name} has no line 'Tested in `tests/...py`'"
    for file in files:
        assert file.is_file(), file
        assert f"proofs/{page.name}" in file.read_text(encoding="utf-8"), f"{file.name} does not name {page.name}"


def test_every_page_is_listed_once() -> None:
    rows = re.findall(r"^\| \[(\w+\.md)\]", (PROOFS / "README.md").read_text(encoding="utf-8"), re.MULTILINE)
    assert sorted(rows) == sorted(page.name for page in PAGES)
