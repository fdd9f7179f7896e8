"""Check a certificate about the sign or the zeros of dΘ/dτ. Usage: python check.py CERTIFICATE

The format is on the page certificate.md; every lemma named here is proved there or on check.md. Nothing is shared with
the code that finds certificates: no Gamma function, no value at τ = 0, no ball arithmetic. F(τ) = Θ(τ, b), b = β - 1.
"""

from __future__ import annotations

import hashlib
import json
import math
import re
import sys
from collections import namedtuple
from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from functools import lru_cache
from itertools import count, islice, pairwise
from typing import Any, NamedTuple, NoReturn

MAX_BYTES, MAX_LINE, MAX_LISTS = 20_000_000, 2_000_000, 200_000
MAX_BETA, MAX_TAU, MAX_BITS, MAX_SPLITS, MAX_WORK = 200, 200, 3_000, 10, 200_000_000
HYPOTHESES = ["certificate", "fold", "identities", "initial_values", "laplace", "negative", "tails"]
NUMBER = "-?(?:0|[1-9][0-9]{0,3999})(?:/[1-9][0-9]{0,3999})?"
RANGE = rf"([\[(])(-inf|{NUMBER}), (inf|{NUMBER})([\])])"
POINTS = {"laplace": 0, "taylor": 0, "left": 1, "right": 1, "sign": 2, "monotone": 2, "fold": 2, "hinge": 2}
VALUES: dict[str, tuple[int, ...]] = {"right": (0, 1), "sign": (-1, 1), "monotone": (-1, 1)}  # of v, s and d
INFINITY = math.inf  # stands for an infinite end of a range; no float takes part in a bound
STEP = Fraction(2)  # between the points from which F is carried on
Box = tuple[Fraction, Fraction, Fraction, Fraction]  # b from, b to, τ from, τ to
Range = namedtuple("Range", "start end closed text")  # of τ or β; closed at the start, closed at the end; in words
Piece = namedtuple("Piece", "start end kind points value")  # covers [start, end] in τ; value is its s, d or v, or 0
Column = namedtuple("Column", "start end cell pieces")  # β in [start, end]; b in [cell, cell + 1] or in (-∞, 0]


class Rejected(Exception):
    """The certificate does not prove its statement; the text says why."""


def reject(reason: str) -> NoReturn:
    """End the check."""
    raise Rejected(reason)


def require(condition: object, reason: str) -> None:
    """End the check unless a condition holds."""
    if not condition:
        reject(reason)


def read_line(line: bytes) -> Any:
    """One line of canonical JSON: no key twice, integers only, and their length is bounded before the conversion."""

    def number(text: str) -> int:
        require(re.fullmatch("-?[0-9]{1,4000}", text), f"{text!a:.50} is not an integer of at most 4000 digits")
        return int(text)

    def keys(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
        return dict(pairs) if len(dict(pairs)) == len(pairs) else reject("a key occurs twice in one object")

    try:
        text = line.decode()
        value = json.loads(text, object_pairs_hook=keys, parse_int=number, parse_float=number, parse_constant=number)
        canonical = json.dumps(value, sort_keys=True, separators=(",", ":"))
    except (RecursionError, ValueError) as error:
        reasons = {RecursionError: "JSON is nested too deeply", UnicodeDecodeError: "the text is not UTF-8"}
        reject(reasons.get(type(error), "a line is not JSON"))
    return value if canonical == text else reject("a line is not canonical JSON")


def entries(value: Any, name: str, *keys: str) -> list[Any]:
    """The values of an object that has exactly these keys."""
    require(isinstance(value, dict) and sorted(value) == sorted(keys), f"{name} has not the keys {', '.join(keys)}")
    return [value[key] for key in keys]


def rational(value: Any) -> Fraction:
    """A rational number as text in lowest terms."""
    number = isinstance(value, str) and re.fullmatch(NUMBER, value)
    require(number, f"{value!a:.50} is not a rational number as text of at most 4000 digits")
    return Fraction(value) if str(Fraction(value)) == value else reject(f"{value!a:.50} is not in lowest terms")


def one_of(value: Any, allowed: Sequence[int], name: str) -> int:
    """An integer (no boolean) out of a few."""
    return value if type(value) is int and value in allowed else reject(f"{name} is {value!a:.50}")


def has(where: Range, x: Any) -> bool:
    """Whether x is in a range."""
    return bool(where.start < x < where.end or (x, True) in zip(where[:2], where.closed, strict=True))


def read_range(value: Any, name: str) -> Range:
    """A range as text, and in words."""
    match = re.fullmatch(RANGE, value) if isinstance(value, str) else None
    left, low, high, right = match.groups() if match else reject(f"{value!a:.50} is not a range")
    start, end = -INFINITY if low == "-inf" else rational(low), INFINITY if high == "inf" else rational(high)
    require(left + low != "[-inf" and high + right != "inf]", f"the range {value!a:.50} is closed at infinity")
    require(start < end or (start == end and left + right == "[]"), f"the range {value!a:.50} is empty")
    text = f"for every {name} in {value}" if start < end else f"at {name} = {low}"
    return Range(start, end, (left == "[", right == "]"), text)


def check_cover(parts: Sequence[Any], start: Any, end: Any, name: str) -> None:
    """Each part begins where the one before it ends, and together they just cover a range."""
    for before, after in pairwise(parts):
        require(before.end >= after.start, f"a gap between {name} at {before.end!s:.50}")
        require(before.end <= after.start, f"an overlap of {name} at {after.start!s:.50}")
        require(before.start < before.end and after.start < after.end, f"one of several {name} is a single point")
    require(parts and parts[0].start <= start and parts[-1].end >= end, f"the {name} do not cover the whole range")
    require(parts[0].end >= start and parts[-1].start <= end, f"one of the {name} lies outside the range")


def read_piece(value: Any) -> Piece:
    """The shape of one piece."""
    kind = value[0] if isinstance(value, list) and value else ""
    require(isinstance(kind, str) and kind in POINTS, f"unknown piece {value!a:.50}")
    length, values, arguments = POINTS[kind], VALUES.get(kind, ()), value[1:]
    require(len(arguments) == length + bool(values), f"a piece {kind} has {len(arguments)} arguments")
    points = [rational(point) for point in arguments[:length]]
    start: Any = Fraction(0) if kind == "taylor" else -INFINITY if kind in ("laplace", "left") else points[0]
    end: Any = INFINITY if kind in ("laplace", "taylor", "right") else points[-1]
    require(start < end, f"a piece {kind} does not go from left to right")
    last = one_of(arguments[length], values, f"the last entry of a piece {kind}") if values else 0
    return Piece(start, end, kind, points, last)


def read_column(line: bytes) -> Column:
    """One column and its place in a cell."""
    beta, pieces = entries(read_line(line), "a column", "beta", "pieces")
    require(isinstance(beta, list) and len(beta) == 2 and isinstance(pieces, list), "a column has not its two lists")
    start: Any = -INFINITY if beta[0] == "-inf" else rational(beta[0])
    end, unbounded = rational(beta[1]), isinstance(start, float)
    require(not unbounded or pieces == [["laplace"]], "a column that begins at -inf is not the piece laplace alone")
    cell = -1 if unbounded else math.floor(start) - 1 - (start == end == math.floor(start))
    require(start <= end, f"the column {beta!a:.50} ends before it begins")
    require(end <= max(cell + 2, 1), f"the column {beta!a:.50} crosses an integer")
    return Column(start, end, cell, [read_piece(piece) for piece in pieces])


def read_certificate(data: bytes) -> tuple[Any, list[Column]]:
    """The hash, the header and the columns."""
    require(len(data) <= MAX_BYTES, f"the certificate is longer than {MAX_BYTES} bytes")
    body, last = data[:-72], data[-72:]
    require(re.fullmatch(rb"(?s).*\nsha256 [0-9a-f]{64}\n", data), "the last line is not sha256 and a hash")
    require(hashlib.sha256(body).hexdigest().encode() == last[7:71], "the hash does not match")
    lines = body[:-1].split(b"\n")
    small = max(map(len, lines)) <= MAX_LINE and body.count(b"[") <= MAX_LISTS
    require(small, f"a line is longer than {MAX_LINE} bytes, or there are more than {MAX_LISTS} lists")
    names = ("format", "hypotheses", "statement", "version")
    form, hypotheses, statement, version = entries(read_line(lines[0]), "the header", *names)
    require(form == "gspot_verified certificate", f"the format is {form!a:.50}")
    one_of(version, (1,), "the version")
    require(hypotheses == HYPOTHESES, "the hypotheses are not the pages that this checker knows")
    return statement, [read_column(line) for line in lines[1:]]


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


def moved(series: list[Model], u: Fraction, p: int) -> list[Model]:
    """Σ C(k,i) a_k u^(k-i), i = 0, 1, 2, for |u| ≤ 1; powers of u have p bits (check.md, section 3)."""
    powers, result, norms = [1 << p], [], [a.norm() for a in series]
    for _ in series:
        powers.append(powers[-1] * u.numerator // u.denominator)
    for i in range(3):
        weights = [math.comb(k, i) * powers[max(k - i, 0)] for k in range(len(series))]
        m = [sum(map(int.__mul__, weights, column)) >> p for column in zip(*(a.m for a in series), strict=True)]
        error = sum(abs(w) * a.error for w, a in zip(weights, series, strict=True))
        error += sum(math.comb(k, i) * k * norm for k, norm in enumerate(norms))
        result.append(Model(m, (error >> p) + 1 + len(m)))
    return result


class Local:
    """F/x^b for b = (centre + radius η)/unit, [low, high] is |η| ≤ 1/2, carried along τ from -x (check.md)."""

    def __init__(self, low: Fraction, high: Fraction, bits: int, spend: Callable[[int], None]) -> None:
        self.unit = 2 * math.lcm(low.denominator, high.denominator)
        self.centre, self.radius = int((low + high) / 2 * self.unit), int((high - low) * self.unit)
        self.reach = (abs(self.centre) + self.radius) // self.unit + 1  # ≥ |b| on the disc
        self.spend = spend
        # Heuristics: the start, a multiple of STEP, the bits and the degrees. Any choice is correct.
        self.x = 2 * math.ceil(max((1.05 * bits) ** (2 / 3), 1.5 * self.reach ** (2 / 3), 4.0) / 2)
        self.p = bits + 60 + self.x // 4 + 3 * math.isqrt(self.x)
        width, goals = float(high - low) * (math.log(self.x) + 2), (0.7 * bits + 28, 20.0)
        log_width = math.log(width) if width else -INFINITY
        self.size, self.few = (next(d for d in count(1) if math.lgamma(d) - d * log_width > goal) for goal in goals)
        self.anchors, self.solutions = [self.at_minus_x()], lru_cache(2)(self.solutions_at)

    def linear(self, a: Model, i: int, divisor: int) -> Model:
        """(i - b) a/divisor; the coefficient beyond the degree goes into the error."""
        n, r, d = i * self.unit - self.centre, self.radius, divisor * self.unit
        m = [(n * x - r * y) // d for x, y in zip(a.m, [0, *a.m], strict=False)]
        return Model(m, ((abs(n) + r) * a.error + r * abs(a.m[-1])) // abs(d) + 1 + len(m))

    def recurrence(self, point: Fraction, s: Fraction, start: Sequence[Model]) -> Iterator[Model]:
        """(k+1)(k+2)(k+3) c_{k+3} = τ (k+1) c_{k+1} + (k - b) c_k at τ = point, for a_k = c_k s^k (section 2)."""
        first, second = point * s * s, s**3 / self.unit
        common = math.lcm(first.denominator, second.denominator)
        alpha, beta = int(first * common), int(second * common)
        zero, one, two = start
        cost = (8 + len(zero.m)) * (1 + (self.p + common.bit_length()) // 512)
        yield from start
        for k in count():
            self.spend(cost)
            n, r, f = beta * (k * self.unit - self.centre), beta * self.radius, alpha * (k + 1)
            d = common * (k + 1) * (k + 2) * (k + 3)
            m = [(f * y + n * x - r * z) // d for x, y, z in zip(zero.m, one.m, [0, *zero.m], strict=False)]
            error = (abs(f) * one.error + (abs(n) + r) * zero.error + r * abs(zero.m[-1])) // d + 1 + len(m)
            zero, one, two = one, two, Model(m, error)
            yield two

    def expand(self, point: Fraction, s: Fraction, start: Sequence[Model]) -> list[Model]:
        """Coefficients until the tail lemma (section 2) holds with q ≤ 1/2; the last error bounds the rest too."""
        square, cube, small = math.ceil(abs(point) * s * s), math.ceil(s**3), 2 * len(start[0].m) + 2
        a: list[Model] = []
        for model in self.recurrence(point, s, start):
            a.append(model)
            i = len(a) - 5
            falls = 2 * (square * (i + 1) + cube * (i + self.reach + 2)) <= (i + 1) * (i + 2) * (i + 3)
            if i >= 0 and falls and max(last.norm() for last in a[-3:]) <= small:
                break
        a[-1] = Model(a[-1].m, a[-1].error + 3 * max(last.norm() for last in a[-3:]))
        return a

    def at_minus_x(self) -> list[Model]:
        """a_0, a_1, a_2 at τ = -x with the scale STEP: the enveloping series on the disc (section 1)."""
        x, unit, parts = self.x, self.unit, []
        term, bound = Model([1 << self.p] + [0] * (self.size - 1), 0), 1 << self.p
        for k in count():
            once = self.linear(term, 3 * k, x)
            twice = self.linear(once, 3 * k + 1, x)
            parts.append((term, once, twice))
            term = self.linear(twice, 3 * k + 2, -3 * (k + 1) * x)
            factors = (abs(i * unit - self.centre) + self.radius for i in range(3 * k, 3 * k + 3))
            before, bound = bound, -(-bound * math.prod(factors) // ((unit * x) ** 3 * 3 * (k + 1)))
            if 3 * k + 2 > self.reach and bound >= before:  # N = k + 1: 3N ≥ Re b + 1/2; the least bound is reached
                break
        far = 3 * k + 3 + self.reach
        bound *= 5 ** -(-self.radius // unit)
        rests = (bound, bound * far // x + 1, bound * far * (far + 1) // (x * x) + 1)
        sums = [[sum(m) for m in zip(*(t.m for t in terms), strict=True)] for terms in zip(*parts, strict=True)]
        errors = [sum(t.error for t in terms) for terms in zip(*parts, strict=True)]
        values = [Model(m, error + rest) for m, error, rest in zip(sums, errors, rests, strict=True)]
        return [v.times(STEP**i / (1 + i // 2)) for i, v in enumerate(values)]

    def solutions_at(self, index: int) -> list[list[Model]]:
        """Series at an anchor: of the midpoints of the values there as one solution, and of three basic solutions."""
        basis = [[Model([(i == j) << self.p] + [0] * (self.few - 1), 0) for j in range(3)] for i in range(3)]
        starts = ([Model(v.m, 0) for v in self.anchors[index]], *basis)
        return [self.expand(index * STEP - self.x, STEP, start) for start in starts]

    def carried(self, index: int, u: Fraction) -> list[Model]:
        """a_0, a_1, a_2 at a distance u STEP from an anchor: the errors are carried by a 3x3 matrix (section 3)."""
        exact, *matrix = (moved(series, u, self.p) for series in self.solutions(index))
        errors = [v.error for v in self.anchors[index]]
        norms = (map(Model.norm, row) for row in zip(*matrix, strict=True))
        carried = (sum(map(int.__mul__, row, errors)) >> self.p for row in norms)
        return [Model(v.m, v.error + error + 1) for v, error in zip(exact, carried, strict=True)]

    def values(self, point: Fraction, s: Fraction) -> list[Model]:
        """a_0, a_1, a_2 at a point with the scale s."""
        index, rest = divmod(point + self.x, STEP)
        require(index >= 0, "out of the checker's range: τ before the start")
        while len(self.anchors) <= index:
            self.anchors.append(self.carried(len(self.anchors) - 1, Fraction(1)))
        return [v.times((s / STEP) ** i) for i, v in enumerate(self.carried(index, rest / STEP))]

    def in_b(self, a: Model) -> Model:
        """A positive multiple of d/db + w, w near log x, for |η| ≤ 1/2: Cauchy's estimate (section 4)."""
        n, d = self.radius * round(math.log(self.x) * 2**16), self.unit << 16
        m = [d * j * y + n * x for j, (y, x) in enumerate(zip([*a.m[1:], 0], a.m, strict=True), 1)]
        return Model(m, (2 * d + n) * a.error)


class Checker:
    """One certificate: signs of F and its derivatives on boxes, at rising accuracy, within a budget of work."""

    def __init__(self, statement: Any, columns: list[Column]) -> None:
        self.statement, self.columns = statement, columns
        self.left, self.bits, self.local = MAX_WORK, 64, lru_cache(12)(Local)

    def spend(self, amount: int) -> None:
        """Take from the budget: operations on numbers of about 500 bits."""
        self.left -= amount
        require(self.left >= 0, "out of the checker's range: the budget of work is used up")

    def begin(self, column: Column, start: Any, end: Any, points: Sequence[Fraction] = ()) -> None:
        """The pieces of a column cover [start, end]; the limits of this checker; a heuristic first accuracy."""
        check_cover(column.pieces, start, end, "pieces")
        distances = [*map(abs, points), *(abs(x) for piece in column.pieces for x in piece.points)]
        reach, far = max(abs(column.start), abs(column.end)), max(distances, default=0)
        if distances and (reach > MAX_BETA or far > MAX_TAU):
            reject(f"out of the checker's range: |β| > {MAX_BETA} or |τ| > {MAX_TAU}")
        self.bits = 48 + int(float(far) ** 1.5 + 3.2 * float(min(max(column.end, 0), MAX_BETA)))

    def parts(self, box: Box, order: int, bits: int) -> tuple[int, int, int, int]:
        """F^(order), or ∂F/∂b + w F if order = -1: the value in the middle, what τ adds, what b adds, the error."""
        low, high, start, end = box
        local, middle, i = self.local(low, high, bits, self.spend), (start + end) / 2, max(order, 0)
        # At a point the scale matters for rounding only.
        s = (end - start) / 2 or Fraction(1 << max(0, int(abs(start)).bit_length() - 1))
        values = local.values(middle, s)
        series = local.expand(middle, s, values) if start < end else islice(local.recurrence(middle, s, values), i + 1)
        models = [a.times(Fraction(math.comb(k, i))) for k, a in enumerate(series)][i:]
        models = models if order >= 0 else [local.in_b(a) for a in models]
        error = sum(a.error for a in models)
        return models[0].m[0], sum(a.spread(0) for a in models[1:]), models[0].spread(1), error

    def sign(self, box: Box, order: int, splits: int = MAX_SPLITS, bits: int = 0) -> int:
        """The one sign on the whole box, or 0 when none is confirmed."""
        bits = max(bits, self.bits)
        middle, in_tau, in_b, error = self.parts(box, order, bits)
        if abs(middle) > in_tau + in_b + error:
            return 1 if middle > 0 else -1
        if 4 * error >= max(abs(middle), in_tau + in_b):
            return self.sign(box, order, splits, bits * 3 // 2) if bits < MAX_BITS else 0
        low, high, start, end = box
        b, tau = (low + high) / 2, (start + end) / 2
        cuts = ((low, high, start, tau), (low, high, tau, end)), ((low, b, start, end), (b, high, start, end))
        one, two = cuts[in_tau < in_b]
        found = self.sign(one, order, splits - 1, bits) if splits else 0
        return found if found and self.sign(two, order, splits - 1, bits) == found else 0

    def left_holds(self, low: Fraction, high: Fraction, cell: int, x: Fraction) -> bool:
        """The hypothesis of tails.md, τ → -∞, in integers."""
        n, unit = 3 * max(1, cell // 3 + 1), math.lcm(low.denominator, high.denominator)
        self.spend((n * (1 + (x.numerator * x.denominator * unit).bit_length() // 64)) ** 2 // 50)
        product = math.prod(int(max(abs(low - i), abs(high - i)) * unit) for i in range(n))
        left = (x.numerator * unit) ** n * 3 ** (n // 3) * math.factorial(n // 3)
        return low >= -1 and x > 0 and left > product * x.denominator**n

    def right_signs(self, box: Box, n: int) -> list[int]:
        """The certain signs of c_0, ..., c_n, (-1)^(n+1) (tails.md); one between opposite signs may be open."""
        for splits in (0, 3):
            signs = [*(self.sign(box, k, splits) for k in range(n + 1)), (-1) ** (n + 1)]
            if all(sign or (k and signs[k - 1] * signs[k + 1] == -1) for k, sign in enumerate(signs)):
                return [sign for sign in signs if sign]
        return []

    def piece_sign(self, piece: Piece, column: Column) -> int:
        """Check the hypotheses of a piece. The sign of F that it gives at its ends, or 0 for a piece monotone."""
        (start, end, kind, points, value), low, high, cell = piece, column.start - 1, column.end - 1, column.cell
        name = f"the piece {kind} from τ = {start!s:.50} to {end!s:.50} of the column from β = {column.start!s:.50}"
        if kind in ("laplace", "taylor"):
            return 1 if high <= 0 else reject(f"{name} needs b ≤ 0")
        require(high > 0 or kind in ("left", "sign"), f"{name} is not allowed for b ≤ 0")
        if kind == "left":
            return 1 if self.left_holds(low, high, cell, -points[0]) else reject(f"{name}: the remainder is too large")
        box = (low, high, points[0], points[-1])
        if kind == "right":
            signs = self.right_signs(box, cell)
            changes = sum(a != b for a, b in pairwise(signs))
            require(signs, f"{name}: the signs of c_0, ..., c_{cell} are not confirmed")
            return signs[0] if changes == value else reject(f"{name}: {changes} changes of sign, not {value}")
        if kind == "fold":
            around = start < 0 < end and 0 in (column.start % 3, column.end % 3)
            require(around, f"{name} is not around τ = 0 at β = 3, 6, 9, ...")
            wide = (low, max(high, low + Fraction(1, 256)), points[0], points[1])
            orders = [(box, 2), (wide, -1), *(((low, high, point, point), 0) for point in points)]
            holds = all(self.sign(where, order) == 1 for where, order in orders)
            return 1 if holds else reject(f"{name}: a hypothesis of the fold is not confirmed")
        found = self.sign(box, 0 if kind == "sign" else 1)
        require(found, f"{name}: no sign is confirmed")
        if kind == "hinge":
            require(0 in points, f"{name} does not begin or end at τ = 0")
            value = found if start == 0 else -found
            return value if value == (-1 if cell % 3 == 1 else 1) else reject(f"{name}: F(0, b) has the other sign")
        require(found == value, f"{name}: the sign is {found}, not {value}")
        return value if kind == "sign" else 0

    def check_sign(self) -> str:
        """dΘ/dτ = -βF has one sign on a range of τ and a range of β."""
        claimed, tau_text, beta_text, _ = entries(self.statement, "the statement", "sign", "tau", "beta", "kind")
        sign, tau, beta = one_of(claimed, (-1, 0, 1), "the sign"), read_range(tau_text, "τ"), read_range(beta_text, "β")
        text = f"dΘ/dτ {'=><'[sign]} 0 {tau.text} and {beta.text}".replace("and for every", "and every")
        if tau.start == tau.end and beta.start == beta.end and beta.end in range(MAX_BETA + 1):
            require(not self.columns, "at one point with an integer β there is no column")
            p, q, f = tau.start.numerator, tau.start.denominator, [0, 0, 1]  # f: q^n Θ(τ, n) for three n, up to β - 1
            for n in range(1, int(beta.end)):
                f = [f[1], f[2], (n - 1) * (n - 2) * q**3 * f[0] - p * f[2]]  # identities.md, (2)
            found = (f[2] < 0) - (f[2] > 0) if beta.end else 0
            return text if found == sign else reject(f"the sign at this integer β is {found}, not {sign}")
        require(sign, "the sign 0 is possible at one point with an integer β ≥ 0 only")
        require(not has(beta, 0), "the range of β holds 0")
        check_cover(self.columns, beta.start, beta.end, "columns")
        for column in self.columns:
            self.begin(column, tau.start, tau.end)
            zero = has(tau, 0) and any(end % 3 in (0, 2) and has(beta, end) for end in (column.start, column.end))
            for piece in column.pieces:
                kind = piece.kind
                require(kind != "monotone" and (kind, piece.value) != ("right", 1), f"a piece {kind} gives no sign")
                require(kind != "fold" or column.start % 3 == 0, "a fold at the upper end of its column has zeros")
                require(kind not in ("fold", "hinge") or not zero, f"τ = 0 is a zero in a piece {kind} at an integer β")
                found = self.piece_sign(piece, column) * (-1 if beta.end > 0 else 1)
                require(found == sign, f"a piece {kind} gives dΘ/dτ the sign {found}, not {sign}")
        return text

    def count_zeros(self, column: Column, points: Sequence[Fraction] = ()) -> int:
        """The number of zeros of F for b in the open cell; all are simple."""
        self.begin(column, -INFINITY, INFINITY, points)
        before, direction, zeros = 0, 0, 0
        for piece in column.pieces:
            require(piece.kind != "hinge", "a piece hinge does not count zeros")
            sign = self.piece_sign(piece, column)
            if piece.kind == "monotone":
                require(before, "a piece monotone comes first")
                require(direction in (0, piece.value), "neighbouring pieces monotone have two directions")
                direction = piece.value
                continue
            change = before not in (0, sign)
            require(direction or not change, "two neighbouring pieces give F different signs where they meet")
            require(not change or sign == direction, "a change of sign is against the direction of a piece monotone")
            zeros += change + (piece.value if piece.kind == "right" else 0)
            zeros += 2 if piece.kind == "fold" and column.end % 3 == 0 else 0
            before, direction = sign, 0
        return zeros if direction == 0 else reject("a piece monotone comes last")

    def check_zeros(self) -> str:
        """The number of zeros for every β of a range that is not an integer."""
        beta_text, counts, _ = entries(self.statement, "the statement", "beta", "counts", "kind")
        beta = read_range(beta_text, "β")
        require(beta.start >= 0 and beta.end <= MAX_BETA, f"out of the checker's range: β < 0 or β > {MAX_BETA}")
        cells = list(range(math.floor(beta.start), math.ceil(beta.end)))
        pairs = isinstance(counts, list) and all(isinstance(e, list) and [*map(type, e)] == [int, int] for e in counts)
        require(pairs and cells and [m for m, _ in counts] == cells, "counts does not list the cells of the range")
        check_cover(self.columns, beta.start, beta.end, "columns")
        for column in self.columns:
            found, claimed = self.count_zeros(column), dict(counts).get(column.cell + 1)
            require(found == claimed, f"{found} zeros on the column from β = {column.start!s:.50}, not {claimed}")
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
        points = [rational(end) for pair in brackets for end in pair]
        order = all(a < b or (a == b and i % 2) for i, (a, b) in enumerate(pairwise(points)))
        require(order, "the brackets are not in order or overlap")
        check_cover(self.columns, beta, beta, "columns")
        number = self.count_zeros(self.columns[0], points)
        require(number == len(brackets), f"there are {number} zeros, not {len(brackets)}")
        signs = [self.sign((beta - 1, beta - 1, point, point), 0) for point in points]
        for low, high, pair in zip(signs[::2], signs[1::2], brackets, strict=True):
            require(low * high == -1, f"F does not change its sign between {pair[0]:.50} and {pair[1]:.50}")
        where = ", ".join(f"({low}, {high})" for low, high in brackets) or "none"
        return f"dΘ/dτ at β = {beta} has exactly {number} real zeros, all simple, one in each of the intervals: {where}"


def check_text(data: bytes) -> str:
    """The statement that a certificate proves."""
    try:
        checker = Checker(*read_certificate(data))
        checks = {"sign": checker.check_sign, "zeros": checker.check_zeros, "brackets": checker.check_brackets}
        kind = checker.statement.get("kind") if isinstance(checker.statement, dict) else None
        return checks[kind]() if isinstance(kind, str) and kind in checks else reject("unknown kind of statement")
    except (ArithmeticError, AttributeError, LookupError, MemoryError, RecursionError, TypeError, ValueError) as error:
        raise Rejected(f"the check failed with {type(error).__name__}") from error


def main(arguments: Sequence[str]) -> int:
    """The command line: one line of output and the exit status."""
    try:
        with open(arguments[0] if len(arguments) == 1 else "", "rb") as file:
            line, stream, status = f"VERIFIED {check_text(file.read(MAX_BYTES + 1))}", sys.stdout, 0
    except Rejected as reason:
        line, stream, status = f"REJECTED {reason}", sys.stderr, 1
    except (OSError, ValueError):
        line, stream, status = "usage: python check.py CERTIFICATE", sys.stderr, 64
    print(line.encode(stream.encoding or "ascii", "backslashreplace").decode(stream.encoding or "ascii"), file=stream)
    return status


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
