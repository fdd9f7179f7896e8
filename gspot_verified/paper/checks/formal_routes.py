"""Which theorem of ``proofs/coq/`` is the whole claim of which entry, or contradicts it.

A theorem stands here only if it carries the claim for all its arguments. The check is added where this run had the
proofs compiled and looked at (``verify --formal``); elsewhere the entry names the route and says that it was not run.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from gspot_verified.paper.checks.entry import Entry, Rung, conclude
from gspot_verified.paper.checks.formal_proof import COQ, ProofRun, formal_proof

CARRIED: dict[str, tuple[str, ...]] = {
    "2-trivial": ("corrected_trivial",),
    "4-deviation": ("deviation_recover",),
    "4-deviation-recover": ("deviation_recover",),
    "3-flight-persists": ("flight_persists",),
    "S-iwc": ("IWC",),
    "S-minus-infinity": ("left_end", "left_end_integer"),
    "S-plus-infinity": ("right_end",),
    "S-switching": ("gamma_sign", "leading_side_rule"),
    "S-side": ("leading_side_rule",),
    "S-iwc-case-III": ("leading_force_positive", "least_value_exists"),
    "C-cases-I-II": ("force_deviation",),
    "C-iwc-case-III": ("force_above_leading_order", "IWC_below_threshold"),
    "C-lift-off": ("force_above_leading_order", "side_rule"),
}
CONTRADICTED: dict[str, tuple[tuple[str, ...], str]] = {
    "2-trivial-zy": (
        ("printed_trivial_is_wrong", "corrected_trivial"),
        "the printed z and y solve the equations never",
    ),
    "S-gamma-intervals": (("gamma_sign",), "on (m, m + 1) the sign is (-1)^(m + 1): positive on (1, 2)"),
}


def with_formal_proof(entry: Entry, proofs: ProofRun, coq: Path = COQ) -> Entry:
    """The entry with its formal proof, and with the check that this is where it was run; others as they are."""
    contradicted = CONTRADICTED.get(entry.identifier)
    names, finding = contradicted or (CARRIED.get(entry.identifier, ()), "")
    if not names:
        return entry
    proof = formal_proof(names, proofs, coq)
    if not proof.run:
        return replace(entry, formal=proof)
    what = "; ".join(f"proofs/coq/{file}: {name}" for name, _, file in proof.theorems)
    checks = (*entry.checks, Rung.FORMAL.check(what, contradicted is None, finding))
    return replace(entry, checks=checks, verdict=conclude(entry.statement, checks), formal=proof)
