"""The coefficient of restitution of the compliant contact: enclosures of it, and the bounds that give its limits.

Proof page: ``proofs/restitution.md``, Theorems Q1 to Q3.
"""

from __future__ import annotations

from flint import arb, arb_mat, fmpq

from gspot_verified.numbers.balls import ball, hull, nonfinite, working_bits

BITS = 1024
_STEP = fmpq(1, 64)
_MAX_STEPS = 64_000
_TERMS = 16


def restitution(rho: fmpq, zeta: fmpq) -> arb:
    """An enclosure of e = v(t_1) for rho = k_1/k_2 and zeta = c sqrt(p/k_2); not finite when the budget ended.

    :raises ValueError: rho or zeta is not positive.

    >>> restitution(fmpq(1), fmpq(1))
    [0.7026 +/- 5.94e-5]
    """
    if not (rho > 0 and zeta > 0):
        raise ValueError(f"rho and zeta must be positive, got {rho} and {zeta}")
    with working_bits(BITS):
        step = ball(min(_STEP, zeta / (8 * (1 + rho))))
        rate, during = fmpq(1) / zeta, hull([step, arb(0)])
        matrix = arb_mat([[0, 1, 0], [-1, 0, 1], [rate, 0, -(rho + 1) * rate]])
        moved, within = (matrix * step).exp(), (matrix * during).exp()
        force = arb_mat([[-1, 0, 1]])
        state = arb_mat([[0], [-1], [0]])
        for _ in range(_MAX_STEPS):
            along, after = within * state, moved * state
            first, last = (force * state)[0, 0], (force * after)[0, 0]
            slope = _range(force * matrix, matrix, state, along, during)
            if slope < 0 and last < 0:
                return state[1, 0] + during * hull([first, arb(0)])
            positive = slope > 0 or (slope < 0 and last > 0) or _range(force, matrix, state, along, during) > 0
            if not positive:
                break
            state = after
    return nonfinite()


def _range(row: arb_mat, matrix: arb_mat, state: arb_mat, along: arb_mat, time: arb) -> arb:
    """row x(t) for all times of a step, x' = matrix x: Taylor's formula at its beginning; ``along`` holds x there."""
    total, power = arb(0), arb(1)
    for k in range(_TERMS):
        total += (row * state)[0, 0] * power
        row, power = row * matrix, power * time / (k + 1)
    return total + (row * along)[0, 0] * power


def elastic_loss(rho: fmpq, zeta: fmpq) -> arb:
    """An upper bound of 1 - e^2, the least that Theorem Q2 gives."""
    with working_bits(BITS):
        found = [2 / ball(rho)]
        if zeta >= 11:
            found.append(8 / ball(zeta))
        omega, h = ball(rho / (1 + rho)).sqrt(), ball(zeta / (1 + rho) ** 2)
        if 12 * h <= omega:
            found.append(h * (8 / omega + ball(zeta / rho)))
        least = found[0]
        for bound in found[1:]:
            least = least.min(bound)
        return least.upper()


def inelastic_bound(rho: fmpq, zeta: fmpq) -> arb:
    """An upper bound of e, by Theorem Q3."""
    with working_bits(BITS):
        return (ball(zeta) + ball(rho).sqrt() / ball(zeta) * ball(1 + rho)).upper()
