"""The tests notice a wrong bound: with one radius shrunk on purpose the sharpness tests must fail."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

_ROOT = Path(__file__).resolve().parents[2]


_THETA = (
    "tests/theta_function/test_sharpness.py",
    "tests/theta_function/value/test_majorant.py",
    "tests/theta_function/value/test_mean_value.py",
    "tests/theta_function/boxes/test_box.py::test_bounds_that_are_attained",
)
_COMPLIANT = ("tests/compliant/test_sharpness.py",)
_INTEGRATOR = ("tests/integrator/test_sharpness.py",)
_UNIFORM = ("tests/expansion/true_solutions/test_piece.py", "tests/expansion/true_solutions/test_growth_ranges.py")
_AFFINE = tuple(f"tests/expansion/from_state/test_affine_{name}.py" for name in ("hand_over", "tube"))


def _slow(sabotage: str) -> object:
    """A run that takes long: a part of ``make test-all``."""
    return pytest.param(sabotage, marks=pytest.mark.slow)


def _run(files: tuple[str, ...], *options: str) -> int:
    command = [
        sys.executable, "-m", "pytest", "-q", "-x", "-p", "no:cacheprovider", "-p", "no:xdist", *options, *files
    ]  # fmt: skip
    return subprocess.run(command, cwd=_ROOT, capture_output=True, timeout=300, check=False).returncode


@pytest.mark.slow
def test_green_without_sabotage() -> None:
    assert _run(_THETA) == 0
    assert _run(_COMPLIANT) == 0
    assert _run(_INTEGRATOR) == 0
    assert _run(_UNIFORM) == 0
    assert _run(_AFFINE) == 0


# The first six bounds are attained to 2^-20 relative; the others are wider than the error, by less than 2^20.
@pytest.mark.parametrize(
    "sabotage",
    [
        *map(_slow, ("majorant:20", "mean_value:20", "splitting:20", "box:20", "laplace:-20", "finite_part:-20")),
        "taylor:20", "negative:20", "positive:-20",
    ],
)  # fmt: skip
def test_red_with_a_shrunk_radius(sabotage: str) -> None:
    assert _run(_THETA, "--sabotage", sabotage) == 1


# The first two are attained to 2^-20 relative.
@pytest.mark.parametrize(
    "sabotage",
    [
        "grid:20", "slow_integral:20", "epsilon_series:-20", "slow_coefficient:-20", "fast_coefficient:-20",
        "side_rule:-20",
    ],
)  # fmt: skip
def test_red_with_a_shrunk_radius_of_the_compliant_model(sabotage: str) -> None:
    assert _run(_COMPLIANT, "--sabotage", sabotage) == 1


@pytest.mark.parametrize("sabotage", ["step:20", "norm_step:20"])  # attained to 2^-20 relative
def test_red_with_a_shrunk_radius_of_the_integrator(sabotage: str) -> None:
    assert _run(_INTEGRATOR, "--sabotage", sabotage) == 1


@pytest.mark.slow
@pytest.mark.parametrize("sabotage", ["growth:20", "piece:20"])
def test_red_with_a_shrunk_radius_of_a_deviation(sabotage: str) -> None:
    assert _run(_UNIFORM, "--sabotage", sabotage) == 1


@pytest.mark.slow
@pytest.mark.parametrize("sabotage", ["affine_hand_over:20", "affine_tube:20"])
def test_red_with_a_shrunk_hand_over(sabotage: str) -> None:
    assert _run(_AFFINE, "--sabotage", sabotage) == 1
