"""Certified runs of scenes of mechanisms: blocks and rods with couplings, springs, forces that vary with place and
time, belts, a contact that moves. Events, brackets, none left out, and what an effect that is left out assumes."""

from __future__ import annotations

import tempfile
from fractions import Fraction
from pathlib import Path
from random import Random
from typing import Any

from attack.answers import AGREED, Answer, Attack, undecided, wrong
from attack.balls_as_numbers import to_fraction
from attack.reference_scene import Run, Scene, Texts, Unsure, run

from gspot_verified import Outcome
from gspot_verified.scenes.certified_run import certified_run
from gspot_verified.scenes.scene.file import parse_scene
from gspot_verified.scenes.scene.run import IMPACT, SceneRun
from gspot_verified.scenes.scene.scene import SceneError

_OFF = 2e-6
_SEEN = 1e-4


def _part(random: Random, low: float, high: float, of: int = 8) -> Fraction:
    return Fraction(round(random.uniform(low, high) * of), of)


def question(random: Random) -> Texts:
    """A random scene."""
    timed = random.random() < 0.3
    made = _block(random, timed) if random.random() < 0.5 else _rod(random, timed)
    effects, chance = ["compliant_contact"], random.random()
    effects += ["lift_off"] * (random.random() < 0.8) + ["tangential_motion"] * (chance < 0.85)
    effects += ["stick"] * (chance < 0.7)
    numbers: dict[str, Any] = {"epsilon": Fraction(1, random.choice((10, 20, 30))), "belt_velocity": 0}
    numbers["until"] = _part(random, 0.2, 1.5, 10) or Fraction(1, 5)
    if random.random() < 0.25:
        effects.append("belt")
        numbers["belt_velocity"] = _part(random, -1, 1)
    if chance < 0.85 and random.random() < 0.2:
        effects.append("tangential_place")
    for name in ("k_1", "k_2", "c"):
        numbers[name] = Fraction(1)
    if random.random() < 0.3:
        for name in ("k_1", "k_2", "c"):
            numbers[name] = _part(random, 0.5, 2)
    start = dict(made.pop("start").items())
    if random.random() < 0.15:
        start["X_dot"] = numbers["belt_velocity"]
    if random.random() < 0.55:
        small = numbers["epsilon"]
        z, gap = -abs(_part(random, 0, 1, 16)) * small**2, random.choice((Fraction(0), _part(random, -2, 2, 16)))
        start |= {"y": z - gap * small**2, "z": z, "v": _part(random, -1, 1) * small}
    return Texts(effects=tuple(effects), numbers=numbers, start=start, solved="H",
                 negative=random.random() < 0.15, **made)  # fmt: skip


def _block(random: Random, timed: bool) -> dict[str, Any]:
    coupling = str(_part(random, -0.6, 0.6))
    along, up = f"({_part(random, -6, 6)})", f"({_part(random, -4, 0.5)})"
    for chance, low, word in ((0.4, 2, "X_dot"), (0.4, 3, "X")):
        along += f" + ({_part(random, -low, low)})*{word}" * (random.random() < chance)
    up += f" + ({_part(random, -3, 3)})*X" * (random.random() < 0.3)
    x, y = "X", "H"
    if timed:
        along += f" + ({_part(random, -5, 5)})*t" * (random.random() < 0.8)
        up += f" + ({_part(random, -5, 5)})*t^2" * (random.random() < 0.5)
        x += f" + ({_part(random, -1, 1)})*t" * (random.random() < 0.4)
        y += f" - ({_part(random, -1, 1)})*t^2" * (random.random() < 0.3)
    y += f" + ({_part(random, -0.3, 0.3)})*X^2" * (random.random() < 0.3)
    mu = str(_part(random, 0.1, 2.5, 16))
    mu += f" + ({_part(random, -0.1, 0.6)})*X" * (random.random() < 0.3)
    start = {"X": _part(random, -0.5, 0.5), "X_dot": _part(random, -1, 1.5)}
    return {"coordinates": ("X", "H"), "mass": (("1", coupling), (coupling, "1")), "forces": (along, up),
            "x": x, "y": y, "mu": "0" if random.random() < 0.1 else mu, "start": start}  # fmt: skip


def _rod(random: Random, timed: bool) -> dict[str, Any]:
    odd = random.random() < 0.33
    length, inertia = _part(random, 0.4, 1.4), abs(_part(random, 0.15, 0.6)) or Fraction(1, 8)
    coupling = str(_part(random, -0.25, 0.25)) if odd else "0"
    push = f"({_part(random, -2, 2)})" if random.random() < 0.5 else "0"
    turn = f"({_part(random, -2, 2)})" if random.random() < 0.6 else "0"
    turn += f" - ({_part(random, -2, 2)})*th_dot" * odd
    push += f" + ({_part(random, -3, 3)})*t" * timed
    start = {"X": _part(random, -0.5, 0.5), "X_dot": _part(random, -1, 1.5)}
    start |= {"th": _part(random, 0.3, 1.4), "th_dot": _part(random, -1.5, 1.5)}
    mass = (("1", "0", coupling), ("0", "1", "0"), (coupling, "0", str(inertia)))
    return {"coordinates": ("X", "H", "th"), "mass": mass,
            "forces": (push, f"({_part(random, -2, 0)})", turn), "x": f"X + ({length})*cos(th)",
            "y": f"H - ({length})*sin(th)", "mu": str(_part(random, 0.2, 2.5, 16)), "start": start}  # fmt: skip


def _quoted(value: Any) -> str:
    return f"[{', '.join(_quoted(each) for each in value)}]" if isinstance(value, tuple) else f'"{value}"'


def files(asked: Texts) -> tuple[str, str]:
    """The mechanism's file and the scene's, which names the other ``mechanism.toml``."""
    number = asked.numbers
    timed = 'time = "t"\n' if _has_time(asked) else ""
    mechanism = (
        f'format = 1\nname = "attack"\n[lagrangian]\ncoordinates = {_quoted(asked.coordinates)}\n'
        f"mass_matrix = {_quoted(asked.mass)}\nforces = {_quoted(asked.forces)}\n{timed}"
        f'[contact]\nx = "{asked.x}"\ny = "{asked.y}"\nmu = "{asked.mu}"\n'
    )
    mechanism += 'slip = "negative"\n' if asked.negative else ""
    mechanism += "[regularisation]\n" + "".join(f'{name} = "{number[name]}"\n' for name in ("k_1", "k_2", "c"))
    scene = (
        f'format = 1\nname = "attack"\nmechanism = "mechanism.toml"\neffects = {_quoted(asked.effects)}\n'
        f'epsilon = "{number["epsilon"]}"\nuntil = "{number["until"]}"\n'
    )
    scene += f'[parameters]\nbelt_velocity = "{number["belt_velocity"]}"\n' if "belt" in asked.effects else ""
    return mechanism, scene + "[start]\n" + "".join(f'{name} = "{value}"\n' for name, value in asked.start.items())


def _has_time(asked: Texts) -> bool:
    return any("*t" in text.replace("*th", "") for text in (*asked.forces, asked.x, asked.y))


def attack(random: Random) -> Attack:
    """A random scene."""
    asked = question(random)
    mechanism, scene = files(asked)
    return Attack(f"certified_run(parse_scene('''{scene}''')) with mechanism.toml '''{mechanism}'''",
                  lambda: judged(asked))  # fmt: skip


def judged(asked: Texts) -> Answer:
    """The package's run beside the reference's."""
    mechanism, scene = files(asked)
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "mechanism.toml").write_text(mechanism)
        try:
            read = parse_scene(scene, Path(folder))
        except SceneError as error:
            return undecided(f"SceneError: {str(error)[:40]}")
        found = certified_run(read, budget=1500)
    try:
        reference = run(Scene(asked))
    except Unsure as why:
        return undecided(f"the reference: {why}")
    return _compared(asked, found, reference)


def _compared(asked: Texts, found: SceneRun, reference: Run) -> Answer:
    until = float(asked.numbers["until"])
    shown = (
        f"{found}\n  reference: {reference.events} from {reference.first}, least force {reference.least_force:.3g}, "
        f"least slip {reference.least_slip:.3g}, least friction {reference.least_friction:.3g}"
    )
    if found.verdict.outcome is Outcome.REFUTED:
        return _refuted(asked, reference, shown)
    own = [event for event in found.events if event.name != IMPACT]
    for event, (name, time) in zip(own, reference.events, strict=False):
        if event.name != name:
            return wrong(f"{event.name} where the reference has {name}\n{shown}")
        if not float(to_fraction(event.lower)) - _OFF <= time <= float(to_fraction(event.upper)) + _OFF:
            return wrong(f"{name}: not in its bracket\n{shown}")
    if any(float(to_fraction(event.upper)) < until - _OFF for event in own[len(reference.events) :]):
        return wrong(f"more events than the reference has\n{shown}")
    if found.verdict.outcome is not Outcome.PROVED:
        return undecided(f"{found.verdict.reason}")
    text = str(found)
    if "for ever" not in text and any(time < until - _OFF for _, time in reference.events[len(own) :]):
        return wrong(f"an event was left out\n{shown}")
    if "provided" in text:
        return AGREED
    if "lift_off" not in asked.effects and reference.least_force < -_SEEN:
        return wrong(f"proved, lift_off is left out and the force is negative\n{shown}")
    if "stick" not in asked.effects and reference.least_slip < -_SEEN:
        return wrong(f"proved, stick is left out and slip is negative\n{shown}")
    return wrong(f"proved with mu < 0\n{shown}") if reference.least_friction < -_SEEN else AGREED


def _refuted(asked: Texts, reference: Run, shown: str) -> Answer:
    """Refuted: an effect that is left out matters. The reference must see one that does."""
    reasons = {"lift_off": reference.least_force, "stick": reference.least_slip}
    if any(name not in asked.effects and least < _SEEN for name, least in reasons.items()):
        return AGREED
    return wrong(f"refuted, and the reference sees no reason\n{shown}")
