"""Certified runs of rods that begin exactly at an event, at the angle 0, where sines and cosines are rational and their
derivatives are not lost: lambda_N = 0 with up to two derivatives, the contact point at rest on its surface.

Judge and reference are those of ``scenes``; the start is solved for, in exact fractions.
"""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from random import Random

from attack.answers import Attack
from attack.reference_scene import Texts
from attack.scenes import files, judged, question

_NEAR = (Fraction(0), Fraction(0), Fraction(1, 10**20), -Fraction(1, 10**30))


def attack(random: Random) -> Attack:
    """A random rod."""
    asked = _rod(random)
    mechanism, scene = files(asked)
    return Attack(f"certified_run(parse_scene('''{scene}''')) with mechanism.toml '''{mechanism}'''",
                  lambda: judged(asked))  # fmt: skip


def _part(random: Random, low: float, high: float) -> Fraction:
    return Fraction(round(random.uniform(low, high) * 8), 8)


def _rod(random: Random) -> Texts:
    """x = X + l cos(th), y = H - l sin(th) + k (cos(th) - 1): at th = 0 a = F_X - l w^2, b = F_H - l T/I - k w^2."""
    base = question(random)
    numbers = dict(base.numbers)
    length, inertia, bow = _part(random, 0.4, 1.4), abs(_part(random, 0.2, 0.7)) or Fraction(1, 4), _part(random, -1, 1)
    turn, rate, push = _part(random, -2, 2), _part(random, -1.5, 1.5), _part(random, -3, 3)
    small, belt = numbers["epsilon"], numbers["belt_velocity"]
    give, order, near = numbers["k_1"] / (numbers["c"] * small), random.randrange(4), random.choice(_NEAR)
    z = Fraction(random.randint(-16, 0), 8) * small**2
    y = z if order else z - abs(_part(random, 0.1, 2)) * small**2
    v = -give * z if order > 1 else _part(random, -1, 1) * small
    free = -length * turn / inertia - bow * rate**2
    lift = give**2 * z - free if order > 2 else _part(random, -4, 0)
    at_rest = random.random() < 0.6
    start = {"X": _part(random, -1, 1), "X_dot": belt if at_rest else _part(random, -1, 1.5), "th": Fraction(0)}
    start |= {"th_dot": rate, "y": y, "z": z, "v": v + near * small}
    if random.random() < 0.2:
        push = length * rate**2  # a = 0, too
    effects = base.effects
    if at_rest and random.random() < 0.7:
        effects = tuple(dict.fromkeys((*effects, "tangential_motion", "stick")))
    return replace(
        base, coordinates=("X", "H", "th"), mass=(("1", "0", "0"), ("0", "1", "0"), ("0", "0", str(inertia))),
        forces=(f"({push})", f"({lift})", f"({turn})"), x=f"X + ({length})*cos(th)",
        y=f"H - ({length})*sin(th) + ({bow})*(cos(th) - 1)", mu=str(_part(random, 0.2, 2.5)),
        effects=effects, numbers=numbers, start=start, negative=False,
    )  # fmt: skip
