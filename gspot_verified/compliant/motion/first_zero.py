"""The first zero of the contact force from an initial state: lambda > 0 before it, a bracket, transversality.

Proof pages: ``proofs/force_range.md``; near the initial state ``proofs/contact_series.md``, section 4.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import ClassVar

from flint import arb, fmpq

from gspot_verified.compliant.model.normal_form import CompliantModel, CompliantState
from gspot_verified.compliant.motion.compliant_force import (
    LEAST_EPSILON_OF_QUADRATURE,
    ContactMotion,
    contact_motion,
)
from gspot_verified.compliant.motion.contact_series import series_cells, series_rate
from gspot_verified.compliant.motion.force_range import ForceRange
from gspot_verified.compliant.motion.rough_zero import rough_zero
from gspot_verified.compliant.motion.zero_by_series import MOST_WORK, SeriesZero, positive_by_series, zero_by_series
from gspot_verified.leading_order.contact_force import rational
from gspot_verified.numbers.balls import ExactInput, approximate, bits_for_digits, working_bits
from gspot_verified.numbers.evidence import Ends, at_most, cover, every, less
from gspot_verified.numbers.short_text import decimal_text
from gspot_verified.numbers.verdict import Evidence, NoTruthValue, Reason, Verdict
from gspot_verified.numbers.written import Written

MAX_DIGITS = 100  # of the bracket; a limit of input: ValueError beyond it
_MARGINS = (fmpq(1, 16), fmpq(1, 4), fmpq(1))
_MOST_PIECES = 400  # of time, against endless work; then nothing is said
_NEWTON_STEPS = 8  # of the secant method, against endless work
_START_BITS = 60  # of what only says where to look, and of a factor of enclosures
_FIRST_INSTANTS = fmpq(500)  # in T: where the fast part hides the sign so long, the power series tells it
_AS_SHOWN = "λ_N > 0 before it, dλ_N/dt < 0 at it"


@dataclass(frozen=True, slots=True)
class FirstZero(NoTruthValue, Written):
    """When contact is lost: the first zero of the contact force lies between ``lower`` and ``upper`` (times measured
    from the G-spot, p = alpha_1 t; ``start`` is the time of the initial state), the force is > 0 from the start up to
    it and falls through 0 there. Undecided: no bracket."""

    written: ClassVar[str] = "model start lower upper verdict"

    model: CompliantModel
    start: fmpq
    verdict: Verdict
    lower: fmpq | None = None
    upper: fmpq | None = None

    def __str__(self) -> str:
        if self.lower is None or self.upper is None:
            return str(self.verdict)
        since = decimal_text(self.lower - self.start, self.upper - self.start)
        return f"{self.verdict}\n  t = {decimal_text(self.lower, self.upper)}; since the initial state {since}"


def contact_lasts(model: CompliantModel, state: CompliantState, until: ExactInput, budget: int = MOST_WORK) -> Verdict:
    """Whether the contact force is > 0 from the initial state up to the time ``until`` (p = alpha_1 t): contact lasts.

    Proved, or undecided: a refutation is the business of :func:`first_zero`.

    From a state with p <= 0 about 1 000 units epsilon/|alpha_1| of time are in reach; more with a larger ``budget``,
    the work of the power series (rate times time).

    :raises ValueError: ``until`` is before the state.

    >>> from gspot_verified import compliant_model, compliant_state
    >>> state = compliant_state("1/2", "-1/6", "-1/15000", 0, "-1/30000")
    >>> contact_lasts(compliant_model("5/2", "1/100"), state, 0).outcome.value
    'proved'
    """
    end = rational(until, "until")
    motion = contact_motion(model, state)
    assert motion.state is not None
    if model.alpha_1 * end > motion.state.p:
        raise ValueError(f"until: {end} is before the initial state")
    text = f"in the compliant model, from this initial state, λ_N > 0 up to t = {end}"
    shown = _lasts(motion, -model.alpha_1 * end / model.scaled_epsilon, budget)
    if shown is not None:
        return Verdict.proved(text, shown)
    if not motion.state.p > 0:
        detail = f"not shown by the power series within its budget of {budget} (its work, rate times time)"
        return Verdict.undecided(text, Reason.BUDGET, detail)
    return Verdict.undecided(
        text, Reason.HYPOTHESIS, "the force is too small, or its fast part too large for the bound"
    )


def _lasts(motion: ContactMotion, end: fmpq, budget: int) -> Evidence | None:
    """lambda > 0 from the state up to T = ``end``; the first instants by the power series where the bound fails."""
    state = motion.state
    assert state is not None
    mean = motion.model.mean_force * motion.model.sigma**2
    if not state.p > 0:
        return positive_by_series(state, mean, end - state.time, budget)
    force = _force_range(motion)
    if (shown := _positive(force, state.time, end)) is not None:
        return shown
    head = state.time + min(_FIRST_INSTANTS, end - state.time)
    before = positive_by_series(state, mean, head - state.time, budget)
    if before is None or head == end:
        return before
    return every([before, _positive(force, head, end)])


def first_zero(model: CompliantModel, state: CompliantState, digits: int = 25, budget: int = MOST_WORK) -> FirstZero:
    """The time at which the contact force first vanishes, in a bracket of 10^-digits times (epsilon/2)^(-1/3) epsilon.

    The unit of the bracket is that of tau = (epsilon/2)^(1/3) t/epsilon, in which the G-spot has width 1. From a state
    with p <= 0 about 1 000 units epsilon/|alpha_1| of time are looked at, and from others where the bound of the fast
    part does not say enough.

    :param digits: 1..100.
    :param budget: the work of the power series, rate times time; the rate is 3 or more for each unit of time.
    :raises ValueError: digits out of range.

    >>> from gspot_verified import compliant_model, compliant_state
    >>> model = compliant_model("3/2", "1e-9")
    >>> b, small = fmpq(-2), model.epsilon
    >>> data = compliant_state("1/2", b, 4 * small**2 * b, 0, 2 * small**2 * b)
    >>> zero = first_zero(model, data)
    >>> print(zero.verdict.outcome.value, decimal_text(zero.lower + fmpq(1, 2), zero.upper + fmpq(1, 2))[:20])
    proved 0.500006988019767490
    """
    if not 1 <= digits <= MAX_DIGITS:
        raise ValueError(f"digits must lie in 1..{MAX_DIGITS}, got {digits}")
    motion = contact_motion(model, state)
    assert motion.state is not None
    start = state.p / model.alpha_1
    text = "in the compliant model, from this initial state, the contact force has its first zero in the bracket"
    zero = _by_force_range(motion, start, text, digits, budget) if state.p > 0 else None
    if zero is None:
        zero = _by_series(motion, start, text, digits, budget)
    if zero is not None:
        return zero
    before = "the bound of the fast part does not show it, and " if state.p > 0 else ""
    detail = f"{before}the power series found no bracket within its budget of {budget} (its work, rate times time)"
    return FirstZero(model, start, Verdict.undecided(text, Reason.BUDGET, detail))


def _by_force_range(motion: ContactMotion, start: fmpq, text: str, digits: int, budget: int) -> FirstZero | None:
    """The bracket from a state with p > 0, by the slow part and a bound of the fast one."""
    model, state = motion.model, motion.state
    assert state is not None
    force = _force_range(motion)
    rough = rough_zero(force, state.time, _unit(motion))
    if rough is None:
        return None
    unit = _unit(motion)
    for margin in _MARGINS:
        before, after = max(rough - margin * unit, state.time), rough + margin * unit
        if before < 0 < after:
            continue
        falls, lasts = less(force.slope(before, after), 0), None
        if falls is not None:
            lasts = _lasts(motion, before, budget)
        if lasts is None:
            continue
        second = model.scaled_epsilon / -model.alpha_1
        bracket = _bracket(motion, (before, rough, after), unit / fmpq(10) ** digits, digits)
        if bracket is None:
            return None
        lower, upper = _outward(bracket.lower * second, bracket.upper * second)
        within = [at_most(before * second, lower), at_most(upper, after * second)]
        outside = [at_most(lower, bracket.lower * second), at_most(bracket.upper * second, upper)]
        evidence = every([lasts, falls, bracket.evidence, *within, *outside])
        if evidence is None:
            return None
        return FirstZero(model, start, Verdict.proved(text, evidence, _AS_SHOWN), lower, upper)
    return None


def _by_series(motion: ContactMotion, start: fmpq, text: str, digits: int, budget: int) -> FirstZero | None:
    """The bracket from any state, by the power series."""
    model, state = motion.model, motion.state
    assert state is not None
    mean = model.mean_force * model.sigma**2
    width = _unit(motion) / fmpq(10) ** digits
    bracket = zero_by_series(state, mean, width, 2 * bits_for_digits(digits) + _START_BITS, budget)
    if bracket is None:
        return None
    second = model.scaled_epsilon / -model.alpha_1
    first, last = start + bracket.lower * second, start + bracket.upper * second
    lower, upper = _outward(first, last)
    evidence = every([bracket.evidence, at_most(lower, first), at_most(last, upper)])
    if evidence is None:
        return None
    return FirstZero(model, start, Verdict.proved(text, evidence, _AS_SHOWN), max(lower, start), upper)


def _force_range(motion: ContactMotion) -> ForceRange:
    return ForceRange(motion, motion.coefficient(_START_BITS))


def _unit(motion: ContactMotion) -> fmpq:
    """About (epsilon/2)^(-1/3), the unit of tau in T; any number is right."""
    with working_bits(_START_BITS):
        eta = (arb(motion.model.scaled_epsilon) / 2).root(3)
        return fmpq(*approximate(1 / eta).as_integer_ratio())


def _positive(force: ForceRange, first: fmpq, last: fmpq) -> Evidence | None:
    """lambda > 0 on [first, last], certainly: two parts again and again, those before and after 0 apart."""
    unit = _unit(force.motion)
    waiting = [(first, min(last, fmpq(0)))] if first < 0 else []
    if last > 0:
        waiting.append((max(first, fmpq(0)), last))
    parts: list[Ends] = []
    shown: list[Evidence] = []
    for _ in range(_MOST_PIECES):
        if not waiting:
            break
        begin, end = waiting.pop()
        if (above := less(0, force.over(begin, end))) is not None:
            parts.append((begin, end))
            shown.append(above)
            continue
        if begin == end:
            return None
        middle = _cut(begin, end, unit)
        if force.near(middle) < 0:  # a heuristic: no use in going on
            return None
        waiting += [(begin, middle), (middle, end)]
    return every([cover(parts, (first, last)), *shown])


def _cut(begin: fmpq, end: fmpq, unit: fmpq) -> fmpq:
    """A time between two: the middle; far before 0 that in the scale of log(-T), in which the force changes steadily.

    Any time between the two is right.
    """
    far, near = -begin, max(-end, unit)
    if far <= 16 * near:
        return (begin + end) / 2
    low, high = (int(size.ceil()).bit_length() for size in (near, far))
    return -(fmpq(2) ** ((low + high) // 2))


def _bracket(motion: ContactMotion, places: tuple[fmpq, fmpq, fmpq], width: fmpq, digits: int) -> SeriesZero | None:
    """Two times ``width`` apart at which the force is certainly > 0 and < 0, by the secant method.

    ``places``: about the zero, and times before and after it between which it is sought.
    """
    coarse, fine = bits_for_digits(12), bits_for_digits(digits + 8)
    rough, step = places[1], _unit(motion) / 10**3
    value = _value_between(motion, places[0], places[2], fine)
    points = [(place, value(place, coarse)) for place in (rough, rough + step)]
    bits = coarse
    for _ in range(_NEWTON_STEPS):
        (first, one), (second, two) = points[-2:]
        with working_bits(fine + 64):
            change = (one - two).mid()
            if change.is_zero() or not change.is_finite():
                return None
            shift = (two.mid() * (second - first) / change).mid()
        root = second + _rational(shift, fine)
        if abs(root - second) < width:
            lower, upper = root - width / 2, root + width / 2
            signs = every([less(0, value(lower, fine)), less(value(upper, fine), 0)])
            return None if signs is None else SeriesZero(lower, upper, signs)
        bits = fine if bits > coarse or abs(root - second) < step / 10**3 else coarse
        points.append((root, value(root, bits)))
    return None


def _outward(lower: fmpq, upper: fmpq) -> tuple[fmpq, fmpq]:
    """Both rounded outward to decimals, one digit beyond their difference."""
    tens = fmpq(1)
    while tens * (upper - lower) < 10:
        tens *= 10
    return fmpq((lower * tens).floor()) / tens, fmpq((upper * tens).ceil()) / tens


def _value_between(motion: ContactMotion, before: fmpq, after: fmpq, bits: int) -> Callable[[fmpq, int], arb]:
    """lambda at T, in the normal form, as a function of T in [before, after] and of the bits that are asked for.

    Where the fast part is found by quadrature, all values come from one power series; ``bits`` are its bits.
    """
    model, state = motion.model, motion.state
    assert state is not None
    if model.scaled_epsilon < LEAST_EPSILON_OF_QUADRATURE:
        return partial(_value, motion)
    mean = model.mean_force * model.sigma**2
    work = series_rate(state, after - state.time) * (after - before)
    hats = motion.hats_at(before, bits + 2 * int(work.ceil()))
    with working_bits(bits + 64 + 2 * int(work.ceil())):
        values = (hats["b"], hats["V"], hats["Z"] - hats["force"], hats["Z"])
    (cell,) = series_cells(state, after - before, 1, bits, (before - state.time, values))

    def value(place: fmpq, _: int) -> arb:
        with working_bits(bits + 64):
            hats = cell.at(arb((place - before) / cell.width))
            return mean + hats[3] - hats[2]

    return value


def _value(motion: ContactMotion, place: fmpq, bits: int) -> arb:
    """lambda at T, in the normal form, with an absolute accuracy near 2^-bits of the mean force."""
    model = motion.model
    slow, fast, _ = motion.hats(-place * model.scaled_epsilon, bits, ("force",))
    with working_bits(bits + 64 + 2 * int(model.scaled_epsilon.height_bits())):
        return slow["force"] + fast["force"] + model.mean_force * model.sigma**2


def _rational(value: arb, bits: int) -> fmpq:
    """A rational near the midpoint with few bits, so that later times stay short."""
    with working_bits(bits):
        mantissa, exponent = (+value).mid().man_exp()
    scale = fmpq(2) ** abs(int(exponent))
    return fmpq(mantissa) * (scale if exponent >= 0 else 1 / scale)
