"""The spaces of Theorem 1 in t and epsilon: which powers of epsilon a space allows (proofs/expansion.md, section 1 b).

s^k delta^(n + front) is t^k epsilon^j with n + front = 2 k + 3 j. The powers j do not depend on nu.
"""

from __future__ import annotations

from collections.abc import Iterable
from itertools import product

from gspot_verified.paper.checks.identities import Algebra

_INDICES = Algebra("nu sigma")
_CONDUCTOR = 24
"""Sets of exponents are lists of those below this number; from it on all belong to the sets that occur here."""

Shift = tuple[int, int]
Exponents = frozenset[int]


def progressions(shift: Shift, front: int) -> list[tuple[int, int]] | None:
    """(first, step) of the powers of epsilon, for even and for odd n; ``None`` unless they are integers without nu.

    >>> progressions((1, -3), 2)
    [(0, 2), (3, 2)]
    """
    found = []
    for parity in (0, 1):
        k = _INDICES.read(f"nu + {shift[parity]} - 3*sigma")
        times_three = _INDICES.read(f"2*nu + {parity + front}") - 2 * k
        first = _INDICES.substitute(times_three, {name: _INDICES.constant(0) for name in ("nu", "sigma")})
        step = times_three.derivative("sigma")
        rest = times_three - first - step * _INDICES.symbols["sigma"]
        numbers = [0 if value.is_zero() else value.leading_coefficient() / 3 for value in (first, step)]
        if not rest.is_zero() or not step.is_constant() or any(number != int(number) for number in numbers):
            return None
        found.append((int(numbers[0]), int(numbers[1])))
    return found


def exponents(shift: Shift, front: int) -> Exponents | None:
    """The powers of epsilon below the conductor; ``None`` unless they are integers >= 0, all of them from some number
    on.

    >>> sorted(exponents((0, -4), 0))[:4]
    [0, 2, 3, 4]
    """
    rows = progressions(shift, front)
    if rows is None or any(first < 0 or step != 2 for first, step in rows) or (rows[0][0] + rows[1][0]) % 2 == 0:
        return None
    return frozenset(j for first, step in rows for j in range(first, _CONDUCTOR, step))


def sums(left: Iterable[int], right: Iterable[int]) -> Exponents:
    """The exponents below the conductor of products: those from it on belong to every set."""
    return frozenset(i + j for i, j in product(left, right) if i + j < _CONDUCTOR)


def later(found: Iterable[int], by: int) -> Exponents:
    """The exponents after a factor epsilon^by."""
    return sums(found, (by,))
