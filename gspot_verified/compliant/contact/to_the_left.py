"""The slow contact force to the left of a point, at one epsilon.

Proof page: ``proofs/monotone.md``, section 7.
"""

from __future__ import annotations

from flint import fmpq

from gspot_verified.compliant.slow.profile import Profile
from gspot_verified.leading_order.contact_force import ContactForce


def positive_to_the_left(force: ContactForce, profile: Profile, start: fmpq, digits: int = 15) -> bool:
    """Whether the deviation of lambda_N is certainly > 0 on (-infinity, start]: C_1 < 0, and G_b, ..., G_(b-n+1) > 0 at
    the start (proofs/monotone.md, section 7); the mean force must be >= 0.

    >>> from gspot_verified.leading_order.contact_force import contact_force
    >>> system = contact_force("5/2")
    >>> positive_to_the_left(system, Profile.of(system, fmpq(1, 10)), fmpq(-10))
    True
    """
    if force.direction > 0 or force.mean < 0:
        return False
    values = profile.derivatives(start, range(profile.order), digits)
    # G_(b-k) = f^(k)/(beta s (-b)_k), and s (-b)_k has the sign -(sign Gamma(-beta)) (-1)^k for k < n.
    return all(-profile.direction * (-1) ** k * value > 0 for k, value in enumerate(values))
