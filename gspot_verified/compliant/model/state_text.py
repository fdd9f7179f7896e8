"""An initial state as text, p,b,y,v,z."""

from __future__ import annotations

from gspot_verified.compliant.model.normal_form import CompliantState, compliant_state


def state_from_text(text: str) -> CompliantState:
    """The state from five numbers between commas.

    :raises ValueError: not five numbers; z <= y.

    >>> state_from_text("1/2, -0.1, -2e-6, 0, -1e-6").p
    1/2
    """
    parts = text.split(",")
    if len(parts) != 5:
        raise ValueError(f"state: expected five numbers p,b,y,v,z, got {len(parts)}")
    p, b, y, v, z = parts
    return compliant_state(p, b, y, v, z)
