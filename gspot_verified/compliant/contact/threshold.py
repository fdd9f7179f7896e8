"""The largest epsilon_0 such that the slow contact force stays positive on a half-line for every epsilon < epsilon_0:
exactly, that is for the compliant model and not at leading order, where the force grows with eta (beta < 5).

Proof page: ``proofs/monotone.md``, section 6.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import ClassVar

from flint import arb, fmpq

from gspot_verified.compliant.contact.least_value import LeastValue, least_value
from gspot_verified.compliant.slow.profile import Profile, scaled_epsilon
from gspot_verified.compliant.slow.slow_solution import MAX_EPSILON, MAX_TENS
from gspot_verified.leading_order.contact_force import ContactForce, below_threshold, rounded_down
from gspot_verified.numbers.balls import approximate, working_bits
from gspot_verified.numbers.evidence import at_most, every, less
from gspot_verified.numbers.verdict import Evidence, NoTruthValue
from gspot_verified.numbers.written import Written

MAX_BETA_OF_THEOREM = 5  # Theorem C needs beta < 5: proofs/monotone.md
MAX_STEPS = 60  # of epsilon, upwards, against endless work; the bound so far holds
_SPARE_DIGITS = 3  # beyond those asked for, besides what the exponent loses


@dataclass(frozen=True, slots=True)
class Threshold(NoTruthValue, Written):
    """The force is positive on the half-line for every epsilon < ``lower``, and not at epsilon = ``upper``, which
    ``place`` shows (lambda_N <= 0 there). ``every_epsilon``: it is positive at every epsilon > 0, and both are None.
    ``upper`` is None when the search ended before; ``steps`` counts the iterations. ``evidence``: what shows that,
    beside what was proved to begin with; None where it is not certain."""

    ask: ClassVar[str] = ".every_epsilon, or .lower and .upper"
    written: ClassVar[str] = "epsilon_0=lower fails_at=upper place every_epsilon steps"

    lower: fmpq | None
    upper: fmpq | None
    place: fmpq | None
    every_epsilon: bool
    steps: int
    evidence: Evidence | None = field(compare=False, repr=False)


def _text(value: fmpq | None) -> str | None:
    return None if value is None else str(value)


def exact_threshold(force: ContactForce, start: fmpq, proved: fmpq, digits: int = 8) -> Threshold:
    """From ``proved``, with the force positive on [start, infinity) for every epsilon < proved, up to the exact
    epsilon_0.

    While the least value M(eta) is negative (beta > 1) the force is positive for epsilon in [epsilon_k, E(M(eta_k))),
    E(M) the epsilon at which mean + A epsilon^p M = 0, because M increases in eta. The last epsilon_k is ``lower``.

    :raises ValueError: C_1/Gamma(-beta) < 0, or beta > 5 (the force does not increase with eta there).

    >>> from gspot_verified.leading_order.contact_force import contact_force
    >>> largest = exact_threshold(contact_force("5/2"), fmpq(-10), fmpq(4, 5), 6)
    >>> largest.lower <= fmpq(8948813, 10**7) <= largest.upper, largest.upper - largest.lower < fmpq(1, 10**5)
    (True, True)
    """
    if not force.takes_impact:
        raise ValueError("c1: the threshold belongs to the side C_1/Gamma(-beta) > 0")
    if force.beta > MAX_BETA_OF_THEOREM:
        raise ValueError(f"beta: the theorem needs beta < {MAX_BETA_OF_THEOREM}, got {force.beta}")
    accuracy = digits + _SPARE_DIGITS + max(0, math.ceil(-math.log10(abs(approximate(force.exponent)))))
    bound, place = proved, None
    shown: list[Evidence | None] = []

    def up_to(lower: fmpq, upper: fmpq | None, place: fmpq | None, step: int) -> Threshold:
        return Threshold(lower, upper, place, False, step, every([*shown, at_most(lower, bound)]))

    for step in range(MAX_STEPS):
        root = root_below(scaled_epsilon(force, bound), accuracy)
        if root is None:
            return up_to(bound, None, None, step)
        least = least_value(Profile.at_root(force.beta, root), start, accuracy)
        if least is None:
            return up_to(bound, None, None, step)
        # Below the bound it is positive by what was shown before; from there on M is at least the one at the root.
        here = [at_most(2 * root**3, scaled_epsilon(force, bound)), least.evidence]
        if (nowhere_less := every([less(1, force.beta), at_most(0, least.lower)])) is not None:
            return Threshold(None, None, None, True, step + 1, every([*shown, *here, nowhere_less]))
        following, place = exponential_below(force, least, accuracy), least.place
        if following is not None and following > bound:
            shown += [*here, below_threshold(following, force.log_epsilon(least.lower, 2 * accuracy))]
            bound = following
        beyond = next_decimal(bound, digits)
        if fails_at(force, place, beyond, accuracy) is not None:
            return up_to(max(proved, rounded(bound, digits + 1)), beyond, place, step + 1)
    return up_to(bound, None, None, MAX_STEPS)


def root_below(epsilon: fmpq, digits: int) -> fmpq | None:
    """A decimal number a little below (epsilon/2)^(1/3); None where the slow solution is not evaluated."""
    if not fmpq(10) ** (2 - MAX_TENS) <= epsilon <= MAX_EPSILON:
        return None
    with working_bits(64 + 8 * digits):
        return rounded_down((arb(epsilon) / 2).log() / 3, digits + 2)


def exponential_below(force: ContactForce, least: LeastValue, digits: int) -> fmpq | None:
    """A decimal number, at most E(M) for the least value M."""
    with working_bits(64 + 8 * digits):
        return rounded_down(force.log_epsilon(least.lower, 2 * digits), digits + 2)


def rounded(value: fmpq, digits: int) -> fmpq:
    """The number of ``digits`` decimal digits next below the value, which is > 0."""
    unit = _unit(value, digits)
    return fmpq((value / unit).floor()) * unit


def next_decimal(value: fmpq, digits: int) -> fmpq:
    """The second decimal number of ``digits`` digits above the value."""
    unit = _unit(value, digits)
    return fmpq((value / unit).floor() + 2) * unit


def _unit(value: fmpq, digits: int) -> fmpq:
    with working_bits(64):
        tens = math.floor(approximate((arb(value).log() / arb(10).log()).mid()))
    return fmpq(10) ** (tens - digits + 1)


def slow_force(force: ContactForce, tau: fmpq, epsilon: fmpq, digits: int = 15) -> arb:
    """lambda_N of the compliant model on the slow manifold, at tau = (epsilon |alpha_1|/2)^(1/3) T.

    >>> from gspot_verified.leading_order.contact_force import contact_force
    >>> system = contact_force("5/2")
    >>> bool(slow_force(system, fmpq(2, 3), fmpq(1, 2)) > system.value("2/3", "1/2"))
    True
    """
    value = Profile.of(force, epsilon).value(tau, digits)
    with working_bits(4 * digits + 64):
        size = force.amplitude(digits) * arb(epsilon) ** arb(force.exponent)
        return arb(force.mean) + (size * value if force.takes_impact else -size * value)


def fails_at(force: ContactForce, place: fmpq, epsilon: fmpq, digits: int) -> Evidence | None:
    """That the slow contact force is < 0 at one point; None where that is not certain."""
    if not scaled_epsilon(force, epsilon) <= MAX_EPSILON:
        return None
    return less(slow_force(force, place, epsilon, digits), 0)
