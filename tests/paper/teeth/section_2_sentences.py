"""Mended sentences, a wrong contact and wrong signs near p = 0 (Sec. 2)."""

from __future__ import annotations

from paper.bite import GENERIC, Bite, NotApplicable, Teeth, raised, replaced, scaled, unseen_at

from gspot_verified.paper.section_2 import lagrangian
from gspot_verified.paper.section_2 import section_2_sentences as ledger

ENTRIES = ledger.ENTRIES
_RELATION = "a relation at y = 0; no factor and no order occurs"
_PRESENCE = "whether a variable is there; a factor or a power changes nothing"

TEETH: Teeth = {
    "2-unilateral": (
        NotApplicable("factor", _RELATION),
        NotApplicable("hidden factor", _RELATION),
        Bite("hypothesis", ledger.ALLOWED, "printed", lambda _: ledger.ALLOWED["corrected"]),
        Bite("hypothesis", ledger.G_SPOT, "y", lambda _: 1),
        Bite("hypothesis", ledger.SURFACE, "y", lambda _: 1),
        NotApplicable("order", _RELATION),
    ),
    "2-contact-condition": (
        Bite("factor", ledger, "FORCE", replaced("(z - y)", "(1000003/1000000*z - y)")),
        Bite("hidden factor", ledger, "FORCE", unseen_at("y", (0, 1))),
        Bite("hypothesis", ledger, "FORCE", replaced("k2*", "(k2 - d)*")),
        Bite("order", ledger, "FORCE", lambda honest: f"{honest}*(z - y)"),
    ),
    "2-tangential": (
        Bite("hidden factor", ledger.EXTENDED, "b", unseen_at("u", (0, 1))),
        Bite("hypothesis", ledger.EXTENDED, "v", lambda honest: f"{honest} + x"),
        Bite("hypothesis", lagrangian.PRINTED["2-extended"], "F4", lambda honest: f"{honest} + x2"),
        Bite("hypothesis", lagrangian.PRINTED["2-extended"], "mu", lambda honest: f"{honest} + x1"),
        Bite("order", ledger.MOTIVATING, "v", replaced("p*lam", "p^2*lam")),
        Bite("factor", ledger.EXTENDED, "b", replaced("c*alpha3", "1000003/1000000*c*alpha3")),
    ),
    "2-p-linear": (
        Bite("factor", ledger.EXTENDED, "p", replaced("alpha1", "1000003/1000000*alpha1")),
        Bite("hidden factor", ledger.EXTENDED, "p", unseen_at("b", (0, 1))),
        Bite("hypothesis", lagrangian.PRINTED["2-extended"], "N5", lambda _: "x6"),
        Bite("hypothesis", lagrangian.PRINTED["2-extended"], "F5", replaced("chi*x6", "x6")),
        Bite("order", ledger.EXTENDED, "p", raised("alpha1")),
    ),
    "2-two-forces": (
        Bite("factor", ledger.EDGES, "lm", scaled),
        Bite("hidden factor", ledger.SHARES, "lp", unseen_at("c", (0, 1))),
        Bite("hypothesis", ledger.EDGES, "lp", lambda _: "mu"),
        Bite("order", ledger.SHARES, "lm", raised("c")),
    ),
    "2-contact-part": (
        Bite("factor", ledger.PART_CORRECTED, "part", scaled),
        Bite("hidden factor", ledger.PART_CORRECTED, "part", unseen_at("lp", (0, 1))),
        Bite("hypothesis", ledger.PART, "part", lambda _: "-alpha3*lp"),
        Bite("order", ledger.PART_CORRECTED, "part", raised("lp")),
    ),
    "2-coupling": (
        Bite("factor", ledger.EXTENDED, "p", replaced("chi*b", "1000003/1000000*chi*b + chi*p")),
        Bite("hidden factor", ledger.EXTENDED, "p", unseen_at("u", (0, 1))),
        Bite("hypothesis", ledger.EXTENDED, "p", replaced("chi*b", "chi*u")),
        NotApplicable("order", _PRESENCE),
    ),
    "2-extended-equations": (
        Bite("factor", ledger.EXTENDED, "v", replaced("q*", f"{GENERIC}*q*"), refutes=True),
        Bite("hidden factor", ledger.EXTENDED, "b", unseen_at("c", (0, 1)), refutes=True),
        Bite("hypothesis", ledger.REPLACED, "v", lambda honest: (honest[0], "p*lp + p*lm")),
        Bite("hypothesis", ledger.REPLACED, "b", lambda honest: ("p*lam", honest[1])),
        Bite("hypothesis", ledger, "FIRST", lambda _: "alpha1"),
        Bite("order", ledger.EXTENDED, "p", replaced("chi*b", "chi^2*b"), refutes=True),
    ),
    "2-signs-at-p-0": (
        Bite("factor", ledger.OTHER, "k^+", replaced("mu*A", "1000003/1000000*mu*A")),
        Bite("hidden factor", ledger.OTHER, "p^-", unseen_at("mu", (0, 1))),
        Bite("hypothesis", ledger.OTHER, "p^-", lambda _: "C - mu*B"),
        Bite("hypothesis", ledger.OTHER, "k^-", lambda _: "B - mu*A"),
        Bite("order", ledger.OTHER, "k^+", replaced("mu*A", "mu^2*A")),
    ),
}
