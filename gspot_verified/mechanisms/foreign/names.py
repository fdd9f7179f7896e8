"""Names of coordinates and parameters that this library can use: a name of others that it cannot use is changed.

Scenes have names of their own (y, v, lambda_N, ...); a coordinate of such a name gets ``q_`` before it. What formulas
cannot spell, as LaTeX, is written in letters, digits and underscores.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping

from gspot_verified.mechanisms.formulas.names import FUNCTIONS, LETTERS, normal_name
from gspot_verified.mechanisms.formulas.symbol import PI
from gspot_verified.mechanisms.input.mechanism import MechanismError

SCENE_FUNCTIONS = ("y", "v", "p", "b", "u", "x")
"""What scenes compute under these names."""
SCENE_NAMES = ("Y", "V", "Z", "z", "lambda_N", "t", "T", "phase")
"""States and columns of scenes."""
SCENE_END = "_radius"
"""Of the columns that certified samples have beside the others."""

_OTHER = re.compile(rf"[^{LETTERS}0-9_]+")
_LONGEST_TITLE = 80  # characters
_LONGEST = 24  # characters: more is put before and behind, and a name has at most 40


def is_reserved(name: str) -> bool:
    """Whether scenes have this name for something else.

    >>> is_reserved("y"), is_reserved("theta")
    (True, False)
    """
    return name in (*SCENE_FUNCTIONS, *SCENE_NAMES, "nu") or name.endswith(SCENE_END)


def mechanism_name(name: object) -> str:
    """The name, if it is one line of visible text.

    :raises MechanismError: it is not.

    >>> mechanism_name("two-link arm")
    'two-link arm'
    """
    if not isinstance(name, str) or not name.strip() or not name.isprintable() or len(name) > _LONGEST_TITLE:
        raise MechanismError(f"name: one line of visible text is needed, at most {_LONGEST_TITLE} characters")
    return name


def spelled(name: str) -> str:
    """The name in letters, digits and underscores, a letter first.

    >>> spelled(r"\\theta_{1}"), spelled("knee-joint"), spelled("1")
    ('theta_1', 'knee_joint', 'q_1')
    """
    word = _OTHER.sub("_", re.sub(r"[\\{}$ ]+", "", normal_name(name))).strip("_")[:_LONGEST]
    return word if re.match(rf"[{LETTERS}]", word) and word not in (*FUNCTIONS, PI) else f"q_{word}".rstrip("_")


def coordinate_names(names: Iterable[str], parameters: Iterable[str] = ()) -> dict[str, str]:
    """For each name of a coordinate the one that it has here; no two are the same, nor is one another's velocity, nor
    one of the ``parameters``.

    >>> coordinate_names(["x", "phi", "q_x"])
    {'x': 'q_x_', 'phi': 'phi', 'q_x': 'q_x'}
    """
    given = list(names)
    plain = [name for name in given if spelled(name) == name and not is_reserved(name)]
    taken = set(parameters)
    made = {}
    for name in (*plain, *(name for name in given if name not in plain)):
        word = spelled(name)
        if is_reserved(word):
            word = f"{word}_" if word.endswith(SCENE_END) else f"q_{word}"
        made[name] = _free(word, taken, ("", "_dot", "_ref"))
    return {name: made[name] for name in given}


def parameter_names(names: Iterable[str], coordinates: Mapping[str, str]) -> dict[str, str]:
    """For each name of a parameter the one that it has here, other than those of the state.

    >>> parameter_names(["m", "phi_dot"], {"phi": "phi"})
    {'m': 'm', 'phi_dot': 'phi_dot_'}
    """
    taken = {f"{word}{end}" for word in coordinates.values() for end in ("", "_dot", "_ref")} | {"t"}
    return {name: _free(spelled(name), taken, ("",)) for name in names}


def _free(word: str, taken: set[str], ends: tuple[str, ...]) -> str:
    while any(word + end in taken for end in ends):
        word += "_"
    taken.update(word + end for end in ends)
    return word


def once(where: str, given: Iterable[tuple[object, str]]) -> list[str]:
    """The second of each pair, a name, if no two are the same; the first is how it was given.

    :raises MechanismError: two are; the message shows how both were given.

    >>> once("parameters", [("m", "m"), ("k", "k")])
    ['m', 'k']
    >>> once("place", [("y", "q_y"), ("q_y", "q_y")])
    Traceback (most recent call last):
    ...
    gspot_verified.mechanisms.input.mechanism.MechanismError: place: 'y' and 'q_y' are the same, q_y: give it once
    """
    known: dict[str, object] = {}
    for shown, name in given:
        if name in known:
            raise MechanismError(f"{where}: {known[name]!r} and {shown!r} are the same, {name}: give it once")
        known[name] = shown
    return [*known]


def renamed_text(names: Mapping[str, str]) -> list[str]:
    """What a reader is told of names that were changed.

    >>> renamed_text({"y": "q_y", "m": "m"})
    ['renamed: y is q_y here']
    """
    changed = [f"{name} is {word}" for name, word in names.items() if name != word]
    return [f"renamed: {', '.join(changed)} here"] if changed else []
