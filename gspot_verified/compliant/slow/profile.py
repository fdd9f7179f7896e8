"""The slow contact force of the compliant model at one epsilon, as a function of tau, with its derivatives.

Proof page: ``proofs/monotone.md``, section 1.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

from flint import arb, fmpq

from gspot_verified.compliant.slow.grid import scale
from gspot_verified.compliant.slow.slow_solution import MAX_EPSILON, MAX_TENS, slow_value
from gspot_verified.leading_order.contact_force import ContactForce
from gspot_verified.numbers.balls import Exact, bits_for_digits, working_bits
from gspot_verified.signs.gamma.side import gamma_sign
from gspot_verified.theta_function.value.evaluate import evaluate

SLOW = "on the slow manifold of the compliant model"
_GUARD_BITS = 32  # bits beyond those asked for, lost on the way; any number is right


@dataclass(frozen=True)
class Profile:
    """f(tau) = sign Gamma(-beta) dG_beta/dtau (tau; eta) = beta s G_b (tau; eta), b = beta - 1, s = sign Gamma(-b),
    at epsilon = 2 eta^3.

    On the slow manifold lambda_N = mean + A epsilon^p f where C_1/Gamma(-beta) > 0, and mean - A epsilon^p f on the
    other side (A, p: :class:`ContactForce`). ``epsilon`` is that of the normal form, epsilon |alpha_1|; ``root`` is eta
    when it is known as a rational number. f^(n) > 0 on the real line, n = ``order``.
    """

    beta: fmpq
    epsilon: Exact
    root: fmpq | None = None

    @classmethod
    def at_root(cls, beta: fmpq, root: fmpq) -> Profile:
        """At epsilon = 2 eta^3, eta = ``root`` > 0 rational, so that T = tau/eta is exact."""
        return cls(beta, 2 * root**3, root)

    @classmethod
    def of(cls, force: ContactForce, epsilon: fmpq) -> Profile:
        """That of the system at its epsilon, in the paper's units."""
        return cls(force.beta, scaled_epsilon(force, epsilon))

    @classmethod
    def leading_order(cls, beta: fmpq) -> Profile:
        """At eta = 0: f_0 = sign Gamma(-beta) dTheta/dtau (tau, beta)."""
        return cls(beta, fmpq(0), fmpq(0))

    @property
    def order(self) -> int:
        """n = floor(beta), the least n for which f^(n) is an integral of a positive function."""
        return int(self.beta.floor())

    @cached_property
    def direction(self) -> int:
        """The sign of Gamma(-beta).

        :raises ValueError: beta is an integer.
        """
        sign = gamma_sign(self.beta)
        if not sign:
            raise ValueError(f"beta: expected a number that is not an integer, got {self.beta}")
        return sign

    def eta(self, bits: int) -> arb:
        """(epsilon/2)^(1/3)."""
        with working_bits(bits):
            return arb(self.root) if self.root is not None else scale(self.epsilon)

    def derivatives(self, tau: fmpq, orders: range, digits: int) -> list[arb]:
        """f^(k)(tau) for each k of ``orders``.

        >>> values = Profile.at_root(fmpq(5, 2), fmpq(1, 100)).derivatives(fmpq(0), range(3), 8)
        >>> [bool(value > 0) for value in values]
        [False, False, True]
        """
        bits = bits_for_digits(digits) + _GUARD_BITS
        if self.root == 0:
            values = [evaluate(tau, self.beta, derivative=k + 1, digits=digits).value for k in orders]
            with working_bits(bits):
                return [self.direction * value for value in values]
        eta = self.eta(2 * bits)
        derivatives = []
        with working_bits(2 * bits):
            time = tau / self.root if self.root is not None else tau / eta
        for k in orders:
            value = slow_value(time, self.beta, self.epsilon, k + 1, digits).value
            with working_bits(bits):
                derivatives.append(self.direction * value * eta ** arb(self.beta - k - 1))
        return derivatives

    def value(self, tau: fmpq, digits: int) -> arb:
        """f(tau)."""
        return self.derivatives(tau, range(1), digits)[0]


def scaled_epsilon(force: ContactForce, epsilon: fmpq) -> fmpq:
    """epsilon in the normal form, epsilon |alpha_1|."""
    return -force.alpha_1 * epsilon


def in_range(force: ContactForce, epsilon: fmpq) -> bool:
    """Whether the slow solution is evaluated at this epsilon."""
    return bool(fmpq(10) ** -MAX_TENS <= scaled_epsilon(force, epsilon) <= MAX_EPSILON)
