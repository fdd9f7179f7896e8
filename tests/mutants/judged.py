"""The committed table of what was judged: of each file the whole or a sample, and what became of its mutants."""

from __future__ import annotations

import tomllib
from dataclasses import dataclass
from pathlib import Path

WHOLE = "whole"
_HEAD = "# What the last recorded run of each file judged: README.md. Written by --record, read by --stated.\n\n"


@dataclass(frozen=True)
class Judged:
    """A row: ``sample`` of ``seed`` (None: the whole file); the mutants of the file and what became of them."""

    sample: int | None
    seed: int
    mutants: int
    killed: int
    argued: int
    waived: int

    def __post_init__(self) -> None:
        if self.killed + self.argued != min(self.mutants - self.waived, self.sample or self.mutants):
            raise ValueError(f"killed and argued are not all that were judged: {self}")

    def holds(self, other: Judged) -> bool:
        """Whether this sample is the larger one."""
        return other.sample is not None and (self.sample is None or self.sample > other.sample)


def outdated(file: str, row: Judged, mutants: int) -> list[str]:
    """The complaint when the row states another number of mutants than its file has."""
    if row.mutants == mutants:
        return []
    text = f"judged.toml states {row.mutants} mutants, the file has {mutants}; judge it again with --record: {file}"
    return [text]


def read_judged(path: Path) -> dict[str, Judged]:
    """The row of each file.

    :raises ValueError: the numbers of a row do not add up.
    """
    rows = tomllib.loads(path.read_text(encoding="utf-8")) if path.is_file() else {}
    return {
        file: Judged(**(row | {"sample": None if row["sample"] == WHOLE else row["sample"]}))
        for file, row in rows.items()
    }


def write_judged(path: Path, rows: dict[str, Judged]) -> None:
    """Write the table, ordered by file."""
    path.write_text(_HEAD + "".join(f"{_line(file, row)}\n" for file, row in sorted(rows.items())), encoding="utf-8")


def _line(file: str, row: Judged) -> str:
    fields = {"sample": f'"{WHOLE}"' if row.sample is None else row.sample} | {
        name: getattr(row, name) for name in ("seed", "mutants", "killed", "argued", "waived")
    }
    return f'"{file}" = {{ {", ".join(f"{name} = {value}" for name, value in fields.items())} }}'
