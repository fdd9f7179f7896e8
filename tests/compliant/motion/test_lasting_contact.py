"""Which invariant set a verdict names, and that nothing is said outside of them; proofs/flight.md, section 3."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction

import pytest
from flint import arb, fmpq

from gspot_verified.compliant.model.flight import ContactState
from gspot_verified.compliant.motion import lasting_contact as module
from gspot_verified.compliant.motion.growth_set import in_fast_set, in_monotone_set, in_slow_set
from gspot_verified.compliant.motion.lasting_contact import lasting_contact
from gspot_verified.numbers.verdict import Outcome

SMALL = fmpq(1, 128)


def state(beta: fmpq, q: fmpq, force: fmpq, D: fmpq, W: fmpq, G: fmpq) -> ContactState:
    """A state with these slopes: b from G = -(b + p lambda), Y from D = -2 lambda - Y - V; epsilon = A = 1/128."""
    return ContactState(
        beta, SMALL, fmpq(-1), arb(-q), arb(q * force - G), arb(-W), arb(-D - 2 * force + W), arb(force)
    )


BELOW_ONE = state(fmpq(1, 2), fmpq(1, 10), fmpq(1), fmpq(1), fmpq(1), fmpq(1))
FAST = state(fmpq(3, 2), fmpq(3), fmpq(1), fmpq(1), fmpq(3), fmpq(3))
SLOW = state(fmpq(3, 2), fmpq(1, 8), fmpq(0), fmpq(1), fmpq(3, 4), fmpq(1, 4))


@pytest.mark.parametrize(
    ("one", "detail"),
    [(BELOW_ONE, "every derivative"), (FAST, "invariant set with rate a = "), (SLOW, "invariant set with a = ")],
)
def test_each_set_proves_a_contact_for_ever(one: ContactState, detail: str) -> None:
    found = lasting_contact(one)
    assert found.outcome is Outcome.PROVED
    assert found.detail.startswith(detail)
    # The same numbers with W = -V turned: no set holds them.
    assert lasting_contact(replace(one, V=-one.V)).outcome is Outcome.UNDECIDED


@pytest.mark.parametrize("p", [arb(0), arb(1), arb(-1, 2), arb(fmpq(1, 2))])
def test_before_the_g_spot_nothing_is_said(p: arb) -> None:
    found = lasting_contact(replace(BELOW_ONE, p=p))
    assert found.outcome is Outcome.UNDECIDED
    assert "< 0 is not certain" in found.detail


def test_a_verdict_rests_on_a_set(monkeypatch: pytest.MonkeyPatch) -> None:
    for name in ("in_monotone_set", "in_fast_set", "in_slow_set"):
        monkeypatch.setattr(module, name, lambda *_: None)
    for one in (BELOW_ONE, FAST, SLOW):
        assert lasting_contact(one).outcome is Outcome.UNDECIDED


# The hypotheses of Theorems F2 to F4, 2^-40 beside each equality

TINY = fmpq(1, 2**40)


def held(in_set: Callable[..., object], *arguments: object) -> bool:
    """Whether a set says that it holds the state."""
    found = in_set(*arguments)
    return found is not None and found is not False


RATE, LAG, KAPPA = fmpq(1, 2), fmpq(1, 8), SMALL / 2
BASE = {"beta": fmpq(3, 2), "q": fmpq(4), "force": fmpq(1), "D": fmpq(1), "W": fmpq(2), "G": fmpq(5)}


def test_the_hypotheses_of_theorem_f2() -> None:
    below = {**BASE, "beta": fmpq(1, 2)}
    assert held(in_monotone_set, state(**below))
    assert held(in_monotone_set, state(**{**below, "beta": fmpq(1)}))
    assert not held(in_monotone_set, state(**{**below, "beta": 1 + TINY}))
    for name in ("q", "force", "W", "G"):
        assert held(in_monotone_set, state(**{**below, name: fmpq(0)}))
        assert not held(in_monotone_set, state(**{**below, name: -TINY}))
    assert held(in_monotone_set, state(**{**below, "D": TINY}))
    assert not held(in_monotone_set, state(**{**below, "D": fmpq(0)}))
    assert held(in_monotone_set, replace(state(**below), alpha_2=fmpq(0)))
    # alpha_2 > 0: lambda is not below the mean force alpha_2/(1 - beta)
    assert held(in_monotone_set, replace(state(**below), alpha_2=fmpq(1, 2)))
    assert not held(in_monotone_set, replace(state(**below), alpha_2=fmpq(1, 2) + TINY))


def test_the_hypotheses_of_theorem_f3() -> None:
    a = RATE
    edge = KAPPA / a + 2 * a + a * a
    for name, least in (("q", edge), ("force", fmpq(0)), ("D", a), ("W", fmpq(0))):
        assert held(in_fast_set, state(**{**BASE, name: least}), a)
        assert not held(in_fast_set, state(**{**BASE, name: least - TINY}), a)
    # G >= 0, with S large enough; S >= a (2 + a) lambda, with G > 0
    assert held(in_fast_set, state(**{**BASE, "G": fmpq(0)}), a)
    assert not held(in_fast_set, state(**{**BASE, "G": -TINY}), a)
    assert held(in_fast_set, state(**{**BASE, "W": fmpq(1, 4), "G": fmpq(1)}), a)
    assert not held(in_fast_set, state(**{**BASE, "W": fmpq(1, 4), "G": 1 - TINY}), a)
    for force, D in ((fmpq(0), fmpq(0)), (fmpq(0), TINY), (TINY, TINY)):
        assert held(in_fast_set, state(**{**BASE, "force": force, "D": D}), a) is bool(D > 0)
    for beta, rate in ((fmpq(1), a), (fmpq(1, 2), a), (fmpq(3, 2), fmpq(0)), (fmpq(3, 2), -a)):
        assert not held(in_fast_set, state(**{**BASE, "beta": beta}), rate)
    assert held(in_fast_set, replace(state(**BASE), alpha_2=fmpq(0)), a)
    # alpha_2 > 0: kappa + epsilon alpha_2/lambda in the place of kappa
    pulled = {**BASE, "q": edge + SMALL * 3 / a}
    assert held(in_fast_set, replace(state(**pulled), alpha_2=fmpq(3)), a)
    assert not held(in_fast_set, replace(state(**pulled), alpha_2=3 + TINY), a)


def test_the_hypotheses_of_theorem_f4() -> None:
    a, c = RATE, LAG
    good = {**BASE, "q": fmpq(5), "D": fmpq(2), "W": fmpq(1), "G": fmpq(2)}

    def holds(rate: fmpq = a, lag: fmpq = c, **changes: fmpq) -> bool:
        return held(in_slow_set, state(**{**good, **changes}), rate, lag)

    assert holds()
    assert holds(force=fmpq(0))
    assert not holds(force=-TINY)
    assert holds(W=fmpq(0))
    assert not holds(W=-TINY)
    assert holds(D=a)  # D = a lambda
    assert not holds(D=a - TINY)
    assert holds(force=fmpq(0), D=fmpq(1, 4), G=fmpq(1))  # D = c S
    assert not holds(force=fmpq(0), D=fmpq(1, 4), G=1 + TINY)
    assert holds(W=fmpq(1, 2), G=fmpq(3, 2))  # S = a M
    assert not holds(W=fmpq(1, 2), G=fmpq(3, 2), D=2 + TINY)
    assert holds(force=fmpq(1, 8), G=fmpq(1))  # G = a S
    assert not holds(force=fmpq(1, 8), G=fmpq(1), W=1 + TINY)
    edge = KAPPA / a + a * a / ((1 - a) * c)
    assert holds(q=edge)
    assert not holds(q=edge - TINY)
    # (1 - 3c - c^2 q_1) S >= cA: S = W + G, A = epsilon |alpha_2|
    one = state(**good)
    last = KAPPA / a + 2 * a + a * a
    pull = (1 - 3 * c - c * c * last) * 3 / c / SMALL
    assert held(in_slow_set, replace(one, alpha_2=-pull), a, c)
    assert not held(in_slow_set, replace(one, alpha_2=-pull - TINY), a, c)
    assert held(in_slow_set, replace(one, alpha_2=fmpq(0)), a, c)
    assert not held(in_slow_set, replace(one, alpha_2=TINY), a, c)
    nothing = state(**{**good, "force": fmpq(0), "D": fmpq(0), "W": fmpq(0), "G": fmpq(0)})
    assert not held(in_slow_set, replace(nothing, alpha_2=fmpq(0)), a, c)  # S > 0
    # At a large kappa the signs of 1 - a and c would make up for q < kappa/a.
    large = replace(state(**{**good, "force": fmpq(0), "D": fmpq(4)}), epsilon=fmpq(10**4), alpha_2=fmpq(0))
    for rate, lag in ((fmpq(3, 2), fmpq(1, 100)), (fmpq(1, 2), fmpq(-1, 100)), (fmpq(1, 2), fmpq(1, 100))):
        assert (1 - rate) * lag * (5 - 5000 / rate) >= rate**2 or (rate < 1 and lag > 0)
        assert not held(in_slow_set, large, rate, lag)
    for rate, lag in ((fmpq(0), c), (fmpq(1), c), (a, fmpq(0)), (-a, c), (a, -c)):
        assert not holds(rate, lag, q=fmpq(10**6))
    assert not holds(beta=fmpq(1))


def test_the_accuracy_that_is_not_asked_for_is_enough() -> None:
    """G = 2^-40 is certainly positive: 128 bits tell it from 0, few bits do not."""
    near = state(fmpq(1, 2), fmpq(1, 3), fmpq(1), fmpq(1), fmpq(1), TINY)
    assert lasting_contact(near).outcome is Outcome.PROVED
    assert lasting_contact(near, 20).outcome is Outcome.UNDECIDED


def test_the_rate_is_rounded_down(monkeypatch: pytest.MonkeyPatch) -> None:
    """It says how fast the force grows at least."""
    rate = next(rate for rate in module.growth_rates(FAST) if in_fast_set(FAST, rate) is not None)
    for more in (0, 1, 2, 3, 5, 7):
        tried = rate * (1 + fmpq(more, 7919))
        monkeypatch.setattr(module, "growth_rates", lambda _, tried=tried: [tried])
        shown = lasting_contact(FAST).detail.rpartition(" ")[2]
        assert tried * fmpq(999, 1000) < fmpq(Fraction(shown).numerator, Fraction(shown).denominator) <= tried
