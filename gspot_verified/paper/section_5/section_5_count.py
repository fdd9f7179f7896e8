"""Ledger of the count of conditions in Sec. 5.1, for every dimension m of the state."""

from __future__ import annotations

from flint import fmpq_mpoly

from gspot_verified.paper.checks.entry import Builders, Entry, Rung, Section
from gspot_verified.paper.checks.identities import Algebra, Claim, Parts

ALGEBRA = Algebra("m")
PRINTED = {"conditions": "m + 1", "equations": "m + 5", "left": "4 + 0*m"}
CONDITIONS = {"pbc": "1", "synchronisation": "4", "G-spot fixed": "m - 4"}
"""Eq. pbc, eqs. specialInitialFirst to specialInitialFourth, eq. Jbc."""
EQUATIONS = {"ξ": "m", "p": "1", "b": "1", "y": "1", "v": "1", "z": "1"}
"""Eqs. specialX to specialZ; eq. specialL is algebraic."""
EXAMPLE = {"states": ("x", "u", "y", "v", "p", "b"), "unknowns": ("p", "b", "y", "v", "z")}
"""The extended example: its state and the further unknowns."""


def total(parts: dict[str, str]) -> fmpq_mpoly:
    """The sum of the numbers."""
    return sum((ALGEBRA.read(f"{text} + 0*m") for text in parts.values()), start=ALGEBRA.constant(0))


def _count() -> Entry:
    this = Claim(ALGEBRA, PRINTED)

    def for_every_m(parts: Parts) -> list[fmpq_mpoly]:
        return [
            parts["conditions"] - total(CONDITIONS),
            parts["equations"] - total(EQUATIONS),
            parts["left"] - (total(EQUATIONS) - total(CONDITIONS)),
        ]

    def in_the_example(parts: Parts) -> list[fmpq_mpoly]:
        states, unknowns = len(EXAMPLE["states"]), len(EXAMPLE["unknowns"])
        at = {name: ALGEBRA.substitute(value, {"m": ALGEBRA.constant(states)}) for name, value in parts.items()}
        # Four components of the state are y, v, p, b; the others need a condition of their own, and p(0) = 0 is one.
        free = [name for name in EXAMPLE["states"] if name not in EXAMPLE["unknowns"]]
        return [
            at["equations"] - (states + unknowns),
            at["conditions"] - (len(free) + 4 + 1),
            at["left"] - (at["equations"] - at["conditions"]),
        ]

    return Section("Section 5, Theorem 1").settled(
        "5-count",
        "lines 1434 to 1438",
        "m+1,\\ m+5,\\ 4",
        "As a count, the boundary conditions are m + 1 for m + 5 differential equations, so that four are left, for "
        "every m >= 4",
        this.check("the numbers of scalar equations, m as a symbol", for_every_m),
        this.check("the extended example, m = 6, counted", in_the_example, Rung.POINTS),
    )


ENTRIES: Builders = {"5-count": _count}
"""The count of conditions."""
