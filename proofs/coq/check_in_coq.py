#!/usr/bin/env python3
"""Let Coq check a certificate: `python3 proofs/coq/check_in_coq.py CERTIFICATE`, after `make prove`.

Writes the text of the file, the same as a term, and a plan of the computation as a Coq source; Coq proves that the term
has this text, and, by the theorem `certificate_checker`, that what it claims is true. A second source states this
again and prints its axioms, which must be those of the classical reals. A file that has not the format of
certificate.md (read by proofs/check.py: canonical JSON, numbers, the hash) is refused before, so that no text of it can
become a command of Coq. Beyond that this script is trusted to copy the text: a wrong term has another text, and a bad
plan proves nothing. The pieces `fold`, `level` and `dip` are not known to the checker in Coq.

    python3 proofs/coq/check_in_coq.py CERTIFICATE                check it with the proofs in build/coq
    python3 proofs/coq/check_in_coq.py --source NAME CERTIFICATE  print the Coq source of its data

Exit code: 0 proved, 1 not, 2 not run.
"""

from __future__ import annotations

import importlib.util
import json
import math
import shutil
import sys
from fractions import Fraction
from pathlib import Path
from types import ModuleType
from typing import Any

HERE = Path(__file__).resolve().parent
BUILD = HERE.parents[1] / "build" / "coq"
UNKNOWN = {"fold", "level", "dip"}
HEADER = """(** * {title}

    Written by proofs/coq/check_in_coq.py: the text of the file, the certificate with this text, and for each column
    a plan of the computation. *)

From Coq Require Import ZArith QArith List String.
From GSpot Require Import CertificateText Checker CheckerCertificate.
Import ListNotations.
Open Scope Q_scope.
"""
PROOF = """
From GSpot Require Import Statement StatementCertificate StatementChecker CheckerSound.

Theorem given_is_true : is_file given_file given /\\ forall F, theta_family F -> true_claim F (claimed given).
Proof.
split.
- exists "{hash}"%string. vm_compute. reflexivity.
- intros F HF. apply (accepted_is_true F given_plans given HF). vm_compute. reflexivity.
Qed.
"""
AUDIT = """From GSpot Require Statement StatementCertificate StatementChecker given.

Definition given_is_true : StatementChecker.is_file given.given_file given.given
  /\\ forall F, StatementCertificate.theta_family F ->
    StatementChecker.true_claim F (CertificateText.claimed given.given)
  := given.given_is_true.
Goal True. idtac "theorem given_is_true". Abort.
Print Assumptions given_is_true.
"""


def beside(path: Path) -> ModuleType:
    """Another script of the proofs as a module."""
    spec = importlib.util.spec_from_file_location(path.stem, path)
    assert spec
    assert spec.loader
    module = importlib.util.module_from_spec(spec)
    sys.modules[path.stem] = module
    spec.loader.exec_module(module)
    return module


def read(data: bytes) -> str:
    """The text of a certificate that this checker may know.

    :raises ValueError: it has not the format, or the checker in Coq does not know its kind or one of its pieces.
    """
    check = beside(HERE.parent / "check.py")
    try:
        version, statement, columns = check.read_certificate(data, check.Limits())
        kind = statement.get("kind") if isinstance(statement, dict) else None
        if version != 1 or kind not in ("sign", "zeros") or any(p.kind in UNKNOWN for c in columns for p in c.pieces):
            raise ValueError("The checker in Coq does not know this kind of statement, or one of its pieces.")
        beta = check.read_range(statement.get("beta"), "beta")
        if kind == "sign":
            tau, _, sign, _ = check.entries(statement, "the statement", "tau", "beta", "sign", "kind")
            check.read_range(tau, "tau")
            check.one_of(sign, (-1, 1), "the sign")
        else:
            _, counts, _ = check.entries(statement, "the statement", "beta", "counts", "kind")
            cells = list(range(max(0, math.floor(beta.start)), math.ceil(beta.end)))
            pairs = isinstance(counts, list) and all(
                isinstance(e, list) and [*map(type, e)] == [int, int] and min(e) >= 0 for e in counts
            )
            check.require(pairs and [m for m, _ in counts] == cells, "counts does not list the cells of the range")
    except (check.Rejected, ArithmeticError) as error:
        raise ValueError(f"Not a certificate: {error}") from error
    return data.decode()


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


def main(arguments: list[str]) -> int:
    """The exit code."""
    if arguments[:1] == ["--source"]:
        print(source(arguments[1], Path(arguments[2]).read_text(encoding="utf-8")), end="")
        return 0
    if len(arguments) != 1:
        print("Not run: expected one file, python3 proofs/coq/check_in_coq.py CERTIFICATE")
        return 2
    try:
        given = Path(arguments[0]).read_bytes()
    except OSError as error:
        print(f"Not run: {error}")
        return 2
    prove = beside(HERE / "prove.py")
    prove.BUILD = BUILD
    if shutil.which("coqc") is None or "proved by Coq" not in prove.state():
        print("Not run: Coq is not found, or `make prove` was not run on these sources.")
        return 2
    try:
        text = read(given)
    except ValueError as error:
        print(error)
        return 1
    end = PROOF.format(hash=text.split("\n")[-2].removeprefix("sha256 "))
    (BUILD / "given.v").write_text(HEADER.format(title="A certificate") + data("given", text) + end, encoding="utf-8")
    (BUILD / "given_audit.v").write_text(AUDIT, encoding="utf-8")
    for name in ("given.v", "given_audit.v"):
        done = prove.run(["coqc", "-q", "-R", ".", "GSpot", name])
        if done.returncode:
            print(done.stdout + done.stderr)
            return 1
    axioms = prove.axioms_printed(done.stdout)["given_is_true"]
    if not set(axioms) <= prove.AXIOMS:
        print(f"Not proved: it uses {', '.join(axioms)}")
        return 1
    print(f"Proved in Coq: {json.dumps(json.loads(text.split(chr(10))[0])['statement'], sort_keys=True)}")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
