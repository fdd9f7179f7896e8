"""The coefficients of a state in the basis of exact solutions, and the exact side rule: the sign of one number K.

Proof page: ``proofs/first_integrals.md``, sections 6 and 7.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar

from flint import acb, arb, fmpq

from gspot_verified.balls import add_remainder, approximate, ball_text, bits_for_digits, sign_of, working_bits
from gspot_verified.compliant.fast_bound import fast_bound
from gspot_verified.compliant.fast_coefficient import fast_coefficient, saddle
from gspot_verified.compliant.normal_form import CompliantModel, CompliantState, Deviation, deviation
from gspot_verified.compliant.slow_coefficient import slow_coefficient
from gspot_verified.dyadic import Dyadic
from gspot_verified.theta_function.reciprocal_gamma import reciprocal_gamma
from gspot_verified.verdict import ASK_VERDICT, NoTruthValue, Reason, Verdict

_ATTEMPTS = 4
_GUARD_BITS = 16
# The bound for all epsilon up to 1/64 of the rate of decay: the fast part is below e^-64 beyond it.
_BOUND_FACTOR = 64


@dataclass(frozen=True, slots=True)
class SideRule(NoTruthValue):
    """C, c_+ and K = C/Gamma(-beta) + 2 Re c_+ of a state with p > 0, in balls (units of the normal form).

    ``slow`` = C, ``fast`` = c_+ (or a ball around 0 where it cannot matter), ``side`` = K; ``verdict``: its sign.
    K < 0: contact is lost, certainly. K > 0: necessary for an impact without collision, not sufficient.
    """

    ask: ClassVar[str] = ASK_VERDICT

    state: Deviation
    slow: arb
    fast: acb
    side: arb
    verdict: Verdict

    @property
    def slow_side(self) -> arb:
        """C/Gamma(-beta): what the paper's rule looks at."""
        with working_bits(int(self.slow.bits()) + _GUARD_BITS):
            return self.slow * reciprocal_gamma(-self.state.beta, int(self.slow.bits()) + _GUARD_BITS)

    @property
    def paper_differs(self) -> bool | None:
        """Whether the paper's rule, the sign of C_1/Gamma(-beta), gives the other side; None when a sign is open."""
        exact, slow = sign_of(self.side), sign_of(self.slow_side)
        return exact != slow if exact and slow else None

    def __str__(self) -> str:
        rule = {True: "the paper's rule gives the other side", False: "the paper's rule gives the same side"}
        lines = [
            str(self.verdict),
            f"  K = {ball_text(self.side)}, of it C/Γ(-β) = {ball_text(self.slow_side)}, "
            f"2 Re c+ = {ball_text(2 * self.fast.real)}",
            f"  {rule.get(self.paper_differs, 'whether the paper has the same side is open')}"
            if self.paper_differs is not None
            else "  whether the paper's rule gives the same side is open",
        ]
        return "\n".join(lines)

    def to_json(self) -> dict[str, Any]:
        """Plain data for ``json.dumps``; balls as exact intervals."""
        return {
            "C": str(Dyadic.from_ball(self.slow)),
            "K": str(Dyadic.from_ball(self.side)),
            "slow_part": str(Dyadic.from_ball(self.slow_side)),
            "fast_part": str(Dyadic.from_ball(2 * self.fast.real)),
            "paper_differs": self.paper_differs,
            "verdict": self.verdict.to_json(),
        }


def side_rule(model: CompliantModel, state: CompliantState, digits: int = 15) -> SideRule:
    """The exact side rule for a state in contact with p > 0.

    The verdict is proved with the sign of K, or undecided where balls of rising accuracy cannot tell it from 0.

    :raises ValueError: p <= 0.

    >>> from gspot_verified.compliant.normal_form import compliant_model, compliant_state
    >>> model = compliant_model("5/2", "1/1000")
    >>> side_rule(model, compliant_state("1/2", "-2/3", "-8/3000000", 0, "-4/3000000")).verdict.outcome.value
    'proved'
    """
    hats = deviation(model, state)
    if not hats.p > 0:
        raise ValueError(f"p: expected a state before the G-spot, p > 0, got {hats.p}")
    goal = bits_for_digits(digits) + _GUARD_BITS
    for attempt in range(_ATTEMPTS):
        slow, fast, side = coefficients(hats, goal * 2**attempt)
        if sign_of(side) not in (None, 0):
            break
    return SideRule(hats, slow, fast, side, _verdict(side))


def coefficients(state: Deviation, bits: int) -> tuple[arb, acb, arb]:
    """C, c_+ and K, p > 0; the fast one by its bound where that is below 2^-bits of the slow part of K."""
    slow = slow_coefficient(state, bits)
    with working_bits(bits + _GUARD_BITS):
        part = slow * reciprocal_gamma(-state.beta, bits + _GUARD_BITS)
        fast = _negligible(state, part, bits)
        if fast is None:
            fast = fast_coefficient(state, bits)
        return slow, fast, part + 2 * fast.real


def _negligible(state: Deviation, part: arb, bits: int) -> acb | None:
    """A ball around 0 that contains c_+, when it is small enough beside ``part``; else None."""
    with working_bits(64):
        top = saddle(state.p)
        rate = -((1 + top).log() + top * (state.p - 1 + top / 2 + top * top / 3)).real
        largest = fmpq(*approximate(rate).as_integer_ratio()) / _BOUND_FACTOR
        if state.epsilon > largest:
            return None
        bound = fast_bound(state, largest).at(state.epsilon)
        if not 2 * bound < part.abs_lower() * arb(2) ** -bits:
            return None
        around = add_remainder(arb(0), bound)
        return acb(around, around)


def _verdict(side: arb) -> Verdict:
    sign = sign_of(side)
    if sign == -1:
        return Verdict.proved("K < 0: contact is lost at a finite time")
    if sign == 1:
        return Verdict.proved("K > 0: contact may last; necessary for an impact without collision")
    return Verdict.undecided("the sign of K", Reason.BUDGET, f"K = {ball_text(side)}: K = 0 is the canard")
