"""Ledger of Section 3: sentences on the simulations that the exact solution settles.

Oscillations of the contact, the separatrix, Case II, and the end of a flight.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import chain
from typing import Any

from flint import fmpq, fmpq_mpoly, fmpz_poly

from gspot_verified.compliant.model.normal_form import CompliantModel, CompliantState, compliant_model, deviation
from gspot_verified.compliant.motion.first_zero import first_zero
from gspot_verified.compliant.motion.run import events
from gspot_verified.compliant.motion.touch_down import NEVER
from gspot_verified.compliant.side.side_rule import side_rule
from gspot_verified.numbers.balls import sign_of
from gspot_verified.numbers.short_text import decimal_text
from gspot_verified.numbers.verdict import Outcome
from gspot_verified.paper.checks.entry import Builders, Check, Entry, Rung, Section, all_of
from gspot_verified.paper.checks.identities import Algebra, rising_signs
from gspot_verified.paper.numerics.paper_runs import least_share
from gspot_verified.paper.numerics.paper_state import paper_state
from gspot_verified.paper.section_3 import varsim1
from gspot_verified.scenes.certified_run import INTEGRATOR, certified_run
from gspot_verified.scenes.scene.file import load_scene
from gspot_verified.scenes.scene.run import IMPACT

SECTION = Section("Section 3")
ALGEBRA = Algebra("r p Y V Z x y b u alpha2 v z e d")
_SYMBOLS = ALGEBRA.symbols
CONTACT = {"Y": "V", "V": "p*(Z - Y)", "Z": "-Z - (Z - Y)"}
"""modelsys3 to modelsys5 in T = t/ε at fixed p and b, y = ε² Y, v = ε V, z = ε² Z less their values at rest."""
CUBIC = "r^3 + 2*r^2 + p*r + p"
"""Its roots r are the rates of the contact: motions e^(r t/ε)."""
DISCRIMINANT = "-p*(4*p^2 - 13*p + 32)"
AT = (fmpq(1, 100), fmpq(1, 2), fmpq(2))
SEPARATED = (fmpq(3, 2), fmpq(5, 2))
"""The β of panels (b) and (c)."""
SIDES = ((fmpq(1, 4), fmpq(1, 2)), (fmpq(2), fmpq(4)))
"""The ν on each of the two sides of the trivial solution ν = 1."""
CASE_II_SIGNS = {"alpha_1": "-u - x", "alpha_2": "y", "alpha_3": "-x"}
"""Case II by positive symbols."""
TRIVIAL = {"b": "-r*p", "v": "0*p", "y": "-2*e^2*r", "z": "-e^2*r"}
"""The trivial solution with the force r, p = α_1 t, e for ε."""
CASE_II = {"beta": fmpq(1, 2), "alpha_2": fmpq(1)}
REACHES = varsim1.EPSILON_0[CASE_II["beta"]]
ATTRACTED, OTHERS = (fmpq(2), fmpq(4)), (fmpq(1, 4), fmpq(1, 2))
"""ν above and below 1: p, b with α_2 p < (α_1 - α_3) b, and not."""
NEAR = fmpq(99, 100)
"""A ν so close to 1 that contact lasts until after p = 0 and is lost then."""
EPSILONS = (fmpq(1, 1000), fmpq(1, 2000))
FLIGHT = {"b": "b + alpha2*u", "v": "v + b*u + alpha2*u^2/2", "y": "y + v*u + b*u^2/2 + alpha2*u^3/6"}
"""Free motion a time u after lift-off from b, v, y; z falls like e^(-u/ε)."""


def rates_of_the_contact() -> bool | None:
    """Whether the cubic is the characteristic polynomial of the contact at fixed p."""
    rows = []
    for name in CONTACT:
        rate = ALGEBRA.read(CONTACT[name])
        rows.append([rate.derivative(other) - (_SYMBOLS["r"] if other == name else 0) for other in CONTACT])
    return bool((ALGEBRA.determinant(rows) + ALGEBRA.read(CUBIC)).is_zero())


def one_real_root_below_minus_one() -> bool | None:
    """For every p > 0: a negative discriminant, and a real root in (-2, -1); so the pair has -1/2 < Re r < 0."""
    cubic = ALGEBRA.read(CUBIC)
    a, b, c, d = (ALGEBRA.coefficient_of(cubic, "r", power) for power in (3, 2, 1, 0))
    found = 18 * a * b * c * d - 4 * b**3 * d + b**2 * c**2 - 4 * a * c**3 - 27 * a**2 * d**2
    at = {place: ALGEBRA.substitute(cubic, {"r": ALGEBRA.constant(place)}) for place in (-2, -1)}
    negative = found == ALGEBRA.read(DISCRIMINANT) and negative_for_positive_p(found)
    sum_of_roots = b == 2 * a
    return negative and sum_of_roots and _opposite(at[-2], at[-1])


def negative_for_positive_p(value: fmpq_mpoly) -> bool:
    """Whether the value is -p (a p² + b p + c) with a > 0 and b² < 4 a c, so that the square never vanishes."""
    a, b, c = (ALGEBRA.coefficient_of(-value, "p", power) for power in (3, 2, 1))
    p = _SYMBOLS["p"]
    whole = (value + p * (a * p**2 + b * p + c)).is_zero()
    return whole and rising_signs(a) and rising_signs(4 * a * c - b**2)


def _opposite(first: fmpq_mpoly, second: fmpq_mpoly) -> bool:
    return rising_signs(-first) and rising_signs(second)


def damped_and_oscillating(p: fmpq) -> bool | None:
    """The same at one p, from the roots: one real, and a pair with -1/2 < Re r < 0 and Im r not 0."""
    cubic = ALGEBRA.substitute(ALGEBRA.read(CUBIC), {"p": ALGEBRA.constant(p)})
    numbers = [ALGEBRA.coefficient_of(cubic, "r", k) * int(p.q) for k in range(4)]
    roots: Any = fmpz_poly([0 if n.is_zero() else int(n.leading_coefficient().p) for n in numbers]).complex_roots()
    pair = [root for root, _ in roots if not root.imag.contains(0)]
    inside = all(-fmpq(1, 2) < root.real and root.real < 0 for root in pair)
    return len(roots) == 3 and len(pair) == 2 and inside


def _oscillations() -> Entry:
    return SECTION.settled(
        "3-oscillations",
        "lines 742 to 746",
        r"\text{damped oscillations, their frequency diverges to }\infty\text{ as }\epsilon\to0",
        "At every fixed p > 0 and b < 0, as long as contact lasts, the contact of the model system has motions e^(r "
        "t/ε) about its rest with a pair r of complex rates, -1/2 < Re r < 0, that do not depend on ε: damped "
        "oscillations with frequency |Im r|/ε",
        Rung.EXACT.check(
            "the characteristic polynomial r³ + 2r² + p r + p: its discriminant is negative for every p > 0, its real "
            "root lies in (-2, -1), the sum of the roots is -2",
            all_of([rates_of_the_contact(), one_real_root_below_minus_one()]),
        ),
        Rung.POINTS.check(
            "the roots at p = 1/100, 1/2, 2", all_of([rates_of_the_contact(), *(damped_and_oscillating(p) for p in AT)])
        ),
        note="At p = 0 the rates are 0, 0 and -2: as p → 0 the frequency tends to 0 (Sec. 4, inner scale).",
    )


def parted(beta: fmpq) -> bool | None:
    """Whether for every ε up to the stated one all runs of one side lift off and all of the other take an impact."""
    return _one_each(
        [[varsim1.proved_fate(beta, nu) for nu in side] for side in SIDES], {varsim1.IMPACT, varsim1.LIFT_OFF}
    )


def sides_differ(beta: fmpq) -> bool | None:
    """Whether at each of three ε K has one sign on one side and the opposite one on the other."""
    found = [
        [[sign_of(side_rule(*varsim1.initial_state(beta, nu, e)).side) for nu in side] for side in SIDES]
        for e in varsim1.POINTS
    ]
    return all_of([_one_each(signs, {1, -1}) for signs in found])


def _one_each(found: Sequence[Sequence[object]], expected: set[Any]) -> bool | None:
    """Whether all of each side agree, and the sides have the two that are expected."""
    if any(None in side for side in found):
        return None
    agreed = [set(side) for side in found]
    return all(len(side) == 1 for side in agreed) and set().union(*agreed) == expected


def _separatrix() -> Entry:
    ranges = ", ".join(f"β = {beta} (every ε <= {varsim1.EPSILON_0[beta]})" for beta in SEPARATED)
    return SECTION.settled(
        "3-separatrix",
        "lines 780 to 781",
        r"\text{the trivial solution appears to form a separatrix}",
        f"{ranges}: of the runs ν = 1/4, 1/2 and ν = 2, 4 of fig. varsim1 on the two sides of the trivial solution "
        "ν = 1, those of one side lift off and those of the other take an impact",
        Rung.BALLS.check("proofs/paper_runs.md, Theorem A'", all_of(parted(beta) for beta in SEPARATED)),
        Rung.POINTS.check(
            "K has one sign on one side and the opposite one on the other at ε = 10^-3, 10^-6, 10^-12",
            all_of(sides_differ(beta) for beta in SEPARATED),
        ),
        note="Off the slow manifold the sign of K decides as long as contact lasts: for K < 0 it is lost, for K > 0 "
        "λ_N → +∞; K = 0 holds other states too than the trivial solution (proofs/first_integrals.md).",
    )


def case_ii(nu: fmpq, epsilon: fmpq, times: int = 1) -> tuple[CompliantModel, CompliantState]:
    """The initial values of fig. varsim1 with α_2 = 1, or times it: the trivial solution has λ_N > 0 and is ν = 1."""
    model = compliant_model(CASE_II["beta"], epsilon, alpha_2=CASE_II["alpha_2"] * times)
    return model, paper_state(model, nu)


def attracted_takes_an_impact(nu: fmpq, epsilon: fmpq) -> bool | None:
    """Whether λ_N > 0 from the start on, and grows from some time on: the certified run ends in an invariant region."""
    scene = load_scene("fig-varsim1", beta=CASE_II["beta"], nu=nu, epsilon=epsilon, alpha_2=CASE_II["alpha_2"])
    run = certified_run(scene, 6, INTEGRATOR)
    return run.fate == IMPACT if run.verdict.outcome is Outcome.PROVED else None


def other_lifts_off_before(nu: fmpq, epsilon: fmpq) -> bool | None:
    """Whether contact is lost at a time before p = 0."""
    found = first_zero(*case_ii(nu, epsilon), digits=6)
    return None if found.upper is None else found.upper < 0


def side_is(nu: fmpq, epsilon: fmpq, sign: int) -> bool | None:
    """Whether K has this sign."""
    found = sign_of(side_rule(*case_ii(nu, epsilon)).side)
    return None if found is None else found == sign


def trivial_keeps_contact() -> bool | None:
    """Whether in Case II the trivial solution solves modelsys2 to modelsys5 with the force r = α_2/(α_3 - α_1) > 0."""
    first, second, third = (ALGEBRA.read(CASE_II_SIGNS[f"alpha_{n}"]) for n in (1, 2, 3))
    b, v, y, z = (ALGEBRA.read(TRIVIAL[name]) for name in "bvyz")
    force, p, small = (_SYMBOLS[name] for name in "rpe")
    rates = [value.derivative("p") * first for value in (b, v, y, z)]
    left = [
        rates[0] - (force * (third - first) - third * force),
        rates[1] - (b + p * force),
        rates[2] - v,
        small * rates[3] + z + small**2 * force,
        z - y - small**2 * force,
    ]
    positive = [rising_signs(value) for value in (second, third - first, -first, -third)]
    return True if all(value.is_zero() for value in left) and all(positive) else None


def lost_after(nu: fmpq, epsilon: fmpq) -> bool | None:
    """Whether contact lasts until after p = 0 and is lost then."""
    found = first_zero(*case_ii(nu, epsilon), digits=6)
    return None if found.lower is None else found.lower > 0


def flies_for_ever(nu: fmpq, epsilon: fmpq) -> bool | None:
    """Whether contact is lost once, and the flight never ends."""
    run = events(*case_ii(nu, epsilon), digits=6)
    return True if run.verdict.outcome is Outcome.PROVED and run.verdict.statement == NEVER else None


def _passes_and_lifts_off(epsilon: fmpq) -> Check:
    found = first_zero(*case_ii(NEAR, epsilon), digits=6)
    return Rung.BALLS.check(
        "proofs/force_range.md: the first zero of λ_N; proofs/flight.md, Theorem F1 (b): the flight; for β = "
        f"{CASE_II['beta']}, α_1 = -1, α_2 = {CASE_II['alpha_2']}, ν = {NEAR}, ε = {epsilon}",
        False if all_of([lost_after(NEAR, epsilon), flies_for_ever(NEAR, epsilon)]) else None,
        ""
        if found.lower is None or found.upper is None
        else f"contact lasts until a t in {decimal_text(found.lower, found.upper)} after p = 0, and is lost for "
        "ever: no impact follows",
    )


def _case_ii() -> Entry:
    return SECTION.settled(
        "3-case-II",
        "lines 768 to 770",
        r"\text{Case II: all initial conditions that pass the G-spot take an impact}",
        "In Case II of the model system every start from which contact lasts until p = 0 takes an impact",
        Rung.EXACT.check(
            "the trivial solution, for all α's of Case II and every ε > 0",
            False if trivial_keeps_contact() else None,
            "λ_N = α_2/(α_3 - α_1) > 0 for ever: contact is not lost and the force does not grow",
        ),
        _passes_and_lifts_off(EPSILONS[0]),
        corrected=f"for β = {CASE_II['beta']}, α_1 = -1, α_2 > 0 and every ε <= {REACHES}, of the starts of Figure 6 "
        "those with ν > 1 take an impact; ν = 1 is the trivial solution, a canard; those with ν < 1 lose contact, "
        "before p = 0 or, close to ν = 1, after it (3-case-II-starts)",
        note="As ε → 0, at leading order, the starts that pass and are not attracted shrink to the trivial solution: "
        "at a fixed ν < 1 contact is lost before p = 0 once ε is small, as the deviation dominates there for β < 1 "
        "(S-dominance, S-iwc). On the slow manifold, for every β in (0, 1) "
        "and every ε, the impact is that of C_1 < 0 (C-cases-I-II). The paper shows no simulation of Case II.",
    )


def same_share() -> bool | None:
    """Whether the deviation of every start is 1 - ν times one, which is a multiple of that of panel (a).

    It is linear in ν and in α_2: two of each settle it.
    """
    starts = [(nu, epsilon, times) for nu in (*ATTRACTED, *OTHERS) for epsilon in EPSILONS for times in (1, 3)]
    size = case_ii(fmpq(1), EPSILONS[0])[0].mean_force
    hats = [deviation(*case_ii(*start)) for start in starts]
    factors = [(1 - nu) * size * times for nu, _, times in starts]
    panel = [deviation(*varsim1.initial_state(CASE_II["beta"], nu, EPSILONS[0])) for nu in ATTRACTED]
    forms = [form for hat in (*hats, *panel) for form in (hat.V, hat.Y - 4 * hat.b, hat.Z - 2 * hat.b)]
    proportional = all(hat.b == factor * hat.p for hat, factor in zip(hats, factors, strict=True))
    return True if size > 0 and proportional and all(form == 0 for form in forms) else None


def share_grows() -> bool | None:
    """Whether λ-hat over its value at the start is positive for all times, for every ε <= REACHES."""
    share = least_share(CASE_II["beta"], REACHES)
    return True if share is not None and share > 0 else None


def _case_ii_starts() -> Entry:
    reached = [(nu, epsilon) for nu in ATTRACTED for epsilon in EPSILONS]
    lost = [(nu, epsilon) for nu in OTHERS for epsilon in EPSILONS]
    later = [(NEAR, epsilon) for epsilon in EPSILONS]
    return SECTION.settled(
        "3-case-II-starts",
        "lines 768 to 770",
        r"\text{Case II: which initial conditions take an impact}",
        f"Case II with β = {CASE_II['beta']}, α_1 = -1, α_2 > 0, the initial values of fig. varsim1, every ε in "
        f"(0, {REACHES}]: for every ν > 1 contact lasts for ever and λ_N → +∞, an impact; for every ν in (0, 1) "
        "contact is lost, and for ν close enough to 1 after p = 0",
        Rung.BALLS.check(
            "proofs/paper_runs.md, Corollary (Case II): λ_N is its mean times 1 + (ν - 1) u, u > 0 and u → ∞, the same "
            "u for every ν and α_2",
            all_of([same_share(), share_grows()]),
        ),
        Rung.POINTS.check(
            "ε = 1/1000 and 1/2000: certified runs for ν = 2, 4, the first zero of λ_N before p = 0 for ν = 1/4, 1/2 "
            f"and after it for ν = {NEAR}, and the sign of K",
            all_of(
                chain(
                    (side_is(*run, 1) for run in reached),
                    (side_is(*run, -1) for run in (*lost, *later)),
                    (attracted_takes_an_impact(*run) for run in reached),
                    (other_lifts_off_before(*run) for run in lost),
                    (lost_after(*run) for run in later),
                )
            ),
        ),
        note="ν = 1 is the trivial solution. The states with ν > 1 are those with α_2 p < (α_1 - α_3) b: rigid slip "
        "takes them to the G-spot (1-case-II).",
    )


def free_motion() -> bool | None:
    """Whether b, v, y of the flight solve b' = α_2, v' = b, y' = v from the state at lift-off."""
    found = {name: ALGEBRA.read(text) for name, text in FLIGHT.items()}
    at_zero = {name: ALGEBRA.coefficient_of(value, "u", 0) - _SYMBOLS[name] for name, value in found.items()}
    rates = [
        found["b"].derivative("u") - _SYMBOLS["alpha2"],
        found["v"].derivative("u") - found["b"],
        found["y"].derivative("u") - found["v"],
    ]
    return all(value.is_zero() for value in (*at_zero.values(), *rates))


def falls_for_ever(alpha_2_is_negative: bool = True) -> bool | None:
    """Whether the leading coefficients of v and y in u are negative: y < z from some time on, as z → 0."""
    image = {"alpha2": -_SYMBOLS["x"] if alpha_2_is_negative else _SYMBOLS["x"]}
    leading = [ALGEBRA.coefficient_of(ALGEBRA.read(FLIGHT[name]), "u", power) for name, power in (("v", 2), ("y", 3))]
    return all(rising_signs(-ALGEBRA.substitute(value, image)) for value in leading)


def below_a_line() -> bool | None:
    """Whether y < z no later than at an explicit time: y + x u³/6 <= (|b|/2 + |v| + |y|) u² for u >= 1.

    With d = |b|/2 + |v| + |y| and u = 6 (d + e)/x the flight has y <= -e u², for every e > 0, x = -α_2; and with
    d = |b| + |v| and u = 2 (d + e)/x, v <= -e u.
    """
    x, d, e = _SYMBOLS["x"], _SYMBOLS["d"], _SYMBOLS["e"]
    answers = []
    for name, power, factor in (("y", 3, 6), ("v", 2, 2)):
        leading = ALGEBRA.substitute(ALGEBRA.coefficient_of(ALGEBRA.read(FLIGHT[name]), "u", power), {"alpha2": -x})
        # u = factor (d + e)/x: (d + leading u) times a power of u, and x (d + leading u) is
        found = d * x + factor * leading * (d + e)
        answers.append(bool((found + e * x).is_zero()))
    return all(answers)


def _flight_ends() -> Entry:
    return SECTION.settled(
        "3-flight-ends",
        "lines 914 to 917",
        r"\text{in Cases I and III }\dot b<0:\ \text{lift-off always terminates}",
        "In Cases I and III (α_2 < 0) every flight of the model system ends with a touch-down, at every ε: in free "
        "motion v and y decrease in the end, without bound",
        Rung.EXACT.check(
            "v has the leading coefficient α_2/2 < 0, y is a cubic with α_2/6 < 0, z = z_0 e^(-u/ε) → 0: y < z in the "
            "end",
            all_of([free_motion(), falls_for_ever()]),
        ),
        Rung.EXACT.check(
            "y <= -e u² at u = 6 (|b|/2 + |v| + |y| + e)/|α_2| >= 1, and v <= -e u at u = 2 (|b| + |v| + e)/|α_2| >= "
            "1, for every e > 0 that makes both u at least 1: an explicit time, and for e > |z_0| y < z there",
            all_of([free_motion(), below_a_line()]),
        ),
        note="That the touch-down comes shortly after the G-spot, in the simulated runs of Case III: 3-after-lift-off.",
    )


ENTRIES: Builders = {
    "3-oscillations": _oscillations,
    "3-case-II": _case_ii,
    "3-case-II-starts": _case_ii_starts,
    "3-separatrix": _separatrix,
    "3-flight-ends": _flight_ends,
}
"""The sentences, in the order of the paper."""
