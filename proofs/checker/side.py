"""Check a side: the model system from a state to lift-off or impact, for every ε up to one at once (from_state.md).

The way to the hand-over is a passage (passage.py). From there on the model system is linear and its distinguished
trajectory exact, so the deviations are taken over L(S): its size matters for the force alone (section 11 of the page).

    Statement     what is said, and the ranges of δ = ε^(1/3)
    Hand-over     the set (13) over L(S) (section 5)
    Pieces        Theorem U1 for the model system, piece after piece (uniform.md; section 11)
    Growth        Theorem U2 for the model system (uniform.md; section 11)
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from math import isqrt
from typing import Any, NamedTuple

import passage
from intervals import Interval, Matrix, Numbers, add, size, up, wider
from limits import Limits, Meter, Rejected, reject, require
from model import Polynomial, short
from passage import BITS, exp_above, log_above, root_above
from reading import entries, read_line

VERSION = 7
HYPOTHESES = ["from_state", "uniform"]
WORK, WORK_PER_BYTE = 2 * 10**9, 10_000  # products of digits: for each unit of Limits.work, for each byte
RANGES, PIECES, DEGREE, ATTEMPTS = 400, 600, 8, 40  # of δ, of s in a range, of the flow, of guesses on a piece
ONE, ANY_DRIFT = 1 << BITS, str(10**9)
FLATTER = (Fraction(1), Fraction(31, 32), Fraction(15, 16), Fraction(7, 8))  # of the growth in a file: any is right
B, Y, V = range(3)  # the components of a deviation

Bounds = list[int]  # in units of 2^-BITS

# ---------------------------------------------------------------------------------------------------------------------
# Statement.
# ---------------------------------------------------------------------------------------------------------------------


class Statement:
    """What follows from the starts by t = ``by``: λ vanishes (``reaches`` is 0), or exceeds ``reaches``."""

    def __init__(self, statement: Any) -> None:
        names = ("alpha", "b", "by", "contact", "epsilon", "kind", "p", "reaches", "within")
        self.of = dict(zip(names, entries(statement, "the statement", *names), strict=True))
        require(self.of.pop("kind") == "side", "unknown kind of statement")
        self.by, self.reaches = short(self.of.pop("by")), short(self.of.pop("reaches"))
        self.epsilon = short(self.of.pop("epsilon"))
        require(self.epsilon > 0, "ε is not positive")

    def start(self, epsilon: Fraction, scaled: Any) -> passage.Start:
        """The starts with every ε up to this one; of the drift of C_1 nothing is stated."""
        return passage.Start(
            self.of | {"drift": ANY_DRIFT, "epsilon": str(epsilon), "kind": "passage", "scaled": scaled}
        )

    def words(self, start: passage.Start, first: Fraction) -> str:
        """The statement, where the first cone begins at s = ``first``."""
        end = "and it vanishes later: contact is lost"
        if self.reaches:
            end = f"and on until it exceeds {self.reaches}, where p < 0"
        place = f"{start.words_of_starts(self.epsilon)}: λ > 0 until p = {-start.a * first} ε^(2/3)"
        return f"{place}, {end}, at the latest at the time {self.by} after p = 0"


class Range(NamedTuple):
    """All δ > 0 from ``least`` to ``most``: a passage to s = -S, then pieces to ``end``, where a cone begins."""

    least: Fraction
    most: Fraction
    start: passage.Start
    passed: passage.Passage
    end: Fraction
    pieces: int
    cone: list[Fraction]  # a, c, B, C of Theorem U2
    top: Fraction  # Y_max

    @property
    def scaled(self) -> Fraction:
        """S."""
        return self.start.scaled

    def amplitude(self, numbers: Numbers) -> tuple[Fraction, Fraction]:
        """Bounds of |L(S)| from below and above: |L| (aSδ²/p_1)^(β-1) C(S)/C_1 at δ = ``most``, C(S)/C_1 of any δ."""
        start = self.start
        part, power, low, high = start.a * self.scaled * self.most**2 / start.p, start.beta - 1, *self.carried(numbers)
        below = exp_above(power * log_above(1 / part) - low)
        return abs(start.excess) / below, abs(start.excess) * exp_above(power * log_above(part) + high)

    def carried(self, numbers: Numbers) -> tuple[Fraction, Fraction]:
        """Bounds of log C(S)/C_1, (12)."""
        start, total = self.start, (0, 0)
        h, root = root_of(numbers, 1 / (start.a * self.scaled**3)), root_of(numbers, start.a * self.scaled)
        r = numbers.mul(root, between(numbers, self.least, self.most))
        h_1, r_1 = (0, root_of(numbers, start.e**2 / start.p**3)[1]), root_of(numbers, start.p)
        for (i, n), c in passage.monomials(self.passed.slow.w).items():
            share = start.beta * c / Fraction(3 * i - n, 2)  # 3i > n: check_barrier
            total = add(total, numbers.term(-share, [h] * i + [r] * n))
            total = add(total, numbers.term(share, [h_1] * i + [r_1] * n))
        return Fraction(total[0], ONE) - self.passed.moved, Fraction(total[1], ONE) + self.passed.moved


def read_range(numbers: Numbers, statement: Statement, line: Any, least: Fraction) -> Range:
    """The next range of δ."""
    names = ("cone", "delta", "end", "passage", "pieces", "scaled", "top")
    cone, delta, end, way, pieces, scaled, top = entries(line, "a range", *names)
    most = short(delta)
    require(most > least, "the ranges of δ are not in order")
    require(type(pieces) is int and 0 < pieces <= PIECES, f"there are not 1 to {PIECES} pieces")
    start = statement.start(most**3, scaled)
    passed = passage.read_passage(start, way, numbers)
    found = Range(least, most, start, passed, short(end), pieces, passage.read_list(cone, 4), short(top))
    require(min(found.end, found.top, *found.cone) > 0, "a number of the range is not positive")
    require(found.end + found.scaled <= pieces, "a piece is longer than 1")
    return found


# ---------------------------------------------------------------------------------------------------------------------
# Upper bounds, in units of 2^-BITS.
# ---------------------------------------------------------------------------------------------------------------------


def units(q: Fraction) -> int:
    """q, rounded up."""
    return up(q.numerator << BITS, q.denominator)


def times(a: int, b: int) -> int:
    """a b for a, b ≥ 0, rounded up."""
    return up(a * b, ONE)


def weighed(row: Sequence[Interval], bounds: Sequence[int]) -> int:
    """A bound of the sum of the products."""
    return up(sum(size(entry) * bound for entry, bound in zip(row, bounds, strict=True)), ONE)


def between(numbers: Numbers, low: Fraction, high: Fraction) -> Interval:
    """All numbers from ``low`` to ``high``."""
    return numbers.interval(low)[0], numbers.interval(high)[1]


def root_of(numbers: Numbers, q: Fraction) -> Interval:
    """√q."""
    low, high = numbers.interval(q)
    return isqrt(low << BITS), isqrt(high << BITS) + 1


# ---------------------------------------------------------------------------------------------------------------------
# Hand-over.
# ---------------------------------------------------------------------------------------------------------------------


class Deviations(NamedTuple):
    """e = Q(γ + u), |u| ≤ ``radii``, and |φ| ≤ ``burst`` e^(-g_- (s + S)/δ) + ``forced``, all over L(S)."""

    basis: list[list[int]]
    centre: list[int]
    radii: Bounds
    burst: int
    forced: int


def handed_over(numbers: Numbers, of: Range) -> Deviations:
    """(13) over L(S) for all δ of the range, in the frame whose column b is the slow vector."""
    start, passed = of.start, of.passed
    far, share = start.a * of.scaled, passed.share
    h, root = root_of(numbers, 1 / (start.a * of.scaled**3)), root_of(numbers, far)
    r = numbers.mul(root, between(numbers, of.least, of.most))
    last, lag = Fraction(r[1], ONE), start.lag / start.rate
    z = largest_fast(of, Fraction(h[1], ONE), last)
    share_v, share_f = share * root_above(1 / start.kappa), share * root_above(start.lag) / start.rate

    def value(polynomial: Polynomial, less: int) -> Interval:
        """Over r^less."""
        total = (0, 0)
        for (i, n), c in passage.over(passage.monomials(polynomial), 0, less).items():
            total = add(total, numbers.term(c, [h] * i + [r] * n))
        return total

    v, w, f = value(passed.slow.v, 1), value(passed.slow.w, 0), value(passed.slow.f, 0)
    fast = numbers.term(Fraction(1), [r, r, f])
    pressed = add(add(fast, numbers.term(-lag, [r, v])), (-w[1] - ONE, -w[0] - ONE))  # κ e_y
    spread = (share + (share_f + lag * share_v) * last) * z / start.kappa
    y = wider(numbers.scaled(1 / start.kappa, pressed), units(spread))
    speed = wider(numbers.mul(root, v), units(share_v * z * Fraction(root[1], ONE)))
    b = numbers.interval(-far)
    column = [b[0], (y[0] + y[1]) >> 1, (speed[0] + speed[1]) >> 1]
    beside = up((b[1] - b[0]) << BITS, -b[1])  # of e_b/column from 1
    radii = [beside]
    radii += [size(add(e, (-c, -c))) + times(beside, abs(c)) for e, c in zip((y, speed), column[1:], strict=True)]
    basis = [[column[B], 0, 0], [column[Y], ONE, 0], [column[V], 0, ONE]]
    return Deviations(basis, [ONE, 0, 0], radii, size(fast) + units(share_f * z * last), 0)


def largest_fast(of: Range, h: Fraction, r: Fraction) -> Fraction:
    """A bound of z ≤ Z + I at the hand-over."""
    start, passed = of.start, of.passed
    e, p = start.a * of.most**3, start.a * of.scaled * of.most**2
    decay = passed.damping * (start.p**2 - p**2) / (2 * e)
    layer = exp_above(passed.rate * log_above(start.p / p) - decay)
    return passage.at(passed.barrier, h, r) + passed.first * layer


# ---------------------------------------------------------------------------------------------------------------------
# Pieces.
# ---------------------------------------------------------------------------------------------------------------------


class Piece(NamedTuple):
    """Over L(S): e_λ on the piece, e and a bound of |f| at its end; and the set there."""

    force: Interval
    end: list[Interval]
    fast: int
    after: Deviations


class Equations:
    """e' = A'e + Bφ and the equation of φ (Lemma 1') for the model system, p̃ = -as, for all δ of a range."""

    def __init__(self, numbers: Numbers, of: Range) -> None:
        start = of.start
        self.numbers, self.start, self.of, self.lag = numbers, start, of, start.lag / start.rate
        self.middle, self.off = (of.least + of.most) / 2, units((of.most - of.least) / 2)
        self.delta = between(numbers, of.least, of.most)
        self.least_rate = start.rate - self.lag * of.most**2 * start.a * of.scaled  # g_-
        require(self.least_rate > 0, "φ does not fall for the largest δ")

    def matrix(self, s: Fraction) -> list[list[Fraction]]:
        """A'(s) at the middle δ."""
        start, drag = self.start, self.lag * self.middle
        turn, push, nothing = start.a * start.beta, start.a * s, Fraction(0)
        return [
            [nothing, -start.kappa * turn, -drag * turn],
            [nothing, nothing, Fraction(1)],
            [Fraction(1), start.kappa * push, drag * push],
        ]

    def flow(self, s: Fraction) -> tuple[list[list[list[int]]], list[list[list[int]]]]:
        """Y, near the flow of the middle A' from s on, and AY - Y' but for rounding: polynomials by entry.

        Y_(j+1) is (A'(s) Y_j + (dA'/ds) Y_(j-1))/(j + 1), rounded down: of the coefficient of t^j in AY - Y' that
        leaves a number from 0 to j + 1 units.
        """
        first, later = self.matrix(s), self.matrix(s + 1)
        common = self.numbers.common_denominator(value for row in (*first, *later) for value in row)
        P = [[int(value * common) for value in row] for row in first]
        R = [[int(value * common) - p for value, p in zip(*rows, strict=True)] for rows in zip(later, P, strict=True)]
        nothing = [[0] * 3 for _ in range(3)]
        powers = [nothing, [[ONE * (i == j) for j in range(3)] for i in range(3)]]

        def fed(before: list[list[int]], now: list[list[int]], divisor: int) -> list[list[int]]:
            columns = [*zip(*(now + before), strict=True)]
            rows = [p + r for p, r in zip(P, R, strict=True)]
            return [
                [self.numbers.meter.dot(*zip(row, column, strict=True)) // divisor for column in columns]
                for row in rows
            ]

        for k in range(DEGREE):
            powers.append(fed(*powers[-2:], common * (k + 1)))
        beyond = [nothing] * DEGREE + [fed(*powers[-2:], common), fed(powers[-1], nothing, common)]
        return by_entry(powers[1:]), by_entry(beyond)

    def advance(self, state: Deviations, begin: Fraction, length: Fraction) -> Piece:
        """Theorem U1 on the piece from s = ``begin`` on."""
        numbers, start = self.numbers, self.start
        end, s = numbers.interval(length), between(numbers, begin, begin + length)
        flow, beyond = self.flow(begin)
        on, basis = on_all(numbers, flow, (0, end[1])), [[(value, value) for value in row] for row in state.basis]
        inverse = numbers.product(numbers.inverse(state.basis), inverse_of(on))
        defect = self.defect(on_all(numbers, beyond, (0, end[1])), on, s)
        rates = numbers.product(inverse, numbers.product(defect, basis))
        push = [[numbers.interval(start.a * start.beta)], [(0, 0)], [numbers.term(-start.a, [s])]]
        column = [size(row[0]) for row in numbers.product(inverse, push)]  # |W^-1 B|
        frame, first = numbers.product(on, basis), times(state.burst, self.fallen(begin))
        at_once = times(first, units(self.of.most / self.least_rate))
        guess = [larger(value) for value in state.radii]
        for _ in range(ATTEMPTS):
            e = placed(frame, state.centre, guess)
            forced = max(state.forced, self.fed(e, s))
            whole = [bound + abs(value) for bound, value in zip(guess, state.centre, strict=True)]
            reached = [
                radius + times(weight, at_once) + times(end[1], weighed(row, whole) + times(weight, forced))
                for radius, weight, row in zip(state.radii, column, rates, strict=True)
            ]
            if all(value < bound for value, bound in zip(reached, guess, strict=True)):
                break
            require(max(reached) < ONE << BITS, "the inequality of Theorem U1 is not satisfied")
            guess = [bound if value < bound else larger(value) for value, bound in zip(reached, guess, strict=True)]
        else:
            reject("the inequality of Theorem U1 is not satisfied")
        last = numbers.product(on_all(numbers, flow, end), basis)
        at_end = placed(last, state.centre, reached)
        after = turned(numbers, last, state._replace(radii=reached, forced=forced))
        force = wider(numbers.scaled(-start.kappa, e[Y]), self.lagged(first + forced, e[V]))
        rest = times(state.burst, self.fallen(begin + length))
        return Piece(force, at_end, self.lagged(rest + forced, at_end[V]), after)

    def defect(self, beyond: Matrix, flow: Matrix, s: Interval) -> Matrix:
        """A'Y - Y' for all δ of the range."""
        start, lag = self.start, self.lag
        bends = [self.numbers.interval(-lag * start.a * start.beta), (0, 0), self.numbers.term(lag * start.a, [s])]
        return [
            [
                wider(value, (DEGREE + 3) ** 2 + times(times(self.off, size(bend)), size(flow[V][j])))
                for j, value in enumerate(row)
            ]
            for row, bend in zip(beyond, bends, strict=True)
        ]

    def fallen(self, s: Fraction) -> int:
        """e^(-g_- (s + S)/δ) from above."""
        return units(exp_above(-self.least_rate * (s + self.of.scaled) / self.of.most))

    def fed(self, e: Sequence[Interval], s: Interval) -> int:
        """What the deviations feed into φ, (3)."""
        numbers, start = self.numbers, self.start
        turn = add(e[B], numbers.term(start.kappa * start.a, [s, e[Y]]))
        turn = add(turn, numbers.term(self.lag * start.a, [s, self.delta, e[V]]))
        return times(size(turn), units(self.lag * self.of.most**2 / self.least_rate))

    def lagged(self, fast: int, v: Interval) -> int:
        """A bound of |f| from one of |φ|."""
        return fast + times(units(self.lag * self.of.most), size(v))


def by_entry(matrices: Sequence[list[list[int]]]) -> list[list[list[int]]]:
    """The coefficients of each entry of a polynomial whose coefficients are matrices."""
    return [[[matrix[i][j] for matrix in matrices] for j in range(3)] for i in range(3)]


def on_all(numbers: Numbers, entries: list[list[list[int]]], time: Interval) -> Matrix:
    """The values of polynomials."""
    return [[numbers.on(coefficients, time) for coefficients in row] for row in entries]


def larger(bound: int) -> int:
    """A guess above a bound."""
    return bound + bound // 32 + (1 << (BITS - 80))


def placed(frame: Matrix, centre: Sequence[int], radii: Sequence[int]) -> list[Interval]:
    """The deviations frame·(γ + u)."""
    found = []
    for row in frame:
        low = sum(min(a * c, b * c) for (a, b), c in zip(row, centre, strict=True))
        high = sum(max(a * c, b * c) for (a, b), c in zip(row, centre, strict=True))
        found.append(wider((low >> BITS, up(high, ONE)), weighed(row, radii)))
    return found


def inverse_of(M: Matrix) -> Matrix:
    """The inverse of M = 1 + E: 1 - E + E² M⁻¹, and the entries of M⁻¹ are at most 1/(1 - |E|) in the row norm."""
    one = [[ONE * (i == j) for j in range(3)] for i in range(3)]
    E = [[(a - c, b - c) for (a, b), c in zip(row, unit, strict=True)] for row, unit in zip(M, one, strict=True)]
    sums = [sum(map(size, row)) for row in E]
    require(max(sums) < ONE, "a piece is too long for its flow to be inverted")
    rest = [up(weighed(row, sums) << BITS, ONE - max(sums)) for row in E]
    return [
        [wider((c - b, c - a), more) for (a, b), c in zip(row, unit, strict=True)]
        for row, unit, more in zip(E, one, rest, strict=True)
    ]


def turned(numbers: Numbers, columns: Matrix, state: Deviations) -> Deviations:
    """The same set in nearly orthonormal directions, the longest errors first: any regular ones are right."""
    middle = [[(a + b) >> 1 for a, b in row] for row in columns]
    vectors = [[row[j] for row in middle] for j in range(3)]
    errors = [radius + abs(c) // 64 for radius, c in zip(state.radii, state.centre, strict=True)]
    order = sorted(range(3), key=lambda j: -(errors[j] ** 2) * sum(value**2 for value in vectors[j]))
    found: list[list[int]] = []
    for vector in (vectors[j] for j in order):
        for unit in found:
            along = sum(a * b for a, b in zip(vector, unit, strict=True)) >> BITS
            vector = [a - (along * b >> BITS) for a, b in zip(vector, unit, strict=True)]
        length = isqrt(sum(a * a for a in vector))
        require(length > 0, "a frame is singular")
        found.append([(a << BITS) // length for a in vector])
    basis = [[unit[i] for unit in found] for i in range(3)]
    change = numbers.product(numbers.inverse(basis), columns)
    moved = placed(change, state.centre, [0] * 3)
    centre = [(a + b) >> 1 for a, b in moved]
    radii = [weighed(row, state.radii) + b - c for row, (_, b), c in zip(change, moved, centre, strict=True)]
    return state._replace(basis=basis, centre=centre, radii=radii)


# ---------------------------------------------------------------------------------------------------------------------
# Growth.
# ---------------------------------------------------------------------------------------------------------------------


def check_growth(numbers: Numbers, statement: Statement, of: Range, piece: Piece) -> int:
    """Theorem U2 from the last piece on, with the cone of the file or a flatter one: the sign of e_λ/L(S)."""
    refused = list[Rejected]()
    for share in FLATTER:
        try:
            return growing(numbers, statement, of, piece, [share * of.cone[0], *of.cone[1:]])
        except Rejected as reason:
            refused.append(reason)
    raise refused[0]


def growing(numbers: Numbers, statement: Statement, of: Range, piece: Piece, cone: Sequence[Fraction]) -> int:
    """The hypotheses of Theorem U2, one after the other."""
    start, e_y = of.start, piece.end[Y]
    require(e_y[0] > 0 or e_y[1] < 0, "the sign of the deviation is not certain where the cone begins")
    side = 1 if e_y[1] < 0 else -1
    b, y, v = (tuple(sorted(Fraction(-side * value, ONE) for value in end)) for end in piece.end)
    a, c, B_, C = cone
    q, mu, kappa = start.a * of.end, 2 * (start.beta - 1), start.kappa
    low, high = kappa * q * y[0] + b[0], kappa * q * y[1] + b[1]  # N
    require(0 < a * y[1] < v[0] and v[1] < B_ * y[0], "V does not lie in the cone (G0)")
    require(0 < c * v[1] < low and high < C * v[0], "N does not lie in the cone (G0)")
    first = y[0] * of.amplitude(numbers)[0]
    require(first < of.top, "the growth would end before it begins")
    last = of.end + log_above(of.top / first) / a
    phi = max(Fraction(piece.fast, ONE) / v[0], of.most * start.lag / start.rate)
    most, turn = start.a * last, start.a * start.beta * phi
    pi = most * phi
    require(c > a + pi, "(G1) does not hold")
    beside = kappa * start.a * (start.beta - 1) / a
    require(kappa > c * phi and kappa * q - beside - turn - c * (c + q * phi) > 0, "(G2) does not hold")
    require(C + pi < B_, "(G3) does not hold")
    require(C * (C - pi) - kappa * most - turn > 0, "(G4) does not hold")
    rate = start.rate - start.lag / start.rate * of.most**2 * start.a * of.scaled
    require(mu < a * last and rate * (of.end + of.scaled) > of.most, "(G7) does not hold")
    reached = (kappa - phi * B_) * of.top
    force = statement.reaches - start.mean if statement.reaches else start.mean
    require(reached > force, "the growth is not followed to the force that is stated")
    require(of.most**2 * last <= statement.by, "it may happen later than is stated")
    return side


def check_range(numbers: Numbers, statement: Statement, of: Range) -> None:
    """Lift-off or impact, as it is stated, for all δ of a range."""
    start, equations, state = of.start, Equations(numbers, of), handed_over(numbers, of)
    length, largest, positive = (of.end + of.scaled) / of.pieces, of.amplitude(numbers)[1], start.excess > 0
    for k in range(of.pieces):
        piece = equations.advance(state, k * length - of.scaled, length)
        against = -piece.force[0] if positive else piece.force[1]
        require(start.mean * ONE > largest * against, "the force is not certainly positive before the cone")
        state = piece.after
    side = check_growth(numbers, statement, of, piece) * (1 if positive else -1)
    require((side < 0) == (statement.reaches == 0), "it is the other side")


def check_side(hypotheses: Any, statement: Any, lines: Sequence[bytes], limits: Limits, length: int) -> str:
    """The statement that a certificate of so many bytes proves; ``lines``: those after the first."""
    require(hypotheses == HYPOTHESES, "the pages are not those of a side")
    stated, least, firsts = Statement(statement), Fraction(0), list[Fraction]()
    require(0 < len(lines) <= RANGES, f"there are not 1 to {RANGES} ranges of δ")
    numbers = Numbers(BITS, Meter(limits, limits.work * WORK + WORK_PER_BYTE * length))
    for line in lines:
        of = read_range(numbers, stated, read_line(line), least)
        require(stated.reaches == 0 or stated.reaches > of.start.mean, "an impact is a force above the mean")
        check_range(numbers, stated, of)
        least = of.most
        firsts.append(of.end)
    require(least**3 >= stated.epsilon, "the ranges do not reach the ε that is stated")
    return stated.words(of.start, min(firsts))
