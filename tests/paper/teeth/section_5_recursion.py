"""Wrong formulas for the inner scale and the steps of Theorem 1's recursion (Sec. 5)."""

from __future__ import annotations

from typing import Any

from paper.bite import Bite, NotApplicable, Teeth, raised, replaced, scaled, unseen_at

from gspot_verified.paper.section_5 import section_5_recursion as ledger

ENTRIES = ledger.ENTRIES
INNER, START, ORDERS, THIRD, STEP_3 = (
    ledger.PRINTED[identifier]
    for identifier in ("5-inner-system", "5-scaled-start", "5-orders", "5-third-order", "5-step-3")
)
MONOMIAL, XI = ledger.CORRECTED["5-monomial"], ledger.CORRECTED["5-xinprime"]
_SMALL = range(7)


def beyond_the_example(honest: str) -> str:
    """A factor that differs from 1 from δ⁶ on, where the example is not computed."""
    return f"(1 + delta^6)*({honest})"


def without_y(honest: Any) -> Any:
    """SpecialLn without y_n."""
    return lambda: honest() | {"L": ledger.ALGEBRA.read("l0 - z0")}


TEETH: Teeth = {
    "5-inner-system": (
        *(Bite("factor", INNER, part, scaled) for part in INNER),
        *(Bite("hidden factor", INNER, part, beyond_the_example) for part in INNER),
        *(Bite("hypothesis", ledger.SCALING, name, lambda power: power + 1) for name in ("b", "y", "v", "z")),
        *(Bite("order", INNER, part, raised("delta")) for part in INNER),
    ),
    "5-scaled-start": (
        *(Bite("factor", START, part, scaled) for part in START),
        *(Bite("hidden factor", START, part, lambda honest: f"(1 + delta^9)*({honest})") for part in START),
        *(Bite("hypothesis", ledger.SCALING, name, lambda power: power + 1) for name in ("p", "b", "y", "v")),
        Bite("hypothesis", ledger.SYNCHRONISED, "Y", lambda _: "Y - 2*y"),
        *(Bite("order", START, part, raised("delta")) for part in START),
        *(Bite("order", START, part, replaced("delta", "delta^2*delta"), refutes=True) for part in "BYV"),
    ),
    "5-orders": (
        *(
            Bite("factor", ORDERS, part, scaled)
            for part in ("P", "r_p", "B", "r_b", "Y", "V", "r_v", "Z", "r_z", "L", "p_0")
        ),
        *(Bite("hidden factor", ORDERS, part, unseen_at("n", _SMALL)) for part in ("r_b", "r_v", "b left", "v right")),
        *(Bite("hidden factor", ORDERS, part, unseen_at("k", (0, 1))) for part in ("b right", "v left")),
        Bite("hypothesis", INNER, "specialZ", replaced("delta*z1", "z1")),
        Bite("hypothesis", INNER, "specialV", replaced("b0 + p*lam", "b0 - p*lam")),
        *(
            Bite("order", ORDERS, part, lambda text: f"{text} + 1")
            for part in ("b last", "v last", "b first", "v first")
        ),
        Bite("order", ORDERS, "p_0", raised("s")),
    ),
    "5-third-order": (
        *(Bite("factor", THIRD, part, scaled) for part in ("specialYnbis", "line 1667")),
        *(Bite("hidden factor", THIRD, part, unseen_at("s", _SMALL)) for part in THIRD),
        Bite("factor", THIRD, "third-order_b", replaced("2*b3", "1000003/500000*b3")),
        Bite("hypothesis", ledger, "_equations", without_y),
        *(Bite("order", THIRD, part, raised("s")) for part in THIRD),
    ),
    "5-monomial": (
        Bite("factor", MONOMIAL, "image", scaled),
        Bite("factor", ledger.PRINTED["5-monomial"], "image", lambda _: ledger.CORRECTED["5-monomial"]["image"]),
        Bite("hidden factor", MONOMIAL, "image", unseen_at("k", _SMALL)),
        NotApplicable("hypothesis", "an identity in s, k, α_1* and α_3*: nothing is assumed"),
        Bite("order", MONOMIAL, "image", raised("k")),
        Bite("order", MONOMIAL, "image", replaced("u3", "s*u3")),
    ),
    "5-step-3": (
        *(Bite("factor", STEP_3, part, scaled) for part in STEP_3),
        *(Bite("hidden factor", STEP_3, part, unseen_at("s", _SMALL)) for part in STEP_3),
        Bite("hypothesis", THIRD, "third-order_b", lambda _: "0*s"),
        *(Bite("order", STEP_3, part, raised("s")) for part in STEP_3),
    ),
    "5-xinprime": (
        Bite("factor", XI, "right", scaled),
        Bite("factor", ledger.PRINTED["5-xinprime"], "right side", scaled),
        Bite("factor", ledger.PRINTED["5-xinprime"], "right", lambda _: "k"),
        Bite("hidden factor", XI, "right", unseen_at("n", _SMALL)),
        Bite("hidden factor", XI, "right", unseen_at("k", _SMALL)),
        Bite("hypothesis", INNER, "specialX", replaced("f + g*lam", "f")),
        Bite("order", ledger.PRINTED["5-xinprime"], "last", lambda text: f"{text} + 1"),
        Bite("order", ledger.PRINTED["5-xinprime"], "left", lambda text: f"{text} + 1"),
    ),
}
