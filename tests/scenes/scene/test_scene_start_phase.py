"""What may be a start and which phase it begins, from numbers alone: every comparison at its border and beside it."""

from __future__ import annotations

from dataclasses import dataclass

import pytest
from flint import arb, fmpq

from gspot_verified.scenes.equations.motion import SceneError
from gspot_verified.scenes.equations.terms import FLIGHT, REVERSE, SLIP, STICK
from gspot_verified.scenes.scene.start import check_rigid_force, check_start, first_phase, in_contact

VALUES = {"k_1": fmpq(2), "k_2": fmpq(1), "damping": fmpq(3)}
ZERO, ONE, EPSILON = fmpq(0), fmpq(1), fmpq(1, 10)
CONTACT = ("compliant_contact",)
ALL = (SLIP, STICK, REVERSE, FLIGHT)


@dataclass
class Motion:
    """Only numbers."""

    y: fmpq = ZERO
    v: fmpq = ZERO
    z: fmpq = ZERO
    b: fmpq | arb = -ONE
    p: fmpq | arb = ONE
    u: fmpq | arb = ONE
    checked: bool = False

    def check(self, values: object) -> None:
        assert values is VALUES
        self.checked = True

    def start(self, values: object) -> dict[str, fmpq]:
        assert values
        return {"y": self.y, "v": self.v, "z": self.z}

    def normal_acceleration(self, values: object) -> fmpq | arb:
        assert values
        return self.b

    def painleve_parameter(self, values: object) -> fmpq | arb:
        assert values
        return self.p

    def slip_velocity(self, values: object) -> fmpq | arb:
        assert values
        return self.u


def contact(**numbers: object) -> bool:
    return in_contact(Motion(**numbers), VALUES, EPSILON)  # type: ignore[arg-type]


TINY = fmpq(1, 10**30)


@pytest.mark.parametrize(
    ("numbers", "expected"),
    [
        ({"y": -TINY}, True),
        ({"y": TINY}, False),
        ({"z": fmpq(-1), "y": fmpq(-1), "v": fmpq(20, 3) - TINY}, True),
        ({"z": fmpq(-1), "y": fmpq(-1), "v": fmpq(20, 3) + TINY}, False),
        ({"v": -TINY}, True),
        ({"v": TINY}, False),
        ({"b": -TINY}, True),
        ({"b": TINY}, False),
        ({"b": arb("[-1 +/- 0.5]")}, True),
        ({"b": arb("[1 +/- 0.5]")}, False),
        # z = -1, v = 20/3: (k_1/c)² z/ε² = -400/9
        ({"z": fmpq(-1), "y": fmpq(-1), "v": fmpq(20, 3), "b": fmpq(-400, 9) - TINY}, True),
        ({"z": fmpq(-1), "y": fmpq(-1), "v": fmpq(20, 3), "b": fmpq(-400, 9) + TINY}, False),
    ],
)
def test_the_first_derivative_that_is_not_zero_decides(numbers: dict[str, object], expected: bool) -> None:
    """Of Z - Y: z - y, then -(k_1/c) z/ε² - v/ε, then (k_1/c)² z/ε² - b; here k_1/c = 2/3 and ε = 1/10."""
    assert contact(**numbers) is expected


@pytest.mark.parametrize("b", [fmpq(0), arb("[0 +/- 1]"), arb("nan")])
def test_two_derivatives_that_vanish_leave_it_open(b: object) -> None:
    with pytest.raises(SceneError, match="whether contact begins is open"):
        contact(b=b)


def first(motion: Motion, phases: tuple[str, ...] = ALL, **more: fmpq) -> str:
    return first_phase(motion, {**VALUES, **more}, EPSILON, phases)  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("u", "belt", "expected"),
    [
        (TINY, 0, SLIP),
        (-TINY, 0, REVERSE),
        (fmpq(0), 0, STICK),
        (fmpq(3), 3, STICK),
        (fmpq(3), 4, REVERSE),
        (fmpq(3), -4, SLIP),
        (arb("[1 +/- 0.5]"), 0, SLIP),
        (arb(0), 0, STICK),
    ],
)
def test_the_phase_by_the_slip_velocity(u: fmpq | arb, belt: int, expected: str) -> None:
    assert first(Motion(u=u), belt_velocity=fmpq(belt)) == expected
    assert first(Motion(u=u, y=fmpq(1)), belt_velocity=fmpq(belt)) == FLIGHT
    assert first(Motion(u=u), (SLIP, FLIGHT), belt_velocity=fmpq(belt)) == SLIP
    assert first(Motion(u=u, y=fmpq(1)), (SLIP, STICK, REVERSE), belt_velocity=fmpq(belt)) == expected


def test_a_slip_velocity_around_zero_is_refused() -> None:
    with pytest.raises(SceneError, match="the sign of the slip velocity is not certain"):
        first(Motion(u=arb("[0 +/- 1]")))


def check(motion: Motion, effects: tuple[str, ...], given: tuple[str, ...] = ("y", "v", "z")) -> None:
    check_start(motion, VALUES, EPSILON, effects, dict.fromkeys(given))  # type: ignore[arg-type]
    assert motion.checked


@pytest.mark.parametrize(
    ("motion", "effects", "message"),
    [
        (Motion(z=TINY), CONTACT, "z must be <= 0"),
        (Motion(y=-EPSILON - TINY), CONTACT, "interpenetrating"),
        (Motion(y=TINY), CONTACT, "not in contact: .* lift_off is left out"),
        (Motion(u=-TINY), (*CONTACT, "tangential_motion"), "u must be >= 0 .* got -1/1"),
        (Motion(u=arb("[-2 +/- 0.5]")), (*CONTACT, "tangential_motion"), "u must be >= 0"),
    ],
)
def test_what_is_no_start(motion: Motion, effects: tuple[str, ...], message: str) -> None:
    with pytest.raises(SceneError, match=message):
        check(motion, effects)


@pytest.mark.parametrize(
    ("motion", "effects", "given"),
    [
        (Motion(), CONTACT, ("y",)),
        (Motion(y=-EPSILON), CONTACT, ("y",)),
        (Motion(y=-EPSILON - TINY), CONTACT, ()),
        (Motion(y=TINY), (*CONTACT, "lift_off"), ("y",)),
        (Motion(u=fmpq(0)), (*CONTACT, "tangential_motion"), ("y",)),
        (Motion(u=fmpq(-1)), CONTACT, ("y",)),
        (Motion(u=fmpq(-1)), (*CONTACT, "tangential_motion", "stick"), ("y",)),
    ],
)
def test_what_is_a_start(motion: Motion, effects: tuple[str, ...], given: tuple[str, ...]) -> None:
    check(motion, effects, given)


@pytest.mark.parametrize(
    ("p", "b", "good"),
    [
        (TINY, -TINY, True),
        (fmpq(0), fmpq(-1), False),
        (fmpq(1), fmpq(0), False),
        (fmpq(-1), fmpq(1), False),
        (arb("[1 +/- 2]"), fmpq(-1), False),
        (fmpq(1), arb("[-1 +/- 2]"), False),
        (arb("[1 +/- 0.5]"), arb("[-1 +/- 0.5]"), True),
    ],
)
def test_the_force_of_rigid_slip(p: fmpq | arb, b: fmpq | arb, good: bool) -> None:
    motion = Motion(p=p, b=b)
    if good:
        check_rigid_force(motion, VALUES)  # type: ignore[arg-type]
        return
    with pytest.raises(SceneError, match=r"it needs p > 0 and b < 0, got p = .*, b = "):
        check_rigid_force(motion, VALUES)  # type: ignore[arg-type]
