"""The drawing of a mechanism: what is refused, with the file, the part and the cure; that it decides nothing."""

from __future__ import annotations

import pickle
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from gspot_verified.mechanisms.formulas.in_sympy import to_sympy
from gspot_verified.mechanisms.input.drawing import PARTS
from gspot_verified.mechanisms.input.file import parse_mechanism
from gspot_verified.mechanisms.input.given import MAX_OPERATIONS, from_fields, lagrangian
from gspot_verified.mechanisms.input.mechanism import Drawing, Mechanism, MechanismError
from gspot_verified.mechanisms.load import load
from gspot_verified.mechanisms.shipped import shipped_names, shipped_text
from gspot_verified.mechanisms.spots.classify import classify
from gspot_verified.mechanisms.sweep.sweep_work import whole_text

BLOCK: dict[str, Any] = {
    "name": "block", "coordinates": ["X", "Y"], "mass_matrix": [[1, 0], [0, 1]], "forces": [0, "-g"],
    "x": "X", "y": "Y", "mu": "1/2", "parameters": {"g": 1},
}  # fmt: skip
LINE = [["X", "Y"], ["X + g/2", "Y"]]


def block(drawing: Any, **changes: Any) -> Mechanism:
    return lagrangian(**BLOCK | changes, drawing=drawing)


def drawn(drawing: Any, **changes: Any) -> Drawing:
    found = block(drawing, **changes).drawing
    assert found is not None
    return found


def texts(mechanism: Mechanism, formulas: Any) -> list[str]:
    return [str(to_sympy(formula, mechanism.state)) for formula in formulas]


def test_the_parts_are_the_formulas_that_were_given() -> None:
    parts = {"lines": [LINE], "circles": [["X", "Y + 1", "1/3"]], "points": [[0, "g"]], "normal": ["-3/5", "4/5"]}
    mechanism = block(parts | {"contact": ["X + 1", "Y"]})
    drawing = mechanism.drawing
    assert drawing is not None
    assert [texts(mechanism, point) for point in drawing.lines[0]] == [["X", "Y"], ["X + g/2", "Y"]]
    assert texts(mechanism, drawing.circles[0]) == ["X", "Y + 1", "1/3"]
    assert texts(mechanism, drawing.points[0]) == ["0", "g"]
    assert texts(mechanism, drawing.contact) == ["X + 1", "Y"]
    assert texts(mechanism, drawing.normal) == ["-3/5", "4/5"]


def test_the_contact_point_is_that_of_the_contact_with_the_normal_upwards() -> None:
    assert drawn({"lines": [LINE]}) == drawn({"lines": [LINE], "contact": ["X", "Y"], "normal": [0, 1]})


def test_where_the_library_mirrors_the_drawing_stays() -> None:
    mirrored = block({"lines": [LINE]}, slip="negative")
    assert mirrored.mirrored
    assert mirrored.drawing == drawn({"lines": [LINE]})


def test_fields_have_a_drawing_too() -> None:
    fields = {"state": ["y", "v"], "F": ["v", -1], "G_T": [0, 0], "G_N": [0, 1], "x": 0, "y": "y", "mu": 0}
    mechanism = from_fields("fall", **fields, drawing={"circles": [[0, "y", "1/2"]]})
    assert mechanism.drawing is not None
    assert texts(mechanism, mechanism.drawing.circles[0]) == ["0", "y", "1/2"]


@pytest.mark.parametrize(
    ("drawing", "message"),
    [
        ({}, r"nothing is drawn: give a line or a circle, as lines = \[\[\["),
        ({"points": [["X", "Y"]]}, "nothing is drawn"),
        ([LINE], "must be a table with some of lines, circles, points, contact, normal, got list"),
        ({"line": [LINE]}, "unknown part 'line'; did you mean 'lines'?"),
        ({"lines": "X"}, "lines must be a list, got 'X'"),
        ({"lines": [[["X", "Y"]]]}, 'line 1 must be .*two points or more; got'),
        ({"lines": [LINE, ["X", "Y"]]}, r"line 2, point 1 must be \[x, y\], two formulas; got 'X'"),
        ({"lines": [[["X", "Y"], ["X"]]]}, r"line 1, point 2 must be \[x, y\], two formulas; got \['X'\]"),
        ({"lines": [[["X", "Y"], ["Z", "Y"]]]}, "line 1, point 2: unknown name 'Z'"),
        ({"lines": [[["X", "Y"], ["X/0", "Y"]]]}, "line 1, point 2: division by zero"),
        ({"lines": [[["X", "Y"], ["X", 0.5]]]}, "line 1, point 2: .*float"),
        ({"lines": [[["X", "Y"], ["X", "Y_dot"]]]}, "line 1, point 2 depends on the velocity Y_dot"),
        ({"circles": [["X", "Y"]]}, r"circle 1 must be \[x, y, radius\] or \[x, y, a, b, angle\], three or five form"),
        ({"circles": [["X", "Y", 1, 2]]}, "circle 1 must be"),
        ({"lines": [LINE], "points": [["X", "Y", 1]]}, r"point 1 must be \[x, y\], two formulas"),
        ({"lines": ["XY"]}, "line 1 must be .*got 'XY'"),
        ({"lines": [["XY", "XY"]]}, "line 1, point 1 must be .*got 'XY'"),
        ({"lines": [LINE], "normal": 1}, r"normal must be \[x, y\], two formulas; got 1"),
    ],
)  # fmt: skip
def test_a_bad_drawing_is_refused_with_its_part(drawing: Any, message: str) -> None:
    with pytest.raises(MechanismError, match=f"^block: drawing.*{message}"):
        block(drawing)


def test_without_x_the_contact_point_must_be_given() -> None:
    turning = {"x": None, "slip_velocity": "X_dot"}
    with pytest.raises(MechanismError, match=r"the contact point is missing.*give contact = "):
        block({"lines": [LINE]}, **turning)
    assert drawn({"lines": [LINE], "contact": ["X", "Y"]}, **turning) == drawn({"lines": [LINE]})


ROD = shipped_text("rod")
HEAD, TAIL = ROD.partition("[drawing]")[0], ROD[ROD.index("[g_spot]") :]


@pytest.mark.parametrize(
    ("drawing", "message"),
    [
        ("lines = 3", 'key "drawing.lines" must be a list, got int 3'),
        ("line = []", "unknown key \"drawing.line\"; did you mean 'lines'"),
        ('lines = [[[["X"]]]]', 'key "drawing.lines" must be a formula'),
        ("circles = [[0, true, 1]]", 'key "drawing.circles" must be a formula.*got bool True'),
        ('lines = [[["X", "Y"], ["Xx", "Y"]]]', "drawing, line 1, point 2: unknown name 'Xx'.*did you mean 'X'"),
        ("", "nothing is drawn: give a line or a circle"),
    ],
)
def test_a_bad_drawing_in_a_file_is_refused_with_the_file(tmp_path: Path, drawing: str, message: str) -> None:
    place = tmp_path / "rod.toml"
    place.write_text(f"{HEAD}[drawing]\n{drawing}\n{TAIL}", encoding="utf-8")
    with pytest.raises(MechanismError, match=f"rod.toml: .*{message}"):
        load(place)


def test_decimals_of_a_file_are_exact() -> None:
    mechanism = parse_mechanism(f"{HEAD}[drawing]\ncircles = [[0.1, 1e-1, 2]]\n{TAIL}")
    assert mechanism.drawing is not None
    assert texts(mechanism, mechanism.drawing.circles[0]) == ["1/10", "1/10", "2"]


def test_a_drawing_is_no_part_of_the_mechanism() -> None:
    """Nothing that compares, hashes or keeps a mechanism sees it; pickle brings it along."""
    plain, shown = parse_mechanism(HEAD + TAIL), parse_mechanism(ROD)
    assert plain.drawing is None
    assert shown.drawing is not None
    assert plain == shown
    assert hash(plain) == hash(shown)
    assert whole_text(plain) == whole_text(shown)
    assert classify(plain).to_json() == classify(shown).to_json()
    assert pickle.loads(pickle.dumps(shown)).drawing == shown.drawing
    assert shown.with_parameters(mu=3).drawing == shown.drawing


def test_a_large_drawing_makes_no_mechanism_too_large() -> None:
    """Its operations are counted apart, and limited likewise."""
    long = "+".join(f"sin({k}*X)" for k in range(1, MAX_OPERATIONS // 4))
    line = [["X", "Y"], [long, "Y"]]
    assert block({"lines": [line]}, forces=[long, 0]) == block(None, forces=[long, 0])
    for forces, drawing in (([long, long], None), ([0, 0], {"lines": [line, line]})):
        with pytest.raises(MechanismError, match=f"more than {MAX_OPERATIONS} operations"):
            block(drawing, forces=forces)


def test_the_shipped_mechanisms_of_bodies_have_a_drawing() -> None:
    without = {name for name in shipped_names() if load(name).drawing is None}
    assert without == {"model system", "extended system"}


ANYTHING = st.recursive(st.none() | st.booleans() | st.integers() | st.text(max_size=4), st.lists, max_leaves=8)


@given(st.sampled_from(PARTS), ANYTHING)
def test_whatever_is_given_is_read_or_refused(part: str, value: Any) -> None:
    """No other error, and nothing in between."""
    try:
        found = block({"lines": [LINE], part: value}).drawing
    except MechanismError:
        return
    assert isinstance(found, Drawing)
