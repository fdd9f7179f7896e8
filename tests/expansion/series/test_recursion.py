"""Theorem 1's recursion: the paper's printed example, the hypotheses, balls and symbols.

Page: proofs/expansion.md.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest
from flint import arb, fmpq

from gspot_verified.expansion.series.recursion import ObstructedOrderError, Recursion
from gspot_verified.expansion.series.system import GSpotError, System
from gspot_verified.functions.expressions import Constant, Power, Variable
from gspot_verified.functions.rings import BALLS
from gspot_verified.functions.symbols import Symbols
from gspot_verified.testing import extended_example


def printed(chi: Any) -> dict[str, list[list[Any]]]:
    """The paper's example (Sec. 5, alpha = (-1, -1, -3/2)): the coefficients of s^0, s^1, ... for each order.

    As printed, except that the paper has O(delta^8) after b where there is a term of order 7.
    """
    c2, c3 = chi * chi, chi * chi * chi
    q = fmpq
    return {
        "p": [[0, -1], [], [0, 0, chi], [], [0, 0, 0, 2 * c2], [], [0, -96 * c3, 0, 0, 3 * c3], []],
        "b": [
            [0, 2], [], [0, 0, 6 * chi], [], [-96 * c2, 0, 0, 12 * c2], [],
            [0, q(-10368, 5) * c3, 0, 0, q(138, 5) * c3],
        ],
        "y": [
            [-4], [], [0, -16 * chi], [8 * chi], [0, 0, -48 * c2], [0, 48 * c2],
            [q(13824, 5) * c3 - 48 * c2, 0, 0, q(-736, 5) * c3],
        ],
        "v": [[], [], [-16 * chi], [], [0, -96 * c2], [48 * c2], [0, 0, q(-2208, 5) * c3]],
        "z": [
            [-2], [], [0, -8 * chi], [8 * chi], [0, 0, -24 * c2], [0, 48 * c2],
            [q(6912, 5) * c3 - 48 * c2, 0, 0, q(-368, 5) * c3],
        ],
    }  # fmt: skip


def test_b_has_a_term_that_the_printed_remainder_hides() -> None:
    """b_7 = 2208/5 chi^3: b(0) = epsilon^2 y''(0) for p(0) = 0, so the remainder after delta^6 is O(delta^7)."""
    for chi in (fmpq(1), fmpq(-5, 7)):
        recursion = terms_of(extended_example(chi), 8)
        assert recursion.b[7].coefficients() == [fmpq(2208, 5) * chi**3]
        assert recursion.b[7].at_zero() == recursion.v[7].derivative().at_zero()


def terms_of(system: System, orders: int) -> Recursion:
    recursion = Recursion(system)
    for _ in range(orders):
        recursion.advance()
    return recursion


@pytest.mark.parametrize("chi", [fmpq(1), fmpq(2), fmpq(3), fmpq(-5, 7)])
def test_the_printed_example(chi: fmpq) -> None:
    recursion = terms_of(extended_example(chi), 8)
    for name, orders in printed(chi).items():
        for n, expected in enumerate(orders):
            assert getattr(recursion, name)[n].coefficients() == expected, (name, n)


def with_symbols(ring: Symbols, chi: Any, alpha: tuple[Any, Any, Any]) -> System:
    base = extended_example(1)
    first, second, third = (Constant(value) for value in alpha)
    slope = first + Constant(chi) * Variable(5)
    return replace(
        base,
        F=(*base.F[:4], slope, second),
        G=(*base.G[:5], Constant(ring.number(-1)) * third),
        alpha_1=slope,
        alpha_2=second,
        alpha_3=third,
        point=tuple(ring.number(0) for _ in range(6)),
        ring=ring,
    )


def test_the_printed_example_for_every_chi() -> None:
    ring = Symbols("chi")
    chi = ring.symbol("chi")
    recursion = terms_of(with_symbols(ring, chi, tuple(ring.number(fmpq(v, 2)) for v in (-2, -2, -3))), 8)
    for value in (fmpq(1), fmpq(-4, 3)):
        for name, orders in printed(value).items():
            for n, expected in enumerate(orders):
                found = [c.numerator(value) / c.denominator(value) for c in getattr(recursion, name)[n].coefficients()]
                assert found == expected, (name, n)


def test_the_first_terms_for_every_alpha() -> None:
    """p_0 = alpha_1 s, b_0 = alpha_1 alpha_2/(alpha_1 - alpha_3) s, lambda_0 = (alpha_2 - b_0')/alpha_3."""
    ring = Symbols("a1", "a2", "a3")
    a1, a2, a3 = (ring.symbol(name) for name in ("a1", "a2", "a3"))
    recursion = terms_of(with_symbols(ring, ring.number(0), (a1, a2, a3)), 8)
    slope = a1 * a2 / (a1 - a3)
    force = (a2 - slope) / a3
    assert recursion.p[0].coefficients() == [0, a1]
    assert recursion.b[0].coefficients() == [0, slope]
    assert recursion.lambda_n[0].coefficients() == [force]
    assert recursion.z[0].coefficients() == [-force]
    assert recursion.y[0].coefficients() == [force * ring.number(-2)]
    for name in ("p", "b", "y", "v", "z", "lambda_n"):
        first = 0 if name == "v" else 1
        assert all(term.is_zero() for term in getattr(recursion, name)[first:])


@pytest.mark.parametrize("chi", [0, 1])
@pytest.mark.parametrize("beta", range(1, 6))
def test_an_integer_beta_is_obstructed(beta: int, chi: int) -> None:
    """Also where the right side vanishes (chi = 0, beta > 1): then the coefficient is free."""
    recursion = Recursion(extended_example(chi, alpha=(-1, -1, -beta)))
    order = 2 * (beta - 1)
    for _ in range(order):
        recursion.advance()
    with pytest.raises(ObstructedOrderError, match=rf"integer {beta}: .* s\^{beta} at order {order} of delta"):
        recursion.advance()


@pytest.mark.parametrize(
    ("alpha", "message"),
    [
        ((0, -1, -1), "alpha_1 = 0 must be negative"),
        ((1, -1, -1), "alpha_1 = 1 must"),
        ((-1, -1, 0), "alpha_3 = 0"),
        ((-1, -1, "1/2"), "alpha_3 = 1/2"),
    ],
)
def test_signs_of_alpha(alpha: tuple[int | str, int | str, int | str], message: str) -> None:
    with pytest.raises(GSpotError, match=message):
        Recursion(extended_example(1, alpha))


def test_a_point_that_is_no_g_spot() -> None:
    base = extended_example(1)
    with pytest.raises(GSpotError, match="not a G-spot: p = 1/9 does not vanish"):
        Recursion(replace(base, point=(*base.point[:4], fmpq(1, 9), fmpq(0))))
    with pytest.raises(GSpotError, match="J_2 = 3"):
        Recursion(replace(base, point=(fmpq(0), fmpq(3), *base.point[2:])))


def test_a_singular_jacobian() -> None:
    base = extended_example(1)
    for condition in (base.J[1], Variable(4), Power(Variable(1), fmpq(2)), Constant(fmpq(0))):
        system = replace(base, J=(Variable(0) if condition != Variable(1) else Variable(1), condition))
        with pytest.raises(GSpotError, match="singular"):
            Recursion(system)


def test_lengths() -> None:
    base = extended_example(1)
    with pytest.raises(ValueError, match="m - 4"):
        replace(base, J=(Variable(0),))
    with pytest.raises(ValueError, match="one length"):
        replace(base, F=base.F[:5])


def test_balls_enclose_the_rational_terms() -> None:
    chi = fmpq(3, 7)
    base = extended_example(chi)
    balls = terms_of(replace(base, point=(arb(0),) * 6, ring=BALLS), 14)
    exact = terms_of(base, 14)
    for name in ("p", "b", "y", "v", "z", "lambda_n"):
        for ball, term in zip(getattr(balls, name), getattr(exact, name), strict=True):
            found, wanted = ball.coefficients(), term.coefficients()
            assert len(found) == len(wanted)
            for value, number in zip(found, wanted, strict=True):
                assert value.is_finite()
                assert (value * int(number.q)).contains(int(number.p))


def test_balls_with_a_beta_that_may_be_an_integer() -> None:
    base = extended_example(1)
    third = Constant(arb(-2, fmpq(1, 100)))
    system = replace(base, alpha_3=third, G=(*base.G[:5], -third), point=(arb(0),) * 6, ring=BALLS)
    with pytest.raises(ObstructedOrderError, match="may be, the integer 2"):
        terms_of(system, 4)
