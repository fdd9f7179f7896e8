"""The picture of a mechanism: which state it is of, what its arrows say, what it refuses before the work."""

from __future__ import annotations

from dataclasses import replace
from typing import Any
from xml.etree import ElementTree

import pytest

from gspot_verified.mechanisms.approach.slip_state import StateError
from gspot_verified.mechanisms.input.given import lagrangian
from gspot_verified.mechanisms.input.mechanism import MechanismError
from gspot_verified.mechanisms.load import load
from gspot_verified.report import plot
from gspot_verified.report.pictures import mechanism_picture as module
from gspot_verified.report.pictures.canvas import Picture
from gspot_verified.report.pictures.mechanism_picture import mechanism_picture
from gspot_verified.report.pictures.mechanism_shape import Shape

STATE = {"X": 0, "theta": "theta_ref - 1/10", "X_dot": 2, "theta_dot": "1/2"}


@pytest.fixture
def shapes(monkeypatch: pytest.MonkeyPatch) -> list[tuple[str, Shape, str]]:
    """Title, shape and caption of each picture, in the place of drawing it."""
    seen: list[tuple[str, Shape, str]] = []

    def kept(_: str, title: str, shape: Shape, caption: str) -> Any:
        seen.append((title, shape, caption))

    monkeypatch.setattr(module, "shape_picture", kept)
    return seen


def test_the_rod_at_its_g_spot(shapes: list[tuple[str, Shape, str]]) -> None:
    """sin theta = 3/5, cos theta = 4/5; X_dot = 2 and theta_dot = 1 give the slip velocity 7/5."""
    mechanism_picture(load("rod"))
    ((title, shape, caption),) = shapes
    assert title == "falling rod at its G-spot"
    ((first, last),) = shape.lines
    assert first == pytest.approx((-0.8, 1.2))
    assert last == shape.contact == pytest.approx((0.8, 0))
    assert shape.u == pytest.approx(1.4)
    assert "X = 0, Y = 0.6, theta = theta_ref, X_dot = 2" in caption
    assert "it shows, it proves nothing" in caption
    assert "u < 0" not in caption


def test_a_spot_by_its_number_and_a_state_of_one_s_own(shapes: list[tuple[str, Shape, str]]) -> None:
    mechanism_picture(load("genot_brogliato_rod"), spot=3)
    mechanism_picture(load("rod"), state=STATE)
    (third, high, _), (own, low, caption) = shapes
    assert third == "falling rod of Génot and Brogliato at G-spot 3"
    assert high.points[0][1] == pytest.approx(0.491123, abs=1e-6)
    assert own == "falling rod at the given state"
    assert low.points[0][1] == pytest.approx(0.517136, abs=1e-6)
    assert "theta = theta_ref - 0.1" in caption


def test_a_velocity_below_zero_is_no_positive_slip(shapes: list[tuple[str, Shape, str]]) -> None:
    mechanism_picture(load("oscillator"))
    ((_, shape, caption),) = shapes
    assert shape.u == pytest.approx(-0.6)
    assert "Here u < 0: slip is positive only on a surface that moves faster in this direction" in caption


@pytest.mark.parametrize(
    ("options", "error", "message"),
    [
        ({"state": STATE, "spot": 1}, ValueError, "give state or spot, not both"),
        ({"state": {"spin": 1}}, StateError, "'spin' is no component"),
        ({"spot": 9}, ValueError, "9"),
    ],
)
def test_what_is_refused(options: dict[str, Any], error: type[Exception], message: str) -> None:
    with pytest.raises(error, match=message):
        mechanism_picture(load("rod"), **options)


def test_a_mechanism_without_a_drawing_is_refused_before_the_work(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "find_g_spot", None)
    with pytest.raises(MechanismError, match=r"falling rod: no picture: .* add a table \[drawing\] to its file, as"):
        mechanism_picture(replace(load("rod"), drawing=None))


def words(picture: Picture) -> list[str]:
    """What its SVG says, as comments beside the letters that are drawn."""
    parser = ElementTree.XMLParser(target=ElementTree.TreeBuilder(insert_comments=True))
    tree = ElementTree.fromstring(picture.svg, parser)
    return [str(node.text).strip() for node in tree.iter() if node.tag is ElementTree.Comment]


def test_the_picture_names_its_arrows_and_is_well_formed() -> None:
    drawn = plot.plot("mechanism", mechanism=load("rod"))
    assert (drawn.name, drawn.title) == ("mechanism", "Falling rod at its G-spot")
    assert drawn.png.startswith(b"\x89PNG")
    assert {"normal, y", "tangent, x", "slip, u = 1.4"} <= set(words(drawn))
    assert "velocity, u = −0.6" in words(mechanism_picture(load("oscillator")))


def test_circles_and_a_wall(monkeypatch: pytest.MonkeyPatch) -> None:
    """A wheel that slips down a wall on its right: the normal points to the left, x counts upwards."""
    wheel = lagrangian(
        "wheel", ["X", "Y", "phi"], [[1, 0, 0], [0, 1, 0], [0, 0, "1/2"]], ["1", "-1", 0], "Y + phi", "-X", "1/2",
        place={"X": 0, "Y": 0, "phi": 0, "X_dot": 0, "Y_dot": -1, "phi_dot": "1/4"},
        drawing={"circles": [["X - 1", "Y", 1]], "points": [["X - 1", "Y"]], "contact": ["X", "Y"], "normal": [-1, 0]},
    )  # fmt: skip
    drawn = mechanism_picture(wheel, state={"Y": 0, "phi": 0, "Y_dot": -1, "phi_dot": "1/4"})
    assert "velocity, u = −0.75" in words(drawn)
    seen: list[Shape] = []
    monkeypatch.setattr(module, "_draw", lambda _name, _title, shape, _caption: seen.append(shape))
    monkeypatch.setattr(module, "styled", lambda draw: draw)
    mechanism_picture(wheel, state={"Y": 0, "phi": 0, "Y_dot": -1, "phi_dot": "1/4"})
    assert (seen[0].normal, seen[0].tangent, seen[0].contact) == ((-1, 0), (0, 1), (0, 0))
