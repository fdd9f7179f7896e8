"""Ledger of Section 6: the simulations of the oscillator at epsilon = 10^-6, and the Cases that it may belong to.

Rigid slip up to the G-spot and C_1 there are enclosed (proofs/approach.md); what follows is the paper's statement at
leading order, and for all small ε by Theorem R (proofs/papers_rule.md), beside a float run of the oscillator with its
contact. Certified runs: ``gspot-verified simulate``.
"""

from __future__ import annotations

from functools import lru_cache, partial

from flint import arb, fmpq

from gspot_verified.leading_order.contact_force import contact_force
from gspot_verified.leading_order.lift_off import lift_off
from gspot_verified.mechanisms.approach.approach_result import Approach
from gspot_verified.mechanisms.approach.mechanism_side import MechanismSide, mechanism_side
from gspot_verified.mechanisms.shipped import shipped_mechanism
from gspot_verified.numbers.balls import approximate, ball_text, hull, sign_of, working_bits
from gspot_verified.numbers.verdict import Outcome
from gspot_verified.paper.checks.entry import Builders, Entry, Rung, Section, all_of
from gspot_verified.paper.checks.identities import Algebra, rising_signs
from gspot_verified.paper.numerics.oscillator_formulas import SECTION_6
from gspot_verified.scenes.floats.float_run import float_run
from gspot_verified.scenes.scene.file import load_scene
from gspot_verified.scenes.scene.run import SceneRun
from gspot_verified.signs.gamma.side import gamma_sign

SECTION = Section("Section 6 and Appendix B")
LIFT_OFF, TOUCH_DOWN, IMPACT = "lift-off", "touch-down", "impact without collision"
BETA, EPSILON = fmpq(7, 3), fmpq(1, 10**6)
STARTS = {"6-first-start": "-9/10", "6-second-start": "-1/2"}
"""φ-dot at φ = φ* + 1/10, y = v = 0."""
SEQUENCES: dict[str, tuple[str, ...]] = {"6-first-start": (LIFT_OFF, TOUCH_DOWN, IMPACT), "6-second-start": (IMPACT,)}
UNTIL = {"6-first-start": "113/1000", "6-second-start": "137/1000"}
LINES = {"6-first-start": "lines 2230 to 2232", "6-second-start": "lines 2232 to 2234"}
PRINTED_TIME = fmpq(1, 1000)
"""Lift-off "takes place just after" it."""
ROUNDED = fmpq(3, 2)
"""Below this multiple of it a later time has the one digit that is printed."""
FLOATS = ("LSODA", 1e-8)
TAU_START = fmpq(-10)
ALGEBRA = Algebra("beta kappa u")
CONTACT = Algebra("y v z p b")
"""The contact at fixed p and b in the time t/ε: y and z over ε², v over ε, k_1 = k_2 = c = 1."""
RATES = {"y": "v", "v": "b + p*(z - y)", "z": "-z - (z - y)"}
AT_REST = {"force": "z - y", "v": "v", "w": "b + p*(z - y)", "phi": "z - y + y/2 + v/4"}
"""λ, V, W and λ - (its value at rest for this y) + V l/g of proofs/papers_rule.md: κ = l = 1/2, g = 2."""
ALPHAS = {name: text for name, (_, text) in SECTION_6.items()}
MEMBERS: dict[str, tuple[fmpq, fmpq]] = {
    "I": (fmpq(1, 2), fmpq(0)),
    "II": (fmpq(1, 2), fmpq(20)),
    "III": (fmpq(7, 3), fmpq(0)),
}
"""A pair β, κ in each Case."""


@lru_cache(maxsize=4)
def in_the_limit(name: str) -> MechanismSide:
    """What the oscillator with its contact does from one start, for all small ε."""
    return mechanism_side(shipped_mechanism("oscillator"), {"phi": "phi_ref + 1/10", "phi_dot": STARTS[name]})


def slip(name: str) -> Approach:
    """The oscillator in rigid slip from one start, followed with every error bounded."""
    return in_the_limit(name).approach


@lru_cache(maxsize=4)
def simulated(name: str) -> SceneRun:
    """A float run of the oscillator on its compliant contact from one start."""
    scene = load_scene("oscillator", phi_dot=STARTS[name], epsilon=EPSILON, until=UNTIL[name])
    return float_run(scene, *FLOATS)


def takes(name: str) -> bool | None:
    """Whether C_1/Γ(-β) has the sign of the first event: < 0 for lift-off, > 0 for an impact."""
    found = slip(name)
    if found.verdict.outcome is not Outcome.PROVED or found.end != "G-spot" or found.coefficient is None:
        return None
    sign, side = sign_of(found.coefficient), gamma_sign(BETA)
    if sign is None or side is None:
        return None
    return (sign * side > 0) == (SEQUENCES[name][0] == IMPACT)


def takes_in_the_limit(name: str) -> bool | None:
    """Whether the first event is that of Theorem R."""
    side = in_the_limit(name).side
    return None if side is None else side == {LIFT_OFF: "lift-off", IMPACT: "impact"}[SEQUENCES[name][0]]


def no_force_comes_in() -> bool:
    """Whether the start y = v = z = 0 comes into (R5) of proofs/papers_rule.md: |X|² falls as φ is not 0, λ rises."""
    rates = {name: CONTACT.read(text) for name, text in RATES.items()}
    at = {name: CONTACT.read(text) for name, text in AT_REST.items()}
    p, b = CONTACT.symbols["p"], CONTACT.symbols["b"]
    size = p * at["v"] ** 2 / 2 + at["w"] ** 2 + 8 * p * at["phi"] ** 2
    falls = CONTACT.derivative(size, rates) + 32 * p * at["phi"] ** 2
    start = {name: CONTACT.constant(0) for name in RATES}
    first = [
        at["force"],
        at["phi"],
        size - b**2,
        CONTACT.derivative(at["force"], rates),
        CONTACT.derivative(at["force"], rates, 2) + b,
        CONTACT.derivative(at["phi"], rates) - b / 4,
    ]
    return bool(falls.is_zero()) and all(CONTACT.substitute(value, start).is_zero() for value in first)


def floats_show(name: str) -> bool | None:
    """Whether the float run has the events of the figure."""
    return tuple(event.name for event in simulated(name).events) == SEQUENCES[name]


def _start(name: str) -> Entry:
    found = slip(name)
    size = "" if found.coefficient is None else f"C_1 = {ball_text(found.coefficient, 8)}"
    what = "lift-off" if SEQUENCES[name][0] == LIFT_OFF else "impact"
    bound = {"lift-off": "some ε_0 > 0", "impact": "an ε_0 > 0 that depends on a given force"}[what]
    then = {"lift-off": "lose contact", "impact": "have a force above the given one, and lose no contact before"}[what]
    return SECTION.settled(
        name,
        LINES[name],
        r"\text{" + ", ".join(SEQUENCES[name]) + "}",
        f"From φ = φ* + 1/10, φ-dot = {STARTS[name]}, y = v = 0, β = 7/3, κ = 0: rigid slip, positive on a belt that "
        "is fast enough, reaches the G-spot with a positive contact force, on the side of the distinguished trajectory "
        f"from which, at leading order as ε → 0, there is a{'n' if what == 'impact' else ''} {what}; for every ε up to "
        f"{bound} compliant starts that tend to this one, the contact not far from rest or y = v = z = 0, keep contact "
        f"and slip until p < 0, and then {then}",
        Rung.BALLS.check("proofs/approach.md: the path in rigid slip and C_1 in balls", takes(name), size),
        Rung.BALLS.check(
            "proofs/papers_rule.md, Theorem R: its hypotheses at this start and at the G-spot, in balls; y = v = z = 0 "
            "by section 1",
            all_of([takes_in_the_limit(name), no_force_comes_in() or None]),
        ),
        Rung.POINTS.check(
            f"a float run at ε = 10^-6 ({FLOATS[0]}): {', '.join(SEQUENCES[name])}",
            floats_show(name),
            ", ".join(e.rounded(8) for e in simulated(name).events),
        ),
        note="The start z is not given in the paper: z = 0 in the float run, which relaxes. The third start of the "
        "paper (on the distinguished trajectory at p = 1/100) cannot be checked: its numbers are not printed.",
    )


def leading_bracket() -> tuple[arb, arb] | None:
    """Enclosures of the lift-off time at leading order for the ends of the ball of C_1; that of C_1 lies between.

    λ_N = mean + C_1 f(τ), both zeros with f < 0: a larger C_1 has the earlier zero.
    """
    coefficient = slip("6-first-start").coefficient
    if coefficient is None:
        return None
    times = []
    for end in (coefficient.upper(), coefficient.lower()):
        mantissa, exponent = end.man_exp()
        c1 = fmpq(mantissa) * fmpq(2) ** int(exponent)
        alpha_1, alpha_2, alpha_3 = (number(name, BETA, fmpq(0)) for name in ("alpha_1", "alpha_2", "alpha_3"))
        force = contact_force(BETA, alpha_1=alpha_1, alpha_2=alpha_2, c1=c1)
        if force.alpha_3 != alpha_3:
            return None
        found = lift_off(force, EPSILON, TAU_START, 10)
        if found.lower is None or found.upper is None:
            return None
        with working_bits(96):
            # τ = κ t/ε^(2/3), κ³ = -α_1/2
            unit = (arb(EPSILON) ** 2 * 2 / -arb(alpha_1)).root(3)
            times.append(unit * hull([arb(found.lower), arb(found.upper)]))
    return times[0], times[1]


def is_just_after(first: arb, last: arb) -> bool | None:
    """Whether both times are later than the printed one and round to it."""
    with working_bits(96):
        inside = first > PRINTED_TIME and last < ROUNDED * PRINTED_TIME
        outside = last < PRINTED_TIME or first > ROUNDED * PRINTED_TIME
    return True if inside else False if outside else None


def simulated_delay() -> fmpq | None:
    """The time from p = 0 to lift-off in the float run, p interpolated between its steps."""
    run = simulated("6-first-start")
    if run.samples is None or not run.events or run.events[0].name != LIFT_OFF:
        return None
    times, values = (list(map(float, run.samples.columns[name])) for name in ("t", "p"))
    for k in range(1, len(values)):
        if values[k] <= 0 < values[k - 1]:
            share = values[k - 1] / (values[k - 1] - values[k])
            zero = times[k - 1] + share * (times[k] - times[k - 1])
            return run.events[0].lower - fmpq(*zero.as_integer_ratio())
    return None


def floats_are_just_after(delay: fmpq | None) -> bool | None:
    """The same for the float run."""
    return None if delay is None else PRINTED_TIME < delay < ROUNDED * PRINTED_TIME


def _time() -> Entry:
    bracket, delay = leading_bracket(), simulated_delay()
    return SECTION.settled(
        "6-lift-off-time",
        "lines 2250 to 2252",
        r"\text{lift-off takes place just after } t=10^{-3}",
        f"First start, on a belt that is fast enough, ε = 10^-6: at leading order, from τ = {TAU_START} on, the "
        "contact first lifts off later than 10^-3 after p = 0, at a time that rounds to the one printed digit, with "
        "the C_1 of this start",
        Rung.BALLS.check(
            "proofs/iwc.md, section 4, at both ends of the ball of C_1; proofs/approach.md for C_1",
            None if bracket is None else is_just_after(*bracket),
            "" if bracket is None else f"t = {ball_text(hull([bracket[0], bracket[1]]), 8)}",
        ),
        Rung.POINTS.check(
            f"a float run at ε = 10^-6 ({FLOATS[0]})",
            floats_are_just_after(delay),
            "" if delay is None else f"t = {approximate(delay):.6g}",
        ),
        note="That contact is kept before, up to p < 0, is shown for every ε up to some ε_0: 6-first-start.",
    )


def number(name: str, beta: fmpq, kappa: fmpq) -> fmpq:
    """A printed α of the oscillator at a pair β, κ, in the units m_1 = l = g = 1."""
    images = {"beta": ALGEBRA.constant(beta), "kappa": ALGEBRA.constant(kappa)}
    found = ALGEBRA.substitute(ALGEBRA.read(ALPHAS[name]), images)
    return fmpq(0) if found.is_zero() else found.leading_coefficient()


def is_controlled() -> bool | None:
    """Whether α_2 is linear in κ with a positive slope for every β > 0, α_1 < 0, and α_3 = β α_1."""
    second = ALGEBRA.read(ALPHAS["alpha_2"])
    slope = second.derivative("kappa")
    ratio = ALGEBRA.read(ALPHAS["alpha_3"]) - ALGEBRA.read(f"beta*({ALPHAS['alpha_1']})")
    linear = slope.derivative("kappa").is_zero() and rising_signs(slope)
    return linear and ratio.is_zero() and rising_signs(-ALGEBRA.read(ALPHAS["alpha_1"]))


def belongs(case: str) -> bool | None:
    """Whether the pair of a Case has its signs (Sec. 1)."""
    beta, kappa = MEMBERS[case]
    first, second, third = (number(name, beta, kappa) for name in ("alpha_1", "alpha_2", "alpha_3"))
    negative, slower = second < 0, first < third < 0
    return {"I": negative and slower, "II": second > 0 and slower, "III": negative and third < first < 0}[case]


def ends_before_10_3() -> bool | None:
    """Whether α_2 > 0 for every κ >= 0 and β >= 10/3: in u = β - 10/3 and κ all coefficients are positive."""
    shifted = {"beta": ALGEBRA.read("10/3 + u")}
    return rising_signs(ALGEBRA.substitute(ALGEBRA.read(ALPHAS["alpha_2"]), shifted))


def _classes() -> Entry:
    pairs = "; ".join(f"Case {case}: β = {beta}, κ = {kappa}" for case, (beta, kappa) in MEMBERS.items())
    return SECTION.settled(
        "6-classes",
        "lines 2180 to 2185",
        r"\text{the sign of }\alpha_2^*\text{ is controlled by }\kappa;\ \text{any of the classes I, II, III}",
        "For every β > 0 the printed α_2 takes every value, each for one κ; so for every β in (0, 1) there are κ in "
        "Case I and in Case II, and for every β > 1 in Case III",
        Rung.EXACT.check(
            "α_2 is linear in κ with the slope (9450 β + 8262)/55080 > 0; α_1 < 0, α_3 = β α_1", is_controlled()
        ),
        Rung.POINTS.check(
            "a pair β, κ in each Case; α_2 > 0 for every κ >= 0, β >= 10/3",
            all_of([*(belongs(case) for case in MEMBERS), ends_before_10_3()]),
            pairs,
        ),
        note="κ < 0 is a spring of negative stiffness. With κ >= 0 Case III ends before β = 10/3, where α_2 > 0.",
    )


ENTRIES: Builders = {
    "6-classes": _classes,
    **{name: partial(_start, name) for name in STARTS},
    "6-lift-off-time": _time,
}
"""The Cases of the oscillator and its simulations."""
