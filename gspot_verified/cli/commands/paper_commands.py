"""Commands ``verify`` and ``report``."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from gspot_verified.cli.app import JsonFlag, app, print_json, progress, warn
from gspot_verified.cli.output import Outputs

if TYPE_CHECKING:
    from gspot_verified.paper.checks.formal_proof import ProofRun


@app.command(
    short_help="Check the paper, claim by claim, and write the report.",
    epilog="Example: gspot-verified verify S-iwc S-side",
)
def verify(
    claims: Annotated[
        list[str] | None, typer.Argument(help="Identifiers of the ledger; all of them if none.", metavar="[CLAIM]...")
    ] = None,
    output: Annotated[Path | None, typer.Option(help="Directory of the report; report if not given.")] = None,
    full: Annotated[bool, typer.Option("--full", help="Run every check again; take nothing from the cache.")] = False,
    formal: Annotated[
        bool, typer.Option("--formal", help="Run the formal proofs of proofs/coq/ too, with Coq: minutes.")
    ] = False,
    alone: Annotated[
        bool, typer.Option("--alone", help="With claims: leave out the entries that their checks name.")
    ] = False,
    cache: Annotated[
        Path | None,
        typer.Option(help="Where results are kept; build/ledger of a clone, else in ~/.cache.", metavar="<folder>"),
    ] = None,
    workers: Annotated[
        int | None,
        typer.Option(help="Processes for the whole paper and its report; one a core, at most 16, if not given."),
    ] = None,
    as_json: JsonFlag = False,
) -> None:
    """Check the paper, Sections 1 to 7 and Appendices A and B, claim by claim, and write the report.

    With claims: these entries, and those that their checks name; no report. A result is kept under the hash of all
    sources, proofs and versions, so that a run that was killed goes on, and shown as kept. Of formal proofs nothing is
    kept: they count where --formal runs them. Exit code 1 when a printed
    statement is refuted (the paper has misprints), 2 when one is undecided; of the named ones if some are named.
    """
    from gspot_verified.cli.ledger_output import claims_data, paper_data, print_claims, print_paper
    from gspot_verified.paper.cache import Cache, default_folder
    from gspot_verified.paper.verify import exit_code, verify_claims, verify_paper
    from gspot_verified.report.write import write_report
    from gspot_verified.work.executors import cores, executor

    outputs = Outputs()
    if claims and output is not None:
        raise ValueError("--output: the report is of the whole paper; name no claims")
    if alone and not claims:
        raise ValueError("--alone: for named claims")
    if claims and workers is not None:
        raise ValueError("--workers: for the whole paper; name no claims")
    folder = output or Path("report")
    if not claims:
        outputs.folder("--output", folder)
    kept = Cache(cache or default_folder(), read=not full)
    proofs = _formal_proofs() if formal else None
    if claims:
        named, further = verify_claims(claims, progress, kept, alone, proofs)
        if as_json:
            print_json(claims_data(named, further))
        else:
            print_claims(named, further)
    else:
        with executor(min(cores(), 16) if workers is None else workers) as pool:
            named = verify_paper(progress, kept, proofs, pool)
            written = outputs.write("--output", folder, lambda: write_report(named, folder, progress, pool))
        if as_json:
            print_json(paper_data(named))
        else:
            print_paper(named)
            if written:
                typer.echo(f"report: {folder / 'index.html'}")
    if kept.closed:
        warn(f"the cache was not used to the end: {kept.closed}")
    outputs.leave(exit_code(named))


def _formal_proofs() -> ProofRun:
    from gspot_verified.paper.checks.formal_proof import run_proofs

    progress("the formal proofs of proofs/coq/, by Coq")
    run = run_proofs()
    if run.failure:
        warn(f"the formal proofs do not count: {run.failure}")
    return run


@app.command(epilog="Example: gspot-verified report report/report.json --output report")
def report(
    source: Annotated[Path, typer.Argument(help="A report.json that `verify` wrote.")] = Path("report/report.json"),
    output: Annotated[Path, typer.Option(help="Directory of the pages.")] = Path("report"),
    cost: Annotated[
        Path | None, typer.Option(help="A measurement that `cost --output` wrote, for the page on cost.")
    ] = None,
    check: Annotated[
        Path | None,
        typer.Option(help="Write nothing; check the certificates of this report again.", metavar="<folder>"),
    ] = None,
    supplement: Annotated[
        Path | None,
        typer.Option(
            help="Write errata.tex and theorems.tex instead, and their PDFs where pdflatex is.", metavar="<folder>"
        ),
    ] = None,
    as_json: JsonFlag = False,
) -> None:
    """Write the pages again from report.json, without running the checks; or check a report's certificates again.

    With --supplement: the errata, two pages for the authors, and the theorems beyond the paper with their formal
    statements. With --check: exit code 0 when the independent checker verifies every certificate that report.json
    names, and each says what it said then; 1 when one is rejected, missing or says something else.
    """
    if check is not None:
        if cost is not None or supplement is not None:
            raise ValueError("--check writes nothing, so --cost and --supplement have no use with it")
        _check_again(check, as_json)
        return
    from gspot_verified.report.write import render_report

    if not source.is_file():
        raise ValueError(f"SOURCE: there is no file {source}")
    if cost is not None and not cost.is_file():
        raise ValueError(f"--cost: there is no file {cost}")
    if supplement is not None:
        _write_supplement(source, supplement, as_json)
        return
    Outputs().folder("--output", output)
    page = render_report(source, output, cost)
    if as_json:
        print_json({"page": str(page)})
    else:
        typer.echo(str(page))


def _write_supplement(source: Path, folder: Path, as_json: bool) -> None:
    from gspot_verified.report.write import write_supplement

    Outputs().folder("--supplement", folder)
    made = write_supplement(source, folder)
    for warning in made.warnings:
        warn(warning)
    if as_json:
        print_json({"files": [str(path) for path in made.files], "warnings": list(made.warnings)})
    else:
        typer.echo("\n".join(str(path) for path in made.files))


def _check_again(folder: Path, as_json: bool) -> None:
    from gspot_verified.report.check_again import check_report

    results = check_report(folder, progress)
    if as_json:
        print_json({"certificates": [result.to_json() for result in results]})
    else:
        for result in results:
            typer.echo(f"{'verified' if result.same else 'FAILED':9}  {result.name}  {result.said}")
    raise typer.Exit(0 if all(result.same for result in results) else 1)
