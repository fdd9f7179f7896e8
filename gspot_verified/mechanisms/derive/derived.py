"""The functions of Sec. 2 of a mechanism, by their letters in the paper."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Generic, TypeVar

T = TypeVar("T")


@dataclass(frozen=True)
class Derived(Generic[T]):
    """The fields and functions of a mechanism: expressions, or sympy functions on the second route.

    ``x`` is None where the slip velocity u is given instead, as in rolling: then no x with u = L_F x need exist.
    """

    F: tuple[T, ...]
    G_T: tuple[T, ...]
    G_N: tuple[T, ...]
    G: tuple[T, ...]
    x: T | None
    y: T
    u: T
    v: T
    a: T
    b: T
    A: T
    B: T
    C: T
    p: T
    alpha_1: T
    alpha_2: T
    alpha_3: T
    mu: T
    mass_matrix: tuple[tuple[T, ...], ...] | None

    @property
    def inertia(self) -> tuple[tuple[T, ...], ...]:
        """What must be positive definite: the mass matrix; A, B, B, C where none is given (paper, Sec. 1.1)."""
        return self.mass_matrix or ((self.A, self.B), (self.B, self.C))
