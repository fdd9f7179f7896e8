"""Values of Θ: F(τ) = Θ(τ, b), b = β - 1, and its derivatives on boxes of τ and b, with all errors (check.md).

Nothing is shared with the code that finds certificates: no Gamma function, no value at τ = 0, no ball arithmetic.

    Models        polynomials in b with a bound on their error; their arithmetic, paid as it is done (Models, section 6)
    F on a disc   F for a complex disc of b, carried along τ (sections 1 to 3)
    Values        F^(d)/d! on a box, with its errors and its scale (section 4)
    Theta         more bits, smaller boxes, or no answer (section 4)
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from itertools import count
from typing import NamedTuple

from limits import DIGIT, Limits, Meter, digits, require

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

    def digits(self) -> int:
        """The length of all its integers."""
        return (sum(map(int.bit_length, self.m)) + self.error.bit_length()) // DIGIT + len(self.m) + 1

    def bytes(self) -> int:
        """The memory that it takes: 4 bytes for a digit, at most 40 beside for an integer."""
        return 4 * self.digits() + 40 * len(self.m) + 120


def combined(f: int, y: Model, n: int, r: int, x: Model, d: int, meter: Meter) -> Model:
    """(f y + (n - r η) x)/d: a coefficient is rounded by less than 1, the one beyond the degree goes into the error."""
    products = x.digits() * digits(n, r, d) + y.digits() * digits(f, d)
    meter.spend(products, 4 * len(x.m) + 20)
    m = [(f * b + n * a - r * c) // d for b, a, c in zip(y.m, x.m, [0, *x.m[:-1]], strict=True)]
    error = abs(f) * y.error + (abs(n) + abs(r)) * x.error + abs(r * x.m[-1])
    return Model(m, error // abs(d) + 1 + len(m))


def times(a: Model, factor: Fraction, meter: Meter) -> Model:
    """A rational multiple."""
    return combined(0, a, factor.numerator, 0, a, factor.denominator, meter)


def weighted(rows: Sequence[tuple[list[int], list[int]]], models: list[Model], p: int, meter: Meter) -> list[Model]:
    """For each row Σ w_k a_k/2^p, where the weight w_k is known up to t_k; a row is the w_k and the t_k."""
    size, degree = sum(a.digits() for a in models), len(models[0].m)
    meter.spend(sum(digits(max(map(abs, w))) for w, _ in rows) * size, len(models) * (len(rows) * degree + 10))
    norms, result = [a.norm() for a in models], []
    for w, t in rows:
        m = [sum(map(int.__mul__, w, column)) >> p for column in zip(*(a.m for a in models), strict=True)]
        error = sum(abs(one) * a.error for one, a in zip(w, models, strict=True)) + sum(map(int.__mul__, t, norms))
        result.append(Model(m, (error >> p) + 1 + len(m)))
    return result


def rounded_powers(u: Fraction, number: int, p: int, meter: Meter) -> list[int]:
    """1, u, u², … for |u| ≤ 1, in units of 2^-p, rounded down one after the other: the k-th is wrong by k units."""
    n, d = u.numerator, u.denominator
    meter.spend(number * (p // DIGIT + 1) * digits(n, d), 4 * number)
    powers = [1 << p]
    for _ in range(number - 1):
        powers.append(powers[-1] * n // d)
    return powers


def moved(series: list[Model], u: Fraction, p: int, meter: Meter) -> list[Model]:
    """Σ C(k,i) a_k u^(k-i), i = 0, 1, 2, for |u| ≤ 1; powers of u have p bits (check.md, section 3)."""
    powers = rounded_powers(u, len(series), p, meter)
    terms = [[math.comb(k, i) for k in range(len(series))] for i in range(3)]
    rows = [
        ([c * powers[max(k - i, 0)] for k, c in enumerate(row)], [c * k for k, c in enumerate(row)])
        for i, row in enumerate(terms)
    ]
    return weighted(rows, series, p, meter)


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


def next_bound(bound: int, n: int, centre: int, radius: int, unit: int, x: int, meter: Meter) -> int:
    """From a bound on sup |(-b)_{3n}|/(3^n n! x^(3n)) to one for n + 1, b = (centre + radius η)/unit; rounded up."""
    factors = [abs(i * unit - centre) + radius for i in range(3 * n, 3 * n + 3)]
    return -(-meter.product((bound, 1), *((f, 1) for f in factors)) // ((unit * x) ** 3 * 3 * (n + 1)))


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
        """(i - b) a/divisor."""
        return combined(0, a, i * self.unit - self.centre, self.radius, a, divisor * self.unit, self.meter)

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
            before, bound = bound, next_bound(bound, k, self.centre, self.radius, self.unit, x, self.meter)
            # N = k + 1: 3N ≥ B + 1/2. The rest is small enough, or it is the least.
            if 3 * k + 2 > self.reach and (bound <= 1 or bound >= before):
                break
        growth = 5 ** -(-self.radius // self.unit)
        left_out = rests(growth * bound, k + 1, self.reach, x)
        values = [Model(m, error + rest) for m, error, rest in zip(sums, errors, left_out, strict=True)]
        return [times(value, STEP**i / (1 + i // 2), self.meter) for i, value in enumerate(values)]

    def recurrence(self, point: Fraction, s: Fraction, start: Sequence[Model]) -> Iterator[Model]:
        """(k+1)(k+2)(k+3) c_{k+3} = τ (k+1) c_{k+1} + (k - b) c_k at τ = point, for a_k = c_k s^k (section 2)."""
        first, second = point * s * s, s**3 / self.unit
        common = math.lcm(first.denominator, second.denominator)
        alpha, beta = int(first * common), int(second * common)
        zero, one, two = start
        yield from start
        for k in count():
            n, r, d = beta * (k * self.unit - self.centre), beta * self.radius, common * (k + 1) * (k + 2) * (k + 3)
            zero, one, two = one, two, combined(alpha * (k + 1), one, n, r, zero, d, self.meter)
            yield two

    def expand(self, point: Fraction, s: Fraction, start: Sequence[Model]) -> list[Model]:
        """Coefficients until the tail lemma (section 2) holds with q ≤ 1/2; the last error bounds the rest too."""
        square, cube = tail_factors(point, s)
        small = 2 * len(start[0].m) + 2
        kept, most = 0, self.meter.limits.memory * 10**6 // 8
        a, norms = list[Model](), list[int]()
        for model in self.recurrence(point, s, start):
            a.append(model)
            norms.append(model.norm())
            kept += model.bytes()
            if kept > most:
                self.meter.limits.beyond("memory")
            if tail_falls(square, cube, len(a) - 5, self.reach + 2) and max(norms[-3:]) <= small:
                break
        a[-1] = Model(a[-1].m, a[-1].error + 3 * max(norms[-3:]))
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
        carried = self.carried(index, rest / STEP)
        return [times(value, (s / STEP) ** i, self.meter) for i, value in enumerate(carried)]

    def in_b(self, a: Model) -> Model:
        """radius 2^16 (d/db + w) of a model for |η| ≤ 1/2, w near log x: Cauchy's estimate (section 4)."""
        n, d = self.radius * round(math.log(self.x) * 2**16), self.unit << 16
        m = [d * j * y + n * x for j, (y, x) in enumerate(zip([*a.m[1:], 0], a.m, strict=True), 1)]
        return Model(m, (2 * d + n) * a.error)


# ---------------------------------------------------------------------------------------------------------------------
# Values: check.md, section 4.
# ---------------------------------------------------------------------------------------------------------------------

Box = tuple[Fraction, Fraction, Fraction, Fraction]  # b from, b to, τ from, τ to


class Scale(NamedTuple):
    """x^b/(2^p s), the unit of a value, b being that of the box."""

    x: int
    p: int
    s: Fraction


class Value(NamedTuple):
    """A number on a box, in units of its scale: the middle up to in_tau + in_b (what τ and b add) + error."""

    middle: Fraction | int
    in_tau: Fraction | int
    in_b: Fraction | int
    error: Fraction | int
    scale: Scale

    def slack(self) -> Fraction | int:
        """How far it may be from the middle."""
        return self.in_tau + self.in_b + self.error

    def low(self) -> Fraction | int:
        """Not more than the least value on the box."""
        return self.middle - self.slack()

    def high(self) -> Fraction | int:
        """Not less than the greatest value on the box."""
        return self.middle + self.slack()

    def sign(self) -> int:
        """The certain sign on the whole box, or 0."""
        return (self.low() > 0) - (self.high() < 0)

    def is_blurred(self) -> bool:
        """Whether a higher accuracy may help, not a smaller box. A heuristic: any choice is correct."""
        return 4 * self.error >= self.in_tau + self.in_b

    def times(self, factor: Fraction) -> Value:
        """A multiple in the same scale."""
        size = abs(factor)
        return Value(self.middle * factor, self.in_tau * size, self.in_b * size, self.error * size, self.scale)

    def unscaled(self) -> Value:
        """The same number in units of x^b/2^p."""
        return self.times(1 / self.scale.s)._replace(scale=self.scale._replace(s=Fraction(1)))

    def plus(self, other: Value) -> Value:
        """The sum of two values in one scale."""
        require(self.scale == other.scale, "two values of different scales are not added")
        return Value(*(one + two for one, two in zip(self[:4], other[:4], strict=True)), self.scale)


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


# ---------------------------------------------------------------------------------------------------------------------
# Theta: check.md, section 4.
# ---------------------------------------------------------------------------------------------------------------------


# Of a box and an accuracy: an answer that holds on the whole box, or 0; the value that shows what may help, if any.
Question = Callable[[Box, int], tuple[int, Value | None]]


class Theta:
    """F and its derivatives on boxes, at rising accuracy, within a budget of work."""

    def __init__(self, limits: Limits, budget: int) -> None:
        self.limits, self.meter = limits, Meter(limits, budget)
        self.bits = 64
        self.locals: dict[tuple[Fraction, Fraction, int, int], Local] = {}

    def local(self, low: Fraction, high: Fraction, bits: int, tau: Fraction) -> Local:
        """F on the disc around [low, high]; those not used for the longest time make room."""
        key = (low, high, bits, start_for(bits, 0, tau))
        disc = self.locals.pop(key, None) or Local(low, high, bits, tau, self.meter)
        self.locals[key] = disc
        half = self.limits.memory * 10**6 // 2
        while len(self.locals) > 1 and sum(one.bytes() for one in self.locals.values()) > half:
            del self.locals[next(iter(self.locals))]
        return disc

    def value(self, box: Box, order: int, bits: int) -> Value:
        """F^(order)/order! on a box, or ∂F/∂b + w F with one w if order = -1."""
        low, high, thin_b = outward(*box[:2], bits)
        start, end, thin_tau = outward(*box[2:], bits)
        require(start == end or order <= 2, "the tail lemma is proved for orders up to 2")
        local, middle, i = self.local(low, high, bits, start), (start + end) / 2, max(order, 0)
        s = (end - start) / 2 or Fraction(1 << max(0, int(abs(start)).bit_length() - 1))  # at a point any s > 0 will do
        values, scale = local.values(middle, s), Scale(local.x, local.p, s**i)
        if start < end:
            series = local.expand(middle, s, values)[i:]
        else:
            series = [next(a for k, a in enumerate(local.recurrence(middle, s, values)) if k == i)]
        if order < 0:
            require(local.radius, "at one b there is no derivative in b")
            series, scale = [local.in_b(a) for a in series], scale._replace(s=Fraction(local.radius << 16))
        weights = [math.comb(k, i) for k in range(i, i + len(series))]
        in_tau = sum(w * a.spread(0) for w, a in zip(weights[1:], series[1:], strict=True))
        in_b = series[0].spread(1)
        error = sum(w * a.error for w, a in zip(weights, series, strict=True))
        # What only the wider box adds is an error: halving would not help, a higher accuracy does.
        error += (in_tau if thin_tau else 0) + (in_b if thin_b else 0)
        return Value(series[0].m[0], 0 if thin_tau else in_tau, 0 if thin_b else in_b, error, scale)

    def settle(self, ask: Question, box: Box, splits: int | None = None, bits: int = 0) -> int:
        """The one answer to a question on the whole box: with more bits, on two halves, or 0 when it stays open."""
        splits, bits = self.limits.splits if splits is None else splits, max(bits, self.bits)
        answer, value = ask(box, bits)
        if answer:
            self.bits = bits
        if answer or value is None:
            return answer
        if value.is_blurred():
            return self.settle(ask, box, splits, bits * 3 // 2) if bits < self.limits.bits else 0
        if not splits:
            return 0
        low, high, start, end = box
        b, tau = (low + high) / 2, (start + end) / 2
        if value.in_tau < value.in_b:
            one, two = (low, b, start, end), (b, high, start, end)
        else:
            one, two = (low, high, start, tau), (low, high, tau, end)
        answer = self.settle(ask, one, splits - 1, bits)
        return answer if answer and self.settle(ask, two, splits - 1, bits) == answer else 0

    def sign(self, box: Box, order: int, splits: int | None = None) -> int:
        """The one sign on the whole box, or 0 when none is confirmed."""

        def ask(part: Box, bits: int) -> tuple[int, Value]:
            value = self.value(part, order, bits)
            return value.sign(), value

        return self.settle(ask, box, splits)
