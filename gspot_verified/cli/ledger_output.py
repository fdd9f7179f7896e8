"""What ``verify`` prints: the paper's entries with all counts and their denominators, or some entries in full."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import typer

from gspot_verified.numbers.verdict import Outcome
from gspot_verified.paper.checks.entry import Entry, Rung, counts, rung_counts
from gspot_verified.paper.claims import WHY, PaperClaim, Standing, paper_claims, standing_counts

_ANSWERS = {True: "agrees", False: "fails", None: "could not tell"}
_KEPT = "cached"
NOT_RUN = "not run"
"""The standing of a claim when one of its entries was not asked for."""


def paper_data(entries: Sequence[Entry]) -> dict[str, Any]:
    """The whole ledger as plain data for ``json.dumps``."""
    outcomes = _outcomes(entries)
    return {
        **_numbers(entries),
        "standings": standing_counts(outcomes),
        "claims": [claim.to_json(outcomes) for claim in paper_claims()],
        "entries": [entry.to_json() for entry in entries],
        "named_by_checks": [],
    }


def claims_data(named: Sequence[Entry], further: Sequence[Entry]) -> dict[str, Any]:
    """Some entries, those that their checks name, and the paper's claims that the named ones belong to."""
    outcomes = _outcomes([*named, *further])
    rows = [{**claim.to_json(outcomes), "standing": _standing(claim, outcomes)} for claim in _about(named)]
    return {
        **_numbers(named),
        "standings": None,
        "claims": rows,
        "entries": [entry.to_json() for entry in named],
        "named_by_checks": [entry.to_json() for entry in further],
    }


def print_paper(entries: Sequence[Entry]) -> None:
    """One line for each entry; then what is proved of how much, on what, and what was run."""
    for entry in entries:
        typer.echo(_line(entry))
        if entry.verdict.outcome is Outcome.REFUTED:
            typer.echo(f"{'':9}  {'':6}  {'corrected:':30}  {entry.corrected}")
    total = counts(entries)
    for outcome, row in rung_counts(entries).items():
        words = (f"{number} on {Rung[name.upper()].short}" for name, number in row.items() if number)
        typer.echo(f"{outcome}: {total[outcome]} of {len(entries)}: " + (", ".join(words) or "none"))
    alone = sum(entry.page_alone for entry in entries)
    typer.echo(f"{alone} of {len(entries)} rest on a proof page alone")
    standings = standing_counts(_outcomes(entries))
    listed = ", ".join(f"{number} {standing}" for standing, number in standings.items())
    typer.echo(f"of the paper's {sum(standings.values())} claims: {listed}")
    typer.echo(f"of {len(entries)} entries: " + ", ".join(f"{number} {outcome}" for outcome, number in total.items()))
    typer.echo(what_was_run(entries))


def print_claims(named: Sequence[Entry], further: Sequence[Entry]) -> None:
    """The named entries in full, a line for each of the further ones, and the claims of the paper that they carry."""
    for entry in named:
        _print_entry(entry)
    if further:
        typer.echo("named by their checks:")
        for entry in further:
            typer.echo(f"  {_line(entry)}")
    outcomes = _outcomes([*named, *further])
    for claim in _about(named):
        standing = _standing(claim, outcomes)
        typer.echo(f"the paper's claim, lines {claim.first} to {claim.last}: {standing}: {claim.words}")
        if claim.why:
            typer.echo(f"  {WHY.get(claim.proved_as, 'why')}: {claim.why}")
    total = ", ".join(f"{number} {outcome}" for outcome, number in counts(named).items())
    typer.echo(f"of {len(named)} named: {total}; the paper makes {len(paper_claims())} claims")
    typer.echo(what_was_run([*named, *further]))


def what_was_run(entries: Sequence[Entry]) -> str:
    """How many of the entries were run now, and how many were not.

    >>> what_was_run([])
    'run now: all 0'
    """
    kept = sum(entry.from_cache for entry in entries)
    if not kept:
        return f"run now: all {len(entries)}"
    total = len(entries)
    return (
        f"run now: {total - kept} of {total}; {_KEPT} from earlier runs on the same sources and versions: "
        f"{kept} of {total} (--full runs them again)"
    )


def _print_entry(entry: Entry) -> None:
    typer.echo(_line(entry))
    for check in entry.checks:
        typer.echo(f"  {_ANSWERS[check.agrees]}: {check.what}")
        typer.echo(f"    by {check.rung.value}")
        if check.finding:
            typer.echo(f"    found: {check.finding}")
    for rung, what, run in entry.routes:
        if not run:
            typer.echo(f"  not run here: {what} ({rung})")
    if entry.corrected:
        refuted = entry.verdict.outcome is Outcome.REFUTED
        typer.echo(f"  {'corrected' if refuted else 'condition or precise form'}: {entry.corrected}")
    if entry.verdict.outcome is Outcome.UNDECIDED:
        reason = entry.verdict.reason.value if entry.verdict.reason else ""
        typer.echo(f"  undecided: {reason}: {entry.verdict.detail}")


def _line(entry: Entry) -> str:
    kept = _KEPT if entry.from_cache else ""
    place = f"{entry.identifier}: {entry.cited.printed or entry.label}"
    return f"{entry.verdict.outcome.value:9}  {kept:6}  {place:30}  {entry.statement}"


def _numbers(entries: Sequence[Entry]) -> dict[str, Any]:
    kept = sum(entry.from_cache for entry in entries)
    return {
        "counts": counts(entries),
        "rungs": rung_counts(entries),
        "page_alone": sum(entry.page_alone for entry in entries),
        "run": {"entries": len(entries), "now": len(entries) - kept, "cached": kept},
    }


def _outcomes(entries: Sequence[Entry]) -> dict[str, Outcome]:
    return {entry.identifier: entry.verdict.outcome for entry in entries}


def _about(named: Sequence[Entry]) -> list[PaperClaim]:
    identifiers = {entry.identifier for entry in named}
    return [claim for claim in paper_claims() if identifiers & set(claim.entries)]


def _standing(claim: PaperClaim, outcomes: dict[str, Outcome]) -> str:
    """What became of the claim; not run, where an entry of it was not and no other one refutes it."""
    standing = claim.standing(outcomes)
    return NOT_RUN if standing is not Standing.REFUTED and set(claim.entries) - set(outcomes) else standing.value
