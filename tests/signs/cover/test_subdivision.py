from __future__ import annotations

import itertools
import random
from collections.abc import Callable
from concurrent.futures import Executor, Future
from itertools import pairwise
from pathlib import Path
from typing import Any

import pytest
from flint import fmpq
from hypothesis import given
from hypothesis import strategies as st

from gspot_verified.signs.cover.journal import Journal
from gspot_verified.signs.cover.pieces import Column, ColumnPiece, Kind
from gspot_verified.signs.cover.subdivision import Examine, State, Subdivision
from gspot_verified.work.executors import InProcessExecutor

CELLS = [(fmpq(0), fmpq(1)), (fmpq(1), fmpq(2)), (fmpq(2), fmpq(5, 2))]
LAPLACE = (ColumnPiece(Kind.LAPLACE, None, None),)


def narrower_than(width: fmpq) -> Examine:
    """Settles the ranges that are at most so wide, and the first cell's left half."""

    def examine(lower: fmpq | None, upper: fmpq) -> Column | None:
        assert lower is not None
        settled = upper - lower <= width or (lower == 0 and upper == fmpq(1, 2))
        return Column(lower, upper, LAPLACE) if settled else None

    return examine


class Late(Executor):
    """Runs the calls of a batch in a random order, when the first result is asked for."""

    def __init__(self) -> None:
        self.waiting: list[Callable[[], None]] = []

    def submit(self, function: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Future[Any]:
        executor = self

        class Asked(Future[Any]):
            def result(self, timeout: float | None = None) -> Any:
                random.Random(7).shuffle(executor.waiting)
                for run in executor.waiting:
                    run()
                executor.waiting.clear()
                return super().result(timeout)

        future = Asked()
        self.waiting.append(lambda: future.set_result(function(*args, **kwargs)))
        return future


def assert_tiles(tree: Subdivision) -> None:
    """Children cover their parent, and finished and unfinished ranges together cover the cells, once."""
    for index, node in enumerate(tree.nodes):
        children = [child for child in tree.nodes if child.parent == index]
        assert bool(children) == (node.state is State.SPLIT)
        if children:
            first, second = children
            assert (first.lower, first.upper) == (node.lower, second.lower)
            assert second.upper == node.upper
            assert first.depth == second.depth == node.depth + 1
    parts = sorted([*((c.lower, c.upper) for c in tree.finished), *tree.unfinished])
    assert parts[0][0] == tree.cells[0][0]
    assert parts[-1][1] == tree.cells[-1][1]
    for (_, upper), (lower, _) in pairwise(parts):
        assert upper == lower


@given(st.integers(0, 60), st.integers(1, 40))
def test_tree_and_budget(budget: int, width: int) -> None:
    tree = Subdivision(list(CELLS), budget)
    seen = [step.examined for step in tree.steps(narrower_than(fmpq(1, width)), InProcessExecutor())]
    assert seen == list(range(1, len(seen) + 1))
    assert len(seen) == tree.examined <= budget
    assert_tiles(tree)
    if tree.unfinished:
        assert tree.examined == budget
    other = Subdivision(list(CELLS), budget)
    for _ in other.steps(narrower_than(fmpq(1, width)), Late()):
        pass
    assert other.nodes == tree.nodes


def test_progress_adds_up() -> None:
    tree = Subdivision(list(CELLS), 1000)
    for step in tree.steps(narrower_than(fmpq(1, 8)), InProcessExecutor()):
        assert_tiles(tree)
        assert step.finished == len(tree.finished)
        assert step.waiting == len(tree.unfinished)
    assert step.waiting == 0
    assert tree.unfinished == []


def test_a_stopped_iterator_goes_on() -> None:
    tree, whole = Subdivision(list(CELLS), 1000), Subdivision(list(CELLS), 1000)
    for _ in whole.steps(narrower_than(fmpq(1, 8)), InProcessExecutor()):
        pass
    while tree.unfinished:
        next(tree.steps(narrower_than(fmpq(1, 8)), InProcessExecutor()))
    assert tree.finished == whole.finished
    assert tree.examined == whole.examined


def test_in_this_process_nothing_is_examined_before_its_turn() -> None:
    calls = []

    def examine(lower: fmpq | None, upper: fmpq) -> None:
        calls.append((lower, upper))

    steps = Subdivision(list(CELLS), 100).steps(examine, InProcessExecutor())
    for k in range(1, 6):
        next(steps)
        assert len(calls) == k


def test_a_witness_ends_the_search() -> None:
    def examine(lower: fmpq | None, upper: fmpq) -> tuple[fmpq, fmpq] | None:
        return (fmpq(0), upper) if upper - fmpq(lower or 0) <= fmpq(1, 4) else None

    trees = [Subdivision(list(CELLS), 1000) for _ in range(2)]
    for tree, pool in zip(trees, (InProcessExecutor(), Late()), strict=True):
        for _ in tree.steps(examine, pool):
            pass
        assert tree.witness is not None
    assert trees[0].nodes == trees[1].nodes


def test_depth_points_and_infinity_get_stuck() -> None:
    tree = Subdivision([(None, fmpq(0)), (fmpq(1), fmpq(1)), (fmpq(1), fmpq(2))], 1000, max_depth=3)
    for _ in tree.steps(lambda *_: None, InProcessExecutor()):
        pass
    assert tree.examined == 1 + 1 + 15
    assert len(tree.unfinished) == 1 + 1 + 8
    assert tree.unfinished[0][0] is None


@pytest.mark.parametrize("budget", [-1, 1.0, True, None])
def test_bad_budget(budget: Any) -> None:
    with pytest.raises(ValueError, match="budget"):
        Subdivision(list(CELLS), budget)


def test_an_error_of_the_work_comes_out() -> None:
    def examine(lower: fmpq | None, upper: fmpq) -> None:
        raise ArithmeticError(f"{lower} {upper}")

    tree = Subdivision(list(CELLS), 10)
    with pytest.raises(ArithmeticError, match="0 1"):
        next(tree.steps(examine, InProcessExecutor()))
    assert tree.examined == 0


def test_what_is_finished_and_what_is_left_stand_in_the_order_of_beta() -> None:
    """The halves of the first range come after the others in the tree; 0 and a missing end are ends like others."""
    cells = [(fmpq(-3, 2), fmpq(-1)), (fmpq(-1), fmpq(0)), (fmpq(0), fmpq(1, 4)), (fmpq(1, 4), fmpq(1, 2)),
             (None, fmpq(-3, 2)), (fmpq(1, 2), fmpq(3, 4))]  # fmt: skip
    ordered = [cells[4], *cells[:4], cells[5]]
    for order in (cells, cells[::-1], [cells[k] for k in (2, 5, 0, 3, 1, 4)]):
        left = Subdivision(list(order), 0)
        assert left.unfinished == ordered
        settled = Subdivision(list(order), 100)
        for _ in settled.steps(lambda lower, upper: Column(lower, upper, LAPLACE), InProcessExecutor()):
            pass
        assert [(column.lower, column.upper) for column in settled.finished] == ordered
        assert settled.unfinished == []
    halves = Subdivision([cells[1], cells[2]], 4)
    for _ in halves.steps(lambda *_: None, InProcessExecutor()):
        pass
    assert [ends[0] for ends in halves.unfinished] == [fmpq(k, 16) for k in (-16, -12, -8, -4, 0, 2)]


def test_nothing_is_examined_after_the_budget_or_the_witness() -> None:
    calls: list[fmpq] = []

    def fails_at_once(_: fmpq | None, upper: fmpq) -> tuple[fmpq, fmpq]:
        calls.append(upper)
        return fmpq(0), upper

    tree = Subdivision(list(CELLS), 100)
    assert len(list(tree.steps(fails_at_once, Late()))) == tree.examined
    examined = tree.examined
    assert list(tree.steps(fails_at_once, Late())) == []
    assert (tree.examined, tree.witness) == (examined, (fmpq(0), fmpq(1)))

    one_fails = Subdivision(list(CELLS), 100)
    assert len(list(one_fails.steps(lambda _, upper: (fmpq(0), upper) if upper == 1 else None, Late()))) == len(CELLS)
    assert len(one_fails.unfinished) == 4  # the halves of the others

    def settles_nothing(*_: Any) -> None:
        calls.append(fmpq(0))

    for budget in (0, 1, 5):
        calls.clear()
        tree = Subdivision(list(CELLS), budget)
        for _ in itertools.islice(tree.steps(settles_nothing, Late()), 50):
            pass
        assert len(calls) == tree.examined == budget


def test_an_executor_of_its_own_gets_a_whole_batch_before_the_first_result() -> None:
    pool = Late()
    steps = Subdivision(list(CELLS), 100).steps(narrower_than(fmpq(1)), pool)
    submitted: list[int] = []
    real = pool.submit

    def submit(function: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Future[Any]:
        submitted.append(1)
        return real(function, *args, **kwargs)

    pool.submit = submit  # type: ignore[method-assign]
    next(steps)
    assert len(submitted) == len(CELLS)


def test_a_journal_answers_for_what_is_known_and_keeps_the_rest(tmp_path: Path) -> None:
    calls: list[fmpq] = []

    again: list[fmpq] = []

    def examine(lower: fmpq | None, upper: fmpq, along: Column | None = None) -> Column | None:
        (calls if along is None else again).append(upper)
        return narrower_than(fmpq(1, 4))(lower, upper)

    def run(budget: int) -> Subdivision:
        with Journal(tmp_path / "j", {"question": 1}) as journal:
            tree = Subdivision(list(CELLS), budget, journal=journal)
            for _ in tree.steps(examine, InProcessExecutor()):
                pass
        return tree

    assert run(4).examined == len(calls) == 4
    whole = run(1000)
    assert len(calls) == whole.examined > 4
    assert whole.unfinished == []
    again.clear()
    second = run(1000)
    assert (second.nodes, len(calls)) == (whole.nodes, whole.examined)
    assert len(again) == len(whole.finished)


def test_a_column_that_does_not_come_out_again_is_sought_anew(tmp_path: Path) -> None:
    with Journal(tmp_path / "j", {"question": 1}) as journal:
        journal.add(fmpq(1), fmpq(2), Column(fmpq(1), fmpq(2), (ColumnPiece(Kind.SIGN, fmpq(0), fmpq(1), 1),)))
        journal.add(fmpq(2), fmpq(5, 2), (fmpq(0), fmpq(2)))
        tree = Subdivision([(fmpq(1), fmpq(2)), (fmpq(2), fmpq(5, 2))], 10, journal=journal)
        for _ in tree.steps(lambda lower, upper, *_: Column(lower, upper, LAPLACE), InProcessExecutor()):
            pass
    assert [column.pieces for column in tree.finished] == [LAPLACE, LAPLACE]
