"""G-spots as a table for people: number, place, slip, Case, β, and what happens."""

from __future__ import annotations

from collections.abc import Collection, Sequence

from gspot_verified.mechanisms.spots.classify import GIVEN_CONDITIONS, Classification
from gspot_verified.numbers.short_text import table_text

_HEADS = ("no.", "place", "slip u", "Case", "β", "what happens as ε → 0")
_STAR = "* found from the place that the mechanism names: taken where no number is given"
_C1 = "C1 says on which side of the distinguished trajectory a slip arrives: `approach` encloses it"


def spot_table(spots: Sequence[Classification], follow: Collection[str] = (), at_place: int | None = None) -> list[str]:
    """The lines of the table, then what must be known of some of the G-spots.

    Numbers are rounded to six digits. Components that are fixed, or in ``follow``, are not in the place. ``at_place``
    is the number of the one that is found from the place that the mechanism names, which gets a star.

    >>> from gspot_verified import classify, load
    >>> print("\\n".join(spot_table([classify(load("falling rod"))])))
      place                                                   slip u  Case  β      what happens as ε → 0
      Y = 0.6, theta = theta_ref, Y_dot = 0.8, theta_dot = 1  1.4     II    18/55  impact without collision
    """
    if not spots:
        return []
    rows = [_HEADS, *(_row(spot, follow, at_place) for spot in spots)]
    if all(spot.number is None for spot in spots):
        rows = [row[1:] for row in rows]
    widths = [max(len(row[k]) for row in rows) for k in range(len(rows[0]))]
    lines = ["  " + "  ".join(map(str.ljust, row, widths)).rstrip() for row in rows]
    star = [] if at_place is None else [_STAR]
    return [*lines, *(f"  {remark}" for remark in (*star, *_remarks(spots)))]


def _row(spot: Classification, follow: Collection[str], at_place: int | None) -> tuple[str, ...]:
    shown = [(word, text) for word, text in spot.short_point if word not in spot.fixed and word not in follow]
    place = ", ".join(f"{word} = {text}" for word, text in shown or spot.short_point)
    number = f"{spot.number}{'*' if spot.number == at_place else ''}"
    beta = "-" if spot.beta is None else table_text(spot.beta)
    return number, place, table_text(spot.slip_velocity), spot.case or "?", beta, spot.what_happens


def _remarks(spots: Sequence[Classification]) -> list[str]:
    """What holds for some; of the G-spots in no Case nothing is said but that."""
    lines = [_C1] if any(spot.case == "III" and spot.impact_sign is not None for spot in spots) else []
    warned: dict[str, list[str]] = {}
    for spot in spots:
        for text in spot.warnings if spot.case != "none" else ():
            warned.setdefault(text, []).append("" if spot.number is None else str(spot.number))
    for text, numbers in warned.items():
        which = ", ".join(filter(None, numbers))
        lines.append(f"warning{f' (G-spot {which})' if which else ''}: {text}")
    notes = dict.fromkeys(note for spot in spots for note in spot.notes)
    return [*lines, *(f"note: {note}" for note in notes)]


def one_spot(spot: Classification) -> str:
    """The table for the G-spot that is found from the place that its mechanism names.

    >>> from gspot_verified import classify, load
    >>> print(one_spot(classify(load("falling rod"))).splitlines()[0])
    falling rod: proved: a G-spot, exactly at the place of its file; X = 0, X_dot = 2 fixed
    """
    found = "exactly at" if spot.exact else "the only one in a box, found from"
    held = ", ".join(f"{word} = {text}" for word, text in spot.short_point if word in spot.fixed)
    conditions = f"; {held} fixed" if held else f"; {GIVEN_CONDITIONS}" if spot.given_conditions else ""
    first = f"{spot.name}: proved: a G-spot, {found} the place of its file{conditions}"
    return "\n".join([first, *spot_table([spot])])
