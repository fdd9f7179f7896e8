"""The coefficients of a state in the basis of exact solutions, and the exact side rule: the sign of one number K.

Proof pages: ``proofs/first_integrals.md``, sections 6 and 7; ``proofs/flight.md``, section 6, for K at or after the
G-spot.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import ClassVar

from flint import acb, arb, fmpq

from gspot_verified.compliant.fast.fast_bound import fast_bound
from gspot_verified.compliant.fast.fast_coefficient import fast_coefficient, saddle
from gspot_verified.compliant.model.normal_form import CompliantModel, CompliantState, Deviation, deviation
from gspot_verified.compliant.side.side_later import side_of_deviation
from gspot_verified.compliant.slow.slow_coefficient import slow_coefficient
from gspot_verified.numbers.balls import add_remainder, approximate, ball_text, bits_for_digits, sign_of, working_bits
from gspot_verified.numbers.evidence import less
from gspot_verified.numbers.verdict import NoTruthValue, Reason, Verdict
from gspot_verified.numbers.written import Written
from gspot_verified.theta_function.gamma.reciprocal_gamma import reciprocal_gamma

_ATTEMPTS = 4  # with rising precision; then the sign stays open
_GUARD_BITS = 16  # bits beyond those asked for, lost on the way; any number is right
# The bound for all epsilon up to 1/64 of the rate of decay: the fast part is below e^-64 beyond it.
_BOUND_FACTOR = 64
_LINEAR = ("b", "V", "Y", "Z")


@dataclass(frozen=True, slots=True)
class SideRule(NoTruthValue, Written):
    """C, c_+ and K = C/Gamma(-beta) + 2 Re c_+ of a state in contact, in balls (units of the normal form).

    ``slow`` = C, ``fast`` = c_+ (or a ball around 0 where it cannot matter), ``side`` = K; ``verdict``: its sign. For
    p <= 0 K comes by its own integral: ``slow`` and ``fast`` are None, the paper's rule is about the way to the G-spot.
    ``in_case_iii``: beta > 1 is no integer and alpha_2 < 0, as the paper's rule asks.
    K < 0: contact is lost, certainly. K > 0: necessary for an impact without collision, not sufficient.
    """

    written: ClassVar[str] = "C=slow K=side slow_part=slow_side fast_part=fast_side in_case_iii paper_differs verdict"

    state: Deviation
    slow: arb | None
    fast: acb | None
    side: arb
    verdict: Verdict
    in_case_iii: bool

    @property
    def slow_side(self) -> arb | None:
        """C/Gamma(-beta): what the paper's rule looks at; None for p <= 0."""
        if self.slow is None:
            return None
        with working_bits(int(self.slow.bits()) + _GUARD_BITS):
            return self.slow * reciprocal_gamma(-self.state.beta, int(self.slow.bits()) + _GUARD_BITS)

    @property
    def fast_side(self) -> arb | None:
        """2 Re c_+; None for p <= 0."""
        return None if self.fast is None else 2 * self.fast.real

    @property
    def paper_side(self) -> int | None:
        """The paper's rule, the sign of C_1/Gamma(-beta) in Case III; None where it does not apply or is open."""
        part = self.slow_side
        return (sign_of(part) or None) if part is not None and self.in_case_iii else None

    @property
    def paper_differs(self) -> bool | None:
        """Whether the paper's rule gives the other side; None where it does not apply or a sign is open."""
        exact, papers = sign_of(self.side), self.paper_side
        return exact != papers if exact and papers else None

    def __str__(self) -> str:
        if self.slow_side is None or self.fast_side is None:
            about = "p <= 0: the paper's rule, which is about the way to the G-spot, does not apply"
            return "\n".join((str(self.verdict), f"  K = {ball_text(self.side)}", f"  {about}"))
        rule = "the paper's rule gives the other side" if self.paper_differs else "the paper's rule gives the same side"
        if self.paper_differs is None:
            rule = "whether the paper's rule gives the same side is open"
        if not self.in_case_iii:
            rule = "the paper's rule, of Case III (β > 1, no integer, α2 < 0), does not apply"
        parts = f"C/Γ(-β) = {ball_text(self.slow_side)}, 2 Re c+ = {ball_text(self.fast_side)}"
        return "\n".join((str(self.verdict), f"  K = {ball_text(self.side)}, of it {parts}", f"  {rule}"))


def side_rule(model: CompliantModel, state: CompliantState, digits: int = 15) -> SideRule:
    """The exact side rule for a state in contact, before, at or after the G-spot.

    The verdict is proved with the sign of K, or undecided where balls of rising accuracy cannot tell it from 0.

    >>> from gspot_verified import compliant_model, compliant_state
    >>> model = compliant_model("5/2", "1/1000")
    >>> side_rule(model, compliant_state("1/2", "-2/3", "-8/3000000", 0, "-4/3000000")).verdict.outcome.value
    'proved'
    """
    hats = deviation(model, state)
    size = _size(hats)
    unit = replace(hats, **{name: getattr(hats, name) / size for name in _LINEAR})
    goal = bits_for_digits(digits) + _GUARD_BITS
    slow: arb | None = None
    fast: acb | None = None
    for attempt in range(_ATTEMPTS):
        bits = goal * 2**attempt
        if hats.p > 0:
            slow, fast, side = coefficients(unit, bits)
        else:
            side = side_of_deviation(unit, bits)
        with working_bits(bits + _GUARD_BITS):
            slow = None if slow is None else slow * size
            fast = None if fast is None else fast * arb(size)
            side = side * size
        if sign_of(side) is not None:  # 0 too: more bits would not say more
            break
    in_case_iii = model.beta > 1 and model.beta.q != 1 and model.alpha_2 < 0
    return SideRule(hats, slow, fast, side, _verdict(side), in_case_iii)


def _size(state: Deviation) -> fmpq:
    """A power of two next to the largest of the hats, or 1. C, c_+ and K are linear in them (``proofs/
    first_integrals.md``, section 1); the quadratures have an absolute floor, which a small state would fall below."""
    largest = max(abs(getattr(state, name)) for name in _LINEAR)
    return fmpq(2) ** (int(largest.p).bit_length() - int(largest.q).bit_length()) if largest else fmpq(1)


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
    if (negative := less(side, 0)) is not None:
        return Verdict.proved("K < 0: contact is lost at a finite time", negative)
    if (positive := less(0, side)) is not None:
        return Verdict.proved("K > 0: contact may last; necessary for an impact without collision", positive)
    reason = Reason.BEYOND if sign_of(side) == 0 else Reason.BUDGET
    about = "no side follows from K = 0, as on the canard and, at an integer β, on the whole slow manifold"
    return Verdict.undecided("the sign of K", reason, f"K = {ball_text(side)}; {about}")
