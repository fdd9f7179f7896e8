"""How flint's numbers and polynomials are pickled and copied: exactly, at any precision in force.

python-flint gives them no way of their own. Importing this module gives them one in the whole process.
"""

from __future__ import annotations

import copyreg
from typing import Any

from flint import acb, arb, arb_poly, fmpq_mpoly, fmpq_mpoly_ctx, fmpq_poly, fmpz_poly

_RADIUS_BITS = 30  # of the mantissa of a radius

_Part = tuple[int, int] | str
"""Mantissa and exponent of a midpoint or a radius; one that is not finite by its name."""


def _part(value: arb) -> _Part:
    if value.is_finite():
        mantissa, exponent = value.man_exp()
        return int(mantissa), int(exponent)
    return "nan" if value.is_nan() else "inf" if value > 0 else "-inf"


def _parts_of_ball(value: arb) -> tuple[Any, tuple[_Part, _Part]]:
    return ball_of_parts, (_part(value.mid()), _part(value.rad()))


def ball_of_parts(middle: _Part, radius: _Part) -> arb:
    """The ball with this midpoint and this radius: exactly where the mantissas are odd or 0, as flint has them.

    >>> ball_of_parts((3, -1), (2**30 - 1, -40)).rad().man_exp() == (2**30 - 1, -40)
    True
    """
    if not isinstance(radius, str) and (lowered := _lowered(*radius)) is not None:
        made = arb(middle, lowered)
        if _part(made.rad()) == radius:
            return made
    return arb(middle, arb(radius) if isinstance(radius, str) else radius)


def _lowered(mantissa: int, exponent: int) -> arb | None:
    """What flint makes that radius of: of a number it takes 30 places and adds one in the last, against rounding.

    None for what it takes exactly, zero and the powers of 2.
    """
    if mantissa & (mantissa - 1) == 0:
        return None
    shift = _RADIUS_BITS - mantissa.bit_length()
    return arb(((mantissa << shift) - 1, exponent - shift))


def _symbols(context: fmpq_mpoly_ctx) -> tuple[Any, tuple[Any, ...]]:
    return fmpq_mpoly_ctx.get, (context.names(), context.ordering())


def _polynomial(value: fmpq_mpoly) -> tuple[Any, tuple[Any, ...]]:
    return _polynomial_of_terms, (value.context(), value.to_dict())


def _polynomial_of_terms(context: fmpq_mpoly_ctx, terms: dict[Any, Any]) -> fmpq_mpoly:
    return context.from_dict(terms)


def _complex_ball(value: acb) -> tuple[Any, tuple[arb, arb]]:
    return acb, (value.real, value.imag)


def _coefficients(value: Any) -> tuple[Any, tuple[list[Any]]]:
    return type(value), (value.coeffs(),)


copyreg.pickle(arb, _parts_of_ball)
copyreg.pickle(acb, _complex_ball)
copyreg.pickle(arb_poly, _coefficients)
copyreg.pickle(fmpq_poly, _coefficients)
copyreg.pickle(fmpz_poly, _coefficients)
copyreg.pickle(fmpq_mpoly_ctx, _symbols)
copyreg.pickle(fmpq_mpoly, _polynomial)
