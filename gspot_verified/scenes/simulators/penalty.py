"""The compliant contact of the paper as a simulator would have it: one stiff system of floats, by scipy's LSODA."""

from __future__ import annotations

import math
from collections.abc import Sequence

from gspot_verified.mechanisms.input.mechanism import Mechanism
from gspot_verified.numbers.balls import approximate
from gspot_verified.scenes.scene.scene import SceneError
from gspot_verified.scenes.simulators.contact_floats import ContactFloats
from gspot_verified.scenes.simulators.simulated import Simulated

_SMOOTHED = 1e-5  # of the slip velocity at the start: friction is μ λ tanh of the slip velocity over that
_ROWS = 4000  # of the table that is kept: a step is not longer than that, so no event is stepped over
_TOLERANCE = 1e-9  # relative, of the solver


def penalty(
    mechanism: Mechanism,
    functions: ContactFloats,
    start: Sequence[float],
    *,
    epsilon: float,
    until: float,
    surface_velocity: float = 0.0,
) -> Simulated:
    """The motion in unscaled variables, from the depth at which the spring carries the force -b/p of rigid slip.

    :raises SceneError: there is no damper, or the solver gives up.
    """
    from scipy.integrate import solve_ivp

    r = mechanism.regularisation
    series, own, damper = (approximate(value) for value in (r.k_1, r.k_2, r.c))
    if damper == 0:
        raise SceneError(f"{mechanism.name}: this run needs a damper, regularisation.c > 0")
    first = functions.contact(start)
    force = -first.b / first.p
    slip = abs(first.u - surface_velocity) * _SMOOTHED
    normal = functions.rates(start)[2]
    n, m = functions.coordinates, len(start)
    # M^-1 dy/dq = G_N moves y by C: down to the depth of both springs.
    depth = epsilon**2 * force * (1 / series + 1 / own)
    places = [q - along * depth / first.C for q, along in zip(start[:n], normal[n : 2 * n], strict=True)]
    beginning = [*places, *start[n:], -(epsilon**2) * force / series]

    def rate(_: float, values: Sequence[float]) -> list[float]:
        state, inner = values[:m], values[m]
        contact = functions.contact(state)
        size = max(0.0, own * (inner - contact.y) / epsilon**2)
        friction = -contact.mu * size * math.tanh((contact.u - surface_velocity) / slip)
        free, tangent, upward = functions.rates(state)
        rates = [f + friction * t + size * g for f, t, g in zip(free, tangent, upward, strict=True)]
        return [*rates, -(series * inner / epsilon**2 + size) * epsilon / damper]

    found = solve_ivp(
        rate, (0, until), beginning, method="LSODA", rtol=_TOLERANCE, atol=1e-13, max_step=until / _ROWS
    )  # fmt: skip
    if not found.success:
        raise SceneError(f"scipy's LSODA gives up at ε = {epsilon:g}: {found.message}")
    states = [column[:m].tolist() for column in found.y.T]
    depths = [float(column[m]) for column in found.y.T]
    forces = [max(0.0, inner - functions.contact(state).y) for inner, state in zip(depths, states, strict=True)]
    return Simulated(found.t.tolist(), states, forces)
