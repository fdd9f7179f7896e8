"""Gamma(y + 1/3)/Gamma(y) at rational y, from a hypergeometric series of ratio -1/1024 summed by binary splitting.

Many times cheaper than two Gamma values once thousands of digits are asked. Proof page: ``proofs/gamma_ratio.md``.
"""

from __future__ import annotations

from functools import reduce
from itertools import pairwise

from flint import arb, fmpq, fmpz, fmpz_poly

from gspot_verified.numbers.balls import add_remainder, working_bits

# N(n) of the proof page: row i holds the coefficients of n^i, by powers y^0 .. y^4.
_NUMERATOR = (
    (0, 2250, 4329, 2646, 567),
    (10100, 45648, 46314, 15255, 1053),
    (137580, 313938, 188001, 32319, 486),
    (698652, 968112, 340200, 26730, 0),
    (1666980, 1370196, 226476, 0, 0),
    (1875312, 717336, 0, 0, 0),
    (797040, 0, 0, 0, 0),
)
# How the work is cut; any choice is correct.
_LEAF = 4
_REDUCED_FROM = 32  # terms of the shortest block whose common factor is taken out
_SHARE = 0.085  # of the leaves that remain, for the next block
_BITS_PER_TERM = 10  # the ratio of the terms is -1/1024

_Node = tuple[fmpz, fmpz, fmpz]
_Polynomials = tuple[fmpz_poly, fmpz_poly, fmpz_poly]


def gamma_ratio(y: fmpq, bits: int) -> arb:
    """An enclosure of Gamma(y + 1/3)/Gamma(y) with about ``bits`` relative bits, for a rational y, 0 < y <= 1.

    :raises ValueError: y outside (0, 1].

    >>> ratio = gamma_ratio(fmpq(2, 9), 128)
    >>> ratio.overlaps(arb.gamma_fmpq(fmpq(5, 9)) / arb.gamma_fmpq(fmpq(2, 9)))
    True
    """
    with working_bits(bits + 40):
        return scaled_gamma_ratio(y, bits) / arb.gamma_fmpq(fmpq(2, 3))


def scaled_gamma_ratio(y: fmpq, bits: int) -> arb:
    """The sum of the series alone: an enclosure of Gamma(2/3) Gamma(y + 1/3)/Gamma(y).

    The tail after M terms is at most 4 (6M + 1) |E(M)|; it enters as the ball that the blocks are applied to.

    :raises ValueError: y outside (0, 1].
    """
    if not 0 < y <= 1:
        raise ValueError(f"y must lie in (0, 1], got {y}")
    steps, scale = _step_polynomials(y)
    leaves = (bits + 24) // (_BITS_PER_TERM * _LEAF) + 1
    leaf = _leaf_polynomials(steps)
    edges = _edges(leaves)
    widest = max(last - first for first, last in pairwise(edges))
    factors = _common_factors(int(y.q), widest * _LEAF // 2)
    with working_bits(64):
        rest = add_remainder(arb(0), 4 * (6 * arb(_LEAF * leaves) + 1) / arb(scale))
    for first, last in zip(edges[-2::-1], edges[:0:-1], strict=False):
        p, q, t = _block(leaf, factors, first, last)
        with working_bits(max(64, bits + 40 - _BITS_PER_TERM * _LEAF * first)):
            rest = (t + p * rest) / q
    with working_bits(bits + 40):
        return rest * scale


def _step_polynomials(y: fmpq) -> tuple[_Polynomials, fmpq]:
    """P, Q, T and the scale: the sum is scale * sum_n P(0)..P(n-1) T(n)/(Q(0)..Q(n)), all in integers."""
    p, q = int(y.p), int(y.q)
    above = [(2 * q, p), (2 * q, p + q), (3, -1), (6 * q, 5 * q - 3 * p), (6 * q, 2 * q - 3 * p), (3 * q, 3 * p + q)]
    below = [(12, 5), (12, 11)] + [(12 * q, 3 * p + q * i) for i in (1, 4, 7, 10)]
    above_content, above_product = _primitive(above)
    below_content, below_product = _primitive(below)
    powers = [p**i * q ** (4 - i) for i in range(5)]
    numerator = fmpz_poly([sum(c * v for c, v in zip(row, powers, strict=True)) for row in _NUMERATOR])
    ratio = fmpq(-9 * above_content, 4 * q * below_content)
    steps = (above_product * ratio.p, below_product * ratio.q, fmpz_poly([11, 12]) * numerator)
    return steps, fmpq(9, 4 * below_content) * ratio.q


def _primitive(factors: list[tuple[int, int]]) -> tuple[int, fmpz_poly]:
    """The product of linear factors u n + v, as its content and the product of the primitive ones."""
    content, product = 1, fmpz_poly([1])
    for u, v in factors:
        divisor = int(fmpz(u).gcd(fmpz(v)))
        content *= divisor
        product *= fmpz_poly([v // divisor, u // divisor])
    return content, product


def _leaf_polynomials(steps: _Polynomials) -> _Polynomials:
    """P, Q, T of the _LEAF terms from n = _LEAF j on, as polynomials in j."""
    shifted: list[_Polynomials] = []
    for i in range(_LEAF):
        at = fmpz_poly([i, _LEAF])
        shifted.append((steps[0](at), steps[1](at), steps[2](at)))
    return reduce(_merge_polynomials, shifted)


def _merge_polynomials(left: _Polynomials, right: _Polynomials) -> _Polynomials:
    return left[0] * right[0], left[1] * right[1], left[2] * right[1] + left[0] * right[2]


def _merge(left: _Node, right: _Node) -> _Node:
    return left[0] * right[0], left[1] * right[1], left[2] * right[1] + left[0] * right[2]


def _common_factors(q: int, longest: int) -> dict[int, fmpz]:
    """For each block length L: what divides P of the left and Q of the right of two reduced blocks of L terms."""
    primes = [n for n in range(2, 6 * q + 1) if 6 * q % n == 0 and fmpz(n).is_prime()]
    factors: dict[int, fmpz] = {}
    removed, length = fmpz(1), _REDUCED_FROM
    while length <= longest:
        coprime = fmpz.fac_ui(fmpz(length))
        for prime in primes:
            coprime //= fmpz(prime) ** _valuation_of_factorial(length, prime)
        factors[length] = coprime**6 // removed
        removed *= coprime**6
        length *= 2
    return factors


def _valuation_of_factorial(n: int, prime: int) -> int:
    total = 0
    while n:
        n //= prime
        total += n
    return total


def _block(leaf: _Polynomials, factors: dict[int, fmpz], first: int, last: int) -> _Node:
    """Integers P, Q, T, up to a common factor, of the leaves first <= j < last."""
    nodes: list[_Node] = [(leaf[0](j), leaf[1](j), leaf[2](j)) for j in range(first, last)]
    length = _LEAF
    while len(nodes) > 1:
        odd = [nodes[-1]] if len(nodes) % 2 else []
        pairs = [(nodes[i], nodes[i + 1]) for i in range(0, len(nodes) - 1, 2)]
        # Only the last block of a level can be shorter than the level's length; it is merged as it is.
        short = not odd and (last - first) * _LEAF % (2 * length) != 0
        whole = len(pairs) - 1 if short else len(pairs)
        divisor = factors.get(length, fmpz(1))
        if divisor == 1:
            merged = [_merge(left, right) for left, right in pairs]
        else:
            merged = [
                _merge((left[0] // divisor, left[1], left[2]), (right[0], right[1] // divisor, right[2]))
                for left, right in pairs[:whole]
            ] + [_merge(left, right) for left, right in pairs[whole:]]
        nodes = merged + odd
        length *= 2
    return nodes[0]


def _edges(leaves: int) -> list[int]:
    """Boundaries of the exact blocks: each takes a share of what remains."""
    edges, least = [0], max(8, leaves // 40)
    while edges[-1] < leaves:
        rest = leaves - edges[-1]
        step = max(least, int(rest * _SHARE))
        edges.append(leaves if 2 * rest < 3 * step else edges[-1] + step)
    return edges
