"""Table 1: rounding, series of epsilon, and what each check must refuse or leave open."""

from __future__ import annotations

import re
from itertools import pairwise
from types import SimpleNamespace
from typing import Any

import pytest
from flint import arb, fmpq

from gspot_verified.compliant.motion.compliant_force import contact_motion
from gspot_verified.numbers.balls import working_bits
from gspot_verified.numbers.verdict import Outcome
from gspot_verified.paper.claims import paper_claims
from gspot_verified.paper.numerics import at_the_g_spot
from gspot_verified.paper.section_3 import table_1 as ledger

HALF = fmpq(1, 2 * 10**4)
BETAS = (fmpq(1, 2), fmpq(3, 2), fmpq(5, 2))


def test_a_printed_number_is_known_to_half_a_unit_of_the_fourth_decimal() -> None:
    assert ledger.rounding("0.3326") == (fmpq(3326, 10**4), HALF)
    assert ledger.rounding("3.000") == (fmpq(3), HALF)
    assert ledger.rounding("1.0") == (fmpq(1), HALF)


def test_the_decades_are_those_of_the_statement() -> None:
    assert ledger.epsilons(ledger.DECADES) == [fmpq(1, 10**k) for k in (3, 4, 5, 6)]
    assert ledger.epsilons((2000, 5, 3)) == [fmpq(1, 2000), fmpq(1, 10000), fmpq(1, 50000)]
    assert ledger.epsilons((1000, fmpq(3, 2), 3)) == [fmpq(1, 1000), fmpq(1, 1500), fmpq(1, 2250)]
    assert ledger.text_of((1000, fmpq(3, 2), 3)) == "ε = 1/1000 and on, each 2/3 of the one before, 3 in all"
    assert ledger.text_of((2000, 5, 3)) == "ε = 1/2000 and on, each 1/5 of the one before, 3 in all"


def test_the_rows_on_the_agreement_state_the_differences_of_the_table() -> None:
    found = {
        abs(ledger.rounding(text)[0] - ledger.rounding(ledger.THEORETICAL[name][beta])[0]): (name, beta)
        for name, row in ledger.MEASURED.items()
        for beta, text in row.items()
    }
    largest = max(found)
    assert (largest, found[largest]) == (fmpq(192, 10**4), ("y", fmpq(5, 2)))
    said = {claim.first: claim.why for claim in paper_claims()}
    assert said[878].endswith("the largest difference is 0.0192, for y-hat at β = 5/2")
    assert said[898].endswith("differs from it by up to 0.02")
    assert largest < fmpq(2, 100)
    assert "the measured ones are 0.6650 to 0.6659" in said[1147]
    assert sorted(ledger.MEASURED["t"].values()) == ["0.6650", "0.6656", "0.6659"]


@pytest.mark.parametrize(
    ("text", "found", "answer"),
    [
        ("0.3333", arb("0.33334"), True),
        ("0.3333", arb("0.33326"), True),
        ("0.3333", arb("0.33336"), False),
        ("0.3333", arb("0.33324"), False),
        ("0.3333", arb("0.33335", "0.00001"), None),
        ("0.3333", arb("nan"), None),
        ("0.3333", arb("inf"), None),
        ("0.3333", None, None),
    ],
)
def test_a_ball_rounds_to_a_number(text: str, found: arb | None, answer: bool | None) -> None:
    assert ledger.is_the_number(text, found) is answer


def test_a_number_is_shown_with_its_certain_decimals() -> None:
    assert ledger.decimals(arb("1.66527", "0.0000008")) == "1.6653"
    assert ledger.decimals(arb("0.03334")) == "0.0333"
    assert ledger.decimals(arb("2.33835", "0.00001")).startswith("[2.338"), "the fourth decimal is not certain"
    assert ledger.rounded_up(arb("0.009819", "0.00000006")) == "0.0099"
    assert ledger.rounded_up(arb("0.0099", "0.00000006")).startswith("[0.00990"), "it may be a little more"
    assert ledger.decimals(arb(0)) == "0.0000"
    assert ledger.decimals(arb("nan")) == ledger.rounded_up(arb("nan")) == "[no information]"


def test_a_power_law_has_its_exponent_as_slope(monkeypatch: pytest.MonkeyPatch) -> None:
    def power(name: str, beta: fmpq, epsilon: fmpq) -> arb:
        assert (name, beta) == ("b", BETAS[0])
        return 3 * arb(epsilon) ** arb(fmpq(1, 3))

    monkeypatch.setattr(ledger, "value", power)
    found = ledger.slope("b", BETAS[0], (1000, 7, 4))
    assert found is not None
    assert abs(found - fmpq(1, 3)) < arb("1e-12")
    monkeypatch.setattr(ledger, "value", lambda name, beta, e: None if e == fmpq(1, 7000) else power(name, beta, e))
    assert ledger.slope("b", BETAS[0], (1000, 7, 4)) is None


def test_what_is_measured(monkeypatch: pytest.MonkeyPatch) -> None:
    def deviations(beta: fmpq, nu: fmpq, epsilon: fmpq) -> dict[str, arb]:
        assert (beta, nu, epsilon) == (BETAS[1], 2, fmpq(1, 1000))
        return {"b": arb(-2), "v": arb(3), "y": arb(-4)}

    def crossing(beta: fmpq, nu: fmpq, epsilon: fmpq, near: fmpq) -> arb | None:
        assert (nu, epsilon) == (2, fmpq(1, 1000))
        return arb(near) if beta > 1 else None

    monkeypatch.setattr(ledger, "deviations", deviations)
    monkeypatch.setattr(ledger, "crossing", crossing)
    assert [ledger.value(name, BETAS[1], fmpq(1, 1000)) for name in "bvy"] == [2, 3, 4]
    near = ledger.value("t", BETAS[1], fmpq(1, 1000))
    assert near is not None
    assert near.contains(fmpq(31, 100))
    assert ledger.value("t", BETAS[0], fmpq(1, 1000)) is None


@pytest.mark.parametrize(
    ("error", "answer"), [("0.1", False), ("0.1999", False), ("0.19996", None), ("0.2", None), ("1", None)]
)
def test_a_number_that_no_series_gives(monkeypatch: pytest.MonkeyPatch, error: str, answer: bool | None) -> None:
    monkeypatch.setattr(ledger, "regression_error", lambda *_: arb(error))
    monkeypatch.setattr(ledger, "limit_exponent", lambda *_: fmpq(1, 2))
    for text, expected in (("0.7", answer), ("0.3", answer), ("0.5", None)):
        assert ledger.can_be_the_number(text, "b", BETAS[0], fmpq(1, 2000)) is expected


@pytest.mark.parametrize(("error", "answer"), [("0.1999", False), ("0.2", None), ("nan", None)])
def test_a_number_that_one_series_does_not_give(
    monkeypatch: pytest.MonkeyPatch, error: str, answer: bool | None
) -> None:
    asked = []
    monkeypatch.setattr(ledger, "series_error", lambda *arguments: asked.append(arguments) or arb(error))
    monkeypatch.setattr(ledger, "limit_exponent", lambda *_: fmpq(1, 2))
    for text, expected in (("0.7", answer), ("0.3", answer), ("0.5", None)):
        assert ledger.can_be_of_the_series(text, "b", BETAS[0], (10, 2, 2)) is expected
    assert asked == [(BETAS[0], "b", [fmpq(1, 10), fmpq(1, 20)])] * 3


@pytest.mark.parametrize(
    ("first", "second", "answer"),
    [(False, False, False), (False, None, None), (None, False, None), (None, None, None)]
    + [(True, other, True) for other in (True, False, None)]
    + [(other, True, True) for other in (False, None)],
)
def test_an_or_fails_only_where_both_fail(first: bool | None, second: bool | None, answer: bool | None) -> None:
    assert ledger.either(first, second) is answer


@pytest.mark.parametrize("half", ["can_be_the_number", "can_be_of_the_series", "slope"])
def test_half_an_or_refutes_no_number(monkeypatch: pytest.MonkeyPatch, half: str) -> None:
    """Each check speaks of both kinds of series."""
    monkeypatch.setattr(ledger, half, lambda *_: None)
    entry = ledger.ENTRIES["3-table-1-y-1_2"]()
    assert entry.verdict.outcome is Outcome.UNDECIDED


@pytest.mark.parametrize(
    ("error", "answer"), [("0.001", False), ("0.00109", False), ("0.0011", None), ("0.002", None), ("nan", None)]
)
def test_two_numbers_that_no_one_series_gives(monkeypatch: pytest.MonkeyPatch, error: str, answer: bool | None) -> None:
    monkeypatch.setattr(ledger, "pair_error", lambda beta, _: arb(error if beta == BETAS[1] else 0))
    assert ledger.can_be_of_one_series(fmpq(1, 2000)) is answer


def test_a_number_is_an_erratum_only_if_no_series_of_its_own_gives_it() -> None:
    assert ledger.is_the_number("1.6635", ledger.slope("b", BETAS[2], (1000, fmpq(3, 2), 3))) is True
    assert ledger.can_be_the_number("1.6635", "b", BETAS[2], fmpq(1, 2500)) is False
    assert ledger.can_be_the_number("1.6635", "b", BETAS[2], fmpq(1, 2000)) is None
    assert ledger.can_be_the_number("1.6538", "y", BETAS[0], ledger.LARGEST) is False
    assert max(max(ledger.epsilons(series)) for every in ledger.SERIES.values() for series in every) == fmpq(1, 1000)


@pytest.mark.parametrize(("first", "answer"), [(999, None), (1000, True), (1001, True)])
def test_a_series_that_begins_above_the_stated_epsilon_shows_nothing(
    monkeypatch: pytest.MonkeyPatch, first: int, answer: bool | None
) -> None:
    monkeypatch.setattr(ledger, "slope", lambda name, beta, _: arb(ledger.MEASURED[name][beta]))
    check = ledger.by_series("b", BETAS[0], (first, 10, 4))
    assert check.agrees is answer
    assert bool(check.finding) is (answer is True)
    for name, beta in ledger.SERIES:
        assert [c.agrees for c in ledger.ENTRIES[ledger.identifier(name, beta)]().checks] == [True, True]


def test_a_series_that_gives_another_number_refutes_no_number(monkeypatch: pytest.MonkeyPatch) -> None:
    """There may be another series that gives it."""
    monkeypatch.setattr(ledger, "slope", lambda name, beta, _: arb(ledger.MEASURED[name][beta]) + 1)
    for name, beta in ledger.SERIES:
        entry = ledger.ENTRIES[ledger.identifier(name, beta)]()
        assert [check.agrees for check in entry.checks] == [None, None]
        assert entry.verdict.outcome is Outcome.UNDECIDED
        assert "the slope is" in entry.checks[0].finding


@pytest.mark.parametrize("identifier", ["3-table-1-y-1_2", "3-table-1-one-series"])
def test_without_a_slope_no_other_number_is_named(monkeypatch: pytest.MonkeyPatch, identifier: str) -> None:
    monkeypatch.setattr(ledger, "slope", lambda *_: None)
    for bound in ("regression_error", "pair_error", "series_error"):
        monkeypatch.setattr(ledger, bound, lambda *_: arb(1))
    entry = ledger.ENTRIES[identifier]()
    assert entry.corrected == ""
    assert entry.verdict.outcome is Outcome.UNDECIDED


def test_one_exponent_of_y_is_by_the_printed_sign_of_the_trivial_solution(monkeypatch: pytest.MonkeyPatch) -> None:
    """y less eq. (29) as printed has the slope 1.6538 at β = 1/2; at the other β it has not the printed one."""
    printed = [ledger.slope_with_the_printed_y(beta, ledger.DECADES) for beta in BETAS]
    agrees = [
        ledger.is_the_number(ledger.MEASURED["y"][beta], slope) for beta, slope in zip(BETAS, printed, strict=True)
    ]
    assert agrees == [True, False, False]
    assert [ledger.decimals(slope) for slope in printed if slope is not None] == ["1.6538", "2.0055", "1.9999"]
    corrected = ledger.ENTRIES["3-table-1-y-1_2"]().corrected
    assert "1.6538 is the slope over these of y less eq. (29) as printed" in corrected
    honest = ledger.deviations
    monkeypatch.setattr(ledger, "deviations", lambda *of: {**honest(*of), "y": 2 * honest(*of)["y"]})
    assert ledger._with_the_printed_y(BETAS[0]) == ""


def test_every_measured_number_has_its_entry_and_its_note() -> None:
    missing = {(name, beta) for name in ledger.MEASURED for beta in BETAS} - set(ledger.SERIES)
    assert missing == {("y", BETAS[0])}
    for name in ledger.MEASURED:
        for beta in BETAS:
            assert (ledger.identifier(name, beta) in ledger.ENTRIES) is True
            note = ledger._notes(name, beta)
            assert ("before and after the G-spot" in note) is ((name, beta) == ("t", BETAS[1]))
            assert ("Theorem E3" in note) is ("neighbours 1 % apart" in note) is ((name, beta) in ledger.NONE_BELOW)


def test_a_number_that_series_of_small_epsilon_do_not_give() -> None:
    """And those of larger ones do: such a number is possible."""
    for (name, beta), largest in ledger.NONE_BELOW.items():
        text = ledger.MEASURED[name][beta]
        assert [ledger.can_be_the_number(text, name, beta, e) for e in (largest, 2 * largest)] == [False, None]
        assert all(max(ledger.epsilons(series)) > largest for series in ledger.SERIES[name, beta])
        assert str(largest) in ledger._notes(name, beta)


def test_where_the_oscillations_show() -> None:
    """The slopes from one ε to the next, as measured and of the slow part; at ε = 1/2500 it is all there is."""
    beta, numbers = BETAS[2], (1000, 1050, 1100, 1200)
    pairs = list(pairwise(numbers))
    whole = [ledger.slope("b", beta, (first, fmpq(last, first), 2)) for first, last in pairs]
    motions = {n: contact_motion(*at_the_g_spot._run(beta, ledger.NU, fmpq(1, n))) for n in (*numbers, 2500)}
    parts = {n: motion.hats(fmpq(0), 60, ("b",)) for n, motion in motions.items()}
    with working_bits(96):
        slow = [
            (abs(parts[first][0]["b"]) / abs(parts[last][0]["b"])).log() / arb(fmpq(last, first)).log()
            for first, last in pairs
        ]
        assert abs(parts[2500][1]["b"]) < abs(parts[2500][0]["b"]) * fmpq(1, 10**12)
    shown = [*(found for found in whole if found is not None), *slow]
    assert re.findall(r"1\.\d{4}", ledger.WAVES) == [ledger.decimals(found) for found in shown]
    assert re.findall(r"1/(\d+)", ledger.WAVES) == list(map(str, numbers))
    assert ledger.WAVES in ledger._notes("b", beta)
    assert not any("oscillations" in ledger._notes(*key) for key in ledger.SERIES if key != ("b", beta))


def test_formulas_at_one_beta() -> None:
    found = {name: [ledger.formula(name, beta) for beta in BETAS] for name in ledger.FORMULAS}
    thirds = {name: [fmpq(n, 3) for n in row] for name, row in {"b": (1, 3, 5), "v": (3, 5, 7), "y": (5, 7, 9)}.items()}
    assert found == {**thirds, "t": [fmpq(2, 3)] * 3}
    for name in ("b", "v", "y"):
        assert [ledger.limit_exponent(beta, name) for beta in BETAS] == thirds[name]


def test_every_printed_limit_is_asked_for() -> None:
    honest = {beta: ledger.formula("y", beta) for beta in BETAS}
    assert ledger.printed_are(honest, "y")
    for beta in BETAS:
        for change in (fmpq(1, 10**4), -fmpq(1, 10**4)):
            assert not ledger.printed_are({**honest, beta: honest[beta] + change}, "y")
    assert ledger.printed_are({**honest, BETAS[2]: 3 + HALF}, "y")  # a tie may be rounded down


def test_every_series_below_tiny(monkeypatch: pytest.MonkeyPatch) -> None:
    honest, asked = ledger.regression_error, []

    def regression_error(beta: fmpq, name: str, largest: fmpq) -> arb:
        asked.append((beta, name, largest))
        return honest(beta, name, largest)

    monkeypatch.setattr(ledger, "regression_error", regression_error)
    assert ledger.every_series_gives("b") is True
    assert asked == [(beta, "b", fmpq(1, 10**15)) for beta in BETAS]
    monkeypatch.setattr(ledger, "regression_error", lambda *_: arb("0.001"))
    assert ledger.every_series_gives("b") is None
    monkeypatch.setattr(ledger, "regression_error", lambda *_: arb(0))
    assert ledger.every_series_gives("b") is True
    monkeypatch.setattr(ledger, "limit_exponent", lambda beta, _: 2 * beta / 3 + fmpq(beta == BETAS[2], 1000))
    assert ledger.every_series_gives("b") is False


@pytest.mark.parametrize(
    ("place", "theta", "answer"),
    [
        (fmpq(2), (lambda tau: tau - 2, arb(1)), True),
        (fmpq(2), (lambda tau: 2 - tau, arb(-1)), True),
        (fmpq(2), (lambda tau: tau - 3, arb(1)), False),  # no change of sign
        (fmpq(2), (lambda tau: arb(tau - fmpq(41, 20), "1e-9"), arb(1)), None),  # a sign that is open
        (fmpq(2), (lambda tau: tau - fmpq(41, 20), arb(1)), False),  # the zero at the end
        (fmpq(2), (lambda tau: tau - 2, arb(0, 1)), None),  # a slope that may vanish
        (fmpq(1, 20), (lambda tau: tau - fmpq(1, 30), arb(1)), False),  # 0 at the edge
        (fmpq(-1, 20), (lambda tau: tau + fmpq(1, 30), arb(1)), False),
        (fmpq(1, 30), (lambda tau: tau - fmpq(1, 40), arb(1)), False),  # 0 inside
    ],
)
def test_a_simple_zero_other_than_0(
    monkeypatch: pytest.MonkeyPatch, place: fmpq, theta: tuple[Any, arb], answer: bool | None
) -> None:
    asked = []

    def evaluate(tau: Any, beta: fmpq, derivative: int = 0) -> Any:
        assert beta == BETAS[0]
        asked.append((tau, derivative))
        return SimpleNamespace(value=theta[1] if derivative == 1 else arb(theta[0](tau)))

    monkeypatch.setattr(ledger, "evaluate", evaluate)
    assert ledger._simple_zero(BETAS[0], place) is answer
    near = fmpq(1, 20)
    assert {tau for tau, derivative in asked if derivative == 0} == {place - near, place + near}
    (whole,) = [tau for tau, derivative in asked if derivative == 1]
    with working_bits(96):
        assert all(whole.contains(arb(end)) for end in (place - near, place, place + near))


def test_the_crossings_are_near_simple_zeros() -> None:
    assert ledger.zeros_are_simple() is True
    assert ledger.CROSSINGS[BETAS[1]] < 0  # of two zeros that before the G-spot


@pytest.mark.parametrize("name", sorted(ledger.FORMULAS))
def test_values_at_two_small_epsilon(monkeypatch: pytest.MonkeyPatch, name: str) -> None:
    """By the certified values alone: the formula for the limit is not asked."""
    asked: list[Any] = []

    def law(change: fmpq) -> Any:
        def value(name: str, beta: fmpq, epsilon: fmpq) -> arb:
            asked.append((name, beta, epsilon))
            return arb(epsilon) ** arb(ledger.formula(name, beta) + change)

        return value

    monkeypatch.delattr(ledger, "limit_exponent")
    assert ledger.values_follow(name) is True
    monkeypatch.setattr(ledger, "value", law(fmpq(0)))
    assert ledger.values_follow(name) is True
    assert set(asked) == {(name, beta, fmpq(1, 10**k)) for beta in BETAS for k in (13, 14)}
    monkeypatch.setattr(ledger, "value", law(fmpq(1, 1000)))
    assert ledger.values_follow(name) is False
    monkeypatch.setattr(ledger, "value", lambda *_: None)
    assert ledger.values_follow(name) is None


def test_the_sign_of_what_is_measured() -> None:
    """The table has the exponents of the sizes."""
    assert {name: ledger.negative(name) for name in "bvy"} == {
        "b": [fmpq(1, 2), fmpq(5, 2)],
        "v": [fmpq(1, 2)],
        "y": [fmpq(1, 2), fmpq(3, 2)],
    }


def test_the_note_on_one_series_says_what_one_number_excludes() -> None:
    entry = ledger.ENTRIES["3-table-1-one-series"]()
    assert ledger.can_be_the_number("1.6538", "y", fmpq(1, 2), ledger.LARGEST) is False
    assert f"no series of ε <= {ledger.LARGEST}" in entry.note
    assert ledger.LARGEST > ledger.COMMON
