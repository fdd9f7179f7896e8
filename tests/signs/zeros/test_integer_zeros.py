"""Zeros at integer beta against exact polynomials, the count law and the zeros at neighbouring beta."""

from __future__ import annotations

import pytest
from flint import fmpq

from gspot_verified.signs.gamma.count_law import number_of_zeros
from gspot_verified.signs.zeros.brackets import zeros_at
from gspot_verified.signs.zeros.integer_zeros import _refine, zeros_at_integer
from gspot_verified.theta_function.value.integer import polynomial


@pytest.mark.parametrize("beta", [*range(1, 16), 30, 61])
def test_brackets_change_sign_and_zero_has_its_multiplicity(beta: int) -> None:
    found = zeros_at_integer(beta, 12)
    values = polynomial(beta - 1)
    assert len(found.brackets) + bool(found.multiplicity_at_zero) == number_of_zeros(beta)
    coefficients = values.coeffs()
    assert all(c == 0 for c in coefficients[: found.multiplicity_at_zero])
    assert coefficients[found.multiplicity_at_zero] != 0
    for lower, upper in found.brackets:
        assert 0 < lower <= upper <= lower + fmpq(1, 10**12)
        assert values(lower) * values(upper) < 0 or values(lower) == 0 == upper - lower
    assert list(found.brackets) == sorted(found.brackets)


@pytest.mark.parametrize("digits", [1, 2])
def test_few_digits_where_the_grid_is_wider_than_what_isolates_the_zero(digits: int) -> None:
    for beta in range(1, 61):
        values = polynomial(beta - 1)
        brackets = zeros_at_integer(beta, digits).brackets
        assert len(brackets) + (values(0) == 0) == number_of_zeros(beta)
        for lower, upper in brackets:
            assert upper - lower <= fmpq(1, 10**digits)
            assert values(lower) * values(upper) < 0 or values(lower) == 0 == upper - lower


def test_cubes_are_known() -> None:
    # dTheta/dtau(., 4) = -4 (2 - tau^3), dTheta/dtau(., 5) = -5 tau (tau^3 - 8)
    ((lower, upper),) = zeros_at_integer(4, 20).brackets
    assert lower**3 < 2 < upper**3
    assert zeros_at_integer(5, 3).brackets == ((fmpq(2), fmpq(2)),)


def test_neighbouring_beta_have_neighbouring_zeros() -> None:
    ((lower, upper),) = zeros_at_integer(6, 6).brackets
    near = zeros_at(fmpq(6) + fmpq(1, 10**9), 6).brackets
    assert any(abs(a - lower) < fmpq(1, 10**5) and abs(b - upper) < fmpq(1, 10**5) for a, b in near)


@pytest.mark.parametrize(("lower", "upper"), [(fmpq(21, 10), fmpq(5, 2)), (fmpq(5, 2), fmpq(29, 10))])
def test_a_cell_of_the_grid_with_two_zeros_is_not_taken(lower: fmpq, upper: fmpq) -> None:
    """beta = 150: 2.190... and 2.894... are zeros. The cell (2, 3) of 0 decimals has one sign at both ends."""
    values = polynomial(149)
    assert values(lower) * values(upper) < 0 < values(fmpq(2)) * values(fmpq(3))
    assert _refine(150, lower, upper, 0) == (lower, upper)
    left, right = _refine(150, lower, upper, 1)
    assert lower <= left < right <= upper
    assert right - left == fmpq(1, 10)


@pytest.mark.parametrize(("beta", "digits"), [(0, 5), (-1, 5), (201, 5), (True, 5), ("3", 5), (3, 0), (3, 1.0)])
def test_bad_input(beta: object, digits: object) -> None:
    with pytest.raises(ValueError, match=r"beta|digits"):
        zeros_at_integer(beta, digits)  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("beta", "known"),
    [(-3, "none \\(dΘ/dτ > 0\\)"), (0, "at beta = 0 dΘ/dτ is 0 everywhere"), (201, "201$")],
)
def test_beyond_the_range_the_message_says_what_is_known(beta: int, known: str) -> None:
    with pytest.raises(ValueError, match="the real zeros are sought for 0 < beta <= 200, got .*" + known):
        zeros_at_integer(beta)


def test_text_and_json_count_zero_once() -> None:
    for beta, number in ((4, 1), (6, 2), (2, 1), (1, 0)):
        found = zeros_at_integer(beta, 5)
        assert found.to_json()["number"] == number == number_of_zeros(beta)
        words = "one real zero" if number == 1 else f"{number} real zeros"
        assert str(found).startswith(f"β = {beta}: {words} of the polynomial dΘ/dτ")
        assert ("of multiplicity" in str(found)) == (found.multiplicity_at_zero > 0)


def test_digits_when_nothing_is_said_and_the_most_of_them() -> None:
    ((lower, upper),) = zeros_at_integer(4).brackets
    assert upper - lower == fmpq(1, 10**15)
    ((lower, upper),) = zeros_at_integer(4, 2000).brackets
    assert upper - lower == fmpq(1, 10**2000)
    assert lower**3 < 2 < upper**3


def test_zeros_that_no_step_separates_are_an_error(monkeypatch: pytest.MonkeyPatch) -> None:
    """As many brackets as the law counts, or none."""
    monkeypatch.setattr("gspot_verified.signs.zeros.integer_zeros.positive_zeros", lambda _: 2)
    with pytest.raises(ArithmeticError, match="not separated"):
        zeros_at_integer(4)
