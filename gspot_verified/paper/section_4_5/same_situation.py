"""Ledger of Section 4.5: the deviation of the force on the side of the impact in Case III, beside Cases I and II."""

from __future__ import annotations

from flint import arb, fmpq

from gspot_verified.numbers.balls import sign_of, working_bits
from gspot_verified.paper.checks.entry import Builders, Entry, Rung, Section, all_of
from gspot_verified.paper.section_4_5.section_4_5_signs import PRINTED as SIGNS
from gspot_verified.signs.gamma.side import gamma_sign
from gspot_verified.theta_function.value.evaluate import evaluate

BETA = fmpq(3, 2)
"""In Case III, and β < 4."""
FORCE = {"far left": -1, "zero": -1}
"""The signs of the deviation of λ_N; in Cases I and II they are positive (S-iwc)."""


def sign_of_the_coefficient() -> int | None:
    """C_1 on the side of the impact: the sign of Γ(-β); in Cases I and II it is negative."""
    return gamma_sign(BETA)


def is_so_far_left() -> bool | None:
    """Whether C_1 dΘ/dτ has the stated sign for τ large and negative, where dΘ/dτ < 0."""
    found = sign_of_the_coefficient()
    return None if found is None else found * int(SIGNS["S-minus-infinity"]["sign"]) == FORCE["far left"]


def is_so_at_zero() -> bool | None:
    """The same at τ = 0, with an enclosure of dΘ/dτ."""
    slope, found = sign_of(evaluate(0, BETA, derivative=1).value), sign_of_the_coefficient()
    return None if slope is None or found is None else found * slope == FORCE["zero"]


def is_so_by_the_initial_value() -> bool | None:
    """The same by eq. t02: C_1/Γ(-β) > 0 on this side, so C_1 times dΘ/dτ at 0 has the sign of Γ((1-β)/3)."""
    with working_bits(64):
        found = sign_of(arb((1 - BETA) / 3).gamma())
    return None if found is None else found == FORCE["zero"]


def _same_situation() -> Entry:
    return Section("Section 4.5").settled(
        "S-same-situation",
        "lines 1304 to 1305",
        r"\text{for the other sign of }C_1\Gamma(-\beta)\text{ we are in the same situation as above}",
        f"In Case III, β = {BETA}, C_1/Γ(-β) > 0, at leading order, the deviation of λ_N is negative for τ → -∞ and at "
        "τ = 0",
        Rung.BALLS.check(
            "τ → -∞: C_1 has the sign of Γ(-β), and dΘ/dτ < 0 (S-minus-infinity); τ = 0: an enclosure of dΘ/dτ",
            all_of([is_so_far_left(), is_so_at_zero()]),
        ),
        Rung.BALLS.check(
            "τ → -∞ as above; τ = 0: Γ((1-β)/3), of which C_1 dΘ/dτ has the sign by the initial value",
            all_of([is_so_far_left(), is_so_by_the_initial_value()]),
        ),
        note="So not all signs are those of Cases I and II, where it is positive at every τ (S-iwc): the impact is by "
        "the mean force at a fixed τ and by the deviation for large τ (S-iwc-case-III), as lines 1296 to 1299 say. At "
        "τ = 0 the sign is that of Γ((1-β)/3) on this side: negative for β in (1, 4), positive for β in (4, 7).",
    )


ENTRIES: Builders = {"S-same-situation": _same_situation}
"""The side of the impact in Case III."""
