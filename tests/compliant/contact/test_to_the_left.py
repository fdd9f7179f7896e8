"""The slow force to the left of a point: each hypothesis by itself. Page: proofs/monotone.md, section 7."""

from __future__ import annotations

import pytest
from flint import fmpq

from gspot_verified.compliant.contact.threshold import slow_force
from gspot_verified.compliant.contact.to_the_left import positive_to_the_left
from gspot_verified.compliant.slow.profile import Profile
from gspot_verified.leading_order.contact_force import contact_force


@pytest.mark.parametrize("beta", ["5/2", "7/3", "9/2"])
@pytest.mark.parametrize("start", [fmpq(-10), fmpq(-4)])
def test_what_is_proved_holds_at_points(beta: str, start: fmpq) -> None:
    for charge in (-1, 1):
        force = contact_force(beta, c1=charge)
        found = positive_to_the_left(force, Profile.of(force, fmpq(1, 10)), start)
        assert found is (charge < 0 and force.mean >= 0)
        for tau in (start, start - 1, start - 5, start - 50):
            assert not found or slow_force(force, tau, fmpq(1, 10), 15) > 0


def test_each_hypothesis_is_needed() -> None:
    """At 7/2 f_0 = -9.2 at 3/2 has the sign that is asked for, and f_0' = -0.4 has not; f_0(3) > 0 has not either."""
    force = contact_force("7/2", c1=-1)
    profile = Profile.leading_order(fmpq(7, 2))
    assert positive_to_the_left(force, profile, fmpq(-10))
    for tau in (fmpq(3, 2), fmpq(3), fmpq(1), fmpq(-1, 4)):
        assert not positive_to_the_left(force, profile, tau)
    for alpha_2, holds in ((-1, False), (1, True)):
        force = contact_force("1/2", alpha_2=alpha_2, c1=-1)
        assert bool(force.mean >= 0) is holds
        assert positive_to_the_left(force, Profile.leading_order(fmpq(1, 2)), fmpq(-10)) is holds
