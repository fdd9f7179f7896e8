"""The mass matrix at the G-spot: positive definite, singular there, not certain; and fields without one."""

from __future__ import annotations

from typing import Any

import pytest
from flint import arb, fmpq, fmpz_mat
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from gspot_verified.functions.rings import BALLS, RATIONALS
from gspot_verified.mechanisms.derive.mass_matrix import check_mass_matrix, leading_minors
from gspot_verified.mechanisms.derive.to_system import shift
from gspot_verified.mechanisms.input.given import from_fields, lagrangian
from gspot_verified.mechanisms.input.mechanism import MechanismError
from gspot_verified.mechanisms.shipped import shipped_mechanism
from gspot_verified.numbers.balls import working_bits

HERE = {"X": fmpq(0), "Y": fmpq(1, 2), "X_dot": fmpq(0), "Y_dot": fmpq(0)}


def block(matrix: list[list[Any]], mu: Any = 1) -> Any:
    return shift(lagrangian("block", ["X", "Y"], matrix, [0, 0], "X", "Y", mu))


@pytest.mark.parametrize("matrix", [[[1, 0], [0, 1]], [[2, "X"], ["X", "Y"]], [[1, "Y"], ["Y", 1]]])
def test_positive_definite(matrix: list[list[Any]]) -> None:
    check_mass_matrix(block(matrix), HERE, RATIONALS)


@pytest.mark.parametrize(
    ("matrix", "part"),
    [
        ([["X", 0], [0, 1]], "size 1 is 0"),
        ([[1, 0], [0, "X"]], "size 2 is 0"),
        ([[1, "2*Y"], ["2*Y", 1]], "size 2 is 0"),
        ([[1, "3*Y"], ["3*Y", 1]], "size 2 is -5/4"),
        ([["X - 1", 0], [0, -1]], "size 1 is -1"),
    ],
)
def test_not_positive_definite(matrix: list[list[Any]], part: str) -> None:
    with pytest.raises(MechanismError, match=f"not positive definite at the G-spot: its leading minor of {part}"):
        check_mass_matrix(block(matrix), HERE, RATIONALS)


def test_a_ball_that_leaves_it_open_is_refused() -> None:
    with working_bits(80):
        around = {name: arb(value) for name, value in HERE.items()} | {"X": arb("0.001", "0.01")}
        with pytest.raises(MechanismError, match="size 1"):
            check_mass_matrix(block([["X", 0], [0, 1]]), around, BALLS)
        check_mass_matrix(block([["X", 0], [0, 1]]), around | {"X": arb("0.1", "0.01")}, BALLS)


def test_fields_need_positive_a_and_c() -> None:
    shifted = shift(shipped_mechanism("extended"))
    at = dict.fromkeys(shifted.mechanism.state, fmpq(0))
    check_mass_matrix(shifted, at, RATIONALS)
    with pytest.raises(MechanismError, match="A = L_GT u must be positive, it is -3/2"):
        check_mass_matrix(shifted, at | {"p": fmpq(2)}, RATIONALS)
    with pytest.raises(MechanismError, match="C = L_GN v must be positive, it is -1"):
        check_mass_matrix(shifted, at | {"p": fmpq(-3)}, RATIONALS)


def test_fields_need_a_positive_determinant() -> None:
    """A = 2, C = 3: B^2 must stay below 6."""

    def with_coupling(b: Any) -> Any:
        return shift(
            from_fields("fields", "xuyv", ["u", 0, "v", 0], [0, 2, 0, b], [0, b, 0, 3], "x", "y", 1)
        )  # fmt: skip

    at = dict.fromkeys("xuyv", fmpq(0))
    for coupling in (0, 2, -2, "12/5"):
        check_mass_matrix(with_coupling(coupling), at, RATIONALS)
    for coupling, value in (("5/2", "-1/4"), (-3, "-3"), ("3", "-3")):
        with pytest.raises(MechanismError, match=f"A C - B\\^2 must be positive, it is {value}"):
            check_mass_matrix(with_coupling(coupling), at, RATIONALS)


IDENTITY = [[1, 0], [0, 1]]


@pytest.mark.parametrize("mu", ["X", "X + 1/2", "Y - 1/2", 0])
def test_friction_that_is_not_negative(mu: Any) -> None:
    check_mass_matrix(block(IDENTITY, mu), HERE, RATIONALS)
    with working_bits(80):
        check_mass_matrix(block(IDENTITY, mu), {name: arb(value) for name, value in HERE.items()}, BALLS)


def test_negative_friction_is_refused() -> None:
    with pytest.raises(MechanismError, match="friction coefficient mu must not be negative at the G-spot, it is -1/2"):
        check_mass_matrix(block(IDENTITY, "X - Y"), HERE, RATIONALS)


@pytest.mark.parametrize(
    ("middle", "radius", "shown"),
    [("-0.1", "1e-9", r"\[-0\.1\d* \+/- .*\]$"), ("0.001", "0.01", r"\[-0\.\d*, 0\.\d*\]$")],
)
def test_friction_that_is_not_certain_is_refused(middle: str, radius: str, shown: str) -> None:
    """A ball on both sides of 0 has not been shown to be a friction coefficient."""
    with working_bits(80):
        around = {name: arb(value) for name, value in HERE.items()} | {"X": arb(middle, radius)}
        with pytest.raises(MechanismError, match=f"mu must not be negative at the G-spot, it is {shown}"):
            check_mass_matrix(block(IDENTITY, "X"), around, BALLS)


@settings(max_examples=40)
@given(st.integers(1, 5).flatmap(lambda n: st.lists(st.integers(-9, 9), min_size=n * n, max_size=n * n)))
def test_leading_minors_are_determinants(entries: list[int]) -> None:
    size = round(len(entries) ** 0.5)
    rows = [entries[i * size : (i + 1) * size] for i in range(size)]
    expected = [fmpz_mat([row[:n] for row in rows[:n]]).det() for n in range(1, size + 1)]
    assume(all(minor != 0 for minor in expected[:-1]))
    assert list(leading_minors([list(map(fmpq, row)) for row in rows])) == expected


def test_three_coordinates_that_are_coupled_in_pairs() -> None:
    """[[2, 1, c], [1, 2, c], [c, c, 1]] has the determinant 3 - 2 c^2: definite up to c^2 = 3/2."""
    for coupling, value in (("6/5", fmpq(3, 25)), ("5/4", fmpq(-1, 8))):
        rows = [[2, 1, coupling], [1, 2, coupling], [coupling, coupling, 1]]
        shifted = shift(lagrangian("three", ["X", "Y", "Z"], rows, [0, 0, 0], "X", "Y", 1))
        at = dict.fromkeys(shifted.mechanism.state, fmpq(0))
        if value > 0:
            check_mass_matrix(shifted, at, RATIONALS)
        else:
            with pytest.raises(MechanismError, match=f"its leading minor of size 3 is {value}"):
                check_mass_matrix(shifted, at, RATIONALS)
