"""Trivial solutions where a hypothesis is dropped, or an equation is another one (Sec. 2)."""

from __future__ import annotations

from paper.bite import Bite, NotApplicable, Teeth, replaced, unseen_at

from gspot_verified.paper.section_2 import no_trivial_solution as ledger

ENTRIES = ledger.ENTRIES

TEETH: Teeth = {
    "2-no-trivial": (
        NotApplicable("factor", "what must not be 0 is a product; a number in front changes no answer"),
        Bite("hidden factor", ledger.RATES, "p", unseen_at("b", (0, 1))),
        *(Bite("hypothesis", ledger, "NOT_ZERO", lambda honest, k=k: honest[:k] + honest[k + 1 :]) for k in range(3)),
        Bite("hypothesis", ledger.RATES, "p", replaced("chi*b", "0*b")),
        Bite("order", ledger, "BALANCE", replaced("p*L", "p*L^2")),
    ),
}
