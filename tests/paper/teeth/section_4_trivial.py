"""Wrong formulas for the trivial solution (Sec. 2)."""

from __future__ import annotations

from typing import Any

from paper.bite import Bite, NotApplicable, Teeth, raised, replaced, scaled, unseen_at

from gspot_verified.paper.section_4 import section_4_trivial as ledger
from gspot_verified.paper.section_4.section_4_outer import QUOTIENT

TRIVIAL, CORRECTED_ZY = ledger.PRINTED["2-trivial"], ledger.CORRECTED["2-trivial-zy"]
_AT_INTEGERS = range(-3, 4)


ENTRIES = {**ledger.ENTRIES, **ledger.IN_CASE_I}


def without_quotient(_: Any) -> Any:
    """α_2 = c α_1: without c = α_2/(α_1 - α_3)."""
    return ledger.ALGEBRA.read("c*alpha1")


TEETH: Teeth = {
    "2-trivial": (
        Bite("factor", TRIVIAL, "p", scaled),
        Bite("factor", TRIVIAL, "b", scaled),
        Bite("factor", TRIVIAL, "v", lambda _: "t/1000000"),
        Bite("hidden factor", TRIVIAL, "p", unseen_at("t", _AT_INTEGERS)),
        Bite("hidden factor", TRIVIAL, "b", unseen_at("alpha1", _AT_INTEGERS)),
        Bite("hypothesis", QUOTIENT, "alpha2", without_quotient),
        Bite("order", TRIVIAL, "p", raised("t")),
        Bite("order", TRIVIAL, "b", raised("epsilon")),
    ),
    "2-trivial-zy": (
        *(Bite("factor", CORRECTED_ZY, name, scaled) for name in "zy"),
        Bite("factor", ledger.PRINTED, "2-trivial-zy", lambda _: ledger.CORRECTED["2-trivial-zy"]),
        Bite("hidden factor", CORRECTED_ZY, "z", unseen_at("epsilon", _AT_INTEGERS)),
        Bite("hidden factor", CORRECTED_ZY, "y", unseen_at("c", _AT_INTEGERS)),
        Bite("hypothesis", QUOTIENT, "alpha2", without_quotient),
        *(Bite("order", CORRECTED_ZY, name, replaced("epsilon^2", "epsilon^3")) for name in "zy"),
    ),
    "2-trivial-contact": (
        Bite("factor", ledger.CONTACT_SIGNS, "force", lambda sign: f"-({sign})", refutes=True),
        Bite("hidden factor", ledger.PRINTED["2-trivial"], "b", lambda text: f"(1-2*t^2)*({text})"),
        Bite("hidden factor", ledger.CORRECTED["2-trivial-zy"], "y", lambda text: f"({text})/4"),
        *(
            Bite("hypothesis", ledger.IN_CONTACT[case], *other)
            for case, other in (
                ("II", ("alpha2", lambda _: "-x")),
                ("II", ("alpha3", lambda _: "-u-w-x")),
                ("III", ("alpha2", lambda _: "x")),
                ("III", ("alpha3", lambda _: "-x")),
            )
        ),
        NotApplicable("order", "signs of exact expressions; no order of an error occurs"),
    ),
    "3-case-I-trivial": (
        *(
            Bite("factor", ledger.TRIVIAL_SIGNS, name, lambda sign: f"-({sign})", refutes=True)
            for name in ("b p", "force")
        ),
        Bite("hidden factor", ledger.PRINTED["2-trivial"], "b", lambda text: f"(1-2*t^2)*({text})"),
        Bite("hidden factor", ledger.CORRECTED["2-trivial-zy"], "y", lambda text: f"({text})/4"),
        *(
            Bite("hypothesis", ledger.CASE_I, *other)
            for other in (("alpha2", lambda _: "x"), ("alpha3", lambda _: "-u-w-x"))
        ),
        NotApplicable("order", "signs of exact expressions; no order of an error occurs"),
    ),
}
