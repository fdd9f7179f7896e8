"""Points at which a statement about the sign of dTheta/dtau fails. The choice of points is a heuristic; each sign is
certain."""

from __future__ import annotations

from flint import arb, fmpq

from gspot_verified.numbers.evidence import signed
from gspot_verified.theta_function.value.evaluate import evaluate
from gspot_verified.theta_function.value.integer import polynomial
from gspot_verified.work.ranges import Range

_MAX_TAU = 10**12  # as far as routes.py evaluates
_MAX_BETA = 10**4  # likewise
_MAX_BITS = 4_000  # of numerator and denominator; a longer point is no witness
_MAX_DEGREE = 400  # of an integer polynomial that is evaluated exactly
_MAX_INTEGERS = 24  # of an infinite range that are tried
_NEAR = (fmpq(1, 2**3), fmpq(1, 2**10), fmpq(1, 2**60), fmpq(1, 2**200))


def sign_at(tau: fmpq, beta: fmpq) -> int | None:
    """The certain sign of dTheta/dtau at one point, 0 included at an integer beta; None when it is not found.

    >>> sign_at(fmpq(0), fmpq(3)), sign_at(fmpq(1), fmpq(1, 2))
    (0, -1)
    """
    value = value_at(tau, beta)
    certain_sign = None if value is None else signed(value)
    return None if certain_sign is None else certain_sign[0]


def value_at(tau: fmpq, beta: fmpq) -> fmpq | arb | None:
    """dTheta/dtau at one point, exact at an integer beta; None beyond what is evaluated."""
    if beta.q == 1 and 0 <= beta.p <= _MAX_DEGREE:
        return fmpq(-beta * polynomial(max(int(beta.p) - 1, 0))(tau))
    if abs(tau) > _MAX_TAU or abs(beta) > _MAX_BETA or max(tau.height_bits(), beta.height_bits()) > _MAX_BITS:
        return None
    return evaluate(tau, beta, derivative=1, digits=3).value


def find_witness(tau: Range, beta: Range, sign: int) -> tuple[fmpq, fmpq] | None:
    """A point of the two ranges where dTheta/dtau certainly has another sign than ``sign``, if one is met."""
    for b in _samples(beta, _beta_points(beta)):
        for t in _samples(tau, [fmpq(0), fmpq(3, 4), fmpq(-3, 4), fmpq(5), fmpq(-5)]):
            certain_sign = sign_at(t, b)
            if certain_sign is not None and certain_sign != sign:
                return t, b
    return None


def _beta_points(beta: Range) -> list[fmpq]:
    """0, where dTheta/dtau vanishes identically, then integers of the range, where zero curves meet tau = 0."""
    lower = -1 if beta.lower is None else int((beta.lower).ceil())
    upper = lower + _MAX_INTEGERS if beta.upper is None else int((beta.upper).floor())
    return [fmpq(0)] + [fmpq(n) for n in range(lower, min(upper, lower + _MAX_INTEGERS) + 1)]


def _samples(values: Range, special: list[fmpq]) -> list[fmpq]:
    points = list(special)
    lower, upper = values.lower, values.upper
    if lower is not None and upper is not None:
        points += [lower, upper, (lower + upper) / 2]
        points += [end + side * (upper - lower) * d for d in _NEAR for end, side in ((lower, 1), (upper, -1))]
    elif lower is not None:
        points += [lower, *(lower + d for d in _NEAR), lower + 1, lower + 10]
    elif upper is not None:
        points += [upper, *(upper - d for d in _NEAR), upper - 1, upper - 10]
    else:
        points += [fmpq(30), fmpq(-30)]
    return [point for point in points if values.contains(point)]
