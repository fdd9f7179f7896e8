"""Commands ``verify`` and ``report``."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from gspot_verified.cli.app import JsonFlag, app, print_json, progress
from gspot_verified.cli.output import Outputs


@app.command(
    short_help="Check the paper, claim by claim, and write the report.",
    epilog="Example: gspot-verified verify --output report",
)
def verify(
    output: Annotated[Path, typer.Option(help="Directory of the report.")] = Path("report"),
    as_json: JsonFlag = False,
) -> None:
    """Check the paper, Sections 1 to 6 and Appendices A and B, claim by claim, and write the report.

    Exit code 1 when a printed statement is refuted (the paper has misprints), 2 when one is undecided.
    """
    from gspot_verified.ledger.claims import standing_counts
    from gspot_verified.ledger.entry import Rung, counts, rung_counts
    from gspot_verified.ledger.verify import exit_code, verify_paper
    from gspot_verified.report.write import write_report

    outputs = Outputs()
    outputs.folder("--output", output)
    entries = verify_paper(progress)
    written = outputs.write("--output", output, lambda: write_report(entries, output, progress))
    if as_json:
        numbers = {
            "counts": counts(entries),
            "rungs": rung_counts(entries),
            "page_alone": sum(entry.page_alone for entry in entries),
            "claims": standing_counts({entry.identifier: entry.verdict.outcome for entry in entries}),
        }
        print_json({**numbers, "entries": [entry.to_json() for entry in entries]})
    else:
        for entry in entries:
            place = entry.cited.printed or entry.label
            typer.echo(f"{entry.verdict.outcome.value:9}  {place:28}  {entry.statement}")
            if entry.verdict.outcome.value == "refuted":
                typer.echo(f"{'':9}  {'corrected:':28}  {entry.corrected}")
        for outcome, row in rung_counts(entries).items():
            words = (f"{number} on {Rung[name.upper()].short}" for name, number in row.items() if number)
            typer.echo(f"{outcome}: " + (", ".join(words) or "none"))
        alone = sum(entry.page_alone for entry in entries)
        typer.echo(f"{alone} of {len(entries)} rest on a proof page alone")
        claims = standing_counts({entry.identifier: entry.verdict.outcome for entry in entries})
        listed = ", ".join(f"{number} {standing}" for standing, number in claims.items())
        typer.echo(f"of the paper's {sum(claims.values())} claims: {listed}")
        total = counts(entries)
        typer.echo(", ".join(f"{number} {outcome}" for outcome, number in total.items()))
        if written:
            typer.echo(f"report: {output / 'index.html'}")
    outputs.leave(exit_code(entries))


@app.command(epilog="Example: gspot-verified report report/report.json --output report")
def report(
    source: Annotated[Path, typer.Argument(help="A report.json that `verify` wrote.")] = Path("report/report.json"),
    output: Annotated[Path, typer.Option(help="Directory of the pages.")] = Path("report"),
    check: Annotated[
        Path | None,
        typer.Option(help="Write nothing; check the certificates of this report again.", metavar="<folder>"),
    ] = None,
    as_json: JsonFlag = False,
) -> None:
    """Write the pages again from report.json, without running the checks; or check a report's certificates again.

    With --check: exit code 0 when the independent checker verifies every certificate that report.json names, and each
    says what it said then; 1 when one is rejected, missing or says something else.
    """
    if check is not None:
        _check_again(check, as_json)
        return
    from gspot_verified.report.write import render_from_json

    if not source.is_file():
        raise ValueError(f"SOURCE: there is no file {source}")
    Outputs().folder("--output", output)
    page = render_from_json(source, output)
    if as_json:
        print_json({"page": str(page)})
    else:
        typer.echo(str(page))


def _check_again(folder: Path, as_json: bool) -> None:
    from gspot_verified.report.check_again import check_again

    found = check_again(folder, progress)
    if as_json:
        print_json({"certificates": [result.to_json() for result in found]})
    else:
        for result in found:
            typer.echo(f"{'verified' if result.same else 'FAILED':9}  {result.name}  {result.said}")
    raise typer.Exit(0 if all(result.same for result in found) else 1)
