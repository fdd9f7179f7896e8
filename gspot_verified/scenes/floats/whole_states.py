"""All components of a mechanism along a run, with floats, those included on which no equation of the scene depends.

A component that is integrated is as it was sampled; two follow from y and v; the others have the rates
dxi/dt = F + G_T lambda_T + G_N lambda_N (paper, eq. genTN) and follow by Heun's method from sample to sample. Nothing
is proved: a picture of the mechanism needs them.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from flint import fmpq

from gspot_verified.functions.expressions import Variable
from gspot_verified.functions.rings import BALLS
from gspot_verified.mechanisms.derive.to_system import shift
from gspot_verified.mechanisms.formulas.symbol import SLIP_SPEED
from gspot_verified.mechanisms.input.mechanism import Lagrangian, Mechanism
from gspot_verified.numbers.balls import approximate, working_bits
from gspot_verified.scenes.equations.terms import FLIGHT, REVERSE, STICK
from gspot_verified.scenes.floats.float_function import float_function
from gspot_verified.scenes.motions.mechanism_motion import MechanismMotion, NormalCoordinate
from gspot_verified.scenes.scene.samples import Samples
from gspot_verified.scenes.scene.scene import Scene, SceneError

_BITS = 80  # beyond a double

Row = Mapping[str, float]


def whole_states(scene: Scene, samples: Samples) -> list[list[float]]:
    """The whole state in each row of the samples, angles from their references.

    :raises SceneError: the scene has no mechanism.
    """
    motion = scene.motion
    if scene.mechanism is None or not isinstance(motion, MechanismMotion):
        raise SceneError(f"{scene.name}: the scene has no mechanism, the model system has no bodies")
    columns = {name: column.tolist() for name, column in samples.columns.items()}
    rows = [dict(zip(columns, row, strict=True)) for row in zip(*columns.values(), strict=True)]
    rest = _Rest(scene.mechanism, motion.kept, approximate(scene.values().get("belt_velocity", fmpq(0))))
    with working_bits(_BITS):
        state = [approximate(value) for value in motion.whole_state(scene.values())]
    states = [rest.completed(state, rows[0])]
    for before, row, first, second in zip(rows, rows[1:], samples.phases, samples.phases[1:], strict=False):
        step, rates = row["t"] - before["t"], rest.rates(states[-1], before["lambda_N"], first)
        ahead = rest.completed(rest.stepped(states[-1], rates, step), row)
        ends = rest.rates(ahead, row["lambda_N"], second)
        mean = [(begin + end) / 2 for begin, end in zip(rates, ends, strict=True)]
        states.append(rest.completed(rest.stepped(states[-1], mean, step), row))
    return states


class _Rest:
    """The components that a run does not integrate."""

    def __init__(self, mechanism: Mechanism, kept: Sequence[str], belt: float) -> None:
        shifted, size = shift(mechanism, slip_speed=True), len(mechanism.state)
        self._belt = belt
        f = shifted.functions
        constrained = isinstance(mechanism.motion, Lagrangian) and mechanism.motion.constraints
        normal = None if constrained else NormalCoordinate.of(f.y, f.v, size)
        self._normal = () if normal is None else (normal.place, normal.velocity)
        references = {angle.coordinate: f"{angle.coordinate} - {angle.name}" for angle in mechanism.angles}
        self._kept = {mechanism.state.index(name): (name, references.get(name, name)) for name in kept}
        self._others = [i for i in range(size) if i not in self._kept and i not in self._normal]
        solved = {} if normal is None else normal.solved(Variable(size), Variable(size + 1))
        rates = [field[i] for i in self._others for field in (f.F, f.G_T, f.G_N)]
        with working_bits(_BITS):
            self._solved = float_function(shifted.expressions(list(solved.values()), BALLS))
            self._slip = float_function(shifted.expressions([f.u], BALLS))
            functions = [f.mu, f.a, f.A, f.B, *rates]
            self._rates = float_function(shifted.expressions(functions, BALLS, {SLIP_SPEED: Variable(size)}))

    def completed(self, state: Sequence[float], row: Row) -> list[float]:
        """The state with what the row of the samples says."""
        made = list(state)
        for i, names in self._kept.items():
            made[i] = next(row[name] for name in names if name in row)
        for i, value in zip(self._normal, self._solved([*made, row["y"], row["v"]]), strict=True):
            made[i] = value
        return made

    def rates(self, state: Sequence[float], normal_force: float, phase: str) -> list[float]:
        """The rates of the others; the friction force is that of the phase, in stick that of du/dt = 0."""
        mu, a, A, B, *parts = self._rates([*state, abs(self._slip(state)[0] - self._belt)])
        friction = {FLIGHT: 0.0, STICK: -(a + B * normal_force) / A, REVERSE: mu * normal_force}
        force = friction.get(phase, -mu * normal_force)
        return [parts[k] + parts[k + 1] * force + parts[k + 2] * normal_force for k in range(0, len(parts), 3)]

    def stepped(self, state: Sequence[float], rates: Sequence[float], step: float) -> list[float]:
        """The others after one step at these rates."""
        made = list(state)
        for i, rate in zip(self._others, rates, strict=True):
            made[i] += step * rate
        return made
