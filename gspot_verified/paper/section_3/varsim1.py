"""Ledger of Fig. varsim1: what each of the fifteen runs does in the compliant model, for every epsilon <= epsilon_0."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial

from flint import fmpq

from gspot_verified.compliant.model.normal_form import (
    CompliantModel,
    CompliantState,
    compliant_model,
    compliant_state,
    deviation,
)
from gspot_verified.compliant.motion.first_zero import contact_lasts, first_zero
from gspot_verified.compliant.side.side_rule import side_rule
from gspot_verified.numbers.verdict import Outcome
from gspot_verified.paper.checks.entry import Builders, Check, Entry, Rung, Section, all_of
from gspot_verified.paper.checks.identities import Algebra, rising_signs
from gspot_verified.paper.numerics.paper_runs import START, fate_by_side, margin_up_to
from gspot_verified.paper.section_3 import section_3

ALGEBRA = Algebra("p epsilon y z lam")
_SYMBOLS = ALGEBRA.symbols
PANELS = {fmpq(1, 2): "a", fmpq(3, 2): "b", fmpq(5, 2): "c"}
FACTORS = (fmpq(1, 4), fmpq(1, 2), fmpq(1), fmpq(2), fmpq(4))
"""The simulated ν; b(0) = -ν |λ_N on the trivial solution|/2."""
EPSILON_0 = {fmpq(1, 2): fmpq(1, 100), fmpq(3, 2): fmpq(1, 100), fmpq(5, 2): fmpq(1, 500)}
"""By β: the proof reaches every ε up to here, for all five runs."""
POINTS = (fmpq(1, 1000), fmpq(1, 10**6), fmpq(1, 10**12))
IMPACT, LIFT_OFF, TRIVIAL, EARLY = "impact", "lift-off", "trivial", "lift-off before the G-spot"
_ABOVE, _BELOW = FACTORS[:2], FACTORS[3:]
FATES: dict[fmpq, dict[fmpq, str]] = {
    fmpq(1, 2): dict.fromkeys(FACTORS, IMPACT),
    fmpq(3, 2): {**dict.fromkeys(_ABOVE, IMPACT), fmpq(1): TRIVIAL, **dict.fromkeys(_BELOW, LIFT_OFF)},
    fmpq(5, 2): {**dict.fromkeys(_ABOVE, LIFT_OFF), fmpq(1): TRIVIAL, **dict.fromkeys(_BELOW, IMPACT)},
}
"""By β and ν, from lines 763 to 785: all of panel (a) take an impact; in (b) and (c) the trivial solution divides the
two fates, which are swapped. The sides are those of lines 783 to 785 with |b(0)| in place of b(0) (entry 3-sides)."""
DRAWN = {
    IMPACT: "contact lasts for ever with λ_N > 0, λ_N → +∞ and y → −∞: an impact without collision",
    LIFT_OFF: "λ_N is positive until after the G-spot, and then contact is lost",
    TRIVIAL: "it is the trivial solution, and λ_N is constant for ever",
}

BELOW = "; z begins below 0 and falls where it is 0 (modelsys5), y = z - ε² λ_N"
BY_AN_INTEGRAL = "while λ_N > 0 e^(t/ε) z falls from below 0 (modelsys5), and y = z - ε² λ_N; "
AT_POINTS = {
    IMPACT: "K > 0, which an impact needs, and λ_N > 0 up to t = 2 ε^(2/3)",
    LIFT_OFF: "K < 0, and the first zero of λ_N is after p = 0",
    TRIVIAL: "the deviation is 0, and λ_N > 0 up to t = 2 ε^(2/3)",
}
"""What is seen at one ε: of an impact and of the trivial solution less than what is drawn."""
FOUND = {IMPACT: "K > 0, λ_N > 0", LIFT_OFF: "lift-off", TRIVIAL: "deviation 0, λ_N > 0", EARLY: EARLY, None: "open"}
"""The same in a word, for what came out."""
RATE_OF_Z, FORCE = "-z - lam", "z - y"
"""ε z' of modelsys5 and ε² λ_N of compl2, with ε² λ_N as lam."""


def initial_state(beta: fmpq, nu: fmpq, epsilon: fmpq) -> tuple[CompliantModel, CompliantState]:
    """p = 1/2, b = -ν |mean force| p, z = y/2, v = 0, y = 2 b ε²/p; α_1 = α_2 = -1."""
    model = compliant_model(beta, epsilon)
    b = -nu * START * abs(model.mean_force)
    y = 2 * b * epsilon**2 / START
    return model, compliant_state(START, b, y, 0, y / 2)


def proved_fate(beta: fmpq, nu: fmpq) -> str | None:
    """What Theorem A' proves of a run for every ε <= ε_0; None when nothing, and for ν = 1 in Case III."""
    if beta > 1 and nu == 1:
        return None
    margin = margin_up_to(beta, nu, EPSILON_0[beta])
    return fate_by_side(beta, nu) if margin is not None and margin > 0 else None


def is_trivial(beta: fmpq, nu: fmpq) -> bool:
    """Whether b/p, y, z and v keep their initial values, by modelsys2 to modelsys5 (times ε²), for all ε and p."""
    p, epsilon = _SYMBOLS["p"], _SYMBOLS["epsilon"]
    model = compliant_model(beta, 1)
    ratio = -nu * abs(model.mean_force)
    b, y, v, z = ratio * p, 2 * ratio * epsilon**2, ALGEBRA.constant(0), ratio * epsilon**2
    force = z - y
    slope = epsilon**2 * (model.alpha_2 - ratio * model.alpha_1) - model.alpha_3 * force  # of b - ratio p
    return all(value.is_zero() for value in (slope, v, epsilon**2 * b + p * force, z + force))


def fate_at(beta: fmpq, nu: fmpq, epsilon: fmpq) -> str | None:
    """The fate that is left at one ε: the lift-off in a bracket, or the sign of K and λ_N > 0 up to t = 2 ε^(2/3)."""
    model, state = initial_state(beta, nu, epsilon)
    hat, side = deviation(model, state), side_rule(model, state).side
    fate = TRIVIAL if all(value == 0 for value in (hat.b, hat.V, hat.Y, hat.Z)) else IMPACT if side > 0 else None
    if fate is not None:
        return fate if contact_lasts(model, state, _some_time(epsilon)).outcome is Outcome.PROVED else None
    lower = first_zero(model, state, digits=6).lower if side < 0 else None
    return None if lower is None else LIFT_OFF if lower > 0 else EARLY


def depth(beta: fmpq, nu: fmpq) -> fmpq:
    """-z/ε² at the start of a run, at every ε."""
    return -initial_state(beta, nu, fmpq(1))[1].z


def y_is_below_z() -> bool:
    """Whether y is z - ε² λ_N: with z < 0 it is below -ε² λ_N, and tends to −∞ where λ_N tends to +∞."""
    z, lam = _SYMBOLS["z"], _SYMBOLS["lam"]
    return bool((ALGEBRA.substitute(ALGEBRA.read(FORCE), {"y": z - lam}) - lam).is_zero())


def surface_stays_below(beta: fmpq, nu: fmpq) -> bool | None:
    """Whether z < 0 as long as λ_N > 0: so it begins, and where z is 0 it falls."""
    at_zero = ALGEBRA.substitute(ALGEBRA.read(RATE_OF_Z), {"z": ALGEBRA.constant(0)})
    return depth(beta, nu) > 0 and rising_signs(-at_zero) and y_is_below_z()


def surface_by_an_integral(beta: fmpq, nu: fmpq) -> bool | None:
    """The same by e^(t/ε) z, which begins below 0 and has the rate -e^(t/ε) ε λ_N: ε z' + z is -ε² λ_N."""
    rate = ALGEBRA.read(RATE_OF_Z) + _SYMBOLS["z"]
    return depth(beta, nu) > 0 and (rate + _SYMBOLS["lam"]).is_zero() and y_is_below_z()


def with_the_depth(beta: fmpq, nu: fmpq, drawn: bool | None, below: Callable[[fmpq, fmpq], bool | None]) -> bool | None:
    """An answer on a fate, with that on y where the fate is an impact."""
    return all_of([drawn, below(beta, nu)]) if FATES[beta][nu] == IMPACT else drawn


def printed_fate(beta: fmpq, nu: fmpq) -> str:
    """The fate that lines 766 to 785 name: in panels (b) and (c) by the side of b(0), of which a larger ν has less."""
    if beta not in section_3.IMPACT["printed"]:
        return IMPACT
    side = (nu < 1) - (nu > 1)
    return TRIVIAL if side == 0 else IMPACT if side == section_3.IMPACT["printed"][beta] else LIFT_OFF


def how_named(beta: fmpq, nu: fmpq) -> str:
    """How the text says what a run does."""
    by_side = beta in section_3.IMPACT["printed"]
    if printed_fate(beta, nu) != FATES[beta][nu]:
        return "names the other fate for this run, by its side of b(0) (3-sides, where the sides are corrected)"
    if by_side and nu == 1:
        return "has the trivial solution between the two fates"
    if by_side:
        return "names this fate for this run, by its side of b(0)"
    return "names this fate for all initial conditions that become attracted to the G-spot"


def are_drawn(beta: fmpq, nu: fmpq, found: Sequence[str | None]) -> bool | None:
    """Whether these fates are that of the figure."""
    return all_of(None if fate is None else fate == FATES[beta][nu] for fate in found)


def _some_time(epsilon: fmpq) -> fmpq:
    """t = 2 ε^(2/3), for the ε of POINTS."""
    tens = len(str(int(1 / epsilon))) - 1
    return 2 * fmpq(1, 10 ** (2 * tens // 3))


def _entry(beta: fmpq, nu: fmpq, every: str, proof: Check) -> Entry:
    tried = [fate_at(beta, nu, epsilon) for epsilon in POINTS]
    return Section("Section 3").settled(
        identifier(beta, nu),
        "fig:varsim1",
        r"\text{dashed curves take an IWC, solid curves lift off}",
        f"Panel ({PANELS[beta]}), β = {beta}, ν = {nu}, in the compliant model from the initial values of the figure, "
        f"every {every}: {DRAWN[FATES[beta][nu]]}",
        proof,
        Rung.POINTS.check(
            f"{BY_AN_INTEGRAL if FATES[beta][nu] == IMPACT else ''}{AT_POINTS[FATES[beta][nu]]}, at ε = 10^-3, 10^-6, "
            "10^-12",
            with_the_depth(beta, nu, are_drawn(beta, nu, tried), surface_by_an_integral),
            "; ".join(FOUND[fate] for fate in tried),
        ),
        note=f"About the compliant model (modelsys1 to modelsys5) from these initial values, not the leading order. "
        f"The text {how_named(beta, nu)}.",
    )


def _run(beta: fmpq, nu: fmpq) -> Entry:
    every, fate = f"ε in (0, {EPSILON_0[beta]}]", proved_fate(beta, nu)
    finding = f"every {every}: {fate or 'open'}"
    what = "proofs/paper_runs.md, Theorem A', on all of the statement: its bounds in balls"
    what += BELOW if FATES[beta][nu] == IMPACT else ""
    agrees = with_the_depth(beta, nu, are_drawn(beta, nu, [fate]), surface_stays_below)
    return _entry(beta, nu, every, Rung.BALLS.check(what, agrees, finding))


def _trivial_run(beta: fmpq, nu: fmpq) -> Entry:
    fate = TRIVIAL if is_trivial(beta, nu) else None
    what = "modelsys2 to modelsys5 with ε and p as symbols: b/p, y, z and v keep their values"
    finding = f"every ε > 0: {fate or 'open'}"
    return _entry(beta, nu, "ε > 0", Rung.EXACT.check(what, are_drawn(beta, nu, [fate]), finding))


def identifier(beta: fmpq, nu: fmpq) -> str:
    """The identifier of the entry of one run."""
    return f"3-varsim1{PANELS[beta]}-{str(nu).replace('/', '_')}"


def _builders() -> dict[str, Callable[[], Entry]]:
    return {
        identifier(beta, nu): partial(_trivial_run if beta > 1 and nu == 1 else _run, beta, nu)
        for beta in PANELS
        for nu in FACTORS
    }


ENTRIES: Builders = _builders()
