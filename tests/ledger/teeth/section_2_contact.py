"""Wrong relaxations of the surface (Sec. 2)."""

from __future__ import annotations

from ledger.bite import Bite, Teeth, replaced, unseen_at

from gspot_verified.ledger import section_2_contact as ledger

ENTRIES = ledger.ENTRIES

TEETH: Teeth = {
    "2-relaxation": (
        Bite("factor", ledger.REST, "contact", replaced("1/2", "500001/1000000")),
        Bite("factor", ledger.SPRINGS, "contact", replaced("k2*", "1000003/1000000*k2*")),
        Bite("hidden factor", ledger.RATE, "contact", unseen_at("y", (-1, 1))),
        Bite("hypothesis", ledger.RATE, "flight", lambda _: ledger.RATE["contact"]),
        Bite("order", ledger.DECAY, "contact", lambda honest: honest + 1),
    ),
}
