"""The model from a state, phase after phase, by the plain Taylor method of the attack beside the certified run."""

from __future__ import annotations

from fractions import Fraction

from attack.balls_as_numbers import to_fraction
from attack.motion import DEFAULTS
from attack.reference_motion import Model, Motion, moved
from flint import fmpq

from gspot_verified.compliant.model.normal_form import CompliantModel, CompliantState
from gspot_verified.compliant.motion.run import CompliantRun
from gspot_verified.numbers.verdict import Outcome

ERROR = fmpq(1, 10**45)  # of the reference, at most
BEYOND = 25  # in T, after the last event: for so long the reference sees no other


def hybrid_run(model: CompliantModel, state: CompliantState, until: Fraction) -> Motion:
    """The motion up to the time ``until`` since the start, in T = t/epsilon."""
    epsilon = to_fraction(model.epsilon)
    parameters = {name: Fraction(value) for name, value in DEFAULTS.items()}
    parameters |= {name: to_fraction(getattr(model, name)) for name in ("alpha_1", "alpha_2", "beta")}
    reference = Model(epsilon, parameters, sticks=False)
    scaled = (state.p, state.b, state.y / model.epsilon**2, state.v / model.epsilon, state.z / model.epsilon**2)
    start = [*map(to_fraction, scaled), Fraction(0)]
    return moved(reference.phases(), reference.first(start), start, until, reference.after)


def disagreement(run: CompliantRun) -> str | None:
    """What the certified run says otherwise than the reference, up to a while after its last event; None: nothing."""
    epsilon = run.model.epsilon
    last = max((event.upper for event in run.events), default=run.start)
    motion = hybrid_run(run.model, run.state, to_fraction((last - run.start) / epsilon) + BEYOND)
    certified = [event for event in run.events if event.name in ("lift-off", "touch-down")]
    open_end = run.verdict.outcome is not Outcome.PROVED or "lost again" in run.verdict.statement
    seen = motion.events[: len(certified)] if open_end else motion.events
    if [event.name for event in certified] != [name for name, _ in seen]:
        return f"{run}\nbut the reference has {[(name, float(time)) for name, time in motion.events]}"
    for event, (name, time) in zip(certified, seen, strict=True):
        place = run.start + epsilon * fmpq(time.numerator, time.denominator)
        if not event.lower - ERROR <= place <= event.upper + ERROR:
            return f"{name} in [{event.lower}, {event.upper}], but the reference has {place}"
    return None
