"""Command ``wrong-sides``: how often float runs report the wrong side, and where the paper's rule does."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

import typer

from gspot_verified.cli.app import JsonFlag, app, print_json, progress
from gspot_verified.cli.command_groups import example

if TYPE_CHECKING:
    from gspot_verified.scenes.hard_sides import Count, WrongSides

_OF_THE_SET = "in place of those of the set, as often as needed."


@app.command(epilog=example("wrong-sides --epsilon 1e-4 --beta 15/2 --nu 2 --method LSODA"))
def wrong_sides(
    epsilon: Annotated[list[str] | None, typer.Option("--epsilon", "--eps", help=f"ε, {_OF_THE_SET}")] = None,
    beta: Annotated[list[str] | None, typer.Option(help=f"β, {_OF_THE_SET}")] = None,
    nu: Annotated[list[str] | None, typer.Option(help=f"ν of the starts, {_OF_THE_SET}")] = None,
    method: Annotated[list[str] | None, typer.Option(help=f"Radau, LSODA or BDF, {_OF_THE_SET}")] = None,
    tolerance: Annotated[list[str] | None, typer.Option(help=f"1e-13..1e-2, {_OF_THE_SET}")] = None,
    as_json: JsonFlag = False,
) -> None:
    """How often solve_ivp reports the wrong side of a start. The certified side is from the exact solution.

    Starts of Fig. varsim1 with β from 5/2 to 15/2 and ε from 10^-3 to 10^-6, a factor 2 from the canard and close to
    it. A float run says "contact is lost" or "contact lasts" by its first event; only starts with a certified answer
    count. Nothing is stored: the whole set with all solvers and tolerances takes some ten minutes.
    Exit code 0 when every start is decided, else 2.
    """
    from gspot_verified.scenes.hard_sides import hard_sides, wrong_sides

    chosen = hard_sides().restricted(epsilons=epsilon, betas=beta, nus=nu, solvers=method, tolerances=tolerance)
    counted = wrong_sides(chosen, progress)
    if as_json:
        print_json(counted.to_json())
    else:
        _show(counted)
    raise typer.Exit(0 if all(side.side is not None for side in counted.certified.values()) else 2)


def _show(counted: WrongSides) -> None:
    epsilons = list(dict.fromkeys(count.epsilon for count in counted.counts))
    betas = list(dict.fromkeys(count.beta for count in counted.counts))
    typer.echo("wrong sides of decided starts; s: runs without an event, f: runs that failed")
    for epsilon in epsilons:
        typer.echo(f"ε = {epsilon}".ljust(24) + "".join(f"β = {beta}".ljust(14) for beta in betas).rstrip())
        here = [count for count in counted.counts if count.epsilon == epsilon]
        for solver, tolerance in dict.fromkeys((count.solver, count.tolerance) for count in here):
            cells = [_cell(c) for c in here if (c.solver, c.tolerance) == (solver, tolerance)]
            typer.echo(f"  {solver} {tolerance}".ljust(24) + "".join(cell.ljust(14) for cell in cells).rstrip())
        rule = "".join(_rule(counted, epsilon, beta).ljust(14) for beta in betas).rstrip()
        typer.echo("  the paper's rule".ljust(24) + rule)
    typer.echo("certified sides:")
    for start, side in counted.certified.items():
        place = f"  ε = {start.epsilon}, β = {start.beta}, ν = {start.nu}: "
        typer.echo(place + f"{side.verdict}" + ("; the paper's rule gives the other side" if side.rule_fails else ""))


def _cell(count: Count) -> str:
    extra = "".join(f" {number}{letter}" for number, letter in ((count.silent, "s"), (count.failed, "f")) if number)
    return f"{count.wrong}/{count.decided}{extra}"


def _rule(counted: WrongSides, epsilon: object, beta: object) -> str:
    answers = [s.rule_fails for start, s in counted.certified.items() if (start.epsilon, start.beta) == (epsilon, beta)]
    known = [answer for answer in answers if answer is not None]
    return f"{sum(known)}/{len(known)}"
