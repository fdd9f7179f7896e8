"""By how much the slow manifold lifts off before the leading order, 1 < beta < 5: at one epsilon, and for all smaller
ones.

Proof page: ``proofs/monotone.md``, sections 8 and 9.
"""

from __future__ import annotations

from flint import arb, fmpq

from gspot_verified.compliant.slow.profile import Profile
from gspot_verified.numbers.balls import bits_for_digits, working_bits
from gspot_verified.numbers.evidence import at_most, every, less
from gspot_verified.numbers.verdict import Evidence

_DIGITS = 15  # of f and its derivatives, for a bound that is shown with four
_GUARD_BITS = 64  # bits beyond those asked for, lost on the way; any number is right


def lead(profile: Profile, lower: fmpq, upper: fmpq) -> arb | None:
    """A bound of tau_LO - tau_lo, tau_lo in (lower, upper) and tau_LO >= tau_lo the time at leading order:

        (eta/8) f^(4)(upper; eta)/f_0'(lower).

    None unless 1 < beta < 5 and f_0' is certainly positive and increasing from ``lower`` on. The caller vouches that
    the force at leading order is positive before tau_LO.
    """
    if not 1 < profile.beta < 5:
        return None
    with working_bits(bits_for_digits(_DIGITS) + _GUARD_BITS):
        slopes = Profile.leading_order(profile.beta).derivatives(lower, range(1, max(profile.order, 2) + 1), _DIGITS)
        if not all(slope > 0 for slope in slopes):
            return None
        fourth = profile.derivatives(upper, range(4, 5), _DIGITS)[0]
        return (profile.eta(128) / 8 * fourth / slopes[0]).upper()


def uniform_constant(profile: Profile, earliest: fmpq, leading: tuple[fmpq, fmpq]) -> tuple[arb, Evidence] | None:
    """kappa with tau_LO - kappa (eta/8) tau_LO^(3/2) <= tau_lo <= tau_LO for every epsilon up to the one of
    ``profile``.

    At that epsilon ``earliest`` <= tau_lo, and ``leading`` encloses tau_LO. With the hypotheses of the page as
    evidence; None where one is not certain.
    """
    b, n = profile.beta - 1, profile.order
    ordered = every([less(0, b), less(b, 4), less(1, earliest), at_most(earliest, leading[0])])
    if ordered is None:
        return None
    at_zero = Profile.leading_order(profile.beta)
    with working_bits(bits_for_digits(_DIGITS) + _GUARD_BITS):
        first, second, latest = arb(earliest), arb(leading[0]), arb(leading[1])
        at_first = at_zero.derivatives(earliest, range(max(n, 2) + 1), _DIGITS)
        at_second = at_zero.derivatives(leading[0], range(n + 2), _DIGITS)
        evidence = every([
            ordered,
            *(less(0, value) for value in at_first),  # f_0 rises, as its derivatives do
            at_most(at_first[2], first.sqrt() * at_first[1]),
            *(less(0, second * at_second[k + 1] + (k - 4 * b) * at_second[k]) for k in range(n + 1)),
            at_most(5 - b, 2 * first * first.sqrt()),
        ])  # fmt: skip
        if evidence is None:
            return None
        eta = profile.eta(128)
        excess = eta * _fourth_root_of_moment(latest, b, eta) ** 4 / 8
        return (excess.exp() * (1 + arb(max(fmpq(0), 1 - b)) / (first * first.sqrt()))).upper(), evidence


def _fourth_root_of_moment(tau: arb, b: fmpq, eta: arb) -> arb:
    """m with: the mean of rho^4 under rho^(3-b) e^(-rho^3/3 + rho tau + h) is at most m^4."""
    half = eta * tau / 2
    return half + (half * half + tau + eta * (6 - b) + (5 - b) / tau.sqrt()).sqrt()
