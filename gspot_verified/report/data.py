"""The report as plain data: what ``report.json`` holds, and the check that a file really is one."""

from __future__ import annotations

import json
import platform
import re
from collections import Counter
from collections.abc import Mapping, Sequence
from importlib import metadata
from pathlib import Path
from typing import Any

from gspot_verified.numbers.verdict import Outcome, Reason
from gspot_verified.paper.checks.consequences import Reach
from gspot_verified.paper.checks.entry import Check, Entry, Rung, carrying, conclude, counts, rung_counts
from gspot_verified.paper.checks.formal_proof import RUN_HERE
from gspot_verified.paper.claims import WHY, Standing, paper_claims, standing_counts
from gspot_verified.paper.dependencies import dependencies
from gspot_verified.report.certificates import CheckedCertificate
from gspot_verified.report.hard_cases import NONE, check_hard_cases
from gspot_verified.report.parts.proof_page import proof_pages
from gspot_verified.report.pictures.canvas import Picture

SCHEMA = 8  # one more with each change of form: only this one is read
_MAX_FILE_BYTES = 200_000_000  # far more than a report: a limit against hostile input

_OUTCOMES = [outcome.value for outcome in Outcome]
_STANDINGS = [standing.value for standing in Standing]
_LIMITED = [standing.value for standing in WHY]
"""The standings of a claim whose entries are proved and prove something else than its words."""
_RUNGS = [rung.name.lower() for rung in Rung]
_REACHES = [reach.value for reach in Reach]
_CONSEQUENCE_TEXTS = ("reach", "reason", "why", "table")
_REASONS = [reason.name.lower() for reason in Reason]
_ENTRY_TEXTS = ("identifier", "label", "printed", "section", "source", "statement", "corrected", "note", "code")
_PICTURE_TEXTS = ("name", "title", "caption", "alternative")
_CERTIFICATE_TEXTS = ("name", "sha256", "said")
_DEPENDENCIES = ("pages", "certificates", "entries", "see_also")
_FILE_NAME = re.compile(r"[A-Za-z0-9_-]{1,60}(\.cert)?")
_VERSIONS = ("gspot-verified", "python", "FLINT", "python-flint", "mpmath", "numpy", "matplotlib")


def versions() -> dict[str, str]:
    """What computed the report, by name. No date and no host, so that two runs agree."""
    import flint

    by_name = {name: _installed(name) for name in _VERSIONS}
    by_name["python"] = f"{platform.python_implementation()} {platform.python_version()}"
    by_name["FLINT"] = flint.__FLINT_VERSION__
    return by_name


def _installed(name: str) -> str:
    try:
        return metadata.version(name)
    except metadata.PackageNotFoundError:
        return "not installed as a package"


def report_data(
    entries: Sequence[Entry],
    pictures: Sequence[Picture],
    certificates: Sequence[CheckedCertificate] = (),
    hard: dict[str, Any] = NONE,
) -> dict[str, Any]:
    """What the pages show, as plain data for ``json.dumps``; figures, certificates, proof pages are files beside it.

    :raises ValueError: two entries have one identifier.
    """
    identifiers = [entry.identifier for entry in entries]
    outcomes = {entry.identifier: entry.verdict.outcome for entry in entries}
    return checked(
        {
            "schema": SCHEMA,
            "counts": counts(entries),
            "rungs": rung_counts(entries),
            "page_alone": sum(entry.page_alone for entry in entries),
            "claims": [claim.to_json(outcomes) for claim in paper_claims()] if entries else [],
            "standings": standing_counts(outcomes) if entries else dict.fromkeys(_STANDINGS, 0),
            "entries": [
                {**entry.to_json(), "dependencies": dependencies(entry, identifiers).to_json()} for entry in entries
            ],
            "figures": [picture.to_json() for picture in pictures],
            "hard_cases": hard,
            "certificates": [certificate.to_json() for certificate in certificates],
            "proofs": proof_pages(),
            "versions": versions(),
        }
    )


def report_text(path: Path) -> str:
    """The text of a ``report.json``.

    :raises ValueError: the file is larger than a report, or not UTF-8.
    """
    if path.stat().st_size > _MAX_FILE_BYTES:
        raise ValueError(f"larger than {_MAX_FILE_BYTES} bytes, so it is not a report")
    return path.read_text(encoding="utf-8")


def read_report(path: Path) -> dict[str, Any]:
    """What a ``report.json`` holds.

    :raises ValueError: the file is not JSON, has another schema, or is malformed; the message names the file.
    :raises OSError: the file cannot be read.
    """
    try:
        return checked(json.loads(report_text(path)))
    except UnicodeDecodeError:
        raise ValueError(f"{path}: not UTF-8 text") from None
    except RecursionError:
        raise ValueError(f"{path}: nested too deeply, so it is not a report") from None
    except ValueError as error:
        raise ValueError(f"{path}: {error}") from error


def checked(report: object) -> dict[str, Any]:
    """The report itself, when it has the form that this version writes.

    :raises ValueError: another schema, a missing or mistyped part, counts that do not agree with the entries, or a
        verdict that its checks do not give.

    >>> checked({"schema": 1})
    Traceback (most recent call last):
    ...
    ValueError: report: this version reads schema 8, the file has schema 1
    """
    data = _mapping(report, "report")
    if type(data.get("schema")) is not int or data["schema"] != SCHEMA:
        raise ValueError(f"report: this version reads schema {SCHEMA}, the file has schema {data.get('schema')!r}")
    entries = _sequence(data, "entries", "report")
    for number, entry in enumerate(entries):
        _check_entry(entry, f"entries[{number}]")
    for identifier, times in Counter(entry["identifier"] for entry in entries).items():
        if times > 1:
            raise ValueError(f"entries: the identifier {identifier!r} occurs {times} times")
    _check_counts(data, entries)
    for number, claim in enumerate(_sequence(data, "claims", "report")):
        _check_claim(
            claim, f"claims[{number}]", {entry["identifier"]: entry["verdict"]["outcome"] for entry in entries}
        )
    standings = {name: sum(claim["standing"] == name for claim in data["claims"]) for name in _STANDINGS}
    if json.dumps(data.get("standings"), sort_keys=True) != json.dumps(standings, sort_keys=True):
        raise ValueError(f"standings: the file says {data.get('standings')}, its claims give {standings}")
    check_hard_cases(data.get("hard_cases"))
    for number, picture in enumerate(_sequence(data, "figures", "report")):
        _texts(_mapping(picture, f"figures[{number}]"), _PICTURE_TEXTS, f"figures[{number}]")
        _file_name(picture["name"], f"figures[{number}].name")
    for number, certificate in enumerate(_sequence(data, "certificates", "report")):
        _texts(_mapping(certificate, f"certificates[{number}]"), _CERTIFICATE_TEXTS, f"certificates[{number}]")
        _file_name(certificate["name"], f"certificates[{number}].name")
        if not isinstance(certificate.get("verified"), bool):
            raise ValueError(f"certificates[{number}].verified: expected true or false")
        if certificate["verified"] is not certificate["said"].startswith("VERIFIED "):
            raise ValueError(f"certificates[{number}].said: it does not go with verified")
    proofs = _mapping(data.get("proofs"), "proofs")
    _texts(proofs, list(proofs), "proofs")
    for name in proofs:
        _file_name(name, "proofs")
    known = _mapping(data.get("versions"), "versions")
    _texts(known, _VERSIONS, "versions")
    return data


def _check_counts(report: dict[str, Any], entries: Sequence[dict[str, Any]]) -> None:
    """The stated numbers are those of the entries."""
    actual: dict[str, Any] = {
        "counts": {name: sum(e["verdict"]["outcome"] == name for e in entries) for name in _OUTCOMES},
        "rungs": {
            name: {rung: sum(e["verdict"]["outcome"] == name and e["rung"] == rung for e in entries) for rung in _RUNGS}
            for name in (Outcome.PROVED.value, Outcome.REFUTED.value)
        },
        "page_alone": sum(e["rests_on"] == [Rung.PAGE.name.lower()] for e in entries),
    }
    for name, numbers in actual.items():
        stated = report.get(name) if isinstance(numbers, int) else _mapping(report.get(name), name)
        # As texts, so that true is not 1.
        if json.dumps(stated, sort_keys=True) != json.dumps(numbers, sort_keys=True):
            raise ValueError(f"{name}: the file says {stated}, its entries give {numbers}")


def _check_claim(value: object, where: str, outcomes: Mapping[str, str]) -> None:
    """A row of the paper's claims: its standing is the one that its entries give."""
    claim = _mapping(value, where)
    _texts(claim, ("claim", "why"), where)
    _one_of(claim.get("standing"), _STANDINGS, f"{where}.standing")
    lines = _sequence(claim, "lines", where)
    if len(lines) != 2 or any(type(line) is not int for line in lines):
        raise ValueError(f"{where}.lines: expected two line numbers, got {lines}")
    verdicts = {outcomes.get(name) for name in _names(claim, "entries", where)}
    if verdicts:
        given = "refuted" if "refuted" in verdicts else "proved" if verdicts == {"proved"} else "undecided"
        if claim["standing"] != given and not (given == "proved" and claim["standing"] in _LIMITED):
            raise ValueError(f"{where}.standing: the file says {claim['standing']}, its entries give {given}")
        if claim["standing"] in _LIMITED and not claim["why"].strip():
            raise ValueError(f"{where}.why: {claim['standing']}, and nothing says by what")
    elif claim["standing"] in ("proved", "refuted", *_LIMITED):
        raise ValueError(f"{where}.standing: {claim['standing']} without an entry")


def _check_rungs(entry: dict[str, Any], where: str) -> None:
    """What an entry rests on: known rungs, the strongest first, and points never under "proved"."""
    rests_on = _sequence(entry, "rests_on", where)
    for rung in rests_on:
        _one_of(rung, _RUNGS, f"{where}.rests_on")
    if rests_on != sorted(set(rests_on), key=_RUNGS.index):
        raise ValueError(f"{where}.rests_on: expected each rung once, the strongest first, got {rests_on}")
    if "rung" not in entry or entry["rung"] != (rests_on[0] if rests_on else None):
        raise ValueError(f"{where}.rung: expected the first of rests_on, got {entry.get('rung')!r}")
    outcome = entry["verdict"]["outcome"]
    if bool(rests_on) is (outcome == Outcome.UNDECIDED.value):
        raise ValueError(f"{where}.rests_on: {rests_on} does not go with the outcome {outcome}")
    if outcome == Outcome.PROVED.value and Rung.POINTS.name.lower() in rests_on:
        raise ValueError(f"{where}.rests_on: a proof never rests on points")


def _check_quotations(entry: dict[str, Any], where: str) -> None:
    """Lines of the paper's source; "verbatim" says that there are some."""
    quotations = _sequence(entry, "quotations", where)
    for number, quotation in enumerate(quotations):
        place = f"{where}.quotations[{number}]"
        _texts(_mapping(quotation, place), ("latex",), place)
        ends = [quotation.get(key) for key in ("first", "last")]
        if any(type(end) is not int for end in ends) or not 1 <= ends[0] <= ends[1]:
            raise ValueError(f"{place}: expected line numbers, first not after last, got {ends}")
    if entry.get("lines") != [[quotation["first"], quotation["last"]] for quotation in quotations]:
        raise ValueError(f"{where}.lines: expected the lines of the quotations, got {entry.get('lines')!r}")
    if entry.get("verbatim") is not bool(quotations):
        raise ValueError(f"{where}.verbatim: {entry.get('verbatim')!r} with {len(quotations)} quotations")


def _check_formal(entry: dict[str, Any], where: str) -> None:
    """A formal proof is said to have been run if a check rests on it, and only then."""
    formal = entry["formal"]
    run = any(check["rung"] == Rung.FORMAL.name.lower() for check in entry["checks"])
    if formal is not None:
        _texts(_mapping(formal, f"{where}.formal"), ("state",), f"{where}.formal")
        if not isinstance(formal.get("run"), bool) or formal["run"] is not (formal["state"] == RUN_HERE):
            raise ValueError(f"{where}.formal: run is {formal.get('run')!r}, and its state {formal['state']!r}")
        for theorem in _sequence(formal, "theorems", f"{where}.formal"):
            _texts(
                _mapping(theorem, f"{where}.formal.theorems"), ("name", "statement", "file"), f"{where}.formal.theorems"
            )
    if run is not (formal is not None and formal["run"]):
        raise ValueError(f"{where}.formal: it does not go with the checks")


def _check_routes(entry: dict[str, Any], where: str) -> None:
    """The routes are the checks, and a formal proof that was not run."""
    formal = entry["formal"]
    routes = [(Rung[check["rung"].upper()].short, check["what"], True) for check in entry["checks"]]
    if formal is not None and not formal["run"]:
        routes.append((Rung.FORMAL.short, ", ".join(theorem["name"] for theorem in formal["theorems"]), False))
    if entry.get("routes") != [{"rung": rung, "what": what, "run": run} for rung, what, run in routes]:
        raise ValueError(f"{where}.routes: they are not those of the checks")


def _check_entry(value: object, where: str) -> None:
    entry = _mapping(value, where)
    _texts(entry, _ENTRY_TEXTS, where)
    for key in ("consequence", "formal"):
        if key not in entry:
            raise ValueError(f"{where}: {key!r} is missing")
    if not isinstance(entry.get("from_cache"), bool):
        raise ValueError(f"{where}.from_cache: expected true or false")
    verdict = _mapping(entry.get("verdict"), f"{where}.verdict")
    _texts(verdict, ("statement", "detail"), f"{where}.verdict")
    _one_of(verdict.get("outcome"), _OUTCOMES, f"{where}.verdict.outcome")
    for key in ("witness", "reason"):
        if key not in verdict:
            raise ValueError(f"{where}.verdict: {key!r} is missing")
    if verdict["outcome"] == Outcome.REFUTED.value or verdict["witness"] is not None:
        _texts(verdict, ("witness",), f"{where}.verdict")
    if verdict["outcome"] == Outcome.UNDECIDED.value or verdict["reason"] is not None:
        _one_of(verdict["reason"], _REASONS, f"{where}.verdict.reason")
    _check_rungs(entry, where)
    _check_quotations(entry, where)
    named = _mapping(entry.get("dependencies"), f"{where}.dependencies")
    for key in _DEPENDENCIES:
        _names(named, key, f"{where}.dependencies")
    reach = entry["consequence"]
    if reach is not None:
        _texts(_mapping(reach, f"{where}.consequence"), _CONSEQUENCE_TEXTS, f"{where}.consequence")
        _one_of(reach["reach"], _REACHES, f"{where}.consequence.reach")
    for box in _sequence(verdict, "remaining", f"{where}.verdict"):
        if not isinstance(box, list) or not all(isinstance(side, str) for side in box):
            raise ValueError(f"{where}.verdict.remaining: expected lists of texts")
    for number, check in enumerate(_sequence(entry, "checks", where)):
        place = f"{where}.checks[{number}]"
        _texts(_mapping(check, place), ("what", "finding"), place)
        _one_of(check.get("rung"), _RUNGS, f"{place}.rung")
        if "agrees" not in check or not (check["agrees"] is None or isinstance(check["agrees"], bool)):
            raise ValueError(f"{place}.agrees: expected true, false or null")
    _check_evidence(entry, where)
    _check_formal(entry, where)
    _check_routes(entry, where)


def _check_evidence(entry: dict[str, Any], where: str) -> None:
    """The verdict, and what it rests on, are those that the checks give."""
    checks = [
        Check(Rung[check["rung"].upper()], check["what"], check["agrees"], check["finding"])
        for check in entry["checks"]
    ]
    given, stated = conclude(entry["statement"], checks, "a witness").outcome, entry["verdict"]["outcome"]
    if stated != given.value:
        raise ValueError(f"{where}.verdict: the file says {stated}, its checks give {given.value}")
    rungs = [rung.name.lower() for rung in carrying(given, checks)]
    if entry["rests_on"] != rungs:
        raise ValueError(f"{where}.rests_on: the file says {entry['rests_on']}, its checks give {rungs}")


def _mapping(value: object, where: str) -> dict[str, Any]:
    if not isinstance(value, dict):
        raise ValueError(f"{where}: expected an object, got {type(value).__name__}")
    return value


def _sequence(holder: dict[str, Any], key: str, where: str) -> list[Any]:
    value = holder.get(key)
    if not isinstance(value, list):
        raise ValueError(f"{where}: expected a list under {key!r}")
    return value


def _names(holder: dict[str, Any], key: str, where: str) -> list[str]:
    names = _sequence(holder, key, where)
    if not all(isinstance(name, str) for name in names):
        raise ValueError(f"{where}.{key}: expected texts")
    return names


def _texts(holder: dict[str, Any], keys: Sequence[str], where: str) -> None:
    for key in keys:
        if not isinstance(holder.get(key), str):
            raise ValueError(f"{where}: expected text under {key!r}")


def _file_name(name: object, where: str) -> None:
    """A plain name: it becomes part of the name of a file or of a link."""
    if not (isinstance(name, str) and _FILE_NAME.fullmatch(name)):
        raise ValueError(f"{where}: expected letters, digits, - and _, got {name!r}")


def _one_of(value: object, allowed: Sequence[str], where: str) -> None:
    if value not in allowed:
        raise ValueError(f"{where}: expected one of {', '.join(allowed)}, got {value!r}")
