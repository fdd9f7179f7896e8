"""Other programs that simulate rigid bodies, run where they are installed: which, and how their models differ."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import partial

from gspot_verified.scenes.simulators.drake_engine import SOLVERS, DrakeEngine, drake_version, spring
from gspot_verified.scenes.simulators.engine import STIFF, follow
from gspot_verified.scenes.simulators.mujoco_engine import MujocoEngine, mujoco_version
from gspot_verified.scenes.simulators.planar_model import PlanarModel
from gspot_verified.scenes.simulators.simulated import Simulated

MUJOCO, DRAKE = "MuJoCo", "Drake"
PROGRAMS = (MUJOCO, DRAKE)


@dataclass(frozen=True)
class Program:
    """``runs``: settings, and the run that is still to be made, of bodies, a step and a time."""

    name: str
    version: str
    differs: str
    runs: Callable[[PlanarModel, float, float], Iterator[tuple[str, Callable[[], Simulated]]]]


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
        find, differs, runs = _KNOWN[name]
        version = find()
        if version is None:
            missing.append(f"{name} is not installed, so it was not run: pip install {name.lower()}")
        else:
            found.append(Program(name, version, differs, runs))
    return Installed(tuple(found), tuple(missing))


def _of_mujoco(model: PlanarModel, step: float, until: float) -> Iterator[tuple[str, Callable[[], Simulated]]]:
    def run() -> Simulated:
        return follow(model, MujocoEngine(model, step), step=step, until=until)

    yield f"dt = {step:.1e}, solref = {STIFF * step:.1e} 1, elliptic", run


def _of_drake(model: PlanarModel, step: float, until: float) -> Iterator[tuple[str, Callable[[], Simulated]]]:
    def run(solver: str) -> Simulated:
        return follow(model, DrakeEngine(model, step, solver), step=step, until=until)

    for solver in SOLVERS:
        yield f"{solver}, dt = {step:.1e}, k = {spring(model, step).stiffness:.1e}", partial(run, solver)


_KNOWN = {
    MUJOCO: (
        mujoco_version,
        "another model: a soft contact, a convex friction cone that also pushes a contact apart when it slips, and a "
        "start at gap 0 without force; it need not take the side of the paper",
        _of_mujoco,
    ),
    DRAKE: (
        drake_version,
        "other models: a spring with a damper in contact, regularised friction, a start at gap 0 without force; sap "
        "and similar are convex, so their friction also pushes a contact apart when it slips; lagged takes the normal "
        "force of the step before; they need not take the side of the paper",
        _of_drake,
    ),
}
