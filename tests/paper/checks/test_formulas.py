"""Formulas as texts: two routes to each value, what is no formula, and what a claim answers."""

from __future__ import annotations

import pytest
from flint import acb, arb, fmpq

from gspot_verified.numbers.balls import working_bits
from gspot_verified.paper.checks.closed_forms import ClosedForm, rational
from gspot_verified.paper.checks.entry import Check, Rung
from gspot_verified.paper.checks.formulas import (
    FormulaClaim,
    closed_form,
    evaluate_text,
    mended,
    put,
    quotient,
    rational_value,
)

VALUES = {"beta": fmpq(7, 3), "n": fmpq(3), "u": fmpq(2, 5), "tau": fmpq(-3, 2)}


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("7", fmpq(7)),
        ("-beta", fmpq(-7, 3)),
        ("beta*n", fmpq(7)),
        ("n/beta", fmpq(9, 7)),
        ("n + beta", fmpq(16, 3)),
        ("n - beta", fmpq(2, 3)),
        ("beta^2", fmpq(49, 9)),
        ("beta^n", fmpq(343, 27)),
        ("beta^(-n)", fmpq(27, 343)),
        ("2*n-1 - n*u/(1-u)", fmpq(3)),
        ("n/(2*n)", fmpq(1, 2)),
    ],
)
def test_rational_values_are_exact(text: str, value: fmpq) -> None:
    assert rational_value(text, **VALUES) == value
    assert evaluate_text(text, VALUES, 64).overlaps(acb(value))


@pytest.mark.parametrize("text", ["Gamma(n)", "fac(n)", "sqrt(n)", "n^u", "1/Gamma(n)"])
def test_what_is_not_rational_has_no_rational_value(text: str) -> None:
    with pytest.raises(ValueError, match="is not rational"):
        rational_value(text, **VALUES)


@pytest.mark.parametrize("text", ["n // 2", "Beta(n)", "Gamma(n, 2)", "n < 2", "'n'", "+n", "not n"])
def test_what_is_no_formula(text: str) -> None:
    with pytest.raises(ValueError, match="not a closed form"):
        closed_form(text)
    with pytest.raises(ValueError, match="not a formula"):
        evaluate_text(text, VALUES, 64)


def gamma_of(value: fmpq) -> arb:
    with working_bits(100):
        return arb(value).gamma()


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("Gamma(beta)", lambda: gamma_of(fmpq(7, 3))),
        ("fac(beta)", lambda: gamma_of(fmpq(10, 3))),
        ("sqrt(n)", lambda: arb(3).sqrt()),
        ("beta^u", lambda: (arb(fmpq(7, 3)).log() * fmpq(2, 5)).exp()),
        ("n/Gamma(beta)", lambda: 3 / gamma_of(fmpq(7, 3))),
        ("n/(Gamma(beta)*2)", lambda: arb(3) / 2 / gamma_of(fmpq(7, 3))),
        ("n/(2*Gamma(beta))", lambda: arb(3) / 2 / gamma_of(fmpq(7, 3))),
        ("n/(Gamma(beta)*Gamma(u))", lambda: 3 / gamma_of(fmpq(7, 3)) / gamma_of(fmpq(2, 5))),
        ("n/(2*(1+n))", lambda: arb(fmpq(3, 8))),
        ("n/Gamma(-3)", lambda: arb(0)),
        ("n/(Gamma(-3)*2)", lambda: arb(0)),
        ("n/(2*Gamma(-n))", lambda: arb(0)),
        ("pi", lambda: arb.pi()),
        ("e^n", lambda: arb(3).exp()),
        ("(i*n)^2", lambda: arb(-9)),
    ],
)
def test_values_in_balls(text: str, value: object) -> None:
    with working_bits(100):
        known = value()  # type: ignore[operator]
    found = evaluate_text(text, VALUES, 100)
    assert found.is_finite()
    assert found.overlaps(acb(known))
    assert found.real.rel_accuracy_bits() > 80 or found == 0


def test_the_precision_is_the_one_asked_for() -> None:
    accuracies = [
        int(evaluate_text("sqrt(n)*Gamma(beta)", VALUES, bits).real.rel_accuracy_bits()) for bits in (60, 300)
    ]
    assert accuracies[0] <= 60 < 280 < accuracies[1]


@pytest.mark.parametrize(
    ("text", "same"),
    [
        ("beta - n", "-(n - beta)"),
        ("beta + n", "n + beta"),
        ("beta*n/2", "n/(2/beta)"),
        ("fac(beta)", "beta*Gamma(beta)"),
        ("Gamma(beta+1)", "beta*Gamma(beta)"),
        ("sqrt(3)", "3^(1/2)"),
        ("sqrt(u)*sqrt(u)", "u"),
        ("4^beta", "2^beta*2^beta"),
        ("6^beta", "2^beta*3^beta"),
        ("(2*u)^beta", "2^beta*u^beta"),
        ("(u/2)^beta", "u^beta/2^beta"),
        ("(-1)^n*(-1)^n", "1"),
        ("(beta+1)^2", "beta^2 + 2*beta + 1"),
        ("(beta+1)^0", "1"),
        ("e^(beta+1)", "e*e^beta"),
        ("i^beta*i", "i^(beta+1)"),
        ("-2*u", "u*(-2)"),
    ],
)
def test_equal_forms(text: str, same: str) -> None:
    assert (closed_form(text) / closed_form(same)).is_one()
    assert not (closed_form(f"({text})*2") / closed_form(same)).is_one()


@pytest.mark.parametrize("text", ["(beta+1)^(1/2)", "(beta+1)^beta", "(-2)^beta", "0^beta"])
def test_powers_that_are_no_closed_forms(text: str) -> None:
    with pytest.raises(ValueError, match=r"a power of|not a closed form"):
        closed_form(text)


def test_texts_are_put_in_at_once_and_as_whole_names() -> None:
    assert put("x*y + x1*n", x="y", y="x", n="2*n") == "(y)*(x) + x1*(2*n)"
    assert put("x + 1") in ("x + 1", "(x) + 1")
    assert put("a.b + a", a="c") == "(c).b + (c)"


def test_any_power_of_one_is_one() -> None:
    for exponent in ("beta", "k", "(1/2)", "0"):
        assert closed_form(f"1^{exponent}").is_one()
    assert not closed_form("2^beta").is_one()


def test_a_quotient_is_one_when_both_are_equal() -> None:
    zero, two = rational(0), rational(2)
    assert quotient(zero, zero).is_one()
    assert quotient(zero, two).is_zero()
    assert quotient(two, zero).is_zero()
    assert quotient(two, rational(4)).factor == rational(fmpq(1, 2)).factor


@pytest.mark.parametrize(
    ("printed", "corrected", "answer"),
    [(False, True, False), (False, False, None), (False, None, None), (True, False, True), (None, True, None)],
)
def test_a_failure_needs_a_corrected_form_that_stands(
    printed: bool, corrected: bool | None, answer: bool | None
) -> None:
    assert mended(printed, corrected) is answer


def value_of(*names: str):  # type: ignore[no-untyped-def]
    return lambda forms: [forms[name] for name in names]


WRONG = FormulaClaim({"f": "2"}, {"f": "1"})


def test_answers_of_a_claim() -> None:
    right = FormulaClaim({"f": "1", "g": "u"})
    assert right.check("a", value_of("f")) == Check(Rung.EXACT, "a", True, "")
    assert right.check("a", value_of("f"), Rung.POINTS).rung is Rung.POINTS
    assert right.check("a", lambda _: []) == Check(Rung.EXACT, "a", None, "open: nothing was checked")
    found = right.check("a", value_of("f", "g"))
    assert (found.agrees, found.finding) == (False, "the quotient is u, not 1")
    assert right.check("a", value_of("g"), finding="b").finding == "b"
    open_one = FormulaClaim({"f": "2^beta", "g": "3"})
    assert open_one.check("a", value_of("f")).agrees is None
    assert open_one.check("a", value_of("f")).finding.startswith("open: ")
    assert open_one.check("a", value_of("f", "g")).agrees is False  # a certain failure beside an open one


def test_a_corrected_form_must_hold() -> None:
    found = WRONG.check("a", value_of("f"))
    assert (found.agrees, found.finding) == (False, "the quotient is 2, not 1; with the corrected form it is 1")
    still = FormulaClaim({"f": "2", "g": "2"}, {"f": "1"}).check("a", value_of("f", "g"))
    assert (still.agrees, still.finding) == (None, "the printed and the corrected form fail")


def test_signs_of_a_claim() -> None:
    claim = FormulaClaim({"plus": "u+1", "minus": "-u", "open": "u-1", "zero": "0"})
    answers = {name: claim.check_sign("a", value_of(name)).agrees for name in claim.printed}
    assert answers["plus"] is True
    assert answers["minus"] is False
    assert answers["open"] is None
    assert "not positive" in claim.check_sign("a", value_of("minus")).finding


def test_hypotheses_are_put_into_both_forms() -> None:
    claim = FormulaClaim({"f": "beta-1"}, {"f": "beta"}).under(beta="1+u")
    assert claim.printed == {"f": "(1+u)-1"}
    assert claim.corrected == {"f": "(1+u)"}
    assert isinstance(closed_form(claim.printed["f"]), ClosedForm)
