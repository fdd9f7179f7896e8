"""Wrong formulas for the extended example system (Sec. 2)."""

from __future__ import annotations

from paper.bite import Bite, Teeth, replaced, scaled, unseen_at

from gspot_verified.paper.section_2 import lagrangian as ledger

_RELATIONS, _QUANTITIES = ledger.PRINTED["2-lagrangian"], ledger.PRINTED["2-quantities"]
_EXTENDED, _STICK = ledger.PRINTED["2-extended"], ledger.PRINTED["2-stick"]
_AT_INTEGERS = range(-3, 4)
_NAMED = ("u", "v", "p", "b", "alpha_1", "alpha_2", "alpha_3")
_FREE = {"k+": "kplus", "k-": "kminus", "p-": "pminus", "a": "a"}


ENTRIES = ledger.ENTRIES


def of_velocity(honest: str) -> str:
    """A dependence on the velocity b' stands for: the relations need coefficients of the position alone."""
    return f"{honest} + x6"


TEETH: Teeth = {
    "2-lagrangian": (
        *(Bite("factor", _RELATIONS, name, scaled) for name in ("N2", "H4")),
        *(Bite("hidden factor", _RELATIONS, name, unseen_at("x5", _AT_INTEGERS)) for name in ("N2", "H4")),
        *(Bite("hypothesis", _RELATIONS, name, of_velocity) for name in ("mu", "N4", "H1", "N3")),
        Bite("order", _RELATIONS, "H4", lambda honest: f"({honest})^2"),
    ),
    "2-quantities": (
        *(Bite("factor", _QUANTITIES, name, scaled) for name in _NAMED),
        *(Bite("hidden factor", _QUANTITIES, name, unseen_at("x5", _AT_INTEGERS)) for name in _NAMED),
        Bite("hypothesis", _QUANTITIES, "mu", lambda honest: f"-({honest})"),
        Bite("order", _QUANTITIES, "alpha_1", replaced("chi*x6", "chi*x6^2")),
        Bite("order", _QUANTITIES, "H4", lambda honest: f"({honest})^2"),
    ),
    "2-extended": (
        *(Bite("factor", _EXTENDED, name, scaled) for name in ("F1", "F5", "H2", "H4", "H6", "N2", "N4", "N6", "mu")),
        *(Bite("hidden factor", _EXTENDED, name, unseen_at("x5", _AT_INTEGERS)) for name in ("F6", "H6", "N4", "mu")),
        *(Bite("hypothesis", _EXTENDED, name, lambda _, free=free: free) for name, free in _FREE.items()),
        Bite("hypothesis", ledger.BELOW_ONE, "x5", lambda _: "1 + d"),
        Bite("order", _EXTENDED, "N4", replaced("x5", "x5^2")),
    ),
    "2-stick": (
        *(Bite("factor", _STICK, name, scaled) for name in _STICK),
        *(Bite("hidden factor", _STICK, name, unseen_at("lam", _AT_INTEGERS)) for name in _STICK),
        Bite("hypothesis", ledger.APART, "kminus", lambda _: "kplus"),
        Bite("hypothesis", ledger.APART, "kminus", lambda _: "kplus - d"),
        Bite("order", _STICK, "numerator", replaced("lam", "lam^2")),
        Bite("order", _STICK, "denominator", replaced("*lam", "*lam^2")),
    ),
}
