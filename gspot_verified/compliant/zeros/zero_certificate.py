"""A certificate that the slow solution has two real zeros for 4 < beta < 5 and every epsilon up to one.

What the pieces prove: ``proofs/certificate.md``, slow_zeros, and ``proofs/finite_epsilon_zeros.md``, section 4. Nothing
here is trusted: ``proofs/checker`` checks each piece again without this package.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path
from typing import ClassVar, Literal

from flint import arb, fmpq

from gspot_verified.certificates.text import certificate_text, write_certificate
from gspot_verified.compliant.patches.slow_patch import rational_scale
from gspot_verified.compliant.zeros.force_certificate import NotProvable
from gspot_verified.compliant.zeros.zero_count import SYSTEM, checked_point
from gspot_verified.numbers.balls import ExactInput, hull, working_bits
from gspot_verified.numbers.verdict import NoTruthValue
from gspot_verified.numbers.written import Shown, Written
from gspot_verified.signs.cover.pieces import Column, ColumnPiece, Kind
from gspot_verified.theta_function.value.evaluate import evaluate
from gspot_verified.work.ranges import Range

_LEAST_BETA, _MOST_BETA = fmpq(4), fmpq(5)  # a hypothesis: proofs/finite_epsilon_zeros.md, section 4 (f)
_RATIO = fmpq(7, 9)  # its cube is a little less than 1/2
_PLACES = [fmpq(7 * k, 64) for k in range(9, 22)]
_FIRST_WIDTH, _LEAST_WIDTH = fmpq(1, 16), fmpq(1, 1024)  # of a column in beta: to begin with, and at last
_DIGITS = 12  # of values whose signs are wanted
_BITS = 64  # of their arithmetic


@dataclass(frozen=True, slots=True)
class SlowZerosStatement(NoTruthValue, Written):
    """Two real zeros of F_(beta-1)(.; epsilon), both simple, for every beta of a range inside [4, 5] that is not an
    integer and every epsilon in (0, epsilon]; 2 eta^3 >= epsilon."""

    version: ClassVar[int] = 3
    kind: ClassVar[Literal["slow_zeros"]] = "slow_zeros"
    ask: ClassVar[str] = ".epsilon is what is stated; that it holds is proved elsewhere"
    written: ClassVar[str] = "beta epsilon eta kind"

    beta: Range
    epsilon: fmpq
    eta: fmpq

    def __str__(self) -> str:
        return (
            f"two real zeros of {SYSTEM}, both simple, for every β in {self.beta} that is not an integer and every ε "
            f"in (0, {self.epsilon}]"
        )


@dataclass(frozen=True, slots=True)
class SlowZerosCertificate(Shown):
    """A statement and the columns that prove it."""

    statement: SlowZerosStatement
    columns: tuple[Column, ...]

    def __str__(self) -> str:
        return f"a certificate of: {self.statement}"

    def text(self) -> str:
        """The certificate as it stands in a file."""
        return certificate_text(self.statement, self.columns)

    def write(self, path: Path) -> None:
        """Write it as a file; see :func:`gspot_verified.certificates.text.write_certificate`."""
        write_certificate(path, self.statement, self.columns)


def slow_zeros_certificate(beta: Range | str, epsilon: ExactInput) -> SlowZerosCertificate:
    """That the slow solution has two real zeros for every beta of a range inside [4, 5] and every epsilon up to one.

    :raises ValueError: a range that is not inside [4, 5]; epsilon <= 0.
    :raises NotProvable: the pieces were not found; the bound is enough for epsilon up to about 17, not up to 32.

    >>> print(slow_zeros_certificate("9/2..37/8", 10).statement)
    two real zeros of λ − λ̄ on the slow manifold of the compliant model with α₁ = −1, C₁ ≠ 0, both simple, for \
every β in (9/2, 37/8) that is not an integer and every ε in (0, 10]
    """
    betas = beta if isinstance(beta, Range) else Range.parse(beta, "beta")
    small = checked_point(epsilon, "epsilon")
    if small <= 0:
        raise ValueError(f"epsilon: expected a number > 0, got {small}")
    if betas.lower is None or betas.upper is None or not _LEAST_BETA <= betas.lower < betas.upper <= _MOST_BETA:
        raise ValueError("beta: the range must lie inside [4, 5]")
    eta = rational_scale(small, 1)
    waiting, columns = _cut(betas.lower, betas.upper), []
    while waiting:
        lower, upper = waiting.pop()
        place = _place(lower - 1, upper - 1, eta)
        if place is not None:
            columns.append(Column(lower, upper, (ColumnPiece(Kind.DIP, place, place / _RATIO),)))
        elif upper - lower <= _LEAST_WIDTH:
            raise NotProvable(f"next to β = {lower} the bound of F_(β−1) is negative at no τ that was tried")
        else:
            middle = (lower + upper) / 2
            waiting += [(middle, upper), (lower, middle)]
    return SlowZerosCertificate(SlowZerosStatement(betas, small, eta), tuple(columns))


def _cut(lower: fmpq, upper: fmpq) -> list[tuple[fmpq, fmpq]]:
    """The range at the multiples of the first width, the last part first."""
    ends = [lower]
    while ends[-1] < upper:
        ends.append(min(upper, ((ends[-1] / _FIRST_WIDTH).floor() + 1) * _FIRST_WIDTH))
    return list(pairwise(ends))[::-1]


def _place(lower: fmpq, upper: fmpq, eta: fmpq) -> fmpq | None:
    """A tau at which the bound is negative for b in [lower, upper]; the most negative one in the middle."""
    middle = (lower + upper) / 2
    best = min(_PLACES, key=lambda tau: float(_bound(tau, arb(middle), eta)))
    with working_bits(_BITS):
        box = hull([arb(lower), arb(upper)])
    return best if _bound(best, box, eta) < 0 else None


def _bound(tau: fmpq, b: arb, eta: fmpq) -> arb:
    """Theta + eta/(8 gamma) [mu^(b-1) Theta'(tau/mu, b) - Theta'(tau, b)], 3 gamma = 1 - mu^3 (the page, 4 (f))."""
    value = evaluate(tau, b, digits=_DIGITS).value
    slope, beyond = (evaluate(place, b, 1, digits=_DIGITS).value for place in (tau, tau / _RATIO))
    with working_bits(_BITS):
        weight = 3 * eta / (8 * (1 - _RATIO**3))
        return value + weight * (arb(_RATIO) ** (b - 1) * beyond - slope)
