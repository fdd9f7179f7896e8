"""From a state of the model system to lift-off or impact without collision, for every epsilon up to epsilon_0 at once.

Proof page: ``proofs/from_state.md``, the theorem of section 6.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, NamedTuple

from flint import arb, fmpq

from gspot_verified.expansion.from_state.barrier import Tube
from gspot_verified.expansion.from_state.choice import LARGEST_DELTA, Plan
from gspot_verified.expansion.from_state.passage import (
    ModelStart,
    checked_ratio,
    passage,
    rounded_up,
    trajectory_of,
)
from gspot_verified.expansion.series.regularisation import Regularisation
from gspot_verified.expansion.true_solutions.bound import BITS, rational
from gspot_verified.expansion.true_solutions.delta_ranges import in_ranges, smallest
from gspot_verified.expansion.true_solutions.equations import Residuals
from gspot_verified.expansion.true_solutions.side_end import SideEnd, first_entered, joined, latest_at, proved_so_far
from gspot_verified.numbers.balls import ExactInput, ball, ball_text, float_bounds, hull, rounded_text, working_bits
from gspot_verified.numbers.verdict import NoTruthValue, Reason, Verdict
from gspot_verified.numbers.written import Written


class Way(NamedTuple):
    """How the hand-over of one range of epsilon is reached."""

    plan: Plan
    tube: Tube


@dataclass(frozen=True)
class ModelSide(NoTruthValue, Written):
    """What becomes of all starts of the model system in a stated set, for every epsilon in (0, ``epsilon``] at once.

    ``side``: "lift-off" (lambda_N > 0 on the way to the G-spot and up to the scaled time ``entered`` > 0 after it, then
    it reaches 0), "impact" (lambda_N > 0 so far and on until it exceeds ``force``, with p < 0; a start may exceed it
    already), or None: undecided, and ``verdict.detail`` says which inequality is not certain. It happens by
    :meth:`latest`. ``drift`` bounds how far log C_1 moves on the way. Slip is assumed to stay positive. The statement
    is about the model system only.
    """

    written: ClassVar[str] = (
        "beta=start.beta alpha_1=start.alpha_1 alpha_2=start.alpha_2 k_1=start.regularisation.k_1 "
        "k_2=start.regularisation.k_2 c=start.regularisation.c p=start.p b=start.b within=start.within "
        "epsilon c_1 side entered drift verdict"
    )

    start: ModelStart
    epsilon: fmpq
    force: fmpq
    c_1: arb
    side: str | None
    ends: tuple[SideEnd, ...]
    ways: tuple[Way, ...]
    drift: arb | None
    verdict: Verdict

    @property
    def entered(self) -> fmpq | None:
        """The first s_1 of all ranges of epsilon."""
        return first_entered(self.ends)

    def latest(self, epsilon: ExactInput) -> arb:
        """The time t after p = 0 by which it has happened: epsilon^(2/3) (s_1 + log(Y_max/(Y_1 delta^mu))/rate).

        :raises ValueError: epsilon is not in (0, epsilon_0], or nothing is proved.
        """
        small = rational(epsilon, "epsilon")
        if not (small > 0 and small <= self.epsilon):
            raise ValueError(f"epsilon must lie in (0, {self.epsilon}], got {small}")
        with working_bits(BITS):
            scaled = latest_at(self.ends, small, 2 * (self.start.beta - 1))
            return (scaled * ball(small) ** ball(fmpq(2, 3))).upper()

    def __str__(self) -> str:
        lines = [str(self.verdict), f"  C_1 = {ball_text(self.c_1, 6)}"]
        if self.entered is not None:
            lines.append(f"  at epsilon = {self.epsilon} by t = {self._text()} after p = 0")
        return "\n".join(lines)

    def _text(self) -> str:
        return rounded_text(float_bounds(self.latest(self.epsilon))[1], 1, 5)


def model_side(
    beta: ExactInput,
    p: ExactInput,
    b: ExactInput,
    *,
    epsilon: ExactInput | None = None,
    within: ExactInput = "1/100",
    force: ExactInput = 10,
    alpha_1: ExactInput = -1,
    alpha_2: ExactInput = -1,
    contact: tuple[ExactInput, ExactInput, ExactInput] = (1, 1, 1),
) -> ModelSide:
    """Whether the model system lifts off or takes an impact without collision, for every epsilon up to one at once.

    p' = alpha_1, b' = alpha_2 - alpha_3 lambda_N with alpha_3 = beta alpha_1, y'' = b + p lambda_N, in contact with
    ``contact`` = (k_1, k_2, c), from the state (p, b) with p > 0. The set of starts is given by ``within``: lambda_N
    within this share of \\|L\\|, L = -b/p - mean force, of -b/p; v/epsilon, phi (``proofs/from_state.md``) likewise.
    The state at rest in the contact, v = 0, y = -h epsilon^2 lambda_N, belongs to every such set. "impact": lambda_N
    exceeds ``force`` times the mean force. Without ``epsilon`` ranges of it are followed as far as they are proved.

    :raises ValueError: beta is not rational, at most 1, an integer or above 30; p, epsilon not positive; L = 0; the
        mean force is not positive; an argument is out of range or not rational; the contact has no damper.

    >>> found = model_side("3/2", "1/2", -2, epsilon="1e-6")
    >>> found.side, found.verdict.outcome.value
    ('lift-off', 'proved')
    """
    given = {"beta": beta, "p": p, "b": b, "within": within, "alpha_1": alpha_1, "alpha_2": alpha_2}
    start = _start({name: rational(value, name) for name, value in given.items()}, Regularisation.of(*contact))
    factor = rational(force, "force")
    if not factor > 1:
        raise ValueError(f"force must exceed 1, got {factor}")
    if epsilon is not None:
        small = rational(epsilon, "epsilon")
        if not small > 0:
            raise ValueError(f"epsilon must be positive, got {small}")
    with working_bits(BITS):
        if epsilon is None:
            return _side(start, None, LARGEST_DELTA, factor)
        return _side(start, small, rounded_up(ball(small).root(3)), factor)


def _start(values: dict[str, fmpq], springs: Regularisation) -> ModelStart:
    start = ModelStart(regularisation=springs, **values)
    checked_ratio(start.beta)
    if not (start.p > 0 and start.within >= 0):
        raise ValueError("p must be positive, and within not negative")
    if not (start.alpha_1 < 0 and start.alpha_2 < 0):
        raise ValueError("alpha_1 and alpha_2 must be negative: else the mean force is not positive")
    if start.excess == 0:
        raise ValueError("b = -p times the mean force: that is the distinguished trajectory")
    return start


def _side(start: ModelStart, epsilon: fmpq | None, delta: fmpq, factor: fmpq) -> ModelSide:
    """Up to epsilon; without one, as far as ranges up to delta are proved."""
    residuals, c_1 = Residuals(trajectory_of(start), delta), start.c_1()
    found, failed = in_ranges(lambda least, most: passage(start, residuals, least, most, factor), delta)
    ends = [each.end for each in found]
    if epsilon is None:
        delta = ends[-1].most if ends else smallest(delta)
        epsilon = delta**3
    shown = joined(ends, delta)
    force = factor * start.mean_force
    whole = (
        f"{start.system_text()}, {start.states_text()}, for every 0 < epsilon <= {epsilon}, as long as slip is positive"
    )
    if shown is None:
        detail = (failed or "different epsilon have different sides") + proved_so_far(ends)
        verdict = Verdict.undecided(f"{whole}: lift-off or impact", Reason.HYPOTHESIS, detail)
        return ModelSide(start, epsilon, force, c_1, side=None, ends=(), ways=(), drift=None, verdict=verdict)
    before = f"{whole}: lambda_N > 0 up to s = {first_entered(ends)}, where p = alpha_1 epsilon^(2/3) s"
    if ends[0].side < 0:
        side, statement = "lift-off", f"{before}, and it vanishes later: contact is lost"
    else:
        ends_by = f"after that it stays so until it exceeds {force}; p < 0 there"
        side, statement = "impact", f"{before}; {ends_by}"
    ways = tuple(Way(each.plan, each.tube) for each in found)
    drift = hull([abs((each.handed.coefficient / c_1).log()) for each in found]).upper()
    return ModelSide(
        start,
        epsilon,
        force,
        c_1,
        side=side,
        ends=tuple(ends),
        ways=ways,
        drift=drift,
        verdict=Verdict.proved(statement, shown),
    )
