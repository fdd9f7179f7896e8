"""Every example on every page runs and prints what the page says."""

from __future__ import annotations

import re
from pathlib import Path

import pages
import pytest
from samples import page_examples

import gspot_verified
import gspot_verified.testing
from gspot_verified.mechanisms.input import file

ROOT = Path(__file__).resolve().parents[2]
PAGES = sorted((ROOT / "docs").glob("*.md"))
WRITTEN = [page for page in PAGES if page.name not in pages.MADE]


def test_there_are_pages() -> None:
    assert {"index", "ten_minutes", "file_format", "certified", "rigour"} <= {page.stem for page in WRITTEN}


@pytest.mark.parametrize("page", WRITTEN, ids=lambda page: page.stem)
def test_the_examples_of_a_page(page: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    assert page_examples.run_page(page, tmp_path) >= 1


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("'II', -1", "'III', -1"),
        ("[exit code 64]", "[exit code 1]"),
        ("1.22540  II ", "1.22540  I  "),
        ("'sine'", "'sin'"),
    ],
)
def test_a_page_that_says_something_else_fails(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, old: str, new: str
) -> None:
    text = (ROOT / "docs" / "ten_minutes.md").read_text(encoding="utf-8")
    assert old in text
    page = tmp_path / "ten_minutes.md"
    page.write_text(text.replace(old, new, 1), encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    with pytest.raises(AssertionError, match=r"ten_minutes\.md"):
        page_examples.run_page(page, tmp_path)


def test_every_key_of_the_format_is_on_its_page() -> None:
    """The page shows the docstring of the reader of files, and that names every key that the reader accepts."""
    assert ".. automodule:: gspot_verified.mechanisms.input.file\n" in (ROOT / "docs" / "file_format.md").read_text(
        "utf-8"
    )
    listed = set(re.findall(r"^ {4}([a-zA-Z0-9_.*]+) {2,}\S", file.__doc__ or "", re.MULTILINE))
    tables = {key for key in file.KEYS if key}
    accepted = {f"{table}.{key}".lstrip(".") for table, keys in file.KEYS.items() for key in keys}
    assert accepted - tables <= listed
    assert len(listed) > 20


def test_the_reference_has_every_public_name_once() -> None:
    found = re.findall(r"^\.\. auto\w+:: gspot_verified\.([\w.]+)$", pages.reference(), re.MULTILINE)
    homes = gspot_verified.__homes__ | {
        name: getattr(gspot_verified.testing, name).__module__ for name in gspot_verified.testing.__all__
    }
    assert len(homes) == len(gspot_verified.__all__) + len(gspot_verified.testing.__all__)
    assert sorted(found) == sorted(f"{home.removeprefix('gspot_verified.')}.{name}" for name, home in homes.items())


@pytest.mark.parametrize(
    ("said", "right"),
    [("1 passed in ...", True), ("2 passed in ...", False), ("1 passed in ...\n[exit code 1]", False)],
)
def test_what_pytest_prints_on_a_page_is_compared(tmp_path: Path, said: str, right: bool) -> None:
    page = tmp_path / "page.md"
    file = "```{code-block} python\n:caption: test_it.py\n\ndef test_it():\n    assert True\n```\n"
    page.write_text(f"{file}\n```console\n$ pytest -q test_it.py\n...\n{said}\n```\n", encoding="utf-8")
    if right:
        assert page_examples.run_page(page, tmp_path) == 1
    else:
        with pytest.raises(AssertionError, match=r"page\.md:\d+: pytest -q"):
            page_examples.run_page(page, tmp_path)


@pytest.mark.parametrize(
    ("shown", "read"),
    [
        ("(a: ~flint.arb.Annotated[~flint.arb.arb, <function f at 0x7f>] | None)", "(a: ~flint.arb.arb | None)"),
        ("(a: Annotated[tuple[int, str], <function f at 0x7f>], b: int)", "(a: tuple[int, str], b: int)"),
        ("(a: TypeAliasForwardRef('ExactInput'), b: Annotated[int, fmpq])", "(a: ExactInput, b: int)"),
        ("(a: Place = <factory>, b: C[str] = <function <lambda>>)", "(a: Place = ..., b: C[str] = ...)"),
        ("(a: int = 1)", "(a: int = 1)"),
        (None, None),
    ],
)  # fmt: skip
def test_types_are_shown_as_a_reader_writes_them(shown: str | None, read: str | None) -> None:
    assert pages.plain_signature(None, "", "", None, None, shown, shown) == (read, read)


def test_on_a_phone_no_heading_is_larger_than_the_one_above_it() -> None:
    """The theme's own sizes are for a wide page: an h1 made smaller alone would be smaller than its h2."""
    style = (ROOT / "docs" / "static" / "site.css").read_text(encoding="utf-8")
    phone = style[style.index("@media (max-width: 600px)") :]
    sizes = [float(size) for size in re.findall(r"h[1-6] \{ font-size: ([\d.]+)em", phone)]
    assert len(sizes) == 4
    assert sizes == sorted(sizes, reverse=True)
    assert "h4, h5, h6 {" in phone


def test_the_pictures_of_the_gallery_are_of_mechanisms_with_a_drawing() -> None:
    """The site draws them when it is built, each at the place of its file."""
    names = pages.GALLERY.findall((ROOT / "docs" / "gallery.md").read_text(encoding="utf-8"))
    assert len(names) == len(set(names)) == 8
    for name in names:
        assert gspot_verified.load(name).drawing is not None
