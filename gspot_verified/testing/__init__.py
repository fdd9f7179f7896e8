"""Tests that users run on their own mechanisms. The strategies need ``hypothesis``; nothing else here does."""

from gspot_verified.testing.examples import extended_example, in_units, sheared
from gspot_verified.testing.laws import (
    check_expansion,
    check_lie_derivatives,
    check_spaces,
    check_synchronisation,
    check_trajectory,
)
from gspot_verified.testing.strategies import polynomials, rationals, states, systems

__all__ = [
    "check_expansion",
    "check_lie_derivatives",
    "check_spaces",
    "check_synchronisation",
    "check_trajectory",
    "extended_example",
    "in_units",
    "polynomials",
    "rationals",
    "sheared",
    "states",
    "systems",
]
