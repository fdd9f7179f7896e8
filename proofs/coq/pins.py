"""The text of each definition and statement that is read, held against statements.txt: a change is seen and said.

A pin is the SHA-256 of a definition without its comments, each run of blanks as one; what a statement says depends on
the definitions that it uses, and these are pinned beside it. One more pin for each file, under the name ``*``, holds
all else that can change a meaning: the files that it imports, the scopes it opens, its strings. The order counts, too.
Imports nothing beyond the standard library.
"""

from __future__ import annotations

import hashlib
import re
from collections.abc import Sequence

from source_rules import code, sentences

NAMED = re.compile(r"(?:Definition|Fixpoint|Inductive|Record) (\w+)\b.*")
STRING = re.compile(r'"(?:[^"]|"")*"')
REST = "*"
HEADER = """# The statements and the definitions that they use, by `prove.py --pin`: file, name, SHA-256 of the text.
# `make prove` refuses another text. Who changes a statement on purpose writes this file anew, and says so.
"""


def pins(text: str) -> dict[str, str]:
    """The hash of each definition of a file by its name, and that of all else."""
    named: dict[str, list[str]] = {REST: STRING.findall(code(text, strings=True))}
    before = ""
    for sentence in sentences(code(text)):
        if match := NAMED.fullmatch(sentence):
            before = match[1]
            named.setdefault(before, []).append(sentence)
        else:
            named[REST].append(f"after {before}: {sentence}")
    return {name: hashlib.sha256("\n".join(said).encode()).hexdigest() for name, said in named.items()}


def pinned(texts: dict[str, bytes], files: Sequence[str]) -> str:
    """What statements.txt should say of these files."""
    rows = [f"{file}.v {name} {held}\n" for file in files for name, held in pins(texts[f"{file}.v"].decode()).items()]
    return HEADER + "".join(rows)


def changes(written: str, now: str) -> list[str]:
    """The definitions whose text is not the pinned one: changed, new, or gone; in words.

    :raises ValueError: a line is no file, name and hash.
    """
    before, after = (
        {(file, name): held for file, name, held in map(str.split, text.removeprefix(HEADER).splitlines())}
        for text in (written, now)
    )
    said = []
    for file, name in {**before, **after}:
        old, new = before.get((file, name)), after.get((file, name))
        if old != new:
            what = "is new" if old is None else "is gone" if new is None else "has another text"
            said.append(f"{file}: {'what is neither definition nor comment' if name == REST else name} {what}")
    return said or ([] if written == now else ["their order is another, or one is listed twice"])
