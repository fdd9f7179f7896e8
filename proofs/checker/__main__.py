"""Check a certificate: dΘ/dτ, the force, a run, a passage, an approach. Usage: python checker [OPTIONS] CERTIFICATE

The format is on the page certificate.md; every lemma named here is proved there or on check.md. Nothing beyond Python's
standard library is imported. The parts, in the order in which they are read; each uses those before it:

    limits       what a check may cost, and products that are paid before they are made (check.md, section 6)
    reading      from bytes to numbers and ranges (certificate.md, Text)
    theta        values of F and its derivatives on boxes (check.md, Models and sections 1 to 4)
    pieces       the hypotheses of each piece (certificate.md, Columns and Pieces)
    statements   the sign and the zeros of dΘ/dτ (certificate.md, Statements; integer β: check.md, section 5)
    force        the contact force and its zeros (certificate.md, Statements; check.md, sections 5a and 5b)
    intervals    intervals of integers, rounded outward (run_certificate.md, section 6)
    model        the equations and events of the model system (run_certificate.md, section 1)
    mechanism    the equations and events of a mechanism, from its mass matrix, forces and contact (section 1a there)
    run          a run: its steps, signs and events (run_certificate.md, sections 2 to 4)
    passage      from a state towards the G-spot for all small ε (from_state.md, section 10)
    side         a passage, and what follows: lift-off or impact for all small ε (from_state.md, section 11)
    approach     a mechanism in rigid slip from a state to a G-spot (approach_certificate.md)
    __main__     the kinds of statements, and the command line
"""

from __future__ import annotations

import os
import re
import stat
import sys
from collections.abc import Sequence

import approach
import force
import passage
import run
import side
import statements
from limits import Limits, Rejected, reject
from pieces import read_certificate
from reading import read_header, read_lines

RULES = {1: statements.RULES, 2: force.FORCE, 3: force.SLOW_ZEROS}  # of each version: kind and check
OF_LINES = {  # of versions without columns
    run.VERSION: run.check_run,
    passage.VERSION: passage.check_passage,
    approach.VERSION: approach.check_approach,
    side.VERSION: side.check_side,
}
USAGE = "usage: python checker [--workers N] [--limit NAME=NUMBER]... CERTIFICATE"
LIMITS = f"; the limits are {', '.join(Limits._fields)}"
STATUS = {"VERIFIED": 0, "REJECTED": 1, "usage": 64}  # exit codes; 64 as in sysexits.h


def check_text(data: bytes, limits: Limits | None = None, workers: int = 1) -> str:
    """The statement that a certificate proves."""
    limits = limits or Limits()
    try:
        first, *lines = read_lines(data, limits)
        header = read_header(first)
        if header[0] in OF_LINES:
            return OF_LINES[header[0]](*header[1:], lines, limits, len(data))
        version, statement, columns = read_certificate(data, limits)
        checker = statements.Checker(statement, columns, limits, limits.budget(len(data)), workers)
        kind, rules = statement.get("kind") if isinstance(statement, dict) else None, RULES[version]
        return rules[kind](checker) if isinstance(kind, str) and kind in rules else reject("unknown kind of statement")
    except Rejected:
        raise
    except Exception as error:  # whatever it is, nothing was verified
        raise Rejected(f"the check failed with {type(error).__name__}") from error


class Usage(Exception):
    """The command line is not one that can be run."""


def read_arguments(arguments: Sequence[str]) -> tuple[str, Limits, int]:
    """The file, the limits and the number of workers."""
    limits, workers, files = Limits(), 1, []
    waiting = iter(arguments)
    for word in waiting:
        option, equals, value = word.partition("=")
        if option not in ("--workers", "--limit"):
            if word == "--help":
                raise Usage(f"the exit status is 0 for VERIFIED alone, 1 for REJECTED, else {STATUS['usage']}{LIMITS}")
            if word.startswith("-"):
                raise Usage(f"there is no option {word} (a file of this name is ./{word})")
            files.append(word)
            continue
        text = value if equals else next(waiting, "")
        name, _, number = text.rpartition("=")
        if not re.fullmatch("[1-9][0-9]{0,11}", number):
            form = f", as NAME=NUMBER, not {text!r}{LIMITS}" if option == "--limit" else f", not {text!r}"
            raise Usage(f"{option} needs a positive integer{form}")
        if option == "--workers" and not name:
            workers = int(number)
        elif option == "--limit" and name in Limits._fields:
            limits = limits._replace(**{name: int(number)})
        else:
            raise Usage(f"there is no {option} {text!r}{LIMITS}")
    if len(files) != 1:
        raise Usage("one certificate is checked at a time")
    return files[0], limits, workers


def read_file(name: str, limits: Limits) -> bytes:
    """The bytes of a regular file; its length is looked at first."""
    # Without O_NONBLOCK the opening of a pipe would wait for a writer.
    descriptor = os.open(name, os.O_RDONLY | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_BINARY", 0))
    with open(descriptor, "rb") as file:
        status = os.fstat(descriptor)
        if not stat.S_ISREG(status.st_mode):
            raise Usage("this is not a regular file")
        limits.keep("bytes", status.st_size)
        return file.read(limits.bytes + 1)


def main(arguments: Sequence[str]) -> int:
    """One line of output and the exit status: 0 verified, 1 rejected, 64 not a certificate to be checked."""
    try:
        name, limits, workers = read_arguments(arguments)
        line = f"VERIFIED {check_text(read_file(name, limits), limits, workers)}"
    except Rejected as reason:
        line = f"REJECTED {reason}"
    except (MemoryError, OSError, ValueError, Usage) as error:
        line = f"{USAGE}: {error}"
    status = STATUS[re.split("[ :]", line)[0]]
    stream = sys.stderr if status else sys.stdout
    encoding = stream.encoding or "ascii"
    print(line.encode(encoding, "backslashreplace").decode(encoding), file=stream)
    return status


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
