"""Asks questions for some time, each within its own limit, and counts what came of them.

Question number n of a kind is drawn from Random("seed/kind/n"), so that each can be asked again alone.
"""

from __future__ import annotations

import importlib
import json
import os
import select
import signal
import time
import traceback
from collections import Counter
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from random import Random
from types import FrameType
from typing import NoReturn

from attack.answers import Answer, Attack, Tally, undecided, wrong

KINDS = (
    "theta",
    "floats",
    "signs",
    "motion",
    "starts",
    "scenes",
    "turning",
    "crossings",
    "mechanisms",
    "sweeps",
    "maps",
    "approaches",
    "fates",
    "canards",
    "friction",
    "side",
    "zero_maps",
    "iwc",
    "expansions",
    "mechanism_expansions",
    "uniform",
    "certificates",
    "sealed",
    "journals",
    "merged",
    "reports",
    "costs",
    "kept",
)  # fmt: skip
"""Modules of this folder, each with ``attack(random)``; cheap before dear."""

_LESS = {"expansions": 4, "mechanism_expansions": 2, "kept": 8}
"""Kinds whose questions differ little from each other, and how much less time they get."""

LIMIT = 60
"""Seconds of one question; after as many again without an answer its process is ended."""
_SHARE = 4.0
_SHOWN = 4_000
_END = "end"

Draw = Callable[[Random], Attack]


class TooLong(BaseException):
    """The question's own time is over. No Exception: nothing below may take it for one of its own."""


@dataclass
class Record:
    """What came of the questions of one kind."""

    counts: Counter[Tally] = field(default_factory=Counter)
    why: Counter[str] = field(default_factory=Counter)
    found: list[str] = field(default_factory=list)
    number: int = 0
    seconds: float = 0.0

    def add(self, kind: str, seed: str, question: str, answer: Answer) -> str | None:
        """Count it; the text of a wrong one."""
        self.counts[answer.tally] += 1
        if answer.tally is Tally.UNDECIDED:
            self.why[answer.detail.splitlines()[0][:90] if answer.detail else ""] += 1
        text = None
        if answer.tally is Tally.WRONG:
            repeat = f"--kind {kind} --seed {seed} --number {self.number}"
            text = f"WRONG {kind} ({repeat})\n  {question}\n  {answer.detail}"
            self.found.append(text)
        self.number += 1
        return text


def draw_of(kind: str) -> Draw:
    """The kind's ``attack``."""
    found: Draw = importlib.import_module(f"attack.{kind}").attack
    return found


def drawn(draw: Draw, kind: str, seed: str, number: int) -> Attack:
    """Question ``number`` of a kind."""
    return draw(Random(f"{seed}/{kind}/{number}"))


def answered(draw: Draw, kind: str, seed: str, number: int, limit: float = LIMIT) -> tuple[str, Answer]:
    """The question and its answer. An error that no attack expects is a wrong answer; so is one that never comes."""
    question = "(while the question was drawn)"
    before = signal.signal(signal.SIGALRM, _too_long)
    signal.setitimer(signal.ITIMER_REAL, limit)
    try:
        posed = drawn(draw, kind, seed, number)
        question = posed.question
        return question, posed.ask()
    except TooLong:
        return question, undecided(f"no answer within {limit:g} s")
    except Exception:
        return question, wrong(f"raised\n{traceback.format_exc()[-_SHOWN:]}")
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)


def _too_long(signum: int, frame: FrameType | None) -> NoReturn:  # noqa: ARG001
    raise TooLong


def attacked(
    kinds: Mapping[str, Draw],
    seed: str,
    seconds: float,
    records: dict[str, Record],
    limit: float = LIMIT,
    tell: Callable[[str], None] = print,
    most: int | None = None,
) -> None:
    """Ask until the time is over, the kind that has used the least time next. Whatever ends it, ``records`` are full.

    A batch runs in a forked process, so that a crash or a hang inside a library costs one question. ``most``: so many
    questions of each kind, and no more.
    """
    until = time.monotonic() + seconds
    while (left := until - time.monotonic()) > 0:
        open_ones = [name for name in kinds if most is None or records[name].number < most]
        if not open_ones:
            return
        kind = min(open_ones, key=lambda name: records[name].seconds * _LESS.get(name, 1))
        record, begun = records[kind], time.monotonic()
        share = 0.0 if most is not None else min(_SHARE, left)
        for question, answer in _batch(kinds[kind], kind, seed, record.number, share, limit, until):
            text = record.add(kind, seed, question, answer)
            if text is not None:
                tell(text)
        record.seconds += time.monotonic() - begun


def _batch(
    draw: Draw, kind: str, seed: str, number: int, seconds: float, limit: float, until: float
) -> Iterator[tuple[str, Answer]]:
    reading, writing = os.pipe()
    child = os.fork()
    if child == 0:
        _asks(draw, kind, seed, number, seconds, limit, writing)
    os.close(writing)
    try:
        yield from _heard(reading, limit, until)
    finally:
        os.close(reading)
        os.kill(child, signal.SIGKILL)  # not reaped yet, so the number is still the child's
        os.waitpid(child, 0)


def _heard(reading: int, limit: float, until: float) -> Iterator[tuple[str, Answer]]:
    data, question = b"", "(while the question was drawn)"
    while True:
        left = until - time.monotonic()
        ready, _, _ = select.select([reading], [], [], max(0.0, min(2 * limit, left)))
        if not ready and left < 2 * limit:
            return  # the whole time is over: the question that is open counts as not asked
        if not ready:
            yield question, wrong(f"hangs: no answer within {2 * limit:g} s, and it cannot be interrupted")
            return
        part = os.read(reading, 1 << 16)
        if not part:
            yield question, wrong("the process ended in the midst of the question")
            return
        *lines, data = (data + part).split(b"\n")
        for line in lines:
            question, tally, detail = json.loads(line)
            if tally == _END:
                return
            if tally is not None:
                yield question, Answer(Tally(tally), detail)


def _asks(draw: Draw, kind: str, seed: str, number: int, seconds: float, limit: float, writing: int) -> NoReturn:
    """In the child: questions from ``number`` on, at least one; each is told before it is asked, its answer after."""

    def telling(random: Random) -> Attack:
        posed = draw(random)
        _tell(writing, posed.question, None, "")
        return posed

    try:
        signal.signal(signal.SIGINT, signal.SIG_IGN)
        signal.signal(signal.SIGTERM, signal.SIG_DFL)
        begun = time.monotonic()
        while True:
            question, answer = answered(telling, kind, seed, number, limit)
            _tell(writing, question, answer.tally.value, answer.detail)
            number += 1
            if time.monotonic() - begun > seconds:
                _tell(writing, "", _END, "")
                break
    finally:
        os._exit(0)


def _tell(writing: int, question: str, tally: str | None, detail: str) -> None:
    line = json.dumps([question, tally, detail]).encode() + b"\n"
    while line:
        line = line[os.write(writing, line) :]


def table(records: Mapping[str, Record]) -> str:
    """The three tallies of each kind, and why questions stayed undecided."""
    lines = [f"{'kind':<14}{'agreed':>9}{'undecided':>11}{'WRONG':>7}{'seconds':>9}"]
    for kind, record in records.items():
        counts = [record.counts[tally] for tally in Tally]
        lines.append(f"{kind:<14}{counts[0]:>9}{counts[1]:>11}{counts[2]:>7}{record.seconds:>9.0f}")
    for kind, record in records.items():
        lines += [f"undecided, {kind}: {count} x {why}" for why, count in record.why.most_common(5)]
    return "\n".join(lines)
