"""``make lint``: every file of the package by the rules of README.md; exit code 1 and the places when one is broken."""

from __future__ import annotations

import ast
import sys
from pathlib import Path

from rigour.exceptions import LIST, complaints, exceptions
from rigour.rules import findings
from rigour.types_of_expressions import ROOT, kinds_in_files

PACKAGE = ROOT / "gspot_verified"


def module_of(path: Path) -> str:
    return ".".join(path.relative_to(ROOT).with_suffix("").parts).removesuffix(".__init__")


def main() -> int:
    files = {module_of(path): path for path in sorted(PACKAGE.rglob("*.py"))}
    kinds = kinds_in_files(files)
    found = {
        path.relative_to(PACKAGE).as_posix(): list(findings(ast.parse(path.read_text(encoding="utf-8")), kinds[module]))
        for module, path in files.items()
    }
    wrong = complaints(found, exceptions(LIST.read_text(encoding="utf-8")))
    for line in wrong:
        print(line)
    print(f"Rigour: {len(files)} files, {len(wrong)} complaints" + (" (tests/rigour/README.md)" if wrong else ""))
    return 1 if wrong else 0


sys.exit(main())
