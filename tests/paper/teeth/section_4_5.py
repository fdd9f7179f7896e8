"""Wrong formulas for the force at leading order and the signs of Sec. 4.5."""

from __future__ import annotations

from flint import fmpq
from paper.bite import Bite, NotApplicable, Teeth, raised, reads_as, replaced, scaled, unseen_at

from gspot_verified.paper.appendix_a import hypergeometric as appendix
from gspot_verified.paper.checks import closed_forms, gamma_cells, words
from gspot_verified.paper.section_4_5 import section_4_5 as ledger
from gspot_verified.paper.section_4_5 import section_4_5_signs as signs

_MEAN = ledger.CORRECTED["S-mean-force"]
_FORCE = ledger.PRINTED["S-deviation-force"]
_INTERVALS = signs.CORRECTED["S-gamma-intervals"]
_BETAS = ("1/2", "3/2", "7/3")
_LETTERS = "letters are compared; there is no formula"
_POSITIVE_FACTOR = "a claim about a sign: a factor near 1 keeps it"


ENTRIES = ledger.ENTRIES


TEETH: Teeth = {
    "S-mean-force": (
        Bite("factor", _MEAN, "force", scaled),
        # The printed form as the corrected one, and the corrected one as the printed one.
        Bite("factor", _MEAN, "force", lambda _: ledger.PRINTED["S-mean-force"]["force"]),
        Bite("factor", ledger.PRINTED["S-mean-force"], "force", lambda _: _MEAN["force"]),
        Bite("hidden factor", _MEAN, "force", unseen_at("alpha1", (-1,))),
        Bite("hidden factor", _MEAN, "force", unseen_at("alpha2", (-1, "-3/2", -2))),
        # Another trajectory than the distinguished one.
        Bite("hypothesis", ledger.TRIVIAL["2-trivial"], "b", lambda honest: f"2*({honest})"),
        Bite("hypothesis", ledger.TRIVIAL["2-trivial"], "b", raised("t")),
        Bite("order", _MEAN, "force", raised("alpha2")),
    ),
    "S-deviation-force": (
        Bite("factor", _FORCE, "force", scaled),
        Bite("hidden factor", _FORCE, "force", unseen_at("beta", _BETAS)),
        Bite("hidden factor", _FORCE, "force", unseen_at("beta", (2, 4, 5, "1/2", "3/2", "7/3"))),
        # Another time scale than t = ε^(2/3) s, another size of b.
        Bite("hypothesis", ledger.INNER, "tau", replaced("epsilon^(-2/3)", "epsilon^(-1/2)")),
        Bite("hypothesis", ledger.INNER, "front", replaced("kappa^(-beta)", "kappa^(1-beta)")),
        Bite("order", _FORCE, "force", raised("epsilon")),
        Bite("order", _FORCE, "force", raised("kappa")),
    ),
    "S-force-sign": (
        NotApplicable("factor", _POSITIVE_FACTOR),
        Bite("hidden factor", ledger.PRINTED["S-force-sign"], "sign of", unseen_at("beta", _BETAS)),
        Bite("hypothesis", ledger.HYPOTHESES["S-force-sign"], "alpha3", lambda honest: f"1{honest}"),
        Bite("order", ledger.PRINTED["S-force-sign"], "sign of", raised("C_1")),
    ),
    "S-dominance": (
        Bite("factor", ledger.PRINTED["S-dominance"], "exponent", scaled),
        Bite("hidden factor", ledger.PRINTED["S-dominance"], "exponent", unseen_at("beta", _BETAS)),
        Bite("hypothesis", ledger.HYPOTHESES["S-dominance"], "dominates", lambda honest: f"1+{honest}"),
        Bite("hypothesis", ledger.HYPOTHESES["S-dominance"], "is dominated", lambda honest: f"{honest}-2"),
        Bite("order", ledger.PRINTED["S-dominance"], "exponent", lambda honest: f"{honest}+1"),
    ),
    "S-minus-infinity": (
        NotApplicable("factor", _POSITIVE_FACTOR),
        Bite("hidden factor", signs.PRINTED["S-minus-infinity"], "sign", unseen_at("beta", range(1, 13))),
        Bite("hypothesis", signs.HYPOTHESES["S-minus-infinity"], "beta", lambda honest: f"{honest}-1"),
        Bite("order", appendix.THETA, "small leading", raised("beta")),
    ),
    "S-zero": (
        NotApplicable("factor", _POSITIVE_FACTOR),
        Bite("hidden factor", signs.PRINTED["S-zero"], "sign of", unseen_at("beta", _BETAS)),
        Bite("hypothesis", signs, "NOT_INTEGER", lambda betas: (*betas, fmpq(1))),
        Bite("order", signs.PRINTED["S-zero"], "sign of", raised("beta")),
        Bite("order", signs.AT_INTEGERS["S-zero"], "1", lambda _: "0"),
    ),
    "S-plus-infinity": (
        Bite("factor", signs.AT_INTEGERS["S-plus-infinity"], "leading", scaled),
        Bite("hidden factor", signs.PRINTED["S-plus-infinity"], "sign of", unseen_at("beta", _BETAS)),
        Bite("hidden factor", signs.AT_INTEGERS["S-plus-infinity"], "leading", unseen_at("n", range(1, 6))),
        Bite("hypothesis", signs, "NOT_INTEGER", lambda betas: (*betas, fmpq(2))),
        Bite("order", signs.PRINTED["S-plus-infinity"], "sign of", raised("beta")),
        Bite("order", signs.AT_INTEGERS["S-plus-infinity"], "leading", raised("tau")),
    ),
    "S-gamma-intervals": (
        *(Bite("factor", _INTERVALS, name, scaled) for name in _INTERVALS),
        *(Bite("hidden factor", _INTERVALS, name, unseen_at("n", range(1, 5))) for name in _INTERVALS),
        Bite("hypothesis", closed_forms, "INTEGERS", lambda names: tuple(name for name in names if name != "n")),
        Bite("hypothesis", gamma_cells, "ABOVE_0", lambda honest: f"{honest}-1"),
        *(Bite("order", _INTERVALS, name, lambda honest: f"{honest}+1") for name in _INTERVALS),
    ),
    "S-gamma-name": (
        NotApplicable("factor", _LETTERS),
        NotApplicable("hidden factor", _LETTERS),
        Bite("hypothesis", words, "quoted", reads_as("Here $Gamma$", r"Here $\Gamma$")),
        Bite("hypothesis", words, "quoted", reads_as("represents the Gamma", "stands for the Gamma")),
        NotApplicable("order", _LETTERS),
    ),
}
