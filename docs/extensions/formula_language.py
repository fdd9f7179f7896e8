"""The language of formulas in a mechanism's file: what the parser knows is asked of it, not written again."""

from __future__ import annotations

import re
from collections.abc import Iterator

from gspot_verified.mechanisms.formulas import formula
from gspot_verified.mechanisms.formulas.names import FUNCTIONS
from gspot_verified.mechanisms.formulas.symbol import PI
from gspot_verified.mechanisms.input.file import parse_mechanism
from gspot_verified.mechanisms.input.mechanism import MechanismError

MEANINGS = {
    "sin": "sine of an angle in radians",
    "cos": "cosine of an angle in radians",
    "tan": "tangent of an angle in radians",
    "exp": "exponential function",
    "sqrt": "square root: the power 1/2",
    "log": "natural logarithm",
}
LIMITS = {
    "MAX_LENGTH": "characters of a formula",
    "MAX_DEPTH": "brackets and powers that are open at once",
    "MAX_POWER": "size of an exponent, and of the product of nested ones",
    "MAX_NESTED_FUNCTIONS": "functions within functions",
    "MAX_DIGITS": "characters of one number",
}
SAMPLE = """\
format = 1
name = "a rod on a belt"

[parameters]
mu = "73/36"
m = "1"

[angles.theta]
sine = "3/5"
cosine = "4/5"

[lagrangian]
coordinates = ["X", "Y", "theta"]
time = "t"
mass_matrix = [["m", 0, 0], [0, 1, 0], [0, 0, "1/3"]]
forces = [0, "-3/5", 0]

[contact]
x = "X + cos(theta)"
y = "Y - sin(theta)"
mu = "mu"

[g_spot]
fixed = ["X", "X_dot", "t"]

[g_spot.point]
X = 0
Y = "3/5"
theta = "theta_ref"
X_dot = 2
Y_dot = "4/5"
theta_dot = 1
t = 0
"""
PLACES = {
    "parameters.*": ('m = "1"', "m = {}"),
    "lagrangian.mass_matrix": ('"1/3"]', "{}]"),
    "lagrangian.forces": ('"-3/5"', "{}"),
    "contact.x": ('"X + cos(theta)"', "{}"),
    "contact.y": ('"Y - sin(theta)"', "{}"),
    "contact.mu": ('mu = "mu"', "mu = {}"),
    "g_spot.point.*": ('Y = "3/5"', "Y = {}"),
}
"""Where each kind of formula stands in the sample."""
_KNOWN = re.compile(r"known here: ([^\n]*)")


def names_at(place: str) -> list[str]:
    """The names that the reader of files knows in the formulas of a key, for the sample: it lists them itself.

    >>> names_at("parameters.*")
    ['mu']
    """
    old, new = PLACES[place]
    if SAMPLE.count(old) != 1:
        raise ValueError(f"the sample has no single {old}")
    try:
        parse_mechanism(SAMPLE.replace(old, new.format('"no_such_name"')))
    except MechanismError as error:
        known = _KNOWN.search(str(error))
        return [] if known is None else known[1].split(", ")
    raise ValueError(f"{place}: an unknown name was read")


def language() -> str:
    """The lists of the page, in Markdown."""
    return "\n".join([*_functions(), *_names(), *_limits()])


def _functions() -> Iterator[str]:
    yield from ("| function | meaning |", "|---|---|")
    yield from (f"| `{name}(…)` | {MEANINGS[name]} |" for name in FUNCTIONS)
    yield from (
        "",
        f"The one constant with a name is `{PI}`. Names of functions and `{PI}` cannot be names of your own.",
        "",
    )


def _names() -> Iterator[str]:
    yield "The names that are known depend on the key. In a file with the coordinates X, Y and theta, the time t, the"
    yield "parameters m and mu, and a table of the reference angle of theta they are:"
    yield from ("", "| key | names |", "|---|---|")
    yield from (f"| `{place}` | {', '.join(f'`{name}`' for name in names_at(place))} |" for place in PLACES)
    yield ""


def _limits() -> Iterator[str]:
    yield from ("| limit | |", "|---|---|")
    yield from (f"| {words} | {getattr(formula, name)} |" for name, words in LIMITS.items())
    yield ""
