"""Wrong coefficients of restitution (Sec. 2)."""

from __future__ import annotations

from flint import fmpq
from paper.bite import GENERIC, Bite, NotApplicable, Teeth, raised, replaced, unseen_at

from gspot_verified.paper.section_2 import section_2_restitution as ledger

ENTRIES = ledger.ENTRIES

TEETH: Teeth = {
    "2-restitution-consistent": (
        Bite("factor", ledger.SPRINGS, "z", replaced("k1*z", f"{GENERIC}*k1*z")),
        Bite("factor", ledger.MOTION, "v", replaced("zeta*", f"{GENERIC}*zeta*")),
        Bite("hidden factor", ledger.SPRINGS, "lam", unseen_at("k2", (1, 4))),
        Bite("hypothesis", ledger.CHOICE, "c", lambda _: fmpq(-2)),
        Bite("order", ledger, "PER_TIME", raised("n")),
    ),
    "2-restitution-elastic": (
        Bite("factor", ledger.MOTION, "v", replaced("zeta*", f"{GENERIC}*zeta*")),
        Bite("factor", ledger, "LARGEST_LOSS", lambda honest: honest / 20),
        Bite("hidden factor", ledger.MOTION, "z", unseen_at("rho", (1, 9, 81))),
        Bite("hypothesis", ledger.ELASTIC, "k_2 → 0", lambda _: {"k_2": fmpq(2)}),
        Bite("order", ledger.ELASTIC, "c → ∞", lambda _: {"c": fmpq(1), "k_2": fmpq(2)}),
    ),
    "2-restitution-inelastic": (
        Bite("factor", ledger.MOTION, "z", replaced("rho*z", f"{GENERIC}*rho*z")),
        Bite("hidden factor", ledger.MOTION, "z", unseen_at("zeta", (4, 8))),
        Bite("hypothesis", ledger.INELASTIC, "k_1", lambda _: 0),
        Bite("order", ledger, "LOSSY", lambda honest: honest[::-1]),
    ),
    "2-restitution-not-fixed": (
        Bite("factor", ledger, "APART", lambda honest: (honest[0] * fmpq(9, 10), honest[1])),
        Bite("hidden factor", ledger, "APART", lambda honest: (honest[0], fmpq(9999, 10000))),
        Bite("hypothesis", ledger, "ONE_CONTACT", lambda _: (fmpq(1), fmpq(4))),
        # One p alone: the coefficient is one number.
        Bite("hypothesis", ledger, "ONE_CONTACT", lambda honest: (honest[0], honest[0])),
        NotApplicable("order", "two numbers are compared; no order of an error occurs"),
    ),
}
