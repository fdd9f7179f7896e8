"""Wrong conditions for Cases I, II and III (Sec. 1)."""

from __future__ import annotations

from typing import Any

from paper.bite import Bite, NotApplicable, Teeth, Tooth, replaced, unseen_at

from gspot_verified.paper.section_1 import section_1_cases as ledger

ENTRIES = ledger.ENTRIES


def without_sign(key: str, text: str) -> Any:
    """One α of a Case with another sign condition."""
    return lambda honest: {**honest, key: text}


def slower_rate_zero(name: str) -> list[Bite]:
    """α_3 = 0 in Cases I and II: b then ends at another value than 0, and the G-spot is not reached."""
    images = {"alpha1": "-u", "alpha3": "0*w"}
    return (
        [] if name == "1-case-III" else [Bite("hypothesis", ledger.CASES, name, lambda honest: honest | images, True)]
    )


def _teeth(name: str) -> tuple[Tooth, ...]:
    other = {"1-case-I": ("alpha2", "m"), "1-case-II": ("alpha1", "-u+w"), "1-case-III": ("alpha2", "m")}[name]
    return (
        Bite("factor", ledger.RATES, "b", replaced("alpha3*b", "1000003/1000000*alpha3*b")),
        Bite("factor", ledger.RATES, "p", replaced("alpha1*p", "1000003/1000000*alpha1*p")),
        Bite("hidden factor", ledger.RATES, "b", unseen_at("p", range(1, 4))),
        Bite("hypothesis", ledger.CASES, name, without_sign(*other)),
        *slower_rate_zero(name),
        Bite("hypothesis", ledger.START, name, lambda _: "n*u"),
        Bite("hypothesis", ledger.GROWS, name, lambda honest: not honest),
        NotApplicable("order", "exact solutions; no order of an error occurs"),
    )


def without_line(key: str, text: str) -> Any:
    """One eigenvector with another part."""
    return lambda honest: {**honest, key: text}


TEETH: Teeth = {
    **{name: _teeth(name) for name in ledger.CASES},
    "1-eigendirections": (
        Bite("factor", ledger.DIRECTIONS, "alpha1", without_line("b", "1000003/1000000*alpha2"), refutes=True),
        Bite("factor", ledger.RATES, "b", replaced("alpha3*b", "1000003/1000000*alpha3*b")),
        Bite(
            "hidden factor", ledger.DIRECTIONS, "alpha1", without_line("p", "(1 + alpha2*(alpha2^2-1))*(alpha1-alpha3)")
        ),
        Bite("hypothesis", ledger.CASES, "1-case-I", without_sign("alpha1", "-w")),
        Bite("hypothesis", ledger.CASES, "1-case-III", without_sign("alpha1", "w")),
        *(Bite("hypothesis", ledger.STRONG, name, lambda honest: honest[::-1], refutes=True) for name in ledger.CASES),
        Bite("hypothesis", ledger.DIRECTIONS, "alpha3", without_line("b", "0*b")),
        NotApplicable("order", "exact directions; no order of an error occurs"),
    ),
}
