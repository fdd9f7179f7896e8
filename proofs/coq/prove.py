#!/usr/bin/env python3
"""Compile the formal proofs, print what each theorem assumes, and leave a record of it.

    python3 proofs/coq/prove.py                 what `make prove` runs
    python3 proofs/coq/prove.py --check-kernel  also coqchk, the independent checker of the compiled proofs (minutes)
    python3 proofs/coq/prove.py --pin           write statements.txt anew, after a statement was changed on purpose

Every statement of the files Statement*.v, that is every `Definition name : Prop := ...`, must be proved in Theorems.v
under its name; its axioms must be those that assumptions.txt lists for it, no more and no fewer; the texts of the
statements and of the definitions in these files must be those whose hashes statements.txt holds (pins.py). The
certificates that the proofs hold as text must be the files. A source that says more than source_rules.py lists is
refused.
All is compiled anew, in a folder of its own, without the caller's environment (coq_run.py): nothing made before is
believed. When all is proved the folder becomes build/coq, with the record, build/coq/record.json: the hash of each
source, of _CoqProject and of each compiled file, and the axioms of each theorem. An old record is removed first.
Imports nothing beyond the standard library; installs nothing.

Exit code: 0 proved, 1 a proof or a list of axioms fails, 2 not run, since Coq or Coquelicot is missing.
"""

from __future__ import annotations

import argparse
import hashlib
import json
import os
import re
import shutil
import signal
import sys
import tempfile
import time
from pathlib import Path
from typing import Any

HERE = Path(__file__).resolve().parent
if str(HERE) not in sys.path:  # python3 -I
    sys.path.insert(0, str(HERE))
if __name__ == "__main__":  # no compiled file of Python is believed either
    sys.dont_write_bytecode, sys.pycache_prefix = True, os.devnull

from audit import Refused, assumptions, check_kernel, differences  # noqa: E402
from certificate_source import source  # noqa: E402
from coq_output import strange_references  # noqa: E402
from coq_run import run  # noqa: E402
from pins import changes, pinned  # noqa: E402
from source_rules import code, project_files, refusals  # noqa: E402

BUILD = HERE.parents[1] / "build" / "coq"
RECORD = "record.json"
PROJECT = "_CoqProject"
PINS = "statements.txt"
CERTIFICATES = {
    "CertificateIWC.v": HERE.parent / "iwc_0_1.cert",
    "CertificateZeros.v": HERE / "zeros_1_2.cert",
    "DataForce.v": HERE.parent / "force_5_2.cert",
    "DataLiftOff.v": HERE.parent / "lift_off_5_2.cert",
    "DataSlowZeros.v": HERE.parent / "zeros_4_5.cert",
    "DataRun.v": HERE.parent / "run_fig_varsim1.cert",
}
"""The sources that are written from the bytes of a file (certificate_source.py)."""
STATED_IN = (
    "Statement",
    "StatementModels",
    "StatementCompliant",
    "StatementFlight",
    "StatementStep",
    "StatementApproach",
    "StatementPassage",
    "StatementCertificate",
    "StatementChecker",
    "StatementForce",
    "StatementRun",
)
"""The files of statements: Theta, boxes, the mechanism at every eps, after lift-off, steps, slip to a G-spot,
from a state to the G-spot for all eps, certificates, checkers of these, a checker of runs."""
READ = (*STATED_IN, "CertificateText", "ForceText", "RunScene", "RunText")
"""Who wants to know what is proved reads these."""
BELIEVED = {
    "CheckerCertificate": {"accepts", "counted"},
    "CertificateIWC": {"iwc_0_1", "iwc_0_1_file", "iwc_0_1_plans"},
    "CertificateZeros": {"zeros_1_2", "zeros_1_2_file", "zeros_1_2_plans"},
    "ForceChecker": {"force_accepts", "force_plan"},
    "DataForce": {"force_5_2", "force_5_2_file", "force_5_2_plans"},
    "DataLiftOff": {"lift_off_5_2", "lift_off_5_2_file", "lift_off_5_2_plans"},
    "DataSlowZeros": {"zeros_4_5", "zeros_4_5_file", "zeros_4_5_plans"},
    "RunChecker": {"run_accepted"},
    "DataRun": {"run_fig_varsim1", "run_fig_varsim1_scene"},
}
"""What a statement may name beside: the checkers whose soundness is stated, and the text or the data of files."""
STATED = re.compile(r"^[ ]*Definition (\w+) : Prop :=", re.MULTILINE)
MISSING = """The formal proofs were not run: {what} not found. They need Coq 8.16 and Coquelicot 3. On Debian or Ubuntu:
    apt-get install --no-install-recommends coq libcoq-coquelicot libcoq-mathcomp-ssreflect make
Nothing else in this project needs them."""


def read_sources() -> dict[str, bytes]:
    """_CoqProject and the files that it lists, in its order.

    :raises ValueError: it has not its one form, a source is not listed, or a listed one is no file of this folder.
    """
    project = (HERE / PROJECT).read_bytes()
    names = project_files(project.decode())
    present = {path.name for path in HERE.glob("*.v")}
    wrong = [f"{name} is not in {PROJECT}" for name in sorted(present - {*names})]
    wrong += [f"{name} is not a file here" for name in names if (HERE / name).is_symlink() or name not in present]
    if wrong:
        raise ValueError("\n".join(wrong))
    return {PROJECT: project} | {name: (HERE / name).read_bytes() for name in names}


def unproved(texts: dict[str, bytes]) -> list[str]:
    """Where a source says more than it may: leaves a proof out, adds an axiom, switches a check off, and so on."""
    names = [name for name in texts if name != PROJECT]
    return [f"{name}: {what}" for name in names for what in refusals(texts[name].decode(), names)]


def other_texts(texts: dict[str, bytes]) -> list[str]:
    """The sources that are not what is written from the bytes of a certificate."""
    others = []
    for name, path in CERTIFICATES.items():
        try:
            same = texts[name] == source(path.stem, path.read_bytes().decode()).encode()
        except (OSError, ValueError, LookupError, TypeError):  # no file, or no certificate
            same = False
        if not same:
            others.append(f"{name}: {path.name}")
    return others


def statements(texts: dict[str, bytes]) -> dict[str, str]:
    """The file that states each theorem, by name: the definitions of type Prop without arguments.

    :raises ValueError: two files state one name, or a comment holds what looks like a statement.
    """
    files: dict[str, str] = {}
    for file in STATED_IN:
        text = texts[f"{file}.v"].decode()
        names = STATED.findall(code(text))
        if names != STATED.findall(text):
            raise ValueError(f"{file}.v: a comment looks like a statement")
        for name in names:
            if name in files:
                raise ValueError(f"{files[name]}.v and {file}.v both state {name}")
            files[name] = file
    return files


def other_statements(texts: dict[str, bytes]) -> list[str]:
    """The statements and definitions that have not the text that is pinned."""
    return changes((HERE / PINS).read_text(encoding="utf-8"), pinned(texts, READ))


def digests(texts: dict[str, bytes]) -> dict[str, str]:
    """SHA-256 of each."""
    return {name: hashlib.sha256(text).hexdigest() for name, text in texts.items()}


def compiled(names: list[str], folder: Path) -> dict[str, bytes]:
    """The compiled file of each source."""
    return {f"{name}o": (folder / f"{name}o").read_bytes() for name in names}


def missing() -> str:
    """What the proofs need and this machine does not have; empty when nothing is missing."""
    tools = [tool for tool in ("coqc", "coq_makefile", "make") if shutil.which(tool) is None]
    if tools:
        return ", ".join(tools)
    with tempfile.TemporaryDirectory() as folder:
        Path(folder, "probe.v").write_text("From Coquelicot Require Import Coquelicot.\n", encoding="utf-8")
        return "Coquelicot" if run(["coqc", "-q", "probe.v"], Path(folder)).returncode else ""


def compile_all(texts: dict[str, bytes], folder: Path, jobs: int) -> None:
    """Compile in an empty folder.

    :raises Refused: a file does not compile.
    """
    for name, text in texts.items():
        (folder / name).write_bytes(text)
    began = time.monotonic()
    for command in (["coq_makefile", "-f", PROJECT, "-o", "Makefile"], ["make", f"-j{jobs}"]):
        done = run(command, folder, alive=lambda: say(compiling(folder, texts, time.monotonic() - began)))
        if done.returncode:
            raise Refused(f"A file does not compile:\n{done.stdout}{done.stderr}")
    without = [name for name in texts if name != PROJECT and not (folder / f"{name}o").is_file()]
    if without:
        raise Refused(f"Not compiled: {', '.join(without)}")


def say(text: str) -> None:
    """A step of the work, on stderr."""
    print(f"... {text}", file=sys.stderr, flush=True)


def compiling(folder: Path, texts: dict[str, bytes], seconds: float) -> str:
    """How far it is: the files that are there, and about how long still, by their share of the lines."""
    lines = {name: text.count(b"\n") for name, text in texts.items() if name != PROJECT}
    times = {name: (folder / f"{name}o").stat().st_mtime for name in lines if (folder / f"{name}o").is_file()}
    if not times:
        return f"compiling the first of {len(lines)} files, {seconds:.0f} s"
    share = sum(map(lines.__getitem__, times)) / sum(lines.values())
    newest = max(times, key=times.__getitem__)
    still = seconds * (1 - share) / share
    return f"{len(times)} of {len(lines)} files compiled in {seconds:.0f} s, {newest} last; about {still:.0f} s still"


def listed() -> dict[str, list[str]]:
    """What assumptions.txt lists for each theorem."""
    lines = (HERE / "assumptions.txt").read_text(encoding="utf-8").splitlines()
    rows = [line.partition(":") for line in lines if line and not line.startswith("#")]
    return {name: sorted(axioms.split()) for name, _, axioms in rows}


def recorded() -> tuple[dict[str, Any], dict[str, bytes]]:
    """The record of a run on these sources, and the compiled files of which it holds the hashes.

    :raises Refused: there is none, it is of other sources, or the compiled files are others; the text says which.
    """
    try:
        record = json.loads((BUILD / RECORD).read_text(encoding="utf-8"))
    except FileNotFoundError:
        raise Refused("The formal proofs were not run here; `make prove` runs them.") from None
    except (OSError, ValueError):
        record = None
    try:
        texts = read_sources()
        same = all(record[key] == value for key, value in known_run(texts, listed()).items()) and record["coq"]
    except (OSError, ValueError, LookupError, TypeError):
        same = False
    if not same:
        raise Refused("The formal proofs were run on other sources than these; `make prove` runs them again.")
    try:
        files = compiled([name for name in texts if name != PROJECT], BUILD)
    except OSError:
        files = {}
    if record.get("compiled") != digests(files):
        raise Refused("The compiled proofs are not those of the record; `make prove` makes them again.")
    return record, files


def state() -> str:
    """Whether the formal proofs were run on these sources, in words."""
    try:
        record, _ = recorded()
    except Refused as error:
        return str(error)
    return f"The formal proofs: {len(record['theorems'])} theorems proved by Coq {record['coq']} from these sources."


def known_run(texts: dict[str, bytes], theorems: dict[str, list[str]]) -> dict[str, Any]:
    """What a record of these sources holds, but for what Coq made of them."""
    hashes = digests(texts)
    return {"project": hashes.pop(PROJECT), "sources": hashes, "theorems": theorems}


def prove_in(folder: Path, texts: dict[str, bytes], jobs: int, kernel: bool) -> dict[str, Any]:
    """The whole job in an empty folder: the record.

    :raises RuntimeError: something is not proved, or a step takes too long.
    :raises ValueError: a name is stated twice.
    """
    say(f"compiling {len(texts) - 1} files, {jobs} at once: two to three minutes on two free cores")
    compile_all(texts, folder, jobs)
    say("holding each theorem against its statement, listing its axioms")
    for file in STATED_IN:
        if strange := strange_references((folder / f"{file}.glob").read_text(encoding="utf-8"), READ, BELIEVED):
            raise Refused("\n".join([f"{file}.v speaks of what nobody reads:", *strange]))
    names = statements(texts)
    axioms = assumptions(names, folder, jobs)
    for name in names:
        print(f"{name}: {', '.join(axiom.split('.')[-1] for axiom in axioms[name]) or 'no axiom'}")
    for file in STATED_IN:  # whoever shows a statement later can see whether it is this one
        print(f"Stated in {file}.v, SHA-256 {hashlib.sha256(texts[f'{file}.v']).hexdigest()}")
    if wrong := differences(axioms, listed()):
        raise Refused("\n".join(["The axioms differ from assumptions.txt:", *wrong]))
    if kernel:
        say("coqchk on all that was compiled: 80 to 100 s on a free core")
        check_kernel(folder)
    if read_sources() != texts:
        raise Refused("A source changed while it was compiled")
    version = run(["coqc", "--print-version"], folder).stdout.split()[0]
    built = digests(compiled([name for name in texts if name != PROJECT], folder))
    return known_run(texts, axioms) | {"coq": version, "kernel": kernel, "compiled": built}


def prove(jobs: int, kernel: bool) -> int:
    """The whole job; the exit code."""
    (BUILD / RECORD).unlink(missing_ok=True)
    began = time.monotonic()
    try:
        texts = read_sources()
        if wrong := unproved(texts):
            raise Refused("\n".join(["A source says what it may not:", *wrong]))
        if wrong := other_texts(texts):
            raise Refused("\n".join(["A text is not that of the file:", *wrong]))
        if wrong := other_statements(texts):
            raise Refused("\n".join([f"A statement is not the one of {PINS}:", *wrong]))
        if what := missing():
            print(MISSING.format(what=what))
            return 2
        BUILD.parent.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(prefix="coq-", dir=BUILD.parent) as place:
            folder = Path(place, "coq")
            folder.mkdir()
            record = prove_in(folder, texts, jobs, kernel)
            (folder / RECORD).write_text(json.dumps(record, indent=1, sort_keys=True) + "\n", encoding="utf-8")
            if BUILD.exists():
                BUILD.rename(Path(place, "old"))
            folder.rename(BUILD)
    except (RuntimeError, ValueError, OSError) as error:
        print(error, file=sys.stderr)
        return 1
    seconds = time.monotonic() - began
    print(f"{len(record['theorems'])} theorems proved by Coq {record['coq']} in {seconds:.0f} s, on the axioms named.")
    print(f"Record: {BUILD / RECORD}")
    return 0


if __name__ == "__main__":
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(143))  # so that what was started ends too
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--jobs", type=int, default=2, help="files compiled at once (2)")
    parser.add_argument("--check-kernel", action="store_true", help="also run coqchk on the compiled proofs")
    parser.add_argument("--pin", action="store_true", help=f"only write {PINS} anew")
    parser.add_argument("--state", action="store_true", help="only say whether they were run on these sources")
    arguments = parser.parse_args()
    if arguments.pin:
        (HERE / PINS).write_text(pinned(read_sources(), READ), encoding="utf-8")
        sys.exit(0)
    if arguments.state:
        print(state())
        sys.exit(0)
    sys.exit(prove(arguments.jobs, arguments.check_kernel))
