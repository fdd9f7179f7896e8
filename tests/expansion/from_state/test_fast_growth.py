"""Lemma 1 of proofs/from_state.md: its matrices by dual numbers in exact fractions, and what it must refuse."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest
from flint import arb, fmpq, fmpq_mpoly
from hypothesis import given, settings
from hypothesis import strategies as st
from samples.strategies import to_fmpq
from witnesses.slow_deviation import Dual, at, rates

from gspot_verified.expansion.from_state.fast_growth import (
    Growth,
    Norm,
    Rectangle,
    _Chart,
    fast_growth,
    fast_matrix,
    surplus,
)
from gspot_verified.expansion.from_state.slow_series import RING, Contact, H, R, slow_series, terms_of
from gspot_verified.expansion.series.regularisation import PAPER, Regularisation
from gspot_verified.numbers.balls import ball, working_bits

BITS = 128
NUMBERS = st.fractions(min_value=Fraction(1, 4), max_value=4, max_denominator=9)
SIGNED = st.fractions(min_value=-3, max_value=3, max_denominator=9)


@given(
    beta=st.fractions(min_value=Fraction(11, 10), max_value=5, max_denominator=12),
    springs=st.tuples(NUMBERS, NUMBERS, NUMBERS),
    h=NUMBERS,
    r=NUMBERS,
    weights=st.tuples(NUMBERS, NUMBERS),
    state=st.tuples(NUMBERS, SIGNED, SIGNED, SIGNED),
    bounds=st.tuples(SIGNED, NUMBERS),
)
@settings(max_examples=30, deadline=None)
def test_the_surplus_is_what_the_square_of_the_norm_leaves(
    beta: Fraction,
    springs: tuple[Fraction, Fraction, Fraction],
    h: Fraction,
    r: Fraction,
    weights: tuple[Fraction, Fraction],
    state: tuple[Fraction, ...],
    bounds: tuple[Fraction, Fraction],
) -> None:
    """2 (h r G - t r^2)|x|^2 - (|x|^2)' = x^T N x - 2 x^T M L R, for motions of the mechanism's own equations."""
    series = slow_series(to_fmpq(beta), Contact.of(Regularisation.of(*springs)), 2)
    norm = Norm(series, to_fmpq(weights[0]), to_fmpq(weights[1]))
    p, e = r * r, h * r**3
    slopes = rates(beta, springs, e, p, state)
    root = Dual(r, -e / (2 * r))
    ratio = Dual(e) / root**3
    L, V, W, phi = (Dual(value, slope) for value, slope in zip(state, slopes, strict=True))
    v, w, f = (at(one, ratio, root) for one in (series.v, series.w, series.f))
    minus = Dual(Fraction(-1)) * L
    x = (root * (V + minus * v), W + minus * root**2 * w, root * (phi + minus * root**2 * f))
    gram = [[at(entry, ratio, root) for entry in row] for row in norm.matrix]
    square = sum((x[i] * gram[i][j] * x[j] for i in range(3) for j in range(3)), Dual(Fraction(0)))
    rate = h * r * bounds[0] - bounds[1] * r * r
    matrix = [[at(entry, ratio, root).value for entry in row] for row in surplus(norm, *map(to_fmpq, bounds))]
    values = [one.value for one in x]
    residual = [e * L.value * at(one, ratio, root).value for one in series.residual]
    shown = sum(values[i] * (matrix[i][j] * values[j] - 2 * gram[i][j].value * residual[j])
                for i in range(3) for j in range(3))  # fmt: skip
    assert 2 * rate * square.value - square.slope == shown


def grown(beta: str, order: int, rate: str, damping: str, k_1: int = 1, r: str = "7072/10000") -> Growth:
    number = fmpq(*map(int, beta.split("/")))
    with working_bits(BITS):
        norm = Norm(slow_series(number, Contact.of(PAPER), order), fmpq(k_1), fmpq(1, 2))
        rectangle = Rectangle(fmpq(1, 8), fmpq(*map(int, r.split("/"))))
        return fast_growth(norm, rectangle, fmpq(*map(int, rate.split("/"))), fmpq(*map(int, damping.split("/"))))


@pytest.mark.parametrize(
    ("beta", "order", "rate"), [("3/2", 4, "1/20"), ("7/3", 4, "3/5"), ("5/2", 5, "7/10"), ("5/4", 4, "-1/20")]
)
def test_lemma_1_holds_for_the_papers_contact(beta: str, order: int, rate: str) -> None:
    found = grown(beta, order, rate, "1/20")
    assert found.evidence is not None
    assert found.where == ""
    assert found.boxes > 4


@pytest.mark.parametrize(
    ("rate", "damping"),
    [("1/2", "1/20"), ("7/10", "1/10"), ("7/10", "1/7")],
    ids=["the limit of the rate", "too much damping", "more than the true damping"],
)
def test_wrong_constants_are_refused(rate: str, damping: str) -> None:
    found = grown("5/2", 5, rate, damping)
    assert found.evidence is None
    assert "not certainly positive definite" in found.where


def test_without_the_coupling_of_the_norm_nothing_is_damped() -> None:
    assert grown("5/2", 5, "7/10", "1/20", k_1=0).evidence is None


def test_the_shares_are_those_of_the_inverse() -> None:
    with working_bits(BITS):
        norm = Norm(slow_series(fmpq(5, 2), Contact.of(PAPER), 3), fmpq(1), fmpq(1, 2))
        rectangle = Rectangle(fmpq(1, 8), fmpq(7, 10))
        shares = norm.shares(rectangle)
        assert shares is not None
        bounds = [float(value.lower()) for value in shares]
        for h in np.linspace(0.0, 0.125, 6):
            for r in np.linspace(0.0, 0.7, 6):
                m, n = r / 8 - h, -r
                inverse = np.linalg.inv(np.array([[0.5, m, 0], [m, 1, n], [0, n, 8]]))
                assert all(np.sqrt(inverse[i, i]) <= bounds[i] * (1 + 1e-12) for i in range(3))
        assert norm.shares(Rectangle(fmpq(1), fmpq(3))) is None


def test_entries_that_a_chart_cannot_divide_are_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    """A matrix whose antisymmetric part does not cancel has an entry of order r."""
    module = "gspot_verified.expansion.from_state.fast_growth.fast_matrix"

    def unbalanced(series: object) -> object:
        matrix = fast_matrix(series)  # type: ignore[arg-type]
        matrix[1][0] = 2 * matrix[1][0]
        return matrix

    monkeypatch.setattr(module, unbalanced)
    with pytest.raises(ArithmeticError, match="monomial"):
        grown("5/2", 2, "7/10", "1/20")


@given(u=st.fractions(Fraction(1, 8), 1, max_denominator=16), size=st.fractions(Fraction(1, 32), 1, max_denominator=32))
@settings(max_examples=20, deadline=None)
def test_the_minors_of_both_charts_are_those_of_the_scaled_matrix(u: Fraction, size: Fraction) -> None:
    """The Schur complement of N with rows 1, 2 divided by r, or by h sqrt(u)."""
    matrix = surplus(Norm(slow_series(fmpq(5, 2), Contact.of(PAPER), 3), fmpq(1), fmpq(1, 2)), fmpq(1), fmpq(1, 9))
    for steep in (True, False):
        h, r = (u * size, size) if steep else (size, u * size)
        N = [[at(entry, Dual(h), Dual(r)).value for entry in row] for row in matrix]
        unit = r * r if steep else h * h * u
        block = [[(N[i][j] - N[i][2] * N[j][2] / N[2][2]) / unit for j in range(2)] for i in range(2)]
        wanted = (N[2][2], block[0][0], block[0][0] * block[1][1] - block[0][1] * block[1][0])
        with working_bits(BITS):
            found = _Chart(matrix, steep, fmpq(1), fmpq(1)).minors(ball(to_fmpq(u)), ball(to_fmpq(size)))
            for value, number in zip(found, wanted, strict=True):
                assert abs(value - ball(to_fmpq(number))) < arb("1e-25") * (1 + abs(ball(to_fmpq(number))))


@given(
    beta=st.fractions(min_value=Fraction(11, 10), max_value=9, max_denominator=12),
    springs=st.tuples(NUMBERS, NUMBERS, NUMBERS),
    weights=st.tuples(NUMBERS, NUMBERS),
    bounds=st.tuples(SIGNED, NUMBERS),
    order=st.integers(1, 4),
)
@settings(max_examples=20, deadline=None)
def test_the_leading_parts_of_the_surplus_are_those_of_lemma_r1(
    beta: Fraction,
    springs: tuple[Fraction, Fraction, Fraction],
    weights: tuple[Fraction, Fraction],
    bounds: tuple[Fraction, Fraction],
    order: int,
) -> None:
    """proofs/papers_rule.md, section 2: order 2 in (h, r) of the block, order 1 of the sides, 0 of the corner; and a
    factor r, which the charts divide by."""
    contact = Contact.of(Regularisation.of(*map(to_fmpq, springs)))
    k_1, k_2, rate, damping = (to_fmpq(value) for value in (*weights, *bounds))
    half = (to_fmpq(beta) - fmpq(3, 2)) / 2
    matrix = surplus(Norm(slow_series(to_fmpq(beta), contact, order), k_1, k_2), rate, damping)
    terms = [[terms_of(entry) for entry in row] for row in matrix]

    def leading(i: int, j: int, size: int) -> dict[tuple[int, int], fmpq]:
        assert all(a + b >= size and (size == 0 or b > 0) for a, b in terms[i][j])
        return {key: value for key, value in terms[i][j].items() if sum(key) == size and value != 0}

    share = contact.lag / contact.rate
    expected = {
        (0, 0, 2): {(1, 1): 2 * contact.kappa * (rate - half), (0, 2): 2 * contact.kappa * (k_2 * share - damping)},
        (0, 1, 2): {},
        (1, 1, 2): {(1, 1): 2 * (rate - half), (0, 2): 2 * ((k_1 - k_2) * share - damping)},
        (0, 2, 1): {},
        (1, 2, 1): {(0, 1): -k_1 * contact.rate},
        (2, 2, 0): {(0, 0): 2 * contact.rate**3 / contact.lag},
    }
    for (i, j, size), parts in expected.items():
        assert leading(i, j, size) == {key: value for key, value in parts.items() if value != 0}


@pytest.mark.parametrize("h", [fmpq(1, 8), fmpq(1, 2)], ids=["m rises most", "m falls most"])
def test_the_shares_are_the_numbers_of_the_page(h: fmpq) -> None:
    """(5) with kappa = 6/5, g = 10, l = 9/5: upper bounds, and no larger ones."""
    kappa, g, l, r = fmpq(6, 5), fmpq(10), fmpq(9, 5), fmpq(3, 4)  # noqa: E741 - the page's name
    beta, k_1, k_2 = fmpq(7, 3), fmpq(3, 2), fmpq(2)
    m = max(k_2 * l / g * r, (beta - fmpq(1, 2)) / 2 * h)
    d = 1 - m**2 / kappa - (k_1 * r) ** 2 * l / g**2
    with working_bits(BITS):
        norm = Norm(slow_series(beta, Contact.of(Regularisation.of(2, 3, "1/2")), 1), k_1, k_2)
        shares = norm.shares(Rectangle(h, r))
    assert shares is not None
    with working_bits(3 * BITS):
        for share, square in zip(shares, (1 / (kappa * d), 1 / d, l / (g**2 * d)), strict=True):
            assert share.is_exact()
            assert ball(square) < share**2 < ball(square) * (1 + arb("1e-30"))


def test_a_norm_at_the_edge_is_none() -> None:
    """d = 0: kappa = 1 and m = -1 at h = 1."""
    series = slow_series(fmpq(5, 2), Contact.of(Regularisation.of(2, 2, 1)), 1)
    norm = Norm(series, fmpq(0), fmpq(0))
    with working_bits(BITS):
        assert norm.shares(Rectangle(fmpq(1), fmpq(1))) is None
        assert norm.shares(Rectangle(1 - fmpq(1, 10**6), fmpq(1))) is not None
    for weights in ((fmpq(-1, 9), fmpq(1)), (fmpq(1), fmpq(-1, 9))):
        with pytest.raises(ValueError, match="must not be negative"):
            Norm(series, *weights)


def diagonal(first: fmpq_mpoly) -> list[list[fmpq_mpoly]]:
    """A matrix whose first entry decides: the second one is r(h + r), as it is in N, the last one is 1."""
    zero, one = RING.constant(0), RING.constant(1)
    return [[first, zero, zero], [zero, H * R + R * R, zero], [zero, zero, one]]


def grown_with(matrix: list[list[fmpq_mpoly]], monkeypatch: pytest.MonkeyPatch) -> Growth:
    """Lemma 1 for this N on 0 < h <= 1/2, 0 < r <= 3/4."""
    monkeypatch.setattr("gspot_verified.expansion.from_state.fast_growth.surplus", lambda *_: matrix)
    with working_bits(BITS):
        norm = Norm(slow_series(fmpq(5, 2), Contact.of(PAPER), 1), fmpq(1), fmpq(1, 2))
        return fast_growth(norm, Rectangle(fmpq(1, 2), fmpq(3, 4)), fmpq(1), fmpq(1, 9))


@pytest.mark.parametrize(
    ("first", "where"),
    [
        (H * R + R * R, ""),
        (H * R - fmpq(1, 2) * R * R, "<= h/r <="),
        (R * R - fmpq(1, 2) * H * R, "<= r/h <="),
        ((H + R) * R * (1 - fmpq(5, 3) * R), "<= h/r <="),
        ((H + R) * R * (1 - fmpq(5, 4) * R), ""),
        ((H + R) * R * (1 - fmpq(5, 2) * H), "N is not certainly"),
        ((H + R) * R * (1 - fmpq(3, 2) * H), ""),
    ],
    ids=["all", "small h/r fails", "small r/h fails", "r > 3/5 fails", "to r = 4/5", "h > 2/5 fails", "to h = 2/3"],
)
def test_both_charts_cover_the_rectangle_and_no_more(
    first: fmpq_mpoly, where: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    found = grown_with(diagonal(first), monkeypatch)
    assert (found.evidence is not None) is (where == "")
    assert where in found.where
    if found.evidence is not None:
        covering = [fact for fact in found.evidence.facts if "cover" in fact]
        assert [fact.split("cover")[1].lstrip("s ") for fact in covering] == ["[0, 1] x [0, 3/4]", "[0, 1] x [0, 1/2]"]
        assert sum(1 if fact.startswith("one ") else int(fact.split()[0]) for fact in covering) == found.boxes
        assert len(found.evidence.facts) >= found.boxes + len(covering)
        assert any(fact.startswith("0 < ") for fact in found.evidence.facts)


def test_boxes_that_leave_something_out_show_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    positive = _Chart.positive

    def shortened(chart: _Chart) -> object:
        parts, where = positive(chart)
        return parts[1:], where

    monkeypatch.setattr(_Chart, "positive", shortened)
    found = grown_with(diagonal(H * R + R * R), monkeypatch)
    assert found.evidence is None
    assert found.where == "the boxes do not cover the rectangle"


@pytest.mark.parametrize("first", [H * H + R * R, RING.constant(1), H + R])
def test_an_entry_of_too_low_an_order_is_refused(first: fmpq_mpoly, monkeypatch: pytest.MonkeyPatch) -> None:
    """h^2 over h^2 u: where r/h = u = 0 it is not finite."""
    with pytest.raises(ArithmeticError, match="the entry has the monomial"):
        grown_with(diagonal(first), monkeypatch)
