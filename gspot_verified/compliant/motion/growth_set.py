"""A set of states from which the contact lasts for ever and its force grows without bound.

Proof page: ``proofs/flight.md``, section 3.
"""

from __future__ import annotations

from dataclasses import dataclass

from flint import arb, fmpq

from gspot_verified.compliant.model.flight import ContactState
from gspot_verified.numbers.evidence import at_most, every, less, theorem
from gspot_verified.numbers.verdict import Evidence

_PAGE = "proofs/flight.md"


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


def load(state: ContactState) -> fmpq | arb:
    """kappa; where alpha_2 > 0 pulls b upwards, kappa + |A|/lambda of the page, not finite where lambda may be 0."""
    return excess(state) if state.pull >= 0 else excess(state) - state.pull / state.force


def in_monotone_set(state: ContactState) -> Evidence | None:
    """Theorem F2 of the page, the load <= 0: everything has one sign."""
    x = slopes(state)
    signs = _not_negative(x.q, x.force, x.W, x.G)
    return theorem(_PAGE, at_most(load(state), 0), signs, less(0, x.D))


def in_fast_set(state: ContactState, a: fmpq) -> Evidence | None:
    """Theorem F3 of the page: q >= kappa/a + 2a + a^2, and lambda grows at least like e^(aT)."""
    kappa = load(state)
    if a <= 0:
        return None
    x = slopes(state)
    wide = at_most(arb(kappa / a + 2 * a + a * a), x.q)
    signs = _not_negative(x.force, x.W, x.G, x.D - a * x.force, x.S - a * (2 + a) * x.force)
    return theorem(_PAGE, less(0, kappa), wide, signs, less(0, x.force) or less(0, x.D))


def in_slow_set(state: ContactState, a: fmpq, c: fmpq) -> Evidence | None:
    """Theorem F4 of the page: the set that holds until q is large enough for the fast set, and leads into it."""
    kappa = excess(state)
    if a <= 0:
        return None
    x = slopes(state)
    last = kappa / a + 2 * a + a * a
    numbers = every([less(a, 1), less(0, c), less(0, kappa), at_most(0, state.pull)])
    signs = every([less(0, x.q), less(0, x.S), _not_negative(x.force, x.W)])
    order = _not_negative(x.D - a * x.force, x.S - a * (x.D + 2 * x.force), x.G - a * x.S, x.D - c * x.S)
    turning = at_most(a * a, (1 - a) * c * (x.q - kappa / a))
    lag = at_most(arb(c * state.pull), (1 - 3 * c - c * c * last) * x.S)
    return theorem(_PAGE, numbers, signs, order, turning, lag)


def _not_negative(*values: arb) -> Evidence | None:
    """That every number in every ball is >= 0; None for a ball without information."""
    return every(at_most(0, value) for value in values)
