"""Another count, other differences, mended brackets (Sec. 5)."""

from __future__ import annotations

from paper.bite import GENERIC, Bite, NotApplicable, Teeth, reads_as, replaced, scaled, unseen_at

from gspot_verified.expansion.series.system import GSpotError
from gspot_verified.paper.checks import words
from gspot_verified.paper.checks.identities import Algebra
from gspot_verified.paper.section_5 import section_5_outer
from gspot_verified.paper.section_5 import section_5_sentences as ledger

ENTRIES = ledger.ENTRIES


def _no_place(_: object) -> None:
    raise GSpotError("a singular Jacobian")


_COUNT = "a count of equations; a factor changes none"
_LETTERS = "letters are compared; there is no formula"
_SIDE = "a sign is compared; a positive factor changes none"
_WORDS = "brackets are counted; there is no formula"

TEETH: Teeth = {
    "5-kinds": (
        NotApplicable("factor", _COUNT),
        Bite("hidden factor", ledger.LEFT, "Z", lambda honest: f"{honest} + z1"),
        Bite("hypothesis", ledger.KINDS, "printed", lambda _: ledger.KINDS["corrected"]),
        Bite("hypothesis", ledger.LEFT, "V", replaced("v1", "v0")),
        NotApplicable("order", _COUNT),
    ),
    "5-synchronised": (
        Bite("factor", ledger.EXTENDED, "v", replaced("p*lam", f"{GENERIC}*p*lam")),
        Bite("hidden factor", ledger.FUNCTIONS, "B", unseen_at("lam", (0, 1))),
        Bite("hypothesis", ledger.EXTENDED, "y", lambda _: "V + b"),
        Bite("order", ledger.FUNCTIONS, "V", replaced("P*lam", "P^2*lam")),
    ),
    "5-locally-unique": (
        Bite("factor", Algebra, "determinant", lambda honest: lambda *rows: 2 * honest(*rows) + 1),
        NotApplicable("hidden factor", "an identity in symbols; no points are sampled"),
        Bite("hypothesis", ledger.AT_THE_G_SPOT, "J", lambda _: "m - 5"),
        Bite("hypothesis", ledger, "REGULAR", lambda _: "singular"),
        Bite("hypothesis", ledger, "find_g_spot", lambda _: _no_place),
        NotApplicable("order", "no order of an error occurs"),
    ),
    "5-typesetting": (
        NotApplicable("factor", _LETTERS),
        NotApplicable("hidden factor", _LETTERS),
        Bite("hypothesis", words, "quoted", reads_as(":= =r_{b,n}", ":=r_{b,n}", then=(r"P_\nu-3$", r"P_{\nu-3}$"))),
        NotApplicable("order", _LETTERS),
    ),
    "5-approaching-side": (
        NotApplicable("factor", _SIDE),
        NotApplicable("hidden factor", _SIDE),
        Bite("hypothesis", words, "quoted", reads_as("manifold for $p<0$.", "manifold for $p>0$.")),
        Bite("hypothesis", words, "quoted", reads_as(r"\xi_0(-t)^r", r"\xi_0(t)^r")),
        Bite("hypothesis", ledger.ATTRACTED, "corrected", lambda _: "<"),
        Bite("order", ledger, "SLOPE", lambda _: "a2"),
    ),
    "5-manifold-names": (
        Bite("factor", section_5_outer.PRINTED["5-outer-system"], "v", scaled),
        NotApplicable("hidden factor", "identities in symbols; no points are sampled"),
        Bite(
            "hypothesis",
            words,
            "quoted",
            reads_as(
                "occur on the slow manifold", "occur on the critical manifold", then=(r"\em critical", r"\em slow")
            ),
        ),
        Bite("hypothesis", section_5_outer.PRINTED["5-slow-manifold"], "b", lambda _: "b*alpha1"),
        Bite("hypothesis", ledger.NAMES, "near by", lambda _: "critical"),
        NotApplicable("order", "no order of an error occurs"),
    ),
    "5-letters": (
        NotApplicable("factor", _LETTERS),
        NotApplicable("hidden factor", _LETTERS),
        Bite("hypothesis", words, "quoted", reads_as(r"\tilde{F}", "F", then=(r"\tilde{G}", "G"))),
        NotApplicable("order", _LETTERS),
    ),
    "5-brackets": (
        NotApplicable("factor", _WORDS),
        NotApplicable("hidden factor", _WORDS),
        Bite("hypothesis", ledger, "quoted", reads_as(r"\phi_0\right))+", r"\phi_0\right)+")),
        Bite("hypothesis", ledger, "quoted", reads_as(r"{(2(\beta-1)/3}", r"{2(\beta-1)/3}")),
        Bite("hypothesis", ledger, "quoted", reads_as("$b=p=0$.", "$b=p=0$).")),
        NotApplicable("order", _WORDS),
    ),
}
