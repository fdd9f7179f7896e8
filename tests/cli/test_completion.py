"""Shell completion, as a shell asks for it, and the version."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import gspot_verified


def completed(words: str, folder: Path) -> list[str]:
    """What bash is told for a line that ends where the cursor is."""
    environment = {
        **os.environ,
        "_GSPOT_VERIFIED_COMPLETE": "complete_bash",
        "COMP_WORDS": words,
        "COMP_CWORD": str(len(words.split(" ")) - 1),
        "PYTHONPATH": str(Path(gspot_verified.__file__).parents[1]),
    }
    command = [sys.executable, "-m", "gspot_verified"]
    run = subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True, check=False)
    assert run.stderr == ""
    return run.stdout.split()


def test_commands_and_mechanisms(tmp_path: Path) -> None:
    for name in ("own.toml", "own.txt", ".own.toml"):
        (tmp_path / name).touch()
    assert completed("gspot-verified cl", tmp_path) == ["classify"]
    assert completed("gspot-verified classify o", tmp_path) == ["oscillator", "own.toml"]
    assert set(completed("gspot-verified expand ", tmp_path)) == {"model", "extended", "oscillator", "rod", "own.toml"}


def test_the_version() -> None:
    command = [sys.executable, "-m", "gspot_verified", "--version"]
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    assert (run.returncode, run.stdout) == (0, f"gspot-verified {gspot_verified.__version__}\n")
