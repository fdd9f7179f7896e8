"""The way of a set of starts of the model system through Theorem B, U1 and U2, or the inequality that is not certain.

The model system has constant alpha_1, alpha_2, alpha_3 and the state (p, b, y, v); paper, Sec. 4.
Proof page: ``proofs/from_state.md``, sections 4 to 6.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from flint import arb, fmpq

from gspot_verified.expansion.from_state.barrier import Start, Tube, start_bound, tube
from gspot_verified.expansion.from_state.choice import LARGEST, Plan, plans, reach_for
from gspot_verified.expansion.from_state.fast_growth import Norm, Rectangle, fast_growth
from gspot_verified.expansion.from_state.hand_over import HandOver, hand_over_set
from gspot_verified.expansion.from_state.slow_series import Contact, contact_text, slow_series
from gspot_verified.expansion.series.regularisation import Regularisation
from gspot_verified.expansion.series.system import System
from gspot_verified.expansion.trajectory import Trajectory, expand_system
from gspot_verified.expansion.true_solutions.equations import DeviationEquations, Residuals
from gspot_verified.expansion.true_solutions.side import end_of_track
from gspot_verified.expansion.true_solutions.side_end import SideEnd, first_end
from gspot_verified.expansion.true_solutions.track import track
from gspot_verified.functions.expressions import Constant, Variable
from gspot_verified.numbers.balls import ball
from gspot_verified.numbers.evidence import every


def model_system(alpha_1: fmpq, alpha_2: fmpq, alpha_3: fmpq, regularisation: Regularisation) -> System:
    """p' = alpha_1, b' = alpha_2 - alpha_3 lambda_N, y' = v, v' = b + p lambda_N.

    >>> from gspot_verified.expansion.series.regularisation import PAPER
    >>> model_system(fmpq(-1), fmpq(-1), fmpq(-3, 2), PAPER).check()
    (-1, -1, -3/2)
    """
    first, second, third = Constant(alpha_1), Constant(alpha_2), Constant(alpha_3)
    nothing = Constant(fmpq(0))
    p, b, y, v = (Variable(i) for i in range(4))
    return System(
        "model system",
        F=(first, second, v, b),
        G=(nothing, -third, nothing, p),
        y=y,
        v=v,
        p=p,
        b=b,
        alpha_1=first,
        alpha_2=second,
        alpha_3=third,
        J=(),
        point=(fmpq(0),) * 4,
        state=("p", "b", "y", "v"),
        regularisation=regularisation,
    )


_ORDER = 10  # of the expansion, whose terms beyond the first vanish for the model system
_FINENESS = 2**30  # of what is rounded to a rational
_LARGEST_RATIO = 30  # the slow series of a larger beta takes minutes, and the checks fail far below


def checked_ratio(beta: fmpq) -> fmpq:
    """beta, if it is in the range of this theorem and its cost.

    :raises ValueError: it is at most 1, an integer, or too large.
    """
    if not beta > 1 or beta.q == 1:
        raise ValueError(f"beta must be above 1 and no integer, got {beta}")
    if not beta <= _LARGEST_RATIO:
        raise ValueError(f"beta must be at most {_LARGEST_RATIO}, got {beta}")
    return beta


@dataclass(frozen=True)
class ModelStart:
    """p_1, b_1, and the half-width of the set of states, for constants alpha_1, alpha_2, alpha_3 = beta alpha_1."""

    beta: fmpq
    alpha_1: fmpq
    alpha_2: fmpq
    regularisation: Regularisation
    p: fmpq
    b: fmpq
    within: fmpq

    @property
    def mean_force(self) -> fmpq:
        """lambda_N of the distinguished trajectory."""
        return self.alpha_2 / (self.alpha_1 * (self.beta - 1))

    @property
    def excess(self) -> fmpq:
        """L = -b/p - mean force."""
        return -self.b / self.p - self.mean_force

    def c_1(self) -> arb:
        """C_1 = -L p^(1 - beta)."""
        return -ball(self.excess) * ball(self.p) ** ball(1 - self.beta)

    def system_text(self) -> str:
        """The system in words."""
        return (
            f"the model system with alpha = ({self.alpha_1}, {self.alpha_2}, {self.beta * self.alpha_1}) and "
            f"{contact_text(self.regularisation)}"
        )

    def states_text(self) -> str:
        """The set of states in words."""
        return (
            f"every start in contact at p = {self.p}, b = {self.b} with |lambda_N + b/p| <= {self.within} |L|, "
            f"sqrt(kappa) |v|/epsilon <= {self.within} sqrt(p) |L|, g |fast|/sqrt(l) <= {self.within} sqrt(p) |L|, "
            f"L = {self.excess}, {Contact.of(self.regularisation).fast_text}"
        )


@dataclass(frozen=True)
class Passage:
    """The end for all delta of a range, with what was compared on the whole way as its evidence."""

    tube: Tube
    plan: Plan
    handed: HandOver
    end: SideEnd


def trajectory_of(start: ModelStart) -> Trajectory:
    """The distinguished trajectory of the model system, to an order that Theorem U2 needs."""
    system = model_system(start.alpha_1, start.alpha_2, start.beta * start.alpha_1, start.regularisation)
    return expand_system(system, max(_ORDER, 2 * int(start.beta.p // start.beta.q) + 8))


def passage(start: ModelStart, residuals: Residuals, least: fmpq, delta: fmpq, factor: fmpq) -> Passage | str:
    """For all epsilon from least^3 to delta^3; the force that an impact must reach is ``factor`` times its mean.

    The first S that leads to an end, or what the first one failed by.
    """
    failed = list[str]()
    for choices in plans(start.beta, -start.alpha_1, Contact.of(start.regularisation)):
        found = tube_from(start, delta, choices)
        if isinstance(found, str):
            failed.append(f"Theorem B: {found}")
            continue
        equations = DeviationEquations(residuals.trajectory, delta, least, residuals)
        ended = _ended(start, equations, factor, *found)
        if isinstance(ended, Passage):
            return ended
        failed.append(ended)
    return failed[0]


def _ended(start: ModelStart, equations: DeviationEquations, factor: fmpq, plan: Plan, passed: Tube) -> Passage | str:
    """From the hand-over on."""
    series = slow_series(start.beta, Contact.of(start.regularisation), plan.order)
    handed = hand_over_set(equations, passed, series, start.c_1(), plan.place)
    tracked = track(
        equations,
        2 * (start.beta - 1),
        -plan.place,
        end_of_track(equations, reach_for(start.beta)),
        centre=handed.centre,
        radii=handed.radii,
        fast=handed.fast,
        frame=handed.frame,
    )
    end = first_end(tracked, -plan.place, factor)
    if end is None:
        reached = tracked.pieces[-1].end if tracked.pieces else -plan.place
        if not tracked.is_whole:
            return f"Theorem U1: its inequality is not certain from s = {reached} on; a smaller epsilon may do"
        return (
            f"Theorem U2: up to s = {reached} the deviation lies in no cone that was tried, or lambda_N is not "
            "certainly positive; a smaller epsilon may do"
        )
    whole = every([passed.evidence, end.evidence])
    return "nothing was compared" if whole is None else Passage(passed, plan, handed, replace(end, evidence=whole))


def tube_from(start: ModelStart, delta: fmpq, choices: Sequence[Plan]) -> tuple[Plan, Tube] | str:
    """The first plan that passes Theorem B, or what failed by the fewest inequalities of those that passed Lemma 1."""
    a, contact = -start.alpha_1, Contact.of(start.regularisation)
    e = a * delta**3
    growth_failed, tube_failed = "", ""
    known = {order: slow_series(start.beta, contact, order) for order in {plan.order for plan in choices}}
    for plan in choices:
        series = known[plan.order]
        norm = Norm(series, plan.k_1, plan.k_2)
        rectangle = Rectangle(rounded_up((1 / ball(a * plan.place**3)).sqrt()), rounded_up(ball(start.p).sqrt()))
        growth = fast_growth(norm, rectangle, plan.growth, plan.damping)
        if growth.evidence is None:
            growth_failed = growth_failed or f"{growth.where} ({plan.text})"
            continue
        z = start_bound(series, start.p, e, start.within)
        side = 1 if start.excess > 0 else -1
        given = Start(start.p, e, z, side, abs(start.excess) / start.mean_force)
        for largest in LARGEST:
            found = tube(norm, growth, rectangle, given, largest)
            if isinstance(found, Tube):
                return plan, found
            text = f"{found} ({plan.text})"
            if not tube_failed or text.count(";") <= tube_failed.count(";"):  # what fails by least
                tube_failed = text
    return tube_failed or growth_failed


def rounded_up(value: arb, fineness: int = _FINENESS) -> fmpq:
    """A multiple of 1/fineness at or above every number in the ball."""
    whole = (value * fineness).ceil().upper().ceil().unique_fmpz()
    if whole is None:
        raise ValueError("a number is too large to be rounded")
    return fmpq(whole, fineness)
