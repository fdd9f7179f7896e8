"""The checker of lift-off and impact where nothing is small: each term of a bound, each hypothesis at its edge.

Page: proofs/from_state.md, sections 5 and 11, transcribed a second time in floating-point numbers of 90 digits. In the
shipped certificate the fast part is so small that a term of it could be left out unnoticed; here it is not.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from fractions import Fraction
from itertools import product
from types import SimpleNamespace
from typing import Any

import mpmath
import pytest
from checker.test_side import check, side
from mpmath import mpf

passage, ONE = check.passage, check.side.ONE
CLOSE = mpf(10) ** -25
SLOW: dict[str, list[tuple[int, int, str]]] = {
    "v": [(1, 1, "2/3"), (1, 2, "-1/5"), (2, 3, "1/7")],
    "w": [(1, 0, "-1/4"), (1, 2, "1/3"), (2, 1, "-1/9")],
    "f": [(1, 0, "1/2"), (2, 1, "-1/3")],
}
BARRIER = {(1, 0): Fraction(1, 50), (2, 1): Fraction(1, 30)}


LAZY = {"least": "1/12", "most": "1/8", "contact": ("1", "4", "6")}  # l/g > 1: a factor and a divisor of it differ


@pytest.fixture(autouse=True)
def _digits() -> Iterator[None]:
    with mpmath.workdps(90):
        yield


def real(value: Any) -> mpf:
    q = Fraction(value)
    return mpf(q.numerator) / q.denominator


def numbers() -> Any:
    return side.Numbers(side.BITS, check.limits.Meter(check.limits.Limits(), 10**15))


def made(
    least: str = "1/3",
    most: str = "1/3",
    b: str = "-3",
    contact: tuple[str, ...] = ("3", "2", "1/2"),
    **changed: Any,
) -> Any:
    """A range with every number of its own; its passage is one that nobody has checked."""
    start = passage.Start(
        {
            "alpha": ["-3/2", "-2/3", "-5/2"],
            "b": b,
            "contact": list(contact),
            "drift": "1",
            "epsilon": str(Fraction(most) ** 3),
            "kind": "passage",
            "p": "4/3",
            "scaled": "9/5",
            "within": "1/100",
        }
    )
    slow = SimpleNamespace(**{name: passage.read_polynomial([*map(list, terms)], name) for name, terms in SLOW.items()})
    passed = passage.Passage(
        slow=slow,
        barrier=BARRIER,
        first=Fraction(1, 20),
        share=Fraction(6, 5),
        rate=Fraction(7, 5),
        damping=Fraction(1, 9),
        moved=Fraction(1, 8),
    )
    given = {
        "least": Fraction(least),
        "most": Fraction(most),
        "start": start,
        "passed": passed,
        "end": Fraction(2),
        "pieces": 5,
        "cone": [Fraction(1)] * 4,
        "top": Fraction(9),
    }
    return side.Range(**given | changed)


class Page:
    """The numbers of the page for one δ of a range."""

    def __init__(self, of: Any, delta: Any, to: Callable[[Any], Any] = real) -> None:
        start, passed = of.start, of.passed
        self.of, self.delta = of, to(delta)
        one, two, damper = map(to, start.contact)
        self.kappa, self.g = one * two / (one + two), (one + two) / damper
        self.l = two - self.kappa
        first, second, third = map(to, start.alpha)
        self.a, self.beta, self.mean = -first, third / first, second / (third - first)
        self.S, self.p, self.share = to(of.scaled), to(start.p), to(passed.share)
        self.L = -to(start.b) / self.p - self.mean
        self.h = 1 / mpmath.sqrt(self.a * self.S**3)
        self.r = mpmath.sqrt(self.a * self.S) * self.delta

    def value(self, name: str, h: mpf, r: mpf) -> mpf:
        terms = passage.monomials(getattr(self.of.passed.slow, name)).items()
        return sum((real(c) * h**i * r**n for (i, n), c in terms), mpf(0))

    def z(self) -> mpf:
        """Z + I at the hand-over."""
        passed, p, e = self.of.passed, self.a * self.S * self.delta**2, self.a * self.delta**3
        layer = (self.p / p) ** real(passed.rate) * mpmath.exp(-real(passed.damping) * (self.p**2 - p**2) / (2 * e))
        return sum(
            (real(c) * self.h**i * self.r**n for (i, n), c in passed.barrier.items()), real(passed.first) * layer
        )

    def handed(self, x: tuple[int, int, int], z: mpf) -> tuple[list[mpf], mpf]:
        """(13) over L(S), where the parts of the fast deviation have these signs: e_b, e_y, e_v and φ."""
        V, W, phi = (sign * self.share * z * scale for sign, scale in zip(x, self.scales(), strict=True))
        force = 1 + self.value("w", self.h, self.r) + W
        speed = self.value("v", self.h, self.r) / self.delta + V * mpmath.sqrt(self.a * self.S)
        fast = self.r**2 * self.value("f", self.h, self.r) + phi * self.r
        y = (fast - self.l / self.g * self.delta * speed - force) / self.kappa
        return [-self.a * self.S, y, speed], fast

    def scales(self) -> tuple[mpf, mpf, mpf]:
        """c_V, 1 and c_φ over c_W."""
        return 1 / mpmath.sqrt(self.kappa), mpf(1), mpmath.sqrt(self.l) / self.g


def units(values: list[int]) -> list[mpf]:
    return [mpf(value) / ONE for value in values]


SIGNS = [(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]


@pytest.mark.parametrize("given", [{}, LAZY])
def test_the_set_of_the_hand_over_is_that_of_the_page_and_no_larger(given: Any) -> None:
    most = made(**given).most
    of = made(**given)._replace(least=most * (1 - Fraction(1, 10**30)))
    page, found = Page(of, of.most), side.handed_over(numbers(), of)
    basis, centre, radii = (
        mpmath.matrix([units(row) for row in found.basis]), units(found.centre), units(found.radii)
    )  # fmt: skip
    z, farthest = page.z(), [mpf(0)] * 3
    fast = mpf(0)
    for signs in SIGNS:
        e, phi = page.handed(signs, z)
        u = mpmath.lu_solve(basis, mpmath.matrix(e))
        farthest = [max(old, abs(u[k] - centre[k])) for k, old in enumerate(farthest)]
        fast = max(fast, abs(phi))
    for bound, true in zip([*radii[1:], mpf(found.burst) / ONE], [*farthest[1:], fast], strict=True):
        assert true - CLOSE <= bound <= true * (1 + mpf(10) ** -14)
    assert farthest[0] - CLOSE <= radii[0] <= CLOSE


@pytest.mark.parametrize("quiet", [True, False])
@pytest.mark.parametrize("given", [{"least": "1/4"}, LAZY])
@pytest.mark.parametrize("share", ["3/4", "7/8", "1"])
def test_the_set_of_the_hand_over_holds_that_of_every_delta(given: Any, share: str, quiet: bool) -> None:
    """Where nothing is fast, and v and f are 0, it is w alone that moves with δ."""
    of = made(**given)
    if quiet:
        slow = SimpleNamespace(v=passage.NOTHING, w=of.passed.slow.w, f=passage.NOTHING)
        of = of._replace(passed=of.passed._replace(slow=slow, barrier={}, first=Fraction(0)))
    page, found = Page(of, of.most * Fraction(share)), side.handed_over(numbers(), of)
    basis = mpmath.matrix([units(row) for row in found.basis])
    for signs in SIGNS:
        e, phi = page.handed(signs, page.z())
        u = mpmath.lu_solve(basis, mpmath.matrix(e))
        for value, centre, radius in zip(u, units(found.centre), units(found.radii), strict=True):
            assert abs(value - centre) <= radius
        assert abs(phi) <= mpf(found.burst) / ONE


def test_the_fast_part_is_bounded_closely_from_above() -> None:
    of = made()
    page = Page(of, of.most)
    bound = real(side.largest_fast(of, passage.above(Fraction(str(page.h))), passage.above(Fraction(str(page.r)))))
    assert page.z() <= bound <= page.z() * (1 + mpf(10) ** -15)


def drift(page: Page, h_1: mpf) -> mpf:
    """The log of C(S)/C_1 by the polynomial w, (12), for one h_1 = h at p_1."""
    found, r_1 = mpf(0), mpmath.sqrt(page.p)
    for i, n, c in SLOW["w"]:
        found -= page.beta * real(c) * (page.h**i * page.r**n - h_1**i * r_1**n) * 2 / (3 * i - n)
    return found


def test_the_amplitude_is_carried_from_the_limit_where_h_is_0() -> None:
    """As δ → 0, h at p_1 tends to 0: then only what is gained at the hand-over is left, in its own interval."""
    of, of_large, least = made(), made(), Fraction(2**40)
    large = passage.read_polynomial([[1, 0, str(least)]], "w")
    of_large.passed.slow.w = large
    (low, _), page = of_large.carried(numbers()), Page(of, of.most)
    gained = -page.beta * real(least) * page.h * 2 / 3
    # The h at the hand-over is an interval of a few units; with h at p_1 from 1 unit on there would be 2^40 more.
    assert real(low) <= gained - real(of.passed.moved)
    spread = side.root_of(numbers(), 1 / (of.start.a * of.scaled**3))
    assert real(low) >= gained - real(of.passed.moved) - real(least) * real(spread[1] - spread[0]) / ONE * page.beta


def test_the_column_of_the_slow_vector_is_paid_where_b_is_not_exact(monkeypatch: pytest.MonkeyPatch) -> None:
    """e_b = -a S is a ball: what it leaves of e_y and e_v counts with its share of their columns."""
    of = made()
    plain = side.handed_over(numbers(), of)
    monkeypatch.setattr(side, "times", lambda *_: 1 << 250)
    wide = side.handed_over(numbers(), of)
    assert plain.radii[0] > 0
    for one, other in zip(plain.radii[1:], wide.radii[1:], strict=True):
        assert other > (1 << 250) > other - one


@pytest.mark.parametrize("b", ["-3", "-1/2"])  # L > 0, L < 0
def test_the_amplitude_moves_as_the_slow_part_and_the_fast_part_say(b: str) -> None:
    of = made(b=b, least="1/4")
    low, high = map(real, of.carried(numbers()))
    moved, drifts = real(of.passed.moved), []
    for delta in (of.least, of.most):
        page = Page(of, delta)
        drifts.append(drift(page, page.a * page.delta**3 / page.p ** mpf("1.5")))
    assert low <= min(drifts) - moved < max(drifts) + moved <= high
    r_1, page = mpmath.sqrt(real(of.start.p)), Page(of, of.most)
    h_1 = page.a * page.delta**3 / page.p ** mpf("1.5")
    ends = [mpf(0), mpf(0)]
    for i, n, c in SLOW["w"]:  # each monomial by itself, between its values for the two ends
        share = page.beta * real(c) * 2 / (3 * i - n)
        here = sorted(-share * Page(of, delta).h ** i * Page(of, delta).r ** n for delta in (of.least, of.most))
        there = sorted((mpf(0), share * h_1**i * r_1**n))
        ends = [end + one + two for end, one, two in zip(ends, here, there, strict=True)]
    assert abs(low - (ends[0] - moved)) < CLOSE
    assert abs(high - (ends[1] + moved)) < CLOSE
    whole = abs(page.L) * (page.a * page.S * page.delta**2 / page.p) ** (page.beta - 1)
    smallest, largest = map(real, of.amplitude(numbers()))
    assert 0 <= whole * mpmath.exp(low) - smallest <= whole * mpf(10) ** -12
    assert 0 <= largest - whole * mpmath.exp(high) <= whole * mpf(10) ** -12


# Pieces.


@pytest.mark.parametrize(("b", "low"), [("-3", True), ("-1/2", False)])
def test_the_force_stays_positive_on_each_piece_for_the_largest_amplitude(
    monkeypatch: pytest.MonkeyPatch, b: str, low: bool
) -> None:
    of, begins = made(b=b, least="1/4"), list[tuple[Any, Fraction, Fraction]]()
    assert (of.start.excess > 0) == low
    edge_of_force = real(of.start.mean) / real(of.amplitude(numbers())[1])

    def forces(worst: mpf, at: int) -> Callable[..., Any]:
        def advance(_: Any, state: Any, begin: Fraction, length: Fraction) -> Any:
            begins.append((state, begin, length))
            number = len(begins) - 1
            size = int(mpmath.floor((worst if number == at else edge_of_force / 2) * ONE))
            return side.Piece((-size, 99 * ONE) if low else (-99 * ONE, size), [], 0, number)

        return advance

    monkeypatch.setattr(side, "check_growth", lambda *_: -1 if low else 1)
    monkeypatch.setattr(side, "handed_over", lambda *_: "at the hand-over")
    statement = SimpleNamespace(reaches=Fraction(0))
    for at in range(of.pieces):
        begins.clear()
        monkeypatch.setattr(side.Equations, "advance", forces(edge_of_force * (1 - mpf(10) ** -12), at))
        side.check_range(numbers(), statement, of)
        length = (of.end + of.scaled) / of.pieces
        assert [state for state, _, _ in begins] == ["at the hand-over", 0, 1, 2, 3]
        assert [begin for _, begin, _ in begins] == [k * length - of.scaled for k in range(of.pieces)]
        assert all(each == length for _, _, each in begins)
        begins.clear()
        monkeypatch.setattr(side.Equations, "advance", forces(edge_of_force * (1 + mpf(10) ** -12), at))
        with pytest.raises(check.limits.Rejected, match="not certainly positive before the cone"):
            side.check_range(numbers(), statement, of)


@pytest.mark.parametrize("given", [{"least": "7/24"}, LAZY])
@pytest.mark.parametrize("begin", [Fraction(-9, 5), Fraction(3, 2)])
def test_what_is_reached_on_a_piece_is_no_less_than_theorem_u1_says(
    monkeypatch: pytest.MonkeyPatch, begin: Fraction, given: Any
) -> None:
    """(c) with W, N and n at points of the piece, for values of δ in the range; all terms of it are large."""
    monkeypatch.setattr(side, "turned", lambda _, columns, state: state._replace(basis=columns))
    of, length = made(**given), Fraction(1, 20)
    equations = side.Equations(numbers(), of)
    rows = [["1", "1/5", "0"], ["-1/4", "3/2", "1/3"], ["1/7", "0", "2"]]
    centre, radii, forced = ["1", "0", "-1/2"], ["1/30", "1/40", "1/50"], Fraction(1, 100)
    page = Page(of, of.most)
    least_rate = page.g - page.l / page.g * page.delta**2 * page.a * page.S
    x = real(begin) + page.S
    burst = Fraction(int(60 * mpmath.exp(least_rate * x / page.delta)))
    basis = [[int(Fraction(value) * ONE) for value in row] for row in rows]
    exact = [int(Fraction(value) * ONE) for value in (*centre, *radii)]
    state = side.Deviations(basis, exact[:3], exact[3:], int(burst * ONE), int(forced * ONE))
    piece = equations.advance(state, begin, length)
    reached = units(piece.after.radii)
    whole = mpmath.matrix([bound + abs(real(value)) for bound, value in zip(reached, centre, strict=True)])
    flow = equations.flow(begin)[0]
    Q = mpmath.matrix([units(row) for row in basis])
    h, phi_forced = real(length), mpf(piece.after.forced) / ONE
    assert piece.after.burst == state.burst
    at_once = page.delta / least_rate * real(burst) * mpmath.exp(-least_rate * x / page.delta)
    for part in (Fraction(0), Fraction(1, 2), Fraction(1)):
        t = h * real(part)
        s = real(begin) + t
        Y = mpmath.matrix(3, 3)
        change = mpmath.matrix(3, 3)
        for i, j in product(range(3), repeat=2):
            Y[i, j] = sum(mpf(c) / ONE * t**k for k, c in enumerate(flow[i][j]))
            change[i, j] = sum(k * mpf(c) / ONE * t ** (k - 1) for k, c in enumerate(flow[i][j]) if k)
        inverse = (Y * Q) ** -1
        push = inverse * mpmath.matrix([page.a * page.beta, 0, -page.a * s])
        for delta in map(real, (of.least, of.most)):
            lag = page.l / page.g * delta
            A = mpmath.matrix(
                [
                    [0, -page.kappa * page.a * page.beta, -lag * page.a * page.beta],
                    [0, 0, 1],
                    [1, page.kappa * page.a * s, lag * page.a * s],
                ]
            )
            N = inverse * (A * Y - change) * Q
            for j in range(3):
                rest = sum(abs(N[j, k]) * whole[k] for k in range(3))
                fed = abs(push[j]) * (at_once + h * phi_forced)
                assert fed + h * rest > real(radii[j]) / 10  # so a term that is left out is seen
                assert reached[j] >= real(radii[j]) + fed + h * rest
        for signs in SIGNS:  # corners of what is reached: what they feed into φ, and the force there
            u = mpmath.matrix([real(c) + sign * w for c, sign, w in zip(centre, signs, reached, strict=True)])
            e = Y * Q * u
            lag = page.l / page.g * page.delta
            turn = e[0] + page.kappa * page.a * s * e[1] + lag * page.a * s * e[2]
            assert phi_forced >= page.l / page.g * page.delta**2 * abs(turn) / least_rate
            fast = real(burst) * mpmath.exp(-least_rate * x / page.delta) + phi_forced + lag * abs(e[2])
            low, high = units(list(piece.force))
            assert low <= -page.kappa * e[1] - fast < -page.kappa * e[1] + fast <= high
            if part == 1:
                left = real(burst) * mpmath.exp(-least_rate * (x + h) / page.delta)
                assert mpf(piece.fast) / ONE >= left + phi_forced + lag * abs(e[2])
                for value, bounds in zip(e, piece.end, strict=True):
                    assert mpf(bounds[0]) / ONE <= value <= mpf(bounds[1]) / ONE


@pytest.mark.parametrize("given", [{"least": "1/4"}, LAZY])
@pytest.mark.parametrize("s", [Fraction(-9, 5), Fraction(3, 2)])
def test_the_equations_are_those_of_the_page_for_every_delta_of_a_range(given: Any, s: Fraction) -> None:
    """A'Y - Y' for A' of (19), in exact rationals; the parts of (3) and of f, each by itself."""
    of, t, longest = made(**given), Fraction(1, 30), Fraction(1, 20)
    equations, start = side.Equations(numbers(), of), of.start
    flow, beyond = equations.flow(s)
    time = (0, side.units(longest))
    of_flow, of_rest = side.on_all(numbers(), flow, time), side.on_all(numbers(), beyond, time)
    defect = equations.defect(of_rest, of_flow, side.between(numbers(), s, s + longest))
    Y = [[sum(c * t**k for k, c in enumerate(entry)) for entry in row] for row in flow]
    change = [[sum(k * c * t ** (k - 1) for k, c in enumerate(entry) if k) for entry in row] for row in flow]
    beta, lag = start.beta, start.lag / start.rate
    rate = start.rate - lag * of.most**2 * start.a * of.scaled
    for delta in (of.least, of.most):
        now = start.a * (s + t)
        A = [
            [Fraction(0), -start.kappa * start.a * beta, -lag * delta * start.a * beta],
            [Fraction(0), Fraction(0), Fraction(1)],
            [Fraction(1), start.kappa * now, lag * delta * now],
        ]
        for i, j in product(range(3), repeat=2):
            rest = sum(A[i][k] * Y[k][j] for k in range(3)) - change[i][j]
            assert defect[i][j][0] <= rest <= defect[i][j][1]
    for i, j in product(range(3), repeat=2):
        farthest = lag * (of.most - of.least) / 2 * side.size(of_flow[side.V][j])
        bend = (start.a * beta, Fraction(0), start.a * max(abs(s), abs(s + longest)))[i]
        wide = defect[i][j][1] - defect[i][j][0] - (of_rest[i][j][1] - of_rest[i][j][0])
        assert 0 <= wide - 2 * (side.DEGREE + 3) ** 2 - 2 * farthest * bend <= 99
    e = [Fraction(-3, 4), Fraction(2), Fraction(1, 2)]
    at = side.units(abs(s)) * (1 if s > 0 else -1)
    fed = equations.fed([(side.units(value),) * 2 for value in e], (at, at))
    turns = [abs(e[0] + start.kappa * start.a * s * e[1] + lag * delta * start.a * s * e[2])
             for delta in (of.least, of.most)]  # fmt: skip
    assert 0 <= Fraction(fed, ONE) - lag * of.most**2 * max(turns) / rate <= Fraction(99, ONE)
    f = equations.lagged(7 * ONE, (side.units(e[0]), ONE // 4))
    assert 0 <= Fraction(f, ONE) - 7 - lag * of.most * Fraction(3, 4) <= Fraction(9, ONE)
    fallen, exact = mpf(equations.fallen(s)) / ONE, mpmath.exp(-real(rate * (s + of.scaled) / of.most))
    assert 0 <= fallen - exact <= exact * mpf(10) ** -12 + mpf(10) ** -50


@pytest.mark.parametrize("damper", ["1/2", "24"])
def test_a_fast_part_that_may_not_fall_is_refused(damper: str) -> None:
    of = made(contact=("3", "2", damper))
    if damper == "1/2":
        side.Equations(numbers(), of)
        return
    with pytest.raises(check.limits.Rejected, match="φ does not fall"):
        side.Equations(numbers(), of)


@pytest.mark.parametrize("centre", [(3, -2, 5), (-3, 2, -5)])
def test_a_placed_set_is_the_hull_of_its_corners(centre: tuple[int, int, int]) -> None:
    frame = [[(1, 2), (-3, -1), (-2, 4)], [(5, 5), (0, 0), (-1, 1)], [(-2, -1), (2, 6), (0, 3)]]
    radii = (1, 2, 3)
    wide = [[(low * ONE, high * ONE) for low, high in row] for row in frame]
    found = side.placed(wide, [c * ONE for c in centre], [r * ONE for r in radii])
    for row, (low, high) in zip(frame, found, strict=True):
        values = [[[entry * c for entry in pair] for pair, c in zip(row, centre, strict=True)]][0]
        reach = sum(max(map(abs, pair)) * r for pair, r in zip(row, radii, strict=True))
        assert low == (sum(map(min, values)) - reach) * ONE
        assert high == (sum(map(max, values)) + reach) * ONE


def test_roots_and_ranges_are_rounded_outward() -> None:
    for q in (Fraction(3), Fraction(2, 7), Fraction(1, 10**9), Fraction(4)):
        low, high = side.root_of(numbers(), q)
        assert Fraction(low, ONE) ** 2 <= q <= Fraction(high, ONE) ** 2
        assert high - low <= 10**5
        ends = side.between(numbers(), q / 3, q)
        assert Fraction(ends[0], ONE) <= q / 3 < q <= Fraction(ends[1], ONE)


@pytest.mark.parametrize("fed", ["1/9", "5"])
@pytest.mark.parametrize("centre", [(2, -1, 1), (-2, 1, 0)])
@pytest.mark.parametrize("second", [("3", "1/2", "-1"), ("0", "0", "0")])
def test_what_is_reached_on_a_piece_is_the_left_side_of_the_inequality(
    monkeypatch: pytest.MonkeyPatch, fed: str, centre: tuple[int, int, int], second: tuple[str, str, str]
) -> None:
    """(c) with matrices that are chosen, so that each of its terms is known; a component may be bounded at once."""
    of, begin, length = made(), Fraction(-1), Fraction(1, 20)
    N = [[Fraction(v) for v in row] for row in (("1", "-2", "0"), second, ("-1", "2", "1"))]
    seen = list[Any]()
    unit = [[ONE * (i == j) for j in range(3)] for i in range(3)]

    def defect(_: Any, beyond: Any, flow: Any, s: Any) -> Any:
        seen.append((beyond, flow, s))
        return [[(int(value * ONE),) * 2 for value in row] for row in N]

    def feed(_: Any, e: Any, s: Any) -> int:
        seen.append((e, s))
        return int(side.units(Fraction(fed)))

    monkeypatch.setattr(side.Equations, "defect", defect)
    monkeypatch.setattr(side.Equations, "fed", feed)
    monkeypatch.setattr(side, "inverse_of", lambda _: [[(value, value) for value in row] for row in unit])
    monkeypatch.setattr(side, "turned", lambda _, columns, state: state._replace(basis=columns))
    equations = side.Equations(numbers(), of)
    radii, forced = [Fraction(1, 3), Fraction(1, 4), Fraction(1, 5)], Fraction(1)
    burst = Fraction(int(6 * mpmath.exp(real(equations.least_rate * (begin + of.scaled) / of.most))))
    state = side.Deviations(
        unit, [c * ONE for c in centre], [side.units(value) for value in radii], int(burst) * ONE, ONE
    )
    piece = equations.advance(state, begin, length)
    s = side.between(numbers(), begin, begin + length)
    assert all(each[-1] == s for each in seen)
    start, phi = of.start, max(forced, Fraction(fed))
    assert Fraction(piece.after.forced, ONE) - phi <= Fraction(1, ONE)
    first = Fraction(equations.fallen(begin), ONE) * burst
    push = [start.a * start.beta, Fraction(0), start.a * max(abs(begin), abs(begin + length))]

    def left(bounds: list[Fraction]) -> list[Fraction]:
        found = []
        for i in range(3):
            rest = sum(abs(N[i][k]) * (bounds[k] + abs(centre[k])) for k in range(3))
            at_once = push[i] * first * of.most / equations.least_rate
            found.append(radii[i] + at_once + length * (rest + push[i] * phi))
        return found

    reached = [Fraction(value, ONE) for value in piece.after.radii]
    above = left([value * Fraction(107, 100) + Fraction(1, 10**9) for value in reached])
    for value, least, most in zip(reached, left(reached), above, strict=True):
        assert least <= value <= most
        assert most - least < Fraction(1, 30)
    (e, _) = seen[-1]
    lag = start.lag / start.rate * of.most
    fast = first + phi + lag * Fraction(side.size(e[side.V]), ONE)
    sides = [-start.kappa * Fraction(end, ONE) for end in reversed(e[side.Y])]
    assert 0 <= sides[0] - fast - Fraction(piece.force[0], ONE) < Fraction(1, 10**20)
    assert 0 <= Fraction(piece.force[1], ONE) - sides[1] - fast < Fraction(1, 10**20)
    left_over = Fraction(equations.fallen(begin + length), ONE) * burst
    at_end = left_over + phi + lag * Fraction(side.size(piece.end[side.V]), ONE)
    assert 0 <= Fraction(piece.fast, ONE) - at_end < Fraction(1, 10**20)
    flow, beyond = equations.flow(begin)
    time = (0, numbers().interval(length)[1])
    assert seen[0][:2] == (side.on_all(numbers(), beyond, time), side.on_all(numbers(), flow, time))


@pytest.mark.parametrize("rest", ["0", "1"])
def test_a_bound_that_is_only_met_is_not_enough(monkeypatch: pytest.MonkeyPatch, rest: str) -> None:
    """Theorem U1 wants its left side below the guess: if it never is, but equal or larger, the piece is refused."""
    of = made()
    unit = [[ONE * (i == j) for j in range(3)] for i in range(3)]
    state = side.Deviations(unit, [ONE, 0, 0], [ONE // 8] * 3, 0, 0)
    monkeypatch.setattr(side, "larger", lambda bound: bound)
    monkeypatch.setattr(side.Equations, "fed", lambda *_: 0)
    nothing = [[(0, 0)] * 3 for _ in range(3)]
    nothing[1][1] = (0, int(rest))
    monkeypatch.setattr(side.Equations, "defect", lambda *_: nothing)
    with pytest.raises(check.limits.Rejected, match="the inequality of Theorem U1 is not satisfied"):
        side.Equations(numbers(), of).advance(state, Fraction(0), Fraction(1, 20))
