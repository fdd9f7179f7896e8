"""Scene files against their schema, and files of strangers: no code is run, hostile sizes end in a clear error."""

from __future__ import annotations

import sys
import tomllib
from importlib import resources
from pathlib import Path
from typing import Any

import pytest
from jsonschema import Draft202012Validator

from gspot_verified.mechanisms.input.mechanism import MechanismError
from gspot_verified.scenes.scene.file import SHIPPED, load_scene, parse_scene, scene_file_schema
from gspot_verified.scenes.scene.scene import SceneError

GOOD: dict[str, Any] = {
    "format": 1,
    "name": "mine",
    "effects": ["compliant_contact", "lift_off"],
    "epsilon": "1e-3",
    "until": 1,
    "start": {"p": "1/2", "b": -1},
}
TEXT = """
format = 1
name = "mine"
effects = ["compliant_contact", "lift_off"]
epsilon = "1e-3"
until = 1
[start]
p = "1/2"
b = -1
"""


def valid(data: object) -> bool:
    return not list(Draft202012Validator(scene_file_schema()).iter_errors(data))


def test_shipped_scenes_and_the_example_satisfy_the_schema() -> None:
    Draft202012Validator.check_schema(scene_file_schema())
    folder = resources.files("gspot_verified.scenes").joinpath("data")
    for name in SHIPPED:
        assert valid(tomllib.loads(folder.joinpath(f"{name}.toml").read_text(encoding="utf-8"))), name
    assert valid(tomllib.loads(TEXT))
    assert parse_scene(TEXT).name == "mine"


@pytest.mark.parametrize(
    "change",
    [
        {"format": 2},
        {"name": ""},
        {"surprise": 1},
        {"effects": ["lift_off"]},
        {"effects": ["compliant_contact", "compliant_contact"]},
        {"effects": ["compliant_contact", "gravity"]},
        {"effects": ["compliant_contact", "stick"]},
        {"effects": ["compliant_contact", "lift_off", "two_way_coupling"], "mechanism": "extended"},
        {"start": {"p": [1]}},
        {"epsilon": True},
    ],
)
def test_the_schema_refuses_what_the_reader_refuses(change: dict[str, Any]) -> None:
    data = {**GOOD, **change}
    assert valid(GOOD)
    assert not valid(data)
    with pytest.raises((SceneError, MechanismError)):
        parse_scene(toml(data))


def toml(data: dict[str, Any]) -> str:
    """As TOML, for the plain values above."""
    lines = [f"{key} = {value(item)}" for key, item in data.items() if not isinstance(item, dict)]
    for key, item in data.items():
        if isinstance(item, dict):
            lines += [f"[{key}]", *(f"{name} = {value(entry)}" for name, entry in item.items())]
    return "\n".join(lines)


def value(item: object) -> str:
    return str(item).lower() if isinstance(item, bool) else repr(item).replace("'", '"')


def test_nothing_that_a_schema_needs_may_be_missing() -> None:
    for key in GOOD:
        assert not valid({name: item for name, item in GOOD.items() if name != key})


DEEP = "[" * 5000 + "]" * 5000
HOSTILE = {
    "deep lists": (TEXT.replace("until = 1", f"until = {DEEP}"), "no TOML"),
    "deep tables": (TEXT + "\n[" + ".".join(["a"] * 3000) + "]\n", ""),
    "a long number": (TEXT.replace("b = -1", f"b = {'9' * 90_000}"), ""),
    "a long decimal": (TEXT.replace("b = -1", f"b = 0.{'9' * 90_000}"), "at most 100 digits"),
    "a huge exponent": (TEXT.replace("b = -1", "b = 1e999999999"), "exponent"),
    "a huge exponent as text": (TEXT.replace("b = -1", 'b = "1e99999"'), "a number of 332190 bits; at most 2000"),
    "a tiny epsilon as text": (TEXT.replace("1e-3", "1e-9999999"), "epsilon"),
    "a long fraction": (TEXT.replace("b = -1", f'b = "1/{"7" * 90_000}"'), "characters; at most"),
    "division by zero": (TEXT.replace("b = -1", 'b = "1/0"'), "b"),
    "infinity": (TEXT.replace("b = -1", "b = -inf"), "start.b"),
    "code": (TEXT.replace("b = -1", "b = \"__import__('os').abort()\""), "b"),
    "code as an effect": (TEXT.replace("lift_off", "__import__"), "unknown effect '__import__'"),
    "code as a parameter": (TEXT + '[parameters]\n"__class__" = 1\n', "unknown parameter '__class__'"),
    "many effects": (TEXT.replace('"lift_off"', ", ".join(['"lift_off"'] * 5000)), "5001 effects; there are 7"),
    "many parameters": (TEXT + "[parameters]\n" + "\n".join(f"a{i} = 1" for i in range(8000)), "unknown parameter"),
    "a giant file": (TEXT + "#" * 200_000, "at most 100000"),
    "no text": ("\0" * 50, "no TOML"),
    "a mechanism outside": (
        TEXT.replace("until", 'mechanism = "../../../dev/zero.toml"\nuntil', 1),
        "there is no file",
    ),
    "a mechanism with a zero": (TEXT.replace("until", 'mechanism = "a\\u0000.toml"\nuntil', 1), "there is no file"),
    "a nameless mechanism": (TEXT.replace("until", 'mechanism = ""\nuntil', 1), "no shipped mechanism"),
    "a long name": (TEXT.replace('"mine"', f'"{"m" * 5000}"'), "at most 80 characters"),
}


@pytest.mark.parametrize("case", HOSTILE)
def test_hostile_files_end_in_a_clear_error(case: str, tmp_path: Path) -> None:
    text, message = HOSTILE[case]
    path = tmp_path / "scene.toml"
    path.write_text(text, encoding="utf-8")
    load_scene("fig-varsim1")  # imports are not counted
    calls = 0

    def count(*_: object) -> None:
        nonlocal calls
        calls += 1

    before = sys.getprofile()
    sys.setprofile(count)
    try:
        with pytest.raises(ValueError, match=r"\S") as caught:
            load_scene(path)
    finally:
        sys.setprofile(before)
    assert calls < 20_000 + 30 * len(text)  # calls and returns: no more than in proportion to the file
    assert message in str(caught.value)
    assert len(str(caught.value)) < 2000


def test_a_formula_of_a_mechanism_s_start_is_no_code() -> None:
    for formula in (
        "phi_ref.__class__",
        "exec(1)",
        "phi_ref**phi_ref**phi_ref",
        "(" * 2000 + "1" + ")" * 2000,
        "9^9^9^9",
    ):
        with pytest.raises((SceneError, MechanismError)):
            load_scene("oscillator", phi=formula)


def test_what_is_no_text_file_is_not_read(tmp_path: Path) -> None:
    import os

    (tmp_path / "latin.toml").write_bytes("name = 'é'".encode("latin-1"))
    with pytest.raises(SceneError, match="not UTF-8 text"):
        load_scene(tmp_path / "latin.toml")
    os.mkfifo(tmp_path / "pipe.toml")
    with pytest.raises(SceneError, match="no scene file"):
        load_scene(tmp_path / "pipe.toml")
    text = TEXT.replace("until", 'mechanism = "pipe.toml"\nuntil', 1)
    with pytest.raises(SceneError, match=r"there is no file 'pipe\.toml'"):
        parse_scene(text, tmp_path)
