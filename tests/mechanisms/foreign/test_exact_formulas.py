"""Formulas of sympy and NumPy: exact, or refused by name."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import numpy as np
import pytest
import sympy
from flint import fmpq

from gspot_verified.mechanisms.foreign.exact_formulas import ExactFormulas
from gspot_verified.mechanisms.input.mechanism import MechanismError

x = sympy.Symbol("x")
HALF = sympy.Rational(1, 2)
READ = ExactFormulas("rod")


@pytest.mark.parametrize(
    "value",
    [HALF, "1/2", "0.5", Fraction(1, 2), fmpq(1, 2), np.array(HALF, dtype=object), np.array("1/2", dtype=object)],
)
def test_exact_numbers_of_any_kind(value: Any) -> None:
    assert READ(value, "x") == HALF


def test_whole_numbers_of_numpy_and_formulas() -> None:
    assert READ(np.int32(3), "x") == READ(np.array(3), "x") == 3
    assert READ(x / 2, "x") == x / 2
    assert READ(np.array([x], dtype=object)[0], "x") == x


@pytest.mark.parametrize("value", [0.5, np.float64(0.5), np.float32(0.5), np.array(0.5), sympy.Float("0.5"), x * 0.5])
def test_floats_are_refused_or_taken_as_decimals(value: Any) -> None:
    with pytest.raises(MechanismError, match=r"rod: here: not exact: the Float 0\.5: write Rational\('0\.5'\)"):
        READ(value, "here")
    taken = ExactFormulas("rod", rationalize=True)
    assert taken(value, "here") in (HALF, x / 2)
    assert taken.replaced == {"0.5": "1/2"}


def test_a_decimal_is_what_a_float_shows() -> None:
    taken = ExactFormulas("rod", rationalize=True)
    assert taken(0.1 * x + 1e-7, "x") == x / 10 + sympy.Rational(1, 10**7)
    assert taken(x**2.0, "x") == x**2
    assert taken(0.1 + 0.2, "x") == sympy.Rational("0.30000000000000004")


@pytest.mark.parametrize(
    ("value", "message"),
    [
        (None, "got NoneType"),
        (True, "got bool"),
        (1j, "got complex"),
        ("x", "'x'"),
        ([1], "one formula is needed|got list"),
        (np.array([1, 2]), "one formula is needed, got a ndarray"),
        (sympy.Matrix([x]), "one formula is needed"),
    ],
)
def test_what_is_no_formula_is_refused(value: Any, message: str) -> None:
    with pytest.raises(MechanismError, match=message):
        READ(value, "x")


def test_a_float_of_another_precision_is_refused() -> None:
    taken = ExactFormulas("rod", rationalize=True)
    for number in (sympy.Float("0.1", 30), sympy.Float("0.1", 5)):
        with pytest.raises(MechanismError, match="bits: of 53 bits is known"):
            taken(number, "x")


@pytest.mark.parametrize("values", [[1, x], (1, x), sympy.Matrix([1, x]), sympy.Matrix([[1, x]]),
                                    np.array([1, x], dtype=object), np.array([[1], [x]], dtype=object)])  # fmt: skip
def test_a_column_may_come_in_many_forms(values: Any) -> None:
    assert READ.vector(values, "force") == [1, x]


@pytest.mark.parametrize("values", [[[1], [x, 2]], [[1, x], [x]], sympy.ones(2, 2)])
def test_a_column_has_one_formula_a_row(values: Any) -> None:
    with pytest.raises(MechanismError, match="got list"):
        READ.vector(values, "force")


@pytest.mark.parametrize("values", [[[1, x], [x, 2]], ((1, x), (x, 2)), sympy.Matrix([[1, x], [x, 2]]),
                                    np.array([[1, x], [x, 2]], dtype=object)])  # fmt: skip
def test_a_matrix_may_come_in_many_forms(values: Any) -> None:
    assert READ.matrix(values, "mass matrix") == [[1, x], [x, 2]]


@pytest.mark.parametrize("values", ["ab", None, 3, {"a": 1}])
def test_what_is_no_list_is_refused(values: Any) -> None:
    with pytest.raises(MechanismError, match="a matrix, an array or a list is needed"):
        READ.vector(values, "force")


@pytest.mark.parametrize("values", [[1, 2], [[1, 2]], [[1], [2]], [[1, 2], [3]], ["ab", "cd"], sympy.ones(2, 3)])
def test_a_matrix_has_as_many_columns_as_rows(values: Any) -> None:
    with pytest.raises(MechanismError, match="as many columns as rows"):
        READ.matrix(values, "mass matrix")


def test_an_entry_is_named() -> None:
    with pytest.raises(MechanismError, match=r"mass matrix \(2, 1\): not exact"):
        READ.matrix([[1, 0], [0.5, 1]], "mass matrix")
    with pytest.raises(MechanismError, match="force 2: not exact"):
        READ.vector([1, 0.5], "force")
