"""Wrong formulas for the frictional impact oscillator (Sec. 6 and Appendix B)."""

from __future__ import annotations

from flint import fmpq
from paper.bite import Bite, NotApplicable, Teeth, raised, replaced, scaled, unseen_at

from gspot_verified.paper.numerics.oscillator_formulas import PRINTED_NUMBERS
from gspot_verified.paper.section_6 import section_6 as ledger
from gspot_verified.paper.section_6.oscillator import CORRECTED, G_SPOT, MOTION, PARAMETERS, PRINTED

ENTRIES = ledger.ENTRIES
G = CORRECTED["6-sign-of-G"]
_PAIRS = (0, 1, 2)
OTHER_CONTACT = Bite("hypothesis", MOTION, "y", replaced("1 - C", "1 + C"))


def one_at_the_g_spot(honest: str) -> str:
    """A factor that is 1 where sin φ = 4/5."""
    return f"(1 + (5*S - 4))*({honest})"


TEETH: Teeth = {
    "6-motion": (
        *(Bite("factor", MOTION, part, scaled) for part in MOTION if part != "QT2"),
        Bite("factor", MOTION, "QT2", lambda _: "1/1000000*l"),
        *(Bite("hidden factor", MOTION, part, one_at_the_g_spot) for part in MOTION if part != "QT2"),
        *(Bite("hidden factor", MOTION, part, unseen_at("w", _PAIRS)) for part in ("f1", "f2", "M11", "M22")),
        Bite("hypothesis", ledger.ENERGIES, "potential", replaced(" + kpsi*psi^2/2", "")),
        Bite("hypothesis", ledger.FORCES, "1", replaced(" - cphi*w", "")),
        *(Bite("order", MOTION, part, raised("l")) for part in MOTION if part != "QT2"),
    ),
    "6-sign-of-G": (
        Bite("factor", G, "M G", scaled),
        Bite("factor", PRINTED["6-sign-of-G"], "M G", lambda _: CORRECTED["6-sign-of-G"]["M G"]),
        Bite("hidden factor", G, "M G", unseen_at("mu", _PAIRS)),
        Bite("hypothesis", PRINTED["B-p"], "formula", replaced("mu*C", "mu*S")),
        Bite("order", G, "M G", raised("mu")),
    ),
    "6-G-spot": (
        *(Bite("factor", G_SPOT, part, scaled) for part in G_SPOT),
        *(Bite("factor", PARAMETERS, part, scaled) for part in PARAMETERS if part != "cphi"),
        *(Bite("hidden factor", PARAMETERS, part, unseen_at("beta", _PAIRS)) for part in ("e", "cpsi", "kpsi")),
        *(Bite("hidden factor", PARAMETERS, part, unseen_at("kappa", _PAIRS)) for part in ("e", "cpsi", "mu")),
        Bite("hypothesis", PARAMETERS, "m2", lambda _: "2*m1"),
        Bite("hypothesis", PARAMETERS, "cphi", lambda _: "m1*l^2*om"),
        Bite("order", G_SPOT, "w", raised("om")),
        Bite("order", G_SPOT, "psi", raised("l")),
        Bite("order", G_SPOT, "x", raised("om")),
    ),
    **{
        f"6-{name}": (
            Bite("factor", PRINTED[f"6-{name}"], "value", scaled),
            Bite("hidden factor", PRINTED[f"6-{name}"], "value", unseen_at("beta", _PAIRS)),
            Bite("hidden factor", PRINTED[f"6-{name}"], "value", unseen_at("kappa", _PAIRS)),
            Bite("hypothesis", PARAMETERS, "m2", lambda _: "2*m1"),
            Bite("hypothesis", G_SPOT, "w", raised("om")),
            Bite("order", PRINTED[f"6-{name}"], "value", raised("om")),
        )
        for name in ("alpha_1", "alpha_2", "alpha_3")
    },
    "6-decimals": (
        *(
            Bite("factor", PRINTED[f"6-{name}"], "value", lambda text: f"1001/1000*({text})")
            for name in PRINTED_NUMBERS
        ),
        *(
            Bite("factor", PRINTED_NUMBERS, name, lambda text: f"{text[:-1]}{(int(text[-1]) + 1) % 10}")
            for name in PRINTED_NUMBERS
        ),
        NotApplicable(
            "hidden factor", "the claim is at one pair (β, κ): a factor that is 1 there changes nothing in it"
        ),
        Bite("hypothesis", ledger.CASE, "kappa", lambda _: fmpq(20)),
        Bite("hypothesis", ledger.CASE, "beta", lambda _: fmpq(1, 2)),
        Bite("hypothesis", ledger, "in_case_iii", lambda honest: lambda a, b, c: honest(a, -b, c)),
        *(Bite("order", PRINTED_NUMBERS, name, lambda text: f"{text}0") for name in PRINTED_NUMBERS),
    ),
    **{
        f"B-{name}": (
            Bite("factor", PRINTED[f"B-{name}"], "formula", scaled),
            Bite("hidden factor", PRINTED[f"B-{name}"], "formula", one_at_the_g_spot),
            Bite("hidden factor", PRINTED[f"B-{name}"], "formula", unseen_at("m2", (1,))),
            OTHER_CONTACT,
            Bite("order", PRINTED[f"B-{name}"], "formula", raised("l")),
        )
        for name in ("v", "p", "b", "alpha_1", "alpha_2", "alpha_3")
    },
}
