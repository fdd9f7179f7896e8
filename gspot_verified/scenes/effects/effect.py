"""What an effect is: states, parameters, equations, events, and what leaving it out assumes of the true motion."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field

from flint import fmpq

from gspot_verified.functions.expressions import Expression
from gspot_verified.scenes.equations.model_terms import ModelTerms
from gspot_verified.scenes.equations.motion import Motion
from gspot_verified.scenes.equations.scaled_system import PhaseEvent
from gspot_verified.scenes.equations.terms import PHASES, Terms


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
class Condition:
    """What must hold along the true motion where an effect is left out.

    ``events``: where it ends to hold, as events of the full scene: their functions stay positive as long as it holds. A
    motion without the effect is that of the full scene up to the first of them. ``of_model``: whether that is asked of
    the model system, too; otherwise the model has it by definition.
    """

    text: str
    events: Callable[[Terms], tuple[PhaseEvent, ...]]
    of_model: bool = True


@dataclass(frozen=True)
class Effect:
    """One effect. ``parameters`` and ``model_parameters`` hold defaults.

    ``sees``: functions that it needs to know (u, x): of a mechanism those components are integrated on which they
    depend. ``opens``: the phases that exist because of it; ``needs``: effects without which it means nothing,
    ``needs_in_model``: in the model system; ``not_with_mechanism``: why it has no place beside a mechanism.

    ``left_out``: one line on what its absence means; ``left_out_of``: the same for one motion, where that is another
    line; ``condition``: what its absence assumes of the motion, None: nothing.
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
    needs_in_model: tuple[str, ...] = ()
    not_with_mechanism: str | None = None
    left_out_of: Callable[[Motion], str | None] = lambda _: None
    condition: Condition | None = None
