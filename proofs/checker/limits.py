"""What a check may cost, and how it ends: limits, a budget of work, products that are paid before they are made.

No proof needs a limit: a certificate beyond one of them is rejected, not refuted (check.md, section 6).
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple, NoReturn

WORK_PER_BYTE = 300_000  # products of digits for each byte of the certificate, beside Limits.work
OPERATION = 200  # what one operation of the interpreter costs, in products of digits
DIGIT = 30  # bits; Python multiplies digits of this length


class Rejected(Exception):
    """The certificate does not prove its statement; the text says why."""


def reject(reason: str) -> NoReturn:
    """End the check."""
    raise Rejected(reason)


def require(condition: object, reason: str) -> None:
    """End the check unless a condition holds."""
    if not condition:
        reject(reason)


class Limits(NamedTuple):
    """What a check may cost. To raise one on purpose: --limit NAME=NUMBER."""

    bytes: int = 20_000_000  # of the file
    line: int = 2_000_000  # bytes of one line
    lists: int = 200_000  # pieces, brackets and so on in the whole file
    beta: int = 200  # |β|, where F is computed
    tau: int = 200  # |τ|, where F is computed
    bits: int = 3_000  # accuracy of F
    splits: int = 10  # how often a box is halved
    work: int = 15  # 10^9 products of digits for a whole certificate; WORK_PER_BYTE is added
    memory: int = 160  # 10^6 bytes of numbers that are kept at one time

    def beyond(self, name: str) -> NoReturn:
        """End the check at a limit."""
        value = getattr(self, name)
        reject(f"out of the checker's range: the limit {name}={value} (raise it on purpose: --limit {name}=NUMBER)")

    def effort(self) -> str:
        """What was tried at most, where a sign stays open."""
        return f"with the limits bits={self.bits}, splits={self.splits} (raise them on purpose: --limit NAME=NUMBER)"

    def keep(self, name: str, value: Any) -> None:
        """End the check if a value is greater than the limit of this name."""
        if value > getattr(self, name):
            self.beyond(name)

    def budget(self, length: int) -> int:
        """The work that a certificate of so many bytes may take."""
        return self.work * 10**9 + WORK_PER_BYTE * length


def digits(*numbers: int) -> int:
    """The length of integers in digits, at least 1 for each."""
    return sum(map(int.bit_length, numbers)) // DIGIT + len(numbers)


class Meter:
    """A budget of work, from which is taken before the work is done: products of digits, operations of Python."""

    def __init__(self, limits: Limits, budget: int) -> None:
        self.limits, self.left = limits, budget

    def spend(self, products: int, operations: int) -> None:
        """Take from the budget."""
        self.left -= products + OPERATION * operations
        if self.left < 0:
            self.limits.beyond("work")

    def product(self, *powers: tuple[int, int]) -> int:
        """The product of base^exponent over pairs (base, exponent), exponent ≥ 0; paid: the square of its length."""
        self.spend(sum(exponent * digits(base) for base, exponent in powers) ** 2, 5 * len(powers))
        return math.prod(base**exponent for base, exponent in powers)

    def dot(self, *pairs: tuple[int, int]) -> int:
        """The sum of the products of pairs; paid: the products of their lengths."""
        self.spend(sum(digits(one) * digits(two) for one, two in pairs), 5 * len(pairs))
        return sum(one * two for one, two in pairs)
