"""The command line ``gspot-verified``.

Results go to stdout, progress to stderr. Exit codes: 0 proved (or done), 1 refuted, 2 undecided, 64 wrong usage, 70 an
internal error.
"""

from __future__ import annotations

import io
import json
import re
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Annotated, Any

import typer
from typer.core import TyperCommand

USAGE = 64
INTERNAL = 70
_NUMBER = re.compile(r"-\.?[0-9].*")

app = typer.Typer(
    add_completion=False,
    no_args_is_help=True,
    rich_markup_mode=None,
    help="Certified values and signs of Θ(τ, β), and the paper claim by claim. "
    "Exit codes: 0 proved, 1 refuted, 2 undecided, 64 usage.",
)

JsonFlag = Annotated[bool, typer.Option("--json", help="Print JSON.")]


class NumberArguments(TyperCommand):
    """A command whose arguments may be negative numbers, with options before or after them, with or without ``--``."""

    def parse_args(self, ctx: Any, args: list[str]) -> list[str]:
        """Move the numbers behind one ``--``; an option's value stays with its option."""
        takes_value = {name for p in self.params if getattr(p, "is_flag", None) is False for name in p.opts}
        options, numbers = [], []
        waiting = iter(args)
        for word in waiting:
            if word in takes_value:
                options += [word, *[value for value in [next(waiting, None)] if value is not None]]
            elif word.startswith("-") and word != "--" and not _NUMBER.fullmatch(word):
                options.append(word)
            elif word != "--":
                numbers.append(word)
        return super().parse_args(ctx, [*options, "--", *numbers])


@app.command(
    cls=NumberArguments,
    epilog="Example: gspot-verified theta -- -50 7/3 --digits 100",
)
def theta(
    tau: Annotated[str, typer.Argument(help='τ: "-50", "7/3", "0.1"; |τ| <= 10^12.')],
    beta: Annotated[str, typer.Argument(help="β, same form; |β| <= 10^4.")],
    digits: Annotated[int, typer.Option(help="Relative accuracy in decimal digits, 1..10^6.")] = 15,
    derivative: Annotated[int, typer.Option(help="k for the k-th τ-derivative, 0..1000.")] = 0,
    as_json: JsonFlag = False,
) -> None:
    """Enclose Θ(τ, β) or a τ-derivative to the asked relative accuracy.

    Exit code 0 when the accuracy was reached, 2 when it was not (next to a zero of Θ): the ball is then still valid.
    """
    from gspot_verified.theta.evaluate import evaluate

    result = evaluate(tau, beta, derivative=derivative, digits=digits)
    if as_json:
        _print_json(result.to_json())
    else:
        typer.echo(str(result))
    if not result.reached:
        reason = result.reason.value if result.reason else "unknown reason"
        typer.echo(f"relative accuracy not reached: {reason}; the sign may be undecided", err=True)
        raise typer.Exit(2)


@app.command(cls=NumberArguments, epilog="Example: gspot-verified side 1/2 4")
def side(
    lower: Annotated[str, typer.Argument(help="Lower end of the range of β.")],
    upper: Annotated[str | None, typer.Argument(help="Upper end; left out: the single value.")] = None,
    as_json: JsonFlag = False,
) -> None:
    """Certified sign of Γ(−β) over a range of β, and which sign of C1 lifts off there."""
    from gspot_verified.signs.side import side_switching

    result = side_switching(lower, lower if upper is None else upper)
    if as_json:
        _print_json(result.to_json())
    else:
        typer.echo(str(result))
    if result.undecided:
        raise typer.Exit(2)


@app.command(
    short_help="Check the paper's statements about Θ and write the report.",
    epilog="Example: gspot-verified verify --output report",
)
def verify(
    output: Annotated[Path, typer.Option(help="Directory of the report.")] = Path("report"),
    as_json: JsonFlag = False,
) -> None:
    """Check the paper's Appendix A and Sec. 4.5 statements about Θ and write the report (HTML, JSON, figures).

    Exit code 1 when a printed statement is refuted (the paper has misprints), 2 when one is undecided.
    """
    from gspot_verified.ledger.entry import counts
    from gspot_verified.ledger.verify import exit_code, verify_paper
    from gspot_verified.report.write import write_report

    entries = verify_paper(_progress)
    page = write_report(entries, output, _progress)
    if as_json:
        _print_json({"counts": counts(entries), "entries": [entry.to_json() for entry in entries]})
    else:
        for entry in entries:
            typer.echo(f"{entry.verdict.outcome.value:9}  {entry.label:28}  {entry.statement}")
            if entry.verdict.outcome.value == "refuted":
                typer.echo(f"{'':9}  {'corrected:':28}  {entry.corrected}")
        total = counts(entries)
        typer.echo(", ".join(f"{number} {outcome}" for outcome, number in total.items()) + f"; report: {page}")
    raise typer.Exit(exit_code(entries))


@app.command(epilog="Example: gspot-verified report report/report.json --output report")
def report(
    source: Annotated[Path, typer.Argument(help="A report.json that `verify` wrote.")] = Path("report/report.json"),
    output: Annotated[Path, typer.Option(help="Directory of the page.")] = Path("report"),
    as_json: JsonFlag = False,
) -> None:
    """Write the HTML page again from report.json, without running the checks."""
    from gspot_verified.report.write import render_from_json

    page = render_from_json(source, output)
    if as_json:
        _print_json({"page": str(page)})
    else:
        typer.echo(str(page))


@app.command(epilog="Example: gspot-verified cost theta --picture cost.png")
def cost(
    subject: Annotated[str, typer.Argument(help='What to measure: "theta".')],
    full: Annotated[bool, typer.Option("--full", help="Also 10^5 and 10^6 digits: about 20 minutes.")] = False,
    picture: Annotated[Path | None, typer.Option(help="Write time against digits as a PNG file.")] = None,
    as_json: JsonFlag = False,
) -> None:
    """Measure what accuracy costs in time, against FLINT's 1F2, mpmath, and PARI and ore_algebra where installed.

    About half a minute. The exit code is 0 whatever the times are: a benchmark decides nothing.
    """
    if subject != "theta":
        raise ValueError(f'cost: expected "theta", got {subject!r}')
    from gspot_verified.cost.picture import save_picture
    from gspot_verified.cost.theta import run as measure_theta

    result = measure_theta(full, _progress)
    if picture is not None:
        save_picture(result.curves, picture)
    if as_json:
        _print_json(result.to_json())
    else:
        typer.echo(str(result))


def _print_json(data: Any) -> None:
    typer.echo(json.dumps(data, ensure_ascii=False, indent=2, sort_keys=True))


def _progress(step: str) -> None:
    typer.echo(f"... {step}", err=True)


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command line and return its exit code; bad input is a message on stderr and 64."""
    try:
        code = app(
            prog_name="gspot-verified", args=None if arguments is None else list(arguments), standalone_mode=False
        )
    except (ValueError, TypeError, OSError) as error:
        typer.echo(f"error: {error}", err=True)
        return USAGE
    except (typer.Abort, KeyboardInterrupt):
        typer.echo("interrupted", err=True)
        return 130
    except Exception as error:
        # A usage error. Its class has moved between releases of typer; what they share is show().
        if hasattr(error, "show"):
            error.show()
            return USAGE
        # Never 1, which would read as "refuted".
        typer.echo(f"internal error, please report it: {type(error).__name__}: {error}", err=True)
        return INTERNAL
    return int(code) if isinstance(code, int) else 0


def run() -> None:
    """The console script."""
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors="backslashreplace")  # Greek letters on a stream that has none
    sys.exit(main())
