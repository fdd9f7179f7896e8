"""Moreau's and Jean's time stepping with Coulomb friction and no rebound: impulses at the end of each step.

J. J. Moreau, Unilateral contact and dry friction in finite freedom dynamics (1988), with the matrices at the middle of
the step. Of one contact all solutions are listed: free, slip to either side, stick. Where there are several the step
takes the first that keeps the contact, or leaves it, as it is told; where there is none it goes on free.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from gspot_verified.scenes.simulators.contact_floats import Contact, ContactFloats
from gspot_verified.scenes.simulators.simulated import Simulated


def moreau_jean(
    functions: ContactFloats,
    start: Sequence[float],
    *,
    step: float,
    until: float,
    surface_velocity: float = 0.0,
    stays: bool = True,
) -> Simulated:
    """The motion from ``start``; ``stays``: of several solutions of a step one that keeps the contact."""
    n = functions.coordinates
    state, time = list(start), 0.0
    # The steps lift a curved contact by O(h): within the way of one step the contact counts as closed.
    margin = step * abs(functions.contact(start).u - surface_velocity)
    times, states, forces = [time], [list(state)], [1.0]
    while time < until:
        middle = _moved(state, n, step / 2)
        free, tangent, normal = functions.rates(middle)
        middle[n : 2 * n] = [v + step * rate for v, rate in zip(state[n : 2 * n], free[n : 2 * n], strict=True)]
        contact = functions.contact(middle)
        impulse, friction = 0.0, 0.0
        if contact.y <= margin:
            found = solutions(replace(contact, u=contact.u - surface_velocity))
            if found:
                impulse, friction = found[-1] if stays else found[0]
        state = _moved(state, n, step / 2)
        state[n : 2 * n] = [
            v + impulse * along_n + friction * along_t
            for v, along_n, along_t in zip(middle[n : 2 * n], normal[n : 2 * n], tangent[n : 2 * n], strict=True)
        ]
        state = _moved(state, n, step / 2)
        time += step
        times.append(time)
        states.append(list(state))
        forces.append(impulse / step)
    return Simulated(times, states, forces)


def solutions(contact: Contact) -> list[tuple[float, float]]:
    """The pairs (normal, tangential) of impulses after which the velocities obey Signorini's and Coulomb's laws.

    First the free one, last those in contact: stick, then slip on.
    """
    A, B, C, u, v, mu = contact.A, contact.B, contact.C, contact.u, contact.v, contact.mu
    found = [(0.0, 0.0)] if v >= 0 else []
    for sign in (-1, 1):  # slip to the left, with the friction to the right; then to the right
        p = C - sign * mu * B
        if p != 0 and (size := -v / p) > 0 and sign * (u + (B - sign * mu * A) * size) >= 0:
            found.append((size, -sign * mu * size))
        if sign < 0:
            determinant = A * C - B * B
            normal, tangential = (B * u - A * v) / determinant, (B * v - C * u) / determinant
            if normal > 0 and abs(tangential) <= mu * normal:
                found.append((normal, tangential))
    return found


def _moved(state: Sequence[float], n: int, time: float) -> list[float]:
    """The coordinates along their velocities, and time itself, where it is a component."""
    places = [q + time * v for q, v in zip(state[:n], state[n : 2 * n], strict=True)]
    return [*places, *state[n : 2 * n], *(t + time for t in state[2 * n :])]
