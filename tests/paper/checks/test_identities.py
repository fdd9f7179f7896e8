"""Polynomials in named symbols, and what a claim answers: its formulas leave something, nothing, or are not asked."""

from __future__ import annotations

import pytest
from flint import fmpq_mat, fmpq_mpoly
from hypothesis import given
from hypothesis import strategies as st

from gspot_verified.paper.checks.identities import Algebra, Claim, Parts, readable, rising_signs


def test_a_claim_that_checks_nothing_is_open() -> None:
    claim = Claim(Algebra("x"), {"f": "x"})
    assert claim.check("nothing", lambda _: []).agrees is None
    assert claim.check("zero", lambda parts: [parts["f"] - parts["f"]]).agrees is True
    assert claim.check("not zero", lambda parts: [parts["f"]]).agrees is False
    wrong = Claim(Algebra("x"), {"f": "x"}, {"f": "2*x"})
    assert wrong.check("the corrected form fails too", lambda parts: [parts["f"]]).agrees is None


def test_the_finding_says_what_is_left_and_whether_the_corrected_form_holds() -> None:
    def whole(parts: Parts) -> list[fmpq_mpoly]:
        return [parts["f"]]

    printed, mended = Claim(Algebra("x"), {"f": "x"}), Claim(Algebra("x"), {"f": "x"}, {"f": "0*x"})
    assert printed.check("printed", whole).finding == "the printed form leaves x instead of 0"
    assert mended.check("mended", whole).finding == f"{printed.check('a', whole).finding}; the corrected form gives 0"
    assert printed.check("a", whole, fault="{left} is missing").finding == "x is missing"
    assert mended.check("a", whole, fault="{left} is missing").finding == "x is missing"
    assert mended.check("a", whole, fault="{left} is missing").agrees is False
    assert printed.check("a", lambda parts: [parts["f"] - parts["f"]], fault="a fault").finding == ""
    open_check = Claim(Algebra("x"), {"f": "x"}, {"f": "2*x"}).check("open", whole)
    assert open_check.finding == "printed: x; corrected: 2*x"


@pytest.mark.parametrize(("length", "whole"), [(159, True), (160, True), (161, False), (162, False)])
def test_a_long_polynomial_is_cut(length: int, whole: bool) -> None:
    text = f"{'x' * (length - 2)}^2"
    value = Algebra(text[:-2]).read(text)
    assert readable(value) == (text if whole else f"{text[:150]} ... (1 terms)")


def test_the_algebra() -> None:
    algebra = Algebra("s k b0 b1 b2")
    total = algebra.jets("s", "b")
    assert algebra.derivative(algebra.read("s*b0"), total, 2) == algebra.read("s*b2 + 2*b1")
    assert algebra.coefficient_of(algebra.read("s^2*k + 3*s^2 + k"), "s", 2) == algebra.read("k+3")
    assert algebra.determinant(
        [[algebra.read("s"), algebra.read("k")], [algebra.read("1+0*s"), algebra.read("s")]]
    ) == (algebra.read("s^2-k"))
    moved = algebra.replaced(
        algebra.read("s*b0 + k*b1 + 7"), "b", [algebra.read("k"), algebra.read("s")], algebra.read("s")
    )
    assert moved == algebra.read("2*s*k + 7*s")
    assert rising_signs(algebra.read("s + 2*k"))
    assert not rising_signs(algebra.read("s - 2*k"))
    assert not rising_signs(algebra.constant(0))
    long = sum((algebra.read("s+k") ** n for n in range(12)), start=algebra.constant(0))
    assert readable(long).endswith("terms)")
    assert readable(Algebra("alpha1 lam lambda0").read("alpha1*lam + lambda0")) == "α_1*λ + lambda0"


@given(st.integers(0, 4).flatmap(lambda size: st.lists(st.integers(-9, 9), min_size=size**2, max_size=size**2)))
def test_a_determinant_is_that_of_the_matrix(numbers: list[int]) -> None:
    algebra, size = Algebra("x"), int(len(numbers) ** 0.5)
    rows = [[algebra.constant(value) for value in numbers[i * size : (i + 1) * size]] for i in range(size)]
    assert algebra.determinant(rows) == algebra.constant(fmpq_mat(size, size, numbers).det())


def test_a_derivation_is_applied_once_unless_more_is_asked_for() -> None:
    algebra = Algebra("x y")
    images = {"x": algebra.read("y"), "y": algebra.read("x^2")}
    value = algebra.read("x*y")
    once = algebra.read("y^2 + x^3")
    assert algebra.derivative(value, images) == once
    assert algebra.derivative(value, images, 0) == value
    assert algebra.derivative(value, images, 2) == algebra.derivative(once, images) == algebra.read("5*x^2*y")


def test_jets_lead_from_each_derivative_to_the_next_and_end_with_the_symbols() -> None:
    algebra = Algebra("t f0 f1 f2 g0")
    images = {"t": "1+0*t", "f0": "f1", "f1": "f2"}
    assert algebra.jets("t", "f", "g") == {name: algebra.read(text) for name, text in images.items()}


def test_coefficients_keep_the_other_symbols_where_they_are() -> None:
    algebra = Algebra("x y z")
    found = algebra.coefficients(algebra.read("x*z + 2*y^2*z^3 + 5*y^2*x + 7"), "y")
    assert found == {0: algebra.read("x*z + 7"), 2: algebra.read("2*z^3 + 5*x")}
    assert algebra.coefficients(algebra.read("x*z + 3*x^2"), "z") == {0: algebra.read("3*x^2"), 1: algebra.read("x")}
    assert algebra.coefficient_of(algebra.read("x*z"), "y", 1).is_zero()


def test_all_coefficients_must_be_positive() -> None:
    algebra = Algebra("x y")
    assert rising_signs(algebra.read("2*x + y^2 + 1"))
    assert not rising_signs(algebra.read("2*x - y^2 + 1"))
