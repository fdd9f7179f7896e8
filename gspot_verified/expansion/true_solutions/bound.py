"""How far true solutions are from the truncated expansion, for all delta in (0, delta_0] at once.

Proof page: ``proofs/uniform.md``, Theorem U1.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, NamedTuple

from flint import arb, fmpq

from gspot_verified.expansion.series.legend import InTwo, in_two, left_side
from gspot_verified.expansion.trajectory import Trajectory
from gspot_verified.expansion.true_solutions.equations import DeviationEquations, measured_in
from gspot_verified.expansion.true_solutions.track import Track, track
from gspot_verified.numbers.balls import ExactInput, add_remainder, ball, ball_text, exact, working_bits
from gspot_verified.numbers.evidence import cover, every, less
from gspot_verified.numbers.verdict import NoTruthValue, Reason, Verdict
from gspot_verified.numbers.written import Written

BITS = 128  # of all bounds here; less make them wider


@dataclass(frozen=True)
class Stretch:
    """Constants K for start <= s <= end."""

    start: fmpq
    end: fmpq
    constants: dict[str, arb]


class StretchRow(NamedTuple):
    """Constants on a piece of s."""

    start: fmpq
    end: fmpq
    state: dict[str, arb]
    contact: dict[str, arb]


@dataclass(frozen=True)
class UniformBound(NoTruthValue, Written):
    """|true - truncated expansion| <= constants[name] delta^order for start <= s <= end and 0 < delta <= delta.

    "True" is every solution of the equations in contact, specialX to specialL, that is within ``within`` delta^order
    of the expansion at s = ``start`` (each of xi, p, b, y, v, and lambda_N + kappa y). ``contact``: that its lambda_N
    is positive all the way, so that it is a solution with the contact law, as long as it slips.
    ``stretches`` has the constants piece by piece. Where ``verdict`` is undecided they end before ``end``.
    """

    written: ClassVar[str] = (
        "name=trajectory.system.name order start end delta within verdict contact_lasts=contact "
        "state=rows.state contact=rows.contact stretches=stretch_rows"
    )

    trajectory: Trajectory
    start: fmpq
    end: fmpq
    delta: fmpq
    within: fmpq
    constants: dict[str, arb]
    stretches: tuple[Stretch, ...]
    verdict: Verdict
    contact: Verdict

    @property
    def rows(self) -> InTwo[arb]:
        """The constants of the whole interval; empty where nothing is proved."""
        return in_two(self.constants, self.trajectory.system.names) if self.constants else InTwo({}, {})

    @property
    def stretch_rows(self) -> list[StretchRow]:
        """The constants of each piece."""
        names = self.trajectory.system.names
        return [StretchRow(one.start, one.end, *in_two(one.constants, names)) for one in self.stretches]

    @property
    def order(self) -> int:
        """M, the order of delta from which terms are left out."""
        return self.trajectory.order

    def at(self, s: ExactInput, delta: ExactInput, digits: int = 15) -> dict[str, arb]:
        """Balls around the scaled variables of the true solutions at (s, delta).

        :raises ValueError: s or delta lies outside of what the verdict covers.

        >>> from gspot_verified import expand
        >>> from gspot_verified.testing import extended_example
        >>> bound = uniform_bound(expand(extended_example(chi=1), 10), -2, 1, "1/20")
        >>> bound.at(1, "1/100")["p"]
        [-0.99989998009310 +/- 3.39e-15]
        """
        place, small = exact(s, "s"), exact(delta, "delta")
        if not isinstance(place, fmpq) or not isinstance(small, fmpq):
            raise ValueError("s and delta must be rational numbers")
        inside = [one for one in self.stretches if one.start <= place <= one.end]
        if not inside:
            raise ValueError(f"s = {place} lies outside of what is proved")
        if not 0 < small <= self.delta:
            raise ValueError(f"delta must lie in (0, {self.delta}], got {small}")
        values = self.trajectory.evaluate(place, small, digits)
        with working_bits(BITS):
            power = ball(small) ** self.order
            return {
                name: add_remainder(value, (inside[0].constants[name] * power).upper())
                for name, value in values.items()
            }

    def __str__(self) -> str:
        lines = [f"{self.trajectory.system.name}: {self.verdict}"]
        names = self.trajectory.system.names
        if self.stretches and self.stretches[-1].end < self.end:
            lines.append(f"  up to s = {self.stretches[-1].end}:")
        for key, value in self.constants.items():
            lines.append(f"  K of {left_side(key, names, True)}: {ball_text(value, 4)}")
        return "\n".join([*lines, f"  {self.contact}"])


def uniform_bound(
    trajectory: Trajectory, start: ExactInput, end: ExactInput, delta: ExactInput, within: ExactInput = 1
) -> UniformBound:
    """Constants K with |true - truncated expansion| <= K delta^M for start <= s <= end and all delta in (0, delta].

    Every solution of the scaled equations in contact counts that is within ``within`` delta^M of the expansion at
    s = start; with ``within=0`` it is the one that starts on the expansion. Undecided when the inequality of Theorem
    U1 cannot be satisfied: a smaller delta or a shorter interval may do.

    :raises SymbolsError: the numbers of the system are symbols.
    :raises ValueError: not start < end, delta or ``within`` out of range or not rational, a contact without a damper.
    :raises ResidualError: the terms are not those of Theorem 1.

    >>> from gspot_verified import expand
    >>> from gspot_verified.testing import extended_example
    >>> bound = uniform_bound(expand(extended_example(chi=1), 6), -3, 2, "1/20")
    >>> bound.verdict.outcome.value, bound.contact.outcome.value, bound.constants["p"] < 31000
    ('proved', 'proved', True)
    """
    first, last, small, tube = (
        rational(value, name) for value, name in ((start, "start"), (end, "end"), (delta, "delta"), (within, "within"))
    )
    check_interval(trajectory, first, last, small)
    if tube < 0:
        raise ValueError(f"within must not be negative, got {tube}")
    with working_bits(BITS):
        equations = DeviationEquations(trajectory, small)
        size = equations.size
        fast = equations.lagged(ball(tube), ball(tube))
        tracked = track(equations, fmpq(trajectory.order), first, last, [arb(0)] * size, [ball(tube)] * size, fast)
        stretches = tuple(Stretch(one.start, one.end, _constants(tracked, i)) for i, one in enumerate(tracked.pieces))
        names = stretches[0].constants if stretches else ()
        constants = {name: _largest([one.constants[name] for one in stretches]) for name in names}
        verdict = _verdict(tracked, first, last, small, tube)
        return UniformBound(
            trajectory=trajectory,
            start=first,
            end=last,
            delta=small,
            within=tube,
            constants=constants,
            stretches=stretches,
            verdict=verdict,
            contact=_contact(tracked, small),
        )


def rational(value: ExactInput, name: str) -> fmpq:
    """The exact value of an input that must be rational.

    :raises ValueError: it is a ball.
    """
    number = exact(value, name)
    if not isinstance(number, fmpq):
        raise ValueError(f"{name} must be a rational number")
    return number


def check_interval(trajectory: Trajectory, start: fmpq, end: fmpq, delta: fmpq) -> None:
    """Start < end, delta > 0, and numbers instead of symbols.

    :raises SymbolsError: the numbers of the system are symbols.
    :raises ValueError: one of the others.
    """
    trajectory.system.check_numbers("bounds")
    if not start < end:
        raise ValueError(f"start must be less than end, got {start} and {end}")
    if not delta > 0:
        raise ValueError(f"delta must be positive, got {delta}")


def _constants(tracked: Track, i: int) -> dict[str, arb]:
    """K of every variable on one piece."""
    piece, m = tracked.pieces[i], tracked.equations.dimension
    names = [*(f"xi_{j + 1}" for j in range(m)), "p", "b", "y", "v"]
    values = dict(zip(names, piece.deviations, strict=True))
    values |= {"z": tracked.z_deviation(piece), "lambda_n": piece.force}
    return {name: value.abs_upper() for name, value in values.items()}


def _largest(values: list[arb]) -> arb:
    largest = values[0]
    for value in values[1:]:
        largest = largest.max(value)
    return largest


def _verdict(tracked: Track, start: fmpq, end: fmpq, delta: fmpq, within: fmpq) -> Verdict:
    order = tracked.equations.trajectory.order
    statement = (
        f"every solution in contact within {within} delta^{order} of the expansion at s = {start} (in "
        f"{measured_in(tracked.equations.trajectory)}) is, as long as slip is positive, within K delta^{order} of it "
        f"for {start} <= s <= {end} and 0 < delta <= {delta}"
    )
    covered = cover(((piece.start, piece.end) for piece in tracked.pieces), (start, end))
    if covered is not None:
        return Verdict.proved(statement, covered)
    reached = tracked.pieces[-1].end if tracked.pieces else start
    detail = f"the inequality of Theorem U1 fails from s = {reached} on; a smaller delta or a shorter interval may do"
    return Verdict.undecided(statement, Reason.HYPOTHESIS, detail)


def _contact(tracked: Track, delta: fmpq) -> Verdict:
    statement = f"lambda_N of these solutions is positive there, for 0 < delta <= {delta}"
    scale = tracked.equations.small**tracked.equations.trajectory.order
    pressing = every(less(0, piece.mean + scale * piece.force) for piece in tracked.pieces)
    if tracked.is_whole and pressing is not None:
        return Verdict.proved(statement, pressing)
    return Verdict.undecided(
        statement, Reason.HYPOTHESIS, "an enclosure of lambda_N holds numbers that are not positive"
    )
