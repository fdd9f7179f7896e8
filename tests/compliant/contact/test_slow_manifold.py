"""The force on the slow manifold at one epsilon on both sides of the exact epsilon_0, next to it; what is taken over
from the leading order; what must stay open.

Page: proofs/monotone.md.
"""

from __future__ import annotations

from dataclasses import replace

import pytest
from flint import fmpq

from gspot_verified.compliant.contact import slow_manifold
from gspot_verified.compliant.contact.slow_manifold import CELL_DIGITS, THRESHOLD_DIGITS, exact_epsilon_0, impact
from gspot_verified.compliant.contact.threshold import Threshold
from gspot_verified.leading_order.iwc import leading_order_iwc
from gspot_verified.numbers.verdict import Outcome, Reason


@pytest.mark.parametrize(
    ("beta", "options", "digits", "whole"),
    [
        ("9/2", {}, 3, True),
        ("5/2", {"alpha_1": -3, "alpha_2": "-1/5", "c1": -2}, 3, True),
        ("7/2", {"alpha_1": -3, "alpha_2": "-1/5", "c1": 2}, 5, False),  # least at the start
        ("1/2", {}, 5, False),
    ],
)
def test_next_to_the_exact_threshold(beta: str, options: dict[str, object], digits: int, whole: bool) -> None:
    """Two routes: the threshold by iteration and, at one epsilon, the least value; their answers change together."""
    exact, _ = exact_epsilon_0(leading_order_iwc(beta, digits=6, **options), digits)  # type: ignore[arg-type]
    assert exact is not None
    assert exact.lower is not None
    assert exact.upper is not None
    assert exact.upper - exact.lower < exact.upper * fmpq(1, 50)
    for epsilon, outcome in ((exact.lower, Outcome.PROVED), (exact.upper, Outcome.REFUTED)):
        leading = leading_order_iwc(beta, epsilon=epsilon, digits=6, **options)  # type: ignore[arg-type]
        assert leading.verdict.outcome is Outcome.REFUTED  # so that nothing is taken over from there
        found = impact(leading, epsilon, 6)
        assert found is not None
        assert found.verdict.outcome is outcome
        assert found.whole_line is (whole and outcome is Outcome.PROVED)
        assert found.start == -10


def test_what_the_leading_order_shows_is_taken_over_below_5_only() -> None:
    """Theorem C: the force is above the one at leading order. For every epsilon, on the whole line, at one epsilon."""
    for beta, options, end in (
        ("1/2", {"alpha_2": 1}, "for every real τ and every ε > 0"),
        ("1/2", {"alpha_2": 1, "epsilon": 7}, "for every real τ at ε = 7"),
        ("7/2", {"tau_start": 5}, "for every τ in [5, inf) and every ε > 0"),
        ("7/2", {"tau_start": 5, "epsilon": 10**7}, "for every τ in [5, inf) at ε = 10000000"),
    ):
        leading = leading_order_iwc(beta, **options)  # type: ignore[arg-type]
        assert leading.every_epsilon
        found = impact(leading, None if "epsilon" not in options else fmpq(options["epsilon"]), 6)  # type: ignore[call-overload]
        assert found is not None
        assert found.verdict.outcome is Outcome.PROVED
        assert found.verdict.statement.endswith(end)
        assert str(leading.verdict.evidence) in str(found.verdict.evidence)
        assert found.start == (5 if "tau_start" in options else None)
        assert found.whole_line is leading.whole_line
    above = leading_order_iwc("21/4", epsilon="1/100")
    assert above.verdict.outcome is Outcome.PROVED
    found = impact(above, fmpq(1, 100), 6)
    assert found is not None
    assert str(above.verdict.evidence) not in str(found.verdict.evidence)


def test_without_a_threshold_at_leading_order_there_is_none() -> None:
    for options in ({"alpha_2": 1}, {}):
        leading = replace(leading_order_iwc("1/2", digits=6, **options), epsilon_0=None)  # type: ignore[arg-type]
        assert exact_epsilon_0(leading, 6) == (None, False)
    found = impact(leading, None, 6)
    assert found is not None
    assert (found.verdict.outcome, found.verdict.reason, found.threshold) == (Outcome.UNDECIDED, Reason.BUDGET, None)
    assert impact(replace(leading_order_iwc("13/2", digits=6), epsilon_0=None), None, 6) is None
    assert impact(leading_order_iwc("27/2", digits=6), None, 6) is None


@pytest.mark.parametrize("epsilon", [fmpq(10) ** 7, fmpq(10) ** -301])
def test_outside_the_range_of_the_slow_solution_it_is_undecided(epsilon: fmpq) -> None:
    leading = leading_order_iwc("21/4", epsilon=epsilon, digits=6)
    found = impact(leading, epsilon, 6)
    assert found is not None
    assert found.verdict.outcome is Outcome.UNDECIDED
    assert not found.whole_line


def test_no_more_digits_than_asked_for_nor_than_the_most(monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[int] = []

    def remembered(*given: object) -> Threshold:
        asked.append(given[3])  # type: ignore[arg-type]
        return Threshold(fmpq(1), None, None, False, 1, None)

    monkeypatch.setattr(slow_manifold, "exact_threshold", remembered)
    monkeypatch.setattr(slow_manifold, "threshold_by_cells", lambda *given: (remembered(*given), False))
    for beta, most in (("3/2", THRESHOLD_DIGITS), ("13/2", CELL_DIGITS)):
        leading = leading_order_iwc(beta, digits=6)
        for digits in (2, most, most + 1, 15):
            found = impact(leading, None, digits)
            assert asked.pop() == min(digits, most)
            assert found is not None
            # The numbers alone prove nothing.
            assert (found.verdict.outcome, found.verdict.reason) == (Outcome.UNDECIDED, Reason.HYPOTHESIS)
    assert (THRESHOLD_DIGITS, CELL_DIGITS) == (8, 6)


def test_a_least_value_next_to_0_or_none_is_undecided(monkeypatch: pytest.MonkeyPatch) -> None:
    epsilon = fmpq(1, 100)
    leading = leading_order_iwc("21/4", epsilon=epsilon)
    monkeypatch.setattr(slow_manifold, "less", lambda *_: None)
    monkeypatch.setattr(slow_manifold, "fails_at", lambda *_: None)
    for _ in range(2):
        found = impact(leading, epsilon, 6)
        assert found is not None
        assert (found.verdict.outcome, found.verdict.reason) == (Outcome.UNDECIDED, Reason.BUDGET)
        assert not found.whole_line
        monkeypatch.setattr(slow_manifold, "least_value", lambda *_: None)


def test_to_the_left_only_where_the_function_at_the_start_adds_to_a_mean_force_that_is_not_negative() -> None:
    """5/2: it falls to a value > 0 at -10, and to one < 0 at 1/2. 7/2: it is negative far to the left."""
    for beta, start, whole in (("5/2", "-10", True), ("5/2", "1/2", False), ("7/2", "-10", False)):
        found = impact(leading_order_iwc(beta, tau_start=start, digits=6), None, 2)
        assert found is not None
        assert found.verdict.outcome is Outcome.PROVED
        assert found.whole_line is whole


def test_the_text_says_where_it_holds_and_the_bracket_of_the_threshold() -> None:
    found = impact(leading_order_iwc("5/2", digits=6), None, 4)
    assert found is not None
    lines = found.lines()
    assert lines[1].startswith("  the largest ε0 possible lies in [0.89")
    assert lines[2] == "  it holds for every τ < -10 as well"
    assert len(replace(found, threshold=None).lines()) == 2
    assert len(replace(found, whole_line=False).lines()) == 2
    assert len(replace(found, start=None).lines()) == 2
