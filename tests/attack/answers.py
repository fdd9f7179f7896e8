"""What one attack is, and what can come of it."""

from __future__ import annotations

import enum
from collections.abc import Callable
from dataclasses import dataclass


class Tally(enum.Enum):
    """``UNDECIDED``: the package (or the reference) gave no answer; never counted as agreed."""

    AGREED = "agreed"
    UNDECIDED = "undecided"
    WRONG = "WRONG"


@dataclass(frozen=True)
class Answer:
    """``detail``: of a wrong one, what the package says and what the reference says."""

    tally: Tally
    detail: str = ""


@dataclass(frozen=True)
class Attack:
    """``question``: the exact question, to be asked again by hand. ``ask``: put it to the package, judge the answer."""

    question: str
    ask: Callable[[], Answer]


AGREED = Answer(Tally.AGREED)


def undecided(why: str) -> Answer:
    """The package said that it does not know, or the reference is not sure."""
    return Answer(Tally.UNDECIDED, why)


def wrong(detail: str) -> Answer:
    """The package says what the reference contradicts."""
    return Answer(Tally.WRONG, detail)


def worst(answers: list[Answer]) -> Answer:
    """One answer for all: wrong before undecided before agreed."""
    order = [Tally.WRONG, Tally.UNDECIDED, Tally.AGREED]
    return min(answers, key=lambda answer: order.index(answer.tally), default=undecided("nothing was compared"))
