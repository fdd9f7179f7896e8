"""Commands ``verify`` and ``report``."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, NoReturn

import typer

from gspot_verified.cli.app import JsonFlag, app, print_json, progress, warn
from gspot_verified.cli.command_groups import example
from gspot_verified.cli.output import Outputs

if TYPE_CHECKING:
    from gspot_verified.paper.checks.formal_proof import ProofRun


@app.command(
    short_help="Check the paper, claim by claim, and write the report.",
    epilog=example("verify S-iwc S-side"),
)
def verify(
    claims: Annotated[
        list[str] | None, typer.Argument(help="Identifiers of the ledger; all of them if none.", metavar="CLAIM")
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


@app.command(
    short_help="Pages to read: on the paper, or on your own mechanism.",
    epilog=example("report --mechanism oscillator"),
)
def report(
    source: Annotated[Path, typer.Argument(help="A report.json that `verify` wrote; on the paper only.")] = Path(
        "report/report.json"
    ),
    output: Annotated[
        Path | None, typer.Option(help="Directory of the pages; report if not given, mechanism_report of a mechanism.")
    ] = None,
    cost: Annotated[
        Path | None, typer.Option(help="A measurement that `cost --output` wrote, for the page on cost.")
    ] = None,
    check: Annotated[
        Path | None,
        typer.Option(help="Check the certificates of the report in this folder again.", metavar="<folder>"),
    ] = None,
    supplement: Annotated[
        Path | None,
        typer.Option(
            help="Write errata.tex and theorems.tex here, and their PDFs where pdflatex is.", metavar="<folder>"
        ),
    ] = None,
    mechanism: Annotated[
        str | None, typer.Option(help="Report on this mechanism: a TOML file or a name, as for classify.")
    ] = None,
    settings: Annotated[
        list[str] | None, typer.Option("--set", metavar="NAME=VALUE", help='A parameter of the mechanism, "mu=2".')
    ] = None,
    states: Annotated[
        list[str] | None,
        typer.Option("--from", help="With --mechanism: a state for a certified run, as for approach; may be repeated."),
    ] = None,
    scene: Annotated[str | None, typer.Option(help="With --mechanism: a scene of it, for a certified run.")] = None,
    budget: Annotated[int | None, typer.Option(help="With --mechanism: boxes of the search for all G-spots.")] = None,
    as_json: JsonFlag = False,
) -> None:
    """Pages to read: on the paper, or on your own mechanism. It does one of four things; none runs the paper's checks.

    On the paper, with no option or --output and --cost: writes the HTML pages from the report.json that `verify` wrote.
    `verify` writes them too; this is for a report.json of another machine, or with another measurement of cost.

    On your own mechanism, with --mechanism (and --set, --from, --scene, --budget): one page for a paper's appendix,
    mechanism.html, with mechanism.json and certificates beside it: its G-spots, cases and sides, the expansion,
    certified runs, pictures, hashes and the commands for each part. It needs no report.json. Exit code 0 when all that
    is stated is proved, 1 when something is refuted (there is no G-spot in the region, or a run), 2 when something is
    undecided.

    To check a report again, with --check: writes nothing. Exit code 0 when the independent checker verifies every
    certificate that its report.json names, and each says what it said then; 1 when one is rejected, missing or says
    something else.

    For the authors of the paper, with --supplement: the errata on two pages and the theorems beyond the paper with
    their formal statements, as LaTeX.
    """
    if mechanism is not None:
        if check is not None or cost is not None or supplement is not None:
            raise ValueError("--mechanism: --check, --cost and --supplement are for the report on the paper")
        _report_on(mechanism, output or Path("mechanism_report"), settings, states, scene, budget, as_json)
    if settings or states or scene is not None or budget is not None:
        raise ValueError("--set, --from, --scene and --budget go with --mechanism")
    if check is not None:
        if cost is not None or supplement is not None or output is not None:
            raise ValueError("--check writes nothing, so --cost, --output and --supplement have no use with it")
        _check_again(check, as_json)
        return
    if supplement is not None and (output is not None or cost is not None):
        raise ValueError("--supplement names its own folder, so --output and --cost have no use with it")
    from gspot_verified.report.write import render_report

    if not source.is_file():
        raise ValueError(f"SOURCE: there is no file {source}")
    if cost is not None and not cost.is_file():
        raise ValueError(f"--cost: there is no file {cost}")
    if supplement is not None:
        _write_supplement(source, supplement, as_json)
        return
    folder = output or Path("report")
    Outputs().folder("--output", folder)
    page = render_report(source, folder, cost)
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


def _report_on(
    name: str,
    folder: Path,
    settings: list[str] | None,
    states: list[str] | None,
    scene: str | None,
    budget: int | None,
    as_json: bool,
) -> NoReturn:
    from gspot_verified.cli.load import components, given_values
    from gspot_verified.report.mechanism.mechanism_report import PAGE, check_not_replaced, mechanism_report, write_pages

    outputs = Outputs()
    outputs.folder("--output", folder)
    try:
        check_not_replaced(folder, name, scene)
    except FileExistsError as error:
        raise ValueError(f"--output: {error}") from None
    starts = [components(state) for state in states or []]
    result = mechanism_report(
        name, settings=given_values(settings), states=starts, scene=scene, budget=budget, progress=progress
    )
    written = outputs.write("--output", folder, lambda: write_pages(result, folder))
    if as_json:
        print_json({"page": str(folder / PAGE), **result.to_json()})
    else:
        for part in result.parts:
            typer.echo(f"{part.outcome.value if part.outcome else '':10} {part.title}")
        if written:
            typer.echo(f"page: {folder / PAGE}")
    outputs.leave(result.exit_code)


def _check_again(folder: Path, as_json: bool) -> None:
    from gspot_verified.report.check_again import check_report

    results = check_report(folder, progress)
    if as_json:
        print_json({"certificates": [result.to_json() for result in results]})
    else:
        for result in results:
            typer.echo(f"{'verified' if result.same else 'FAILED':9}  {result.name}  {result.said}")
    raise typer.Exit(0 if all(result.same for result in results) else 1)
