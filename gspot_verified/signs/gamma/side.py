"""The sign of Gamma(-beta) over a range of beta, and which side of the canard lifts off.

Paper, Sec. 4.5. β > 1 (Case III): lift-off where C_1/Γ(-β) < 0, an impact without collision (IWC) where it is
positive. 0 < β < 1 (Cases I and II): as ε → 0 every trajectory that reaches the G-spot in contact has C_1 < 0 and takes
an IWC (or C_1 = 0, the trivial solution, in Case II); at a given ε starts next to that one pass and lift off.
β < 0 is in no Case: no side.
Proof page: ``proofs/side_switching.md``.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import ClassVar

from flint import arb, fmpq

from gspot_verified.numbers.balls import Exact, ExactInput, exact, sign_of, working_bits
from gspot_verified.numbers.verdict import NoTruthValue
from gspot_verified.numbers.written import Written
from gspot_verified.theta_function.gamma.reciprocal_gamma import reciprocal_gamma

MAX_BETA = 10**6  # a limit of input: ValueError beyond it
_MAX_INTERVALS = 100_000  # a limit of input: ValueError beyond it


@dataclass(frozen=True, slots=True)
class SignInterval(NoTruthValue, Written):
    """A maximal interval of constant sign of Gamma(-beta) inside the range.

    ``lower`` and ``upper`` are its ends; ``lower_closed`` and ``upper_closed`` say whether an end belongs to it.
    An end is closed only where it is an end of the range that is not a pole.
    """

    ask: ClassVar[str] = ".sign is 1 or -1"
    written: ClassVar[str] = (
        "lower upper lower_closed upper_closed sign lift_off_sign_of_C1=lift_off_sign impact_sign_of_C1=impact_sign"
    )

    lower: Fraction
    upper: Fraction
    lower_closed: bool
    upper_closed: bool
    sign: int

    @property
    def lift_off_sign(self) -> int | None:
        """The sign of C_1 that lifts off in Case III; None unless beta > 1 on the interval."""
        return -self.sign if self.lower >= 1 else None

    @property
    def impact_sign(self) -> int | None:
        """The sign of C_1 that takes an IWC; None for beta < 0. For 0 < beta < 1 it is -1, the only one as ε → 0."""
        return self.sign if self.lower >= 0 else None

    def _ends(self) -> tuple[str, str]:
        """Both ends as text; by FLINT, because CPython refuses to print integers of more than 4,300 digits."""
        first, last = (str(fmpq(end.numerator, end.denominator)) for end in (self.lower, self.upper))
        return first, last

    def __str__(self) -> str:
        left, right = "[" if self.lower_closed else "(", "]" if self.upper_closed else ")"
        sign = "> 0" if self.sign > 0 else "< 0"
        return (
            f"{left}{', '.join(self._ends())}{right}: Γ(-β) {sign}; {side_text(self.lift_off_sign, self.impact_sign)}"
        )


@dataclass(frozen=True, slots=True)
class SideSwitching(NoTruthValue, Written):
    """The answer of :func:`side`: intervals and integers together cover the range.

    ``integers`` are the poles of Gamma(-beta) in the range (1/Gamma(-beta) = 0 there).
    ``undecided`` holds the poles that lie in the range for some choice of ball endpoints and outside for others.
    """

    ask: ClassVar[str] = ".undecided holds the poles that the balls leave open"
    written: ClassVar[str] = "intervals integers side_switches_at=switches undecided"

    intervals: tuple[SignInterval, ...]
    integers: tuple[int, ...]
    undecided: tuple[int, ...] = ()

    @property
    def switches(self) -> tuple[int, ...]:
        """The integers where the side switches: 2, 3, ... Below 1 C_1 < 0 takes an IWC, below 0 nothing is said."""
        return tuple(n for n in self.integers if n >= 2)

    def __str__(self) -> str:
        lines = [str(interval) for interval in self.intervals]
        for text, integers in (
            ("Γ(-β) has a pole at β = ", self.integers),
            ("in Case III the side switches at β = ", self.switches),
        ):
            if integers:
                lines.append(text + ", ".join(map(str, integers)))
        if self.undecided:
            lines.append("undecided (an endpoint's ball holds it): β = " + ", ".join(map(str, self.undecided)))
        return "\n".join(lines)


def side_text(lift_off_sign: int | None, impact_sign: int | None) -> str:
    """What the paper says of the sides as ε → 0, in words; the two signs as in :class:`SignInterval`."""
    if impact_sign is None:
        return "no side: the Cases I, II and III have β > 0"
    if lift_off_sign is None:
        return "Cases I and II, by the paper's rule as ε → 0: C1 < 0 takes an IWC, no other sign occurs"
    lift_off, impact = (f"C1 {'>' if sign > 0 else '<'} 0" for sign in (lift_off_sign, impact_sign))
    return f"Case III, by the paper's rule as ε → 0: {lift_off} lifts off, {impact} takes an IWC"


def follows_text(lift_off_sign: int | None, impact_sign: int) -> str:
    """The same in one short phrase; in Cases I and II nothing but an impact occurs as ε → 0 (paper, Sec. 1.4).

    >>> follows_text(None, -1), follows_text(1, -1)
    ('impact without collision', 'lift-off if C1 > 0, impact without collision if C1 < 0')
    """
    if lift_off_sign is None:
        return "impact without collision"
    lift_off, impact = (f"C1 {'>' if sign > 0 else '<'} 0" for sign in (lift_off_sign, impact_sign))
    return f"lift-off if {lift_off}, impact without collision if {impact}"


def gamma_sign(beta: ExactInput) -> int | None:
    """The sign of Gamma(-beta): 1 or -1 when certain for the whole input, 0 at a pole (beta = 0, 1, 2, ...), else None.

    Exact for a rational: (-1)^(floor(beta) + 1) for a non-integer beta > 0, and 1 for beta < 0.

    >>> gamma_sign("1/2"), gamma_sign("3/2"), gamma_sign(-3), gamma_sign(4)
    (-1, 1, 1, 0)
    """
    value = _checked(beta, "beta")
    lower, upper = _ends(value)
    if lower == upper:
        return _sign_at(lower)
    if _first_pole(lower) <= upper:  # the ball holds a pole, and more than it
        return None
    return _sign_at(lower)


def gamma_sign_by_ball(beta: ExactInput, bits: int = 64) -> int | None:
    """The same sign by a second route: an enclosure of 1/Gamma(-beta). ``None`` when the ball holds zero and more."""
    value = _checked(beta, "beta")
    with working_bits(bits):
        return sign_of(reciprocal_gamma(-value, bits))


def side(lower: ExactInput, upper: ExactInput | None = None) -> SideSwitching:
    """The sign of Gamma(-beta) for every beta in [lower, upper]: maximal intervals and the integers between them.

    ``upper`` left out: at one beta.

    For ball endpoints the intervals cover the largest range that the balls allow; a pole that only some of the
    allowed ranges hold is listed as undecided.

    :raises TypeError: a float.
    :raises ValueError: not a number, a reversed range, |beta| > 10^6, or more than 10^5 intervals.

    >>> print(side("1/2", 2))
    [1/2, 1): Γ(-β) < 0; Cases I and II, by the paper's rule as ε → 0: C1 < 0 takes an IWC, no other sign occurs
    (1, 2): Γ(-β) > 0; Case III, by the paper's rule as ε → 0: C1 < 0 lifts off, C1 > 0 takes an IWC
    Γ(-β) has a pole at β = 1, 2
    in Case III the side switches at β = 2
    """
    first, first_inner = _ends(_checked(lower, "lower"))
    last_inner, last = _ends(_checked(lower if upper is None else upper, "upper"))
    if first > last:
        raise ValueError("the range is reversed: lower > upper")
    start = _first_pole(first)
    stop = last.numerator // last.denominator
    if stop - start > _MAX_INTERVALS:
        raise ValueError(f"the range holds more than {_MAX_INTERVALS} integers: split it")
    poles = list(range(start, stop + 1))
    intervals = []
    left, left_closed = first, True
    for pole in poles:
        if left < pole:
            intervals.append(SignInterval(left, Fraction(pole), left_closed, False, _sign_at((left + pole) / 2)))
        left, left_closed = Fraction(pole), False
    if left < last or (left == last and left_closed):
        intervals.append(SignInterval(left, last, left_closed, True, _sign_at((left + last) / 2)))
    certain = tuple(pole for pole in poles if first_inner <= pole <= last_inner)
    undecided = tuple(pole for pole in poles if not first_inner <= pole <= last_inner)
    return SideSwitching(tuple(intervals), certain, undecided)


def _checked(value: ExactInput, name: str) -> Exact:
    number = exact(value, name)
    if not -MAX_BETA <= number <= MAX_BETA:
        raise ValueError(f"{name}: |beta| must be at most {MAX_BETA}")
    return number


def _ends(value: Exact) -> tuple[Fraction, Fraction]:
    """Both ends of the input as exact fractions; the ends of a ball are rounded outward to 256 bits."""
    if isinstance(value, fmpq):
        number = Fraction(int(value.p), int(value.q))
        return number, number
    with working_bits(256):
        return _fraction(value.lower()), _fraction(value.upper())


def _fraction(point: arb) -> Fraction:
    mantissa, exponent = point.man_exp()
    if exponent < -100_000:
        raise ValueError("beta: a ball endpoint has an exponent below -100000; give a rational")
    return Fraction(int(mantissa)) * Fraction(2) ** int(exponent)


def _first_pole(lower: Fraction) -> int:
    """The least integer n >= 0 with n >= lower."""
    return max(0, -(-lower.numerator // lower.denominator))


def _sign_at(beta: Fraction) -> int:
    if beta < 0:
        return 1
    if beta.denominator == 1:
        return 0
    return -1 if (beta.numerator // beta.denominator) % 2 == 0 else 1
