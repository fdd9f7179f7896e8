"""Where bodies are drawn: at the places that sympy makes of the file's own texts."""

from __future__ import annotations

import math
import tomllib
from typing import Any

import pytest
import sympy
from hypothesis import given
from hypothesis import strategies as st

from gspot_verified.mechanisms.derive.to_system import shift
from gspot_verified.mechanisms.input.given import lagrangian
from gspot_verified.mechanisms.input.mechanism import Mechanism, MechanismError
from gspot_verified.mechanisms.load import load
from gspot_verified.mechanisms.shipped import shipped_names, shipped_text
from gspot_verified.report.pictures.mechanism_shape import Shape, Shapes, closed_line, extent, moved, surface, window

NAMES = [name for name in shipped_names() if "[drawing]" in shipped_text(name)]
SAMPLES = st.lists(st.floats(-2, 2), min_size=6, max_size=6)


class BySympy:
    """The formulas of a file, read by sympy; angles count from their references."""

    def __init__(self, name: str) -> None:
        data: dict[str, Any] = tomllib.loads(shipped_text(name))
        motion = data["lagrangian"] if "lagrangian" in data else data["energies"]
        self._data, self._coordinates = data, motion["coordinates"]
        self.state = [*self._coordinates, *(f"{word}_dot" for word in self._coordinates)]
        self.state += [motion["time"]] if "time" in motion else []
        parameters, angles = data["parameters"], data.get("angles", {})
        words = [*self.state, *parameters, *(f"{word}_ref" for word in angles)]
        self._symbols = {word: sympy.Symbol(word) for word in words}
        self._shifts = {self._symbols[word]: self._symbols[word] + self._symbols[f"{word}_ref"] for word in angles}
        self._numbers = {
            self._symbols[f"{word}_ref"]: sympy.atan2(sympy.Rational(pair["sine"]), sympy.Rational(pair["cosine"]))
            for word, pair in angles.items()
        }
        self._numbers |= {self._symbols[word]: self.formula(value) for word, value in parameters.items()}

    def formula(self, text: Any) -> Any:
        return sympy.sympify(str(text).replace("^", "**"), locals=self._symbols)

    def at(self, state: list[float]) -> dict[str, Any]:
        """All numbers of the drawing at a state."""
        values = dict(zip((self._symbols[word] for word in self.state), state, strict=True))

        def number(formula: Any) -> float:
            made = sympy.sympify(formula).subs(self._shifts, simultaneous=True)
            while not made.free_symbols <= values.keys():
                made = made.subs(self._numbers)
            return float(made.subs(values))

        def pair(given: Any) -> list[float]:
            return [number(self.formula(each)) for each in given]

        drawing, contact = self._data["drawing"], self._data["contact"]
        if "x" in contact:
            x = self.formula(contact["x"])
            u = sum(x.diff(self._symbols[word]) * self._symbols[f"{word}_dot"] for word in self._coordinates)
        else:
            u = self.formula(contact["slip_velocity"])
        return {
            "lines": [[pair(point) for point in line] for line in drawing.get("lines", [])],
            "points": [pair(point) for point in drawing["points"]],
            "contact": pair(drawing.get("contact", [contact.get("x", 0), contact["y"]])),
            "height": number(self.formula(contact["y"])),
            "u": number(u),
        }


def flat(values: Any) -> list[float]:
    return [part for value in values for part in flat(value)] if isinstance(values, list | tuple) else [values]


@pytest.mark.parametrize("name", NAMES)
def test_places_are_those_of_the_formulas(name: str) -> None:
    shapes, read = Shapes(shift(load(name), slip_speed=True)), BySympy(name)
    for state in ([0.0] * 8, [0.3, -0.7, 0.2, 1.5, -0.4, 0.9, 0.8, -0.1], [-1.2, 0.1, -0.9, -0.3, 2.0, -1.1, 1.0, 0.7]):
        cut = state[: len(read.state)]
        shape, expected = shapes.at(cut), read.at(cut)
        assert len(expected["lines"]) <= len(shape.lines)
        found = {"lines": shape.lines[: len(expected["lines"])]}
        for part, values in expected.items():
            assert flat(found.get(part, getattr(shape, part))) == pytest.approx(flat(values), abs=1e-13), part
        assert (shape.normal, shape.tangent) == ((0, 1), (1, 0))
        assert shape.foot == pytest.approx((shape.contact[0], shape.contact[1] - shape.height), abs=1e-15)


@pytest.mark.parametrize("name", [name for name in NAMES if "belt" not in name and "chalk" not in name])
def test_the_drawn_contact_moves_as_the_contact_does(name: str) -> None:
    """Along the surface with u, by differences of places; of a wheel and an ellipse it is the material point that
    slips, and the rest is rolling: the contact point of the drawing moves on the body."""
    mechanism = load(name)
    shapes, step = Shapes(shift(mechanism, slip_speed=True)), 1e-6
    coordinates = mechanism.motion.coordinates  # type: ignore[union-attr]
    state = [0.3, 0.7, 0.2, 1.5, -0.4, 0.9, 0.8, -0.1][: len(mechanism.state)]
    half = len(coordinates)
    later = [place + step * rate for place, rate in zip(state[:half], state[half : 2 * half], strict=True)]
    first, second = shapes.at(state), shapes.at([*later, *state[half:]])
    rolling = "wheel" in name or "ellipse" in name
    assert ((second.contact[0] - first.contact[0]) / step == pytest.approx(first.u, abs=1e-4)) != rolling
    assert second.contact[1] - first.contact[1] == pytest.approx(second.height - first.height, abs=1e-12)


def test_an_ellipse_and_a_wheel_touch_the_surface_from_above_where_the_drawing_says() -> None:
    for name in ("sliding ellipse", "unbalanced wheel"):
        mechanism = load(name)
        for turn in (0.0, 0.4, -1.3, 2.9):
            shape = Shapes(shift(mechanism)).at([0.5, 1.0, turn, 0.0, 0.0, 0.0])
            lowest = min(shape.lines[-1], key=lambda place: place[1])
            assert lowest[1] == pytest.approx(shape.contact[1], abs=4e-3)
            assert lowest[1] >= shape.contact[1] - 1e-12
            assert lowest[0] == pytest.approx(shape.contact[0], abs=0.1)
            assert shape.foot[1] == pytest.approx(0, abs=1e-12)


ROD = Shapes(shift(load("rod")))


@given(SAMPLES)
def test_the_rod_is_rigid_and_touches_at_its_end(state: list[float]) -> None:
    shape = ROD.at(state)
    ((first, last),) = shape.lines
    assert math.dist(first, last) == pytest.approx(2)
    assert last == pytest.approx(shape.contact)
    assert shape.points[0] == pytest.approx(((first[0] + last[0]) / 2, (first[1] + last[1]) / 2))


def block(**changes: Any) -> Mechanism:
    given: dict[str, Any] = {"lines": [[["X", "Y"], ["X", "Y + 1"]]], "circles": [["X", "Y", "2"]]} | changes
    slip = given.pop("slip", "positive")
    return lagrangian("block", ["X", "Y"], [[1, 0], [0, 1]], [0, -1], "X", "Y", 0, slip=slip, drawing=given)


def at(mechanism: Mechanism, *state: float) -> Shape:
    return Shapes(shift(mechanism)).at(state)


def test_circles_reach_as_far_as_their_radius() -> None:
    shape = at(block(), 5, 1, 0, 0)
    assert flat(window(shape.reaches())) == pytest.approx([3, -1, 7, 3])
    assert extent(window(shape.reaches())) == pytest.approx(4)
    assert extent(window([(1, 1)])) == 1


@given(st.floats(0.1, 3), st.floats(0.1, 3), st.floats(-4, 4))
def test_a_closed_line_lies_on_its_ellipse(first: float, second: float, angle: float) -> None:
    line = closed_line(1, 2, first, second, angle)
    assert line[0] == pytest.approx(line[-1])
    assert line[0] == pytest.approx((1 + first * math.cos(angle), 2 + first * math.sin(angle)))
    for x, y in line:
        along = (x - 1) * math.cos(angle) + (y - 2) * math.sin(angle)
        across = (y - 2) * math.cos(angle) - (x - 1) * math.sin(angle)
        assert (along / first) ** 2 + (across / second) ** 2 == pytest.approx(1)
    assert closed_line(1, 2, first) == closed_line(1, 2, first, first)


def test_the_normal_has_length_one_and_the_foot_is_below_the_contact() -> None:
    shape = at(block(normal=[-3, 4], contact=["X", 7]), 5, 10, 1, 0)
    assert shape.normal == pytest.approx((-0.6, 0.8))
    assert shape.tangent == pytest.approx((0.8, 0.6))
    assert shape.foot == pytest.approx((5 + 6, 7 - 8))
    assert shape.u == 1


def test_where_x_is_mirrored_the_tangent_is_to_the_left_and_u_counts_along_it() -> None:
    shape = at(block(slip="negative"), 5, 0, -3, 0)
    assert shape.contact == (5, 0)
    assert shape.tangent == (-1, 0)
    assert shape.u == 3


@given(st.floats(-3, 3), st.floats(-3, 3), st.floats(-3, 3), st.floats(-3, 3))
def test_the_surface_goes_through_the_foot_and_stays_when_it_moves_along(
    x: float, y: float, angle: float, way: float
) -> None:
    normal, corners = (math.cos(angle), math.sin(angle)), ((-4.0, -2.0), (4.0, 5.0))
    first = surface((x, y), normal, corners, 0.25)
    again = surface(moved((x, y), (normal[1], -normal[0]), way), normal, corners, 0.25)
    assert flat(first) == pytest.approx(flat(again), abs=1e-12)
    for place in first[0]:
        assert (place[0] - x) * normal[0] + (place[1] - y) * normal[1] == pytest.approx(0, abs=1e-12)
    for begin, end in first[1:]:
        assert (end[0] - begin[0]) * normal[0] + (end[1] - begin[1]) * normal[1] == pytest.approx(-0.25)


def test_what_has_no_place_is_refused() -> None:
    for part, state, why in (
        ({"points": [["sqrt(X)", 0]]}, -1.0, "no finite real value"),
        ({"points": [["1/X", 0]]}, 0.0, "zero|0.0"),
        ({"points": [["X^64", 0]]}, 1e9, "too large|no finite"),
        ({"points": [["X", 0]]}, math.inf, "no finite real value"),
        ({"normal": ["X", 0]}, 0.0, "the normal has the length 0"),
    ):
        with pytest.raises(MechanismError, match=rf"^block: the drawing has no place at the state \[.*: .*({why})"):
            at(block(**part), state, 0.0, 0.0, 0.0)
    with pytest.raises(MechanismError, match="l has no value"):
        Shapes(shift(load("rod", l=None), free=True))
    with pytest.raises(MechanismError, match=r"model system: no picture: .* add a table \[drawing\] to its file, as l"):
        Shapes(shift(load("model")))
