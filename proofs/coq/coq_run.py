"""Run Coq's programs: with a time limit, and with nothing of the caller's environment that Coq, make or OCaml reads.

Imports nothing beyond the standard library.
"""

from __future__ import annotations

import os
import signal
import subprocess
import time
from collections.abc import Callable
from pathlib import Path

LIMIT = 2400
"""Seconds until a step is given up, on a loaded machine; the whole takes two to three minutes on two free cores."""


class TooLong(RuntimeError):
    """A step that was given up; the text names it."""


def environment(folder: Path) -> dict[str, str]:
    """The whole environment of a step: where the programs are, and no home with files of the user.

    So there is no ``MAKEFLAGS``, ``MAKEFILES``, ``COQPATH``, ``COQEXTRAFLAGS``, ``OCAMLPATH``, ``.coqrc`` or
    ``~/.local/share/coq``. The programs ``coqc``, ``coqchk``, ``coq_makefile`` and ``make`` on PATH are trusted.
    """
    path = os.environ.get("PATH", os.defpath)
    return {"PATH": path, "LC_ALL": "C.UTF-8", "HOME": str(folder), "XDG_DATA_HOME": str(folder / "no_data")}


def run(
    command: list[str],
    folder: Path,
    limit: float = LIMIT,
    alive: Callable[[], None] = lambda: None,
    every: float = 10,
) -> subprocess.CompletedProcess[str]:
    """The command in a folder, its output as text; ``alive`` is called every so many seconds while it runs.

    :raises TooLong: it has not ended within the limit; it and what it started are ended.
    """
    with subprocess.Popen(
        command,
        cwd=folder,
        env=environment(folder),
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        encoding="utf-8",
        errors="replace",
        start_new_session=True,
    ) as process:
        end = time.monotonic() + limit
        try:
            while True:
                left = end - time.monotonic()
                try:
                    output, errors = process.communicate(timeout=max(0, min(every, left)))
                    break
                except subprocess.TimeoutExpired:
                    if left <= every:
                        raise TooLong(f"{command[0]} was given up after {limit:.0f} s, the limit of a step") from None
                alive()
        except BaseException:
            os.killpg(process.pid, signal.SIGKILL)
            raise
    return subprocess.CompletedProcess(command, process.returncode, output, errors)
