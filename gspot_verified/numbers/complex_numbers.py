"""Complex numbers as they are passed: which inputs are complex, exact in, rectangles of balls out."""

from __future__ import annotations

import re
from typing import Any, NamedTuple

from flint import acb, arb, fmpq

from gspot_verified.numbers.balls import Exact, approximate, ball, exact, is_exact

_UNSIGNED = r"[0-9.]+(?:[eE][+-]?[0-9]+)?(?:/[0-9]+)?"
_COMPLEX = re.compile(
    rf"(?:(?P<real>[+-]?{_UNSIGNED})\s*(?=[+-]))?(?P<sign>\+\s*-|[+-])?\s*(?P<imaginary>{_UNSIGNED})?\s*[ij]"
)
_OF_MPMATH = ("mpc", "ivmpc")  # names, so that mpmath is not imported before someone uses it


class ExactComplex(NamedTuple):
    """A complex number, or a rectangle of them: each part is a rational or a finite ball."""

    real: Exact
    imaginary: Exact


ComplexInput = acb | ExactComplex
"""What a user may pass for a complex number, beside an ``mpc`` of mpmath and a text with i or j."""


def is_complex(value: object) -> bool:
    """Whether an input is of a complex type, or a text that ends in i or j; whether it is valid is not asked.

    >>> is_complex("1+2i"), is_complex(acb(1, 2)), is_complex("1/2")
    (True, True, False)
    """
    if isinstance(value, str):
        return value.rstrip()[-1:] in ("i", "j")
    return isinstance(value, acb | ExactComplex | complex) or type(value).__name__ in _OF_MPMATH


def exact_complex(value: Any, name: str) -> ExactComplex:
    """The exact value of a complex input.

    Accepted: a text such as ``"1+2i"`` or ``"3/2-5/7j"``, whose parts are read as real texts are (``5/7j`` is 5/7 times
    j, and ``+-`` is a minus, so that ``f"{a}+{b}i"`` is right for every sign); a finite ``acb``; an ``mpc`` or an
    ``iv.mpc`` of mpmath.

    :raises TypeError: a Python complex; the message says how to pass it on purpose.
    :raises ValueError: a part is not finite, or a text is not a complex number; it names the argument.

    >>> exact_complex("3/2 - 0.1i", "tau")
    ExactComplex(real=3/2, imaginary=-1/10)
    >>> exact_complex("1+2k", "tau")
    Traceback (most recent call last):
    ...
    ValueError: tau: expected a complex number such as "1+2i", "3/2-5/7i" or "-0.1i", got '1+2k'
    """
    if isinstance(value, ExactComplex):
        return value
    if isinstance(value, str):
        return _of_text(value, name)
    if isinstance(value, complex):
        real, imaginary = value.real, value.imag
        raise TypeError(
            f"{name}: a complex is not taken as exact; write acb({real}, {imaginary}) for its binary value or "
            f'"{real}{imaginary:+}i" for the decimal'
        )
    return ExactComplex(exact(value.real, name), exact(value.imag, name))


def _of_text(text: str, name: str) -> ExactComplex:
    word = text.strip().replace("\N{MINUS SIGN}", "-")
    match = _COMPLEX.fullmatch(word)
    if match is None:
        shown = word if len(word) <= 40 else word[:37] + "..."
        raise ValueError(f'{name}: expected a complex number such as "1+2i", "3/2-5/7i" or "-0.1i", got {shown!r}')
    real, imaginary = (exact(part, name) for part in (match["real"] or "0", match["imaginary"] or "1"))
    return ExactComplex(real, -imaginary if "-" in (match["sign"] or "") else imaginary)


def complex_ball(value: ExactComplex) -> acb:
    """A rectangle that contains ``value``, rounded to the current precision."""
    return acb(ball(value.real), ball(value.imaginary))


def middle(value: ExactComplex) -> tuple[ExactComplex, arb]:
    """The midpoint of the rectangle, exactly, and an upper bound on the distances from it."""
    point = ExactComplex(*(part if isinstance(part, fmpq) else part.mid() for part in value))
    return point, acb(*(arb(0) if isinstance(part, fmpq) else part.rad() for part in value)).abs_upper()


def approximate_complex(value: ExactComplex) -> complex:
    """A complex float near the (midpoint of the) value. For heuristics only: it carries no bound."""
    return complex(approximate(value.real), approximate(value.imaginary))


def is_point(value: ExactComplex) -> bool:
    """True when the input is one number and not a rectangle of them."""
    return is_exact(value.real) and is_exact(value.imaginary)


def is_real(value: ExactComplex) -> bool:
    """True when the imaginary part is exactly 0."""
    return bool(value.imaginary == 0)
