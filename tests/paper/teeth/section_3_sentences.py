"""Wrong sentences on the simulations (Sec. 3)."""

from __future__ import annotations

from typing import Any

from flint import fmpq
from paper.bite import Bite, NotApplicable, Teeth, replaced, unseen_at

from gspot_verified.paper.section_3 import section_3_sentences as ledger

ENTRIES = ledger.ENTRIES


def other_fate(honest: Any) -> Any:
    """The same fate on both sides of the trivial solution."""
    return lambda beta, nu: honest(beta, fmpq(2) if nu == 4 else nu) if nu != fmpq(1, 2) else honest(beta, fmpq(2))


def negative_for(nu: fmpq) -> Any:
    """The state of one ν replaced by that of the other side."""
    return lambda honest: lambda n, *rest: honest(fmpq(1, 2) if n == nu else n, *rest)


TEETH: Teeth = {
    "3-oscillations": (
        Bite("factor", ledger.CONTACT, "V", replaced("p*(Z - Y)", "1000003/1000000*p*(Z - Y)")),
        Bite("factor", ledger, "DISCRIMINANT", replaced("13*p", "13000003/1000000*p")),
        Bite("hidden factor", ledger, "CUBIC", unseen_at("p", range(1, 3))),
        Bite("hypothesis", ledger, "AT", lambda honest: (*honest, fmpq(-1))),
        NotApplicable("order", "the rates are exact; no order of an error occurs"),
    ),
    "3-case-II": (
        Bite("factor", ledger.TRIVIAL, "b", replaced("-r*p", "-1000003/1000000*r*p")),
        Bite("hidden factor", ledger.TRIVIAL, "b", unseen_at("p", range(1, 3))),
        Bite("hypothesis", ledger.CASE_II_SIGNS, "alpha_2", lambda _: "-y"),
        Bite("hypothesis", ledger, "NEAR", lambda _: fmpq(1, 2)),
        NotApplicable("order", "the counterexamples are one exact solution and one run; no order of an error occurs"),
    ),
    "3-case-II-starts": (
        Bite("factor", ledger.CASE_II, "alpha_2", lambda honest: -honest),
        Bite("hidden factor", ledger, "case_ii", negative_for(fmpq(4))),
        Bite("hypothesis", ledger, "REACHES", lambda _: fmpq(1, 2)),
        Bite("hypothesis", ledger, "ATTRACTED", lambda honest: (*honest, fmpq(1, 2))),
        Bite("hypothesis", ledger, "OTHERS", lambda honest: (*honest, ledger.NEAR)),
        NotApplicable("order", "the claim is on what runs do for every ε ≤ ε0; no order of an error occurs"),
    ),
    "3-separatrix": (
        Bite("factor", ledger, "SIDES", lambda honest: tuple(zip(*honest, strict=True))),
        Bite("hidden factor", ledger.varsim1, "fate_by_side", other_fate),
        Bite("hypothesis", ledger.varsim1, "EPSILON_0", lambda honest: dict.fromkeys(honest, fmpq(1, 2))),
        NotApplicable("order", "the claim is on what runs do for every ε ≤ ε0; no order of an error occurs"),
    ),
    "3-flight-ends": (
        Bite("factor", ledger.FLIGHT, "y", replaced("alpha2*u^3/6", "1000003/6000000*alpha2*u^3")),
        Bite("hidden factor", ledger.FLIGHT, "v", unseen_at("u", range(3))),
        Bite("hypothesis", ledger, "falls_for_ever", lambda honest: lambda: honest(False)),
        NotApplicable("order", "free motion is exact; no order of an error occurs"),
    ),
}
