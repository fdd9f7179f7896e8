"""From a state near a G-spot to lift-off or impact, for every epsilon up to epsilon_0: alphas that depend on the state.

Proof page: ``proofs/from_state.md``, the theorem of section 8.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace
from functools import cache, reduce
from itertools import product
from typing import ClassVar, NamedTuple

from flint import arb, fmpq

from gspot_verified.expansion.chart.chart import Chart, Region
from gspot_verified.expansion.chart.cone import Cone, joined_cones, rational_of, ray_of
from gspot_verified.expansion.from_state.affine_hand_over import affine_hand_over
from gspot_verified.expansion.from_state.affine_system import Affine, AffineSystem
from gspot_verified.expansion.from_state.affine_tube import AffineStart, AffineTube, Sums, affine_tube
from gspot_verified.expansion.from_state.choice import (
    LARGEST,
    LARGEST_DELTA,
    Plan,
    affine_plans,
    largest_delta,
    near,
    reach_for,
)
from gspot_verified.expansion.from_state.fast_growth import Growth, Norm, Rectangle, fast_growth
from gspot_verified.expansion.from_state.hand_over import HandOver
from gspot_verified.expansion.from_state.passage import checked_ratio, rounded_up
from gspot_verified.expansion.from_state.slow_manifold import Cut, SlowManifold, slow_manifold
from gspot_verified.expansion.from_state.slow_series import Contact, contact_text
from gspot_verified.expansion.trajectory import expand_system
from gspot_verified.expansion.true_solutions.bound import BITS, rational
from gspot_verified.expansion.true_solutions.delta_ranges import in_ranges, smallest
from gspot_verified.expansion.true_solutions.equations import DeviationEquations, Residuals
from gspot_verified.expansion.true_solutions.side import end_of_track
from gspot_verified.expansion.true_solutions.side_end import SideEnd, first_end, joined
from gspot_verified.expansion.true_solutions.track import track
from gspot_verified.numbers.balls import Exact, ExactInput, ball, ball_text, exact, hull, working_bits
from gspot_verified.numbers.evidence import differ, every
from gspot_verified.numbers.inner_text import inner_text
from gspot_verified.numbers.verdict import NoTruthValue, Reason, Verdict
from gspot_verified.numbers.written import Written

_ORDER = 10  # of the expansion
_RATIOS = (fmpq(21, 20), fmpq(6, 5), fmpq(2))  # nu: how far C_1 may move on the way; any number above 1 is right
_WEIGHT = 8  # J: up to which powers of r the slow manifold is right; any is allowed
_FINER = 8  # from level to level of the delta for which residuals are bounded
_FINE_BITS = 256  # of a slow manifold in balls, lost in its rounds
_DIGITS = 30  # of an expansion in balls
_LEAST_ORDER = 1  # of a slow manifold: L_0 is the same with each
_FINENESS = 2**64  # e is rounded to multiples of 1/_FINENESS
_PIECES = 16  # of p on the way from the G-spot to the start: any number is right
_BEYOND = fmpq(101, 100)  # of h_1 over its value at s = -S as delta tends to 0


@dataclass(frozen=True)
class ChartedWay:
    """With a chart: ``cone`` holds p, b, y, v from all starts up to the hand-over, ``starts`` their states: those of
    its box ``around`` with these p, b, y, v; ``after`` holds the states from the hand-over to the end that the side
    tells, and ``later`` bounds the time between them, for every epsilon. Slip that exceeds ``lost`` at a start stays
    positive up to the end, if it is known."""

    cone: Cone
    starts: Region
    after: tuple[arb, ...]
    later: arb
    lost: Exact | None = None


class _Passed(NamedTuple):
    """Of one range of epsilon: the cone that holds p, b, y, v, and a bound of the time from the hand-over to the
    end."""

    cone: Cone
    later: arb


@dataclass(frozen=True)
class AffineSide(NoTruthValue, Written):
    """What becomes of all starts in a stated set, for every epsilon in (0, ``epsilon``] at once; alpha_i of p, b, y, v.

    ``side``: "lift-off" (lambda_N > 0 until p < 0, later it reaches 0), "impact" (lambda_N > 0 until p < 0, and after
    that until it exceeds a stated force), or None: undecided, and ``verdict.detail`` says which inequality is not
    certain. Slip is assumed to stay positive. ``way`` says where the states are, if the system has a chart.
    """

    written: ClassVar[str] = "p=start.p b=start.b within=start.within epsilon side verdict"

    start: AffineStart
    epsilon: fmpq
    side: str | None
    verdict: Verdict
    way: ChartedWay | None = None

    def __str__(self) -> str:
        return str(self.verdict)


def affine_side(
    system: AffineSystem,
    p: ExactInput,
    b: ExactInput,
    *,
    within: ExactInput = "1/100",
    force: ExactInput = 10,
    quotient: arb | None = None,
) -> AffineSide:
    """Whether the system lifts off or takes an impact without collision, for every epsilon up to one at once.

    The arguments are those of :func:`model_side`, where p and b may be balls: all of both are meant, with a
    ``quotient`` those with -b/p in this ball. The state must lie near the G-spot. Ranges of epsilon are followed as far
    as they are proved.

    :raises ValueError: beta is an integer or above 30; p is not positive, ``within`` negative, ``force`` at most 1; L
        is, or may be, 0; ``within`` or ``force`` is not rational; the contact has no damper.
    """
    checked_ratio(near(system.beta))
    share = rational(within, "within")
    start = AffineStart(_manifold(system, _LEAST_ORDER), exact(p, "p"), exact(b, "b"), share, quotient)
    factor = rational(force, "force")
    if not (start.p > 0 and start.within >= 0 and factor > 1):
        raise ValueError("p must be positive, within not negative, force above 1")
    with working_bits(BITS):
        if differ(start.excess, 0) is None:
            raise ValueError("b is, or may be, that of the reference: nothing decides the side")
        return _side(start, factor)


@cache
def _manifold(system: AffineSystem, order: int) -> SlowManifold:
    with working_bits(_FINE_BITS):
        return slow_manifold(system, Cut(order, fmpq(_WEIGHT), 2 * near(system.beta) - 2))


def _side(start: AffineStart, factor: fmpq) -> AffineSide:
    system = start.manifold.system
    order = max(_ORDER, 2 * int(near(system.beta).floor()) + 8)
    trajectory = expand_system(system.system(), order, _DIGITS)
    residuals, prepared, ways = dict[fmpq, Residuals](), list(_prepared(start)), list[_Passed]()

    def follow(least: fmpq, most: fmpq) -> SideEnd | str:
        level = _level(system, most)
        shared = residuals.setdefault(level, Residuals(trajectory, level))
        return _followed(start, prepared, DeviationEquations(trajectory, most, least, shared), factor, ways)

    top = LARGEST_DELTA if system.chart is None else largest_delta(start.p, system.a)
    ends, failed = in_ranges(follow, top)
    delta = ends[-1].most if ends else smallest(top)
    shown, epsilon, way, place = joined(ends, delta), delta**3, None, ""
    if system.chart is not None and shown is not None:
        way = _way(start, system.chart, ways, ends)
        failed = failed if way is not None else "p, b, y, v are not certainly coordinates at the start"
        shown = None if way is None else every([shown, way.starts.evidence])
        place = "" if way is None else f" and the state in {_box_text(system.chart, way.starts)}"
    whole = (
        f"{_system_text(system)}, {states_text(start)}{place}, for every 0 < epsilon <= {epsilon}, as long as slip is "
        "positive"
    )
    if shown is None:
        detail = failed or "different epsilon have different sides"
        verdict = Verdict.undecided(f"{whole}: lift-off or impact", Reason.HYPOTHESIS, detail)
        return AffineSide(start, epsilon, None, verdict)
    before = f"{whole}: lambda_N > 0 until p < 0"
    if ends[0].side < 0:
        side, statement = "lift-off", f"{before}, and it vanishes later: contact is lost"
    else:
        after = f"after that it stays so until it exceeds {_text(factor * system.mean_force)}; p < 0 there"
        side, statement = "impact", f"{before}; {after}"
    return AffineSide(start, epsilon, side, Verdict.proved(statement, shown), way)


def _way(start: AffineStart, chart: Chart, ways: Sequence[_Passed], ends: Sequence[SideEnd]) -> ChartedWay | None:
    """Where the states are; None: it is not certain that the starts are states of the chart."""
    p, force, cone = ball(start.p), ball(start.force), joined_cones([one.cone for one in ways])
    ray = ray_of(cone, p, force)
    chain = chart.chain(ray.pieces(_PIECES))
    if chain is None:
        return None
    starts = chart.region(replace(ray, first=rational_of(p.lower())).place, chain[-1])
    after = tuple(hull(values) for values in zip(*(end.states for end in ends), strict=True))
    later = reduce(arb.max, (one.later for one in ways))
    return None if starts is None else ChartedWay(cone, starts, after, later)


def _box_text(chart: Chart, region: Region) -> str:
    parts = zip(chart.system.names, region.around, strict=True)
    return ", ".join(f"{name} in {inner_text(value)}" for name, value in parts)


def _level(system: AffineSystem, most: fmpq) -> fmpq:
    """The delta whose residuals serve a range up to ``most``: one for all ranges, where no power series ends."""
    level = LARGEST_DELTA
    if not all(isinstance(one, Affine) for one in (system.alpha_1, system.alpha_2, system.alpha_3)):
        while level / _FINER >= most:
            level /= _FINER
    return level


@dataclass(frozen=True)
class _Prepared:
    """Lemma 1 for one plan; it does not depend on epsilon. The start's manifold has the plan's order. ``failed`` notes
    by nu and z_max the smallest e for which no tube was found, and why."""

    plan: Plan
    start: AffineStart
    norm: Norm[SlowManifold]
    rectangle: Rectangle
    growth: Growth
    failed: dict[tuple[fmpq, fmpq], tuple[fmpq, str]] = field(default_factory=dict)


def _prepared(start: AffineStart) -> Iterator[_Prepared]:
    """For each norm the sharpest rate that is shown."""
    system = start.manifold.system
    for choices in affine_plans(near(system.beta), system.a, start.manifold.contact):
        for plan in choices:
            manifold = _manifold(system, plan.order)
            norm = Norm(manifold, plan.k_1, plan.k_2)
            reach = (1 / (ball(system.a) * plan.place**3)).sqrt() * ball(_BEYOND)
            rectangle = Rectangle(rounded_up(reach), rounded_up(ball(start.p).sqrt()))
            growth = fast_growth(norm, rectangle, plan.growth, plan.damping)
            if growth.evidence is not None or plan is choices[-1]:
                yield _Prepared(plan, replace(start, manifold=manifold), norm, rectangle, growth)
                break


def _followed(
    start: AffineStart, prepared: list[_Prepared], equations: DeviationEquations, factor: fmpq, ways: list[_Passed]
) -> SideEnd | str:
    """From p_1 to the end, for all delta of the equations, or what a plan failed by that came farthest; ``ways`` gets
    where p, b, y, v are on it."""
    by_tube, by_hand_over, by_end = list[str](), list[str](), list[str]()
    wide = list[arb]()  # z of what was handed over and not followed to an end
    for one in prepared:
        passed = _tube(start, one, largest_e(start.manifold.system.a, equations.exact_delta))
        if isinstance(passed, str):
            by_tube.append(passed)
            continue
        handed = affine_hand_over(equations, one.start, passed, one.plan.place)
        if isinstance(handed, str):
            by_hand_over.append(handed)
            continue
        if any(z <= handed.z for z in wide):
            continue
        ended = _ended(start, equations, factor, handed, one.plan.place)
        if isinstance(ended, str):
            by_end.append(ended)
            wide.append(handed.z)
            continue
        whole = every([passed.evidence, ended.evidence])
        if whole is not None:
            ways.append(_Passed(passed.cone, _later(ended, one.plan.place, start.manifold.mu)))
            return replace(ended, evidence=whole)
    farthest = by_end or by_hand_over
    return farthest[0] if farthest else f"Theorem B': {nearest(by_tube)}"


def nearest(failed: Sequence[str]) -> str:
    """Of messages of :func:`affine_tube` the first of those that name the fewest inequalities."""
    named = [text for text in failed if text.startswith("not certain: ")] or [*failed, "no norm and no z_max was tried"]
    return sorted(named, key=lambda text: text.count("; "))[0]


def _later(end: SideEnd, place: fmpq, mu: Exact) -> arb:
    """delta^2 (S + s_+): the time from the hand-over to the end, at the largest delta of the range the longest."""
    return (ball(end.most) ** 2 * (ball(place) + end.latest(end.most**3, mu))).upper()


def _tube(start: AffineStart, one: _Prepared, e: fmpq) -> AffineTube | str:
    """The first nu and z_max that serve, or what the nearest failed by; what failed for a smaller e is not tried
    again."""
    missed = list[str]()
    known: dict[fmpq, Sums] = {}
    likely = [largest for largest in LARGEST if largest > 3 * start.within]
    for ratio, largest in product(_RATIOS, likely):
        failed = one.failed.get((ratio, largest))
        if failed is not None and failed[0] <= e:
            missed.append(failed[1])
            continue
        found = affine_tube(one.start, one.norm, one.growth, one.rectangle, e, largest, ratio=ratio, known=known)
        if isinstance(found, AffineTube):
            return found
        one.failed[ratio, largest] = e, found
        missed.append(found)
    return nearest(missed)


def _ended(
    start: AffineStart, equations: DeviationEquations, factor: fmpq, handed: HandOver, place: fmpq
) -> SideEnd | str:
    tracked = track(
        equations,
        start.manifold.mu,
        -place,
        end_of_track(equations, reach_for(near(start.manifold.beta))),
        centre=handed.centre,
        radii=handed.radii,
        fast=handed.fast,
        frame=handed.frame,
    )
    end = first_end(tracked, -place, factor)
    if end is not None:
        return end
    reached = tracked.pieces[-1].end if tracked.pieces else -place
    return f"Theorems U1, U2: no end is certain up to s = {reached}; z <= {ball_text(handed.z, 3)} at s = -{place}"


def largest_e(a: Exact, delta: fmpq) -> fmpq:
    """a delta^3, or a rational number above it."""
    return a * delta**3 if isinstance(a, fmpq) else rounded_up(a * delta**3, _FINENESS)


def _text(value: Exact) -> str:
    return str(value) if isinstance(value, fmpq) else ball_text(value)


def _system_text(system: AffineSystem) -> str:
    if system.chart is not None:
        return f"{system.chart.system.name} with {contact_text(system.regularisation)}"
    first, second, third = (one.text for one in (system.alpha_1, system.alpha_2, system.alpha_3))
    moving = ", v = y'" if system.moves else ""
    return (
        f"p' = alpha_1, b' = alpha_2 - alpha_3 lambda_N, y'' = b + p lambda_N{moving} with alpha_1 = {first}, "
        f"alpha_2 = {second}, alpha_3 = {third} and {contact_text(system.regularisation)}"
    )


def states_text(start: AffineStart) -> str:
    """The set of states in words; p, b are any of their balls, and what is printed lies in these."""
    chart = start.manifold.system.chart
    of_set = chart is not None or isinstance(start.p, arb) or isinstance(start.b, arb)
    p, b, force, excess = (
        f"in {inner_text(value)}" if of_set and isinstance(value, arb) else f"= {_text(value)}"
        for value in (start.p, start.b, start.force, start.excess)
    )
    sharper = "" if start.quotient is None else f", -b/p {force}"
    return (
        f"every start in contact at p {p}, b {b}{sharper} with "
        f"|lambda_N + b/p| <= {start.within} |L|, "
        f"sqrt(kappa) |v|/epsilon <= {start.within} sqrt(p) |L|, g |fast|/sqrt(l) <= {start.within} sqrt(p) |L|, "
        f"L {excess}, {Contact.of(start.manifold.system.regularisation).fast_text}"
    )
