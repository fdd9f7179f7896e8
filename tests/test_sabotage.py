"""The tests notice a wrong bound: with one radius shrunk on purpose the sharpness tests must fail."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

_ROOT = Path(__file__).resolve().parent.parent


def _run(*options: str) -> int:
    command = [
        sys.executable, "-m", "pytest", "-q", "-x", "-p", "no:cacheprovider", "-p", "no:xdist", *options,
        "tests/theta_function/test_sharpness.py",
        "tests/theta_function/test_majorant.py",
        "tests/theta_function/test_mean_value.py",
        "tests/theta_function/test_box.py::test_bounds_that_are_attained",
    ]  # fmt: skip
    return subprocess.run(command, cwd=_ROOT, capture_output=True, timeout=300, check=False).returncode


def test_green_without_sabotage() -> None:
    assert _run() == 0


# The first six bounds are attained to 2^-20 relative; the others are wider than the error, by less than 2^20.
@pytest.mark.parametrize(
    "sabotage",
    [
        "majorant:20", "mean_value:20", "negative:20", "taylor:20", "splitting:20", "box:20",
        "positive:-20", "laplace:-20", "finite_part:-20",
    ],
)  # fmt: skip
def test_red_with_a_shrunk_radius(sabotage: str) -> None:
    assert _run("--sabotage", sabotage) == 1
