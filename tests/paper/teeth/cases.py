"""Wrong formulas for Cases I, II and III of Sec. 4.5."""

from __future__ import annotations

from flint import fmpq
from paper.bite import Bite, NotApplicable, Teeth, raised, replaced, scaled, unseen_at

from gspot_verified.paper.checks import gamma_cells
from gspot_verified.paper.section_4_5 import cases as ledger
from gspot_verified.paper.section_4_5 import growth, lift_off

_PRINTED, _WORDING, _GROWTH = ledger.PRINTED, ledger.CORRECTED["S-wording"], lift_off.PRINTED["S-growth"]
_POSITIVE_FACTOR = "a claim about a sign: a factor near 1 keeps it"


ENTRIES = ledger.ENTRIES


def one_at_a_half(honest: str) -> str:
    """A factor that is 1 at β = 1/2 and changes its sign between 0 and 1."""
    return f"(1-8*(beta-1/2)^2)*({honest})"


TEETH: Teeth = {
    "S-iwc": (
        NotApplicable("factor", _POSITIVE_FACTOR),
        Bite("hidden factor", _PRINTED["S-iwc"], "sign", one_at_a_half),
        Bite("hypothesis", ledger.BETA_RANGE, "S-iwc", lambda _: "0..2"),
        Bite("hypothesis", ledger.HYPOTHESES["S-iwc"], "beta", lambda honest: f"2*{honest}"),
        NotApplicable("order", "the sign is stated for every τ: there is no error term"),
    ),
    "S-wording": (
        # The printed words with dΘ/dτ in place of Θ; a factor near 1 keeps the signs.
        Bite("factor", _PRINTED, "S-wording", lambda _: dict(_WORDING)),
        *(Bite("factor", _WORDING, name, scaled) for name in _WORDING),
        *(Bite("hidden factor", _WORDING, name, one_at_a_half) for name in _WORDING),
        Bite("hypothesis", ledger.HYPOTHESES["S-wording"], "beta", lambda _: "u"),
        Bite("order", _WORDING, "far left", raised("x")),
    ),
    "S-side": (
        NotApplicable("factor", _POSITIVE_FACTOR),
        Bite("hidden factor", _PRINTED["S-side"], "side", unseen_at("beta", ("3/2", "5/2", "7/2"))),
        Bite("hypothesis", ledger.HYPOTHESES["S-side"], "alpha3", replaced("(1+u)", "u")),
        Bite("hypothesis", ledger.HYPOTHESES["S-side"], "alpha2", lambda _: "x-1"),
        Bite("hypothesis", ledger.HYPOTHESES["S-side"], "alpha1", lambda _: "w"),
        Bite("order", _PRINTED["S-side"], "side", raised("C_1")),
    ),
    "S-iwc-case-III": (
        Bite("factor", ledger, "BELOW", lambda share: share * fmpq(102, 100)),
        Bite("hidden factor", _PRINTED["S-iwc-case-III"], "side", unseen_at("beta", ("3/2", "7/3", "7/2"))),
        Bite("hypothesis", ledger.HYPOTHESES["S-iwc-case-III"], "alpha3", replaced("(1+u)", "u")),
        Bite("hypothesis", ledger.HYPOTHESES["S-iwc-case-III"], "beta", replaced("1+u", "u")),
        Bite("hypothesis", ledger.HYPOTHESES["S-iwc-case-III"], "alpha1", lambda _: "w"),
        Bite("order", _PRINTED["S-iwc-case-III"], "side", raised("C_1")),
    ),
    "S-growth": (
        *(Bite("factor", _GROWTH, name, scaled) for name in _GROWTH),
        Bite("hidden factor", _GROWTH, "rate", unseen_at("beta", ("3/2", "5/2"))),
        Bite("hypothesis", ledger.HYPOTHESES["S-growth"], "beta", replaced("1+u", "u")),
        Bite("factor", growth, "ROOT", lambda _: "1/3"),
        Bite("hypothesis", growth.RATES, "s", lambda honest: f"{honest} + q"),
        Bite("hypothesis", growth.RATES, "q", replaced("q^2", "2*q^2")),
        Bite("hypothesis", growth, "THIRD", replaced("a*M0", "2*a*M0")),
        Bite("order", _GROWTH, "power", lambda honest: f"{honest}+1"),
        Bite("order", _GROWTH, "rate", raised("beta")),
    ),
    "S-switching": (
        NotApplicable("factor", _POSITIVE_FACTOR),
        Bite("hidden factor", _PRINTED["S-switching"], "function", unseen_at("beta", ("3/2", "5/2", "7/2"))),
        Bite("hypothesis", gamma_cells, "ABOVE_0", lambda honest: f"{honest}-1"),
        # Γ(-β)^2 does not change its sign.
        Bite("order", _PRINTED["S-switching"], "function", lambda honest: f"{honest}*{honest}"),
    ),
}
