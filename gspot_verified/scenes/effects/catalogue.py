"""All effects by their names."""

from __future__ import annotations

from gspot_verified.scenes.effects import (
    belt,
    compliant_contact,
    lift_off,
    stick,
    tangential_motion,
    tangential_place,
    two_way_coupling,
)
from gspot_verified.scenes.effects.effect import Effect

EFFECTS: dict[str, Effect] = {
    module.EFFECT.name: module.EFFECT
    for module in (compliant_contact, lift_off, tangential_motion, tangential_place, stick, belt, two_way_coupling)
}
"""In the order in which their states follow the mechanism's."""
