"""Ledger of Section 6: sentences on the oscillator, held against other sentences and its formulas."""

from __future__ import annotations

from collections.abc import Mapping
from math import prod

from flint import arb, fmpq, fmpq_mpoly

from gspot_verified.numbers.balls import nonfinite, working_bits
from gspot_verified.paper.checks.entry import Builders, Entry, Rung, Section, all_of
from gspot_verified.paper.checks.identities import rising_signs
from gspot_verified.paper.checks.words import Place, held_against
from gspot_verified.paper.section_6 import oscillator, section_6_runs
from gspot_verified.paper.section_6.oscillator import ALGEBRA

SECTION = Section("Section 6 and Appendix B")
_SYMBOLS = ALGEBRA.symbols
SOURCES = "lines 106 to 109, 121 to 122, 2096 to 2098"
ELSEWHERE = {
    "the Introduction": Place("line 109", r"first studied by Leine \{\\em et al\.\}\\/ \\cite\{(\w+)\}"),
    "the caption of Figure 1": Place("line 121", r"proposed by \\cite\{(Leine\w+)\}"),
}
HERE = Place("line 2098", r"oscillator proposed by \\cite\{(leine\w+)\}")
"""Who proposed the oscillator."""
CURVES = "lines 2224 to 2225 and 2247 to 2250"
IN_THE_CAPTION = {
    "the simulation": Place("caption", r"The (\w+) curves were obtained by numerical simulation"),
    "Θ": Place("caption", r"the (\w+) curves are given by the suitable scaled \$\\Theta\$"),
}
IN_THE_TEXT = {
    "the simulation": Place("text", r"The (\w+) curve is simulation"),
    "Θ": Place("text", r"The (\w+) curve is computed using the suitably scaled hypergeometric \$\\Theta\$"),
}
"""The colours of Figure 12."""
FOUR_CURVES = "lines 2211 to 2214 and 2230 to 2237"
_CURVE = r"([a-z]+/[a-z-]+)"
DRAWN = {
    "first start": (rf"initial conditions \({_CURVE},", rf"The {_CURVE} curve \(first"),
    "second start": (rf"initial conditions \(\S+, {_CURVE},", rf"The {_CURVE} curve \(second"),
    "third start": (rf"and {_CURVE} curves\)", rf"The {_CURVE} curve is the trajectory"),
    "expansion": (rf"distinguished trajectory \({_CURVE} curve\)", rf"the {_CURVE} curve is the appoximate"),
}
"""The colour and the kind of line of each curve of Figure 11, in the caption and in the text."""
BELT = {"moving": "-3/5*l*om - lam", "at rest": "0*l"}
"""The velocity of the surface: below -3/5 sqrt(g l) by lam > 0; none."""
SIDES = {"moving": 1, "at rest": -1}
"""The sign of the slip."""
STARTS = (fmpq(-9, 10), fmpq(-1, 2))
"""φ-dot of the two starts, in the units m_1 = l = g = 1; φ = φ* + 1/10, cos φ* = 3/5."""
AWAY = fmpq(1, 10)
IN_CONTACT = {"psi": "C - 1", "x": "-S*w"}
"""ψ and its rate at both starts."""
BETAS = {"below": "18/7 - lam", "above": "18/7 + lam"}
"""Every β below 18/7, and every β above it, at the distance lam > 0."""
HIGHEST = fmpq(18, 7)


def _attribution() -> Entry:
    return SECTION.settled(
        "6-attribution",
        SOURCES,
        r"\text{a frictional impact oscillator proposed by [leine2008]}",
        "One work is cited in lines 109, 121 and 2098 as that in which the oscillator was studied first, and proposed",
        *(held_against(SOURCES, f"line 2098 and {where}", HERE, place) for where, place in ELSEWHERE.items()),
        corrected="One work is cited in all three places; lines 109 and 121 name the one of 2002",
        note="By the keys of the citations: the source holds no bibliography.",
    )


def _colours() -> Entry:
    return SECTION.settled(
        "6-colours",
        CURVES,
        r"\text{blue: simulation, red: }\Theta\qquad\text{red: simulation, blue: }\Theta",
        "Figure 12: in the caption and in the text the same curve is the simulation, and the same one is Θ",
        *(
            held_against(CURVES, f"the curve of {what}", IN_THE_CAPTION[what], IN_THE_TEXT[what])
            for what in IN_THE_TEXT
        ),
        corrected="The caption or the text has the two colours exchanged",
        note="The figure decides.",
    )


def _curves() -> Entry:
    return SECTION.settled(
        "6-curves",
        FOUR_CURVES,
        r"\text{red/solid, blue/dashed, purple/dotted, green/dash-dotted}",
        "Figure 11: the caption and the text name the same colour and kind of line for each of the four curves",
        *(
            held_against(FOUR_CURVES, f"the curve of the {what}", Place("caption", caption), Place("text", text))
            for what, (caption, text) in DRAWN.items()
        ),
        note="The caption names no start by its numbers: the three are taken in the order of the text.",
    )


def by_the_place() -> fmpq_mpoly:
    """The rate of the printed x."""
    return oscillator.along(ALGEBRA.read(oscillator.MOTION["x"]), {"phi": _SYMBOLS["w"]})


def by_the_friction() -> fmpq_mpoly:
    """The same as the power of the tangential force: Q_T times the rates."""
    push = {name: ALGEBRA.read(oscillator.MOTION[name]) for name in ("QT1", "QT2")}
    return push["QT1"] * _SYMBOLS["w"] + push["QT2"] * _SYMBOLS["x"]


def slips_at_the_g_spot(rate: fmpq_mpoly, belt: str) -> bool | None:
    """Whether the rate less the velocity of the belt has its sign at the G-spot, for all l, g and lam > 0."""
    slip = SIDES[belt] * oscillator.at_g_spot(rate - ALGEBRA.read(BELT[belt]))
    return True if rising_signs(slip) else False if rising_signs(-slip) else None


def slips_at_the_starts(rate: fmpq_mpoly, belt: str) -> bool | None:
    """The same at the two starts of the simulations, in the units l = om = 1; lam enters with the same sign."""
    images = {name: ALGEBRA.constant(1) for name in ("l", "om")}
    slip, velocity = (SIDES[belt] * ALGEBRA.substitute(v, images) for v in (rate, ALGEBRA.read(BELT[belt])))
    held = -ALGEBRA.coefficient_of(velocity, "lam", 1)
    still = ALGEBRA.coefficient_of(velocity, "lam", 0)
    cosine, sine = (fmpq(*map(int, oscillator.G_SPOT[name].split("/"))) for name in "CS")
    with working_bits(64):
        here = arb(cosine) * arb(AWAY).cos() - arb(sine) * arb(AWAY).sin()
        found = [_in_balls(slip, {"C": here, "w": arb(turn)}) - _in_balls(still, {}) for turn in STARTS]
    if not (held.is_zero() or rising_signs(held)):
        return None
    return True if all(u > 0 for u in found) else False if held.is_zero() and all(u < 0 for u in found) else None


def _in_balls(value: fmpq_mpoly, values: Mapping[str, arb]) -> arb:
    """The value of a polynomial; not finite where it has another symbol."""
    total = arb(0)
    for exponents, number in value.terms():
        powers = zip(ALGEBRA.symbols, map(int, exponents), strict=True)
        total += prod((values.get(name, nonfinite()) ** k for name, k in powers if k), start=arb(number))
    return total


def _slips(rate: fmpq_mpoly) -> bool | None:
    """Whether both belts give their sign, at the G-spot and at the starts."""
    return all_of(slips(rate, belt) for slips in (slips_at_the_g_spot, slips_at_the_starts) for belt in BELT)


def _positive_slip() -> Entry:
    return SECTION.settled(
        "6-positive-slip",
        "lines 2134 to 2140, 2167 to 2174, 2193 to 2200",
        r"\text{Assuming positive slip},\quad x(q)=l\sin(\phi),\quad\dot\phi^*=-\sqrt{g/l}",
        "With u as the rate of the printed x(q) = l sin φ less the velocity of the belt, slip is positive at the G-spot"
        " and at the two starts on every belt with a velocity below -3/5 √(g l); on a surface at rest it is negative "
        "there",
        Rung.BALLS.check("the rate of the printed x", _slips(by_the_place())),
        Rung.BALLS.check("the printed Q_T times the rates of φ and ψ", _slips(by_the_friction())),
        note="The velocity of the belt is not printed. Without it nothing can be said of whether a run ends in stick.",
    )


def _units(value: fmpq_mpoly) -> fmpq_mpoly:
    """In the units m_1 = l = g = 1, at the printed ψ and its printed rate."""
    place = {name: ALGEBRA.read(text) for name, text in IN_CONTACT.items()}
    return ALGEBRA.substitute(value, place | {"l": ALGEBRA.constant(1)})


def by_the_height() -> bool | None:
    """Whether y and the v of Appendix B vanish there, for every φ and its rate."""
    y, v = ALGEBRA.read(oscillator.MOTION["y"]), ALGEBRA.read(oscillator.PRINTED["B-v"]["formula"])
    return _units(y).is_zero() and _units(v).is_zero()


def by_the_rates() -> bool | None:
    """Whether ψ = -(1 - cos φ), its rate is the printed one, and Q_N times the rates is 0."""
    psi = ALGEBRA.read(IN_CONTACT["psi"])
    rate = oscillator.along(psi, {"phi": _SYMBOLS["w"]}) - ALGEBRA.read(IN_CONTACT["x"])
    push = {name: ALGEBRA.read(oscillator.MOTION[name]) for name in ("QN1", "QN2")}
    power = push["QN1"] * _SYMBOLS["w"] + push["QN2"] * _SYMBOLS["x"]
    return rate.is_zero() and (psi + 1 - _SYMBOLS["C"]).is_zero() and _units(power).is_zero()


def _starts() -> Entry:
    return SECTION.settled(
        "6-starts",
        "lines 2197 to 2200",
        r"\psi=\cos\phi-1,\ \dot\psi=-\sin(\phi)\dot\phi\ \Rightarrow\ y=v=0",
        "In the units m_1 = l = g = 1 the printed ψ and its rate are those of y = v = 0, for every φ and its rate",
        Rung.EXACT.check("y of line 2136 and v of Appendix B", by_the_height()),
        Rung.EXACT.check("the rate of the printed ψ; the power of the normal force", by_the_rates()),
    )


def damper(where: str) -> fmpq_mpoly:
    """c_ψ for these β, with lam > 0."""
    return ALGEBRA.substitute(ALGEBRA.read(oscillator.PARAMETERS["cpsi"]), {"beta": ALGEBRA.read(BETAS[where])})


def damps_up_to_the_highest() -> bool | None:
    """Whether c_ψ > 0 for every β < 18/7, and c_ψ < 0 for every β > 18/7."""
    return all_of([rising_signs(damper("below")), rising_signs(-damper("above"))])


def falls_through_zero() -> bool | None:
    """The same by its value and its slope: 0 at 18/7, and linear in β with a negative slope."""
    found = ALGEBRA.read(oscillator.PARAMETERS["cpsi"])
    slope = found.derivative("beta")
    at_highest = ALGEBRA.substitute(found, {"beta": ALGEBRA.constant(HIGHEST)})
    return all_of([at_highest.is_zero(), slope.derivative("beta").is_zero(), rising_signs(-slope)])


def has_a_case() -> bool | None:
    """Whether there are κ >= 0 with a Case for every β up to 18/7 but β = 1: κ = 0 is one.

    There α_2 < 0, as it is convex in β and negative at both ends; α_1 < 0 and α_3 = β α_1: Case I for β < 1, else III.
    """
    algebra, zero = section_6_runs.ALGEBRA, section_6_runs.ALGEBRA.constant(0)
    second = algebra.substitute(algebra.read(section_6_runs.ALPHAS["alpha_2"]), {"kappa": zero})
    convex = rising_signs(second.derivative("beta").derivative("beta"))
    ends = [section_6_runs.number("alpha_2", beta, fmpq(0)) for beta in (fmpq(0), HIGHEST)]
    return all_of([section_6_runs.is_controlled(), convex, max(ends) < 0])


def has_a_case_by_its_coefficients() -> bool | None:
    """The same with β = 18/7 a/(a + b), a > 0, b >= 0: (a + b)² α_2 at κ = 0 has negative coefficients alone.

    So have α_1 and α_3, and α_3 is β α_1. Here a is u and b is kappa.
    """
    algebra = section_6_runs.ALGEBRA
    first, second, third = (algebra.read(section_6_runs.ALPHAS[f"alpha_{k}"]) for k in (1, 2, 3))
    still = algebra.substitute(second, {"kappa": algebra.constant(0)})
    terms = [algebra.coefficient_of(still, "beta", power) for power in range(3)]
    part, whole = algebra.read("u") * HIGHEST, algebra.read("u + kappa")
    spread = sum((term * part**k * whole ** (2 - k) for k, term in enumerate(terms)), algebra.constant(0))
    beta = algebra.read("beta")
    all_terms = (still - sum((term * beta**k for k, term in enumerate(terms)), algebra.constant(0))).is_zero()
    return all_of([all_terms, (third - beta * first).is_zero(), *(rising_signs(-v) for v in (first, third, spread))])


def _any_beta() -> Entry:
    return SECTION.settled(
        "6-any-beta",
        "lines 2156 to 2165, 2184 to 2185",
        r"\beta\ \text{may take any desired value}",
        "With the chosen parameters the constant c_ψ of the damper is positive for 0 < β < 18/7 and negative for every "
        "β > 18/7; for every β with 0 < β <= 18/7 but β = 1 there is a κ >= 0 with which the oscillator is in a Case",
        Rung.EXACT.check(
            "the signs of c_ψ = 25/108 (18 - 7β) m_1 sqrt(g/l) of line 2160 on both sides of 18/7; α_1, α_2 and α_3 at "
            "κ = 0",
            all_of([damps_up_to_the_highest(), has_a_case()]),
        ),
        Rung.EXACT.check(
            "c_ψ falls linearly through 0 at 18/7; the signs of the coefficients of α_1, α_2 and α_3 with κ = 0 and "
            "β = 18/7 a/(a + b)",
            all_of([falls_through_zero(), has_a_case_by_its_coefficients()]),
        ),
        note="The paper does not say that constants of springs and dampers are not negative. With constants of any "
        "sign every β > 0 can be had, in some Case but for β = 1: 6-classes.",
    )


ENTRIES: Builders = {
    "6-attribution": _attribution,
    "6-positive-slip": _positive_slip,
    "6-starts": _starts,
    "6-any-beta": _any_beta,
    "6-curves": _curves,
    "6-colours": _colours,
}
"""Sentences of Sec. 6."""
