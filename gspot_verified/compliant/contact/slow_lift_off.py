"""The lift-off time on the slow manifold of the compliant model: at one epsilon, and against the leading order for all
smaller ones.

Proof page: ``proofs/monotone.md``, sections 7 to 9.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import ClassVar

from flint import arb, fmpq

from gspot_verified.compliant.contact.crossing import NotBelow, first_crossing
from gspot_verified.compliant.contact.delay import lead, uniform_constant
from gspot_verified.compliant.contact.to_the_left import positive_to_the_left
from gspot_verified.compliant.slow.profile import SLOW, Profile, in_range
from gspot_verified.leading_order.contact_force import ContactForce, of_system
from gspot_verified.leading_order.lift_off import LiftOff
from gspot_verified.numbers.balls import approximate, working_bits
from gspot_verified.numbers.evidence import at_most, theorem
from gspot_verified.numbers.short_text import decimal_text, short_text
from gspot_verified.numbers.verdict import NoTruthValue, Outcome, Reason, Verdict
from gspot_verified.numbers.written import Written
from gspot_verified.signs.cover.refutation import refutation
from gspot_verified.work.ranges import Range

_CONSTANT_DIGITS = 4  # to which kappa and the gap are rounded up
_MOST_KAPPA = 10**100  # of what is stated: it may be e^(10^12) where epsilon is large, which no memory holds


@dataclass(frozen=True, slots=True)
class SlowLiftOff(NoTruthValue, Written):
    """lambda_N > 0 on [start, lower], and it changes sign in the open interval (lower, upper), at epsilon.

    ``lead`` bounds by how much that is before the lift-off at leading order (None: not proved). ``uniform``: the
    statement for every smaller epsilon, with its constant ``kappa``. ``whole_line``: lambda_N > 0 to the left as well.
    """

    written: ClassVar[str] = "epsilon verdict bracket lead kappa uniform whole_line"

    epsilon: fmpq
    start: fmpq
    lower: fmpq | None
    upper: fmpq | None
    lead: arb | None
    kappa: fmpq | None
    whole_line: bool
    verdict: Verdict
    uniform: Verdict | None

    @property
    def bracket(self) -> tuple[fmpq, fmpq] | None:
        """Both ends, where they are known."""
        return None if self.lower is None or self.upper is None else (self.lower, self.upper)

    def lines(self) -> list[str]:
        """The lines of the text."""
        lines = [str(self.verdict)]
        if self.lead is not None:
            gap = short_text(rounded_up(self.lead, _CONSTANT_DIGITS))
            lines.append(f"  before the lift-off at leading order, by at most {gap} (proofs/monotone.md, section 8)")
        if self.whole_line:
            lines.append(f"  λ_N > 0 for every τ < {self.start} as well")
        if self.uniform is not None:
            lines.append(str(self.uniform))
        return lines


def slow_lift_off(force: ContactForce, leading: LiftOff, start: fmpq, digits: int = 15) -> SlowLiftOff:
    """The first zero of the slow contact force on [start, infinity) at the epsilon of ``leading``, where
    C_1/Gamma(-beta) < 0.

    :raises ValueError: C_1/Gamma(-beta) > 0.

    >>> from gspot_verified.leading_order.contact_force import contact_force
    >>> from gspot_verified.leading_order.lift_off import lift_off
    >>> system = contact_force("3/2", c1=-1)
    >>> zero = slow_lift_off(system, lift_off(system, fmpq(1, 1000), fmpq(-10), 6), fmpq(-10), 6)
    >>> zero.lower, zero.upper, bool(zero.lead < fmpq(9, 100)), zero.kappa
    (441259/125000, 3530073/1000000, True, 179/100)
    """
    if force.takes_impact:
        raise ValueError("c1: a lift-off needs C_1/Gamma(-beta) < 0")
    epsilon = leading.epsilon
    where = f"{of_system(SLOW, force)}, at ε = {short_text(epsilon)}"
    if not in_range(force, epsilon):
        return _open(epsilon, start, f"{where}: the lift-off time", "ε |α1| is outside [1e-300, 1e6]")
    profile = Profile.of(force, epsilon)
    try:
        crossing = first_crossing(profile, start, lambda places: force.level(epsilon, places), digits)
    except NotBelow as error:
        # first_crossing has just shown that the force is certainly below 0 at the start itself.
        shown = error.evidence
        asked = {"τ": Range(start, start, True, True)}
        against = refutation(f"{where}: λ_N > 0 at τ = {start}", asked, [(start,)], lambda _: ("λ_N < 0", shown))
        assert against is not None  # the start lies in the range that is the start
        return SlowLiftOff(
            epsilon=epsilon,
            start=start,
            lower=None,
            upper=None,
            lead=None,
            kappa=None,
            whole_line=False,
            verdict=against.verdict,
            uniform=None,
        )
    if crossing is None:
        text = f"{where}: the first zero of λ_N on [{start}, inf)"
        return _open(epsilon, start, text, "a value of λ_N is too close to 0, or nothing was found")
    lower, upper = crossing.lower, crossing.upper
    text = f"{where}: λ_N > 0 on [{start}, τ_lo) and λ_N changes sign at τ_lo, τ_lo in ({decimal_text(lower, upper)})"
    proved = Verdict.proved(text, crossing.evidence)
    whole = positive_to_the_left(force, profile, start)
    if leading.verdict.outcome is not Outcome.PROVED or leading.lower is None or leading.upper is None:
        return SlowLiftOff(
            epsilon=epsilon,
            start=start,
            lower=lower,
            upper=upper,
            lead=None,
            kappa=None,
            whole_line=whole,
            verdict=proved,
            uniform=None,
        )
    kappa, uniform = None, None
    constant = uniform_constant(profile, lower, (leading.lower, leading.upper))
    if constant is not None and constant[0] < _MOST_KAPPA:
        kappa = rounded_up(constant[0], _CONSTANT_DIGITS)
        both = [crossing.evidence, leading.verdict.evidence]
        known = theorem("proofs/monotone.md, section 9", *both, constant[1], at_most(constant[0], kappa))
        uniform = None if known is None else Verdict.proved(_for_all(force, start, epsilon, kappa), known)
    return SlowLiftOff(
        epsilon=epsilon,
        start=start,
        lower=lower,
        upper=upper,
        lead=lead(profile, lower, upper),
        kappa=kappa,
        whole_line=whole,
        verdict=proved,
        uniform=uniform,
    )


def _open(epsilon: fmpq, start: fmpq, text: str, why: str) -> SlowLiftOff:
    verdict = Verdict.undecided(text, Reason.BUDGET, why)
    return SlowLiftOff(
        epsilon=epsilon,
        start=start,
        lower=None,
        upper=None,
        lead=None,
        kappa=None,
        whole_line=False,
        verdict=verdict,
        uniform=None,
    )


def _for_all(force: ContactForce, start: fmpq, epsilon: fmpq, kappa: fmpq) -> str:
    return (
        f"{of_system(SLOW, force)}: for every ε in (0, {short_text(epsilon)}] λ_N > 0 on [{start}, τ_lo(ε)) and "
        f"τ_LO(ε) - {short_text(kappa)} (η/8) τ_LO(ε)^(3/2) <= τ_lo(ε) <= τ_LO(ε), where τ_LO is the lift-off time at "
        f"leading order, η = (ε |α1|/2)^(1/3); τ_lo(ε) decreases strictly in ε"
    )


def rounded_up(value: arb, digits: int) -> fmpq:
    """A decimal number of ``digits`` digits that is at least the value, which is > 0 and finite.

    >>> rounded_up(arb("0.0123451"), 4)
    247/20000
    """
    with working_bits(128):
        tens = math.floor(approximate((value.log() / arb(10).log()).mid()))
        unit = fmpq(10) ** (tens - digits + 1)
        whole = (value / unit).upper().ceil().unique_fmpz()
    assert whole is not None  # an exact number
    return fmpq(whole) * unit
