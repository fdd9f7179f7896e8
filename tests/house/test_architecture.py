"""ARCHITECTURE.md, CONTRIBUTING.md and README.md show the house as it is: its layers and rooms, files that exist."""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path

import pytest
from house.test_layout import LAYERS, PACKAGE, ROOMS, ROOT

TEXT = (ROOT / "ARCHITECTURE.md").read_text(encoding="utf-8")
PAGES = ("ARCHITECTURE.md", "CONTRIBUTING.md", "README.md")
FILES_TO_READ = 21


def rooms_of(layer: str) -> str:
    """The rooms of a layer from the top down, as the drawing shows them; ``·`` are the files of the folder itself."""
    rows = ROOMS.get(layer, ())
    return " > ".join(" ".join(room or "·" for room in row) for row in rows)


def drawing() -> list[str]:
    """The lines of the drawing without its words: a layer and its rooms, with a rule between two rows of layers."""
    return "\n-\n".join("\n".join(f"{layer}: {rooms_of(layer)}".rstrip(": ") for layer in row) for row in LAYERS).split(
        "\n"
    )


def drawn(text: str) -> list[str]:
    """The same, read from the drawing."""
    found: list[str] = []
    for line in re.findall(r"^[│├](.*)$", text, re.MULTILINE):
        words = line.partition(" — ")[0].split()
        if not words or line.startswith("─"):
            found.append("-")
        elif line.startswith("  "):  # the rooms stand below the name of their layer
            found[-1] += ": " + " ".join(words)
        else:
            found.append(" ".join(words))
    return found


def missing(paths: Sequence[str], page: Path) -> list[str]:
    """Those that are neither in the repository nor in the package nor beside the page."""
    return [path for path in paths if not any((place / path).exists() for place in (ROOT, PACKAGE, page.parent))]


def paths_in(text: str) -> list[str]:
    """What a page names as a path: text between backticks with a slash or a suffix of a file, and targets of links."""
    quoted = re.findall(r"(?<!`)`([\w./-]+)`(?![`\]])", text)
    links = [target.partition("#")[0] for target in re.findall(r"\]\(([^)\s]+)\)", text) if "://" not in target]
    suffixes = (".py", ".md", ".toml", ".json", ".v", ".cff", ".svg", ".cert")
    made = ("build/", "report/index.html", "report/report.json")
    named = [path for path in quoted if path.endswith((*suffixes, "/")) or "/" in path]
    return [path for path in (*named, *links) if path and not path.startswith(made) and "NAME" not in path]


def test_the_drawing_is_that_of_the_layers_and_rooms() -> None:
    wanted = drawing()
    assert drawn(TEXT) == wanted, "the drawing in ARCHITECTURE.md should have:\n" + "\n".join(wanted)


def test_every_layer_of_the_drawing_has_its_words() -> None:
    for layer in (layer for row in LAYERS for layer in row):
        assert re.search(rf"^│ {layer} +— \w", TEXT, re.MULTILINE), f"{layer}: no words beside it"


@pytest.mark.parametrize("name", PAGES)
def test_every_path_that_is_named_exists(name: str) -> None:
    page = ROOT / name
    paths = paths_in(page.read_text(encoding="utf-8"))
    assert len(paths) > 10
    assert missing(paths, page) == [], f"{name} names what is not there (moved? give the new place)"


def test_what_is_not_there_is_seen() -> None:
    text = "`numbers/balls.py`, `no/such.py`, [x](tests/gone.md#part), [y](https://example.org/z.md), `make test`"
    assert missing(paths_in(text), ROOT / "ARCHITECTURE.md") == ["no/such.py", "tests/gone.md"]


def test_the_files_to_read_are_as_many_as_it_says() -> None:
    part = TEXT.partition("## To read in an hour")[2].partition("\n## ")[0]
    rows = re.findall(r"^(\d+)\. `([\w/.]+)`: \w", part, re.MULTILINE)
    assert [int(number) for number, _ in rows] == list(range(1, FILES_TO_READ + 1))
    assert len({path for _, path in rows}) == FILES_TO_READ
    assert all((ROOT / path).is_file() or (PACKAGE / path).is_file() for _, path in rows)
