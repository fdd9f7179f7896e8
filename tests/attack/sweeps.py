"""Sweeps of the G-spot of a random body over one parameter: at random values inside, at the seams of cells and at the
brackets' ends the reference's own spots must have what the piece says. Narrow ranges, one cell, ranges with folds."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from random import Random
from typing import Any

import mpmath
import sympy
from attack.answers import AGREED, Answer, Attack, undecided, wrong
from attack.balls_as_numbers import holds, to_fraction
from attack.mechanisms import body, case_of, drawn_body, file_of
from attack.reference_mechanism import Body, Plane

from gspot_verified import Outcome
from gspot_verified.expansion.series.system import GSpotError
from gspot_verified.mechanisms.input.file import parse_mechanism
from gspot_verified.mechanisms.input.mechanism import MechanismError
from gspot_verified.mechanisms.sweep.sweep import sweep
from gspot_verified.mechanisms.sweep.sweep_piece import Kind, SweepPiece
from gspot_verified.mechanisms.sweep.sweep_result import Sweep

_SLACK = mpmath.mpf(10) ** -15
_PLACES = 5

Spots = tuple[list[dict[str, Any]], bool]
"""The spots, and whether the reference is sure that they are all."""


@dataclass(frozen=True)
class _At(Body):
    """The body at one value of each parameter; its functions are made once for all values."""

    known: dict[str, sympy.Expr]
    place: dict[str, sympy.Rational]

    def functions(self) -> dict[str, sympy.Expr]:
        return {key: sympy.sympify(each).subs(self.place) for key, each in self.known.items()}


def attack(random: Random) -> Attack:
    """One parameter of a random body varies."""
    values, slip = drawn_body(random)
    values["k"] = Fraction(0)
    which = random.choice(("mu", "mu", "g", "tau", "l", "J", "push", "idle"))
    centre = values.get(which, Fraction(1))
    width = abs(centre) * random.choice((Fraction(1, 2), Fraction(1, 5), Fraction(1, 10**6), Fraction(1, 10**40)))
    low, high = centre - width, centre + width * random.choice((1, 2))
    cells, number = random.choice((1, 1, 2, 7, 16)), random.choice((1, 1, 2))
    if low == high:
        high += 1
    text = file_of({**values, which: "par"} if which in values else values, slip, {"par": str(centre)})
    seed = random.getrandbits(32)
    over = f"{low}..{high}:{cells}"
    question = f"sweep(parse_mechanism('''{text}'''), {{'par': '{over}'}}, spot={number})"

    def ask() -> Answer:
        try:
            found = sweep(parse_mechanism(text), {"par": over}, spot=number)
        except (MechanismError, GSpotError, ValueError) as error:
            return undecided(f"{type(error).__name__}: {str(error)[:40]}")
        plain = body({**values, which: "par"} if which in values else values)
        return judged(found, plain, slip, Random(seed))

    return Attack(question, ask)


def judged(found: Sweep, plain: Body, slip: Fraction, random: Random) -> Answer:
    """The pieces cover the range; the reference's spots at some values."""
    ends = [(to_fraction(piece.lower[0]), to_fraction(piece.upper[0])) for piece in found.pieces]
    (axis,) = found.axes
    whole = to_fraction(axis.lower), to_fraction(axis.upper)
    seams = all(one[1] == two[0] for one, two in itertools.pairwise(ends))
    if ends[0][0] != whole[0] or ends[-1][1] != whole[1] or not seams or any(low >= high for low, high in ends):
        return wrong(f"the pieces do not cover the range: {ends}")
    all_spots = spots_of(plain, slip, random)

    def spots(at: Fraction) -> tuple[list[dict[str, Any]], bool]:
        return all_spots({"par": at})

    places = [random.choice(ends)[random.randrange(2)] for _ in range(2)]
    places += [whole[0] + (whole[1] - whole[0]) * Fraction(random.getrandbits(40), 1 << 40) for _ in range(_PLACES)]
    for piece, (low, high) in zip(found.pieces, ends, strict=True):
        if piece.kind is Kind.CROSSING and len(places) < 2 * _PLACES:
            places += [low, high]
    compared = 0
    for place in places:
        for piece, (low, high) in zip(found.pieces, ends, strict=True):
            if low <= place <= high and piece.kind in (Kind.SETTLED, Kind.CROSSING):
                here, sure = spots(place)
                trouble = untrue_piece(piece, here)
                if trouble and sure:
                    return wrong(f"par = {place}: {trouble}\n{found}\n  reference: {shown(here)}")
                compared += not trouble
    trouble = _crossings(found, spots) or _folds(found, spots)
    if trouble:
        return wrong(f"{trouble}\n{found}")
    if not compared:
        return undecided("no settled piece at the places")
    return AGREED if found.verdict.outcome is Outcome.PROVED else undecided(f"holds: {found.verdict.reason}")


def spots_of(plain: Body, slip: Fraction, random: Random) -> Callable[[Mapping[str, Fraction]], Spots]:
    """What gives the reference's spots at values of the parameters."""
    known = plain.functions()
    fixed = (mpmath.mpf(0), mpmath.mpf(slip.numerator) / slip.denominator)
    fields = (
        plain.coordinates,
        plain.velocities,
        plain.kinetic,
        plain.potential,
        plain.forces,
        plain.x,
        plain.y,
        plain.mu,
    )

    def spots(at: Mapping[str, Fraction]) -> Spots:
        place = {name: sympy.Rational(value.numerator, value.denominator) for name, value in at.items()}
        return Plane(_At(*fields, known, place), fixed).spots(random, 0)

    return spots


def shown(spots: Sequence[dict[str, Any]]) -> str:
    return str([{name: mpmath.nstr(value, 12) for name, value in spot.items()} for spot in spots])


def matching(piece: SweepPiece, spots: Sequence[dict[str, Any]]) -> list[dict[str, Any]]:
    """The spots whose numbers lie in the piece's."""
    found = []
    for spot in spots:
        spot = {**spot, "slip_velocity": spot["u"]}
        spot["beta"] = spot["alpha_3"] / spot["alpha_1"] if spot["alpha_1"] else None
        names = ("alpha_1", "alpha_2", "alpha_3", "beta", "slip_velocity")
        balls = {name: piece.number(name) for name in names}
        if all(ball is None or spot[name] is None or holds(ball.to_ball(), spot[name], _SLACK * (1 + abs(spot[name])))
               for name, ball in balls.items()):  # fmt: skip
            found.append(spot)
    return found


def untrue_piece(piece: SweepPiece, spots: Sequence[dict[str, Any]]) -> str:
    """What the piece says against the spots at a place in it."""
    match = matching(piece, spots)
    if not match:
        return f"no spot has the numbers of the piece {piece.to_json()}"
    if piece.kind is not Kind.SETTLED:
        return ""
    cases = [case_of(*(spot[name] for name in ("alpha_1", "alpha_2", "alpha_3"))) for spot in match]
    if all(case not in (None, piece.case) for case in cases):
        return f"Case {piece.case}, the reference {cases}"
    if piece.case == "III" and cases == ["III"]:
        with mpmath.workdps(60):  # beta may be next to an integer
            sign = int(mpmath.sign(mpmath.rgamma(-match[0]["alpha_3"] / match[0]["alpha_1"])))
        if sign and (piece.lift_off_sign, piece.impact_sign) != (-sign, sign):
            return f"the sides {piece.lift_off_sign}, {piece.impact_sign} with 1/Gamma(-beta) of the sign {sign}"
    return ""


def _crossings(found: Sweep, spots: Callable[[Fraction], tuple[list[dict[str, Any]], bool]]) -> str:
    """Where a quantity passes 0 exactly once it has both signs at the ends of its bracket."""
    for crossing in found.crossings:
        if not crossing.proved:
            continue
        for end, sign in ((crossing.lower, -crossing.direction), (crossing.upper, crossing.direction)):
            pieces = [piece for piece in found.pieces if piece.passing is not None and piece.holds([end])]
            here, _ = spots(to_fraction(end))
            signs = [sign_of(value_in(spot, crossing.quantity)) for piece in pieces for spot in matching(piece, here)]
            if len(signs) == 1 and signs[0] == -sign:
                return f"{crossing.quantity} at par = {end} has not the sign {sign}"
    return ""


def value_in(spot: Mapping[str, Any], quantity: str) -> Any:
    """A quantity, or a difference of two, at a spot."""
    one, _, two = quantity.partition(" - ")
    first = spot["alpha_3"] / spot["alpha_1"] if one == "beta" else spot[one]
    return first - (0 if not two else spot[two] if two in spot else mpmath.mpf(int(two)))


def sign_of(value: Any) -> int:
    """0 also for what is too small to be told."""
    return 0 if abs(value) < 1e-25 else int(mpmath.sign(value))


def _folds(found: Sweep, spots: Callable[[Fraction], tuple[list[dict[str, Any]], bool]]) -> str:
    """Next to a fold two spots more on its open side than behind it."""
    for fold in found.folds:
        low, high = map(to_fraction, fold.bounds())
        away = abs(to_fraction(fold.reach) - (low if fold.opens < 0 else high)) / 1000
        inside, behind = (high + away, low - away) if fold.opens > 0 else (low - away, high + away)
        (more, sure), (less, sure_too) = spots(inside), spots(behind)
        if sure and sure_too and len(more) != len(less) + 2:
            return f"{len(more)} spots on the open side of the fold {fold}, {len(less)} behind it"
    return ""
