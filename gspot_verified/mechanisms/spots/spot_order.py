"""The order of the G-spots in a list, which gives each its number: first those that slip in contact may reach."""

from __future__ import annotations

from collections.abc import Sequence

from gspot_verified.mechanisms.spots.classify import classify_g_spot, sign_of_exact
from gspot_verified.mechanisms.spots.g_spot import GSpot


def relevant_first(spots: Sequence[GSpot]) -> list[GSpot]:
    """Cases I, II and III with u > 0, the three Cases without, those of which the case is open, the others.

    Slip from p > 0 and b < 0 approaches in these Cases (paper, Sec. 1.2), and on a surface at rest it is u > 0. Within
    each of the four groups the order is kept.
    """
    return sorted(spots, key=_rank)


def _rank(spot: GSpot) -> tuple[bool, bool, bool]:
    found = classify_g_spot(spot)
    in_a_case = found.case in ("I", "II", "III")
    return not in_a_case, found.case == "none", in_a_case and sign_of_exact(found.slip_velocity) != 1
