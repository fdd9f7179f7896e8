"""Hold each theorem against its statement, list its axioms, run coqchk: on what is compiled in a folder.

Imports nothing beyond the standard library.
"""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from coq_output import AXIOMS, WIDE, axioms_printed, kernel_accepts
from coq_run import run
from source_rules import LIBRARY

KERNEL_LIMIT = 900
"""Seconds until coqchk is given up; it takes 80 to 100 s on a free core."""


class Refused(RuntimeError):
    """The proofs do not pass; the first line says what fails."""


def assumptions(stated: dict[str, str], folder: Path, jobs: int) -> dict[str, list[str]]:
    """The axioms of each theorem, by Coq's `Print Assumptions`; each proof is held against its statement again.

    :raises RuntimeError: a statement without a theorem of its name and type, or an answer that is not understood.
    """
    shares = [dict(list(stated.items())[start::jobs]) for start in range(jobs)]
    with ThreadPoolExecutor(jobs) as pool:
        parts = pool.map(assumptions_of, range(jobs), shares, [folder] * jobs)
    return {name: axioms for part in parts for name, axioms in part.items()}


def assumptions_of(number: int, stated: dict[str, str], folder: Path) -> dict[str, list[str]]:
    """One share of :func:`assumptions`, in a file of its own."""
    lines = [f"From {LIBRARY} Require {' '.join(sorted({*stated.values()}))} Theorems."]
    for name, file in stated.items():
        proof = f"{LIBRARY}.{file}.{name} := {LIBRARY}.Theorems.{name}"
        lines += [f"Definition check_{name} : {proof}.", f"Print Assumptions check_{name}."]
    (folder / f"audit_{number}.v").write_text(WIDE + "\n".join(lines) + "\n", encoding="utf-8")
    done = run(["coqc", "-q", "-R", ".", LIBRARY, f"audit_{number}.v"], folder)
    if done.returncode:
        raise Refused(f"A statement is not proved:\n{done.stdout}{done.stderr}")
    return axioms_printed(done.stdout, list(stated))


def differences(printed: dict[str, list[str]], expected: dict[str, list[str]]) -> list[str]:
    """How the axioms printed by Coq differ from the list, and which are none of the four allowed."""
    wrong = [
        f"{name} uses {', '.join(printed.get(name, ['none']))}, listed {', '.join(expected.get(name, ['none']))}"
        for name in sorted({*printed, *expected})
        if printed.get(name) != expected.get(name)
    ]
    return wrong + [f"{name}: not an axiom of the classical reals: {axiom}"
                    for name, axioms in printed.items() for axiom in axioms if axiom not in AXIOMS]  # fmt: skip


def check_kernel(folder: Path) -> None:
    """coqchk on everything that Theorems.v uses, the standard library too.

    :raises Refused: it does not accept, or its summary is not understood.
    """
    command = ["coqchk", "-silent", "-o", "-bytecode-compiler", "yes", "-R", ".", LIBRARY, f"{LIBRARY}.Theorems"]
    done = run(command, folder, KERNEL_LIMIT)
    if done.returncode or not kernel_accepts(done.stdout + done.stderr):
        raise Refused(f"coqchk does not accept the proofs:\n{done.stdout}{done.stderr}")
