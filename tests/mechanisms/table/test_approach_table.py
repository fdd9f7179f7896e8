"""Each row of a table says what ``approach`` and ``mechanism_side`` say of that state alone; pages: proofs/approach.md,
proofs/papers_rule.md."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from flint import arb, fmpq

from gspot_verified import MechanismError, load, mechanism_side
from gspot_verified.mechanisms.approach import mechanism_side as sides
from gspot_verified.mechanisms.approach.approach import PRECISIONS
from gspot_verified.mechanisms.approach.approach_result import Approach
from gspot_verified.mechanisms.table import approach_table as module
from gspot_verified.mechanisms.table.approach_table import approach_table
from gspot_verified.mechanisms.table.approached_row import ApproachedRow
from gspot_verified.numbers.balls import ball

MODEL = load("model system")
FIXED = {"x": 0, "u": 3}
BALL = re.compile(r"\[\S+ \+/- \S+\]|-?\d+\.\d+")  # its width is that of the bits with which a row was settled
STATES = [{"p": "1/2", "b": "-2"}, {"p": "1/2", "b": "-1/50"}, {"p": "1/4", "b": "-1"}]


def agrees(row: ApproachedRow, name: str, parameters: Mapping[str, str], state: Mapping[str, str | int]) -> None:
    alone = mechanism_side(load(name, **parameters), state)
    slip = alone.approach
    assert (row.end, row.case, row.side, row.small_epsilon_side) == (slip.end, slip.case, slip.side, alone.side)
    assert [BALL.sub("", text) for text in row.warnings] == [BALL.sub("", text) for text in slip.warnings]
    numbers = dict(row.numbers)
    for word, value in (("time", slip.time), ("beta", slip.beta), ("C1", slip.coefficient)):
        own = numbers[word]
        assert (own is None) == (value is None)
        assert own is None or value is None or own.to_ball().overlaps(ball(value))
    assert [own is not None for _, own in row.point] == [bool(slip.spot)] * len(row.point)


def test_a_row_says_what_the_state_alone_says() -> None:
    """Parameters and components as columns; at a G-spot with both sides, and an end before."""
    rows = [{**state, "alpha_3": alpha} for state in STATES for alpha in ("-3/2", "-5/2")]
    found = list(approach_table(MODEL, rows, FIXED))
    assert [row.number for row in found] == [1, 2, 3, 4, 5, 6]
    assert {row.outcome for row in found} == {"settled"}
    assert {row.side for row in found} >= {"lift-off", "impact without collision"}
    for row, values in zip(found, rows, strict=True):
        state: dict[str, str | int] = {**FIXED, "p": values["p"], "b": values["b"]}
        agrees(row, "model system", {"alpha_3": values["alpha_3"]}, state)


def test_formulas_of_reference_angles(tmp_path: Path) -> None:
    """A component may be a formula; at the G-spot an angle stands with its reference."""
    path = tmp_path / "states.csv"
    path.write_text("phi_dot,phi\n-9/10,phi_ref + 1/10\n-1/2,phi_ref + 1/10\n,phi_ref\n", encoding="utf-8")
    oscillator = load("oscillator")
    first, second, third = approach_table(oscillator, path)
    assert [row.small_epsilon_side for row in (first, second, third)] == ["lift-off", "impact", None]
    agrees(first, "oscillator", {}, {"phi": "phi_ref + 1/10", "phi_dot": "-9/10"})
    angle = dict(first.point)["phi"]
    (reference,) = (each for each in oscillator.angles if each.coordinate == "phi")
    assert angle is not None
    assert (angle.to_ball() - arb.atan2(arb(reference.sine), arb(reference.cosine))).overlaps(
        mechanism_side(oscillator, {"phi": "phi_ref + 1/10", "phi_dot": "-9/10"}).approach.spot[
            oscillator.state.index("phi")
        ]
    )
    assert third.outcome == "refused"
    assert third.point == tuple((word, None) for word in oscillator.state)


@pytest.mark.parametrize(
    ("values", "reason"),
    [
        ({"p": "-1", "b": "-1"}, "not certainly positive"),
        ({"p": "1", "b": "1"}, "not certainly negative"),
        ({"p": "nan", "b": "-1"}, "p"),
        ({"p": "1"}, "those of p, b are needed"),
        ({"p": "q + 1", "b": "-1"}, "p"),
    ],
)
def test_a_row_that_is_wrong_is_refused_alone(values: dict[str, str], reason: str) -> None:
    first, second, third = approach_table(MODEL, [STATES[0], values, STATES[0]], FIXED)
    assert second.outcome == "refused"
    assert reason in second.reason
    assert (second.end, second.side, second.small_epsilon_side) == (None, None, None)
    assert (first.side, third.side) == ("lift-off", "lift-off")


def test_what_is_open_is_undecided(monkeypatch: pytest.MonkeyPatch) -> None:
    """A path that is not followed to its end."""
    real = sides.followed
    monkeypatch.setattr(sides, "followed", lambda *a, **k: real(*a, **{**k, "max_steps": 1}))
    (row,) = approach_table(MODEL, STATES[:1], FIXED)
    assert (row.outcome, row.end, row.side, row.small_epsilon_side) == ("undecided", None, None, None)
    assert row.reason
    assert all(number is None for _, number in (*row.numbers, *row.point))
    assert row.summary == "undecided"


def test_the_surface_moves() -> None:
    (row,) = approach_table(MODEL, STATES[:1], FIXED, surface_velocity=4)
    assert row.outcome == "refused"
    assert "no positive slip" in row.reason


def test_the_same_for_every_executor(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "_PORTION", 2)
    expected = list(approach_table(MODEL, STATES, FIXED))
    done: list[int] = []
    with ThreadPoolExecutor(1) as pool:
        assert list(approach_table(MODEL, STATES, FIXED, executor=pool, progress=done.append)) == expected
    assert done == [2, 3]


def test_rows_are_taken_as_they_are_needed(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "_PORTION", 2)
    taken: list[int] = []

    def endless() -> Iterator[dict[str, str]]:
        while True:
            taken.append(1)
            yield {"p": "-1", "b": "-1"}

    found = approach_table(MODEL, endless(), FIXED)
    assert [next(found).number for _ in range(3)] == [1, 2, 3]
    assert len(taken) == 4


def test_a_wrong_table_is_refused_whole(tmp_path: Path) -> None:
    (tmp_path / "table.csv").write_text("p,b\n", encoding="utf-8")
    with pytest.raises(MechanismError, match="no parameter or component 'q'"):
        approach_table(MODEL, [{"q": 1}], FIXED)
    with pytest.raises(MechanismError, match="no row"):
        approach_table(MODEL, tmp_path / "table.csv", FIXED)
    with pytest.raises(ValueError, match="u: the table has a column u, and the state gives it too"):
        approach_table(MODEL, [{"u": 1}], FIXED)


def test_a_line_of_csv() -> None:
    row, other = approach_table(MODEL, [STATES[0], {"p": "-1", "b": "-1"}], FIXED)
    head, line, refused = (text.rstrip("\n").split(",") for text in (row.csv_head(), row.to_csv(), other.to_csv()))
    assert head[:8] == ["p", "b", "outcome", "end", "case", "side", "small_epsilon_side", "reason"]
    assert line[:7] == ["1/2", "-2", "settled", "G-spot", "III", "lift-off", "lift-off"]
    assert refused[:3] == ["-1", "-1", "refused"]
    assert len(head) == len({*head}) == len(line)
    assert head[-12:] == [f"{word}_{end}" for word in MODEL.state for end in ("lower", "upper")]
    where = head.index("C1_lower")
    coefficient = mechanism_side(MODEL, {**FIXED, **STATES[0]}).approach.coefficient
    assert coefficient is not None
    assert arb(float(line[where])) <= coefficient <= arb(float(line[where + 1]))


def test_few_bits_first_and_more_where_a_row_is_open(monkeypatch: pytest.MonkeyPatch) -> None:
    """The first precision settles rows; where it cannot, the answer is that of the state alone."""
    tried: list[tuple[int, ...]] = []
    real = sides.followed

    def noted(*given: Any, **more: Any) -> Approach:
        found = real(*given, **more)
        tried.append((*more["precisions"], found.bits))
        return found

    monkeypatch.setattr(sides, "followed", noted)
    close = {"p": "1/2", "b": "-1000000001/1000000000"}  # to the distinguished trajectory, which has b = -1 there
    row, open_at_first = approach_table(MODEL, [STATES[0], close], FIXED)
    monkeypatch.undo()
    assert [bits for *_, bits in tried] == [46, 160]
    assert tried[0][2:-1] == PRECISIONS
    for each, values in ((row, STATES[0]), (open_at_first, close)):
        agrees(each, "model system", {}, {**FIXED, **values})
        assert each.outcome == "settled"


def test_rows_of_other_parameters_share_nothing_that_depends_on_them(monkeypatch: pytest.MonkeyPatch) -> None:
    """What is compiled for a row is not taken for the next one of other parameters, nor for the first one again."""
    monkeypatch.setattr(module, "_PORTION", 1)  # all begin with the same precision
    values = ["-3/2", "-5/2", "-3/2"]
    found = list(approach_table(MODEL, [{**STATES[0], "alpha_3": value} for value in values], FIXED))
    for row, value in zip(found, values, strict=True):
        beta = dict(row.numbers)["beta"]
        assert beta is not None
        assert beta.to_ball().contains(-fmpq(*map(int, value.split("/"))))
    assert replace(found[2], number=1) == found[0]


def test_rows_of_other_parameters_are_derived_once(monkeypatch: pytest.MonkeyPatch) -> None:
    """Several columns of a rod; each row says what its rod says alone."""

    def derived(_: object) -> None:
        raise AssertionError("a row has a derivation of its own")

    monkeypatch.setattr(module, "_shifted", derived)
    start = {"X": 0, "X_dot": 2, "theta": "theta_ref - 1/20", "theta_dot": "1/2"}
    rows = [{"mu": "2", "l": "1"}, {"mu": "73/36", "l": "11/10"}, {"mu": "-2", "l": "1"}]
    first, second, third = approach_table(load("rod"), rows, start)
    for row, values in ((first, rows[0]), (second, rows[1])):
        assert row.outcome == "settled"
        agrees(row, "rod", values, start)
    assert third.outcome == "refused"


def test_what_the_shared_functions_leave_open_is_asked_of_the_row_alone(monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[bool] = []
    real = module.side_from

    def unsure(shifted: Any, *given: Any, **more: Any) -> Any:
        asked.append(shifted.shared is not None)
        return real(shifted, *given, **{**more, "max_steps": 1} if shifted.shared is not None else more)

    monkeypatch.setattr(module, "side_from", unsure)
    (row,) = approach_table(MODEL, [{**STATES[0], "alpha_3": "-3/2"}], FIXED)
    assert asked == [True, False]
    agrees(row, "model system", {"alpha_3": "-3/2"}, {**FIXED, **STATES[0]})


def test_a_row_after_one_of_more_bits_begins_with_the_second_precision(monkeypatch: pytest.MonkeyPatch) -> None:
    """In its portion, so that the rows are the same for every executor; the next portion begins anew."""
    tried: list[int] = []
    real = module.side_from

    def noted(*given: Any, **more: Any) -> Any:
        tried.append(more["precisions"][0])
        return real(*given, **more)

    monkeypatch.setattr(module, "side_from", noted)
    monkeypatch.setattr(module, "_PORTION", 3)
    close = {"p": "1/2", "b": "-1000000001/1000000000"}
    found = list(approach_table(MODEL, [STATES[0], close, STATES[0], STATES[0]], FIXED))
    assert tried == [46, 46, 64, 46]
    assert {row.outcome for row in found} == {"settled"}


@pytest.mark.parametrize(
    ("name", "state"),
    [
        ("model system", {**FIXED, **STATES[0]}),
        pytest.param("oscillator", {"phi": "phi_ref + 1/10", "phi_dot": "-9/10"}, marks=pytest.mark.slow),
        ("rod", {"X": 0, "X_dot": 2, "theta": "theta_ref - 1/20", "theta_dot": "1/2"}),
    ],
)
def test_digits_that_are_asked_for(name: str, state: Mapping[str, str | int]) -> None:
    """Few bits find the sign; more digits are in the first answer's bounds, and in those of the state alone."""
    numbers = []
    for digits in (None, 4, 15):
        (row,) = approach_table(load(name), [state], digits=digits)
        agrees(row, name, {}, state)
        assert row.outcome == "settled"
        value = dict(row.numbers)["C1"]
        assert value is not None
        numbers.append(value.to_ball())
        if digits is not None:
            assert row.digits is not None
            assert row.digits >= digits
            assert numbers[-1].rad() <= abs(numbers[-1]).upper() / 10**digits
        assert str(row.digits) == row.to_csv().rstrip("\n").split(",")[row.csv_head().split(",").index("C1_digits")]
    assert all(one.overlaps(other) for one in numbers for other in numbers)


def test_a_row_with_fewer_digits_says_how_many(monkeypatch: pytest.MonkeyPatch) -> None:
    """What is known stands there; it is not settled."""
    monkeypatch.setattr(module, "_PRECISIONS", (40,))
    monkeypatch.setattr(module, "_BITS_FOR_DIGITS", 64)
    row, early = approach_table(MODEL, [STATES[0], {"p": "1/2", "b": "-1/50"}], FIXED, digits=15)
    assert (row.outcome, row.end, row.side) == ("undecided", "G-spot", "lift-off")
    assert row.reason == f"C1 has {row.digits} digits, 15 were asked for"
    assert row.digits is not None
    assert 1 <= row.digits < 15
    assert early.outcome in ("settled", "undecided")


@pytest.mark.parametrize("digits", [0, 16, -1])
def test_digits_out_of_range(digits: int) -> None:
    with pytest.raises(ValueError, match="digits must lie in 1"):
        approach_table(MODEL, STATES, FIXED, digits=digits)


def test_a_part_of_the_table() -> None:
    """The same answers by the same numbers; what is no part is refused."""
    whole = list(approach_table(MODEL, STATES, FIXED))
    assert list(approach_table(MODEL, STATES, FIXED, only=(2, 3))) == whole[1:]
    assert list(approach_table(MODEL, STATES, FIXED, only=(2, None))) == whole[1:]
    assert list(approach_table(MODEL, STATES, FIXED, only=(1, 1))) == whole[:1]
    for part in ((0, 1), (3, 2), (1.0, 2), (1, "2")):
        with pytest.raises(ValueError, match="expected two numbers"):
            approach_table(MODEL, STATES, FIXED, only=part)  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="the table has no row 4"):
        approach_table(MODEL, STATES, FIXED, only=(4, None))
