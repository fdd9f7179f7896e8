"""A certificate as a Coq source: its text, the same as a term, and for each column a plan of the computation.

A wrong term has another text than the file, and a bad plan proves nothing. Imports nothing beyond the standard library.
"""

from __future__ import annotations

import json
import math
from fractions import Fraction
from typing import Any

HEADER = """(** * {title}

    Written by proofs/coq/check_in_coq.py: the text of the file, the certificate with this text, and for each column
    a plan of the computation. *)

From Coq Require Import ZArith QArith List String.
From GSpot Require Import CertificateText Checker CheckerCertificate.
Import ListNotations.
Open Scope Q_scope.
"""


def number(text: str) -> str:
    """A rational as a Coq term."""
    value = Fraction(text)
    top = f"({value.numerator})" if value < 0 else value.numerator
    return f"({top} # {value.denominator})"


def edge(text: str) -> str:
    """An end of a range, which may be infinite."""
    return {"-inf": "MinusInfinity", "inf": "PlusInfinity"}.get(text) or f"(At {number(text)})"


def truth(value: bool) -> str:
    """A Boolean as a Coq term."""
    return "true" if value else "false"


def interval(text: str) -> str:
    """A range."""
    low, high = text[1:-1].split(", ")
    return f"(Interval {edge(low)} {edge(high)} {truth(text[0] == '[')} {truth(text[-1] == ']')})"


def entry(piece: list[Any]) -> str:
    """A piece."""
    kind, *arguments = piece
    words = [number(word) if isinstance(word, str) else str(word) for word in arguments]
    if kind in ("sign", "monotone"):
        words[2] = truth(arguments[2] == 1)
    return " ".join([kind.capitalize(), *words])


def claim(statement: dict[str, Any]) -> str:
    """The statement of the certificate."""
    if statement["kind"] == "sign":
        return f"SignClaim {interval(statement['tau'])} {interval(statement['beta'])} {truth(statement['sign'] == 1)}"
    counts = "; ".join(f"({cell}, {zeros})%nat" for cell, zeros in statement["counts"])
    return f"ZerosClaim {interval(statement['beta'])} [{counts}]"


def degree(width: float, goal: float) -> int:
    """How many coefficients in eta make the rest less than e^-goal."""
    count = 1
    while count < 60 and width and math.lgamma(count + 1) - count * math.log(width) < goal:
        count += 1
    return count


def plan(column: dict[str, Any]) -> str:
    """How to compute on a column: any choice is sound, a bad one proves nothing."""
    points = [Fraction(word) for piece in column["pieces"] for word in piece[1:] if isinstance(word, str)]
    if column["beta"][0] == "-inf" or not points:
        return "Plan 1 0 1 0 [] (Effort 0 0 1 0 0)"
    low, high = map(Fraction, column["beta"])
    right = float(max(0, *points))
    accuracy = 12 + 0.2 * right**1.5 + 0.6 * float(high)
    x = 2 * math.ceil(max(accuracy ** (2 / 3), 1.5 * float(high) ** (2 / 3), 5.0, float(-min(points))) / 2)
    terms = max(round(x**1.5 / 3), math.ceil(high / 3) + 1)
    loss = x**1.5  # bits: 2/3 x^(3/2) of natural logarithm, on the way from -x to 0
    bits = 8 * math.ceil((30 + accuracy + 1.3 * loss + 0.5 * right**1.5) / 8)
    width = float(high - low) / 2 * (math.log(x) + 2)
    main, rest = degree(width, 0.7 * (accuracy + loss)), degree(width, 0.7 * accuracy)
    return f"Plan {x} {terms} (2 ^ {bits}) 4 [{main}; {rest}; {rest}; {rest}]%nat (Effort 500 1000 2 8 200)"


def data(name: str, text: str) -> str:
    """The text, the certificate and the plans as Coq definitions."""
    lines = text.split("\n")
    columns = [json.loads(line) for line in lines[1:-2]]
    blocks = [
        f"Block {edge(column['beta'][0])} {number(column['beta'][1])}\n     [{'; '.join(map(entry, column['pieces']))}]"
        for column in columns
    ]
    between = ";\n   "
    doubled = text.replace('"', '""')
    return (
        f'\nDefinition {name}_file : string := "{doubled}"%string.\n\n'
        f"Definition {name} : certificate := Certificate ({claim(json.loads(lines[0])['statement'])})\n"
        f"  [{between.join(blocks)}].\n\n"
        f"Definition {name}_plans : list plan :=\n  [{between.join(map(plan, columns))}].\n"
    )


def source(name: str, text: str) -> str:
    """A file of the development that holds this data."""
    return HEADER.format(title=f"The certificate {name}.cert") + data(name, text)
