"""The compliance of the contact: c z' = -k_1 z - λ_N, λ_N = k_2 (z - y) while y < z.

Paper, Sec. 2, eqs. compliant1 and compliant2; there k_1 = k_2 = 1/ε^2 and c = 1/ε (eq. compliant3). Here
k_1 = κ_1/ε^2, k_2 = κ_2/ε^2, c = γ/ε with any exact κ_1, κ_2 > 0, γ >= 0. With z = ε^2 Z, y = ε^2 Y

    Z = -λ/κ_1 - (γ/κ_1) ε Z',    Y = Z - λ/κ_2 = -h λ - (γ/κ_1) ε Z',    h = 1/κ_1 + 1/κ_2.

The leading order holds h alone: it is the paper's (h = 2) with ε sqrt(h/2) in the place of ε.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from flint import fmpq

from gspot_verified.numbers.balls import ExactInput, exact

NO_DAMPER = "the contact has no damper (c = 0): nothing is damped"
"""Why nothing is said of what remains as ε → 0."""


@dataclass(frozen=True)
class Regularisation:
    """k_1 = ``k_1``/ε^2, k_2 = ``k_2``/ε^2, c = ``c``/ε.

    :raises TypeError: a number that is not exact, as a float.
    :raises ValueError: not rational, k_1 or k_2 not positive, or c negative.

    >>> Regularisation.of(2, 1, "1/2").compliance
    3/2
    """

    k_1: fmpq
    k_2: fmpq
    c: fmpq

    def __post_init__(self) -> None:
        for name in ("k_1", "k_2", "c"):
            value = exact(getattr(self, name), name)
            if not isinstance(value, fmpq):
                raise ValueError(f"{name} must be a rational number, got a ball")
            object.__setattr__(self, name, value)
        if not (self.k_1 > 0 and self.k_2 > 0 and self.c >= 0):
            raise ValueError(f"the contact needs k_1 > 0, k_2 > 0, c >= 0, got {self.k_1}, {self.k_2}, {self.c}")

    @classmethod
    def of(cls, k_1: ExactInput, k_2: ExactInput, c: ExactInput) -> Regularisation:
        """The same from exact inputs."""
        given: Any = (k_1, k_2, c)
        return cls(*given)

    @property
    def compliance(self) -> fmpq:
        """h = 1/κ_1 + 1/κ_2."""
        return 1 / self.k_1 + 1 / self.k_2

    @property
    def delay(self) -> fmpq:
        """γ/κ_1."""
        return self.c / self.k_1

    @property
    def is_papers(self) -> bool:
        """Whether it is that of eq. compliant3."""
        return bool(self.k_1 == 1 and self.k_2 == 1 and self.c == 1)


PAPER = Regularisation(fmpq(1), fmpq(1), fmpq(1))
"""Eq. compliant3."""
