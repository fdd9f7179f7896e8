"""Lemmas Z and T of proofs/from_state.md, section 8: which terms vanish, whatever the Taylor coefficients are."""

from __future__ import annotations

import random
from dataclasses import replace

import pytest
from flint import arb, fmpq

from gspot_verified.expansion.from_state.affine_system import AffineSystem
from gspot_verified.expansion.from_state.analytic import Analytic, Polynomial
from gspot_verified.expansion.from_state.slow_manifold import Cut, SlowManifold, excess_terms, slow_manifold
from gspot_verified.expansion.series.regularisation import PAPER, Regularisation
from gspot_verified.functions.expressions import Constant, Expression, Variable
from gspot_verified.numbers.balls import ball, working_bits

P, B, Y, V = (Variable(i) for i in range(4))
CUT = Cut(3, fmpq(5), fmpq(83, 100))
OTHER = Regularisation.of(2, 3, "1/2")
MIDDLES = (
    ("-1", "1/3", "-2", "1/5", "1", "-1/2", "2", "1/3", "-1"),
    ("-7/6", "3/4", "1/2", "0", "-1/3", "1", "-1/2", "1", "3/2"),
    ("-1.4142", "-2", "5/3", "1/7", "2", "1/9", "3", "-2", "1/4"),
)
WIDTH = fmpq(1, 10**6)


def alpha(numbers: list[fmpq | arb]) -> Analytic:
    constants = [Constant(value) for value in numbers]
    terms: list[Expression] = [P, B, P * P, P * B, B * B, V, Y, P * V]
    function: Expression = constants[0]
    for value, term in zip(constants[1:], terms, strict=True):
        function = function + value * term
    return Analytic(function, 4, "f")


def exact_numbers(draw: random.Random | None) -> list[list[fmpq]]:
    """Coefficients in the balls; the middles without ``draw``."""
    shift = fmpq(0)
    rows = list[list[fmpq]]()
    for row in MIDDLES:
        rows.append([])
        for text in row:
            if draw is not None:
                shift = WIDTH * fmpq(draw.randint(-100, 100), 100)
            value = fmpq(int(float(text) * 10**4), 10**4) if "." in text else fmpq(*map(int, text.split("/")))
            rows[-1].append(value + shift)
    return rows


def system_of(rows: list[list[fmpq]], contact: Regularisation) -> AffineSystem:
    first, second, third = (alpha(list(row)) for row in rows)
    return AffineSystem(first, second, third, contact)


def in_balls(contact: Regularisation, width: fmpq = WIDTH) -> AffineSystem:
    with working_bits(256):
        first, second, third = (alpha([arb(value, width) for value in row]) for row in exact_numbers(None))
    return AffineSystem(first, second, third, contact)


def parts(manifold: SlowManifold) -> list[Polynomial]:
    own = [manifold.force, manifold.u, manifold.w, manifold.f, manifold.fall, manifold.back, manifold.faster]
    return [*own, *manifold.residual, manifold.drift, manifold.stray, manifold.slow]


@pytest.mark.parametrize("contact", [PAPER, OTHER])
def test_the_manifold_of_every_system_in_the_balls_is_held(contact: Regularisation) -> None:
    """Term by term; what is left out is 0 for each of them, where the iteration ends and all is exact."""
    draw = random.Random(3)
    with working_bits(256):
        wide = slow_manifold(in_balls(contact), CUT)
    assert any(not isinstance(value, fmpq) for value in excess_terms(wide.u).values())
    for number in range(12):
        system = system_of(exact_numbers(draw if number else None), contact)
        assert system.is_exact
        narrow = slow_manifold(system, CUT)
        for found, exact in zip(parts(wide), parts(narrow), strict=True):
            held, wanted = excess_terms(found), excess_terms(exact)
            assert wanted.keys() <= held.keys()
            for key, value in held.items():
                assert ball(value).contains(wanted.get(key, fmpq(0))), key


def test_coefficients_are_not_wider_than_their_balls_make_them() -> None:
    with working_bits(256):
        narrow = slow_manifold(in_balls(PAPER, fmpq(1, 10**60)), CUT)
        for one in parts(narrow):
            for value in excess_terms(one).values():
                assert isinstance(value, fmpq) or value.rad() < arb("1e-35") * (1 + abs(value))


@pytest.mark.parametrize(
    "cut", [CUT, Cut(4, fmpq(8), fmpq(83, 100)), Cut(2, fmpq(3), fmpq(5)), Cut(1, fmpq(1), fmpq(1, 9))]
)
def test_the_iteration_ends_in_time(cut: Cut) -> None:
    """So many rounds are enough for exact numbers, which are compared."""
    for contact in (PAPER, OTHER):
        slow_manifold(system_of(exact_numbers(None), contact), cut)


def test_rounds_are_those_of_the_lemma() -> None:
    assert CUT.rounds == 4 * (2 + 4)
    assert Cut(4, fmpq(8), fmpq(1)).rounds == 5 * 8
    assert Cut(1, fmpq(1), fmpq(1)).rounds == 2 * 5


def test_too_few_rounds_are_an_error(monkeypatch: pytest.MonkeyPatch) -> None:
    """What is left out must hold 0."""
    with working_bits(256):
        system = in_balls(PAPER, fmpq(1, 10**40))
        for rounds in (2, 5):
            monkeypatch.setattr(Cut, "rounds", rounds)
            with pytest.raises(ArithmeticError, match="should vanish"):
                slow_manifold(system, CUT)


def test_a_term_that_does_not_vanish_is_not_left_out() -> None:
    """Each residual that is not kept, if it were."""
    with working_bits(256):
        manifold = slow_manifold(in_balls(PAPER, fmpq(1, 10**40)), CUT)
        wider = replace(CUT, order=CUT.order + 1), replace(CUT, weight=CUT.weight + 2)
        for more in wider:
            for one in manifold.residual:
                with pytest.raises(ArithmeticError, match="should vanish"):
                    more.left(one, 1)
        assert CUT.left(manifold.residual[0], 1).to_dict().keys() == manifold.residual[0].to_dict().keys()


def test_an_exponent_that_meets_zero_is_refused() -> None:
    """beta in a ball with an integer."""
    rows = exact_numbers(None)
    rows[2][0] = fmpq(-2)
    with pytest.raises(ValueError, match="no integer"):
        AffineSystem(*(alpha([arb(value, WIDTH) for value in row]) for row in rows), PAPER)
