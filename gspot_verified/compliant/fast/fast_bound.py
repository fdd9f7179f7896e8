"""A bound of |c_+| that serves every epsilon up to a largest one: no quadrature of the fast part at small epsilon.

Proof page: ``proofs/first_integrals.md``, section 5.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

from flint import acb, arb, fmpq

from gspot_verified.compliant.fast.fast_coefficient import FastPath, saddle
from gspot_verified.compliant.model.kernel import Kernel, kernel
from gspot_verified.compliant.model.normal_form import Deviation
from gspot_verified.numbers.balls import hull, nonfinite, working_bits

_BITS = 64  # of a bound, of which a few digits count; any number is right
_PARTS = 400  # boxes on each half of the path: more of them make the bound less


@dataclass(frozen=True, slots=True)
class FastBound:
    """|c_+| <= size e^(rate (1/epsilon - 1/largest)) for 0 < epsilon <= largest, the hats of the state kept fixed."""

    largest: fmpq
    size: arb
    rate: arb

    def at(self, epsilon: fmpq) -> arb:
        """The bound at one epsilon; not finite unless 0 < epsilon <= largest."""
        if not 0 < epsilon <= self.largest:
            return nonfinite()
        with working_bits(_BITS + int(epsilon.height_bits())):
            return self.size * (self.rate * (1 / arb(epsilon) - 1 / arb(self.largest))).exp()


def fast_bound(state: Deviation, largest: fmpq) -> FastBound:
    """The bound for every epsilon <= ``largest``, with p and the hats b, V, Y, Z of ``state``.

    ``rate`` is a bound of epsilon Re(exponent) on the whole path, just above its value Re g(r_+) < 0 at the saddle.
    Hypotheses, checked, else not finite: p > 0, ``largest`` > 0, and that ``rate`` holds before and beyond the boxes.
    """
    if not (state.p > 0 and largest > 0):
        return FastBound(largest, nonfinite(), nonfinite())
    with working_bits(_BITS):
        data, top = kernel(replace(state, epsilon=largest)), saddle(state.p)
        path = FastPath(data, top, _BITS)
        first, last = path.first(), path.last()
        boxes = [*_from_minus_one(data, top, first), *_to_infinity(data, top, last)]
        rate = boxes[0].rate
        for box in boxes:
            rate = rate.max(box.rate)
        # Beyond the boxes Re E falls: that is a hypothesis of path.beyond. Before them it is at most ``start``.
        start = data.epsilon * path.exponent_before(first)
        if not start <= rate:
            return FastBound(largest, nonfinite(), nonfinite())
        size = path.before(first) + path.beyond(last)
        for box in boxes:
            size += box.front * (box.rate / data.epsilon - path.height).exp()
        size = size * path.height.exp() * data.beta / (2 * arb.pi())
        return FastBound(largest, size.abs_upper(), rate.upper())


@dataclass(frozen=True, slots=True)
class _Box:
    """A part of the path: a bound of Re E, E = epsilon times the exponent, and one of length |s|^(beta-1) |k|."""

    rate: arb
    front: arb


def _from_minus_one(data: Kernel, top: acb, first: arb) -> Iterator[_Box]:
    """1 + s = (1 + r_+) e^u: dE/du = P(s) = s^3 + 2 s^2 + p s + p."""
    log_start = (1 + top).log()

    def exponent(u: arb) -> acb:
        s = (1 + top) * u.exp() - 1
        return log_start + u + s * (data.p - 1 + s / 2 + s * s / 3)

    for whole, middle in _parts(first, arb(0)):
        rest = (1 + top) * whole.exp()
        s = rest - 1
        slope = data.p * (1 + s) + s * s * (s + 2)
        yield _box(data, s, data.polynomial(s, rest), exponent(middle).real, slope.real, _reach(whole, middle))


def _to_infinity(data: Kernel, top: acb, last: arb) -> Iterator[_Box]:
    """s = r_+ + e^(i pi/3) rho: dE/drho = e^(i pi/3) P(s)/(1 + s)."""
    direction = acb(arb(fmpq(1, 2)), arb(3).sqrt() / 2)

    def exponent(rho: arb) -> acb:
        s = top + direction * rho
        return (1 + s).log() + s * (data.p - 1 + s / 2 + s * s / 3)

    for whole, middle in _parts(last, arb(0)):
        s = top + direction * whole
        slope = direction * (data.p + s * s * (s + 2) / (1 + s))
        yield _box(
            data, s, data.polynomial(s, 1 + s) / (1 + s), exponent(middle).real, slope.real, _reach(whole, middle)
        )


def _box(data: Kernel, s: acb, rest: acb, middle: arb, slope: arb, reach: arb) -> _Box:
    """Re E <= its value in the middle + |slope| reach (mean value theorem); the piece is at most 2 reach long."""
    power = abs(s) ** (data.beta - 1)
    return _Box((middle + abs(slope) * reach).upper(), (2 * reach * power * abs(rest)).abs_upper())


def _reach(whole: arb, middle: arb) -> arb:
    """How far a number of ``whole`` is from ``middle``, at most: rounded, so a little more than half the width."""
    return (whole - middle).abs_upper()


def _parts(far: arb, near: arb) -> Iterator[tuple[arb, arb]]:
    """Pieces that cover what lies between ``far`` and ``near``, as (ball, a number in it), the finer the nearer to
    ``near``."""
    for k in range(_PARTS):
        begin, end = (near + (far - near) * fmpq(j**2, _PARTS**2) for j in (k, k + 1))
        yield hull([begin, end]), ((begin + end) / 2).mid()
