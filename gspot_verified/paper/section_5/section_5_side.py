"""Ledger of Section 5: the sign of C_1/Γ(-β) decides lift-off or impact, for all small ε.

Proof pages: proofs/papers_rule.md, Theorem R, for every mechanism of Case III and an ε_0 that is not computed;
proofs/uniform.md, Theorem U2, for the extended example and an explicit one.
"""

from __future__ import annotations

from dataclasses import replace
from functools import lru_cache

from flint import arb, fmpq

from gspot_verified.expansion.from_state.limit_side import OTHER, limit_side
from gspot_verified.expansion.series.legend import DELTA_FACTORS
from gspot_verified.expansion.trajectory import expand_system
from gspot_verified.expansion.true_solutions.side import UniformSide, uniform_side
from gspot_verified.numbers.balls import ball, float_bounds, rounded_text, working_bits
from gspot_verified.numbers.verdict import Outcome
from gspot_verified.paper.checks.entry import Builders, Entry, Rung, Section, all_of
from gspot_verified.paper.checks.identities import Algebra, rising_signs
from gspot_verified.paper.checks.page import Page
from gspot_verified.scenes.floats.float_run import float_run
from gspot_verified.scenes.scene.file import load_scene
from gspot_verified.scenes.scene.run import IMPACT
from gspot_verified.scenes.scene.scene import Scene
from gspot_verified.signs.gamma.side import gamma_sign
from gspot_verified.testing import extended_example

LIFT_OFF = "lift-off"
BETA, COUPLING, ORDER = fmpq(3, 2), 1, 8
LARGEST_DELTA, WITHIN, FORCE = fmpq(1, 50), fmpq(1, 1000), 10
AMOUNTS = (fmpq(-1), fmpq(1))
"""C_1."""
FIRST_EVENT = {-1: LIFT_OFF, 1: IMPACT}
"""By the sign of C_1/Γ(-β)."""
FLOATS = ("LSODA", 1e-8)
SMALLER = (fmpq(1), fmpq(1, 4))
"""Float runs are made at these fractions of the largest δ."""
RULE_BETAS = tuple(fmpq(10 * n + tenth, 10) for n in range(1, 9) for tenth in (1, 9))
"""Near both ends of every interval between integers, from 1 to 9."""
BARRIER = Algebra("h r w b")
"""w = l/g; b = β - 3/2."""
WEIGHTS = (fmpq(1), fmpq(1, 2))
"""k_1 and k_2 in the matrix M of Lemma R1."""
DECAY, EXCESS = fmpq(1, 8), fmpq(1, 8)
"""θ g/l, and Γ_E - (β - 3/2)/2."""
CONE = (fmpq(1, 2), fmpq(3, 4))
"""a_U and c_U over ω (section 6)."""
_UNTIL = 25
_BITS = 128


@lru_cache(maxsize=4)
def side_of(amount: fmpq) -> UniformSide:
    """What becomes of the family with this C_1, for every δ up to the largest one."""
    trajectory = expand_system(extended_example(chi=COUPLING, alpha=(-1, -1, f"-{BETA}")), ORDER)
    return uniform_side(trajectory, amount, LARGEST_DELTA, within=WITHIN, force=FORCE)


def expected(amount: fmpq) -> str | None:
    """The first event by the rule."""
    sign = gamma_sign(BETA)
    return None if sign is None else FIRST_EVENT[sign * (1 if amount > 0 else -1)]


def is_as_expected(amount: fmpq) -> bool | None:
    """Whether the whole family takes the side of the rule."""
    found = side_of(amount)
    if found.verdict.outcome is not Outcome.PROVED:
        return None
    return {LIFT_OFF: LIFT_OFF, "impact": IMPACT}[str(found.side)] == expected(amount)


def member(amount: fmpq, delta: fmpq) -> Scene:
    """The middle of the family at one δ, as a start of the extended system."""
    found = side_of(amount)
    with working_bits(_BITS):
        values = found.trajectory.evaluate(found.start, delta, 20)
        size = ball(delta) ** ball(2 * (BETA - 1))
        moved = dict(zip("pbyv", found.deviation[-4:], strict=True))
        moved["z"] = moved["y"] / 2
        start = {
            name: middle((values[name] + size * moved[name]) * ball(delta) ** DELTA_FACTORS[name]) for name in moved
        }
    scene = load_scene("fig-varsim2", beta=BETA, chi=COUPLING, epsilon=delta**3, until=_UNTIL * delta**2, **start)
    return replace(scene, stop_at_force=fmpq(FORCE))


def middle(value: arb) -> fmpq:
    """The midpoint of a ball."""
    mantissa, exponent = value.mid().man_exp()
    return fmpq(mantissa) * fmpq(2) ** int(exponent)


def float_runs_agree(amount: fmpq) -> bool | None:
    """Whether float runs of members have the event of the rule first."""
    runs = (float_run(member(amount, LARGEST_DELTA * part), *FLOATS) for part in SMALLER)
    return all_of(bool(run.events) and run.events[0].name == expected(amount) for run in runs)


def barrier_is_positive() -> bool:
    """Lemma R1: N_11/(2κ), and half the Schur complement of N_33, are sums of a positive h r and a positive w r².

    N = 2(Γ_E h r - θ r²) diag(κ, 1, 0) - S by entries, θ = w/8 and Γ_E = b/2 + 1/8, with S_11 = κ(b h r - 2 k_2 w r²),
    S_22 = b h r - 2 (k_1 - k_2) w r², S_23 = k_1 g r, S_33 = -2 g³/l: N_23²/N_33 is k_1² w r²/2.
    """
    first, second = WEIGHTS
    h, r, w, b = (BARRIER.symbols[name] for name in "hrwb")
    growth = (b / 2 + EXCESS) * h * r - DECAY * w * r**2
    corner = growth - (b * h * r - 2 * second * w * r**2) / 2
    schur = growth - (b * h * r - 2 * (first - second) * w * r**2) / 2 - first**2 * w * r**2 / 4
    return all(rising_signs(value) and len(value.to_dict()) == 2 for value in (corner, schur))


def cone_is_kept() -> bool:
    """Section 6: a_U < V/Y = ω, c_U < N/V = ω, a_U < c_U, and κq = ω² > c_U², as δ → 0 far out."""
    slope, rise = CONE
    return 0 < slope < rise < 1 and rise**2 < 1


R = Page("papers_rule", (barrier_is_positive, cone_is_kept))


def rule_is_the_printed_one(beta: fmpq) -> bool | None:
    """Whether Theorem R has the printed events for both signs of C_1/Γ(-β)."""
    found, sign = limit_side(beta), gamma_sign(beta)
    if found.side is None or sign is None or found.verdict.outcome is not Outcome.PROVED:
        return None
    names = {LIFT_OFF: "lift-off", IMPACT: "impact"}
    return {sign: found.side, -sign: OTHER[found.side]} == {key: names[event] for key, event in FIRST_EVENT.items()}


def _rule() -> Entry:
    return Section("Section 5, matching").settled(
        "5-rule",
        "lines 2087 to 2092",
        r"\text{the same conditions (dTheta\_sign) determine whether lift-off or IWC occur}",
        "For every mechanism of Case III with analytic functions, p, b, y, v independent at its G-spot, k_1, k_2, c >"
        " 0, β > 1 not an integer, and every rigid slip motion into the G-spot with C_1 not 0, slip being positive "
        "there too: compliant starts that tend to a state of it, the contact not far from rest, keep contact and slip"
        " until p < 0 for every ε up to some ε_0 > 0, and then lose contact for C_1/Γ(-β) < 0; for C_1/Γ(-β) > 0, λ_N "
        "grows past any given force, on which ε_0 depends, and contact is not lost before",
        R.carries(
            Rung.EXACT.check(
                "Theorem R: the event for each sign of C_1/Γ(-β) is the printed one, held against it at two β between "
                "each two integers up to 9",
                all_of(rule_is_the_printed_one(beta) for beta in RULE_BETAS),
            )
        ),
        Rung.POINTS.check(
            "5-side, by another theorem: the families of the extended example, χ = 1, have these events",
            all_of(is_as_expected(amount) for amount in AMOUNTS),
        ),
        note="Not far from rest: hypothesis (R5) of the page. ε_0 is not computed. That an impact is completed is not "
        "proved. Cases I and II are not covered.",
    )


def _latest(amount: fmpq) -> str:
    found = side_of(amount)
    if found.entered is None:
        return "nothing is proved"
    latest = rounded_text(float_bounds(found.latest(LARGEST_DELTA))[1], 1)
    return f"C_1 = {amount}: {found.side}, at ε_0 before s = {latest}"


def _side() -> Entry:
    return Section("Section 5, matching").settled(
        "5-side",
        "lines 2087 to 2092",
        r"\text{the same conditions (dTheta\_sign) determine whether lift-off or IWC occur}",
        f"The extended example in positive slip, χ = {COUPLING}, β = {BETA}, for every ε <= {LARGEST_DELTA**3} at "
        f"once: all states whose scaled ξ, p, b, y, v and λ_N + y/2 are within {WITHIN} ε^({2 * (BETA - 1) / 3}) of "
        f"those of the expansion of order {ORDER} and the slow deviation with C_1, in which λ_N + y/2 does not "
        f"deviate, at t = -ε^(2/3), lose contact for C_1 = -1; for C_1 = 1, λ_N grows past {FORCE} times the mean "
        "force, with p < 0",
        Rung.BALLS.check(
            "proofs/uniform.md, Theorem U2: a tube around the expansion, then a cone",
            all_of(is_as_expected(amount) for amount in AMOUNTS),
            "; ".join(_latest(amount) for amount in AMOUNTS),
        ),
        Rung.POINTS.check(
            f"float runs ({FLOATS[0]}) of the middle of each family at ε = "
            f"{' and '.join(str((LARGEST_DELTA * part) ** 3) for part in SMALLER)}",
            all_of(float_runs_agree(amount) for amount in AMOUNTS),
        ),
        note="At leading order in ε: S-side, for every β > 1 that is not an integer; for 0 < β < 1 S-iwc has the "
        "sign of dΘ/dτ alone. Contact may be lost after such an impact, too.",
    )


ENTRIES: Builders = {"5-side": _side, "5-rule": _rule}
"""The side of stated families for all small ε."""
