"""What a source of the formal proofs may say, and the one form of _CoqProject: what is not known here is refused.

The sources use a small part of Coq's language, and this file lists it. Nothing in the list can add an axiom unseen,
switch off a check of Coq, read another file, or give a known sign another meaning. Coq's own lexer is followed: strings
within comments, comments within comments, a sentence that ends with a full stop and a blank, bullets and braces.
Imports nothing beyond the standard library.
"""

from __future__ import annotations

import re

LIBRARY = "GSpot"
PROJECT = re.compile(rf"-R \. {LIBRARY}\n\n((?:[A-Z][A-Za-z0-9]*\.v\n)+)")
TOKEN = re.compile(r'\(\*|\*\)|"(?:[^"]|"")*"|[^"(*]+|.', re.DOTALL)
ELSEWHERE = {"Coq", "Coquelicot"}
"""The libraries beside this one."""
WITHIN_A_SECTION = {"Context", "Hypothesis", "Let", "Variable", "Variables"}
"""Outside of a section these would be axioms."""
COMMAND = re.compile(
    r"(?:Context|Corollary|Definition|Example|Fixpoint|Hypothesis|Inductive|Lemma|Let|Record|Theorem|Variables?) .*"
    r"|Proof|Qed|(?:Section|End) \w+"
    rf"|From (?:{'|'.join(sorted(ELSEWHERE))}) Require Import(?: [A-Z]\w*)+"
    rf"|From {LIBRARY} Require(?: Import)?(?: [A-Z]\w*)+"
    r"|Import ListNotations|Open Scope (?:R|Q|Z|nat|string)_scope"
    r"|Notation [\w']+ := \([\w' ]+\)|Arguments \w+ : simpl never|Global Opaque \w+|Global Instance \w+ : .*"
)
"""The commands, each with its whole form."""
TACTIC = re.compile(r"(?:\d+: )?[a-z].*")
"""Coq has no command that begins with a small letter."""
START = re.compile(r"(?:[\s{}+*-]|\d+\s*:\s*\{)*")
"""Bullets and braces: sentences without a full stop."""
FORBIDDEN = re.compile(
    r"\b(?:Admitted|admit|give_up|Axioms?|Parameters?|Conjecture|Unset|bypass_check|Declare|Extraction|Primitive"
    r"|native_compute|native_cast_no_check|where)\b|:>|<<:"
)
"""Signs that leave out a proof, use the native compiler, or declare a notation or a coercion within a sentence."""


def project_files(text: str) -> list[str]:
    """The files that _CoqProject lists.

    :raises ValueError: it has not its one form, names a file twice, or one like a library.
    """
    match = PROJECT.fullmatch(text)
    if match is None:
        raise ValueError(f"_CoqProject is not '-R . {LIBRARY}', an empty line and one name of a file on each line")
    names = match[1].split()
    if len(set(names)) < len(names) or {name.removesuffix(".v") for name in names} & {*ELSEWHERE, LIBRARY}:
        raise ValueError("_CoqProject names a file twice, or one with the name of a library")
    return names


def code(text: str, strings: bool = False) -> str:
    """The text with every comment as a blank and every string as an empty one, or with its strings.

    :raises ValueError: a character other than those that are printed in ASCII and line feeds; a comment or a string
        without an end; a comment right after a full stop, where Coq reads another sign.
    """
    if strange := re.search(r"[^\n -~]", text):
        raise ValueError(f"the character {strange[0]!a}")
    depth, kept = 0, [""]
    for match in TOKEN.finditer(text):
        token = match[0]
        if token == '"':
            raise ValueError("a string without an end")
        if token == "(*":
            if depth == 0 and kept[-1].endswith("."):
                raise ValueError("a comment right after a full stop")
            kept.append(" ")
            depth += 1
        elif token == "*)" and depth:
            depth -= 1
        elif depth == 0:
            kept.append('""' if token[0] == '"' and not strings else token)
    if depth:
        raise ValueError("a comment without an end")
    return "".join(kept)


def sentences(text: str) -> list[str]:
    """The sentences of a text without comments, each on one line, without the bullets before it.

    :raises ValueError: the last one has no full stop.
    """
    *whole, rest = re.split(r"\.(?=\s|$)", text)
    if START.sub("", rest, count=1):
        raise ValueError("the last sentence has no full stop")
    return [" ".join(START.sub("", sentence, count=1).split()) for sentence in whole]


def refusals(text: str, files: list[str]) -> list[str]:
    """Why a source with this text may not be compiled; empty when it may. ``files``: those of the development."""
    try:
        said = sentences(code(text))
    except ValueError as error:
        return [str(error)]
    refused, depth = [], 0
    for sentence in said:
        word = sentence.partition(" ")[0]
        depth += (word == "Section") - (word == "End")
        known = COMMAND.fullmatch(sentence) or TACTIC.fullmatch(sentence)
        if not known or FORBIDDEN.search(sentence) or (word in WITHIN_A_SECTION and depth < 1):
            refused.append(f"{sentence:.60}")
        elif word == "From" and sentence.split()[1] == LIBRARY:
            required = sentence.removeprefix(f"From {LIBRARY} Require ").removeprefix("Import ").split()
            refused += [f"{sentence:.60}" for name in required if f"{name}.v" not in files]
    return refused
