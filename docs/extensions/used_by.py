"""Which files stand on a proof page: those whose docstrings cite it, and the ledger's entries that rest on it.

``python docs/extensions/used_by.py`` writes the last column of ``proofs/README.md``; a test compares it.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from functools import cache
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PROOFS = ROOT / "proofs"
LIST = PROOFS / "README.md"
_CITED = re.compile(r"proofs/(\w+)\.md")
_OF_CHECKER = re.compile(r"\b(\w+)\.md")  # the checker stands beside the pages
_ROW = re.compile(r"^(\| \[(\w+)\.md\]\(\w+\.md\) \| .* \|) [^|]*\|$", re.MULTILINE)


@cache
def used_by() -> dict[str, list[str]]:
    """The files of each page, as the pages write them: from the package's folder on, or from the root."""
    found: dict[str, list[str]] = {page.stem: [] for page in sorted(PROOFS.glob("*.md")) if page != LIST}
    package = ROOT / "gspot_verified"
    trees = {path: ast.parse(path.read_text(encoding="utf-8")) for path in sorted(package.rglob("*.py"))}
    named = {(_module(path), name): page for path, tree in trees.items() for name, page in constants(tree)}
    for path, tree in trees.items():
        imported = {named[key] for key in _imported(tree) if key in named}
        for page in sorted({*cited(tree), *imported}):
            found[page].append(path.relative_to(package).as_posix())
    texts = [path.read_text(encoding="utf-8") for path in (PROOFS / "checker").glob("*.py")]
    for page in {page for text in texts for page in _OF_CHECKER.findall(ast.get_docstring(ast.parse(text)) or "")}:
        found[page].append("proofs/checker")
    return found


def cited(tree: ast.Module) -> Iterator[str]:
    """The pages that the docstrings of a source name, and those of its calls ``Page("name", steps)``."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Module | ast.ClassDef | ast.FunctionDef):
            yield from _CITED.findall(ast.get_docstring(node) or "")
        elif (page := _page(node)) is not None:
            yield page


def constants(tree: ast.Module) -> Iterator[tuple[str, str]]:
    """(name, page) where a source gives a page a name: ``NAME = Page("page", steps)``."""
    for node in tree.body:
        if isinstance(node, ast.Assign) and (page := _page(node.value)) is not None:
            yield from ((target.id, page) for target in node.targets if isinstance(target, ast.Name))


def _page(node: ast.AST) -> str | None:
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "Page":
        return next((str(arg.value) for arg in node.args[:1] if isinstance(arg, ast.Constant)), None)
    return None


def _module(path: Path) -> str:
    return ".".join(path.relative_to(ROOT).with_suffix("").parts)


def _imported(tree: ast.Module) -> Iterator[tuple[str, str]]:
    for node in ast.walk(tree):
        if isinstance(node, ast.ImportFrom):
            yield from ((node.module or "", alias.name) for alias in node.names)


def with_column(text: str, files: dict[str, list[str]]) -> str:
    """The table of the pages with its last column anew."""
    return _ROW.sub(lambda row: f"{row[1]} {', '.join(f'`{file}`' for file in files[row[2]])} |", text)


def main() -> None:
    """Write the column."""
    LIST.write_text(with_column(LIST.read_text(encoding="utf-8"), used_by()), encoding="utf-8")


if __name__ == "__main__":
    main()
