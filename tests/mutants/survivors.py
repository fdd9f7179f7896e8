"""The committed list of survivors: read it, and hold it against what a run found."""

from __future__ import annotations

import tomllib
from collections.abc import Iterable
from pathlib import Path

from mutants.operators import Mutant

Key = tuple[str, str]


def read_survivors(path: Path) -> dict[Key, str]:
    """Each listed mutant (file, change) with the argument why it is equivalent or harmless.

    :raises ValueError: an entry without an argument, or listed twice.
    """
    found: dict[Key, str] = {}
    for file, changes in tomllib.loads(path.read_text(encoding="utf-8")).items():
        for change, argument in changes.items():
            if not argument.strip():
                raise ValueError(f"no argument: {file} {change}")
            found[file, change] = argument
    return found


def is_listed(mutant: Mutant, listed: Iterable[Key]) -> bool:
    """Whether the list argues for this mutant, for every change of its line, or for every change of its function."""
    return not {mutant.key, *mutant.wider}.isdisjoint(listed)


def is_waived(mutant: Mutant, listed: Iterable[Key]) -> bool:
    """Whether the list argues for every change of its line or of its function: then no test is asked."""
    return not mutant.wider.isdisjoint(listed)


def complaints(
    listed: Iterable[Key], existing: Iterable[Mutant], killed: Iterable[Mutant], survived: Iterable[Mutant]
) -> list[str]:
    """What is wrong with the list, one text each; ``existing`` are all mutants of the files that were run."""
    listed, existing = set(listed), list(existing)
    found = [f"survived and is not in the list:\n{entry(m)}" for m in survived if not is_listed(m, listed)]
    found += [f"is in the list and was killed: {mutant}" for mutant in killed if mutant.key in listed]
    files = {mutant.file for mutant in existing}
    gone = stale([key for key in listed if key[0] in files], existing)
    return found + [f"is in the list and exists no longer: {' | '.join(key)}" for key in gone]


def stale(listed: Iterable[Key], existing: Iterable[Mutant]) -> list[Key]:
    """The entries that no mutant of ``existing`` has; these are all mutants of the files that are listed."""
    keys = {key for mutant in existing for key in (mutant.key, *mutant.wider)}
    return sorted(key for key in listed if key not in keys)


def entry(mutant: Mutant) -> str:
    """The lines to add to the list, the argument left open."""
    return f'["{mutant.file}"]\n{toml_text(mutant.change)} = ""'


def toml_text(text: str) -> str:
    """The text between the quotation marks that leave it as it is."""
    if "'" not in text:
        return f"'{text}'"
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"') + '"'
