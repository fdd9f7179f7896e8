"""The scene that starts on slip just before a G-spot of a mechanism. Which start is taken is a free choice."""

from __future__ import annotations

from flint import arb, fmpq

from gspot_verified.functions.box_program import BoxProgram
from gspot_verified.functions.derivative import partial_derivative
from gspot_verified.functions.rings import BALLS
from gspot_verified.mechanisms.approach.state_beside import state_beside
from gspot_verified.mechanisms.derive.to_system import Shifted, shift
from gspot_verified.mechanisms.input.mechanism import Lagrangian, Mechanism
from gspot_verified.mechanisms.spots.chosen_spot import at_spot
from gspot_verified.mechanisms.spots.classify import Classification, classify_g_spot
from gspot_verified.mechanisms.spots.g_spot import GSpot, find_g_spot
from gspot_verified.numbers.balls import approximate, ball, sign_of, working_bits
from gspot_verified.numbers.short_text import short_text
from gspot_verified.scenes.motions.mechanism_motion import NormalCoordinate
from gspot_verified.scenes.scene.scene import Scene, SceneError

_BITS = 80  # of the search for a start
_PLACES = 10**8  # a start is rounded to so many parts of 1
_SHARES_OF_C = tuple(fmpq(1, 2**k) for k in (5, 7, 9, 12))  # p at the start, tried in turn
_SHARE_OF_FORCE = fmpq(5, 4)  # -b/p at the start, over |mean force|; from a smaller one slip may lift off before
_TIMES = 10  # that p takes to fall to 0: how long is looked
EPSILON = fmpq(1, 1000)  # of the scene, until another is set
ON_A_SURFACE_AT_REST = ("compliant_contact", "lift_off", "tangential_motion", "stick")
ON_A_BELT = ("compliant_contact", "lift_off", "belt")


def scene_before_spot(mechanism: Mechanism, number: int) -> Scene:
    """Slip that comes to the G-spot of this number (as ``classify_all`` lists them), just in contact: y = v = z = 0.

    At the start p is about a 32nd part of C at the G-spot, or less (C is what p would be without friction), and -b/p is
    about five quarters of the size of the mean force: in Case II slip with less than that lifts off before the G-spot.
    ``epsilon`` = 1/1000, and ``until`` is ten times the time that p takes to fall to 0 at its rate α1 at the G-spot.
    Effects: contact, lift-off, tangential motion and stick; where u < 0 at the G-spot, a belt in place of the last two,
    whose velocity is not given. All may be changed with ``Scene.with_settings``.

    :raises SceneError: slip does not come to this G-spot (it is in no Case), the direction of slip there is not
        certain, no start was found, or scenes do not cover the mechanism.
    :raises ValueError: there is no G-spot of that number.
    :raises MechanismError: the mechanism is not complete.

    >>> from gspot_verified import load
    >>> scene = scene_before_spot(load("rod"), 1)
    >>> scene.effects == ON_A_SURFACE_AT_REST, scene.first_phase(), scene.start["theta"]
    (True, 'slip', 'theta_ref - 0.0194993')
    """
    spot = find_g_spot(at_spot(mechanism, number))
    found = classify_g_spot(spot)
    where = f"{mechanism.name}, G-spot {number}"
    if found.case in (None, "none") or found.mean_force is None:
        raise SceneError(
            f"{where}: no start before it: {found.what_happens}; slip comes to G-spots in Cases I to III "
            "(classify_all lists the number and the Case of each)"
        )
    slip = sign_of(ball(found.slip_velocity))
    if slip not in (1, -1):
        raise SceneError(
            f"{where}: no start before it: whether the contact slips there, u > 0 or u < 0, is not certain"
        )
    shifted = shift(spot.shifted.mechanism)
    f, state, motion = shifted.functions, mechanism.state, mechanism.motion
    if isinstance(motion, Lagrangian) and motion.constraints:
        raise SceneError(f"{where}: no start before it: the mechanism has constraints; write a scene with a start")
    free = NormalCoordinate.of(f.y, f.v, len(state))
    determined = {state[free.place], state[free.velocity]} if free else _steepest(spot, shifted, where)
    for share in _SHARES_OF_C:
        start = _start(spot, found, share)
        if start is None:
            continue
        scene = Scene(
            name=f"slip before {where}",
            effects=ON_A_SURFACE_AT_REST if slip > 0 else ON_A_BELT,
            epsilon=EPSILON,
            until=_until(found, share),
            parameters={},
            start={word: value for word, value in start.items() if word not in determined},
            mechanism=mechanism if free else spot.shifted.mechanism,  # else y = v = 0 is solved next to its place
        )
        p, b = (of(scene.values()) for of in (scene.motion.painleve_parameter, scene.motion.normal_acceleration))
        if p > 0 and b < 0:
            return scene
    raise SceneError(f"{where}: no state of slip with p > 0 and b < 0 was found next to it; write a scene with a start")


def _steepest(spot: GSpot, shifted: Shifted, where: str) -> set[str]:
    """The coordinate in which y is steepest at the G-spot, and its velocity: y = v = 0 is solved for them."""
    state, motion = spot.shifted.mechanism.state, spot.shifted.mechanism.motion
    if not isinstance(motion, Lagrangian):
        raise SceneError(f"{where}: no start before it: the mechanism is given by fields; write a scene with a start")
    n = len(motion.coordinates)
    with working_bits(_BITS):
        slopes = shifted.expressions([partial_derivative(shifted.functions.y, i, len(state)) for i in range(n)], BALLS)
        place = [ball(value) for value in spot.system.point]
        sizes = [abs(approximate(slope)) for slope in BoxProgram(slopes, len(state)).values(place)]
    steepest = sizes.index(max(sizes))
    return {state[steepest], state[n + steepest]}


def _start(spot: GSpot, found: Classification, share: fmpq) -> dict[str, fmpq | str] | None:
    """All components of a state with p = ``share`` C, rounded; an angle with a reference is counted from it."""
    mechanism = spot.shifted.mechanism
    references = {angle.coordinate: angle.name for angle in mechanism.angles}
    with working_bits(_BITS):
        assert found.mean_force is not None
        p = (ball(found.C) * ball(share)).mid()
        force = abs(ball(found.mean_force)) * ball(_SHARE_OF_FORCE)
        state = state_beside(spot, p, (-force * p).mid())
        if state is None:
            return None
        start: dict[str, fmpq | str] = {}
        for word, value in zip(mechanism.state, state, strict=True):
            number = _rounded(value)
            sign, size = ("-", -number) if number < 0 else ("+", number)
            start[word] = f"{references[word]} {sign} {short_text(size)}" if word in references else number
        return start


def _until(found: Classification, share: fmpq) -> fmpq:
    with working_bits(_BITS):
        return _rounded(_TIMES * ball(found.C) * ball(share) / abs(ball(found.alpha_1)), up=1)


def _rounded(value: arb, up: int = 0) -> fmpq:
    return fmpq(round(approximate(value) * _PLACES) + up, _PLACES)
