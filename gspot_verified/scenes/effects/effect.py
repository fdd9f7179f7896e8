"""What an effect is: states, parameters, equations, events, and what leaving it out assumes."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field

from flint import fmpq

from gspot_verified.expansion.expressions import Expression
from gspot_verified.scenes.effects.terms import FLIGHT, SLIP, STICK, Terms
from gspot_verified.scenes.scaled_system import PhaseEvent


def no_events(_: Terms) -> tuple[PhaseEvent, ...]:
    """None."""
    return ()


def no_rates(_: Terms) -> dict[str, Expression]:
    """None."""
    return {}


@dataclass(frozen=True)
class Effect:
    """One effect. ``rates`` gives the equations of its own states and of no others.

    ``phases``: those in which its states are integrated, and ``opens``: the phases that exist because of it.
    ``parameters``: defaults; ``needs``: effects without which it means nothing; ``left_out``: one line.
    """

    name: str
    left_out: str
    states: tuple[str, ...] = ()
    parameters: Mapping[str, fmpq] = field(default_factory=dict)
    rates: Callable[[Terms], dict[str, Expression]] = no_rates
    events: Callable[[Terms], tuple[PhaseEvent, ...]] = no_events
    needs: tuple[str, ...] = ()
    opens: tuple[str, ...] = ()
    phases: tuple[str, ...] = (SLIP, STICK, FLIGHT)
