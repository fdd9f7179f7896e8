"""What the runs of the paper's Fig. varsim1 do in the compliant model, for every epsilon up to an epsilon_0 at once.

Proof page: ``proofs/paper_runs.md`` (Theorem A').
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import ClassVar

from flint import arb, fmpq

from gspot_verified.compliant.fast.decaying_coefficient import real_saddle
from gspot_verified.compliant.fast.fast_coefficient import saddle
from gspot_verified.compliant.fast.fast_coefficient_bound import (
    decaying_coefficient_bound,
    oscillating_coefficient_bound,
    unit_weight,
)
from gspot_verified.compliant.fast.fast_path_bound import decaying_bounds, oscillating_bounds
from gspot_verified.compliant.fast.late_bound import late_bounds
from gspot_verified.compliant.slow.grid import scale
from gspot_verified.compliant.slow.slow_solution import slow_value
from gspot_verified.numbers.balls import ShownBall, float_bounds, rounded_text, working_bits
from gspot_verified.numbers.evidence import equal, every, less
from gspot_verified.numbers.verdict import NoTruthValue, Reason, Verdict
from gspot_verified.numbers.written import Written
from gspot_verified.theta_function.value.evaluate import evaluate

START = fmpq(1, 2)
"""p at the start of the runs."""
CANDIDATES = tuple(fmpq(1, n) for n in (25, 50, 75, 100, 150, 200, 250, 300, 400, 500, 700, 1000))
_BITS = 64
_DIGITS = 15
_FORCE = 1
_RAY = fmpq(131, 100)


@dataclass(frozen=True, slots=True)
class PaperRun(NoTruthValue, Written):
    """What one run does for every epsilon in (0, ``epsilon_0``]: ``fate`` is "impact", "lift-off" or "trivial".

    ``margin``: a lower bound of lambda/|mean force| up to the G-spot (lift-off) or for all times (impact).
    """

    written: ClassVar[str] = "beta nu fate epsilon_0 margin verdict"

    beta: fmpq
    nu: fmpq
    fate: str
    epsilon_0: fmpq | None
    verdict: Verdict
    margin: ShownBall | None = None


@dataclass(frozen=True, slots=True)
class Sizes:
    """Bounds for all epsilon <= largest: Phi on T <= 0 (``fast``), Phi_Q on T >= 0 (``late``), |Phi_P^(n)| relative to
    H |F_b^(n)| (``ratio``) on T >= 0 and |Phi_P'(0)| relative to H |F_b'(0)| (``start``), ``scale`` of H F_b."""

    fast: arb
    late: arb
    ratio: arb
    start: arb
    scale: arb


def paper_run(beta: fmpq, nu: fmpq) -> PaperRun:
    """The fate of the run (p, b, y, v, z) = (1/2, -nu |mean|/2, 4 b epsilon^2, 0, 2 b epsilon^2), alpha_1 =
    alpha_2 = -1.

    epsilon_0 is the largest of a list that the proof reaches; nu > 0, beta in (0, 3), not an integer.

    >>> found = paper_run(fmpq(1, 2), fmpq(1, 4))
    >>> found.fate, found.epsilon_0 >= fmpq(1, 100)
    ('impact', True)
    """
    if not (0 < beta < 3 and beta.q > 1 and nu > 0):
        raise ValueError(f"beta, nu: expected a beta in (0, 3) that is no integer and nu > 0, got {beta}, {nu}")
    if (trivial := every([less(1, beta), equal(nu, 1)])) is not None:
        return PaperRun(
            beta,
            nu,
            "trivial",
            None,
            Verdict.proved(f"β = {beta}, ν = 1: λ_N is the mean force for ever, at every ε > 0", trivial),
        )
    fate = fate_by_side(beta, nu)
    for largest in CANDIDATES:
        margin = margin_up_to(beta, nu, largest)
        if margin is not None and (positive := less(0, margin)) is not None:
            text = f"in the compliant model, β = {beta}, ν = {nu}, every ε in (0, {largest}]: {_FATES[fate]}"
            least = rounded_text(float_bounds(margin)[0], -1, 5)
            detail = f"λ_N is at least {least} times |mean force| {_WHERE[fate]}"
            return PaperRun(beta, nu, fate, largest, Verdict.proved(text, positive, detail), margin)
    text = f"in the compliant model, β = {beta}, ν = {nu}, some ε0: {_FATES[fate]}"
    return PaperRun(beta, nu, fate, None, Verdict.undecided(text, Reason.BUDGET, "no ε0 >= 1/1000 was found"))


_FATES = {
    "impact": "contact lasts for ever, λ_N > 0, and λ_N → +∞: an impact without collision",
    "lift-off": "λ_N > 0 until after the G-spot, and then contact is lost",
}
_WHERE = {"impact": "for all times", "lift-off": "up to the G-spot"}


def fate_by_side(beta: fmpq, nu: fmpq) -> str:
    """Impact for beta < 1; for 1 < beta < 2 when nu < 1, for 2 < beta < 3 when nu > 1."""
    return "impact" if beta < 1 or (nu < 1) == (beta < 2) else "lift-off"


def margin_up_to(beta: fmpq, nu: fmpq, largest: fmpq) -> arb | None:
    """The margin of Theorem A' for every epsilon <= ``largest``; None when a hypothesis fails there."""
    with working_bits(_BITS):
        sizes = sizes_up_to(beta, largest)
        if sizes is None or not (sizes.ratio < 1 and sizes.fast < fmpq(1, 2)):
            return None
        return _MARGINS[0 if beta < 1 else 1 if beta < 2 else 2](beta - 1, nu, largest, sizes)


def least_share(beta: fmpq, largest: fmpq) -> arb | None:
    """beta < 1: a lower bound of lambda-hat over its value at the start, for all times and every epsilon <= largest
    (section 3); None when a hypothesis fails there. The share does not depend on nu and alpha_2, and has no bound."""
    with working_bits(_BITS):
        sizes = sizes_up_to(beta, largest) if beta < 1 else None
        if sizes is None or not (sizes.ratio < 1 and sizes.fast < fmpq(1, 2)):
            return None
        return _least_share(sizes)


def _least_share(sizes: Sizes) -> arb:
    return (1 - 2 * sizes.fast).min((1 - sizes.ratio) * (1 - sizes.fast) - sizes.late)


def _case_one(_b: fmpq, nu: fmpq, _largest: fmpq, sizes: Sizes) -> arb | None:
    """b < 0: F increases (section 3)."""
    return (1 + nu) * _least_share(sizes) - 1


def _first_panel(b: fmpq, nu: fmpq, largest: fmpq, sizes: Sizes) -> arb | None:
    """0 < b < 1: F decreases, F(0) > 0 (section 4)."""
    if nu < 1:
        return 1 - (1 - nu) * (1 + 2 * sizes.fast + sizes.late)
    if not slow_value(0, b, largest, digits=_DIGITS).value > 0:
        return None
    return 1 - (nu - 1) * sizes.fast


def _second_panel(b: fmpq, nu: fmpq, largest: fmpq, sizes: Sizes) -> arb | None:
    """1 < b < 2: F is convex, F(0) < 0 (section 5)."""
    if nu < 1:
        return 1 - (1 - nu) * (1 + 2 * sizes.fast)
    if not slow_value(0, b - 1, largest, digits=_DIGITS).value > 0:
        return None
    value, slope, bend = (evaluate(0, b - k, digits=_DIGITS).value for k in range(3))
    if not (slope > 0 and bend > 0):
        return None
    dip = abs(value) + b / (2 * (b - 1)) * (slope * (1 + sizes.start)) ** 2 / ((1 - sizes.ratio) * bend)
    return 1 - (nu - 1) * (sizes.scale * dip + sizes.fast + sizes.late)


_MARGINS: tuple[Callable[[fmpq, fmpq, fmpq, Sizes], arb | None], ...] = (_case_one, _first_panel, _second_panel)


def sizes_up_to(beta: fmpq, largest: fmpq) -> Sizes | None:
    """The bounds for every epsilon <= ``largest`` (section 2); None where one does not exist or does not fall with
    epsilon."""
    b, small, p = beta - 1, arb(largest), START
    weight = unit_weight(arb(beta))
    top = saddle(p)
    rate = (top * (1 - p - top / 2 - top * top / 3) - (1 + top).log()).real
    coefficient = oscillating_coefficient_bound(weight, p, small)
    wave = abs(b) / arb.pi() * coefficient * oscillating_bounds(arb(beta), p, small)[_FORCE]
    fall = abs(b) / (2 * arb.pi()) * decaying_coefficient_bound(weight, p, small)
    fall = fall * decaying_bounds(arb(beta), p, small)[_FORCE]
    fast = wave + fall
    if not (fast < 1 and b * small <= rate):
        return None
    least = _least_h(b, largest, fast)
    if not least > 0:
        return None
    order = max(0, int(b.ceil()))
    index = b - order
    rising = abs(b * (b - 1)) if order == 2 else abs(b) if order == 1 else fmpq(1)
    swing = abs(b) / arb.pi() * coefficient * (-rate / small).exp() * (arb(p) / small) ** b / least
    ratio = swing * (1 + _RAY) * arb(-index).gamma() / rising
    start = arb(0)
    if order == 2:
        slope = slow_value(0, b - 1, largest, digits=_DIGITS).value
        start = swing * late_bounds(b, largest, fmpq(0), ("force",))[0] / (b * slope)
        if not slope > 0:
            return None
    drop = (real_saddle(p) * p / small).exp()
    size = (2 * scale(largest) ** 2 / p) ** arb(b) if b > 0 else arb(1)
    found = Sizes(*(value.abs_upper() for value in (fast, fall * drop, ratio, start, size)))
    return found if all(v.is_finite() for v in (found.fast, found.late, found.ratio, found.start)) else None


def _least_h(b: fmpq, largest: fmpq, fast: arb) -> arb:
    """A lower bound of H (p_0/epsilon)^b for every epsilon <= ``largest`` (section 2)."""
    if b < 0:
        return 1 - fast
    small, p = arb(largest), arb(START)
    far = p / (2 * small)
    if not far > b:
        return arb(0)
    tail = far ** (b - 1) * (-far).exp() * arb(b).rgamma() / (1 - max(b - 1, fmpq(0)) / far)
    return (1 - small**2 / p**3 * b * (b + 1) * (b + 2) - tail).lower()
