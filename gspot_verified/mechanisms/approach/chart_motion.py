"""An explicit epsilon_0 for mechanisms whose p, b, y, v are functions of the state: by a chart at the G-spot.

Proof page: ``proofs/chart.md``.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import reduce
from typing import NamedTuple

from flint import arb

from gspot_verified.expansion.chart.chart import Chart, Region
from gspot_verified.expansion.chart.radius import radius
from gspot_verified.expansion.chart.taylor_rest import covered
from gspot_verified.expansion.from_state.affine_side import AffineSide, affine_side
from gspot_verified.expansion.from_state.affine_system import AffineSystem
from gspot_verified.expansion.from_state.analytic import Analytic
from gspot_verified.expansion.series.system import System
from gspot_verified.functions.box_program import BoxProgram
from gspot_verified.functions.derivative import rewritten
from gspot_verified.functions.expressions import Expression, Variable
from gspot_verified.mechanisms.approach.approach_plan import state_to_start_from
from gspot_verified.mechanisms.approach.mechanism_side import MechanismSide
from gspot_verified.mechanisms.derive.component_names import component, names_of_other_things
from gspot_verified.mechanisms.derive.slip_hypotheses import SlipHypotheses
from gspot_verified.mechanisms.derive.slip_loss import SlipLoss
from gspot_verified.mechanisms.derive.to_system import Shifted
from gspot_verified.mechanisms.input.mechanism import Mechanism
from gspot_verified.mechanisms.spots.chosen_spot import at_spot
from gspot_verified.mechanisms.spots.g_spot import GSpot, find_g_spot
from gspot_verified.numbers.balls import add_remainder, ball, ball_text, exact, float_bounds, rounded_text, working_bits
from gspot_verified.numbers.evidence import every, less
from gspot_verified.numbers.inner_text import in_inner_interval
from gspot_verified.numbers.verdict import Reason, Verdict

_ORDER = 4  # of what a Taylor polynomial of an alpha leaves: any from 2 on is right
_COMPONENTS = 4  # p, b, y, v are coordinates of so many
_BITS = 256  # of a G-spot that is not rational
_HELD = "; the mass matrix is positive definite and mu >= 0 all the way"
_ROOM, _ROOM_OF_FORCE = arb((1, -11)), arb((1, -14))  # of p and -b/p, in parts of those of the path: any are right


def with_chart(found: MechanismSide, mechanism: Mechanism, spot: int | None = None) -> MechanismSide:
    """The same with ``explicit`` for the starts around a state of rigid slip near the G-spot, on the way that
    :func:`mechanism_side` followed, where the contact depends on four components alone; or with the reason why not."""
    known = found.explicit is not None and found.explicit.side is not None
    if found.side is None or known:
        return found
    if len(found.active) != _COMPONENTS:
        return replace(
            found, not_explicit=f"the contact depends on {len(found.active)} components: {', '.join(found.active)}"
        )
    active, path = [mechanism.state.index(word) for word in found.active], found.approach.path
    try:
        place = find_g_spot(at_spot(mechanism, spot), _BITS)
        with working_bits(place.bits):
            chart = Chart(restricted(place, active))
            number = state_to_start_from(path.p, radius(chart))
            p = add_remainder(path.p[number], path.p[number] * _ROOM)
            force = add_remainder(path.force[number], path.force[number] * _ROOM_OF_FORCE)
            system = _charted(chart)
        explicit = affine_side(system, p, -force * p, quotient=force)
    except (ValueError, ZeroDivisionError) as error:  # beside the theorem
        return replace(found, not_explicit=str(error))
    with working_bits(place.bits):
        at = _At(path.p[number], path.b[number], path.force[number], path.states[number])
        explicit = _checked(place.shifted, explicit, active, at)
    time = ball_text(path.time[number], 6)
    return replace(found, explicit=explicit, reached=time)


def _charted(chart: Chart) -> AffineSystem:
    """The alphas as functions of p, b, y, v."""
    system = chart.system
    first, second, third = (
        Analytic(function, _ORDER, name, chart)
        for name, function in (
            ("alpha_1", system.alpha_1), ("alpha_2", system.alpha_2), ("alpha_3", system.alpha_3),
        )
    )  # fmt: skip
    return AffineSystem(first, second, third, system.regularisation, chart)


def restricted(place: GSpot, active: Sequence[int]) -> System:
    """The system of these components, on which p, b, y, v, the alphas and their own rates depend alone."""
    whole, mechanism = place.system, place.mechanism
    scalars = (whole.y, whole.v, whole.p, whole.b, whole.alpha_1, whole.alpha_2, whole.alpha_3)
    functions = [*(whole.F[i] for i in active), *(whole.G[i] for i in active), *scalars]
    table: dict[Expression, Expression] = {Variable(i): Variable(k) for k, i in enumerate(active)}
    own_functions = rewritten(functions, lambda node: table[node] if isinstance(node, Variable) else None)
    own = [own_functions[function] for function in functions]
    y, v, p, b, first, second, third = own[2 * len(active) :]
    references = {angle.coordinate: angle.name for angle in mechanism.angles}
    others = names_of_other_things(place.shifted)
    named = [(word, component(word, others)) for word in (mechanism.state[i] for i in active)]
    return System(
        name=whole.name,
        F=tuple(own[: len(active)]),
        G=tuple(own[len(active) : 2 * len(active)]),
        y=y,
        v=v,
        p=p,
        b=b,
        alpha_1=first,
        alpha_2=second,
        alpha_3=third,
        J=(),
        point=tuple(whole.point[i] for i in active),
        ring=whole.ring,
        state=tuple(f"{name} - {references[word]}" if word in references else name for word, name in named),
        regularisation=whole.regularisation,
    )


class _At(NamedTuple):
    """Rigid slip at one time."""

    p: arb
    b: arb
    force: arb
    state: Sequence[arb]


def _checked(shifted: Shifted, side: AffineSide, active: Sequence[int], at: _At) -> AffineSide:
    """The same, if the state of the path is one of the starts as they are written, and the mechanism's hypotheses hold
    on the way."""
    system, way = side.start.manifold.system, side.way
    if way is None or system.chart is None or side.verdict.evidence is None:
        return side
    written = [*(ball(one) for one in (side.start.p, side.start.b, side.start.force)), *way.starts.around]
    path = [at.p, at.b, at.force, *(at.state[i] for i in active)]
    among = every(in_inner_interval(value, one) for value, one in zip(path, written, strict=True))
    if among is None:
        return _open(side, "the state of rigid slip is not certainly among the starts")
    hypotheses, shown = SlipHypotheses(shifted), [side.verdict.evidence, among]
    if not hypotheses.components <= set(active):
        return _open(side, "the hypotheses on the mechanism depend on further components")
    boxes = covered(system.chart, way.cone)
    if boxes is None:
        return _open(side, "p, b, y, v are not certainly coordinates of the state on the way")
    slowest = slowest_fall(system.chart, [region for _, region in boxes])
    if slowest is None:
        return _open(side, "p does not certainly fall on the way")
    states = [_whole(shifted, active, box) for box in (*(region.states for _, region in boxes), way.after)]
    for box in states:
        checked = hypotheses.checked(box)
        if isinstance(checked, str):
            return _open(side, checked)
        shown.append(checked)
    evidence = every(shown)
    if evidence is None:
        return _open(side, "the hypotheses on the mechanism are not certain")
    time = ball(side.start.p) / slowest + way.later
    latest = rounded_text(float_bounds(time)[1], 1)
    lost, kept = _lost(shifted, active, states, time), ""
    if lost is not None:
        kept = f"; slip stays positive if it exceeds {lost} at the start"
        way = replace(way, lost=exact(lost, "lost"))
    by = f"{_HELD}{kept}; all this within a time of {latest} from the start on"
    return replace(side, way=way, verdict=Verdict.proved(side.verdict.statement + by, evidence))


def _lost(shifted: Shifted, active: Sequence[int], boxes: Sequence[Sequence[arb]], time: arb) -> str | None:
    """A decimal number above the slip that is lost in these states up to this time; None: none is known."""
    loss = SlipLoss(shifted)
    lost = loss.largest(boxes, time) if loss.components <= set(active) else None
    return None if lost is None else rounded_text(float_bounds(lost)[1], 1)


def _whole(shifted: Shifted, active: Sequence[int], known: Sequence[arb]) -> list[arb]:
    """A state with these components; the others do not matter."""
    whole = [arb(0)] * len(shifted.mechanism.state)
    for i, value in zip(active, known, strict=True):
        whole[i] = value
    return whole


def slowest_fall(chart: Chart, regions: Sequence[Region]) -> arb | None:
    """A positive number that -alpha_1 exceeds on all regions; None: it is not certain."""
    program, found = BoxProgram([chart.system.alpha_1], len(chart.system.point)), list[arb]()
    for region in regions:
        (rate,) = program.mean_values(list(region.states))
        if less(rate, 0) is None:
            return None
        found.append((-rate).lower())
    return reduce(arb.min, found)


def _open(side: AffineSide, why: str) -> AffineSide:
    verdict = Verdict.undecided(side.verdict.statement, Reason.HYPOTHESIS, why)
    return replace(side, side=None, verdict=verdict)
