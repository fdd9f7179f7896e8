"""A belt: the surface moves along itself with a constant velocity, and the contact sticks at that velocity."""

from __future__ import annotations

from flint import fmpq

from gspot_verified.scenes.effects.effect import Effect

EFFECT = Effect(
    "belt",
    "the surface is at rest: the contact sticks at u = 0",
    parameters={"belt_velocity": fmpq(0)},
    needs=("stick",),
)
