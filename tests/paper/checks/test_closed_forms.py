"""Closed forms against balls: what is proved equal is equal, what is proved positive is positive."""

from __future__ import annotations

from functools import reduce

import pytest
from flint import acb, arb, fmpq
from hypothesis import given
from hypothesis import strategies as st

from gspot_verified.numbers.balls import working_bits
from gspot_verified.paper.checks.closed_forms import ALGEBRA, ClosedForm, gamma, power, rational, sine_of_number
from gspot_verified.paper.checks.formulas import (
    FormulaClaim,
    closed_form,
    evaluate_text,
    mended,
    put,
    quotient,
    rational_value,
)

_SMALL = st.integers(-4, 4)
_RATIONALS = st.builds(fmpq, st.integers(-40, 40), st.integers(1, 9))
_POSITIVE = st.builds(fmpq, st.integers(1, 40), st.integers(1, 9))


def number(text: str, **values: fmpq) -> arb:
    return evaluate_text(text, values, 256).real


def value_of(form: ClosedForm, **values: fmpq) -> acb:
    """A closed form in balls, part by part."""

    def at(part: object) -> fmpq:
        return rational_value(str(part), **values)

    with working_bits(256):
        above, below = (
            evaluate_text(str(part), values, 256) for part in (form.factor.numerator, form.factor.denominator)
        )
        found = above / below * acb(at(form.phase)).exp_pi_i()
        for base, exponent in form.powers.items():
            number = {"pi": arb.pi(), "e": arb(1).exp()}.get(base)
            found *= (arb(at(base)) if number is None else number) ** arb(at(exponent))
        for argument, times in form.gammas.items():
            found *= acb(at(argument)).gamma() ** times
        for argument, times in form.sines.items():
            found *= acb(at(argument)).sin_pi() ** times
        return found


PARTS = (
    "2", "beta", "3^beta", "12^(beta/2)", "epsilon^(beta/3-1)", "kappa^(1/2)", "(-1)^k", "(-1)^(3*k+1)", "i", "i^(3*k)",
    "e^(i*pi*beta)", "e^(5*i*pi/2)", "e^(u/2)", "Gamma(1/4)", "Gamma(1/3)", "Gamma(2/3)", "Gamma(1/6)", "Gamma(5/6)",
    "Gamma(-9/4)", "Gamma(7/2)", "Gamma(8/3)", "Gamma(-1/3)", "Gamma(1)", "Gamma(4)", "Gamma(beta)", "Gamma(-beta/3)",
    "Gamma(1/3-beta/3-k)", "Gamma(beta/3+2*k+1/2)", "fac(k)", "Gamma(u+1/2)",
)  # fmt: skip


@given(st.lists(st.tuples(st.sampled_from(PARTS), st.integers(-3, 3)), min_size=1, max_size=3), st.integers(0, 3))
def test_a_form_has_the_value_of_its_text(parts: list[tuple[str, int]], k: int) -> None:
    values = {"beta": fmpq(17, 7), "k": fmpq(k), "epsilon": fmpq(1, 3), "kappa": fmpq(5, 4), "u": fmpq(3, 5)}
    text = "*".join(f"({part})^({times})" for part, times in parts)
    form = reduce(ClosedForm.__mul__, (closed_form(part) ** times for part, times in parts))
    expected, found = evaluate_text(text, values, 256), value_of(form, **values)
    with working_bits(256):
        assert expected.is_finite()
        assert abs(found / expected - 1) < arb("1e-50")
    assert form.is_rational() is not (form.powers or form.gammas or form.sines or not form.phase.is_zero())
    assert (closed_form(text) / form).is_one()


def test_what_is_not_rational() -> None:
    one = rational(1).factor
    parts = ({"powers": {"3": ALGEBRA.read("beta")}}, {"phase": ALGEBRA.read("beta")}, {"gammas": {"u": 1}})
    for part in (*parts, {"sines": {"u": 1}}):
        form = ClosedForm(one, **part)  # type: ignore[arg-type]
        assert not form.is_rational()
        assert not form.is_one()
    assert ClosedForm(one, gammas={"u": 1}).is_positive()
    assert not ClosedForm(one, sines={"u": 1}).is_positive()
    assert not ClosedForm(one, phase=ALGEBRA.read("u")).is_positive()
    assert not ClosedForm(one, powers={"alpha1": ALGEBRA.read("beta")}).is_positive()


@pytest.mark.parametrize(
    ("text", "same"),
    [
        ("i^4", 1), ("i^2", -1), ("i^(-2)", -1), ("i^10", -1), ("e^(7*i*pi)", -1), ("e^(-6*i*pi)", 1), ("Gamma(1)", 1),
        ("Gamma(2)", 1), ("Gamma(5)", 24), ("fac(3)", 6), ("(-1)^(4*k+6)", 1),
    ],
)  # fmt: skip
def test_numbers_are_brought_to_a_number_at_once(text: str, same: int) -> None:
    form = closed_form(text)
    assert form.is_rational()
    assert form.factor == same
    assert (rational(0) ** 0).is_one()


@st.composite
def gamma_texts(draw: st.DrawFn) -> str:
    """Γ of (a β + b)/3 + c k, with a power of 3 in front."""
    slope, constant, integer = draw(st.sampled_from((-3, -2, -1, 1, 3))), draw(_SMALL), draw(st.integers(-1, 1))
    return f"3^(beta/3+{draw(_SMALL)})*Gamma(({slope}*beta+{constant})/3+({integer})*k)"


@given(gamma_texts(), _SMALL, _RATIONALS, st.integers(0, 4))
def test_the_functional_equation_in_both_ways(text: str, shift: int, beta: fmpq, k: int) -> None:
    argument = text.partition("Gamma(")[2][:-1]
    moved = text.replace(f"Gamma({argument})", f"Gamma({argument}+{shift})")
    factors = [f"({argument}+{i})" for i in range(shift)] or [f"({argument}-{i + 1})" for i in range(-shift)]
    expected = f"({text})*{'*'.join(factors)}" if shift > 0 else f"({text})/({'*'.join(factors) or '1'})"
    assert (closed_form(moved) / closed_form(expected)).is_one()
    first, second = number(moved, beta=beta, k=fmpq(k)), number(expected, beta=beta, k=fmpq(k))
    if first.is_finite() and second.is_finite():
        assert first.overlaps(second)


@pytest.mark.parametrize(
    ("first", "second"),
    [
        ("Gamma(-beta)*Gamma(1+beta)*Gamma(1/2-beta)*Gamma(1/2+beta)", "Gamma(1+beta)*Gamma(-beta)*Gamma(1/2+beta)*"
         "Gamma(1/2-beta)"),
        ("Gamma(-beta/3)*Gamma(1+beta/3)/Gamma(1/3-beta/3)/Gamma(2/3+beta/3)",
         "Gamma(-beta/3-1)*Gamma(2+beta/3)/Gamma(4/3-beta/3)/Gamma(-1/3+beta/3)"),
        ("Gamma(-beta)", "3^(-beta-1/2)/(2*pi)*Gamma(-beta/3)*Gamma((1-beta)/3)*Gamma((2-beta)/3)"),
        ("Gamma(1+beta)/Gamma(1+beta-3*k)", "(-1)^(3*k)*Gamma(3*k-beta)/Gamma(-beta)"),
        ("Gamma(1/2)*Gamma(5/2)", "3*pi/4"),
        ("Gamma(1/6)*Gamma(5/6)", "2*pi"),
        ("Gamma(1/3)*Gamma(2/3)", "2*pi/sqrt(3)"),
        ("fac(k+1)", "(k+1)*fac(k)"),
        ("(9/4)^(beta/2)", "3^beta/2^beta"),
        ("i^(4*k+2)", "-1"),
        ("e^(i*pi*beta+lam)", "(-1)^beta*e^lam"),
    ],
)  # fmt: skip
def test_equal_forms_are_equal_in_balls(first: str, second: str) -> None:
    assert (closed_form(first) / closed_form(second)).is_one()
    values = {"beta": fmpq(17, 7), "k": fmpq(2), "lam": fmpq(3, 5)}
    one, other = (evaluate_text(text, values, 256) for text in (first, second))
    assert one.is_finite()
    assert other.is_finite()
    assert one.overlaps(other)


@pytest.mark.parametrize(
    ("first", "second"),
    [
        ("Gamma(-beta)", "Gamma(beta)"),
        ("Gamma(-beta/3)", "Gamma((1-beta)/3)"),
        ("3^beta", "3^(beta+1/2)"),
        ("epsilon^(beta/3)", "epsilon^(beta/2)"),
        ("(-1)^k", "1"),
        ("i", "-i"),
        ("e^lam", "e^(2*lam)"),
        ("(1+(beta-2)*(beta-3))*kappa^beta", "kappa^beta"),
    ],
)
def test_different_forms_are_not_one(first: str, second: str) -> None:
    assert not (closed_form(first) / closed_form(second)).is_one()


@given(st.lists(st.tuples(st.integers(-3, 3), st.integers(0, 2), st.integers(0, 2)), min_size=1, max_size=5),
       _POSITIVE, _POSITIVE, st.fractions(min_value="1/100", max_value="99/100", max_denominator=100))  # fmt: skip
def test_a_proved_sign_is_the_sign(terms: list[tuple[int, int, int]], u: fmpq, w: fmpq, unit: object) -> None:
    v = fmpq(unit.numerator, unit.denominator)  # type: ignore[attr-defined]
    text = "+".join(f"({c})*u^{a}*v^{b}" for c, a, b in terms)
    form = closed_form(f"({text})*w^(beta/2)") if not closed_form(text).is_zero() else rational(0)
    sign = form.sign()
    if sign is not None:
        value = rational_value(text, u=u, v=v)
        assert (value > 0) is (sign > 0)
        assert (number(f"({text})*w^(beta/2)", u=u, v=v, w=w, beta=fmpq(1, 3)) > 0) is (sign > 0)


@pytest.mark.parametrize(
    ("text", "sign"),
    [
        ("1-v", 1), ("v-1", -1), ("Gamma(-v)", -1), ("Gamma((1-v)/3)", 1), ("Gamma(u)", 1), ("Gamma(-u)", None),
        ("u-1", None), ("m", None), ("3*m+1", 1), ("C_1*C_1", None), ("alpha1", None), ("e^(i*lam)", None),
        ("beta", None), ("1-m", None), ("epsilon^((2*beta-2)/3)", 1), ("(-1)^k", None), ("0*u", None),
        ("sqrt(pi)*3^(beta/3)", 1),
    ],
)  # fmt: skip
def test_signs(text: str, sign: int | None) -> None:
    assert closed_form(text).sign() == sign


def test_sums_and_their_errors() -> None:
    assert (closed_form("2*epsilon^beta+3*epsilon^beta") / closed_form("5*epsilon^beta")).is_one()
    assert (closed_form("0*beta") + closed_form("beta")).factor == closed_form("beta").factor
    for wrong in (
        "epsilon^beta+kappa^beta",
        "Gamma(beta)+1",
        "(1+beta)^beta",
        "alpha1^beta",
        "alpha1^(1/2)",
        "beta if 1 else 2",
        "sin(beta)",
    ):
        with pytest.raises(ValueError, match=r".+"):
            closed_form(wrong)
    assert (closed_form("0*epsilon^beta") + rational(1)).is_one()
    assert (rational(1) + closed_form("0*epsilon^beta")).is_one()
    for pole in (0, -1, -2):
        with pytest.raises(ValueError, match="pole"):
            gamma(ALGEBRA.constant(pole))
    with pytest.raises(ZeroDivisionError):
        rational(0).inverse()
    with pytest.raises(ValueError, match="one power"):
        closed_form("1+epsilon").exponent("epsilon")


def test_parts_of_a_turned_form() -> None:
    parts = closed_form("2*e^(2*i*pi/3)").turned()
    assert parts is not None
    assert [str(part) for part in parts] == ["-1", "3^(1/2)"]
    assert closed_form("i^k").turned() is None
    assert closed_form("e^(i*pi/5)").turned() is None
    for n in range(-12, 13):
        value = sine_of_number(fmpq(n, 6))
        found = number(str(value).replace(" ", "*"))
        with working_bits(256):
            assert abs(found - arb(fmpq(n, 6)).sin_pi()) < fmpq(1, 10**60)


def test_the_text_of_a_form() -> None:
    assert str(closed_form("2*Gamma(-beta/3)")) == "(-6)/(beta) Γ(-1/3*beta + 1)^1"
    assert str(closed_form("3^beta*Gamma(beta/3)")) == "pi 3^(beta) Γ(-1/3*beta + 1)^-1 sin π(1/3*beta)^-1"
    assert str(closed_form("e^(i*pi*beta)")) == "exp(iπ(beta))"
    assert str(rational(1)) == "1"


def test_exponents() -> None:
    form = closed_form("-C_1/alpha3*epsilon^(beta-1)*epsilon^2")
    assert form.exponent("epsilon") == ALGEBRA.read("beta+1")
    assert form.exponent("alpha3") == -1
    assert form.exponent("kappa") == 0
    assert power("12", ALGEBRA.read("beta")).powers.keys() == {"2", "3"}


def test_rational_texts_stay_exact() -> None:
    assert evaluate_text("1/3-beta/3", {"beta": fmpq(1)}, 64).is_zero()
    assert evaluate_text("1/(3*Gamma(-beta))", {"beta": fmpq(2)}, 64).is_zero()
    assert not evaluate_text("Gamma(-beta)", {"beta": fmpq(2)}, 64).is_finite()
    assert rational_value("(n-1)/3", n=3) == fmpq(2, 3)
    with pytest.raises(ValueError, match="not rational"):
        rational_value("sqrt(n)", n=2)
    with pytest.raises(ValueError, match="not a formula"):
        evaluate_text("sin(beta)", {"beta": fmpq(1)}, 64)


def test_texts_are_put_in_all_at_once() -> None:
    assert put("u*beta+betas", beta="u", u="beta") == "(beta)*(u)+betas"
    assert put("beta") == "beta"


def test_quotients_of_zeros() -> None:
    zero, one = rational(0), rational(1)
    assert [quotient(*pair).is_one() for pair in ((zero, zero), (zero, one), (one, zero), (one, one))] == [
        True, False, False, True,
    ]  # fmt: skip


def test_claims_are_three_valued() -> None:
    def whole(forms: dict[str, ClosedForm]) -> list[ClosedForm]:
        return list(forms.values())

    assert FormulaClaim({"f": "beta/beta"}).check("equal", whole).agrees is True
    assert FormulaClaim({"f": "2"}).check("not equal", whole).agrees is False
    assert FormulaClaim({"f": "epsilon^beta"}).check("not proved to be equal", whole).agrees is None
    assert FormulaClaim({"f": "2"}).check("nothing", lambda _: []).agrees is None
    assert FormulaClaim({"f": "2"}, {"f": "1"}).check("mended", whole).agrees is False
    assert FormulaClaim({"f": "2"}, {"f": "3"}).check("not mended", whole).agrees is None
    assert FormulaClaim({"f": "u-1"}).check_sign("open", whole).agrees is None
    assert FormulaClaim({"f": "u-1", "g": "-1"}).check_sign("one fails", whole).agrees is False
    assert FormulaClaim({"f": "beta"}).under(beta="u").check_sign("with the hypothesis", whole).agrees is True
    assert [mended(*pair) for pair in ((True, None), (False, True), (False, None), (False, False), (None, True))] == [
        True, False, None, None, None,
    ]  # fmt: skip


@pytest.mark.parametrize(
    ("text", "same"),
    [
        ("Gamma(-1/2)", "-2*pi^(1/2)"),
        ("Gamma(-3/2)", "4/3*pi^(1/2)"),
        ("Gamma(-7/2)", "16/105*pi^(1/2)"),
        ("Gamma(-2/3)", "-3/2*Gamma(1/3)"),
        ("Gamma(-8/3)", "-27/80*Gamma(1/3)"),
        ("Gamma(7/2)", "15/8*pi^(1/2)"),
        ("Gamma(10/3)", "28/27*Gamma(1/3)"),
    ],
)
def test_gamma_of_rational_numbers(text: str, same: str) -> None:
    assert (closed_form(text) / closed_form(same)).is_one()
    assert not (closed_form(text) / closed_form(f"2*({same})")).is_one()
    with working_bits(100):
        assert abs(evaluate_text(text, {}, 100).real / evaluate_text(same, {}, 100).real - 1) < arb("1e-20")
