"""A scene: a mechanism, the effects that matter, initial values, and how long to look."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

from flint import fmpq

from gspot_verified.balls import ExactInput
from gspot_verified.expansion.expressions import Expression
from gspot_verified.mechanisms.names import nearest
from gspot_verified.scenes.effects.catalogue import EFFECTS
from gspot_verified.scenes.effects.effect import Effect
from gspot_verified.scenes.effects.normal_acceleration import MECHANISM
from gspot_verified.scenes.effects.terms import FLIGHT, SLIP, STICK, Terms, number, scaled
from gspot_verified.scenes.scaled_system import ScaledSystem
from gspot_verified.signs.contact_force import rational

START_KEYS = ("p", "b", "nu", "y", "v", "z", "u")


class SceneError(ValueError):
    """The description of the scene is wrong; the message names the part."""


@dataclass(frozen=True)
class Scene:
    """``start``: p, b or nu (b = -nu p |alpha_2/(alpha_3 - alpha_1)|), y, v, z or none of them (at rest on the
    surface: y = 2 b epsilon^2/p, z = y/2, v = 0 with the paper's stiffness), u with tangential motion; paper's units.

    ``until``: the time, from the start, at which float runs end. ``stop_at_force``: a float run ends where p < 0 and
    lambda_N is this many times its first value; None: it does not.

    :raises SceneError: a part is wrong.
    """

    name: str
    effects: tuple[str, ...]
    epsilon: fmpq
    until: fmpq
    parameters: Mapping[str, fmpq]
    start: Mapping[str, fmpq]
    stop_at_force: fmpq | None = None

    def __post_init__(self) -> None:
        _check_effects(self.effects)
        for name in self.parameters:
            if name not in self.defaults():
                known = ", ".join(self.defaults())
                raise SceneError(f"unknown parameter {name!r}{nearest(name, self.defaults())}; here: {known}")
        _check_numbers(self)

    def parts(self) -> tuple[Effect, ...]:
        """The mechanism and the effects, in the order of their states."""
        return (MECHANISM, *(effect for name, effect in EFFECTS.items() if name in self.effects))

    def defaults(self) -> dict[str, fmpq]:
        """The parameters of this scene's effects and their default values."""
        return {name: value for part in self.parts() for name, value in part.parameters.items()}

    def values(self) -> dict[str, fmpq]:
        """The parameters with the values that they have."""
        return {**self.defaults(), **self.parameters}

    def phases(self) -> tuple[str, ...]:
        """The phases that the effects open."""
        return (SLIP, *(phase for part in self.parts() for phase in part.opens))

    def system(self, phase: str) -> ScaledSystem:
        """The equations of one phase; effects that are left out are not in them.

        :raises SceneError: this scene has no such phase.
        """
        if phase not in self.phases():
            raise SceneError(f"no phase {phase!r} in this scene; there are: {', '.join(self.phases())}")
        parts = self.parts()
        states = tuple(state for part in parts if phase in part.phases for state in part.states)
        terms = Terms(phase, states, self.epsilon, self.initial()["p"], self.values())
        rates = {name: rate for part in parts for name, rate in part.rates(terms).items()}
        events = tuple(event for part in parts for event in part.events(terms))
        return ScaledSystem(phase, states, tuple(rates[state] for state in states), events, self._read_out(terms))

    def _read_out(self, terms: Terms) -> tuple[tuple[str, Expression], ...]:
        epsilon = self.epsilon
        shown = [
            ("p", terms.p),
            ("b", terms.state("b")),
            ("y", scaled(epsilon**2, terms.state("Y"))),
            ("v", scaled(epsilon, terms.state("V"))),
            ("z", scaled(epsilon**2, terms.state("Z"))),
            ("lambda_N", terms.force),
        ]
        if "tangential_motion" in self.effects:
            shown.append(("u", number(fmpq(0)) if terms.phase == STICK else terms.state("u")))
        return tuple(shown)

    def initial(self) -> dict[str, fmpq]:
        """p, b, y, v, z (and u) at the start, exactly.

        :raises SceneError: a state is missing, or one too many is given.
        """
        found = dict(self.start)
        factor = found.pop("nu", None)
        for name in ("p", *(("u",) if "tangential_motion" in self.effects else ())):
            if name not in found:
                raise SceneError(f"start: the state {name} is missing")
        if ("b" in found) == (factor is not None):
            raise SceneError("start: give b or nu, one of them")
        values = self.values()
        if factor is not None:
            drift = (values["beta"] - 1) * values["alpha_1"]
            if drift == 0:
                raise SceneError("start: nu needs a trivial solution; at beta = 1 there is none: give b")
            found["b"] = -factor * found["p"] * abs(values["alpha_2"] / drift)
        at_rest = [name for name in "yvz" if name not in found]
        if len(at_rest) not in (0, 3):
            raise SceneError(f"start: the state {at_rest[0]} is missing; give y, v and z, or none of them")
        if at_rest:
            if found["p"] <= 0:
                raise SceneError(f"start: at rest on the surface p must be > 0, got {found['p']}; give y, v and z")
            depth = self.epsilon**2 * found["b"] / found["p"]
            k_1, k_2 = values["k_1"], values["k_2"]
            found |= {"y": depth * (1 / k_1 + 1 / k_2), "v": fmpq(0), "z": depth / k_1}
        return found

    def first_phase(self) -> str:
        """Flight where y >= z, else stick where u = 0 and the scene has it, else slip."""
        start = self.initial()
        if start["y"] >= start["z"] and FLIGHT in self.phases():
            return FLIGHT
        return self.contact_phase(start.get("u", fmpq(1)) == 0)

    def contact_phase(self, at_rest: bool) -> str:
        """The phase of contact: stick without slip velocity, where the scene has it, else slip."""
        return STICK if at_rest and STICK in self.phases() else SLIP

    def with_settings(self, **settings: ExactInput | None) -> Scene:
        """The scene with other numbers: parameters, values of the start, ``eps``, ``until``; None changes nothing.

        :raises SceneError: there is no such setting.
        """
        parameters, start, epsilon, until = dict(self.parameters), dict(self.start), self.epsilon, self.until
        for name, value in settings.items():
            if value is None:
                continue
            found = rational(value, name)
            if name in ("eps", "epsilon"):
                epsilon = found
            elif name == "until":
                until = found
            elif name in START_KEYS:
                if name in ("b", "nu"):
                    start.pop("nu" if name == "b" else "b", None)
                start[name] = found
            elif name in self.defaults():
                parameters[name] = found
            else:
                known = ("eps", "until", *START_KEYS, *self.defaults())
                raise SceneError(f"no setting {name[:40]!r}{nearest(name, known)}; there are: {', '.join(known)}")
        return replace(self, parameters=parameters, start=start, epsilon=epsilon, until=until)


def _check_effects(names: tuple[str, ...]) -> None:
    for name in names:
        if name not in EFFECTS:
            raise SceneError(f"unknown effect {name[:40]!r}{nearest(name, EFFECTS)}; there are: {', '.join(EFFECTS)}")
        if names.count(name) > 1:
            raise SceneError(f"effect {name!r} is named twice")
        effect = EFFECTS[name]
        for other in effect.needs:
            if other not in names:
                raise SceneError(f"effect {name!r} needs {other!r}")
    if "compliant_contact" not in names:
        raise SceneError("effect 'compliant_contact' is missing: without it nothing is integrated after the G-spot")


def _check_numbers(scene: Scene) -> None:
    values = scene.values()
    for name, value in (("epsilon", scene.epsilon), ("until", scene.until)):
        if value <= 0:
            raise SceneError(f"{name} must be > 0, got {value}")
    for name in ("k_1", "k_2", "damping"):
        if values[name] <= 0:
            raise SceneError(f"parameter {name} must be > 0, got {values[name]}")
    if scene.stop_at_force is not None and scene.stop_at_force <= 1:
        raise SceneError(f"stop_at_force must be > 1, got {scene.stop_at_force}")
    if "stick" in scene.effects and not (values["a"] == 0 and values["k_plus"] < 0 < values["k_minus"]):
        raise SceneError("effect 'stick': only a = 0 and k_plus < 0 < k_minus are covered")
    start = scene.initial()
    for name in start:
        if name not in START_KEYS or (name == "u" and "tangential_motion" not in scene.effects):
            raise SceneError(f"start: this scene has no state {name!r}")
    if start.get("u", 0) < 0:
        raise SceneError(f"start: u must be >= 0 (positive slip), got {start['u']}")
    if start["y"] >= start["z"] and FLIGHT not in scene.phases():
        raise SceneError(f"start: not in contact: y = {start['y']} >= z = {start['z']}, and lift_off is left out")
    if start["y"] >= start["z"] and scene.stop_at_force is not None:
        raise SceneError("stop_at_force: the start is not in contact, so there is no first force to measure by")
    if start["z"] > 0:
        raise SceneError(f"start: z must be <= 0 (the surface is not pulled out), got {start['z']}")
