"""Wrong equations of p, b, y, v in positive slip (Sec. 2)."""

from __future__ import annotations

from paper.bite import Bite, NotApplicable, Teeth, replaced, scaled, unseen_at

from gspot_verified.paper.section_2 import general_system as ledger

ENTRIES = ledger.ENTRIES

TEETH: Teeth = {
    "2-at-once": (
        Bite("factor", ledger.FORCES["N"], "w", scaled),
        Bite("factor", ledger.ROD, "p", replaced("c - mu*s", "c - mu*s + w")),
        Bite("hidden factor", ledger.FORCES["T"], "w", unseen_at("s", (0, 1))),
        Bite("hypothesis", ledger.MOTION, "q1", lambda honest: f"{honest} + lam"),
        Bite("hypothesis", ledger.FRICTION, "mu", lambda honest: f"{honest}*w1"),
        Bite("hypothesis", ledger.PLACES, "x", replaced("X", "X + U")),
        Bite("hypothesis", ledger.PLACES, "y", replaced("Y", "Y + W")),
        NotApplicable("order", "exact zeros; no order of an error occurs"),
    ),
    "2-projected": (
        Bite("factor", ledger.MOTION, "w2", replaced("m12", "1000003/1000000*m12")),
        Bite("factor", ledger.FORCES["N"], "w", scaled),
        Bite("hidden factor", ledger.FORCES["T"], "w", unseen_at("s", (0, 1))),
        Bite("hypothesis", ledger.MOTION, "w1", replaced("m12", "m22")),
        Bite("hypothesis", ledger.TANGENTIAL, "u", replaced("t2", "n2")),
        Bite("hypothesis", ledger.MOTION, "w1", lambda text: text.replace("t1*lamT", "t1*w1*lamT")),
        Bite("order", ledger.MOTION, "w1", replaced("n1*lam", "n1*lam^2")),
    ),
    "2-slip-equations": (
        *(Bite("factor", ledger.PRINTED, name, scaled, refutes=True) for name in "pbyv"),
        Bite("factor", ledger.PRINTED, "b", replaced("alpha3*r", "1000003/1000000*alpha3*r"), refutes=True),
        Bite("hidden factor", ledger.PRINTED, "v", unseen_at("r", range(-2, 3))),
        Bite("hypothesis", ledger.COULOMB, "lamT", lambda _: "mu*r"),
        Bite("hypothesis", ledger.SYSTEM, "rate", replaced("T*lamT", "T*lamT*c")),
        Bite("hypothesis", ledger.ALONG, "T", lambda _: "C"),
        Bite("hypothesis", ledger.MOTION, "w1", replaced("m12", "m22")),
        Bite("hypothesis", ledger.LAGRANGIAN, "LGp", lambda _: "LGp"),
        Bite("hypothesis", ledger.LAGRANGIAN, "LGy", lambda _: "LGy"),
        *(Bite("hypothesis", ledger.ROD, name, scaled) for name in ledger.ROD),
        *(Bite("hypothesis", ledger.FORCES[force], "w", scaled) for force in "TN"),
        *(Bite("hypothesis", ledger.NEWTON, name, scaled) for name in ledger.NEWTON),
        Bite("order", ledger.PRINTED, "v", replaced("p*r", "p*r^2")),
    ),
    "2-motivating": (
        *(Bite("factor", ledger.MODEL, name, scaled, refutes=True) for name in "pbyv"),
        Bite("hidden factor", ledger.MODEL, "v", unseen_at("r", range(-2, 3))),
        Bite("hypothesis", ledger.MODEL, "p", lambda honest: f"{honest} + b"),
        *(Bite("hypothesis", ledger.DEFINED, name, scaled) for name in ledger.DEFINED),
        Bite("order", ledger.MODEL, "v", replaced("p*r", "p*r^2")),
    ),
}
