"""Where slip ends, over ranges of starts of the model with polynomials as its alphas and of rods with a spring: at
random places, ends and corners of the pieces the reference's slip ends as the piece says; they cover the range once."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from random import Random

from attack.answers import AGREED, Answer, Attack, undecided, wrong
from attack.balls_as_numbers import to_fraction
from attack.maps import untrue_cover
from attack.mechanisms import body, file_of
from attack.reference_plane import PlaneSlip, Powers, value
from attack.reference_plane import Unsure as UnsurePlane
from attack.reference_slip import Slip, Unsure
from samples.model_texts import model_text

from gspot_verified import Outcome
from gspot_verified.expansion.series.system import GSpotError
from gspot_verified.mechanisms.fates.box_fate import Fate
from gspot_verified.mechanisms.fates.fate_piece import FatePiece
from gspot_verified.mechanisms.fates.fates import fates
from gspot_verified.mechanisms.fates.fates_result import Fates
from gspot_verified.mechanisms.input.file import parse_mechanism
from gspot_verified.mechanisms.input.mechanism import MechanismError

_MODEL = model_text('"u", "push", "v", "b", "alpha_1", "alpha_2"', "alpha_3")
_POWERS = {"1": (0, 0), "p": (1, 0), "b": (0, 1), "p^2": (2, 0), "p*b": (1, 1), "b^2": (0, 2)}
_WIDTHS = tuple(Fraction(1, n) for n in (1, 2, 2, 5, 5, 20, 20, 100, 1000, 10**6, 10**12))
_PIECES = 10  # that are looked at: most of them such that slip begins
_OFF = 1e-9  # next to a border the reference's own error is larger

Place = Mapping[str, Fraction]
Begins = Callable[[Place], tuple[float, float, float]]
"""p, b and the slip velocity less the surface's at a place."""
Ends = Callable[[Place], tuple[str, float]]
"""How slip from there ends, with the sign of C_1 or 0."""


def attack(random: Random) -> Attack:
    """The model, or a rod."""
    return random.choice((_model, _model, _rod))(random)


def _model(random: Random) -> Attack:
    first = -random.choice((Fraction(1), Fraction(random.randint(2, 20), 8)))
    beta = random.choice((Fraction(3, 2), Fraction(7, 3), Fraction(5, 2), Fraction(random.randint(3, 45), 10)))
    second = -Fraction(random.randint(1, 24), 8)
    polynomials = {
        "alpha_1": _polynomial(random, first), "alpha_2": _polynomial(random, second),
        "alpha_3": _polynomial(random, beta * first), "push": _polynomial(random, _slope(random)),
    }  # fmt: skip
    text = _MODEL
    for name, each in polynomials.items():
        text = text.replace(name, " + ".join(f"({c})*{term}" for term, c in each.items()))
    p = random.choice((Fraction(1, 2), Fraction(1, 4), Fraction(1, 20), Fraction(random.randint(1, 30), 40)))
    mean = second / ((beta - 1) * first) if beta != 1 else Fraction(1)
    b = -p * abs(mean) * random.choice((Fraction(1), Fraction(random.randint(1, 60), 16)))
    u = Fraction(random.randint(0, 40), 8)
    centre = {"p": p, "b": b, "u": u}
    varied = random.choice((("p", "b"), ("p", "b"), ("b", "u"), ("p", "u"), ("b",), ("p",), ("u",)))
    widths = {name: _width(random) * (abs(centre[name]) or 1) for name in varied}
    surface = random.choice((Fraction(0), Fraction(0), u - Fraction(1, 4), u + b / 2))
    tables: list[Powers] = [{_POWERS[t]: float(c) for t, c in each.items()} for each in polynomials.values()]
    slip = PlaneSlip((tables[0], tables[1], tables[2]), tables[3], float(surface))

    def begins(place: Place) -> tuple[float, float, float]:
        return float(place["p"]), float(place["b"]), float(place["u"] - surface)

    def ends(place: Place) -> tuple[str, float]:
        if value(slip.alphas[0], float(place["p"]), float(place["b"])) >= 0:
            raise UnsurePlane("p does not fall")
        return slip.ended([float(place[name]) for name in ("p", "b", "u")])

    return _asked(random, text, {"x": Fraction(0), **centre}, widths, surface, begins, ends)


def _rod(random: Random) -> Attack:
    """The rod with a wrist, with numbers of its own: a spot of Case III as a rule."""
    values = {
        "mu": Fraction(3, 2) + Fraction(random.randint(-2, 4), 32), "J": Fraction(1, 3), "l": Fraction(1),
        "g": Fraction(random.randint(100, 130), 8), "k": Fraction(random.randint(30, 50), 8), "w": 0,
        "d": Fraction(random.randint(4, 12), 8), "tau": Fraction(random.randint(-3, 1), 4),
    } | dict.fromkeys(("c", "s", "q", "push"), Fraction(0))  # fmt: skip
    text = file_of(values, Fraction(5)).replace('th_dot = "1"', 'th_dot = "3"')
    centre = {
        "X": Fraction(0), "X_dot": Fraction(random.choice((5, 5, 3, 1))),
        "th": Fraction(random.randint(66, 88), 100), "th_dot": Fraction(random.randint(25, 40), 10),
    }  # fmt: skip
    varied = random.choice((("th", "th_dot"), ("th", "th_dot"), ("th",), ("th_dot",), ("X_dot", "th_dot")))
    widths = {name: _width(random) / 4 for name in varied}
    flow: list[Slip] = []

    def start(place: Place) -> list[float]:
        if not flow:
            flow.append(Slip(body(values)))
        q = {str(c): float(place.get(str(c), 0)) for c in (*flow[0].body.coordinates, *flow[0].body.velocities)}
        y, v, *_ = flow[0].place(*q.values())
        return [*{**q, "H": -y, "H_dot": -v}.values()]

    def begins(place: Place) -> tuple[float, float, float]:
        state = start(place)
        p, b, u, *_ = flow[0].at(state)[2]
        return p, b, u

    def ends(place: Place) -> tuple[str, float]:
        state = start(place)
        if flow[0].at(state)[2][0] < 1e-3:
            raise Unsure("p is small at the start")
        end = flow[0].ended(state, 0.0)
        return end.what, end.coefficient or 0

    return _asked(random, text, centre, widths, Fraction(0), begins, ends)


def _slope(random: Random) -> Fraction:
    return random.choice((Fraction(0), Fraction(0), Fraction(random.randint(-8, 8), random.choice((3, 8, 16)))))


def _polynomial(random: Random, first: Fraction) -> dict[str, Fraction]:
    return {"1": first} | {term: _slope(random) for term in [*_POWERS][1:] if random.random() < 0.5}


def _width(random: Random) -> Fraction:
    return random.choice(_WIDTHS)


def _asked(
    random: Random,
    text: str,
    centre: Place,
    widths: Place,
    surface: Fraction,
    begins: Begins,
    ends: Ends,
) -> Attack:
    cells = random.choice((1, 2, 3, 6, 8)) * (1 if len(widths) == 2 else 3)
    over = {name: f"{centre[name] - width}..{centre[name] + width}:{cells}" for name, width in widths.items()}
    given = {name: str(number) for name, number in centre.items() if name not in widths}
    budget, seed = random.choice((0, 0, 20)), random.getrandbits(32)

    def ask() -> Answer:
        try:
            found = fates(parse_mechanism(text), given, over, surface_velocity=str(surface), budget=budget)
        except (MechanismError, GSpotError, ValueError) as error:
            return undecided(f"{type(error).__name__}: {str(error)[:40]}")
        return judged(found, centre, begins, ends, Random(seed))

    options = f"surface_velocity='{surface}', budget={budget}"
    return Attack(f"fates(parse_mechanism('''{text}'''), {given}, {over}, {options})", ask)


def judged(found: Fates, centre: Place, begins: Begins, ends: Ends, random: Random) -> Answer:
    """The cover; then slip from some places of some pieces by the reference."""
    boxes = [(tuple(map(to_fraction, piece.lower)), tuple(map(to_fraction, piece.upper))) for piece in found.pieces]
    whole = [(to_fraction(axis.lower), to_fraction(axis.upper)) for axis in found.axes]
    if trouble := untrue_cover(boxes, whole):
        return wrong(f"{trouble}\n{found}")
    known = [number for number, piece in enumerate(found.pieces) if piece.fate is not Fate.UNDECIDED]
    if found.verdict.outcome is Outcome.PROVED and len(known) < len(found.pieces):
        return wrong(f"proved with open pieces\n{found}")
    still = (Fate.NO_SLIP, Fate.OPENS, Fate.PAINLEVE)
    known.sort(key=lambda number: (found.pieces[number].fate in still, random.random()))
    compared = 0
    for number in [*known[: _PIECES - 2], *known[-2:]]:
        place = {**centre, **_place(found, *boxes[number], random)}
        try:
            trouble = untrue(found.pieces[number], begins(place), lambda at=place: ends(at))
        except (Unsure, UnsurePlane):
            continue
        if trouble:
            shown = {name: str(at) for name, at in place.items()}
            return wrong(f"{found.pieces[number]}: from {shown} {trouble}\n{found}")
        compared += 1
    return AGREED if compared else undecided("no piece is settled, or the reference is not sure")


def _place(found: Fates, low: Sequence[Fraction], high: Sequence[Fraction], random: Random) -> dict[str, Fraction]:
    """Inside, or on an edge or a corner."""
    shares = [random.choice((Fraction(0), Fraction(1), Fraction(random.getrandbits(20), 1 << 20))) for _ in low]
    return {axis.name: a + (b - a) * part for axis, a, b, part in zip(found.axes, low, high, shares, strict=True)}


def untrue(piece: FatePiece, start: tuple[float, float, float], ends: Callable[[], tuple[str, float]]) -> str:
    """What is not so of slip from a place of the piece; empty where all is."""
    p, b, slip = start
    kinds = {
        Fate.NO_SLIP: slip < _OFF, Fate.OPENS: p > -_OFF and b > -_OFF and slip > -_OFF,
        Fate.PAINLEVE: p < _OFF and slip > -_OFF,
    }  # fmt: skip
    if piece.fate in kinds:
        return "" if kinds[piece.fate] else f"p = {p}, b = {b}, slip less the surface's velocity {slip}"
    if not (p > -_OFF and b < _OFF and slip > -_OFF):
        return f"there is no slip: p = {p}, b = {b}, slip less the surface's velocity {slip}"
    what, sign = ends()
    expected = {Fate.LIFT_OFF: "lift-off", Fate.STOPS: "slip stops"}.get(piece.fate, "G-spot")
    if what != expected:
        return f"the reference ends by {what}"
    if (piece.fate is Fate.ABOVE and sign < 0) or (piece.fate is Fate.BELOW and sign > 0):
        return f"the reference has C_1 {'>' if sign > 0 else '<'} 0"
    return ""
