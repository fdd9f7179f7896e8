"""Ledger of Sec. 3: runs of the extended system in which an impact without collision ends in lift-off, in slip."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import lru_cache
from itertools import groupby, pairwise

from flint import arb, fmpq

from gspot_verified.numbers.balls import approximate, ball_text, certainly_less, hull, sign_of, working_bits
from gspot_verified.paper.checks.entry import Builders, Entry, Rung, Section, all_of
from gspot_verified.paper.section_3.varsim2 import (
    BETA,
    EPSILON,
    LIFT_OFF,
    SCENE,
    happens,
    has_no_slip_velocity,
    slip_slows_down,
)
from gspot_verified.scenes.certified_run import INTEGRATOR, certified_run
from gspot_verified.scenes.floats.float_run import float_run
from gspot_verified.scenes.scene.file import load_scene
from gspot_verified.scenes.scene.run import SceneRun
from gspot_verified.scenes.scene.samples import Boxes, Samples
from gspot_verified.scenes.scene.scene import Scene

Box = dict[str, arb]
CHI, ALPHA_1 = 1, -1
LOST = {fmpq(1, 4): (fmpq(70), fmpq(25)), fmpq(4): (fmpq(200), fmpq(77))}
"""By ν: u(0) of the run, and a bound of the slip velocity that is lost up to lift-off."""
RATES: dict[str, tuple[int, Callable[[Box], arb]]] = {
    "p": (-1, lambda at: ALPHA_1 + CHI * at["b"]),
    "v": (-1, lambda at: at["b"] + at["p"] * at["lambda_N"]),
    "lambda_N": (1, lambda at: -at["z"] / EPSILON - EPSILON * at["lambda_N"] - at["v"]),
    "y": (-1, lambda at: at["v"]),
}
"""What turns, in the order of the turns: the sign of its rate before, and the rate in slip, that of λ_N times ε²."""
AT_SPOT = {"b": (fmpq(-3), fmpq(0)), "v": (fmpq(-1, 40), fmpq(0)), "lambda_N": (fmpq(0), fmpq(140))}
"""Bounds where p falls through 0."""
PEAK = fmpq(1000)
"""λ_N gets above it."""
FLOAT_NEAR = fmpq(1, 2000)
"""Twice the step of the float samples."""
_FLOATS = ("LSODA", 1e-10, 4001)
_SLIP = "slip"
_BITS = 64
_WORDS = {"p": "p", "v": "v", "lambda_N": "λ_N", "y": "y"}


def scene_of(nu: fmpq) -> Scene:
    """The extended system with this ν and its u(0)."""
    return load_scene(SCENE, chi=CHI, nu=nu, u=LOST[nu][0], beta=BETA, epsilon=EPSILON)


@lru_cache(maxsize=2)
def run_of(nu: fmpq) -> SceneRun:
    """The certified run by the integrator, with boxes that leave no gap in time."""
    return certified_run(scene_of(nu), 12, INTEGRATOR, points=2)


def rows_of_slip(phases: Sequence[str]) -> int:
    """How many rows there are before the first one of another phase."""
    return next((k for k, phase in enumerate(phases) if phase != _SLIP), len(phases))


def slip_boxes(boxes: Boxes) -> list[Box]:
    """The boxes up to lift-off."""
    with working_bits(_BITS):
        return [
            {name: hull([arb(boxes.lower[name][k]), arb(boxes.upper[name][k])]) for name in boxes.lower}
            for k in range(rows_of_slip(boxes.phases))
        ]


def one_turn(signs: Sequence[int | None], before: int) -> bool | None:
    """Whether these signs are ``before`` and then the other one, with unknown ones between the two alone."""
    known = [sign for sign in signs if sign is not None]
    if known != sorted(known, key=lambda sign: sign != before):
        return False
    whole = [sign for sign, _ in groupby(signs)]
    if whole in ([before, -before], [before, None, -before]):
        return True
    return None if None in whole or not whole else False


def turns(boxes: Sequence[Box]) -> dict[str, tuple[bool | None, arb]]:
    """By name: whether the rate has its one turn in these boxes, and a ball around the time of it; {} for no boxes."""
    found = {}
    for name, (before, rate) in RATES.items() if boxes else ():
        signs = [sign_of(rate(at)) for at in boxes]
        last = max((k for k, sign in enumerate(signs) if sign == before), default=0)
        first = min((k for k, sign in enumerate(signs) if sign == -before), default=len(signs) - 1)
        found[name] = (one_turn(signs, before), hull([boxes[last]["t"], boxes[first]["t"]]))
    return found


def from_the_spot(boxes: Sequence[Box]) -> Sequence[Box]:
    """The boxes from the first one on in which p may be 0."""
    return boxes[next((k for k, at in enumerate(boxes) if sign_of(at["p"]) != 1), len(boxes)) :]


def as_claimed(boxes: Sequence[Box], lost: fmpq) -> bool | None:
    """Whether the boxes of slip show how the impact begins at the G-spot and how it ends."""
    later = from_the_spot(boxes)
    beyond = next((k for k, at in enumerate(later) if sign_of(at["p"]) == -1), None)
    if beyond is None:
        return None
    with working_bits(_BITS):
        spot = later[: beyond + 1]
        answers = [certainly_less(arb(low), at[name]) for at in spot for name, (low, _) in AT_SPOT.items()]
        answers += [certainly_less(at[name], arb(high)) for at in spot for name, (_, high) in AT_SPOT.items()]
        below = {certainly_less(at["lambda_N"], arb(PEAK)) for at in boxes}
        answers.append(True if False in below else None if None in below else False)
        answers += [certainly_less(boxes[0]["u"] - lost, boxes[-1]["u"]), certainly_less(arb(0), boxes[-1]["u"])]
        found = list(turns(later).values())
        answers += [answer for answer, _ in found]
        answers += [certainly_less(time, later) for (_, time), (_, later) in pairwise(found)]
        return all_of(answers)


def boxes_of(nu: fmpq) -> list[Box]:
    """The boxes of slip of the certified run; none where it has no boxes."""
    samples = run_of(nu).samples
    return [] if samples is None or samples.boxes is None else slip_boxes(samples.boxes)


def is_shown(nu: fmpq) -> bool | None:
    """Whether the certified run lifts off as its only event, and its boxes are as claimed."""
    return all_of([happens(run_of(nu), (LIFT_OFF,)), as_claimed(boxes_of(nu), LOST[nu][1])])


def extremes(samples: Samples) -> dict[str, fmpq]:
    """The times up to lift-off at which the samples have the least p, v and y and the largest λ_N."""
    end = rows_of_slip(samples.phases)
    times = samples.columns["t"][:end]
    places = {name: (before * samples.columns[name][:end]).argmax() for name, (before, _) in RATES.items()}
    return {name: fmpq(*float(times[place]).as_integer_ratio()) for name, place in places.items()}


def as_sampled(samples: Samples, lost: fmpq) -> bool:
    """Whether the samples have the extremes in the order of RATES, a force above PEAK, and lose less slip than this."""
    end = rows_of_slip(samples.phases)
    times = list(extremes(samples).values())
    force, slip = (samples.columns[name][:end] for name in ("lambda_N", "u"))
    return times == sorted(times) and bool(force.max() > float(PEAK)) and bool(slip[0] - float(lost) < slip[-1])


def floats_agree(nu: fmpq) -> bool | None:
    """Whether a float run lifts off alone, and has its extremes within FLOAT_NEAR of the certified turns."""
    run, found = float_run(scene_of(nu), *_FLOATS), turns(from_the_spot(boxes_of(nu)))
    if run.samples is None or not found:
        return None
    seen = extremes(run.samples)
    with working_bits(_BITS):
        near = [certainly_less(abs(found[name][1] - arb(seen[name])), arb(FLOAT_NEAR)) for name in found]
    alone = [event.name for event in run.events] == [LIFT_OFF]
    return all_of([alone, as_sampled(run.samples, LOST[nu][1]), *near])


def _told(nu: fmpq) -> str:
    boxes = boxes_of(nu)
    with working_bits(_BITS):
        found = turns(from_the_spot(boxes)).items()
        times = ", ".join(f"{_WORDS[name]} {approximate(time):.5g}" for name, (_, time) in found)
        return (
            f"ν = {nu}: turns at t = {times}; lift-off with u = {', '.join(ball_text(at['u'], 8) for at in boxes[-1:])}"
        )


def _impact_to_lift_off() -> Entry:
    starts = ", and ".join(f"ν = {nu} with u(0) = {first}" for nu, (first, _) in LOST.items())
    losses = ", ".join(f"less than {lost} for ν = {nu}" for nu, (_, lost) in LOST.items())
    (b_least, _), (v_least, _), (_, most) = AT_SPOT["b"], AT_SPOT["v"], AT_SPOT["lambda_N"]
    return Section("Section 3").settled(
        "3-impact-to-lift-off",
        "lines 937 to 940",
        r"p,\ v\ \text{and}\ y\ \text{all begin to increase before the contact sticks: the impact will terminate}",
        f"χ = {CHI}, ε = {EPSILON}, β = {BETA}, {starts}: an impact without collision begins and ends in lift-off, "
        f"in slip. Contact lasts from the start until p = 0, where {b_least} < b < 0, {v_least} < v < 0 and 0 < λ_N "
        f"< {most}, and beyond; from there on p, v and y fall first and λ_N grows, to more than {PEAK}; p, v, λ_N "
        "and y turn in this order, each once up to lift-off: p, v and y rise then. The slip velocity that is lost up "
        f"to lift-off ({losses}) does not depend on u(0), where u(0) is larger than it: lift-off can come at every "
        "share of the slip velocity at p = 0 strictly between none and all of it",
        Rung.BALLS.check(
            "certified runs by the validated integrator, lift-off the only event: the signs of the rates of p, v, y "
            "and λ_N in boxes that enclose all of the motion in slip; eqs. udot, newex1 to newex5 in slip, derived by "
            "u: no rate has u, so another u(0) changes u alone, by as much, as long as u > 0; u falls as λ_N > 0",
            all_of([*map(is_shown, LOST), has_no_slip_velocity(), slip_slows_down()]),
            "; ".join(map(_told, LOST)),
        ),
        Rung.POINTS.check(
            f"float runs ({_FLOATS[0]}) lift off alone, after the loss and with the force that are stated; p, v, y "
            f"have their least and λ_N its largest value in this order, within {FLOAT_NEAR} of these times",
            all_of(map(floats_agree, LOST)),
        ),
        note="What the impact leads to at other ν and ε is not stated here. For χ = 0 it goes on until the contact "
        "sticks (3-impact-to-stick).",
    )


ENTRIES: Builders = {"3-impact-to-lift-off": _impact_to_lift_off}
"""How an impact without collision can end."""
