"""A mechanism as polynomials: of its states, of sines and cosines, and of the divisors that its equations have.

The producer's side of ``proofs/run_certificate.md``, section 1a: Lemma 2 makes sines, cosines and divisors states with
polynomial rates. Nothing here is part of a proof: the checker derives its own equations.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from itertools import permutations
from typing import Any

from flint import Ordering, fmpq, fmpq_mpoly, fmpq_mpoly_ctx

from gspot_verified.functions.derivative import powers_as_products
from gspot_verified.functions.expressions import (
    Constant,
    Cosine,
    Expression,
    Power,
    Product,
    Sine,
    Sum,
    Variable,
    in_order,
)
from gspot_verified.mechanisms.derive.derivation import lagrangian_input
from gspot_verified.mechanisms.derive.to_system import Preparation
from gspot_verified.mechanisms.formulas.symbol import SLIP_SPEED, Symbol
from gspot_verified.mechanisms.input.mechanism import Lagrangian, Mechanism
from gspot_verified.scenes.equations.motion import SceneError
from gspot_verified.scenes.equations.terms import FLIGHT, REVERSE, SLIP, STICK

Y, V, Z, INVERSE, SLIDE = "y/eps^2", "v/eps", "z/eps^2", "1/det M", "1/A det M"
SCALED = {"Y": Y, "V": V, "Z": Z}


class NotPolynomial(SceneError):
    """A mechanism that no certificate of runs covers; the message says why."""


class PolynomialMechanism:
    """The functions of a mechanism, by names: q or (q-q_ref), q_dot, sin(q), cos(q) for each coordinate q.

    ``place``: how the coordinates themselves are called. ``given``: what a certificate says of the mechanism.

    :raises NotPolynomial: a function of it is no such polynomial, or it is not given by a mass matrix and forces.
    """

    def __init__(self, mechanism: Mechanism) -> None:
        motion = mechanism.motion
        if not isinstance(motion, Lagrangian) or motion.constraints or motion.time is not None:
            raise NotPolynomial(
                "certificates of runs cover mechanisms with a mass matrix and forces, without constraints and time"
            )
        if mechanism.x is None:
            raise NotPolynomial("certificates of runs need x, not a slip velocity")
        self.coordinates = motion.coordinates
        angles = {angle.coordinate: angle for angle in mechanism.angles}
        self.references = {
            q: (angles[q].sine, angles[q].cosine) if q in angles else (fmpq(0), fmpq(1)) for q in self.coordinates
        }
        self.place = {q: f"({q}-{q}_ref)" if q in angles else q for q in self.coordinates}
        own = [name for q in self.coordinates for name in (self.place[q], f"{q}_dot", f"sin({q})", f"cos({q})")]
        self.names = (*own, Y, V, Z, INVERSE, SLIDE)
        self.context = fmpq_mpoly_ctx.get(list(self.names), Ordering.lex)
        self._by_name = dict(zip(self.names, self.context.gens(), strict=True))
        given = lagrangian_input(mechanism, motion, Preparation(mechanism))
        assert given.x is not None
        roots = [given.x, given.y, given.mu, *given.forces, *(entry for row in given.rows for entry in row)]
        x, y, mu, *rest = self._polynomials(roots)
        n = len(self.coordinates)
        self.x, self.y, self.forces = x, y, rest[:n]
        self.mass = [rest[n + i * n : n + i * n + n] for i in range(n)]
        if not mu.is_constant():
            raise NotPolynomial("certificates of runs need a friction coefficient that is a number")
        self.mu = number_of(mu)
        self.given: dict[str, Any] = {
            "angles": {q: [str(angle.sine), str(angle.cosine)] for q, angle in angles.items()},
            "coordinates": list(self.coordinates),
            "forces": [self._text(force) for force in self.forces],
            "mass_matrix": [[self._text(entry) for entry in row] for row in self.mass],
            "mu": str(self.mu),
            "x": self._text(x),
            "y": self._text(y),
        }

    def of(self, name: str) -> fmpq_mpoly:
        """A state."""
        return self._by_name[name]

    def number(self, value: fmpq | int) -> fmpq_mpoly:
        """A constant."""
        return self.context.constant(value)

    def names_in(self, polynomials: Iterable[fmpq_mpoly]) -> set[str]:
        """What occurs in them."""
        return {
            self.names[i]
            for each in polynomials
            for powers in each.to_dict()
            for i, power in enumerate(powers)
            if power
        }

    def _text(self, polynomial: fmpq_mpoly) -> str:
        """As the certificate writes it."""
        terms = []
        for powers, value in polynomial.to_dict().items():
            factors = [self.names[i] for i, power in enumerate(powers) for _ in range(int(power))]
            terms.append("*".join([str(value), *factors]))
        return " + ".join(terms) or "0"

    def _polynomials(self, roots: Sequence[Expression]) -> list[fmpq_mpoly]:
        products = powers_as_products(roots)
        made: dict[Expression, fmpq_mpoly] = {}
        for node in in_order([products[root] for root in roots]):
            made[node] = self._polynomial(node, made)
        return [made[products[root]] for root in roots]

    def _polynomial(self, node: Expression, made: Mapping[Expression, fmpq_mpoly]) -> fmpq_mpoly:
        n = len(self.coordinates)
        match node:
            case Constant(fmpq() as value):
                return self.number(value)
            case Variable(index) if index < n:
                return self.of(self.place[self.coordinates[index]])
            case Variable(index) if index < 2 * n:
                return self.of(f"{self.coordinates[index - n]}_dot")
            case Sum(terms):
                return sum((made[term] for term in terms), self.number(0))
            case Product(left, right):
                return made[left] * made[right]
            case Sine(Variable(index)) | Cosine(Variable(index)) if index < n:
                q = self.coordinates[index]
                sine, cosine, (s, c) = self.of(f"sin({q})"), self.of(f"cos({q})"), self.references[q]
                return c * sine - s * cosine if isinstance(node, Sine) else c * cosine + s * sine
        if node is Symbol(SLIP_SPEED):
            raise NotPolynomial("certificates of runs need a friction coefficient that is a number")
        what = {Power: "a division or a root", Symbol: "a reference angle outside of a sine or cosine"}
        named = what.get(type(node), f"{type(node).__name__.lower()} of more than one coordinate")
        raise NotPolynomial(f"certificates of runs cover polynomials of sin(q) and cos(q), not {named}")

    def by(self, function: fmpq_mpoly, q: str) -> fmpq_mpoly:
        """The derivative by a coordinate."""
        return self.rate(function, {self.place[q]: self.number(1), **self._turns(q, self.number(1))})

    def _turns(self, q: str, speed: fmpq_mpoly) -> dict[str, fmpq_mpoly]:
        sine, cosine = f"sin({q})", f"cos({q})"
        return {sine: speed * self.of(cosine), cosine: -speed * self.of(sine)}

    def rate(self, function: fmpq_mpoly, rates: Mapping[str, fmpq_mpoly] | None = None) -> fmpq_mpoly:
        """The derivative along a flow; None: of a function without velocities, by time."""
        if rates is None:
            rates = {}
            for q in self.coordinates:
                speed = self.of(f"{q}_dot")
                rates |= {self.place[q]: speed, **self._turns(q, speed)}
        total = self.number(0)
        for name in self.names_in([function]) & set(rates):
            total += function.derivative(self.names.index(name)) * rates[name]
        return total

    def turns(self, q: str, epsilon: fmpq) -> dict[str, fmpq_mpoly]:
        """The rates of a coordinate, its sine and its cosine by T."""
        speed = epsilon * self.of(f"{q}_dot")
        return {self.place[q]: speed, **self._turns(q, speed)}

    def put_in(self, function: fmpq_mpoly, table: Mapping[str, fmpq_mpoly]) -> fmpq_mpoly:
        """The function with others in the places of some names."""
        return function.compose(*(table.get(name, self.of(name)) for name in self.names), ctx=self.context)

    def normal(self, epsilon: fmpq) -> dict[str, fmpq_mpoly]:
        """The coordinate of which y is a multiple beside the others, and its velocity, by Y, V and the others.

        :raises NotPolynomial: there is none.
        """
        used = self.names_in([self.y])
        for q in self.coordinates:
            slope = self.y.derivative(self.names.index(self.place[q]))
            if not slope.is_zero() and slope.is_constant() and not used & {f"sin({q})", f"cos({q})"}:
                rest, share = self.y - slope * self.of(self.place[q]), 1 / number_of(slope)
                return {
                    self.place[q]: share * (epsilon**2 * self.of(Y) - rest),
                    f"{q}_dot": share * (epsilon * self.of(V) - self.rate(rest)),
                }
        raise NotPolynomial("certificates of runs need a coordinate of which y is a multiple beside the others")

    def minors(self) -> list[fmpq_mpoly]:
        """The leading minors of the mass matrix."""
        return [self.determinant([row[:k] for row in self.mass[:k]]) for k in range(1, len(self.mass) + 1)]

    def determinant(self, rows: Sequence[Sequence[fmpq_mpoly]]) -> fmpq_mpoly:
        """By Leibniz' formula."""
        total = self.number(0)
        for order in permutations(range(len(rows))):
            odd = sum(order[i] > order[j] for j in range(len(rows)) for i in range(j)) % 2
            product = self.number(-1 if odd else 1)
            for row, column in zip(rows, order, strict=True):
                product *= row[column]
            total += product
        return total

    def cofactors(self) -> list[list[fmpq_mpoly]]:
        """det M times the inverse of M."""
        n = range(len(self.mass))
        return [
            [
                (-1) ** (i + j) * self.determinant([[self.mass[k][m] for m in n if m != j] for k in n if k != i])
                for j in n
            ]
            for i in n
        ]


def number_of(polynomial: fmpq_mpoly) -> fmpq:
    """A constant polynomial's value."""
    return sum(polynomial.coeffs(), fmpq(0))


def expression(polynomial: fmpq_mpoly, states: Mapping[int, int]) -> Expression:
    """The polynomial with Variable(states[i]) for its variable i."""
    terms: list[Expression] = []
    for powers, value in polynomial.to_dict().items():
        factors: list[Expression] = [Variable(states[i]) for i, power in enumerate(powers) for _ in range(int(power))]
        product: Expression = Constant(value)
        for k, factor in enumerate(factors):
            product = factor if k == 0 and value == 1 else Product(product, factor)
        terms.append(product)
    return Sum(tuple(terms)) if len(terms) > 1 else terms[0] if terms else Constant(fmpq(0))


class PolynomialPhase:
    """The rates by T and the events' functions in one phase; ``divisor``: what 1/(A det M) is the inverse of."""

    def __init__(
        self, mechanism: PolynomialMechanism, phase: str, epsilon: fmpq, values: Mapping[str, fmpq], follows: bool
    ) -> None:
        m, zero = mechanism, mechanism.number(0)
        table, det, cofactors = m.normal(epsilon), m.minors()[-1], m.cofactors()
        dots = [m.of(f"{q}_dot") for q in m.coordinates]
        w = m.number(1 / number_of(det)) if det.is_constant() else m.of(INVERSE)
        by_x, by_y = ([m.by(f, q) for q in m.coordinates] for f in (m.x, m.y))
        gap = m.of(Z) - m.of(Y)
        force = zero if phase == FLIGHT else values["k_2"] * gap
        pushed = [f + force * y for f, y in zip(m.forces, by_y, strict=True)]
        across = [_dot(by_x, row, zero) for row in cofactors]
        A = _dot(by_x, across, zero)
        still = _dot(across, pushed, zero) + det * _dot([m.rate(f) for f in by_x], dots, zero)
        self.divisor = A if phase == STICK and not A.is_constant() else zero
        friction = {SLIP: -m.mu * force, REVERSE: m.mu * force}.get(phase, zero)
        if phase == STICK:
            friction = -still * (m.number(1 / number_of(A)) if A.is_constant() else m.of(SLIDE))
        forces = [f + friction * x for f, x in zip(pushed, by_x, strict=True)]
        accelerations = [w * _dot(row, forces, zero) for row in cofactors]
        rates = {
            Y: m.of(V),
            V: _dot(by_y, accelerations, zero) + _dot([m.rate(f) for f in by_y], dots, zero),
            Z: (-values["k_1"] * m.of(Z) - force) * (1 / values["damping"]),
            INVERSE: -epsilon * w * w * m.rate(det),
            SLIDE: -epsilon * m.of(SLIDE) ** 2 * m.rate(self.divisor),
        }
        for q, acceleration in zip(m.coordinates, accelerations, strict=True):
            rates |= m.turns(q, epsilon) | {f"{q}_dot": epsilon * acceleration}
        functions = {"touch-down": -gap} if phase == FLIGHT else {"lift-off": gap}
        u = _dot(by_x, dots, zero)
        if follows and phase in (SLIP, REVERSE):
            functions["stick"] = u if phase == SLIP else -u
        if phase == STICK:
            functions |= {"slip forwards": m.mu * A * force - still, "slip backwards": m.mu * A * force + still}
        self.rates = {name: m.put_in(rate, table) for name, rate in rates.items()}
        self.functions = {name: m.put_in(function, table) for name, function in functions.items()}
        self.divisor, self.slip = m.put_in(self.divisor, table), m.put_in(u, table)


def _dot(left: Sequence[fmpq_mpoly], right: Sequence[fmpq_mpoly], zero: fmpq_mpoly) -> fmpq_mpoly:
    return sum((a * b for a, b in zip(left, right, strict=True)), zero)
