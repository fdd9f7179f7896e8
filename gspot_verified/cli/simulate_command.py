"""Commands ``simulate`` and ``scenes``."""

from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from gspot_verified.cli.app import JsonFlag, app, print_json, warn
from gspot_verified.cli.output import Outputs

if TYPE_CHECKING:
    from gspot_verified.scenes.run import SceneRun
    from gspot_verified.scenes.samples import Samples
    from gspot_verified.scenes.scene import Scene


@app.command(epilog="Example: gspot-verified simulate fig-varsim1 --beta 3/2 --nu 2 --eps 1e-3")
def simulate(
    scene: Annotated[str, typer.Argument(help="A scene's TOML file, or a name that `scenes` lists.")],
    beta: Annotated[str | None, typer.Option(help="β, in place of the scene's.")] = None,
    nu: Annotated[str | None, typer.Option(help="ν of the initial values, in place of the scene's.")] = None,
    eps: Annotated[str | None, typer.Option("--eps", help="ε, in place of the scene's.")] = None,
    settings: Annotated[list[str] | None, typer.Option("--set", help="name=value, as often as needed.")] = None,
    floats: Annotated[bool, typer.Option("--float", help="A quick run with floats: nothing is proved.")] = False,
    compare: Annotated[bool, typer.Option("--compare", help="A run with floats beside the certified one.")] = False,
    method: Annotated[str, typer.Option(help="Of the float run: Radau, LSODA or BDF.")] = "Radau",
    tolerance: Annotated[float, typer.Option(help="Of the float run, relative.")] = 1e-10,
    digits: Annotated[int, typer.Option(help="Of the certified run, decimals of the lift-off time, 1..80.")] = 15,
    csv: Annotated[Path | None, typer.Option(help="Write the float run's steps to this file.")] = None,
    npz: Annotated[Path | None, typer.Option(help="Write the float run's steps to this file of numpy arrays.")] = None,
    as_json: JsonFlag = False,
) -> None:
    """What a scene does: lift-off, touch-down, stick, impact without collision; certified, or simulated with --float.

    Exit code 0 when the certified run is proved, 2 when something is undecided: a float run always is.
    """
    from gspot_verified.scenes.certified_run import certified_run
    from gspot_verified.scenes.file import load_scene
    from gspot_verified.scenes.float_run import float_run
    from gspot_verified.scenes.run import agreement

    if floats and compare:
        raise ValueError("give --float or --compare, not both")
    if (csv is not None or npz is not None) and not (floats or compare):
        raise ValueError("--csv and --npz write a float run: give --float or --compare")
    outputs = Outputs()
    outputs.file("--csv", csv, (".csv",))
    outputs.file("--npz", npz, (".npz",))
    loaded = load_scene(scene).with_settings(**{**_settings(settings or []), **_given(beta=beta, nu=nu, eps=eps)})
    certified = None if floats else certified_run(loaded, digits)
    simulated = float_run(loaded, method, tolerance) if floats or compare else None
    runs = [run for run in (certified, simulated) if run is not None]
    agree = None if certified is None or simulated is None else agreement(simulated, certified)
    if as_json:
        print_json({"scene": _scene_json(loaded), "runs": [run.to_json() for run in runs], "agree": agree})
    else:
        _show(loaded, runs)
    if agree is False:
        warn("the float run contradicts the certified one")
    if simulated is not None and simulated.samples is not None:
        samples = simulated.samples
        if csv is not None:
            outputs.write("--csv", csv, lambda: _write_csv(csv, samples))
        if npz is not None:
            outputs.write("--npz", npz, lambda: _write_npz(npz, samples))
    outputs.leave(runs[0].verdict.exit_code)


@app.command(epilog="Example: gspot-verified scenes")
def scenes() -> None:
    """The scenes that come with the package, their effects, and what leaving out the others assumes."""
    from gspot_verified.scenes.effects.catalogue import EFFECTS
    from gspot_verified.scenes.file import SHIPPED, load_scene

    for name in SHIPPED:
        typer.echo(f"{name}: {', '.join(load_scene(name).effects)}")
    typer.echo("effects, and what a scene without them assumes:")
    for name, effect in EFFECTS.items():
        typer.echo(f"  {name}: {effect.left_out}")


def _given(**settings: str | None) -> dict[str, str]:
    return {name: value for name, value in settings.items() if value is not None}


def _settings(words: list[str]) -> dict[str, str]:
    found: dict[str, str] = {}
    for word in words:
        name, equals, value = (part.strip() for part in word.partition("="))
        if not equals or not name.isidentifier() or name in found:
            raise ValueError(f"--set: expected name=value, each name once, got {word[:60]!r}")
        found[name] = value
    return found


def _scene_json(scene: Scene) -> dict[str, Any]:
    return {
        "name": scene.name,
        "effects": list(scene.effects),
        "epsilon": str(scene.epsilon),
        "parameters": {name: str(value) for name, value in scene.values().items()},
        "start": {name: str(value) for name, value in scene.initial().items()},
    }


def _show(scene: Scene, runs: list[SceneRun]) -> None:
    for run in runs:
        typer.echo(str(run))
    start = ", ".join(f"{name} = {value}" for name, value in scene.initial().items())
    typer.echo(f"  {scene.name}, ε = {scene.epsilon}, from {start}")


def _write_csv(path: Path, samples: Samples) -> None:
    import csv

    names = list(samples.columns)
    beside = path.with_name(f".{path.name}.part")
    with beside.open("w", encoding="utf-8", newline="") as stream:
        writer = csv.writer(stream)
        writer.writerow([*names, "phase"])
        rows = zip(*(map(float, samples.columns[name]) for name in names), samples.phases, strict=True)
        writer.writerows(rows)
    os.replace(beside, path)


def _write_npz(path: Path, samples: Samples) -> None:
    import numpy as np

    beside = path.with_name(f".{path.name}.part")
    with beside.open("wb") as stream:
        np.savez_compressed(stream, allow_pickle=False, phase=np.array(samples.phases), **samples.columns)
    os.replace(beside, path)
