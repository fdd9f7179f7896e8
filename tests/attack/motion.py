"""Certified runs of the model scenes against the plain Taylor method: the order of events, their brackets, no event
that was left out, the trajectory; also where two events nearly or exactly coincide, where a run ends at an event, and
where it starts on the surface of one."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import pairwise
from random import Random

from attack.answers import AGREED, Answer, Attack, undecided, wrong
from attack.balls_as_numbers import to_fraction
from attack.reference_motion import FLIGHT, Model, Motion, Unsure, moved
from attack.reference_series import BITS

from gspot_verified import Outcome
from gspot_verified.scenes.certified_run import certified_run
from gspot_verified.scenes.scene.file import parse_scene
from gspot_verified.scenes.scene.run import IMPACT, SceneRun
from gspot_verified.scenes.scene.scene import SceneError

DEFAULTS = {
    "alpha_1": -1, "alpha_2": -1, "beta": Fraction(3, 2), "k_1": 1, "k_2": 1, "damping": 1, "chi": 0, "a": 0,
    "k_plus": -1, "k_minus": 2, "p_minus": 1, "belt_velocity": 0,
}  # fmt: skip
_STATES = ("p", "b", "Y", "V", "Z", "u")
_LONGEST = 80
_CHANGES = ("lift-off", "touch-down", "stick", "slip forwards", "slip backwards")


@dataclass(frozen=True)
class Question:
    """A scene of the model: ``start`` in the scaled units p, b, Y, V, Z, u."""

    effects: tuple[str, ...]
    epsilon: Fraction
    until: Fraction
    parameters: Mapping[str, Fraction]
    start: tuple[Fraction, ...]

    @property
    def text(self) -> str:
        """The scene as a file."""
        p, b, Y, V, Z, u = self.start
        small = self.epsilon
        start = {"p": p, "b": b, "y": Y * small**2, "v": V * small, "z": Z * small**2}
        start |= {"u": u} if "tangential_motion" in self.effects else {}
        lines = ["format = 1", 'name = "attack"', f"effects = {list(self.effects)}".replace("'", '"')]
        lines += [f'epsilon = "{small}"', f'until = "{self.until}"', "[parameters]"]
        lines += [f'{name} = "{value}"' for name, value in self.parameters.items()]
        return "\n".join([*lines, "[start]", *(f'{name} = "{value}"' for name, value in start.items())])

    @property
    def model(self) -> Model:
        """The same for the reference."""
        values = {name: Fraction(value) for name, value in DEFAULTS.items()} | dict(self.parameters)
        return Model(self.epsilon, values, "stick" in self.effects, "lift_off" in self.effects)

    def reference(self, more: Fraction = Fraction(0)) -> Motion:
        """The reference's motion, to ``more`` T beyond the end."""
        model = self.model
        start = list(self.start)
        return moved(model.phases(), model.first(start), start, self.until / self.epsilon + more, model.after)


def _number(random: Random, low: float, high: float) -> Fraction:
    value = random.uniform(low, high)
    return random.choice(
        (Fraction(round(value * 8), 8), Fraction(round(value * 1000), 1000), Fraction(round(value * 7), 7))
    )


def question(random: Random) -> Question:
    """A random scene."""
    effects = ["compliant_contact", "lift_off"]
    parameters = {
        "alpha_1": _number(random, -2, 1), "alpha_2": _number(random, -2, 1), "beta": _number(random, 0.2, 4),
    }  # fmt: skip
    if random.random() < 0.3:
        parameters |= {name: _number(random, 0.4, 2) or Fraction(1) for name in ("k_1", "k_2", "damping")}
    if random.random() < 0.7:
        effects.append("tangential_motion")
        parameters |= {"a": random.choice((Fraction(0), _number(random, -1, 1))), "k_plus": _number(random, -2, 1)}
        if random.random() < 0.85:
            effects.append("stick")
            parameters["k_minus"] = parameters["k_plus"] + (abs(_number(random, 0.3, 3)) or Fraction(1))
            parameters["p_minus"] = _number(random, -1, 2)
            if random.random() < 0.3:
                effects.append("belt")
                parameters["belt_velocity"] = _number(random, -1, 1)
    if random.random() < 0.4:
        effects.append("two_way_coupling")
        parameters["chi"] = _number(random, -1, 1)
    epsilon = random.choice((Fraction(1, 10), Fraction(1, 20), Fraction(1, 50), Fraction(1, 100)))
    start = _start(random, parameters)
    until = _number(random, 0.2, min(2.0, float(_LONGEST * epsilon))) or Fraction(1, 4)
    return Question(tuple(effects), epsilon, until, parameters, start)


def _start(random: Random, parameters: Mapping[str, Fraction]) -> tuple[Fraction, ...]:
    p, b = _number(random, -0.7, 1.2), _number(random, -1.5, 0.5)
    u = random.choice((Fraction(0), _number(random, 0, 0.3), _number(random, 0, 3), parameters.get("belt_velocity", 0)))
    if "k_minus" in parameters and random.random() < 0.3:
        u = -u
    kind = random.random()
    if kind < 0.35 and p > 0 and b < 0:
        k_1, k_2 = (parameters.get(name, Fraction(1)) for name in ("k_1", "k_2"))
        Y, V, Z = b / p * (1 / k_1 + 1 / k_2), Fraction(0), b / p / k_1
    elif kind < 0.55:
        Y = Z = V = Fraction(0)  # just touching
        V = random.choice((Fraction(0), -abs(_number(random, 0, 1))))
    elif kind < 0.7:
        Z = -abs(_number(random, 0, 2))
        Y, V = Z, _number(random, -1, 1)
    else:
        Z = -abs(_number(random, 0, 2))
        Y, V = Z + _number(random, -2, 1), _number(random, -1, 1)
    return p, b, Y, V, Z, Fraction(u)


def attack(random: Random) -> Attack:
    """A random scene, or one that was bent so that something coincides."""
    first = question(random)
    bend = random.choice((_plain, _plain, _ends_at_an_event, _coinciding, _ends_after_two))
    pick, near = (
        random.random(),
        random.choice(
            (Fraction(0), Fraction(1, 10**9), Fraction(-1, 10**9), Fraction(1, 10**25), -Fraction(1, 10**33))
        ),
    )
    bent: list[Question] = []

    def ask() -> Answer:
        return judged(bent[0])

    try:
        bent.append(bend(first, pick, near))
    except Unsure as error:
        why = f"the reference: {error}"
        return Attack(first.text, lambda: undecided(why))
    return Attack(f"certified_run(parse_scene('''{bent[0].text}'''), points=2)", ask)


def _plain(first: Question, pick: float, near: Fraction) -> Question:  # noqa: ARG001
    return first


def short(value: Fraction, places: int = 30) -> Fraction:
    """Rounded to so many decimals."""
    return Fraction(round(value * 10**places), 10**places)


def _ends_at_an_event(first: Question, pick: float, near: Fraction) -> Question:
    events = first.reference().events
    if not events:
        return first
    time = events[int(pick * len(events))][1] * first.epsilon
    return replace(first, until=short(time + near)) if time + near > 0 else first


def _coinciding(first: Question, pick: float, near: Fraction) -> Question:
    """u at the start such that slip ends at another event: u acts back on nothing, so it is moved as a whole."""
    if "stick" not in first.effects:
        return first
    far = replace(first, start=(*first.start[:5], Fraction(10**6)))
    found = far.reference()
    if not found.events:
        return first
    time = found.events[int(pick * len(found.events))][1]
    drift = found.at(time)[1][5] - 10**6
    belt = first.parameters.get("belt_velocity", Fraction(0))
    return replace(first, start=(*first.start[:5], short(belt - drift + near)))


def _ends_after_two(first: Question, pick: float, near: Fraction) -> Question:
    """The end between two coinciding events, or right after them."""
    bent = _coinciding(first, pick, near)
    try:
        events = bent.reference().events
    except Unsure:
        return bent
    if not events:
        return bent
    return replace(bent, until=short(events[0][1] * bent.epsilon + 2 * abs(near) + Fraction(1, 10**12)))


def judged(asked: Question) -> Answer:
    """The package's run beside the reference's."""
    try:
        scene = parse_scene(asked.text)
    except SceneError as error:
        return undecided(f"SceneError: {str(error)[:60]}")
    found = certified_run(scene, points=2, budget=1500)
    try:
        motion = asked.reference()
    except Unsure as why:
        claimed = found.verdict.outcome is Outcome.PROVED
        return undecided(f"the reference is not sure, the run {'proved' if claimed else 'undecided'}: {str(why)[:40]}")
    return _compared(asked, found, motion)


def _compared(asked: Question, found: SceneRun, motion: Motion) -> Answer:
    proved = found.verdict.outcome is Outcome.PROVED
    shown = f"{found}\n  reference: {[(name, float(T * asked.epsilon)) for name, T in motion.events]}"
    if found.verdict.outcome is Outcome.REFUTED:
        return _left_out(asked, motion, shown)
    own = [event for event in found.events if event.name in _CHANGES]
    for event, (name, time) in zip(own, motion.events, strict=False):
        if event.name != name:
            return wrong(f"{event.name} where the reference has {name}\n{shown}")
        if not to_fraction(event.lower) - _OFF <= time * asked.epsilon <= to_fraction(event.upper) + _OFF:
            return wrong(f"{name}: not in its bracket\n{shown}")
    whole = motion.end >= asked.until / asked.epsilon
    more = own[len(motion.events) :]  # the exact solution speaks of all times: what it says of later ones is not judged
    if whole and any(to_fraction(event.upper) <= asked.until for event in more):
        return wrong(f"more events than the reference has\n{shown}")
    if proved and len(motion.events) > len(own):
        return wrong(f"an event was left out\n{shown}")
    trouble = _trajectory(found, motion, asked.epsilon) or _growth(asked, found, motion)
    if trouble:
        return wrong(f"{trouble}\n{shown}")
    if "stick" not in asked.effects and "tangential_motion" in asked.effects and proved:
        least = _least_slip(motion)
        if least < -Fraction(1, 10**6) and "condition" not in str(found.verdict):
            return wrong(f"stick is left out, proved, and u falls to {float(least)}\n{shown}")
    return AGREED if proved else undecided(f"{found.verdict.reason}: {found.verdict.detail.split('(t =')[0][:60]}")


_OFF = Fraction(1, 10**40)


def _left_out(asked: Question, motion: Motion, shown: str) -> Answer:
    """Refuted: an effect that is left out matters. True where slip turns and stick is left out."""
    least = _least_slip(motion)
    if "stick" not in asked.effects and "tangential_motion" in asked.effects and least <= 0:
        return AGREED
    return wrong(f"refuted, and the reference sees no reason\n{shown}")


def _least_slip(motion: Motion) -> Fraction:
    """The least u at some places in contact; 1 where there is none: in flight nothing is assumed of u."""
    step = Fraction(motion.end, 1 << BITS) / 200
    found = [motion.at(k * step) for k in range(201)]
    return min((states[5] for phase, states in found if phase != FLIGHT), default=Fraction(1))


def _trajectory(found: SceneRun, motion: Motion, epsilon: Fraction) -> str:
    """The samples of the run; a message where one does not hold the reference's state."""
    if found.samples is None:
        return ""
    columns = found.samples.columns
    scale = {"p": 1, "b": 1, "y": epsilon**2, "v": epsilon, "z": epsilon**2, "u": 1}
    times, spread = columns["t"], columns.get("t_radius")
    for row in range(0, len(times), max(1, len(times) // 25)):
        if spread is None or not spread[row] < 1e-14:
            continue
        time = Fraction(times[row]) / epsilon
        if time > Fraction(motion.end, 1 << BITS):
            break
        phase, states = motion.at(time)
        if phase != found.samples.phases[row]:
            continue
        for name, factor in scale.items():
            if name not in columns:
                continue
            exact = states["pbyvzu".index(name)] * factor
            rate = abs(exact) + 100
            allowed = Fraction(columns[f"{name}_radius"][row]) + rate * Fraction(spread[row]) * 1000 + _rounded(exact)
            if abs(Fraction(columns[name][row]) - exact) > allowed:
                return f"{name} at t = {times[row]}: {columns[name][row]}, the reference {float(exact)}"
    return ""


def _rounded(exact: Fraction) -> Fraction:
    """A time that is shown as a float is off by its rounding; so is the state then."""
    return (abs(exact) + 1) * Fraction(1, 10**9)


def _growth(asked: Question, found: SceneRun, motion: Motion) -> str:
    """An impact: the force grows from then on until the next event, or until it has grown by the multiple."""
    for event in found.events:
        if event.name != IMPACT:
            continue
        begin = to_fraction(event.upper) / asked.epsilon
        if begin >= Fraction(motion.end, 1 << BITS):
            continue
        later = [T for _, T in motion.events if begin < T]
        end = min([*later, Fraction(motion.end, 1 << BITS), begin + 20])
        forces = [states[4] - states[2] for k in range(21) for states in [motion.at(begin + (end - begin) * k / 21)[1]]]
        limited = "-fold" in str(found.verdict) or "times as large" in str(found.verdict)
        if not limited and any(after <= before for before, after in pairwise(forces)):
            return f"the force does not grow after the impact: {[float(x) for x in forces]}"
    return ""
