"""Ledger of the equations of p, b, y, v in positive slip (Sec. 2).

r is λ_N; LFp, LGp, ... are Lie derivatives along F and G.
"""

from __future__ import annotations

from flint import fmpq_mpoly

from gspot_verified.paper.checks.entry import Builders, Entry, settled
from gspot_verified.paper.checks.identities import Algebra, Claim, Parts

ALGEBRA = Algebra("p b r v alpha1 alpha2 alpha3 LFp LGp LFb LGb LFy LGy LFv LGv")
PRINTED = {"p": "alpha1", "b": "alpha2 - alpha3*r", "y": "v", "v": "b + p*r"}
DEFINED = {"LFp": "alpha1", "LFb": "alpha2", "LGb": "-alpha3", "LFy": "v", "LFv": "b", "LGv": "p"}
"""What p, b, v and the α's of Sec. 2 are."""
LAGRANGIAN = {"LGp": "0*p", "LGy": "0*p"}
"""Eqs. lagrangian1 and lagrangian2: the force does not change y and p at once."""


def defined(text: str) -> fmpq_mpoly:
    """A formula in Lie derivatives, in the quantities of Sec. 2."""
    images = {name: ALGEBRA.read(value) for name, value in {**DEFINED, **LAGRANGIAN}.items()}
    return ALGEBRA.substitute(ALGEBRA.read(text), images)


def _slip_equations() -> Entry:
    this = Claim(ALGEBRA, PRINTED)

    def along_the_field(parts: Parts) -> list[fmpq_mpoly]:
        return [defined(f"LF{name} + r*LG{name}") - parts[name] for name in "pbyv"]

    def by_the_parts_of_the_force(parts: Parts) -> list[fmpq_mpoly]:
        free = {name: ALGEBRA.substitute(parts[name], {"r": ALGEBRA.constant(0)}) for name in "pbyv"}
        slopes = {name: parts[name].derivative("r") for name in "pbyv"}
        return [
            *(free[name] - defined(f"LF{name}") for name in "pbyv"),
            *(slopes[name] - defined(f"LG{name}") for name in "pbyv"),
            *(slope.derivative("r") for slope in slopes.values()),
        ]

    return settled(
        "Section 2",
        "2-slip-equations",
        "gensys2 to gensys5",
        r"\dot p=\alpha_1,\ \dot b=\alpha_2-\alpha_3\lambda_N,\ \dot y=v,\ \dot v=b+p\lambda_N",
        "In positive slip p, b, y, v satisfy the four equations, by the definitions of Sec. 2 and the two Lagrangian "
        "relations",
        this.check("the derivatives along F + λ_N G", along_the_field),
        this.check("the parts without λ_N and the factors of λ_N, one by one", by_the_parts_of_the_force),
    )


ENTRIES: Builders = {"2-slip-equations": _slip_equations}
"""The general system in positive slip."""
