"""Hard cases of whole simulations: a start next to the canard."""

from __future__ import annotations

from flint import arb

from gspot_verified.hard_cases.compliant_cases import BETA, EPSILON
from gspot_verified.hard_cases.double import double_text
from gspot_verified.hard_cases.hard_case import Case, HardCase, bits_lost, near
from gspot_verified.hard_cases.timed import timed
from gspot_verified.numbers.balls import ball_text, working_bits
from gspot_verified.scenes.certified.certified_integration import integrated_run
from gspot_verified.scenes.effects.lift_off import LIFT_OFF
from gspot_verified.scenes.floats.float_run import float_run
from gspot_verified.scenes.scene.file import load_scene
from gspot_verified.scenes.scene.run import RunEvent
from gspot_verified.scenes.scene.scene import Scene, SceneError

_PRECISIONS = (128, 256, 384)  # bits, tried in turn
_SOLVER, _TOLERANCE = "LSODA", 1e-10


def scene_next_to_the_canard(k: int) -> Scene:
    """The paper's run with nu = 1 - 10^-k."""
    return load_scene("fig-varsim1", beta=BETA, nu=near(1, k, -1), epsilon=EPSILON, until="1")


def certified_lift_off(scene: Scene) -> tuple[RunEvent | None, int]:
    """The first lift-off, and the first precision of a list at which it is found; None if at none."""
    for bits in _PRECISIONS:
        events = integrated_run(scene, bits=(bits,)).events
        if events and events[0].name == LIFT_OFF:
            return events[0], bits
    return None, _PRECISIONS[-1]


def run_next_to_the_canard(k: int) -> HardCase:
    """When a run that starts 10^-k from the canard lifts off."""
    scene = scene_next_to_the_canard(k)
    (lift_off, work), seconds = timed(lambda: certified_lift_off(scene))
    certified, text = None, "undecided"
    if lift_off is not None:
        with working_bits(work):
            certified = arb(lift_off.lower).union(arb(lift_off.upper))
            text = f"t = {ball_text(certified, 12)} after the start"
    double = None
    try:
        events = float_run(scene, _SOLVER, _TOLERANCE).events
        double = next((int(e.lower.p) / int(e.lower.q) for e in events if e.name == LIFT_OFF), None)
        said = "no event" if double is None else double_text(double)
    except SceneError:
        said = "the solver gave up"

    def deviation(bits: int) -> arb:
        with working_bits(bits):
            return arb(near(1, k, -1)) - 1

    asked = f"lift-off of a run, ν = 1 − 10^−{k}, β = 5/2, ε = 1/1000"
    return HardCase(
        level=k,
        asked=asked,
        condition=float(k),
        lost=bits_lost(deviation),
        double=double,
        double_text=said,
        certified=certified,
        text=text,
        work=work,
        seconds=seconds,
    )


CASES: dict[str, Case] = {
    "run": run_next_to_the_canard,
}
