"""What may be a start, and the phase that it begins: exact comparisons, certain ones where a mechanism needs balls."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from flint import arb, fmpq

from gspot_verified.numbers.balls import ball_text, sign_of
from gspot_verified.scenes.equations.motion import Motion, SceneError
from gspot_verified.scenes.equations.terms import FLIGHT, REVERSE, SLIP, STICK


def check_start(
    motion: Motion, values: Mapping[str, fmpq], epsilon: fmpq, effects: Sequence[str], given: Mapping[str, object]
) -> None:
    """Passes for a start that is one.

    :raises SceneError: a state is missing or too much, the surface is pulled out, the bodies are inside each other, or
        there is no contact and none can come.
    """
    motion.check(values)
    start = motion.start(values)
    if start["z"] > 0:
        raise SceneError(f"start: z must be <= 0 (the surface is not pulled out), got {start['z']}")
    overlap = start["z"] - start["y"]
    if "y" in given and overlap > epsilon:
        raise SceneError(
            f"start: interpenetrating: y lies {overlap} below the surface at z = {start['z']}; in contact y and z "
            f"are of the order of epsilon^2 = {epsilon**2}, and more than epsilon is refused"
        )
    if "lift_off" not in effects and not in_contact(motion, values, epsilon):
        raise SceneError(f"start: not in contact: y = {start['y']} >= z = {start['z']}, and lift_off is left out")
    if "tangential_motion" in effects and "stick" not in effects:
        slip = _slip_sign(motion, values)
        if slip < 0:
            velocity = _text(motion.slip_velocity(values))
            raise SceneError(f"start: u must be >= 0 (positive slip) where stick is left out, got {velocity}")


def check_rigid_force(motion: Motion, values: Mapping[str, fmpq]) -> None:
    """Passes where rigid slip at the start has a force, -b/p > 0.

    :raises SceneError: it has none, or not certainly.
    """
    p, b = motion.painleve_parameter(values), motion.normal_acceleration(values)
    if not (p > 0 and b < 0):
        raise SceneError(
            "stop_at_force: there is no force of rigid slip at the start, -b/p, to measure by: it needs p > 0 and "
            f"b < 0, got p = {_text(p)}, b = {_text(b)}"
        )


def in_contact(motion: Motion, values: Mapping[str, fmpq], epsilon: fmpq) -> bool:
    """Whether z > y at the start or, where z = y, right after it: the first derivative of Z - Y in T that is not 0.

    :raises SceneError: z - y vanishes with two derivatives, or the second is not certainly of one sign.
    """
    start, rate = motion.start(values), values["k_1"] / values["damping"]
    gap = start["z"] - start["y"]
    if gap == 0:
        gap = -rate * start["z"] / epsilon**2 - start["v"] / epsilon
    if gap != 0:
        return bool(gap > 0)
    sign = _sign(rate * rate * start["z"] / epsilon**2 - motion.normal_acceleration(values))
    if sign in (None, 0):
        raise SceneError("start: y = z with equal velocities and no certain sign of b: whether contact begins is open")
    return sign == 1


def first_phase(motion: Motion, values: Mapping[str, fmpq], epsilon: fmpq, phases: Sequence[str]) -> str:
    """The phase at the start.

    :raises SceneError: the slip velocity, or whether friction holds the contact, is not certain.
    """
    if FLIGHT in phases and not in_contact(motion, values, epsilon):
        return FLIGHT
    if STICK not in phases:
        return SLIP
    sign = _slip_sign(motion, values)
    if sign != 0:
        return SLIP if sign > 0 else REVERSE
    return STICK


def _slip_sign(motion: Motion, values: Mapping[str, fmpq]) -> int:
    sign = _sign(motion.slip_velocity(values) - values.get("belt_velocity", fmpq(0)))
    if sign is None:
        raise SceneError("start: the sign of the slip velocity is not certain")
    return sign


def _sign(value: fmpq | arb) -> int | None:
    if isinstance(value, arb):
        return sign_of(value)
    return (value > 0) - (value < 0)


def _text(value: fmpq | arb) -> str:
    return ball_text(value) if isinstance(value, arb) else str(value)
