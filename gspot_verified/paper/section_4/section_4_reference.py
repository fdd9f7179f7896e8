"""Ledger of Section 4: two references to a display that has no number."""

from __future__ import annotations

import re

from gspot_verified.paper.checks.entry import Builders, Entry, Rung, Section
from gspot_verified.paper.checks.paper import printed_number
from gspot_verified.paper.checks.words import quoted

LABEL = "lines 982 to 986, 1025 to 1026, 1378 to 1380"
NAME = "eq:modelSysTEliminated"
"""The label of the display of line 984."""


def has_a_number() -> bool | None:
    """Whether LaTeX's counters give the label's display a number."""
    return printed_number(NAME) is not None


def is_a_numbered_environment() -> bool | None:
    """Whether the environment around the label is one with numbers, where a reference names the label."""
    words = quoted(LABEL)
    found = re.findall(r"\\begin\{equation(\*?)\}(?:(?!\\end).)*\\label\{" + NAME + r"\}", words)
    if len(found) != 1 or rf"\eqref{{{NAME}}}" not in words:
        return None
    return not found[0]


def _reference() -> Entry:
    return Section("Section 4").settled(
        "4-reference",
        LABEL,
        r"\text{Inserting this into (...); the equation (...) is linear in }b",
        "The references in lines 1025 and 1378 name the equation for b of line 984 by its number",
        Rung.EXACT.check("LaTeX's counters up to the display", has_a_number(), "the display has no number"),
        Rung.EXACT.check(
            "the environment of the label and the references, in the source",
            is_a_numbered_environment(),
            "equation*: the reference cannot print a number of this display",
        ),
        corrected="The display gets a number: equation in place of equation*",
        note="What LaTeX prints is the number of the section, which is also that of another equation.",
    )


ENTRIES: Builders = {"4-reference": _reference}
"""The references to the single equation for b."""
