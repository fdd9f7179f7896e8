"""Journals put together from two honest ones, of other ranges, other starts, or an earlier budget: lines of both, in
any order, twice, cut in the midst of one, with the other's first line. Refused, or what is concluded stays."""

from __future__ import annotations

import json
import tempfile
from collections.abc import Callable
from dataclasses import dataclass, replace
from fractions import Fraction
from pathlib import Path
from random import Random
from typing import Any

from attack.answers import AGREED, Answer, Attack, undecided, wrong
from attack.journals import contradiction, sealed, sliver
from attack.mechanisms import drawn_body, file_of
from attack.motion import question
from attack.statements import untrue

from gspot_verified import Outcome
from gspot_verified import sign as sign_on_ranges
from gspot_verified.expansion.series.system import GSpotError
from gspot_verified.mechanisms.input.file import parse_mechanism
from gspot_verified.mechanisms.input.mechanism import MechanismError
from gspot_verified.mechanisms.sweep.sweep import sweep
from gspot_verified.scenes.certified_run import certified_run
from gspot_verified.scenes.scene.file import parse_scene
from gspot_verified.scenes.scene.scene import SceneError
from gspot_verified.signs.zeros.zeros import zeros_on_range

_TRUE = (
    ("[3/2..7/4]", (("-inf..0", -1), ("1..4", 1), ("-1/2..0", -1))),
    ("[5/4..3/2]", (("-inf..0", -1), ("[0..1/2]", -1), ("-1/2..0", -1))),
    ("[7/2..15/4]", (("-1..1", -1), ("-inf..1", -1), ("-inf..0", -1), ("[0..1/2]", -1))),
    ("[31/10..33/10]", (("-1..1", -1), ("-inf..1", -1), ("-1..3", -1), ("-2..2", -1), ("[0..1/2]", -1))),
    ("(3..13/4]", (("-1..1", -1), ("-inf..1", -1), ("-1..3", -1), ("-2..2", -1), ("-1/2..0", -1))),
    ("[9/4..5/2]", (("[0..1/2]", 1),)),
    ("[11/4..3)", (("1..4", -1),)),
)
"""Ranges of beta, and on each some ranges of tau with the sign there: they are proved by columns."""
_COUNTED = ("[31/10..13/4]", "[5/4..3/2]", "[9/4..5/2]", "[17/4..9/2]", "(2..5/2]", "(3..7/2]", "[5/2..3)", "(2..4)")
_NEAR_ONE = (Fraction(1, 3), Fraction(1, 7), Fraction(-1, 5))

Ask = Callable[[Path | None], Any]
"""Puts a question, with a journal or without."""


@dataclass(frozen=True)
class _Pair:
    """``asked`` is put with the merged journal; ``other`` makes the second one. ``trouble``: (without a journal, with
    the merged one, random) -> in what they contradict each other, or None: they cannot be compared."""

    text: str
    asked: Ask
    other: Ask
    trouble: Callable[[Any, Any, Random], str | None]
    sealed: bool = False


def attack(random: Random) -> Attack:
    """Two questions of one kind, and a way to merge their journals."""
    pair = random.choice((_signs, _signs, _zeros, _sweeps, _steps))(random)
    seed = random.getrandbits(32)
    return Attack(f"{pair.text}; the journals merged with Random({seed})", lambda: _judged(pair, Random(seed)))


def _judged(pair: _Pair, random: Random) -> Answer:
    with tempfile.TemporaryDirectory() as folder:
        one, two, place = (Path(folder) / name for name in ("one", "two", "merged"))
        try:
            true = pair.asked(one)
        except (MechanismError, GSpotError, SceneError, ValueError) as error:
            return undecided(f"{type(error).__name__}: {str(error)[:40]}")
        try:
            pair.other(two)
        except (MechanismError, GSpotError, SceneError, ValueError):
            two = one
        if not (one.exists() and two.exists()):
            return undecided("settled without a journal")
        data, foreign = merged(one.read_bytes(), two.read_bytes(), random, pair.sealed)
        place.write_bytes(data)
        try:
            found = pair.asked(place)
        except ValueError:
            return AGREED
        if foreign:
            return wrong(f"a journal with the first line {data.splitlines()[0][:300]!r} was taken")
    trouble = pair.trouble(true, found, random)
    if trouble is None:
        return undecided("one of the two is undecided")
    return (
        wrong(f"{trouble}\n{found}\n  without the journal: {true}\n  journal: {data[:4000]!r}") if trouble else AGREED
    )


def merged(one: bytes, two: bytes, random: Random, seals: bool = False) -> tuple[bytes, bool]:
    """The merged file, and whether its first line is that of another question or of other sources."""
    (head, *lines), (other_head, *others) = one.splitlines(), two.splitlines()
    both = [*lines, *others]
    match random.randrange(6):
        case 0:
            both = [line for pair in zip(lines, others, strict=False) for line in pair]
        case 1:
            both = both[::-1]
        case 2:
            random.shuffle(both)
        case 3:
            both = [random.choice(both) for _ in range(2 * len(both))] if both else []
        case 4:
            both = [*others, other_head, *lines]
        case _:
            both = [*others, *lines[: len(lines) // 2]]
    if seals and random.random() < 0.7:
        both = [line.encode() for line in sealed([json.loads(line)[1] for line in both if line != other_head])]
    first, chance = head, random.random()
    if chance < 0.1:
        first = other_head
    elif chance < 0.2:
        first = json.dumps(json.loads(head) | {"sources": "0" * 64}, sort_keys=True).encode()
    elif chance < 0.3:
        first = head[: -random.randint(2, 5)] + b"}"
    data = b"\n".join([first, *both, b""])
    if random.random() < 0.3:
        data = data[: -random.randint(1, max(1, min(200, len(data) - len(first) - 2)))]
    ends = random.random()
    if ends < 0.05:
        data, first = data.replace(b"\n", b"\r\n"), first + b"\r"
    elif ends < 0.1:
        data += b"\n\n"
    return data, first != head


def _signs(random: Random) -> _Pair:
    """The same range of beta with another range of tau; a false statement with lines of a true one; or the same
    question with a small budget."""
    beta, known = random.choice(_TRUE)
    tau, mark = random.choice(known)
    way = random.randrange(4)
    (other, sign), budget = random.choice(known), 60
    if way == 0:
        (other, sign), budget = (tau, mark), random.choice((1, 3))
    elif way == 1:
        tau, beta, mark = sliver(random)
        low, high = (Fraction(end) for end in tau[1:-1].split(".."))
        other, sign = f"({low}..{high - (high - low) / random.choice((20, 10**6))})", mark
    elif way == 2:
        more_beta = random.choice(_TRUE)
        other, sign = random.choice(more_beta[1])
    more = (other, more_beta[0] if way == 2 else beta, sign)

    def trouble(true: Any, found: Any, _: Random) -> str | None:
        if found.verdict.outcome is Outcome.PROVED:
            if way == 1:
                return "it fails in a corner"
            stated = found.statement.to_json() | {"kind": "sign", "sign": mark}
            if against := untrue(stated):
                return against
        outcomes = {each.verdict.outcome for each in (true, found)}
        if Outcome.UNDECIDED in outcomes and len(outcomes) > 1:
            return None
        return "" if len(outcomes) == 1 else "two outcomes"

    return _Pair(
        f"sign('{tau}', '{beta}', {mark}, budget=60) with lines of sign{more}, budget {budget}",
        lambda place: sign_on_ranges(tau, beta, mark, budget=60, journal=place),
        lambda place: sign_on_ranges(*more, budget=budget, journal=place),
        trouble,
    )


def _zeros(random: Random) -> _Pair:
    """Another range of beta; or the columns of a sign on the same."""
    beta, other = random.choice(_COUNTED), random.choice(_COUNTED)
    of_sign = random.random() < 0.4

    def second(place: Path | None) -> Any:
        if of_sign:
            return sign_on_ranges("1/10..1/5", beta, -1, budget=30, journal=place)
        return zeros_on_range(other, budget=60, journal=place)

    def trouble(true: Any, found: Any, _: Random) -> str | None:
        if found.statement is None or true.statement is None:
            return None
        if str(found.statement) != str(true.statement):
            return "two statements"
        tubes, own = ([tube for column in each.columns for tube in column.tubes()] for each in (found, true))
        lost = [(a, b) for a, b in own if not any(a < d and c < b for c, d in tubes)]
        return f"the zeros in {lost} lie outside of all tubes" if lost else ""

    what = f"sign on {beta}" if of_sign else f"zeros_on_range('{other}')"
    return _Pair(
        f"zeros_on_range('{beta}', budget=60) with lines of {what}",
        lambda place: zeros_on_range(beta, budget=60, journal=place),
        second,
        trouble,
    )


def _sweeps(random: Random) -> _Pair:
    """Another range, another spot, more digits, or another number of the same body."""
    values, slip = drawn_body(random)
    values["k"] = Fraction(0)
    which = random.choice(("mu", "g", "tau", "l", "J"))
    centre = values[which]
    width = abs(centre or 1) * Fraction(1, random.choice((3, 20)))
    changed = {**values, which: "par"}
    text = file_of(changed, slip, {"par": str(centre)})
    way = random.randrange(4)
    if way == 0:
        changed["c"] = values["c"] + Fraction(1, 50)
    low, high = centre - width, centre + width
    cells = random.choice((3, 33, 33))  # 32 in one line
    over, other = f"{low}..{high}:{cells}", f"{low}..{high + (width if way == 1 else 0)}:{cells}"
    more = {"digits": 9} if way == 2 else {}
    spot = 2 if way == 3 else 1
    other_text = file_of(changed, slip, {"par": str(centre)})
    return _Pair(
        f"sweep(parse_mechanism('''{text}'''), {{'par': '{over}'}}, spot=1) with lines of that over {other}, "
        f"spot {spot}, {more}, c = {changed['c']}",
        lambda place: sweep(parse_mechanism(text), {"par": over}, spot=1, journal=place),
        lambda place: sweep(parse_mechanism(other_text), {"par": other}, spot=spot, journal=place, **more),
        contradiction,
    )


def _steps(random: Random) -> _Pair:
    """The run from another start, to another end, with another epsilon."""
    asked = question(random)
    factor = 1 + random.choice(_NEAR_ONE)
    ways = (
        replace(asked, until=asked.until * factor),
        replace(asked, epsilon=asked.epsilon * factor),
        replace(asked, start=(*asked.start[:5], asked.start[5] + factor)),
        replace(asked, start=(asked.start[0] * factor, *asked.start[1:])),
    )
    other = random.choice(ways)

    def run(text: str) -> Ask:
        return lambda place: certified_run(parse_scene(text), route="integrator", journal=place, budget=800)

    def trouble(true: Any, found: Any, _: Random) -> str | None:
        outcomes = {each.verdict.outcome for each in (true, found)}
        if Outcome.UNDECIDED in outcomes:
            return None if len(outcomes) > 1 else ""
        if len(outcomes) > 1 or found.fate != true.fate or len(found.events) != len(true.events):
            return "two answers"
        pairs = [pair for pair in zip(found.events, true.events, strict=True) if "impact" not in pair[0].name]
        apart = [(a, b) for a, b in pairs if a.lower > b.upper or b.lower > a.upper]
        return f"disjoint brackets: {apart}" if apart else ""

    return _Pair(
        f"the run of '''{asked.text}''' with lines of that of '''{other.text}'''",
        run(asked.text),
        run(other.text),
        trouble,
        sealed=True,
    )
