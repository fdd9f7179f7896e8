#!/usr/bin/env python3
"""Let Coq check a certificate: `python3 proofs/coq/check_in_coq.py CERTIFICATE`, after `make prove`.

Writes the text of the file, the same as a term, and a plan of the computation as a Coq source (certificate_source.py);
Coq proves that the term has this text, and, by the theorem `certificate_checker`, that what it claims is true. A second
source states this again and lets Coq print the text, the claim and the axioms. The text must be that of the file, the
axioms those of the classical reals; the claim that is shown is the one that Coq printed. Each run has a folder of its
own, which is removed, with a copy of the compiled proofs, which must be those of the record of `make prove`: both are
believed, so who doubts what lies in build/coq runs `make prove` before.
A file that has not the format of certificate.md (read by proofs/checker: canonical JSON, numbers, the hash) is refused
before, so that no text of it can become a command of Coq; so is one with larger numbers than LARGEST,
or longer than LONGEST.
The pieces that the checker in Coq does not know are in UNKNOWN. A number of zeros that rests on a `fold` is
compared with the count law instead, by the theorem `count_checker`: the claim is proved, the pieces are not looked at.
Of a run (version 4) of the scenes that run_source.py knows the first phase is proved, by `run_checker`: contact, and
the first lift-off in its bracket. Coq is given the first line of the file and the steps of this phase; it proves that
the line is the text of the scene. All that follows is seen by proofs/checker alone, which must accept the whole file.

    python3 proofs/coq/check_in_coq.py CERTIFICATE                check it with the proofs in build/coq
    python3 proofs/coq/check_in_coq.py --source NAME CERTIFICATE  print the Coq source of its data

Exit code: 0 proved, 1 not, 2 not run.
"""

from __future__ import annotations

import importlib.util
import json
import math
import os
import re
import resource
import shutil
import sys
import tempfile
from fractions import Fraction
from pathlib import Path
from types import ModuleType
from typing import Any

HERE = Path(__file__).resolve().parent
for folder in (HERE, HERE.parent / "checker"):
    if str(folder) not in sys.path:  # python3 -I
        sys.path.insert(0, str(folder))
if __name__ == "__main__":  # no compiled file of Python is believed either
    sys.dont_write_bytecode, sys.pycache_prefix = True, os.devnull

import run_source  # noqa: E402
from certificate_source import data, head, source  # noqa: E402
from coq_output import WIDE, axioms_printed  # noqa: E402
from coq_run import LIMIT, run  # noqa: E402
from limits import Limits, Rejected, require  # noqa: E402
from pieces import POINTS, read_certificate  # noqa: E402
from reading import entries, one_of, rational, read_header, read_lines, read_range  # noqa: E402
from run import VERSION, check_run  # noqa: E402
from source_rules import LIBRARY  # noqa: E402

BUILD = HERE.parents[1] / "build" / "coq"
LARGEST = 100
"""Of |beta|, of a number of zeros, of |tau|: the plan and Coq's numbers grow with them."""
LONGEST = 500_000
"""Bytes of a file: Coq holds each as a term."""
LONGEST_RUN = 2_000_000
"""Bytes of a run, of which Coq holds the first line and numbers."""
MOST = {"steps": 200, "pieces": 600, "bounds": 4_000, "coefficients of a polynomial": 100, "bits": 640}
"""Of the first phase of a run: what Coq's time grows with."""
LIMIT_RUN = 600
"""Seconds until Coq is stopped, of a run."""
UNKNOWN = {
    "sign": {"fold", "level", "dip"},
    "zeros": {"level", "dip"},
    "force": {*POINTS} - {"left", "sign", "right", "level"},
    "lift_off": {*POINTS} - {"level"},
    "slow_zeros": {*POINTS} - {"dip"},
}
"""By kind of statement: the pieces without which there is no answer."""
VERSIONS = {"sign": 1, "zeros": 1, "force": 2, "lift_off": 2, "slow_zeros": 3}
DENOMINATORS = {2: 64, 3: 512}
"""By version: the largest denominator of an end of beta. Coq computes powers with this exponent."""
LONGEST_NUMBER = 60
"""Signs of a number of which such powers are computed: of the system, epsilon, the level, eta."""
PROOF = """
From GSpot Require Import Statement StatementCertificate StatementChecker CheckerSound CheckerCounts.

Theorem given_is_true : is_file given_file given /\\ forall F, theta_family F -> true_claim F (claimed given).
Proof.
split.
- exists "{hash}"%string. vm_compute. reflexivity.
- intros F HF. apply ({theorem}). vm_compute. reflexivity.
Qed.
"""
FORCE_PROOF = """
From GSpot Require Import StatementForce DipSound.

Theorem given_is_true : is_force_file given_file given /\\ true_force_claim (force_claimed given).
Proof.
split.
- exists "{hash}"%string. vm_compute. reflexivity.
- apply (force_accepted_is_true given_plans). vm_cast_no_check (eq_refl true).
Qed.
"""
RUN_HEAD = """(** * The first phase of a run *)

From Coq Require Import ZArith QArith List String.
From GSpot Require Import CompliantMotion RunScene RunText RunChecker.
Import ListNotations.
Open Scope Z_scope.
"""
RUN_PROOF = """
From GSpot Require Import StatementRun RunRuns.

Theorem given_is_true : given_line = header_text given_header /\\ true_run_claim (its_scene given_header).
Proof.
split.
- vm_compute. reflexivity.
- apply (accepted_run_is_true given). vm_cast_no_check (eq_refl true).
Qed.
"""
BY_PIECES = "accepted_is_true F given_plans given HF"
BY_LAW = "counted_is_true F (claimed given) HF"
BEGINS = """From Coq Require Import String.
From GSpot Require {statements}.
From Given Require given.
"""
AUDIT = (
    BEGINS.format(statements="Statement StatementCertificate StatementChecker")
    + WIDE
    + """
Definition given_is_true : GSpot.StatementChecker.is_file Given.given.given_file Given.given.given
  /\\ forall F, GSpot.StatementCertificate.theta_family F ->
    GSpot.StatementChecker.true_claim F (GSpot.CertificateText.claimed Given.given.given)
  := Given.given.given_is_true.
Eval vm_compute in Given.given.given_file.
Eval vm_compute in GSpot.CertificateText.claim_text (GSpot.CertificateText.claimed Given.given.given).
Print Assumptions given_is_true.
"""
)
FORCE_AUDIT = (
    BEGINS.format(statements="ForceText StatementForce")
    + WIDE
    + """
Definition given_is_true : GSpot.StatementForce.is_force_file Given.given.given_file Given.given.given
  /\\ GSpot.StatementForce.true_force_claim (GSpot.ForceText.force_claimed Given.given.given)
  := Given.given.given_is_true.
Eval vm_compute in Given.given.given_file.
Eval vm_compute in GSpot.ForceText.force_claim_text (GSpot.ForceText.force_claimed Given.given.given).
Print Assumptions given_is_true.
"""
)
RUN_AUDIT = (
    BEGINS.format(statements="RunText StatementRun")
    + WIDE
    + """
Definition given_is_true : Given.given.given_line = GSpot.RunText.header_text Given.given.given_header
  /\\ GSpot.StatementRun.true_run_claim (GSpot.RunText.its_scene Given.given.given_header)
  := Given.given.given_is_true.
Eval vm_compute in Given.given.given_line.
Eval vm_compute in GSpot.RunText.first_phase_text (GSpot.RunText.its_scene Given.given.given_header).
Print Assumptions given_is_true.
"""
)
PRINTED = re.compile(r' += "((?:[^"]|"")*)"%string\n +: string\n')
"""A string as Coq prints it."""


def beside(path: Path) -> ModuleType:
    """Another script of the proofs as a module: the one that is loaded already, where it is of this file."""
    known = sys.modules.get(path.stem)
    if known is not None and known.__spec__ and known.__spec__.origin == str(path):
        return known
    spec = importlib.util.spec_from_file_location(path.stem, path)
    assert spec
    assert spec.loader
    module = importlib.util.module_from_spec(spec)
    sys.modules[path.stem] = module
    spec.loader.exec_module(module)
    return module


def read(given: bytes) -> str:
    """The text of a certificate that this checker may know.

    :raises ValueError: it has not the format, or the checker in Coq does not know its kind or one of its pieces.
    """
    longest = LONGEST_RUN if given.partition(b"\n")[0].endswith(b',"version":4}') else LONGEST
    if len(given) > longest:
        raise ValueError(f"Out of range: the checker in Coq reads files of up to {longest} bytes.")
    try:
        if longest == LONGEST_RUN:
            return read_run(given)
        version, statement, columns = read_certificate(given, Limits())
        kind = statement.get("kind") if isinstance(statement, dict) else None
        known = isinstance(kind, str) and kind in UNKNOWN and version == VERSIONS[kind]
        if not known or any(p.kind in UNKNOWN[kind] for c in columns for p in c.pieces):
            raise ValueError("The checker in Coq does not know this kind of statement, or one of its pieces.")
        ends = [end for column in columns for end in (column.start, column.end)]
        within(*ends, *[point for column in columns for piece in column.pieces for point in (piece.start, piece.end)])
        if version != 1:
            read_force(statement, version, ends)
            return given.decode()
        beta = read_range(statement.get("beta"), "beta")
        within(beta.start, beta.end)
        if kind == "sign":
            tau, _, sign, _ = entries(statement, "the statement", "tau", "beta", "sign", "kind")
            read_range(tau, "tau")
            one_of(sign, (-1, 1), "the sign")
        else:
            _, counts, _ = entries(statement, "the statement", "beta", "counts", "kind")
            require(math.isfinite(beta.start) and math.isfinite(beta.end), "the range of beta is not bounded")
            cells = list(range(max(0, math.floor(beta.start)), math.ceil(beta.end)))
            pairs = isinstance(counts, list) and all(
                isinstance(e, list) and [*map(type, e)] == [int, int] and min(e) >= 0 for e in counts
            )
            require(pairs and [m for m, _ in counts] == cells, "counts does not list the cells of the range")
            within(*[zeros for _, zeros in counts])
    except (Rejected, ArithmeticError) as error:
        raise ValueError(f"Not a certificate: {error}") from error
    return given.decode()


def read_force(statement: dict[str, Any], version: int, ends: list[Any]) -> None:
    """The statement of a certificate about the contact force, and its columns from ``ends`` of beta, as Coq reads them.

    :raises ValueError: a number is too large, or too long.
    """
    kind = statement["kind"]
    if kind == "slow_zeros":
        beta, epsilon, eta, _ = entries(statement, "the statement", "beta", "epsilon", "eta", "kind")
        read, numbers = read_range(beta, "beta"), [epsilon, eta]
        ends = [*ends, read.start, read.end]
        within(read.start, read.end)
    else:
        alpha, *numbers, tau, _ = entries(statement, "the statement", "alpha", "c1", "epsilon", "level", "tau", "kind")
        require(isinstance(alpha, list) and len(alpha) == 3, "alpha is not a list of three numbers")
        numbers += alpha
        if kind == "force":
            read_range(tau, "tau")
        else:
            within(rational(tau))
    for number in numbers:
        rational(number)
    if max(map(len, numbers)) > LONGEST_NUMBER:
        raise ValueError(f"Out of range: the checker in Coq reads numbers of up to {LONGEST_NUMBER} signs here.")
    if not all(math.isfinite(end) for end in ends):
        raise ValueError("Out of range: the checker in Coq reads bounded ranges of beta about the contact force.")
    if any(end.denominator > DENOMINATORS[version] for end in ends):
        most = DENOMINATORS[version]
        raise ValueError(f"Out of range: the checker in Coq reads ends of beta of denominators up to {most} here.")


def read_run(given: bytes) -> str:
    """The text of a run that proofs/checker accepts, and of which the checker in Coq may know the first phase.

    :raises ValueError: the run is not of this kind, or its first phase is too long.
    :raises Rejected: proofs/checker does not accept the run.
    """
    first, *lines = read_lines(given, Limits())
    version, *held = read_header(first)
    require(version == VERSION, "this is not a run")
    check_run(*held, lines, Limits(), len(given))
    text = given.decode()
    _, bits, _, steps = run_source.read(text)
    pieces = [piece for step in steps for piece in step["pieces"]]
    sizes = [len(steps), len(pieces), sum(len(piece["nodes"]) for piece in pieces)]
    sizes += [max(len(c) for step in steps for c in step["x"].values()), bits]
    for (name, most), size in zip(MOST.items(), sizes, strict=True):
        if size > most:
            raise ValueError(
                f"Out of range: the checker in Coq reads a first phase of up to {most} {name}, not {size}."
            )
    return text


def has_fold(text: str) -> bool:
    """Whether a certificate that was read holds a fold."""
    columns = [json.loads(line) for line in text.split("\n")[1:-2]]
    return any(piece[0] == "fold" for column in columns for piece in column["pieces"])


def within(*numbers: float | Fraction) -> None:
    """Numbers for which a plan can be made.

    :raises ValueError: one is finite and larger than LARGEST.
    """
    if any(math.isfinite(number) and abs(number) > LARGEST for number in numbers):
        raise ValueError(f"Out of range: the checker in Coq reads numbers up to {LARGEST}.")


def strings_printed(output: str) -> tuple[str, str, str]:
    """The two strings in what Coq printed for an audit, and what it printed after them.

    :raises RuntimeError: it is not understood.
    """
    first = PRINTED.match(output)
    second = PRINTED.match(output, first.end()) if first else None
    if first is None or second is None:
        raise RuntimeError(f"What Coq prints is not understood:\n{output:.500}")
    held, claim = (match[1].replace('""', '"') for match in (first, second))
    return held, claim, output[second.end() :]


def claim_printed(output: str, text: str) -> tuple[str, str]:
    """The claim in what Coq printed for AUDIT, and what it printed after it.

    :raises RuntimeError: it is not understood, or Coq's text or claim is not the one of the certificate.
    """
    held, claim, rest = strings_printed(output)
    line = text.partition("\n")[0]
    header = json.loads(line)
    if header["version"] == VERSION:
        same = held == line and claim == first_phase(header["statement"])
    else:
        same = held == text and line.endswith(f',"statement":{claim},"version":{header["version"]}}}')
    if not same:
        raise RuntimeError("Coq was given another text than that of the file.")
    return claim, rest


def first_phase(statement: dict[str, Any]) -> str:
    """What Coq proves of a run: its scene, up to the first event."""
    claim = {name: statement[name] for name in ("epsilon", "parameters", "start")}
    return json.dumps(claim | {"first_event": statement["events"][0]}, sort_keys=True, separators=(",", ":"))


def sources(text: str) -> dict[str, str]:
    """What Coq compiles: the certificate with the proof, and what prints the claim and its axioms."""
    version = json.loads(text.partition("\n")[0])["version"]
    if version == VERSION:
        return {"given.v": RUN_HEAD + run_source.data(text) + RUN_PROOF, "audit.v": RUN_AUDIT}
    theorem = BY_LAW if has_fold(text) else BY_PIECES
    proof, audit = (PROOF, AUDIT) if version == 1 else (FORCE_PROOF, FORCE_AUDIT)
    end = proof.format(hash=text.split("\n")[-2].removeprefix("sha256 "), theorem=theorem)
    return {"given.v": head("A certificate", text) + data("given", text) + end, "audit.v": audit}


def proved(text: str, library: dict[str, bytes]) -> str:
    """The claim of a certificate, as Coq printed it after it has accepted the proof; ``library``: the compiled proofs.

    :raises RuntimeError: Coq does not accept it, or what it prints is not understood, or an axiom is not allowed.
    :raises ValueError: no source can be written.
    """
    written = sources(text)
    limit = LIMIT_RUN if "given_line" in written["audit.v"] else LIMIT
    with tempfile.TemporaryDirectory(prefix="check_in_coq-") as place:
        folder, proofs = Path(place, "given"), Path(place, "proofs")
        folder.mkdir()
        proofs.mkdir()
        for name, compiled in library.items():
            (proofs / name).write_bytes(compiled)
        for name, lines in written.items():
            (folder / name).write_text(lines, encoding="utf-8")
            done = run(["coqc", "-q", "-R", "../proofs", LIBRARY, "-R", ".", "Given", name], folder, limit)
            if done.returncode:
                raise RuntimeError(done.stdout + done.stderr)
    claim, rest = claim_printed(done.stdout, text)
    axioms_printed(rest, ["given_is_true"])
    return claim


def how_far(text: str) -> str:
    """What the answer adds where not all of the file is looked at."""
    if json.loads(text.partition("\n")[0])["version"] == VERSION:
        return ", of the first phase alone, contact and then the first lift-off"
    return " by the count law, without the pieces" if has_fold(text) else ""


def deepen_the_stack() -> None:
    """Coq walks through a long string by recursion: 68 kB are too much for a stack of 8 MB, the usual limit."""
    _, most = resource.getrlimit(resource.RLIMIT_STACK)
    resource.setrlimit(resource.RLIMIT_STACK, (most, most))


def main(arguments: list[str]) -> int:
    """The exit code."""
    if arguments[:1] == ["--source"]:
        print(source(arguments[1], Path(arguments[2]).read_text(encoding="utf-8")), end="")
        return 0
    if len(arguments) != 1:
        print("Not run: expected one file, python3 proofs/coq/check_in_coq.py CERTIFICATE")
        return 2
    try:
        with Path(arguments[0]).open("rb") as file:
            given = file.read(LONGEST_RUN + 1)
    except OSError as error:
        print(f"Not run: {error}")
        return 2
    try:
        text = read(given)
    except ValueError as error:
        print(error)
        return 1
    prove = beside(HERE / "prove.py")
    prove.BUILD = BUILD
    try:
        _, library = prove.recorded()
    except RuntimeError as error:
        print(f"Not run: {error}")
        return 2
    if shutil.which("coqc") is None:
        print("Not run: Coq is not found.")
        return 2
    deepen_the_stack()
    try:
        print(f"Proved in Coq{how_far(text)}: {proved(text, library)}")
    except (RuntimeError, ValueError) as error:
        print(error)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
