"""Cones of states in contact in which lambda_N grows, and the inequalities that keep a motion in them.

Proof page: ``proofs/invariant_region.md``, Theorems R1 and R4. Which numbers a and c are tried is a heuristic.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Protocol

from flint import arb, fmpq

from gspot_verified.numbers.balls import approximate
from gspot_verified.scenes.motions.contact_form import ContactBounds, ContactForm

_TRIES = 12  # rates a of a fast cone, each less by the root of 2
_SLOW_TRIES = 10  # rates a of a slow cone, likewise
_LARGEST_C = 0.9  # of what c may be, so that room is left; any cone is tested
_SLOW_SHARES = 3  # values of c for each a, each the half of the last
_LESS = 0.75  # of the slope, beside twice the loads: the box that a likely cone has room for


@dataclass(frozen=True)
class ContactPoint:
    """λ, W = -V, G = -F, D = λ', S = κW + G of the states at one time, and the ball of -∂F/∂λ there."""

    force: arb
    W: arb
    G: arb
    D: arb
    S: arb

    @classmethod
    def of(cls, form: ContactForm, box: list[arb]) -> ContactPoint:
        """``box``: the states, the clock, and λ."""
        Y, V, force = box[form.Y], box[form.V], box[-1]
        acceleration = form.acceleration(box)
        rate = -form.s * force - form.kappa * form.k * Y - form.k * V
        return cls(force, -V, -acceleration, rate, -form.kappa * V - acceleration)


class GrowthCone(Protocol):
    """Keeps the motion that is in it, with λ' >= ``rate`` λ, for as long as :meth:`is_kept`."""

    @property
    def rate(self) -> arb:
        """a."""
        ...

    def is_kept(self, bounds: ContactBounds) -> bool:
        """Whether the hypothesis holds wherever these bounds do and λ is not below its value at the beginning."""
        ...

    def is_kept_for_ever(self, bounds: ContactBounds) -> bool:
        """The same for every larger q, where H is a constant plus a constant times λ."""
        ...


@dataclass(frozen=True)
class FastCone:
    """D >= aλ, kS >= a(s + a)λ: Theorem R1."""

    form: ContactForm
    rate: arb
    force: arb

    def is_kept(self, bounds: ContactBounds) -> bool:
        """kq >= a(s + a) + kh/a."""
        return bool(-self.form.k * bounds.slope >= _fast_bound(self.form, self.rate, _load(bounds, self.force)))

    def is_kept_for_ever(self, bounds: ContactBounds) -> bool:
        """The same inequality: it holds for every larger q."""
        return self.is_kept(bounds)


@dataclass(frozen=True)
class SlowCone:
    """D >= aλ, kS >= a(D + sλ), κG >= aS, D >= cS: Theorem R4."""

    form: ContactForm
    rate: arb
    c: arb
    force: arb
    S: arb

    def is_kept(self, bounds: ContactBounds) -> bool:
        """Both inequalities, for the q of these bounds."""
        return self._is_kept(bounds, -bounds.slope)

    def is_kept_for_ever(self, bounds: ContactBounds) -> bool:
        """Both for all q from here on up to where the motion lies in the cone of Theorem R1 and that one is kept."""
        largest = _fast_bound(self.form, self.rate, _load(bounds, self.force)) / self.form.k
        return self._is_kept(bounds, -bounds.slope) and self._is_kept(bounds, (-bounds.slope).max(largest))

    def _is_kept(self, bounds: ContactBounds, q: arb) -> bool:
        form, a, c = self.form, self.rate, self.c
        load = _load(bounds, self.force)
        relief, lift = (-bounds.factor).max(arb(0)), (-bounds.constant).max(arb(0))
        grows = (form.kappa - a) * c * (q - load / a) >= a * a
        left = form.k - c * (form.kappa + form.s) - c * c * q - c * c * relief / a
        return bool(a > 0 and a < form.kappa and grows and left >= 0 and left * self.S >= c * lift)


def cones(form: ContactForm, at: ContactPoint, bounds: ContactBounds) -> Iterator[GrowthCone]:
    """Cones that certainly hold all states at this point, and that may be kept; fast growth first."""
    if not (at.force > 0 and at.W >= 0 and at.G >= 0 and bounds.slope < 0):
        return
    k, s = form.k, form.s
    for i in range(_TRIES):
        a = arb(approximate(-bounds.slope) / 2 ** (1 + i / 2))
        if a > 0 and a * at.force <= at.D and k * at.S >= a * (s + a) * at.force:
            yield FastCone(form, a, at.force)
    if not (at.S > 0 and at.D > 0):
        return
    M = at.D + s * at.force
    largest = min(*(approximate(value) for value in (at.D / at.force, k * at.S / M, form.kappa * at.G / at.S)))
    most = _LARGEST_C * min(approximate(at.D / at.S), approximate(k / (form.kappa + s)))
    for i in range(_SLOW_TRIES):
        a = arb(min(largest, approximate(form.kappa) / 2) * 2 ** (-(i + 0.01) / 2))
        if not (a > 0 and a * at.force <= at.D and k * at.S >= a * M and form.kappa * at.G >= a * at.S):
            continue
        for j in range(_SLOW_SHARES):
            c = arb(most * 2**-j)
            if c > 0 and c * at.S <= at.D:
                yield SlowCone(form, a, c, at.force, at.S)


def likely_first(candidates: list[GrowthCone], bounds: ContactBounds) -> list[GrowthCone]:
    """The cones that have room for a box of states come first."""
    wider = replace(
        bounds, slope=bounds.slope * _LESS, factor=abs(bounds.factor) * 2, constant=abs(bounds.constant) * 2
    )
    return sorted(candidates, key=lambda cone: not cone.is_kept(wider))


def _load(bounds: ContactBounds, force: arb) -> arb:
    """h >= 0 with H <= hλ as long as λ >= its value ``force`` at the beginning."""
    return (bounds.factor + bounds.constant.max(arb(0)) / force).max(arb(0))


def _fast_bound(form: ContactForm, a: arb, load: arb) -> arb:
    """What kq must not fall below in Theorem R1."""
    total: fmpq = form.s
    return a * (total + a) + form.k * load / a
