"""Ledger of Section 3, "Possible dynamics beyond the G-spot": what follows lift-off in the printed simulations.

The runs are those of proofs/flight.md: brackets of both events, and a contact that lasts for ever by an invariant set.
"""

from __future__ import annotations

from flint import arb, fmpq

from gspot_verified.compliant.model.normal_form import compliant_model
from gspot_verified.compliant.motion.run import ONE_FLIGHT, CompliantRun, events
from gspot_verified.compliant.side.side_later import side
from gspot_verified.numbers.balls import ball_text, certainly_less, hull, sign_of, working_bits
from gspot_verified.numbers.verdict import Outcome
from gspot_verified.paper.checks.entry import Builders, Entry, Rung, Section, all_of, same_sign
from gspot_verified.paper.numerics.paper_state import paper_state
from gspot_verified.paper.numerics.slow_flights import LATEST

DIGITS = 12
_SIDE_BITS = 60
EPSILONS = (fmpq(1, 10**3), fmpq(1, 10**9))
LIFTING = {fmpq(3, 2): (fmpq(2), fmpq(4)), fmpq(5, 2): (fmpq(1, 4), fmpq(1, 2))}
"""By β, panels (b) and (c): the simulated ν that lift off."""
CLAIM = {"events": ONE_FLIGHT}
"""What a run must have proved about itself."""
MOST = 300
POWER = fmpq(4, 3)
"""The velocity before the impact is below MOST ε^POWER."""
MOST_FREE = 13
FREE_POWER = fmpq(2, 3)
"""b at lift-off, the normal acceleration there, is below MOST_FREE ε^FREE_POWER."""
MOST_TIME = 45
TIME_POWER = fmpq(2, 3)
"""The touch-down comes less than MOST_TIME ε^TIME_POWER after the G-spot."""


def run_of(beta: fmpq, nu: fmpq, epsilon: fmpq) -> CompliantRun:
    """The certified run from the paper's data with ν."""
    model = compliant_model(beta, epsilon)
    return events(model, paper_state(model, nu), DIGITS)


def as_claimed(run: CompliantRun) -> bool | None:
    """One flight that rises faster than |y|/ε from a small b > 0, and a slow touch-down soon after the G-spot."""
    if run.verdict.outcome is not Outcome.PROVED:
        return None
    if run.verdict.statement != CLAIM["events"] or len(run.events) != 2:
        return False
    first, speed = run.events[0].state, -run.events[1].velocity
    with working_bits(64):
        time = hull([arb(run.events[1].lower), arb(run.events[1].upper)])
        # v is ε V and y is ε² Y.
        rises = [certainly_less(first.Y, arb(0)), certainly_less(-first.Y, first.V)]
        bounds = [(first.b, MOST_FREE, FREE_POWER), (speed, MOST, POWER), (time, MOST_TIME, TIME_POWER)]
        small = [certainly_less(value, most * arb(run.model.epsilon) ** arb(power)) for value, most, power in bounds]
        return all_of([*rises, *(certainly_less(arb(0), value) for value, _, _ in bounds), *small])


def side_at_touch_down(run: CompliantRun) -> bool | None:
    """Whether K > 0 there: necessary for contact that lasts, and found without the invariant sets."""
    if len(run.events) != 2:
        return None
    return same_sign(sign_of(side(run.events[1].state, _SIDE_BITS)), 1)


def _one_flight() -> Entry:
    answers: list[bool | None] = []
    sides: list[bool | None] = []
    shown = []
    for beta, factors in LIFTING.items():
        for nu in factors:
            for epsilon in EPSILONS:
                run = run_of(beta, nu, epsilon)
                answers.append(as_claimed(run))
                sides.append(side_at_touch_down(run))
            if run.events:
                shown.append(f"β = {beta}, ν = {nu}, ε = {epsilon}: v = {ball_text(run.events[-1].velocity, 6)}")
    return Section("Section 3").settled(
        "3-after-lift-off",
        "lines 914 to 918",
        r"\text{lift-off terminates shortly after the G-spot, with an impact of very low normal velocity}",
        "Each run of Case III from the starts of Figure 6 that lifts off, at ε = 10^-3 and 10^-9, has exactly one "
        "flight, from a lift-off where y < 0, v > |y|/ε and 0 < b < 13 ε^(2/3) to a touch-down, less than 45 ε^(2/3) "
        "after the G-spot, where 0 < -v < 300 ε^(4/3), and then takes an impact without collision: contact is not "
        "lost again",
        Rung.BALLS.check(
            "proofs/flight.md: certified lift-off and touch-down; the state at touch-down lies in an invariant set in "
            "which λ_N > 0 for ever, λ_N and -v without bound",
            all_of(answers),
            "; ".join(shown),
        ),
        Rung.POINTS.check(
            "proofs/flight.md, section 6: K > 0 in each state at touch-down, by its contour; K < 0 would mean that "
            "contact is lost again",
            all_of(sides),
        ),
        note="The last section of the paper leaves open whether contact is lost again, even infinitely often: in "
        "these runs of the model system it is not. On the slow manifold, α_1 = -1, α_2 < 0, this is proved for β = "
        f"3/2 and 5/2 and every ε <= 1/100 at once, for a lift-off that is late enough and has t <= {LATEST} "
        "(proofs/flight.md, section 5): τ >= 2 for β = 3/2, τ >= 5 for β = 5/2; by no check of this entry.",
    )


ENTRIES: Builders = {"3-after-lift-off": _one_flight}
"""What follows lift-off."""
