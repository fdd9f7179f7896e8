"""Sweeps of two parameters, of a random body or of the model with polynomials as its alphas: the pieces cover the
rectangle once, and at random places, corners and seams the reference's spots have what the piece says. Where the whole
is proved the spot is followed from the start by the reference too: the pieces must be its own, not those of another."""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from random import Random
from typing import Any

import mpmath
from attack.answers import AGREED, Answer, Attack, undecided, wrong
from attack.balls_as_numbers import to_fraction
from attack.mechanisms import body, drawn_body, file_of
from attack.sweeps import Spots, matching, shown, sign_of, spots_of, untrue_piece, value_in
from samples.model_texts import model_text

from gspot_verified import Outcome
from gspot_verified.expansion.series.system import GSpotError
from gspot_verified.mechanisms.input.file import parse_mechanism
from gspot_verified.mechanisms.input.mechanism import MechanismError
from gspot_verified.mechanisms.sweep.sweep import sweep
from gspot_verified.mechanisms.sweep.sweep_piece import Kind, SweepPiece
from gspot_verified.mechanisms.sweep.sweep_result import Sweep

_NAMES = ("par", "other")
_WIDTHS = (Fraction(1, 2), Fraction(1, 5), Fraction(1, 20), Fraction(1, 10**6), Fraction(1, 10**40))
_MODEL = model_text('"u", 0, "v", "b", "alpha_1", "alpha_2"', "alpha_3", "par = 0\nother = 0")
_INSIDE, _CORNERS, _CURVES = 4, 3, 3  # places that are looked at
_PIECES = 24  # that a sweep divides by itself: a question is to take a second, not a minute
_STEPS = 12  # on the way from the start to a place

Place = tuple[Fraction, ...]
Find = Callable[[Mapping[str, Fraction]], Spots]


def attack(random: Random) -> Attack:
    """A body, or the model."""
    return random.choice((_body, _model, _model))(random)


def _model(random: Random) -> Attack:
    """The model system, whose alphas are polynomials: their curves cross, touch, turn, or run along the seams."""
    alphas = {name: _polynomial(random) for name in ("alpha_1", "alpha_2", "alpha_3")}
    formulas = {name: " + ".join(f"({c})*{term}" for term, c in each.items()) for name, each in alphas.items()}
    text = _MODEL
    for name, formula in formulas.items():
        text = text.replace(name, f"({formula})")
    over = {}
    for name in _NAMES:
        width = random.choice((1, 1, Fraction(1, 2), Fraction(1, 7), Fraction(1, 10**20)))
        low, high = random.choice(((-width, width), (Fraction(0), width), (-width, Fraction(0)), (-width / 3, width)))
        over[name] = f"{low}..{high}:{random.choice((1, 1, 2, 3))}"
    seed = random.getrandbits(32)

    def spots(at: Mapping[str, Fraction]) -> Spots:
        x, y = (at[name] for name in _NAMES)
        exact = {
            name: each["1"] + each["par"] * x + each["other"] * y + each["par*other"] * x * y
            + each["par^2"] * x * x + each["other^2"] * y * y
            for name, each in alphas.items()
        }  # fmt: skip
        with mpmath.workdps(60):
            spot = {name: mpmath.mpf(value.numerator) / value.denominator for name, value in exact.items()}
        return [spot | {name: mpmath.mpf(value) for name, value in (("u", 1), ("th", 0), ("th_dot", 0))}], True

    def ask() -> Answer:
        try:
            found = sweep(parse_mechanism(text), over, budget=_PIECES)
        except (MechanismError, GSpotError, ValueError) as error:
            return undecided(f"{type(error).__name__}: {str(error)[:40]}")
        return judged(found, spots, Random(seed))

    return Attack(f"sweep(parse_mechanism('''{text}'''), {over}, budget={_PIECES})", ask)


def _polynomial(random: Random) -> dict[str, Fraction]:
    """Of two parameters; below 0 in the middle, as a rule."""
    first = random.choice((Fraction(-1), Fraction(-3, 2), Fraction(-2), Fraction(-7, 2), Fraction(-1, 4), Fraction(0)))
    others = ("par", "other", "par*other", "par^2", "other^2")
    slope = (Fraction(0), Fraction(0), Fraction(1), Fraction(-1, 2), Fraction(1, 3), Fraction(-2))
    return {"1": first} | {name: random.choice(slope) for name in others}


def _body(random: Random) -> Attack:
    """Two parameters of a random body vary; at times the start is a corner of four cells, or of the rectangle."""
    values, slip = drawn_body(random)
    values["k"] = Fraction(0)
    which = random.sample(("mu", "mu", "g", "tau", "l", "J", "push", "d", "q", "c", "s"), 2)
    if which[0] == which[1]:
        which[1] = "idle"
    places = [(name, of, values.get(of, Fraction(1))) for name, of in zip(_NAMES, which, strict=True)]
    over, centres = {}, {name: str(centre) for name, _, centre in places}
    for name, _, centre in places:
        width = (abs(centre) or Fraction(1)) * random.choice(_WIDTHS)
        low, high = random.choice(
            ((centre - width, centre + width), (centre, centre + width), (centre - width, centre))
        )
        over[name] = f"{low}..{high}:{random.choice((1, 1, 2, 2, 3))}"
    named = {**values, **{of: name for name, of in zip(_NAMES, which, strict=True) if of in values}}
    if random.random() < 0.5 and (bent := _across_a_border(named, slip, places, random)):
        over["par"] = f"{bent[0]}..{bent[1]}:1"
    text, number, seed = file_of(named, slip, centres), random.choice((1, 1, 2)), random.getrandbits(32)

    def ask() -> Answer:
        try:
            found = sweep(parse_mechanism(text), over, spot=number, budget=_PIECES)
        except (MechanismError, GSpotError, ValueError) as error:
            return undecided(f"{type(error).__name__}: {str(error)[:40]}")
        own = Random(seed)
        return judged(found, _careful(spots_of(body(named), slip, own)), own)

    return Attack(f"sweep(parse_mechanism('''{text}'''), {over}, spot={number}, budget={_PIECES})", ask)


def _across_a_border(
    named: Mapping[str, Any], slip: Fraction, places: Sequence[tuple[str, str, Fraction]], random: Random
) -> tuple[Fraction, Fraction] | None:
    """A range of the first parameter in which a spot comes to another Case or side, by the reference; None: none."""
    centre, other = places[0][2] or Fraction(1), places[1][2]
    spots = _careful(spots_of(body(dict(named)), slip, random))
    values = [centre * Fraction(k, 8) for k in range(4, 15)]
    found = [[_border(spot) for spot in spots({"par": value, "other": other})[0]] for value in values]
    pairs = list(itertools.pairwise(zip(values, found, strict=True)))
    ranges = [(low, high) for (low, one), (high, two) in pairs if len(one) == len(two) and one != two]
    return random.choice(ranges) if ranges else None


def _careful(spots: Find) -> Find:
    """The same; unsure where the body has a pole of p, as beyond the sense of its mass matrix."""

    def careful(at: Mapping[str, Fraction]) -> Spots:
        try:
            return spots(at)
        except ValueError:
            return [], False

    return careful


def _border(spot: Mapping[str, Any]) -> tuple[int, ...]:
    """What changes where a spot passes from one Case, or side, to another."""
    signs = [sign_of(value_in(spot, name)) for name in ("alpha_1", "alpha_2", "alpha_3", "alpha_3 - alpha_1")]
    return (*signs, int(mpmath.floor(value_in(spot, "beta"))) if signs[0] and signs[2] == signs[0] else 0)


def judged(found: Sweep, spots: Find, random: Random) -> Answer:
    """The cover by exact areas; then the reference's spots at some places."""
    boxes = [(tuple(map(to_fraction, piece.lower)), tuple(map(to_fraction, piece.upper))) for piece in found.pieces]
    whole = [(to_fraction(axis.lower), to_fraction(axis.upper)) for axis in found.axes]
    if trouble := untrue_cover(boxes, whole):
        return wrong(f"{trouble}\n{found}")
    compared = 0
    for place in _places(boxes, whole, random):
        for piece, (low, high) in zip(found.pieces, boxes, strict=True):
            if not _within(low, place, high) or piece.kind not in (Kind.SETTLED, Kind.CROSSING):
                continue
            here, sure = spots(_named(place))
            trouble = untrue_piece(piece, here)
            if trouble and sure:
                return wrong(f"at {_text(place)}: {trouble}\n{found}\n  reference: {shown(here)}")
            compared += not trouble
    if trouble := _graphs(found, boxes, spots, random):
        return wrong(f"{trouble}\n{found}")
    proved = found.verdict.outcome is Outcome.PROVED
    if proved and any(piece.kind in (Kind.OPEN, Kind.NO_TUBE) for piece in found.pieces):
        return wrong(f"proved with open pieces\n{found}")
    if proved and all(piece.kind is not Kind.SETTLED for piece in found.pieces):
        return wrong(f"proved, and nothing is settled\n{found}")
    if proved and (trouble := _other_spot(found, boxes, whole, spots, random)):
        return wrong(f"{trouble}\n{found}")
    if not compared:
        return undecided("no settled piece at the places")
    return AGREED if proved else undecided(f"holds: {found.verdict.reason}")


def untrue_cover(boxes: Sequence[tuple[Place, Place]], whole: Sequence[tuple[Fraction, Fraction]]) -> str:
    """Boxes inside, with no common interior, whose areas make up the whole."""
    area = Fraction(0)
    for low, high in boxes:
        if any(not a <= x < y <= b for x, y, (a, b) in zip(low, high, whole, strict=True)):
            return f"the piece {_text(low)}..{_text(high)} is empty or outside"
        area += math.prod(b - a for a, b in zip(low, high, strict=True))
    for (low, high), (other, end) in itertools.combinations(boxes, 2):
        if all(max(a, b) < min(c, d) for a, b, c, d in zip(low, other, high, end, strict=True)):
            return f"the pieces at {_text(low)} and {_text(other)} overlap"
    all_of_it = math.prod((high - low for low, high in whole), start=Fraction(1))
    return "" if area == all_of_it else f"the pieces leave {all_of_it - area} out"


def _places(
    boxes: Sequence[tuple[Place, Place]], whole: Sequence[tuple[Fraction, Fraction]], random: Random
) -> list[Place]:
    """Inside, and corners of pieces, which several of them share."""
    places: list[Place] = [
        tuple(low + (high - low) * Fraction(random.getrandbits(40), 1 << 40) for low, high in whole)
        for _ in range(_INSIDE)
    ]
    for _ in range(_CORNERS):
        box = random.choice(boxes)
        places.append(tuple(box[random.randrange(2)][k] for k in range(2)))
    return places


def _graphs(found: Sweep, boxes: Sequence[tuple[Place, Place]], spots: Find, random: Random) -> str:
    """Where a quantity may vanish it grows, or falls, along the parameter that the piece names."""
    pairs = [(piece, box) for piece, box in zip(found.pieces, boxes, strict=True) if piece.kind is Kind.CROSSING]
    for piece, (low, high) in random.sample(pairs, min(_CURVES, len(pairs))):
        assert piece.passing is not None
        along = piece.passing.along
        across = low[1 - along] + (high[1 - along] - low[1 - along]) * Fraction(random.getrandbits(20), 1 << 20)
        ends = [(end[along], across) if along == 0 else (across, end[along]) for end in (low, high)]
        here = [matching(piece, spots(_named(place))[0]) for place in ends]
        if [len(each) for each in here] != [1, 1]:
            continue
        before, after = (each[0] for each in here)
        quantity = piece.passing.quantity
        with mpmath.workdps(40):
            sign = sign_of(value_in(after, quantity) - value_in(before, quantity))
        if sign == -piece.passing.direction:
            direction = f"{piece.passing.direction} along {_NAMES[along]}"
            return f"{quantity} has not the direction {direction} from {_text(ends[0])} on"
    return ""


def _other_spot(
    found: Sweep,
    boxes: Sequence[tuple[Place, Place]],
    whole: Sequence[tuple[Fraction, Fraction]],
    spots: Find,
    random: Random,
) -> str:
    """The reference follows the spot from the start; the pieces at the end of the way must hold that one."""
    start = tuple(map(to_fraction, found.start))
    end = tuple(low + (high - low) * Fraction(random.getrandbits(40), 1 << 40) for low, high in whole)
    own = [spot for spot in spots(_named(start))[0] if _holds(found, boxes, start, spot)]
    if len(own) != 1:
        return ""
    spot = own[0]
    for k in range(1, _STEPS + 1):
        place = tuple(a + (b - a) * Fraction(k, _STEPS) for a, b in zip(start, end, strict=True))
        here, sure = spots(_named(place))
        if not sure or not (next_one := _nearest(spot, here)):
            return ""  # lost on the way
        spot = next_one
    if _holds(found, boxes, end, spot):
        return ""
    return f"at {_text(end)} the pieces do not hold the spot that comes from the start: {shown([spot])}"


def _holds(found: Sweep, boxes: Sequence[tuple[Place, Place]], place: Place, spot: dict[str, Any]) -> bool:
    at: list[SweepPiece] = [
        piece for piece, (low, high) in zip(found.pieces, boxes, strict=True) if _within(low, place, high)
    ]
    return all(matching(piece, [spot]) for piece in at)


def _nearest(spot: dict[str, Any], others: Sequence[dict[str, Any]]) -> dict[str, Any] | None:
    """The spot that is far nearer than all others; None where there is no such."""
    order = sorted(others, key=lambda other: _distance(spot, other))
    if not order or _distance(spot, order[0]) > 0.1:
        return None
    return order[0] if len(order) == 1 or _distance(spot, order[1]) > 5 * _distance(spot, order[0]) else None


def _distance(one: dict[str, Any], two: dict[str, Any]) -> float:
    return float(abs(mpmath.sin((one["th"] - two["th"]) / 2)) + abs(one["th_dot"] - two["th_dot"]))


def _within(low: Place, place: Place, high: Place) -> bool:
    return all(a <= x <= b for a, x, b in zip(low, place, high, strict=True))


def _named(place: Place) -> dict[str, Fraction]:
    return dict(zip(_NAMES, place, strict=True))


def _text(place: Place) -> str:
    return f"({', '.join(map(str, place))})"
