"""A certificate as a Coq source: its text, the same as a term, and for each column a plan of the computation.

A wrong term has another text than the file, and a bad plan proves nothing. Imports nothing beyond the standard library.
"""

from __future__ import annotations

import json
import math
from collections.abc import Callable
from fractions import Fraction
from typing import Any, NamedTuple

import run_source

HEADER = """(** * {title}

    Written by proofs/coq/check_in_coq.py: the text of the file, the certificate with this text, and for each column
    a plan of the computation. *)

From Coq Require Import ZArith QArith List String.
From GSpot Require Import CertificateText Checker {modules}.
Import ListNotations.
Open Scope Q_scope.
"""


def number(text: str) -> str:
    """A rational as a Coq term."""
    return run_source.number(Fraction(text))


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
    start, guard = (4, 14) if column["pieces"][:1] and column["pieces"][0][0] == "dip" else (12, 30)
    accuracy = start + 0.2 * right**1.5 + 0.6 * float(high)
    x = 2 * math.ceil(max(accuracy ** (2 / 3), 1.5 * float(high) ** (2 / 3), 5.0, float(-min(points))) / 2)
    terms = max(round(x**1.5 / 3), math.ceil(high / 3) + 1)
    loss = x**1.5  # bits: 2/3 x^(3/2) of natural logarithm, on the way from -x to 0
    bits = 8 * math.ceil((guard + accuracy + 1.3 * loss + 0.5 * right**1.5) / 8)
    width = float(high - low) / 2 * (math.log(x) + 2)
    main, rest = degree(width, 0.7 * (accuracy + loss)), degree(width, 0.7 * accuracy)
    return f"Plan {x} {terms} (2 ^ {bits}) 4 [{main}; {rest}; {rest}; {rest}]%nat (Effort 500 1000 2 8 200)"


def powers(column: dict[str, Any]) -> str:
    """For a piece dip: two numbers between which (t1/t2)^(b - 1) lies on the column, with exponents; else zeros."""
    kind, *points = column["pieces"][0] if column["pieces"] else [""]
    low, high = map(Fraction, column["beta"])
    if kind != "dip" or low < 2 or Fraction(points[0]) <= 0:
        return "0 0 0 0"
    ratio = float(Fraction(points[0]) / Fraction(points[1]))
    parts = 2 ** max(1, math.ceil(-math.log2(4 * max(high - low, Fraction(1, 1024)))))
    longest, shortest = Fraction(math.ceil((high - 2) * parts), parts), Fraction(math.floor((low - 2) * parts), parts)
    least, most = (ratio ** float(exponent) * 16 * parts for exponent in (longest, shortest))
    numbers = [math.floor(least - 0.1), math.ceil(most + 0.1)]
    below, above = (number(str(Fraction(value, 16 * parts))) for value in numbers)
    return f"{below} {number(str(longest))} {above} {number(str(shortest))}"


def force_plan(column: dict[str, Any]) -> str:
    """The same for a certificate about the contact force."""
    return f"ForcePlan ({plan(column)}) {powers(column)}"


def part(piece: list[Any]) -> str:
    """A piece of a certificate about the contact force."""
    return entry(piece) if piece[0] in ("level", "dip") else f"Known ({entry(piece)})"


def force_claim(statement: dict[str, Any]) -> str:
    """The statement of a certificate about the contact force."""
    if statement["kind"] == "slow_zeros":
        return f"SlowZerosClaim {interval(statement['beta'])} {number(statement['epsilon'])} {number(statement['eta'])}"
    numbers = [*statement["alpha"], statement["c1"], statement["epsilon"], statement["level"]]
    name, tau = ("ForceClaim", interval) if statement["kind"] == "force" else ("LiftOffClaim", number)
    return " ".join([name, *map(number, numbers), tau(statement["tau"])])


class Terms(NamedTuple):
    """How certificates of one kind are written: the modules, the words, and the functions for their parts."""

    modules: str
    kind: str
    plan_kind: str
    make: str
    make_column: str
    claim: Callable[[dict[str, Any]], str]
    begin: Callable[[str], str]
    piece: Callable[[list[Any]], str]
    plan: Callable[[dict[str, Any]], str]


THETA = Terms("CheckerCertificate", "certificate", "plan", "Certificate", "Block", claim, edge, entry, plan)
FORCE = Terms(
    *("CheckerCertificate ForceText ForceChecker", "force_data", "force_plan", "ForceData", "Strip"),
    *(force_claim, number, part, force_plan),
)


def terms_of(text: str) -> Terms:
    """How this certificate is written: version 1, or version 2 or 3."""
    return THETA if json.loads(text.partition("\n")[0])["version"] == 1 else FORCE


def data(name: str, text: str) -> str:
    """The text, the certificate and the plans as Coq definitions."""
    lines, terms = text.split("\n"), terms_of(text)
    columns = [json.loads(line) for line in lines[1:-2]]
    blocks = [
        f"{terms.make_column} {terms.begin(column['beta'][0])} {number(column['beta'][1])}\n"
        f"     [{'; '.join(map(terms.piece, column['pieces']))}]"
        for column in columns
    ]
    between = ";\n   "
    doubled = text.replace('"', '""')
    return (
        f'\nDefinition {name}_file : string := "{doubled}"%string.\n\n'
        f"Definition {name} : {terms.kind} := {terms.make} ({terms.claim(json.loads(lines[0])['statement'])})\n"
        f"  [{between.join(blocks)}].\n\n"
        f"Definition {name}_plans : list {terms.plan_kind} :=\n  [{between.join(map(terms.plan, columns))}].\n"
    )


def head(title: str, text: str) -> str:
    """How a source with this certificate begins."""
    return HEADER.format(title=title, modules=terms_of(text).modules)


def source(name: str, text: str) -> str:
    """A file of the development that holds this data; of a run (version 4), what run_source.py writes."""
    if json.loads(text.partition("\n")[0])["version"] == 4:
        return run_source.source(name, text)
    return head(f"The certificate {name}.cert", text) + data(name, text)
