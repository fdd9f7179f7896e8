"""Balls and polynomials cross a process as they are: midpoint and radius exactly, at any precision in force."""

from __future__ import annotations

import copy
import pickle
import subprocess
import sys

import pytest
from flint import acb, arb, arb_poly, fmpq, fmpq_mpoly_ctx, fmpq_poly, fmpz_poly
from hypothesis import given
from hypothesis import strategies as st

from gspot_verified.numbers import pickled
from gspot_verified.numbers.balls import working_bits
from gspot_verified.numbers.dyadic import Dyadic

Parts = tuple[tuple[int, int], tuple[int, int]]

_UNCOMMON = (2**30 - 1, 2**29 + 1, 2**29, 2**30 - 2, 1, 0)
"""Mantissas of a radius at the ends of its 30 bits."""


def parts(ball: arb) -> Parts:
    """Midpoint and radius of a finite ball as flint has them."""
    assert ball.is_finite()
    (m, e), (r, f) = ball.mid().man_exp(), ball.rad().man_exp()
    return (int(m), int(e)), (int(r), int(f))


def canonical(mantissa: int, exponent: int) -> tuple[int, int]:
    """The same number with an odd mantissa."""
    if mantissa == 0:
        return 0, 0
    zeros = (mantissa & -mantissa).bit_length() - 1
    return mantissa >> zeros, exponent + zeros


def again(value: object) -> object:
    return pickle.loads(pickle.dumps(value))


@st.composite
def computed_balls(draw: st.DrawFn) -> arb:
    """Balls as they come out of arithmetic; their radii have all 30 bits."""
    number = draw(st.fractions(min_value=-20, max_value=20))
    with working_bits(draw(st.integers(2, 400))):
        value = arb(fmpq(number.numerator, number.denominator))
        for _ in range(draw(st.integers(0, 3))):
            value = value.exp() / 3 - value
    return value


@given(computed_balls(), st.integers(2, 200), st.integers(2, 200))
def test_a_ball_comes_back_at_any_precision(ball: arb, before: int, after: int) -> None:
    if not ball.is_finite():
        return
    with working_bits(before):
        data = pickle.dumps(ball)
    with working_bits(after):
        assert parts(pickle.loads(data)) == parts(ball)
        assert parts(copy.copy(ball)) == parts(copy.deepcopy(ball)) == parts(ball)


exponents = st.integers(-(10**20), 10**20)


@given(st.integers(), exponents, st.one_of(st.sampled_from(_UNCOMMON), st.integers(0, 2**30 - 1)), exponents)
def test_every_midpoint_and_radius(middle: int, exponent: int, radius: int, scale: int) -> None:
    wanted = canonical(middle, exponent), canonical(radius, scale)
    assert parts(pickled.ball_of_parts(*wanted)) == wanted
    assert parts(again(pickled.ball_of_parts(*wanted))) == wanted  # type: ignore[arg-type]


def test_arithmetic_makes_radii_that_flint_does_not_take_as_they_are() -> None:
    """Without this the property above would hold for a plain constructor too."""
    lengths = set()
    with working_bits(60):
        for n in range(1, 200):
            value = (arb(n) / 7).exp() * arb(fmpq(1, n))
            middle, radius = parts(value)
            lengths.add(radius[0].bit_length())
            if radius[0].bit_length() == 30:
                assert parts(arb(middle, radius)) != (middle, radius)
                assert parts(again(value)) == (middle, radius)  # type: ignore[arg-type]
    assert 30 in lengths


@pytest.mark.parametrize(
    "ball",
    [arb("nan"), arb.nan(), arb("inf"), arb("-inf"), arb("inf") + arb(0, 1), arb("-inf") + arb(0, fmpq(1, 3)),
     arb(0, arb("inf")), arb(fmpq(1, 3)) + arb(0, arb("inf"))],
)  # fmt: skip
def test_balls_that_are_not_finite(ball: arb) -> None:
    found = again(ball)
    assert isinstance(found, arb)
    assert [str(found.mid()), str(found.rad())] == [str(ball.mid()), str(ball.rad())]
    assert (found.is_nan(), found > 0, found < 0) == (ball.is_nan(), ball > 0, ball < 0)


@pytest.mark.parametrize("lowered", [arb(0), arb(1), arb((2**29, -1)), arb(2**40), None])
def test_another_flint_would_give_a_wider_ball(monkeypatch: pytest.MonkeyPatch, lowered: arb | None) -> None:
    """If a radius were taken in another way, nothing would be lost from the ball."""
    monkeypatch.setattr(pickled, "_lowered", lambda *_: lowered)
    found = pickled.ball_of_parts((3, -1), (2**30 - 1, -30))
    assert Dyadic.from_ball(found).contains_interval(Dyadic(3 * 2**29 - 2**30 + 1, 3 * 2**29 + 2**30 - 1, -30))


def test_polynomials_and_complex_balls() -> None:
    third = arb(fmpq(1, 3))
    context = fmpq_mpoly_ctx.get(("chi", "a"), "lex")
    chi, a = context.gens()
    for exact in (fmpq_poly([1, fmpq(2, 3)]), fmpq_poly([]), fmpz_poly([0, 5]), (chi + a * fmpq(2, 3)) ** 3, chi - chi):
        found = again(exact)
        assert found == exact
        assert type(found) is type(exact)
    assert again(context) is context
    complex_ball = again(acb(third, -third))
    assert isinstance(complex_ball, acb)
    assert [parts(complex_ball.real), parts(complex_ball.imag)] == [parts(third), parts(-third)]
    polynomial = again(arb_poly([third, 0, -third]))
    assert isinstance(polynomial, arb_poly)
    assert [*map(parts, polynomial.coeffs())] == [parts(third), parts(arb(0)), parts(-third)]


POOL = """
import multiprocessing, sys
from gspot_verified import evaluate, theta
from gspot_verified.numbers.dyadic import Dyadic

points = [(-2, "7/3"), (0, "1/2"), ("1/3", 2)]
with multiprocessing.get_context(sys.argv[1]).Pool(1) as pool:
    there = pool.starmap(theta, points), pool.starmap(evaluate, points)
assert [*map(Dyadic.from_ball, there[0])] == [Dyadic.from_ball(theta(*point)) for point in points]
assert [result.to_json() for result in there[1]] == [evaluate(*point).to_json() for point in points]
print("as here")
"""


@pytest.mark.parametrize("method", ["fork", pytest.param("spawn", marks=pytest.mark.slow)])
def test_a_pool_of_processes(method: str) -> None:
    """In a process of its own: this one may have threads, which a fork does not take along."""
    run = subprocess.run([sys.executable, "-c", POOL, method], capture_output=True, text=True, check=False, timeout=100)
    assert (run.stdout, run.returncode) == ("as here\n", 0), run.stderr
