"""A belt: the surface moves along itself with a constant velocity, and the contact sticks at that velocity.

Without it the surface is at rest: that is what the scene is about, and nothing of the motion is assumed. With it, and
without tangential motion, the velocity need not be given: then it is some velocity below u, and a run says so.
"""

from __future__ import annotations

from flint import fmpq

from gspot_verified.scenes.effects.effect import Effect

EFFECT = Effect(
    "belt",
    "the surface is at rest: the contact sticks at u = 0",
    parameters={"belt_velocity": fmpq(0)},
    needs_in_model=("stick",),
)
