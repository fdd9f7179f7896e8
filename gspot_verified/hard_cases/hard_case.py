"""One question at one hardness, and what it costs; beside it what the usual formulas give in double precision."""

from __future__ import annotations

import math
import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, ClassVar, TypeVar

import numpy as np
from flint import arb, fmpq

from gspot_verified.cost.times.measure import clear_caches
from gspot_verified.numbers.balls import relative_bits, working_bits
from gspot_verified.numbers.verdict import NoTruthValue
from gspot_verified.numbers.written import Written

RIGHT_DIGITS = 8
"""A value in double precision counts as right when so many digits of it are."""

Found = arb | fmpq | int | None
"""A value (a ball, or exact), a sign or a number of things (int), or None where it stayed undecided."""


@dataclass(frozen=True, slots=True)
class HardCase(NoTruthValue, Written):
    """What the library and double precision say to one question.

    ``condition``: the decimal logarithm of the condition number; for questions with finitely many answers, of the
    reciprocal of the relative distance to the nearest data with another answer; None where there is no such datum.
    ``lost``: bits that the usual formula loses in balls: the least working precision at which it answers, less the bits
    delivered (53 of a value, 1 of a sign or a number); None where that was not sought, or up to 32,768 bits do not
    suffice. ``double`` is the answer of the usual formula in double precision (None: it gave none), ``certified`` the
    library's; ``work`` counts what it did and ``seconds`` is what it took. ``double_said`` is what the usual formula
    says where that is more than the number.
    """

    ask: ClassVar[str] = ".certified is None where the question stayed undecided, .double_right is True or False"
    written: ClassVar[str] = (
        "level asked condition bits_lost=lost double=double_text double_right certified=text decided work seconds"
    )

    level: int
    asked: str
    certified: Found
    text: str
    work: int
    seconds: float
    condition: float | None = None
    lost: int | None = None
    double: float | None = None
    double_said: str | None = None

    @property
    def double_text(self) -> str:
        """What doubles say, for a table; empty where they are not asked."""
        if self.double_said is not None:
            return self.double_said
        return "" if self.double is None else double_text(self.double)

    @property
    def decided(self) -> bool:
        """Whether the library answers."""
        return self.certified is not None

    @property
    def double_right(self) -> bool | None:
        """Whether double precision gives the certified answer: a value to 8 digits; None where one of the two is not
        there to compare."""
        if self.certified is None or not self.double_text:
            return None
        return agrees(self.double, self.certified)


Case = Callable[[int], HardCase]
"""A family's question at a level."""


def agrees(double: float | None, certified: arb | fmpq | int) -> bool:
    """Whether a double is the certified answer: the same sign or number; of a value, to ``RIGHT_DIGITS`` digits.

    >>> agrees(1.0, 1), agrees(None, 1), agrees(0.333333333, arb("1/3")), agrees(float("nan"), arb(1))
    (True, False, True, False)
    """
    if double is None or not math.isfinite(double):
        return False
    exact = fmpq(*double.as_integer_ratio())
    if isinstance(certified, int):
        return bool(exact == certified)
    with working_bits(128):
        distance = abs(arb(exact) - certified)
        return bool(distance <= abs(arb(certified)) * arb(10) ** -RIGHT_DIGITS)


def near(integer: int, k: int, side: int = 1) -> fmpq:
    """integer + side 10^-k."""
    return fmpq(integer) + side * fmpq(1, 10**k)


def nearest_double(value: fmpq) -> float:
    """The double next to an exact number; infinite beyond the range."""
    try:
        return int(value.p) / int(value.q)
    except OverflowError:
        return math.inf if value > 0 else -math.inf


def log10(value: arb | fmpq | int) -> float:
    """The decimal logarithm of a size, to about two decimals: for a table."""
    with working_bits(64):
        return round(float((abs(arb(value)).log() / arb(10).log()).mid()), 2)


def bits_lost(formula: Callable[[int], arb], delivered: int = 53, most: int = 1 << 15) -> int | None:
    """The least working precision, to about a sixteenth, at which the formula has ``delivered`` bits, less these.

    None where up to ``most`` bits do not suffice. A sign or a number is ``delivered`` = 1.

    >>> def cancelling(bits):
    ...     with working_bits(bits):
    ...         return (arb(50).exp() + 1) - arb(50).exp()
    >>> 65 < bits_lost(cancelling) < 85, bits_lost(cancelling, most=100) is None
    (True, True)
    """

    def enough(bits: int) -> bool:
        value = formula(bits)
        return value.is_finite() and relative_bits(value) >= delivered

    low, high = delivered, delivered + 8
    while not enough(high):
        low, high = high, 2 * high
        if high > most:
            return None
    while high - low > max(2, high // 16):
        middle = (low + high) // 2
        low, high = (low, middle) if enough(middle) else (middle, high)
    return high - delivered


_REPEATS = 5  # of a short call
_LONG = 0.02  # seconds: then no further repeat

T = TypeVar("T")


def timed(call: Callable[[], T]) -> tuple[T, float]:
    """The answer and the best of five times; a long call is made once.

    >>> timed(lambda: 2)[0]
    2
    """
    seconds: list[float] = []
    while len(seconds) < _REPEATS and sum(seconds) < _LONG:
        clear_caches()
        start = time.process_time()
        answer = call()
        seconds.append(time.process_time() - start)
    return answer, min(seconds)


_MOST_TERMS = 4_000  # a limit, as a user would set one
_GRID = 4_001  # points at which signs are compared


def theta_series(beta: float) -> list[float]:
    """Theta(0), Theta'(0), Theta''(0)/2 as printed (eqs. t01 to t03), by scipy's Gamma; NaN at its poles."""
    from scipy.special import gamma

    with np.errstate(all="ignore"):
        outer = gamma(-beta)
        values = [float(gamma((j - beta) / 3) / (outer * 3.0 ** ((3 - j + beta) / 3))) for j in range(3)]
    return [values[0], values[1], values[2] / 2]


def theta_double(tau: float, beta: float) -> float:
    """Theta by its power series at 0 in double precision, until the terms no longer count."""
    terms = [value * tau**j for j, value in enumerate(theta_series(beta))]
    total, cube = math.fsum(terms), tau * tau * tau
    for k in range(_MOST_TERMS):
        terms.append(terms[k] * (k - beta) * cube / ((k + 1.0) * (k + 2) * (k + 3)))
        total += terms[-1]
        if not math.isfinite(total) or (k > 3 and max(map(abs, terms[-3:])) <= abs(total) * 1e-18):
            break
    return total


def sign_changes(function: Callable[[float], float], first: float, last: float, points: int = _GRID) -> int:
    """How often the values on a uniform grid change their sign; zeros and NaN are passed over."""
    values = np.array([function(point) for point in np.linspace(first, last, points)])
    with np.errstate(invalid="ignore"):
        signs = np.sign(values)
    signs = signs[(signs == 1) | (signs == -1)]
    return int(np.count_nonzero(signs[1:] != signs[:-1]))


def double_text(value: float | None) -> str:
    """A double for a table.

    >>> double_text(0.1), double_text(float("nan")), double_text(None), double_text(3.0)
    ('0.1', 'nan', 'no answer', '3')
    """
    if value is None:
        return "no answer"
    return f"{value:.10g}"


def real_roots(coefficients: Any) -> int:
    """How many of numpy's roots of a polynomial have no imaginary part."""
    return int(np.count_nonzero(np.roots(coefficients).imag == 0))
