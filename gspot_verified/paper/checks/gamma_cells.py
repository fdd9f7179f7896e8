"""The sign of Γ(-β) on (m, m + 1) for every integer m >= -1, by induction with the step checked for a symbol β.

Proof page: ``proofs/side_switching.md``.
"""

from __future__ import annotations

from gspot_verified.paper.checks.closed_forms import ClosedForm, power, rational
from gspot_verified.paper.checks.formulas import closed_form, put

ABOVE_0 = "u"
"""β > 0 in the step of the induction: u is positive."""


def induction(function: str) -> list[ClosedForm]:
    """Positive forms exactly when the function of β is positive on (-1, 0) and f(β)/f(β - 1) < 0 for every β > 0.

    For Γ(-β): Γ > 0 on (0, 1), and Γ(z) = Γ(z + 1)/z. Then the sign on (m, m + 1) is (-1)^(m + 1) by induction on m.

    >>> [form.sign() for form in induction("Gamma(-beta)")], [form.sign() for form in induction("Gamma(beta)")]
    ([1, 1], [-1, None])
    """
    step = closed_form(put(function, beta=ABOVE_0)) / closed_form(put(function, beta=f"{ABOVE_0}-1"))
    return [closed_form(put(function, beta="-v")), rational(-1) * step]


def sign_on_cell(lower: ClosedForm) -> ClosedForm:
    """(-1)^(m + 1) for m = ``lower``, a polynomial in integer symbols."""
    return power("-1", lower.factor.numerator + 1)


def is_cell(lower: ClosedForm, upper: ClosedForm) -> ClosedForm:
    """1 when the interval has the length 1; -1 when it is longer, so that a pole lies inside; 0 otherwise."""
    length = (upper + rational(-1) * lower).factor.constant()
    return rational(0 if length is None or length < 1 else 1 if length == 1 else -1)
