"""Wrong formulas for the solutions that behave like (-τ)^β (Sec. 4.4)."""

from __future__ import annotations

from paper.bite import Bite, Teeth, replaced, scaled, unseen_at

from gspot_verified.paper.section_4 import section_4_oscillating as ledger

ENTRIES = ledger.ENTRIES


TEETH: Teeth = {
    "4-behaves-like": (
        Bite("factor", ledger.AIRY, "4 c^3", scaled),
        Bite("factor", ledger.AIRY, "solution", replaced("4*c^2", "4000001/1000000*c^2")),
        Bite("factor", ledger.AIRY, "beta", scaled),
        *(Bite("factor", ledger.POWERS, name, scaled) for name in ledger.POWERS),
        *(Bite("factor", ledger.SMALL, f"{name} {j}", scaled) for name in ("h", "e") for j in range(3)),
        *(Bite("factor", ledger.SMALL, name, scaled) for name in ("real 1", "imaginary 2")),
        *(
            Bite("factor", ledger, "SINES", lambda honest, j=j: (*honest[:j], f"2*({honest[j]})", *honest[j + 1 :]))
            for j in range(3)
        ),
        Bite("factor", ledger.SERIES, "e", replaced("x^(-beta/2-3/4)", "x^(-beta/3-3/4)")),
        *(Bite("factor", ledger.LEADING, name, scaled) for name in ledger.LEADING),  # type: ignore[arg-type]
        Bite("hidden factor", ledger.AIRY, "solution", unseen_at("tau", range(-3, 4))),
        Bite("hidden factor", ledger.AIRY, "beta", unseen_at("tau", range(-3, 4))),
        Bite("hypothesis", ledger, "BETA", lambda _: "-x - 1/2"),
        Bite("order", ledger.POWERS, "oscillating", replaced("-beta/2 - 3/4", "-beta/2 - 3/4 + 1")),
        Bite("order", ledger.POWERS, "power series", replaced("beta", "beta - 1")),
    ),
}
