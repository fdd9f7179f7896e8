"""(19'), (20') of proofs/from_state.md, section 8: y and v beside the slow manifold, from x and the state alone."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product

import mpmath
import pytest
from flint import arb, fmpq
from mpmath import mpf

from gspot_verified.expansion.from_state.affine_tube import ExcessBounds, Sums, _Path
from gspot_verified.expansion.from_state.barrier import value_of
from gspot_verified.expansion.from_state.fast_growth import Norm, Rectangle
from gspot_verified.expansion.from_state.slow_manifold import Cut, excess_terms, slow_manifold
from gspot_verified.numbers.balls import working_bits
from tests.expansion.from_state.test_barrier_numbers import in_mpmath, number
from tests.expansion.from_state.test_slow_manifold_in_balls import OTHER, exact_numbers, system_of

P, E = fmpq(1, 25), fmpq(1, 10**5)
SYSTEM = system_of([[2 * value for value in row] for row in exact_numbers(None)], OTHER)
A = mpf(2)
"""-alpha_1 at the G-spot."""
SHARES = tuple(map(arb, (5, 30, 20)))
LARGEST = arb(3)
NEARLY = 1 - mpf(10) ** -9


@pytest.fixture(autouse=True)
def _digits() -> Iterator[None]:
    with mpmath.workdps(40), working_bits(128):
        yield


def sums() -> Sums:
    manifold = slow_manifold(SYSTEM, Cut(2, fmpq(2), 2 * SYSTEM.beta - 2))
    excess = ExcessBounds.around(manifold.mu, LARGEST, arb(1))
    path = _Path(Rectangle(fmpq(1, 4), fmpq(1, 5)), P, E)
    first, second, third = SHARES
    return Sums(Norm(manifold, fmpq(1), fmpq(1, 2)), manifold, (first, second, third), excess, path, P)


def at(polynomial: object, h: mpf, r: mpf, excess: mpf) -> mpf:
    terms = excess_terms(polynomial).items()  # type: ignore[arg-type]
    return mpmath.fsum(number(value) * h**i * r**n * excess**k for (i, n, k), value in terms)


def largest_changes(found: Sums, h: mpf, r: mpf, side: int) -> tuple[mpf, mpf, mpf, mpf]:
    """The largest \\|Y\\|, \\|V\\|, and changes of both, for all x of the length p\\|L\\| by the shares."""
    manifold = found._manifold
    kappa, lag = mpf(6) / 5, mpf(9) / 50  # kappa, l/g of k_1 = 2, k_2 = 3, c = 1/2
    excess = side * 3 * r ** number(2 * SYSTEM.beta - 2)
    force = at(manifold.force, h, r, excess) + excess
    places = {}
    for signs in (*product((1, -1), repeat=3), (0, 0, 0)):
        first, second, third = (
            s * in_mpmath(share) * r**2 * abs(excess) for s, share in zip(signs, SHARES, strict=True)
        )
        speed = h * r * at(manifold.u, h, r, excess) + first / r
        pull = r**2 * at(manifold.w, h, r, excess) + second
        phi = r**2 * at(manifold.f, h, r, excess) + third / r
        places[signs] = (phi - (force + pull / r**2) - lag * speed) / kappa, speed
    still = places.pop((0, 0, 0))
    sizes = (max(abs(place[i]) for place in places.values()) for i in (0, 1))
    moved = (max(abs(place[i] - still[i]) for place in places.values()) for i in (0, 1))
    height, speed = sizes
    by_height, by_speed = moved
    return height, speed, by_height, by_speed


@pytest.mark.parametrize("side", [1, -1])
@pytest.mark.parametrize(("h", "r"), [("1/9", "1/10"), ("1/4", "1/50"), ("1/1000", "1/5")])
def test_y_and_v_beside_the_slow_manifold(h: str, r: str, side: int) -> None:
    """The bounds are reached: each share counts, with its factor."""
    found, (height, speed) = sums(), (number(fmpq(*map(int, text.split("/")))) for text in (h, r))
    place = arb(fmpq(*map(int, h.split("/")))), arb(fmpq(*map(int, r.split("/"))))
    _, _, by_height, by_speed = largest_changes(found, height, speed, side)
    for terms, wanted in zip(found._unsteady, (by_height, by_speed), strict=True):
        bound = in_mpmath(value_of(terms, *place))
        assert wanted * NEARLY <= bound <= wanted / NEARLY
    slopes = {(fmpq(0), fmpq(0)): arb(2)}, {(fmpq(0), fmpq(2)): arb(3)}
    moved = in_mpmath(value_of(found._moved(slopes), *place))
    wanted = 2 * (height * speed**3 / A) ** 2 * by_height + 3 * speed**2 * (height * speed**3 / A) * by_speed
    assert wanted * NEARLY <= moved <= wanted / NEARLY


@pytest.mark.parametrize("side", [1, -1])
def test_y_and_v_on_the_way_are_bounded(side: int) -> None:
    """Over p^3 and p^2, along the curves of e and of smaller ones from p_1 to h = h_1."""
    found = sums()
    height, speed = in_mpmath(found._height), in_mpmath(found._speed)
    largest = [mpf(0), mpf(0)]
    for share in (1, 10, 100):
        e = number(E) / share
        end = (e / mpf("0.25")) ** (mpf(1) / 3)
        for k in range(11):
            r = end * (number(fmpq(1, 5)) / end) ** (mpf(k) / 10)
            h = e / r**3
            y, v, _, _ = largest_changes(found, h, r, side)
            sizes = ((h * r**3 / A) ** 2 * y / r**6, (h * r**3 / A) * v / r**4)
            largest = [max(one, other) for one, other in zip(largest, sizes, strict=True)]
    assert largest[0] <= height < 3 * largest[0]
    assert largest[1] <= speed < 3 * largest[1]
