"""The slow manifold where the alphas are polynomials in p and b, by polynomials in h, r and L, and its reference force.

Proof page: ``proofs/from_state.md``, section 8. Exact rationals; h = e/p^(3/2), r = sqrt(p), L the excess of -b/p over
the reference force. The names are those of the page: V = h r u, W = r^2 w, phi = r^2 f.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from flint import Ordering, fmpq, fmpq_mpoly, fmpq_mpoly_ctx

from gspot_verified.expansion.from_state.affine_system import AffineSystem
from gspot_verified.expansion.from_state.slow_series import RING as LEVEL
from gspot_verified.expansion.from_state.slow_series import Contact, terms_of

RING = fmpq_mpoly_ctx.get(("h", "r", "L"), Ordering.lex)
H, R, L = RING.gens()
_ROUNDS = 200  # of the iteration, which ends far before


@dataclass(frozen=True)
class Cut:
    """h^i r^n L^k is kept for i <= ``order`` and n + (k - 1) mu <= ``weight``, mu = 2 beta - 2."""

    order: int
    weight: fmpq
    mu: fmpq

    def of(self, polynomial: fmpq_mpoly, fewer: int = 0) -> fmpq_mpoly:
        """What is kept, with the order less ``fewer``."""
        return _chosen(polynomial, lambda i, n, k: i <= self.order - fewer and n + (k - 1) * self.mu <= self.weight)


@dataclass(frozen=True)
class SlowManifold:
    """``force`` is the reference, free of L; u, w, f; ``fall``, ``back``, ``slow`` are A_1, A_3, S of the page.

    ``residual`` is (F_1, F_2, F_3), which vanish but for what was cut; ``drift`` is D.
    """

    system: AffineSystem
    force: fmpq_mpoly
    u: fmpq_mpoly
    w: fmpq_mpoly
    f: fmpq_mpoly
    fall: fmpq_mpoly
    back: fmpq_mpoly
    slow: fmpq_mpoly
    residual: tuple[fmpq_mpoly, fmpq_mpoly, fmpq_mpoly]
    drift: fmpq_mpoly

    @property
    def beta(self) -> fmpq:
        """alpha_3/alpha_1 at the G-spot."""
        return self.system.beta

    @property
    def mu(self) -> fmpq:
        """2 beta - 2: \\|L\\| is nearly a multiple of r^mu."""
        return 2 * self.beta - 2

    @property
    def contact(self) -> Contact:
        """kappa, g, l."""
        return Contact.of(self.system.regularisation)

    @property
    def feeding(self) -> tuple[fmpq_mpoly, fmpq_mpoly, fmpq_mpoly]:
        """What x_2 feeds into x_1, x_2, x_3 besides r, 0, (l/g) r, over h r."""
        u, w, f = (self.back * one.derivative(2) for one in (self.u, self.w, self.f))
        return H * u, self.back - self.fall + w, R * f

    @property
    def coupling(self) -> tuple[fmpq_mpoly, fmpq_mpoly, fmpq_mpoly]:
        """The same at L = 0."""
        first, second, third = (without_excess(one) for one in self.feeding)
        return first, second, third

    @property
    def level_fall(self) -> fmpq_mpoly:
        """A_1 at L = 0."""
        return without_excess(self.fall)


def slow_manifold(system: AffineSystem, cut: Cut) -> SlowManifold:
    """The polynomials that the iteration of section 8 leaves as they are."""
    contact, beta = Contact.of(system.regularisation), system.beta
    kappa, rate, lag = contact.kappa, contact.rate, contact.lag
    force, u, w, f = RING.constant(system.mean_force), *[RING.constant(0)] * 3
    for _ in range(_ROUNDS):
        rules = _Rules.of(system, force, w)
        fall, back = rules.fall, rules.back
        pushed = rules.driven + back * w - rate * R * (f / H) - rules.along(w)
        followed = H * H * (fall * u + rules.along(u))
        lagged = lag / rate * w - H * R * (rules.along(f) - fall * f)
        left = still_terms(cut.of(rules.slow))
        after = cut.of(pushed / kappa, 1), cut.of(followed), cut.of(lagged / rate)
        if (u, w, f) == after and not left:
            residual = (w - followed) / H, pushed - kappa * u, (lagged - rate * f) / H
            drift = _drift(rules.slow, fall, beta, cut)
            return SlowManifold(
                system, force, u, w, f, fall=fall, back=back, slow=rules.slow, residual=residual, drift=drift
            )
        u, w, f = after
        force -= RING.from_dict({(i, n, 0): value / (beta - 1 + fmpq(3 * i - n, 2)) for (i, n), value in left.items()})
    raise ArithmeticError("the iteration has not ended")


@dataclass(frozen=True)
class _Rules:
    """How polynomials change on the slow manifold."""

    fall: fmpq_mpoly
    back: fmpq_mpoly
    driven: fmpq_mpoly
    slow: fmpq_mpoly

    @classmethod
    def of(cls, system: AffineSystem, force: fmpq_mpoly, w: fmpq_mpoly) -> _Rules:
        p, b = R * R, -R * R * (force + L)
        first, second, third = (one.at(p, b) / system.a for one in (system.alpha_1, system.alpha_2, system.alpha_3))
        driven = second + (first - third) * (force + L)
        return cls(-first, -third, driven, driven - first * level(force) - third * w)

    def along(self, polynomial: fmpq_mpoly) -> fmpq_mpoly:
        """d: the change over h r."""
        return self.fall * level(polynomial) - self.slow * polynomial.derivative(2)


def level(polynomial: fmpq_mpoly) -> fmpq_mpoly:
    """E F, E = (3/2) h d/dh - (1/2) r d/dr."""
    return fmpq(3, 2) * H * polynomial.derivative(0) - fmpq(1, 2) * R * polynomial.derivative(1)


def _drift(slow: fmpq_mpoly, fall: fmpq_mpoly, beta: fmpq, cut: Cut) -> fmpq_mpoly:
    """D: what S/(A_1 L) is above beta - 1 by, cut; nothing is kept of S at L = 0."""
    whole, drift = slow - (beta - 1) * fall * L, RING.constant(0)
    while (after := cut.of(whole - drift * (fall - 1) * L) / L) != drift:
        drift = after
    return drift


def still(polynomial: fmpq_mpoly) -> fmpq_mpoly:
    """Its terms without L."""
    return _chosen(polynomial, lambda _, __, k: k == 0)


def still_terms(polynomial: fmpq_mpoly) -> dict[tuple[int, int], fmpq]:
    """The terms without L, by (i, n)."""
    return terms_of(without_excess(polynomial))


def without_excess(polynomial: fmpq_mpoly) -> fmpq_mpoly:
    """The polynomial at L = 0, in h and r alone."""
    return LEVEL.from_dict({(i, n): value for (i, n, k), value in excess_terms(polynomial).items() if k == 0})


def excess_terms(polynomial: fmpq_mpoly) -> dict[tuple[int, int, int], fmpq]:
    """The coefficients of h^i r^n L^k by (i, n, k)."""
    return {(int(i), int(n), int(k)): value for (i, n, k), value in polynomial.to_dict().items()}


def _chosen(polynomial: fmpq_mpoly, kept: Callable[[int, int, int], bool]) -> fmpq_mpoly:
    return RING.from_dict({key: value for key, value in excess_terms(polynomial).items() if kept(*key)})
