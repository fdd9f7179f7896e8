"""Rigid slip of a mechanism whose p, b and α's depend on two components of the state, which move by themselves.

Proof page: ``proofs/fates.md``, section 1.
"""

from __future__ import annotations

from collections.abc import Sequence

from flint import arb

from gspot_verified.functions.box_program import BoxProgram
from gspot_verified.functions.derivative import lie_derivative, substitute
from gspot_verified.functions.expressions import Constant, Expression, Variable
from gspot_verified.integrator.field.field import VectorField
from gspot_verified.mechanisms.approach.slip_flow import ClosedFlow, Numbers, SlipFlow
from gspot_verified.mechanisms.derive.slip_hypotheses import SlipHypotheses
from gspot_verified.mechanisms.derive.to_system import Shifted
from gspot_verified.mechanisms.input.mechanism import MechanismError
from gspot_verified.mechanisms.spots.spot_conditions import components_of
from gspot_verified.numbers.evidence import every, less
from gspot_verified.numbers.verdict import Evidence

_SIZE = 2  # components of the plane


class PlanarFlow:
    """The plane: the flow of its two components, and the rates of u, which are functions of them.

    :raises MechanismError: the flow is not planar in this sense; the message says why.
    """

    def __init__(self, shifted: Shifted) -> None:
        whole, name = SlipFlow.of(shifted), shifted.mechanism.name
        self._hypotheses = SlipHypotheses(shifted)
        self._dimension = whole.dimension
        self.components = _closed(whole, [whole.p, whole.b, whole.alpha_1, whole.alpha_2, whole.alpha_3])
        if len(self.components) != _SIZE:
            words = ", ".join(shifted.mechanism.state[i] for i in self.components)
            raise MechanismError(
                f"{name}: a sweep over states needs a flow in which p, b and the alphas depend on two components; here "
                f"on {words}"
            )
        self.flow = self._part(whole)
        rates = [lie_derivative(whole.u, field) for field in (whole.F, whole.G)]
        left = [i for i in range(whole.dimension) if i not in self.components and not _place(whole, i)]
        others = [rate for i in left for rate in (whole.F[i], whole.G[i])]
        used = self._hypotheses.components.union(*(components_of(each) for each in (*rates, *others)))
        if not used <= set(self.components):
            word = shifted.mechanism.state[min(used - set(self.components))]
            raise MechanismError(
                f"{name}: a sweep over states needs slip, friction, masses and the other components to move by the two "
                f"on which p and b depend; here something depends on {word}, too"
            )
        u_F, u_G = (self._own(rate) for rate in rates)
        flow = self.flow
        self.by_log_p = VectorField([-(rate / flow.alpha_1) for rate in flow.slowed()])
        self.rates = BoxProgram(self.by_log_p.functions, _SIZE)
        self.p_and_b = BoxProgram([flow.p, flow.b], _SIZE)
        self.alphas = BoxProgram([flow.alpha_1, flow.alpha_2, flow.alpha_3], _SIZE)
        self.slip_rate = BoxProgram([(flow.p * u_F - flow.b * u_G) / flow.alpha_1], _SIZE)
        """p du/dp along slip."""
        self._others = BoxProgram([self._own(rate) for rate in others], _SIZE)
        self._with_slip = BoxProgram(
            [flow.p, flow.b, Variable(_SIZE), flow.alpha_1, flow.alpha_2, flow.alpha_3, *flow.F, u_F, *flow.G, u_G],
            _SIZE + 1,
        )
        self.u = BoxProgram([whole.u], whole.dimension)

    def _own(self, function: Expression) -> Expression:
        first, second = self.components
        numbers = {first: Variable(0), second: Variable(1)}
        return substitute(function, [numbers.get(i, Variable(i)) for i in range(self._dimension)])

    def _part(self, whole: SlipFlow) -> ClosedFlow:
        return ClosedFlow(
            tuple(self._own(whole.F[i]) for i in self.components),
            tuple(self._own(whole.G[i]) for i in self.components),
            *map(self._own, (whole.p, whole.b, whole.alpha_1, whole.alpha_2, whole.alpha_3)),
        )

    def of_state(self, state: Sequence[arb]) -> list[arb]:
        """The two components of a state."""
        return [state[i] for i in self.components]

    def on(self, box: Sequence[arb]) -> Numbers:
        """On a box of the two components and u, as a flow of three."""
        return Numbers.of(self._with_slip.values(list(box)))

    def supposed(self, box: Sequence[arb]) -> Evidence | str:
        """What is supposed of every state on the way: alpha_1 < 0, a positive definite mass matrix, mu >= 0, finite
        rates of all other components; or in words what is not certain."""
        first = self.alphas.mean_values(list(box))[0]
        falls = less(first, 0)
        if falls is None:
            return "p may not fall on the way"
        if not all(rate.is_finite() for rate in self._others.values(list(box))):
            return "the rates of other components may not be finite on the way"
        checked = self.sense(box)
        return checked if isinstance(checked, str) else every([falls, checked]) or "p may not fall on the way"

    def sense(self, box: Sequence[arb]) -> Evidence | str:
        """What p and b mean something by: a positive definite mass matrix, mu >= 0; or in words what is not certain."""
        whole = [arb(0)] * self._dimension  # the other components do not matter there
        for place, side in zip(self.components, box, strict=True):
            whole[place] = side
        return self._hypotheses.checked(whole)


def _closed(flow: SlipFlow, functions: Sequence[Expression]) -> tuple[int, ...]:
    """The fewest components that hold all on which these functions and their own F and G depend, in order."""
    found = frozenset[int]().union(*(components_of(function) for function in functions))
    while True:
        more = found.union(*(components_of(rate) for i in found for rate in (flow.F[i], flow.G[i])))
        if more == found:
            return tuple(sorted(found))
        found = more


def _place(flow: SlipFlow, i: int) -> bool:
    """Whether the component is a place whose rate is another component."""
    F, G = flow.F[i], flow.G[i]
    return isinstance(F, Variable) and isinstance(G, Constant) and G.value == 0
