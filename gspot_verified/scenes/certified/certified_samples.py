"""The trajectory of a certified run of the linear model scene: enclosures, as midpoints and radii.

In the first contact by the exact solution, in flight in closed form. Proof pages: ``proofs/exact_solution.md``,
``proofs/flight.md``, section 1.
"""

from __future__ import annotations

import math

from flint import arb, fmpq

from gspot_verified.compliant.model.flight import Flight
from gspot_verified.compliant.model.normal_form import CompliantModel
from gspot_verified.compliant.motion.compliant_force import force
from gspot_verified.compliant.motion.run import CompliantRun, Event
from gspot_verified.numbers.balls import bits_for_digits, float_bounds, working_bits
from gspot_verified.scenes.effects.lift_off import LIFT_OFF, TOUCH_DOWN
from gspot_verified.scenes.equations.terms import FLIGHT, SLIP
from gspot_verified.scenes.scene.samples import RADIUS, Samples

MAX_POINTS = 100_000  # a limit of input: ValueError beyond it
_COLUMNS = ("p", "b", "y", "v", "z", "lambda_N")
_LARGEST_RATIO = 1000  # of lambda_N to its first value: beyond it the trajectory is not drawn


def certified_samples(run: CompliantRun, until: fmpq, points: int, digits: int = 12) -> Samples:
    """Enclosures at ``points`` equal steps of time from the start to ``until`` and at the ends of the brackets of
    the events, as far as the run is known: to where the bracket of the first touch-down begins, or where the force is
    1000 times its first value; nothing where it is not known whether contact lasts.

    Each value lies within the radius of its midpoint, both floats.

    :raises ValueError: fewer than 2 points, or more than 100000.
    """
    import numpy as np

    if not 2 <= points <= MAX_POINTS:
        raise ValueError(f"points: expected 2..{MAX_POINTS}, got {points}")
    rows, phases = [], []
    first: float | None = None
    for time in _times(run, until, points):
        sample = _values(run, run.start + time, digits)
        if sample is None:
            break
        phase, values = sample
        pairs = [midpoint_and_radius(value) for value in values]
        first = pairs[-1][0] if first is None else first
        if not all(math.isfinite(part) for pair in pairs for part in pair) or pairs[-1][0] > _LARGEST_RATIO * first:
            break
        rows.append([part for pair in (midpoint_and_radius(arb(time)), *pairs) for part in pair])
        phases.append(phase)
    names = tuple(name + end for name in ("t", *_COLUMNS) for end in ("", RADIUS))
    columns = np.array(rows).reshape(len(rows), len(names)).T
    return Samples(dict(zip(names, columns, strict=True)), tuple(phases))


def _times(run: CompliantRun, until: fmpq, points: int) -> list[fmpq]:
    """In order, after the start; of a touch-down only where its bracket begins: nothing is known in it."""
    ends = [run.start + until * k / (points - 1) for k in range(points)]
    for event in run.events:
        ends += [event.lower] if event.name == TOUCH_DOWN else [event.lower, event.upper]
    return sorted({time - run.start for time in ends if run.start <= time <= run.start + until})


def midpoint_and_radius(value: arb) -> tuple[float, float]:
    """Two floats m and r with the whole ball in [m - r, m + r]; r is infinite where the ball has no bounds in floats.

    >>> middle, radius = midpoint_and_radius(arb(1) / 2)
    >>> middle, 0 <= radius < 1e-15
    (0.5, True)
    """
    low, high = float_bounds(value)
    middle = low / 2 + high / 2
    if not math.isfinite(middle):
        return 0.0, math.inf
    # The difference is rounded to nearest: the next float is no less than it.
    return middle, math.nextafter(max(high - middle, middle - low), math.inf)


def _values(run: CompliantRun, time: fmpq, digits: int) -> tuple[str, list[arb]] | None:
    """The phase and p, b, y, v, z, lambda_N at one time, measured from the G-spot; None: it is not known."""
    # The first of each name: the exact solution holds up to the first lift-off, the closed form in the flight after it.
    lift, land = (next((event for event in run.events if event.name == name), None) for name in (LIFT_OFF, TOUCH_DOWN))
    if lift is None:
        if run.verdict.exit_code != 0:
            return None
    elif time > lift.lower:
        known = land is not None and lift.upper <= time <= land.lower
        return (FLIGHT, _in_flight(run.model, lift, time, digits)) if known else None
    contact = force(run.model, run.state, time, digits)
    return SLIP, [arb(contact.p), contact.b, contact.y, contact.v, contact.z, contact.force]


def _in_flight(model: CompliantModel, lift: Event, time: fmpq, digits: int) -> list[arb]:
    """The closed form, for every lift-off in its bracket; in the units of the paper."""
    start, sigma, small = lift.state, model.sigma, model.scaled_epsilon
    with working_bits(bits_for_digits(digits) + 64):
        u = (arb(time) - arb(lift.lower).union(arb(lift.upper))) / model.epsilon
        there = Flight(start).landed(u)
        deformation = there.Y
        height = deformation + Flight(start).gap(u)
        return [
            arb(time) * model.alpha_1,
            there.b / sigma**2,
            height * small**2,
            there.V * small / sigma,
            deformation * small**2,
            arb(0),
        ]
