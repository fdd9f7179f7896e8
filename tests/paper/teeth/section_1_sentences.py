"""Mended sentences and a wrong slope of an impact (Sec. 1)."""

from __future__ import annotations

from paper.bite import GENERIC, Bite, NotApplicable, Teeth, raised, reads_as, replaced, scaled, unseen_at

from gspot_verified.paper.checks import words
from gspot_verified.paper.section_1 import section_1_negative_p
from gspot_verified.paper.section_1 import section_1_sentences as ledger

ENTRIES = ledger.ENTRIES
_SIGN = "the sign of a product; a positive factor changes none"
_WORDS = "words are compared; there is no formula"

TEETH: Teeth = {
    "1-mirror": (
        Bite("factor", ledger.FRICTION, "backwards", scaled),
        Bite("hidden factor", ledger.PROJECTED, "v", unseen_at("B", (0, 1))),
        Bite("hypothesis", ledger.MIRROR, "B", lambda _: "B"),
        Bite("hypothesis", ledger.PROJECTED, "v", replaced("lamT*B", "lamT*C")),
        Bite("hypothesis", ledger.PROJECTED, "v", replaced("+ lamT*B", "- lamT*B")),
        Bite("hypothesis", ledger.PROJECTED, "v", replaced("+ lam*C", "- lam*C")),
        Bite("hypothesis", ledger.PARAMETER, "backwards", lambda _: "C - mu*B"),
        NotApplicable("order", "exact symmetries; no order of an error occurs"),
    ),
    "1-stiffness": (
        NotApplicable("factor", "a power of ε; a factor changes none"),
        NotApplicable("hidden factor", "a power of ε; a factor changes none"),
        Bite("hypothesis", ledger.CONSTANTS, "k2", lambda _: 2),
        Bite("order", ledger.STIFFNESS, "printed", lambda _: -2),
        Bite("order", ledger.STIFFNESS, "corrected", lambda honest: honest - 1),
    ),
    "1-poisson": (
        NotApplicable("factor", _SIGN),
        NotApplicable("hidden factor", _SIGN),
        Bite("hypothesis", ledger.IMPULSE, "printed", lambda _: "r*P"),
        Bite("hypothesis", ledger.IMPULSE, "corrected", lambda _: "(r-1)*P"),
        NotApplicable("order", _SIGN),
    ),
    "1-colours": (
        NotApplicable("factor", _WORDS),
        NotApplicable("hidden factor", _WORDS),
        Bite("hypothesis", words, "quoted", reads_as("green", "red")),
        Bite("hypothesis", words, "quoted", reads_as("red", "green")),
        NotApplicable("order", _WORDS),
    ),
    "1-scalars": (
        NotApplicable("factor", _WORDS),
        NotApplicable("hidden factor", _WORDS),
        Bite("hypothesis", words, "quoted", reads_as(r"$\cD$", r"$\cC$")),
        NotApplicable("order", _WORDS),
    ),
    "1-impact-slope": (
        Bite("factor", ledger.SLOPE, "u", replaced("mu*A", f"{GENERIC}*mu*A")),
        Bite("hidden factor", ledger.SLOPE, "v", unseen_at("p", (-1, 1))),
        Bite("hypothesis", section_1_negative_p.RATES, "v", lambda _: "C + mu*B"),
        Bite("hypothesis", section_1_negative_p.STICK, "u", replaced("B*P", "C*P")),
        # For a p > 0 without a bound B - μA may be positive.
        Bite("hypothesis", ledger, "NEAR_THE_G_SPOT", lambda honest: (*honest[:-1], {"p": "x"})),
        Bite("order", ledger.SLOPE, "v", replaced("p", "p^2")),
    ),
    "1-impact-ends": (
        Bite("factor", ledger, "BOUND", scaled),
        Bite("hidden factor", ledger, "BOUND", unseen_at("r", (0, 1))),
        Bite("hypothesis", section_1_negative_p.STICK, "u", replaced("A*T", "2*A*T")),
        Bite("hypothesis", section_1_negative_p.STICK, "v", replaced("B*T", "A*T")),
        Bite("order", ledger, "BOUND", raised("m")),
    ),
}
