"""What an effect is: states, parameters, equations, events, and what leaving it out assumes."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field

from flint import fmpq

from gspot_verified.expansion.expressions import Expression
from gspot_verified.scenes.effects.model_terms import ModelTerms
from gspot_verified.scenes.effects.terms import PHASES, Terms
from gspot_verified.scenes.scaled_system import PhaseEvent


@dataclass(frozen=True)
class States:
    """States with their equations: ``rates`` gives those of these states and of no others.

    ``phases``: those in which they are integrated.
    """

    names: tuple[str, ...]
    rates: Callable[[Terms], dict[str, Expression]]
    phases: tuple[str, ...] = PHASES


@dataclass(frozen=True)
class ModelStates:
    """The same for states of the model system; a mechanism has its own in their place."""

    names: tuple[str, ...]
    rates: Callable[[ModelTerms], dict[str, Expression]]
    phases: tuple[str, ...] = PHASES


@dataclass(frozen=True)
class Effect:
    """One effect. ``parameters`` and ``model_parameters`` hold defaults.

    ``sees``: functions that it needs to know (u, x): of a mechanism those components are integrated on which they
    depend. ``opens``: the phases that exist because of it; ``needs``: effects without which it means nothing;
    ``not_with_mechanism``: why it has no place beside a mechanism; ``left_out``: one line.
    """

    name: str
    left_out: str
    states: States | None = None
    model_states: ModelStates | None = None
    parameters: Mapping[str, fmpq] = field(default_factory=dict)
    model_parameters: Mapping[str, fmpq] = field(default_factory=dict)
    events: Callable[[Terms], tuple[PhaseEvent, ...]] = lambda _: ()
    sees: tuple[str, ...] = ()
    opens: tuple[str, ...] = ()
    needs: tuple[str, ...] = ()
    not_with_mechanism: str | None = None
