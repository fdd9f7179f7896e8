"""Commands ``theta`` and ``side``."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Annotated

import typer

from gspot_verified.cli.app import JsonFlag, NumberArguments, app, print_json, progress, refuse, show
from gspot_verified.cli.command_groups import example

_SLOW_DIGITS = 20_000  # from here on a computation takes long enough to announce it
_MODEL = {"--epsilon": "1/1000", "--alpha1": "-1", "--alpha2": "-1"}
"""With ``side --state``: what is taken where an option is left out."""


@app.command(
    cls=NumberArguments,
    epilog=example("theta -- -50 7/3 --digits 100"),
)
def theta(
    tau: Annotated[str, typer.Argument(help='τ: "-50", "7/3", "0.1", or complex: "1+2i", "3/2-5/7i"; |τ| <= 10^12.')],
    beta: Annotated[str, typer.Argument(help="β, real, same form; |β| <= 10^4.")],
    digits: Annotated[int, typer.Option(help="Relative accuracy in decimal digits, 1..10^6.")] = 15,
    derivative: Annotated[int, typer.Option(help="k for the k-th τ-derivative, 0..1000.")] = 0,
    as_json: JsonFlag = False,
) -> None:
    """Θ(τ, β) or a τ-derivative, to the asked relative accuracy.

    Exit code 0 when the accuracy was reached, 2 when it was not (next to a zero of Θ): the ball is then still valid.
    """
    from gspot_verified.theta_function.value.evaluate import evaluate

    if digits >= _SLOW_DIGITS:
        _announce(tau, beta, derivative, digits)
    result = evaluate(tau, beta, derivative=derivative, digits=digits)
    show(result, as_json)
    if not result.reached:
        reason = result.reason.value if result.reason else "unknown reason"
        typer.echo(f"relative accuracy not reached: {reason}; the sign may be undecided", err=True)
        raise typer.Exit(2)


def _announce(tau: str, beta: str, derivative: int, digits: int) -> None:
    """Beforehand: one call of FLINT may last so long that nothing can be said meanwhile."""
    from gspot_verified.numbers.complex_numbers import is_complex
    from gspot_verified.theta_function.value.effort import expected_effort
    from gspot_verified.theta_function.value.routes import checked_arguments

    effort = None
    if not is_complex(tau):
        point, parameter = checked_arguments(tau, beta, derivative)
        effort = expected_effort(point, parameter - derivative, digits)
    if effort is None:
        progress(f"{digits} digits: this may take minutes; there is no estimate for these arguments")
    else:
        progress(f"{digits} digits, route {effort.route}: {effort} on one core, roughly")


@app.command(cls=NumberArguments, epilog=example("side 1/2 4"))
def side(
    lower: Annotated[str | None, typer.Argument(help="Lower end of the range of β.")] = None,
    upper: Annotated[str | None, typer.Argument(help="Upper end; left out: the single value.")] = None,
    beta: Annotated[str | None, typer.Option(help="With --state: β = α3/α1.")] = None,
    epsilon: Annotated[
        str | None, typer.Option("--epsilon", "--eps", help="With --state: ε > 0; 1/1000 if left out.")
    ] = None,
    alpha1: Annotated[str | None, typer.Option(help="With --state: α1* < 0; -1 if left out.")] = None,
    alpha2: Annotated[str | None, typer.Option(help="With --state: α2*; -1 if left out.")] = None,
    state: Annotated[str | None, typer.Option(help="The exact side rule of this state in contact: p,b,y,v,z.")] = None,
    as_json: JsonFlag = False,
) -> None:
    """The sign of Γ(−β), and the side by the paper's rule as ε → 0. At one β or over a range.

    With --state: the exact side rule of the compliant model at one ε, K < 0: contact is certainly lost, with the
    paper's rule C1/Γ(−β) beside it.
    """
    model = {"--epsilon": epsilon, "--alpha1": alpha1, "--alpha2": alpha2}
    if state is not None:
        if upper is not None:
            raise ValueError(f"--state: it needs one β, not the range {lower}..{upper}; leave out the upper end")
        if beta is not None and lower is not None:
            raise ValueError("--beta: β is given as an argument already")
        if beta is None and lower is None:
            raise ValueError("β: give it as an argument or with --beta")
        _side_of_state(lower if beta is None else beta, model, state, as_json)
        return
    refuse("it goes with --state", model)
    if beta is not None or lower is None:
        raise ValueError("β: give it as an argument; --beta goes with --state")
    from gspot_verified.signs.gamma.side import side as side_switching

    result = side_switching(lower, upper)
    show(result, as_json)
    if result.undecided:
        raise typer.Exit(2)


def _side_of_state(beta: str | None, given: Mapping[str, str | None], state: str, as_json: bool) -> None:
    from gspot_verified.compliant.model.normal_form import compliant_model
    from gspot_verified.compliant.model.state_text import state_from_text
    from gspot_verified.compliant.side.side_rule import side_rule

    epsilon, alpha_1, alpha_2 = (_MODEL[name] if value is None else value for name, value in given.items())
    model = compliant_model(beta, epsilon, alpha_1=alpha_1, alpha_2=alpha_2)
    result = side_rule(model, state_from_text(state))
    numbers = f"{model.numbers}, ε = {epsilon}"
    system = f"the compliant model from the initial state (p, b, y, v, z) = ({state}), {numbers}"
    if as_json:
        print_json({**result.to_json(), "system": system})
    else:
        typer.echo(str(result))
        typer.echo(f"  {system}")
    raise typer.Exit(result.verdict.exit_code)
