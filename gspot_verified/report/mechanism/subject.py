"""What the page on a mechanism is about, and its parts.

The subject: a mechanism with the place of one G-spot in a file of its own, as commands name it. A part: a result with
its verdict, or the reason why nothing is stated.
"""

from __future__ import annotations

import json
import re
import shlex
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any, ClassVar

from flint import arb, fmpq

from gspot_verified.mechanisms.input.file import parse_mechanism
from gspot_verified.mechanisms.input.mechanism import Mechanism
from gspot_verified.mechanisms.spots.classify import Classification
from gspot_verified.mechanisms.spots.g_spot import GSpot
from gspot_verified.numbers.balls import Exact, working_bits
from gspot_verified.numbers.verdict import NoTruthValue, Outcome, Verdict
from gspot_verified.numbers.written import Written
from gspot_verified.report.certificates import CheckedCertificate
from gspot_verified.report.pictures.canvas import Picture
from gspot_verified.signs.zeros.slope_at import UndecidedError
from gspot_verified.theta_function.value.routes import BudgetError

_HEADER = re.compile(r"\s*\[+\s*[\"']?([A-Za-z0-9_]+)")
_END_PLACES = (4, 8, 14)  # decimals of the ends of a range around a ball, tried in turn
_BITS = 128  # of those ends: of a double's beta times 10^14 no digit is lost
_LARGEST_DENOMINATOR = 10**12  # of a rational that is taken for the exact value: any number is correct
_PLACES = 30  # decimals of a place from which a search starts: any number is correct


@dataclass(frozen=True)
class Source:
    """A mechanism's file in the report's folder, and the parameters that are set beside it."""

    file: str
    text: str
    settings: Mapping[str, str]

    @property
    def mechanism(self) -> Mechanism:
        """What the file describes, with these parameters.

        :raises MechanismError: a part of it is wrong.
        """
        return parse_mechanism(self.text).changed(**self.settings)

    def command(self, name: str, *words: str, option: str | None = None) -> str:
        """A command of gspot-verified about this mechanism."""
        subject = [self.file] if option is None else [option, self.file]
        settings = [word for key, value in self.settings.items() for word in ("--set", f"{key}={value}")]
        return shlex.join(["gspot-verified", name, *subject, *settings, *words])

    def python(self, imports: str, expression: str) -> str:
        """A line of Python about it; ``{mechanism}`` in the expression stands for the mechanism."""
        settings = "".join(f', {key}="{value}"' for key, value in self.settings.items())
        mechanism = f'load("{self.file}"{settings})'
        code = f"from gspot_verified import {imports}; {expression.format(mechanism=mechanism)}"
        return shlex.join(["python", "-c", code])


@dataclass(frozen=True)
class Subject:
    """One G-spot of a mechanism: ``source`` names its place."""

    number: int
    source: Source
    mechanism: Mechanism
    spot: GSpot
    classified: Classification

    def certificate_name(self, kind: str) -> str:
        """The name of a file beside the page."""
        return f"g-spot-{self.number}-{kind}.cert"


def beta_ends(beta: Exact) -> tuple[fmpq, ...]:
    """The rational itself, or two short rationals with the ball between them, and no integer.

    :raises ValueError: there are none.

    >>> beta_ends(fmpq(7, 3)), beta_ends(arb("2.25", "1e-9"))
    ((7/3,), (11249/5000, 11251/5000))
    """
    if isinstance(beta, fmpq):
        return (beta,)
    for places in _END_PLACES:
        unit = fmpq(10) ** places
        with working_bits(_BITS):
            lower, upper = (beta.lower() * arb(unit)).floor(), (beta.upper() * arb(unit)).ceil()
            first, last = (lower - 1).unique_fmpz(), (upper + 1).unique_fmpz()
        if first is not None and last is not None and fmpq(first, unit.p).ceil() == fmpq(last, unit.p).floor() + 1:
            return fmpq(first, unit.p), fmpq(last, unit.p)
    raise ValueError("β is, or may be, an integer")


def placed_at(source: Source, spot: GSpot, file: str) -> Source:
    """The same mechanism in a file that names the place of this G-spot.

    :raises ValueError: the G-spot's conditions are formulas, or its table in the file cannot be told from the rest.
    """
    if spot.mechanism.place.conditions is not None:
        raise ValueError("its conditions J are formulas; name its place in a mechanism file of its own")
    kept, inside = [], False
    for line in source.text.splitlines():
        header = _HEADER.match(line)
        if header is not None:
            inside = header[1] == "g_spot"
        if not inside:
            kept.append(line)
    made = replace(source, file=file, text="\n".join([*kept, "", *_place(spot), ""]))
    try:
        same = replace(made.mechanism, place=spot.mechanism.place) == spot.mechanism
    except ValueError:
        same = False
    if not same:
        raise ValueError("its place could not be put into the file: write [g_spot] as a table of its own, at the end")
    return made


def _place(spot: GSpot) -> list[str]:
    """The table g_spot of a file."""
    references = {angle.coordinate: angle.name for angle in spot.mechanism.angles}
    lines = ["[g_spot]"]
    if not spot.exact:
        lines.append("search = true")
    if spot.fixed:
        lines.append(f"fixed = {json.dumps(list(spot.fixed))}")
    lines += ["", "[g_spot.point]"]
    for word, value in zip(spot.mechanism.state, spot.system.point, strict=True):
        number = _near(value)
        reference = f"{references[word]} + " if word in references else ""
        lines.append(f'{word} = "{reference}({number})"')
    return lines


def _near(value: Exact) -> fmpq:
    """The value itself where it is rational; else a short rational in the ball, such as that of a fixed component."""
    if isinstance(value, fmpq):
        return value
    mantissa, exponent = value.mid().man_exp()
    middle = Fraction(int(mantissa)) * Fraction(2) ** int(exponent)
    short = middle.limit_denominator(_LARGEST_DENOMINATOR)
    number = fmpq(short.numerator, short.denominator)
    return number if value.contains(number) else fmpq(round(middle * 10**_PLACES), 10**_PLACES)


@dataclass(frozen=True, slots=True)
class ReportPart(NoTruthValue, Written):
    """``text`` is what the result prints, ``data`` its JSON; ``commands`` give the same again, in the report's folder.

    ``outcome`` is None where nothing is stated: ``text`` then says why, or it is a picture or a table of numbers.
    """

    ask: ClassVar[str] = ".outcome is Outcome.PROVED, REFUTED, UNDECIDED, or None: nothing is stated"
    written: ClassVar[str] = "title outcome text commands picture certificates data"

    title: str
    outcome: Outcome | None
    text: str
    commands: tuple[str, ...] = ()
    picture: Picture | None = None
    certificates: tuple[CheckedCertificate, ...] = ()
    data: Any = None


def attempted(title: str, make: Callable[[], ReportPart]) -> ReportPart:
    """What ``make`` gives; where a hypothesis fails or a budget ends, a part that says so."""
    try:
        return make()
    except (UndecidedError, BudgetError) as error:
        return ReportPart(title, Outcome.UNDECIDED, f"undecided: {error}")
    except ValueError as error:
        return ReportPart(title, None, f"nothing is stated: {error}")


def outcome_of(verdicts: Iterable[Verdict]) -> Outcome:
    """Proved when all are; refuted when one is; else undecided.

    >>> outcome_of([]).value
    'undecided'
    """
    outcomes = {verdict.outcome for verdict in verdicts}
    if Outcome.REFUTED in outcomes:
        return Outcome.REFUTED
    return Outcome.PROVED if outcomes == {Outcome.PROVED} else Outcome.UNDECIDED
