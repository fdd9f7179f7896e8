"""Theta and its derivatives against three other ways to them: at integers, next to them, on balls over them, with long
denominators, where the package's route changes, far out, next to zeros."""

from __future__ import annotations

from fractions import Fraction
from random import Random

import mpmath
from attack import reference_theta
from attack.answers import AGREED, Answer, Attack, undecided, worst, wrong
from attack.balls_as_numbers import accurate, holds, to_fmpq
from flint import arb

from gspot_verified import BudgetError, evaluate


def rational(random: Random, size: float) -> Fraction:
    """A number up to ``size``: an integer, next to one, short, or with a long denominator."""
    whole = Fraction(round(random.uniform(-size, size)))
    near = Fraction(random.choice((-1, 1)), 10 ** random.choice((1, 3, 8, 20, 40, 80)))
    short = Fraction(random.randint(-100, 100), random.choice((2, 3, 4, 7, 12, 60))) % max(1, int(size))
    long = Fraction(round(random.uniform(-size, size) * 10**9), 10**9 + random.randrange(1, 10**6, 2))
    deep = whole + Fraction(random.getrandbits(300), 1 << 301) - Fraction(1, 4)
    return random.choice((whole, whole + near, short * random.choice((-1, 1)), long, deep))


def attack(random: Random) -> Attack:
    """One of the questions below."""
    return random.choice((_anywhere, _anywhere, _balls, _border, _far_out, _far_derivative, _near_zero))(random)


def _point(random: Random) -> tuple[Fraction, Fraction]:
    tau = rational(random, random.choice((1, 5, 20, 60, 120)))
    beta = rational(random, random.choice((2, 6, 15, 40)))
    if random.random() < 0.1:
        tau = Fraction(random.choice((-1, 0, 1)), 10 ** random.choice((1, 20, 200)))
    return tau, beta


def _anywhere(random: Random) -> Attack:
    tau, beta = _point(random)
    derivative = random.choice((0, 0, 1, 1, 2, 3, 7, 30))
    return at_a_point(tau, beta, derivative, random.choice((3, 15, 16, 30, 60)))


def _far_out(random: Random) -> Attack:
    size = 10 ** random.uniform(2, 12)
    tau = Fraction(random.choice((-1, -1, 1)) * round(size * 1000), 1000)
    if tau > 0:
        tau = Fraction(round(10 ** random.uniform(2.4, 5) * 8), 8)
    return at_a_point(tau, rational(random, random.choice((2, 8))), 0, random.choice((10, 25)))


def _far_derivative(random: Random) -> Attack:
    """Beyond where the series is short, on both sides of where the package changes its route."""
    tau = Fraction(random.choice((-1, 1)) * round(10 ** random.uniform(2.4, 4) * 1000), 1000)
    beta = rational(random, random.choice((1, 4, 8)))
    return at_a_point(tau, beta, random.choice((1, 1, 2, 3, 5, 9)), random.choice((10, 25)))


def _border(random: Random) -> Attack:
    """Both sides of a tau at which the package changes its route."""
    beta, digits, derivative = rational(random, 9), random.choice((10, 15, 30, 70)), random.choice((0, 1, 2))
    low, high = Fraction(random.randint(-60, 0)), Fraction(random.randint(1, 60)) + rational(random, 1)
    pick = random.randrange(12)
    question = f"the border of routes for {beta=!s}, {digits=}, {derivative=} in [{low}, {high}], change {pick}"

    def ask() -> Answer:
        grid = [low + (high - low) * k / 12 for k in range(13)]
        routes = [_route(tau, beta, derivative, digits) for tau in grid]
        changes = [k for k in range(12) if routes[k] != routes[k + 1]]
        if not changes:
            return worst([at_a_point(tau, beta, derivative, digits).ask() for tau in (low, high)])
        k = pick % len(changes)
        first, last, before = grid[changes[k]], grid[changes[k] + 1], routes[changes[k]]
        for _ in range(40):
            middle = Fraction(round((first + last) / 2 * 2**50), 2**50)
            first, last = (middle, last) if _route(middle, beta, derivative, digits) == before else (first, middle)
        return worst([at_a_point(tau, beta, derivative, digits).ask() for tau in (first, last)])

    return Attack(question, ask)


def _route(tau: Fraction, beta: Fraction, derivative: int, digits: int) -> str:
    return evaluate(to_fmpq(tau), to_fmpq(beta), derivative, digits).route


def at_a_point(tau: Fraction, beta: Fraction, derivative: int, digits: int) -> Attack:
    """The ball is finite, holds the reference, and is as narrow as it says; or it says that it is not."""

    def ask() -> Answer:
        try:
            found = evaluate(to_fmpq(tau), to_fmpq(beta), derivative, digits)
        except BudgetError as error:
            return undecided(f"BudgetError: {error}")
        if not found.value.is_finite():
            return wrong(f"reached, with {found.value}") if found.reached else undecided("not finite, not reached")
        value, off = reference_theta.reference(tau, beta, derivative, digits + 20)
        shown = f"evaluate({tau}, {beta}, {derivative}, {digits}): {found.value} by {found.route}"
        if not holds(found.value, value, off):
            return wrong(f"{shown}\n  reference {mpmath.nstr(value, digits + 10)} +/- {mpmath.nstr(off, 3)}")
        if found.reached and not accurate(found.value, digits) and found.value != 0:
            return wrong(f"{shown}: said to be reached, and it is wider than 10^-{digits}")
        return AGREED if found.reached else undecided("holds the reference, accuracy not reached")

    return Attack(f"evaluate(fmpq('{tau}'), fmpq('{beta}'), {derivative}, {digits})", ask)


def _balls(random: Random) -> Attack:
    """Balls around a point, over integers often: the values at some exact points in them."""
    tau, beta = _point(random)
    widths = [Fraction(random.choice((0, 1, 1, 3)), 2 ** random.choice((1, 4, 10, 30, 70))) for _ in range(2)]
    derivative = random.choice((0, 0, 1, 2, 5))
    digits = random.choice((5, 15, 40))
    centres = [Fraction(round(x * 2**80), 2**80) if w else x for x, w in zip((tau, beta), widths, strict=True)]
    shares = [(random.choice((-1, 0, 1)), random.choice((-1, 0, 1)))] + [
        (Fraction(random.randint(-64, 64), 64), Fraction(random.randint(-64, 64), 64)) for _ in range(2)
    ]
    if any(abs(c) > 10**4 for c in centres):
        centres = [c % 100 for c in centres]

    def ask() -> Answer:
        inputs = [_ball(c, w) if w else to_fmpq(c) for c, w in zip(centres, widths, strict=True)]
        try:
            found = evaluate(*inputs, derivative, digits)
        except BudgetError as error:
            return undecided(f"BudgetError: {error}")
        if not found.value.is_finite():
            return wrong("reached, and not finite") if found.reached else undecided("a ball that is not finite")
        for share in shares:
            point = [c + w * s for c, w, s in zip(centres, widths, share, strict=True)]
            value, off = reference_theta.reference(point[0], point[1], derivative, 40)
            if not holds(found.value, value, off):
                return wrong(f"{found.value} by {found.route} without {mpmath.nstr(value, 40)} at {point}")
        return AGREED

    text = ", ".join(f"{c} +/- {w}" for c, w in zip(centres, widths, strict=True))
    return Attack(f"evaluate of the balls {text}, derivative {derivative}, {digits} digits, at {shares}", ask)


def _ball(centre: Fraction, radius: Fraction) -> arb:
    """Exact: both are dyadic."""
    return arb(_dyadic(centre), _dyadic(radius))


def _dyadic(value: Fraction) -> tuple[int, int]:
    assert value.denominator & (value.denominator - 1) == 0
    return value.numerator, 1 - value.denominator.bit_length()


def _near_zero(random: Random) -> Attack:
    """The value at a rational that agrees with a zero to some digits."""
    beta = abs(rational(random, 8))
    low, digits, derivative = Fraction(random.randint(-40, 20), 10), random.choice((10, 15, 30)), random.choice((0, 1))
    places = random.choice((5, 20, 45))

    def ask() -> Answer:
        zero = _zero_after(low, beta, derivative)
        if zero is None:
            return undecided("no zero was found there")
        with mpmath.workdps(90):
            return at_a_point(Fraction(int(zero * 10**places), 10**places), beta, derivative, digits).ask()

    return Attack(f"next to the first zero after {low} of derivative {derivative}, {beta=!s}, {places} places", ask)


def _zero_after(low: Fraction, beta: Fraction, derivative: int) -> mpmath.mpf | None:
    def sign(tau: Fraction) -> int:
        return int(mpmath.sign(reference_theta.by_series(tau, beta, derivative, 10)[0]))

    first = sign(low)
    for k in range(1, 24):
        right = low + Fraction(k, 2)
        if sign(right) == -first:
            left = right - Fraction(1, 2)
            for _ in range(170):
                middle = (left + right) / 2
                value = reference_theta.by_series(middle, beta, derivative, 60)[0]
                left, right = (middle, right) if mpmath.sign(value) == first else (left, middle)
            with mpmath.workdps(90):
                return reference_theta.mp((left + right) / 2)
    return None
