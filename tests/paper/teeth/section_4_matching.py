"""Wrong formulas for the matching and the powers of ε (Sec. 4.4)."""

from __future__ import annotations

from typing import Any

from paper.bite import Bite, NotApplicable, Teeth, replaced, scaled, unseen_at

from gspot_verified.paper.section_4 import section_4_matching as ledger

_MATCHING, _EXPONENTS = ledger.PRINTED["4-matching"], ledger.PRINTED["4-exponents"]
_MIDDLE = ledger.CORRECTED["4-matching-middle"]
_TRIED = (2, 3)


ENTRIES = ledger.ENTRIES


def another_power(_: Any) -> Any:
    """ε = δ⁴: without δ = ε^(1/3)."""
    return ledger.OUTER_ALGEBRA.read("delta^4")


def first_decimal(honest: Any) -> Any:
    """0.3334 in the place of 0.3333."""
    return (("0.3334", *honest[0][1:]), *honest[1:])


OTHER_SCALE = Bite("hypothesis", ledger.INNER_SCALE, "epsilon", another_power)

TEETH: Teeth = {
    "4-matching": (
        *(Bite("factor", _MATCHING, name, scaled, refutes=True) for name in _MATCHING),
        Bite("factor", ledger, "LEADING", scaled),
        *(Bite("hidden factor", _MATCHING, name, unseen_at("beta", _TRIED)) for name in _MATCHING),
        Bite("hidden factor", ledger, "LEADING", unseen_at("beta", _TRIED)),
        OTHER_SCALE,
        Bite("order", _MATCHING, "outer", replaced("beta", "beta + 1")),
        Bite("order", ledger, "LEADING", replaced("beta", "beta + 1")),
    ),
    "4-matching-middle": (
        Bite("factor", _MIDDLE, "middle", scaled),
        Bite("factor", ledger.PRINTED["4-matching-middle"], "middle", lambda honest: f"beta*({honest})"),
        Bite("hidden factor", _MIDDLE, "middle", unseen_at("beta", _TRIED)),
        OTHER_SCALE,
        Bite("order", _MIDDLE, "middle", replaced("beta", "(beta+1)")),
    ),
    "4-exponents": (
        *(Bite("factor", _EXPONENTS, name, scaled) for name in _EXPONENTS),
        *(Bite("hidden factor", _EXPONENTS, name, unseen_at("beta", _TRIED)) for name in _EXPONENTS),
        OTHER_SCALE,
        *(Bite("order", _EXPONENTS, name, lambda honest: f"{honest} + 1") for name in _EXPONENTS),
    ),
    "4-table": (
        Bite("factor", ledger, "TABLE", first_decimal),
        *(Bite("factor", _EXPONENTS, name, lambda honest: f"1001/1000*({honest})") for name in "byv"),
        NotApplicable("hidden factor", "the claim is on the three values of β alone; for all β: 4-exponents"),
        OTHER_SCALE,
        *(Bite("order", _EXPONENTS, name, lambda honest: f"{honest} + 1") for name in "byv"),
    ),
}
