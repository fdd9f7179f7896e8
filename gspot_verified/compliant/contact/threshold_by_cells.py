"""The exact epsilon_0 for beta > 5, where the force need not grow with eta: epsilon is covered by cells from 0 on.

Proof page: ``proofs/monotone.md``, section 10.
"""

from __future__ import annotations

from flint import arb, fmpq

from gspot_verified.compliant.contact.cells_of_epsilon import above_on_cell, falling_to_the_left
from gspot_verified.compliant.contact.least_value import least_value
from gspot_verified.compliant.contact.threshold import (
    Threshold,
    exponential_below,
    fails_at,
    next_decimal,
    root_below,
    rounded,
)
from gspot_verified.compliant.slow.profile import Profile
from gspot_verified.leading_order.contact_force import ContactForce
from gspot_verified.numbers.balls import working_bits
from gspot_verified.numbers.evidence import Ends, at_most, cover, every
from gspot_verified.numbers.verdict import Evidence

MAX_BETA = 13  # so far the search has been tried; section 10 of the page holds for every beta
MAX_CELLS = 60  # of epsilon, against endless work; what they cover holds
_SHARE = fmpq(97, 100)  # of the way to the end that is guessed from the last cell: a heuristic
_LEAST_WIDTH = fmpq(1, 2**40)  # relative; a narrower cell is given up
_SPARE_DIGITS = 3  # beyond those asked for, which rounding takes


def threshold_by_cells(
    force: ContactForce, start: fmpq, aim: fmpq, digits: int = 6, left: bool = False
) -> tuple[Threshold | None, bool]:
    """The exact epsilon_0 on [start, infinity), and (with ``left``) whether it holds to the left of the start as well.

    ``aim``: where to look first, any number. None when no epsilon_0 > 0 was found.

    :raises ValueError: C_1/Gamma(-beta) < 0, or beta not in (1, 13).
    """
    if not force.takes_impact:
        raise ValueError("c1: the threshold belongs to the side C_1/Gamma(-beta) > 0")
    if not 1 < force.beta < MAX_BETA:
        raise ValueError(f"beta: expected a number in (1, {MAX_BETA}), got {force.beta}")
    accuracy = digits + _SPARE_DIGITS
    reached, target = fmpq(0), root_below(-force.alpha_1 * aim, accuracy)
    place: fmpq | None = None
    whole = left
    cells: list[Ends] = []
    shown: list[Evidence] = []

    def up_to(lower: fmpq, upper: fmpq | None, place: fmpq | None, step: int) -> Threshold:
        covered = cover(cells, (fmpq(0), reached))
        return Threshold(
            lower, upper, place, False, step, every([covered, *shown, at_most(lower, _epsilon(force, reached))])
        )

    for step in range(1, MAX_CELLS + 1):
        if target is None or target <= reached:
            break
        holds = _holds(force, start, (reached, target), place)
        if holds is None:
            target = (reached + target) / 2
            if target - reached <= _LEAST_WIDTH * target:
                break
            continue
        whole = whole and falling_to_the_left(force.beta, start, (reached, target))
        cells.append((reached, target))
        shown.append(holds)
        reached = target
        bound = _epsilon(force, reached)
        least = least_value(Profile.at_root(force.beta, reached), start, accuracy)
        if least is None or least.lower >= 0:
            break
        place = least.place
        beyond = next_decimal(bound, digits)
        if fails_at(force, place, beyond, accuracy) is not None:
            return up_to(rounded(bound, digits + 1), beyond, place, step), whole
        goal = exponential_below(force, least, accuracy)
        further = None if goal is None else root_below(-force.alpha_1 * goal, accuracy)
        target = None if further is None else reached + _SHARE * (further - reached)
    if reached == 0:
        return None, False
    return up_to(_epsilon(force, reached), None, None, MAX_CELLS), whole


def _epsilon(force: ContactForce, root: fmpq) -> fmpq:
    return -2 * root**3 / force.alpha_1


def _holds(force: ContactForce, start: fmpq, roots: tuple[fmpq, fmpq], place: fmpq | None) -> Evidence | None:
    """That the force is positive on [start, infinity) for every eta of the cell; None where it is not
    certain."""
    epsilon = _epsilon(force, roots[1])
    if place is not None and fails_at(force, place, epsilon, 15) is not None:
        return None
    with working_bits(128):
        bound = -force.level(epsilon, 20)
    return above_on_cell(force.beta, start, roots, arb(bound))
