"""Ledger of Section 1: the α's can have any combination of signs, by eight G-spots of a rigid body.

The body has mass and moment of inertia 1; its contact point is (c, s) from its centre (X, Y), turned by the angle of
cosine C and sine S; a vertical force h + κ t acts at the centre. U, V, w are the velocities.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from itertools import product

from flint import fmpq, fmpq_mpoly

from gspot_verified.paper.checks.entry import Builders, Entry, Rung, Section, all_of
from gspot_verified.paper.checks.identities import Algebra
from gspot_verified.paper.section_2 import lagrangian

SECTION = Section("Section 1")
ALGEBRA = Algebra("X Y C S U V w t c s mu h kappa")
_SYMBOLS = ALGEBRA.symbols
CONTACT = {"x": "X + c*C - s*S", "y": "Y + c*S + s*C"}
"""The contact point."""
DRIFT = {"X": "U", "Y": "V", "C": "-S*w", "S": "C*w", "V": "h + kappa*t", "t": "1+0*t"}
"""F: free motion."""
ALPHAS = {"alpha_1": "w*(mu*(c^2 - s^2) - 2*c*s)", "alpha_2": "kappa - c*w^3", "alpha_3": "2*s*w*(c + mu*s)"}
"""The α's at C = 1, S = 0 and t = 0, by hand."""
SHAPES = ((fmpq(1), fmpq(-1), fmpq(2)), (fmpq(1, 2), fmpq(-1), fmpq(5, 2)))
"""c, s and μ: p = 1 + c (c + μ s) = 0."""
TURNS = (fmpq(1), fmpq(-1))
"""w."""
RATES = (fmpq(4), fmpq(-4))
"""κ."""
EXAMPLE_SPOT = {"x2": 1, "x3": 0, "x4": 0, "x5": 0, "x6": 0}
"""A G-spot of the extended example: u = 1, y = v = p = b = 0."""
EXAMPLE_VALUES = (1, -1)
"""Values of each of its α's."""
COMBINATIONS = frozenset(product((1, -1), repeat=3))
Signs = tuple[int, ...]


def lie(function: fmpq_mpoly, field: Mapping[str, fmpq_mpoly]) -> fmpq_mpoly:
    """The Lie derivative along a field."""
    return ALGEBRA.derivative(function, field)


def quantities() -> dict[str, fmpq_mpoly]:
    """u, v, b, p and the α's by the definitions of Sec. 2; the last three must vanish (lagrangian1, lagrangian2)."""
    drift = {name: ALGEBRA.read(text) for name, text in DRIFT.items()}
    x, y = (ALGEBRA.read(CONTACT[name]) for name in "xy")
    turn = {"C": -_SYMBOLS["S"], "S": _SYMBOLS["C"]}  # the derivative in the angle
    gradients = [{"U": q.derivative("X"), "V": q.derivative("Y"), "w": lie(q, turn)} for q in (x, y)]
    slip = {name: gradients[1][name] - _SYMBOLS["mu"] * gradients[0][name] for name in "UVw"}  # the mass matrix is 1
    u, v = lie(x, drift), lie(y, drift)
    b, p = lie(v, drift), lie(v, slip)
    found = {"u": u, "y": y, "v": v, "b": b, "p": p}
    found |= {"alpha_1": lie(p, drift), "alpha_2": lie(b, drift), "alpha_3": -lie(b, slip)}
    return found | {"L_G x": lie(x, slip), "L_G y": lie(y, slip), "L_G p": lie(p, slip)}


def upright(value: fmpq_mpoly) -> fmpq_mpoly:
    """The value at C = 1, S = 0, t = 0, U = 2, with Y, V and h such that y = v = b = 0."""
    s, w = _SYMBOLS["s"], _SYMBOLS["w"]
    images = {"Y": -s, "V": -_SYMBOLS["c"] * w, "h": s * w**2, "U": ALGEBRA.constant(2)}
    place = {"C": ALGEBRA.constant(1), "S": ALGEBRA.constant(0), "t": ALGEBRA.constant(0)}
    return ALGEBRA.substitute(value, images | place)


def by_hand() -> bool | None:
    """Whether the α's there are the formulas written by hand, y = v = b = 0 there, and the relations hold anywhere."""
    found = quantities()
    same = all((upright(found[name]) - ALGEBRA.read(text)).is_zero() for name, text in ALPHAS.items())
    at_the_spot = all(upright(found[name]).is_zero() for name in ("y", "v", "b"))
    return same and at_the_spot and all(found[name].is_zero() for name in ("L_G x", "L_G y", "L_G p"))


def number(value: fmpq_mpoly) -> fmpq:
    """A constant polynomial.

    :raises ValueError: a symbol occurs.
    """
    if not value.is_constant():
        raise ValueError(f"{value} is not a number")
    return fmpq(0) if value.is_zero() else value.leading_coefficient()


def bodies() -> Iterator[dict[str, fmpq]]:
    """u, p and the α's of each body."""
    found = {name: upright(value) for name, value in quantities().items()}
    for (c, s, mu), w, kappa in product(SHAPES, TURNS, RATES):
        values = {"c": c, "s": s, "mu": mu, "w": w, "kappa": kappa}
        images = {name: ALGEBRA.constant(value) for name, value in values.items()}
        numbers = {name: number(ALGEBRA.substitute(found[name], images)) for name in ("u", "p", *ALPHAS)}
        yield numbers | {"mu": mu}


def signs(values: Mapping[str, fmpq]) -> Signs:
    """The signs of the three α's."""
    return tuple((values[name] > 0) - (values[name] < 0) for name in ALPHAS)


def every_combination_by_bodies() -> bool | None:
    """Whether each body is at a G-spot in positive slip (p = 0, u > 0, μ > 0), and all eight combinations occur."""
    found = list(bodies())
    spots = all(values["p"] == 0 and values["u"] > 0 and values["mu"] > 0 for values in found)
    return spots and {signs(values) for values in found} == COMBINATIONS


def example(values: Mapping[str, int]) -> dict[str, fmpq]:
    """u, y, v, b, p and the α's of the extended example at its G-spot, by Lie derivatives; G is halved there."""
    algebra = lagrangian.ALGEBRA
    parts = {name: algebra.read(text) for name, text in lagrangian.PRINTED["2-lagrangian"].items()}
    state = [f"x{i}" for i in range(1, 7)]
    drift = {name: parts[f"F{name[1]}"] for name in state}
    clear = algebra.read("2*(1-x5)")
    slip = {name: clear * parts[f"N{name[1]}"] - parts["mu"] * parts[f"H{name[1]}"] for name in state}
    u, v = (algebra.derivative(parts[name], drift) for name in "xy")
    b = algebra.derivative(v, drift)
    p = algebra.read(lagrangian.PRINTED["2-quantities"]["p"])
    remainder = algebra.derivative(v, slip) - clear * p  # p = L_G v
    found = {"u": u, "y": parts["y"], "v": v, "b": b, "p": p, "remainder": remainder}
    found |= {"alpha_1": algebra.derivative(p, drift), "alpha_2": algebra.derivative(b, drift)}
    found["alpha_3"] = -algebra.derivative(b, slip) / 2
    images = {name: algebra.constant(value) for name, value in {**EXAMPLE_SPOT, **values}.items()}
    at_spot = {name: algebra.substitute(value, images) for name, value in found.items() if name != "remainder"}
    return {name: number(value) for name, value in (at_spot | {"remainder": remainder}).items()}


def every_combination_by_the_example() -> bool | None:
    """The same for the extended example."""
    cases = (dict(zip(("alpha1", "alpha2", "alpha3"), row, strict=True)) for row in product(EXAMPLE_VALUES, repeat=3))
    found = [example(values) for values in cases]
    spots = all(values["u"] > 0 and not any(values[name] for name in ("y", "v", "b", "p")) for values in found)
    defined = all(values["remainder"] == 0 for values in found)
    return spots and defined and {signs(values) for values in found} == COMBINATIONS


def _alpha_signs() -> Entry:
    values = "; ".join(", ".join(str(row[name]) for name in ALPHAS) for row in bodies())
    return SECTION.settled(
        "1-alpha-signs",
        "lines 257 to 258",
        r"(\operatorname{sgn}\alpha_1,\operatorname{sgn}\alpha_2,\operatorname{sgn}\alpha_3)\in\{-1,1\}^3",
        "Each of the eight combinations of signs of α_1, α_2, α_3 occurs at a G-spot in positive slip",
        Rung.EXACT.check(
            "Lie derivatives of a rigid body with one contact point and a vertical force h + κ t: eight G-spots, "
            "for two shapes with their μ, two turning velocities and two κ; the same α's by hand",
            all_of([by_hand(), every_combination_by_bodies()]) or None,  # other bodies may show what these do not
            f"α_1, α_2, α_3: {values}",
        ),
        Rung.EXACT.check(
            "Lie derivatives of the extended example (Sec. 2) at its G-spot, with 1 and -1 for each of its constants",
            every_combination_by_the_example() or None,
        ),
    )


ENTRIES: Builders = {"1-alpha-signs": _alpha_signs}
"""The signs of the α's."""
