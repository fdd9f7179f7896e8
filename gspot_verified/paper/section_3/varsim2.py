"""Ledger of Fig. varsim2: the four runs of the extended system, with tangential motion and stick."""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import lru_cache, partial

from flint import arb, fmpq

from gspot_verified.compliant.model.normal_form import compliant_model
from gspot_verified.compliant.motion.compliant_force import force
from gspot_verified.numbers.balls import approximate, ball_text, sign_of, working_bits
from gspot_verified.numbers.verdict import Outcome
from gspot_verified.paper.checks.entry import Builders, Check, Entry, Rung, Section, all_of
from gspot_verified.paper.checks.identities import Algebra, rising_signs
from gspot_verified.paper.numerics.paper_state import START, paper_state
from gspot_verified.scenes.certified_run import INTEGRATOR, certified_run
from gspot_verified.scenes.floats.float_run import float_run
from gspot_verified.scenes.scene.file import load_scene
from gspot_verified.scenes.scene.run import IMPACT, SceneRun

SECTION = Section("Section 3")
STICK, LIFT_OFF = "stick", "lift-off"
SCENE = "fig-varsim2"
FIRST_SLIP = fmpq(70)
BETA, EPSILON = fmpq(1, 2), fmpq(1, 1000)
RUNS: dict[tuple[int, fmpq], tuple[str, ...]] = {
    (0, fmpq(1, 4)): (IMPACT, STICK, LIFT_OFF),
    (0, fmpq(4)): (IMPACT, STICK, LIFT_OFF),
    (1, fmpq(1, 4)): (LIFT_OFF,),
    (1, fmpq(4)): (STICK, LIFT_OFF),
}
"""By χ and ν: the events of the figure, with the impact without collision where it is a statement. χ = 0 sticks before
it lifts off (lines 933 to 935); of the four one lifts off without stick (caption): the text does not say which."""
WITHOUT_STICK = 1
"""In so many of the four cases lift-off comes without stick."""
FASTER = (fmpq(200), fmpq(1000))
"""Initial slip velocities that are "large enough" for ν = 4, too."""
ALGEBRA = Algebra("u p b y v z lam alpha1 alpha2 alpha3 chi")
SLIP = {
    "u": "-lam", "p": "alpha1 + chi*b", "b": "alpha2 - alpha3*lam", "y": "v", "v": "b + p*lam", "z": "-z - (z - y)",
    "lam": "z - y",
}  # fmt: skip
"""The rates of udot and newex1 to newex5 in slip with the constants of newex6, that of z times ε; last ε² λ_N."""
AT_SPOT = START
"""The time after the start at which p = 0 for χ = 0: p falls from START at the rate 1."""
_NEAR = fmpq(1, 10**9)
_FLOAT_NEAR = fmpq(1, 10**4)
_DIGITS, _BITS = 20, 128
_FLOATS = ("LSODA", 1e-10)


@lru_cache(maxsize=16)
def run_of(chi: int, nu: fmpq, slip: fmpq | None = None) -> SceneRun:
    """The certified run of the extended system by the integrator; u(0) = 70 where no other is given."""
    first = FIRST_SLIP if slip is None else slip
    return certified_run(load_scene(SCENE, chi=chi, nu=nu, u=first, beta=BETA, epsilon=EPSILON), 12, INTEGRATOR)


def names_of(run: SceneRun) -> tuple[str, ...]:
    """The events of a run in order."""
    return tuple(event.name for event in run.events)


def happens(run: SceneRun, events: tuple[str, ...]) -> bool | None:
    """Whether a certified run has these events in this order and no other one up to its end."""
    return names_of(run) == events if run.verdict.outcome is Outcome.PROVED else None


def grows_after_the_spot(nu: fmpq) -> bool | None:
    """Whether for χ = 0 λ_N is seen to grow, after p = 0 and for as long as it slips: not up to a multiple alone."""
    run = run_of(0, nu)
    begins = [event.lower for event in run.events if event.name == IMPACT]
    if run.verdict.outcome is not Outcome.PROVED or len(begins) != 1:
        return None
    until_slip_ends = re.match(
        rf"{re.escape(run.fate)} \(λ_N grows at least like exp\(\S+ t/ε\) for as long as the contact slips",
        run.verdict.statement,
    )
    return (begins[0] > AT_SPOT and until_slip_ends is not None) or None


def slip_velocity(nu: fmpq, time: fmpq) -> arb:
    """u at a time after the start for χ = 0, in slip: du/dt = -λ, db/dt = α_2 + β λ, so λ need not be integrated."""
    model = compliant_model(BETA, EPSILON)
    state = paper_state(model, nu)
    there = force(model, state, state.p / model.alpha_1 + time, _DIGITS)
    with working_bits(_BITS):
        return FIRST_SLIP - (there.b - state.b - model.alpha_2 * time) / BETA


def sticks_first(nu: fmpq) -> bool | None:
    """Whether stick is the first change of phase that is claimed, and the exact solution has it there."""
    claimed = [name for name in RUNS[0, nu] if name != IMPACT]
    found = sticks_by_the_exact_solution(nu)
    return claimed[:1] == [STICK] if found is True else found


def sticks_by_the_exact_solution(nu: fmpq) -> bool | None:
    """Whether u falls through 0 within 10^-9 of the integrator's stick, by the exact solution of the slip phase."""
    found = [event for event in run_of(0, nu).events if event.name == STICK]
    if len(found) != 1:
        return None
    before, after = (slip_velocity(nu, time) for time in (found[0].lower - _NEAR, found[0].upper + _NEAR))
    if sign_of(before) is None or sign_of(after) is None:
        return None
    return sign_of(before) == 1 and sign_of(after) == -1


def floats_agree(chi: int, nu: fmpq) -> bool | None:
    """Whether a float run has the events of the figure, within 10^-4 of the certified times."""
    run = run_of(chi, nu)
    seen = float_run(load_scene(SCENE, chi=chi, nu=nu, u=FIRST_SLIP, beta=BETA, epsilon=EPSILON), *_FLOATS).events
    expected = [name for name in RUNS[chi, nu] if name != IMPACT]
    certified = [event for event in run.events if event.name != IMPACT]
    if [event.name for event in seen] != expected or len(certified) != len(seen):
        return False
    return all(abs(a.lower - b.lower) < _FLOAT_NEAR for a, b in zip(seen, certified, strict=True))


def _times(run: SceneRun) -> str:
    return ", ".join(event.rounded(9) for event in run.events)


def _run(chi: int, nu: fmpq, second: Check, note: str) -> Entry:
    return SECTION.settled(
        identifier(chi, nu),
        "fig:varsim2",
        r"\text{squares: slip-stick transitions, circles: lift-off}",
        f"The run of fig. varsim2 with χ = {chi}, ν = {nu} (ε = {EPSILON}, β = {BETA}, u(0) = {FIRST_SLIP}) has up to "
        f"t = 1 these events in this order, and no other change of phase: {', '.join(RUNS[chi, nu])}",
        Rung.BALLS.check(
            "certified run of the extended system by the validated integrator",
            all_of([happens(run_of(chi, nu), RUNS[chi, nu]), *([grows_after_the_spot(nu)] if chi == 0 else [])]),
            _times(run_of(chi, nu)),
        ),
        second,
        note=f"ε is not in the caption: that of fig. varsim1. {note}".strip(),
    )


def _one_way(nu: fmpq) -> Entry:
    second = Rung.POINTS.check(
        f"a float run ({_FLOATS[0]}): the same events at these times; the exact solution of the slip phase: u falls "
        "through 0 within 10^-9 of that stick",
        all_of([floats_agree(0, nu), sticks_first(nu)]),
        f"u(0.1) = {ball_text(slip_velocity(nu, fmpq(1, 10)), 8)}",
    )
    return _run(
        0, nu, second, "The impact is listed where λ_N is proved to grow for as long as the contact slips, after p = 0."
    )


def _two_way(nu: fmpq) -> Entry:
    what = f"a float run ({_FLOATS[0]}): the same events at these times"
    note = "Whether an impact without collision begins before is not shown here."
    if RUNS[1, nu][:1] == (STICK,):
        note += (
            f" u(0) = {FIRST_SLIP} is not large enough for ν = {nu}: with {FASTER[0]} and more it lifts off and has "
        )
        note += "not stuck (3-large-slip)."
    return _run(1, nu, Rung.POINTS.check(what, floats_agree(1, nu)), note)


def identifier(chi: int, nu: fmpq) -> str:
    """The identifier of the entry of one run."""
    return f"3-varsim2-{chi}-{str(nu).replace('/', '_')}"


def lift_off_without_stick() -> list[tuple[int, fmpq]]:
    """The runs in which lift-off comes without stick before it."""
    found = []
    for chi, nu in RUNS:
        names = names_of(run_of(chi, nu))
        if LIFT_OFF in names and STICK not in names[: names.index(LIFT_OFF)]:
            found.append((chi, nu))
    return found


def all_proved() -> bool | None:
    """Whether the four runs are certified up to their end."""
    return all_of(run_of(chi, nu).verdict.outcome is Outcome.PROVED or None for chi, nu in RUNS)


def as_many(found: int) -> bool | None:
    """Whether this is the number in the caption, for certified runs."""
    return None if all_proved() is not True else found == WITHOUT_STICK


def _caption() -> Entry:
    found = lift_off_without_stick()
    drawn = [events for events in RUNS.values() if LIFT_OFF in events and STICK not in events]
    return SECTION.settled(
        "3-varsim2-caption",
        "lines 951 to 952",
        r"\text{liftoff occurs without slip-stick transition in one out of four cases}",
        f"Of the four runs with χ = 0 or 1, ν = 1/4 or 4, ε = {EPSILON}, β = {BETA} and u(0) = {FIRST_SLIP} there "
        "is exactly one in which the contact lifts off up to t = 1 and has not stuck before",
        Rung.BALLS.check(
            "the certified runs, counted", as_many(len(found)), ", ".join(f"χ = {chi}, ν = {nu}" for chi, nu in found)
        ),
        Rung.POINTS.check(
            "float runs have the events that were counted",
            all_of([*(floats_agree(chi, nu) for chi, nu in RUNS), len(drawn) == WITHOUT_STICK]),
        ),
    )


def _continues_to_stick() -> Entry:
    nus = sorted({nu for _, nu in RUNS})
    return SECTION.settled(
        "3-impact-to-stick",
        "lines 933 to 935",
        r"\chi=0:\ \text{the impact continues all the way until the contact sticks}",
        f"χ = 0, ν = 1/4 and 4, as in fig. varsim2 with ε = {EPSILON}: contact lasts from the start on until the "
        "contact sticks, and λ_N grows from some time after the G-spot on, as long as it slips",
        Rung.BALLS.check(
            "certified runs by the validated integrator: no event but the impact before the stick; the growth of λ_N "
            "is seen after p = 0, and not up to a multiple alone",
            all_of([*(happens(run_of(0, nu), RUNS[0, nu]) for nu in nus), *map(grows_after_the_spot, nus)]),
        ),
        Rung.BALLS.check(
            "the exact solution of the slip phase: u falls through 0 within 10^-9 of that stick",
            all_of(sticks_first(nu) for nu in nus),
        ),
    )


def has_no_slip_velocity() -> bool | None:
    """Whether u stands in no rate of slip, its own included."""
    return all(ALGEBRA.read(text).derivative("u").is_zero() for text in SLIP.values())


def slip_slows_down() -> bool | None:
    """Whether u falls in slip as long as there is a force: what is lost of it grows up to lift-off."""
    return rising_signs(-ALGEBRA.read(SLIP["u"]))


FAST = ((fmpq(1, 4), FIRST_SLIP), *((fmpq(4), slip) for slip in FASTER))
"""ν and u(0) of the runs in which slip is fast enough."""


def floats_lift_off(nu: fmpq, slip: fmpq) -> bool | None:
    """Whether a float run has a lift-off alone, within 10^-4 of the certified one."""
    seen = float_run(load_scene(SCENE, chi=1, nu=nu, u=slip, beta=BETA, epsilon=EPSILON), *_FLOATS).events
    certified = run_of(1, nu, slip).events
    if len(certified) != 1:
        return None
    return [event.name for event in seen] == [LIFT_OFF] and abs(seen[0].lower - certified[0].lower) < _FLOAT_NEAR


def _large_slip() -> Entry:
    stops = [event.lower for event in run_of(1, fmpq(4), FASTER[0]).events]
    again = [event.lower for event in run_of(1, fmpq(4), FASTER[1]).events]
    return SECTION.settled(
        "3-large-slip",
        "lines 937 to 940",
        r"\text{for large enough } u(0)\ \text{lift-off occurs before the contact sticks}",
        f"χ = 1, ε = {EPSILON}, β = {BETA}: for ν = 1/4 and every u(0) >= {FIRST_SLIP}, for ν = 4 and every u(0) >= "
        f"{FASTER[0]}, the contact lifts off and has not stuck; the motion of p, b, y, v and z in slip does not "
        "depend on u",
        Rung.BALLS.check(
            f"certified runs: ν = 1/4 with u(0) = {FIRST_SLIP}, ν = 4 with u(0) = {FASTER[0]}, lift-off is the only "
            "event; eqs. udot, newex1 to newex5 in slip, derived by u: no rate has u, so with a larger u(0) u alone is "
            "larger, by as much, until lift-off",
            all_of([*(happens(run_of(1, nu, slip), (LIFT_OFF,)) for nu, slip in FAST), has_no_slip_velocity()]),
            f"ν = 4: lift-off at t = {', '.join(f'{approximate(time):.12g}' for time in stops)}",
        ),
        Rung.POINTS.check(
            f"for ν = 4 the certified lift-off is the same to 10^-9 with u(0) = {FASTER[1]}; float runs ({_FLOATS[0]}) "
            "lift off alone, at these times",
            all_of([_close(stops, again), *(floats_lift_off(nu, slip) for nu, slip in FAST)]),
        ),
    )


def _close(first: list[fmpq], second: list[fmpq]) -> bool | None:
    if not first or len(first) != len(second):
        return None
    return all(abs(a - b) < _NEAR for a, b in zip(first, second, strict=True))


def _builders() -> dict[str, Callable[[], Entry]]:
    runs: dict[str, Callable[[], Entry]] = {
        identifier(chi, nu): partial(_one_way if chi == 0 else _two_way, nu) for chi, nu in RUNS
    }
    return {
        "3-impact-to-stick": _continues_to_stick,
        "3-large-slip": _large_slip,
        **runs,
        "3-varsim2-caption": _caption,
    }


ENTRIES: Builders = _builders()
"""The sentences on the simulations of the extended system, its four runs, and what the caption counts."""
