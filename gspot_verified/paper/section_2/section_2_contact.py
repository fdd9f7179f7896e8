"""Ledger of Section 2: how the deformation z of the surface relaxes at a fixed position y, and under a given force."""

from __future__ import annotations

from flint import fmpq_mpoly

from gspot_verified.paper.checks.entry import Builders, Entry, Rung, Section, all_of
from gspot_verified.paper.checks.identities import Algebra, Claim, Parts, rising_signs

ALGEBRA = Algebra("z y zd epsilon k1 k2 c d x lam")
_SYMBOLS = ALGEBRA.symbols
RATE = {"contact": "-z - (z - y)", "flight": "-z"}
"""ε z' of compl1 with ε² λ_N = z - y, or λ_N = 0."""
REST = {"contact": "1/2*y", "flight": "0*y"}
"""Where z relaxes to."""
DECAY = {"contact": 2, "flight": 1}
"""z minus its rest falls like e^(-decay t/ε)."""
UNDER_FORCE = "-z - epsilon^2*lam"
"""ε z' of compl1."""
COMPLIANT = {"z": "-z - epsilon^2*lam", "force": "z - y"}
"""ε z' of compl1, and ε² λ_N of compl2 for y < z."""
GIVEN = {"z": "-epsilon^2*lam", "y": "-2*epsilon^2*lam"}
"""z and y at rest under a given force λ_N."""
BALANCE = {"z": "-k1*z - lam", "y": "k2*(z - y) - lam"}
"""c z' of compliant1, and the difference of the two sides of compliant2."""
CONSTANTS = {"k1": -2, "k2": -2, "c": -1}
"""The powers of ε in k_1, k_2 and c (compliant3)."""
SPRINGS = {"contact": "-k1*z - k2*(z - y)", "flight": "-k1*z"}
"""c z' of compliant1 and compliant2."""


def relaxes(phase: str) -> bool | None:
    """Whether the deviation d = z - rest obeys ε d' = -decay d, and the rest lies on the right side of z = y.

    y = -x in contact (z = y/2 > y), y = x in flight (z = 0 < y), for every x > 0.
    """
    rest = ALGEBRA.read(REST[phase])
    rate = ALGEBRA.substitute(ALGEBRA.read(RATE[phase]), {"z": rest + _SYMBOLS["d"]})
    place = -_SYMBOLS["x"] if phase == "contact" else _SYMBOLS["x"]
    gap = ALGEBRA.substitute(rest - _SYMBOLS["y"], {"y": place})
    apart = gap if phase == "contact" else -gap
    return (rate + DECAY[phase] * _SYMBOLS["d"]).is_zero() and rising_signs(apart)


def leaves_the_other_phase(phase: str) -> bool | None:
    """Whether z, from a place d > 0 beyond y where the other phase rules, goes to y at a rate that stays above x/ε.

    With y as above: z = -x - d in flight rises, z = x + d in contact falls; the rate times ε is at least x.
    """
    other = "flight" if phase == "contact" else "contact"
    side, y = (1, -_SYMBOLS["x"]) if phase == "contact" else (-1, _SYMBOLS["x"])
    place = {"y": y, "z": y - side * _SYMBOLS["d"]}
    return rising_signs(side * ALGEBRA.substitute(ALGEBRA.read(RATE[other]), place) - _SYMBOLS["x"])


def of_the_springs(phase: str) -> bool | None:
    """The same from springs and damper: k_1 = k_2 = 1/ε², c = 1/ε, so c z' times ε² is ε z'."""
    force = ALGEBRA.substitute(
        ALGEBRA.read(SPRINGS[phase]), {"k1": ALGEBRA.constant(1), "k2": ALGEBRA.constant(1)}
    )  # times ε²
    at_rest = ALGEBRA.substitute(force, {"z": ALGEBRA.read(REST[phase])})
    return at_rest.is_zero() and (force.derivative("z") + DECAY[phase]).is_zero()


def _relaxation() -> Entry:
    return Section("Section 2").settled(
        "2-relaxation",
        "lines 555 to 557",
        r"z\to y/2\ (y<0),\qquad z\to0\ (y>0)",
        "At a fixed y < 0 the deformation z of the surface relaxes to y/2, in contact like e^(-2t/ε), and at a fixed "
        "y > 0 to 0, in flight like e^(-t/ε), from every start",
        Rung.EXACT.check(
            "eqs. compl1 and compl2: the deviation of z decays at these rates, for every y; from the other phase, "
            "z < y < 0 or z > y > 0, z comes to y at a rate of at least |y|/ε",
            all_of([*(relaxes(phase) for phase in RATE), *(leaves_the_other_phase(phase) for phase in RATE)]),
        ),
        Rung.EXACT.check(
            "eqs. compliant1 to compliant3: the springs balance there, and the slope of the force over c is the rate",
            all_of(of_the_springs(phase) for phase in SPRINGS),
        ),
        note="A start with z < y < 0 is in flight first: z rises to y, and from there to y/2 in contact. A start with "
        "z > y > 0 is in contact first: z falls to y, and from there to 0 in flight.",
    )


def settles_under_force() -> bool | None:
    """Whether the deviation d = z - rest obeys ε d' = -d under a constant force."""
    rest = ALGEBRA.read(GIVEN["z"])
    rate = ALGEBRA.substitute(ALGEBRA.read(UNDER_FORCE), {"z": rest + _SYMBOLS["d"]})
    return (rate + _SYMBOLS["d"]).is_zero()


def vanish_with_epsilon() -> bool | None:
    """Whether z and y at rest have a factor ε, and else λ_N alone: they tend to 0 for every λ_N."""
    found = [ALGEBRA.read(text) for text in GIVEN.values()]
    free = {"epsilon", "lam"}
    at_zero = (ALGEBRA.substitute(value, {"epsilon": ALGEBRA.constant(0)}) for value in found)
    others = (value.derivative(name) for value in found for name in _SYMBOLS if name not in free)
    return all(value.is_zero() for value in (*at_zero, *others)) and not any(value.is_zero() for value in found)


def balanced_by_the_springs() -> bool | None:
    """Whether z = -λ_N/k_1 and z - y = λ_N/k_2 are the same z and y, with k_1 and k_2 powers of ε.

    k_i = ε^(-m): the value of the balance times ε^m is 0 where k_i is read as 1 there and λ_N as ε^m λ_N.
    """
    rest = {name: ALGEBRA.read(text) for name, text in GIVEN.items()}
    answers = []
    for name, spring in (("z", "k1"), ("y", "k2")):
        power = -CONSTANTS[spring]
        images = {spring: ALGEBRA.constant(1), "lam": _SYMBOLS["epsilon"] ** power * _SYMBOLS["lam"]}
        scaled = ALGEBRA.substitute(ALGEBRA.read(BALANCE[name]), images)
        answers.append(ALGEBRA.substitute(scaled, rest).is_zero())
    return all(answers)


def relaxes_by_the_damper() -> bool | None:
    """Whether k_1/c = 1/ε, and the slope of c z' is -k_1: the rest is approached like e^(-t/ε)."""
    slope = ALGEBRA.read(BALANCE["z"]).derivative("z")
    return CONSTANTS["k1"] - CONSTANTS["c"] == -1 and (slope + _SYMBOLS["k1"]).is_zero()


def _deformation() -> Entry:
    return Section("Section 2").settled(
        "2-deformation",
        "lines 557 to 558",
        r"z=-\epsilon^2\lambda_N\to0",
        "Under a given constant force λ_N the deformation of the surface settles at z = -ε² λ_N like e^(-t/ε), and the "
        "contact point at y = -2ε² λ_N: both tend to 0 as ε → 0, for every λ_N > 0",
        Rung.EXACT.check(
            "eq. compl1: the deviation of z from -ε² λ_N decays, and what is left has a factor ε",
            all_of([settles_under_force(), vanish_with_epsilon()]),
        ),
        Rung.EXACT.check(
            "eqs. compliant1 to compliant3: the springs k_1 and k_2 carry the force at these z and y, at rest",
            all_of([balanced_by_the_springs(), relaxes_by_the_damper(), vanish_with_epsilon()]),
        ),
        note="For a force that depends on ε this holds as long as ε² λ_N → 0.",
    )


def _compliant() -> Entry:
    this = Claim(ALGEBRA, COMPLIANT)
    epsilon, zd, lam = (_SYMBOLS[name] for name in ("epsilon", "zd", "lam"))

    def put_in(parts: Parts) -> list[fmpq_mpoly]:
        # c z' = -k1 z - λ and λ = k2 (z - y), times ε²: a constant with the power m of ε becomes ε^(2 + m).
        images = {name: epsilon ** (2 + power) for name, power in CONSTANTS.items()}
        images["lam"] = epsilon**2 * lam
        whole = {name: ALGEBRA.substitute(ALGEBRA.read(text), images) for name, text in BALANCE.items()}
        damper = ALGEBRA.substitute(_SYMBOLS["c"], images) * zd - whole["z"]
        return [damper - (epsilon * zd - parts["z"]), whole["y"] - (parts["force"] - epsilon**2 * lam)]

    def by_rest_and_rate(parts: Parts) -> list[fmpq_mpoly]:
        # An affine equation has one rest, -λ/k1, and one rate, k1/c = ε^-1; the force is 0 at y = z, with the slope k2.
        rest = {"z": -(epsilon ** -CONSTANTS["k1"]) * lam}
        rate = ALGEBRA.constant(CONSTANTS["k1"] - CONSTANTS["c"] + 1)
        stiffness = ALGEBRA.constant(CONSTANTS["k2"] + 2)
        at_surface = ALGEBRA.substitute(parts["force"], {"y": _SYMBOLS["z"]})
        return [
            ALGEBRA.substitute(parts["z"], rest),
            parts["z"].derivative("z") + 1,
            rate,
            at_surface,
            parts["force"].derivative("y") + 1,
            stiffness,
        ]

    return Section("Section 2").settled(
        "2-compliant",
        "eqs. compliant1 to compliant3, compl1, compl2, lines 572 to 583",
        r"\epsilon\dot z=-z-\epsilon^2\lambda_N,\quad\lambda_N=\epsilon^{-2}(z-y)",
        "With k_1 = k_2 = 1/ε² and c = 1/ε eq. compliant1 is eq. compl1 for every λ_N, and eq. compliant2 is eq. "
        "compl2 where y < z, for every ε > 0; elsewhere both are printed as 0",
        this.check("the constants put in, times ε²", put_in),
        this.check("the rest and the rate of z under a force; where the force is 0, and its slope", by_rest_and_rate),
    )


ENTRIES: Builders = {"2-compliant": _compliant, "2-relaxation": _relaxation, "2-deformation": _deformation}
"""The relaxation and the deformation of the surface."""
