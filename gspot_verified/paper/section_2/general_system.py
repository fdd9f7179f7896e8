"""Ledger of the equations of p, b, y, v in positive slip (Sec. 2).

r is λ_N; LFp, LGp, ... are Lie derivatives along F and G.
"""

from __future__ import annotations

from flint import fmpq_mpoly

from gspot_verified.paper.checks.entry import Builders, Entry, Rung, settled
from gspot_verified.paper.checks.identities import Algebra, Claim, Parts

ALGEBRA = Algebra("p b r v alpha1 alpha2 alpha3 LFp LGp LFb LGb LFy LGy LFv LGv c s w g k mu W Y")
PRINTED = {"p": "alpha1", "b": "alpha2 - alpha3*r", "y": "v", "v": "b + p*r"}
DEFINED = {"LFp": "alpha1", "LFb": "alpha2", "LGb": "-alpha3", "LFy": "v", "LFv": "b", "LGv": "p"}
"""What p, b, v and the α's of Sec. 2 are."""
LAGRANGIAN = {"LGp": "0*p", "LGy": "0*p"}
"""Eqs. lagrangian1 and lagrangian2: the force does not change y and p at once."""

NEWTON = {"c": "-s*w", "s": "c*w", "w": "-k*(c - mu*s)*r", "W": "-g + r", "Y": "W"}
"""The sliding rod of mass and half length 1: the rates of cos, sin and speed of its angle, and of its centre's speed W
and height Y. The contact is at (c, -s) from the centre, k is 1 over the moment of inertia.
"""
ROD = {
    "p": "1 + k*c*(c - mu*s)", "b": "s*w^2 - g", "y": "Y - s", "v": "W - c*w",
    "alpha1": "k*w*(mu*(s^2 - c^2) - 2*c*s)", "alpha2": "c*w^3", "alpha3": "2*k*s*w*(c - mu*s)",
}  # fmt: skip
"""p, b and the α's of the rod, by hand."""


def defined(text: str) -> fmpq_mpoly:
    """A formula in Lie derivatives, in the quantities of Sec. 2."""
    images = {name: ALGEBRA.read(value) for name, value in {**DEFINED, **LAGRANGIAN}.items()}
    return ALGEBRA.substitute(ALGEBRA.read(text), images)


def _slip_equations() -> Entry:
    this = Claim(ALGEBRA, PRINTED)

    def along_the_field(parts: Parts) -> list[fmpq_mpoly]:
        return [defined(f"LF{name} + r*LG{name}") - parts[name] for name in "pbyv"]

    def sliding_rod(parts: Parts) -> list[fmpq_mpoly]:
        rates = {name: ALGEBRA.read(text) for name, text in NEWTON.items()}
        images = {name: ALGEBRA.read(text) for name, text in ROD.items()}
        return [ALGEBRA.derivative(images[name], rates) - ALGEBRA.substitute(parts[name], images) for name in "pbyv"]

    return settled(
        "Section 2",
        "2-slip-equations",
        "gensys2 to gensys5",
        r"\dot p=\alpha_1,\ \dot b=\alpha_2-\alpha_3\lambda_N,\ \dot y=v,\ \dot v=b+p\lambda_N",
        "In positive slip p, b, y, v satisfy the four equations, by the definitions of Sec. 2 and the two Lagrangian "
        "relations",
        this.check("the derivatives along F + λ_N G", along_the_field),
        this.check("the rod that slides, by Newton's law: in every state of this mechanism", sliding_rod, Rung.POINTS),
    )


ENTRIES: Builders = {"2-slip-equations": _slip_equations}
"""The general system in positive slip."""
