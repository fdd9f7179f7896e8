"""Wrong formulas for the ansatz near the G-spot (Sec. 5)."""

from __future__ import annotations

from paper.bite import Bite, Teeth, raised, replaced, scaled, unseen_at

from gspot_verified.paper.section_5 import section_5_ansatz as ledger
from gspot_verified.paper.section_5 import section_5_outer as outer

ENTRIES = ledger.ENTRIES
EQUATIONS, SOLUTION = ledger.PRINTED["5-ansatz"], ledger.PRINTED["5-ansatz-solution"]
P0 = ledger.CORRECTED["5-ansatz-p0"]

TEETH: Teeth = {
    "5-ansatz": (
        *(Bite("factor", EQUATIONS, part, scaled) for part in EQUATIONS),
        *(Bite("hidden factor", EQUATIONS, part, unseen_at("r", range(1, 6))) for part in EQUATIONS),
        # p is not 0 at the G-spot; F varies at order 0; the force is not finite on the distinguished trajectory.
        Bite("hypothesis", ledger.DISTINGUISHED, "p", lambda _: "q2 - alpha1*w"),
        Bite("hypothesis", ledger.DISTINGUISHED, "p", replaced("-alpha1*w", "0*w")),
        *(Bite("order", ledger.ANSATZ, part, raised("w")) for part in ledger.ANSATZ),
        *(Bite("order", EQUATIONS, part, raised("r")) for part in EQUATIONS),
    ),
    "5-ansatz-solution": (
        *(Bite("factor", SOLUTION, part, scaled) for part in SOLUTION),
        *(Bite("hidden factor", SOLUTION, part, unseen_at("beta", range(1, 6))) for part in SOLUTION),
        *(Bite("hidden factor", SOLUTION, part, unseen_at("b0", (0, 1))) for part in SOLUTION),
        Bite("hypothesis", EQUATIONS, "balance", replaced("-b0", "-2*b0")),
        Bite("hypothesis", outer.PRINTED["5-slow-manifold"], "b", replaced("alpha3*b", "2*alpha3*b")),
        Bite("order", SOLUTION, "r", lambda text: f"{text} + 1"),
        *(Bite("order", SOLUTION, part, raised("b0")) for part in ("alpha3 xi0", "alpha1 lambda0")),
    ),
    "5-ansatz-p0": (
        Bite("factor", P0, "alpha3 (r+1) p0", scaled),
        Bite("factor", ledger.PRINTED["5-ansatz-p0"], "alpha3 (r+1) p0", lambda _: "m*G*b0"),
        Bite("hidden factor", P0, "alpha3 (r+1) p0", unseen_at("m", (0, 1))),
        Bite("hidden factor", P0, "alpha3 (r+1) p0", unseen_at("r", range(1, 6))),
        Bite("hypothesis", SOLUTION, "alpha3 xi0", replaced("-G*b0", "G*b0")),
        Bite("order", P0, "alpha3 (r+1) p0", raised("b0")),
        Bite("order", ledger.ANSATZ, "p", raised("w")),
    ),
}
