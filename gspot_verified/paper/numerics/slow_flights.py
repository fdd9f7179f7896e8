"""Exactly one flight and then an impact without collision: slow trajectories, for every epsilon up to a largest one.

Proof page: ``proofs/flight.md``, section 5.
"""

from __future__ import annotations

from dataclasses import dataclass

from flint import arb, fmpq

from gspot_verified.compliant.slow.grid import scale
from gspot_verified.compliant.slow.slow_solution import slow_value
from gspot_verified.leading_order.contact_force import rational
from gspot_verified.numbers.balls import ExactInput, ball_text, working_bits
from gspot_verified.numbers.evidence import at_most, every, less, theorem
from gspot_verified.numbers.verdict import Evidence, Reason, Verdict
from gspot_verified.theta_function.value.evaluate import evaluate

_DIGITS = 20
_BITS = 128
_Q = fmpq(3, 2)
LATEST = fmpq(1, 4)


@dataclass(frozen=True, slots=True)
class _Moments:
    """x_0 ... x_3 of the page at one tau: for eta = 0 and for the largest eta; between them for every eta between."""

    least: tuple[arb, ...]
    most: tuple[arb, ...]


def one_flight(beta: ExactInput, largest: ExactInput, tau: ExactInput, latest: ExactInput = LATEST) -> Verdict:
    """Theorem F6 for every epsilon <= ``largest``: every slow trajectory with alpha_2 < 0 whose contact ends with
    lift-off at tau_lo >= ``tau``, t_lo <= ``latest``, makes exactly one flight, then an impact without collision.

    In the normal form; tau = (2 epsilon^2)^(-1/3) t. Proved, or undecided: the inequalities are sufficient only.

    :raises TypeError: a float.
    :raises ValueError: a ball; beta not in (1, 2) or (2, 3); largest, tau or latest not positive.

    >>> one_flight("3/2", "1/100", 2).outcome.value
    'proved'
    """
    power, small = rational(beta, "beta"), rational(largest, "largest")
    place, time = rational(tau, "tau"), rational(latest, "latest")
    if not (1 < power < 3 and power != 2):
        raise ValueError(f"beta: expected a number in (1, 2) or (2, 3), got {power}")
    for name, value in (("largest", small), ("tau", place), ("latest", time)):
        if not value > 0:
            raise ValueError(f"{name}: expected a number > 0, got {value}")
    text = (
        f"β = {power}, α₂ < 0, every ε <= {small} (normal form): a slow trajectory whose contact ends with lift-off at "
        f"τ_lo >= {place}, t_lo <= {time}, makes exactly one flight and then takes an impact without collision"
    )
    with working_bits(_BITS):
        in_range = _in_range(power, small, place, time)
        if in_range is None:
            return Verdict.undecided(text, Reason.HYPOTHESIS, "the bounds (6) on q_l and kappa do not hold")
        margin = _least_margin(power, place, _moments(power, small, place))
        holds = theorem("proofs/flight.md", in_range, less(0, margin))
        if holds is None:
            return Verdict.undecided(
                text, Reason.HYPOTHESIS, f"the inequalities (7): least margin {ball_text(margin, 5)}"
            )
        return Verdict.proved(text, holds, f"least margin of the inequalities (7): {ball_text(margin, 5)}")


def _in_range(beta: fmpq, largest: fmpq, tau: fmpq, latest: fmpq) -> Evidence | None:
    """(6): monotone in kappa and q_l, so at the largest ones; q_l >= 4 kappa^(2/3) is tau^3 >= 32 (beta - 1)^2."""
    kappa, end = arb(largest * (beta - 1)), arb(latest)
    total = 6 * _Q * _Q * end + (12 * _Q * kappa * end.sqrt()).sqrt() + 2 * kappa
    return every([at_most(32 * (beta - 1) ** 2, tau**3), at_most(kappa, fmpq(27, 64)), at_most(total, 4)])


def _moments(beta: fmpq, largest: fmpq, tau: fmpq) -> _Moments:
    """x_j(tau; eta) = Gamma(j - b) G_(b-j)(tau; eta), b = beta - 1; it increases with eta."""
    b, eta = beta - 1, scale(largest)
    least, most = [], []
    for j in range(4):
        gamma = arb(j - b).gamma()
        least.append(gamma * evaluate(tau, b - j, digits=_DIGITS).value)
        value = slow_value(arb(tau) / eta, b - j, largest, digits=_DIGITS).value
        most.append(gamma * eta ** arb(b - j) * value)
    return _Moments(tuple(least), tuple(most))


def _least_margin(beta: fmpq, tau: fmpq, x: _Moments) -> arb:
    """The least of the differences in (7), and of x_0 and x_1, which must be positive."""
    low, high = x.least, x.most
    root = _Q * arb(2 * tau).sqrt()
    differences = [
        low[0],
        low[1],
        low[2] - tau / 2 * high[0],
        tau * low[1] - (2 * beta - 1) * high[0],
        tau * low[2] - (2 * beta - 2) * high[1],
        tau * low[3] - max(fmpq(0), 2 * beta - 3) * high[2],
        root * low[1] - high[2],
        root * low[0] - high[1],
    ]
    least = differences[0]
    for difference in differences[1:]:
        least = least.min(difference)
    return least
