"""Certified runs that begin exactly at an event, to as many derivatives as can be had (lambda_N = 0, u = the surface's
velocity, friction at its bound, y = z = 0), and runs whose epsilon is such that an event falls on the end of the time.

Questions and judge are those of ``motion``; here the start is solved for, in exact fractions.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from fractions import Fraction
from random import Random

from attack.answers import Answer, Attack, undecided
from attack.motion import DEFAULTS, Question, judged, question, short
from attack.reference_motion import Unsure

_NEAR = (Fraction(0), Fraction(1, 10**9), -Fraction(1, 10**9), Fraction(1, 10**25), -Fraction(1, 10**33))
_PLACES = 24  # of epsilon
_SECANTS = 8


def attack(random: Random) -> Attack:
    """A random scene of the model, bent."""
    first, near = question(random), random.choice(_NEAR)
    bend = random.choice((_touching, _touching, _at_rest, _at_its_bound, _epsilon_of_an_event, _epsilon_of_an_event))
    try:
        bent = bend(first, random, near)
    except Unsure as error:
        why = f"the reference: {error}"
        return Attack(first.text, lambda: undecided(why))

    def ask() -> Answer:
        return judged(bent)

    return Attack(f"certified_run(parse_scene('''{bent.text}'''), points=2)", ask)


def _values(asked: Question) -> Mapping[str, Fraction]:
    return {name: Fraction(value) for name, value in DEFAULTS.items()} | dict(asked.parameters)


def _touching(first: Question, random: Random, near: Fraction) -> Question:
    """lambda_N = 0 at the start, with one to three derivatives; at times all but exactly."""
    values = _values(first)
    rate = values["k_1"] / values["damping"]
    p, b, _, V, Z, u = first.start
    Z = random.choice((Z, Fraction(0), Z, -Fraction(random.randint(1, 8), 4)))
    order = random.choice((0, 1, 1, 2, 2, 3))
    V = -rate * Z if order > 0 else V
    b = rate * rate * Z if order > 1 else b
    parameters = dict(first.parameters)
    if order > 2:
        parameters["alpha_2"] = -(rate**3) * Z / first.epsilon
    where = random.randrange(4)
    start = [p, b, Z, V, Z, random.choice((u, u, values["belt_velocity"]))]
    start[1 + where % 3] += near
    return replace(first, start=tuple(start), parameters=parameters)


def _at_rest(first: Question, random: Random, near: Fraction) -> Question:
    """u is the surface's velocity, in contact, at its first touch, or in flight."""
    values = _values(first)
    p, b, _, V, Z, _ = first.start
    gap = random.choice((Fraction(0), Fraction(1, 2), Fraction(2), -Fraction(1, 2)))
    effects = tuple(dict.fromkeys((*first.effects, "tangential_motion", *random.choice(((), ("stick",))))))
    return replace(first, start=(p, b, Z - gap, V, Z, values["belt_velocity"] + near), effects=effects)


def _at_its_bound(first: Question, random: Random, near: Fraction) -> Question:
    """The contact rests, and the friction that holds it is all that there is: k lambda + a = 0."""
    values = _values(first)
    p, b, _, V, Z, _ = first.start
    k = values[random.choice(("k_minus", "k_plus"))] or Fraction(1)
    gap = abs(first.start[2] - Z) or Fraction(1)
    parameters = {**first.parameters, "a": -k * values["k_2"] * gap + near}
    effects = tuple(dict.fromkeys((*first.effects, "tangential_motion", "stick")))
    return replace(first, start=(p, b, Z - gap, V, Z, values["belt_velocity"]), effects=effects, parameters=parameters)


def _epsilon_of_an_event(first: Question, random: Random, near: Fraction) -> Question:
    """The scene of an epsilon with which an event falls on ``until``, which stays: by the secant method."""
    events = first.reference().events
    if not events:
        return first
    number = random.randrange(len(events))
    name = events[number][0]
    until = short(events[number][1] * first.epsilon * Fraction(random.randint(90, 110), 100), 6)
    if until <= 0:
        return first

    def late(epsilon: Fraction) -> Fraction | None:
        found = replace(first, epsilon=epsilon, until=2 * until).reference().events
        same = number < len(found) and found[number][0] == name
        return found[number][1] * epsilon - until if same else None

    points = [first.epsilon, first.epsilon * Fraction(101, 100)]
    values = [late(point) for point in points]
    for _ in range(_SECANTS):
        one, two = values[-2:]
        if one is None or two is None or one == two or abs(two) < Fraction(1, 10 ** (_PLACES - 2)):
            break
        points.append(short(points[-1] - two * (points[-1] - points[-2]) / (two - one), _PLACES))
        if not Fraction(1, 500) < points[-1] < Fraction(1, 2):
            return first
        values.append(late(points[-1]))
    return replace(first, epsilon=points[-1], until=until + near) if until + near > 0 else first
