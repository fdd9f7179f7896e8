"""Scene files against their schema, and files of strangers: no code is run, hostile sizes end in a clear error."""

from __future__ import annotations

import dataclasses
import sys
import tomllib
from importlib import resources
from pathlib import Path
from typing import Any

import pytest
from flint import fmpq
from jsonschema import Draft202012Validator

from gspot_verified.functions.expressions import Constant
from gspot_verified.mechanisms.input.mechanism import MechanismError
from gspot_verified.mechanisms.shipped import shipped_mechanism
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
        {"start": "stick"},
        {"start": "slip", "state": {"p": "1/2", "b": -1, "y": 0, "v": 0, "z": 0}},
        {"state": {"p": "1/2", "b": -1}},
    ],
)
def test_the_schema_refuses_what_the_reader_refuses(change: dict[str, Any]) -> None:
    data = {**GOOD, **change}
    assert valid(GOOD)
    assert not valid(data)
    with pytest.raises((SceneError, MechanismError)):
        parse_scene(toml(data))


def test_a_start_on_the_slow_manifold() -> None:
    data = {**GOOD, "start": "slip", "state": {"p": "1/2", "b": -1}}
    assert valid(data)
    scene = parse_scene(toml(data))
    assert scene.on_slow_manifold
    assert scene.initial()["v"] != 0
    assert scene.initial() == parse_scene(TEXT).with_settings(start="slip").initial()
    assert parse_scene(TEXT).initial()["v"] == 0
    with pytest.raises(SceneError, match='key "state": it is for start = "slip"'):
        parse_scene(TEXT + "[state]\np = 1\n")


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


def test_the_longest_name_and_the_longest_file(tmp_path: Path) -> None:
    """80 characters of a name, 100 000 bytes of a file; one more is refused, and so is a line feed in a name."""
    assert parse_scene(TEXT.replace("mine", "m" * 80)).name == "m" * 80
    for name in ("m" * 81, "  ", "a\\nb", "a\\u0007"):
        with pytest.raises(SceneError, match='key "name" must be one line of visible text, at most 80 characters'):
            parse_scene(TEXT.replace("mine", name))
    longest = TEXT + "#" * (100_000 - len(TEXT))
    path = tmp_path / "scene.toml"
    path.write_text(longest, encoding="utf-8")
    assert load_scene(path) == parse_scene(longest) == parse_scene(TEXT)
    path.write_text(longest + "#", encoding="utf-8")
    with pytest.raises(SceneError, match="a scene file may have at most 100000 bytes"):
        load_scene(path)
    with pytest.raises(SceneError, match="a scene may have at most 100000 characters"):
        parse_scene(longest + "#")


def test_a_mark_of_byte_order_is_no_part_of_the_text(tmp_path: Path) -> None:
    path = tmp_path / "scene.toml"
    path.write_bytes(b"\xef\xbb\xbf" + TEXT.encode())
    assert load_scene(path) == parse_scene(TEXT)


def test_a_file_that_cannot_be_read_is_named(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "scene.toml"
    path.write_text(TEXT)

    def refused(*_: object, **__: object) -> None:
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr(Path, "open", refused)
    with pytest.raises(SceneError, match=r"scene\.toml: cannot be read: Permission denied$"):
        load_scene(path)


MECHANISM_TEXT = """
format = 1
name = "a rod"
mechanism = "rod"
effects = ["compliant_contact", "lift_off"]
epsilon = "1e-3"
until = "1/3"
stop_at_force = 5
[parameters]
k_1 = 2
mu = "5/4"
[start]
theta = "theta_ref - 1/10"
theta_dot = "1"
"""


def test_every_key_of_a_file_comes_to_its_place() -> None:
    """Parameters of the mechanism go to it, the others to the scene; a formula of the start stays a text."""
    found = parse_scene(MECHANISM_TEXT)
    assert (found.epsilon, found.until, found.stop_at_force) == (fmpq(1, 1000), fmpq(1, 3), fmpq(5))
    assert found.effects == ("compliant_contact", "lift_off")
    assert found.parameters == {"k_1": fmpq(2)}
    assert found.start == {"theta": "theta_ref - 1/10", "theta_dot": "1"}
    assert found.mechanism is not None
    assert dict(found.mechanism.parameters)["mu"] == Constant(fmpq(5, 4))
    plain = parse_scene(TEXT)
    assert (plain.stop_at_force, plain.mechanism, plain.parameters) == (None, None, {})
    assert plain.start == {"p": fmpq(1, 2), "b": fmpq(-1)}
    with pytest.raises(SceneError, match="unknown parameter 'mu'"):
        parse_scene(TEXT + '[parameters]\nmu = "5/4"\n')
    with pytest.raises((SceneError, MechanismError), match='"format" must be 1'):
        parse_scene(TEXT.replace("format = 1", "format = 2"))


def test_a_mechanism_s_file_is_looked_for_beside_the_scene(tmp_path: Path) -> None:
    from gspot_verified.mechanisms.shipped import shipped_mechanism

    place = resources.files("gspot_verified.mechanisms").joinpath("data", "falling_rod.toml")
    (tmp_path / "mine.toml").write_text(place.read_text(encoding="utf-8"), encoding="utf-8")
    text = MECHANISM_TEXT.replace('mechanism = "rod"', 'mechanism = "mine.toml"')
    found = parse_scene(text, tmp_path).mechanism
    assert found is not None
    assert found.state == shipped_mechanism("rod").state
    (tmp_path / "scene.toml").write_text(text, encoding="utf-8")
    assert load_scene(tmp_path / "scene.toml").mechanism == found
    with pytest.raises(SceneError, match=r"there is no file 'mine\.toml'"):
        parse_scene(text, tmp_path / "elsewhere")
    longest = f"{'./' * 495}/mine.toml"
    assert len(longest) == 1000
    assert parse_scene(text.replace("mine.toml", longest), tmp_path).mechanism == found
    with pytest.raises(SceneError, match=r"there is no file '\./"):
        parse_scene(text.replace("mine.toml", f"./{longest}"), tmp_path)
    with pytest.raises(SceneError, match=r"there is no file 'x+'$"):
        parse_scene(text.replace("mine.toml", "x" * 996 + ".toml"), tmp_path)


def test_a_parameter_of_the_mechanism_and_of_an_effect_is_refused() -> None:
    """One mechanism whose parameter is called k_1, as the stiffness of the contact is."""
    from gspot_verified.mechanisms.shipped import shipped_mechanism
    from gspot_verified.scenes.scene import file

    rod = shipped_mechanism("rod")
    clash = dataclasses.replace(rod, parameters=(*rod.parameters, ("k_1", fmpq(1))))
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(file, "shipped_mechanism", lambda _: clash)
        with pytest.raises(SceneError, match="parameter 'k_1' is one of the mechanism and of an effect"):
            parse_scene(MECHANISM_TEXT)


def test_a_name_that_is_nearly_one_of_the_package() -> None:
    with pytest.raises(SceneError, match=r"no scene of that name; did you mean 'fig-varsim[12]'"):
        load_scene("fig-varsim")
    with pytest.raises(SceneError, match=f"^no scene file '{'x' * 60}', and no scene of that name; there are: fig-"):
        load_scene("x" * 61)
    with pytest.raises(SceneError, match="no scene file"):
        load_scene(Path("rod"))  # a path is no name


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("format = 1", "", 'key "format" is missing'),
        ("format = 1", "format =", "no TOML"),
        ('"lift_off"', '"lift_of"', "unknown effect 'lift_of'; did you mean 'lift_off'?"),
        ("epsilon = 1e-3", 'epsilon = "1e400000"', "epsilon: the exponent of '1e400000' must lie within"),
        ("epsilon = 1e-3", 'epsilon = "-inf"', "epsilon: expected a number such as"),
        ("epsilon = 1e-3", "epsilon = -1", "epsilon must be > 0, got -1"),
    ],
)
def test_what_is_wrong_in_a_file_names_the_file(tmp_path: Path, old: str, new: str, said: str) -> None:
    path = tmp_path / "mine.toml"
    text = """format = 1
name = "mine"
effects = ["compliant_contact", "lift_off"]
epsilon = 1e-3
until = 1
parameters = {alpha_1 = -1, alpha_2 = -1, beta = "3/2"}
start = {p = "1/2", nu = 2}
"""
    path.write_text(text)
    assert load_scene(path).name == "mine"
    path.write_text(text.replace(old, new))
    with pytest.raises((SceneError, MechanismError), match=f"^{path}: ") as refused:
        load_scene(path)
    assert said in str(refused.value)


def test_a_wrong_setting_is_not_the_file_s(tmp_path: Path) -> None:
    path = tmp_path / "mine.toml"
    path.write_text(resources.files("gspot_verified.scenes").joinpath("data", "fig-varsim1.toml").read_text())
    with pytest.raises(SceneError, match=r"^no setting 'nosuch'"):
        load_scene(path, nosuch=1)


def test_a_mechanism_is_no_scene() -> None:
    with pytest.raises(TypeError, match=r"a mechanism is no scene: scene_before_spot\(mechanism, 1\) makes one"):
        load_scene(shipped_mechanism("rod"))  # type: ignore[arg-type]
