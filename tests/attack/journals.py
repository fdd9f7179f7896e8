"""Journals made by hand: columns that nobody found, steps and tubes that nobody proved. Refused, or they change
nothing."""

from __future__ import annotations

import json
import math
import tempfile
from collections.abc import Sequence
from fractions import Fraction
from hashlib import sha256
from itertools import pairwise, product
from pathlib import Path
from random import Random
from typing import Any

import mpmath
import pytest
from attack import reference_theta
from attack.answers import AGREED, Answer, Attack, undecided, wrong
from attack.mechanisms import drawn_body, file_of
from attack.motion import Question, judged, question
from attack.signs import sign_changes, slope
from attack.statements import untrue
from flint import fmpq

from gspot_verified import Outcome
from gspot_verified import sign as sign_on_ranges
from gspot_verified.expansion.series.system import GSpotError
from gspot_verified.mechanisms.input.file import parse_mechanism
from gspot_verified.mechanisms.input.mechanism import MechanismError
from gspot_verified.mechanisms.sweep import sweep_work
from gspot_verified.mechanisms.sweep.sweep import sweep
from gspot_verified.mechanisms.sweep.sweep_piece import NUMBERS, Kind
from gspot_verified.mechanisms.sweep.sweep_result import Sweep
from gspot_verified.mechanisms.sweep.sweep_work import examine, read_line
from gspot_verified.scenes.certified_run import certified_run
from gspot_verified.scenes.scene.file import parse_scene
from gspot_verified.scenes.scene.scene import SceneError
from gspot_verified.signs.zeros.zeros import zeros_on_range

_SIGNS = (
    ("-1..1", "[5/2..11/4]", 1), ("-inf..1", "[5/2..11/4]", -1), ("-1..3", "[3/2..7/4]", -1),
    ("0..inf", "[9/4..5/2]", 1),
    ("-inf..inf", "[5/4..3/2]", -1), ("-2..2", "[7/2..15/4]", 1), ("-inf..0", "[1/4..1/2]", 1),
    ("1..4", "[31/10..33/10]", -1),
)  # fmt: skip


def attack(random: Random) -> Attack:
    """One of the four kinds of journals."""
    return random.choice((_signs, _zeros, _steps, _steps, _tubes, _tubes))(random)


def sliver(random: Random) -> tuple[str, str, int]:
    """A statement that fails in one corner alone, 10^-75 wide: just across a zero at one end of the range of beta."""
    low = Fraction(random.choice((5, 7, 9, 13)), 4) + Fraction(random.randint(-20, 20), 100)
    high = low + Fraction(1, random.choice((8, 64)))
    zeros = [_last_zero(beta) for beta in (low, high)]
    right = min(zeros) + Fraction(1, 10**75)
    left = right - Fraction(random.randint(3, 9), 10)
    sign = slope(min(zeros) - Fraction(1, 100), low if zeros[0] <= zeros[1] else high)
    return f"({left}..{right})", f"({low}..{high})", sign or 1


def _last_zero(beta: Fraction) -> Fraction:
    """The last change of sign below 9, to 10^-85."""
    ends = sign_changes(beta, Fraction(-4), Fraction(9), Fraction(1, 4))[-1]

    def value(tau: mpmath.mpf) -> mpmath.mpf:
        return reference_theta.by_series(Fraction(*mpmath.libmp.to_rational(tau._mpf_)), beta, 1, 100)[0]

    with mpmath.workdps(120):
        root = mpmath.findroot(value, tuple(map(reference_theta.mp, ends)), solver="anderson", tol=1e-180)
        zero = Fraction(int(root * 10**90), 10**90)
    off = Fraction(1, 10**86)
    assert slope(zero - off, beta, 100) == -(slope(zero + off, beta, 100) or 0)
    return zero


def _pieces(random: Random, low: str, high: str) -> list[list[Any]]:
    """Pieces that would prove the statement if they were believed."""
    first, last = (None if end in ("-inf", "inf") else end for end in (low, high))
    mark = random.choice((1, -1))
    found: list[list[Any]] = []
    if first is None:
        found.append(["left", None, "-3", 0])
        first = "-3"
    end = last if last is not None else "8"
    found.append(["sign", first, end, mark])
    if last is None:
        found.append(["right", end, None, 0])
    return found


def _signs(random: Random) -> Attack:
    """The true journal's first line, and columns made up for the whole range."""
    false = random.random() < 0.6
    tau, beta, sign = sliver(random) if false else random.choice(_SIGNS)
    low, high = beta[1:-1].split("..")
    cuts = [Fraction(low), *range(math.floor(Fraction(low)) + 1, math.ceil(Fraction(high))), Fraction(high)]
    lines = []
    for cell in pairwise(map(str, cuts)):
        answer: dict[str, Any] = {"column": [*cell], "pieces": _pieces(random, *tau.strip("()").split(".."))}
        lines.append(json.dumps([*cell, {"witness": ["0", low]} if random.random() < 0.1 else answer]))
    line = "\n".join(lines)

    def ask() -> Answer:
        with tempfile.TemporaryDirectory() as folder:
            place, honest = Path(folder) / "forged.journal", Path(folder) / "honest.journal"
            sign_on_ranges(tau, beta, sign, budget=1, journal=honest)
            if not honest.exists():
                return undecided("settled without a journal")
            place.write_text(f"{honest.read_text().splitlines()[0]}\n{line}\n")
            try:
                found = sign_on_ranges(tau, beta, sign, budget=40, journal=place)
            except ValueError:
                return AGREED
            if found.verdict.outcome is not Outcome.PROVED:
                return AGREED
            trouble = (
                "it fails in a corner" if false else untrue(found.statement.to_json() | {"kind": "sign", "sign": sign})
            )
            return wrong(f"{found.verdict}\n  {trouble}") if trouble else AGREED

    return Attack(f"sign('{tau}', '{beta}', {sign}) with a journal that holds {line}", ask)


def _zeros(random: Random) -> Attack:
    """A column with too many or too few zeros."""
    low, high = random.choice((("31/10", "13/4"), ("5/4", "3/2"), ("9/4", "5/2"), ("17/4", "9/2")))
    count = random.choice((0, 1, 2, 3, 4))
    pieces: list[list[Any]] = [["left", None, "-2", 0]]
    for k in range(2 * count + 1):
        ends = [str(-2 + k), str(-1 + k)]
        pieces.append(["monotone" if k % 2 else "sign", *ends, 1 if (k // 2) % 2 else -1])
    pieces.append(["right", pieces[-1][2], None, 0])
    line = json.dumps([low, high, {"column": [low, high], "pieces": pieces}])

    def ask() -> Answer:
        with tempfile.TemporaryDirectory() as folder:
            place, honest = Path(folder) / "forged.journal", Path(folder) / "honest.journal"
            true = zeros_on_range(f"[{low}..{high}]", budget=60, journal=honest)
            place.write_text(f"{honest.read_text().splitlines()[0]}\n{line}\n")
            try:
                found = zeros_on_range(f"[{low}..{high}]", budget=60, journal=place)
            except (ValueError, ArithmeticError):
                return AGREED
            if found.statement is None:
                return AGREED
            if str(found.statement) != str(true.statement):
                return wrong(f"from the forged journal: {found}\n  without it: {true}")
            tubes = [tube for column in found.columns for tube in column.tubes()]
            honest_tubes = [tube for column in true.columns for tube in column.tubes()]
            if any(not any(a < d and c < b for c, d in tubes) for a, b in honest_tubes):
                return wrong(f"the zero in {honest_tubes} lies outside of the tubes {tubes} of the forged journal")
            return AGREED

    return Attack(f"zeros_on_range('[{low}..{high}]') with a journal that holds {line}", ask)


def _steps(random: Random) -> Attack:
    """The journal of a true run with some of its numbers changed, and its digests made anew."""
    asked = question(random)
    changes = [
        (random.random(), random.random(), random.choice((0.0, 0.5, 2.0, 1e3, 1e-3, -1.0, 1.0001))) for _ in range(3)
    ]
    text = f"the run of '''{asked.text}''' with a journal of which (line, number, factor) {changes} were changed"
    return Attack(text, lambda: _judged_steps(asked, changes))


def _judged_steps(asked: Question, changes: list[tuple[float, float, float]]) -> Answer:
    try:
        scene = parse_scene(asked.text)
    except SceneError:
        return undecided("no such scene")
    with tempfile.TemporaryDirectory() as folder:
        place = Path(folder) / "run.journal"
        true = certified_run(scene, route="integrator", journal=place, budget=800)
        head, *lines = place.read_text().splitlines()
        data = [json.loads(line)[1] for line in lines]
        for line, number, factor in changes:
            if data:
                _change(data[int(line * len(data))], number, factor)
        place.write_text("\n".join([head, *sealed(data), ""]))
        try:
            found = certified_run(scene, route="integrator", journal=place, budget=800)
        except (ValueError, TypeError, KeyError) as error:
            return AGREED if isinstance(error, ValueError) else wrong(f"{type(error).__name__}: {error}")
    if found.verdict.outcome is Outcome.UNDECIDED:
        return AGREED
    if true.verdict.outcome is Outcome.PROVED:
        if found.fate != true.fate:
            return wrong(f"from the forged journal: {found}\n  without it: {true}")
        apart = [
            (a, b) for a, b in zip(found.events, true.events, strict=True) if a.lower > b.upper or b.lower > a.upper
        ]
        apart = [(a, b) for a, b in apart if a.name != "impact without collision"]
        return wrong(f"disjoint brackets: {apart}") if apart else AGREED
    return judged(asked)


def sealed(data: Sequence[Any]) -> list[str]:
    """Lines of a journal of steps, each with the digest that it would have."""
    last, lines = "", []
    for each in data:
        last = sha256(f"{last}{json.dumps(each, sort_keys=True)}".encode()).hexdigest()[:16]
        lines.append(json.dumps([last, each]))
    return lines


def _tubes(random: Random) -> Attack:
    """The journal of a sweep with tubes of another spot or cell, changed ones, or none, and the right digest."""
    values, slip = drawn_body(random)
    values["k"] = Fraction(0)
    which = random.choice(("mu", "g", "tau", "l", "J"))
    centre = values[which]
    width = abs(centre or 1) * random.choice((Fraction(1, 2), Fraction(1, 10)))
    text = file_of({**values, which: "par"}, slip, {"par": str(centre)})
    over, seed = f"{centre - width}..{centre + width}:{random.choice((2, 3, 6))}", random.getrandbits(32)
    asked = f"sweep(parse_mechanism('''{text}'''), {{'par': '{over}'}}, spot=1)"
    return Attack(f"{asked} with forged tubes, seed {seed}", lambda: _judged_tubes(text, over, Random(seed)))


def _judged_tubes(text: str, over: str, random: Random) -> Answer:
    mechanism = parse_mechanism(text)
    with tempfile.TemporaryDirectory() as folder:
        places = [Path(folder) / name for name in ("one", "two")]
        try:
            true = sweep(mechanism, {"par": over}, spot=1, journal=places[0])
        except (MechanismError, GSpotError, ValueError) as error:
            return undecided(f"{type(error).__name__}: {str(error)[:40]}")
        try:
            sweep(mechanism, {"par": over}, spot=2, journal=places[1])
        except (MechanismError, GSpotError, ValueError):
            places[1] = places[0]
        head, *lines = places[0].read_text().splitlines()
        portions = [json.loads(line) for line in lines]
        others = [cell for line in places[1].read_text().splitlines()[1:] for cell in json.loads(line)[2]]
        for _ in range(random.randint(1, 4)):
            portion = random.choice(portions)
            portion[2] = _forged_cells(portion[2], others, random)
        place = Path(folder) / "forged"
        place.write_text("\n".join([head, *map(json.dumps, portions), ""]))
        with pytest.MonkeyPatch.context() as patch:
            # As if the digest were that of the pieces which come out along the forged tubes.
            along = lambda question, work, text: examine(question, work, read_line(text)[2])  # noqa: E731
            patch.setattr(sweep_work, "proved_again", along)
            try:
                found = sweep(mechanism, {"par": over}, spot=1, journal=place)
            except ValueError:
                return AGREED
    trouble = contradiction(true, found, random)
    return wrong(f"{trouble}\n{found}\n  without the journal: {true}") if trouble else AGREED


def _forged_cells(cells: list[Any], others: list[Any], random: Random) -> list[Any]:
    """The choices of each cell, changed in one way."""
    cells = json.loads(json.dumps(cells))
    cell = random.randrange(len(cells))
    match random.randrange(6):
        case 0:
            cells[cell] = random.choice(others)
        case 1:
            cells = json.loads(json.dumps(others))
        case 2:
            cells[cell] = [None if random.random() < 0.4 else tube for tube in cells[cell]]
        case 3:
            random.shuffle(cells[cell])
        case 4:
            cells[cell] = [*cells[cell][:1], *cells[cell]]
        case _:
            tubes = [tube for tube in cells[cell] if tube is not None]
            if tubes:
                _change(random.choice(tubes), random.random(), random.choice((2, -1, 0, 1.5)))
    return cells


def contradiction(true: Sweep, found: Sweep, random: Random) -> str:
    """Where two sweeps of one question say different things of one place; empty: nowhere that was looked at."""
    (axis,) = true.axes
    ends = [end for each in (true, found) for piece in each.pieces for end in (piece.lower[0], piece.upper[0])]
    places = [axis.lower + (axis.upper - axis.lower) * fmpq(random.getrandbits(30), 1 << 30) for _ in range(20)]
    for place in [*places, *ends]:
        for one, two in product(*([p for p in each.pieces if p.holds([place])] for each in (true, found))):
            if one.kind is two.kind is Kind.SETTLED and one.answer != two.answer:
                return f"par = {place}: {one.answer} and {two.answer}"
            for name in NUMBERS:
                balls = [number.to_ball() for number in (one.number(name), two.number(name)) if number is not None]
                if len(balls) == 2 and not balls[0].overlaps(balls[1]):
                    return f"par = {place}: {name} in {balls[0]} and in {balls[1]}"
    return ""


def _change(data: Any, number: float, factor: float) -> None:
    """Multiply one number somewhere in the line."""
    places: list[tuple[Any, Any]] = []

    def visit(node: Any) -> None:
        for key, child in node.items() if isinstance(node, dict) else enumerate(node):
            if isinstance(child, dict | list):
                visit(child)
            elif isinstance(child, int | float) and not isinstance(child, bool):
                places.append((node, key))

    visit(data)
    if places:
        node, key = places[int(number * len(places))]
        node[key] = type(node[key])(node[key] * factor)
