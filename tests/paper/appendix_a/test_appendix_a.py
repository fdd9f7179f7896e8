"""Appendix A of the ledger: changed values are not proved, and the steps of proofs/connection.md."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any

import pytest
from flint import acb, arb, fmpq, fmpq_poly

from gspot_verified import Outcome
from gspot_verified.paper.appendix_a import appendix_a, asymptotic_errors, hypergeometric
from gspot_verified.paper.appendix_a import appendix_a_asymptotics as asymptotics
from gspot_verified.paper.checks.entry import Rung
from gspot_verified.theta_function.gamma.initial_values import initial_values, paper_initial_values
from gspot_verified.theta_function.value.asymptotic_coefficients import coefficient
from gspot_verified.theta_function.value.routes import theta_by

BETA = fmpq_poly([0, 1])


def outcome(identifier: str) -> Outcome:
    return appendix_a.ENTRIES[identifier]().verdict.outcome


def times(factor: Callable[[int], Any], honest: Callable[..., list[Any]]) -> Callable[..., list[Any]]:
    return lambda *arguments: [term * factor(k) for k, term in enumerate(honest(*arguments))]


@pytest.mark.parametrize(
    ("name", "factor", "entry"),
    [
        ("h_terms", lambda _: -1, "A-leading"),
        ("h_terms", lambda k: (-1) ** k, "A-leading"),
        ("h_terms", lambda k: (-1) ** k, "A-bsmall1"),
        ("e_terms", lambda _: -1, "A-bsmall1"),
        ("e_terms", lambda _: acb(0, 1), "A-bsmall2"),
        ("e_terms", lambda k: (-1) ** k, "A-bsmall3"),
        ("e_terms", lambda k: 2**k, "A-bsmall2"),
        ("e_1_terms", lambda _: -1, "A-tlarge"),
        ("e_1_terms", lambda k: (-1) ** k, "A-blarge1"),
        ("e_1_terms", lambda _: arb(3).sqrt(), "A-blarge3"),
    ],
)
def test_a_changed_series_is_noticed_at_points(
    monkeypatch: pytest.MonkeyPatch, name: str, factor: Callable[[int], Any], entry: str
) -> None:
    monkeypatch.setattr(hypergeometric, name, times(factor, getattr(hypergeometric, name)))
    monkeypatch.setattr(appendix_a, "BETAS", appendix_a.BETAS[-3:])
    assert outcome(entry) is not Outcome.PROVED


@pytest.mark.parametrize("j", range(3))
def test_a_changed_initial_value_is_noticed_at_points(monkeypatch: pytest.MonkeyPatch, j: int) -> None:
    honest = hypergeometric.printed_initial_values

    def changed(beta: fmpq, bits: int) -> tuple[arb, ...]:
        values = list(honest(beta, bits))
        values[j] = -values[j]
        return tuple(values)

    monkeypatch.setattr(hypergeometric, "printed_initial_values", changed)
    monkeypatch.setattr(appendix_a, "BETAS", appendix_a.BETAS[-3:])
    assert outcome(f"A-t0{j + 1}") is not Outcome.PROVED
    assert outcome("A-cancellation") is not Outcome.PROVED


def test_nan_proves_and_refutes_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(hypergeometric, "fundamental_solution", lambda *_: arb.nan())
    for identifier in ("A-th3", "A-bsmall1", "A-blarge2", "A-th5-condition"):
        assert outcome(identifier) is Outcome.UNDECIDED


def test_a_ball_that_cannot_tell_refutes_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(hypergeometric, "fundamental_solution", lambda *_: arb(1, 0.5))
    assert outcome("A-th5-condition") is Outcome.UNDECIDED


def test_checks_on_nothing_prove_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(appendix_a, "BETAS", ())
    proved = {identifier for identifier in appendix_a.ENTRIES if outcome(identifier) is Outcome.PROVED}
    assert proved == {"A-coefficients"}


def test_a_ball_is_zero_only_when_it_is_small_and_holds_zero() -> None:
    assert appendix_a._is_zero(arb(0, "9e-61")) is True
    assert appendix_a._is_zero(arb(0, "2e-60")) is None
    assert appendix_a._is_zero(arb(0)) is True
    assert appendix_a._is_zero(arb("1e-70")) is appendix_a._is_zero(arb("-1e-70")) is False
    assert appendix_a._is_zero(arb.nan()) is None


def test_the_first_coefficient_must_be_one(monkeypatch: pytest.MonkeyPatch) -> None:
    honest = appendix_a.coefficient
    dlmf = hypergeometric.dlmf_coefficients
    monkeypatch.setattr(appendix_a, "coefficient", lambda k: 2 * honest(k))
    monkeypatch.setattr(appendix_a, "coefficient_by_inversion", lambda k: 2 * honest(k))
    monkeypatch.setattr(hypergeometric, "dlmf_coefficients", lambda *a: [2 * c for c in dlmf(*a)])
    assert [check.agrees for check in appendix_a.ENTRIES["A-coefficients"]().checks] == [False, True]


def test_asymptotic_errors_answer_false_when_certain(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(asymptotic_errors, "theta_by", lambda *a, **k: 2 * theta_by(*a, **k))
    assert asymptotic_errors.theta_error_within(fmpq(40), fmpq(1, 2)) is False


def test_only_what_covers_the_whole_claim_is_called_exact() -> None:
    exact = {name for name, build in appendix_a.ENTRIES.items() if any(c.rung is Rung.EXACT for c in build().checks)}
    assert exact == {"A-th3", "A-coefficients", "A-cancellation", "A-th5-condition"}


def test_the_texts_of_the_initial_values_are_those_of_the_library() -> None:
    for beta in (fmpq(-7, 3), fmpq(1, 2), fmpq(22, 5)):
        texts = hypergeometric.printed_initial_values(beta, 128)
        entire = [hypergeometric.value_of(text, beta, 128) for text in hypergeometric.ENTIRE_INITIAL_VALUES.values()]
        library = zip(paper_initial_values(beta, 128), initial_values(beta, 128), strict=True)
        for first, second, (third, fourth) in zip(texts, entire, library, strict=True):
            assert all(value.is_finite() for value in (first, second))
            assert first.overlaps(third)
            assert second.overlaps(fourth)


def series(j: int, beta: fmpq_poly, count: int) -> list[fmpq_poly]:
    """The Taylor coefficients of y_j, as polynomials in β."""
    found = [fmpq_poly([0])] * count
    found[j] = fmpq_poly([fmpq(1, 2) if j == 2 else 1])
    for k in range(count - 3):
        if not found[k].degree() < 0:
            found[k + 3] = (k - beta) * found[k] / ((k + 1) * (k + 2) * (k + 3))
    return found


@pytest.mark.parametrize("j", range(3))
def test_step_1_of_the_induction_in_beta(j: int) -> None:
    slope = [(k + 1) * value for k, value in enumerate(series(j, BETA, 31)[1:])]
    factor = fmpq_poly([1]) if j else -BETA
    assert slope == [factor * value for value in series((j - 1) % 3, BETA - 1, 30)]


def test_step_3_of_the_induction_in_beta() -> None:
    scaled = [coefficient(k) * fmpq(3, 2) ** k for k in range(20)]
    a = -BETA / 3 - fmpq(1, 2)
    for k in range(1, 20):
        assert scaled[k](BETA - 1) == scaled[k] + fmpq(3, 2) * (a - k + 1) * scaled[k - 1]


@pytest.mark.parametrize("j", range(3))
def test_the_exceptions_are_the_integers_at_which_the_formula_fails(j: int) -> None:
    allowed = asymptotics._allowed_integers(j)
    assert allowed == [fmpq(n) for n in range(9) if n % 3 != j]
    for n in range(9):
        holds = asymptotic_errors.large_error_within(j, fmpq(60), fmpq(n))
        assert holds is (n % 3 != j)


def test_a_factor_with_zeros_of_its_own_says_nothing_on_the_exceptions(monkeypatch: pytest.MonkeyPatch) -> None:
    assert all(asymptotics._vanishes(j) for j in range(3))
    monkeypatch.setitem(hypergeometric.LARGE, "factor 1", "3^(2/3)*(beta-5)/Gamma((1-beta)/3)")
    monkeypatch.setitem(hypergeometric.LARGE, "factor 2", "0/Gamma((2-beta)/3)")
    assert [asymptotics._vanishes(j) for j in range(3)] == [True, False, False]
    monkeypatch.setitem(asymptotics.EXCEPTIONS, "0", "3+3*m")
    assert not asymptotics._vanishes(0)


@pytest.mark.parametrize(
    ("left", "right", "answer"),
    [("1", "0", False), ("-1", "0", False), ("0 +/- 1", "0", None), ("0", "0", None), ("1", "1e-30", None)],
)
def test_a_formula_fails_where_its_sides_differ_for_certain(
    monkeypatch: pytest.MonkeyPatch, left: str, right: str, answer: bool | None
) -> None:
    monkeypatch.setattr(hypergeometric, "fundamental_solution", lambda *_: arb(left))
    monkeypatch.setattr(hypergeometric, "value_of", lambda *_, **__: arb(right))
    monkeypatch.setattr(asymptotics, "_allowed_integers", lambda _: [])
    assert asymptotics._at_exceptions()[0] is answer


def test_one_exception_that_is_open_leaves_all_open(monkeypatch: pytest.MonkeyPatch) -> None:
    honest = hypergeometric.fundamental_solution
    monkeypatch.setattr(hypergeometric, "fundamental_solution", lambda j, *a: honest(j, *a) if a[1] != 3 else arb(0, 1))
    assert asymptotics._at_exceptions()[0] is None


def test_the_condition_of_th5_is_said_formula_by_formula() -> None:
    """That they hold with it is what A-blarge1 to A-blarge3 say, under a condition of their own."""
    corrected = appendix_a.ENTRIES["A-th5-condition"]().corrected
    for number, exception in (("A.11", "3m"), ("A.12", "1+3m"), ("A.13", "2+3m")):
        assert re.search(rf"eq\. \({number}\) needs β other than {re.escape(exception)}(, |$)", corrected)
    assert corrected.startswith("With m = 0, 1, 2, ...: ")


@pytest.mark.parametrize("j", range(3))
def test_each_integer_that_a_formula_of_th4_names_is_tried(monkeypatch: pytest.MonkeyPatch, j: int) -> None:
    tried: list[fmpq] = []
    monkeypatch.setattr(asymptotic_errors, "small_error_within", lambda *a: tried.append(a[-1]) or True)
    entry = asymptotics.small(j, appendix_a.BETAS)
    named = re.search(r"at β = ([\d, ]+)\.", entry.note)
    assert named is not None
    assert [fmpq(int(n)) for n in named[1].split(", ")] == [beta for beta in tried[: len(tried) // 2] if beta.q == 1]
    assert f"{len(tried)} points, integers β among them" in entry.checks[-1].what


@pytest.mark.parametrize("n", [-4, -1, 0, 3, 8])
def test_each_integer_that_is_named_is_tried(monkeypatch: pytest.MonkeyPatch, n: int) -> None:
    honest = appendix_a.initial_values

    def changed(beta: fmpq, bits: int) -> tuple[arb, ...]:
        values = honest(beta, bits)
        return tuple(value + 1 for value in values) if beta == n else values

    monkeypatch.setattr(appendix_a, "BETAS", appendix_a.BETAS[-3:])
    assert "integers from -4 to 8" in appendix_a.ENTRIES["A-t01"]().checks[-1].what
    monkeypatch.setattr(appendix_a, "initial_values", changed)
    assert appendix_a.ENTRIES["A-t01"]().checks[-1].agrees is not True
