"""Wrong contact, lift-off and impact for p < 0 (Sec. 1)."""

from __future__ import annotations

from paper.bite import GENERIC, Bite, NotApplicable, Teeth, replaced, scaled, unseen_at

from gspot_verified.paper.section_1 import section_1_negative_p as ledger

ENTRIES = ledger.ENTRIES
_SIGNS = NotApplicable("order", "exact signs; no order of an error occurs")

TEETH: Teeth = {
    "1-negative-p": (
        Bite("factor", ledger, "ACCELERATION", replaced("p*l", f"{GENERIC}*p*l")),
        Bite("factor", ledger, "FLIGHT", scaled),
        Bite("hidden factor", ledger, "ACCELERATION", unseen_at("l", (0, 1))),
        Bite("hypothesis", ledger.PARADOX, "p", lambda _: "x"),
        Bite("hypothesis", ledger.PARADOX, "p", lambda _: "0*x"),
        Bite("order", ledger, "FLIGHT", replaced("s^2", "s^3")),
    ),
    "1-impact-without-collision": (
        Bite("factor", ledger.RATES, "v", replaced("mu*B", f"{GENERIC}*mu*B")),
        Bite("factor", ledger.COMPRESSION, "P", scaled),
        Bite("hidden factor", ledger.COMPRESSION, "T", unseen_at("u", (1, 2))),
        Bite("hidden factor", ledger.RATES, "u", unseen_at("mu", (0, 1))),
        Bite("hypothesis", ledger.PARADOX, "p", lambda _: "x"),
        Bite("hypothesis", ledger.PARADOX, "p", lambda _: "0*x"),
        Bite("hypothesis", ledger.STICK, "v", replaced("B*T", "A*T")),
        _SIGNS,
    ),
    "1-impact-sizes": (
        Bite("factor", ledger.SIZES, "Poisson", lambda pair: (scaled(pair[0]), pair[1]), refutes=True),
        Bite("factor", ledger.SIZES, "energetic", lambda pair: (pair[0], scaled(pair[1])), refutes=True),
        Bite("factor", ledger.COMPRESSION, "P", scaled),
        Bite(
            "hidden factor",
            ledger.SIZES,
            "lowest",
            lambda pair: (unseen_at("u", (0, 1))(pair[0]), pair[1]),
            refutes=True,
        ),
        Bite("hypothesis", ledger.PARADOX, "p", lambda _: "x"),
        Bite("hypothesis", ledger.PARADOX, "p", lambda _: "0*x"),
        Bite("hypothesis", ledger, "LEAST", lambda pair: (f"2*{pair[0]}", pair[1]), refutes=True),
        Bite(
            "order", ledger.SIZES, "energetic", lambda pair: (replaced("-p*", "p^2*")(pair[0]), pair[1]), refutes=True
        ),
    ),
    "1-laws-of-impact": (
        Bite("factor", ledger.STICK, "v", replaced("B*T", f"{GENERIC}*B*T")),
        Bite("factor", ledger.SIZES, "energetic", lambda pair: (pair[0], scaled(pair[1]))),
        Bite("hidden factor", ledger.SIZES, "Poisson", lambda pair: (unseen_at("u", (0, 1))(pair[0]), pair[1])),
        Bite("hypothesis", ledger.PARADOX, "p", lambda _: "x"),
        Bite("hypothesis", ledger, "LIMIT", lambda _: "1+0*p", refutes=True),
        Bite("hidden factor", ledger.SIZES, "energetic", lambda pair: (f"p*({pair[0]})", f"p*({pair[1]})")),
        Bite("order", ledger.SIZES, "energetic", lambda pair: (replaced("-p*", "p^2*")(pair[0]), pair[1])),
    ),
}
