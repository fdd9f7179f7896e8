"""Commands ``approach`` and ``simulators``: what follows a state, and what simulators say of it."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, NoReturn

import typer

from gspot_verified.cli.app import (
    JsonFlag,
    Scheduler,
    TableOutput,
    Workers,
    app,
    print_json,
    progress,
    refuse,
    show,
    warn,
)
from gspot_verified.cli.command_groups import example
from gspot_verified.cli.commands.mechanism_commands import MechanismName, Settings
from gspot_verified.cli.load import components, load_with_settings, show_approach
from gspot_verified.cli.output import Outputs
from gspot_verified.cli.table_output import TableRun, write_approach_table

if TYPE_CHECKING:
    from gspot_verified.mechanisms.input.mechanism import Mechanism

_STATE = 'The state, "phi=phi_ref + 1/10,phi_dot=-9/10": all components, or all but the two that y = v = 0 determine.'

_TRAJECTORY = "A CSV table of a simulator: t, the components of the state, and force where it is known; repeatable."
Surface = Annotated[
    str | None, typer.Option("--surface-velocity", help="Velocity of the surface, counted as u; 0 if u > 0.")
]
Spot = Annotated[
    int | None,
    typer.Option("--spot", help="What --from leaves out is as at this G-spot, by its number in `classify --all`."),
]


@app.command(epilog=example('approach oscillator --from "phi=phi_ref+1/10,phi_dot=-9/10"'))
def approach(
    name: MechanismName,
    state: Annotated[str | None, typer.Option("--from", help=_STATE)] = None,
    surface: Surface = None,
    settings: Settings = None,
    spot: Spot = None,
    table: Annotated[
        Path | None,
        typer.Option(help="Follow slip for each row of a CSV file of parameters and components of the state."),
    ] = None,
    output: TableOutput = None,
    digits: Annotated[
        int | None, typer.Option(help="With --table: digits of C1, 1 to 15; else as many as its sign needs.")
    ] = None,
    rows: Annotated[
        str | None, typer.Option(help="With --table: rows A:B of it only, to do a long table in parts.")
    ] = None,
    workers: Workers = 1,
    scheduler: Scheduler = None,
    certificate: Annotated[
        Path | None,
        typer.Option(help="Write a certificate that slip reaches the G-spot, which `check` reads."),
    ] = None,
    as_json: JsonFlag = False,
) -> None:
    """Where slip from a state ends: G-spot, lift-off, or stop. At a G-spot: C1 in balls, lift-off or impact.

    Exit code 0 when that is proved and, at a G-spot, the side is known; else 2.

    With --table slip is followed for each row of values, with those of --from in all rows, and the answers are the
    lines of a CSV file; a row that is refused or undecided says why, and then the exit code is 2. There is no journal:
    a path that a file holds must be proved again, which takes as long; --rows does a long table in parts, each with an
    --output of its own. By default the numbers have as few digits as the signs need; --digits asks for more of C1.

    --certificate is for mechanisms of sines, cosines and powers with x, as it is for `simulate`; the components of the
    state must be rational numbers, an angle its reference and one. The sign of C1 is in it where β < 2.
    """
    if table is not None:
        refuse(
            "not with --table, whose answers are the rows of --output",
            {"--spot": spot, "--json": as_json, "--certificate": certificate},
        )
        write_approach_table(TableRun(name, settings, table, output, workers, scheduler), state, surface, digits, rows)
    refuse(
        "only with --table",
        {"--output": output, "--scheduler": scheduler, "--workers": workers != 1, "--digits": digits, "--rows": rows},
    )
    if state is None:
        raise ValueError("give the state with --from, or states with --table")
    outputs = Outputs()
    outputs.reads(name)
    outputs.file("--certificate", certificate)
    mechanism = load_with_settings(name, settings)
    if certificate is None:
        show_approach(mechanism, state, surface, as_json, spot)
    refuse("not together with --certificate", {"--spot": spot})
    _certify(outputs, mechanism, state, surface, certificate, as_json)


def _certify(
    outputs: Outputs, mechanism: Mechanism, state: str, surface: str | None, file: Path, as_json: bool
) -> NoReturn:
    """The answer, and a certificate where it is a G-spot."""
    from gspot_verified.certificates.text import write_text
    from gspot_verified.mechanisms.approach.approach import approach as approach_spot
    from gspot_verified.scenes.certificates.approach_certificate import approach_certificate

    given = components(state)
    result = approach_spot(mechanism, given, surface_velocity=surface)
    if as_json:
        print_json(result.to_json(), "approach")
    else:
        typer.echo(str(result))
    if result.end != "G-spot":
        warn(f"--certificate: no G-spot is proved to be reached; {file} was not written")
    elif outputs.write(
        "--certificate",
        file,
        lambda: write_text(file, approach_certificate(mechanism, given, surface_velocity=surface)),
    ):
        (progress if as_json else typer.echo)(f"certificate that the G-spot is reached: {file}")
    outputs.leave(result.exit_code)


@app.command(epilog=example("simulators pushed-chalk --from theta=2/5,theta_dot=1"))
def simulators(
    name: MechanismName,
    state: Annotated[str, typer.Option("--from", help=_STATE)],
    trajectory: Annotated[list[Path] | None, typer.Option(help=_TRAJECTORY)] = None,
    epsilon: Annotated[
        list[str] | None, typer.Option("--epsilon", "--eps", help="ε of compliant runs, not 1e-3 and 1e-4.")
    ] = None,
    surface: Surface = None,
    settings: Settings = None,
    spot: Spot = None,
    as_json: JsonFlag = False,
) -> None:
    """What simulators say of slip, beside what is certified. Runs in floats prove nothing.

    Run are the compliant contact of the paper by scipy, Moreau's and Jean's time stepping, and MuJoCo and Drake where
    they are installed; tables of others are read with --trajectory. Exit code as `approach`: that of the certified
    answer.
    """
    from gspot_verified.scenes.simulators.comparison import EPSILONS
    from gspot_verified.scenes.simulators.comparison import simulators as compared

    found = compared(
        load_with_settings(name, settings),
        components(state),
        files=trajectory or (),
        surface_velocity=surface,
        spot=spot,
        epsilons=epsilon or EPSILONS,
    )
    show(found, as_json)
    raise typer.Exit(found.exit_code)
