"""Which side a start of the linear model scene takes: certified by the exact solution, or as a float run has it.

Proof pages: ``proofs/first_integrals.md`` (the sign of K), ``proofs/flight.md`` (contact that lasts for ever).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from flint import fmpq

from gspot_verified.compliant.model.normal_form import (
    CompliantModel,
    CompliantState,
    deviation,
)
from gspot_verified.compliant.motion.compliant_force import force
from gspot_verified.compliant.motion.lasting_contact import lasting_contact
from gspot_verified.compliant.motion.lift_off_state import contact_state
from gspot_verified.compliant.motion.run import IMPACT as LASTING
from gspot_verified.compliant.motion.run import events as compliant_run
from gspot_verified.compliant.motion.run_plan import later_times
from gspot_verified.compliant.motion.zero_by_series import positive_by_series, zero_by_series
from gspot_verified.compliant.side.side_rule import SideRule, side_rule
from gspot_verified.numbers.balls import sign_of
from gspot_verified.numbers.evidence import every, less
from gspot_verified.numbers.verdict import NoTruthValue, Outcome, Reason, Verdict
from gspot_verified.scenes.certified_run import exact_start
from gspot_verified.scenes.effects.lift_off import LIFT_OFF
from gspot_verified.scenes.floats.float_run import float_run
from gspot_verified.scenes.scene.run import IMPACT
from gspot_verified.scenes.scene.scene import Scene, SceneError

LOST, LASTS = "contact is lost", "contact lasts"
NO_EVENT, FAILED = "no event", "failed"
_SERIES_FROM = fmpq(1, 1500)  # epsilon, above which the power series is asked first; any number is right
_DIGITS, _BITS = 13, 60  # of the state from which lasting contact is shown


@dataclass(frozen=True, slots=True)
class CertifiedSide(NoTruthValue):
    """``side``: whether contact is lost or lasts for ever, None where that is undecided; ``rule``: K and its parts.

    ``asymptotic``: what the paper's rule says; None where it does not apply or is open.
    """

    ask: ClassVar[str] = ".side is a text or None, .verdict a Verdict"

    side: str | None
    rule: SideRule
    verdict: Verdict

    @property
    def asymptotic(self) -> str | None:
        """The side by the paper's rule."""
        sign = self.rule.paper_side
        return None if sign is None else LASTS if sign > 0 else LOST

    @property
    def rule_fails(self) -> bool | None:
        """Whether the paper's rule gives the wrong side; None where one of the two is open."""
        return None if self.side is None or self.asymptotic is None else self.side != self.asymptotic


def certified_side(scene: Scene) -> CertifiedSide:
    """Whether the contact of the scene's start is lost or lasts for ever, from the exact solution.

    :raises NotCovered: the scene is not the linear model scene from a state in contact with p > 0.

    >>> from gspot_verified.scenes.scene.file import load_scene
    >>> certified = certified_side(load_scene("fig-varsim1", beta="13/2", nu=2))
    >>> certified.side, certified.rule_fails
    ('contact is lost', True)
    """
    model, state = exact_start(scene)
    rule = side_rule(model, state, 6)
    if (negative := less(rule.side, 0)) is not None:
        return CertifiedSide(LOST, rule, Verdict.proved(LOST, negative, "K < 0"))
    if sign_of(rule.side) == 1 and model.scaled_epsilon > _SERIES_FROM:
        verdict = _by_series(model, state)
        if verdict is not None:
            return CertifiedSide(verdict.statement, rule, verdict)
    run = compliant_run(model, state, 3)
    if run.verdict.outcome is Outcome.PROVED and run.verdict.statement == LASTING:
        return CertifiedSide(LASTS, rule, Verdict.proved(LASTS, run.verdict.evidence, run.verdict.detail))
    lost = next((event.evidence for event in run.events if event.name == LIFT_OFF), None)
    if lost is not None:
        return CertifiedSide(LOST, rule, Verdict.proved(LOST, lost, "λ_N > 0 up to a zero, dλ_N/dt < 0 at it"))
    text = "whether contact is lost or lasts"
    return CertifiedSide(None, rule, Verdict.undecided(text, Reason.BUDGET, "neither was shown"))


def _by_series(model: CompliantModel, state: CompliantState) -> Verdict | None:
    """Where the fast part is large: the force by its power series up to a time of an invariant set, or to its zero."""
    start = deviation(model, state)
    mean = model.mean_force * model.sigma**2
    for time in later_times(model):
        there = contact_state(force(model, state, time, _DIGITS), _BITS)
        lasting = lasting_contact(there, _BITS)
        if lasting.outcome is Outcome.PROVED:
            until = start.p / start.epsilon - model.alpha_1 * time / start.epsilon
            shown = every([positive_by_series(start, mean, until), lasting.evidence])
            if shown is not None:
                text = "λ_N > 0 by its power series up to a state in an invariant set"
                return Verdict.proved(LASTS, shown, text)
            break
    zero = zero_by_series(start, mean, fmpq(1, 1000), _BITS)
    if zero is not None:
        return Verdict.proved(LOST, zero.evidence, "λ_N > 0 by its power series up to a zero, dλ_N/dt < 0 at it")
    return None


def float_side(scene: Scene, method: str, tolerance: float) -> str:
    """What a float run says: LOST or LASTS by its first event, NO_EVENT, or FAILED where the solver gives up."""
    try:
        events = float_run(scene, method, tolerance).events
    except SceneError:
        return FAILED
    names = [event.name for event in events]
    if not names:
        return NO_EVENT
    return {LIFT_OFF: LOST, IMPACT: LASTS}.get(names[0], NO_EVENT)
