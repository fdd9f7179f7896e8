"""Lift-off or impact without collision for a family of states, for every epsilon up to epsilon_0.

Proof page: ``proofs/uniform.md``, Corollary 2.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from flint import arb, fmpq

from gspot_verified.expansion.trajectory import Trajectory
from gspot_verified.expansion.true_solutions.bound import BITS, check_interval, rational
from gspot_verified.expansion.true_solutions.delta_ranges import in_ranges
from gspot_verified.expansion.true_solutions.equations import DeviationEquations, measured_in
from gspot_verified.expansion.true_solutions.side_end import (
    SideEnd,
    first_end,
    first_entered,
    joined,
    latest_at,
    proved_so_far,
)
from gspot_verified.expansion.true_solutions.slow_deviation import slow_deviation
from gspot_verified.expansion.true_solutions.track import track
from gspot_verified.numbers.balls import (
    Exact,
    ExactInput,
    add_remainder,
    approximate,
    ball,
    ball_text,
    float_bounds,
    rounded_text,
    working_bits,
)
from gspot_verified.numbers.verdict import NoTruthValue, Reason, Verdict
from gspot_verified.numbers.written import Written

REACH = 4.0  # tau up to which a cone is looked for: a heuristic
_FAILED = "no deviation that was followed lies in a cone of Theorem U2; a smaller delta may do"
_BOTH = "different delta have different sides"


@dataclass(frozen=True)
class UniformSide(NoTruthValue, Written):
    """What becomes of all solutions near the expansion + the slow deviation with C_1, for all delta in (0, delta].

    ``side``: "lift-off" (lambda_N reaches 0), "impact" (lambda_N > 0 until it exceeds ``force``), or None: undecided.
    It happens after s = ``entered`` and at the latest at :meth:`latest`. ``deviation`` is the slow deviation at s =
    ``start`` over delta^(2 beta - 2), by component: xi_1, ..., p, b, y, v. ``ends`` are those of ranges of delta.
    """

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
    ends: tuple[SideEnd, ...]
    verdict: Verdict

    @property
    def epsilon(self) -> fmpq:
        """epsilon_0 = delta_0^3."""
        return self.delta**3

    @property
    def entered(self) -> fmpq | None:
        """The first s_1 of all ranges of delta."""
        return first_entered(self.ends)

    def latest(self, delta: ExactInput) -> arb:
        """By which s it has happened: s_1 + log(Y_max/(Y_1 delta^mu))/a; t = epsilon^(2/3) s.

        :raises ValueError: delta is not in (0, delta_0], or nothing is proved.
        """
        small = rational(delta, "delta")
        if not self.ends:
            raise ValueError("nothing is proved")
        if not (small > 0 and small <= self.delta):
            raise ValueError(f"delta must lie in (0, {self.delta}], got {small}")
        with working_bits(BITS):
            return latest_at(self.ends, small**3, 2 * (self.beta - 1))

    def __str__(self) -> str:
        lines = [f"{self.trajectory.system.name}: {self.verdict}"]
        if self.entered is not None:
            lines.append(f"  after s = {self.entered}; at delta = {self.delta} before s = {self._text()}")
        return "\n".join(lines)

    def _text(self) -> str:
        return rounded_text(float_bounds(self.latest(self.delta))[1], 1, 5)


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
        power = 2 * (beta - 1)
        deviation = slow_deviation(DeviationEquations(trajectory, small), beta, amount, first)

        def followed_on(least: fmpq, most: fmpq) -> SideEnd | str:
            equations = DeviationEquations(trajectory, most, least)
            until = end_of_track(equations)
            if not first < until:
                raise ValueError(f"start must be less than {until}, got {first}")
            radii = [add_remainder(ball(tube), value.rad()).upper() for value in deviation]
            fast = equations.lagged(ball(tube), add_remainder(deviation[equations.v], ball(tube)))
            tracked = track(equations, power, first, until, [value.mid() for value in deviation], radii, fast)
            return first_end(tracked, first, factor) or _FAILED

        ends, failed = in_ranges(followed_on, small)
        shown = joined(ends, small)
    whole = (
        f"for every 0 < epsilon <= {small**3} and every state within {tube} delta^mu of the expansion and the slow "
        f"deviation with C_1 = {amount} at s = {first} (in {measured_in(trajectory)}, which is 0 in the slow "
        f"deviation), mu = {power}, as long as slip is positive"
    )
    family = (trajectory, amount, beta, first, small, tube, tuple(deviation))
    if shown is None:
        detail = (failed or _BOTH) + proved_so_far(ends)
        verdict = Verdict.undecided(f"{whole}: lift-off or impact", Reason.HYPOTHESIS, detail)
        return UniformSide(*family, None, (), verdict)
    before = f"{whole}: lambda_N > 0 up to s = {first_entered(ends)}"
    if ends[0].side < 0:
        side, statement = "lift-off", f"{before}, and it vanishes later: contact is lost"
    else:
        reached = factor * trajectory.lambda_n[0].at_zero()
        ends_by = f"after that it stays so until it exceeds {_number(reached)}; p < 0 there"
        side, statement = "impact", f"{before}; {ends_by}"
    return UniformSide(*family, side, tuple(ends), Verdict.proved(statement, shown))


def _number(value: Exact) -> str:
    return ball_text(value) if isinstance(value, arb) else str(value)


def end_of_track(equations: DeviationEquations, reach: float = REACH) -> fmpq:
    """The s at tau = ``reach``, up to which a deviation is followed before it is given up."""
    return fmpq(round(8 * reach / approximate(-equations.alpha_1 * equations.kappa) ** (1 / 3)), 8)
