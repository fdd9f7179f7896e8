"""Check a certificate about dΘ/dτ, the contact force or its zeros. Usage: python check.py [OPTIONS] CERTIFICATE

The format is on the page certificate.md; every lemma named here is proved there or on check.md. Nothing is shared with
the code that finds certificates: no Gamma function, no value at τ = 0, no ball arithmetic. F(τ) = Θ(τ, b), b = β - 1.

    Limits        what a check may cost (check.md, section 6)
    Reading       from bytes to columns of pieces (certificate.md, Text and Columns)
    Models        polynomials in b with a bound on their error (check.md, Models)
    F on a disc   F for a complex disc of b, carried along τ (check.md, sections 1 to 3)
    Boxes         signs of F and of its derivatives on boxes (check.md, section 4)
    Pieces        the hypotheses of each piece (certificate.md, Pieces)
    Statements    from pieces to the statement (certificate.md; integer β: check.md, section 5)
    Command line
"""

from __future__ import annotations

import hashlib
import json
import math
import os
import re
import stat
import sys
from collections import namedtuple
from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from fractions import Fraction
from itertools import count, pairwise
from multiprocessing import get_context
from typing import Any, NamedTuple, NoReturn

INFINITY = math.inf  # stands for an infinite end of a range; no float takes part in a bound


class Rejected(Exception):
    """The certificate does not prove its statement; the text says why."""


def reject(reason: str) -> NoReturn:
    """End the check."""
    raise Rejected(reason)


def require(condition: object, reason: str) -> None:
    """End the check unless a condition holds."""
    if not condition:
        reject(reason)


# ---------------------------------------------------------------------------------------------------------------------
# Limits. They keep a check short; no proof needs them. A certificate beyond one of them is rejected, not refuted.
# ---------------------------------------------------------------------------------------------------------------------

WORK_PER_BYTE = 300_000  # products of digits for each byte of the certificate, beside Limits.work
OPERATION = 200  # what one operation of the interpreter costs, in products of digits
DIGIT = 30  # bits; Python multiplies digits of this length


class Limits(NamedTuple):
    """What a check may cost. To raise one on purpose: --limit NAME=NUMBER."""

    bytes: int = 20_000_000  # of the file
    line: int = 2_000_000  # bytes of one line
    lists: int = 200_000  # pieces, brackets and so on in the whole file
    beta: int = 200  # |β|, where F is computed
    tau: int = 200  # |τ|, where F is computed
    bits: int = 3_000  # accuracy of F
    splits: int = 10  # how often a box is halved
    work: int = 15  # 10^9 products of digits for a whole certificate; WORK_PER_BYTE is added
    memory: int = 160  # 10^6 bytes of numbers that are kept at one time

    def beyond(self, name: str) -> NoReturn:
        """End the check at a limit."""
        value = getattr(self, name)
        reject(f"out of the checker's range: the limit {name}={value} (raise it on purpose: --limit {name}=NUMBER)")

    def effort(self) -> str:
        """What was tried at most, where a sign stays open."""
        return f"with the limits bits={self.bits}, splits={self.splits} (raise them on purpose: --limit NAME=NUMBER)"

    def keep(self, name: str, value: Any) -> None:
        """End the check if a value is greater than the limit of this name."""
        if value > getattr(self, name):
            self.beyond(name)


def digits(number: int) -> int:
    """The length of an integer in digits, at least 1."""
    return number.bit_length() // DIGIT + 1


class Meter:
    """Counts work before it is done: products of digits, and operations of the interpreter."""

    def __init__(self, limits: Limits, budget: int) -> None:
        self.limits, self.left = limits, budget

    def spend(self, products: int, operations: int) -> None:
        """Take from the budget."""
        self.left -= products + OPERATION * operations
        if self.left < 0:
            self.limits.beyond("work")


# ---------------------------------------------------------------------------------------------------------------------
# Reading: certificate.md, Text and Columns.
# ---------------------------------------------------------------------------------------------------------------------

HYPOTHESES = {
    1: ["certificate", "fold", "identities", "initial_values", "laplace", "negative", "tails"],
    2: ["certificate", "exact_solution", "identities", "initial_values", "laplace", "monotone", "negative", "tails"],
    3: [
        *("certificate", "epsilon_series", "exact_solution", "finite_epsilon_zeros"),
        *("identities", "initial_values", "laplace", "negative"),
    ],
}  # by version
NUMBER = "-?(?:0|[1-9][0-9]{0,3999})(?:/[1-9][0-9]{0,3999})?"
RANGE = rf"([\[(])(-inf|{NUMBER}), (inf|{NUMBER})([\])])"
POINTS = {"laplace": 0, "taylor": 0, "left": 1, "right": 1, "sign": 2, "monotone": 2, "fold": 2, "hinge": 2}
POINTS |= {"level": 2, "dip": 2}  # of the points that a piece of each kind names: how many
VALUES: dict[str, tuple[int, ...]] = {"right": (0, 1), "sign": (-1, 1), "monotone": (-1, 1)}  # of v, s and d

Range = namedtuple("Range", "start end closed text")  # of τ or β; closed at the start, closed at the end; in words
Piece = namedtuple("Piece", "start end kind points value")  # covers [start, end] in τ; value is its s, d or v, or 0
Column = namedtuple("Column", "start end cell pieces")  # β in [start, end]; b in [cell, cell + 1] or in (-∞, 0]


def integer(text: str) -> int:
    """A JSON integer; its length is bounded before the conversion."""
    require(re.fullmatch("-?[0-9]{1,4000}", text), f"{text!a:.50} is not an integer of at most 4000 digits")
    return int(text)


def object_of(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    """A JSON object with no key twice."""
    value = dict(pairs)
    require(len(value) == len(pairs), "a key occurs twice in one object")
    return value


def read_line(line: bytes) -> Any:
    """One line of canonical JSON: integers are its only numbers."""
    try:
        text = line.decode()
        value = json.loads(
            text, object_pairs_hook=object_of, parse_int=integer, parse_float=integer, parse_constant=integer
        )
        canonical = json.dumps(value, sort_keys=True, separators=(",", ":"))
    except RecursionError:
        reject("JSON is nested too deeply")
    except UnicodeDecodeError:
        reject("the text is not UTF-8")
    except ValueError:
        reject("a line is not JSON")
    require(canonical == text, "a line is not canonical JSON")
    return value


def entries(value: Any, name: str, *keys: str) -> list[Any]:
    """The values of an object that has exactly these keys."""
    require(isinstance(value, dict) and sorted(value) == sorted(keys), f"{name} has not the keys {', '.join(keys)}")
    return [value[key] for key in keys]


def rational(value: Any) -> Fraction:
    """A rational number as text in lowest terms."""
    matches = isinstance(value, str) and re.fullmatch(NUMBER, value)
    require(matches, f"{value!a:.50} is not a rational number as text of at most 4000 digits")
    number = Fraction(value)
    require(str(number) == value, f"{value!a:.50} is not in lowest terms")
    return number


def one_of(value: Any, allowed: Sequence[int], name: str) -> int:
    """An integer (no boolean) out of a few."""
    require(type(value) is int and value in allowed, f"{name} is {value!a:.50}")
    return int(value)


def has(where: Range, x: Any) -> bool:
    """Whether x is in a range."""
    at_an_end = (x == where.start and where.closed[0]) or (x == where.end and where.closed[1])
    return bool(where.start < x < where.end or at_an_end)


def read_range(value: Any, name: str) -> Range:
    """A range as text, and in words."""
    match = re.fullmatch(RANGE, value) if isinstance(value, str) else None
    if match is None:
        reject(f"{value!a:.50} is not a range")
    left, low, high, right = match.groups()
    start = -INFINITY if low == "-inf" else rational(low)
    end = INFINITY if high == "inf" else rational(high)
    require(left + low != "[-inf" and high + right != "inf]", f"the range {value!a:.50} is closed at infinity")
    require(start < end or (start == end and left + right == "[]"), f"the range {value!a:.50} is empty")
    text = f"for every {name} in {value}" if start < end else f"at {name} = {low}"
    return Range(start, end, (left == "[", right == "]"), text)


def check_cover(parts: Sequence[Any], start: Any, end: Any, name: str) -> None:
    """Each part begins where the one before it ends, and together they just cover a range."""
    for before, after in pairwise(parts):
        require(before.end >= after.start, f"a gap between {name}")
        require(before.end <= after.start, f"an overlap of {name}")
        require(before.start < before.end and after.start < after.end, f"one of several {name} is a single point")
    require(parts and parts[0].start <= start and parts[-1].end >= end, f"the {name} do not cover the whole range")
    require(parts[0].end >= start and parts[-1].start <= end, f"one of the {name} lies outside the range")


def read_piece(value: Any) -> Piece:
    """The shape of one piece."""
    kind = value[0] if isinstance(value, list) and value else ""
    require(isinstance(kind, str) and kind in POINTS, f"unknown piece {value!a:.50}")
    arguments, length, values = value[1:], POINTS[kind], VALUES.get(kind, ())
    require(len(arguments) == length + bool(values), f"a piece {kind} has {len(arguments)} arguments")
    points = [rational(point) for point in arguments[:length]]
    last = one_of(arguments[length], values, f"the last entry of a piece {kind}") if values else 0
    start: Any = points[0] if points else -INFINITY
    end: Any = points[-1] if points else INFINITY
    if kind == "left":
        start = -INFINITY
    if kind == "right":
        end = INFINITY
    if kind == "taylor":
        start = Fraction(0)
    require(start < end, f"a piece {kind} does not go from left to right")
    return Piece(start, end, kind, points, last)


def read_column(line: bytes) -> Column:
    """One column and its place in a cell."""
    beta, pieces = entries(read_line(line), "a column", "beta", "pieces")
    require(isinstance(beta, list) and len(beta) == 2 and isinstance(pieces, list), "a column has not its two lists")
    end = rational(beta[1])
    if beta[0] == "-inf":
        require(pieces == [["laplace"]], "a column that begins at -inf is not the piece laplace alone")
        start: Any = -INFINITY
        cell = -1
    else:
        start = rational(beta[0])
        is_integer = start == end and start.denominator == 1
        cell = math.floor(start) - 2 if is_integer else math.floor(start) - 1
    require(start <= end, f"the column {beta!a:.50} ends before it begins")
    require(end <= cell + 2 or end <= 1, f"the column {beta!a:.50} crosses an integer")
    return Column(start, end, cell, [read_piece(piece) for piece in pieces])


def read_certificate(data: bytes, limits: Limits) -> tuple[int, Any, list[Column]]:
    """The version, the statement and the columns."""
    limits.keep("bytes", len(data))
    require(re.fullmatch(rb"(?s).*\nsha256 [0-9a-f]{64}\n", data), "the last line is not sha256 and a hash")
    body, last = data[:-72], data[-72:]
    require(hashlib.sha256(body).hexdigest().encode() == last[7:71], "the hash does not match")
    limits.keep("lists", body.count(b"["))
    lines = body[:-1].split(b"\n")
    limits.keep("line", max(map(len, lines)))
    names = ("format", "hypotheses", "statement", "version")
    form, hypotheses, statement, version = entries(read_line(lines[0]), "the header", *names)
    require(form == "gspot_verified certificate", f"the format is {form!a:.50}")
    known = HYPOTHESES[one_of(version, tuple(HYPOTHESES), "the version")]
    require(hypotheses == known, "the hypotheses are not the pages that this checker knows")
    return version, statement, [read_column(line) for line in lines[1:]]


# ---------------------------------------------------------------------------------------------------------------------
# Models: check.md, Models.
# ---------------------------------------------------------------------------------------------------------------------


class Model(NamedTuple):
    """Σ m_j η^j + ε(η), in units of 2^-p; ε is analytic and |ε| ≤ error on the complex disc |η| ≤ 1."""

    m: list[int]
    error: int

    def norm(self) -> int:
        """A bound on the disc."""
        return sum(map(abs, self.m)) + self.error

    def spread(self, first: int) -> int:
        """A bound on the terms from η^first on, for |η| ≤ 1/2."""
        return sum((abs(m) >> j) + 1 for j, m in enumerate(self.m) if j >= first)

    def times(self, factor: Fraction) -> Model:
        """A rational multiple; each coefficient is rounded by less than 1."""
        n, d = factor.numerator, factor.denominator
        return Model([n * m // d for m in self.m], abs(n) * self.error // d + 1 + len(self.m))

    def digits(self) -> int:
        """The length of all its integers."""
        return (sum(map(int.bit_length, self.m)) + self.error.bit_length()) // DIGIT + len(self.m) + 1

    def bytes(self) -> int:
        """The memory that it takes: 4 bytes for a digit, at most 40 beside for an integer."""
        return 4 * self.digits() + 40 * len(self.m) + 120


def moved(series: list[Model], u: Fraction, p: int, meter: Meter) -> list[Model]:
    """Σ C(k,i) a_k u^(k-i), i = 0, 1, 2, for |u| ≤ 1; powers of u have p bits (check.md, section 3)."""
    length, degree = len(series), len(series[0].m)
    size = p // DIGIT + 1
    meter.spend(length * size * (digits(u.numerator) + digits(u.denominator)), 4 * length)
    meter.spend(3 * size * sum(a.digits() for a in series), length * (3 * degree + 10))
    powers = [1 << p]
    for _ in series:
        powers.append(powers[-1] * u.numerator // u.denominator)
    norms = [a.norm() for a in series]
    result = []
    for i in range(3):
        weights = [math.comb(k, i) * powers[max(k - i, 0)] for k in range(length)]
        m = [sum(map(int.__mul__, weights, column)) >> p for column in zip(*(a.m for a in series), strict=True)]
        error = sum(abs(w) * a.error for w, a in zip(weights, series, strict=True))
        error += sum(math.comb(k, i) * k * norm for k, norm in enumerate(norms))
        result.append(Model(m, (error >> p) + 1 + len(m)))
    return result


# ---------------------------------------------------------------------------------------------------------------------
# F on a disc: check.md, sections 1 to 3.
# ---------------------------------------------------------------------------------------------------------------------

STEP = Fraction(2)  # between the points from which F is carried on


def start_for(bits: int, reach: int, tau: Fraction) -> int:
    """An even x ≥ -τ, so far out that the series at -x gives these bits. A heuristic: any choice is correct."""
    x = 2 * math.ceil(max((1.05 * bits) ** (2 / 3), 1.5 * reach ** (2 / 3), 4.0) / 2)
    return x if x >= -tau else 16 * math.ceil(-tau / 16)


def degree_for(width: Fraction, x: int, goal: float) -> int:
    """How many coefficients in η make the rest less than e^-goal. A heuristic: any choice is correct."""
    size = float(width) * (math.log(x) + 2)
    if not size:
        return 1
    return next(d for d in count(1) if math.lgamma(d) - d * math.log(size) > goal)


def tail_factors(point: Fraction, s: Fraction) -> tuple[int, int]:
    """Integers ≥ |τ₀|s² and ≥ s³."""
    return math.ceil(abs(point) * s * s), math.ceil(s**3)


def tail_falls(square: int, cube: int, i: int, b: int) -> bool:
    """The hypothesis q(i) ≤ 1/2 of the tail lemma, i ≥ 0, for |b| ≤ B (section 2)."""
    return i >= 0 and 2 * (square * (i + 1) + cube * (i + b)) <= (i + 1) * (i + 2) * (i + 3)


def next_bound(bound: int, n: int, centre: int, radius: int, unit: int, x: int) -> int:
    """From a bound on sup |(-b)_{3n}|/(3^n n! x^(3n)) to one for n + 1, b = (centre + radius η)/unit; rounded up."""
    factors = math.prod(abs(i * unit - centre) + radius for i in range(3 * n, 3 * n + 3))
    return -(-bound * factors // ((unit * x) ** 3 * 3 * (n + 1)))


def rests(bound: int, n: int, reach: int, x: int) -> tuple[int, int, int]:
    """For bound = g T, N = n and B = reach: g T, g T (3N + B)/x and g T (3N + B)(3N + 1 + B)/x², rounded up."""
    far = 3 * n + reach
    return bound, -(-bound * far // x), -(-bound * far * (far + 1) // (x * x))


class Local:
    """F/x^b for b = (centre + radius η)/unit, [low, high] is |η| ≤ 1/2, carried along τ from -x."""

    def __init__(self, low: Fraction, high: Fraction, bits: int, tau: Fraction, meter: Meter) -> None:
        self.unit = 2 * math.lcm(low.denominator, high.denominator)
        self.centre, self.radius = int((low + high) / 2 * self.unit), int((high - low) * self.unit)
        self.reach = (abs(self.centre) + self.radius) // self.unit + 1  # ≥ |b| on the disc
        self.x = start_for(bits, self.reach, tau)
        self.p = bits + 30 + self.x // 4 + 3 * math.isqrt(self.x)
        self.few_bits = 24 + 3 * math.isqrt(self.x)  # of the basic solutions: only their norms are used
        self.degree = degree_for(high - low, self.x, 0.6 * bits + 10)
        self.meter = meter
        self.anchor_bytes, self.kept_series = 0, dict[int, tuple[list[list[Model]], int]]()
        self.anchors: list[list[Model]] = []
        self.add_anchor(self.at_minus_x())

    def bytes(self) -> int:
        """The memory that is kept: anchors, and series at the last two of them."""
        return self.anchor_bytes + sum(size for _, size in self.kept_series.values())

    def add_anchor(self, values: list[Model]) -> None:
        """Keep the values at one more anchor; one F takes at most half of the memory."""
        self.anchors.append(values)
        self.anchor_bytes += sum(value.bytes() for value in values)
        if 2 * self.bytes() > self.meter.limits.memory * 10**6:
            self.meter.limits.beyond("memory")

    def linear(self, a: Model, i: int, divisor: int) -> Model:
        """(i - b) a/divisor; the coefficient beyond the degree goes into the error."""
        n, r, d = i * self.unit - self.centre, self.radius, divisor * self.unit
        self.meter.spend(a.digits() * (digits(n) + digits(r) + digits(d)), 4 * len(a.m))
        m = [(n * x - r * y) // d for x, y in zip(a.m, [0, *a.m], strict=False)]
        return Model(m, ((abs(n) + r) * a.error + r * abs(a.m[-1])) // abs(d) + 1 + len(m))

    def at_minus_x(self) -> list[Model]:
        """a_0, a_1, a_2 at τ = -x with the scale STEP: the enveloping series on the disc (section 1)."""
        x = self.x
        sums = [[0] * self.degree for _ in range(3)]
        errors = [0, 0, 0]
        term, bound = Model([1 << self.p] + [0] * (self.degree - 1), 0), 1 << self.p
        for k in count():
            once = self.linear(term, 3 * k, x)
            twice = self.linear(once, 3 * k + 1, x)
            for i, part in enumerate((term, once, twice)):
                sums[i] = list(map(int.__add__, sums[i], part.m))
                errors[i] += part.error
            term = self.linear(twice, 3 * k + 2, -3 * (k + 1) * x)
            self.meter.spend((3 * digits(self.unit * x) + digits(bound)) ** 2, 0)
            before, bound = bound, next_bound(bound, k, self.centre, self.radius, self.unit, x)
            # N = k + 1: 3N ≥ B + 1/2. The rest is small enough, or it is the least.
            if 3 * k + 2 > self.reach and (bound <= 1 or bound >= before):
                break
        growth = 5 ** -(-self.radius // self.unit)
        left_out = rests(growth * bound, k + 1, self.reach, x)
        values = [Model(m, error + rest) for m, error, rest in zip(sums, errors, left_out, strict=True)]
        return [value.times(STEP**i / (1 + i // 2)) for i, value in enumerate(values)]

    def recurrence(self, point: Fraction, s: Fraction, start: Sequence[Model]) -> Iterator[Model]:
        """(k+1)(k+2)(k+3) c_{k+3} = τ (k+1) c_{k+1} + (k - b) c_k at τ = point, for a_k = c_k s^k (section 2)."""
        first, second = point * s * s, s**3 / self.unit
        common = math.lcm(first.denominator, second.denominator)
        alpha, beta = int(first * common), int(second * common)
        zero, one, two = start
        yield from start
        for k in count():
            n, r, f = beta * (k * self.unit - self.centre), beta * self.radius, alpha * (k + 1)
            d = common * (k + 1) * (k + 2) * (k + 3)
            products = zero.digits() * (digits(n) + digits(r) + digits(d)) + one.digits() * (digits(f) + digits(d))
            self.meter.spend(products, 4 * len(zero.m) + 20)
            m = [(f * y + n * x - r * z) // d for x, y, z in zip(zero.m, one.m, [0, *zero.m], strict=False)]
            error = (abs(f) * one.error + (abs(n) + r) * zero.error + r * abs(zero.m[-1])) // d + 1 + len(m)
            zero, one, two = one, two, Model(m, error)
            yield two

    def expand(self, point: Fraction, s: Fraction, start: Sequence[Model]) -> list[Model]:
        """Coefficients until the tail lemma (section 2) holds with q ≤ 1/2; the last error bounds the rest too."""
        square, cube = tail_factors(point, s)
        small = 2 * len(start[0].m) + 2
        kept, most = 0, self.meter.limits.memory * 10**6 // 8
        a: list[Model] = []
        for model in self.recurrence(point, s, start):
            a.append(model)
            kept += model.bytes()
            if kept > most:
                self.meter.limits.beyond("memory")
            if tail_falls(square, cube, len(a) - 5, self.reach + 2) and max(last.norm() for last in a[-3:]) <= small:
                break
        a[-1] = Model(a[-1].m, a[-1].error + 3 * max(last.norm() for last in a[-3:]))
        return a

    def series_at(self, index: int) -> list[list[Model]]:
        """Series at an anchor: of the midpoints of the values there as one solution, and of three basic solutions."""
        if index not in self.kept_series:
            degree = min(self.degree, degree_for(Fraction(self.radius, self.unit), self.x, 6.0))
            basis = [[Model([(i == j) << self.few_bits] + [0] * (degree - 1), 0) for j in range(3)] for i in range(3)]
            starts = ([Model(value.m, 0) for value in self.anchors[index]], *basis)
            expansions = [self.expand(index * STEP - self.x, STEP, start) for start in starts]
            while len(self.kept_series) > 1:
                del self.kept_series[next(iter(self.kept_series))]
            self.kept_series[index] = expansions, sum(a.bytes() for series in expansions for a in series)
        return self.kept_series[index][0]

    def carried(self, index: int, u: Fraction) -> list[Model]:
        """a_0, a_1, a_2 at a distance u STEP from an anchor: the errors are carried by a 3x3 matrix (section 3)."""
        series, *basis = self.series_at(index)
        exact = moved(series, u, self.p, self.meter)
        columns = [moved(solution, u, self.few_bits, self.meter) for solution in basis]
        errors = [value.error for value in self.anchors[index]]
        result = []
        for i, value in enumerate(exact):
            grown = sum(column[i].norm() * error for column, error in zip(columns, errors, strict=True))
            result.append(Model(value.m, value.error + (grown >> self.few_bits) + 1))
        return result

    def values(self, point: Fraction, s: Fraction) -> list[Model]:
        """a_0, a_1, a_2 at a point with the scale s."""
        index, rest = divmod(point + self.x, STEP)
        require(index >= 0, "out of the checker's range: τ before the start")
        while len(self.anchors) <= index:
            self.add_anchor(self.carried(len(self.anchors) - 1, Fraction(1)))
        return [value.times((s / STEP) ** i) for i, value in enumerate(self.carried(index, rest / STEP))]

    def in_b(self, a: Model) -> Model:
        """A positive multiple of d/db + w, w near log x, for |η| ≤ 1/2: Cauchy's estimate (section 4)."""
        n, d = self.radius * round(math.log(self.x) * 2**16), self.unit << 16
        m = [d * j * y + n * x for j, (y, x) in enumerate(zip([*a.m[1:], 0], a.m, strict=True), 1)]
        return Model(m, (2 * d + n) * a.error)


# ---------------------------------------------------------------------------------------------------------------------
# Boxes: check.md, section 4.
# ---------------------------------------------------------------------------------------------------------------------

Box = tuple[Fraction, Fraction, Fraction, Fraction]  # b from, b to, τ from, τ to


def short(number: Fraction, bits: int, rounding: Callable[[Fraction], int]) -> Fraction:
    """The number, or the multiple of 2^-bits next to it on the side of the rounding if its denominator is longer."""
    scale = 1 << bits
    return number if number.denominator <= scale else Fraction(rounding(number * scale), scale)


def outward(low: Fraction, high: Fraction, bits: int) -> tuple[Fraction, Fraction, bool]:
    """A range that holds [low, high], with short denominators; whether it is much wider. A point is used as it is."""
    if low == high:
        return low, high, False
    start, end = short(low, bits, math.floor), short(high, bits, math.ceil)
    return start, end, end - start > 2 * (high - low)


# F^(k)/k! on a box is within in_tau + in_b (what τ and b add) + error of middle, times x^b/(2^p scale); unit is x, p.
Enclosed = namedtuple("Enclosed", "middle in_tau in_b error unit scale")


def power_between(base: Fraction, exponent: Fraction, bits: int, meter: Meter) -> tuple[Fraction, Fraction]:
    """base^(h/n) for 0 < base < 1, h/n ≥ 0, between neighbouring multiples of 2^-bits: r^n ≤ 2^(bits n) base^h."""
    h, n, low, high = exponent.numerator, exponent.denominator, 0, 1 << bits
    meter.spend(bits * (n * (bits // DIGIT + 1) + h * digits(base.denominator)) ** 2, 20 * bits)
    right, left = base.numerator**h << (bits * n), base.denominator**h
    while high - low > 1:  # low^n ≤ 2^(bits n) base^h < high^n
        middle = (low + high) // 2
        low, high = (middle, high) if middle**n * left <= right else (low, middle)
    return Fraction(low, 1 << bits), Fraction(high, 1 << bits)


class ColumnCheck:
    """One column: signs of F and its derivatives on boxes, at rising accuracy, within a budget of work."""

    def __init__(self, column: Column, limits: Limits, budget: int) -> None:
        self.column, self.limits, self.meter = column, limits, Meter(limits, budget)
        self.bits = 64
        self.locals: dict[tuple[Fraction, Fraction, int, int], Local] = {}

    def begin(self, start: Any, end: Any, points: Sequence[Fraction] = ()) -> None:
        """The pieces cover [start, end]; the limits in β and τ; a heuristic first accuracy."""
        column = self.column
        check_cover(column.pieces, start, end, "pieces")
        distances = [*map(abs, points), *(abs(x) for piece in column.pieces for x in piece.points)]
        if distances:
            self.limits.keep("beta", max(abs(column.start), abs(column.end)))
            self.limits.keep("tau", max(distances))
            right = max([0, *points, *(x for piece in column.pieces for x in piece.points)])
            self.bits = min(12 + int(0.2 * float(right) ** 1.5 + 0.6 * float(max(column.end, 0))), self.limits.bits)

    def local(self, low: Fraction, high: Fraction, bits: int, tau: Fraction) -> Local:
        """F on the disc around [low, high]; those not used for the longest time make room."""
        key = (low, high, bits, start_for(bits, 0, tau))
        disc = self.locals.pop(key, None) or Local(low, high, bits, tau, self.meter)
        self.locals[key] = disc
        half = self.limits.memory * 10**6 // 2
        while len(self.locals) > 1 and sum(one.bytes() for one in self.locals.values()) > half:
            del self.locals[next(iter(self.locals))]
        return disc

    def parts(self, box: Box, order: int, bits: int) -> Enclosed:
        """F^(order), or a positive multiple of ∂F/∂b + w F if order = -1."""
        low, high, thin_b = outward(*box[:2], bits)
        start, end, thin_tau = outward(*box[2:], bits)
        require(start == end or order <= 2, "the tail lemma is proved for orders up to 2")
        local, middle, i = self.local(low, high, bits, start), (start + end) / 2, max(order, 0)
        s = (end - start) / 2 or Fraction(1 << max(0, int(abs(start)).bit_length() - 1))  # at a point any s > 0 will do
        values = local.values(middle, s)
        if start < end:
            series = local.expand(middle, s, values)[i:]
        else:
            series = [next(a for k, a in enumerate(local.recurrence(middle, s, values)) if k == i)]
        if order < 0:
            series = [local.in_b(a) for a in series]
        self.meter.spend(sum(a.digits() for a in series), 3 * len(series) * len(series[0].m))
        weights = [math.comb(k, i) for k in range(i, i + len(series))]
        in_tau = sum(w * a.spread(0) for w, a in zip(weights[1:], series[1:], strict=True))
        in_b = series[0].spread(1)
        error = sum(w * a.error for w, a in zip(weights, series, strict=True))
        # What only the wider box adds is an error: halving would not help, a higher accuracy does.
        error += (in_tau if thin_tau else 0) + (in_b if thin_b else 0)
        in_tau, in_b = 0 if thin_tau else in_tau, 0 if thin_b else in_b
        return Enclosed(series[0].m[0], in_tau, in_b, error, (local.x, local.p), s**i)

    def sign(self, box: Box, order: int, splits: int | None = None, bits: int = 0) -> int:
        """The one sign on the whole box, or 0 when none is confirmed."""
        splits = self.limits.splits if splits is None else splits
        bits = max(bits, self.bits)
        middle, in_tau, in_b, error, *_ = self.parts(box, order, bits)
        if abs(middle) > in_tau + in_b + error:
            self.bits = bits
            return 1 if middle > 0 else -1
        if 4 * error >= max(abs(middle), in_tau + in_b):
            return self.sign(box, order, splits, bits * 3 // 2) if bits < self.limits.bits else 0
        if not splits:
            return 0
        low, high, start, end = box
        b, tau = (low + high) / 2, (start + end) / 2
        if in_tau < in_b:
            one, two = (low, b, start, end), (b, high, start, end)
        else:
            one, two = (low, high, start, tau), (low, high, tau, end)
        sign = self.sign(one, order, splits - 1, bits)
        return sign if sign and self.sign(two, order, splits - 1, bits) == sign else 0

    def compared(self, value: int, unit: tuple[int, int], b: Fraction, level: Fraction) -> int:
        """The sign of value x^b/2^p - level for value ≥ 0, level > 0, b = h/n ≥ 0, in integers: both sides to the n."""
        (x, p), h, n = unit, b.numerator, b.denominator
        left, right = value * level.denominator, level.numerator << p
        self.meter.spend((n * (digits(left) + digits(right)) + h * digits(x)) ** 2, 20)
        one, two = left**n * x**h, right**n
        return (one > two) - (one < two)

    def within(self, box: Box, level: Fraction, splits: int, bits: int = 0) -> bool:
        """|F| ≤ level on a box at one b ≥ 0."""
        bits = max(bits, self.bits)
        middle, in_tau, in_b, error, unit, _ = self.parts(box, 0, bits)
        if self.compared(abs(middle) + in_tau + in_b + error, unit, box[0], level) <= 0:
            return True
        if 4 * error >= max(abs(middle), in_tau + in_b):
            return bits < self.limits.bits and self.within(box, level, splits, bits * 3 // 2)
        if not splits or self.compared(max(abs(middle) - error, 0), unit, box[0], level) > 0:
            return False
        tau = (box[2] + box[3]) / 2
        halves = ((*box[:2], box[2], tau), (*box[:2], tau, box[3]))
        return all(self.within(half, level, splits - 1, bits) for half in halves)

    def beyond(self, b: Fraction, tau: Fraction, level: Fraction, sign: int) -> bool:
        """sign F ≥ level > 0 at one point, b ≥ 0; the accuracy is raised while the ball cannot tell."""
        bits = self.bits
        while bits < self.limits.bits:
            middle, in_tau, in_b, error, unit, _ = self.parts((b, b, tau, tau), 0, bits)
            slack = in_tau + in_b + error
            if self.compared(max(sign * middle - slack, 0), unit, b, level) >= 0:
                return True
            if self.compared(max(sign * middle + slack, 0), unit, b, level) < 0:
                return False
            bits = bits * 3 // 2
        return False

    def dips(self, first: Fraction, second: Fraction, eta: Fraction) -> bool:
        """Whether F(t1) + η/(8γ) [μ^(b-1) F'(t2) - F'(t1)] < 0 on the column; μ = t1/t2 > 0, γ = (1 - μ³)/3."""
        low, high, ratio = self.column.start - 1, self.column.end - 1, first / second
        weight = 3 * eta / (8 * (1 - ratio**3))
        least, most = (power_between(ratio, b - 1, 2 * DIGIT, self.meter)[i] for i, b in enumerate((high, low)))
        bits = self.bits
        while bits < self.limits.bits:
            parts = [self.parts((low, high, tau, tau), k, bits) for tau, k in ((first, 0), (first, 1), (second, 1))]
            require(len({part.unit for part in parts}) == 1, "F and F' are known in different units of x^b/2^p")
            value, slope, largest = (part.middle / part.scale for part in parts)
            slacks = [(part.in_tau + part.in_b + part.error) / part.scale for part in parts]
            largest = (largest + slacks[2]) * (most if largest + slacks[2] > 0 else least)
            bound, doubt = value + weight * (largest - slope), slacks[0] + weight * slacks[1]
            if bound + doubt < 0:
                return True
            # Too wide in b, or far above 0: a higher accuracy would not help.
            wide = 4 * sum(part.error / part.scale for part in parts) < sum(slacks)
            if wide or bound > doubt + 2 * weight * slacks[2]:
                return False
            bits = bits * 3 // 2
        return False

    # -----------------------------------------------------------------------------------------------------------------
    # Pieces: certificate.md, Pieces.
    # -----------------------------------------------------------------------------------------------------------------

    def left_holds(self, low: Fraction, high: Fraction, cell: int, x: Fraction) -> bool:
        """The hypothesis of tails.md, τ → -∞, in integers, for a range of b that is hardly wider and x hardly less."""
        if low < -1 or x <= 0:
            return False
        low, high, x = short(low, 256, math.floor), short(high, 256, math.ceil), short(x, 256, math.floor)
        n, unit = 3 * max(1, cell // 3 + 1), math.lcm(low.denominator, high.denominator)
        self.meter.spend((n * digits(x.numerator * x.denominator * unit)) ** 2, 20 * n)
        product = math.prod(int(max(abs(low - i), abs(high - i)) * unit) for i in range(n))
        left = (x.numerator * unit) ** n * 3 ** (n // 3) * math.factorial(n // 3)
        return left > product * x.denominator**n

    def right_signs(self, box: Box, n: int) -> list[int]:
        """The certain signs of c_0, ..., c_n, (-1)^(n+1) (tails.md); one between opposite signs may be open."""
        for splits in (0, 3):
            signs = [*(self.sign(box, k, splits) for k in range(n + 1)), (-1) ** (n + 1)]
            if all(sign or (k and signs[k - 1] * signs[k + 1] == -1) for k, sign in enumerate(signs)):
                return [sign for sign in signs if sign]
        return []

    def fold_holds(self, box: Box) -> bool:
        """The hypotheses of fold.md beyond its place; ∂F/∂b with a weight, on a wider range of b (section 4)."""
        low, high, start, end = box
        wide = (low, max(high, low + Fraction(1, 256)), start, end)
        return (
            self.sign((low, high, start, start), 0) == 1
            and self.sign((low, high, end, end), 0) == 1
            and self.sign(box, 2) == 1
            and self.sign(wide, -1) == 1
        )

    def piece_sign(self, piece: Piece) -> int:
        """Check the hypotheses of a piece. The sign of F that it gives at its ends, or 0 for a piece monotone."""
        start, end, kind, points, value = piece
        column = self.column
        low, high, cell = column.start - 1, column.end - 1, column.cell
        require(kind not in ("level", "dip"), f"a piece {kind} gives no sign")
        name = f"the piece {kind} from τ = {start!s:.50} to {end!s:.50} of the column from β = {column.start!s:.50}"
        if kind in ("laplace", "taylor"):
            require(high <= 0, f"{name} needs b ≤ 0")
            return 1
        require(high > 0 or kind in ("left", "sign"), f"{name} is not allowed for b ≤ 0")
        if kind == "left":
            require(self.left_holds(low, high, cell, -points[0]), f"{name}: the remainder is too large")
            return 1
        box = (low, high, points[0], points[-1])
        if kind == "right":
            signs = self.right_signs(box, cell)
            require(signs, f"{name}: the signs of c_0, ..., c_{cell} are not confirmed {self.limits.effort()}")
            changes = sum(a != b for a, b in pairwise(signs))
            require(changes == value, f"{name}: {changes} changes of sign, not {value}")
            return signs[0]
        if kind == "fold":
            at_an_end = 0 in (column.start % 3, column.end % 3)
            require(start < 0 < end and at_an_end, f"{name} is not around τ = 0 at β = 3, 6, 9, ...")
            require(self.fold_holds(box), f"{name}: a hypothesis of the fold is not confirmed {self.limits.effort()}")
            return 1
        sign_on_box = self.sign(box, 0 if kind == "sign" else 1)
        require(sign_on_box, f"{name}: no sign is confirmed {self.limits.effort()}")
        if kind == "hinge":
            require(0 in points, f"{name} does not begin or end at τ = 0")
            sign = sign_on_box if start == 0 else -sign_on_box
            require(sign == (-1 if cell % 3 == 1 else 1), f"{name}: F(0, b) has the other sign")
            return sign
        require(sign_on_box == value, f"{name}: the sign is {sign_on_box}, not {value}")
        return sign_on_box if kind == "sign" else 0


# ---------------------------------------------------------------------------------------------------------------------
# Statements: certificate.md, From pieces to the statement.
# ---------------------------------------------------------------------------------------------------------------------


def sign_holds(check: ColumnCheck, tau: Range, beta: Range, sign: int) -> None:
    """On one column: dΘ/dτ = -βF has one sign."""
    column = check.column
    check.begin(tau.start, tau.end)
    zero = has(tau, 0) and any(end % 3 in (0, 2) and has(beta, end) for end in (column.start, column.end))
    for piece in column.pieces:
        kind = piece.kind
        require(kind != "monotone" and (kind, piece.value) != ("right", 1), f"a piece {kind} gives no sign")
        require(kind != "fold" or column.start % 3 == 0, "a fold at the upper end of its column has zeros")
        require(kind not in ("fold", "hinge") or not zero, f"τ = 0 is a zero in a piece {kind} at an integer β")
        given = check.piece_sign(piece) * (-1 if beta.end > 0 else 1)
        require(given == sign, f"a piece {kind} gives dΘ/dτ the sign {given}, not {sign}")


def number_of_zeros(check: ColumnCheck, points: Sequence[Fraction] = ()) -> int:
    """On one column: the number of zeros of F for b in the open cell; all are simple."""
    column = check.column
    check.begin(-INFINITY, INFINITY, points)
    before, direction, zeros = 0, 0, 0
    for piece in column.pieces:
        require(piece.kind != "hinge", "a piece hinge does not count zeros")
        sign = check.piece_sign(piece)
        if piece.kind == "monotone":
            require(before, "a piece monotone comes first")
            require(direction in (0, piece.value), "neighbouring pieces monotone have two directions")
            direction = piece.value
            continue
        change = before not in (0, sign)
        require(direction or not change, "two neighbouring pieces give F different signs where they meet")
        require(not change or sign == direction, "a change of sign is against the direction of a piece monotone")
        zeros += 1 if change else 0
        if piece.kind == "right":
            zeros += piece.value
        if piece.kind == "fold" and column.end % 3 == 0:
            zeros += 2
        before, direction = sign, 0
    require(direction == 0, "a piece monotone comes last")
    return zeros


def zeros_hold(check: ColumnCheck, counts: dict[int, int]) -> None:
    """On one column: the number of zeros is the one that is claimed for its cell."""
    number, claimed = number_of_zeros(check), counts.get(check.column.cell + 1)
    require(number == claimed, f"{number} zeros on the column from β = {check.column.start!s:.50}, not {claimed}")


def brackets_hold(check: ColumnCheck, beta: Fraction, brackets: list[tuple[Fraction, Fraction]]) -> None:
    """On the one column: as many zeros as brackets, and a change of sign in each."""
    number = number_of_zeros(check, [end for pair in brackets for end in pair])
    require(number == len(brackets), f"there are {number} zeros, not {len(brackets)}")
    for pair in brackets:
        low, high = (check.sign((beta - 1, beta - 1, point, point), 0) for point in pair)
        require(low * high == -1, f"F does not change its sign between {pair[0]!s:.50} and {pair[1]!s:.50}")


def force_holds(check: ColumnCheck, tau: Range, sign: int, level: Fraction) -> None:
    """On the one column, at one β: sign F ≥ -level on the range of τ (certificate.md, force)."""
    column = check.column
    check.begin(tau.start, tau.end)
    for piece in column.pieces:
        if piece.kind == "level":
            box = (column.start - 1, column.end - 1, piece.start, piece.end)
            held = check.within(box, level, check.limits.splits)
            require(held, f"|F| ≤ {level} is not confirmed from τ = {piece.start!s:.50} to {piece.end!s:.50}")
            continue
        allowed = piece.kind in ("left", "sign", "right") and (piece.kind, piece.value) != ("right", 1)
        require(allowed, f"a piece {piece.kind} does not bound the force")
        require(check.piece_sign(piece) == sign, f"a piece {piece.kind} gives F the other sign")


def lift_off_holds(check: ColumnCheck, beta: Fraction, tau: Fraction, sign: int, level: Fraction) -> None:
    """On the one column, at one β: sign F ≥ level at one τ (certificate.md, lift_off)."""
    check.begin(tau, tau, [tau])
    require(len(check.column.pieces) == 1 and check.column.pieces[0].kind == "level", "there is not one piece level")
    require(check.beyond(beta - 1, tau, level, sign), f"F beyond the level is not confirmed at τ = {tau!s:.50}")


def dip_holds(check: ColumnCheck, eta: Fraction) -> None:
    """On one column: G_b < 0 at one τ for every ε of the statement (certificate.md, slow_zeros)."""
    column = check.column
    require([piece.kind for piece in column.pieces] == ["dip"], "a column is not one piece dip")
    first, second = column.pieces[0].points
    require(first > 0 and 2 * first**3 <= second**3, "a piece dip has not t1 > 0 and 2 t1³ ≤ t2³")
    short = max(column.start.denominator, column.end.denominator) <= 4096
    require(short, "a column with a piece dip has an end of a denominator beyond 4096")
    check.begin(first, second)
    where = f"the piece dip at τ = {first!s:.50} of the column from β = {column.start!s:.50}"
    require(check.dips(first, second, eta), f"{where} is not confirmed {check.limits.effort()}")


class System(NamedTuple):
    """The compliant model with its C_1: rational numbers, 1 < β = α_3/α_1 < 5 not an integer, α_1, α_2, α_3 < 0."""

    alpha: list[Fraction]
    c1: Fraction
    beta: Fraction

    def side(self) -> int:
        """The sign of C_1/Γ(-β): Γ(-β) has the sign (-1)^(⌊β⌋ + 1) (side_switching.md)."""
        return (-1) ** (math.floor(self.beta) + 1) * (1 if self.c1 > 0 else -1)

    def compared(self, epsilon: Fraction, level: Fraction, meter: Meter) -> int:
        """The sign of A ε^p β level - mean force, A = |C_1/α_3| κ^(1-β), p = 2(β-1)/3, κ^3 = -α_1/2 (iwc.md).

        With β - 1 = h/n: of (|C_1/α_3| β level/mean)^(3n) (2 ε²/-α_1)^h - 1, exactly.
        """
        first, second, third = self.alpha
        h, n = (self.beta - 1).numerator, self.beta.denominator
        one = abs(self.c1 / third) * self.beta * level * (third - first) / second
        two = 2 * epsilon * epsilon / -first
        size = sum(3 * n * digits(x) for x in one.as_integer_ratio()) + sum(
            h * digits(x) for x in two.as_integer_ratio()
        )
        meter.spend(size**2, 20)
        product = one ** (3 * n) * two**h
        return (product > 1) - (product < 1)


def read_system(alpha: Any, c1: Any) -> System:
    """The numbers of a statement on the compliant model."""
    require(isinstance(alpha, list) and len(alpha) == 3, "alpha is not a list of three numbers")
    numbers, charge = [rational(value) for value in alpha], rational(c1)
    require(all(number < 0 for number in numbers) and charge, "one of the α is not negative, or C_1 = 0")
    beta = numbers[2] / numbers[0]
    require(1 < beta < 5 and 1 < beta.denominator <= 4096, "β is not in (1, 5), an integer, or of a long denominator")
    return System(numbers, charge, beta)


class Task(NamedTuple):
    """One column and what must hold on it; it may be sent to another process."""

    rule: Callable[..., None]
    arguments: tuple[Any, ...]
    column: Column
    limits: Limits
    budget: int

    def run(self) -> tuple[str, int]:
        """The reason why the rule does not hold, or nothing; and the work that was spent."""
        check = ColumnCheck(self.column, self.limits, self.budget)
        try:
            self.rule(check, *self.arguments)
        except Rejected as reason:
            return str(reason), self.budget - check.meter.left
        return "", self.budget - check.meter.left


class Checker:
    """One certificate: its statement, its columns, and the budget of work that all of them share."""

    def __init__(self, statement: Any, columns: list[Column], limits: Limits, budget: int, workers: int = 1) -> None:
        self.statement, self.columns = statement, columns
        self.limits, self.left, self.workers = limits, budget, workers

    def on_each_column(self, rule: Callable[..., None], *arguments: Any) -> None:
        """The rule holds on each column. The answer is the same for any number of workers: they begin afresh."""
        if self.workers > 1:
            tasks = [Task(rule, arguments, column, self.limits, self.left) for column in self.columns]
            with ProcessPoolExecutor(self.workers, get_context("spawn")) as pool:
                try:
                    self.settle(pool.map(Task.run, tasks))
                finally:
                    pool.shutdown(wait=False, cancel_futures=True)
        else:
            # self.left is read when a task is made, after the task before it was settled.
            self.settle(Task(rule, arguments, column, self.limits, self.left).run() for column in self.columns)

    def settle(self, answers: Iterable[tuple[str, int]]) -> None:
        """Take the work of each column from the one budget, in the order of the columns."""
        for reason, spent in answers:
            self.left -= spent
            if self.left < 0:
                self.limits.beyond("work")
            require(not reason, reason)

    def check_sign(self) -> str:
        """dΘ/dτ = -βF has one sign on a range of τ and a range of β."""
        claimed, tau_text, beta_text, _ = entries(self.statement, "the statement", "sign", "tau", "beta", "kind")
        sign, tau, beta = one_of(claimed, (-1, 0, 1), "the sign"), read_range(tau_text, "τ"), read_range(beta_text, "β")
        text = f"dΘ/dτ {'=><'[sign]} 0 {tau.text} and {beta.text}".replace("and for every", "and every")
        if tau.start == tau.end and beta.start == beta.end and beta.end in range(self.limits.beta + 1):
            require(not self.columns, "at one point with an integer β there is no column")
            exact_sign = self.sign_at_integer(tau.start, int(beta.end))
            require(exact_sign == sign, f"the sign at this integer β is {exact_sign}, not {sign}")
            return text
        require(sign, "the sign 0 is possible at one point with an integer β ≥ 0 only")
        require(not has(beta, 0), "the range of β holds 0")
        check_cover(self.columns, beta.start, beta.end, "columns")
        self.on_each_column(sign_holds, tau, beta, sign)
        return text

    def sign_at_integer(self, tau: Fraction, beta: int) -> int:
        """The sign of dΘ/dτ = -βF at one point, by integers g_n = q^n Θ(p/q, n) (check.md, section 5)."""
        meter = Meter(self.limits, self.left)
        p, q, g = tau.numerator, tau.denominator, [0, 0, 1]  # g_n for three n, the last one up to β - 1
        for n in range(1, beta):
            meter.spend(digits(g[0]) * (3 * digits(q) + 1) + digits(g[2]) * digits(p), 10)
            g = [g[1], g[2], (n - 1) * (n - 2) * q**3 * g[0] - p * g[2]]  # identities.md, (2)
        return (g[2] < 0) - (g[2] > 0) if beta else 0

    def check_zeros(self) -> str:
        """The number of zeros for every β of a range that is not an integer."""
        beta_text, counts, _ = entries(self.statement, "the statement", "beta", "counts", "kind")
        beta = read_range(beta_text, "β")
        require(beta.start >= 0, "a number of zeros is claimed for β < 0")
        self.limits.keep("beta", beta.end)
        cells = list(range(math.floor(beta.start), math.ceil(beta.end)))
        pairs = isinstance(counts, list) and all(isinstance(e, list) and [*map(type, e)] == [int, int] for e in counts)
        require(pairs and cells and [m for m, _ in counts] == cells, "counts does not list the cells of the range")
        check_cover(self.columns, beta.start, beta.end, "columns")
        self.on_each_column(zeros_hold, dict(counts))
        numbers = ", ".join(f"N = {number} on ({m}, {m + 1})" for m, number in counts)
        where = beta.text + (" that is not an integer" if beta.start < beta.end else "")
        return f"{where}, dΘ/dτ has exactly N real zeros, all simple: {numbers}"

    def check_brackets(self) -> str:
        """One zero in each bracket, and no other: there are as many zeros as changes of sign."""
        beta_text, brackets, _ = entries(self.statement, "the statement", "beta", "brackets", "kind")
        beta = rational(beta_text)
        require(beta > 0 and beta.denominator > 1, "β is not positive, or it is an integer")
        pairs = isinstance(brackets, list) and all(isinstance(pair, list) and len(pair) == 2 for pair in brackets)
        require(pairs and len(self.columns) == 1, "the brackets are not a list of pairs, or there is not one column")
        intervals = [(rational(low), rational(high)) for low, high in brackets]
        order = all(low < high for low, high in intervals) and all(one[1] <= two[0] for one, two in pairwise(intervals))
        require(order, "the brackets are not in order or overlap")
        check_cover(self.columns, beta, beta, "columns")
        self.on_each_column(brackets_hold, beta, intervals)
        where = ", ".join(f"({low}, {high})" for low, high in brackets) or "none"
        many = f"{len(intervals)} real zeros, all simple, one in each of the intervals:"
        number = "one real zero, simple, in" if len(intervals) == 1 else many
        return f"dΘ/dτ at β = {beta} has exactly {number} {where}"

    def check_one_column(self, beta: Fraction) -> None:
        """One column, the point β of the statement: F is compared in units of x^b at the one b of the column."""
        check_cover(self.columns, beta, beta, "columns")
        require([one[:2] for one in self.columns] == [(beta, beta)], "there is not one column, the point β")

    def check_force(self) -> str:
        """The contact force on the slow manifold stays positive, for every ε up to one."""
        names = ("alpha", "c1", "epsilon", "kind", "level", "tau")
        alpha, c1, epsilon_text, _, level_text, tau_text = entries(self.statement, "the statement", *names)
        system, epsilon, level = read_system(alpha, c1), rational(epsilon_text), rational(level_text)
        tau, meter = read_range(tau_text, "τ"), Meter(self.limits, self.left)
        require(epsilon > 0 and level > 0, "ε or the level is not positive")
        require(system.side() == 1, "C_1/Γ(-β) is not positive")
        require(system.compared(epsilon, level, meter) <= 0, "at this level the deviation exceeds the mean force")
        self.check_one_column(system.beta)
        self.on_each_column(force_holds, tau, (-1) ** math.floor(system.beta), level)
        return f"{self.of_system(alpha, c1)}, λ > 0 {tau.text} and every ε in (0, {epsilon}]"

    def check_lift_off(self) -> str:
        """The contact force on the slow manifold is negative at one τ, for every ε from one on."""
        names = ("alpha", "c1", "epsilon", "kind", "level", "tau")
        alpha, c1, epsilon_text, _, level_text, tau_text = entries(self.statement, "the statement", *names)
        system, epsilon, level = read_system(alpha, c1), rational(epsilon_text), rational(level_text)
        tau, meter = rational(tau_text), Meter(self.limits, self.left)
        require(epsilon > 0 and level > 0, "ε or the level is not positive")
        require(system.side() == -1, "C_1/Γ(-β) is not negative")
        require(system.compared(epsilon, level, meter) >= 0, "at this level the mean force exceeds the deviation")
        self.check_one_column(system.beta)
        self.on_each_column(lift_off_holds, system.beta, tau, (-1) ** math.floor(system.beta), level)
        return f"{self.of_system(alpha, c1)}, λ < 0 at τ = {tau} for every ε ≥ {epsilon}: contact is lost before"

    def check_slow_zeros(self) -> str:
        """Two zeros of the slow solution for every β of a range inside [4, 5] and every ε up to one."""
        names = ("beta", "epsilon", "eta", "kind")
        beta_text, epsilon_text, eta_text, _ = entries(self.statement, "the statement", *names)
        beta, epsilon, eta = read_range(beta_text, "β"), rational(epsilon_text), rational(eta_text)
        require(beta.start >= 4 and beta.end <= 5, "the range of β is not inside [4, 5]")
        require(beta.start < beta.end or beta.end.denominator > 1, "the range of β is one integer")
        require(epsilon > 0 and eta > 0, "ε or η is not positive")
        Meter(self.limits, self.left).spend((3 * digits(eta.numerator * eta.denominator)) ** 2, 20)
        require(2 * eta**3 >= epsilon, "2 η³ is less than ε")
        check_cover(self.columns, beta.start, beta.end, "columns")
        self.on_each_column(dip_holds, eta)
        where = beta.text + (" that is not an integer" if beta.start < beta.end else "")
        model = "on the slow manifold of the compliant model with α_1 = -1, C_1 ≠ 0"
        return f"{where}, every ε in (0, {epsilon}], {model} λ minus its mean has exactly two real zeros, both simple"

    def of_system(self, alpha: Any, c1: Any) -> str:
        """The system of a statement in words."""
        numbers = ", ".join(alpha)
        return f"on the slow manifold of the compliant model with α = ({numbers}) and C_1 = {c1}, τ = κ t ε^(-2/3)"


def check_text(data: bytes, limits: Limits | None = None, workers: int = 1) -> str:
    """The statement that a certificate proves."""
    limits = limits or Limits()
    budget = limits.work * 10**9 + WORK_PER_BYTE * len(data)
    try:
        version, statement, columns = read_certificate(data, limits)
        checker = Checker(statement, columns, limits, budget, workers)
        theta = {"sign": checker.check_sign, "zeros": checker.check_zeros, "brackets": checker.check_brackets}
        force = {"force": checker.check_force, "lift_off": checker.check_lift_off}
        checks = {1: theta, 2: force, 3: {"slow_zeros": checker.check_slow_zeros}}[version]
        kind = statement.get("kind") if isinstance(statement, dict) else None
        return checks[kind]() if isinstance(kind, str) and kind in checks else reject("unknown kind of statement")
    except Rejected:
        raise
    except Exception as error:  # whatever it is, nothing was verified
        raise Rejected(f"the check failed with {type(error).__name__}") from error


# ---------------------------------------------------------------------------------------------------------------------
# Command line.
# ---------------------------------------------------------------------------------------------------------------------

USAGE = "usage: python check.py [--workers N] [--limit NAME=NUMBER]... CERTIFICATE"
LIMITS = f"; the limits are {', '.join(Limits._fields)}"
STATUS = {"VERIFIED": 0, "REJECTED": 1, "usage": 64}  # exit codes; 64 as in sysexits.h


class Usage(Exception):
    """The command line is not one that can be run."""


def read_arguments(arguments: Sequence[str]) -> tuple[str, Limits, int]:
    """The file, the limits and the number of workers."""
    limits, workers, files = Limits(), 1, []
    waiting = iter(arguments)
    for word in waiting:
        option, equals, value = word.partition("=")
        if option not in ("--workers", "--limit"):
            if word == "--help":
                raise Usage(f"the exit status is 0 for VERIFIED alone, 1 for REJECTED, else {STATUS['usage']}{LIMITS}")
            if word.startswith("-"):
                raise Usage(f"there is no option {word} (a file of this name is ./{word})")
            files.append(word)
            continue
        text = value if equals else next(waiting, "")
        name, _, number = text.rpartition("=")
        if not re.fullmatch("[1-9][0-9]{0,11}", number):
            form = f", as NAME=NUMBER, not {text!r}{LIMITS}" if option == "--limit" else f", not {text!r}"
            raise Usage(f"{option} needs a positive integer{form}")
        if option == "--workers" and not name:
            workers = int(number)
        elif option == "--limit" and name in Limits._fields:
            limits = limits._replace(**{name: int(number)})
        else:
            raise Usage(f"there is no {option} {text!r}{LIMITS}")
    if len(files) != 1:
        raise Usage("one certificate is checked at a time")
    return files[0], limits, workers


def read_file(name: str, limits: Limits) -> bytes:
    """The bytes of a regular file; its length is looked at first."""
    # Without O_NONBLOCK the opening of a pipe would wait for a writer.
    descriptor = os.open(name, os.O_RDONLY | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_BINARY", 0))
    with open(descriptor, "rb") as file:
        status = os.fstat(descriptor)
        if not stat.S_ISREG(status.st_mode):
            raise Usage("this is not a regular file")
        limits.keep("bytes", status.st_size)
        return file.read(limits.bytes + 1)


def main(arguments: Sequence[str]) -> int:
    """One line of output and the exit status: 0 verified, 1 rejected, 64 not a certificate to be checked."""
    try:
        name, limits, workers = read_arguments(arguments)
        line = f"VERIFIED {check_text(read_file(name, limits), limits, workers)}"
    except Rejected as reason:
        line = f"REJECTED {reason}"
    except (MemoryError, OSError, ValueError, Usage) as error:
        line = f"{USAGE}: {error}"
    status = STATUS[re.split("[ :]", line)[0]]
    stream = sys.stderr if status else sys.stdout
    encoding = stream.encoding or "ascii"
    print(line.encode(encoding, "backslashreplace").decode(encoding), file=stream)
    return status


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
