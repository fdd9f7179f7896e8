"""The slow contact force stays positive on a half-line for every epsilon of an interval, for any beta: Theorem C's
polynomial bounds how f changes with eta, branch and bound does the rest.

Proof page: ``proofs/monotone.md``, section 10.
"""

from __future__ import annotations

from collections.abc import Callable

from flint import arb, fmpq

from gspot_verified.compliant.contact.least_value import halves
from gspot_verified.compliant.contact.lower_polynomial import drift, leading_enclosures, lower_terms
from gspot_verified.compliant.contact.taylor_cell import TaylorCell
from gspot_verified.compliant.slow.profile import Profile
from gspot_verified.numbers.balls import bits_for_digits, working_bits
from gspot_verified.numbers.evidence import Ends, cover, equal, every, less
from gspot_verified.numbers.verdict import Evidence

MAX_CELLS = 250  # intervals of tau, against endless work; then nothing is said
_DIGITS = 15  # of f on the cells: its sign is wanted
_MOST_RIGHT = 60  # tau up to which a rising f is looked for; then nothing is said


def above_on_cell(beta: fmpq, start: fmpq, roots: tuple[fmpq, fmpq], bound: arb) -> Evidence | None:
    """That f(tau; eta) > ``bound`` for every tau >= start and every eta in [roots[0], roots[1]]; None says nothing."""
    profile = Profile.at_root(beta, roots[0]) if roots[0] > 0 else Profile.leading_order(beta)
    count = 1 + max((term.order for term in lower_terms(beta - 1)), default=0) + profile.order

    def change(lower: fmpq, upper: fmpq, derivative: int) -> arb:
        return drift(beta, derivative, roots, leading_enclosures(beta, lower, upper, count))

    with working_bits(bits_for_digits(_DIGITS) + 64):
        rising_tail = _rising_from(profile, start, change)
        if rising_tail is None:
            return None
        right, rises = rising_tail
        if (beyond := less(bound, profile.value(right, _DIGITS) + change(right, right, 0))) is None:
            return None
        parts: list[Ends] = [(right, None)]
        shown = [rises, beyond]
        waiting = [(start, right)] if right > start else []
        for _ in range(MAX_CELLS):
            if not waiting:
                break
            lower, upper = waiting.pop()
            above = less(bound, TaylorCell(profile, lower, upper, _DIGITS).least + change(lower, upper, 0))
            if above is None:
                waiting += reversed(halves(lower, upper))
                continue
            parts.append((lower, upper))
            shown.append(above)
        return every([cover(parts, (start, None)), *shown])


def _rising_from(
    profile: Profile, start: fmpq, change: Callable[[fmpq, fmpq, int], arb]
) -> tuple[fmpq, Evidence] | None:
    """A point >= start at which f', ..., f^(n) > 0 for every eta of the cell, so that f increases from there on."""
    point = start
    while point <= max(start, fmpq(_MOST_RIGHT)):
        slopes = profile.derivatives(point, range(1, profile.order + 1), _DIGITS)
        above = (less(0, slope + change(point, point, j)) for j, slope in enumerate(slopes, 1))
        rises = every([equal(len(slopes), profile.order), *above])
        if rises is not None:
            return point, rises
        point += 1
    return None


def falling_to_the_left(beta: fmpq, start: fmpq, roots: tuple[fmpq, fmpq]) -> bool:
    """Whether (-1)^k f^(k)(start; eta), k < n, certainly have the sign of -Gamma(-beta) for every eta of the cell.

    With C_1 < 0 and a mean force >= 0 the force is then positive to the left of the start (section 7 of the page).
    """
    ends = [Profile.at_root(beta, root) if root > 0 else Profile.leading_order(beta) for root in roots]
    n, sign = ends[0].order, -ends[0].direction
    count = 1 + max((term.order for term in lower_terms(beta - 1)), default=0) + n
    enclosures = leading_enclosures(beta, start, start, count)
    with working_bits(bits_for_digits(_DIGITS) + 64):
        low = ends[0].derivatives(start, range(n), _DIGITS)
        high = ends[1].derivatives(start, range(n), _DIGITS)
        changes = [drift(beta, k, roots, enclosures) for k in range(n)]
        return all((low[k] + changes[k] > 0) if sign * (-1) ** k > 0 else (high[k] - changes[k] < 0) for k in range(n))
