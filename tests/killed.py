"""A run that is killed at a known state: when its journal has so many lines. It sends SIGKILL to itself."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from pathlib import Path

_ROOT = Path(__file__).resolve().parents[1]
_KILL = """
import os, signal
from gspot_verified.work.journal_file import JournalFile
honest = JournalFile.add_text
def add(self, text):
    kept = honest(self, text)
    if len(self.lines) == {lines}:
        os.kill(os.getpid(), signal.SIGKILL)
    return kept
JournalFile.add_text = add
"""


def killed_after(lines: int, program: str, journal: Path) -> bytes:
    """The journal of the program, which a kill ended after so many lines, in the midst of the next one."""
    command = [sys.executable, "-c", _KILL.format(lines=lines) + program]
    done = subprocess.run(command, capture_output=True, env={**os.environ, "PYTHONPATH": str(_ROOT)}, check=False)
    assert done.returncode == -signal.SIGKILL, done.stderr
    whole = journal.read_bytes()
    assert whole.count(b"\n") == 1 + lines
    with journal.open("ab") as file:
        file.write(b'["1/')
    return whole
