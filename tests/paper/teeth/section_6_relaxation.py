"""Wrong relaxations and units (Sec. 6)."""

from __future__ import annotations

from flint import fmpq
from paper.bite import GENERIC, Bite, NotApplicable, Teeth, raised, replaced

from gspot_verified.paper.section_6 import oscillator, section_6_runs
from gspot_verified.paper.section_6 import section_6_relaxation as ledger

ENTRIES = ledger.ENTRIES

TEETH: Teeth = {
    "6-units": (
        NotApplicable("factor", "powers of the units; a number changes none, and both routes are linear in the parts"),
        Bite("hidden factor", oscillator.PARAMETERS, "kphi", replaced("m1*g*l", f"{GENERIC}*m1*g*l*l")),
        Bite("hypothesis", oscillator.PARAMETERS, "cpsi", replaced("om", "om^2")),
        Bite("hypothesis", oscillator.MOTION, "f2", replaced("(m1 + m2)*g", "(m1 + m2)")),
        Bite("hypothesis", oscillator.MOTION, "QT1", replaced("l*C", "l^2*C")),
        Bite("hypothesis", oscillator.MOTION, "QN2", replaced("1+", "l+")),
        Bite("order", oscillator.PARAMETERS, "kpsi", raised("m1")),
    ),
    "6-relaxation": (
        Bite("factor", ledger, "FACTOR", lambda honest: honest * 3),
        NotApplicable("hidden factor", "one number at one place; nothing is sampled"),
        Bite("hypothesis", ledger.PLACE, "away", lambda _: fmpq(1, 20)),
        Bite("hypothesis", ledger, "NEAR_P", lambda honest: 2 * honest),
        Bite("hypothesis", ledger, "SLIP_TIME", lambda honest: tuple(10 * end for end in honest)),
        Bite("order", section_6_runs, "EPSILON", lambda honest: honest * 10),
    ),
}
