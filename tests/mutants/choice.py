"""Which test files judge a source file: its mirror and its own examples, or all that import it."""

from __future__ import annotations

import ast
from pathlib import Path

_ALSO = {"proofs/check.py": ("must_reject/test_must_reject.py", "must_reject/test_hostile.py")}


def mirrored(root: Path, file: str) -> list[str]:
    """Paths for pytest: the file's own examples and ``tests/.../test_NAME*.py``; what imports it when there is none."""
    path = Path(file)
    folder = root / "tests" / Path(*path.parts[1:-1])
    tests = sorted(folder.glob(f"test_{path.stem}.py")) + sorted(folder.glob(f"test_{path.stem}_*.py"))
    tests += [root / "tests" / name for name in _ALSO.get(file, ())]
    return [file, *(test.relative_to(root).as_posix() for test in tests)] if tests else importing(root, file)


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
