"""Ledger of Section 6: how long the contact of the simulations relaxes, and the units of the oscillator.

At fixed p and b the contact has the rates r/ε with r³ + 2r² + p r + p = 0 (3-oscillations): one real root x near
-2 + p/4, and a pair with the real part -(2 + x)/2.
"""

from __future__ import annotations

from typing import Any

from flint import arb, fmpq, fmpq_mpoly, fmpz_poly

from gspot_verified.numbers.balls import ball_text, hull, working_bits
from gspot_verified.numbers.verdict import Outcome
from gspot_verified.paper.checks.entry import Builders, Entry, Rung, Section, all_of
from gspot_verified.paper.section_6 import oscillator, section_6_runs
from gspot_verified.paper.section_6.oscillator import ALGEBRA

SECTION = Section("Section 6 and Appendix B")
FACTOR = 1000
"""The oscillation has relaxed when it is smaller by this factor."""
ABOUT = (fmpq(8, 10_000), fmpq(10, 10_000))
"""Where "about 10^-3" is read to lie."""
SLIP_TIME = (fmpq(1, 10), fmpq(3, 20))
"""Where the time of slip until the G-spot lies: line 2203 has O(10^-1)."""
PLACE = {"C": fmpq(3, 5), "S": fmpq(4, 5), "mu": fmpq(25, 12), "away": fmpq(1, 10)}
"""cos φ*, sin φ*, μ and φ - φ* of both starts."""
NEAR_P = fmpq(614, 10_000)
_UNITS = {"length": "l", "rate": "om", "mass": "m1"}
WEIGHTS = {
    "l": (1, 0, 0), "om": (0, 1, 0), "m1": (0, 0, 1), "g": (1, 2, 0), "psi": (1, 0, 0), "w": (0, 1, 0), "x": (1, 1, 0),
    "kphi": (2, 2, 1), "kpsi": (0, 2, 1), "cphi": (2, 1, 1), "cpsi": (0, 1, 1), "m2": (0, 0, 1), "J": (-1, 0, 0),
}  # fmt: skip
"""The powers of the units of length, rate and mass in each quantity; angles, μ, β and κ have none."""
FORCES = {
    "f1": (2, 2, 1), "f2": (1, 2, 1), "M11": (2, 0, 1), "M12": (1, 0, 1), "M21": (1, 0, 1), "M22": (0, 0, 1),
    "QT1": (1, 0, 0), "QT2": (0, 0, 0), "QN1": (1, 0, 0), "QN2": (0, 0, 0),
}  # fmt: skip
"""The same of M, f, Q_T and Q_N: in the two equations a torque and a force."""


def first_p() -> arb:
    """p of Appendix B at the two starts, m_1 = m_2 = 1."""
    with working_bits(96):
        turn = arb(PLACE["away"])
        c = arb(PLACE["C"]) * turn.cos() - arb(PLACE["S"]) * turn.sin()
        s = arb(PLACE["S"]) * turn.cos() + arb(PLACE["C"]) * turn.sin()
        return (c**2 + s * (s - arb(PLACE["mu"]) * c)) / (1 + c**2)


def real_part(p: arb) -> arb | None:
    """An enclosure of the pair's real part: the cubic changes its sign between the two ends for x."""
    with working_bits(96):
        ends = [-2 + p / 4 - p**3 / 128, -2 + p / 4]
        low, high = (r**3 + 2 * r**2 + p * r + p for r in ends)
        return -(2 + hull(ends)) / 2 if low < 0 and high > 0 else None


def relaxation(part: arb | None) -> arb | None:
    """The time after which e^(part t/ε) is below 1/FACTOR."""
    if part is None or not part < 0:
        return None
    with working_bits(96):
        return arb(section_6_runs.EPSILON) * arb(FACTOR).log() / -part


def lies_in(value: arb | None, ends: tuple[fmpq, fmpq]) -> bool | None:
    """Whether the value lies between the ends."""
    if value is None:
        return None
    if value > ends[0] and value < ends[1]:
        return True
    return False if value < ends[0] or value > ends[1] else None


def by_the_roots() -> bool | None:
    """The same at a rational p near the start's, by all roots."""
    numbers = [NEAR_P, NEAR_P, fmpq(2), fmpq(1)]
    roots: Any = fmpz_poly([int((value * int(NEAR_P.q)).p) for value in numbers]).complex_roots()
    pair = [root.real for root, _ in roots if not root.imag.contains(0)]
    return all_of(lies_in(relaxation(part), ABOUT) for part in pair)


def slips_for_a_tenth() -> bool | None:
    """Whether rigid slip from each of the two starts reaches the G-spot at a time within SLIP_TIME."""
    paths = [section_6_runs.slip(name) for name in section_6_runs.STARTS]
    return all_of(
        lies_in(path.time, SLIP_TIME) if path.verdict.outcome is Outcome.PROVED and path.end == "G-spot" else None
        for path in paths
    )


def _relaxation() -> Entry:
    time = relaxation(real_part(first_p()))
    return SECTION.settled(
        "6-relaxation",
        "lines 2202 to 2203",
        r"\text{relaxation of the }z\text{ dynamics takes about }10^{-3}",
        "ε = 10^-6, p and b fixed, p at its value at the two starts: the oscillation of the contact falls by the "
        "factor 1000 after 0.8 to 1.0 times 10^-3; rigid slip from the two starts, on a belt that is fast enough, "
        "takes 0.10 to 0.15 until the G-spot",
        Rung.BALLS.check(
            "an enclosure of the roots at the p of the starts",
            lies_in(time, ABOUT),
            "" if time is None else f"p = {ball_text(first_p(), 8)}, t = {ball_text(time, 6)}",
        ),
        Rung.BALLS.check("proofs/approach.md: the path in rigid slip and its time", slips_for_a_tenth()),
        Rung.POINTS.check(f"all roots at p = {NEAR_P}", by_the_roots()),
        note="z alone relaxes to y/2 at fixed y like e^(-2t/ε), within 10^-5 (2-relaxation): what takes 10^-3 is the "
        "oscillation of y, v and z about the slow manifold. The last clause has one check. That the other two roots "
        "are a pair is shown at p = 307/5000 alone.",
    )


def has_unit(value: fmpq_mpoly, unit: tuple[int, int, int]) -> bool:
    """Whether all terms of a polynomial have these powers of the units."""
    names = list(ALGEBRA.symbols)
    for exponents, _ in value.terms():
        powers = [[int(k) * part for part in WEIGHTS[n]] for n, k in zip(names, exponents, strict=True) if n in WEIGHTS]
        if tuple(map(sum, zip((0, 0, 0), *powers, strict=True))) != unit:
            return False
    return True


def motion_is_homogeneous() -> bool | None:
    """Whether each part of M, f, Q_T and Q_N has one unit, that of its place in the equation of motion."""
    parts = oscillator.parts_of_motion()
    return all(has_unit(parts[name], unit) for name, unit in FORCES.items())


def parameters_have_their_units() -> bool | None:
    """Whether the chosen parameters are numbers times the units that they should have, in m_1, l and the rate."""
    found = {name: ALGEBRA.read(text) for name, text in oscillator.PARAMETERS.items()}
    return all(has_unit(value, WEIGHTS.get(name, (0, 0, 0))) for name, value in found.items())


def scaled_motion_has_no_units() -> bool | None:
    """Whether M, f, Q_T and Q_N with the chosen parameters, the units as symbols, are their form at 1, scaled."""
    images = {name: ALGEBRA.read(text) for name, text in oscillator.PARAMETERS.items()} | {
        "psi": ALGEBRA.read("l*psi"),
        "w": ALGEBRA.read("om*w"),
        "x": ALGEBRA.read("l*om*x"),
    }
    one = {name: ALGEBRA.constant(1) for name in (*_UNITS.values(), "J", "g")}
    answers = []
    for name, (length, rate, mass) in FORCES.items():
        value = ALGEBRA.substitute(oscillator.parts_of_motion()[name], images)
        value = ALGEBRA.substitute(value, {"g": ALGEBRA.read("l*om^2")})
        whole = ALGEBRA.read(f"l^{length}*om^{rate}*m1^{mass}") * ALGEBRA.substitute(value, one)
        answers.append(oscillator.without_quotients(value - whole).is_zero())
    return all(answers)


def _units() -> Entry:
    return SECTION.settled(
        "6-units",
        "lines 2162 to 2163",
        r"m_1,\ g,\ l\ \text{determine a scale for mass, length, and time, with no other influence}",
        "The chosen parameters have their units with β and κ without dimension, and the equations of motion of the "
        "oscillator, written in the units m_1, l and sqrt(l/g), then have no m_1, l, g in them",
        Rung.EXACT.check(
            "M, f, Q_T, Q_N and the parameters: all terms have the same powers of length, time and mass",
            all_of([motion_is_homogeneous(), parameters_have_their_units()]),
        ),
        Rung.EXACT.check(
            "M, f, Q_T, Q_N with the parameters put in, ψ and the rates in units: powers of units times the form at 1",
            scaled_motion_has_no_units(),
        ),
    )


ENTRIES: Builders = {"6-units": _units, "6-relaxation": _relaxation}
"""Relaxation and units."""
