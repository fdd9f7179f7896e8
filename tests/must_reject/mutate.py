"""Good certificates, and ways to make each of them wrong.

After a change of the content the hash is computed anew, so that the check of the content has to find the fault.
"""

from __future__ import annotations

import copy
import hashlib
import importlib.util
import json
import os
import sys
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from pathlib import Path
from types import ModuleType, SimpleNamespace
from typing import Any

import pytest

HYPOTHESES = ["certificate", "fold", "identities", "initial_values", "laplace", "negative", "tails"]
CHECKER = Path(__file__).resolve().parents[2] / "proofs" / "checker"
PARTS = (
    "limits",
    "reading",
    "theta",
    "pieces",
    "statements",
    "force",
    "intervals",
    "model",
    "mechanism",
    "run",
    "passage",
    "side",
    "approach",
)

Lines = list[Any]
Mutation = Callable[[Lines], None]


def checker() -> SimpleNamespace:
    """The files of ``proofs/checker`` as modules, under their names; ``main`` is the file that is run as a program.

    They are no part of the package. Workers import them by the same names.
    """
    if str(CHECKER) not in sys.path:
        sys.path.append(str(CHECKER))
    parts = {name: importlib.import_module(name) for name in PARTS}
    return SimpleNamespace(**parts, main=_program())


@cache
def _program() -> ModuleType:
    spec = importlib.util.spec_from_file_location("checker_program", CHECKER / "__main__.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def work_of(checker: SimpleNamespace, monkeypatch: pytest.MonkeyPatch) -> list[int]:
    """Every amount of work that is taken from a budget from now on."""
    amounts: list[int] = []
    spend = checker.limits.Meter.spend

    def recorded(meter: Any, products: int, operations: int) -> None:
        amounts.append(products + checker.limits.OPERATION * operations)
        spend(meter, products, operations)

    monkeypatch.setattr(checker.limits.Meter, "spend", recorded)
    return amounts


@dataclass(frozen=True)
class BreakingPieces:
    """In place of the pieces of a column, in any process: an exception, or without one the end of the process."""

    failure: type[Exception] | None

    def __iter__(self) -> Iterator[Any]:
        if self.failure is None:
            os._exit(0)
        raise self.failure("two\nlines")


def canonical(value: Any) -> str:
    return json.dumps(value, sort_keys=True, separators=(",", ":"))


def sealed(body: str | bytes) -> bytes:
    """The body and its hash."""
    data = body.encode() if isinstance(body, str) else body
    return data + b"sha256 " + hashlib.sha256(data).hexdigest().encode() + b"\n"


def text_of(lines: Lines) -> bytes:
    """A certificate from its header and columns."""
    return sealed("".join(f"{canonical(line)}\n" for line in lines))


def lines_of(statement: dict[str, Any], *columns: tuple[list[str], list[Any]]) -> Lines:
    header = {"format": "gspot_verified certificate", "hypotheses": HYPOTHESES, "statement": statement, "version": 1}
    return [header, *({"beta": list(beta), "pieces": pieces} for beta, pieces in columns)]


IWC = lines_of(
    {"beta": "(0, 1)", "kind": "sign", "sign": -1, "tau": "(-inf, inf)"},
    (["0", "1/2"], [["left", "-4/3"], ["sign", "-4/3", "-1/2", 1], ["sign", "-1/2", "0", 1], ["taylor"]]),
    (["1/2", "1"], [["left", "-4/3"], ["sign", "-4/3", "0", 1], ["taylor"]]),
)
IWC_BY_THEOREM = lines_of(
    {"beta": "(0, 1)", "kind": "sign", "sign": -1, "tau": "(-inf, inf)"}, (["0", "1"], [["laplace"]])
)
NEGATIVE_BETA = lines_of(
    {"beta": "(-inf, 0)", "kind": "sign", "sign": 1, "tau": "(-inf, inf)"},
    (["-inf", "-2"], [["laplace"]]),
    (["-2", "0"], [["laplace"]]),
)
HINGE = lines_of(
    {"beta": "(1, 2)", "kind": "sign", "sign": -1, "tau": "(-inf, 0)"},
    (["1", "3/2"], [["left", "-3/4"], ["sign", "-3/4", "-1/2", 1], ["sign", "-1/2", "0", 1]]),
    (["3/2", "2"], [["left", "-3/4"], ["sign", "-3/4", "-1/2", 1], ["hinge", "-1/2", "0"]]),
)
RIGHT = lines_of(
    {"beta": "[5/4, 3/2]", "kind": "sign", "sign": 1, "tau": "[4, inf)"}, (["5/4", "3/2"], [["right", "4", 0]])
)
FOLD_SIGN = lines_of(
    {"beta": "(3, 49/16]", "kind": "sign", "sign": -1, "tau": "(-inf, 1/2]"},
    (
        ["3", "49/16"],
        [["left", "-3/8"], ["sign", "-3/8", "-1/4", 1], ["fold", "-1/4", "1/4"], ["sign", "1/4", "1/2", 1]],
    ),
)
INTEGER = lines_of({"beta": "[4, 4]", "kind": "sign", "sign": -1, "tau": "[0, 0]"})
ZERO = lines_of({"beta": "[3, 3]", "kind": "sign", "sign": 0, "tau": "[0, 0]"})
ZEROS = lines_of(
    {"beta": "(1, 9/8]", "counts": [[1, 1]], "kind": "zeros"},
    (["1", "17/16"], [["left", "-3/8"], ["sign", "-3/8", "0", 1], ["sign", "0", "1/2", 1], ["right", "1/2", 1]]),
    (
        ["17/16", "9/8"],
        [
            ["left", "-1/2"],
            ["sign", "-1/2", "1/2", 1],
            ["sign", "1/2", "3/2", 1],
            ["monotone", "3/2", "2", -1],
            ["monotone", "2", "3", -1],
            ["right", "3", 0],
        ],
    ),
)
FOLD = lines_of(
    {"beta": "(95/32, 49/16)", "counts": [[2, 2], [3, 1]], "kind": "zeros"},
    (
        ["95/32", "3"],
        [
            ["left", "-3/8"],
            ["sign", "-3/8", "-1/4", 1],
            ["fold", "-1/4", "1/4"],
            ["monotone", "1/4", "1/2", 1],
            ["right", "1/2", 0],
        ],
    ),
    (
        ["3", "49/16"],
        [
            ["left", "-3/8"],
            ["sign", "-3/8", "-1/4", 1],
            ["fold", "-1/4", "1/4"],
            ["sign", "1/4", "1/2", 1],
            ["right", "1/2", 1],
        ],
    ),
)
# The zeros are -0.2405377930647989... and 2.0772867676126555...
BRACKETS = lines_of(
    {"beta": "7/3", "brackets": [["-1203/5000", "-481/2000"], ["2077/1000", "1039/500"]], "kind": "brackets"},
    (
        ["7/3", "7/3"],
        [
            ["left", "-1/2"],
            ["monotone", "-1/2", "0", -1],
            ["sign", "0", "1", -1],
            ["sign", "1", "2", -1],
            ["monotone", "2", "5/2", 1],
            ["right", "5/2", 0],
        ],
    ),
)
GOOD = {
    "iwc": IWC,
    "iwc by theorem": IWC_BY_THEOREM,
    "negative beta": NEGATIVE_BETA,
    "hinge": HINGE,
    "right": RIGHT,
    "fold sign": FOLD_SIGN,
    "integer": INTEGER,
    "zero": ZERO,
    "zeros": ZEROS,
    "fold": FOLD,
    "brackets": BRACKETS,
}


def mutated(lines: Lines, mutation: Mutation) -> bytes:
    """The text after a change of the content, with a new hash."""
    changed = copy.deepcopy(lines)
    mutation(changed)
    assert text_of(changed) != text_of(lines), "the mutation changes nothing"
    return text_of(changed)


def state(**entries: Any) -> Mutation:
    """Other entries of the statement."""
    return lambda lines: lines[0]["statement"].update(entries)


def head(**entries: Any) -> Mutation:
    """Other entries of the header."""
    return lambda lines: lines[0].update(entries)


def column_ends(column: int, *ends: Any) -> Mutation:
    return lambda lines: lines[column].update(beta=list(ends))


def drop_column(column: int) -> Mutation:
    return lambda lines: lines.pop(column)


def swap_columns(one: int, two: int) -> Mutation:
    def change(lines: Lines) -> None:
        lines[one], lines[two] = lines[two], lines[one]

    return change


def drop_piece(column: int, piece: int) -> Mutation:
    return lambda lines: lines[column]["pieces"].pop(piece)


def put_piece(column: int, piece: int, *new: Any) -> Mutation:
    return lambda lines: lines[column]["pieces"].__setitem__(piece, list(new))


def put_pieces(column: int, *new: Any) -> Mutation:
    return lambda lines: lines[column].update(pieces=[list(piece) for piece in new])


def move_end(column: int, piece: int, entry: int, by: Fraction) -> Mutation:
    """One end of a piece moves: a gap or an overlap."""

    def change(lines: Lines) -> None:
        target = lines[column]["pieces"][piece]
        target[entry] = str(Fraction(target[entry]) + by)

    return change


def move_column_end(column: int, entry: int, by: Fraction) -> Mutation:
    def change(lines: Lines) -> None:
        lines[column]["beta"][entry] = str(Fraction(lines[column]["beta"][entry]) + by)

    return change
