"""How far the compliant motion is from rigid slip, and how large its fast part, for every epsilon up to one at once.

Proof page: ``proofs/from_own_state.md``, Theorem O. Every hypothesis on the numbers is compared here.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from flint import arb, arb_mat, fmpq

from gspot_verified.functions.box_program import BoxProgram
from gspot_verified.functions.expressions import Constant, Variable
from gspot_verified.mechanisms.approach.slip_flow import ClosedFlow
from gspot_verified.mechanisms.own_state.fast_norm import FastNorm
from gspot_verified.mechanisms.own_state.rigid_way import WayPart
from gspot_verified.numbers.balls import add_remainder, ball, ball_text
from gspot_verified.numbers.evidence import every, less
from gspot_verified.numbers.verdict import Evidence

_TRIES = 8  # of the radii of a box
_ROOM, _LARGER = 2, arb("1.5")  # of the radii, beside those before; any numbers are right
_NOTHING = arb(0)  # exact, made once


@dataclass(frozen=True)
class OwnStarts:
    """The starts: every component within ``beside`` epsilon of that of a state of rigid slip, the fast part at most
    ``share`` \\|b\\|."""

    beside: fmpq
    share: fmpq


@dataclass(frozen=True)
class CompliantTube:
    """For every epsilon in (0, ``epsilon``]: on the way contact lasts and the states lie in ``boxes``; at its end they
    lie in ``states``, p, b, y, v in ``place``, -b/p in ``force``, and sqrt(kappa p) \\|v\\|/epsilon, \\|b + p lambda\\|
    and g sqrt(p/l) \\|phi\\| are at most ``fast``."""

    epsilon: fmpq
    boxes: tuple[tuple[arb, ...], ...]
    states: tuple[arb, ...]
    place: tuple[arb, arb, arb, arb]
    force: arb
    fast: arb
    evidence: Evidence


class CompliantEquations:
    """The rates of (state, p, Lambda) in rigid slip, with their derivatives; Lambda = -b/p."""

    def __init__(self, flow: ClosedFlow) -> None:
        self.dimension = m = flow.dimension
        p, force = Variable(m), Variable(m + 1)
        slip = [f + g * force for f, g in zip(flow.F, flow.G, strict=True)]
        self._rates = BoxProgram(
            [*slip, flow.alpha_1, -(flow.alpha_2 + (flow.alpha_1 - flow.alpha_3) * force) / p], m + 2
        )
        self._place = BoxProgram([flow.p, -flow.b / flow.p], m)
        self._kick = BoxProgram([*(g / p for g in flow.G), Constant(fmpq(0)), flow.alpha_3 / (p * p)], m + 2)

    def place(self, states: Sequence[arb]) -> list[arb]:
        """The states with p and -b/p."""
        return [*states, *self._place.mean_values(list(states))]

    def slopes(self, states: Sequence[arb]) -> list[list[arb]]:
        """The derivatives of p and -b/p."""
        return self._place.gradients(list(states))[1]

    def rates(self, box: Sequence[arb]) -> tuple[list[arb], list[list[arb]]]:
        """The rates and their derivatives."""
        return self._rates.gradients(list(box))

    def kick(self, box: Sequence[arb]) -> tuple[list[arb], list[list[arb]]]:
        """What b + p lambda adds to the rates, over it, and its derivatives."""
        return self._kick.gradients(list(box))


def compliant_tube(
    equations: CompliantEquations,
    norm: FastNorm,
    start: Sequence[arb],
    way: Sequence[WayPart],
    starts: OwnStarts,
    epsilon: fmpq,
) -> CompliantTube | str:
    """Theorem O for rigid slip from every state of the box ``start``, ``way`` being its parts; or the inequality that
    fails.

    :raises ValueError: epsilon or a number of the starts is not positive, or there is no part.
    """
    if not (epsilon > 0 and starts.beside > 0 and starts.share > 0 and way):
        raise ValueError("epsilon, beside and share must be positive, and the way not empty")
    known: _Reached | str = _begun(equations, norm, start, starts, ball(epsilon))
    boxes, shown = list[tuple[arb, ...]](), list[Evidence]()
    for part in way:
        if isinstance(known, str):
            return known
        passed = _passed(equations, norm, part, known, ball(epsilon))
        if isinstance(passed, str):
            return passed
        known, box = passed
        boxes.append(tuple(box[: equations.dimension]))
        shown.append(known.evidence)
    if isinstance(known, str):
        return known
    at_end = [add_remainder(one, off) for one, off in zip(equations.place(way[-1].last), known.beside, strict=True)]
    shift = _shift(equations, norm, at_end, ball(epsilon))
    *states, p, force = at_end
    evidence = every(shown)
    if evidence is None:
        return "an inequality on the way is not certain"
    fast = (known.fast + shift).upper()
    place = _place(norm, p, force, fast, ball(epsilon))
    return CompliantTube(epsilon, tuple(boxes), tuple(states), place, force, fast, evidence)


def _place(norm: FastNorm, p: arb, force: arb, fast: arb, epsilon: arb) -> tuple[arb, arb, arb, arb]:
    """p, b, y, v; (6) of the page."""
    kappa, rate, lag = (ball(value) for value in (norm.contact.kappa, norm.contact.rate, norm.contact.lag))
    speed, phi = fast / (kappa * p).sqrt(), fast * (lag / p).sqrt() / rate
    height = (phi + force + fast / p + lag / rate * speed) / kappa
    return p, -force * p, add_remainder(_NOTHING, epsilon**2 * height), add_remainder(_NOTHING, epsilon * speed)


@dataclass(frozen=True)
class _Reached:
    """At the end of a part: bounds of eta and of the distance from rigid slip, E, Q, and what \\|X\\| is at most."""

    off: list[arb]
    beside: list[arb]
    first: arb
    decayed: arb
    driven: arb
    fast: arb
    evidence: Evidence


def _begun(
    equations: CompliantEquations, norm: FastNorm, start: Sequence[arb], starts: OwnStarts, epsilon: arb
) -> _Reached | str:
    """At the beginning."""
    beside = ball(starts.beside) * epsilon
    states = [add_remainder(one, beside) for one in start]
    box = equations.place(states)
    *_, p, force = box
    decay = norm.decay(p)
    if decay is None:
        return f"the norm of the fast part does not certainly fall at p = {_shown(p)}"
    off = [beside.upper()] * len(states)
    off += [(beside * sum(map(abs, row), _NOTHING)).upper() for row in equations.slopes(states)]
    fast = ball(starts.share) * p * force
    speed = epsilon * fast / (ball(norm.contact.kappa) * p).sqrt()
    eta = [(one + speed * abs(kick)).upper() for one, kick in zip(off, equations.kick(box)[0], strict=True)]
    first = ((1 + decay.tilt).sqrt() * (fast + _shift(equations, norm, box, epsilon))).upper()
    return _Reached(eta, off, first, _NOTHING, _NOTHING, first, decay.evidence)


def _shift(equations: CompliantEquations, norm: FastNorm, box: Sequence[arb], epsilon: arb) -> arb:
    """sqrt(kappa p) times the distance epsilon rho/(kappa p) of the force's equilibrium from V = 0."""
    values, _ = equations.rates(box)
    kappa, p = ball(norm.contact.kappa), box[equations.dimension]
    return (epsilon * abs(values[-1]) * (p / kappa).sqrt()).upper()


def _passed(
    equations: CompliantEquations, norm: FastNorm, part: WayPart, before: _Reached, epsilon: arb
) -> tuple[_Reached, list[arb]] | str:
    """At the end of the next part, and a box of the state, p and Lambda on it."""
    rigid, time = equations.place(part.states), part.duration
    radii = [_ROOM * one for one in before.beside]
    for _ in range(_TRIES):
        box = [add_remainder(one, radius) for one, radius in zip(rigid, radii, strict=True)]
        fast = _fast(equations, norm, box, before, time, epsilon)
        if isinstance(fast, str):
            return fast
        reached, ends, largest = _moved(equations, box, before, fast, time)
        inside = every(less(one, radius) for one, radius in zip(largest, radii, strict=True))
        shown = every([fast.evidence, less(0, time), inside])
        if shown is not None:
            return _Reached(reached, ends, before.first, fast.decayed, fast.driven, fast.last, shown), box
        radii = [(one * _LARGER).upper() for one in largest]
    return f"the distance from rigid slip is not certainly bounded at p = {_shown(rigid[equations.dimension])}"


@dataclass(frozen=True)
class _Fast:
    """Bounds on a part: the integral of \\|v\\|, \\|v\\| on it and at its end, \\|W\\| on it, \\|X\\| at its end."""

    travelled: arb
    speed: arb
    last_speed: arb
    push: arb
    last: arb
    decayed: arb
    driven: arb
    evidence: Evidence


def _fast(
    equations: CompliantEquations, norm: FastNorm, box: Sequence[arb], before: _Reached, time: arb, epsilon: arb
) -> _Fast | str:
    """(3), (5) of the page, on a box."""
    *_, p, force = box
    where = f"at p = {_shown(p)}, Lambda = {_shown(force)}"
    decay, kappa = norm.decay(p), ball(norm.contact.kappa)
    if decay is None:
        return f"the norm of the fast part does not certainly fall {where}"
    values, rows = equations.rates(box)
    kicks, _ = equations.kick(box)
    slope, first = rows[-1], values[-2]
    turn = abs(sum((a * k for a, k in zip(slope, kicks, strict=True)), _NOTHING)) * p
    drive = abs(sum((a * b for a, b in zip(slope, values, strict=True)), _NOTHING)) * (p / kappa).sqrt()
    tilt = decay.tilt
    spread = (abs(first) / (2 * p)).max(abs(slope[-1])) + epsilon * turn / (kappa * p).sqrt()
    growth = ((1 + tilt) * spread + tilt * abs(first) / (4 * p)) / (1 - tilt)
    rate = decay.rate / 2
    driven = before.driven.max((drive / rate).upper())
    share = 1 / (1 - tilt).sqrt()
    left = before.first * (-before.decayed / epsilon).exp()
    largest = share * (left + epsilon**2 * driven)
    conditions = {
        f"epsilon times the growth {_shown(growth)} of the fast part is less than its decay {_shown(rate)}": less(
            epsilon * growth, rate
        ),
        f"contact: |b + p lambda| <= {_shown(largest)} is less than {_shown(p * force)}": less(largest, p * force),
    }
    failed = [name for name, shown in conditions.items() if shown is None]
    evidence = every([decay.evidence, *conditions.values()])
    if evidence is None:
        return f"not certain {where}: " + "; ".join(failed)
    decayed = (before.decayed + rate * time).lower()
    last = share * (before.first * (-decayed / epsilon).exp() + epsilon**2 * driven)
    per, still = epsilon / (kappa * p).sqrt(), epsilon**2 * abs(values[-1]) / kappa
    travelled = per * share * (left * (epsilon / rate).min(time.upper()) + epsilon**2 * driven * time) + still * time
    return _Fast(
        travelled=travelled.upper(),
        speed=(per * largest + still).upper(),
        last_speed=(per * last + still).upper(),
        push=largest.upper(),
        last=last.upper(),
        decayed=decayed,
        driven=driven,
        evidence=evidence,
    )


def _moved(
    equations: CompliantEquations, box: Sequence[arb], before: _Reached, fast: _Fast, time: arb
) -> tuple[list[arb], list[arb], list[arb]]:
    """Bounds of eta and of the distance at the end of the part, and of the distance on the whole part; (5), (6)."""
    values, rows = equations.rates(box)
    kick, turns = equations.kick(box)
    slopes, change, column = arb_mat(rows), arb_mat(turns), arb_mat([[one] for one in kick])
    drift = slopes * column - change * arb_mat([[one] for one in values])
    drift -= change * column * add_remainder(_NOTHING, fast.push)
    size = len(box)
    growth = arb_mat(
        [[(entry if i == j else abs(entry)).upper() for j, entry in enumerate(row)] for i, row in enumerate(rows)]
    )
    upwards = arb_mat(size, size, [entry.max(_NOTHING) for entry in growth.entries()])
    eta = arb_mat([[one] for one in before.off])
    push = arb_mat([[(abs(one) * fast.travelled).upper()] for one in drift.entries()])
    whole = (upwards * time).exp()
    end = [one.upper() for one in ((growth * time).exp() * eta + whole * push).entries()]
    largest = (whole * (eta + push)).entries()
    return (
        end,
        [(one + fast.last_speed * abs(by)).upper() for one, by in zip(end, kick, strict=True)],
        [(one + fast.speed * abs(by)).upper() for one, by in zip(largest, kick, strict=True)],
    )


def _shown(value: arb) -> str:
    return ball_text(value, 4)
