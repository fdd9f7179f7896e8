"""Commands ``sign``, ``zeros`` and ``check``."""

from __future__ import annotations

from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, NoReturn

import typer

from gspot_verified.cli.app import print_json, progress, show
from gspot_verified.cli.output import Outputs
from gspot_verified.cli.ranges_progress import RangesProgress

if TYPE_CHECKING:
    from gspot_verified.compliant.zeros.zero_certificate import SlowZerosCertificate
from typing import Annotated

from gspot_verified.cli.app import JournalFile, JsonFlag, Scheduler, Workers, app, refuse, warn
from gspot_verified.cli.command_groups import example
from gspot_verified.cli.output import PICTURES

DEFAULT_BETA = "1..7"
_MANY = 100  # ranges of beta: from so many on it is said how long the work may take


def zeros_at_finite_epsilon(beta: str, epsilon: str, digits: int, as_json: bool) -> NoReturn:
    """One beta, one epsilon.

    :raises ValueError: ``epsilon`` is a range.
    """
    from gspot_verified.compliant.zeros.zero_count import slow_zeros

    if ".." in epsilon:
        raise ValueError("--epsilon: a range of ε needs a range of β, such as 5..6")
    zeros = slow_zeros(beta, epsilon, digits)
    show(zeros, as_json)
    raise typer.Exit(zeros.verdict.exit_code)


def zeros_over_a_rectangle(
    outputs: Outputs,
    beta: str,
    epsilon: str,
    budget: int,
    picture: Path | None,
    certificate: Path | None,
    workers: int,
    scheduler: str | None,
    journal: Path | None,
    as_json: bool,
) -> NoReturn:
    """A range of beta, one epsilon or a range of them.

    :raises ValueError: a picture of one epsilon is asked for, or a certificate that is not for beta in (4, 5) and all
        small epsilon, or a file that is the journal of a row.
    """
    from gspot_verified.compliant.zeros.zero_map import least_work, row_file, zero_map
    from gspot_verified.work.executors import executor

    if picture is not None and ".." not in epsilon:
        raise ValueError("--picture needs a range of ε, such as 0..10")
    rows, ranges = least_work(beta, epsilon)
    if journal is not None:
        for number in range(rows):
            outputs.file("--journal", row_file(journal, number))
    proof = None if certificate is None else _certificate(beta, epsilon)
    if rows * ranges > _MANY:
        progress(
            f"{rows} rows of ε with {ranges} ranges of β each, and more where they are cut: {rows * ranges} or more at "
            f"about half a second, at most {budget} (--budget)"
        )
    shown = RangesProgress(rows=rows)
    with executor(workers, scheduler) as pool, outputs.journal(journal):
        zeros = zero_map(beta, epsilon, budget=budget, executor=pool, journal=journal, progress=shown)
    if picture is not None:
        from gspot_verified.report.pictures.zero_map_picture import save_zero_map

        outputs.write("--picture", picture, lambda: save_zero_map(zeros, picture))
    if proof is not None and certificate is not None:
        outputs.write("--certificate", certificate, partial(proof.write, certificate))
    show(zeros, as_json)
    outputs.leave(zeros.verdict.exit_code)


def _certificate(beta: str, epsilon: str) -> SlowZerosCertificate:
    from gspot_verified.compliant.zeros.zero_certificate import slow_zeros_certificate
    from gspot_verified.work.ranges import Range

    small = Range.parse(epsilon, "epsilon") if ".." in epsilon else None
    if small is None or small.lower != 0 or small.upper is None:
        raise ValueError("--certificate: with --epsilon it needs a range from 0 on, such as 0..10, and β inside 4..5")
    return slow_zeros_certificate(beta, small.upper)


DIGITS, BUDGET = 15, 5_000  # of zeros, where they are left out

CertificateFile = Annotated[Path | None, typer.Option("--certificate", help="Write a certificate that `check` reads.")]
TauRange = Annotated[str, typer.Option(help='Range of τ: "-inf..inf", "[-2..3)", "1/2". Open unless [ or ].')]
BetaRange = Annotated[str, typer.Option(help='Range of β, same form: "0..1" is the open interval.')]


@app.command(epilog=example("sign --tau=-inf..inf --beta 0..1 --certificate iwc.cert"))
def sign(
    tau: TauRange,
    beta: BetaRange,
    positive: Annotated[bool, typer.Option("--positive", help="Ask for dΘ/dτ > 0 instead of dΘ/dτ < 0.")] = False,
    budget: Annotated[int, typer.Option(help="How many ranges of β may be examined.")] = 2_000,
    by_theorem: Annotated[
        bool, typer.Option("--by-theorem", help="β <= 1: by the Laplace integral, no boxes.")
    ] = False,
    certificate: CertificateFile = None,
    workers: Workers = 1,
    scheduler: Scheduler = None,
    journal: JournalFile = None,
    as_json: JsonFlag = False,
) -> None:
    """The sign of dΘ/dτ on ranges of τ and β. Proved, refuted with a point, or undecided with what is left."""
    from gspot_verified.certificates.text import write_certificate
    from gspot_verified.signs.cover.sign import sign as sign_on_ranges
    from gspot_verified.work.executors import executor

    outputs = Outputs()
    outputs.file("--certificate", certificate)
    outputs.file("--journal", journal)
    wanted = 1 if positive else -1
    with executor(workers, scheduler) as pool, outputs.journal(journal):
        result = sign_on_ranges(
            tau,
            beta,
            wanted,
            budget=budget,
            by_theorem=by_theorem,
            executor=pool,
            journal=journal,
            progress=RangesProgress(),
        )
    statement, written = result.proved_statement, False
    if certificate is not None and statement is not None:
        written = outputs.write(
            "--certificate", certificate, lambda: write_certificate(certificate, statement, result.columns)
        )
    if as_json:
        print_json(result.to_json())
    else:
        typer.echo(str(result))
        if written:
            typer.echo(f"certificate of: {statement}: {certificate}")
    if certificate is not None and statement is None:
        warn(f"--certificate: nothing was proved, so {certificate} was not written")
    outputs.leave(result.verdict.exit_code)


@app.command(epilog=example("zeros --beta 7/3 --digits 30"))
def zeros(
    beta: Annotated[
        str | None,
        typer.Option(help='A range such as "1..13", or one value such as "7/3"; with --epsilon 1..7 if left out.'),
    ] = None,
    epsilon: Annotated[
        str | None,
        typer.Option(
            "--epsilon", "--eps", help='ε or "0..10" (0 < ε <= 100): the compliant model on its slow manifold, not Θ.'
        ),
    ] = None,
    digits: Annotated[int | None, typer.Option(help="At one value: decimals of the brackets; 15 if left out.")] = None,
    budget: Annotated[int | None, typer.Option(help="How many ranges of β may be examined; 5 000 if left out.")] = None,
    picture: Annotated[Path | None, typer.Option(help="Write the sign atlas of the range as PNG, PDF or SVG.")] = None,
    certificate: CertificateFile = None,
    workers: Workers = 1,
    scheduler: Scheduler = None,
    journal: JournalFile = None,
    as_json: JsonFlag = False,
) -> None:
    """All real zeros of dΘ/dτ, at one β or over a range of β. At one β brackets, over a range how many.

    How many is known for every β by the count law, at once; columns show it again and give tubes, for β <= 200. Exit
    code 2: a range of β is left without tubes.

    With --epsilon: of the contact force's deviation λ − λ̄ on the slow manifold of the compliant model at that ε,
    with α1 = -1 and C1 other than 0.
    """
    from gspot_verified.certificates.text import write_certificate
    from gspot_verified.signs.gamma.count_law import numbers_on
    from gspot_verified.signs.zeros.brackets import MAX_BETA
    from gspot_verified.signs.zeros.zeros import zeros_on_range
    from gspot_verified.work.executors import executor
    from gspot_verified.work.ranges import Range

    outputs = Outputs()
    outputs.file("--certificate", certificate)
    outputs.file("--journal", journal)
    outputs.file("--picture", picture, PICTURES)
    if beta is None:
        if epsilon is None:
            raise ValueError("--beta is needed")
        beta = DEFAULT_BETA
    if ".." in beta:
        refuse("it is for one value of β", {"--digits": digits})
    else:
        of_ranges = {"--journal": journal, "--scheduler": scheduler, "--budget": budget, "--picture": picture}
        refuse("it needs a range of β, such as 1..13", {**of_ranges, "--workers": None if workers == 1 else workers})
    decimals = DIGITS if digits is None else digits
    examined = BUDGET if budget is None else budget
    if epsilon is not None:
        if ".." in beta:
            zeros_over_a_rectangle(
                outputs=outputs,
                beta=beta,
                epsilon=epsilon,
                budget=examined,
                picture=picture,
                certificate=certificate,
                workers=workers,
                scheduler=scheduler,
                journal=journal,
                as_json=as_json,
            )
        refuse("with --epsilon it needs a range of β inside 4..5", {"--certificate": certificate})
        zeros_at_finite_epsilon(beta, epsilon, decimals, as_json)
    if ".." not in beta:
        _zeros_at(outputs, beta, decimals, certificate, as_json)
        return
    betas = Range.parse(beta, "beta")
    if certificate is not None and (betas.upper is None or betas.upper > MAX_BETA):
        raise ValueError(f"--certificate: no column is sought for β > {MAX_BETA}")
    progress(f"by the count law, {numbers_on(betas)}")
    with executor(workers, scheduler) as pool, outputs.journal(journal):
        result = zeros_on_range(
            betas, budget=examined, executor=pool, journal=journal, progress=RangesProgress(tubes=True)
        )
    statement = result.statement
    if certificate is not None and statement is not None:
        outputs.write("--certificate", certificate, lambda: write_certificate(certificate, statement, result.columns))
    if picture is not None:
        from gspot_verified.report.figures.atlas import save_atlas

        outputs.write("--picture", picture, lambda: save_atlas(result, picture))
    show(result, as_json)
    if certificate is not None and statement is None:
        warn(f"--certificate: columns do not prove it, so {certificate} was not written")
    outputs.leave(2 if result.unfinished else 0)


def _zeros_at(outputs: Outputs, beta: str, digits: int, certificate: Path | None, as_json: bool) -> None:
    from flint import fmpq

    from gspot_verified.certificates.text import write_certificate
    from gspot_verified.numbers.balls import exact
    from gspot_verified.signs.gamma.count_law import number_of_zeros
    from gspot_verified.signs.zeros.brackets import MAX_BETA, zeros_at
    from gspot_verified.signs.zeros.integer_zeros import zeros_at_integer
    from gspot_verified.signs.zeros.slope_at import UndecidedError

    value = exact(beta, "beta")
    if isinstance(value, fmpq) and value > MAX_BETA:
        if certificate is not None:
            raise ValueError(f"--certificate: no column is sought for β > {MAX_BETA}")
        number, route = number_of_zeros(value), "the count law"
        if as_json:
            print_json({"beta": str(value), "number": number, "route": route})
        else:
            typer.echo(f"β = {value}: {number} different real zeros of dΘ/dτ")
            typer.echo(f"  route: {route} (proofs/count_law.md); brackets are sought for β <= {MAX_BETA}")
        return
    if isinstance(value, fmpq) and value.q == 1:
        if certificate is not None:
            raise ValueError("--certificate: at an integer β dΘ/dτ is a polynomial; no certificate is made")
        at_integer = zeros_at_integer(int(value.p), digits)
        show(at_integer, as_json)
        return
    try:
        isolated = zeros_at(beta, digits)
    except UndecidedError as error:
        typer.echo(f"undecided: {error}", err=True)
        raise typer.Exit(2) from None
    if certificate is not None:
        outputs.write(
            "--certificate", certificate, lambda: write_certificate(certificate, isolated.statement, [isolated.column])
        )
    show(isolated, as_json)
    outputs.leave(0)


@app.command(epilog=example("check iwc.cert"))
def check(
    file: Annotated[Path, typer.Argument(help="A certificate.")],
    workers: Annotated[int, typer.Option(help="Processes that share the columns; the answer is the same.")] = 1,
    limit: Annotated[
        list[str] | None, typer.Option(help="NAME=NUMBER: raise a limit of the checker on purpose, such as work=100.")
    ] = None,
    as_json: JsonFlag = False,
) -> None:
    """Re-check a certificate with proofs/checker. In a process of its own that imports nothing of this package.

    Exit code 0 when it is verified, 1 when it is rejected.
    """
    from gspot_verified.certificates.checker import check as run_checker

    if file.is_dir():
        raise ValueError(f"FILE: {file} is a folder, not a certificate")
    result = run_checker(file, workers, limit or ())
    if as_json:
        print_json(result.to_json())
    else:
        typer.echo(result.text, err=not result.verified)
    raise typer.Exit(0 if result.verified else 1)
