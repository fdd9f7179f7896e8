"""The fold's four hypotheses, each of which alone must stop it, and signs of models against point values.

Page: proofs/fold.md.
"""

from __future__ import annotations

from itertools import pairwise
from types import SimpleNamespace

import pytest
from flint import arb, fmpq

from gspot_verified.signs.cover.column_models import ColumnModels
from gspot_verified.theta_function.value.evaluate import evaluate

LOWER, UPPER = fmpq(-1, 4), fmpq(1, 4)


def answering(monkeypatch: pytest.MonkeyPatch, changed: str | None, answer: int | None) -> ColumnModels:
    """Models whose four answers at the fold are all 1, but for one."""
    models = ColumnModels(fmpq(2), fmpq(33, 16), fmpq(9))
    answers = {"lower end": 1, "upper end": 1, "second derivative": 1, "in b": 1} | (
        {changed: answer} if changed else {}
    )
    places = {(LOWER, LOWER, 0): "lower end", (UPPER, UPPER, 0): "upper end", (LOWER, UPPER, 2): "second derivative"}

    def sign(lower: fmpq, upper: fmpq, derivative: int = 0) -> int | None:
        return answers[places[lower, upper, derivative]]

    def doubled(lower: fmpq, upper: fmpq) -> SimpleNamespace:
        assert (lower, upper) == (LOWER, UPPER)
        ball = {1: arb(2, 1), -1: arb(-2, 1), 0: arb(0), None: arb(0, 1)}[answers["in b"]]
        return SimpleNamespace(beta_derivative=lambda: SimpleNamespace(enclosure=lambda: ball))

    monkeypatch.setattr(models, "sign", sign)
    monkeypatch.setattr(models, "_doubled", doubled)
    return models


@pytest.mark.parametrize("changed", ["lower end", "upper end", "second derivative", "in b"])
@pytest.mark.parametrize("answer", [-1, 0, None])
def test_each_hypothesis_of_the_fold_is_needed(
    changed: str, answer: int | None, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert answering(monkeypatch, None, None).fold(LOWER, UPPER)
    assert not answering(monkeypatch, changed, answer).fold(LOWER, UPPER)


def test_a_real_fold_and_boxes_that_are_none() -> None:
    models = ColumnModels(fmpq(2), fmpq(33, 16), fmpq(9))
    assert models.fold(LOWER, UPPER)
    # F > 0 and F'' > 0, but dF/db has both signs on a box that reaches far to the right.
    assert not models.fold(LOWER, fmpq(7, 2))
    # Next to b = 1 F is decreasing and changes its sign.
    assert not ColumnModels(fmpq(1), fmpq(17, 16), fmpq(4)).fold(LOWER, UPPER)
    # Without width in b nothing is known of dF/db.
    assert not ColumnModels(fmpq(2), fmpq(2), fmpq(4)).fold(LOWER, UPPER)


@pytest.mark.parametrize("derivative", [0, 1, 2])
def test_signs_are_those_of_points(derivative: int) -> None:
    models = ColumnModels(fmpq(9, 4), fmpq(37, 16), fmpq(6))
    found = 0
    for k in range(-16, 24):
        lower, upper = fmpq(k, 4), fmpq(k + 1, 4)
        sign = models.sign(lower, upper, derivative)
        if sign is None:
            continue
        found += 1
        for tau in (lower, upper):
            for b in (fmpq(9, 4), fmpq(37, 16)):
                value = evaluate(tau, b, derivative=derivative, digits=5).value
                assert value > 0 if sign > 0 else value < 0
    assert found > 25


@pytest.mark.parametrize("n", range(6))
def test_changes_are_those_of_the_derivatives(n: int) -> None:
    """F, F', ..., F^(n) by evaluation, then (-1)^(n+1)."""
    b = n + fmpq(1, 4)
    models = ColumnModels(b - fmpq(1, 64), b + fmpq(1, 64), fmpq(8))
    known = 0
    for tau in range(9):
        values = [evaluate(tau, b, derivative=k, digits=5).value for k in range(n + 1)]
        signs = [*(1 if value > 0 else -1 for value in values), (-1) ** (n + 1)]
        found = models.changes(fmpq(tau), n)
        known += found is not None
        assert found in (None, sum(one != other for one, other in pairwise(signs)))
    assert known > 3


def test_the_sign_at_the_centre() -> None:
    models = ColumnModels(fmpq(9, 4), fmpq(37, 16), fmpq(6))
    for k in range(-12, 13):
        value = evaluate(fmpq(k, 2), fmpq(73, 32), digits=5).value
        assert models.sign_at_centre(fmpq(k, 2)) == (1 if value > 0 else -1)
