"""Many values at once: every ball and every pair of doubles contains the value.

Pages: proofs/local_series.md, proofs/float_horner.md.
"""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from flint import acb, arb, fmpq
from hypothesis import given, settings
from hypothesis import strategies as st
from samples.strategies import ends, near_integers, small_heights, to_fmpq

from gspot_verified import evaluate, theta, theta_of_floats
from gspot_verified.numbers.balls import bits_for_digits, relative_bits
from gspot_verified.theta_function.arrays import batch, kept_panels
from gspot_verified.theta_function.arrays.arrays import bounds, theta_array
from gspot_verified.theta_function.arrays.float_balls import FloatBalls
from gspot_verified.theta_function.arrays.kept_panels import KeptPanels


def test_arrays_of_floats_are_exact_binary_values() -> None:
    grid = np.linspace(-3.0, 2.0, 11)
    values = theta(grid, "1/2")
    assert values.shape == grid.shape
    for tau, value in zip(grid, values, strict=True):
        exact = theta(Fraction(float(tau)), "1/2")
        assert value.overlaps(exact)
        assert relative_bits(value) >= 49
    lower, upper = bounds(values)
    assert np.isfinite(lower).all()
    assert (lower < upper).all()


def test_arrays_of_objects_and_integers() -> None:
    assert theta_array(np.array([Fraction(1, 2), "1/3"], dtype=object), 3)[1].overlaps(theta("1/3", 3))
    assert theta(np.array([[1, 2], [3, 4]]), 2).shape == (2, 2)
    with pytest.raises(ValueError, match="finite"):
        theta(np.array([1.0, np.nan]), "1/2")


_BETAS = st.one_of(small_heights(), near_integers(9), st.floats(-8, 12).map(Fraction)).filter(lambda b: abs(b) <= 60)


def _exact(tau: float, beta: fmpq, derivative: int) -> tuple[Fraction, Fraction]:
    return ends(evaluate(fmpq(*tau.as_integer_ratio()), beta, derivative, 70).value)


@given(
    _BETAS,
    st.sampled_from([1e-9, 0.5, 2.0, 9.0, 30.0, 70.0]),
    st.integers(0, 3),
    st.integers(0, 2**32),
    st.sampled_from([3, 40, 800]),
)
def test_values_of_doubles_contain_the_evaluator(
    beta: Fraction, reach: float, derivative: int, seed: int, count: int
) -> None:
    """All three ways are met: panels in doubles, panels in balls, one polynomial; a few points of each."""
    source = np.random.default_rng(seed)
    tau = source.uniform(-reach, reach, count)
    found = theta_of_floats(tau, to_fmpq(beta), derivative)
    for i in source.integers(0, count, 3):
        lower, upper = _exact(float(tau[i]), to_fmpq(beta), derivative)
        if np.isinf(found.radius[i]):
            assert max(abs(lower), abs(upper)) > Fraction(10) ** 290
            continue
        middle, radius = Fraction(float(found.midpoint[i])), Fraction(float(found.radius[i]))
        assert middle - radius <= lower
        assert upper <= middle + radius
        assert radius <= Fraction(1, 10**15) * abs(middle) + Fraction(1, 2**800)


@given(_BETAS, st.sampled_from([2.0, 30.0]), st.integers(0, 2), st.sampled_from([25, 50]), st.sampled_from([5, 300]))
def test_balls_at_doubles_contain_the_evaluator(
    beta: Fraction, reach: float, derivative: int, digits: int, count: int
) -> None:
    tau = np.linspace(-reach, reach, count)
    values = theta_array(tau, to_fmpq(beta), derivative, digits)
    for i in (0, count // 3, count - 1):
        lower, upper = _exact(float(tau[i]), to_fmpq(beta), derivative)
        found = ends(values[i])
        assert found[0] <= lower
        assert upper <= found[1]
        assert relative_bits(values[i]) >= bits_for_digits(digits)


@settings(max_examples=20)
@given(_BETAS, st.sampled_from([0.1, 2.0, 30.0, 70.0]), st.integers(0, 2), st.integers(0, 2**32))
def test_fine_panels_and_pairs_of_doubles_contain_the_evaluator(
    beta: Fraction, reach: float, derivative: int, seed: int
) -> None:
    """As if there were many more points: some next to a zero, if doubles show one."""
    source = np.random.default_rng(seed)
    tau = np.sort(source.uniform(-reach, reach, 40))
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(kept_panels, "_POINTS_OF_A_FINE_CELL", 0)
        patch.setattr(kept_panels, "_POINTS_OF_A_CELL", 0)
        patch.setattr(kept_panels, "_POINTS_OF_A_CELL_AT_0", 0)
        patch.setattr(batch, "_POINTS_OF_A_LONG_PANEL", 1)
        patch.setattr(batch, "_LEAST_PAIRS", 1)
        kept_panels.kept_panels.cache_clear()
        signs = np.flatnonzero(np.diff(np.sign(theta_of_floats(tau, to_fmpq(beta), derivative).midpoint)))
        if len(signs):
            low, high = tau[signs[0]], tau[signs[0] + 1]
            for _ in range(2):
                inner = np.linspace(low, high, 40)
                change = np.flatnonzero(np.diff(np.sign(theta_of_floats(inner, to_fmpq(beta), derivative).midpoint)))
                low, high = inner[change[0]], inner[change[0] + 1]
            tau[:20] = np.linspace(low, high, 20)
        found = theta_of_floats(tau, to_fmpq(beta), derivative)
    kept_panels.kept_panels.cache_clear()
    for i in (0, 13, 19, 39):
        lower, upper = _exact(float(tau[i]), to_fmpq(beta), derivative)
        if np.isinf(found.radius[i]):
            assert max(abs(lower), abs(upper)) > Fraction(10) ** 290
            continue
        middle, radius = Fraction(float(found.midpoint[i])), Fraction(float(found.radius[i]))
        assert middle - radius <= lower
        assert upper <= middle + radius
        assert radius <= Fraction(1, 10**15) * abs(middle) + Fraction(1, 2**800)


def test_from_the_second_array_on_panels_are_kept(monkeypatch: pytest.MonkeyPatch) -> None:
    """A first array of few points is not worth them; one that comes after is, and the next needs nothing new."""
    kept_panels.kept_panels.cache_clear()
    tau = np.linspace(0.25, 5.0, 200)
    made: list[int] = []
    columns = KeptPanels._made
    monkeypatch.setattr(
        KeptPanels, "_made", lambda self, cell, count: (made.append(cell), columns(self, cell, count))[1]
    )
    first = theta_of_floats(tau, "-1/2")
    assert made == []
    monkeypatch.setattr(batch, "_by_one_polynomial", None)
    monkeypatch.setattr(batch, "_in_balls", None)
    second = theta_of_floats(tau, "-1/2")
    assert sorted(made) == [0, 1, 2, 3, 4, 5]
    third = theta_of_floats(tau[:100], "-1/2")
    assert len(made) == 6
    assert (second.midpoint[:100] == third.midpoint).all()
    for later in (second, FloatBalls(third.midpoint, third.radius)):
        part = first[: len(later)]
        assert (part.lower <= later.upper).all()
        assert (later.lower <= part.upper).all()


def test_pairs_of_doubles_serve_what_one_double_misses(monkeypatch: pytest.MonkeyPatch) -> None:
    """Next to the zero of Theta' at beta = 5/2 and not on it no ball is needed; a wrong panel costs only time."""
    near = 1.531716136412176 + np.linspace(1e-9, 1e-3, 4_000)
    right = theta_of_floats(near, "5/2", 1)
    monkeypatch.setattr(batch, "_in_balls", None)
    monkeypatch.setattr(batch, "_by_one_polynomial", None)
    again = theta_of_floats(near, "5/2", 1)
    assert (again.radius <= 1e-15 * abs(again.midpoint)).all()
    monkeypatch.undo()
    locate = batch._locate
    monkeypatch.setattr(batch, "_locate", lambda points, cover: locate(points, cover) + 1)
    found = theta_of_floats(near, "5/2", 1)
    for other in (again, found):
        assert (other.lower <= right.upper).all()
        assert (right.lower <= other.upper).all()


def test_points_next_to_a_zero_and_on_the_edges_of_panels() -> None:
    near = 1.531716136412176 + np.linspace(-1e-3, 1e-3, 400)
    edges = np.concatenate([np.arange(-64, 65) / 4, np.nextafter(np.arange(-64, 65) / 4, 99), [64.0, -64.0]])
    for tau in (near, edges):
        found = theta_of_floats(tau, "5/2", 1)
        assert (found.radius <= 1e-15 * abs(found.midpoint)).all()
        for i in range(0, len(tau), 37):
            lower, upper = _exact(float(tau[i]), fmpq(5, 2), 1)
            assert Fraction(float(found.midpoint[i])) - Fraction(float(found.radius[i])) <= lower
            assert upper <= Fraction(float(found.midpoint[i])) + Fraction(float(found.radius[i]))


def test_a_wrong_panel_costs_time_and_never_truth(monkeypatch: pytest.MonkeyPatch) -> None:
    tau = np.linspace(-3.0, 3.0, 2_000)
    right = theta_of_floats(tau, "7/3")
    locate = batch._locate
    monkeypatch.setattr(batch, "_locate", lambda points, cover: np.roll(locate(points, cover), 3))
    found = theta_of_floats(tau, "7/3")
    assert (found.lower <= right.upper).all()
    assert (right.lower <= found.upper).all()


@pytest.mark.parametrize("beta", [1, "7/3", "-3/2"])
def test_who_lets_numpy_raise_gets_the_same_values(beta: Any) -> None:
    tau = np.array([5e-324, 1e-310, -1e-320, 0.0, 1.5, -7.25])
    for _ in range(2):  # the second time by panels that are kept
        with np.errstate(all="raise"):
            raising = theta_of_floats(tau, beta)
        assert np.isfinite(raising.radius).all()
        plain = theta_of_floats(tau, beta)
        assert (abs(raising.midpoint - plain.midpoint) <= raising.radius + plain.radius).all()


def test_points_beyond_all_panels_take_no_memory_for_panels() -> None:
    far = np.array([1e12, -1e12, 1e11])
    for answer in (theta_of_floats(far, "7/3"), theta_of_floats(far, "7/3", 1)):
        assert np.isinf(answer.radius).tolist() == [True, False, True]
    assert theta(-abs(far), "7/3", digits=20)[2].overlaps(theta(-(10**11), "7/3"))


def test_arithmetic_that_is_not_ieee_is_not_used(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(batch, "arithmetic_is_ieee", lambda: False)
    monkeypatch.setattr(batch, "horner", None)
    found = theta_of_floats(np.linspace(-1.0, 1.0, 9), "7/3")
    assert (found.radius <= 1e-15 * abs(found.midpoint)).all()


def test_grids_are_broadcast() -> None:
    tau, beta = np.linspace(-2.0, 2.0, 7)[None, :], np.array([0.5, 0.25, 3.0])[:, None]
    found, balls = theta_of_floats(tau, beta), theta(tau, beta)
    assert found.midpoint.shape == balls.shape == (3, 7)
    for i in range(3):
        row = theta_of_floats(tau[0], Fraction(float(beta[i, 0])))
        assert (row.lower <= found.upper[i]).all()
        assert (found.lower[i] <= row.upper).all()
        for j in range(7):
            assert arb(found.midpoint[i, j], found.radius[i, j]).overlaps(balls[i, j])
    mixed = theta(Fraction(1, 3), np.array([Fraction(1, 2), "7/3"], dtype=object))
    assert mixed[1].overlaps(theta("1/3", "7/3"))
    assert theta_of_floats(np.empty(0), "1/2").midpoint.size == 0


@pytest.mark.parametrize(
    "kind", [np.int8, np.uint16, np.int64, np.uint64, np.float16, np.float32, np.longdouble, ">f8"]
)
def test_every_real_type_whose_numbers_are_doubles(kind: Any) -> None:
    numbers = np.array([0, 1, 2, 7, 33], dtype=kind)
    found, expected = theta_of_floats(numbers, "7/3"), theta_of_floats(numbers.astype(np.float64), "7/3")
    assert (found.lower <= expected.upper).all()
    assert (expected.lower <= found.upper).all()
    assert (found.radius <= 1e-15 * abs(found.midpoint)).all()


@pytest.mark.skipif(np.finfo(np.longdouble).nmant <= 52, reason="long doubles are doubles here")
def test_a_float_that_is_no_double_is_refused() -> None:
    for number in (np.longdouble(1) / 3, np.longdouble(1) + np.finfo(np.longdouble).eps, np.longdouble("1e-4000")):
        with pytest.raises(ValueError, match="is not a double"):
            theta_of_floats(np.array([0.5, number]), "7/3")
    with pytest.raises(ValueError, match="is not a double"):
        theta_of_floats(np.array([np.longdouble("1e4000")]), "7/3")


def test_lists_and_numbers() -> None:
    found = theta_of_floats([[0.5, 1], [-2, 3]], "7/3")
    assert found.shape == (2, 2)
    assert theta_of_floats([], "7/3").shape == (0,)
    for index, tau in np.ndenumerate(np.array([[0.5, 1], [-2, 3]])):
        single = theta_of_floats(float(tau), "7/3")
        assert single.shape == ()
        for enclosed in (single, found[index]):
            truth = theta(Fraction(float(tau)), "7/3", digits=30)
            assert truth.is_finite()
            assert arb(float(enclosed.midpoint), float(enclosed.radius)).contains(truth.mid())


def test_what_vanishes_is_exactly_zero() -> None:
    found = theta_of_floats(np.linspace(-2.0, 2.0, 9), 2, 3)
    assert (found.midpoint == 0).all()
    assert (found.radius == 0).all()
    assert all(value.is_zero() for value in theta_array(np.linspace(-2.0, 2.0, 9), 2, 3, 40))


def test_bad_arrays() -> None:
    for tau in ([True, False], ["1/3"], [Fraction(1, 3)], [1j], [None], [[1.0], None]):
        with pytest.raises(TypeError, match="integers or floats"):
            theta_of_floats(np.array(tau, dtype=object if None in tau else None), "1/2")
    for number in (2**63 - 1, -(2**63), 2**53 + 1, 10**12 + 1):
        with pytest.raises(ValueError, match="covers"):
            theta_of_floats([number], "1/2")
    with pytest.raises(ValueError, match="finite"):
        theta_of_floats([0.5, float("nan")], "1/2")
    with pytest.raises(ValueError, match="finite"):
        theta_of_floats(np.array([1.0, np.inf]), "1/2")
    with pytest.raises(ValueError, match="covers"):
        theta_of_floats(np.array([1.0, 1e13]), "1/2")
    with pytest.raises(TypeError, match="beta: a float"):
        theta_of_floats(np.array([1.0]), 0.5)  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="beta: every entry"):
        theta_of_floats(np.array([1.0]), np.array([np.nan]))
    with pytest.raises(TypeError, match="ball"):
        theta_of_floats(np.array([1.0]), arb(0, 1))
    with pytest.raises(ValueError, match="digits"):
        theta_array(np.array([1.0]), "1/2", digits=0)


def test_a_masked_array_is_refused() -> None:
    masked, plain = np.ma.masked_array([0.5, 1.0], [True, False]), np.array([0.5, 1.0])
    for tau, beta in ((masked, "1/2"), (plain, masked)):
        with pytest.raises(TypeError, match="a masked array is not taken"):
            theta_array(tau, beta)
        with pytest.raises(TypeError, match="a masked array is not taken"):
            theta_of_floats(tau, beta)


def test_a_masked_array_in_a_list_is_refused() -> None:
    """numpy makes a plain array of the list, without the mask."""
    masked = np.ma.masked_array([0.5, 1.0], [True, False])
    for tau, beta in (([masked, masked], "1/2"), ((masked,), "1/2"), ([[masked]], "1/2"), ([0.5, 1.0], [masked])):
        with pytest.raises(TypeError, match="a masked array is not taken"):
            theta_of_floats(tau, beta)  # type: ignore[arg-type]


def test_an_array_of_balls_for_beta() -> None:
    """Balls without a hash: equal ones share their work, others do not; one that is not finite is refused."""
    wide, same, other = arb("0.3"), arb("0.3"), arb("0.7")
    found = theta_array(np.array([0.5, 0.5, 0.5, 0.5]), np.array([wide, same, other, 2], dtype=object))
    for value, beta in zip(found, ("0.3", "0.3", "0.7", 2), strict=True):
        assert value.is_finite()
        assert value.contains(theta("1/2", beta, digits=30).mid())
    with pytest.raises(ValueError, match="beta"):
        theta_array(np.array([0.5]), np.array([arb("nan")], dtype=object))


@pytest.mark.parametrize("tau", [5e-324, 1e-310, 1e-300, 1e-271, 1e-250])
@pytest.mark.parametrize(("beta", "derivative"), [(2, 0), (2, 1), ("1e-290", 1), ("1e-320", 1), ("1e-260", 2)])
def test_next_to_the_least_doubles_the_promise_holds(tau: float, beta: object, derivative: int) -> None:
    found = theta_of_floats(np.array([tau, -1.5]), beta, derivative)
    for point, middle, radius in zip((tau, -1.5), found.midpoint.tolist(), found.radius.tolist(), strict=True):
        truth = theta(fmpq(*point.as_integer_ratio()), beta, derivative, digits=40)
        assert truth.is_finite()
        assert abs(truth - arb(middle)) <= arb(radius) or truth == middle
        assert radius <= max(1e-15 * abs(middle), 2.0**-899)


class _Column:
    """What numpy and this library see of a pandas Series."""

    def __init__(self, values: list[float], index: list[str]) -> None:
        self.values, self.index = np.array(values), np.array(index)

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> np.ndarray[Any, Any]:
        return self.values if dtype is None else self.values.astype(dtype)


def test_the_index_of_a_column_is_kept() -> None:
    column = _Column([0.5, -1.25, 2.0], ["a", "b", "c"])
    found, plain = theta_of_floats(column, "7/3"), theta_of_floats([0.5, -1.25, 2.0], "7/3")
    assert found.index is column.index
    assert (found.midpoint == plain.midpoint).all()
    assert (found.radius == plain.radius).all()
    for key, rows in (
        (slice(1, None), "bc"),
        (slice(None, None, -1), "cba"),
        ([2, 0], "ca"),
        (found.midpoint < 0, None),
    ):
        part = found[key]
        assert len(part.index) == len(part)
        assert rows is None or "".join(part.index) == rows
        assert part.midpoint.tolist() == [
            plain[int(np.flatnonzero(column.index == row)[0])].midpoint for row in part.index
        ]
    assert found[1].index is None


def test_no_index_where_there_is_none_or_it_would_not_fit() -> None:
    assert theta_of_floats([0.5, 1], "7/3").index is None
    assert theta_of_floats(np.array([0.5, 1]), "7/3").index is None
    column = _Column([0.5, 1.0], ["a", "b"])
    assert theta_of_floats(column, np.array([[0.5], [1.5]])).index is None
    assert theta_of_floats(column, np.array([0.5, 1.5])).index is column.index


def test_a_series_of_pandas() -> None:
    pandas = pytest.importorskip("pandas")
    column = pandas.Series([0.5, -1.25, 2.0], index=["a", "b", "c"])
    found = theta_of_floats(column[column > 0], "7/3")
    frame = pandas.DataFrame(found.to_numpy(), index=found.index, columns=["lower", "upper"])
    assert frame.loc["c", "lower"] == theta_of_floats(2, "7/3").lower


def test_complex_arrays_give_complex_balls() -> None:
    """Each complex float stands for its exact binary value, as a float does."""
    taus = np.array([[0.1 + 2j, 3], [-20.5 + 1e-3j, 1e8j]])
    found = theta(taus, "7/3")
    assert found.shape == (2, 2)
    for tau, value in zip(taus.ravel(), found.ravel(), strict=True):
        exact = theta(acb(tau.real, tau.imag), "7/3", digits=30)
        assert isinstance(value, acb)
        assert relative_bits(value) >= bits_for_digits(15)
        assert value.contains(exact.mid())
    short = theta(np.array([0.1 + 2j], dtype=np.complex64), "7/3")[0]
    assert short.contains(theta(acb(np.float64(np.float32(0.1)), 2), "7/3", digits=30).mid())
    long = theta(np.array([np.clongdouble(1) / 3 + 1j]), "7/3", digits=30)[0]
    third = np.longdouble(1) / 3
    assert long.overlaps(theta(f"{Fraction(*third.as_integer_ratio())}+i", "7/3", digits=30))


def test_complex_entries_and_betas_are_broadcast() -> None:
    mixed = theta(np.array(["1+2i", 3, acb(1, 2)], dtype=object), "7/3")
    assert [type(value) for value in mixed] == [acb, arb, acb]
    assert mixed[0].overlaps(mixed[2])
    columns = theta("1+2i", np.array(["7/3", 3], dtype=object))
    assert columns[0].overlaps(mixed[0])
    assert columns[1].overlaps(theta("1+2i", 3))


@pytest.mark.parametrize("bad", [complex("nan"), complex(1, float("inf"))])
def test_complex_entries_that_are_not_finite_are_refused(bad: complex) -> None:
    with pytest.raises(ValueError, match="tau: every entry must be finite"):
        theta(np.array([1j, bad]), "7/3")


def test_what_takes_no_complex_array_says_so() -> None:
    taus = np.array([1 + 2j])
    with pytest.raises(
        TypeError, match="tau: expected integers or floats, got complex128; theta takes arrays of complex"
    ):
        theta_of_floats(taus, "7/3")
    with pytest.raises(TypeError, match="beta: expected int"):
        theta(1, taus)
    with pytest.raises(TypeError, match="tau: a complex is not taken"):
        theta(np.array([1 + 2j], dtype=object), "7/3")
    with pytest.raises(TypeError, match="tau: a complex is not taken"):
        theta(1 + 2j, np.array([0.5]))


class Column:
    """What pandas gives: an array by its method, an index."""

    index = ("a", "b")

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> np.ndarray[Any, Any]:
        return np.array([0.5, 1.5], dtype=dtype)


@pytest.mark.parametrize(
    "betas", [[0.5, 1.5], (0.5, 1.5), ["1/2", "3/2"], [Fraction(1, 2), "1.5"], Column(), np.array([0.5, 1.5])]
)
def test_betas_in_a_list(betas: Any) -> None:
    found = theta_of_floats([1, 2], betas)
    for tau, beta, middle, radius in zip((1, 2), ("1/2", "3/2"), found.midpoint, found.radius, strict=True):
        assert arb(float(middle), float(radius)).contains(theta(tau, beta, digits=40))
    assert theta_of_floats([[1], [2]], betas).shape == (2, 2)


@pytest.mark.parametrize("betas", [[], [[]]])
def test_no_betas_give_no_values(betas: Any) -> None:
    assert theta_of_floats(1.0, betas).shape == np.shape(betas)


def test_what_no_beta_is() -> None:
    for betas, message in (([0.5, None], "beta: "), (["x"], "beta: expected"), ([float("nan")], "finite")):
        with pytest.raises((TypeError, ValueError), match=message):
            theta_of_floats(1.0, betas)
    for of in (theta_of_floats, theta):
        with pytest.raises(ValueError, match=r"tau has the shape \(3,\), beta \(2,\): they do not broadcast"):
            of(np.zeros(3), np.array([0.5, 1.5]))
