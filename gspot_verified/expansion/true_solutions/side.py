"""Lift-off or impact without collision for a family of states, for every epsilon up to epsilon_0.

Proof page: ``proofs/uniform.md``, Theorem U2 and Corollary 2.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from flint import arb, fmpq

from gspot_verified.expansion.trajectory import Trajectory
from gspot_verified.expansion.true_solutions.bound import BITS, check_interval, rational
from gspot_verified.expansion.true_solutions.cone_choice import cones
from gspot_verified.expansion.true_solutions.equations import DeviationEquations
from gspot_verified.expansion.true_solutions.growth import DeviationCone, EntryDeviation, entry_of, grows, ranges_of
from gspot_verified.expansion.true_solutions.slow_deviation import slow_deviation
from gspot_verified.expansion.true_solutions.track import Track, track
from gspot_verified.numbers.balls import (
    ExactInput,
    add_remainder,
    approximate,
    ball,
    ball_text,
    exact,
    hull,
    working_bits,
)
from gspot_verified.numbers.evidence import cover, every, less
from gspot_verified.numbers.verdict import ASK_VERDICT, Evidence, NoTruthValue, Reason, Verdict
from gspot_verified.numbers.written import Written

REACH = 4.0  # tau up to which a cone is looked for: a heuristic
_ROOM = fmpq(13, 10)  # above the force that is to be reached, for what is subtracted from it


@dataclass(frozen=True)
class UniformSide(NoTruthValue, Written):
    """What becomes of all solutions near the expansion + the slow deviation with C_1, for all delta in (0, delta].

    ``side``: "lift-off" (lambda_N reaches 0), "impact" (lambda_N > 0 until it exceeds ``force``), or None: undecided.
    It happens after s = ``entered`` and at the latest at :meth:`latest`. ``deviation`` is the slow deviation at s =
    ``start`` over delta^(2 beta - 2), by component: xi_1, ..., p, b, y, v.
    """

    ask: ClassVar[str] = ASK_VERDICT
    written: ClassVar[str] = (
        "name=trajectory.system.name order=trajectory.order c_1 beta start delta epsilon within side entered verdict"
    )

    trajectory: Trajectory
    c_1: fmpq
    beta: fmpq
    start: fmpq
    delta: fmpq
    within: fmpq
    deviation: tuple[arb, ...]
    side: str | None
    entered: fmpq | None
    rate: arb | None
    ratio: arb | None
    force: arb | None
    verdict: Verdict

    @property
    def epsilon(self) -> fmpq:
        """epsilon_0 = delta_0^3."""
        return self.delta**3

    def latest(self, delta: ExactInput) -> arb:
        """By which s it has happened: s_1 + log(Y_max/(Y_1 delta^mu))/a; t = epsilon^(2/3) s.

        :raises ValueError: delta is not in (0, delta_0], or nothing is proved.
        """
        small = exact(delta, "delta")
        if self.entered is None or self.rate is None or self.ratio is None:
            raise ValueError("nothing is proved")
        if not (small > 0 and small <= self.delta):
            raise ValueError(f"delta must lie in (0, {self.delta}], got {small}")
        with working_bits(BITS):
            power = ball(2 * (self.beta - 1))
            return (ball(self.entered) + (self.ratio / ball(small) ** power).log() / self.rate).upper()

    def __str__(self) -> str:
        lines = [f"{self.trajectory.system.name}: {self.verdict}"]
        if self.entered is not None:
            lines.append(f"  after s = {self.entered}; at delta = {self.delta} before s = {self._text()}")
        return "\n".join(lines)

    def _text(self) -> str:
        return ball_text(self.latest(self.delta), 5)


def uniform_side(
    trajectory: Trajectory,
    c_1: ExactInput,
    delta: ExactInput,
    start: ExactInput = -1,
    within: ExactInput = "1/1000",
    force: ExactInput = 10,
) -> UniformSide:
    """Whether the states with C_1 at s = ``start`` lift off or go into an impact, for every epsilon <= delta^3 at once.

    beta > 1 (Case III). The family: xi, p, b, y, v within ``within`` delta^(2 beta - 2) of the expansion plus the slow
    deviation with C_1 at leading order, and lambda_N + kappa y likewise. "impact": lambda_N stays positive and exceeds
    ``force`` times the mean force; what follows is not said. Slip is assumed to stay positive.

    :raises ValueError: beta is not a rational number above 1, C_1 = 0, or an argument is out of range.
    :raises SymbolsError: the numbers of the system are symbols.

    >>> from gspot_verified import expand
    >>> from gspot_verified.testing import extended_example
    >>> trajectory = expand(extended_example(chi=1), 8)
    >>> uniform_side(trajectory, -1, "1/50").side, uniform_side(trajectory, 1, "1/50").side
    ('lift-off', 'impact')
    """
    amount, small, first, tube, factor = (
        rational(value, name)
        for value, name in (
            (c_1, "c_1"), (delta, "delta"), (start, "start"), (within, "within"), (force, "force"),
        )
    )  # fmt: skip
    check_interval(trajectory, first, first + 1, small)
    if amount == 0:
        raise ValueError("C_1 must not be 0: that is the distinguished trajectory")
    if tube < 0 or not factor > 1:
        raise ValueError("within must not be negative, and force must exceed 1")
    alpha_1, _, alpha_3 = trajectory.system.check()
    beta = alpha_3 / alpha_1
    if not isinstance(beta, fmpq) or not 1 < beta <= 1 + fmpq(trajectory.order, 2):
        raise ValueError(f"beta must be rational, above 1 and at most 1 + order/2, got {beta}")
    with working_bits(BITS):
        equations = DeviationEquations(trajectory, small)
        power = 2 * (beta - 1)
        deviation = slow_deviation(equations, beta, amount, first)
        radii = [add_remainder(ball(tube), value.rad()).upper() for value in deviation]
        until = end_of_track(equations)
        if not first < until:
            raise ValueError(f"start must be less than {until}, got {first}")
        tracked = track(equations, power, first, until, [value.mid() for value in deviation], radii, ball(tube))
        family = (trajectory, amount, beta, first, small, tube, tuple(deviation))
        whole = (
            f"for every epsilon <= {small**3} and every state within {tube} delta^mu of the expansion and the slow "
            f"deviation with C_1 = {amount} at s = {first}, mu = {power}, as long as slip is positive"
        )
        ends = first_end(tracked, first, factor)
        if ends is None:
            detail = "no deviation that was followed lies in a cone of Theorem U2; a smaller delta may do"
            statement = f"{whole}: lift-off or impact"
            return UniformSide(*family, None, None, None, None, None, Verdict.undecided(
                statement, Reason.HYPOTHESIS, detail
            ))  # fmt: skip
        entry, cone, reached, evidence = ends
        before = f"{whole}: lambda_N > 0 up to s = {entry.place}"
        if entry.side < 0:
            side, statement = "lift-off", f"{before}, and it vanishes later: contact is lost"
        else:
            side, statement = "impact", f"{before} and on, until it exceeds {ball_text(reached, 3)}; p < 0 there"
        ratio = (cone.top / entry.Y.lower()).upper()
        return UniformSide(*family, side, entry.place, cone.a, ratio, reached, Verdict.proved(statement, evidence))


def end_of_track(equations: DeviationEquations, reach: float = REACH) -> fmpq:
    """The s at tau = ``reach``, up to which a deviation is followed before it is given up."""
    return fmpq(round(8 * reach / approximate(-equations.alpha_1 * equations.kappa) ** (1 / 3)), 8)


def first_end(tracked: Track, start: fmpq, factor: fmpq) -> tuple[EntryDeviation, DeviationCone, arb, Evidence] | None:
    """The first end of a piece at which Theorem U2 applies, contact being kept until then; the force reached; and what
    was compared."""
    equations = tracked.equations
    scale = hull([equations.delta ** ball(tracked.power), arb(0)])
    before: list[Evidence] = []
    for index, piece in enumerate(tracked.pieces):
        pressing = less(0, piece.mean + scale * piece.force)
        if pressing is None:
            return None
        before.append(pressing)
        entry = entry_of(tracked, index)
        if entry is None:
            continue
        wanted = equations.mean_force * (1 if entry.side < 0 else factor)
        top = (_ROOM * wanted / equations.kappa).upper()
        for cone in cones(equations, entry, tracked.power, top):
            grown = grows(equations, entry, tracked.power, cone)
            ranges = ranges_of(equations, entry, tracked.power, cone)
            if grown is None or ranges is None:
                continue
            reached, grows_until = grown
            if entry.side < 0:
                ended = every([less(ranges.force, reached)])
            else:
                ended = every([less(0, ranges.force), less(wanted, reached + ranges.force)])
                reached = wanted.lower()
            parts = tracked.pieces[: index + 1]
            whole = cover(((part.start, part.end) for part in parts), (start, piece.end))
            evidence = every([*before, whole, grows_until, ended])
            if evidence is not None:
                return entry, cone, reached, evidence
    return None
