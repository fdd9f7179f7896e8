"""Wrong formulas for the inner scale (Sec. 4)."""

from __future__ import annotations

from typing import Any

from paper.bite import Bite, Teeth, raised, replaced, scaled, unseen_at

from gspot_verified.paper.section_4 import section_4_inner as ledger

_PRINTED, _CORRECTED = ledger.PRINTED, ledger.CORRECTED
_AT_INTEGERS = range(-3, 4)
_SCALING = _PRINTED["4-inner-scaling"]


ENTRIES = ledger.ENTRIES


def another_power(_: Any) -> Any:
    """ε = δ⁴: without δ = ε^(1/3)."""
    return ledger.ALGEBRA.read("delta^4")


OTHER_SCALE = Bite("hypothesis", ledger.INNER_SCALE, "epsilon", another_power)

TEETH: Teeth = {
    "4-inner": (
        Bite("factor", _PRINTED["4-inner"], "equation", scaled),
        Bite("factor", _PRINTED["4-inner"], "equation", replaced("2*g3", "2000001/1000000*g3")),
        Bite("hidden factor", _PRINTED["4-inner"], "equation", unseen_at("s", _AT_INTEGERS)),
        OTHER_SCALE,
        Bite("order", _PRINTED["4-inner"], "equation", replaced("delta*", "delta^2*")),
    ),
    "4-inner-fast": (
        Bite("factor", _CORRECTED["4-inner-fast"], "equation", scaled),
        Bite("factor", _PRINTED["4-inner-fast"], "equation", lambda _: ledger.CORRECTED["4-inner-fast"]["equation"]),
        Bite("hidden factor", _CORRECTED["4-inner-fast"], "equation", unseen_at("delta", (0, 1))),
        OTHER_SCALE,
        Bite("order", _CORRECTED["4-inner-fast"], "equation", replaced("delta^2", "delta^3")),
    ),
    "4-inner-fast-polynomial": (
        Bite("factor", _PRINTED["4-inner-fast-polynomial"], "polynomial", scaled),
        Bite("hidden factor", _PRINTED["4-inner-fast-polynomial"], "polynomial", unseen_at("lam", (0, -2))),
        Bite("hypothesis", _CORRECTED["4-inner-fast"], "equation", replaced("delta^2*alpha1*s", "alpha1*s")),
        Bite("order", _PRINTED["4-inner-fast-polynomial"], "polynomial", replaced("lam^3", "lam^4")),
    ),
    "4-inner-slow": (
        Bite("factor", _PRINTED["4-inner-slow"], "equation", scaled),
        Bite("factor", _PRINTED["4-inner-slow"], "equation", replaced("2*g3", "2000001/1000000*g3")),
        Bite("hidden factor", _PRINTED["4-inner-slow"], "equation", unseen_at("s", _AT_INTEGERS)),
        OTHER_SCALE,
        Bite("order", _PRINTED["4-inner-slow"], "equation", replaced("g3", "g4")),
    ),
    "4-theta": (
        Bite("factor", _PRINTED["4-theta"], "equation", scaled),
        Bite("factor", _PRINTED["4-theta"], "kappa cubed", scaled),
        Bite("hidden factor", _PRINTED["4-theta"], "equation", unseen_at("tau", range(5))),
        Bite("hidden factor", _PRINTED["4-theta"], "kappa cubed", unseen_at("alpha1", (-1, -2, -3))),
        Bite("hypothesis", ledger, "ALPHA_1", lambda _: "x - w"),
        Bite("order", _PRINTED["4-theta"], "equation", replaced("tau*", "tau^2*")),
    ),
    "4-inner-scaling": (
        *(Bite("factor", _SCALING, name, scaled) for name in _SCALING),
        *(Bite("hidden factor", _SCALING, name, unseen_at("delta", (0, 1))) for name in _SCALING),
        OTHER_SCALE,
        *(Bite("order", _SCALING, name, raised("delta")) for name in _SCALING),
    ),
    "4-inner-scaling-v": (
        Bite("factor", _CORRECTED["4-inner-scaling-v"], "v factor", scaled),
        Bite("factor", _PRINTED["4-inner-scaling-v"], "v", scaled),
        Bite("factor", _PRINTED["4-inner-scaling-v"], "v factor", lambda _: "delta"),
        Bite("hidden factor", _CORRECTED["4-inner-scaling-v"], "v factor", unseen_at("delta", (0, 1))),
        OTHER_SCALE,
        Bite("order", _CORRECTED["4-inner-scaling-v"], "v factor", lambda _: "delta^3"),
    ),
}
