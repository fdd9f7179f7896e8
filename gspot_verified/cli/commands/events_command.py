"""Command ``events``."""

from __future__ import annotations

from typing import Annotated

import typer

from gspot_verified.cli.app import JsonFlag, app, print_json
from gspot_verified.cli.command_groups import example


@app.command(epilog=example("events --beta 3/2 --epsilon 1e-6 --nu 2"))
def events(
    beta: Annotated[str | None, typer.Option(help="β = α3/α1; or give --alpha3.")] = None,
    epsilon: Annotated[str, typer.Option("--epsilon", "--eps", help="ε > 0.")] = "1/1000",
    alpha1: Annotated[str, typer.Option(help="α1* < 0.")] = "-1",
    alpha2: Annotated[str, typer.Option(help="α2*.")] = "-1",
    alpha3: Annotated[str | None, typer.Option(help="α3* < 0; β α1 if left out.")] = None,
    nu: Annotated[str | None, typer.Option(help="The initial data of Fig. varsim1 with this ν; or --state.")] = None,
    state: Annotated[
        str | None, typer.Option(help="The initial state in contact, before the G-spot: p,b,y,v,z.")
    ] = None,
    digits: Annotated[int, typer.Option(help="Decimals of the lift-off time, in units of the G-spot, 1..80.")] = 15,
    budget: Annotated[
        int,
        typer.Option(
            help="Work of the power series (rate times time), where the bound of the fast part is too wide, and in "
            "each contact after a flight."
        ),
    ] = 3_000,
    flights: Annotated[int, typer.Option(help="How many flights are followed.")] = 8,
    as_json: JsonFlag = False,
) -> None:
    """What the compliant model does from a state, certified. Lift-off, flight, touch-down, an impact without collision.

    Exit code 0 when the whole run is proved, or the run up to a contact that is lost again, as the first line says; 2
    when a part is undecided.
    """
    from gspot_verified.compliant.model.normal_form import compliant_model
    from gspot_verified.compliant.model.state_text import state_from_text
    from gspot_verified.compliant.motion.run import events as compliant_run
    from gspot_verified.paper.numerics.paper_state import paper_state

    model = compliant_model(beta, epsilon, alpha_1=alpha1, alpha_2=alpha2, alpha_3=alpha3)
    if nu is not None and state is None:
        start = paper_state(model, nu)
    elif state is not None and nu is None:
        start = state_from_text(state)
    else:
        raise ValueError("give --nu or --state, one of them")
    result = compliant_run(model, start, digits, budget, flights)
    if as_json:
        print_json(result.to_json())
    else:
        typer.echo(str(result))
        numbers = f"{model.numbers}, ε = {epsilon}"
        values = ", ".join(str(getattr(start, name)) for name in "pbyvz")
        typer.echo(f"  the compliant model from (p, b, y, v, z) = ({values}), {numbers}")
    raise typer.Exit(result.verdict.exit_code)
