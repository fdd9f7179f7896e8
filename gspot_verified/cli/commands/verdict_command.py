"""Command ``verdict``: lift-off or impact without collision for every epsilon up to one at once."""

from __future__ import annotations

from typing import Annotated

import typer

from gspot_verified.cli.app import JsonFlag, app, print_json
from gspot_verified.cli.command_groups import example


@app.command(epilog=example("verdict --beta 3/2 --from p=1/2,b=-2"))
def verdict(
    beta: Annotated[str, typer.Option(help="β = α3/α1 > 1, rational and not an integer.")],
    state: Annotated[
        str | None, typer.Option("--from", help='The state of the model system, "p=1/2,b=-2"; p > 0, b < 0.')
    ] = None,
    epsilon: Annotated[
        str | None, typer.Option("--epsilon", "--eps", help="With --from: ε0; left out: the largest of a list.")
    ] = None,
    within: Annotated[
        str, typer.Option(help="With --from: how far λ, v and y may be from rest, as a share of the excess of -b/p.")
    ] = "1/100",
    alpha1: Annotated[str, typer.Option(help="With --from: α1* < 0.")] = "-1",
    alpha2: Annotated[str, typer.Option(help="With --from: α2* < 0.")] = "-1",
    as_json: JsonFlag = False,
) -> None:
    """Lift-off or impact without collision, for every ε up to an ε0 at once. Proved from far away, not near the G-spot.

    With --from: the model system (constant α's) from this state, with an explicit ε0. Without: for every mechanism with
    m = 4 and this β there is an ε0 > 0, which is not computed. Exit code 0 when it is proved, 2 when undecided; the
    inequality that fails is printed then.
    """
    from gspot_verified.cli.approach_output import components
    from gspot_verified.expansion.from_state.limit_side import LimitSide, limit_side
    from gspot_verified.expansion.from_state.model_side import ModelSide, model_side

    found: LimitSide | ModelSide
    if state is None:
        if epsilon is not None:
            raise ValueError("--epsilon: it goes with --from")
        found = limit_side(beta)
    else:
        given = components(state)
        if set(given) != {"p", "b"}:
            raise ValueError(f'--from: it needs p and b, "p=1/2,b=-2", got {state!r}')
        found = model_side(beta, given["p"], given["b"], epsilon=epsilon, within=within, alpha_1=alpha1, alpha_2=alpha2)
    if as_json:
        print_json(found.to_json())
    else:
        typer.echo(str(found))
    raise typer.Exit(found.verdict.exit_code)
