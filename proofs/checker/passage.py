"""Check a passage: the model system from a state towards the G-spot, for every ε up to one at once (from_state.md).

The statement is Theorem B of that page. The file has polynomials v, w, f, a norm, a rectangle and rates that any
producer may have chosen: residuals, the growth of the deviation, its barrier and the drift of C_1 follow here.

    Contact       the constants κ, g, l, and the statement (sections 1 and 4)
    Slow part     the residuals of the polynomials (section 2)
    Growth        Lemma 1 on the whole rectangle, in two charts (section 3)
    Barrier       Theorem B, hypothesis after hypothesis (section 4), and the drift (section 5, (12))
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import Any, NamedTuple

from intervals import Interval, Numbers, add, root_up, up
from limits import Limits, Meter, require
from model import Polynomial, number, short, state
from reading import entries, read_line

VERSION = 5
HYPOTHESES = ["from_state"]
BITS = 192  # of what is rounded
ROOTS, LARGEST_POWER = 60, 1000  # square roots that make a number small enough for its logarithm; of e
HALVINGS = 24  # of a box of the rectangle, where a sign is open
TERMS, HIGHEST = 200, 30  # of a polynomial of the file
WORK, WORK_PER_BYTE = 10**8, 10_000  # products of digits: for each unit of Limits.work, for each byte
H, R, NOTHING = state("h"), state("r"), Polynomial()
Monomials = dict[tuple[int, int], Fraction]  # coefficients of h^i r^n, by (i, n)

# ---------------------------------------------------------------------------------------------------------------------
# Upper bounds of rational numbers, roots and logarithms, in units of 2^-BITS.
# ---------------------------------------------------------------------------------------------------------------------


def above(q: Fraction) -> Fraction:
    """The least multiple of 2^-BITS that is no less than q."""
    return Fraction(up(q.numerator << BITS, q.denominator), 1 << BITS)


def root_above(q: Fraction) -> Fraction:
    """A number ≥ √q."""
    return Fraction(root_up(up(q.numerator << 2 * BITS, q.denominator)), 1 << BITS)


def log_above(q: Fraction) -> Fraction:
    """A number ≥ log q, q > 0: log q = 2^n log(q^(1/2^n)) ≤ 2^n (q^(1/2^n) - 1)."""
    for _ in range(ROOTS):
        q = root_above(q)
    return (q - 1) * 2**ROOTS


def exp_above(x: Fraction) -> Fraction:
    """A number ≥ e^x: e^(x/2^n) ≤ 1/(1 - x/2^n)."""
    require(x < LARGEST_POWER, "a power of e is too large")
    q = above(1 / (1 - x / 2**ROOTS))
    for _ in range(ROOTS):
        q = above(q * q)
    return q


# ---------------------------------------------------------------------------------------------------------------------
# Contact and statement.
# ---------------------------------------------------------------------------------------------------------------------


def read_list(value: Any, count: int) -> list[Fraction]:
    """So many rational numbers."""
    require(isinstance(value, list) and len(value) == count, f"{value!a:.50} is not a list of {count} numbers")
    return [short(entry) for entry in value]


class Start:
    """The model system, the set of starts at p = p_1, and up to which ε and down to which p something is said."""

    def __init__(self, statement: Any) -> None:
        names = ("alpha", "b", "contact", "drift", "epsilon", "kind", "p", "scaled", "within")
        alpha, b, contact, drift, epsilon, kind, p, scaled, within = entries(statement, "the statement", *names)
        require(kind == "passage", "unknown kind of statement")
        self.alpha, self.contact = read_list(alpha, 3), read_list(contact, 3)
        self.p, self.b, self.within, self.epsilon = short(p), short(b), short(within), short(epsilon)
        self.scaled, self.drift = short(scaled), short(drift)
        first, second, third = self.alpha
        require(first < 0 and second < 0 and third < first, "α_1 and α_2 are not negative, or β is not above 1")
        require(all(value > 0 for value in self.contact), "a constant of the contact is not positive")
        require(self.p > 0 and self.epsilon > 0 and self.scaled > 0 and self.within >= 0, "p, ε, S or η")
        one, two, damper = self.contact
        self.kappa, self.rate = one * two / (one + two), (one + two) / damper
        self.lag = two - self.kappa  # > 0
        self.beta, self.a, self.mean = third / first, -first, second / (third - first)
        self.e, self.excess = self.a * self.epsilon, -self.b / self.p - self.mean
        require(self.excess != 0, "b = -p λ̄: the distinguished trajectory")
        require((self.scaled * self.a) ** 3 * self.epsilon**2 < self.p**3, "the passage would end before its start")

    def words_of_starts(self, epsilon: Fraction) -> str:
        """The system, the starts, and every ε up to one."""
        alpha, contact = (", ".join(map(str, values)) for values in (self.alpha, self.contact))
        return (
            f"the model system with α = ({alpha}) and (k_1 ε², k_2 ε², c ε) = ({contact}): for every ε in "
            f"(0, {epsilon}] and every start in contact at p = {self.p}, b = {self.b} with |λ + b/p| ≤ η|L|, "
            f"√κ|v|/ε ≤ η√p|L|, (g/√l)|φ| ≤ η√p|L|, η = {self.within}, L = -b/p - {self.mean}, φ = λ + κy/ε² + "
            f"(l/g)v/ε, κ = {self.kappa}, g = {self.rate}, l = {self.lag}, as long as slip is positive"
        )

    def words(self) -> str:
        """The statement."""
        return (
            f"{self.words_of_starts(self.epsilon)}: λ > 0 down to p = {self.scaled * self.a} ε^(2/3), where L has "
            f"kept its sign, and |log(C/C_1)| ≤ {self.drift} on the way, C = -L p^({1 - self.beta}), C_1 its value at "
            "the start"
        )


# ---------------------------------------------------------------------------------------------------------------------
# Slow part: polynomials in h and r = √p, and what they leave of the equations.
# ---------------------------------------------------------------------------------------------------------------------


def read_polynomial(value: Any, name: str) -> Polynomial:
    """A list of [i, n, coefficient] for the terms h^i r^n, in order and none twice."""
    require(isinstance(value, list) and len(value) <= TERMS, f"{name} is not a list of at most {TERMS} terms")
    found, before = Polynomial(), (-1, -1)
    for term in value:
        powers = isinstance(term, list) and len(term) == 3 and all(type(power) is int for power in term[:2])
        require(powers and all(0 <= power <= HIGHEST for power in term[:2]), f"{term!a:.50} is not a term of {name}")
        require(before < (term[0], term[1]), f"the terms of {name} are not in order")
        before = term[0], term[1]
        found.take(("h",) * term[0] + ("r",) * term[1], short(term[2]))
    return found


def monomials(polynomial: Polynomial) -> Monomials:
    """Its coefficients by exponents."""
    return {(key.count("h"), key.count("r")): value for key, value in polynomial.items()}


def over(terms: Monomials, i: int, n: int) -> Monomials:
    """The quotient by h^i r^n, which must be a polynomial."""
    require(all(key[0] >= i and key[1] >= n for key in terms), f"a polynomial is not divisible by h^{i} r^{n}")
    return {(key[0] - i, key[1] - n): value for key, value in terms.items()}


def at(terms: Monomials, h: Fraction, r: Fraction, sign: int = 0) -> Fraction:
    """A bound of Σ |c| h^i r^n, h, r ≥ 0; with a sign: over the coefficients c of this sign."""
    chosen = (abs(c) * h**i * r**n for (i, n), c in terms.items() if sign == 0 or sign * c > 0)
    return sum((above(value) for value in chosen), Fraction(0))


def change(polynomial: Polynomial) -> Polynomial:
    """d/dT, from h' = (3/2) h² r and r' = -(1/2) h r²."""
    return H * R * (number(Fraction(3, 2)) * H * polynomial.by("h") - number(Fraction(1, 2)) * R * polynomial.by("r"))


class Slow:
    """v, w, f, and 𝓕: a bound of the size of what they leave of the equations, over e|L|, monomial by monomial."""

    def __init__(self, start: Start, v: Polynomial, w: Polynomial, f: Polynomial) -> None:
        self.start, self.v, self.w, self.f = start, v, w, f
        bent = number(start.lag / start.rate) * w - number(start.rate) * f - self.along_square(f)
        driven = H * R * number(start.beta - 1) * (number(1) + w) - number(start.rate) * R * R * f
        first = over(monomials(R * R * w - self.along(v)), 1, 2)
        second = over(monomials(driven - self.along_square(w) - number(start.kappa) * v), 1, 1)
        third = over(monomials(bent), 1, 0)
        self.source: Monomials = {}
        for factor, terms in zip(self.lengths(), (first, second, third), strict=True):
            for key, value in terms.items():
                self.source[key] = self.source.get(key, Fraction(0)) + above(factor * abs(value))

    def along(self, F: Polynomial) -> Polynomial:
        """D F."""
        start = self.start
        return change(F) - H * R * (number(start.beta - 1) + number(start.beta) * self.w) * F

    def along_square(self, F: Polynomial) -> Polynomial:
        """r^-2 D(r² F) = (D - hr) F."""
        return self.along(F) - H * R * F

    def lengths(self) -> tuple[Fraction, Fraction, Fraction]:
        """Bounds of √M_11, √M_22, √M_33."""
        return root_above(self.start.kappa), Fraction(1), root_above(self.start.rate**2 / self.start.lag)


# ---------------------------------------------------------------------------------------------------------------------
# Growth: Lemma 1.
# ---------------------------------------------------------------------------------------------------------------------


class Norm(NamedTuple):
    """M by its numbers k_1, k_2; |x|' ≤ (hr growth - damping r²)|x| + |L||R| on 0 < h ≤ ``h``, 0 < r ≤ ``r``."""

    k_1: Fraction
    k_2: Fraction
    growth: Fraction
    damping: Fraction
    h: Fraction
    r: Fraction

    def matrix(self, start: Start) -> list[list[Polynomial]]:
        """M."""
        m = number(self.k_2 * start.lag / start.rate) * R - number((start.beta - Fraction(1, 2)) / 2) * H
        n = number(-self.k_1) * R
        return [
            [number(start.kappa), m, NOTHING],
            [m, number(1), n],
            [NOTHING, n, number(start.rate**2 / start.lag)],
        ]

    def share(self, start: Start) -> Fraction:
        """c_W: |x_2| ≤ c_W |x| on the rectangle, (5)."""
        m = max(self.k_2 * start.lag / start.rate * self.r, (start.beta - Fraction(1, 2)) / 2 * self.h)
        rest = 1 - m**2 / start.kappa - (self.k_1 * self.r) ** 2 * start.lag / start.rate**2
        require(rest > 0, "the norm is not positive definite on the rectangle")
        return root_above(1 / rest)

    def surplus(self, slow: Slow) -> list[list[Polynomial]]:
        """N of Lemma 1."""
        start = slow.start
        half, beta = number(Fraction(-1, 2)) * H * R, number(start.beta)
        B = [
            [half, R + beta * H * slow.v, NOTHING],
            [-number(start.kappa) * R, H * R * (beta - number(1) + beta * slow.w), -number(start.rate) * R],
            [NOTHING, number(start.lag / start.rate) * R + beta * H * R * R * slow.f, half - number(start.rate)],
        ]
        M, factor = self.matrix(start), number(2 * self.growth) * H * R - number(2 * self.damping) * R * R
        MB = [[M[i][0] * B[0][j] + M[i][1] * B[1][j] + M[i][2] * B[2][j] for j in range(3)] for i in range(3)]
        return [[factor * M[i][j] - MB[i][j] - MB[j][i] - change(M[i][j]) for j in range(3)] for i in range(3)]


Terms = list[tuple[Fraction, int, int]]  # c u^i s^j


def scaled(entry: Polynomial, steep: bool, power: int) -> Terms:
    """An entry in the chart h = us, r = s (``steep``) or r = us, h = s, over s^power, and over u in the second chart
    if power > 0 (a side entry keeps u^(-1/2), see :func:`minors`)."""
    found = []
    for (i, n), value in monomials(entry).items():
        first, second = i if steep else n - (power > 0), i + n - power
        require(first >= 0 and second >= 0, f"N has the monomial h^{i} r^{n}")
        found.append((value, first, second))
    return found


def enclosed(numbers: Numbers, terms: Terms, u: Interval, s: Interval) -> Interval:
    """Σ c u^i s^j."""
    total = (0, 0)
    for c, i, j in terms:
        total = add(total, numbers.term(c, [u] * i + [s] * j))
    return total


def check_chart(numbers: Numbers, N: list[list[Polynomial]], steep: bool, reach: Fraction, other: Fraction) -> None:
    """N is positive definite for 0 ≤ u ≤ 1, 0 ≤ s ≤ reach, where us ≤ other."""
    corner, sides = scaled(N[2][2], steep, 0), [scaled(N[i][2], steep, 1) for i in (0, 1)]
    block = [scaled(N[i][j], steep, 2) for i, j in ((0, 0), (0, 1), (1, 1))]

    def positive(u: Interval, s: Interval) -> bool:
        last = enclosed(numbers, corner, u, s)
        if last[0] <= 0:
            return False
        a, b, d = (enclosed(numbers, terms, u, s) for terms in block)
        x, y = (enclosed(numbers, terms, u, s) for terms in sides)
        weight = [numbers.reciprocal(last)] + ([] if steep else [u])
        a = add(a, numbers.term(Fraction(-1), [*weight, x, x]))
        b = add(b, numbers.term(Fraction(-1), [*weight, x, y]))
        d = add(d, numbers.term(Fraction(-1), [*weight, y, y]))
        return a[0] > 0 and add(numbers.term(Fraction(1), [a, d]), numbers.term(Fraction(-1), [b, b]))[0] > 0

    edge, end = numbers.interval(other)[1], numbers.interval(reach)[1]
    open_boxes = [((0, numbers.one), (0, end), 0)]
    while open_boxes:
        u, s, depth = open_boxes.pop()
        if u[0] * s[0] > edge << BITS or positive(u, s):
            continue
        require(depth < HALVINGS, "the growth of the deviation is not confirmed (Lemma 1)")
        if (u[1] - u[0]) * end >= (s[1] - s[0]) << BITS:
            middle = (u[0] + u[1]) >> 1
            open_boxes += [((u[0], middle), s, depth + 1), ((middle, u[1]), s, depth + 1)]
        else:
            middle = (s[0] + s[1]) >> 1
            open_boxes += [(u, (s[0], middle), depth + 1), (u, (middle, s[1]), depth + 1)]


# ---------------------------------------------------------------------------------------------------------------------
# Barrier: Theorem B.
# ---------------------------------------------------------------------------------------------------------------------


def barrier(source: Monomials, rate: Fraction, damping: Fraction) -> Monomials:
    """Z of (9)."""
    total: Monomials = {}
    for (i, n), c in source.items():
        while True:
            own = Fraction(3 * i - n, 2)
            if own > rate + Fraction(1, 4) or (n < 1 and own > rate):
                total[i, n] = total.get((i, n), Fraction(0)) + above(c / (own - rate))
                break
            require(n >= 1, f"a source is not paid at h^{i}: the growth {own} is below the rate")
            i, n, c = i + 1, n - 1, above(c / damping)
            total[i, n] = total.get((i, n), Fraction(0)) + c
            own += 2
            if own >= rate:
                break
            c = above(c * (rate - own))
    return total


def start_bound(slow: Slow, start: Start) -> Fraction:
    """z_0 of (8)."""
    h, r = root_above(start.e**2 / start.p**3), root_above(start.p)
    one, two, three = slow.lengths()
    v, w, f = (at(terms, h, r) for terms in (over(monomials(slow.v), 0, 1), monomials(slow.w), monomials(slow.f)))
    return 3 * start.within + one * v + two * w + three * r * f


class Passage(NamedTuple):
    """z ≤ Z + I until the hand-over, where I is ``first`` at the start; ``share`` is c_W, ``rate`` Γ, ``damping`` θ.

    ``moved`` bounds what z does to log C on the way.
    """

    slow: Slow
    barrier: Monomials
    first: Fraction
    share: Fraction
    rate: Fraction
    damping: Fraction
    moved: Fraction


def check_barrier(start: Start, slow: Slow, norm: Norm, rate: Fraction, largest: Fraction, least: Fraction) -> Passage:
    """The hypotheses of Theorem B for e = e_0, and the drift; ``least``² ≥ p_S², ``largest``: z_max."""
    e, theta, share, w = start.e, norm.damping, norm.share(start), monomials(slow.w)
    require(e**2 < norm.h**2 * start.p**3 and start.p <= norm.r**2, "the start is not on the rectangle")
    require(start.a * start.scaled**3 * norm.h**2 >= 1, "the passage ends beyond the rectangle")
    require((e / norm.h) ** 2 <= least**3 and least < start.p, "p at the end of the rectangle is not the one given")
    rising, falling, moved = at(w, norm.h, norm.r, 1), at(w, norm.h, norm.r, -1), share * largest
    require(rate >= norm.growth + start.beta * (1 + rising + moved) and rate > 0, "the rate is too small")
    require(3 * theta * start.p**2 > 4 * rate * e, "the layer does not fall with ε")
    Z = barrier(slow.source, rate, theta)
    highest, first = at(Z, norm.h, norm.r), start_bound(slow, start)
    require(highest + first < largest, "the barrier is not below z_max at the start")
    length = log_above(start.p**3 * norm.h**2 / e**2) / 3  # of log p between p_1 and p_S, from above
    decay = theta * (start.p**2 - least**2) / (2 * e)
    room = -log_above(first / (largest - highest)) if first else None
    require(room is None or rate * length - decay < room, "the barrier is not below z_max at the end")
    if start.excess > 0:
        require(falling + moved < 1, "the force is not certainly positive")
    else:
        require(start.beta * (falling + moved) < start.beta - 1, "the deviation does not certainly fall with p")
        require(-start.excess * (1 + rising + moved) < start.mean, "the force is not certainly positive")
    require(all(3 * i > n for i, n in w), "w has a monomial that does not grow")
    last = root_above(least)
    slope = sum((above(2 * abs(c) * norm.h**i * last**n / (3 * i - n)) for (i, n), c in w.items()), Fraction(0))
    fall = decay / max(length, Fraction(2, 3)) - rate
    require(fall > 0, "the integral of the layer is not bounded")
    area = first / fall + passed(Z, norm, last)
    moved = start.beta * share * area
    require(start.beta * slope + moved <= start.drift, "C_1 may drift more than is stated")
    return Passage(slow, Z, first, share, rate, theta, moved)


def passed(Z: Monomials, norm: Norm, last: Fraction) -> Fraction:
    """A bound of the integral of Z dp/p down to p_S, √p_S ≤ ``last``: below (11)."""
    total = Fraction(0)
    for (i, n), c in Z.items():
        require(i >= 1, "the barrier has a monomial without h")
        kept = min(n, 3 * i - 1)
        total += above(2 * c * norm.r ** (n - kept) * norm.h**i * last**kept / (3 * i - kept))
    return total


def read_passage(start: Start, line: Any, numbers: Numbers) -> Passage:
    """Theorem B with the numbers of a line."""
    names = ("damping", "f", "growth", "largest", "least", "norm", "rate", "rectangle", "v", "w")
    damping, f, growth, largest, least, k, rate, rectangle, v, w = entries(line, "the line", *names)
    norm = Norm(*read_list(k, 2), short(growth), short(damping), *read_list(rectangle, 2))
    require(norm.k_1 >= 0 and norm.k_2 >= 0 and min(norm[3:]) > 0, "a number of the norm is negative")
    slow = Slow(start, *(read_polynomial(terms, name) for terms, name in ((v, "v"), (w, "w"), (f, "f"))))
    require(short(largest) > 0 and short(least) > 0, "z_max or the least p is not positive")
    passage = check_barrier(start, slow, norm, short(rate), short(largest), short(least))
    N = norm.surplus(slow)
    check_chart(numbers, N, True, norm.r, norm.h)
    check_chart(numbers, N, False, norm.h, norm.r)
    return passage


def check_passage(hypotheses: Any, statement: Any, lines: Sequence[bytes], limits: Limits, length: int) -> str:
    """The statement that a certificate of so many bytes proves; ``lines``: those after the first."""
    require(hypotheses == HYPOTHESES, "the pages are not those of a passage")
    start = Start(statement)
    require(len(lines) == 1, "there is not one line after the first")
    numbers = Numbers(BITS, Meter(limits, limits.work * WORK + WORK_PER_BYTE * length))
    read_passage(start, read_line(lines[0]), numbers)
    return start.words()
