"""Lift-off on the slow manifold: known times, signs around the bracket, the leading order, all small eps.

Page: proofs/monotone.md.
"""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

import pytest
from flint import arb, fmpq
from hypothesis import given, settings
from hypothesis import strategies as st
from samples.strategies import to_fmpq

from gspot_verified import Outcome, iwc
from gspot_verified.compliant.contact import crossing
from gspot_verified.compliant.contact.crossing import first_crossing
from gspot_verified.compliant.contact.delay import uniform_constant
from gspot_verified.compliant.contact.slow_lift_off import SlowLiftOff, rounded_up, slow_lift_off
from gspot_verified.compliant.contact.taylor_cell import TaylorCell
from gspot_verified.compliant.contact.threshold import slow_force
from gspot_verified.compliant.contact.to_the_left import positive_to_the_left
from gspot_verified.compliant.slow.profile import Profile
from gspot_verified.leading_order.contact_force import ContactForce, contact_force
from gspot_verified.leading_order.lift_off import lift_off
from gspot_verified.numbers.balls import exact, working_bits

START = fmpq(-10)
KNOWN = {
    "3/2": ("3.53007", "4.91598", "6.995993"),
    "7/3": ("5.21133", "7.96038", "12.073180"),
    "5/2": ("5.43517", "8.44175", "12.913006"),
    "7/2": ("7.10684", "11.35514", "17.690110"),
    "9/2": ("8.55653", "13.90092", "21.865209"),
    "13/2": ("11.03118", "18.32451", "29.155673"),
}
BETAS = st.fractions(Fraction(10, 9), Fraction(44, 9), max_denominator=9).filter(lambda b: b.denominator > 1)


def falling(beta: Fraction | str) -> ContactForce:
    """The system whose force tends to -infinity, |C_1| = 1."""
    return contact_force(beta, c1=-contact_force(beta).c1)


def found_at(force: ContactForce, epsilon: fmpq, digits: int = 8) -> SlowLiftOff:
    return slow_lift_off(force, lift_off(force, epsilon, START, digits), START, digits)


@pytest.mark.parametrize("beta", KNOWN)
def test_known_times(beta: str) -> None:
    """Found before in balls of 64 to 80 bits by quadrature, at 10^-3, 10^-6, 10^-12."""
    for exponent, text in zip((3, 6, 12), KNOWN[beta], strict=True):
        found = found_at(falling(beta), fmpq(10) ** -exponent)
        assert found.lower is not None
        assert found.upper is not None
        assert abs(arb(found.lower) - arb(text)) < fmpq(10) ** -(len(text.split(".")[1]))
        assert found.upper - found.lower <= fmpq(1, 10**8)
        assert (found.kappa is None) == (beta == "13/2")


@settings(max_examples=12, deadline=None)
@given(BETAS, st.integers(2, 40), st.lists(st.fractions(0, 1, max_denominator=60), min_size=4, max_size=4))
def test_the_force_is_positive_before_and_negative_after(beta: Fraction, tens: int, shares: list[Fraction]) -> None:
    force, epsilon = falling(beta), fmpq(10) ** -tens
    leading = lift_off(force, epsilon, START, 8)
    if leading.verdict.outcome is not Outcome.PROVED or leading.lower is None or leading.upper is None:
        return
    found = slow_lift_off(force, leading, START, 8)
    assert found.verdict.outcome is Outcome.PROVED
    assert found.lower is not None
    assert found.upper is not None
    assert found.lower < leading.upper
    assert slow_force(force, found.upper, epsilon, 30) < 0 < slow_force(force, found.lower, epsilon, 30)
    for share in shares:
        assert slow_force(force, START + to_fmpq(share) * (found.lower - START), epsilon, 20) > 0
    if found.lead is not None:
        assert leading.lower - found.lower <= found.lead + fmpq(1, 10**7)


@settings(max_examples=8, deadline=None)
@given(BETAS, st.integers(0, 12), st.integers(13, 200))
def test_the_uniform_bound_holds_at_smaller_epsilon(beta: Fraction, tenths: int, smaller: int) -> None:
    """kappa from eps = 10^-3, tried at other eps down to 10^-200: it is not violated, and it is not absurdly large."""
    force = falling(beta)
    first = found_at(force, fmpq(1, 1000))
    if first.kappa is None:
        return
    assert fmpq(1) <= first.kappa < 6
    for epsilon in (fmpq(1, 1000 + 300 * tenths), fmpq(10) ** -smaller):
        leading = lift_off(force, epsilon, START, 20)
        there = slow_lift_off(force, leading, START, 20)
        assert leading.lower is not None
        assert leading.upper is not None
        assert there.lower is not None
        assert there.upper is not None
        with working_bits(200):
            eta = (arb(epsilon) / 2).root(3)
            allowed = first.kappa * eta / 8 * arb(leading.upper) ** arb(fmpq(3, 2))
            assert leading.lower - there.upper <= allowed
            least = eta / 8 * arb(leading.lower) ** arb(fmpq(3, 2)) / 2
            assert smaller > 60 or leading.upper - there.lower >= least


@settings(max_examples=25, deadline=None)
@given(
    st.fractions(Fraction(10, 9), 12, max_denominator=9).filter(lambda b: b.denominator > 1),
    st.fractions(0, 1, max_denominator=8),
    st.fractions(-6, 6, max_denominator=9),
    st.fractions(Fraction(1, 30), 2, max_denominator=30),
    st.fractions(0, 1, max_denominator=50),
)
def test_bounds_on_a_cell(beta: Fraction, root: Fraction, left: Fraction, wide: Fraction, share: Fraction) -> None:
    profile = Profile.at_root(to_fmpq(beta), to_fmpq(root)) if root else Profile.leading_order(to_fmpq(beta))
    lower, upper = to_fmpq(left), to_fmpq(left + wide)
    cell = TaylorCell(profile, lower, upper, 20)
    with working_bits(128):
        here = profile.derivatives(lower + to_fmpq(share) * (upper - lower), range(2), 25)
        assert cell.least <= here[0]
        assert here[0] <= cell.greatest
        assert not cell.rising or here[1] > 0


@settings(max_examples=40, deadline=None)
@given(
    BETAS,
    st.fractions(Fraction(1, 10), 25, max_denominator=20),
    st.fractions(Fraction(1, 50), Fraction(3, 2), max_denominator=50),
)
def test_the_steps_of_the_uniform_bound(beta: Fraction, tau: Fraction, root: Fraction) -> None:
    """(ii) of section 9 at any tau > 0; (i) where its hypotheses hold; theta(x) >= 1 - x/2; the mean of rho^4."""
    parameter, place, eta = to_fmpq(beta), to_fmpq(tau), to_fmpq(root)
    profile, leading = Profile.at_root(parameter, eta), Profile.leading_order(parameter)
    with working_bits(150):
        b, at = parameter - 1, arb(place)
        fourth, eighth = (profile.derivatives(place, range(k, k + 1), 20)[0] for k in (4, 8))
        f = leading.derivatives(place, range(5), 20)
        half = eta * at / 2
        m = half + (half * half + at + eta * (6 - b) + (5 - b) / at.sqrt()).sqrt()
        assert fourth > f[4]
        assert fourth <= (eta * m**4 / 8).exp() * f[4]
        assert eighth <= m**4 * fourth
        if all(value > 0 for value in f[:3]) and f[2] <= at.sqrt() * f[1]:
            further = leading.derivatives(place + 1, range(5), 20)
            assert further[2] <= arb(place + 1).sqrt() * further[1]
            assert f[4] <= (at * at.sqrt() + 1 - b) * f[1]
    x = Fraction(root)
    assert (x + 2) / (2 * (1 + x)) >= max(1 - x / 2, Fraction(1, 2))


def test_hypotheses_of_the_uniform_bound() -> None:
    """Each is checked: below 1 nothing is said, and an end too far to the left violates one."""
    profile = Profile(fmpq(5, 2), fmpq(1, 1000))
    assert uniform_constant(profile, fmpq(27, 5), (fmpq(553, 100), fmpq(554, 100))) is not None
    assert uniform_constant(profile, fmpq(1, 2), (fmpq(553, 100), fmpq(554, 100))) is None
    assert uniform_constant(profile, fmpq(27, 5), (fmpq(2), fmpq(554, 100))) is None
    assert uniform_constant(profile, fmpq(27, 10), (fmpq(27, 10), fmpq(554, 100))) is None
    assert uniform_constant(Profile(fmpq(11, 2), fmpq(1, 1000)), fmpq(9), (fmpq(10), fmpq(11))) is None


def test_to_the_left() -> None:
    force = contact_force("5/2")
    epsilon = fmpq(1, 10)
    assert positive_to_the_left(force, Profile.of(force, epsilon), START)
    assert all(slow_force(force, -(fmpq(10) ** k), epsilon) > force.mean for k in range(1, 6))
    assert not positive_to_the_left(force, Profile.of(force, epsilon), fmpq(1))
    rising = contact_force("7/2")
    assert not positive_to_the_left(rising, Profile.of(rising, epsilon), START)
    assert slow_force(rising, fmpq(-(10**4)), epsilon) < 0


def test_a_start_after_the_lift_off_is_refuted() -> None:
    force = falling("3/2")
    found = slow_lift_off(force, lift_off(force, fmpq(1, 1000), fmpq(4), 8), fmpq(4), 8)
    assert found.verdict.outcome is Outcome.REFUTED
    with pytest.raises(ValueError, match="c1"):
        slow_lift_off(contact_force("3/2"), lift_off(force, fmpq(1, 1000), START, 8), START)


def test_an_epsilon_out_of_range_keeps_the_leading_order_and_its_caveat() -> None:
    found = iwc("3/2", c1=-1, epsilon="1e-400", digits=5)
    assert found.compliant is None
    assert found.verdict.outcome is Outcome.PROVED
    direct = slow_lift_off(falling("3/2"), lift_off(falling("3/2"), fmpq(10) ** -400, START, 5), START)
    assert direct.verdict.outcome is Outcome.UNDECIDED


def test_a_level_that_is_nearly_touched_is_undecided(monkeypatch: pytest.MonkeyPatch) -> None:
    """At beta = 7/3 the greatest value before the last rise, as a level, cannot be told from the function."""
    monkeypatch.setattr(crossing, "MAX_CELLS", 200)
    profile = Profile(fmpq(10, 3), fmpq(1, 100))
    places = [fmpq(k, 50) for k in range(-100, 200)]
    top = max((profile.value(place, 12).mid() for place in places[:150]), key=float)
    assert first_crossing(profile, fmpq(-2), lambda _: arb(top, 1), 6) is None


def test_ends_without_their_signs_are_no_crossing(monkeypatch: pytest.MonkeyPatch) -> None:
    """The bisection answers with another interval: its ends are compared once more, as evidence."""
    profile = Profile(fmpq(5, 2), fmpq(1, 100))
    found = first_crossing(profile, fmpq(-2), lambda _: arb(20), 6)
    assert found is not None
    assert f"cover [-2, {found.lower}]" in str(found.evidence)
    for wrong in ((found.lower - 1, found.lower), (found.upper, found.upper + 1), (found.upper, found.lower)):
        monkeypatch.setattr(crossing, "narrowed", lambda *_, wrong=wrong: wrong)
        assert first_crossing(profile, fmpq(-2), lambda _: arb(20), 6) is None


def test_an_interval_that_is_left_out_is_no_crossing(monkeypatch: pytest.MonkeyPatch) -> None:
    profile = Profile(fmpq(10, 3), fmpq(1, 100))
    assert first_crossing(profile, fmpq(-2), lambda _: arb(5), 6) is not None
    monkeypatch.setattr(crossing, "halves", lambda lower, upper: (((lower + upper) / 2, upper),))
    assert first_crossing(profile, fmpq(-2), lambda _: arb(5), 6) is None


def test_without_a_hypothesis_of_the_constant_nothing_is_said_for_smaller_epsilon(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    force = contact_force("3/2", c1=-1)
    leading = lift_off(force, fmpq(1, 1000), START, 6)
    found = slow_lift_off(force, leading, START, 6)
    assert found.uniform is not None
    assert str(leading.verdict.evidence) in str(found.uniform.evidence)
    not_finite = (arb("nan"), found.verdict.evidence)
    monkeypatch.setattr("gspot_verified.compliant.contact.slow_lift_off.uniform_constant", lambda *_: not_finite)
    without = slow_lift_off(force, leading, START, 6)
    assert (without.kappa, without.uniform) == (None, None)
    assert (without.verdict.outcome, without.bracket) == (Outcome.PROVED, found.bracket)
    monkeypatch.undo()
    monkeypatch.setattr("gspot_verified.compliant.contact.delay.at_most", lambda *_: None)
    assert slow_lift_off(force, leading, START, 6).uniform is None


def test_a_constant_that_no_memory_holds_is_not_stated() -> None:
    """kappa is e^(3.7 10^12) here: to write it ended the process; at smaller epsilon it had millions of digits."""
    found = iwc(alpha_1=-187500, alpha_2="-39/32", alpha_3="-81937500/101", c1="1/500000000", epsilon="7/3", digits=3)
    assert found.lift_off is not None
    assert (found.lift_off.kappa, found.lift_off.uniform) == (None, None)
    assert found.verdict.outcome is Outcome.PROVED


def test_the_bracket_and_the_lines_of_the_text() -> None:
    found = found_at(contact_force("3/2", c1=-1), fmpq(1, 1000), 6)
    assert found.bracket == (found.lower, found.upper) != (None, None)
    assert replace(found, lower=None).bracket is replace(found, upper=None).bracket is None
    assert found.lead is not None
    first, second, third, fourth = found.lines()
    assert (first, third) == (str(found.verdict), "  λ_N > 0 for every τ < -10 as well")
    assert second.startswith("  before the lift-off at leading order, by at most 0.08")
    assert found.lead <= exact(second.split("at most ")[1].split()[0], "lead")
    assert fourth == str(found.uniform)
    assert replace(found, lead=None, uniform=None).lines() == [first, third]
    assert replace(found, whole_line=False).lines() == [first, second, fourth]


@pytest.mark.parametrize("value", ["0.0123451", "0.01234", "9.9999", "99995", "1e-30", "2"])
def test_rounded_up_to_a_decimal_that_is_not_less(value: str) -> None:
    """One of four digits, at most the second one above."""
    true = exact(value, "value")
    with working_bits(100):
        found = rounded_up(arb(true), 4)
        assert arb(true) <= found
    assert found - true <= true * fmpq(1, 10**3)
    tens = found * 10**40
    while tens > 10**5:
        tens /= 10
    assert tens.q == 1
