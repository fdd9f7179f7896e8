"""Ledger of the equations of p, b, y, v in positive slip (Sec. 2).

r is λ_N; LFp, LGp, ... are Lie derivatives along F and G.
"""

from __future__ import annotations

from flint import fmpq_mpoly

from gspot_verified.paper.checks.entry import Builders, Check, Entry, Rung, settled
from gspot_verified.paper.checks.identities import Algebra, Claim, Parts

ALGEBRA = Algebra("p b r v alpha1 alpha2 alpha3 LFp LGp LFb LGb LFy LGy LFv LGv c s w g k mu W Y U X")
PRINTED = {"p": "alpha1", "b": "alpha2 - alpha3*r", "y": "v", "v": "b + p*r"}
DEFINED = {"LFp": "alpha1", "LFb": "alpha2", "LGb": "-alpha3", "LFy": "v", "LFv": "b", "LGv": "p"}
"""What p, b, v and the α's of Sec. 2 are."""
LAGRANGIAN = {"LGp": "0*p", "LGy": "0*p"}
"""Eqs. lagrangian1 and lagrangian2: the force does not change y and p at once."""

AT_ONCE = {"coordinates": "0*g", "slopes": "0*w"}
"""What a force changes of the coordinates q at once, and the slopes of x, y and p in the velocities (and in t)."""

NEWTON = {"c": "-s*w", "s": "c*w", "w": "-k*(c - mu*s)*r", "W": "-g + r", "Y": "W"}
"""The sliding rod of mass and half length 1: the rates of cos, sin and speed of its angle, and of its centre's speed W
and height Y. The contact is at (c, -s) from the centre, k is 1 over the moment of inertia.
"""
ROD = {
    "p": "1 + k*c*(c - mu*s)", "b": "s*w^2 - g", "y": "Y - s", "v": "W - c*w",
    "alpha1": "k*w*(mu*(s^2 - c^2) - 2*c*s)", "alpha2": "c*w^3", "alpha3": "2*k*s*w*(c - mu*s)",
}  # fmt: skip
"""p, b and the α's of the rod, by hand."""


FORCES = {"T": {"w": "-k*s", "U": "1+0*k"}, "N": {"w": "-k*c", "W": "1+0*k"}}
"""G_T and G_N of the rod: λ_T and λ_N turn it, and push its centre with the speeds U and W."""
PLACES = {"x": "X + c", "y": "Y - s"}
"""Its contact point, with the centre at X, Y."""


def defined(text: str) -> fmpq_mpoly:
    """A formula in Lie derivatives, in the quantities of Sec. 2."""
    images = {name: ALGEBRA.read(value) for name, value in {**DEFINED, **LAGRANGIAN}.items()}
    return ALGEBRA.substitute(ALGEBRA.read(text), images)


def along_a_force() -> bool | None:
    """Whether L_G f is 0: a sum over the coordinates and the velocities of a slope times a component of G.

    One coordinate with the slope k and one velocity with the component c stand for all.
    """
    component, slope = (ALGEBRA.read(AT_ONCE[name]) for name in ("coordinates", "slopes"))
    return (ALGEBRA.symbols["k"] * component + slope * ALGEBRA.symbols["c"]).is_zero()


def of_the_rod() -> bool | None:
    """Whether x, y and p of the rod are not changed at once by λ_T, λ_N, and p by the force of positive slip."""
    fields = {name: {key: ALGEBRA.read(text) for key, text in field.items()} for name, field in FORCES.items()}
    turning = fields["N"]["w"] - ALGEBRA.symbols["mu"] * fields["T"]["w"]
    as_in_slip = (turning - ALGEBRA.read(NEWTON["w"]).derivative("r")).is_zero()
    values = [ALGEBRA.read(text) for text in (*PLACES.values(), ROD["p"])]
    return as_in_slip and all(
        ALGEBRA.derivative(value, field).is_zero() for value in values for field in fields.values()
    )


def _at_once() -> Entry:
    return settled(
        "Section 2",
        "2-at-once",
        "eq:lagrangian1, eq:lagrangian2",
        r"\mathcal L_{G_T}x=\mathcal L_{G_N}x=\mathcal L_{G_T}y=\mathcal L_{G_N}y=0,\ \mathcal L_Gp=0",
        "Forces change accelerations alone, and x, y and p depend on the coordinates and t alone (for a μ that does): "
        "so L_{G_T} x = L_{G_N} x = L_{G_T} y = L_{G_N} y = 0 and L_G p = 0",
        Check(
            Rung.EXACT,
            "a Lie derivative along a force, as a sum over coordinates and velocities: each term has a factor 0",
            along_a_force(),
        ),
        Check(
            Rung.POINTS,
            "the rod that slides, with its tangential and its normal force: in every state of this mechanism",
            of_the_rod(),
        ),
        note="p = C - μB, where B and C are inner products of the gradients of x and y (1-mass-matrix).",
    )


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


ENTRIES: Builders = {"2-at-once": _at_once, "2-slip-equations": _slip_equations}
"""The general system in positive slip."""
