"""The contact force after a G-spot, on both sides of the canard, and the number of zeros of its deviation: statements
with certificates."""

from __future__ import annotations

import tempfile
from pathlib import Path

from flint import arb

from gspot_verified.certificates.text import certificate_text
from gspot_verified.compliant.contact.iwc import CompliantIwc
from gspot_verified.compliant.zeros.force_certificate import iwc_certificate
from gspot_verified.leading_order.iwc import IwcResult
from gspot_verified.mechanisms.iwc import iwc
from gspot_verified.numbers.balls import Exact
from gspot_verified.numbers.verdict import Outcome
from gspot_verified.report.certificates import CheckedCertificate, checked
from gspot_verified.report.mechanism.subject import ReportPart, Subject, beta_ends, outcome_of
from gspot_verified.report.pictures.contact_force_picture import contact_force_picture
from gspot_verified.signs.cover.sign import sign
from gspot_verified.signs.zeros.brackets import zeros_at
from gspot_verified.signs.zeros.integer_zeros import zeros_at_integer
from gspot_verified.signs.zeros.zeros import zeros_on_range

_PICTURE_EPSILON = "1/1000"


def force_part(subject: Subject, c1: int, title: str) -> ReportPart:
    """Whether the contact holds with this sign of C_1; with a certificate where the alphas are rational, 1 < beta < 5.

    :raises ValueError: the G-spot is in no Case, or its compliance is not the paper's.
    """
    result = iwc(subject.classified, c1=c1)
    words, text = [f"--c1={c1}"], str(result)
    files: tuple[CheckedCertificate, ...] = ()
    if isinstance(result.leading, IwcResult):
        name = subject.certificate_name("impact" if result.leading.force.takes_impact else "lift-off")
        try:
            files = (_checked_text(name, iwc_certificate(result.leading).text()),)
            words += ["--certificate", name]
        except ValueError as error:
            text += f"\nno certificate: {error}"
    else:
        text += "\nno certificate: it needs rational alphas, and those of this G-spot are balls"
    return ReportPart(
        title,
        outcome_of(statement.verdict for statement in result.statements),
        text,
        (subject.source.command("iwc", *words, option="--mechanism"), *_checks(files)),
        certificates=files,
        data=result.to_json(),
    )


def force_picture_part(subject: Subject) -> ReportPart:
    """The force at leading order on both sides.

    :raises ValueError: the alphas are no rational numbers, or the G-spot is in no Case.
    """
    result: CompliantIwc = iwc(subject.classified, c1=1)
    if not isinstance(result.leading, IwcResult):
        raise ValueError("the picture needs rational alphas, and those of this G-spot are balls")
    command = subject.source.python(
        "iwc, load, plot", f'plot(iwc({{mechanism}}, c1=1), "force.svg", epsilon="{_PICTURE_EPSILON}")'
    )
    drawn = contact_force_picture(result.leading.force, _PICTURE_EPSILON)
    return ReportPart(drawn.title, None, drawn.caption, (command,), drawn)


def zeros_part(subject: Subject) -> ReportPart:
    """Case III: how many zeros the deviation of the force has at leading order; Cases I and II: that it has none.

    :raises ValueError: the G-spot is in no Case, or beta is beyond what certificates cover.
    """
    beta = subject.classified.beta
    if beta is None or subject.classified.case not in ("I", "II", "III"):
        raise ValueError(f"the statement is about Cases I, II and III, and here: {subject.classified.reason}")
    if subject.classified.case != "III":
        return _without_zeros(subject, _range(beta))
    title = "The zeros of dΘ/dτ, to which the deviation of the force is proportional at leading order"
    if isinstance(beta, arb):
        return _zeros_over(subject, title, _range(beta))
    if beta.q == 1:
        command = f"gspot-verified zeros --beta {beta}"
        found = zeros_at_integer(int(beta.p))
        text = f"{found}\nno certificate: at an integer β dΘ/dτ is a polynomial"
        return ReportPart(title, Outcome.PROVED, text, (command,), data=found.to_json())
    isolated = zeros_at(beta)
    name = subject.certificate_name("zeros")
    files = (_checked_text(name, certificate_text(isolated.statement, [isolated.column])),)
    command = f"gspot-verified zeros --beta {beta} --certificate {name}"
    commands = (command, *_checks(files))
    return ReportPart(title, Outcome.PROVED, str(isolated), commands, certificates=files, data=isolated.to_json())


def _without_zeros(subject: Subject, beta: str) -> ReportPart:
    result = sign("-inf..inf", beta)
    files: tuple[CheckedCertificate, ...] = ()
    command = f"gspot-verified sign --tau=-inf..inf --beta {beta}"
    if result.proved_statement is not None:
        name = subject.certificate_name("sign")
        files = (_checked_text(name, certificate_text(result.proved_statement, result.columns)),)
        command += f" --certificate {name}"
    return ReportPart(
        "The sign of dΘ/dτ, to which the deviation of the force is proportional at leading order",
        result.verdict.outcome,
        str(result),
        (command, *_checks(files)),
        certificates=files,
        data=result.to_json(),
    )


def _zeros_over(subject: Subject, title: str, beta: str) -> ReportPart:
    result = zeros_on_range(beta)
    files: tuple[CheckedCertificate, ...] = ()
    command = f"gspot-verified zeros --beta {beta}"
    if result.statement is not None:
        name = subject.certificate_name("zeros")
        files = (_checked_text(name, certificate_text(result.statement, result.columns)),)
        command += f" --certificate {name}"
    text = f"{result}\nThe range holds the ball of β."
    return ReportPart(
        title, Outcome.PROVED, text, (command, *_checks(files)), certificates=files, data=result.to_json()
    )


def _range(beta: Exact) -> str:
    return "..".join(map(str, beta_ends(beta)))


def _checked_text(name: str, text: str) -> CheckedCertificate:
    """What the independent checker says of it."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / name
        path.write_text(text, encoding="utf-8", newline="\n")
        return checked(path)


def _checks(files: tuple[CheckedCertificate, ...]) -> tuple[str, ...]:
    return tuple(f"gspot-verified check {file.name}" for file in files)
