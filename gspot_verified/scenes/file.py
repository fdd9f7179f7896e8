"""Scenes in TOML files, and those that come with the package. No code of a file is run; numbers are exact."""

from __future__ import annotations

from importlib import resources
from pathlib import Path

from flint import fmpq

from gspot_verified.balls import ExactInput
from gspot_verified.mechanisms.names import nearest
from gspot_verified.mechanisms.toml_table import TomlTable, toml_table
from gspot_verified.scenes.scene import START_KEYS, Scene, SceneError
from gspot_verified.signs.contact_force import rational

SHIPPED = ("fig-varsim1", "fig-varsim2")
MAX_CHARACTERS = 100_000
_KEYS = {
    "": ("format", "name", "source", "effects", "epsilon", "until", "stop_at_force", "parameters", "start"),
    "start": START_KEYS,
}


def load_scene(name_or_path: str | Path, /, **settings: ExactInput | None) -> Scene:
    """The scene in a TOML file, or the one of the package with that name; ``settings`` as in ``Scene.with_settings``.

    :raises SceneError: neither a file nor a name, or a part of the scene is wrong.
    :raises MechanismError: no TOML, or a key is wrong.

    >>> load_scene("fig-varsim1", nu=2, eps="1e-3").system("slip").states
    ('b', 'Y', 'V', 'Z')
    """
    path = Path(name_or_path)
    if isinstance(name_or_path, str) and name_or_path in SHIPPED:
        place = resources.files("gspot_verified.scenes").joinpath("data", f"{name_or_path}.toml")
        text = place.read_text(encoding="utf-8")
    elif path.is_file():
        if path.stat().st_size > MAX_CHARACTERS:
            raise SceneError(f"a scene file may have at most {MAX_CHARACTERS} bytes: {path}")
        text = path.read_text(encoding="utf-8")
    else:
        hint = nearest(str(name_or_path), SHIPPED)
        shown = str(name_or_path)[:60]
        raise SceneError(f"no scene file {shown!r}, and no scene of that name{hint}; there are: {', '.join(SHIPPED)}")
    return parse_scene(text).with_settings(**settings)


def parse_scene(text: str) -> Scene:
    """The scene that a TOML text describes.

    :raises SceneError: a part of the scene is wrong.
    :raises MechanismError: no TOML, or a key is wrong.
    """
    table = toml_table(text)
    table.only(_KEYS)
    if table.get("format", int, "1") != 1:
        raise SceneError('key "format" must be 1')
    start = table.table("start")
    start.only(_KEYS)
    return Scene(
        table.text("name"),
        tuple(table.words("effects")),
        _number(table, "epsilon"),
        _number(table, "until"),
        _numbers(table.table("parameters")),
        _numbers(start),
        _number(table, "stop_at_force") if table.has("stop_at_force") else None,
    )


def _number(table: TomlTable, name: str) -> fmpq:
    return rational(table.formula(name), table.key(name))


def _numbers(table: TomlTable) -> dict[str, fmpq]:
    return {name: _number(table, name) for name in table.names()}
