"""A scene: what moves, the effects that matter, initial values, and how long to look."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, fields, replace
from functools import cached_property

from flint import arb, fmpq

from gspot_verified.functions.derivative import powers_as_products
from gspot_verified.functions.expressions import Expression
from gspot_verified.mechanisms.derive.impossible import refuse_impossible
from gspot_verified.mechanisms.formulas.names import nearest
from gspot_verified.mechanisms.input.mechanism import Mechanism, name_with
from gspot_verified.numbers.balls import ExactInput
from gspot_verified.numbers.written import Shown
from gspot_verified.scenes.effects.catalogue import EFFECTS, OUTSIDE
from gspot_verified.scenes.effects.effect import Effect
from gspot_verified.scenes.equations.motion import Motion
from gspot_verified.scenes.equations.motion import SceneError as SceneError
from gspot_verified.scenes.equations.scaled_system import ScaledSystem
from gspot_verified.scenes.equations.terms import PHASES, SLIP, Terms, scaled
from gspot_verified.scenes.motions.compact import compact
from gspot_verified.scenes.motions.mechanism_motion import MechanismMotion
from gspot_verified.scenes.motions.model_motion import ModelMotion
from gspot_verified.scenes.motions.slow_point import SlowPoint, slow_point
from gspot_verified.scenes.scene.numbers import scene_number
from gspot_verified.scenes.scene.start import check_rigid_force, check_start, first_phase

_ROUNDS = 12  # of a point and the components that follow from it: each gains a factor of epsilon^2 or so
OF_EVERY_SCENE = ("eps", "epsilon", "until", "start", "y", "v", "z")
"""Settings of every scene; ``eps`` is ``epsilon``."""
SLIP_START = "slip"
"""A start on the slow manifold of slip."""
START_KEYS = ("p", "b", "nu", "y", "v", "z", "u", "x")
"""The keys of a start in the model scenes; beside a mechanism its components take the places of p, b, nu, u, x."""


@dataclass(frozen=True)
class Scene(Shown):
    """``mechanism``: what moves; None: the model system and, with its effects, the extended example.

    ``parameters``: those of the effects and of the model. ``start``, in the paper's units; the model: p, b or nu
    (b = -nu p |alpha_2/(alpha_3 - alpha_1)|), u and x with their effects; y, v, z or none of them (at rest on the
    surface: y = 2 b epsilon^2/p, z = y/2, v = 0 with the paper's stiffness). A mechanism: components of its state as
    numbers or formulas; y, v, z or none of them (just in contact: all 0); two components follow from y and v.

    ``until``: the time, from the start, at which runs end. ``stop_at_force``: a run ends where p < 0 and lambda_N is
    this many times that of rigid slip at the start, -b/p (a certified one where that is certain, after an impact
    without collision was shown); None: it does not. ``on_slow_manifold``: y, v, z at the start are those of
    :attr:`slow_start`.

    :raises SceneError: a part is wrong.
    :raises TypeError, ValueError: a number that is not exact: a float, a ball.
    :raises MechanismError: the mechanism is not complete, it has a mass or a friction coefficient below 0, or its mass
        matrix is not positive definite at the start.
    """

    name: str
    effects: tuple[str, ...]
    epsilon: fmpq
    until: fmpq
    parameters: Mapping[str, fmpq]
    start: Mapping[str, fmpq | str]
    stop_at_force: fmpq | None = None
    mechanism: Mechanism | None = None
    on_slow_manifold: bool = False

    def __post_init__(self) -> None:
        _check_names(self)
        self._read_numbers()
        _check_effects(self.effects, self.mechanism is not None)
        if self.mechanism is not None:
            refuse_impossible(self.mechanism)
        _check_positive(self.epsilon, "epsilon")
        for name in self.parameters:
            if name not in self.defaults():
                known = ", ".join(self.defaults())
                raise SceneError(f"unknown parameter {name[:40]!r}{nearest(name, self.defaults())}; here: {known}")
        _check_numbers(self)
        _check_surface(self)
        check_start(self.motion, self.values(), self.epsilon, self.effects, self.start)
        self.first_phase()
        if self.stop_at_force is not None:
            check_rigid_force(self.motion, self.values())

    def _read_numbers(self) -> None:
        """Plain rationals in the place of what is exactly one: a ball, a float, or a number that compares in its own
        way is none that a statement can name."""
        for name in ("epsilon", "until", "stop_at_force"):
            if getattr(self, name) is not None:
                object.__setattr__(self, name, scene_number(getattr(self, name), name))
        parameters = {name: scene_number(value, f"parameters: {name[:40]}") for name, value in self.parameters.items()}
        object.__setattr__(self, "parameters", parameters)

    def __getstate__(self) -> dict[str, object]:
        """What was given; the equations are made again where they are needed."""
        return {each.name: getattr(self, each.name) for each in fields(self)}

    @cached_property
    def motion(self) -> Motion:
        """The equations of what moves."""
        return self._motion_with(self.used())

    def _motion_with(self, effects: Sequence[Effect]) -> Motion:
        given, point, small = dict(self.start), self.slow_start, self.epsilon
        if point is not None:
            given |= point.unscaled(small)
        if self.mechanism is None:
            start = {name: scene_number(value, f"start: {name}") for name, value in given.items()}
            return ModelMotion(effects, small, start)
        sees = [name for each in effects for name in each.sees]
        return MechanismMotion(self.mechanism, sees, small, given)

    @cached_property
    def slow_start(self) -> SlowPoint | None:
        """The point next to the slow manifold of slip, over the other components of the start; an exact start, whose
        distance from the manifold is not bounded. None: y, v, z are given, or those of contact at rest.

        :raises SceneError: y, v or z is given, too; there is no positive slip at the start, or no slow manifold.
        """
        if not self.on_slow_manifold:
            return None
        for name in "yvz":
            if name in self.start:
                raise SceneError(
                    f"start: {name} is given, and the slow manifold of slip is asked for: give one of them"
                )
        point = self._slow_point(None)
        for _ in range(_ROUNDS if self.mechanism is not None and self._touching(None).enclosed_initial() else 0):
            before, point = point, self._slow_point(point)
            if (before.Y, before.V) == (point.Y, point.V):
                break
        return point

    def _touching(self, point: SlowPoint | None) -> Scene:
        """The scene from y = v = z = 0, or from this point."""
        small = self.epsilon
        at = dict.fromkeys("yvz", fmpq(0)) if point is None else point.unscaled(small)
        return replace(self, start={**self.start, **at}, stop_at_force=None, on_slow_manifold=False)

    def _slow_point(self, near: SlowPoint | None) -> SlowPoint:
        """The point over the components that follow from the others, and from y and v of ``near``."""
        touching = self._touching(near)
        if touching.first_phase() != SLIP:
            raise SceneError("start: no positive slip in contact there, so no slow manifold of it")
        return slow_point(touching.system(SLIP), touching.scaled_initial(), self.epsilon, touching.values())

    def used(self) -> tuple[Effect, ...]:
        """The effects, in the order of the catalogue."""
        return _in_order(self.effects)

    def left_out(self) -> tuple[Effect, ...]:
        """The effects that are left out; none of those that have no place in this scene."""
        others = [effect for name, effect in EFFECTS.items() if name not in self.effects]
        return tuple(effect for effect in others if self.mechanism is None or effect.not_with_mechanism is None)

    def assumes(self) -> dict[str, str]:
        """For each effect that is left out, what that means for this scene."""
        return {effect.name: effect.left_out_of(self.motion) or effect.left_out for effect in self.left_out()}

    def conditional(self) -> tuple[Effect, ...]:
        """The effects whose absence assumes something of the motion; where two belong together, the one that the other
        needs."""
        return tuple(
            effect
            for effect in self.left_out()
            if effect.condition is not None
            and (effect.condition.of_model or self.mechanism is not None)
            and all(name in self.effects for name in effect.needs)
        )

    def not_followed(self, effect: Effect) -> str | None:
        """Why the condition of an effect that is left out cannot be followed along a run; None: it can."""
        if effect.sees and self.has_unknown_surface_velocity:
            return "the velocity of the surface is not given"
        try:
            self.scaled_initial((effect,))
        except SceneError as error:
            return str(error)
        return None

    def defaults(self) -> dict[str, fmpq]:
        """The parameters of this scene's effects, and of the model, with their default values."""
        return _defaults(self.used(), self.motion)

    def values(self) -> dict[str, fmpq]:
        """The parameters with the values that they have; the velocity of the surface is in it where it is known."""
        values = {**self.defaults(), **self.parameters}
        if self.has_unknown_surface_velocity:
            del values["belt_velocity"]
        return values

    @property
    def has_unknown_surface_velocity(self) -> bool:
        """Whether the surface moves, at a velocity that is not given: below that of the contact point, as is said."""
        return {"belt"} == {"belt", "tangential_motion"} & {*self.effects} and "belt_velocity" not in self.parameters

    def phases(self) -> tuple[str, ...]:
        """The phases that the effects open."""
        opened = {SLIP, *(phase for effect in self.used() for phase in effect.opens)}
        return tuple(phase for phase in PHASES if phase in opened)

    def system(self, phase: str, watched: Sequence[Effect] = ()) -> ScaledSystem:
        """The equations of one phase; effects that are left out are not in them.

        ``watched``: effects that are left out, whose conditions are to be followed: with what these need to be known,
        and with the events at which they end to hold.

        :raises SceneError: this scene has no such phase, or its start does not give what a condition needs.
        """
        if phase not in self.phases():
            raise SceneError(f"no phase {phase!r} in this scene; there are: {', '.join(self.phases())}")
        used = self.used()
        own = [effect.states for effect in used if effect.states is not None and phase in effect.states.phases]
        motion = self._motion_watching(tuple(watched))
        moving = motion.states(phase)
        first = moving if self.mechanism is not None else moving[:1]
        states = (*first, *(name for part in own for name in part.names), *moving[len(first) :])
        terms = motion.terms(phase, states, self.values())
        rates = motion.rates(terms) | {name: rate for part in own for name, rate in part.rates(terms).items()}
        ends = [
            replace(event, left_out=effect.name)
            for effect in watched
            if effect.condition is not None
            for event in effect.condition.events(terms)
        ]
        events = (*(event for effect in used for event in effect.events(terms)), *ends)
        shown = self._read_out(terms, motion)
        # The rates alone: what is shown and watched must not change them.
        shorter = compact([rates[state] for state in states])
        supposed = terms.supposed
        needed = [*(event.function for event in events), *(function for _, function in supposed)]
        roots = [*shorter.values(), *needed, *shown.values()]
        made = powers_as_products(roots)
        return ScaledSystem(
            phase,
            states,
            tuple(made[shorter[rates[state]]] for state in states),
            tuple(replace(event, function=made[event.function]) for event in events),
            tuple((name, made[function]) for name, function in shown.items()),
            tuple((name, made[function]) for name, function in supposed),
        )

    def _motion_watching(self, watched: tuple[Effect, ...]) -> Motion:
        """What moves, with what the conditions of these effects need to know of it."""
        if self.mechanism is None or not any(effect.sees for effect in watched):
            return self.motion
        names = tuple(effect.name for effect in watched)
        if names not in self._watching:
            self._watching[names] = self._motion_with((*self.used(), *watched))
        return self._watching[names]

    @cached_property
    def _watching(self) -> dict[tuple[str, ...], Motion]:
        return {}

    def _read_out(self, terms: Terms, motion: Motion) -> dict[str, Expression]:
        epsilon, own = self.epsilon, motion.shown(terms)
        return {
            "p": own["p"],
            "b": own["b"],
            "y": scaled(epsilon**2, terms.state("Y")),
            "v": scaled(epsilon, terms.state("V")),
            "z": scaled(epsilon**2, terms.state("Z")),
            "lambda_N": terms.force,
            **own,
        }

    def initial(self) -> dict[str, fmpq]:
        """The states at the start in the paper's units, exactly: of the model p, b, y, v, z (u, x), of a mechanism its
        components that are integrated, but for those of :meth:`enclosed_initial`, and y, v, z."""
        return self.motion.start(self.values())

    def enclosed_initial(self) -> dict[str, arb]:
        """Enclosures of the components that y, v and the constraints of a mechanism determine, where it has no free
        translation along the normal."""
        return self.motion.enclosed_start()

    def scaled_initial(self, watched: Sequence[Effect] = ()) -> dict[str, fmpq | arb]:
        """Both with Y, V, Z: the value at T = 0 of every state that is integrated in some phase; ``watched`` as in
        :meth:`system`."""
        motion, small = self._motion_watching(tuple(watched)), self.epsilon
        start = motion.start(self.values())
        return (
            start
            | motion.enclosed_start()
            | {"Y": start["y"] / small**2, "V": start["v"] / small, "Z": start["z"] / small**2}
        )

    def first_phase(self) -> str:
        """Flight, stick, slip or reverse slip, as y, z and the slip velocity at the start say."""
        return first_phase(self.motion, self.values(), self.epsilon, self.phases())

    def with_effects(self, add: Sequence[str] = (), drop: Sequence[str] = (), **settings: ExactInput | None) -> Scene:
        """The scene with these effects more and those fewer, and with ``settings`` as in :meth:`with_settings`.

        What is given for an effect that is dropped, its parameters and in the model its states, is dropped with it.

        :raises SceneError: one to add is there, one to drop is not, one that stays needs one that is dropped, or the
            start lacks a state.
        """
        for name in add:
            if name in self.effects:
                raise SceneError(f"effect {name[:40]!r} is in the scene already")
        for name in drop:
            if name not in self.effects:
                raise SceneError(f"effect {name[:40]!r} is not in the scene; it has: {', '.join(self.effects)}")
        wanted = (*(name for name in self.effects if name not in drop), *add)
        _check_effects(wanted, self.mechanism is not None)
        used = _in_order(wanted)
        return self._named(self._with(wanted, _defaults(used, self._motion_with(used)), settings), settings)

    def with_settings(self, **settings: ExactInput | None) -> Scene:
        """The scene with other numbers: parameters (of a mechanism, too), values of the start, ``epsilon`` (``eps`` is
        the same), ``until``, ``start`` ("slip" takes y, v, z from the slow manifold); None changes nothing. Beside a
        mechanism the name says which of its parameters and which values of the start are others.

        :raises SceneError: there is no such setting.
        """
        return self._named(self._with(self.effects, self.defaults(), settings), settings)

    def _named(self, changed: Scene, settings: Mapping[str, ExactInput | None]) -> Scene:
        if self.mechanism is None or changed.mechanism is None:
            return changed
        before, after = dict(self.mechanism.parameters), dict(changed.mechanism.parameters)
        others = [word for word in after if after[word] != before[word]]
        others += [word for word in settings if word in changed.start and changed.start[word] != self.start.get(word)]
        return replace(changed, name=name_with(self.name, {word: str(settings[word]) for word in others}))

    def _with(
        self, effects: tuple[str, ...], defaults: Mapping[str, fmpq], settings: Mapping[str, ExactInput | None]
    ) -> Scene:
        dropped = [name for each in self.used() if each.name not in effects for name in each.sees]
        start = {key: given for key, given in self.start.items() if self.mechanism is not None or key not in dropped}
        parameters = {name: value for name, value in self.parameters.items() if name in defaults}
        epsilon, until = self.epsilon, self.until
        mechanism, slow = self.mechanism, self.on_slow_manifold
        self._check_settings([name for name, value in settings.items() if value is not None], defaults)
        for name, value in settings.items():
            if value is None:
                continue
            if name == "start":
                slow = checked_start(value)
                given_here = [key for key in settings if settings[key] is not None]
                start = {key: given for key, given in start.items() if key not in ("y", "v", "z") or key in given_here}
                continue
            if name in ("eps", "epsilon"):
                epsilon = scene_number(value, name)
            elif name == "until":
                until = scene_number(value, name)
            elif name in self._start_keys():
                if name in ("b", "nu"):
                    start.pop("nu" if name == "b" else "b", None)
                start[name] = value if isinstance(value, str) and mechanism is not None else scene_number(value, name)
            elif mechanism is not None and name in dict(mechanism.parameters):
                mechanism = mechanism.with_parameters(**{checked_owner(defaults, name): value})
            elif name in defaults:
                parameters[name] = scene_number(value, name)
            else:
                own = () if mechanism is None else tuple(dict(mechanism.parameters))
                known = ("epsilon", "until", "start", *self._start_keys(), *defaults, *own)
                raise SceneError(f"no setting {name[:40]!r}{nearest(name, known)}; there are: {', '.join(known)}")
        return replace(
            self,
            effects=effects,
            parameters=parameters,
            start=start,
            epsilon=epsilon,
            until=until,
            mechanism=mechanism,
            on_slow_manifold=slow,
        )

    def _check_settings(self, names: Sequence[str], defaults: Mapping[str, fmpq]) -> None:
        """Passes where each name says one thing, and no two say the same."""
        for one, other in (("eps", "epsilon"), *([("b", "nu")] if self.mechanism is None else [])):
            if one in names and other in names:
                raise SceneError(f"{one} and {other} are both given: give one of them")
        if self.mechanism is None:
            return
        for name, _ in self.mechanism.parameters:
            if name in names and name in OF_EVERY_SCENE:
                raise SceneError(
                    f"{name!r} is a parameter of {self.mechanism.name} and a setting of every scene: "
                    "change it in a file"
                )
        for name in self.mechanism.state:
            if name in names and name not in ("y", "v", "z") and name in (*OF_EVERY_SCENE, *defaults):
                raise SceneError(
                    f"{name!r} is a component of {self.mechanism.name} and a setting of this scene: change it in a file"
                )

    def _start_keys(self) -> tuple[str, ...]:
        if self.mechanism is None:
            return START_KEYS
        return tuple(dict.fromkeys((*self.mechanism.state, "y", "v", "z")))


def checked_start(value: object) -> bool:
    """Whether y, v, z are those of the slow manifold: where ``value`` is "slip".

    :raises SceneError: it is something else.
    """
    if value != SLIP_START:
        raise SceneError(f'start: expected "{SLIP_START}", or a table of components, got {str(value)[:40]!r}')
    return True


def checked_owner(defaults: Mapping[str, fmpq], name: str) -> str:
    """The name of a mechanism's parameter, if no effect has one of that name, with these ``defaults``.

    :raises SceneError: both have.
    """
    if name in defaults:
        raise SceneError(
            f"parameter {name!r} is one of the mechanism and of an effect: change the mechanism's in its file"
        )
    return name


def _in_order(names: Sequence[str]) -> tuple[Effect, ...]:
    return tuple(effect for name, effect in EFFECTS.items() if name in names)


def _defaults(used: Sequence[Effect], motion: Motion) -> dict[str, fmpq]:
    return {name: value for effect in used for name, value in effect.parameters.items()} | dict(motion.parameters)


def _check_names(scene: Scene) -> None:
    """Before they stand in a message."""
    for part in ("effects", "parameters", "start"):
        names = getattr(scene, part)
        mapping = part == "effects" or isinstance(names, Mapping)
        if not mapping or isinstance(names, str) or not all(isinstance(name, str) for name in names):
            expected = "names of effects" if part == "effects" else "values by their names"
            raise SceneError(f"{part}: expected {expected}, got {str(names)[:60]}")


def _check_effects(names: tuple[str, ...], beside_mechanism: bool) -> None:
    for name in names:
        if name in OUTSIDE:
            raise SceneError(f"effect {name!r} is outside of what scenes know: {OUTSIDE[name]}")
        if name not in EFFECTS:
            raise SceneError(f"unknown effect {name[:40]!r}{nearest(name, EFFECTS)}; there are: {', '.join(EFFECTS)}")
        if names.count(name) > 1:
            raise SceneError(f"effect {name!r} is named twice")
        effect = EFFECTS[name]
        for other in effect.needs if beside_mechanism else (*effect.needs, *effect.needs_in_model):
            if other not in names:
                raise SceneError(f"effect {name!r} needs {other!r}")
        if beside_mechanism and effect.not_with_mechanism is not None:
            raise SceneError(f"effect {name!r} and a mechanism exclude each other: {effect.not_with_mechanism}")
    if "compliant_contact" not in names:
        raise SceneError("effect 'compliant_contact' is missing: without it nothing is integrated after the G-spot")


def _check_positive(value: fmpq, name: str) -> None:
    if value <= 0:
        raise SceneError(f"{name} must be > 0, got {value}")


def _check_surface(scene: Scene) -> None:
    motion = scene.motion
    if scene.has_unknown_surface_velocity and isinstance(motion, MechanismMotion) and motion.sees_slip_speed:
        raise SceneError(
            f"effect 'belt': the friction of {motion.mechanism.name} depends on the slip speed, and the velocity of "
            "the surface is not given: give belt_velocity"
        )


def _check_numbers(scene: Scene) -> None:
    values = scene.values()
    _check_positive(scene.until, "until")
    for name in ("k_1", "k_2", "damping"):
        _check_positive(values[name], f"parameter {name}")
    if scene.stop_at_force is not None and scene.stop_at_force <= 1:
        raise SceneError(f"stop_at_force must be > 1, got {scene.stop_at_force}")
    if "stick" in scene.effects and scene.mechanism is None and values["k_minus"] <= values["k_plus"]:
        raise SceneError("effect 'stick': k_minus must be > k_plus: their difference is 2 mu A, positive for friction")
