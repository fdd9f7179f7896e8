"""The checks of Sec. 4.5, second half, at points and on boxes: each looks at what it names."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from types import SimpleNamespace
from typing import Any

import pytest
from flint import arb, fmpq

from gspot_verified.leading_order.iwc import leading_order_iwc
from gspot_verified.paper.section_4_5 import cases
from gspot_verified.signs.gamma.side import gamma_sign


def answers(identifier: str) -> list[bool | None]:
    return [check.agrees for check in cases.ENTRIES[identifier]().checks]


def test_the_words_are_tried_with_the_first_derivative(monkeypatch: pytest.MonkeyPatch) -> None:
    def signs(*by_order: int) -> None:
        monkeypatch.setattr(
            cases, "evaluate", lambda *_, derivative=0, **__: SimpleNamespace(value=arb(by_order[derivative]))
        )

    signs(1, -1, 1)
    assert answers("S-wording")[1] is False
    signs(1, 1, -1)  # the corrected form does not stand
    assert answers("S-wording")[1] is None
    signs(-1, 1, 1)
    assert answers("S-wording")[1] is True


def test_the_words_are_tried_where_the_check_says(monkeypatch: pytest.MonkeyPatch) -> None:
    asked, honest = set(), cases.evaluate

    def evaluate(tau: int, beta: fmpq, derivative: int = 0) -> Any:
        asked.add((tau, beta, derivative))
        return honest(tau, beta, derivative=derivative)

    monkeypatch.setattr(cases, "evaluate", evaluate)
    check = cases.ENTRIES["S-wording"]().checks[1]
    assert check.what == "Θ(-20, 3/10) and Θ(0, 3/10)"
    assert check.finding == "Θ > 0 at τ = -20 and τ = 0, dΘ/dτ < 0 there and at τ = 20"
    places = {(-20, 0), (0, 0), (-20, 1), (0, 1), (20, 1)}
    assert asked == {(tau, fmpq(3, 10), derivative) for tau, derivative in places}


def test_the_pieces_of_the_cover_are_shown() -> None:
    finding = cases.ENTRIES["S-iwc"]().checks[1].finding
    introduction, _, pieces = finding.partition(": ")
    assert introduction == "pieces from τ = −∞ to +∞"
    assert len(pieces.split(", ")) >= 3


def test_the_systems_that_are_tried_are_those_of_case_iii(monkeypatch: pytest.MonkeyPatch) -> None:
    honest, seen = cases.evaluate_text, list[dict[str, Any]]()

    def evaluate_text(text: str, values: dict[str, Any], bits: int) -> Any:
        seen.append(values)
        return honest(text, values, bits)

    monkeypatch.setattr(cases, "evaluate_text", evaluate_text)
    assert answers("S-side") == [True, True]
    for values in seen:
        assert values["alpha1"] < 0
        assert values["alpha2"] < 0
        assert values["alpha3"] == values["beta"] * values["alpha1"]
        assert values["epsilon"] == fmpq(1, 10**6)
    assert {(values["C_1"], values["beta"]) for values in seen} == {(c, b) for c in (-1, 1) for b in cases.SIDE_BETAS}
    assert {cases.sign_of(arb(b).gamma()) for b in [-b for b in cases.SIDE_BETAS]} == {1, -1}


def test_a_small_deviation_leaves_the_mean_force(monkeypatch: pytest.MonkeyPatch) -> None:
    """Also where the deviation by itself has the stated sign."""

    def evaluate(_: int, beta: fmpq, **__: int) -> Any:
        return SimpleNamespace(value=arb("1e-300") * (gamma_sign(beta) or 0))

    monkeypatch.setattr(cases, "evaluate", evaluate)
    assert answers("S-side")[1] is False
    monkeypatch.setitem(cases.CORRECTED_FORCE["S-mean-force"], "force", "0*alpha2")
    assert answers("S-side")[1] is True


def test_one_bound_that_is_not_found_leaves_the_check_open(monkeypatch: pytest.MonkeyPatch) -> None:
    def one_missing(beta: fmpq, **options: Any) -> Any:
        found = leading_order_iwc(beta, **options)
        return replace(found, epsilon_0=None) if beta == cases.IWC_BETAS[0] else found

    monkeypatch.setattr(cases, "leading_order_iwc", one_missing)
    assert answers("S-iwc-case-III") == [True, None]


def switching(signs: list[int], integers: range, places: list[int] | None = None) -> Any:
    """Intervals (n - 1, n) with the stated signs; ``places``: other n."""
    ends = places or list(range(1, len(signs) + 1))
    intervals = [
        SimpleNamespace(lower=Fraction(n - 1), upper=Fraction(n), sign=sign)
        for n, sign in zip(ends, signs, strict=True)
    ]
    return SimpleNamespace(intervals=intervals, integers=tuple(integers))


@pytest.mark.parametrize(
    ("found", "answer"),
    [
        (switching([-1, 1, -1], range(1, 31)), True),
        (switching([-1, 1, -1], range(1, 30)), False),
        (switching([-1, 1, -1], range(2, 31)), False),
        (switching([-1, 1, 1], range(1, 31)), False),
        (switching([1, -1, 1], range(1, 31)), False),  # they alternate, and are not those of Γ
        (switching([-1, -1], range(1, 31), [1, 3]), False),  # those of Γ, and they do not alternate
    ],
)
def test_the_intervals_alternate_and_have_the_sign_of_gamma(
    monkeypatch: pytest.MonkeyPatch, found: Any, answer: bool
) -> None:
    monkeypatch.setattr(cases, "side_switching", lambda *_: found)
    assert answers("S-switching") == [True, answer]
