"""The committed list of survivors: read it, and hold it against what a run found."""

from __future__ import annotations

import tomllib
from collections.abc import Iterable
from pathlib import Path

from mutants.operators import Mutant

Key = tuple[str, str, str, str]
ANY = "*"


def read_survivors(path: Path) -> dict[Key, str]:
    """Each listed mutant with the argument why it is equivalent or harmless.

    :raises ValueError: an entry without an argument, or listed twice.
    """
    found: dict[Key, str] = {}
    for entry in tomllib.loads(path.read_text(encoding="utf-8")).get("survivor", []):
        key = (entry["file"], entry["scope"], entry["before"], entry["after"])
        if key in found:
            raise ValueError(f"listed twice: {key}")
        if not entry.get("argument", "").strip():
            raise ValueError(f"no argument: {key}")
        if key[2] == ANY and (key[1] == "module" or key[3] != ANY):
            raise ValueError(f"a whole scope is a function and every change of it: {key}")
        found[key] = entry["argument"]
    return found


def is_listed(mutant: Mutant, listed: Iterable[Key]) -> bool:
    """Whether the list argues for this mutant, for every change of its line, or for every change of its function."""
    return not {mutant.key, *_wider(mutant)}.isdisjoint(listed)


def is_waived(mutant: Mutant, listed: Iterable[Key]) -> bool:
    """Whether the list argues for every change of its line or of its function: then no test is asked."""
    return not set(_wider(mutant)).isdisjoint(listed)


def _wider(mutant: Mutant) -> tuple[Key, Key]:
    return (mutant.file, mutant.scope, mutant.before, ANY), (mutant.file, mutant.scope, ANY, ANY)


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
    keys = {key for mutant in existing for key in (mutant.key, *_wider(mutant))}
    return sorted(key for key in listed if key not in keys)


def entry(mutant: Mutant) -> str:
    """The text to add to the list, its argument left open."""
    fields = zip(("file", "scope", "before", "after"), mutant.key, strict=True)
    lines = [f"{name} = {_toml(value)}" for name, value in fields]
    return "\n".join(["[[survivor]]", *lines, 'argument = ""'])


def _toml(text: str) -> str:
    if "'" not in text:
        return f"'{text}'"
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"') + '"'
