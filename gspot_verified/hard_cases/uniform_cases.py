"""Hard cases of uniform bounds: an expansion followed past the G-spot, where solutions part from each other."""

from __future__ import annotations

from flint import fmpq

from gspot_verified.expansion.true_solutions.bound import UniformBound, uniform_bound
from gspot_verified.hard_cases.hard_case import Case, HardCase
from gspot_verified.hard_cases.timed import timed
from gspot_verified.mechanisms.expand import expand
from gspot_verified.mechanisms.load import load
from gspot_verified.numbers.balls import approximate
from gspot_verified.numbers.verdict import Outcome

ORDER = 6  # of delta, of the expansion
START = fmpq(-3)  # s, before the G-spot at s = 0
DELTA = fmpq(1, 20)  # the statement is for all smaller ones


def bound_until(end: int) -> UniformBound:
    """How far the solution that starts on the expansion at s = -3 is from it, up to s = ``end``."""
    return uniform_bound(expand(load("extended"), ORDER), START, end, DELTA, within=0)


def past_the_g_spot(end: int) -> HardCase:
    """Whether that is proved for all delta up to 1/20: 1 where it is; the constant of p is shown."""
    bound, seconds = timed(lambda: bound_until(end))
    proved = bound.verdict.outcome is Outcome.PROVED
    text = f"|Δp| ≤ {approximate(bound.constants['p'].upper()):.4g} δ^6" if proved else "undecided"
    asked = f"the distance from the expansion up to s = {end}, 0 < δ ≤ 1/20"
    return HardCase(
        level=end,
        asked=asked,
        condition=None,
        lost=None,
        double=None,
        double_text="",
        certified=1 if proved else None,
        text=text,
        work=len(bound.stretches),
        seconds=seconds,
    )


CASES: dict[str, Case] = {"uniform": past_the_g_spot}
