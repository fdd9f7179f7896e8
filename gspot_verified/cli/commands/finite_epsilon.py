"""``zeros --epsilon``: the zeros of the slow solution of the compliant model, at one point or over a rectangle."""

from __future__ import annotations

from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, NoReturn

import typer

from gspot_verified.cli.app import print_json, progress
from gspot_verified.cli.output import Outputs
from gspot_verified.cli.ranges_progress import RangesProgress

if TYPE_CHECKING:
    from gspot_verified.compliant.zeros.zero_certificate import SlowZerosCertificate

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
    if as_json:
        print_json(zeros.to_json())
    else:
        typer.echo(str(zeros))
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
        small epsilon.
    """
    from gspot_verified.compliant.zeros.zero_map import least_work, zero_map
    from gspot_verified.work.executors import executor

    if picture is not None and ".." not in epsilon:
        raise ValueError("--picture needs a range of ε, such as 0..10")
    proof = None if certificate is None else _certificate(beta, epsilon)
    rows, ranges = least_work(beta, epsilon)
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
    if as_json:
        print_json(zeros.to_json())
    else:
        typer.echo(str(zeros))
    outputs.leave(zeros.verdict.exit_code)


def _certificate(beta: str, epsilon: str) -> SlowZerosCertificate:
    from gspot_verified.compliant.zeros.zero_certificate import slow_zeros_certificate
    from gspot_verified.work.ranges import Range

    small = Range.parse(epsilon, "epsilon") if ".." in epsilon else None
    if small is None or small.lower != 0 or small.upper is None:
        raise ValueError("--certificate: with --epsilon it needs a range from 0 on, such as 0..10, and β inside 4..5")
    return slow_zeros_certificate(beta, small.upper)
