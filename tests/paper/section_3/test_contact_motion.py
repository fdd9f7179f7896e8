"""The two power series of proofs/contact_motion.md against each other, and against a plain Runge-Kutta run."""

from __future__ import annotations

from fractions import Fraction

import pytest
from flint import arb, fmpq, fmpq_poly

from gspot_verified.numbers.balls import working_bits
from gspot_verified.paper.section_3 import contact_motion as motion

BETAS = [fmpq(3, 2), fmpq(5, 2)]


def runge_kutta(beta: float, epsilon: float, end: float, steps: int) -> float:
    """The deviation of the force in floats: the system of the page, written again."""
    p = 0.5
    b = p / (1 - beta)
    state = [b, 2 * b / p, 0.0, b / p]

    def field(t: float, x: list[float]) -> list[float]:
        force = x[3] - x[1]
        return [beta * force, x[2] / epsilon, (x[0] - t * force) / epsilon, (-x[3] - force) / epsilon]

    h, t = (end + 0.5) / steps, -0.5
    for _ in range(steps):
        k1 = field(t, state)
        k2 = field(t + h / 2, [x + h / 2 * k for x, k in zip(state, k1, strict=True)])
        k3 = field(t + h / 2, [x + h / 2 * k for x, k in zip(state, k2, strict=True)])
        k4 = field(t + h, [x + h * k for x, k in zip(state, k3, strict=True)])
        rows = zip(state, k1, k2, k3, k4, strict=True)
        state = [x + h / 6 * (a + 2 * b + 2 * c + d) for x, a, b, c, d in rows]
        t += h
    return state[3] - state[1]


@pytest.mark.parametrize("beta", BETAS)
@pytest.mark.parametrize(("epsilon", "end"), [(fmpq(1, 20), fmpq(1, 10)), (fmpq(1, 100), fmpq(7, 100))])
def test_both_series_and_a_plain_run_agree(beta: fmpq, epsilon: fmpq, end: fmpq) -> None:
    stepwise = motion.force_by_system(beta, epsilon, end)[-1]
    at_once = motion.force_by_single_equation(beta, epsilon, end)
    plain = runge_kutta(float(beta.p) / float(beta.q), 1 / float(epsilon.q), float(end.p) / float(end.q), 4000)
    with working_bits(200):
        for value in (stepwise, at_once):
            assert value.is_finite()
            assert value.rad() < arb("1e-10")
            assert abs(value - plain) < arb("1e-6") * (1 + abs(plain))
        assert stepwise.overlaps(at_once)


def test_fewer_terms_give_a_wider_ball_that_still_overlaps(monkeypatch: pytest.MonkeyPatch) -> None:
    arguments = (fmpq(3, 2), fmpq(1, 20), fmpq(1, 10))
    sharp = motion.force_by_system(*arguments)[-1]
    monkeypatch.setattr(motion, "_TERMS", 14)
    wide = motion.force_by_system.__wrapped__(*arguments)[-1]
    assert wide.is_finite()
    assert wide.rad() > sharp.rad()
    assert wide.contains(sharp)


def test_no_finite_answer_without_the_hypothesis(monkeypatch: pytest.MonkeyPatch) -> None:
    arguments = (fmpq(3, 2), fmpq(1, 1000), fmpq(7, 100))
    monkeypatch.setattr(motion, "_TERMS", 50)
    monkeypatch.setattr(motion, "_TERMS_FROM_CENTRE", 900)
    assert not motion.force_by_system.__wrapped__(*arguments)[-1].is_finite()
    assert not motion.force_by_single_equation.__wrapped__(*arguments).is_finite()


@pytest.mark.parametrize("end", [fmpq(1, 7), fmpq(-1, 2), fmpq(-1)])
def test_an_end_off_the_steps_is_refused(end: fmpq) -> None:
    with pytest.raises(ValueError, match="end must be"):
        motion.force_by_system(fmpq(3, 2), fmpq(1, 20), end)


@pytest.mark.parametrize("end", [fmpq(0), fmpq(3, 5), fmpq(-1)])
def test_an_end_outside_the_remainder_is_refused(end: fmpq) -> None:
    with pytest.raises(ValueError, match="end must be"):
        motion.force_by_single_equation(fmpq(3, 2), fmpq(1, 20), end)


def test_the_weights_of_the_page() -> None:
    assert fmpq(1004, 1000) ** 3 <= fmpq(102, 100)


def exact_step(state: list[fmpq], start: fmpq, beta: fmpq, epsilon: fmpq, terms: int) -> tuple[list[fmpq], fmpq]:
    """Section 1 of the page in exact numbers, written again: the polynomials at the end of a step, and the rest."""
    h, c, before = motion._STEP, list(state), fmpq(0)
    total, sizes = list(state), [max(abs(value) for value in state)]
    for k in range(terms):
        b, y, v, z = c
        force = z - y
        c = [
            beta * force / (k + 1),
            *(value / (epsilon * (k + 1)) for value in (v, b - start * force - before, y - 2 * z)),
        ]
        before = force
        total = [value + new * h ** (k + 1) for value, new in zip(total, c, strict=True)]
        sizes.append(max(abs(value) for value in c) * h ** (k + 1))
    rho = (max(2 * beta, (3 + 2 * abs(start)) / epsilon) * h + 2 / epsilon * h**2) / (terms + 1)
    assert rho < 1
    return total, 2 * max(sizes[-2:]) * rho / (1 - rho)


def is_ball(ball: arb, middle: fmpq, radius: fmpq) -> bool:
    """Whether it is this ball, up to the rounding of a radius."""
    return ball.is_finite() and abs(ball.mid() - middle) < arb("1e-40") and 0 <= ball.rad() - radius < radius / 10**6


@pytest.mark.parametrize(
    ("beta", "epsilon", "start", "terms"),
    [
        (fmpq(3, 2), fmpq(1, 2), fmpq(-1, 2), 1),
        (fmpq(3, 2), fmpq(1, 2), fmpq(1, 4), 2),
        (fmpq(5, 2), fmpq(1), fmpq(-1, 2), 1),
        (fmpq(5, 2), fmpq(7), fmpq(-1, 10), 3),
        (fmpq(9), fmpq(2), fmpq(0), 2),
    ],
)
@pytest.mark.parametrize("state", [[1, 2, 3, 5], [-7, 1, 0, 0], [0, 0, 0, 1]])
def test_one_step_and_its_remainder(
    monkeypatch: pytest.MonkeyPatch, beta: fmpq, epsilon: fmpq, start: fmpq, terms: int, state: list[int]
) -> None:
    monkeypatch.setattr(motion, "_TERMS", terms)
    total, rest = exact_step([fmpq(value) for value in state], start, beta, epsilon, terms)
    with working_bits(300):
        found = motion._one_step([arb(value) for value in state], start, beta, epsilon)
        assert all(is_ball(ball, middle, rest) for ball, middle in zip(found, total, strict=True))


@pytest.mark.parametrize(("terms", "finite"), [(1, True), (0, False)])
def test_a_step_needs_a_ratio_below_1(monkeypatch: pytest.MonkeyPatch, terms: int, finite: bool) -> None:
    """The first ratio, 2 β h + 2 h², is exactly 1."""
    monkeypatch.setattr(motion, "_TERMS", terms)
    h = motion._STEP
    found = motion._one_step([arb(1)] * 4, fmpq(0), (1 - 2 * h**2) / (2 * h), fmpq(1))
    assert [ball.is_finite() for ball in found] == [finite] * 4


def test_the_coefficients_satisfy_the_equation_of_the_page() -> None:
    """(S) without Y, V, Z: ε L''' + 2 L'' + (b - tL)'/ε + (b - tL)/ε² = 0, L = b'/β."""
    beta, epsilon, t = fmpq(7, 3), fmpq(2, 5), fmpq_poly([0, 1])
    first = [fmpq(3), fmpq(-2), fmpq(5), fmpq(7)]
    with working_bits(400), pytest.MonkeyPatch.context() as patch:
        patch.setattr(motion, "_TERMS_FROM_CENTRE", 9)
        balls = motion._coefficients([arb(value) for value in first], beta, epsilon)
    assert len(balls) == 13
    b = fmpq_poly([rational(ball) / epsilon**k for k, ball in enumerate(balls)])
    force = b.derivative() / beta
    drive = b - t * force
    slope = force.derivative().derivative()
    left = epsilon * slope.derivative() + 2 * slope + drive.derivative() / epsilon + drive / epsilon**2
    assert [left[k] for k in range(9)] == [0] * 9
    assert [b[0], b[1] * epsilon, b[2] * 2 * epsilon**2, b[3] * 6 * epsilon**3] == first


def rational(ball: arb) -> fmpq:
    """The rational number with a small denominator that a narrow ball holds."""
    with working_bits(400):
        found = Fraction(int((ball.mid() * 2**300).floor().unique_fmpz()), 2**300).limit_denominator(10**30)
    assert ball.overlaps(arb(fmpq(found.numerator, found.denominator)))
    return fmpq(found.numerator, found.denominator)


@pytest.mark.parametrize("order", [0, 1, 2, 3])
@pytest.mark.parametrize("t", [fmpq(3), fmpq(-4)])
@pytest.mark.parametrize("largest", range(4))
def test_the_remainder_of_a_derivative(order: int, t: fmpq, largest: int) -> None:
    beta, epsilon, number = fmpq(5, 2), fmpq(3, 7), 1000
    x = abs(t) / epsilon
    row = [fmpq(0)] * (number + 4)
    row[3], row[number + largest] = fmpq(1), fmpq(-2) / x ** (number + largest)
    rho = 2 * x / (number + 4) + epsilon * (1 + beta) * x**3 / ((number + 3) * (number + 4))
    rho = fmpq(102, 100) * (rho + epsilon * (1 + beta) * x**4 / ((number + 2) * (number + 3) * (number + 4)))
    assert rho < 1
    rest = 4 * 2 * (number + largest) ** 3 * rho / (1 - rho) / abs(t) ** order
    polynomial = fmpq_poly(row)
    for _ in range(order):
        polynomial = polynomial.derivative()
    with working_bits(3000):
        found = motion._derivative([arb(value) for value in row], t, order, beta, epsilon)
        assert is_ball(found, polynomial(t / epsilon) / epsilon**order, rest)


def test_the_remainder_of_a_derivative_needs_a_thousand_terms_and_a_ratio_below_1() -> None:
    def finite(terms: int, t: fmpq) -> bool:
        return bool(motion._derivative([arb(0)] * (terms + 4), t, 0, fmpq(1), fmpq(1)).is_finite())

    assert finite(1000, fmpq(3))
    assert not finite(999, fmpq(3))
    assert not finite(1000, fmpq(1000))


def test_the_largest_is_a_bound_of_all() -> None:
    with working_bits(60):
        for values in ([arb(1), arb(3, 1), arb(2)], [arb(4), arb(1)], [arb(0, 4), arb(0)]):
            assert motion._largest(values) >= 4
            assert motion._largest(values) < 5
        assert motion._size([arb(-9), arb(1)]) >= 9
