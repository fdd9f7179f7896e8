"""A state, what is certified to follow, and what simulators say."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import ClassVar

from flint import fmpq

from gspot_verified.leading_order.contact_force import rational
from gspot_verified.mechanisms.approach.approach import approach
from gspot_verified.mechanisms.approach.approach_result import IMPACT, LIFT_OFF, SLIP_STOPS, Approach
from gspot_verified.mechanisms.approach.slip_state import StateInput
from gspot_verified.mechanisms.input.mechanism import Mechanism
from gspot_verified.numbers.balls import ExactInput, approximate, ball_text, exact
from gspot_verified.numbers.verdict import NoTruthValue
from gspot_verified.numbers.written import Written
from gspot_verified.scenes.scene.scene import SceneError
from gspot_verified.scenes.simulators.contact_floats import ContactFloats, contact_floats
from gspot_verified.scenes.simulators.drake_engine import SOLVERS, DrakeEngine, drake_version, spring
from gspot_verified.scenes.simulators.engine import STIFF, follow
from gspot_verified.scenes.simulators.moreau_jean import moreau_jean
from gspot_verified.scenes.simulators.mujoco_engine import MujocoEngine, mujoco_version
from gspot_verified.scenes.simulators.penalty import penalty
from gspot_verified.scenes.simulators.planar_body import planar_model
from gspot_verified.scenes.simulators.planar_model import PlanarModel
from gspot_verified.scenes.simulators.simulated import (
    IMPULSE,
    LEAVES,
    STOPS,
    Happened,
    Simulated,
    read_motion,
    what_happens,
)

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


EPSILONS = ("1e-3", "1e-4")
STEPS = (1e-3, 1e-4)  # of the time until the event that is certified
_LATER = 3.0  # times the certified time: so long the simulators run
_LEAST_EPSILON = fmpq(1, 10**6)  # a limit of input
_LEAST_STEP = 1e-6  # likewise
_EARLY = 0.95  # of the certified time: an event before it is not the one that is certified
_LATE = 1.05  # the same for events of rigid slip, which come at their time, not after it
_LASTING = 0.03  # of the certified time: so long a contact is lost; rows further apart do not show what comes when
_SAME = 1e-3  # of the certified time, and of 1 + |value|: nearer to the certified start a table begins in it
_EXPECTED = {LIFT_OFF: (LEAVES,), IMPACT: (STOPS, IMPULSE), SLIP_STOPS: (STOPS,)}
RIGHT, EARLY, LATE, WRONG, SILENT, SHORT = "agrees", "too early", "too late", "differs", "no event", "ends early"
OPEN, FAILED = "not comparable", "failed"


@dataclass(frozen=True)
class SimulatorRun(NoTruthValue, Written):
    """What happens first in one run, at which time and slip velocity, and how that agrees with what is certified.

    ``agrees``: "agrees", "differs", "too early" (before the certified event, where rigid slip is certified to keep the
    contact), "too late" (that of rigid slip, after its time), "no event", "ends early" (nothing, and it ends before
    three times the certified time, or in what may be a flight), "not comparable" (no side is known, or the rows about
    it lie too far apart), "failed" (``happened`` says why).
    """

    ask: ClassVar[str] = ".agrees is a text"

    simulator: str
    settings: str
    happened: str
    time: float | None
    slip: float | None
    agrees: str


@dataclass(frozen=True)
class SimulatorComparison(NoTruthValue, Written):
    """The certified answer, and what each simulator says. The runs are floats: they prove nothing of the mechanism.

    ``notes``: which programs were not run, and why; how the model of one that was differs from the paper's.
    """

    ask: ClassVar[str] = ".certified.verdict.outcome is what was proved"
    written: ClassVar[str] = "certified runs notes"

    certified: Approach
    runs: tuple[SimulatorRun, ...]
    notes: tuple[str, ...] = ()

    @property
    def exit_code(self) -> int:
        """That of the certified answer: simulators may err."""
        return self.certified.exit_code

    def __str__(self) -> str:
        certified = self.certified
        head = f"{certified.name}: {certified.verdict}"
        if certified.surface_velocity not in (None, "0"):
            head += f"\n  on a surface with the velocity u = {certified.surface_velocity}"
        if certified.time is not None:
            head += f"\n  after the time t = {ball_text(certified.time, 6)}"
        if certified.end == "G-spot":
            said = f"{certified.side or 'undecided'} ({certified.side_reason})"
            head += f"; then, by the paper's statement as ε → 0: {said}"
        rows = [("simulator", "settings", "what comes first", "t", "slip", "")]
        rows += [(r.simulator, r.settings, r.happened, _short(r.time), _short(r.slip), r.agrees) for r in self.runs]
        widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
        table = ["  " + "  ".join(word.ljust(w) for word, w in zip(row, widths, strict=True)).rstrip() for row in rows]
        remarks = (*certified.warnings, *certified.notes, *self.notes)
        return "\n".join([head, *table, *(f"  {remark}" for remark in remarks)])


def _short(value: float | None) -> str:
    return "" if value is None else f"{value:.4g}"


def simulators(
    mechanism: Mechanism,
    state: StateInput,
    *,
    files: Sequence[str | Path] = (),
    surface_velocity: ExactInput | None = None,
    spot: int | None = None,
    epsilons: Sequence[ExactInput] = EPSILONS,
    steps: Sequence[ExactInput | float] = STEPS,
    programs: Sequence[str] = PROGRAMS,
) -> SimulatorComparison:
    """What is certified to follow a state in slip (:func:`approach`), beside simulators and tables that you bring.

    Run are the paper's compliant contact by scipy for each of ``epsilons``, and Moreau's and Jean's steps for each
    of ``steps`` (times the certified time), with both choices where a step has several solutions. Of ``programs`` those
    that are installed are run with the same steps, where the mechanism is one rigid body or came from a file of bodies
    (from_urdf, from_mjcf): they are told its bodies and its own free accelerations, and add their contact. ``files``
    are CSV tables of other simulators: a column t, one for each component of the state, and force where it is known.
    All start in the state that is certified.

    At a G-spot the side is the paper's statement as epsilon -> 0, certified at no epsilon; a simulator with a contact
    of another kind need not obey it. No rigid contact leaves the surface before, for there rigid slip is certified to
    last.

    :raises StateError: the state is not one from which slip can be followed.
    :raises MechanismError: a mechanism without velocities or with parameters that have no value.
    :raises ValueError: an epsilon or a step that is no number in 1e-6..1, or no name of a program.
    :raises SceneError: a table that cannot be read, or that begins at another time or in another state; nothing is
        certified of the state, or u < 0 and no velocity of the surface is given.

    >>> from gspot_verified import load
    >>> start = {"X": 0, "X_dot": 5, "theta": "4/5", "theta_dot": "33/10"}
    >>> found = simulators(load("rod with a wrist"), start, epsilons=["1e-3"], steps=[])
    >>> found.certified.side, found.runs[0].happened, found.runs[0].agrees
    ('lift-off', 'leaves the surface', 'agrees')
    """
    functions = contact_floats(mechanism)
    tables = [(str(file), read_motion(file, functions)) for file in files]
    small, lengths = [_epsilon(value) for value in epsilons], [_step(step) for step in steps]
    certified = approach(mechanism, state, surface_velocity=surface_velocity, spot=spot)
    judge = _Judge(mechanism, functions, certified, surface_velocity)
    for name, table in tables:
        judge.check_start(name, table)
    runs = [judge.run(*case) for case in judge.simulations(small, lengths)]
    others = installed(programs) if lengths else Installed((), ())
    model, why = judge.model() if others != Installed((), ()) else (None, "")
    notes = [*others.missing, *(f"{each.name}: {each.differs}" for each in others.found)]
    if model is None:  # to install a program would not help
        notes = [f"{name}: not run: {why}" for name in programs] if why else []
    else:
        runs += [judge.run(*case) for each in others.found for case in judge.steps_of(each, model, lengths)]
    runs += [judge.judged(name, "", table) for name, table in tables]
    return SimulatorComparison(certified, tuple(runs), tuple(notes))


def _epsilon(value: ExactInput) -> float:
    """Below the least one doubles do not resolve a depth of epsilon^2."""
    number = rational(value, "epsilon")
    if not _LEAST_EPSILON <= number <= 1:
        raise ValueError(f"epsilon of a simulator in floats: expected a number in 1e-6..1, got {number}")
    return approximate(number)


def _step(value: ExactInput | float) -> float:
    """A part of the certified time: of 0 a simulation would have no end."""
    number = value if isinstance(value, float) else approximate(rational(value, "step"))
    if not _LEAST_STEP <= number <= 1:
        raise ValueError(
            f"step of a simulator, a part of the certified time: expected a number in 1e-6..1, got {value}"
        )
    return number


class _Judge:
    """The start as floats, and what agrees with the certified answer."""

    def __init__(
        self, mechanism: Mechanism, functions: ContactFloats, certified: Approach, velocity: ExactInput | None
    ) -> None:
        if certified.time is None:
            raise SceneError(f"{certified.name}: nothing is certified of this state, so there is nothing to compare")
        if certified.surface_velocity is None:
            raise SceneError(f"{certified.name}: u is not positive: a simulator needs the surface's velocity")
        self.mechanism, self.functions, self.certified = mechanism, functions, certified
        self.velocity = 0.0 if velocity is None else approximate(exact(velocity, "surface_velocity"))
        self.time = approximate(certified.time)
        shifted = [approximate(value) for value in certified.path.states[0]]
        self.start = [value + angle for value, angle in zip(shifted, functions.references, strict=True)]

    def simulations(
        self, epsilons: Sequence[float], steps: Sequence[float]
    ) -> Iterator[tuple[str, str, Callable[[], Simulated]]]:
        """Name, settings, and the run that is still to be made."""
        functions, start, until = self.functions, self.start, _LATER * self.time
        for epsilon in epsilons:
            yield "compliant contact, LSODA", f"ε = {epsilon:g}", partial(
                penalty, self.mechanism, functions, start,
                epsilon=epsilon, until=until, surface_velocity=self.velocity,
            )  # fmt: skip
        for step in steps:
            for stays in (True, False):
                yield "Moreau-Jean", f"h = {step * self.time:.1e}, {'stays' if stays else 'leaves'}", partial(
                    moreau_jean, functions, start,
                    step=step * self.time, until=until, surface_velocity=self.velocity, stays=stays,
                )  # fmt: skip

    def check_start(self, name: str, table: Simulated) -> None:
        """Passes for a table that begins where the certified path does.

        :raises SceneError: it begins at another time, or in another state.
        """
        if abs(table.times[0]) > _SAME * self.time:
            began = f"{table.times[0]:g}"
            raise SceneError(f"{name}: the table begins at t = {began}, and the certified state is that at t = 0")
        for word, value, wanted in zip(self.functions.names, table.states[0], self.start, strict=True):
            if abs(value - wanted) > _SAME * (1 + abs(wanted)):
                raise SceneError(
                    f"{name}: the table begins with {word} = {value:.6g}, and the certified state has {wanted:.6g}"
                )

    def model(self) -> tuple[PlanarModel | None, str]:
        """The mechanism as other programs know it, or why it cannot be told to them."""
        if self.velocity:
            return None, "the surface moves"
        try:
            return planar_model(self.mechanism.bodies, self.functions, self.start), ""
        except SceneError as error:
            return None, str(error)

    def steps_of(
        self, program: Program, model: PlanarModel, steps: Sequence[float]
    ) -> Iterator[tuple[str, str, Callable[[], Simulated]]]:
        """As :meth:`simulations`, of another program."""
        for step in steps:
            for settings, motion in program.runs(model, step * self.time, _LATER * self.time):
                yield f"{program.name} {program.version}", settings, motion

    def run(self, simulator: str, settings: str, motion: Callable[[], Simulated]) -> SimulatorRun:
        """One simulation; what it says when it gives up."""
        try:
            return self.judged(simulator, settings, motion())
        except (SceneError, OverflowError, ZeroDivisionError) as error:
            return SimulatorRun(simulator, settings, str(error), None, None, FAILED)

    def judged(self, simulator: str, settings: str, motion: Simulated) -> SimulatorRun:
        """What happens in a motion, beside what is certified."""
        found = what_happens(motion, self.functions, self.velocity, lasting=_LASTING * self.time)
        return SimulatorRun(simulator, settings, found.what, found.time, found.slip, self._agrees(found))

    def _agrees(self, found: Happened) -> str:
        if found.time is None:
            return SILENT if found.since >= (_LATER - _LASTING) * self.time else SHORT
        if found.time < _EARLY * self.time:
            return EARLY
        expected = _EXPECTED.get(self.certified.side or self.certified.end or "")
        if expected is None or found.time - found.since > _LASTING * self.time:
            return OPEN
        if found.what not in expected:
            return WRONG
        return LATE if self.certified.end != "G-spot" and found.time > _LATE * self.time else RIGHT
