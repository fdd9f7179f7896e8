from __future__ import annotations

from functools import partial

import pytest
from flint import fmpq

from gspot_verified.cost.benchmarks import theta
from gspot_verified.cost.times import cases
from gspot_verified.cost.times.measure import ChildRun


@pytest.mark.parametrize(
    ("tau", "text"), [(fmpq(-7, 3), "τ=-7/3"), (fmpq(10), "τ=10 "), (fmpq(-(10**6)), "τ=-10^6"), (fmpq(1234), "τ=1234")]
)
def test_questions_in_words(tau: fmpq, text: str) -> None:
    words = cases.asked(tau, fmpq(1, 2), 15) + " "
    assert text in words
    assert "β=1/2 15 digits" in words


def test_derivatives_in_words() -> None:
    assert cases.asked(fmpq(1), fmpq(1), 15, 1).startswith("Θ' ")
    assert cases.asked(fmpq(1), fmpq(1), 15, 3).startswith("Θ^(3) ")


def test_a_baseline_that_gives_up_is_a_note() -> None:
    times, note = cases._times(fmpq(10**6), fmpq(1, 2), 50, repeats=1, bits=1_000)
    assert "baseline" not in times
    assert {"cold", "warm", "mpmath"} <= set(times)
    assert note.startswith("baseline: no answer within 1000 bits")


def test_the_first_attempt_of_the_baseline_is_kept() -> None:
    assert "first attempt" in cases._times(fmpq(-50), fmpq(1, 2), 20, repeats=1)[0]
    assert "first attempt" not in cases._times(fmpq(1), fmpq(1, 2), 20, repeats=1)[0]


@pytest.mark.slow
def test_far_rows_have_figures_and_targets(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(cases, "FAR_BITS", 1_000)
    monkeypatch.setattr(cases, "BETAS", cases.BETAS[:1])
    monkeypatch.setattr(cases, "_times", partial(cases._times, repeats=1))
    rows = list(cases.far_tau())
    assert [row.case for row in rows] == ["τ = -50"] * 2 + ["huge τ"] * 4
    assert all(row.figure is not None and row.target.unit == "s" for row in rows)
    assert all((row.baseline is None) == (row.case == "huge τ") for row in rows)


def test_the_same_beta_again_compares_two_calls() -> None:
    row = cases._repeated_beta(15, 1)
    assert row.cold is not None
    assert row.warm is not None
    assert row.figure == row.warm / row.cold


def _children(monkeypatch: pytest.MonkeyPatch, **runs: ChildRun) -> None:
    def run(request: dict[str, object], _: float) -> ChildRun:
        return runs.get(f"{request['who']}_{request['digits']}", runs.get(str(request["who"]), ChildRun(None, None)))

    monkeypatch.setattr(theta, "run_child", run)
    monkeypatch.setattr(cases, "run_child", run)


def test_heavy_rows_come_from_children(monkeypatch: pytest.MonkeyPatch) -> None:
    ours = ChildRun(2.0, 10**7, processor=1.5)
    _children(monkeypatch, ours=ours, baseline=ChildRun(400.0, 10**8, "", 100.0, 390.0))
    rows = list(theta.against_baseline(lambda _: None))
    assert [row.figure for row in rows] == [200.0, 200.0]
    assert all("first attempt alone" in row.note and "50 x" in row.note and "390 s: 260 x" in row.note for row in rows)


def test_a_baseline_without_an_answer_leaves_the_row_open(monkeypatch: pytest.MonkeyPatch) -> None:
    _children(monkeypatch, ours=ChildRun(2.0, 10**7), baseline=ChildRun(None, None, "no answer within 900 s"))
    rows = list(theta.against_baseline(lambda _: None))
    assert all(row.met is None and "no answer within 900 s" in row.note for row in rows)


def test_growth_states_the_peak_memory(monkeypatch: pytest.MonkeyPatch) -> None:
    _children(monkeypatch, ours_100000=ChildRun(0.5, 3 * 10**7), ours_1000000=ChildRun(6.0, 8 * 10**7))
    row = theta.growth(lambda _: None)
    assert row.figure == 12.0
    assert row.note == "peak memory: 30 MB at 10^5, 80 MB at 10^6 digits"


def test_general_beta_in_fresh_processes(monkeypatch: pytest.MonkeyPatch) -> None:
    _children(monkeypatch, ours=ChildRun(3.0, 10**7))
    assert [row.figure for row in theta.general_beta_rows(lambda _: None)] == [1.0, 1.0]
    _children(monkeypatch)
    assert [row.met for row in theta.general_beta_rows(lambda _: None)] == [None, None]


def test_mpmath_in_words(monkeypatch: pytest.MonkeyPatch) -> None:
    _children(monkeypatch, mpmath=ChildRun(None, None, "no answer within 120 s"))
    assert theta.mpmath_at_many_digits(lambda _: None).endswith("no answer within 120 s")
    _children(monkeypatch, mpmath=ChildRun(88.0, 1))
    assert theta.mpmath_at_many_digits(lambda _: None).endswith("88.0 s")
