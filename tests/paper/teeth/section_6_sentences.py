"""Mended sentences on the oscillator (Sec. 6)."""

from __future__ import annotations

from flint import fmpq
from paper.bite import Bite, NotApplicable, Teeth, raised, reads_as, replaced, scaled

from gspot_verified.paper.checks import words
from gspot_verified.paper.section_6 import oscillator, section_6_runs
from gspot_verified.paper.section_6 import section_6_sentences as ledger

ENTRIES = ledger.ENTRIES
_WORDS = "words are compared; there is no formula"
_SIGN = "exact signs; a positive factor changes none"

TEETH: Teeth = {
    "6-attribution": (
        NotApplicable("factor", _WORDS),
        NotApplicable("hidden factor", _WORDS),
        Bite("hypothesis", words, "quoted", reads_as("leine2008", "leine2002", then=("Leine2002", "leine2002"))),
        Bite("hypothesis", words, "quoted", reads_as("proposed by", "of")),
        NotApplicable("order", _WORDS),
    ),
    "6-starts": (
        Bite("factor", ledger.IN_CONTACT, "x", scaled, refutes=True),
        Bite("hidden factor", ledger.IN_CONTACT, "psi", lambda honest: f"{honest} + S^2*w*(w - 1)", refutes=True),
        Bite("hypothesis", oscillator.MOTION, "y", replaced("l*(1 - C)", "2*l*(1 - C)")),
        Bite("hypothesis", oscillator.MOTION, "QN1", replaced("l*S", "l*C")),
        Bite("order", ledger.IN_CONTACT, "x", replaced("*w", "*w^2"), refutes=True),
    ),
    "6-positive-slip": (
        NotApplicable("factor", _SIGN),
        NotApplicable("hidden factor", _SIGN),
        Bite("hypothesis", ledger.BELT, "moving", replaced("3/5", "1/2")),
        Bite("hypothesis", ledger.BELT, "moving", replaced("- lam", "+ lam")),
        Bite("hypothesis", ledger.BELT, "at rest", lambda _: "-l*om", refutes=True),
        Bite("hypothesis", oscillator.G_SPOT, "w", lambda _: "om"),
        Bite("hypothesis", oscillator.MOTION, "QT1", replaced("C", "S - l")),
        Bite("hypothesis", ledger, "STARTS", lambda _: (fmpq(-9, 10), fmpq(1, 2))),
        NotApplicable("order", _SIGN),
    ),
    "6-any-beta": (
        NotApplicable("factor", _SIGN),
        NotApplicable("hidden factor", _SIGN),
        Bite("hypothesis", ledger.BETAS, "below", lambda _: "19/7 - lam"),
        Bite("hypothesis", ledger.BETAS, "above", lambda _: "17/7 + lam"),
        Bite("hypothesis", oscillator.PARAMETERS, "cpsi", replaced("18 - 7*beta", "18 + 7*beta")),
        Bite("hypothesis", section_6_runs.ALPHAS, "alpha_2", lambda honest: f"-({honest})"),
        Bite("hypothesis", ledger, "HIGHEST", lambda _: fmpq(10, 3)),
        Bite("order", oscillator.PARAMETERS, "cpsi", raised("beta")),
    ),
    "6-curves": (
        NotApplicable("factor", _WORDS),
        NotApplicable("hidden factor", _WORDS),
        *(
            Bite("hypothesis", words, "quoted", reads_as(honest, wrong))
            for honest, wrong in (
                ("The red/solid", "The blue/solid"),
                ("The blue/dashed", "The blue/dotted"),
                ("and purple/dotted", "and red/dotted"),
                ("(green/dash-dotted", "(green/dashed"),
            )
        ),
        NotApplicable("order", _WORDS),
    ),
    "6-colours": (
        NotApplicable("factor", _WORDS),
        NotApplicable("hidden factor", _WORDS),
        Bite("hypothesis", words, "quoted", reads_as("blue curves", "red curves")),
        Bite(
            "hypothesis",
            words,
            "quoted",
            reads_as("red curves", "blue curves", then=("The blue curves", "The red curves")),
        ),
        NotApplicable("order", _WORDS),
    ),
}
