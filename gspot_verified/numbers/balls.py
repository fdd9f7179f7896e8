"""Precision scopes, exact inputs in, enclosures out, certain comparisons.

This module is the one owner of flint's global context. The rules it keeps:

- the working precision is set only by :class:`working_bits`, which restores it on every way out (Ctrl-C in the very
  moment of going in or out may leave another one, and keep other threads waiting);
- an input is an exact rational (``fmpq``) or a finite ball (``arb``); a float is refused;
- a comparison answers True or False only when it is certain, and ``None`` otherwise;
- every error bound enters a ball through :func:`add_remainder`, balls are joined by :func:`hull`.

flint's precision is one number for the whole process: work in parallel in processes. Threads wait for each other here.
"""

from __future__ import annotations

import decimal
import math
import operator
import re
import threading
from collections.abc import Iterable
from fractions import Fraction
from functools import reduce
from numbers import Integral
from typing import Annotated, Any, TypeVar

from flint import acb, arb, ctx, fmpq, fmpz

import gspot_verified.numbers.pickled  # noqa: F401 - what leaves a process can be pickled

ExactInput = int | Fraction | fmpq | fmpz | str | arb
"""What a user may pass for a real number."""

Exact = fmpq | arb
"""What :func:`exact` makes of it: a rational, or a finite ball."""

Ball = TypeVar("Ball", arb, acb)
"""Of real numbers; or of complex ones, a rectangle: a ball for the real part, and one for the imaginary part."""

MAX_DIGITS = 1_000_000  # a limit of input: ValueError beyond it
MAX_WORKING_BITS = 64_000_000  # nearly twenty times what a million digits take, against endless work
MAX_SERIES_LENGTH = 100_000  # a limit of input: ValueError beyond it
_MAX_DECIMAL_EXPONENT = 100_000  # of a text, whose power of 10 is made exactly; a limit of input: ValueError beyond it
_MAX_BINARY_EXPONENT = 40_000  # a limit of input: ValueError beyond it
_SMALLEST_SHOWN = 1e-300  # below it doubles are no longer exact enough for endpoints: the ball is shown as it is
_MAX_STRING = 2_000_000  # characters of a text; a limit of input: ValueError beyond it
_LOG2_10 = math.log2(10)  # bits of a decimal digit

_FRACTION = re.compile(r"([+-]?[0-9]+)(?:/([0-9]+))?")
_DECIMAL = re.compile(r"([+-]?)([0-9]*)\.?([0-9]*)(?:[eE]([+-]?[0-9]{1,9}))?")

_lock = threading.RLock()


class working_bits:
    """Context manager: flint works with ``bits`` bits inside; the same object can be entered again, and it nests.

    >>> with working_bits(200):
    ...     third = arb(fmpq(1, 3))
    >>> third.rel_accuracy_bits() >= 190
    True
    """

    __slots__ = ("_bits", "_saved")

    def __init__(self, bits: int) -> None:
        if type(bits) is not int:  # flint would cut a fraction off in silence
            raise TypeError(f"bits must be an int, got {type(bits).__name__}")
        if not 2 <= bits <= MAX_WORKING_BITS:
            raise ValueError(f"bits must lie in 2..{MAX_WORKING_BITS}, got {bits}")
        self._bits = bits
        self._saved: list[int] = []

    def __enter__(self) -> None:
        _lock.acquire()
        self._saved.append(ctx.prec)
        ctx.prec = self._bits

    def __exit__(self, kind: object, error: object, trace: object) -> None:
        ctx.prec = self._saved.pop()
        _lock.release()


class series_length:
    """Context manager: flint keeps ``length`` terms of every power series inside; it nests.

    >>> from flint import arb_series
    >>> with series_length(3):
    ...     arb_series([1, 1], 9) * arb_series([1, 1], 9)
    1.00000000000000 + 2.00000000000000*x + 1.00000000000000*x^2 + O(x^3)
    """

    __slots__ = ("_length", "_saved")

    def __init__(self, length: int) -> None:
        if type(length) is not int or not 0 <= length <= MAX_SERIES_LENGTH:
            raise ValueError(f"length must be an int in 0..{MAX_SERIES_LENGTH}, got {length!r}")
        self._length = length
        self._saved: list[int] = []

    def __enter__(self) -> None:
        _lock.acquire()
        self._saved.append(ctx.cap)
        ctx.cap = self._length

    def __exit__(self, kind: object, error: object, trace: object) -> None:
        ctx.cap = self._saved.pop()
        _lock.release()


def checked_bits(bits: int, least: int, most: int = MAX_WORKING_BITS, name: str = "bits") -> int:
    """The same number of bits that a user gave.

    :raises ValueError: no int, or not in least..most.

    >>> checked_bits(128, 2)
    128
    """
    if type(bits) is not int or not least <= bits <= most:
        raise ValueError(f"{name} must be an int in {least}..{most}, got {bits!r}")
    return bits


def current_bits() -> int:
    """The working precision in force, in bits."""
    return int(ctx.prec)


def bits_for_digits(digits: int) -> int:
    """Bits of relative accuracy that stand for ``digits`` decimal digits.

    :raises TypeError: ``digits`` is not an int.
    :raises ValueError: it is not in 1..10^6.

    >>> bits_for_digits(15)
    51
    """
    if type(digits) is not int and (not isinstance(digits, Integral) or isinstance(digits, bool)):
        raise TypeError(f"digits must be an int, got {type(digits).__name__}")
    if not 1 <= digits <= MAX_DIGITS:
        raise ValueError(f"digits must lie in 1..{MAX_DIGITS}, got {digits}")
    return math.ceil(int(digits) * _LOG2_10) + 1


def digits_for_bits(bits: int) -> int:
    """The least number of decimal digits with 10^-digits <= 2^-bits.

    >>> digits_for_bits(53)
    16
    """
    return math.ceil(bits / _LOG2_10)


def exact(value: ExactInput, name: str) -> Exact:
    """The exact value of an input: ``fmpq`` for a rational or an exact ball, the ball itself for another ``arb``.

    Accepted: int, Fraction, fmpq, fmpz, decimal or fraction strings (``"0.1"`` is 1/10, U+2212 a minus), a finite arb,
    and of mpmath an ``mpf`` (its exact binary value) and an ``iv.mpf`` (a ball around it).

    :raises TypeError: a float (or any other type); the message says how to pass it on purpose.
    :raises ValueError: a NaN or infinite ball, or a string that is not a number; it names the argument.

    >>> exact("0.1", "tau")
    1/10
    >>> exact(0.1, "tau")
    Traceback (most recent call last):
    ...
    TypeError: tau: a float is not taken as exact; write Fraction(0.1) for its binary value or "0.1" for the decimal
    """
    if isinstance(value, fmpq):
        return value if type(value) is fmpq else fmpq(value)  # a subclass may compare in its own way
    if isinstance(value, arb):
        value = value if type(value) is arb else arb(value)
        if not value.is_finite():
            raise ValueError(f"{name}: the ball must be finite, got {value}")
        return _point(value) if value.is_exact() else value
    if isinstance(value, str):
        return _parse(value, name)
    if isinstance(value, float):
        raise TypeError(
            f"{name}: a float is not taken as exact; write Fraction({float(value)!r}) for its binary value "
            f'or "{float(value)!r}" for the decimal'
        )
    if isinstance(value, Integral | fmpz) and not isinstance(value, bool):
        return fmpq(operator.index(value))
    if isinstance(value, Fraction):
        return fmpq(value.numerator, value.denominator)
    if type(value).__module__.startswith("mpmath."):
        return _of_mpmath(value, name)
    raise TypeError(f"{name}: expected int, Fraction, fmpq, str or arb, got {type(value).__name__}")


def _of_mpmath(value: Any, name: str) -> Exact:
    """An ``mpf`` is one number, an ``iv.mpf`` a ball; ``mpmath.pi`` is neither: its digits depend on a precision."""
    if hasattr(value, "_mpi_"):
        return hull([arb(_of_mantissa(end, name)) for end in value._mpi_])
    if type(value).__name__ != "mpf":
        raise TypeError(f"{name}: of mpmath an mpf or an iv.mpf is taken, got {type(value).__name__}")
    return _of_mantissa(value._mpf_, name)


def _of_mantissa(parts: tuple[int, int, int, int], name: str) -> fmpq:
    """(-1)^sign mantissa 2^exponent. Infinities and NaN are the triples with mantissa 0 and another exponent."""
    sign, mantissa, exponent, _ = parts
    if exponent and not mantissa:
        raise ValueError(f"{name}: the number must be finite")
    if abs(exponent) > _MAX_BINARY_EXPONENT:
        raise ValueError(f"{name}: the binary exponent must lie within +-{_MAX_BINARY_EXPONENT}, got {exponent}")
    whole = fmpz(-mantissa if sign else mantissa)
    return fmpq(whole << exponent) if exponent >= 0 else fmpq(whole, fmpz(1) << -exponent)


def to_mpmath(value: arb) -> Any:
    """The ``iv.mpf`` with the ends of the ball, rounded outward to the working precision: it contains the ball.

    mpmath is imported here and nowhere else.

    :raises ValueError: the ball is not finite.

    >>> to_mpmath(arb(fmpq(3, 8)))
    mpi('0.375', '0.375')
    """
    from mpmath import iv  # type: ignore[import-untyped]
    from mpmath.libmp import from_man_exp  # type: ignore[import-untyped]

    if not value.is_finite():
        raise ValueError(f"the ball must be finite, got {value}")
    ends = [end.man_exp() for end in (value.lower(), value.upper())]
    return iv.make_mpf(tuple(from_man_exp(int(mantissa), int(exponent)) for mantissa, exponent in ends))


def _point(value: arb) -> Exact:
    """The rational that an exact ball is, unless its exponent is so large that the rational would fill the memory."""
    mantissa, exponent = value.man_exp()
    if abs(exponent) > _MAX_BINARY_EXPONENT:
        return value
    return fmpq(mantissa << int(exponent)) if exponent >= 0 else fmpq(mantissa, fmpz(1) << -int(exponent))


def _parse(text: str, name: str) -> fmpq:
    word = text.strip().replace("\N{MINUS SIGN}", "-")
    shown = word if len(word) <= 40 else word[:37] + "..."
    if len(word) > _MAX_STRING:
        raise ValueError(f"{name}: a number may have at most {_MAX_STRING} characters")
    if match := _FRACTION.fullmatch(word):
        denominator = fmpz(match[2]) if match[2] else fmpz(1)
        if denominator == 0:
            raise ValueError(f"{name}: the denominator of {shown!r} is zero")
        return fmpq(fmpz(match[1].lstrip("+")), denominator)
    match = _DECIMAL.fullmatch(word)
    if match is None or not (match[2] or match[3]):
        raise ValueError(f'{name}: expected a number such as "-50", "7/3" or "0.1", got {shown!r}')
    exponent = int(match[4] or 0)
    if abs(exponent) > _MAX_DECIMAL_EXPONENT:
        raise ValueError(f"{name}: the exponent of {shown!r} must lie within +-{_MAX_DECIMAL_EXPONENT}")
    number = fmpq(fmpz(match[2] + match[3])) * fmpq(10) ** (exponent - len(match[3]))
    return -number if match[1] == "-" else number


def ball(value: Exact) -> arb:
    """A ball that contains ``value``, rounded to the current precision."""
    return arb(value) if isinstance(value, fmpq) else +value


def is_exact(value: Exact) -> bool:
    """True when the input is one number and not a ball of them."""
    return isinstance(value, fmpq) or value.is_exact()


def add_remainder(value: Ball, bound: arb | acb) -> Ball:
    """``value`` widened by ``|bound|``: contains v + r for every v in ``value`` and |r| <= |bound|.

    r is complex where ``value`` is. Every truncation error of the library enters a ball here. A bound that is not
    finite gives such a ball.
    """
    reach = arb(0, bound.abs_upper())
    return value + (reach if isinstance(value, arb) else acb(reach, reach))


def sign_of(value: arb) -> int | None:
    """1, -1, or 0 when the sign of *every* number in the ball is that; ``None`` when it is not certain.

    A NaN ball has no certain sign.

    >>> sign_of(arb(3)), sign_of(arb(0)), sign_of(arb(0, 1))
    (1, 0, None)
    """
    if value > 0:
        return 1
    if value < 0:
        return -1
    return 0 if value.is_zero() else None


def certainly_less(left: arb, right: arb) -> bool | None:
    """Whether left < right: True or False when that is so for every pair of numbers in the balls, else ``None``."""
    return True if left < right else False if left >= right else None


def certainly_at_most(left: arb, right: arb) -> bool | None:
    """Whether left <= right: True or False when that is so for every pair of numbers in the balls, else ``None``."""
    return True if left <= right else False if left > right else None


def hull(parts: Iterable[arb]) -> arb:
    """A ball that contains all parts and what lies between them: the one way to join balls, so that none is left out.

    >>> hull(arb(n) for n in (1, 5, 2)).contains(5)
    True
    """
    return reduce(arb.union, parts)


def relative_bits(value: arb | acb) -> int:
    """How many bits of ``value`` are certain; 0 or less when the ball contains zero or is not finite, else n when the
    radius is at most 2^-n of the largest number in the ball: very large for an exact one. Of a complex ball: the larger
    one of its two radii, and the larger one of its two parts.
    """
    if not value.is_finite():
        return -MAX_WORKING_BITS
    if value.is_exact():
        return MAX_WORKING_BITS
    return int(value.rel_accuracy_bits())


def shrink_to_bits(value: Ball, bits: int) -> Ball:
    """The same enclosure, rounded outward to a midpoint of ``bits`` bits."""
    with working_bits(max(bits, 30)):
        return +value


def nonfinite() -> arb:
    """The ball of no information, which routes return when a hypothesis of their bound is not met."""
    return arb.nan()


def float_bounds(value: arb) -> tuple[float, float]:
    """Two floats (lower, upper) that enclose the ball, rounded outward; infinite where floats overflow."""
    if not value.is_finite():
        return -math.inf, math.inf
    with working_bits(53):
        lower, upper = float(value.lower()), float(value.upper())
    return math.nextafter(lower, -math.inf), math.nextafter(upper, math.inf)


def approximate(value: Exact) -> float:
    """A float near the (midpoint of the) value. For heuristics only: it carries no bound.

    >>> approximate(fmpq(1, 3)), approximate(arb(2, "0.1"))
    (0.3333333333333333, 2.0)
    """
    if isinstance(value, arb):
        return float(value.mid())
    try:
        return int(value.p) / int(value.q)
    except OverflowError:
        return math.inf if value > 0 else -math.inf


def ball_text(value: arb | acb, digits: int = 15) -> str:
    """The ball as text: ``[midpoint +/- radius]`` when it is narrow, ``[lower, upper]`` when it is wide.

    Of a complex ball each part so, the imaginary one with an i.

    >>> with working_bits(60):
    ...     ball_text(arb(1) / 3, 5), ball_text(arb(0, "0.3"), 3), ball_text(acb(2, arb(-1) / 3), 5)
    ('[0.33333 +/- 3.34e-6]', '[-0.301, 0.301]', '2.0000 + [-0.33333 +/- 3.34e-6]i')
    """
    if isinstance(value, acb):
        return f"{ball_text(value.real, digits)} + {ball_text(value.imag, digits)}i"
    if not value.is_finite():
        return "[no information]"
    lower, upper = float_bounds(value)
    if relative_bits(value) >= 5 or math.isinf(lower) or math.isinf(upper) or max(-lower, upper) < _SMALLEST_SHOWN:
        return value.str(digits)
    return f"[{rounded_text(lower, -1)}, {rounded_text(upper, 1)}]"


ShownBall = Annotated[arb, ball_text]
"""A ball that is written for people."""


def rounded_text(value: float, direction: int, digits: int = 3) -> str:
    """So many significant digits, rounded down (direction -1) or up (1).

    >>> rounded_text(12.36, -1), rounded_text(12.36, 1), rounded_text(40.0, -1), rounded_text(12345.0, 1)
    ('12.3', '12.4', '40', '1.24e+4')
    """
    context = decimal.Context(prec=digits, rounding=decimal.ROUND_FLOOR if direction < 0 else decimal.ROUND_CEILING)
    rounded = context.normalize(context.create_decimal_from_float(value))
    plain = rounded.is_finite() and 0 <= rounded.adjusted() < digits  # normalized, 40 would be 4e+1
    return f"{rounded:f}" if plain else f"{rounded:g}"
