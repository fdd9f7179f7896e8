"""The one way to a mechanism."""

from __future__ import annotations

from importlib import resources
from pathlib import Path

import pytest

from gspot_verified.mechanisms.input.file import read_mechanism
from gspot_verified.mechanisms.input.mechanism import MechanismError
from gspot_verified.mechanisms.load import load
from gspot_verified.mechanisms.shipped import SHORT_NAMES, shipped_mechanism, shipped_names
from gspot_verified.scenes.scene.file import load_scene

DATA = resources.files("gspot_verified.mechanisms").joinpath("data")


@pytest.mark.parametrize("name", [*SHORT_NAMES, *shipped_names()])
def test_a_name_of_the_package(name: str) -> None:
    assert load(name) == shipped_mechanism(name)


def test_a_file_and_values_for_its_parameters(tmp_path: Path) -> None:
    own = tmp_path / "own.toml"
    own.write_text(DATA.joinpath("extended_system.toml").read_text(encoding="utf-8"), encoding="utf-8")
    assert load(own) == load(str(own)) == load("extended")
    assert load(own, chi="1/2") == load("extended").changed(chi="1/2")
    assert dict(load(own, chi=None).parameters)["chi"] is None


def test_the_name_says_which_values_are_others() -> None:
    """Statements begin with the name: with mu = 3/2 they are not on the rod of the file."""
    assert load("rod", m="1.0", mu="1.5", g=2).name == "falling rod, g = 2, mu = 3/2"
    assert load("extended", chi=None).name == "extended system"


def test_a_file_without_a_suffix_comes_before_a_name(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    text = DATA.joinpath("extended_system.toml").read_text(encoding="utf-8")
    (tmp_path / "rod").write_text(text, encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    assert load("rod").name == "extended system"
    assert load(Path("rod")).name == "extended system"


def test_a_path_is_never_a_name() -> None:
    with pytest.raises(MechanismError, match="oscillator: cannot be read"):
        load(Path("oscillator"))


@pytest.mark.parametrize(
    ("name", "message"),
    [("nothing", "there is no file 'nothing', and no shipped mechanism"), ("no.toml", "no.toml: cannot be read")],
)
def test_what_is_not_there(name: str, message: str) -> None:
    with pytest.raises(MechanismError, match=message):
        load(name)


@pytest.mark.parametrize("name", ["arm.urdf", "ARM.URDF", "arm.xml", "arm.mjcf"])
def test_a_robot_is_sent_to_its_reader(name: str, tmp_path: Path) -> None:
    (tmp_path / name).write_text("<robot/>", encoding="utf-8")
    reader = "from_urdf" if name.lower().endswith("urdf") else "from_mjcf"
    for given in (tmp_path / name, str(tmp_path / name)):
        for read in (load, load_scene, read_mechanism):
            with pytest.raises(MechanismError, match=f"a robot; {reader}.*does not say what touches"):
                read(given)


def test_a_folder_is_said_to_be_one(tmp_path: Path) -> None:
    with pytest.raises(MechanismError, match="is a folder, and no shipped mechanism"):
        load(str(tmp_path))


def test_an_unknown_parameter() -> None:
    with pytest.raises(MechanismError, match="no parameter 'nu'"):
        load("extended", nu=1)


def test_what_is_no_name() -> None:
    with pytest.raises(TypeError, match="a path or a name, got int"):
        load(3)  # type: ignore[arg-type]


def test_an_empty_name_is_no_folder() -> None:
    with pytest.raises(MechanismError, match="there is no file ''"):
        load("")


def test_a_wrong_file_is_refused_with_its_place(tmp_path: Path) -> None:
    own = tmp_path / "own.toml"
    own.write_text('name = "own"\nwrong = 1\n', encoding="utf-8")
    with pytest.raises(MechanismError, match=r"own\.toml: "):
        load(own)


@pytest.mark.parametrize("friction", ["-1/2", "-1/1000000000"])
def test_a_mechanism_that_no_mechanism_is_like_is_refused(friction: str) -> None:
    with pytest.raises(MechanismError, match=r"^genot_brogliato_rod: "):
        load("genot_brogliato_rod", mu=friction)
    assert load("genot_brogliato_rod", mu=0).name == f"{load('genot_brogliato_rod').name}, mu = 0"
