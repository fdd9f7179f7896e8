"""The slow part of the deviation of the model system, by polynomials in h = e/p^(3/2) and r = sqrt(p).

Proof page: ``proofs/from_state.md``, section 2. Exact rationals. The names v, w, f are those of the page: H_V = v,
H_W = r^2 w, H_phi = r^2 f.
"""

from __future__ import annotations

from dataclasses import dataclass

from flint import Ordering, fmpq, fmpq_mpoly, fmpq_mpoly_ctx

from gspot_verified.expansion.series.regularisation import NO_DAMPER, Regularisation

RING = fmpq_mpoly_ctx.get(("h", "r"), Ordering.lex)
H, R = RING.gens()


@dataclass(frozen=True)
class Contact:
    """kappa, g, l of the contact; see ``proofs/uniform.md``."""

    kappa: fmpq
    rate: fmpq
    lag: fmpq

    @classmethod
    def of(cls, springs: Regularisation) -> Contact:
        """The numbers of a contact.

        :raises ValueError: it has no damper.

        >>> from gspot_verified.expansion.series.regularisation import PAPER
        >>> Contact.of(PAPER)
        Contact(kappa=1/2, rate=2, lag=1/2)
        """
        if not springs.c > 0:
            raise ValueError(NO_DAMPER)
        kappa = 1 / springs.compliance
        return cls(kappa, (springs.k_1 + springs.k_2) / springs.c, springs.k_2 - kappa)

    @property
    def fast_text(self) -> str:
        """What phi is, in words."""
        numbers = f"kappa = {self.kappa}, g = {self.rate}, l = {self.lag}"
        return f"fast = lambda_N + kappa y/epsilon^2 + (l/g) v/epsilon, {numbers}"


def contact_text(springs: Regularisation) -> str:
    """The contact's constants in words, in their units."""
    return f"(k_1 epsilon^2, k_2 epsilon^2, c epsilon) = ({springs.k_1}, {springs.k_2}, {springs.c})"


@dataclass(frozen=True)
class SlowSeries:
    """v, w, f, and the residual divided by e L: (r r_V, r_W, r r_phi)/e, as polynomials in (h, r)."""

    beta: fmpq
    contact: Contact
    v: fmpq_mpoly
    w: fmpq_mpoly
    f: fmpq_mpoly
    residual: tuple[fmpq_mpoly, fmpq_mpoly, fmpq_mpoly]

    @property
    def balance(self) -> fmpq:
        """(beta - 1/2)/2."""
        return (self.beta - fmpq(1, 2)) / 2

    @property
    def coupling(self) -> tuple[fmpq_mpoly, fmpq_mpoly, fmpq_mpoly]:
        """What x_2 feeds into x_1, x_2, x_3 besides r, 0, (l/g) r, over h r, (4)."""
        return self.beta * self.v / R, self.beta - 1 + self.beta * self.w, self.beta * R * self.f

    @property
    def level_fall(self) -> fmpq_mpoly:
        """-p'/(h r p)."""
        return RING.constant(1)


def slow_series(beta: fmpq, contact: Contact, order: int) -> SlowSeries:
    """The polynomials up to h^order; section 2, (3).

    :raises ValueError: the order is not positive.

    >>> from gspot_verified.expansion.series.regularisation import PAPER
    >>> slow_series(fmpq(5, 2), Contact.of(PAPER), 2).w
    -3/2*h^2
    """
    if not order > 0:
        raise ValueError(f"the order must be positive, got {order}")
    kappa, rate, lag = contact.kappa, contact.rate, contact.lag
    rules = _Rules(beta, contact)
    v = w = f = 0 * H
    while True:
        v_next = _cut(rules.force(w, f) / kappa, order)
        w_next = _cut(_exact_quotient(rules.along(v_next, w), R * R), order)
        f_next = _cut((lag / rate * w_next - rules.along_square(f, w)) / rate, order)
        if (v_next, w_next, f_next) == (v, w, f):
            break
        v, w, f = v_next, w_next, f_next
    residual = (
        _exact_quotient(w - _exact_quotient(rules.along(v, w), R * R), H),
        _exact_quotient(rules.force(w, f) - kappa * v, H * R),
        _exact_quotient(lag / rate * w - rate * f - rules.along_square(f, w), H),
    )
    return SlowSeries(beta, contact, v, w, f, residual)


def terms_of(polynomial: fmpq_mpoly) -> dict[tuple[int, int], fmpq]:
    """The coefficients of h^i r^n by (i, n)."""
    return {(int(i), int(n)): value for (i, n), value in polynomial.to_dict().items()}


def change(polynomial: fmpq_mpoly) -> fmpq_mpoly:
    """d/dT: h' = (3/2) h^2 r, r' = -(1/2) h r^2."""
    return fmpq(3, 2) * H * H * R * polynomial.derivative(0) - fmpq(1, 2) * H * R * R * polynomial.derivative(1)


@dataclass(frozen=True)
class _Rules:
    """How polynomials times L change on the slow solution."""

    beta: fmpq
    contact: Contact

    def along(self, polynomial: fmpq_mpoly, w: fmpq_mpoly) -> fmpq_mpoly:
        """D: the change of polynomial * L over L, on the slow solution."""
        return change(polynomial) - H * R * ((self.beta - 1) + self.beta * w) * polynomial

    def along_square(self, polynomial: fmpq_mpoly, w: fmpq_mpoly) -> fmpq_mpoly:
        """r^-2 D(r^2 polynomial)."""
        return self.along(polynomial, w) - H * R * polynomial

    def force(self, w: fmpq_mpoly, f: fmpq_mpoly) -> fmpq_mpoly:
        """[e (beta-1)(1 + w) - g p H_phi - D H_W]/r^2: what kappa v balances."""
        return H * R * (self.beta - 1) * (1 + w) - self.contact.rate * R * R * f - self.along_square(w, w)


def _cut(polynomial: fmpq_mpoly, order: int) -> fmpq_mpoly:
    return RING.from_dict({key: value for key, value in terms_of(polynomial).items() if key[0] <= order})


def _exact_quotient(polynomial: fmpq_mpoly, divisor: fmpq_mpoly) -> fmpq_mpoly:
    """The page shows that the division is exact; if it were not, flint raises an error."""
    return polynomial / divisor
