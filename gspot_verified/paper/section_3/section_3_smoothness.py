"""Ledger of Section 3.2: which derivative of y diverges at the G-spot as epsilon tends to 0."""

from __future__ import annotations

from functools import partial

from flint import arb, fmpq

from gspot_verified.numbers.balls import ball_text, certainly_less, working_bits
from gspot_verified.paper.checks.entry import Builders, Entry, Rung, Section, all_of
from gspot_verified.paper.numerics.at_the_g_spot import deviations
from gspot_verified.paper.numerics.scaling_exponents import limit_exponent, regression_error

SECTION = Section("Section 3")
DIVERGES = {fmpq(1, 2): 0, fmpq(3, 2): 1, fmpq(5, 2): 2}
"""By β: which derivative of y diverges first, as printed."""
DERIVATIVES = ("y", "v", "b")
"""y, dy/dt = v and, at p = 0, d²y/dt² = b."""
LARGEST = fmpq(1, 2500)
SHOWN = (fmpq(1, 10**3), fmpq(1, 10**5))
NU = fmpq(2)


def exponent_over_scale(beta: fmpq, order: int) -> fmpq:
    """The limit exponent of the derivative over ε², the scale of y at fixed p."""
    return limit_exponent(beta, DERIVATIVES[order]) - 2


def as_printed(beta: fmpq, order: int) -> bool | None:
    """Whether the derivative diverges over every series of small ε exactly from the printed order on."""
    error = regression_error(beta, DERIVATIVES[order], LARGEST)
    exponent = exponent_over_scale(beta, order)
    with working_bits(64):
        if certainly_less(error, arb(abs(exponent))) is not True:
            return None
    return (exponent < 0) == (order >= DIVERGES[beta])


def grows(beta: fmpq, order: int) -> bool | None:
    """The same between two ε, one of them that of the figure."""
    with working_bits(64):
        large, small = (abs(deviations(beta, NU, e)[DERIVATIVES[order]]) / e**2 for e in SHOWN)
        answer = certainly_less(large, small)
    return None if answer is None else answer == (order >= DIVERGES[beta])


def _smoothness(beta: fmpq) -> Entry:
    orders = range(DIVERGES[beta] + 1)
    lower = "; the derivatives of lower order tend to 0" if DIVERGES[beta] else ""
    word = ("y itself", "the first derivative of y", "the second derivative of y")[DIVERGES[beta]]
    lines = {0: "lines 799 to 800", 1: "lines 801 to 802", 2: "lines 802 to 803"}[DIVERGES[beta]]
    # For β < 1 the run of ν = 1 is none of the trivial solution: b(0) < 0, and (1 + ν)|λ̄| in the place of (ν - 1)λ̄.
    other = "" if beta < 1 else " other than ν = 1"
    values = []
    for epsilon in SHOWN:
        with working_bits(64):
            size = abs(deviations(beta, NU, epsilon)[DERIVATIVES[DIVERGES[beta]]]) / epsilon**2
            values.append(f"ε = {epsilon}: {ball_text(size, 6)}")
    return SECTION.settled(
        smoothness_identifier(beta),
        lines,
        rf"\beta={float(beta.p) / float(beta.q)}:\ \text{{{word} appears to diverge}}",
        f"β = {beta}, runs of fig. varsim1{other}, in the scale ε² of y: at the G-spot {word} has size "
        f"ε^(-1/3), and diverges as ε → 0{lower} (the trivial solution taken off, with the corrected sign of its y: "
        "2-trivial-zy)",
        Rung.BALLS.check(
            f"proofs/scaling_exponents.md, Theorem E3: the exponent of each derivative over ε², every ε <= {LARGEST}",
            all_of(
                [*(as_printed(beta, order) for order in orders), _is_third(exponent_over_scale(beta, DIVERGES[beta]))]
            ),
        ),
        Rung.POINTS.check(
            f"certified values at ε = 10^-3 and 10^-5, ν = {NU}",
            all_of(grows(beta, order) for order in orders),
            "; ".join(values),
        ),
        note="y itself tends to 0 with ε: what diverges is y/ε², at p = 0. As ε → 0 at fixed p, y/ε² has the term "
        "p^(β-1), whose derivative of this order diverges as p → 0.",
    )


def _is_third(exponent: fmpq) -> bool | None:
    return exponent == fmpq(-1, 3)


def smoothness_identifier(beta: fmpq) -> str:
    """The identifier of the entry of one β."""
    return f"3-smooth-{str(beta).replace('/', '_')}"


ENTRIES: Builders = {smoothness_identifier(beta): partial(_smoothness, beta) for beta in DIVERGES}
"""The sentences on the figure at ε = 10^-5, one for each β."""
