"""Intervals of integers in units of 2^-bits, rounded outward: the only arithmetic of a run's checker that rounds.

An integer n stands for n/2^bits, a pair of integers for all numbers between them. Exact here: +, -, ≤, |·|.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from fractions import Fraction
from typing import Any

from limits import DIGIT, Meter, digits, reject, require

SCHOOLBOOK = 70  # digits up to which Python multiplies each with each

Interval = tuple[int, int]
Box = dict[str, Interval]
Matrix = list[list[Interval]]


def up(n: int, d: int) -> int:
    """The least integer ≥ n/d, d > 0."""
    return -(-n // d)


def root_up(n: int) -> int:
    """The least integer ≥ √n."""
    root = math.isqrt(n)
    return root + (root * root < n)


def add(a: Interval, b: Interval) -> Interval:
    """a + b."""
    return a[0] + b[0], a[1] + b[1]


def wider(a: Interval, radius: int) -> Interval:
    """All numbers that are so near to a."""
    return a[0] - radius, a[1] + radius


def size(a: Interval) -> int:
    """The largest absolute value."""
    return max(-a[0], a[1])


def longest(numbers: Iterable[int]) -> int:
    """The length of the longest of some integers, in digits."""
    return digits(max(map(abs, numbers), default=0))


def packed(coefficients: Sequence[int], width: int) -> int:
    """The value of a polynomial at 2^(8 width), for coefficients less than that in size."""
    parts = [b"".join(max(sign * c, 0).to_bytes(width, "little") for c in coefficients) for sign in (1, -1)]
    return int.from_bytes(parts[0], "little") - int.from_bytes(parts[1], "little")


def karatsuba(shorter: int, longer: int) -> int:
    """How many products of digits Python makes for one product of integers of these lengths in digits."""
    blocks, products = up(longer, shorter), 1
    while shorter > SCHOOLBOOK:
        shorter, products = up(shorter, 2), 3 * products
    return blocks * products * shorter**2


class Numbers:
    """The operations that round, and long exact ones. Each pays for its work before it is done."""

    def __init__(self, bits: int, meter: Meter) -> None:
        self.bits, self.one, self.meter = bits, 1 << bits, meter

    def read(self, value: Any) -> int:
        """m 2^e from [m, e], |m 2^e| < 2^bits and e ≥ -bits: exact."""
        pair = isinstance(value, list) and [*map(type, value)] == [int, int]
        require(pair and abs(value[1]) <= self.bits, f"{value!a:.50} is not a number [m, e]")
        m, e = value
        require(m.bit_length() + e <= self.bits, "a number is too large")
        return int(m << (self.bits + e))

    def interval(self, q: Fraction) -> Interval:
        """An interval around a rational."""
        self.meter.spend(digits(q.numerator << self.bits) * digits(q.denominator), 4)
        return (q.numerator << self.bits) // q.denominator, up(q.numerator << self.bits, q.denominator)

    def scaled(self, q: Fraction, a: Interval) -> Interval:
        """q a."""
        ends = a[0] * q.numerator, a[1] * q.numerator
        return min(ends) // q.denominator, up(max(ends), q.denominator)

    def mul(self, a: Interval, b: Interval) -> Interval:
        """a b."""
        ends = a[0] * b[0], a[0] * b[1], a[1] * b[0], a[1] * b[1]
        return min(ends) >> self.bits, up(max(ends), self.one)

    def reciprocal(self, a: Interval) -> Interval:
        """1/a for a > 0."""
        require(a[0] > 0, "a divisor is not certainly positive")
        self.meter.spend(2 * digits(self.one << self.bits) * longest(a), 4)
        return (self.one << self.bits) // a[1], up(self.one << self.bits, a[0])

    def sine_cosine(self, q: Fraction) -> tuple[Interval, Interval]:
        """Enclosures of sin q and cos q, |q| ≤ 8: Taylor's sums; the first term left out bounds the rest (Lemma 2)."""
        require(abs(q) <= 8, "an angle is not within 8 of its reference")
        self.meter.spend(6 * self.bits * digits(self.one) ** 2, 20 * self.bits)
        x, found = self.interval(q), []
        for term, k in ((x, 1), ((self.one, self.one), 0)):
            total = (0, 0)
            while size(term) > 1:
                total = add(total, term)
                term = self.scaled(Fraction(-1, (k + 1) * (k + 2)), self.mul(x, self.mul(x, term)))
                k += 2
            found.append(wider(total, size(term)))
        return found[0], found[1]

    def term(self, q: Fraction, factors: Sequence[Interval]) -> Interval:
        """q times all factors."""
        length = sum(digits(size(factor)) for factor in factors) + digits(q.numerator * q.denominator)
        self.meter.spend(4 * length**2, 8 * len(factors) + 8)
        part = (self.one, self.one)
        for factor in factors:
            part = self.mul(part, factor)
        return self.scaled(q, part)

    def on(self, coefficients: Sequence[int], tau: Interval) -> Interval:
        """A polynomial on an interval inside [-1, 1], by Horner's rule."""
        self.meter.spend(5 * len(coefficients) * longest(coefficients) * digits(self.one), 15 * len(coefficients))
        found = (0, 0)
        for c in reversed(coefficients):
            found = add(self.mul(found, tau), (c, c))
        return found

    def product(self, A: Matrix, B: Matrix) -> Matrix:
        """A B."""
        columns = list(zip(*B, strict=True))
        lengths = [longest(size(entry) for row in M for entry in row) for M in (A, B)]
        count = len(A) * len(B) * len(columns)
        self.meter.spend(4 * count * lengths[0] * lengths[1], 14 * count)
        return [[self._dot(row, column) for column in columns] for row in A]

    def _dot(self, row: Sequence[Interval], column: Sequence[Interval]) -> Interval:
        total = (0, 0)
        for a, b in zip(row, column, strict=True):
            total = add(total, self.mul(a, b))
        return total

    def inverse(self, exact: list[list[int]]) -> Matrix:
        """An enclosure of the inverse of an exact matrix, by Gauss and Jordan in rational numbers."""
        n = len(exact)
        self.meter.spend(4 * n**3 * (n * max(map(longest, exact))) ** 2, 100 * n**3)
        work = [[Fraction(v, self.one) for v in row] for row in exact]
        work = [row + [Fraction(i == j) for j in range(n)] for i, row in enumerate(work)]
        for i in range(n):
            pivot = next((row for row in range(i, n) if work[row][i]), None)
            if pivot is None:
                reject("a basis is singular")
            work[i], work[pivot] = work[pivot], work[i]
            work[i] = [v / work[i][i] for v in work[i]]
            for row in range(n):
                if row != i:
                    work[row] = [a - work[row][i] * b for a, b in zip(work[row], work[i], strict=True)]
        return [[self.interval(v) for v in row[n:]] for row in work]

    def length(self, values: Sequence[Interval]) -> int:
        """A bound of the Euclidean length of a vector."""
        self.meter.spend(3 * len(values) * longest(map(size, values)) ** 2, 6 * len(values))
        return root_up(sum(size(v) ** 2 for v in values))

    def apply_up(self, M: Sequence[Sequence[int]], v: Sequence[int]) -> list[int]:
        """Upper bounds of M v."""
        self.meter.spend(len(v) * sum(map(longest, M)) * longest(v), 4 * len(v) * len(M))
        return [up(sum(a * b for a, b in zip(row, v, strict=True)), self.one) for row in M]

    def common_denominator(self, values: Iterable[Fraction]) -> int:
        """The least one."""
        common = 1
        for value in values:
            self.meter.spend(2 * digits(common) * digits(value.denominator), 2)
            common = math.lcm(common, value.denominator)
        return common

    def multiple(self, factor: int, c: Sequence[int]) -> list[int]:
        """A polynomial times an integer, exactly."""
        self.meter.spend(len(c) * digits(factor) * longest(c), 2 * len(c))
        return [factor * v for v in c]

    def convolution(self, a: Sequence[int], b: Sequence[int]) -> list[int]:
        """The coefficients of a product of two polynomials, exactly: one product of long integers (Lemma 1)."""
        width = sum(max(map(int.bit_length, c)) for c in (a, b)) // 8 + len(a).bit_length() // 8 + 2  # bytes
        count, half = len(a) + len(b) - 1, 1 << (8 * width - 1)
        lengths = sorted(8 * width * len(c) // DIGIT + 1 for c in (a, b))
        self.meter.spend(karatsuba(*lengths), 8 * count)
        total = packed(a, width) * packed(b, width) + packed([half] * count, width)
        data = total.to_bytes(width * count, "little")
        return [int.from_bytes(data[i : i + width], "little") - half for i in range(0, len(data), width)]
