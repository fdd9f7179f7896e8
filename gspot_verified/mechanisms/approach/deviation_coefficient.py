"""C_1 of a trajectory: the coefficient of (-t)^β in its deviation from the distinguished trajectory of its G-spot.

Proof page: ``proofs/approach.md``, Theorems A2 (β > 1) and A4 (β < 1).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from flint import arb

from gspot_verified.integrator.field.field import VectorField
from gspot_verified.mechanisms.approach.capture import Capture
from gspot_verified.mechanisms.approach.distinguished import Distinguished, FlowBounds, force_at, taylor_in_p
from gspot_verified.mechanisms.approach.slip_flow import SlipNumbers
from gspot_verified.numbers.balls import add_remainder, hull

_ROOM = arb((1, -3))  # of a radius of the region, for the rest of the polynomial: any number is correct


def coefficient_above_one(
    numbers: SlipNumbers,
    field: VectorField,
    states: Sequence[arb],
    neighbourhood: Capture,
    place: Sequence[arb],
    order: int,
    disc: arb,
    taylor: Callable[[VectorField, Sequence[arb], int], Distinguished | None] = taylor_in_p,
) -> arb | None:
    """C_1 from a state at a small p, where β > 1; None when a hypothesis is not certain.

    ``field`` is (S, R), ``neighbourhood`` the capture of ``states``, ``place`` encloses the G-spot; ``order`` and
    ``disc`` are those of the distinguished trajectory's polynomial, which ``taylor`` gives.
    """
    at = numbers.on(states)
    inside = neighbourhood.numbers
    if not inside.alpha_3 < inside.alpha_1:
        return None
    goal = inside.alpha_2 / (inside.alpha_3 - inside.alpha_1)
    try:
        trajectory = taylor(field, place, order)
    except ValueError:
        return None
    if trajectory is None or not goal.is_finite():
        return None
    # The region: where the trajectory itself stays, and the polynomial; a little wider than needed.
    whole = hull([arb(0), at.p.upper()])
    sides = []
    for polynomial, side in zip(
        (*trajectory.state, trajectory.force), (*neighbourhood.box, hull([at.force, goal])), strict=True
    ):
        around = hull([side, polynomial(whole)])
        sides.append(add_remainder(around, around.rad() * _ROOM))
    region = FlowBounds.on(field, sides)
    if region is None:
        return None
    middle = force_at(field, trajectory, at.p, disc, region)
    if middle is None:
        return None
    c = region.S_force * (region.S_state * at.p.upper()).exp()
    last = at.p.upper()
    if not region.exponent - region.R_state * c * last > 0:
        return None
    beta_change = arb(0)
    for slope, way in zip(numbers.beta_slopes(sides[:-1]), region.S, strict=True):
        beta_change = beta_change + slope.abs_upper() * way.abs_upper()
    omega = last * (beta_change + region.R_state * c)
    star = numbers.on(place)
    deviation = at.force - middle
    # One power of (α₁*/p)^(β* - 1) and exp([-ω, ω]): a product of wide balls would lose the sign.
    grown = add_remainder((star.alpha_3 / star.alpha_1 - 1) * (-star.alpha_1 / at.p).log(), omega).exp()
    value = star.alpha_1 * deviation * grown
    return value if value.is_finite() else None


def coefficient_below_one(
    numbers: SlipNumbers, states: Sequence[arb], neighbourhood: Capture, place: Sequence[arb]
) -> arb | None:
    """C_1 < 0 from a state at a small p, where β < 1; None when a hypothesis is not certain."""
    at, inside, star = numbers.on(states), neighbourhood.numbers, numbers.on(place)
    # λ grows at least like exp(growth s): the integral of 1/λ.
    push = inside.alpha_2.upper().max(arb(0))
    growth = (inside.alpha_3 - inside.alpha_1).lower() - push / at.force.lower()
    if not (at.force > 0 and growth > 0):
        return None
    inverse_force = 1 / (at.force.lower() * growth)
    F, G = _largest(inside.F), _largest(inside.G)
    p, second = at.p.abs_upper(), inside.alpha_2.abs_upper()
    first, third = neighbourhood.decay_1, neighbourhood.decay_3
    distance = F * p / first**2 + G * (neighbourhood.integral_of_b + second * p / first**2) / third
    slopes = sum((slope.abs_upper() for slope in numbers.beta_slopes(neighbourhood.box)), arb(0))
    omega = second * inverse_force + inside.alpha_1.abs_upper() * slopes * distance
    grown = add_remainder(star.alpha_3 / star.alpha_1 * (-star.alpha_1 / at.p).log(), omega).exp()
    value = at.b * grown
    return value if value.is_finite() else None


def _largest(values: Sequence[arb]) -> arb:
    largest = arb(0)
    for value in values:
        largest = largest.max(value.abs_upper())
    return largest
