"""Read a scene from a TOML file, or one of those that come with the package.

For example::

    format = 1
    name = "a rod that falls"
    mechanism = "rod"
    effects = ["compliant_contact", "lift_off", "tangential_motion", "stick"]
    epsilon = 1e-4
    until = "1/2"

    [parameters]
    mu = 2

    [start]
    theta = "theta_ref + 1/10"
    theta_dot = 1
    X_dot = 2

The keys::

    format           1
    name             one line of visible text
    source           a text for readers
    mechanism        of the package, or the path of a TOML file from this file's folder; the model if missing
    effects          names of effects; `gspot-verified scenes` lists them
    epsilon          > 0
    until            > 0: the time, from the start, at which runs end
    stop_at_force    optional, > 1: a run ends where p < 0 and the force is this many times that of rigid slip at the
                     start, -b/p; a certified one where that is certain, after an impact without collision was shown
    parameters.*     numbers of the effects, of the model, or of the mechanism
    start.*          the model: p, b or nu, and u, x with their effects; a mechanism: components of its state, as
                     numbers or formulas; y, v, z or none of them
    start = "slip"   y, v, z are those of an exact point next to the slow manifold of slip; the components then stand
                     in the table `state`

No code of a file is run. Numbers are exact: integers, decimals (0.1 is 1/10), or texts such as "7/3"; they stand
without units, in those of the mechanism.
"""

from __future__ import annotations

import json
import os
from importlib import resources
from pathlib import Path
from typing import Any

from flint import fmpq

from gspot_verified.mechanisms.formulas.names import nearest
from gspot_verified.mechanisms.input.file import read_mechanism, refuse_robot
from gspot_verified.mechanisms.input.mechanism import Mechanism, MechanismError
from gspot_verified.mechanisms.input.toml_table import TomlTable, toml_table
from gspot_verified.mechanisms.shipped import shipped_mechanism
from gspot_verified.numbers.balls import ExactInput
from gspot_verified.scenes.effects.catalogue import EFFECTS
from gspot_verified.scenes.scene.numbers import scene_number
from gspot_verified.scenes.scene.scene import SLIP_START, Scene, SceneError, checked_owner, checked_start

SHIPPED = ("fig-varsim1", "fig-varsim2", "oscillator", "oscillator-canard", "extended", "rod", "stribeck")
MAX_BYTES = 100_000  # of a scene file, so that a wrong file is refused at once
_IS_A_MECHANISM = "is a mechanism, not a scene: with a G-spot's number, --spot 1, slip starts just before that"
KEYS = {
    "": (
        "format",
        "name",
        "source",
        "mechanism",
        "effects",
        "epsilon",
        "until",
        "stop_at_force",
        "parameters",
        "start",
        "state",
    ),
}


def scene_names() -> tuple[str, ...]:
    """The scenes that come with the package: the names that :func:`load_scene` knows.

    The command is ``scenes``; that word is the subpackage here.

    >>> scene_names()[:2]
    ('fig-varsim1', 'fig-varsim2')
    """
    return SHIPPED


def load_scene(name_or_path: str | Path, /, **settings: ExactInput | None) -> Scene:
    """The scene in a TOML file, or the one of the package with that name; ``settings`` as in ``Scene.with_settings``.

    :raises SceneError: neither a file nor a name, or a part of the scene is wrong; the message names the file.
    :raises MechanismError: no TOML, a key is wrong, or the mechanism is; likewise.

    >>> load_scene("fig-varsim1", nu=2, epsilon="1e-3").system("slip").states
    ('b', 'Y', 'V', 'Z')
    >>> load_scene("oscillator", phi_dot="-1/2").system("slip").states
    ('phi', 'phi_dot', 'Y', 'V', 'Z')
    """
    if isinstance(name_or_path, Mechanism):
        raise TypeError(
            "a mechanism is no scene: scene_before_spot(mechanism, 1) makes one, which starts before a G-spot"
        )
    path = Path(name_or_path)
    if isinstance(name_or_path, str) and name_or_path in SHIPPED:
        place = resources.files("gspot_verified.scenes").joinpath("data", f"{name_or_path}.toml")
        scene = parse_scene(place.read_text(encoding="utf-8"))
    elif path.is_file():
        scene = _scene_of_file(path)
    else:
        hint = nearest(str(name_or_path), SHIPPED)
        shown = str(name_or_path)[:60]
        if isinstance(name_or_path, str) and _names_a_mechanism(name_or_path):
            raise SceneError(f"{shown!r} {_IS_A_MECHANISM}")
        raise SceneError(f"no scene file {shown!r}, and no scene of that name{hint}; there are: {', '.join(SHIPPED)}")
    return scene.with_settings(**settings)


def files_read(name_or_path: str | Path) -> list[Path]:
    """The files that :func:`load_scene` reads: that of the scene, and that of its mechanism, if it names one.

    >>> files_read("rod")
    []
    """
    path = Path(name_or_path)
    if name_or_path in SHIPPED or not os.path.isfile(path):  # False also for what can be no path
        return []
    try:
        table = toml_table(_text(path))
    except ValueError:  # load_scene says what is wrong
        return [path]
    named = table.text("mechanism") if table.is_text("mechanism") else ""
    return [path, *([path.parent / named] if named.endswith(".toml") else [])]


def scene_file_schema() -> dict[str, Any]:
    """The schema (JSON Schema, draft 2020-12) of scene files, for editors and other programs.

    >>> scene_file_schema()["$id"]
    'gspot-verified/scene-file/1'
    """
    place = resources.files("gspot_verified.scenes").joinpath("data", "scene_file.json")
    schema: dict[str, Any] = json.loads(place.read_text(encoding="utf-8"))
    return schema


def parse_scene(text: str, folder: Path | None = None) -> Scene:
    """The scene that a TOML text describes; the path of a mechanism counts from ``folder``.

    :raises SceneError: a part of the scene is wrong.
    :raises MechanismError: no TOML, a key is wrong, or the mechanism is.

    >>> scene = parse_scene('''
    ... format = 1
    ... name = "the model at a smaller epsilon"
    ... effects = ["compliant_contact", "lift_off"]
    ... epsilon = "1/2000"
    ... until = 1
    ... parameters = {alpha_1 = -1, alpha_2 = -1, beta = "3/2"}
    ... start = {p = "1/2", nu = 2}
    ... ''')
    >>> scene.epsilon, scene.system("slip").states
    (1/2000, ('b', 'Y', 'V', 'Z'))
    """
    if len(text) > MAX_BYTES:
        raise SceneError(f"a scene may have at most {MAX_BYTES} characters")
    table = toml_table(text)
    if table.has("contact") or table.has("fields"):
        raise SceneError(f"this {_IS_A_MECHANISM}")
    table.only(KEYS)
    if table.get("format", int, "1") != 1:
        raise SceneError('key "format" must be 1')
    name = table.text("name")
    if not name.strip() or not name.isprintable() or len(name) > 80:
        raise SceneError('key "name" must be one line of visible text, at most 80 characters')
    mechanism = _mechanism(table.text("mechanism"), folder) if table.has("mechanism") else None
    effects = tuple(table.words("effects"))
    if len(effects) > len(EFFECTS):
        raise SceneError(f"{len(effects)} effects; there are {len(EFFECTS)}: {', '.join(EFFECTS)}")
    slow = table.is_text("start") and checked_start(table.text("start"))
    if table.has("state") and not slow:
        raise SceneError(f'key "state": it is for start = "{SLIP_START}"; otherwise give the table `start`')
    given = table.table("parameters").all_formulas()
    own = {} if mechanism is None else {key: given.pop(key) for key in list(given) if key in dict(mechanism.parameters)}
    scene = Scene(
        name=name,
        effects=effects,
        epsilon=_number(table, "epsilon"),
        until=_number(table, "until"),
        parameters={key: scene_number(value, f"parameters: {key[:40]}") for key, value in given.items()},
        start=_start(table.table("state" if slow else "start").all_formulas(), mechanism is not None),
        stop_at_force=_number(table, "stop_at_force") if table.has("stop_at_force") else None,
        mechanism=mechanism
        if mechanism is None
        else mechanism.with_parameters(**{key: _value(own[key], key) for key in own}),
        on_slow_manifold=slow,
    )
    for key in own:
        checked_owner(scene.defaults(), key)
    return scene


def _names_a_mechanism(name: str) -> bool:
    try:
        shipped_mechanism(name)
    except MechanismError:
        return False
    return True


def _scene_of_file(path: Path) -> Scene:
    refuse_robot(path)
    text = _text(path)
    try:
        return parse_scene(text, path.parent)
    except MechanismError as error:
        raise MechanismError(f"{path}: {error}") from None
    except ValueError as error:
        raise SceneError(f"{path}: {error}") from None


def _text(path: Path) -> str:
    try:
        with path.open("rb") as stream:
            data = stream.read(MAX_BYTES + 1)
    except OSError as error:
        raise SceneError(f"{path}: cannot be read: {error.strerror or error}") from None
    if len(data) > MAX_BYTES:
        raise SceneError(f"{path}: a scene file may have at most {MAX_BYTES} bytes")
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError:
        raise SceneError(f"{path}: not UTF-8 text") from None


def _mechanism(name: str, folder: Path | None) -> Mechanism:
    """A mechanism of the package, or a file; what is no ordinary file is not opened."""
    if not name.endswith(".toml"):
        return shipped_mechanism(name)
    path = (folder or Path()) / name
    if "\0" in name or len(name) > 1000 or not path.is_file():
        raise SceneError(f"mechanism: there is no file {name[:100]!r}")
    return read_mechanism(path)


def _start(given: dict[str, Any], beside_mechanism: bool) -> dict[str, fmpq | str]:
    """Formulas stay texts where a mechanism reads them."""
    return {
        key: value if isinstance(value, str) and beside_mechanism else scene_number(value, f"start: {key[:40]}")
        for key, value in given.items()
    }


def _value(value: Any, name: str) -> fmpq:
    return scene_number(value, f"parameters: {name}")


def _number(table: TomlTable, name: str) -> fmpq:
    return scene_number(table.formula(name), table.key(name))
