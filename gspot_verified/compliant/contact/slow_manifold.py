"""The contact force of the compliant model on its slow manifold: is it positive on a half-line, below which epsilon?

Proof page: ``proofs/monotone.md``. The slow manifold is the one solution with b-hat ~ C_1 (-t)^beta as t -> -infinity
that grows slower than e^(|T|/2) (``proofs/exact_solution.md``, section 4).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from flint import arb, fmpq

from gspot_verified.compliant.contact.least_value import least_value
from gspot_verified.compliant.contact.threshold import MAX_BETA_OF_THEOREM, Threshold, exact_threshold, fails_at
from gspot_verified.compliant.contact.threshold_by_cells import MAX_BETA, threshold_by_cells
from gspot_verified.compliant.contact.to_the_left import positive_to_the_left
from gspot_verified.compliant.slow.profile import SLOW, Profile, in_range
from gspot_verified.leading_order.contact_force import of_system
from gspot_verified.leading_order.iwc import IwcResult, force_statement
from gspot_verified.leading_order.stretches import stretches
from gspot_verified.numbers.balls import working_bits
from gspot_verified.numbers.evidence import every, less, theorem
from gspot_verified.numbers.short_text import short_text
from gspot_verified.numbers.verdict import Evidence, NoTruthValue, Outcome, Reason, Verdict
from gspot_verified.numbers.written import Written
from gspot_verified.signs.cover.refutation import refutation
from gspot_verified.work.ranges import Range

ABOVE = "its force is above the one at leading order at every τ and every ε (proofs/monotone.md, Theorem C)"
BY_CELLS = "by Theorem C's polynomial, on cells that cover every such ε (proofs/monotone.md, section 10)"
THRESHOLD_DIGITS = 8
"""Digits of the exact epsilon_0, at most: each costs a share of a second."""
CELL_DIGITS = 6
"""The same for beta > 5."""


@dataclass(frozen=True, slots=True)
class SlowManifold(NoTruthValue, Written):
    """What is proved about the contact force of the compliant model on its slow manifold.

    ``whole_line``: the verdict, when proved, holds to the left of ``start`` as well; ``start`` is None where the
    statement itself is for every real tau. ``threshold``: the exact epsilon_0.
    """

    written: ClassVar[str] = "verdict whole_line threshold"

    verdict: Verdict
    start: fmpq | None
    whole_line: bool
    threshold: Threshold | None = None

    def lines(self) -> list[str]:
        """The lines of the text."""
        lines = [str(self.verdict)]
        exact = self.threshold
        if exact is not None and exact.lower is not None and exact.upper is not None and exact.place is not None:
            lines.append(
                f"  the largest ε0 possible lies in [{short_text(exact.lower)}, {short_text(exact.upper)}]: "
                f"at the upper end λ_N < 0 at τ = {short_text(exact.place)}"
            )
        if self.start is not None and self.whole_line and self.verdict.outcome is Outcome.PROVED:
            lines.append(f"  it holds for every τ < {self.start} as well")
        return lines


def impact(leading: IwcResult, epsilon: fmpq | None, digits: int) -> SlowManifold | None:
    """What is proved where C_1/Gamma(-beta) > 0: at ``epsilon``, or below the exact epsilon_0; or None."""
    beta = leading.force.beta
    if epsilon is not None:
        return _at_epsilon(leading, epsilon, digits)
    if beta < MAX_BETA_OF_THEOREM:
        return _below_threshold(leading, digits)
    return _by_cells(leading, digits) if beta < MAX_BETA else None


def exact_epsilon_0(leading: IwcResult, digits: int) -> tuple[Threshold | None, bool]:
    """The exact epsilon_0 on [start, infinity), and whether it is proved to hold to the left as well; 0 < beta < 13.

    None where there is none at leading order to begin with, or none was found.
    """
    if leading.epsilon_0 is None:
        return None, False
    force, start = leading.force, leading.start
    if force.beta < MAX_BETA_OF_THEOREM:
        exact = exact_threshold(force, start, leading.epsilon_0, min(digits, THRESHOLD_DIGITS))
        return exact, _to_the_left(leading, digits)
    left = leading.whole_line and force.direction < 0
    return threshold_by_cells(force, start, leading.epsilon_0, min(digits, CELL_DIGITS), left)


def _by_cells(leading: IwcResult, digits: int) -> SlowManifold | None:
    """beta > 5, where the leading order is no lower bound; None where it has no epsilon_0 to begin with."""
    if leading.epsilon_0 is None:
        return None
    force, start = leading.force, leading.start
    exact, whole = exact_epsilon_0(leading, digits)
    if exact is None:
        text = (
            f"{of_system(SLOW, force)}: some ε0 > 0 with λ_N > 0 for every τ in [{start}, inf) and every ε in (0, ε0)"
        )
        return SlowManifold(Verdict.undecided(text, Reason.BUDGET, "no cell of ε was settled"), start, False)
    return SlowManifold(_up_to(of_system(SLOW, force), exact, exact.evidence, start, BY_CELLS), start, whole, exact)


def _below_threshold(leading: IwcResult, digits: int) -> SlowManifold:
    force, start = leading.force, None if leading.every_epsilon and leading.whole_line else leading.start
    if leading.every_epsilon:
        verdict = Verdict.proved(force_statement(start, None, None, of_system(SLOW, force)), _above(leading), ABOVE)
        return SlowManifold(verdict, start, leading.whole_line)
    exact, whole = exact_epsilon_0(leading, digits)
    if exact is None:
        text = (
            f"{of_system(SLOW, force)}: some ε0 > 0 with λ_N > 0 for every τ in [{start}, inf) and every ε in (0, ε0)"
        )
        return SlowManifold(Verdict.undecided(text, Reason.BUDGET, "none at leading order to begin with"), start, False)
    shown = every([_above(leading), exact.evidence])
    return SlowManifold(_up_to(of_system(SLOW, force), exact, shown, start, ABOVE), start, whole, exact)


def _up_to(system: str, exact: Threshold, shown: Evidence | None, start: fmpq | None, why: str) -> Verdict:
    """That the force is positive below the exact eps_0, where that was shown."""
    text = force_statement(start, None, exact.lower, system)
    if shown is None:
        return Verdict.undecided(text, Reason.HYPOTHESIS, "a comparison on the way to it is not certain")
    return Verdict.proved(text, shown, why)


def _above(leading: IwcResult) -> Evidence | None:
    """That Theorem C puts the force above the one at leading order, of which the statement is proved."""
    return theorem("proofs/monotone.md", less(leading.force.beta, MAX_BETA_OF_THEOREM), leading.verdict.evidence)


def _to_the_left(leading: IwcResult, digits: int) -> bool:
    """Whether the force is positive to the left of the start at every epsilon: there it is above the one at leading
    order, which falls from +infinity to a value at the start that adds to the mean force."""
    value = stretches(leading.force.beta, leading.force.direction, leading.start, digits).start.value
    return leading.whole_line and leading.force.mean >= 0 and bool(value >= 0)


def _at_epsilon(leading: IwcResult, epsilon: fmpq, digits: int) -> SlowManifold:
    force, start = leading.force, leading.start
    if (above := _above(leading)) is not None:
        everywhere = None if leading.every_epsilon and leading.whole_line else start
        text = force_statement(everywhere, epsilon, None, of_system(SLOW, force))
        return SlowManifold(Verdict.proved(text, above, ABOVE), everywhere, leading.whole_line)
    text = force_statement(start, epsilon, None, of_system(SLOW, force))
    whole = force.beta < MAX_BETA_OF_THEOREM and _to_the_left(leading, digits)
    if not in_range(force, epsilon):
        return SlowManifold(Verdict.undecided(text, Reason.BUDGET, "ε |α1| is outside [1e-300, 1e6]"), start, False)
    profile = Profile.of(force, epsilon)
    whole = whole or positive_to_the_left(force, profile, start)
    least = least_value(profile, start, min(digits, THRESHOLD_DIGITS))
    if least is not None:
        with working_bits(4 * digits + 64):
            size = force.amplitude(digits) * arb(epsilon) ** arb(force.exponent)
            bound = force.mean + size * least.lower
        if (positive := every([less(0, bound), least.evidence])) is not None:
            verdict = Verdict.proved(text, positive, "least value by branch and bound (proofs/monotone.md)")
            return SlowManifold(verdict, start, whole)
        asked = {"τ": Range(start, None, True, False)}
        against = refutation(
            text, asked, [(least.place,)], lambda tau: ("λ_N < 0", fails_at(force, tau, epsilon, digits))
        )
        if against is not None:
            return SlowManifold(against.verdict, start, False)
    return SlowManifold(Verdict.undecided(text, Reason.BUDGET, "the least value is too close to 0"), start, False)
