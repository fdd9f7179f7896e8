"""Ledger of Section 2: for χ not 0 the extended example has no trivial solution.

On a trivial solution v is 0, and y, z and so the force L = λ_N are constant. Then b + p L = 0 (newex4), p' = α_1 + χ b
(newex1), b' = α_2 - α_3 L (newex2); m and b0 are slope and value at t = 0 of b.
"""

from __future__ import annotations

from flint import fmpq_mpoly

from gspot_verified.paper.checks.entry import Builders, Entry, Rung, Section
from gspot_verified.paper.checks.identities import Algebra

ALGEBRA = Algebra("p b t L m b0 chi alpha1 alpha2 alpha3")
_SYMBOLS = ALGEBRA.symbols
RATES = {"p": "alpha1 + chi*b", "b": "alpha2 - alpha3*L"}
"""newex1 and newex2 in positive slip."""
BALANCE = "b + p*L"
"""dv/dt of newex4 in positive slip."""
NOT_ZERO = ("chi", "alpha1", "alpha2")


def is_not_zero(value: fmpq_mpoly, *others: str) -> bool:
    """Whether a value is a product of numbers and symbols that are not 0."""
    number, factors = value.factor()
    allowed = [ALGEBRA.read(name) for name in (*NOT_ZERO, *others)]
    return number != 0 and all(factor in allowed for factor, _ in factors)


def without_force(value: fmpq_mpoly) -> fmpq_mpoly:
    """The value at L = 0."""
    return ALGEBRA.substitute(value, {"L": ALGEBRA.constant(0)})


def at_the_g_spot(value: fmpq_mpoly) -> fmpq_mpoly:
    """The value at p = 0, where b + p L = 0 gives b = 0."""
    return ALGEBRA.substitute(value, {"p": ALGEBRA.constant(0), "b": ALGEBRA.constant(0)})


def by_derivatives() -> bool | None:
    """Whether the first two derivatives of b + p L = 0, b' + L p' and χ L b', exclude p = 0.

    For L = 0 the first is α_2, not 0. For b' = 0 it is L p', so that p' = 0; but where p = 0 it is α_1, not 0.
    """
    rates = {name: ALGEBRA.read(text) for name, text in RATES.items()}
    balance = ALGEBRA.read(BALANCE)
    first = ALGEBRA.derivative(balance, rates)
    second = ALGEBRA.derivative(first, rates) - _SYMBOLS["chi"] * _SYMBOLS["L"] * rates["b"]
    ends = second.is_zero() and at_the_g_spot(balance).is_zero()
    holds = "chi" in NOT_ZERO and is_not_zero(without_force(first)) and is_not_zero(at_the_g_spot(rates["p"]))
    return True if ends and holds else None


def by_the_line() -> bool | None:
    """Whether b = b0 + m t and b + p L = 0 solve newex1 for no state with p = 0.

    What must vanish for all t is m + L (α_1 + χ b), with the slope χ L m. For L = 0 it is m = α_2, not 0. For m = 0, b
    is constant, and 0 where p = 0: it is L α_1, not 0.
    """
    rate = ALGEBRA.substitute(ALGEBRA.read(RATES["p"]), {"b": ALGEBRA.read("b0 + m*t")})
    residual = ALGEBRA.derivative(ALGEBRA.read(BALANCE), {"b": _SYMBOLS["m"], "p": rate})
    no_force = ALGEBRA.substitute(without_force(residual), {"m": without_force(ALGEBRA.read(RATES["b"]))})
    level = ALGEBRA.substitute(residual, {"m": ALGEBRA.constant(0), "b0": ALGEBRA.constant(0)})
    found = [is_not_zero(residual.derivative("t"), "L", "m"), is_not_zero(no_force), is_not_zero(level, "L")]
    return True if all(found) else None


def _no_trivial() -> Entry:
    return Section("Section 2").settled(
        "2-no-trivial",
        "lines 708 to 712",
        r"\chi=1:\ \text{there is no such trivial solution}",
        "In positive slip with contact the extended example has no solution with v = 0 and constant y and z that "
        "passes p = 0, for all χ, α_1 and α_2 other than 0",
        Rung.EXACT.check("newex4 with v = 0, derived twice along newex1 and newex2", by_derivatives()),
        Rung.EXACT.check("b as a line in t, p from newex4, put into newex1", by_the_line()),
        note="With constant y and z, p, b, y, v and z can rest too, as long as it slips, for χ and α_3 not 0, in "
        "contact where α_2/α_3 > 0: b = -α_1/χ, λ_N = α_2/α_3 and p = α_1 α_3/(χ α_2), which is not 0; u is not at "
        "rest there. For χ = 0: 2-trivial.",
    )


ENTRIES: Builders = {"2-no-trivial": _no_trivial}
"""No trivial solution."""
