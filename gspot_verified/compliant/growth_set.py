"""A set of states from which the contact lasts for ever and its force grows without bound.

Proof page: ``proofs/flight.md``, section 3.
"""

from __future__ import annotations

from dataclasses import dataclass

from flint import arb, fmpq

from gspot_verified.compliant.flight import ContactState


@dataclass(frozen=True, slots=True)
class Slopes:
    """The state in the variables of the page: q = -p, W = -V, G = -(b + p lambda), S = W + G, D = d lambda/dT."""

    q: arb
    force: arb
    D: arb
    W: arb
    G: arb

    @property
    def S(self) -> arb:
        """W + G, the rate of 2 lambda + D."""
        return self.W + self.G


def slopes(state: ContactState) -> Slopes:
    """The variables of the growth set, at the current precision."""
    return Slopes(-state.p, state.force, state.force_rate, -state.V, -(state.b + state.p * state.force))


def excess(state: ContactState) -> fmpq:
    """kappa = epsilon (beta - 1)."""
    return state.epsilon * (state.beta - 1)


def in_monotone_set(state: ContactState) -> bool:
    """Theorem F2 of the page, beta <= 1: everything has one sign."""
    x = slopes(state)
    signs = _not_negative(x.q, x.force, x.W, x.G) and x.D > 0
    return bool(excess(state) <= 0 and state.pull >= 0 and signs)


def in_fast_set(state: ContactState, a: fmpq) -> bool:
    """Theorem F3 of the page: q >= kappa/a + 2a + a^2, and lambda grows at least like e^(aT)."""
    kappa = excess(state)
    if not (a > 0 and kappa > 0 and state.pull >= 0):
        return False
    x = slopes(state)
    wide = x.q >= kappa / a + 2 * a + a * a
    signs = _not_negative(x.force, x.W, x.G, x.D - a * x.force, x.S - a * (2 + a) * x.force)
    return bool(wide and signs and (x.force > 0 or x.D > 0))


def in_slow_set(state: ContactState, a: fmpq, c: fmpq) -> bool:
    """Theorem F4 of the page: the set that holds until q is large enough for the fast set, and leads into it."""
    kappa = excess(state)
    if not (0 < a < 1 and c > 0 and kappa > 0 and state.pull >= 0):
        return False
    x = slopes(state)
    last = kappa / a + 2 * a + a * a
    signs = _not_negative(x.force, x.W) and x.S > 0
    order = _not_negative(x.D - a * x.force, x.S - a * (x.D + 2 * x.force), x.G - a * x.S, x.D - c * x.S)
    turning = (1 - a) * c * (x.q - kappa / a) >= a * a
    lag = (1 - 3 * c - c * c * last) * x.S >= arb(c * state.pull)
    return bool(x.q > 0 and signs and order and turning and lag)


def _not_negative(*values: arb) -> bool:
    """Whether every number in every ball is >= 0; a ball without information is not."""
    return all(value >= 0 for value in values)
