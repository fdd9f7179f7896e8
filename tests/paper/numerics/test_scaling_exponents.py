"""The exponents of Table 1: bounds for small epsilon, and what is measured. Steps of proofs/scaling_exponents.md."""

from __future__ import annotations

import math

import pytest
from flint import arb, fmpq
from hypothesis import given, settings
from hypothesis import strategies as st

from gspot_verified.compliant.model.normal_form import Deviation, compliant_model, deviation
from gspot_verified.compliant.motion.compliant_force import contact_motion
from gspot_verified.compliant.motion.contact_series import carried
from gspot_verified.compliant.slow.slow_coefficient import slow_coefficient
from gspot_verified.numbers.balls import ball, working_bits
from gspot_verified.paper.numerics import scaling_exponents as ledger
from gspot_verified.paper.numerics.at_the_g_spot import crossing, deviations
from gspot_verified.paper.numerics.paper_state import paper_state
from gspot_verified.paper.numerics.scaling_exponents import (
    LEAST_RATIO,
    NAMES,
    exponent_error,
    fast_share,
    limit_exponent,
    pair_error,
    quantity,
    regression_error,
    regression_slope,
    series_error,
    share_at,
)

BETAS = (fmpq(1, 2), fmpq(3, 2), fmpq(5, 2))
NU = fmpq(2)
ROWS = [(beta, name) for beta in BETAS for name in NAMES]


@pytest.mark.parametrize("beta", BETAS)
def test_the_limits_are_the_formulas_of_the_paper(beta: fmpq) -> None:
    assert [limit_exponent(beta, name) for name in NAMES] == [2 * beta / 3, (2 * beta + 2) / 3, (2 * beta + 4) / 3]


@pytest.mark.parametrize(("beta", "name"), ROWS)
def test_every_measured_slope_lies_within_the_bound_and_the_bound_is_not_idle(beta: fmpq, name: str) -> None:
    largest = fmpq(1, 2500)
    error = regression_error(beta, name, largest)
    assert error.is_finite()
    for first in (largest, fmpq(1, 10**5)):
        places = [first, first / LEAST_RATIO]
        with working_bits(96):
            slope = regression_slope([abs(deviations(beta, NU, e)[name]).log() for e in places], places)
            off = abs(slope - limit_exponent(beta, name))
            assert off < error
            if first == largest:
                assert off > error / 8


@pytest.mark.parametrize(("beta", "name"), ROWS)
def test_the_bound_falls_like_the_cube_root(beta: fmpq, name: str) -> None:
    with working_bits(64):
        quotient = exponent_error(beta, name, fmpq(1, 10**9)) / exponent_error(beta, name, fmpq(1, 10**12))
    assert 9 < quotient < 12


@pytest.mark.parametrize("beta", [fmpq(1, 2), fmpq(3, 2)])
def test_v_and_y_of_the_next_beta_scale_alike(beta: fmpq) -> None:
    largest = fmpq(1, 1500)
    first, second = quantity(beta + 1, "v"), quantity(beta, "y")
    assert (first.index, first.power, first.factor) == (second.index, second.power, second.factor)
    assert limit_exponent(beta + 1, "v") == limit_exponent(beta, "y")
    error = pair_error(beta, largest)
    assert error < regression_error(beta, "y", largest) / 8
    for place in (largest, fmpq(1, 10**4)):
        places = [place, place / 2, place / 7]
        with working_bits(96):
            slopes = [
                regression_slope([abs(deviations(b, NU, e)[name]).log() for e in places], places)
                for b, name in ((beta + 1, "v"), (beta, "y"))
            ]
            assert abs(slopes[0] - slopes[1]) < error
            if place == largest:
                assert abs(slopes[0] - slopes[1]) > error / 100
    assert not pair_error(beta, fmpq(1, 500)).is_finite()


def test_the_bounds_are_the_sums_of_the_page(monkeypatch: pytest.MonkeyPatch) -> None:
    """Of given shares and errors of C; a share of 1 or more has no bound."""
    shares = {(fmpq(3, 2), "y"): fmpq(1, 5), (fmpq(5, 2), "v"): fmpq(1, 10)}
    monkeypatch.setattr(ledger, "fast_share", lambda beta, name, _: arb(shares[beta, name]))
    monkeypatch.setattr(ledger, "_coefficient_error", lambda beta, _: arb(beta / 100, fmpq(1, 1000)))
    monkeypatch.setattr(ledger, "exponent_error", lambda *_: arb(7))
    changes = [-2 * math.log(1 - share) / math.log(1.01) for share in (0.2, 0.1)]
    largest = fmpq(1, 2000)
    assert float(pair_error(fmpq(3, 2), largest)) == pytest.approx(0.042 + sum(changes), rel=1e-7)
    assert float(regression_error(fmpq(3, 2), "y", largest)) == pytest.approx(7 + changes[0], rel=1e-12)
    assert pair_error(fmpq(3, 2), largest).is_exact()
    for none in (arb(1), arb(fmpq(3, 2)), arb(1, fmpq(1, 10**6)), arb("nan")):
        monkeypatch.setattr(ledger, "fast_share", lambda *_, none=none: none)
        assert not pair_error(fmpq(3, 2), largest).is_finite()
        assert not regression_error(fmpq(3, 2), "y", largest).is_finite()


def test_without_its_hypotheses_there_is_no_bound() -> None:
    assert not fast_share(fmpq(5, 2), "b", fmpq(1, 500)).is_finite()
    assert not regression_error(fmpq(5, 2), "b", fmpq(1, 500)).is_finite()
    assert not exponent_error(fmpq(5, 2), "b", fmpq(1, 2)).is_finite()
    assert not exponent_error(fmpq(9, 2), "b", fmpq(1, 10**6)).is_finite()


@pytest.mark.parametrize("beta", BETAS)
@pytest.mark.parametrize("small", [fmpq(1, 500), fmpq(1, 1000)])
def test_the_share_at_one_epsilon_is_a_bound_there(beta: fmpq, small: fmpq) -> None:
    model = compliant_model(beta, small)
    slow, fast, _ = contact_motion(model, paper_state(model, NU)).hats(fmpq(0), 60)
    with working_bits(64):
        assert abs(fast["b"] / slow["b"]) < share_at(beta, "b", small) < 1
        assert abs(fast["V"] / slow["V"]) < share_at(beta, "v", small)
        assert abs((fast["Z"] - fast["force"]) / (slow["Z"] - slow["force"])) < share_at(beta, "y", small)


@pytest.mark.parametrize("name", NAMES)
def test_the_slope_over_one_series_is_as_near_as_said(name: str) -> None:
    epsilons = [fmpq(1, 10**k) for k in (3, 4, 5, 6)]
    for beta in BETAS:
        error = series_error(beta, name, epsilons)
        with working_bits(96):
            found = regression_slope([abs(deviations(beta, NU, e)[name]).log() for e in epsilons], epsilons)
            assert abs(found - limit_exponent(beta, name)) < error
        assert error.is_exact()


def test_the_fast_part_counts_by_the_weights_of_the_regression(monkeypatch: pytest.MonkeyPatch) -> None:
    """Two ε: each logarithm has the weight 1 over the logarithm of their quotient."""
    monkeypatch.setattr(ledger, "exponent_error", lambda _beta, _name, largest: arb(largest))
    monkeypatch.setattr(ledger, "share_at", lambda *_: 1 - arb(-1).exp())
    pair = [fmpq(1, 20), fmpq(1, 10)]
    assert float(series_error(fmpq(1, 2), "y", pair)) == pytest.approx(0.1 + 2 / math.log(2), rel=1e-12)
    for none in (arb(1), arb("nan")):
        monkeypatch.setattr(ledger, "share_at", lambda *_, none=none: none)
        assert not series_error(fmpq(1, 2), "y", pair).is_finite()


@pytest.mark.parametrize("beta", BETAS)
@pytest.mark.parametrize("small", [fmpq(1, 1024), fmpq(1, 2000)])
def test_the_share_of_the_fast_part_is_a_bound_and_serves_smaller_epsilon(beta: fmpq, small: fmpq) -> None:
    model = compliant_model(beta, small)
    slow, fast, by_bound = contact_motion(model, paper_state(model, NU)).hats(fmpq(0), 60)
    assert not by_bound or small < fmpq(1, 1024)
    with working_bits(64):
        share = {
            "b": abs(fast["b"] / slow["b"]),
            "v": abs(fast["V"] / slow["V"]),
            "y": abs((fast["Z"] - fast["force"]) / (slow["Z"] - slow["force"])),
        }
        for name in NAMES:
            assert share[name] < fast_share(beta, name, fmpq(1, 1024))


@pytest.mark.parametrize("beta", BETAS)
def test_what_is_measured_agrees_with_the_power_series_about_the_start(beta: fmpq) -> None:
    model = compliant_model(beta, "1/1000")
    start = deviation(model, paper_state(model, NU))
    hats = carried(start, fmpq(500), 80)
    found = deviations(beta, NU, fmpq(1, 1000))
    small = model.epsilon
    with working_bits(96):
        other = {"b": hats["b"], "v": small * hats["V"], "y": small**2 * (hats["Z"] - hats["force"])}
        for name in NAMES:
            assert found[name].is_finite()
            assert other[name].is_finite()
            assert found[name].overlaps(other[name])
            assert abs(found[name] - other[name]) < abs(found[name]) / 10**8


@pytest.mark.parametrize(("beta", "guess"), [(BETAS[0], "69/100"), (BETAS[1], "-31/100"), (BETAS[2], "12/5")])
def test_a_crossing_is_a_change_of_sign_of_the_deviation(beta: fmpq, guess: str) -> None:
    small = fmpq(1, 1000)
    found = crossing(beta, NU, small, fmpq(*map(int, guess.split("/"))))
    assert found is not None
    model = compliant_model(beta, small)
    motion = contact_motion(model, paper_state(model, NU))
    signs = []
    for end in (found.lower(), found.upper()):
        mantissa, exponent = end.man_exp()
        place = fmpq(mantissa) * fmpq(2) ** int(exponent)
        slow, fast, _ = motion.hats(-place, 60, ("b",))
        with working_bits(64):
            signs.append(bool(slow["b"] + fast["b"] > 0))
    assert sorted(signs) == [False, True]
    assert found.rel_accuracy_bits() > 20


def test_where_nothing_vanishes_no_crossing_is_found() -> None:
    assert crossing(BETAS[2], NU, fmpq(1, 1000), fmpq(-3)) is None


def test_the_integrals_are_the_multipliers_of_the_exact_solution() -> None:
    """Section 1: -r (2+r)/(1+r) and -r^2 (2+r)/(1+r) with r = eta rho leave 1 + 1/(1+x) and powers of eta."""
    with working_bits(80):
        for x in (arb("0.1"), arb(2)):
            assert ((2 + x) / (1 + x) - 1 - 1 / (1 + x)).contains(0)
    assert [quantity(fmpq(5, 2), name).index for name in NAMES] == [fmpq(5, 2), fmpq(1, 2), fmpq(3, 2)]


@given(st.integers(1, 40), st.integers(1, 39).filter(lambda tenths: tenths % 10))
@settings(max_examples=25, deadline=None)
def test_the_exponent_of_c_lies_between_the_bounds_of_section_2(epsilon: int, beta_tenths: int) -> None:
    """d ln C/d ln(epsilon) - beta from the certified coefficient at two epsilon."""
    beta, largest = fmpq(beta_tenths, 10), fmpq(epsilon, 10**4)
    places = [largest * fmpq(999, 1000), largest]
    data = [Deviation(beta, e, fmpq(1, 2), fmpq(1), fmpq(0), fmpq(4), fmpq(2)) for e in places]
    with working_bits(128):
        slope = regression_slope([abs(slow_coefficient(state, 80)).log() for state in data], places)
        size = 8 * largest**2 * beta * (beta + 1)
        assert -4 * beta * size < slope - ball(beta) < 3 * (beta + 2) * size
        assert abs(slope - ball(beta)) > size / 1000
