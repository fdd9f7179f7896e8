"""A ball as text that holds fewer numbers, never more: for sets of which something is said of every element.

What :func:`ball_text` writes holds the ball and more, up to several times as much.
"""

from __future__ import annotations

from decimal import Decimal

from flint import arb, fmpq

from gspot_verified.numbers.balls import Exact
from gspot_verified.numbers.evidence import every, less
from gspot_verified.numbers.verdict import Evidence

_FINER = 1000  # steps of the decimals in the ball: any number is right


def inner_ends(value: arb) -> tuple[fmpq, fmpq]:
    """Two decimal numbers in the ball near its ends; of an exact ball its number, twice.

    :raises ValueError: the ball is not finite.
    """
    lower, upper = _ends(value)
    if lower == upper:
        return lower, upper
    step = _step(lower, upper)
    return (lower / step).ceil() * step, (upper / step).floor() * step


def inner_text(value: arb) -> str:
    """The interval between them, exactly.

    :raises ValueError: the ball is not finite.

    >>> inner_text(arb("0.5", "0.00012305")), inner_text(arb("0.25"))
    ('[0.4998770, 0.5001230]', '[1/4, 1/4]')
    """
    ends = inner_ends(value)
    lower, upper = _ends(value)
    if lower == upper:
        return f"[{lower}, {upper}]"
    step = _step(lower, upper)
    exponent = len(str(step.p)) - len(str(step.q))
    return "[" + ", ".join(_decimal(int((end / step).p), exponent) for end in ends) + "]"


def text_of_each(value: Exact) -> str:
    """A number; of a ball, of each number of which something is said, the interval, or its one number.

    >>> text_of_each(fmpq(1, 3)), text_of_each(arb("0.25")), text_of_each(arb("0.5", "0.00012305"))
    ('1/3', '1/4', '[0.4998770, 0.5001230]')
    """
    if isinstance(value, fmpq):
        return str(value)
    lower, upper = inner_ends(value)
    return str(lower) if lower == upper else inner_text(value)


def in_inner_interval(part: arb, whole: arb) -> Evidence | None:
    """Every number of the one ball lies in the interval that is written of the other."""
    if not whole.is_finite():
        return None
    lower, upper = inner_ends(whole)
    return every([less(lower, part), less(part, upper)])


def _ends(value: arb) -> tuple[fmpq, fmpq]:
    if not value.is_finite():
        raise ValueError("the ball must be finite")
    middle, radius = (fmpq(mantissa) * fmpq(2) ** int(exponent) for mantissa, exponent in
                      (value.mid().man_exp(), value.rad().man_exp()))  # fmt: skip
    return middle - radius, middle + radius


def _step(lower: fmpq, upper: fmpq) -> fmpq:
    """A power of 10, at most the width over ``_FINER``."""
    width = (upper - lower) / _FINER
    step = fmpq(10) ** (len(str(width.p)) - len(str(width.q)) + 1)
    while step > width:
        step /= 10
    return step


def _decimal(count: int, exponent: int) -> str:
    return str(Decimal((int(count < 0), tuple(map(int, str(abs(count)))), exponent)))
