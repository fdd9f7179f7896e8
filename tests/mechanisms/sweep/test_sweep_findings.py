"""Case and side on pieces against exact arithmetic: α_1, α_2, α_3 are random polynomials in the parameter.

Page: proofs/sweep.md, sections 3 to 5.
"""

from __future__ import annotations

import itertools
import random
from fractions import Fraction

import pytest
import sympy
from flint import arb, fmpq
from hypothesis import given, settings
from hypothesis import strategies as st
from samples.families import family, three_alphas

from gspot_verified.functions.box_program import BoxProgram
from gspot_verified.functions.expressions import Variable
from gspot_verified.mechanisms.input.mechanism import MechanismError
from gspot_verified.mechanisms.spots.classify import classify
from gspot_verified.mechanisms.sweep.sweep import sweep
from gspot_verified.mechanisms.sweep.sweep_findings import Findings, case_of_signs
from gspot_verified.mechanisms.sweep.sweep_piece import Kind
from gspot_verified.mechanisms.sweep.sweep_result import ZeroOnLine
from gspot_verified.mechanisms.sweep.sweep_start import Origin, proved_tube
from gspot_verified.mechanisms.table.classify_table import classify_table
from gspot_verified.mechanisms.zeros.tube import Equations
from gspot_verified.numbers.balls import working_bits

K = sympy.Symbol("k")
COEFFICIENTS = st.lists(st.fractions(-3, 3, max_denominator=4), min_size=1, max_size=4)
NEGATIVE = st.lists(st.fractions(0, 2, max_denominator=4), min_size=1, max_size=3)


def polynomial(coefficients: list[Fraction]) -> sympy.Poly:
    return sympy.Poly(sum(sympy.Rational(c.numerator, c.denominator) * K**i for i, c in enumerate(coefficients)), K)


def at(function: sympy.Poly, value: fmpq) -> Fraction:
    found = function.eval(sympy.Rational(int(value.p), int(value.q)))
    return Fraction(int(found.p), int(found.q))


def exactly(first: Fraction, second: Fraction, third: Fraction) -> tuple[str, int | None, int | None]:
    """The paper's cases, Sec. 1.2 and Sec. 4.5, for numbers; beta an integer in Case III gives no sides."""
    if first < third < 0 and second != 0:
        return ("I" if second < 0 else "II"), None, -1
    if third < first < 0 and second < 0:
        beta = third / first
        sign = None if beta.denominator == 1 else (1 if (beta.numerator // beta.denominator) % 2 else -1)
        return "III", (None if sign is None else -sign), sign
    return "none", None, None


def boundary(crossing: ZeroOnLine, alphas: tuple[sympy.Poly, ...]) -> sympy.Poly:
    """A polynomial that vanishes where the crossing's quantity does (alpha_1 has a certain sign there, for beta)."""
    first, second, third = alphas
    named = {"alpha_1": first, "alpha_2": second, "alpha_3": third, "alpha_3 - alpha_1": third - first}
    if crossing.quantity in named:
        return named[crossing.quantity]
    return third - int(crossing.quantity.removeprefix("beta - ")) * first


@given(COEFFICIENTS, COEFFICIENTS, COEFFICIENTS, st.booleans(), st.integers(1, 5), st.lists(st.integers(0, 64)))
@settings(max_examples=25, deadline=None)
def test_random_polynomials(
    one: list[Fraction], two: list[Fraction], three: list[Fraction], likely: bool, cells: int, points: list[int]
) -> None:
    first, second, third = (polynomial(each) for each in (one, two, three))
    if likely:  # mostly Case III: -α_1 small and positive, -α_3 larger
        first, third = -(first * first) - sympy.Rational(1, 4), -(third * third) - sympy.Rational(1, 3)
    alphas = (first, second, third)
    texts = [str(each.as_expr()) for each in alphas]
    result = sweep(three_alphas(*texts), {"k": ("-1", "1", cells)})
    for piece in result.pieces:
        (lower,), (upper,) = piece.lower, piece.upper
        assert piece.kind in (Kind.SETTLED, Kind.CROSSING, Kind.OPEN)
        for part in (0, 64, 31, *points):
            place = lower + (upper - lower) * fmpq(part, 64)
            values = [at(each, place) for each in alphas]
            for name, value in zip(("alpha_1", "alpha_2", "alpha_3"), values, strict=True):
                number = piece.number(name)
                assert number is not None
                assert number.contains(value)
            if piece.number("beta") is not None:
                assert piece.numbers[3].contains(values[2] / values[0])  # type: ignore[union-attr]
            if piece.kind is Kind.SETTLED:
                assert piece.answer == exactly(*values)
                assert piece.answer[0] in ("none", "I", "II") or piece.answer[1] is not None
    for crossing in result.crossings:
        ends = [sympy.Rational(int(end.p), int(end.q)) for end in (crossing.lower, crossing.upper)]
        zeros = boundary(crossing, alphas).count_roots(*ends)
        assert zeros == 1 if crossing.proved else zeros <= 1


PLANE = st.lists(st.integers(-3, 3), min_size=6, max_size=6)
"""Coefficients of 1, k, l, k^2, k l, l^2, in quarters."""


@given(PLANE, PLANE, PLANE, st.booleans(), st.integers(1, 3), st.integers(1, 3), st.integers(0, 10**6))
@settings(max_examples=10, deadline=None)
def test_random_polynomials_on_a_map(
    one: list[int], two: list[int], three: list[int], likely: bool, columns: int, rows: int, seed: int
) -> None:
    k, m = sympy.symbols("k l")
    monomials = (sympy.Integer(1), k, m, k**2, k * m, m**2)
    first, second, third = (sum((c * x for c, x in zip(each, monomials, strict=True)), sympy.Integer(0)) / 4
                            for each in (one, two, three))  # fmt: skip
    if likely:
        first, third = -(first**2) / 4 - sympy.Rational(1, 4), -(third**2) / 4 - sympy.Rational(1, 3)
    result = sweep(
        three_alphas(*map(str, (first, second, third))), {"k": ("-1", "1", columns), "l": ("-1", "1", rows)}, budget=4
    )
    named = {"alpha_1": first, "alpha_2": second, "alpha_3": third, "alpha_3 - alpha_1": third - first}
    dice = random.Random(seed)
    for piece in dice.sample(result.pieces, min(20, len(result.pieces))):
        for part in ((0, 0), (8, 8), (0, 8), (dice.randrange(9), dice.randrange(9))):
            place = [
                low + (high - low) * fmpq(t, 8) for low, high, t in zip(piece.lower, piece.upper, part, strict=True)
            ]
            at_place = {s: sympy.Rational(int(value.p), int(value.q)) for s, value in zip((k, m), place, strict=True)}
            exact = [sympy.Rational(each.subs(at_place)) for each in (first, second, third)]
            values = [Fraction(int(each.p), int(each.q)) for each in exact]
            for name, value in zip(("alpha_1", "alpha_2", "alpha_3"), values, strict=True):
                number = piece.number(name)
                assert number is not None
                assert number.contains(value)
            if piece.kind is Kind.SETTLED:
                assert piece.answer == exactly(*values)
            if piece.passing is not None:
                quantity, along = piece.passing.quantity, (k, m)[piece.passing.along]
                function = named.get(quantity)
                if function is None:
                    function = third / first - int(quantity.removeprefix("beta - "))
                assert sympy.sign(sympy.diff(function, along).subs(at_place)) == piece.passing.direction


@pytest.mark.parametrize(
    ("alphas", "settled"),
    [
        (("-1", "k^2", "-1/2"), {"II"}),  # alpha_2 touches 0
        (("-1", "-1", "-2 - k^2"), {"III"}),  # beta touches 2
        (("-1", "-1", "-2 + k^2"), {"III"}),
        (("k", "-1", "k"), {"none"}),  # alpha_1 and alpha_3 are equal
        (("-1", "k", "-1 + k"), {"I", "II", "none", "III"}),  # two quantities vanish at once
        (("-1 - k", "-1", "-2 - 2*k"), {"none"}),  # beta = 2 all along, until alpha_1 vanishes at the end
    ],
)
def test_what_touches_or_coincides_is_left(alphas: tuple[str, str, str], settled: set[str]) -> None:
    result = sweep(three_alphas(*alphas), {"k": "-1..1:3"})
    assert result.verdict.exit_code == 2
    assert {piece.case for piece in result.pieces if piece.kind is Kind.SETTLED} <= settled
    assert not any(crossing.proved for crossing in result.crossings if crossing.lower <= 0 <= crossing.upper)


@pytest.mark.parametrize("signs", list(itertools.product([-1, 0, 1], repeat=3)))
def test_the_table_is_that_of_a_single_classification(signs: tuple[int, int, int]) -> None:
    first, second, third = signs
    for factor in (1, 3):
        single = classify(three_alphas(str(first), str(second), f"{third}*{factor}/2"))
        difference = Fraction(third * factor, 2) - first
        table = {"alpha_1": first, "alpha_2": second, "alpha_3": third}
        table["alpha_3 - alpha_1"] = (difference > 0) - (difference < 0)
        assert case_of_signs(table) == (single.case, ())


@pytest.mark.parametrize("unknown", [{"alpha_1"}, {"alpha_2"}, {"alpha_3 - alpha_1"}, {"alpha_1", "alpha_3"}])
def test_an_unknown_sign_is_never_filled_in(unknown: set[str]) -> None:
    """Whatever the unknown signs are, a Case that is said is the one that they give."""
    names = ("alpha_1", "alpha_2", "alpha_3", "alpha_3 - alpha_1")
    for signs in itertools.product([-1, 1], repeat=4):
        table = dict(zip(names, signs, strict=True))
        case, unsure = case_of_signs({name: None if name in unknown else sign for name, sign in table.items()})
        if case is not None:
            for others in itertools.product([-1, 1], repeat=len(unknown)):
                assert case_of_signs(table | dict(zip(sorted(unknown), others, strict=True)))[0] == case
        else:
            assert set(unsure) == unknown


def test_what_no_contact_can_do_is_warned_of() -> None:
    """Case I has a negative mean force; the spot's u is what the place says."""
    result = sweep(three_alphas("-1", "-1", "-1/2"), {"k": "-1..1:4"})
    assert result.warnings == ("in Case I (4 pieces) the mean force is tensile (negative), no contact does that",)
    assert result.warnings[0] in str(result)
    assert sweep(three_alphas("-1", "-1", "-3/2"), {"k": "1/2..1:4"}).warnings == ()
    moving = three_alphas("-1", "-1", "-3/2", slip="k")
    (warning,) = sweep(moving, {"k": "-1..1:4"}).warnings
    assert warning.startswith("u <= 0 at the G-spot on one piece, perhaps on 2 more")


def test_where_no_mass_matrix_gives_the_fields_nothing_is_settled() -> None:
    """A C - B^2 = (3 k - 1)/4 > 0 for k > 1/3 only; the signs of the alphas alone would say Case III everywhere."""
    mechanism = three_alphas("-1", "-1", "-3/2", inertia="k").with_parameters(k=1)
    result = sweep(mechanism, {"k": "-1..1:6"})
    for piece in result.pieces:
        if piece.upper[0] > fmpq(2, 5):
            assert piece.kind is Kind.SETTLED or piece.lower[0] < fmpq(2, 5)
        if piece.lower[0] <= fmpq(1, 3):
            assert piece.kind is Kind.OPEN
            assert piece.unsure == ("the mass matrix is positive definite",)
    assert result.at(k="9/10").case == "III"
    assert result.verdict.exit_code == 2


@pytest.mark.parametrize("kind", list(Kind))
@pytest.mark.parametrize(
    ("first", "third", "beta", "force"),
    [
        (arb(-1), arb(-3), Fraction(3), Fraction(2)),
        (arb(-3), arb(-1), Fraction(1, 3), Fraction(-2)),
        (arb(-1), arb(-1, "0.1"), Fraction(1), None),
        (arb(0, 1), arb(-3), None, Fraction(4, 3)),
        (arb(-1, "0.25"), arb(-3), Fraction(3), Fraction(2)),
    ],
)
def test_a_piece_says_what_holds_on_all_of_it(
    kind: Kind, first: arb, third: arb, beta: Fraction | None, force: Fraction | None
) -> None:
    """α_2 = -4: the mean force α_2/(α_3 - α_1) where that difference has a sign; Case and side where settled."""
    square = Equations(BoxProgram([Variable(0) * Variable(0) - Variable(1)], 2), 1)
    with working_bits(80):
        on = proved_tube(square, (fmpq(1),), (fmpq(5, 4),), Origin((fmpq(1),), (fmpq(1),), ((fmpq(1, 2),),)))
        assert on is not None
        numbers = {
            "alpha_1": first, "alpha_2": arb(-4), "alpha_3": third, "alpha_3 - alpha_1": third - first,
            "beta": third / first, "slip_velocity": arb(5),
        }  # fmt: skip
        piece = Findings(numbers, "III", 1, -1, ()).piece(on, kind)
    assert piece.answer == (("III", 1, -1) if kind is Kind.SETTLED else (None, None, None))
    for name, value in (("beta", beta), ("mean_force", force), ("slip_velocity", Fraction(5))):
        found = piece.number(name)
        assert (found is None) == (value is None)
        assert found is None or value is None or found.contains(value)
    assert (piece.lower, piece.upper, piece.kind, piece.passing) == (on.tube.lower, on.tube.upper, kind, None)
    assert piece.tube() is not None


@pytest.mark.parametrize(
    ("first", "other", "beyond"),
    [
        ("-l*(k - 2)", "1/(k - 2)", 3),
        ("-1 - l^2 + k", "sqrt(k)", 1),
        ("-1 + 0*l", "log(k)", 1),
        ("-l/(k - 2)", "k - 2", 3),
    ],
)
def test_where_a_formula_has_no_value_nothing_is_settled(first: str, other: str, beyond: int) -> None:
    """α_1 = -1 is what is left of all of them: at k = 2, or for k < 0, there is no such mechanism."""
    lower = fmpq(1 if beyond == 3 else -1)
    mechanism = three_alphas(first, "-1", "-3/2", other=other, k=str(beyond))
    found = sweep(mechanism, {"k": (lower, beyond, 3)})
    assert found.verdict.exit_code == 2
    missing = fmpq(2) if beyond == 3 else fmpq(-1, 2)
    assert not any(piece.kind is Kind.SETTLED for piece in found.pieces if piece.holds([missing]))
    assert any(piece.kind is Kind.SETTLED for piece in found.pieces)
    with pytest.raises(MechanismError, match=r"division by zero|a root of the negative|the logarithm of"):
        classify(mechanism.with_parameters(k=missing))
    nowhere, somewhere = classify_table(mechanism, [{"k": missing}, {"k": beyond}])
    assert nowhere.case is None
    assert (nowhere.outcome, somewhere.outcome) in {("refused", "settled"), ("undecided", "settled")}


def test_a_fold_is_one_of_the_mechanism() -> None:
    """p = q^2 - k has its fold at k = 0, where there is no 1/k."""
    assert sweep(family("q^2 - k*w*(k + 1)", "1", w="1/(k + 1)"), {"k": "-1/3..1:5"}).folds
    assert sweep(family("q^2 - k*w*k", "1", w="1/k"), {"k": "-1/3..1:5"}).folds == ()
