"""Sums over products for every n: both routes agree with the sums written out, on right and on wrong formulas."""

from __future__ import annotations

from itertools import product

import pytest

from gspot_verified.paper.checks.convolution import NAMES, all_pairs, product_of_geometric_series
from gspot_verified.paper.checks.identities import Algebra
from gspot_verified.paper.checks.leading_order import is_dominated

ALGEBRA = Algebra("n k other")


def holds_for_small_n(texts: tuple[str, str, str, str], least: int) -> bool:
    """The pairs of indices written out for n = 0, ..., 6, each once."""
    for n in range(7):
        left, right, first, last = (compile(text, "index", "eval") for text in texts)
        ks = range(eval(first, {"n": n}), eval(last, {"n": n}) + 1)
        pairs = sorted((eval(left, {"n": n, "k": k}), eval(right, {"n": n, "k": k})) for k in ks)
        if pairs != sorted((i, n - i) for i in range(least, n + 1)):
            return False
    return True


@pytest.mark.parametrize("least", [0, 1])
@pytest.mark.parametrize(
    "texts",
    [
        *product(("n - k", "n - k + 1", "k"), ("k", "n", "n - k", "k + 1"), ("0", "1"), ("n - 1", "n", "n + 1")),
    ],
)
def test_both_routes_say_what_the_written_out_sums_say(texts: tuple[str, str, str, str], least: int) -> None:
    of = {name: ALGEBRA.read(text + " + 0*n") for name, text in zip(NAMES, texts, strict=True)}
    holds = holds_for_small_n(texts, least)
    geometric = all(value.is_zero() for value in product_of_geometric_series(ALGEBRA, of, least))
    assert geometric is holds
    # The route by pairs asks for j = k besides: it refuses the sum in the opposite order.
    pairs = all(value.is_zero() for value in all_pairs(ALGEBRA, of, least))
    assert pairs is (holds and texts[1] == "k")


@pytest.mark.parametrize(
    "texts",
    [
        ("n", "0*k", "0*k", "n"),  # one product, n + 1 times
        ("n - k", "k", "0*k", "n*k"),
        ("n - k", "k", "0*k", "n + 40"),
        ("n - k", "-40*k", "0*k", "n"),
        ("-40*k", "k", "0*k", "n"),
        ("n - k", "k", "k", "n"),
        ("n - k", "0*k", "0*k", "n"),  # k in one index alone
        ("0*k", "n - k", "0*k", "n"),
    ],
)
def test_other_sums_are_refused_by_geometric_series(texts: tuple[str, str, str, str]) -> None:
    of = {name: ALGEBRA.read(text) for name, text in zip(NAMES, texts, strict=True)}
    assert not all(value.is_zero() for value in product_of_geometric_series(ALGEBRA, of, 0))


@pytest.mark.parametrize("wrong", ["n*k", "other", "n/2 - k", "k^2", "9*k"])
def test_an_index_that_is_no_integer_line_is_refused(wrong: str) -> None:
    of = {name: ALGEBRA.read(text) for name, text in zip(NAMES, (wrong, "k", "0*k", "n"), strict=True)}
    assert not all(value.is_zero() for value in product_of_geometric_series(ALGEBRA, of, 0))
    assert not all(value.is_zero() for value in all_pairs(ALGEBRA, of, 0))


@pytest.mark.parametrize("unit", [1, 2])
def test_dominated_monomials_are_smaller_for_every_exponent(unit: int) -> None:
    for a, b, c in product(range(5), range(1, 4), range(3)):
        orders = [a + unit * (r - 1) * b - c - unit * (r - 1) for r in (1e-9, 0.1, 0.5, 1, 2, 9, 1e6)]
        assert is_dominated(a, b, c, unit) is all(order > 1e-12 for order in orders)


def test_a_monomial_without_t_is_not_dominated() -> None:
    """Beside w^c T the monomial w^a alone is larger for large r, as T is then a high power of w."""
    assert not any(is_dominated(a, 0, 1) for a in range(5))
    assert not is_dominated(1, 1, 1)
    assert is_dominated(3, 2, 1, unit=2)
    assert not is_dominated(2, 2, 1, unit=2)
