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

EXCLUSIONS: dict[tuple[str, str], str] = {
    **{("mechanism", name): effect.not_with_mechanism for name, effect in EFFECTS.items() if effect.not_with_mechanism},
    ("mechanism", "nu"): "nu measures b by the model's trivial solution; give components of the state",
    ("stick", "k_minus <= k_plus"): "their difference is 2 mu A, which is positive for friction",
}
"""What cannot be in one scene, and why; what an effect cannot do without stands with the effect."""

OUTSIDE: dict[str, str] = {
    "impact_law": "the contact is compliant, with a stiffness of the order of 1/epsilon^2: what an impact does is "
    "integrated, and a law of impact would be a second answer",
    "joint_friction": "it follows the force in the joint, which depends on lambda_N: then L_GN u and L_GT v differ, "
    "and the equations change where that force changes its sign",
    "second_contact": "two contacts with friction have a matrix in the place of p = C - mu B, and no G-spot in the "
    "sense of the paper",
    "slip_in_space": "the direction of slip turns with lambda_N, so L_G p does not vanish (eq. lagrangian2)",
}
"""What the literature has and no effect is, and why; the page ``docs/outside.md`` says more."""
