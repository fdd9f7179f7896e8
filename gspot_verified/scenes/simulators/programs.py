"""Other programs that simulate rigid bodies, run where they are installed: which, and how their models differ."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import partial

from gspot_verified.scenes.simulators.mujoco_steps import STIFF, mujoco_steps, mujoco_version
from gspot_verified.scenes.simulators.planar_body import PlanarBody
from gspot_verified.scenes.simulators.simulated import Simulated

MUJOCO = "MuJoCo"
PROGRAMS = (MUJOCO,)


@dataclass(frozen=True)
class Program:
    """``runs``: settings, and the run that is still to be made, of a body, a step and a time."""

    name: str
    version: str
    differs: str
    runs: Callable[[PlanarBody, float, float], Iterator[tuple[str, Callable[[], Simulated]]]]


@dataclass(frozen=True)
class Installed:
    """``missing``: of each program that is not, how it is installed."""

    found: tuple[Program, ...]
    missing: tuple[str, ...]


def installed(names: Sequence[str]) -> Installed:
    """Those of these programs that are installed.

    :raises ValueError: a name of none.

    >>> installed([])
    Installed(found=(), missing=())
    """
    unknown = next((name for name in names if name not in PROGRAMS), None)
    if unknown is not None:
        raise ValueError(f"programs: expected names of {', '.join(PROGRAMS)}, got {str(unknown)[:40]!r}")
    found, missing = [], []
    for name in names:
        version = mujoco_version()
        if version is None:
            missing.append(f"{name} is not installed, so it was not run: pip install {name.lower()}")
        else:
            found.append(Program(name, version, _MUJOCO_DIFFERS, _of_mujoco))
    return Installed(tuple(found), tuple(missing))


_MUJOCO_DIFFERS = (
    "another model: a soft contact, a convex friction cone that also pushes a contact apart when it slips, and a start "
    "at gap 0 without force; it need not take the side of the paper"
)


def _of_mujoco(body: PlanarBody, step: float, until: float) -> Iterator[tuple[str, Callable[[], Simulated]]]:
    yield f"dt = {step:.1e}, solref = {STIFF * step:.1e} 1, elliptic", partial(
        mujoco_steps, body, step=step, until=until
    )  # fmt: skip
