"""Numbers of scenes: what is exact passes, units and hostile sizes are named."""

from __future__ import annotations

import pytest
from flint import arb, fmpq

from gspot_verified.scenes.equations.motion import SceneError
from gspot_verified.scenes.scene.numbers import MAX_BITS, scene_number


@pytest.mark.parametrize(
    ("given", "value"),
    [("1e-3", "1/1000"), ("-7/3", "-7/3"), (" +0.25 ", "1/4"), ("2E5", "200000"), (3, "3"), (fmpq(1, 2), "1/2")],
)
def test_exact_numbers_pass(given: str | int | fmpq, value: str) -> None:
    assert str(scene_number(given, "epsilon")) == value


@pytest.mark.parametrize(
    ("given", "unit"),
    [("10 mm", "mm"), ("3s", "s"), ("1e-3 kg m^2", "kg m^2"), ("-7/3 m/s", "m/s"), ("45°", "°"), ("5%", "%"),
     ("2 µm", "µm"), (" +.5 e ", "e"), ("1e", "e"), ("3 eV", "eV"), ("0 bar", "bar"), ("0bar", "bar"), ("0 o", "o")],
)  # fmt: skip
def test_a_unit_is_named(given: str, unit: str) -> None:
    with pytest.raises(SceneError, match=rf"^y: .* has a unit \({unit.replace('^', chr(92) + '^')}\); numbers stand"):
        scene_number(given, "y")


@pytest.mark.parametrize(
    "given", ["two", "1/0", "nan", "", "1e5e3", "0x10", " -0XfF ", "0b11", "+0o17", arb(1), arb("0.1")]
)
def test_what_is_no_number(given: str | arb) -> None:
    if isinstance(given, arb) and given.is_exact():
        assert scene_number(given, "y") == 1
        return
    with pytest.raises(ValueError, match="y") as caught:
        scene_number(given, "y")
    assert "has a unit" not in str(caught.value)


def test_a_float_is_refused() -> None:
    with pytest.raises(TypeError):
        scene_number(0.1, "y")  # type: ignore[arg-type]


def test_the_largest_number_that_passes_and_the_least_that_does_not() -> None:
    """Of a fraction each part counts, the larger one is named; a text of 2001 characters is not read."""
    top = 2**MAX_BITS
    for least in (fmpq(top - 1), fmpq(1 - top), fmpq(1, top - 1)):
        assert scene_number(least, "y") == least
    for beyond in (fmpq(top), fmpq(-top), fmpq(1, top), fmpq(3, top), fmpq(top, 3)):
        with pytest.raises(SceneError, match=r"^y: a number of 2001 bits; at most 2000 are allowed$"):
            scene_number(beyond, "y")
    assert scene_number("0" * 1999 + "1", "y") == 1
    with pytest.raises(SceneError, match=r"^y: a number of 2001 characters; at most 2000 bits are allowed$"):
        scene_number("0" * 2000 + "1", "y")
    with pytest.raises(SceneError, match="2001 characters"):
        scene_number("1" + " " * 1999 + "m", "y")
