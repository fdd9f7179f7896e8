"""Where slip of the model with constant alphas ends, over ranges whose ends, corners and seams lie just on the canard,
or where slip stops just at the G-spot: at all corners of all pieces the closed form must allow what the piece says."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from itertools import product
from random import Random

import mpmath
from attack.answers import AGREED, Answer, Attack, undecided, wrong
from attack.balls_as_numbers import to_fraction
from attack.maps import untrue_cover
from attack.reference_constant import ConstantSlip
from samples.model_texts import model_text

from gspot_verified.mechanisms.fates.box_fate import Fate
from gspot_verified.mechanisms.fates.fates import fates
from gspot_verified.mechanisms.fates.fates_result import Fates
from gspot_verified.mechanisms.input.file import parse_mechanism

_WIDTHS = tuple(Fraction(1, n) for n in (2, 5, 20, 1000, 10**9, 10**15))
_OFF = mpmath.mpf(10) ** -40
_HIGHEST = Fraction(19, 20)  # of p: from p = 1 on the model's mass matrix is none

Place = Mapping[str, Fraction]


def attack(random: Random) -> Attack:
    """A range around, before or after a place where two answers meet."""
    first = -random.choice((Fraction(1), Fraction(1), Fraction(random.randint(2, 20), 8)))
    beta = random.choice((
        Fraction(3, 2), Fraction(2), Fraction(5, 2), Fraction(3), Fraction(21, 20),
        Fraction(random.randint(11, 50), 10),
    ))  # fmt: skip
    second = -Fraction(random.randint(1, 24), 8)
    force, surface = second / ((beta - 1) * first), Fraction(random.choice((0, 0, random.randint(-4, 4))), 4)
    push = random.choice((Fraction(0), Fraction(random.randint(-8, 8), 4), force, force + Fraction(1, 8)))
    slip = ConstantSlip(first, second, beta, push, surface)
    p = random.choice((Fraction(1, 4), Fraction(1, 9), Fraction(random.randint(1, 30), 40)))
    b, u = slip.on_canard(p)
    tie = {"p": p, "b": b, "u": random.choice((u, u, u + 1, surface + 3, surface))}
    over = {}
    for name in random.choice((("p", "b"), ("b", "u"), ("p", "u"), ("b",), ("u",), ("p",))):
        width = random.choice(_WIDTHS) * (abs(tie[name]) or 1)
        before, after = random.choice(((1, 0), (0, 1), (1, 1), (Fraction(1, 3), Fraction(1, 5))))
        high = tie[name] + after * width
        over[name] = (tie[name] - before * width, min(high, _HIGHEST) if name == "p" else high)
    cells, budget = random.choice((1, 2, 3, 4)), random.choice((0, 0, 10))
    text = model_text(f'"u", "{push}", "v", "b", "{first}", "{second}"', f"{beta * first}")
    given = {"x": "0"} | {name: str(value) for name, value in tie.items() if name not in over}
    ranges = {name: f"{low}..{high}:{cells}" for name, (low, high) in over.items()}

    def ask() -> Answer:
        found = fates(parse_mechanism(text), given, ranges, surface_velocity=str(surface), budget=budget)
        return judged(found, tie, slip)

    options = f"surface_velocity='{surface}', budget={budget}"
    return Attack(f"fates(parse_mechanism('''{text}'''), {given}, {ranges}, {options})", ask)


def judged(found: Fates, tie: Place, slip: ConstantSlip) -> Answer:
    """The cover; then all corners, and the tie where a piece holds it."""
    boxes = [(tuple(map(to_fraction, piece.lower)), tuple(map(to_fraction, piece.upper))) for piece in found.pieces]
    if trouble := untrue_cover(boxes, [(to_fraction(axis.lower), to_fraction(axis.upper)) for axis in found.axes]):
        return wrong(f"{trouble}\n{found}")
    names, compared = [axis.name for axis in found.axes], 0
    for piece, (low, high) in zip(found.pieces, boxes, strict=True):
        if piece.fate is Fate.UNDECIDED:
            continue
        corners = list(product(*zip(low, high, strict=True)))
        middle = tuple(tie[name] for name in names)
        inside = all(a <= value <= z for a, value, z in zip(low, middle, high, strict=True))
        for corner in [*corners, *([middle] if inside else [])]:
            place = {**tie, **dict(zip(names, corner, strict=True))}
            if not _allowed(piece.fate, place, slip):
                shown = {name: str(at) for name, at in place.items()}
                return wrong(f"{piece} at {shown}\n{found}")
            compared += 1
    return AGREED if compared else undecided("no piece is settled")


def _allowed(fate: Fate, place: Place, slip: ConstantSlip) -> bool:
    p, b, u = place["p"], place["b"], place["u"]
    if fate is Fate.NO_SLIP:
        return u < slip.surface
    if u <= slip.surface or p == 0 or fate is Fate.LIFT_OFF:  # alpha_2 < 0: b does not rise through 0
        return False
    if fate in (Fate.OPENS, Fate.PAINLEVE):
        return b > 0 and p > 0 if fate is Fate.OPENS else p < 0
    if p < 0 or b >= 0:
        return False
    least = slip.least_slip(p, b, u)
    if fate is Fate.STOPS:
        return bool(least < _OFF)
    sign = {Fate.BELOW: -1, Fate.ABOVE: 1}.get(fate)
    return bool(least > -_OFF) and sign in (None, slip.sign(p, b))
