"""Commands ``classify`` and ``expand``."""

from __future__ import annotations

import glob
import warnings
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from gspot_verified.cli.app import (
    JournalFile,
    JsonFlag,
    Scheduler,
    TableOutput,
    Workers,
    app,
    counted,
    print_json,
    refuse,
    warn,
)
from gspot_verified.cli.command_groups import example
from gspot_verified.cli.load import load_with_settings
from gspot_verified.cli.output import PICTURES, Outputs
from gspot_verified.cli.table_output import TableRun, write_classified_table
from gspot_verified.numbers.counted import done_of

if TYPE_CHECKING:
    from gspot_verified.expansion.trajectory import Trajectory


_COUNTED = {2: "two", 3: "three"}


def _known_names(typed: str) -> list[str]:
    """What a shell may complete: the names of the package, and files."""
    from gspot_verified.mechanisms.shipped import SHORT_NAMES

    paths = [path for path in Path().glob(f"{glob.escape(typed)}*") if not path.name.startswith(".")]
    files = [str(path) for path in paths if path.is_dir() or path.suffix == ".toml"]
    return [*(name for name in SHORT_NAMES if name.startswith(typed)), *sorted(files)]


MechanismName = Annotated[
    str, typer.Argument(help="A TOML file, or: model, extended, oscillator, rod.", autocompletion=_known_names)
]
Spot = Annotated[
    int | None, typer.Option("--spot", help="Which G-spot: its number in `classify --all`; left out: the file's.")
]
Settings = Annotated[
    list[str] | None,
    typer.Option("--set", metavar="NAME=VALUE", help='A parameter, "mu=2"; in expand also "chi=symbolic".'),
]


@app.command(epilog=example("classify oscillator --set beta=5/2"))
def classify(
    name: MechanismName,
    settings: Settings = None,
    everywhere: Annotated[
        bool, typer.Option("--all", help="All G-spots, from no start (also where the file gives no place).")
    ] = False,
    box: Annotated[
        list[str] | None, typer.Option("--box", help='All G-spots with a component in an interval: "theta=0..3/2".')
    ] = None,
    budget: Annotated[int | None, typer.Option(help="How many boxes the search for all G-spots looks at.")] = None,
    from_state: Annotated[
        str | None, typer.Option("--from", help="Where slip from this state leads, as in `approach`.")
    ] = None,
    verbose: Annotated[bool, typer.Option("--verbose", help="All numbers of each G-spot, in balls.")] = False,
    table: Annotated[
        Path | None,
        typer.Option(help="Classify each row of a CSV file of parameter values; its first line has names."),
    ] = None,
    output: TableOutput = None,
    workers: Workers = 1,
    scheduler: Scheduler = None,
    journal: JournalFile = None,
    as_json: JsonFlag = False,
) -> None:
    """A mechanism's G-spots: slip, Case, β, and what happens. A table; --verbose: also alpha_i.

    All of its G-spots with --all, --box, or where the file gives no place, or one that is no G-spot for these
    parameters; then exit code 1: there is none in the region, proved. The number of a G-spot is the N of --spot N
    elsewhere. Exit code 2: the list may not be complete, or the balls of a point that is not rational leave the case
    open.

    With --table the G-spot found from the file's place is classified for each row of parameter values, in a CSV file;
    a row that is refused or undecided says why, and then the exit code is 2.
    """
    if table is not None:
        alone = {"--all": everywhere, "--box": box, "--budget": budget, "--from": from_state, "--verbose": verbose}
        refuse("not with --table, whose answers are the rows of --output", alone | {"--json": as_json})
        write_classified_table(TableRun(name, settings, table, output, workers, scheduler), journal)
    only = {"--output": output, "--scheduler": scheduler, "--journal": journal, "--workers": workers != 1}
    refuse("only with --table", only)
    if from_state is not None:
        refuse(
            "--from follows slip from that state, as approach does, and lists no G-spots",
            {"--all": everywhere, "--box": box, "--budget": budget, "--verbose": verbose},
        )
        from gspot_verified.cli.load import show_approach

        show_approach(load_with_settings(name, settings), from_state, None, as_json)
    from gspot_verified.mechanisms.spots.classify import classify as classify_mechanism
    from gspot_verified.mechanisms.spots.g_spot import NotThereError
    from gspot_verified.mechanisms.spots.spot_table import one_spot
    from gspot_verified.mechanisms.zeros.newton import NotFoundError

    mechanism = load_with_settings(name, settings)
    placed = {word for word, _ in mechanism.place.values} >= set(mechanism.state)
    if placed and not (everywhere or box or budget):
        try:
            result = classify_mechanism(mechanism)
        except (NotFoundError, NotThereError) as error:
            warn(f"{error}; all G-spots are searched instead")
        else:
            _print(result.to_json(), str(result) if verbose else one_spot(result), as_json)
            raise typer.Exit(2 if result.case is None else 0)
    from gspot_verified.mechanisms.spots.all_g_spots import DEFAULT_BUDGET
    from gspot_verified.mechanisms.spots.classify_all import classify_all

    classified = classify_all(mechanism, _box(box or []), budget=DEFAULT_BUDGET if budget is None else budget)
    _print(classified.to_json(), classified.in_full() if verbose else str(classified), as_json)
    raise typer.Exit(classified.exit_code)


def _print(data: dict[str, Any], text: str, as_json: bool) -> None:
    if as_json:
        print_json(data)
    else:
        typer.echo(text)


def _box(given: list[str]) -> dict[str, tuple[Any, Any]]:
    from gspot_verified.work.ranges import Range

    intervals = {}
    for text in given:
        word, equals, interval = text.partition("=")
        word = word.strip()
        if not equals or ".." not in interval:
            raise ValueError(f'--box: expected "component=lower..upper", got {text[:60]!r}')
        if word in intervals:
            raise ValueError(f"--box: {word[:60]} is given twice")
        parsed = Range.parse(interval, f"--box, {word[:60]}")
        if parsed.lower is None or parsed.upper is None:
            raise ValueError(f"--box, {word[:60]}: the interval must be finite")
        intervals[word] = (parsed.lower, parsed.upper)
    return intervals


@app.command(epilog=example("expand extended --order 7 --chi symbolic"))
def expand(
    name: MechanismName,
    order: Annotated[int, typer.Option(help="Terms of the orders below this one of δ = ε^(1/3).")] = 8,
    chi: Annotated[str | None, typer.Option(help='Short for --set chi=...: a number or "symbolic".')] = None,
    settings: Settings = None,
    spot: Spot = None,
    in_time: Annotated[bool, typer.Option("--in-time", help="As polynomials in t and ε (the Corollary).")] = False,
    at: Annotated[str | None, typer.Option(help='Value at "s,delta" (with --in-time: "t,epsilon"), in balls.')] = None,
    digits: Annotated[int, typer.Option(help="Accuracy where the G-spot is not rational, and of --at.")] = 15,
    residual: Annotated[str | None, typer.Option(help='Bound on what is left for |s| <= S, δ <= D: "S,D".')] = None,
    uniform: Annotated[
        str | None, typer.Option(help='How far true solutions are, for s in [A, B] and all δ <= D: "A,B,D".')
    ] = None,
    bits: Annotated[int | None, typer.Option(help="Coefficients as balls, with so many working bits.")] = None,
    side: Annotated[
        str | None, typer.Option(help='Lift-off or impact near the G-spot with C1, for all ε <= D³: "C1,D".')
    ] = None,
    latex: Annotated[bool, typer.Option("--latex", help="Print LaTeX.")] = False,
    picture: Annotated[
        Path | None, typer.Option(help="Draw what is left in the equations, with its bound: PNG, PDF or SVG.")
    ] = None,
    as_json: JsonFlag = False,
) -> None:
    """The distinguished trajectory of Theorem 1, expanded. With exact coefficients.

    Coefficients are balls of the asked digits where the G-spot is not rational, and with --bits. Exit code 2 when
    digits are not reached, when --uniform or --side is undecided, and when --residual leaves an equation without a
    bound.
    """
    from gspot_verified.expansion.trajectory import AccuracyWarning
    from gspot_verified.mechanisms.expand import expand as expand_mechanism

    outputs = Outputs()
    outputs.file("--picture", picture, PICTURES)
    if latex and (in_time or at is not None):
        raise ValueError("--latex prints the scaled variables: not with --in-time or --at")
    chosen = [*(settings or []), *([] if chi is None else [f"chi={chi}"])]
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", AccuracyWarning)  # said below, on stderr and by the exit code
        subject = load_with_settings(name, chosen)
        trajectory = expand_mechanism(subject, order, digits, _orders, bits, spot=spot)
    if trajectory.pulls:
        warn("the mean force is negative: this trajectory would have to pull on the surface, no contact does that")
    data = trajectory.to_json()
    text = trajectory.to_latex() if latex else str(trajectory)
    if in_time:
        series = trajectory.in_time()
        data, text = series.to_json(), str(series)
    if at is not None:
        values, text = _values_at(trajectory, at, in_time, digits)
        data |= {"at": values}
    proved = True
    if residual is not None:
        from gspot_verified.expansion.residual import residual_bounds

        reach, small = _numbers(residual, "--residual", "1,1/10")
        bounds = residual_bounds(trajectory, reach, small)
        data |= {"residual": bounds.to_json()}
        text, proved = f"{text}\n{bounds}", bounds.complete
    if uniform is not None:
        from gspot_verified.expansion.true_solutions.bound import uniform_bound
        from gspot_verified.numbers.verdict import Outcome

        distance = uniform_bound(trajectory, *_numbers(uniform, "--uniform", "-3,2,1/20"))
        data |= {"uniform": distance.to_json()}
        text, proved = f"{text}\n{distance}", proved and distance.verdict.outcome is Outcome.PROVED
    if side is not None:
        from gspot_verified.expansion.true_solutions.side import uniform_side

        taken = uniform_side(trajectory, *_numbers(side, "--side", "1,1/50"))
        data |= {"side": taken.to_json()}
        text, proved = f"{text}\n{taken}", proved and taken.side is not None
    if picture is not None:
        from gspot_verified.report.pictures.expansion_picture import save_expansion

        outputs.write("--picture", picture, lambda: save_expansion(trajectory, picture))
    if as_json:
        print_json(data)
    else:
        typer.echo(text)
    reached = bits is not None or trajectory.accuracy is None or trajectory.accuracy.reached
    if not reached:
        warn(str(trajectory.accuracy))
    outputs.leave(0 if reached and proved else 2)


def _values_at(trajectory: Trajectory, at: str, in_time: bool, digits: int) -> tuple[dict[str, Any], str]:
    """The values of the truncated polynomials as data and as text."""
    from gspot_verified.expansion.series.legend import VALUES_OF, in_two, left_side
    from gspot_verified.expansion.text import exact_text
    from gspot_verified.numbers.balls import ball_text

    first, second = _numbers(at, "--at", "1,1/10")
    value = trajectory.evaluate_in_time if in_time else trajectory.evaluate
    values, names = value(first, second, digits), trajectory.system.names
    lines = [f"{left_side(key, names, not in_time)} = {ball_text(ball, digits)}" for key, ball in values.items()]
    both = {key: {"value": ball_text(ball, digits), "enclosure": exact_text(ball)} for key, ball in values.items()}
    place = {"t": first, "epsilon": second} if in_time else {"s": first, "delta": second}
    return {**place, "values_of": VALUES_OF, **in_two(both, names)._asdict()}, "\n".join([*lines, VALUES_OF])


def _orders(done: int, of: int) -> None:
    counted(done_of(done, of, "order"), done, done / of, done % 20 == 0)


def _numbers(text: str, option: str, example: str) -> list[str]:
    """The numbers of an option, as many as its example has."""
    parts = [part.strip() for part in text.split(",")]
    count = len(example.split(","))
    if len(parts) != count:
        raise ValueError(f'{option}: expected {_COUNTED[count]} numbers such as "{example}", got {text[:60]!r}')
    return parts
