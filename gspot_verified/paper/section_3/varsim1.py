"""Ledger of Fig. varsim1: what each of the fifteen runs does in the compliant model, for every epsilon <= epsilon_0."""

from __future__ import annotations

from collections.abc import Callable
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
from gspot_verified.paper.checks.entry import Builders, Check, Entry, Rung, all_of, settled
from gspot_verified.paper.numerics.paper_runs import START, fate_by_side, margin_up_to

PANELS = {fmpq(1, 2): "a", fmpq(3, 2): "b", fmpq(5, 2): "c"}
FACTORS = (fmpq(1, 4), fmpq(1, 2), fmpq(1), fmpq(2), fmpq(4))
"""The simulated ν; b(0) = -ν |λ_N on the trivial solution|/2."""
EPSILON_0 = {fmpq(1, 2): fmpq(1, 100), fmpq(3, 2): fmpq(1, 100), fmpq(5, 2): fmpq(1, 500)}
"""By β: the proof reaches every ε up to here, for all five runs."""
POINTS = (fmpq(1, 1000), fmpq(1, 10**6), fmpq(1, 10**12))
DRAWN = {
    "impact": "contact lasts for ever with λ_N > 0, and λ_N → +∞: an impact without collision",
    "lift-off": "λ_N > 0 until after the G-spot, and then contact is lost",
    "trivial": "the trivial solution: λ_N is its constant for ever",
}


def initial_state(beta: fmpq, nu: fmpq, epsilon: fmpq) -> tuple[CompliantModel, CompliantState]:
    """p = 1/2, b = -ν |mean force| p, z = y/2, v = 0, y = 2 b ε²/p; α_1 = α_2 = -1."""
    model = compliant_model(beta, epsilon)
    b = -nu * START * abs(model.mean_force)
    y = 2 * b * epsilon**2 / START
    return model, compliant_state(START, b, y, 0, y / 2)


def expected(beta: fmpq, nu: fmpq) -> str:
    """The fate in the figure, as the exact side rule orders it."""
    return "trivial" if beta > 1 and nu == 1 else fate_by_side(beta, nu)


def for_every_epsilon(beta: fmpq, nu: fmpq) -> bool | None:
    """Whether Theorem A' gives the fate for every ε <= ε_0."""
    if expected(beta, nu) == "trivial":
        return _is_trivial(beta, nu)
    margin = margin_up_to(beta, nu, EPSILON_0[beta])
    return True if margin is not None and margin > 0 else None


def _is_trivial(beta: fmpq, nu: fmpq) -> bool:
    """The deviation of the state is 0: its terms do not depend on ε once y and z are divided by ε²."""
    hats = [deviation(*initial_state(beta, nu, small)) for small in POINTS]
    return all(value == 0 for hat in hats for value in (hat.b, hat.V, hat.Y, hat.Z))


def at_points(beta: fmpq, nu: fmpq) -> bool | None:
    """The same at three ε, by the sign of K and by intervals: the lift-off in a bracket, or λ_N > 0 up to τ = 2."""
    answers: list[bool | None] = []
    for small in POINTS:
        model, state = initial_state(beta, nu, small)
        if expected(beta, nu) == "trivial":
            lasts = contact_lasts(model, state, _some_time(small))
            answers.append(True if lasts.outcome is Outcome.PROVED else None)
            continue
        side = side_rule(model, state).side
        if expected(beta, nu) == "impact":
            lasts = contact_lasts(model, state, _some_time(small))
            answers += [False if side < 0 else True if side > 0 else None, lasts.outcome is Outcome.PROVED or None]
        else:
            lift_off = first_zero(model, state, digits=6)
            answers.append(True if side < 0 else False if side > 0 else None)
            answers.append(None if lift_off.lower is None else lift_off.lower > 0)
    return all_of(answers)


def _some_time(epsilon: fmpq) -> fmpq:
    """A time t > 0 with τ = (ε/2)^(1/3) t/ε near 2: ε^(2/3) rounded for the ε of POINTS."""
    tens = len(str(int(1 / epsilon))) - 1
    return 2 * fmpq(1, 10 ** (2 * tens // 3))


def _run(beta: fmpq, nu: fmpq) -> Entry:
    fate = expected(beta, nu)
    every = "ε > 0" if fate == "trivial" else f"ε in (0, {EPSILON_0[beta]}]"
    rung = Rung.EXACT if fate == "trivial" else Rung.BALLS
    what = "the deviation from the trivial solution is 0" if fate == "trivial" else "proofs/paper_runs.md, Theorem A'"
    return settled(
        "Section 3",
        identifier(beta, nu),
        "fig:varsim1",
        r"\text{dashed curves take an IWC, solid curves lift off}",
        f"Panel ({PANELS[beta]}), β = {beta}, ν = {nu}, in the compliant model from the initial values of the figure, "
        f"every {every}: {DRAWN[fate]}",
        Check(rung, what, for_every_epsilon(beta, nu), f"every {every}"),
        Check(Rung.POINTS, "the sign of K and intervals at ε = 10^-3, 10^-6, 10^-12", at_points(beta, nu)),
        note="About the compliant model (modelsys1 to modelsys5) from these initial values, not the leading order.",
    )


def identifier(beta: fmpq, nu: fmpq) -> str:
    """The identifier of the entry of one run."""
    return f"3-varsim1{PANELS[beta]}-{str(nu).replace('/', '_')}"


def _builders() -> dict[str, Callable[[], Entry]]:
    return {identifier(beta, nu): partial(_run, beta, nu) for beta in PANELS for nu in FACTORS}


ENTRIES: Builders = _builders()
