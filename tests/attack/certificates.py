"""Mutants of true certificates, sealed anew: the checker may accept one only if what it then states is true."""

from __future__ import annotations

import copy
import json
from fractions import Fraction
from functools import cache
from pathlib import Path
from random import Random
from typing import Any

from attack.answers import AGREED, Answer, Attack, undecided, wrong
from attack.statements import untrue
from must_reject.mutate import GOOD, Lines, checker, text_of

from gspot_verified import Range, sign
from gspot_verified.certificates.text import certificate_text
from gspot_verified.signs.zeros.zeros import zeros_on_range

_PROOFS = Path(__file__).resolve().parents[2] / "proofs"
_FORCES = ("force_5_2", "lift_off_5_2")
_FILES = ("iwc_0_1", "zeros_1_13", *_FORCES, "zeros_4_5")


def attack(random: Random) -> Attack:
    """One to three changes of a true certificate."""
    name = random.choice((*GOOD, *_FILES, *_FORCES * 2, *["zeros_4_5"] * 3, "fresh sign", "fresh zeros"))
    lines = copy.deepcopy(_lines(name))
    kept = canonical_statement(lines)
    if name in _FORCES and random.random() < 0.6:
        _retune(lines[0]["statement"], random)
        text = text_of(lines)
        return Attack(f"check_text({text!r}), from {name}", lambda: _judged(text, lines, kept))
    if len(lines) > 12:  # a part of the columns is checked sooner, and cover is mutated elsewhere
        _shorten(lines, random)
        kept = canonical_statement(lines)
    for _ in range(random.choice((1, 1, 2, 3))):
        random.choice((_end, _end, _deep, _dips, _mark, _statement, _statement, _drop, _kind, _column))(lines, random)
    text = text_of(lines)
    return Attack(f"check_text({text!r}), from {name}", lambda: _judged(text, lines, kept))


def canonical_statement(lines: Lines) -> str:
    """The statement as text."""
    return json.dumps(lines[0]["statement"], sort_keys=True)


@cache
def _source(name: str) -> str:
    if name == "fresh sign":
        found = sign("-3..5/2", "[5/2..11/4]", 1)
        found = found if found.columns else sign("-inf..-1/2", "[5/2..11/4]", -1)
        assert found.proved_statement is not None
        return certificate_text(found.proved_statement, found.columns)
    if name == "fresh zeros":
        zeros = zeros_on_range(Range.parse("[31/10..13/4]", "beta"))
        assert zeros.statement is not None
        return certificate_text(zeros.statement, zeros.columns)
    return (_PROOFS / f"{name}.cert").read_text(encoding="utf-8")


def _lines(name: str) -> Lines:
    if name in GOOD:
        return GOOD[name]
    return [json.loads(line) for line in _source(name).splitlines()[:-1]]


def _shorten(lines: Lines, random: Random) -> None:
    """A few neighbouring columns, and the statement over them."""
    first = random.randrange(1, len(lines) - 2)
    del lines[first + 3 :]
    del lines[1:first]
    statement = lines[0]["statement"]
    low, high = lines[1]["beta"][0], lines[-1]["beta"][1]
    if statement["kind"] in ("sign", "zeros", "slow_zeros"):
        statement["beta"] = f"({low}, {high})"
    if statement["kind"] == "zeros":
        cells = range(int(Fraction(low) // 1), int(-(-Fraction(high) // 1)))
        statement["counts"] = [pair for pair in statement["counts"] if pair[0] in cells]


def _rationals(lines: Lines) -> list[tuple[list[Any], int]]:
    found: list[tuple[list[Any], int]] = []
    for column in lines[1:]:
        found += [(column["beta"], k) for k in range(2)]
        for piece in column["pieces"]:
            found += [(piece, k) for k in range(1, len(piece)) if isinstance(piece[k], str)]
    return [(where, k) for where, k in found if where[k] not in ("inf", "-inf")]


def _end(lines: Lines, random: Random) -> None:
    """A number moves, by little or much; at times its neighbours with it."""
    places = _rationals(lines)
    if not places:
        return
    where, k = random.choice(places)
    old = where[k]
    by = Fraction(random.choice((-1, 1)), random.choice((10**40, 2**20, 64, 8, 2, 1)))
    new = str(Fraction(old) + by)
    everywhere = random.random() < 0.7
    for other, j in places if everywhere else [(where, k)]:
        if other[j] == old:
            other[j] = new


def _deep(lines: Lines, random: Random) -> None:
    """All numbers of one value get a long denominator."""
    places = _rationals(lines)
    if not places:
        return
    where, k = random.choice(places)
    old, shift = where[k], Fraction(random.choice((-1, 1)), 10 ** random.choice((25, 40, 300)) + 7)
    for other, j in places:
        if other[j] == old and other[0] not in ("0", "-inf"):
            other[j] = str(Fraction(old) + shift)


def _dips(lines: Lines, random: Random) -> None:
    """Dips elsewhere, at points with long denominators, for an epsilon up to which they prove nothing."""
    pieces = [piece for column in lines[1:] for piece in column["pieces"] if piece[0] == "dip"]
    if not pieces:
        return _end(lines, random)
    deep = 10 ** random.choice((1, 31, 90)) + 7
    first = Fraction(random.randint(10, 25), 10) + Fraction(1, deep)
    ends = [
        str(first),
        str(first * random.choice((Fraction(9, 7), Fraction(13, 10), Fraction(5, 4))) + Fraction(1, deep)),
    ]
    for piece in pieces:
        piece[1:] = ends
    epsilon = random.choice((33, 100, 1000, 10**6))
    eta = next(n for n in range(1, 200) if 2 * n**3 >= epsilon)
    lines[0]["statement"] |= {"epsilon": str(epsilon), "eta": str(eta)}
    return None


def _retune(statement: dict[str, Any], random: Random) -> None:
    """Other forces, C_1, beta; epsilon next to where the deviation at the level is the mean force, or far from it."""
    first = -Fraction(random.randint(1, 12), random.choice((3, 5)))
    beta = random.choice((Fraction(5, 2),) * 6 + (Fraction(12, 5), Fraction(7, 2), Fraction(5001, 2000)))
    second = -Fraction(random.randint(1, 30), 7) * random.choice((1, 1, 1, -1))
    c1 = abs(Fraction(statement["c1"])) * random.choice((-1, 1)) * Fraction(random.randint(1, 40), 9)
    level = Fraction(statement["level"]) * random.choice((1, 1, 1, Fraction(99, 100), Fraction(101, 100), 2))
    deviation = float(abs(c1) / (beta * -first) * beta * level) * float(-first / 2) ** (-float(beta - 1) / 3)
    border = abs(float(second / (first * (beta - 1))) / deviation) ** (3 / (2 * float(beta - 1)))
    wide = random.choice((1, 1 + 1e-9, 1 - 1e-9, 1.5, 3, 1 / 3, 100))
    alpha = [first, second, beta * first]
    statement |= {"alpha": list(map(str, alpha)), "c1": str(c1), "level": str(level)}
    statement["epsilon"] = str(Fraction(border * wide).limit_denominator(10**12) or 1)


def _mark(lines: Lines, random: Random) -> None:
    pieces = [piece for column in lines[1:] for piece in column["pieces"] if isinstance(piece[-1], int)]
    if pieces:
        piece = random.choice(pieces)
        piece[-1] = random.choice([value for value in (-1, 0, 1) if value != piece[-1]])


def _drop(lines: Lines, random: Random) -> None:
    column = random.choice(lines[1:]) if len(lines) > 1 else None
    if column is None:
        return
    if random.random() < 0.3:
        lines.remove(column)
    elif column["pieces"]:
        del column["pieces"][random.randrange(len(column["pieces"]))]


def _kind(lines: Lines, random: Random) -> None:
    """A piece of one kind becomes one of another with the same ends."""
    pieces = [piece for column in lines[1:] for piece in column["pieces"]]
    if not pieces:
        return
    piece = random.choice(pieces)
    kinds = {"sign": ("monotone",), "monotone": ("sign",), "left": ("left",), "level": ("sign", "level")}
    piece[0] = random.choice(kinds.get(piece[0], ("fold", "hinge", "taylor", "laplace")))
    if piece[0] in ("taylor", "laplace"):
        del piece[1:]


def _column(lines: Lines, random: Random) -> None:
    """The pieces of one column are put under another."""
    if len(lines) > 2:
        one, two = random.sample(range(1, len(lines)), 2)
        lines[one]["pieces"] = copy.deepcopy(lines[two]["pieces"])


def _statement(lines: Lines, random: Random) -> None:
    statement = lines[0]["statement"]
    key = random.choice([key for key in statement if key != "kind"])
    value = statement[key]
    if key == "sign":
        statement[key] = -value or 1
    elif key == "counts":
        pair = random.choice(value) if value else [1, 1]
        pair[1] += random.choice((-1, 1))
    elif key in ("epsilon", "eta", "level") or (isinstance(value, str) and value[:1] not in "[("):
        factor = random.choice(
            (Fraction(2), Fraction(1, 2), Fraction(10), Fraction(1001, 1000), Fraction(-1), Fraction(10**5))
        )
        statement[key] = str(Fraction(value) * factor)
        if key == "epsilon" and "eta" in statement and random.random() < 0.7:
            eta = Fraction(statement["eta"])
            while 2 * eta**3 < Fraction(statement["epsilon"]):
                eta *= Fraction(11, 10)
            statement["eta"] = str(eta)
    elif key in ("tau", "beta"):
        statement[key] = _other_range(value, random)
    elif key == "alpha":
        value[random.randrange(3)] = random.choice(("-1", "1", "-2", "-5/2", "-7/2"))
    elif key == "brackets" and value:
        pair = random.choice(value)
        pair[random.randrange(2)] = str(Fraction(pair[0]) + Fraction(random.randint(-4, 4), 100))


def _other_range(text: str, random: Random) -> str:
    low, high = text[1:-1].split(", ")
    ends = [low, high]
    k = random.randrange(2)
    if ends[k] not in ("inf", "-inf"):
        ends[k] = str(Fraction(ends[k]) + Fraction(random.choice((-1, 1)), random.choice((1, 4, 64, 10**12))))
    left, right = random.choice((text[0], "(", "[")), random.choice((text[-1], ")", "]"))
    return f"{'(' if ends[0] == '-inf' else left}{ends[0]}, {ends[1]}{')' if ends[1] == 'inf' else right}"


def _judged(text: bytes, lines: Lines, kept: str) -> Answer:
    check = checker()
    try:
        stated = check.main.check_text(text, check.limits.Limits())
    except check.limits.Rejected as reason:
        return undecided("rejected for its work") if "limit" in str(reason) else AGREED
    if canonical_statement(lines) == kept:
        return AGREED
    trouble = untrue(lines[0]["statement"])
    if trouble is None:
        return undecided(f"accepted; no reference for {lines[0]['statement']['kind']}")
    return wrong(f"accepted: {stated}\n  {trouble}") if trouble else AGREED
