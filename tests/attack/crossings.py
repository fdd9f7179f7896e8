"""Events on sets of states: each start in the set has its crossing inside the bracket, and all of its states there are
in the box that is handed on; the field turns, so that a set is wide in a new direction at each time."""

from __future__ import annotations

from fractions import Fraction
from random import Random

import mpmath
from attack.answers import AGREED, Answer, Attack, undecided, wrong
from attack.balls_as_numbers import exactly, holds, to_fmpq
from flint import arb

from gspot_verified.functions.derivative import plus, times
from gspot_verified.functions.expressions import Constant, Expression, Variable
from gspot_verified.integrator.box_steps.integrate import Run
from gspot_verified.integrator.field.event import Crossing, Moment, Watch
from gspot_verified.integrator.field.field import VectorField
from gspot_verified.integrator.norm_steps.norm_run import NormRun
from gspot_verified.numbers.balls import working_bits

_X, _Y, _S = (Variable(i) for i in range(3))
_OFF = mpmath.mpf(10) ** -40


def attack(random: Random) -> Attack:
    """x' = -y, y' = x, s' = speed + pull x from a box; g = s + tilt y rises through 0."""
    speed, pull = Fraction(random.randint(9, 40), 10) / 2, Fraction(random.randint(-20, 20), 10)
    tilt = random.choice((Fraction(0), Fraction(random.randint(-8, 8), 10)))
    centre = [Fraction(random.randint(-10, 10), 10) for _ in range(2)] + [-Fraction(random.randint(2, 60), 10)]
    radius = [random.choice((Fraction(0), Fraction(1, 10**6), Fraction(1, 100), Fraction(1, 10))) for _ in range(3)]
    if random.random() < 0.5:  # a slow rise of a wide set
        speed, pull, tilt = 1 + Fraction(random.randint(1, 20), 100), Fraction(1), Fraction(0)
        centre, radius = (
            [Fraction(1), Fraction(0), centre[2] - 2],
            [radius[0], radius[1], Fraction(random.randint(1, 8), 8)],
        )
    shares = [[random.choice((-1, 1)) for _ in range(3)] for _ in range(3)]
    shares += [[Fraction(random.randint(-100, 100), 100) for _ in range(3)] for _ in range(3)]
    norm = random.random() < 0.5
    question = (
        f"{'NormRun' if norm else 'Run'}: {speed=!s}, {pull=!s}, {tilt=!s}, box {centre} +/- {radius}, at {shares}"
    )
    return Attack(question, lambda: _judged(speed, pull, tilt, centre, radius, shares, norm))


def _constant(value: Fraction) -> Expression:
    return Constant(to_fmpq(value))


def _judged(
    speed: Fraction, pull: Fraction, tilt: Fraction, centre: list[Fraction], radius: list[Fraction],
    shares: list[list[Fraction]], norm: bool,
) -> Answer:  # fmt: skip
    field = VectorField([times(_constant(Fraction(-1)), _Y), _X, plus(_constant(speed), times(_constant(pull), _X))])
    function = plus(_S, times(_constant(tilt), _Y)) if tilt else _S
    starts = [[c + r * s for c, r, s in zip(centre, radius, share, strict=True)] for share in shares]
    with working_bits(192):
        box = [
            arb(to_fmpq(c)) + arb(0, 1) * arb(to_fmpq(r)) if r else arb(to_fmpq(c))
            for c, r in zip(centre, radius, strict=True)
        ]
        watch = Watch("event", function, field)
        if not watch.value(box) < 0:
            return undecided("the set does not begin before the event")
        found, passed = None, arb(0)
        for segment in (NormRun if norm else Run)(field, box, arb(12)):
            found = watch.along(segment)
            if found is not None:
                break
            passed = segment.time + segment.step.h if watch.excluded(Moment(segment, arb(1))) else passed
    with mpmath.workdps(60):
        if isinstance(found, Crossing):
            return _crossing(found, speed, pull, tilt, starts)
        if found is not None:
            return undecided("Unclear")
        end = exactly(passed.mid())
        for start in starts:
            if any(_g(speed, pull, tilt, start, end * k / 400) > _OFF for k in range(401)):
                return wrong(f"no event was seen up to {mpmath.nstr(end, 10)}, and g > 0 from {start}")
        return AGREED


def _states(speed: Fraction, pull: Fraction, start: list[Fraction], t: mpmath.mpf) -> list[mpmath.mpf]:
    """In closed form."""
    x, y, s = (mpmath.mpf(v.numerator) / v.denominator for v in start)
    c, d = (mpmath.mpf(v.numerator) / v.denominator for v in (speed, pull))
    cosine, sine = mpmath.cos(t), mpmath.sin(t)
    return [x * cosine - y * sine, y * cosine + x * sine, s + c * t + d * (x * sine + y * (cosine - 1))]


def _g(speed: Fraction, pull: Fraction, tilt: Fraction, start: list[Fraction], t: mpmath.mpf) -> mpmath.mpf:
    _, y, s = _states(speed, pull, start, t)
    return s + tilt.numerator * y / tilt.denominator


def _zero(
    speed: Fraction, pull: Fraction, tilt: Fraction, start: list[Fraction], low: mpmath.mpf, high: mpmath.mpf
) -> mpmath.mpf:
    """By bisection."""
    for _ in range(220):
        middle = (low + high) / 2
        low, high = (low, middle) if _g(speed, pull, tilt, start, middle) > 0 else (middle, high)
    return low


def _crossing(found: Crossing, speed: Fraction, pull: Fraction, tilt: Fraction, starts: list[list[Fraction]]) -> Answer:
    middle, radius = exactly(found.time.mid()), exactly(found.time.rad())
    low, high = middle - radius, middle + radius
    for start in starts:
        if _g(speed, pull, tilt, start, low) > _OFF or _g(speed, pull, tilt, start, high) < -_OFF:
            return wrong(f"no crossing in the bracket {found.time} from {start}")
        if any(_g(speed, pull, tilt, start, low * k / 400) > _OFF for k in range(400)):
            return wrong(f"a crossing before the bracket {found.time} from {start}")
        # The box is that of the moments from begin to end, whose times are balls: the zero, and what lies between.
        first, last = exactly(found.begin.time.upper()), exactly(found.end.time.lower())
        between = [first + (last - first) * k / 20 for k in range(21)] if first < last else []
        for time in [_zero(speed, pull, tilt, start, low, high), *between]:
            for name, ball, state in zip("xys", found.states, _states(speed, pull, start, time), strict=True):
                if not holds(ball, state, _OFF):
                    shown = (
                        f"{name} = {mpmath.nstr(state, 15)} at t = {mpmath.nstr(time, 15)} of the bracket {found.time}"
                    )
                    return wrong(f"{shown}, from {start}, is not in the box {ball} that is handed on")
    if not found.rate > 0:
        return wrong(f"a crossing whose rate {found.rate} is not certainly > 0")
    return AGREED
