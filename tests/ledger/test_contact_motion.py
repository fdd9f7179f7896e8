"""The two power series of proofs/contact_motion.md against each other, and against a plain Runge-Kutta run."""

from __future__ import annotations

import pytest
from flint import arb, fmpq

from gspot_verified.balls import working_bits
from gspot_verified.ledger import contact_motion as motion

BETAS = [fmpq(3, 2), fmpq(5, 2)]


def runge_kutta(beta: float, eps: float, end: float, steps: int) -> float:
    """The deviation of the force in floats: the system of the page, written again."""
    p = 0.5
    b = p / (1 - beta)
    state = [b, 2 * b / p, 0.0, b / p]

    def field(t: float, x: list[float]) -> list[float]:
        force = x[3] - x[1]
        return [beta * force, x[2] / eps, (x[0] - t * force) / eps, (-x[3] - force) / eps]

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
@pytest.mark.parametrize(("eps", "end"), [(fmpq(1, 20), fmpq(1, 10)), (fmpq(1, 100), fmpq(7, 100))])
def test_both_series_and_a_plain_run_agree(beta: fmpq, eps: fmpq, end: fmpq) -> None:
    stepwise = motion.force_by_system(beta, eps, end)[-1]
    at_once = motion.force_by_single_equation(beta, eps, end)
    plain = runge_kutta(float(beta.p) / float(beta.q), 1 / float(eps.q), float(end.p) / float(end.q), 4000)
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
