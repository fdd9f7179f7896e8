"""Points against a statement: each lies in the ranges, and its sign is another one, by an exact or a second route."""

from __future__ import annotations

import pytest
from flint import fmpq
from hypothesis import given
from hypothesis import strategies as st
from samples.strategies import to_fmpq

from gspot_verified import Range, polynomial, theta_by
from gspot_verified.signs.cover.witness import find_witness, sign_at

ENDS = st.fractions(-4, 6, max_denominator=4)


@given(ENDS, ENDS, ENDS, ENDS, st.tuples(*[st.booleans()] * 4), st.sampled_from([1, -1]))
def test_a_witness_lies_in_both_ranges(t1, t2, b1, b2, closed, sign) -> None:  # type: ignore[no-untyped-def]
    ranges = []
    for (first, second), (left, right) in zip(((t1, t2), (b1, b2)), (closed[:2], closed[2:]), strict=True):
        lower, upper = sorted((first, second))
        point = lower == upper
        ranges.append(Range(to_fmpq(lower), to_fmpq(upper), left or point, right or point))
    found = find_witness(ranges[0], ranges[1], sign)
    if found is not None:
        assert ranges[0].contains(found[0])
        assert ranges[1].contains(found[1])
        assert sign_at(*found) not in (None, sign)


@pytest.mark.parametrize("beta", range(8))
@pytest.mark.parametrize("tau", [fmpq(-3), fmpq(0), fmpq(2), fmpq(7, 3)])
def test_signs_at_integers_are_those_of_the_polynomial(beta: int, tau: fmpq) -> None:
    """The derivative of the polynomial Theta(., beta)."""
    value = polynomial(beta).derivative()(tau)
    assert sign_at(tau, fmpq(beta)) == (value > 0) - (value < 0)


@pytest.mark.parametrize("beta", ["-1/2", "1/2", "5/2", "17/3"])
@pytest.mark.parametrize("tau", [-3, 0, 2, 5])
def test_signs_elsewhere_by_the_taylor_route(beta: str, tau: int) -> None:
    number = fmpq(*map(int, beta.split("/")))
    value = -number * theta_by("taylor", tau, number - 1, digits=30)
    assert sign_at(fmpq(tau), number) == (1 if value > 0 else -1)
    assert value != 0


def test_out_of_reach_no_sign_is_said() -> None:
    assert sign_at(fmpq(10) ** 13, fmpq(1, 2)) is None
    assert sign_at(fmpq(1), fmpq(10**5) + fmpq(1, 2)) is None
    assert sign_at(fmpq(1), -fmpq(10**5) - fmpq(1, 2)) is None
    assert sign_at(fmpq(1), fmpq(1, 3**3000)) is None
    assert sign_at(fmpq(1, 3**3000), fmpq(1, 2)) is None


@pytest.mark.parametrize(
    ("tau", "beta"),
    [
        (Range(fmpq(1), fmpq(2), True, True), Range(fmpq(1, 2), fmpq(3, 4), True, True)),
        (Range(fmpq(1), None, True, False), Range(fmpq(1, 2), fmpq(3, 4), True, True)),
        (Range(None, fmpq(-1), False, True), Range(fmpq(1, 2), fmpq(3, 4), True, True)),
        (Range(None, None, False, False), Range(fmpq(1, 2), fmpq(3, 4), True, True)),
    ],
)
def test_a_witness_is_found_where_the_sign_is_the_other_one(tau: Range, beta: Range) -> None:
    """dTheta/dtau < 0 for 0 < beta < 1."""
    found = find_witness(tau, beta, 1)
    assert found is not None
    assert tau.contains(found[0])
    assert beta.contains(found[1])
    assert sign_at(*found) == -1
    assert find_witness(tau, beta, -1) is None


def test_far_to_the_left_no_sign_is_said() -> None:
    assert sign_at(-(fmpq(10) ** 13), fmpq(1, 2)) is None
