"""The states between p = 0 and a small p, as far as p, b, y, v say them: a cone along rigid slip.

Proof page: ``proofs/chart.md``.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from flint import arb, fmpq

from gspot_verified.numbers.balls import Exact, add_remainder, ball, hull


@dataclass(frozen=True)
class Cone:
    """``first`` <= p <= ``last``, \\|b/p + ``middle``\\| <= ``beside``, \\|y\\| <= ``height`` p^3, \\|v\\| <= ``speed``
    p^2."""

    first: fmpq
    last: fmpq
    middle: Exact
    beside: fmpq
    height: fmpq
    speed: fmpq

    @property
    def force(self) -> arb:
        """-b/p."""
        return add_remainder(ball(self.middle), ball(self.beside))

    def rows(self, count: int) -> list[list[arb]]:
        """The terms of orders below ``count`` of (p, b, y, v) = (p, -force p, Y p^3, V p^2) at p + t, for all of it."""
        p, zero, force = hull([ball(self.first), ball(self.last)]), arb(0), self.force
        height, speed = add_remainder(zero, ball(self.height)), add_remainder(zero, ball(self.speed))
        known = [
            [p, -force * p, height * p**3, speed * p**2],
            [arb(1), -force, 3 * height * p**2, 2 * speed * p],
            [zero, zero, 3 * height * p, speed],
            [zero, zero, height, zero],
        ]
        return [known[n] if n < len(known) else [zero] * 4 for n in range(count)]

    @property
    def place(self) -> list[arb]:
        """A box around its p, b, y, v."""
        return self.rows(1)[0]

    @property
    def tip(self) -> Cone:
        """p = 0."""
        return replace(self, first=fmpq(0), last=fmpq(0))

    def slabs(self, count: int) -> list[Cone]:
        """So many that cover it, each with its share of the forces."""
        half = self.beside / count
        return [replace(self, middle=self.middle + (2 * k + 1 - count) * half, beside=half) for k in range(count)]

    def pieces(self, count: int) -> list[Cone]:
        """So many that cover it, each with its share of p, from below."""
        step = (self.last - self.first) / count
        return [replace(self, first=self.first + step * k, last=self.first + step * (k + 1)) for k in range(count)]


def joined_cones(cones: Sequence[Cone]) -> Cone:
    """One that holds all, which have p and the middle of the force in common."""
    first, *others = cones
    return replace(
        first,
        beside=max([first.beside, *(one.beside for one in others)]),
        height=max([first.height, *(one.height for one in others)]),
        speed=max([first.speed, *(one.speed for one in others)]),
    )


def ray_of(cone: Cone, p: arb, force: arb) -> Cone:
    """The cone up to every p of a ball, with -b/p in another ball."""
    least, most = rational_of(force.lower()), rational_of(force.upper())
    return replace(cone, last=rational_of(p.upper()), middle=(least + most) / 2, beside=(most - least) / 2)


def rational_of(value: arb) -> fmpq:
    """An exact ball as a rational number.

    :raises ValueError: it is not exact, or not finite.
    """
    mantissa, exponent = value.man_exp()
    return fmpq(mantissa) * fmpq(2) ** int(exponent)
