"""All parts of the chapter, in its order."""

from __future__ import annotations

from gspot_verified.cost.measurement.contest import Blueprint, TimedRoute
from gspot_verified.cost.parts import scene_runs
from gspot_verified.cost.parts.checked_proofs import CHECKER, FORMAL
from gspot_verified.cost.parts.expansion_orders import EXPANSIONS
from gspot_verified.cost.parts.sign_ranges import SIGNS
from gspot_verified.cost.parts.slow_solution_digits import FINITE_EPSILON
from gspot_verified.cost.parts.theta_digits import THETA
from gspot_verified.cost.parts.theta_routes import ROUTES
from gspot_verified.cost.parts.zero_parts import ATLAS, BRACKETS


def blueprints(full: bool) -> tuple[Blueprint, ...]:
    """The parts, for the small or the full size."""
    scenes = scene_runs.blueprint(full)
    return (THETA, ROUTES, SIGNS, ATLAS, BRACKETS, EXPANSIONS, FINITE_EPSILON, scenes, CHECKER, FORMAL)


def contestants_of(key: str) -> tuple[TimedRoute, ...]:
    """The contestants of one part, with those of the full size.

    :raises ValueError: there is no such part.
    """
    matches = [blueprint for blueprint in blueprints(True) if blueprint.key == key]
    if not matches:
        raise ValueError(f"part: expected one of {', '.join(b.key for b in blueprints(True))}, got {key!r}")
    return matches[0].contestants()
