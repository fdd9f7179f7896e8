"""Signs of dTheta/dtau on ranges, numbers of zeros, brackets: against samples of the power series."""

from __future__ import annotations

import math
from fractions import Fraction
from random import Random

import mpmath
from attack import reference_theta
from attack.answers import AGREED, Answer, Attack, undecided, wrong
from attack.balls_as_numbers import to_fmpq, to_fraction

from gspot_verified import Outcome, Range, number_of_zeros, sign
from gspot_verified.signs.zeros.brackets import zeros_at
from gspot_verified.signs.zeros.zeros import zeros_on_range

_DIGITS = 12


def attack(random: Random) -> Attack:
    """One of the questions below."""
    return random.choice((_sign, _sign, _brackets, _brackets, _count))(random)


def slope(tau: Fraction, beta: Fraction, digits: int = _DIGITS) -> int | None:
    """The sign of dTheta/dtau; None where the reference cannot tell."""
    value, off = reference_theta.by_series(tau, beta, 1, digits)
    if value == 0 and off == 0:
        return 0
    return int(mpmath.sign(value)) if abs(value) > off else None


def _short(random: Random, low: float, high: float) -> Fraction:
    return Fraction(round(random.uniform(low, high) * 64), random.choice((64, 63, 65, 100)))


def _sign(random: Random) -> Attack:
    """A range that is a little part of the plane, at times one that ends at a zero or reaches to infinity."""
    beta_low = random.choice((_short(random, -4, 10), Fraction(random.randint(0, 9)), Fraction(random.randint(1, 9))))
    beta_high = beta_low + random.choice(
        (Fraction(0), Fraction(1, 10**20), Fraction(1, 16), Fraction(1, 2), Fraction(1))
    )
    tau_low = _short(random, -12, 8)
    tau_high = tau_low + random.choice((Fraction(0), Fraction(1, 10**12), Fraction(1, 8), Fraction(1), Fraction(7)))
    closed = [random.random() < 0.7 for _ in range(4)]
    tau = Range(to_fmpq(tau_low), to_fmpq(tau_high), *_ends(tau_low, tau_high, closed[:2]))
    beta = Range(to_fmpq(beta_low), to_fmpq(beta_high), *_ends(beta_low, beta_high, closed[2:]))
    far = random.random()
    if far < 0.2:
        tau = Range(None, to_fmpq(tau_high), False, closed[1])
        tau_low = tau_high - 30
    elif far < 0.3:
        tau = Range(to_fmpq(tau_low), None, closed[0], False)
        tau_high = tau_low + 30
    wanted = random.choice((-1, 1))
    places = (
        [_inside(random, tau_low, tau_high) for _ in range(12)],
        [_inside(random, beta_low, beta_high) for _ in range(12)],
    )
    question = f"sign({tau!r}, {beta!r}, {wanted}, budget=40)"
    return Attack(question, lambda: _judged_sign(tau, beta, wanted, list(zip(*places, strict=True))))


def _ends(low: Fraction, high: Fraction, closed: list[bool]) -> tuple[bool, bool]:
    return (True, True) if low == high else (closed[0], closed[1])


def _inside(random: Random, low: Fraction, high: Fraction) -> Fraction:
    """A point in the open interval, next to an end often."""
    share = random.choice((Fraction(random.randint(1, 99), 100), Fraction(1, 10**6), 1 - Fraction(1, 10**6)))
    return low + (high - low) * share


def _judged_sign(tau: Range, beta: Range, wanted: int, places: list[tuple[Fraction, Fraction]]) -> Answer:
    found = sign(tau, beta, wanted, budget=40)
    if found.verdict.outcome is Outcome.PROVED:
        for point in places:
            if slope(*point) not in (wanted, None):
                return wrong(f"{found.verdict}\n  the sign at tau, beta = {point} is {slope(*point)}")
        return AGREED
    if found.verdict.outcome is Outcome.REFUTED:
        if found.point is None:
            return wrong(f"{found.verdict}: refuted without a point")
        at, power = map(to_fraction, found.point)
        inside = _holds(tau, at) and _holds(beta, power)
        if not inside or found.sign_there == wanted:
            return wrong(f"{found.verdict}: the point {at}, {power} is none against it")
        there = slope(at, power, 40) if abs(at) < 300 else None
        if there is None:
            return undecided("the reference does not reach the point")
        return AGREED if there == found.sign_there else wrong(f"{found.verdict}\n  the sign there is {there}")
    return undecided(f"{found.verdict.reason}")


def _holds(where: Range, point: Fraction) -> bool:
    value = to_fmpq(point)
    above = where.lower is None or value > where.lower or (where.lower_closed and value == where.lower)
    below = where.upper is None or value < where.upper or (where.upper_closed and value == where.upper)
    return bool(above and below)


def _parameter(random: Random) -> Fraction:
    whole = Fraction(random.randint(1, 9))
    near = Fraction(random.choice((-1, 1)), 10 ** random.choice((1, 2, 4, 9)))
    return random.choice((whole + near, _short(random, 0.1, 9.9), whole + Fraction(random.getrandbits(90), 1 << 90)))


def _brackets(random: Random) -> Attack:
    beta, digits = _parameter(random), random.choice((3, 8, 15, 40))
    return Attack(f"zeros_at(fmpq('{beta}'), {digits})", lambda: _judged_brackets(beta, digits))


def _judged_brackets(beta: Fraction, digits: int) -> Answer:
    if beta.denominator == 1:
        return undecided("an integer beta")
    found = [tuple(map(to_fraction, pair)) for pair in zeros_at(to_fmpq(beta), digits).brackets]
    for low, high in found:
        if high - low > Fraction(1, 10**digits) or high <= low:
            return wrong(f"the bracket {low}, {high} is wider than 10^-{digits}")
        if abs(high) > 100:
            continue
        ends = [slope(end, beta, digits + 10) for end in (low, high)]
        if None in ends or ends[0] == ends[1]:
            return wrong(f"no change of sign in the bracket {low}, {high}: {ends}")
    return _compared(beta, found, number_of_zeros(to_fmpq(beta)))


def _compared(beta: Fraction, brackets: list[tuple[Fraction, ...]], number: int | None) -> Answer:
    """Every change of sign on a grid lies in a bracket; the number is that of the law."""
    if number != len(brackets):
        return wrong(f"{len(brackets)} brackets, and the law says {number}")
    changes = sign_changes(beta, Fraction(-9), Fraction(9))
    for low, high in changes:
        hit = [pair for pair in brackets if pair[0] < high and pair[1] > low]
        if not hit:
            return wrong(f"dTheta/dtau changes its sign between {low} and {high}, outside of all {brackets}")
    return AGREED


def sign_changes(
    beta: Fraction, low: Fraction, high: Fraction, step: Fraction = Fraction(1, 8)
) -> list[tuple[Fraction, Fraction]]:
    """Intervals of a grid at whose ends the signs differ."""
    shift = Fraction(1, 1013)
    points = [low + shift + k * step for k in range(math.floor((high - low) / step))]
    signs = [slope(point, beta) for point in points]
    return [
        (points[k], points[k + 1])
        for k in range(len(points) - 1)
        if signs[k] and signs[k + 1] and signs[k] != signs[k + 1]
    ]


def _count(random: Random) -> Attack:
    """The number and the tubes on a range of beta; at some beta of it the changes of sign lie in the tubes."""
    low = _parameter(random)
    high = low + random.choice((Fraction(1, 64), Fraction(1, 4), Fraction(5, 4)))
    betas = [low + (high - low) * Fraction(random.randint(1, 999), 1000) for _ in range(2)]
    return Attack(f"zeros_on_range('[{low}, {high}]'), looked at for {betas}", lambda: _judged_count(low, high, betas))


def _judged_count(low: Fraction, high: Fraction, betas: list[Fraction]) -> Answer:
    found = zeros_on_range(Range(to_fmpq(low), to_fmpq(high), True, True), budget=300)
    open_ones = 0
    for beta in betas:
        if beta.denominator == 1:
            continue
        columns = [c for c in found.columns if c.lower is not None and c.lower <= to_fmpq(beta) <= c.upper]
        changes = sign_changes(beta, Fraction(-9), Fraction(9))
        law = number_of_zeros(to_fmpq(beta))
        if law is not None and len(changes) > law:
            return wrong(f"beta = {beta}: {len(changes)} changes of sign, the law says {law}")
        if not columns:
            open_ones += 1
            continue
        tubes = [tuple(map(to_fraction, tube)) for tube in columns[0].tubes()]
        last = columns[0].pieces[-1].lower
        folds = [piece for piece in columns[0].pieces if piece.kind.value == "fold"]
        for left, right in changes:
            inside = any(a < right and b > left for a, b in tubes)
            beyond = last is not None and right > to_fraction(last)
            folded = any(p.lower is not None and p.upper is not None and to_fraction(p.lower) < right
                         and to_fraction(p.upper) > left for p in folds)  # fmt: skip
            if not (inside or beyond or folded):
                return wrong(f"beta = {beta}: a change of sign in ({left}, {right}), outside of the tubes {tubes}")
    return undecided("no column over the points") if open_ones == len(betas) else AGREED
