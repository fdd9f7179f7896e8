"""Rigid slip from states of random bodies: where it ends, when, in which state, C_1 and the side at a G-spot. Surfaces
whose velocity makes slip end with lift-off, starts next to an event."""

from __future__ import annotations

from fractions import Fraction
from random import Random
from typing import Any

import mpmath
import sympy
from attack.answers import AGREED, Answer, Attack, undecided, wrong
from attack.balls_as_numbers import exactly
from attack.mechanisms import body, case_of, drawn_body, file_of
from attack.reference_slip import End, Slip, Unsure
from flint import arb

from gspot_verified import Outcome
from gspot_verified.mechanisms.approach.approach import Approach, approach
from gspot_verified.mechanisms.input.file import parse_mechanism
from gspot_verified.mechanisms.input.mechanism import MechanismError

_OFF = 1e-6
_TRIES = 60


def attack(random: Random) -> Attack:
    """A body, and a state of slip at which p > 0 > b, if one was found."""
    values, slip = drawn_body(random)
    if random.random() < 0.5:
        values["mu"] += 1
    text = file_of(values, slip)
    seed = random.getrandbits(32)
    kind, near = random.random(), Fraction(random.choice((-1, 1)), 10 ** random.choice((2, 9, 30)))

    def ask() -> Answer:
        flow, states = Slip(body(values)), Random(seed)
        state = next((s for s in (_state(states) for _ in range(_TRIES)) if _slips(flow, s)), None)
        if state is None:
            return undecided("no state of slip among those tried")
        try:
            end, surface = _reference(flow, state, kind, near)
        except Unsure as why:
            end, surface = why, None
        try:
            found = approach(parse_mechanism(text), state, surface_velocity=surface)
        except MechanismError as error:
            return undecided(f"{type(error).__name__}: {str(error)[:40]}")
        return undecided(f"the reference: {end}") if isinstance(end, Unsure) else judged(found, end, state, surface)

    return Attack(f"approach of '''{text}''', states {seed}, kind {kind}, {near}", ask)


def _state(random: Random) -> dict[str, Fraction]:
    """All but H and H_dot, which y = 0 and v = 0 give."""
    parts = {"X_dot": (-8, 24), "th": (-24, 24), "th_dot": (-16, 16)}
    return {"X": Fraction(0), **{name: Fraction(random.randint(*ends), 8) for name, ends in parts.items()}}


def _start(flow: Slip, state: dict[str, Fraction]) -> list[float]:
    """H and H_dot from y = v = 0: both stand alone in them."""
    q = {str(c): float(state.get(str(c), 0)) for c in (*flow.body.coordinates, *flow.body.velocities)}
    y, v, *_ = flow.place(*q.values())
    return list({**q, "H": -y, "H_dot": -v}.values())


def _slips(flow: Slip, state: dict[str, Fraction]) -> bool:
    _, _, (p, b, *_) = flow.at(_start(flow, state))
    return p > 1e-3 and b < -1e-3


def _reference(flow: Slip, state: dict[str, Fraction], kind: float, near: Fraction) -> tuple[End, Fraction | None]:
    """The end of slip; sometimes with a surface that makes slip end near another event."""
    u = flow.at(_start(flow, state))[2][2]
    if kind < 0.5:
        surface = None if u > 0 else Fraction(round(8 * u) - 8, 8)
        return flow.ended(_start(flow, state), 0.0 if u > 0 else float(surface or 0)), surface
    free = flow.ended(_start(flow, state), None)
    last = Fraction(flow.at(free.state)[2][2]).limit_denominator(10**9) + near
    return flow.ended(_start(flow, state), float(last)), last


def judged(found: Approach, end: End, state: dict[str, Fraction], surface: Fraction | None) -> Answer:
    """The package's end beside the reference's."""
    given = {name: str(value) for name, value in state.items()}
    shown = f"from {given} with the surface {surface}: {found}\n  reference: {end}"
    if found.end is None:
        return undecided(f"{found.verdict.detail[:60]}")
    if found.verdict.outcome is not Outcome.PROVED:
        return wrong(f"an end that is not proved\n{shown}")
    if found.end != end.what:
        return wrong(f"{found.end} where the reference has {end.what}\n{shown}")
    if not _holds(found.time, end.time):
        return wrong(f"the time\n{shown}")
    order = dict(zip(("X", "H", "th", "X_dot", "H_dot", "th_dot"), end.state, strict=True))
    if any(not _holds(arb(text), order[word]) for word, text in found.place):
        return wrong(f"the place\n{shown}")
    return _spot(found, end, shown) if found.end == "G-spot" else AGREED


def _spot(found: Approach, end: End, shown: str) -> Answer:
    assert found.alphas is not None
    if any(not _holds(ball, value, 1e-5) for ball, value in zip(found.alphas, end.alphas, strict=True)):
        return wrong(f"the alphas\n{shown}")
    case = case_of(*map(mpmath.mpf, end.alphas))
    if found.case is not None and found.case != case:
        return wrong(f"Case {found.case}, the reference {case}\n{shown}")
    if end.coefficient is None or found.coefficient is None:
        return AGREED if found.side is None else undecided("the reference does not know C_1")
    if not _holds(found.coefficient, end.coefficient, 0.1):
        return wrong(f"C_1\n{shown}")
    beta = end.alphas[2] / end.alphas[0]
    gamma = float(sympy.sign(1 / sympy.gamma(-beta)))
    side = "lift-off" if case == "III" and end.coefficient * gamma < 0 else "impact without collision"
    if found.side is not None and found.side != side:
        return wrong(f"the side\n{shown}")
    return AGREED


def _holds(ball: Any, value: float, off: float = _OFF) -> bool:
    if ball is None or not ball.is_finite():
        return False
    middle, radius = exactly(ball.mid()), exactly(ball.rad())
    return bool(abs(middle - value) <= radius + off * (1 + abs(value)))
