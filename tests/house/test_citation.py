"""CITATION.cff, pyproject.toml and LICENSE name the same version, authors, words and licence."""

from __future__ import annotations

import re
import tomllib
from pathlib import Path

import gspot_verified

ROOT = Path(__file__).resolve().parents[2]
CITATION = (ROOT / "CITATION.cff").read_text(encoding="utf-8")
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]


def stated(key: str) -> str:
    """The value of a key of the first level."""
    (found,) = re.findall(rf"^{key}: (.+)$", CITATION, re.MULTILINE)
    return str(found)


def listed(key: str) -> list[str]:
    """The items of a list of the first level."""
    (found,) = re.findall(rf"^{key}:\n((?:  .*\n)+)", CITATION, re.MULTILINE)
    return re.findall(r"^  - (?:name: )?(.+)$", found, re.MULTILINE)


def test_the_version_is_that_of_the_package() -> None:
    assert stated("version") == PROJECT["version"] == gspot_verified.__version__


def test_authors_words_and_licence_are_the_same_everywhere() -> None:
    assert listed("authors") == [author["name"] for author in PROJECT["authors"]]
    assert all(author in (ROOT / "LICENSE").read_text(encoding="utf-8") for author in listed("authors"))
    assert listed("keywords") == PROJECT["keywords"]
    assert stated("license") == PROJECT["license"]["text"]


def test_the_paper_is_the_one_that_readme_names() -> None:
    paper = re.findall(r"^ +title: (.+)$", CITATION, re.MULTILINE)
    assert len(paper) == 1
    assert f"*{paper[0]}*" in (ROOT / "README.md").read_text(encoding="utf-8")
