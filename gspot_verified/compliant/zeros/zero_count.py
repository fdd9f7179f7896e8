"""The number of real zeros of the slow solution F_(beta-1) at one beta and one epsilon, certified.

Proof page: ``proofs/finite_epsilon_zeros.md``, sections 1 and 2; integers beta: section 3.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Literal

from flint import arb, arb_mat, fmpq

from gspot_verified.compliant.model.normal_form import LEAST_EPSILON, MAX_EPSILON
from gspot_verified.compliant.slow.force_polynomial import distinct_real_zeros, force_polynomial
from gspot_verified.compliant.slow.slow_jet import slow_jet
from gspot_verified.compliant.slow.slow_signs import CELL, SlowSigns
from gspot_verified.compliant.zeros.slow_zero_column import slow_zero_column
from gspot_verified.compliant.zeros.zero_places import polynomial_places, zero_places
from gspot_verified.numbers.balls import ExactInput, ball_text, exact
from gspot_verified.numbers.counted import counted
from gspot_verified.numbers.evidence import cover, equal, every
from gspot_verified.numbers.verdict import Evidence, NoTruthValue, Reason, Verdict
from gspot_verified.numbers.written import Written
from gspot_verified.signs.cover.pieces import Column, number_of_zeros
from gspot_verified.signs.gamma.count_law import number_of_zeros as law

MAX_BETA = 40  # a limit of input: ValueError beyond it
MAX_DIGITS = 100  # of the places of zeros; a limit of input: ValueError beyond it
SYSTEM = "λ − λ̄ on the slow manifold of the compliant model with α₁ = −1, C₁ ≠ 0"
_MORE_ORDERS = 10  # in tau, beyond b: with more the remainder is less; chosen by trial: any number is right
_FIRST_BITS = 80  # at the first try, then twice as many
_TRIES = 3  # then the number stays open


@dataclass(frozen=True, slots=True)
class SlowZeros(NoTruthValue, Written):
    """How many distinct real zeros F_(beta-1)(T; epsilon) has at one beta and one epsilon.

    ``number`` is None when it stayed open. ``law`` is the number for Theta, the limit epsilon -> 0. ``column``: the
    pieces that show the number; None at an integer beta, where F is a polynomial and Sturm's theorem counts.
    ``places``: a ball of T for each zero, in order, without a zero that is too far out.
    """

    system: ClassVar[str] = SYSTEM
    ask: ClassVar[str] = ".number is None when it stayed open; .verdict says whether it was settled"
    written: ClassVar[str] = "system beta epsilon number number_for_theta=law zeros=places route pieces verdict"

    beta: fmpq
    epsilon: fmpq
    number: int | None
    law: int
    column: Column | None
    places: tuple[arb, ...] = ()
    digits: int = 15

    @property
    def route(self) -> Literal["polynomial", "pieces"]:
        """How they are counted."""
        return "polynomial" if self.beta.q == 1 else "pieces"

    @property
    def pieces(self) -> list[list[str | int]]:
        """The pieces of the column as they stand in a certificate."""
        return [] if self.column is None else [piece.to_list() for piece in self.column.pieces]

    @property
    def verdict(self) -> Verdict:
        """Proved, with the number; or undecided."""
        question = f"the number of real zeros T = t/ε (p = −t) of {SYSTEM}, β = {self.beta}, ε = {self.epsilon}"
        if self.number is None:
            return Verdict.undecided(question, Reason.BUDGET)
        return Verdict.proved(f"{question}: {self.number}", self._counted(self.number))

    def _counted(self, number: int) -> Evidence | None:
        """The pieces cover the line and hold so many zeros; at an integer beta Sturm's theorem counts as many."""
        if self.beta.q == 1:
            return equal(number, distinct_real_zeros(force_polynomial(int(self.beta.p) - 1, self.epsilon)))
        if self.column is None:
            return None
        found = number_of_zeros(self.column)
        pieces = cover(((piece.lower, piece.upper) for piece in self.column.pieces), (None, None))
        return None if found is None else every([pieces, equal(number, found)])

    def __str__(self) -> str:
        if self.number is None:
            return str(self.verdict)
        compared = "as for Θ" if self.number == self.law else f"for Θ (ε → 0): {self.law}"
        lines = [f"  T = {ball_text(place, self.digits)}" for place in self.places]
        left_out = self.number - len(self.places)
        if left_out > 0:
            lines.append(f"  {counted(left_out, 'zero')} more, too far out to be enclosed")
        return "\n".join([f"{self.verdict} ({compared})", *lines])


def slow_zeros(beta: ExactInput, epsilon: ExactInput, digits: int = 15) -> SlowZeros:
    """The number of distinct real zeros T = t/epsilon of F_(beta-1)(T; epsilon), and where they are.

    On the slow manifold of the compliant model the contact force is its trivial value plus a multiple of this function
    (``proofs/exact_solution.md``).

    :param beta: one number, 0 < beta <= 40, other than 1: there the trivial value does not exist.
    :param epsilon: one number, 10^-300 <= epsilon <= 10^6.
    :param digits: decimals of tau = (epsilon/2)^(1/3) T to which each zero is enclosed, 1..100.
    :raises TypeError: a float argument.
    :raises ValueError: an argument outside its domain.

    >>> print(slow_zeros("5/2", "1/10").number, slow_zeros("5.95", "1/10").number, slow_zeros("5.95", "1/100").number)
    2 1 3
    """
    point, small = checked_point(beta, "beta"), checked_point(epsilon, "epsilon")
    if not 0 < point <= MAX_BETA:
        raise ValueError(f"beta: expected a number in (0, {MAX_BETA}], got {point}")
    if point == 1:
        raise ValueError("beta: at β = 1 there is no trivial solution, and so no deviation λ − λ̄")
    if not LEAST_EPSILON <= small <= MAX_EPSILON:
        raise ValueError(f"epsilon: expected a number in [1e-300, {MAX_EPSILON}]")
    if type(digits) is not int or not 1 <= digits <= MAX_DIGITS:
        raise ValueError(f"digits must be an int and lie in 1..{MAX_DIGITS}")
    expected = law(point)
    if point.q == 1:
        n = int(point.p) - 1
        number = distinct_real_zeros(force_polynomial(n, small))
        return SlowZeros(point, small, number, expected, None, tuple(polynomial_places(n, small, digits)), digits)
    column = _column(point, small)
    if column is None:
        return SlowZeros(point, small, None, expected, None, (), digits)
    places = tuple(zero_places(point, small, column, digits))
    return SlowZeros(point, small, number_of_zeros(column), expected, column, places, digits)


def checked_point(value: ExactInput, name: str) -> fmpq:
    """One exact number.

    :raises ValueError: a ball that is not one number.
    """
    point = exact(value, name)
    if not isinstance(point, fmpq):
        raise ValueError(f"{name}: expected one exact number, got a ball")
    return point


def _column(beta: fmpq, epsilon: fmpq) -> Column | None:
    b = beta - 1
    n = int(b.floor())
    order = max(n, 0) + 1 + _MORE_ORDERS
    for attempt in range(_TRIES):
        bits = _FIRST_BITS * 2**attempt

        def expansion(k: int, bits: int = bits) -> arb_mat:
            jet = slow_jet((k + fmpq(1, 2)) * CELL, b, epsilon, order + 1, bits)
            return arb_mat(order + 1, 1, jet)

        column = slow_zero_column(SlowSigns(expansion, order, bits + 32), beta, beta, n, fmpq(1, 2 ** (bits // 4)))
        if column is not None:
            return column
    return None
