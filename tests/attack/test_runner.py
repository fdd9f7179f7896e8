"""The runner: seeds, limits, hangs, crashes, tallies, exit codes."""

from __future__ import annotations

import os
import signal
import time
from random import Random

import pytest
from attack import __main__ as program
from attack.answers import AGREED, Answer, Attack, Tally, undecided, wrong
from attack.runner import Record, answered, attacked, drawn, table


def constant(answer: Answer) -> object:
    return lambda random: Attack(f"question {random.random():.6f}", lambda: answer)


def stubborn() -> Answer:
    signal.signal(signal.SIGALRM, signal.SIG_IGN)
    while True:
        time.sleep(1)


def crash() -> Answer:
    os._exit(3)


def ran(most: int, limit: float, **draws: object) -> dict[str, Record]:
    records = {kind: Record() for kind in draws}
    attacked(draws, "seed", 600, records, limit, lambda text: None, most)  # type: ignore[arg-type]  # noqa: ARG005
    return records


def test_a_question_is_drawn_from_seed_kind_and_number_alone() -> None:
    draw = constant(AGREED)
    questions = [drawn(draw, kind, seed, n).question for kind in "ab" for seed in "cd" for n in range(3)]
    assert len(set(questions)) == len(questions)
    assert drawn(draw, "a", "c", 1).question == questions[1]


def test_all_kinds_get_their_turn_and_are_counted() -> None:
    records = ran(2, 60, one=constant(AGREED), two=constant(undecided("why")), three=constant(wrong("so")))
    assert records["one"].counts.keys() == {Tally.AGREED}
    assert records["two"].counts.keys() == {Tally.UNDECIDED}
    assert records["three"].counts.keys() == {Tally.WRONG}
    assert {record.number for record in records.values()} == {2}
    assert "--kind three --seed seed --number 0" in records["three"].found[0]
    shown = table(records)
    assert "undecided, two" in shown
    assert "x why" in shown


def test_a_question_has_its_own_limit() -> None:
    """The question brings its alarm on itself: no clock decides what is reached before it."""

    def late() -> Answer:
        assert 0 < signal.getitimer(signal.ITIMER_REAL)[0] <= 600
        signal.raise_signal(signal.SIGALRM)
        return AGREED

    question, answer = answered(lambda _: Attack("loop", late), "any", "0", 0, limit=600)
    assert (question, answer.tally) == ("loop", Tally.UNDECIDED)
    assert "no answer within" in answer.detail


def test_a_hang_that_cannot_be_interrupted_is_wrong() -> None:
    records = ran(1, 0.1, bad=lambda _: Attack("hang", stubborn))
    assert records["bad"].counts[Tally.WRONG] >= 1
    assert "hangs" in records["bad"].found[0]


def test_a_crash_is_wrong_and_costs_one_question() -> None:
    def sometimes(random: Random) -> Attack:
        return Attack("crash", crash) if random.random() < 0.5 else Attack("fine", lambda: AGREED)

    records = ran(6, 60, any=sometimes)
    assert records["any"].counts[Tally.WRONG] >= 1
    assert records["any"].counts[Tally.AGREED] >= 1
    assert "the process ended" in records["any"].found[0]


@pytest.mark.parametrize(("answer", "code"), [(AGREED, 0), (undecided("why"), 0), (wrong("so"), 1)])
def test_exit_codes(
    answer: Answer, code: int, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(program, "draw_of", lambda kind: constant(answer))  # noqa: ARG005
    before = signal.getsignal(signal.SIGTERM)
    try:
        assert program.main(["--most", "2", "--kind", "theta", "--seed", "7"]) == code
        out = capsys.readouterr().out
        assert out.startswith("seed 7, ")
        assert "WRONG" in out
        assert program.main(["--kind", "theta", "--seed", "7", "--number", "3"]) == code
    finally:
        signal.signal(signal.SIGTERM, before)


def test_interrupted_it_prints_what_was_done(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def interrupted(draws: object, seed: str, seconds: float, records: dict[str, Record], *rest: object) -> None:  # noqa: ARG001
        records["theta"].add("theta", seed, "a question", wrong("so"))
        raise KeyboardInterrupt

    monkeypatch.setattr(program, "attacked", interrupted)
    before = signal.getsignal(signal.SIGTERM)
    try:
        assert program.main(["--kind", "theta", "--seed", "7"]) == 1
    finally:
        signal.signal(signal.SIGTERM, before)
    assert "interrupted; so far:" in capsys.readouterr().out


def test_one_question_needs_its_kind_and_seed() -> None:
    with pytest.raises(SystemExit):
        program.main(["--number", "3"])
