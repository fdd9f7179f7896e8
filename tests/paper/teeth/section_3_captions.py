"""Mended captions and other panels (Sec. 3)."""

from __future__ import annotations

from paper.bite import Bite, NotApplicable, Teeth, reads_as, scaled

from gspot_verified.paper.checks import words
from gspot_verified.paper.section_3 import section_3_captions as ledger

ENTRIES = ledger.ENTRIES
_WHICH = "which variables occur; a factor or a power changes none"
_SIGN = "exact signs; no order of an error occurs"

TEETH: Teeth = {
    "3-trivial-shown": (
        Bite("factor", ledger, "NU", scaled),
        NotApplicable("hidden factor", "three panels, all looked at"),
        Bite("hypothesis", ledger.DRAWN, "printed", lambda _: "bc"),
        Bite("hypothesis", ledger.DRAWN, "corrected", lambda _: "c"),
        Bite("hypothesis", words, "quoted", reads_as("not shown", "shown")),
        NotApplicable("order", "no order of an error occurs"),
    ),
    "3-caption-equations": (
        NotApplicable("factor", _WHICH),
        NotApplicable("hidden factor", _WHICH),
        Bite("hypothesis", ledger.LAST, "printed", lambda _: "modelsys5"),
        Bite("hypothesis", ledger.EQUATIONS, "modelsys5", lambda _: ("x", "-z - lam")),
        NotApplicable("order", _WHICH),
    ),
    "3-panels": (
        Bite("factor", ledger.BETAS, "a", lambda honest: honest * 4),
        NotApplicable("hidden factor", "three panels, all looked at"),
        Bite("hypothesis", ledger, "ALPHA_2", lambda honest: -honest),
        Bite("hypothesis", ledger.CASES, "c", lambda _: "I"),
        NotApplicable("order", _SIGN),
    ),
    "3-after-contact": (
        Bite("factor", ledger.EQUATIONS, "modelsys2", lambda _: ("b", "2*alpha2 - alpha3*lam")),
        Bite("hidden factor", ledger.EQUATIONS, "modelsys4", lambda _: ("v", "b + b*(b - 1)*alpha3 + p*lam")),
        Bite("hypothesis", ledger.EQUATIONS, "modelsys2", lambda _: ("b", "alpha2 - alpha3*lam - alpha3")),
        Bite("hypothesis", ledger.section_3_sentences.FLIGHT, "b", lambda _: "b - alpha2*u"),
        NotApplicable("order", "exact equations; no order of an error occurs"),
    ),
}
