"""Wrong claims on the flight in Case II (Sec. 3)."""

from __future__ import annotations

from paper.bite import Bite, NotApplicable, Teeth, replaced, unseen_at

from gspot_verified.paper.section_3 import flight_in_case_ii as ledger

ENTRIES = ledger.ENTRIES

TEETH: Teeth = {
    "3-flight-persists": (
        Bite("factor", ledger.FLIGHT, "y", replaced("alpha2*u^3/6", "1000003/6000000*alpha2*u^3")),
        Bite("hidden factor", ledger.FLIGHT, "v", unseen_at("u", range(3))),
        Bite("hypothesis", ledger.AT_LIFT_OFF, "v", lambda _: "m*rate - d"),
        Bite("hypothesis", ledger, "SIGN", lambda sign: -sign, refutes=True),
        NotApplicable("order", "free motion is exact; no order of an error occurs"),
    ),
}
