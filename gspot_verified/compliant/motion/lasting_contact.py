"""Whether the contact in a state lasts for ever: an impact without collision as a statement.

Proof page: ``proofs/flight.md``, section 3.
"""

from __future__ import annotations

from gspot_verified.compliant.model.flight import ContactState
from gspot_verified.compliant.motion.growth_choice import LAGS, growth_rates
from gspot_verified.compliant.motion.growth_set import in_fast_set, in_monotone_set, in_slow_set
from gspot_verified.numbers.balls import approximate, ball_text, rounded_text, working_bits
from gspot_verified.numbers.evidence import every, less
from gspot_verified.numbers.verdict import Reason, Verdict

TEXT = "the contact lasts for ever, λ and −v grow without bound: an impact without collision"


def lasting_contact(state: ContactState, bits: int = 128) -> Verdict:
    """Proved when the state, with p < 0, lies in one of the three invariant sets of the page; otherwise undecided.

    Undecided says nothing about the contact: the sets are sufficient, not necessary.
    """
    with working_bits(bits):
        beyond = less(state.p, 0)
        if beyond is None:
            return Verdict.undecided(TEXT, Reason.HYPOTHESIS, f"p = {ball_text(state.p)} < 0 is not certain")
        if (inside := in_monotone_set(state)) is not None:
            detail = "every derivative of λ in question has one sign (β < 1)"
            return Verdict.proved(TEXT, every([beyond, inside]), detail)
        for rate in growth_rates(state):
            shown = f"a = {rounded_text(approximate(rate), -1, 4)}"  # λ grows at least so fast
            if (inside := in_fast_set(state, rate)) is not None:
                return Verdict.proved(TEXT, every([beyond, inside]), f"invariant set with rate {shown}")
            for lag in LAGS:
                if (inside := in_slow_set(state, rate, lag)) is not None:
                    return Verdict.proved(TEXT, every([beyond, inside]), f"invariant set with {shown}, c = {lag}")
        return Verdict.undecided(TEXT, Reason.HYPOTHESIS, "the state was found in none of the invariant sets")
