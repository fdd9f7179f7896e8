"""Commands ``simulate`` and ``scenes``."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, NoReturn

import typer

from gspot_verified.cli.app import JsonFlag, app, print_json, progress, refuse, warn
from gspot_verified.cli.command_groups import example
from gspot_verified.cli.output import PICTURES, Outputs

if TYPE_CHECKING:
    from flint import arb, fmpq

    from gspot_verified.scenes.scene.run import SceneRun
    from gspot_verified.scenes.scene.scene import Scene

_PICTURE_POINTS = 21  # samples for a picture, if their number is not given; boxes take their place where there are some
_FILE_POINTS = 101  # the same for a file


@app.command(epilog=example("simulate fig-varsim1 --beta 3/2 --nu 2 --epsilon 1e-3"))
def simulate(
    scene: Annotated[
        str,
        typer.Argument(
            help="A scene's TOML file, or a name that `scenes` lists; with --spot a mechanism, as in classify."
        ),
    ],
    spot: Annotated[
        int | None, typer.Option(help="Start on slip just before this G-spot: its number in `classify --all`.")
    ] = None,
    beta: Annotated[str | None, typer.Option(help="β, in place of the scene's.")] = None,
    nu: Annotated[str | None, typer.Option(help="ν of the initial values, in place of the scene's.")] = None,
    epsilon: Annotated[str | None, typer.Option("--epsilon", "--eps", help="ε, in place of the scene's.")] = None,
    until: Annotated[
        str | None,
        typer.Option(help="How long to look: a time after the start, in place of the scene's; as 2 or 1/10."),
    ] = None,
    settings: Annotated[
        list[str] | None, typer.Option("--set", metavar="NAME=VALUE", help='Another value, "mu=3/4".')
    ] = None,
    add: Annotated[
        list[str] | None, typer.Option("--add-effect", metavar="EFFECT", help="An effect more; `scenes` lists them.")
    ] = None,
    drop: Annotated[
        list[str] | None, typer.Option("--drop-effect", metavar="EFFECT", help="An effect of the scene less.")
    ] = None,
    floats: Annotated[bool, typer.Option("--float", help="A quick run with floats: nothing is proved.")] = False,
    compare: Annotated[bool, typer.Option("--compare", help="A run with floats beside the certified one.")] = False,
    method: Annotated[str | None, typer.Option(help="Of the float run: Radau (if left out), LSODA or BDF.")] = None,
    tolerance: Annotated[float | None, typer.Option(help="Of the float run, relative; 1e-10 if left out.")] = None,
    digits: Annotated[
        int | None, typer.Option(help="Of the certified run, decimals of the times, 1..80; 15 if left out.")
    ] = None,
    route: Annotated[
        str | None,
        typer.Option(help='Of the certified run: "exact" or "integrator"; the exact solution if it decides.'),
    ] = None,
    points: Annotated[
        int | None,
        typer.Option(
            help="Samples at so many equal steps of time; the float run and the integrator: own steps if missing."
        ),
    ] = None,
    csv: Annotated[Path | None, typer.Option(help="Write the samples: of the float run if there is one.")] = None,
    npz: Annotated[Path | None, typer.Option(help="The same as numpy arrays.")] = None,
    picture: Annotated[
        Path | None, typer.Option(help="Draw λ_N, y, b, own coordinates: PNG, PDF or SVG by the suffix.")
    ] = None,
    animation: Annotated[
        Path | None,
        typer.Option(help="Draw the mechanism in motion: an SVG that browsers play. Of the same run as --csv."),
    ] = None,
    journal: Annotated[
        Path | None, typer.Option(help="Keep what is done here; the same command goes on after a kill.")
    ] = None,
    certificate: Annotated[
        Path | None,
        typer.Option(
            help="Write a certificate of the integrator's run of a model scene, for `check` to prove it again."
        ),
    ] = None,
    budget: Annotated[
        int | None,
        typer.Option(help="How many steps the integrator may make at each precision; 20 000 if left out."),
    ] = None,
    as_json: JsonFlag = False,
) -> None:
    """What happens in a scene: certified, or with floats. Lift-off, touch-down, stick, impact without collision.

    A mechanism with --spot N needs no scene file: it starts just in contact, p about a 32nd part of C or less, with
    stick, slip and lift-off; ε = 1/1000, and the time is ten times that which p takes to fall to 0. All of it can be
    changed by --set, --epsilon, --until.

    Events are listed up to --until, all of them; a run also ends where an impact without collision lasts for ever, or
    has made the force as large as stop_at_force of the scene. The
    exact solution answers for all times, whatever --until is: it is used for the linear model scene where it decides.
    --set start=slip starts next to the slow manifold of slip, at an exact point; otherwise y, v, z are the scene's. How
    much of a fast oscillation of the start is left at the G-spot is printed.
    What each effect brings is printed beside the run: states and operations in slip, and phases. --drop-effect leaves
    out what was given for the effect, too; an effect that --add-effect brings may need --set, as u=70.
    --certificate writes what `check` needs to prove the run again without this package: every step, every event and
    their order. It covers the model scenes from a start in contact and slip.
    --journal keeps what the integrator chose for each step, and proves all of it again when it goes on; with --compare
    the float run has FILE.float. Samples of a certified run are enclosures: a column of midpoints and one of radii, of
    the time, too; a row holds at one time within t_radius of its t, not certainly at the rounded number t.
    What the effects that are left out assume of the motion is checked along the run: where it fails, the run is refuted
    as a statement on the motion with them; where it is not certain, the statement says "provided that". Exit code 0
    when the certified run is proved, 1 when it is refuted, 2 when something is undecided: a float run always is.
    """
    from gspot_verified.scenes.certified_run import EXACT
    from gspot_verified.scenes.scene.file import files_read, load_scene
    from gspot_verified.scenes.scene.run import agreement
    from gspot_verified.scenes.scene.scene import checked_owner
    from gspot_verified.scenes.simulate import simulate as run_of

    if floats and compare:
        raise ValueError("give --float or --compare, not both")
    if floats:
        of_certified = {"--digits": digits, "--route": route, "--budget": budget}
        refuse("it is for a certified run, not for one with --float", of_certified)
    elif not compare:
        refuse("it is for a float run; add --float or --compare", {"--method": method, "--tolerance": tolerance})
    if route == EXACT:
        of_steps = {"--budget": budget, "--journal": None if compare else journal}
        refuse(f"it is for the integrator, which --route {EXACT} leaves out", of_steps)
    if certificate is not None:
        others = {"--float": floats, "--compare": compare, "--points": points, "--journal": journal}
        others |= {"--csv": csv, "--npz": npz, "--picture": picture, "--animation": animation}
        refuse("not together with --certificate", others | {"--route": route if route == EXACT else None})
    elif all(place is None for place in (csv, npz, picture, animation)):
        refuse("it goes with --csv, --npz, --picture or --animation", {"--points": points})
    outputs = Outputs()
    for read in (scene, *(files_read(scene) if spot is None else ())):
        outputs.reads(read)
    outputs.file("--certificate", certificate)
    outputs.file("--csv", csv, (".csv",))
    outputs.file("--npz", npz, (".npz",))
    outputs.file("--picture", picture, PICTURES)
    outputs.file("--animation", animation, (".svg",))
    outputs.file("--journal", journal)
    of_floats = journal.with_name(f"{journal.name}.float") if journal is not None and compare else journal
    if of_floats != journal:
        outputs.file("--journal with --compare", of_floats)
    changes = _given(settings or [], beta=beta, nu=nu, epsilon=epsilon, until=until)
    given = [*changes]
    loaded = load_scene(scene) if spot is None else _before(scene, spot, changes)
    loaded = loaded.with_effects(add or (), drop or (), **changes)
    for name in given:
        if name not in changes:  # it was one of the mechanism
            checked_owner(loaded.defaults(), name)
    if certificate is not None:
        _certify(outputs, loaded, digits, budget, certificate, as_json)
    if animation is not None:
        from gspot_verified.report.pictures.mechanism_animation import check_animated

        check_animated(loaded)
    sampled = None
    of_samples = csv is not None or npz is not None or animation is not None
    if picture is not None or (of_samples and not compare):
        sampled = (_PICTURE_POINTS if csv is None and npz is None else _FILE_POINTS) if points is None else points
    certified = simulated = None
    with outputs.journal(journal):
        if floats or compare:  # first, because it is quick: what it refuses is refused before the long work
            simulated = run_of(
                loaded, floats=True, method=method, tolerance=tolerance, points=points, journal=of_floats
            )
        if not floats:
            certified = run_of(
                loaded,
                digits=digits,
                route=route,
                budget=budget,
                points=sampled,
                journal=journal,
                progress=_after_estimate(loaded),
            )
    runs = [run for run in (certified, simulated) if run is not None]
    agree = None if certified is None or simulated is None else agreement(simulated, certified)
    if as_json:
        print_json({"scene": _scene_json(loaded), "runs": [run.to_json() for run in runs], "agree": agree})
    else:
        _show(loaded, runs)
    if agree is False:
        warn("the float run contradicts the certified one")
    if certified is not None and certified.route == EXACT:
        for option, value in (("--journal", journal), ("--budget", budget)):
            if value is not None:
                warn(f"{option}: the exact solution decided this run without steps; --route integrator makes some")
    for note in (note for run in runs for note in run.notes):
        outputs.missing("--journal", note)
    _write(outputs, loaded, runs, csv, npz, picture, animation)
    outputs.leave(runs[0].verdict.exit_code)


def _certify(
    outputs: Outputs, scene: Scene, digits: int | None, budget: int | None, file: Path, as_json: bool
) -> NoReturn:
    """The run by the integrator, with its certificate."""
    from gspot_verified.certificates.text import write_text
    from gspot_verified.scenes.certificates.run_certificate import certified_with_steps
    from gspot_verified.scenes.certified.certified_integration import MAX_STEPS

    accuracy, steps = 15 if digits is None else digits, MAX_STEPS if budget is None else budget
    run, text, why = certified_with_steps(scene, accuracy, steps, progress)
    if as_json:
        print_json({"scene": _scene_json(scene), "runs": [run.to_json()], "agree": None})
    else:
        _show(scene, [run])
    if text is None:
        warn(f"--certificate: {why}; {file} was not written")
    elif outputs.write("--certificate", file, lambda: write_text(file, text)) and not as_json:
        typer.echo(f"  certificate of this run: {file}")
    outputs.leave(run.verdict.exit_code)


@app.command(epilog=example("scenes"))
def scenes(as_json: JsonFlag = False) -> None:
    """The scenes of the package, and the effects to choose from.

    With what leaving an effect out assumes, what excludes what, and what is outside.
    """
    from gspot_verified.scenes.effects.catalogue import EFFECTS, EXCLUSIONS, OUTSIDE
    from gspot_verified.scenes.scene.file import SHIPPED, load_scene

    loaded = [load_scene(name) for name in SHIPPED]
    if as_json:
        effects = [
            {
                "name": name,
                "left_out": effect.left_out,
                "needs": list(effect.needs),
                "parameters": {n: str(v) for n, v in {**effect.parameters, **effect.model_parameters}.items()},
            }
            for name, effect in EFFECTS.items()
        ]
        exclusions = [{"first": a, "second": b, "reason": reason} for (a, b), reason in EXCLUSIONS.items()]
        print_json({"scenes": [_scene_json(scene) for scene in loaded], "effects": effects, "exclusions": exclusions})
        return
    for scene in loaded:
        typer.echo(f"{scene.name} ({_moving(scene)}): {', '.join(scene.effects)}")
    typer.echo("effects, and what a scene without them assumes:")
    for name, effect in EFFECTS.items():
        needs = f" (needs {', '.join(effect.needs)})" if effect.needs else ""
        typer.echo(f"  {name}{needs}: {effect.left_out}")
    typer.echo("what excludes what:")
    for (first, second), reason in EXCLUSIONS.items():
        typer.echo(f"  {first} and {second}: {reason}")
    typer.echo("what is no effect:")
    for name, reason in OUTSIDE.items():
        typer.echo(f"  {name}: {reason}")


def _after_estimate(scene: Scene) -> Callable[[str], None]:
    """Signs of life, before the first of them what the whole run may cost; a short run gives none."""
    first = True

    def say(step: str) -> None:
        nonlocal first
        if first:
            from gspot_verified.scenes.floats.fast_oscillation import fast_oscillation

            first, found = False, fast_oscillation(scene)
            if found is not None:
                progress(str(found))
        progress(step)

    return say


def _before(name: str, spot: int, given: dict[str, str]) -> Scene:
    """The scene before a mechanism's G-spot: its parameters leave ``given``, and are set before."""
    from gspot_verified.mechanisms.load import load
    from gspot_verified.scenes.scene.before_spot import scene_before_spot
    from gspot_verified.scenes.scene.scene import OF_EVERY_SCENE

    mechanism = load(name)
    parameters = [name for name, _ in mechanism.parameters if name not in OF_EVERY_SCENE]
    own = {name: given.pop(name) for name in parameters if name in given}
    return scene_before_spot(mechanism.changed(**own), spot)


def _given(words: list[str], **options: str | None) -> dict[str, str]:
    """What --set and the options of their own say; each setting once."""
    settings = _settings(words)
    for name, value in options.items():
        if value is None:
            continue
        for same in (name, "eps") if name == "epsilon" else (name,):
            if same in settings:
                raise ValueError(f"give --{name} or --set {same}=..., not both")
        settings[name] = value
    return settings


def _settings(words: list[str]) -> dict[str, str]:
    settings: dict[str, str] = {}
    for word in words:
        name, equals, value = (part.strip() for part in word.partition("="))
        if not equals or not name.isidentifier() or name in settings:
            raise ValueError(f"--set: expected name=value, each name once, got {word[:60]!r}")
        settings[name] = value
    return settings


def _moving(scene: Scene) -> str:
    return "model" if scene.mechanism is None else scene.mechanism.name


def _notes(scene: Scene) -> tuple[str, ...]:
    """How the mechanism was read: which way u, x and the velocity of a belt count, and the scene's own compliance."""
    from dataclasses import replace

    from gspot_verified.expansion.series.regularisation import Regularisation

    if scene.mechanism is None:
        return ()
    springs = Regularisation(*(scene.values()[name] for name in ("k_1", "k_2", "damping")))
    return replace(scene.mechanism, regularisation=springs).notes


def _start(scene: Scene) -> dict[str, fmpq | arb]:
    """The start; an angle that has a reference is counted from it."""
    angles = () if scene.mechanism is None else scene.mechanism.angles
    counted = {angle.coordinate: f"{angle.coordinate} - {angle.name}" for angle in angles}
    return {counted.get(name, name): value for name, value in (scene.initial() | scene.enclosed_initial()).items()}


def _not_integrated(scene: Scene) -> dict[str, str]:
    """What the start gives beside the states that are integrated, and the mechanism's time: what effects that are left
    out assume is asked of it, and forces can depend on it. The model's nu says its b."""
    from gspot_verified.mechanisms.input.mechanism import Lagrangian

    shown = scene.initial().keys() | scene.enclosed_initial().keys() | ({"nu"} if scene.mechanism is None else set())
    found = {name: str(value) for name, value in scene.start.items() if name not in shown}
    motion = None if scene.mechanism is None else scene.mechanism.motion
    if isinstance(motion, Lagrangian) and motion.time and motion.time not in shown:
        found.setdefault(motion.time, "0")
    return found


def _scene_json(scene: Scene) -> dict[str, Any]:
    from flint import arb

    from gspot_verified.numbers.balls import ball_text
    from gspot_verified.scenes.floats.fast_part import fast_part
    from gspot_verified.scenes.scene.effect_cost import effect_costs

    parameters, left = {name: str(value) for name, value in scene.values().items()}, fast_part(scene)
    return {
        "name": scene.name,
        "mechanism": None if scene.mechanism is None else scene.mechanism.name,
        "notes": list(_notes(scene)),
        "effects": list(scene.effects),
        "costs": [cost.to_json() for cost in effect_costs(scene)],
        "assumes": scene.assumes(),
        "epsilon": str(scene.epsilon),
        "until": str(scene.until),
        "parameters": parameters,
        "start": {name: str(value) for name, value in _start(scene).items() if not isinstance(value, arb)},
        "enclosed_start": {name: ball_text(value) for name, value in _start(scene).items() if isinstance(value, arb)},
        "start_not_integrated": _not_integrated(scene),
        "slow_start": None if scene.slow_start is None else str(scene.slow_start),
        "fast_part": None if left is None else left.to_json(),
        "states": {phase: list(scene.system(phase).states) for phase in scene.phases()},
    }


def _number(scene: Scene, value: fmpq | arb) -> str:
    """Exactly, the long decimals of a start on the slow manifold as decimals; or as a ball."""
    from flint import arb

    from gspot_verified.numbers.balls import ball_text
    from gspot_verified.numbers.short_text import short_text

    if isinstance(value, arb):
        return ball_text(value)
    return short_text(value) if scene.on_slow_manifold else str(value)


def _show(scene: Scene, runs: list[SceneRun]) -> None:
    from gspot_verified.scenes.floats.fast_part import fast_part
    from gspot_verified.scenes.scene.effect_cost import cost_text

    for run in runs:
        typer.echo(str(run))
    start = ", ".join(f"{name} = {_number(scene, value)}" for name, value in _start(scene).items())
    typer.echo(f"  {scene.name}, ε = {scene.epsilon}, from {start}")
    if given := _not_integrated(scene):
        typer.echo("  at the start, not integrated: " + ", ".join(f"{name} = {value}" for name, value in given.items()))
    typer.echo("  with " + ", ".join(f"{name} = {value}" for name, value in scene.values().items()))
    for said in (scene.slow_start, fast_part(scene), cost_text(scene)):
        if said is not None:
            typer.echo(f"  {said}")
    for name, line in scene.assumes().items():
        typer.echo(f"  without {name}: {line}")
    for note in _notes(scene):
        typer.echo(f"  note: {note}")


def _write(
    outputs: Outputs,
    scene: Scene,
    runs: list[SceneRun],
    csv: Path | None,
    npz: Path | None,
    picture: Path | None,
    animation: Path | None,
) -> None:
    """The samples and the animation of the last run that has some, and the picture of all."""
    last = next((run for run in reversed(runs) if run.samples is not None), runs[-1])
    for option, path in (("--csv", csv), ("--npz", npz)):
        if path is not None and (samples := last.samples) is not None:
            outputs.write(option, path, lambda path=path: samples.save(path))  # type: ignore[misc]
    if animation is not None:
        from gspot_verified.report.pictures.mechanism_animation import mechanism_animation

        outputs.write("--animation", animation, lambda: mechanism_animation(scene, last).save(animation))
    if picture is not None:
        from gspot_verified.report.pictures.scene_picture import scene_picture
        from gspot_verified.scenes.certified_run import with_boxes
        from gspot_verified.scenes.scene.run import CERTIFIED

        drawn = [with_boxes(scene, run, progress) if run.strength == CERTIFIED else run for run in runs]
        outputs.write("--picture", picture, lambda: scene_picture(scene, drawn).save(picture))
