"""Theorem F6 of flight.md: its identities by another quadrature, its bounds on lift-off states found at single epsilon,
and what must not be proved."""

from __future__ import annotations

import mpmath
import pytest
from flint import arb, fmpq
from hypothesis import given
from hypothesis import strategies as st
from witnesses.theta import contains_witness, to_fraction

from gspot_verified.compliant.model.flight import ContactState
from gspot_verified.compliant.motion.lasting_contact import lasting_contact
from gspot_verified.compliant.motion.touch_down import flight_end
from gspot_verified.compliant.slow.slow_solution import slow_value
from gspot_verified.numbers.balls import working_bits
from gspot_verified.numbers.verdict import Outcome
from gspot_verified.paper.numerics import slow_flights as module
from gspot_verified.paper.numerics.slow_flights import one_flight

CERTIFIED = [("3/2", 2), ("5/2", 5)]


def moment(j: int, beta: fmpq, epsilon: fmpq, time: fmpq) -> arb:
    """x^(j) = Gamma(j - b) F_(b-j), b = beta - 1."""
    b = beta - 1
    return arb(j - b).gamma() * slow_value(time, b - j, epsilon, digits=30).value


@pytest.mark.parametrize(("beta", "tau"), CERTIFIED)
def test_the_certified_statements(beta: str, tau: int) -> None:
    verdict = one_flight(beta, "1/100", tau)
    assert verdict.outcome is Outcome.PROVED
    assert "every ε <= 1/100" in verdict.statement


@pytest.mark.parametrize(
    "arguments",
    [
        ("3/2", "1/100", "3/2"),
        ("5/2", "1/100", 4),
        ("11/4", "1/100", 6),
        ("3/2", 1, 2),
        ("3/2", "1/100", 2, "1/3"),
        ("3/2", "1/100", 12),
    ],
    ids=["tau", "tau at 5/2", "margin", "epsilon", "late", "far"],
)
def test_what_the_inequalities_do_not_give_is_undecided(arguments: tuple[object, ...]) -> None:
    assert one_flight(*arguments).outcome is Outcome.UNDECIDED  # type: ignore[arg-type]


@pytest.mark.parametrize(
    "arguments",
    [(1, "1/100", 2), (2, "1/100", 2), (3, "1/100", 2), ("1/2", "1/100", 2), ("3/2", 0, 2), ("3/2", "1/100", -1),
     ("3/2", "1/100", 2, 0)],
)  # fmt: skip
def test_arguments_outside_the_theorem_are_refused(arguments: tuple[object, ...]) -> None:
    with pytest.raises(ValueError, match=r"beta|largest|tau|latest"):
        one_flight(*arguments)  # type: ignore[arg-type]


@pytest.mark.parametrize("beta", [fmpq(3, 2), pytest.param(fmpq(5, 2), marks=pytest.mark.slow)])
def test_the_identity_and_the_bounds_of_lemma_1(beta: fmpq) -> None:
    epsilon, time = fmpq(1, 50), fmpq(12)
    with mpmath.workdps(40):
        small, power = mpmath.mpf(1) / 50, mpmath.mpf(int(beta.p)) / int(beta.q)

        def weighted(j: int) -> mpmath.mpf:
            def integrand(u: mpmath.mpf) -> mpmath.mpf:
                r = mpmath.exp(u)
                exponent = (r - r**2 / 2 - r**3 / 3 - mpmath.log1p(r)) / small + 12 * r
                return mpmath.exp((j - power + 1) * u + exponent) * (2 + r) / (1 + r)

            return mpmath.quad(integrand, [mpmath.mpf(k) / 2 for k in range(-320, 4)])

        second, third = (to_fraction(weighted(j)) for j in (2, 3))
    with working_bits(150):
        x = [moment(j, beta, epsilon, time) for j in range(4)]
        q, kappa = epsilon * time, epsilon * (beta - 1)
        assert contains_witness(q * x[1] - kappa * x[0], third, 25)
        for low, middle in ((x[2], second), (x[3], third)):
            exact = arb(fmpq(middle.numerator, middle.denominator))
            assert low < exact < 2 * low


@pytest.mark.parametrize(
    ("beta", "tau", "epsilon"),
    [
        *(("3/2", 2, epsilon) for epsilon in (fmpq(1, 100), fmpq(1, 10**5), fmpq(1, 10**12))),
        *(("5/2", 5, epsilon) for epsilon in (fmpq(1, 500), fmpq(1, 10**5), fmpq(1, 10**12))),
    ],
)
@pytest.mark.parametrize("factor", [fmpq(1), fmpq(3, 2)])
def test_flights_of_slow_trajectories_at_one_epsilon(beta: str, tau: int, epsilon: fmpq, factor: fmpq) -> None:
    """The trajectory that lifts off at a given time (its C is chosen so): bounds of the proof, and its conclusion."""
    power = fmpq(*map(int, beta.split("/")))
    with working_bits(200):
        eta = (arb(epsilon) / 2).root(3)
        time = fmpq((tau * factor / eta).upper().ceil().unique_fmpz())
        x = [moment(j, power, epsilon, time) for j in range(4)]
        mean = 1 / arb(power - 1)
        k = mean / x[0]
        q, kappa = epsilon * time, epsilon * (power - 1)
        # V + Y = k x', b = k m_2, V = k (x'' + 2 x' - m_2), with m_2 from b-hat = -k epsilon beta Gamma(-beta) F_beta.
        b_hat = -k * epsilon * power * arb(-power).gamma() * slow_value(time, power, epsilon, digits=40).value
        b = b_hat + q * mean
        V = k * (x[2] + 2 * x[1]) - b
        Y = k * x[1] - V
        assert q <= fmpq(1, 4), "later than the theorem allows: nothing would be claimed"
        assert b > q * mean / 4
        assert b < fmpq(9, 2) * arb(q) * mean
        assert 3 * arb(q).sqrt() * mean > V
        assert Y < 0
        start = ContactState(power, epsilon, fmpq(-1), arb(-q), b, V, Y, arb(0))
        end = flight_end(start, 80)
        assert end.state is not None
        assert end.lower is not None
        assert 4 * end.lower * kappa > 3 * q
        assert lasting_contact(end.state).outcome is Outcome.PROVED


TINY = fmpq(1, 2**40)


def in_range(largest: fmpq, tau: fmpq, latest: fmpq) -> bool:
    found: object = module._in_range(fmpq(3, 2), largest, tau, latest)
    return found is not None and found is not False


def test_the_bounds_on_kappa_and_q() -> None:
    """(6) and q >= 4 kappa^(2/3), at their equalities; beta = 3/2, so kappa = epsilon/2."""
    with working_bits(128):
        assert in_range(fmpq(1, 4), fmpq(2), fmpq(1, 100))
        assert not in_range(fmpq(1, 4), 2 - TINY, fmpq(1, 100))
        assert in_range(fmpq(27, 32), fmpq(2), fmpq(1, 10**6))
        assert not in_range(fmpq(27, 32) + TINY, fmpq(2), fmpq(1, 10**6))
        with mpmath.workdps(30):
            for kappa in (mpmath.mpf(1) / 8, mpmath.mpf(1) / 3):
                end = mpmath.findroot(
                    lambda q, k=kappa: mpmath.mpf(27) / 2 * q + mpmath.sqrt(18 * k * mpmath.sqrt(q)) + 2 * k - 4, 0.1
                )
                place = fmpq(int(end * 10**15), 10**15)
                largest = fmpq(1, 4) if kappa == mpmath.mpf(1) / 8 else fmpq(2, 3)
                assert in_range(largest, fmpq(2), place - fmpq(1, 10**6))
                assert not in_range(largest, fmpq(2), place + fmpq(1, 10**6))


def test_the_moments_are_those_of_the_page() -> None:
    """x_j at eta = 0 by quadrature where the integral converges, and at the largest eta by the slow solution."""
    beta, largest, tau = fmpq(3, 2), fmpq(1, 50), fmpq(2)
    with working_bits(128):
        found = module._moments(beta, largest, tau)
        eta = (arb(largest) / 2).root(3)
        for j in range(4):
            page = module.slow_value(tau / eta, beta - 1 - j, largest, digits=25).value
            page = page * eta ** arb(beta - 1 - j) * arb(j - beta + 1).gamma()
            assert found.most[j].overlaps(page)
            assert found.most[j].rad() < arb(10) ** -12
            assert found.least[j] < found.most[j]
    with mpmath.workdps(30):
        for j in (1, 2, 3):
            value = mpmath.quad(
                lambda r, n=j: r ** (n - mpmath.mpf(3) / 2) * mpmath.exp(-(r**3) / 3 + 2 * r),
                [0, mpmath.mpf(1) / 10**6, mpmath.mpf(1) / 100, 1, 2, 4, 8],
            )
            assert contains_witness(found.least[j], to_fraction(value), 8)


NUMBERS = st.lists(st.integers(-20, 20), min_size=4, max_size=4)


@given(NUMBERS, NUMBERS, st.sampled_from([fmpq(5, 2), fmpq(5, 4)]))
def test_the_least_margin_is_that_of_the_eight(low: list[int], high: list[int], beta: fmpq) -> None:
    """x_0, x_1 and the differences in (7) at tau = 2, so that Q sqrt(2 tau) = 3; 2 beta - 3 counts where it is > 0."""
    last = fmpq(2) if beta == fmpq(5, 2) else fmpq(0)
    every = [
        fmpq(low[0]), fmpq(low[1]), fmpq(low[2] - high[0]), 2 * low[1] - (2 * beta - 1) * high[0],
        2 * low[2] - (2 * beta - 2) * high[1], 2 * low[3] - last * high[2], fmpq(3 * low[1] - high[2]),
        fmpq(3 * low[0] - high[1]),
    ]  # fmt: skip
    with working_bits(128):
        found = module._least_margin(beta, fmpq(2), module._Moments(tuple(map(arb, low)), tuple(map(arb, high))))
        assert abs(found - min(every)) < arb(10) ** -30
