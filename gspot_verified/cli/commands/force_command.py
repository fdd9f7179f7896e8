"""Command ``force``."""

from __future__ import annotations

from typing import Annotated

import typer

from gspot_verified.cli.app import JsonFlag, app, print_json
from gspot_verified.cli.command_groups import example


@app.command(epilog=example("force --beta 5/2 --epsilon 1e-6 --t 1e-4"))
def force(
    t: Annotated[str, typer.Option("--t", help="The time, measured from the G-spot: p = α1 t.")],
    beta: Annotated[str | None, typer.Option(help="β = α3/α1; or give --alpha3.")] = None,
    epsilon: Annotated[str, typer.Option("--epsilon", "--eps", help="ε > 0.")] = "1/1000",
    alpha1: Annotated[str, typer.Option(help="α1* < 0.")] = "-1",
    alpha2: Annotated[str, typer.Option(help="α2*.")] = "-1",
    alpha3: Annotated[str | None, typer.Option(help="α3* < 0; β α1 if left out.")] = None,
    c1: Annotated[
        str | None, typer.Option(help="On the slow manifold: C1; left out: 1 or -1 with C1/Γ(-β) > 0.")
    ] = None,
    state: Annotated[str | None, typer.Option(help="From this initial state in contact: p,b,y,v,z.")] = None,
    digits: Annotated[int, typer.Option(help="Decimal digits of the force, 1..1000.")] = 15,
    certify: Annotated[
        bool, typer.Option("--certify", help="With --state: whether contact has lasted until t.")
    ] = False,
    as_json: JsonFlag = False,
) -> None:
    """The contact force of the compliant model at one time. At every ε: on its slow manifold, or from a state.

    Exit code 0 when the accuracy was reached (with --certify: and contact has lasted), 2 when not.
    """
    from flint import fmpq

    from gspot_verified.compliant.model.normal_form import compliant_model
    from gspot_verified.compliant.model.state_text import state_from_text
    from gspot_verified.compliant.motion.compliant_force import SlowMotions
    from gspot_verified.compliant.motion.compliant_force import force as compliant_force
    from gspot_verified.compliant.motion.first_zero import contact_lasts
    from gspot_verified.leading_order.contact_force import rational
    from gspot_verified.signs.gamma.side import gamma_sign

    model = compliant_model(beta, epsilon, alpha_1=alpha1, alpha_2=alpha2, alpha_3=alpha3)
    if state is not None:
        if c1 is not None:
            raise ValueError("--c1: it is for the slow manifold; the state fixes its own C1")
        start = state_from_text(state)
        result = compliant_force(model, start, t, digits)
        lasting = contact_lasts(model, start, t) if certify else None
        where = "from the initial state (p, b, y, v, z) = (" + state + ")"
    else:
        if certify:
            raise ValueError("--certify: it needs an initial state, --state")
        lasting = None
        charge = fmpq(gamma_sign(model.beta) or 1) if c1 is None else rational(c1, "c1")
        result = compliant_force(model, SlowMotions(charge), t, digits)
        where = f"on its slow manifold, b + (α2/(α3-α1)) p ~ C1 (-t)^β, C1 = {charge}"
    contact = "the contact phase of the compliant model (the model as long as contact has lasted)"
    numbers = f"{model.numbers}, ε = {epsilon}"
    system = f"{contact}, {where}, {numbers}"
    if as_json:
        certified = {} if lasting is None else {"contact_lasts": lasting.to_json()}
        print_json({**result.to_json(), **certified, "system": system})
    else:
        typer.echo(str(result))
        typer.echo(f"  {system}")
        if lasting is not None:
            typer.echo(str(lasting))
    raise typer.Exit(0 if result.reached and (lasting is None or lasting.exit_code == 0) else 2)
