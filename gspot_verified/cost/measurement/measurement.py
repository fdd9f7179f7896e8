"""What one run over all parts measured: plain values that a file can hold. No measuring here, no drawing."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

from gspot_verified.numbers.written import PAIRS, Written
from gspot_verified.work.journal_file import source_key

CERTIFIED, NO_BOUND = "certified", "no bound"
KINDS = (CERTIFIED, NO_BOUND)
FILES = "files of gspot-verified"
"""Among the versions: by this hash the files that were measured are known."""


@dataclass(frozen=True, slots=True)
class Point:
    """One question to one route. ``place``: where the point lies, the accuracy (or size) that was reached.

    ``asked``: the question in words. ``median`` and ``best``: seconds of processor time of ``repeats`` calls.
    ``memory``: bytes by which a fresh process grew during the call, None where that was not measured.
    """

    place: float
    asked: str
    median: float
    best: float
    repeats: int
    memory: int | None = None


@dataclass(frozen=True, slots=True)
class Route:
    """One way to the answer: its points, whether it bounds its error, and the growth that theory expects.

    ``exponent``: expected power of ``place`` in the long run, None where none is named; ``theory``: why. ``note``: why
    there are few points or none. ``panel``: the part of the figure where it is drawn.
    """

    name: str
    kind: Annotated[str, KINDS]
    points: tuple[Point, ...]
    exponent: float | None = None
    theory: str = ""
    note: str = ""
    panel: str = ""


@dataclass(frozen=True, slots=True)
class Share:
    """A part of the time: the module in which it was spent, what it calls in FLINT included; ``part`` is in 0..1."""

    words: str
    part: float


@dataclass(frozen=True, slots=True)
class Limit:
    """The nearest limit of arithmetic or of the machine for one question: its seconds beside those that it took."""

    asked: str
    words: str
    seconds: float
    took: float

    @property
    def factor(self) -> float:
        """How many times the limit."""
        return self.took / self.seconds


@dataclass(frozen=True, slots=True)
class Part:
    """One computation: the question, its routes, where the time of ``shares_of`` goes, and the limit.

    ``axis``: what a place means; ``symbol``: its letter. ``targets``: seconds that are aimed at, by panel.
    """

    key: str
    title: str
    question: str
    axis: str
    symbol: str
    routes: tuple[Route, ...]
    shares_of: str = ""
    shares: tuple[Share, ...] = ()
    limit: Limit | None = None
    remarks: tuple[str, ...] = ()
    targets: Annotated[tuple[tuple[str, float], ...], PAIRS] = ()


@dataclass(frozen=True, slots=True)
class CheapAnswer:
    """One question about a sign, asked three times: at 53 bits, of mpmath as it comes, and certified by two routes."""

    question: str
    why: str
    certified: str
    routes: tuple[str, str]
    doubles: str
    doubles_how: str
    mpmath: str

    def wrong(self, answer: str) -> bool:
        """Whether an answer is given and is not the certified one."""
        return answer not in (self.certified, NO_ANSWER, NOT_ASKED)


NO_ANSWER, NOT_ASKED = "no answer", "not asked"


@dataclass(frozen=True, slots=True)
class Measurement(Written):
    """All parts, from one run. ``date`` is the day on which it ended; ``load``: the other work on the machine."""

    parts: tuple[Part, ...]
    answers: tuple[CheapAnswer, ...]
    date: str
    machine: str
    versions: tuple[tuple[str, str], ...]
    load: str
    full: bool
    seconds: float

    @property
    def of_other_files(self) -> bool:
        """Whether other files of the package were measured than those that are there now, or it is not known which."""
        return dict(self.versions).get(FILES) != files_key()


def files_key() -> str:
    """The hash of the package's files, and of FLINT's version, in short.

    >>> len(files_key())
    16
    """
    return source_key()[:16]
