"""The law of ``proofs/count_law.md``: its steps one by one, and the count itself by routes that do not use it.

The independent count covers the line by a left tail and a right tail (``proofs/negative.md``, ``proofs/tails.md``) and,
between them, by intervals on which dΘ/dτ or its derivative has a certain sign.
"""

from __future__ import annotations

import itertools
import math
from fractions import Fraction

import mpmath
import pytest
from flint import arb, fmpq, fmpq_poly
from hypothesis import assume, given
from hypothesis import strategies as st
from samples.strategies import near_integers, small_heights, to_fmpq

from gspot_verified import evaluate, polynomial, theta
from gspot_verified.numbers.balls import sign_of, working_bits
from gspot_verified.signs.gamma.count_law import (
    multiplicity_at_zero,
    negative_zeros,
    number_of_zeros,
    numbers_on,
    positive_zeros,
)

Bracket = tuple[Fraction, Fraction]
TAU = fmpq_poly([0, 1])
# Two or three in each cell from (0, 1) to (12, 13).
BETAS = [n + Fraction(k, 16) for n in range(13) for k in ((3, 9, 15) if n % 2 else (1, 6))]


def cell(beta: Fraction) -> int:
    return math.floor(beta)


def sign_at(tau: Fraction, beta: Fraction, derivative: int = 1) -> int | None:
    """The certified sign of a derivative of Θ at a point."""
    return sign_of(evaluate(tau, beta, derivative=derivative).value)


def ball_over(bracket: Bracket) -> arb:
    lower, upper = bracket
    with working_bits(128):
        return arb(to_fmpq((lower + upper) / 2), to_fmpq((upper - lower) / 2))


def zeros_between(lower: Fraction, upper: Fraction, beta: Fraction) -> list[Bracket]:
    """Disjoint brackets, one for each zero of dΘ/dτ(·, β) between two points where it is not 0; all simple.

    Certified: every interval ends with dΘ/dτ of one sign on it, or strictly monotone on it.
    """
    found: list[Bracket] = []
    ends = {end: sign_at(end, beta) for end in (lower, upper)}
    stack = [(lower, upper)]
    while stack:
        left, right = stack.pop()
        assert right - left > Fraction(1, 10**12), "a multiple zero, or a zero at an end"
        ball = ball_over((left, right))
        if sign_of(theta(ball, beta, derivative=1)):
            continue
        if sign_of(theta(ball, beta, derivative=2)):
            assert ends[left]
            assert ends[right]
            if ends[left] != ends[right]:
                found.append((left, right))
            continue
        middle = left + (right - left) * Fraction(7, 15)  # not halves: no end may be a zero such as τ = 0
        ends[middle] = sign_at(middle, beta)
        stack += [(left, middle), (middle, right)]
    return sorted(found)


def left_end(beta: Fraction) -> Fraction:
    """A point at and before which dΘ/dτ < 0."""
    b = beta - 1
    order = max(1, math.floor(b / 3) + 1)
    product = math.prod((abs(b - i) for i in range(3 * order)), start=Fraction(1))
    x = next(x for x in itertools.count(1) if x ** (3 * order) * 3**order * math.factorial(order) > product)
    return Fraction(-x)


def changes(signs: list[int | None]) -> int:
    assert all(signs), signs
    return sum(first != second for first, second in itertools.pairwise(signs))


def right_end(beta: Fraction, most: int = 1) -> tuple[Fraction, int]:
    """A point T and the number (0 or 1, at most ``most``) of zeros of dΘ/dτ on [T, ∞)."""
    m = cell(beta)
    for point in range(1, 100):
        signs = [sign_at(Fraction(point), beta, k) for k in range(1, m + 1)]
        found = changes([*signs, -((-1) ** m)])
        if found <= most:
            return Fraction(point), found
    raise AssertionError("no right end")


def refined(bracket: Bracket, beta: Fraction, width: Fraction = Fraction(1, 2**24)) -> Bracket:
    lower, upper = bracket
    first = sign_at(lower, beta)
    while upper - lower > width:
        middle = (lower + upper) / 2
        lower, upper = (middle, upper) if sign_at(middle, beta) == first else (lower, middle)
    return lower, upper


def refined_zeros(beta: Fraction) -> list[arb]:
    """All zeros of dΘ/dτ(·, β) as narrow balls."""
    zeros = zeros_between(left_end(beta), right_end(beta, 0)[0], beta)
    return [ball_over(refined(bracket, beta)) for bracket in zeros]


def factor(beta: Fraction) -> Fraction:
    """F_b = factor · dΘ/dτ(·, β), b = β − 1."""
    return -1 / beta


# The count


@pytest.mark.parametrize("beta", BETAS, ids=str)
def test_the_law_against_a_certified_count(beta: Fraction) -> None:
    left, (right, tail) = left_end(beta), right_end(beta)
    assert sign_at(left, beta) == -1
    zeros = zeros_between(left, right, beta)
    negative = [bracket for bracket in zeros if bracket[1] < 0]
    positive = [bracket for bracket in zeros if bracket[0] > 0]
    for bracket in zeros:
        if bracket[0] <= 0 <= bracket[1]:
            narrow = refined(bracket, beta)
            (negative if narrow[1] < 0 else positive).append(narrow)
            assert narrow[0] > 0 or narrow[1] < 0
    assert len(negative) == negative_zeros(beta)
    assert len(positive) + tail == positive_zeros(beta)
    assert len(zeros) + tail == number_of_zeros(beta)
    assert multiplicity_at_zero(beta) == 0


@given(st.fractions(Fraction(1, 50), 16, max_denominator=50))
def test_a_scan_finds_no_more_than_the_law_and_the_same_parity(beta: Fraction) -> None:
    assume(beta.denominator > 1)
    signs = [sign_at(Fraction(k, 8), beta) for k in range(-40, 130)]
    seen = changes(signs)
    last = signs[-1] == -((-1) ** cell(beta))
    assert seen <= number_of_zeros(beta)
    assert (number_of_zeros(beta) - seen) % 2 == (0 if last else 1)


@given(st.one_of(small_heights(), near_integers(400), st.fractions(max_denominator=10**6)))
def test_the_parts_add_up(beta: Fraction) -> None:
    assume(beta != 0)
    parts = negative_zeros(beta) + (multiplicity_at_zero(beta) > 0) + positive_zeros(beta)
    assert number_of_zeros(beta) == number_of_zeros(to_fmpq(beta)) == number_of_zeros(str(beta)) == parts
    if beta < 0:
        assert parts == 0
    elif beta.denominator > 1:
        assert parts == cell(beta) % 3 + cell(beta) // 3
        assert (parts - cell(beta)) % 2 == 0  # the signs at both ends of the line
        assert parts <= cell(beta)  # Budan and Fourier


@pytest.mark.parametrize("beta", ["-1/2", "-7", "-1/1000"])
@pytest.mark.parametrize("tau", [-30, -1, 0, "1/3", 12])
def test_negative_beta(tau: int | str, beta: str) -> None:
    assert evaluate(tau, beta, derivative=1).value > 0
    assert number_of_zeros(beta) == 0


@pytest.mark.parametrize("count", [number_of_zeros, positive_zeros, negative_zeros, multiplicity_at_zero])
def test_refusals(count: object) -> None:
    assert callable(count)
    with pytest.raises(TypeError, match="float"):
        count(2.5)
    with pytest.raises(ValueError, match="identically"):
        count(0)
    with pytest.raises(ValueError, match="rational"):
        count(arb(fmpq(5, 2), fmpq(1, 8)))
    with pytest.raises(ValueError, match="finite"):
        count(arb("nan"))
    assert count(arb((5, -1))) == count("5/2")


# Fact 3: the signs at τ = 0

SIGNS_AT_0 = {0: [1, 1, 1], 1: [1, -1, -1], 2: [-1, -1, 1]}


@given(st.one_of(st.fractions(-1, 60, max_denominator=1000), near_integers(60)))
def test_signs_at_0(b: Fraction) -> None:
    assume(b > -1 and b.denominator > 1)
    expected = SIGNS_AT_0[math.ceil(b) % 3]
    assert [sign_at(Fraction(0), b, j) for j in range(3)] == expected


@given(st.fractions(-1, 40, max_denominator=40))
def test_signs_at_0_from_the_printed_initial_values(b: Fraction) -> None:
    """Γ((j−b)/3)/Γ(−b) by mpmath."""
    assume(b > -1 and b.denominator > 1)
    x = mpmath.mpf(b.numerator) / b.denominator
    signs = [int(mpmath.sign(mpmath.gamma((j - x) / 3) * mpmath.gamma(-x))) for j in range(3)]
    assert signs == SIGNS_AT_0[math.ceil(b) % 3]


# Section 2: the identities


def solution(b: Fraction, initial: list[Fraction], order: int) -> fmpq_poly:
    """The first terms of the solution of F''' = τF' − bF with any F(0), F'(0), F''(0)/2."""
    terms = list(initial)
    for k in range(order - 3):
        terms.append((k - b) * terms[k] / ((k + 1) * (k + 2) * (k + 3)))
    return fmpq_poly([to_fmpq(term) for term in terms])


def vanishes(series: fmpq_poly, order: int) -> bool:
    return all(series[k] == 0 for k in range(order))


def q_and_e_residues(f: fmpq_poly, b: fmpq) -> tuple[fmpq_poly, fmpq_poly]:
    d1 = f.derivative()
    d2 = d1.derivative()
    q = d1 * d2 + b / 2 * f * f
    e = f * d2 - d1 * d1 / 2 - TAU * f * f / 2
    return q.derivative() - (d2 * d2 + TAU * d1 * d1), e.derivative() + (b + fmpq(1, 2)) * f * f


@pytest.mark.parametrize("n", range(25))
def test_identities_on_the_integer_polynomials(n: int) -> None:
    for residue in q_and_e_residues(polynomial(n), fmpq(n)):
        assert residue == 0


@given(
    st.fractions(-5, 20, max_denominator=30), st.lists(st.fractions(-3, 3, max_denominator=9), min_size=3, max_size=3)
)
def test_identities_on_every_solution(b: Fraction, initial: list[Fraction]) -> None:
    order = 24
    for residue in q_and_e_residues(solution(b, initial, order), to_fmpq(b)):
        assert vanishes(residue, order - 3)


@given(st.fractions(0, 14, max_denominator=30), st.fractions(0, 8, max_denominator=8))
def test_q_increases(b: Fraction, tau: Fraction) -> None:
    assume(b > 0)

    def quantity(at: Fraction) -> arb:
        g, d1, d2 = (theta(at, b, derivative=k, digits=40) for k in range(3))
        with working_bits(128):
            return d1 * d2 + to_fmpq(b) / 2 * g * g

    assert quantity(tau + Fraction(1, 8)) > quantity(tau)


@given(st.fractions(-1, 14, max_denominator=30), st.fractions(-6, 8, max_denominator=8))
def test_identities_on_balls(b: Fraction, tau: Fraction) -> None:
    """The product rule, with the third derivative from the library instead of the equation."""
    f, d1, d2, d3 = (theta(tau, b, derivative=k, digits=30) for k in range(4))
    with working_bits(128):
        t, p = arb(to_fmpq(tau)), to_fmpq(b)
        assert (d2 * d2 + d1 * d3 + p * f * d1).overlaps(d2 * d2 + t * d1 * d1)
        assert (f * d3 - f * f / 2 - t * f * d1).overlaps(-(p + fmpq(1, 2)) * f * f)


# Sections 1 and 3, at the zeros themselves


@pytest.mark.parametrize("beta", [beta for beta in BETAS if beta > 1], ids=str)
def test_at_positive_zeros_first_and_second_derivative_agree_in_sign(beta: Fraction) -> None:
    positive = [zero for zero in refined_zeros(beta) if zero > 0]
    assert len(positive) == positive_zeros(beta)
    for zero in positive:
        assert theta(zero, beta, derivative=2) * theta(zero, beta, derivative=3) > 0


@pytest.mark.parametrize("beta", [beta for beta in BETAS if beta > 1], ids=str)
def test_the_next_function_at_the_zeros(beta: Fraction) -> None:
    """F_{b+1} = g'' at the zeros of g = F_b, with the sign (−1)^i g(0)."""
    scale = to_fmpq(factor(beta))
    at_0 = sign_of(theta(0, beta, derivative=1) * scale)
    positive = [zero for zero in refined_zeros(beta) if zero > 0]
    for i, zero in enumerate(positive, start=1):
        value = theta(zero, beta + 1, derivative=1) * to_fmpq(factor(beta + 1))
        assert value.overlaps(theta(zero, beta, derivative=3) * scale)
        assert at_0 is not None
        assert sign_of(value) == (-1) ** i * at_0


@pytest.mark.parametrize("beta", [beta for beta in BETAS if cell(beta) % 3 == 2], ids=str)
def test_the_next_function_at_the_negative_zero(beta: Fraction) -> None:
    """F_b(c) = (b−1)(b−2) F_{b−3}(c) > 0 at the negative zero c of F_{b−1}; here b = β."""
    (zero,) = [zero for zero in refined_zeros(beta) if zero < 0]
    value = theta(zero, beta)
    assert value > 0
    assert value.overlaps(theta(zero, beta - 3) * to_fmpq((beta - 1) * (beta - 2)))


@pytest.mark.parametrize("beta", [beta for beta in BETAS if beta > 1], ids=str)
def test_interlacing(beta: Fraction) -> None:
    here = [zero for zero in refined_zeros(beta + 1) if zero > 0]
    before = [zero for zero in refined_zeros(beta) if zero > 0]
    for first, second in itertools.pairwise(here):
        assert sum(bool(first < zero < second) for zero in before) == 1
    assert all(zero < here[-1] for zero in before)


# Section 4: integer β


def sturm(p: fmpq_poly, lower: fmpq | None, upper: fmpq | None) -> int:
    """The number of distinct real roots in (lower, upper]; ``None`` is infinity, and no end is a multiple root."""
    chain = [p, p.derivative()]
    while chain[-1] != 0:
        chain.append(-(chain[-2] % chain[-1]))

    def variations(at: fmpq | None, side: int) -> int:
        values = [q(at) if at is not None else q[q.degree()] * side ** q.degree() for q in chain[:-1]]
        signs = [value > 0 for value in values if value != 0]
        return sum(first != second for first, second in itertools.pairwise(signs))

    return variations(lower, -1) - variations(upper, 1)


def reduced(n: int) -> tuple[fmpq_poly, int]:
    """dΘ/dτ(·, n) without its factor τ^r, and r."""
    coefficients = polynomial(n).derivative().coeffs()
    r = next(k for k, value in enumerate(coefficients) if value != 0)
    return fmpq_poly(coefficients[r:]), r


@pytest.mark.parametrize("n", range(1, 41))
def test_integer_beta_by_sturm(n: int) -> None:
    rest, r = reduced(n)
    assert multiplicity_at_zero(n) == r
    assert sturm(rest, fmpq(0), None) == positive_zeros(n)
    assert sturm(rest, None, fmpq(0)) == negative_zeros(n) == 0
    assert number_of_zeros(n) == sturm(rest, None, None) + (r > 0)
    if n > 3:
        assert rest.gcd(rest.derivative()).degree() == 0  # simple
    assert positive_zeros(n) + r == (n - 1) % 3 + (n - 1) // 3  # with multiplicity: as many as in the cell before


def test_sturm_itself() -> None:
    p = fmpq_poly([-1, 1]) ** 2 * fmpq_poly([2, 1]) * fmpq_poly([1, 0, 1])
    assert (sturm(p, None, None), sturm(p, fmpq(0), None), sturm(p, None, fmpq(-3))) == (2, 1, 0)


# Section 5: what happens at an integer


@pytest.mark.parametrize("n", range(1, 14))
def test_before_and_after_an_integer(n: int) -> None:
    rest, r = reduced(n)
    bound = next(t for t in itertools.count(1) if sturm(rest, fmpq(t), None) == 0) + 1
    before, after = (n + sign * Fraction(1, 10**6) for sign in (-1, 1))
    span = Fraction(-5), Fraction(bound)
    assert len(zeros_between(*span, before)) == number_of_zeros(before)  # all zeros stay
    assert len(zeros_between(*span, after)) == number_of_zeros(after) - 1  # and one more comes in from +∞
    assert sign_at(span[1], after) == (-1) ** n
    assert sign_at(Fraction(10 * n + 40), after) == -((-1) ** n)
    near_0 = [len(zeros_between(Fraction(-1, 10), Fraction(1, 10), beta)) for beta in (before, after)]
    assert near_0 == [r, {0: 0, 1: 1, 2: 0}[r]]


@given(st.fractions(0, 40), st.fractions(0, 40))
def test_numbers_on_a_range_are_those_of_its_cells(one: Fraction, two: Fraction) -> None:
    lower, upper = min(one, two), max(one, two)
    assume(lower < upper)
    statement = numbers_on(f"{lower}..{upper}")
    assert [m for m, _ in statement.counts] == list(range(math.floor(lower), math.ceil(upper)))
    for m, number in statement.counts:
        inside = (max(lower, Fraction(m)) + min(upper, Fraction(m + 1))) / 2
        assert number == number_of_zeros(inside)


@pytest.mark.parametrize(
    ("beta", "message"),
    [
        ("-1..2", "must lie inside"), ("0..inf", "must lie inside"), ("7", "polynomial"), ("7..7", "empty"),
        ("0..1001", "at most 1000"), ("1/2..1001", "at most 1000"),
    ],
)  # fmt: skip
def test_ranges_without_numbers(beta: str, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        numbers_on(beta)


def test_the_widest_range() -> None:
    assert len(numbers_on("1..1001").counts) == 1000
    assert numbers_on("7/2").counts == ((3, 1),)
