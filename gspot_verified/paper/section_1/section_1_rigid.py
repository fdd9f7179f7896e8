"""Ledger of Section 1: the contact force of rigid slip, and its equations in the rescaled time."""

from __future__ import annotations

from flint import fmpq_mpoly

from gspot_verified.paper.checks.entry import Builders, Entry, Section
from gspot_verified.paper.checks.identities import Algebra, Claim, Parts

SECTION = Section("Section 1")
ALGEBRA = Algebra("b p q lam lamT mu A B C alpha1 alpha2 alpha3")
_SYMBOLS = ALGEBRA.symbols
PRINTED: dict[str, dict[str, str]] = {
    "1-force": {"p times the force": "-b", "p": "C - mu*B"},
    "1-rescaled": {"p": "alpha1*p", "b": "alpha2*p + alpha3*b"},
}
NORMAL = "b + B*lamT + C*lam"
"""dv/dt of vdynamics."""
TANGENTIAL = "-mu*lam"
"""λ_T by Coulomb's law in positive slip."""
RATES = {"p": "alpha1", "b": "alpha2 - alpha3*lam"}
"""gensys2 and gensys3."""


def acceleration_in_slip() -> fmpq_mpoly:
    """dv/dt in positive slip."""
    return ALGEBRA.substitute(ALGEBRA.read(NORMAL), {"lamT": ALGEBRA.read(TANGENTIAL)})


def _force() -> Entry:
    this = Claim(ALGEBRA, PRINTED["1-force"])

    def vanishes(parts: Parts) -> list[fmpq_mpoly]:
        # p dv/dt at p λ_N as printed: dv/dt is linear in λ_N.
        slip = acceleration_in_slip()
        at_zero = ALGEBRA.substitute(slip, {"lam": ALGEBRA.constant(0)})
        return [parts["p"] * at_zero + slip.derivative("lam") * parts["p times the force"]]

    def by_newton(parts: Parts) -> list[fmpq_mpoly]:
        # Newton's law, (C X - B V, A V - B X) = D (λ_T, λ_N), D = A C - B², for X = du/dt - a and V = dv/dt - b.
        a, b, c = (_SYMBOLS[name] for name in "ABC")
        determinant = a * c - b**2
        friction = ALGEBRA.read(TANGENTIAL).derivative("lam")
        # B times the first line and C times the second: X drops out.
        inertia, push = c * a - b * b, determinant * (b * friction + c)
        return [inertia * parts["p"] - push, parts["p times the force"] + _SYMBOLS["b"]]

    return SECTION.settled(
        "1-force",
        "lines 168 to 170",
        r"\lambda_N=-b/p,\quad p=C-\mu B",
        "Contact with positive slip is sustained (dv/dt = 0) for λ_N = -b/p, p = C - μ B not 0, where this is positive",
        this.check("the normal acceleration with λ_T = -μ λ_N vanishes at this force", vanishes),
        this.check(
            "Newton's law with the mass matrix: the tangential acceleration drops out, and V = p λ_N", by_newton
        ),
        note="So for p < 0 the force is positive exactly for b > 0 (the sentence after it).",
    )


def _rescaled() -> Entry:
    this = Claim(ALGEBRA, PRINTED["1-rescaled"])

    def chain_rule(parts: Parts) -> list[fmpq_mpoly]:
        # d/ds = p d/dt, and p λ_N = -b in rigid slip; the rates are linear in λ_N.
        found = []
        for name in ("p", "b"):
            rate = ALGEBRA.read(RATES[name])
            at_zero = ALGEBRA.substitute(rate, {"lam": ALGEBRA.constant(0)})
            found.append(_SYMBOLS["p"] * at_zero - rate.derivative("lam") * _SYMBOLS["b"] - parts[name])
        return found

    def quotient(parts: Parts) -> list[fmpq_mpoly]:
        # db/dp is the same in both times: b' (dp/dt) = p' (db/dt) with λ_N = q, b = -p q; and p' is p dp/dt.
        rates = {name: ALGEBRA.substitute(ALGEBRA.read(RATES[name]), {"lam": _SYMBOLS["q"]}) for name in ("p", "b")}
        images = {"b": -_SYMBOLS["p"] * _SYMBOLS["q"]}
        slopes = {name: ALGEBRA.substitute(parts[name], images) for name in ("p", "b")}
        return [slopes["b"] * rates["p"] - slopes["p"] * rates["b"], slopes["p"] - _SYMBOLS["p"] * rates["p"]]

    return SECTION.settled(
        "1-rescaled",
        "eqs. Gspot1 and Gspot2",
        r"\frac{dp}{d\hat s}=\alpha_1p,\quad\frac{db}{d\hat s}=\alpha_2p+\alpha_3b",
        "In rigid slip with p not 0, in the time s with dt = p ds, p and b satisfy dp/ds = α_1 p and db/ds = α_2 p + "
        "α_3 b, for the α's of Sec. 2",
        this.check("p times gensys2 and gensys3 with p λ_N = -b", chain_rule),
        this.check("db/dp by gensys2 and gensys3 with λ_N as a symbol, b = -p λ_N", quotient),
    )


ENTRIES: Builders = {"1-force": _force, "1-rescaled": _rescaled}
"""The force, and the equations near the G-spot."""
