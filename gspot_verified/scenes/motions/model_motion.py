"""The model system and the extended example (paper, Secs. 2.3, 2.4): states b, and those that effects bring."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from flint import arb, fmpq

from gspot_verified.functions.expressions import Expression
from gspot_verified.scenes.effects import model
from gspot_verified.scenes.effects.effect import Effect, ModelStates
from gspot_verified.scenes.equations.model_terms import ModelTerms
from gspot_verified.scenes.equations.motion import SceneError
from gspot_verified.scenes.equations.terms import Terms


class ModelMotion:
    """``start``: p, b or nu (b = -nu p |alpha_2/(alpha_3 - alpha_1)|), y, v, z or none of them; u, x if integrated."""

    is_model = True
    depends_on_place = False
    """No equation of the paper's systems has x on its right."""

    def __init__(self, effects: Sequence[Effect], epsilon: fmpq, start: Mapping[str, fmpq]) -> None:
        self._effects, self._epsilon, self._start = tuple(effects), epsilon, start
        self.parameters: Mapping[str, fmpq] = {
            **model.PARAMETERS,
            **{name: value for effect in effects for name, value in effect.model_parameters.items()},
        }

    def _parts(self) -> tuple[ModelStates, ...]:
        return (model.MODEL, *(effect.model_states for effect in self._effects if effect.model_states is not None))

    def states(self, phase: str) -> tuple[str, ...]:
        """b, then those of the effects."""
        return tuple(name for part in self._parts() if phase in part.phases for name in part.names)

    def terms(self, phase: str, states: tuple[str, ...], values: Mapping[str, fmpq]) -> ModelTerms:
        """The functions of one phase."""
        return ModelTerms(phase, states, self._epsilon, values, self.start(values)["p"])

    def rates(self, terms: Terms) -> dict[str, Expression]:
        """The equations, each by the effect that brings the state."""
        assert isinstance(terms, ModelTerms)
        parts = [part for part in self._parts() if terms.phase in part.phases]
        return {name: rate for part in parts for name, rate in part.rates(terms).items()}

    def shown(self, terms: Terms) -> dict[str, Expression]:
        """p, b; u and x if they are integrated."""
        assert isinstance(terms, ModelTerms)
        shown = {"p": terms.p, "b": terms.state("b")}
        seen = [name for effect in self._effects for name in effect.sees]
        if "u" in seen:
            shown["u"] = terms.u
        if "x" in seen:
            shown["x"] = terms.state("x")
        return shown

    def start(self, values: Mapping[str, fmpq]) -> dict[str, fmpq]:
        """p, b, y, v, z (u, x), exactly; at rest on the surface where y, v, z are not given.

        At rest: v = 0, y and z where dv/dt = 0 and dz/dt = 0; 2 b epsilon^2/p and y/2 with the paper's stiffness.
        """
        start = dict(self._start)
        factor = start.pop("nu", None)
        needed = ("p", *(name for effect in self._effects for name in effect.sees))
        for name in needed:
            if name not in start:
                raise SceneError(f"start: the state {name} is missing")
        if ("b" in start) == (factor is not None):
            raise SceneError("start: give b or nu, one of them")
        if factor is not None:
            drift = (values["beta"] - 1) * values["alpha_1"]
            if drift == 0:
                raise SceneError("start: nu needs a trivial solution; at beta = 1 there is none: give b")
            start["b"] = -factor * start["p"] * abs(values["alpha_2"] / drift)
        for name in start:
            if name not in ("p", "b", "y", "v", "z", *needed):
                raise SceneError(f"start: this scene has no state {name!r}")
        at_rest = [name for name in "yvz" if name not in start]
        if len(at_rest) not in (0, 3):
            raise SceneError(f"start: the state {at_rest[0]} is missing; give y, v and z, or none of them")
        if at_rest:
            start |= self._at_rest(start, values)
        return start

    def _at_rest(self, start: Mapping[str, fmpq], values: Mapping[str, fmpq]) -> dict[str, fmpq]:
        if start["p"] <= 0:
            raise SceneError(f"start: at rest on the surface p must be > 0, got {start['p']}; give y, v and z")
        depth = self._epsilon**2 * start["b"] / start["p"]
        k_1, k_2 = values["k_1"], values["k_2"]
        return {"y": depth * (1 / k_1 + 1 / k_2), "v": fmpq(0), "z": depth / k_1}

    def enclosed_start(self) -> dict[str, arb]:
        """None: all of them are given."""
        return {}

    def check(self, values: Mapping[str, fmpq]) -> None:
        """Its equations hold everywhere."""

    def normal_acceleration(self, values: Mapping[str, fmpq]) -> fmpq:
        """b."""
        return self.start(values)["b"]

    def painleve_parameter(self, values: Mapping[str, fmpq]) -> fmpq:
        """p."""
        return self.start(values)["p"]

    def slip_velocity(self, values: Mapping[str, fmpq]) -> fmpq:
        """u."""
        return self.start(values)["u"]
