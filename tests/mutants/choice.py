"""Which test files judge a source file: its mirror and its own examples, or all that import it."""

from __future__ import annotations

import ast
from pathlib import Path

_LEDGER = "gspot_verified/paper/"
_OF_THE_PARTS = tuple(f"tests/paper/test_{name}.py" for name in ("verdicts", "teeth", "steps"))
_OF_THE_CHECKER = (
    *(f"tests/must_reject/test_{name}.py" for name in ("must_reject", "forged", "hostile")),
    *("tests/compliant/zeros/test_force_certificate.py", "tests/compliant/zeros/test_zero_certificate.py"),
)
"""Judge each file of the checker, which no test imports by a name of the package."""


def mirrored(root: Path, file: str) -> list[str]:
    """Paths for pytest: the file's own examples and its mirror; what imports it when there is none.

    The mirror of NAME.py is test_NAME.py and test_NAME_MORE.py, where no file beside it is named NAME_MORE.py. For a
    part of the ledger both, and the tests of all parts.
    """
    path = Path(file)
    folder = root / "tests" / Path(*path.parts[1:-1])
    tests = sorted(folder.glob(f"test_{path.stem}.py")) + _with_longer_names(root / path, folder)
    of_checker = file.startswith("proofs/checker/")  # it has no examples, and finds its own parts as a program alone
    tests += [root / name for name in _OF_THE_CHECKER] if of_checker else []
    own = [] if of_checker else [file]
    chosen = [*own, *(test.relative_to(root).as_posix() for test in tests)] if tests else importing(root, file)
    further = [*importing(root, file), *_OF_THE_PARTS] if parts(root, file) else []
    return list(dict.fromkeys([*chosen, *further]))


def _with_longer_names(path: Path, folder: Path) -> list[Path]:
    """The tests test_NAME_*.py in a folder that are of no file beside NAME.py with a longer name."""
    others = [f"test_{other.stem}" for other in path.parent.glob(f"{path.stem}_*.py")]
    found = sorted(folder.glob(f"test_{path.stem}_*.py"))
    return [test for test in found if not any(test.stem == name or test.stem.startswith(f"{name}_") for name in others)]


def parts(root: Path, file: str) -> set[str]:
    """The parts of the paper (tables in ``tests/paper/teeth``) that rest on a file of the ledger; none for others.

    Marked tests of other parts are left out. All parts rest on the frame of the ledger: its own tests judge it.
    """
    folder = root / _LEDGER
    imports = {path.stem: _imported(path) for path in folder.rglob("*.py")} if file.startswith(_LEDGER) else {}
    tables = {path.stem for path in (root / "tests" / "paper" / "teeth").glob("*.py")}
    frame, homes = {"entry", "page", "paper", "identities", "verify"}, _homes(folder)
    found, new = set[str](), {Path(file).stem} & (imports.keys() - frame)
    while new:
        found |= new
        new = {name for name, used in imports.items() if not used.isdisjoint(homes[n] for n in new)} - found - frame
    return found & tables


def _homes(folder: Path) -> dict[str, str]:
    """The dotted names of the modules of the ledger, by their last words."""
    start = folder.parents[1] if folder.name == "paper" else folder
    return {
        path.stem: ".".join(path.relative_to(start).with_suffix("").parts)
        for path in folder.rglob("*.py")
        if path.stem != "__init__"
    }


def importing(root: Path, file: str) -> list[str]:
    """Paths for pytest: the file's own examples and every test file that imports the module."""
    module = file.removesuffix(".py").replace("/", ".")
    tests = [test for test in sorted((root / "tests").rglob("test_*.py")) if module in _imported(test)]
    return [file, *(test.relative_to(root).as_posix() for test in tests)]


def _imported(test: Path) -> set[str]:
    """The dotted names that the test file imports, ``from a import b`` as both ``a`` and ``a.b``."""
    names: set[str] = set()
    for node in ast.walk(ast.parse(test.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            names |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom) and node.module:
            names |= {node.module, *(f"{node.module}.{alias.name}" for alias in node.names)}
    return names
