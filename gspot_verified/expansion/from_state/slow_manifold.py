"""The slow manifold where the alphas depend on the state, by polynomials in h, r and L, and its reference force.

Proof page: ``proofs/from_state.md``, section 8. Exact rationals where the Taylor coefficients are, else balls, by
Lemma Z there; h = e/p^(3/2), r = sqrt(p), L the excess of -b/p over the reference force. The names are those of the
page: V = h r u, W = r^2 w, phi = r^2 f.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from flint import Ordering, fmpq, fmpq_mpoly_ctx

from gspot_verified.expansion.from_state.affine_system import AffineSystem
from gspot_verified.expansion.from_state.analytic import Place, Polynomial
from gspot_verified.expansion.from_state.slow_series import RING as LEVEL
from gspot_verified.expansion.from_state.slow_series import Contact
from gspot_verified.functions.ball_polynomials import BallPolynomial, constant, polynomial_of
from gspot_verified.numbers.balls import Exact, ball

RING = fmpq_mpoly_ctx.get(("h", "r", "L"), Ordering.lex)
H, R, L = RING.gens()


@dataclass(frozen=True)
class Cut:
    """h^i r^n L^k is kept for i <= ``order`` and n + (k - 1) mu <= ``weight``; any mu > 0 is right."""

    order: int
    weight: fmpq
    mu: fmpq

    def keeps(self, i: int, n: int, k: int) -> bool:
        """Whether h^i r^n L^k is kept."""
        return bool(i <= self.order and n + (k - 1) * self.mu <= self.weight)

    @property
    def rounds(self) -> int:
        """After so many the iteration has ended, whatever the numbers: Lemma Z."""
        return (self.order + 1) * (int(((self.weight + self.mu) / 2).floor()) + 4)

    def of(self, polynomial: Polynomial, fewer: int = 0) -> Polynomial:
        """What is kept, with the order less ``fewer``."""
        return _chosen(polynomial, lambda i, n, k: self.keeps(i + fewer, n, k))

    def left(self, polynomial: Polynomial, fewer: int = 0) -> Polynomial:
        """What is left of a residual: the terms that are kept vanish, and at L = 0 those of low weight: Lemmas Z, T.

        :raises ArithmeticError: a term that vanishes certainly does not.
        """
        least = min(fmpq(3 * self.order), self.weight + self.mu)
        return _without(polynomial, lambda i, n, k: self.keeps(i + fewer, n, k) or (k == 0 and n < least))


@dataclass(frozen=True)
class SlowManifold:
    """``force`` is the reference, free of L; u, w, f; ``fall`` is A_1, ``back`` A_3, ``faster`` S - (beta - 1) L.

    ``residual`` is (F_1, F_2, F_3), which vanish but for what was cut; ``drift`` is D, and ``stray`` what is left of
    S - (beta - 1 + D) A_1 L.
    """

    system: AffineSystem
    cut: Cut
    force: Polynomial
    u: Polynomial
    w: Polynomial
    f: Polynomial
    fall: Polynomial
    back: Polynomial
    faster: Polynomial
    residual: tuple[Polynomial, Polynomial, Polynomial]
    drift: Polynomial
    stray: Polynomial

    @property
    def beta(self) -> Exact:
        """alpha_3/alpha_1 at the G-spot."""
        return self.system.beta

    @property
    def balance(self) -> fmpq:
        """(beta - 1/2)/2, or a number near it."""
        return self.cut.mu / 4 + fmpq(1, 4)

    @property
    def slow(self) -> Polynomial:
        """S."""
        return self.faster + constant(RING, self.beta - 1) * L

    @property
    def mu(self) -> Exact:
        """2 beta - 2: \\|L\\| is nearly a multiple of r^mu."""
        return 2 * self.beta - 2

    @property
    def contact(self) -> Contact:
        """kappa, g, l."""
        return Contact.of(self.system.regularisation)

    @property
    def feeding(self) -> tuple[Polynomial, Polynomial, Polynomial]:
        """What x_2 feeds into x_1, x_2, x_3 besides r, 0, (l/g) r, over h r."""
        u, w, f = (self.back * one.derivative(2) for one in (self.u, self.w, self.f))
        return H * u, self.back - self.fall + w, R * f

    @property
    def coupling(self) -> tuple[Polynomial, Polynomial, Polynomial]:
        """The same at L = 0."""
        first, second, third = (without_excess(one) for one in self.feeding)
        return first, second, third

    @property
    def level_fall(self) -> Polynomial:
        """A_1 at L = 0."""
        return without_excess(self.fall)


def slow_manifold(system: AffineSystem, cut: Cut) -> SlowManifold:
    """The polynomials that the iteration of section 8 leaves as they are: Lemma Z says after how many rounds."""
    force, u, w, f = constant(RING, system.mean_force), *[constant(RING, fmpq(0))] * 3
    for _ in range(cut.rounds):
        rules = _Rules.of(system, (force, u, w, f), cut.of)
        pushed = cut.of(rules.pushed(w, f) / rules.contact.kappa, 1)
        after = rules.still_force(cut), pushed, cut.of(rules.followed(u)), cut.of(rules.lagged(w, f))
        if system.is_exact and (force, u, w, f) == after:
            break
        force, u, w, f = after
    force, u, w, f = (_without(one, lambda i, n, k: k == 0 and n + 2 < 3 * i) for one in (force, u, w, f))  # Lemma T
    rules = _Rules.of(system, (force, u, w, f))
    fall, back, contact = rules.fall, rules.back, rules.contact
    first, second = (w - rules.followed(u)) / H, rules.pushed(w, f) - contact.kappa * u
    third = contact.rate * (rules.lagged(w, f) - f) / H
    faster = cut.left(still(rules.faster)) + moving(rules.faster)
    unchanged = constant(RING, system.beta - 1) * (fall - 1) * L
    drift = _drift(moving(faster) - unchanged, fall, cut)
    return SlowManifold(
        system,
        cut,
        force,
        u,
        w,
        f,
        fall=fall,
        back=back,
        faster=faster,
        residual=(cut.left(first, 1), cut.left(second, 1), cut.left(third, 1)),
        drift=drift,
        stray=cut.left(faster - unchanged - drift * fall * L),
    )


@dataclass(frozen=True)
class _Rules:
    """How polynomials change on the slow manifold; the ``short`` form of each function of the state is used.

    S = ``faster`` + (beta - 1) L, and ``faster`` = ``beside`` + (beta - 1) force + E force.
    """

    system: AffineSystem
    fall: Polynomial
    back: Polynomial
    driven: Polynomial
    beside: Polynomial
    faster: Polynomial
    slow: Polynomial

    @classmethod
    def of(
        cls,
        system: AffineSystem,
        parts: Place,
        short: Callable[[Polynomial], Polynomial] = lambda whole: whole,
    ) -> _Rules:
        force, _, w, _ = parts
        unit = constant(RING, 1 / system.a)
        place = _place(system, parts)
        first, second, third = (
            short(one.above(place) * unit) for one in (system.alpha_1, system.alpha_2, system.alpha_3)
        )
        own, steady = constant(RING, system.alpha_2.value / system.a), constant(RING, system.beta - 1)
        beside = own + second + (first - third) * (force + L)
        driven = beside + steady * (force + L)
        third = third - constant(RING, system.beta)
        beside = short(beside - first * level(force) - third * w)
        faster = beside + steady * force + level(force)
        return cls(system, 1 - first, -third, driven, beside, faster, faster + steady * L)

    @property
    def contact(self) -> Contact:
        """kappa, g, l."""
        return Contact.of(self.system.regularisation)

    def still_force(self, cut: Cut) -> Polynomial:
        """The reference force with which S at L = 0 would have no kept term, all else as it is."""
        terms = still_terms(cut.of(self.beside)).items()
        steady = self.system.beta - 1
        return polynomial_of(RING, {(i, n, 0): -value / (steady + fmpq(3 * i - n, 2)) for (i, n), value in terms})

    def along(self, polynomial: Polynomial) -> Polynomial:
        """d: the change over h r."""
        return self.fall * level(polynomial) - self.slow * polynomial.derivative(2)

    def pushed(self, w: Polynomial, f: Polynomial) -> Polynomial:
        """F_2 + kappa u."""
        return self.driven + self.back * w - self.contact.rate * R * (f / H) - self.along(w)

    def followed(self, u: Polynomial) -> Polynomial:
        """w - h F_1."""
        return H * H * (self.fall * u + self.along(u))

    def lagged(self, w: Polynomial, f: Polynomial) -> Polynomial:
        """f + h F_3/g."""
        rate = self.contact.rate
        return self.contact.lag / rate**2 * w - H * R * (self.along(f) - self.fall * f) / rate


def _place(system: AffineSystem, parts: Place) -> Place:
    """p, b, y, v where x = 0, for ``parts`` force, u, w, f; 0 for y, v where they are not needed."""
    force, u, _, _ = parts
    p, b, nothing = R * R, -R * R * (force + L), RING.constant(0)
    if not system.moves:
        return p, b, nothing, nothing
    per = constant(RING, 1 / system.a)
    return p, b, H**2 * R**6 * per**2 * height(system, parts), H**2 * R**4 * per * u


def height(system: AffineSystem, parts: Place) -> Polynomial:
    """Y where x = 0."""
    force, u, w, f = parts
    contact = Contact.of(system.regularisation)
    return (R * R * f - force - L - w - contact.lag / contact.rate * H * R * u) / contact.kappa


def level(polynomial: Polynomial) -> Polynomial:
    """E F, E = (3/2) h d/dh - (1/2) r d/dr."""
    change: Polynomial = fmpq(3, 2) * H * polynomial.derivative(0) - fmpq(1, 2) * R * polynomial.derivative(1)
    return change


def _drift(whole: Polynomial, fall: Polynomial, cut: Cut) -> Polynomial:
    """D: what S/(A_1 L) is above beta - 1 by, cut, from S - (beta - 1) A_1 L; each round adds two orders of r."""
    drift: Polynomial = RING.constant(0)
    for _ in range(int(cut.weight.floor()) // 2 + 1):
        drift = cut.of(whole - drift * (fall - 1) * L) / L
    return drift


def still(polynomial: Polynomial) -> Polynomial:
    """Its terms without L."""
    return _chosen(polynomial, lambda _, __, k: k == 0)


def moving(polynomial: Polynomial) -> Polynomial:
    """Its terms with L."""
    return _chosen(polynomial, lambda _, __, k: k > 0)


def still_terms(polynomial: Polynomial) -> dict[tuple[int, int], Exact]:
    """The terms without L, by (i, n)."""
    return {(i, n): value for (i, n, k), value in excess_terms(polynomial).items() if k == 0}


def without_excess(polynomial: Polynomial) -> Polynomial:
    """The polynomial at L = 0, in h and r alone."""
    return polynomial_of(LEVEL, still_terms(polynomial))


def excess_terms(polynomial: Polynomial) -> dict[tuple[int, int, int], Exact]:
    """The coefficients of h^i r^n L^k by (i, n, k)."""
    return {(int(i), int(n), int(k)): value for (i, n, k), value in polynomial.to_dict().items()}


def _without(polynomial: Polynomial, vanishing: Callable[[int, int, int], bool]) -> Polynomial:
    """The polynomial without terms that vanish, if so they may."""
    for (i, n, k), value in excess_terms(polynomial).items():
        if vanishing(i, n, k) and not ball(value).contains(0):
            raise ArithmeticError(f"h^{i} r^{n} L^{k} has the coefficient {value}, which should vanish")
    return _chosen(polynomial, lambda i, n, k: not vanishing(i, n, k))


def _chosen(polynomial: Polynomial, kept: Callable[[int, int, int], bool]) -> Polynomial:
    if isinstance(polynomial, BallPolynomial):
        return polynomial.only(kept)
    return RING.from_dict({key: value for key, value in polynomial.to_dict().items() if kept(*map(int, key))})
