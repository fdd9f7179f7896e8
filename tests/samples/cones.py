"""Cones of Theorem U2 of which a test needs the rate alone."""

from __future__ import annotations

from flint import arb

from gspot_verified.expansion.true_solutions.growth import DeviationCone


def cone_of(rate: arb | int | str) -> DeviationCone:
    """A cone that grows with this rate."""
    return DeviationCone(arb(rate), arb(1), arb(1), arb(1), (), arb(0), arb(1))
