"""The state at lift-off, from a bracket of its time and the state at the lower end.

Proof page: ``proofs/flight.md``, section 7.
"""

from __future__ import annotations

from flint import arb, fmpq

from gspot_verified.compliant.model.flight import ContactState
from gspot_verified.compliant.model.force_result import CompliantForce
from gspot_verified.numbers.balls import add_remainder, hull, nonfinite, working_bits


def contact_state(value: CompliantForce, bits: int) -> ContactState:
    """The state in contact at one time, in the normal form without hats."""
    model = value.model
    sigma, small = model.sigma, model.scaled_epsilon
    with working_bits(bits):
        return ContactState(
            beta=model.beta,
            epsilon=small,
            alpha_2=model.alpha_2 * sigma**3,
            p=arb(value.p),
            b=value.b * sigma**2,
            V=value.v * sigma / small,
            Y=value.y / small**2,
            force=value.force * sigma**2,
        )


def lift_off_state(before: ContactState, duration: fmpq, bits: int) -> ContactState:
    """A ball of the state at lift-off, which happens within ``duration`` (as T) after ``before``: lambda = 0, Y = Z.

    Not finite when the a-priori enclosure fails: ``duration`` is then too long.
    """
    with working_bits(bits):
        b, V, _, Z = contact_box(before, duration, bits)
        p = _places(before, duration)
        return ContactState(
            beta=before.beta, epsilon=before.epsilon, alpha_2=before.alpha_2, p=p, b=b, V=V, Y=Z, force=arb(0)
        )


def contact_box(before: ContactState, duration: fmpq, bits: int) -> list[arb]:
    """b, V, Y, Z as balls that hold the contact phase for ``duration`` (as T) after ``before``; not finite when the
    a-priori enclosure fails."""
    with working_bits(bits):
        first = (before.b, before.V, before.Y, before.Y + before.force)
        p = _places(before, duration)
        # Twice the way at the starting rates, and a little: any radius is right that passes the check.
        radii = [
            (2 * duration * abs(rate) + abs(x) * arb(2) ** -bits + arb(2) ** -bits * arb(duration)).abs_upper()
            for rate, x in zip(_rates(before, p, *first), first, strict=True)
        ]
        box = [add_remainder(x, radius) for x, radius in zip(first, radii, strict=True)]
        rates = _rates(before, p, *box)
        if not all(duration * abs(rate) < radius for rate, radius in zip(rates, radii, strict=True)):
            return [nonfinite()] * len(box)
        return box


def _places(before: ContactState, duration: fmpq) -> arb:
    return hull([before.p, before.p - before.epsilon * duration])


def _rates(state: ContactState, p: arb, b: arb, V: arb, Y: arb, Z: arb) -> tuple[arb, arb, arb, arb]:
    """b', V', Y', Z' of the contact phase."""
    force = Z - Y
    return state.epsilon * (state.alpha_2 + state.beta * force), b + p * force, V, -Z - force
