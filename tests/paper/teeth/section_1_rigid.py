"""Wrong equations of rigid slip (Sec. 1)."""

from __future__ import annotations

from paper.bite import Bite, NotApplicable, Teeth, replaced, scaled, unseen_at

from gspot_verified.paper.section_1 import section_1_rigid as ledger

ENTRIES = ledger.ENTRIES
_EXACT = NotApplicable("order", "exact equations; no order of an error occurs")

TEETH: Teeth = {
    "1-force": (
        Bite("factor", ledger.PRINTED["1-force"], "p times the force", scaled, refutes=True),
        Bite("factor", ledger.PRINTED["1-force"], "p", replaced("mu*B", "1000003/1000000*mu*B"), refutes=True),
        Bite("hidden factor", ledger.PRINTED["1-force"], "p", unseen_at("mu", (0, 1))),
        Bite("hypothesis", ledger, "TANGENTIAL", lambda _: "mu*lam"),
        _EXACT,
    ),
    "1-rescaled": (
        Bite("factor", ledger.PRINTED["1-rescaled"], "p", scaled),
        Bite("factor", ledger.PRINTED["1-rescaled"], "b", replaced("alpha3*b", "1000003/1000000*alpha3*b")),
        Bite("hidden factor", ledger.PRINTED["1-rescaled"], "b", unseen_at("p", (1, 2))),
        Bite("hypothesis", ledger.RATES, "b", lambda _: "alpha2 + alpha3*lam"),
        _EXACT,
    ),
}
