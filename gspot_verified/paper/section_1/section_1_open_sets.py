"""Ledger of Section 1: open sets of states that reach a G-spot, where the α's are functions of the state.

Page: proofs/approach.md, section 2, the corollary. Rates are those in the time s with dt = p ds. Near the G-spot a1, a3
and A2 bound -α_1, -α_3 and |α_2|, f and g a component of F and of G; n is -b.
"""

from __future__ import annotations

from flint import arb, fmpq, fmpq_mpoly

from gspot_verified.mechanisms.approach.capture import capture
from gspot_verified.mechanisms.approach.slip_flow import SlipFlow, SlipNumbers
from gspot_verified.mechanisms.derive.to_system import shift
from gspot_verified.mechanisms.shipped import shipped_mechanism
from gspot_verified.numbers.balls import working_bits
from gspot_verified.paper.checks.entry import Builders, Entry, Rung, Section, all_of
from gspot_verified.paper.checks.identities import Algebra, rising_signs
from gspot_verified.paper.checks.page import Page
from gspot_verified.paper.section_1 import section_1_cases
from gspot_verified.paper.section_2 import general_system

ALGEBRA = Algebra("p b v alpha1 alpha2 alpha3 LFp LGp LFb LGb LFy LGy LFv LGv a1 a3 A2 n c u w")
_SYMBOLS = ALGEBRA.symbols
FIELD = "p*LF{name} - b*LG{name}"
"""The rate of a function of the state: dξ/ds = p F - b G, as p λ_N = -b."""
KEPT = {"y": "p*v", "v": "0*p"}
"""So y and v stay 0."""
SLOWEST = {"p": "-a1*p", "n": "A2*p - a3*n"}
"""The rates of p and n are at most these."""
INTEGRALS = {"p": "p", "n": "a1*n + A2*p"}
"""a1 times a bound of the integral of p, which is the time, and a1 a3 times one of that of n."""
RATES_OF_DECAY = {"p": "a1", "n": "a1*a3"}
WEIGHT = "a1*n + 2*A2*p"
"""a1 times the W of the second proof."""
DECAY = {"a1": "2*c + w", "a3": "c + u"}
"""W falls at least like e^(-c s): c is at most a3 and a1/2."""
SYSTEM = {
    "1-case-I": (("-2", "-1", "-1"), (fmpq(1, 100), fmpq(-1, 50))),
    "1-case-II": (("-2", "1", "-1"), (fmpq(1, 100), fmpq(-1, 20))),
    "1-case-III": (("-1", "-1", "-3/2"), (fmpq(1, 100), fmpq(-1, 20))),
}
"""α_1*, α_2*, α_3* of the extended example, and p and b of the middle of a set of states."""
CHI, FIRST_SLIP, RADIUS = 1, 5, fmpq(1, 10**4)
_BITS = 100


def flow_is_the_rescaled_one() -> bool:
    """Whether the rates of p and b are those of Gspot1 and Gspot2, and y = v = 0 is kept, by the definitions."""
    defined = {**general_system.DEFINED, **general_system.LAGRANGIAN}
    images = {name: ALGEBRA.read(text) for name, text in defined.items()}
    wanted = {**section_1_cases.RATES, **KEPT}
    return all(
        (ALGEBRA.substitute(ALGEBRA.read(FIELD.format(name=name)), images) - ALGEBRA.read(text)).is_zero()
        for name, text in wanted.items()
    )


def slope(text: str) -> fmpq_mpoly:
    """The rate of a function of p and n, both as slow as they can be."""
    return ALGEBRA.derivative(ALGEBRA.read(text), {name: ALGEBRA.read(rate) for name, rate in SLOWEST.items()})


def ways_shrink() -> bool:
    """Whether the integrals of p and n are at most the stated ones, which are small with p and n at the start."""
    at_spot = {name: ALGEBRA.constant(0) for name in SLOWEST}
    return all(
        (slope(text) + ALGEBRA.read(RATES_OF_DECAY[name]) * _SYMBOLS[name]).is_zero()
        and ALGEBRA.substitute(ALGEBRA.read(text), at_spot).is_zero()
        for name, text in INTEGRALS.items()
    )


def weight_decays() -> bool:
    """Whether the rate of W is at most -c W."""
    images = {name: ALGEBRA.read(text) for name, text in DECAY.items()}
    return rising_signs(-ALGEBRA.substitute(slope(WEIGHT) + _SYMBOLS["c"] * ALGEBRA.read(WEIGHT), images))


def by_integrals(name: str) -> bool | None:
    """Whether a Case has what Theorem A1 asks for: α_1, α_3 < 0, and a force that does not fall to 0."""
    return all_of([section_1_cases.reaches(section_1_cases.CASES[name]), section_1_cases.force_moves(name)])


def by_the_weight(name: str) -> bool | None:
    """The same by the trace and the determinant of the flow, and by the force along its solutions, with its limit."""
    return all_of([section_1_cases.is_stable(name), section_1_cases.stays_and_ends(name)])


def is_captured(name: str) -> bool | None:
    """Whether all states of a set in the contact reach a G-spot of the extended example, χ not 0, in balls."""
    alphas, place = SYSTEM[name]
    constants = dict(zip(("alpha_1", "alpha_2", "alpha_3"), alphas, strict=True))
    mechanism = shipped_mechanism("extended system", chi=CHI, **constants)
    with working_bits(_BITS):
        x, u, p, b = (arb(middle, RADIUS) for middle in (0, FIRST_SLIP, *place))
        found = capture(SlipNumbers(SlipFlow.of(shift(mechanism))), [x, u, arb(0), arb(0), p, b], arb(0))
    return None if found is None else True


def _open_sets() -> Entry:
    first, second = (Page("approach", (flow_is_the_rescaled_one, step)) for step in (ways_shrink, weight_decays))
    return Section("Section 1").settled(
        "1-open-sets",
        "lines 53 to 54",
        r"\text{approached in finite time by an open set of initial conditions}",
        "For every mechanism with analytic functions and every G-spot of it in Case I, II or III at which p, b, y, v "
        "are independent and slip is positive: each neighbourhood of the G-spot has a non-empty set of states with p "
        "> 0 and b < 0, open among those with y = v = 0, from which rigid slip stays in the neighbourhood, with a "
        "positive force, and tends to a G-spot in it in finite time; λ_N tends to ∞ in Cases I and II, and to "
        "α_2/(α_3 - α_1) at this G-spot in Case III",
        first.carries(
            Rung.EXACT.check(
                "section 2, corollary: by the integrals of p and |b| the state moves little; in each Case α_1, α_3 < 0 "
                "and the rate of λ_N has the sign that is asked for",
                all_of(map(by_integrals, section_1_cases.CASES)),
            )
        ),
        second.carries(
            Rung.EXACT.check(
                "section 2, second proof: a weighted sum of p and |b| falls like an exponential; in each Case trace < 0"
                " < determinant, and λ_N > 0 along the solutions, with its limit",
                all_of(map(by_the_weight, section_1_cases.CASES)),
            )
        ),
        Rung.POINTS.check(
            f"Theorem A1 in balls: a set of states of the extended example, χ = {CHI}, in each Case",
            all_of(map(is_captured, SYSTEM)),
        ),
        note="In a small neighbourhood the G-spot that is reached is the given one where the state has four "
        "components, as it is isolated then; with more components it may be another one. Which states: with constant "
        "α's, 1-case-I, 1-case-II, 1-case-III.",
    )


ENTRIES: Builders = {"1-open-sets": _open_sets}
"""Open sets of states."""
