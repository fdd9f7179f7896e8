"""Float runs: scipy in variables scaled by epsilon, with the exact Jacobian, phase after phase. Nothing is proved."""

from __future__ import annotations

import itertools
import math
import warnings
from collections.abc import Callable, Iterator, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from flint import fmpq

from gspot_verified.numbers.balls import approximate
from gspot_verified.numbers.verdict import Reason, Verdict
from gspot_verified.scenes.effects.stick import SLIPS, STICKS
from gspot_verified.scenes.effects.tangential_motion import SLIP_STOPS
from gspot_verified.scenes.equations.scaled_system import CONTACT
from gspot_verified.scenes.equations.terms import FLIGHT, REVERSE, SLIP, STICK
from gspot_verified.scenes.floats.float_function import float_function
from gspot_verified.scenes.scene.assumption import ASSUMED, Assumption, provided
from gspot_verified.scenes.scene.run import IMPACT, SIMULATED, RunEvent, SceneRun, fate_of
from gspot_verified.scenes.scene.run_journal import RunJournal, question
from gspot_verified.scenes.scene.samples import Samples
from gspot_verified.scenes.scene.scene import Scene, SceneError

if TYPE_CHECKING:
    from numpy import ndarray


_ABSOLUTE = 1e-3  # tolerance, as a share of the relative one
MAX_PULLING = 50_000
"""Evaluations of the equations in one piece of a run with lambda_N < 0, where lift_off is left out: SceneError beyond
it. A mechanism that the surface pulls may turn ever faster, and the run take ever longer."""


class _Pulling(Exception):
    """These evaluations are used up; the argument is the clock there."""


class FloatPhase:
    """``ends``: the name of each event that ends the phase, and the phase that follows; None: the run ends."""

    def __init__(self, scene: Scene, phase: str, large_force: float | None) -> None:
        system = scene.system(phase)
        self.phase, self.states = phase, system.states
        self._rates = float_function(system.right_hand_side)
        self._slopes = float_function([entry for row in system.jacobian() for entry in row])
        self._shown = float_function([function for _, function in system.read_out])
        self.names = tuple(name for name, _ in system.read_out)
        self._epsilon = approximate(scene.epsilon)
        self._may_pull = phase != FLIGHT and "lift_off" not in scene.effects
        self.guards = [
            (event.next_phase, float_function([event.function]))
            for event in system.events
            if event.next_phase not in (FLIGHT, CONTACT)
        ]
        self.ends: list[tuple[str, str | None]] = [(event.name, event.next_phase) for event in system.events]
        self._events = [_terminal(float_function([event.function])) for event in system.events]
        if large_force is not None and phase != FLIGHT:
            seen = float_function([system.shown("lambda_N"), system.shown("p")])

            def below(x: Sequence[float]) -> list[float]:
                force, p = seen(x)
                return [large_force - force if p < 0 else large_force]

            self.ends.append((IMPACT, None))
            self._events.append(_terminal(below))

    def integrate(self, state: Sequence[float], span: tuple[float, float], method: str, tolerance: float) -> Any:
        """What ``solve_ivp`` gives, with its dense output.

        :raises SceneError: the solver fails, its values are not finite, or the surface pulls for too long.
        """
        import numpy as np
        from scipy.integrate import solve_ivp

        size, left = len(self.states), itertools.count(MAX_PULLING, -1)
        surface, body = (self.states.index(name) for name in "ZY")

        def rates(t: float, y: ndarray[Any, Any]) -> list[float]:
            if self._may_pull and y[surface] < y[body] and next(left) <= 0:
                raise _Pulling(t)
            return self._rates([*map(float, y), t])

        try:
            with np.errstate(all="ignore"), warnings.catch_warnings():
                warnings.simplefilter("ignore")  # whether it went well is asked below
                solution = solve_ivp(
                    rates,
                    span,
                    np.array(state),
                    method=method,
                    jac=lambda t, y: np.array(self._slopes([*map(float, y), t])).reshape(size, size),
                    events=self._events,
                    rtol=tolerance,
                    atol=tolerance * _ABSOLUTE,
                    dense_output=True,
                )
        except _Pulling as end:
            raise SceneError(
                f"the float run ended in {self.phase} at t = {end.args[0] * self._epsilon:.6g}: the surface has pulled "
                f"in {MAX_PULLING} evaluations of the equations; without lift_off λ_N is supposed to be positive in "
                "contact, and where it is not this is no motion of the mechanism: add the effect, or end before"
            ) from None
        except (ArithmeticError, ValueError) as error:
            raise SceneError(f"the float run failed in {self.phase}: {error}") from None
        if not solution.success:
            raise SceneError(f"the float run failed in {self.phase}: {solution.message}")
        if not np.all(np.isfinite(solution.y)):
            raise SceneError(f"the float run failed in {self.phase}: a value is too large for a float")
        return solution

    def rows(self, times: Sequence[float], states: ndarray[Any, Any]) -> list[list[float]]:
        """t in the paper's units and the read-out, for each time; ``states`` has one column for each."""
        return [
            [float(t) * self._epsilon, *self._shown([*map(float, y), float(t)])]
            for t, y in zip(times, states.T, strict=True)
        ]

    def shown(self, state: Sequence[float], time: float) -> dict[str, float]:
        """The read-out at one state."""
        return dict(zip(self.names, self._shown([*state, time]), strict=True))


def _terminal(function: Callable[[Sequence[float]], list[float]]) -> Any:
    """An event of ``solve_ivp`` that ends the phase where the function falls through 0."""

    def event(t: float, y: ndarray[Any, Any]) -> float:
        return function([*map(float, y), t])[0]

    event.terminal, event.direction = True, -1.0  # type: ignore[attr-defined]
    return event


METHODS = ("Radau", "LSODA", "BDF")
MAX_PHASES = 200  # of one run, against endless work
MAX_POINTS = 1_000_000  # a limit of input: ValueError beyond it
LEAST_EPSILON = fmpq(1, 10**12)  # below it doubles resolve the fast time no longer: SceneError
PIECES = 64
"""With a journal the span of the run is cut into so many equal pieces, and solvers start anew at each. Without one it
is not cut: at a tight tolerance new starts, of low order and short steps, cost many times the run."""


@dataclass(frozen=True)
class SolverPiece:
    """What one call of the solver leaves behind. ``next_phase``: of the following piece; None: the run ends here."""

    phase: str
    rows: list[list[float]]
    time: float
    state: dict[str, float]
    event: str | None
    next_phase: str | None


def float_run(
    scene: Scene,
    method: str = "Radau",
    tolerance: float = 1e-10,
    points: int | None = None,
    journal: str | Path | None = None,
) -> SceneRun:
    """The scene integrated with floats until ``scene.until``, or until p < 0 and the force is ``scene.stop_at_force``
    times that of rigid slip at the start, -b/p, which is then called an impact without collision: a threshold, not a
    statement.

    :param tolerance: relative; the absolute one is a thousandth of it, in scaled variables.
    :param points: the samples are taken at so many equal steps of time, by the solver's interpolation, and at the
        events; None: at the solver's own steps.
    :param journal: a file that keeps what is done; a run that was interrupted goes on from there, to the result of a
        run with a journal that was not interrupted. A run without a journal takes other steps, is faster, and differs
        within the error of floats, which near a canard may be the other side. Where the journal cannot be written (a
        full disk) the run goes on without it, and ``notes`` says so.
    :raises SceneError: an unknown method, a tolerance outside 1e-13..1e-2, epsilon < 1e-12, or the solver fails.
    :raises ValueError: the journal is that of another run.
    :raises OSError: the journal cannot be opened.
    """
    import numpy as np

    _check(scene, method, tolerance, points)
    asked = {"method": method, "tolerance": tolerance, "points": points}
    kept = None if journal is None else RunJournal(journal, question(scene, asked))
    pieces = [] if kept is None else [_kept_piece(data, kept.path, scene) for data in kept.pieces]
    cuts = 1 if kept is None else PIECES
    for piece in _pieces(scene, method, tolerance, points, pieces[-1] if pieces else None, cuts):
        pieces.append(piece)
        if kept is not None:
            kept.add(asdict(piece))
    names = ("t", *(name for name, _ in scene.system(scene.first_phase()).read_out))
    columns = np.array([row for piece in pieces for row in piece.rows]).T
    phases = tuple(piece.phase for piece in pieces for _ in piece.rows)
    samples = Samples(dict(zip(names, columns, strict=True)), phases)
    small = approximate(scene.epsilon)
    events = tuple(
        RunEvent(piece.event, *(2 * [fmpq(*(piece.time * small).as_integer_ratio())]))
        for piece in pieces
        if piece.event is not None
    )
    fate = fate_of([event.name for event in events])
    detail = f"simulated with floats ({method}, relative tolerance {tolerance:g}): no error is bounded"
    assumptions = unchecked(scene)
    verdict = Verdict.undecided(f"{fate}{provided(assumptions)}", Reason.FLOATS, detail)
    notes = () if kept is None else tuple(kept.notes)
    return SceneRun(SIMULATED, fate, events, verdict, samples, notes, assumptions)


def unchecked(scene: Scene) -> tuple[Assumption, ...]:
    """What the effects that are left out assume of the motion, all of it only assumed."""
    start, why = fmpq(0), "a run with floats checks nothing"
    return tuple(
        Assumption(effect.name, effect.condition.text, ASSUMED, start, start, why)
        for effect in scene.conditional()
        if effect.condition is not None
    )


def _kept_piece(data: Any, path: Path, scene: Scene) -> SolverPiece:
    try:
        piece = SolverPiece(**data)
        numbers = [piece.time, *piece.state.values(), *(x for row in piece.rows for x in row)]
        if not all(math.isfinite(x) for x in numbers):
            raise ValueError("not a finite number")
        if not all(isinstance(word, str) or word is None for word in (piece.event, piece.next_phase)):
            raise ValueError("not a name")
        _check_names(scene, piece)
    except (TypeError, ValueError, AttributeError) as error:
        raise ValueError(f"{path}: a line of the journal cannot be read: {error}") from None
    return piece


def _check_names(scene: Scene, piece: SolverPiece) -> None:
    phases = scene.phases()
    if piece.phase not in phases or piece.next_phase not in (*phases, None):
        raise ValueError("a phase that the scene has not")
    if not set(scene.scaled_initial()) <= set(piece.state):
        raise ValueError("a state without a component of the scene")
    if {len(row) for row in piece.rows} - {1 + len(scene.system(piece.phase).read_out)}:
        raise ValueError("a row of another length")


def _check(scene: Scene, method: str, tolerance: float, points: int | None) -> None:
    if method not in METHODS:
        raise SceneError(f"method: expected one of {', '.join(METHODS)}, got {method!r}")
    if not 1e-13 <= tolerance <= 1e-2:
        raise SceneError(f"tolerance: expected 1e-13..1e-2, got {tolerance}")
    if points is not None and not 2 <= points <= MAX_POINTS:
        raise SceneError(f"points: expected 2..{MAX_POINTS}, got {points}")
    if scene.epsilon < LEAST_EPSILON:
        raise SceneError(f"float runs need epsilon >= 1e-12, got {scene.epsilon}")


def _pieces(
    scene: Scene, method: str, tolerance: float, points: int | None, last: SolverPiece | None, cuts: int
) -> Iterator[SolverPiece]:
    """The pieces that follow ``last``, of a span cut into ``cuts``; events cut it further."""
    run = _FloatRun(scene)
    end = approximate(scene.until / scene.epsilon)
    if not math.isfinite(end):
        raise SceneError("until/epsilon is too large for a float")
    if last is None:
        phase: str | None = scene.first_phase()
        if phase == STICK:
            phase = run.contact_phase(run.start, 0.0, at_rest=True)
        state, time = run.start, 0.0
    else:
        phase, state, time = last.next_phase, last.state, last.time
    for _ in range(MAX_PHASES + cuts):
        if phase is None or time >= end:
            return
        stop = min(end, end * (math.floor(time / end * cuts * (1 + 1e-12)) + 1) / cuts)
        begins = last is None or last.event is not None
        equal = None if points is None else (end, points)
        piece = run.piece(phase, state, (time, stop), method, tolerance, equal, begins)
        last = piece
        yield piece
        phase, state, time = piece.next_phase, piece.state, piece.time


class _FloatRun:
    """The compiled phases of one scene."""

    def __init__(self, scene: Scene) -> None:
        self._scene, self._compiled = scene, dict[str, FloatPhase]()
        self._belt = approximate(scene.values().get("belt_velocity", fmpq(0)))
        self.start = {name: approximate(value) for name, value in scene.scaled_initial().items()}
        for name, value in self.start.items():
            if not math.isfinite(value):
                raise SceneError(f"start: {name} is too large for a float")
        self._large: float | None = None
        if scene.stop_at_force is not None:
            first = self._phase(scene.first_phase())
            at = first.shown([self.start[name] for name in first.states], 0.0)
            self._large = approximate(scene.stop_at_force) * -at["b"] / at["p"]
            self._compiled.clear()

    def _phase(self, phase: str) -> FloatPhase:
        if phase not in self._compiled:
            self._compiled[phase] = FloatPhase(self._scene, phase, self._large)
        return self._compiled[phase]

    def contact_phase(self, state: dict[str, float], time: float, at_rest: bool) -> str:
        """Slip as the slip velocity says; without one stick, or slip to where friction does not hold the contact."""
        if STICK not in self._scene.phases():
            return SLIP
        if not at_rest:
            seen = self._phase(SLIP)
            slip = seen.shown([state[name] for name in seen.states], time)["u"] - self._belt
            if slip != 0:
                return SLIP if slip > 0 else REVERSE
        held = self._phase(STICK)
        at = [*(state[name] for name in held.states), time]
        return next((phase for phase, guard in held.guards if guard(at)[0] < 0), STICK)

    def piece(
        self,
        phase: str,
        state: dict[str, float],
        span: tuple[float, float],
        method: str,
        tolerance: float,
        points: tuple[float, int] | None,
        begins: bool,
    ) -> SolverPiece:
        """One call of the solver, to the end of the span or to an event, and what follows it.

        ``begins``: whether the phase begins here; otherwise the piece before has this state already.
        """
        compiled = self._phase(phase)
        solution = compiled.integrate([state[name] for name in compiled.states], span, method, tolerance)
        time = float(solution.t[-1])
        after = {**state, **dict(zip(compiled.states, map(float, solution.y[:, -1]), strict=True))}
        hits = zip(compiled.ends, solution.t_events, strict=True)
        ended = next((end for end, times in hits if len(times)), None)
        rows = _rows(compiled, solution, points, begins, ended is not None)
        if ended is None:
            return SolverPiece(phase, rows, time, after, None, phase)
        name, following = ended
        if following == CONTACT:
            following = self.contact_phase(after, time, at_rest=name == SLIP_STOPS)
            if name == SLIP_STOPS:
                name = STICKS if following == STICK else SLIPS[following]
        if following == STICK and "u" in after:
            after["u"] = self._belt
        return SolverPiece(phase, rows, time, after, name, following)


def _rows(
    compiled: FloatPhase, solution: Any, points: tuple[float, int] | None, begins: bool, ends: bool
) -> list[list[float]]:
    import numpy as np

    if points is None:
        skipped = 0 if begins else 1
        return compiled.rows(solution.t[skipped:], solution.y[:, skipped:])
    end, count = points
    first, last = float(solution.t[0]), float(solution.t[-1])
    equal = (end * k / (count - 1) for k in range(count))
    times = {time for time in equal if first < time <= last}
    times |= ({first} if begins else set()) | ({last} if ends else set())
    at: Sequence[float] = sorted(times)
    return compiled.rows(at, np.column_stack([solution.sol(time) for time in at])) if at else []
