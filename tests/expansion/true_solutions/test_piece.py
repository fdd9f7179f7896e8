"""One piece of Theorem U1 (proofs/uniform.md): inequality (c) a second time in exact fractions, for equations whose
matrices are given numbers; and what the frame may be.

A run cannot see a term of (c) that is left out while the guesses are wide.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction
from types import SimpleNamespace
from typing import Any

import pytest
from flint import arb, arb_mat, fmpq, fmpq_mat
from hypothesis import given, settings
from hypothesis import strategies as st
from samples.strategies import ends, to_fraction

from gspot_verified.expansion.true_solutions import piece as module
from gspot_verified.expansion.true_solutions.equations import Coupling
from gspot_verified.expansion.true_solutions.frames import Frame, identity
from gspot_verified.expansion.true_solutions.piece import Deviations, Rules, TrackPiece, advance
from gspot_verified.numbers.balls import working_bits

BITS = 128
SIZE = 5  # xi_1, p, b, y, v
DELTA, KAPPA, LAG, DAMPER, RATE = fmpq(1, 16), fmpq(1, 2), fmpq(3, 4), fmpq(5, 4), fmpq(2)
ORDER, POWER = 4, fmpq(2)
START, END = fmpq(-1), fmpq(-15, 16)
LIMIT = [[0, 0, 0, 2, 0], [0, 0, 0, 0, 0], [0, 0, 0, -1, 0], [0, 0, 0, 0, 1], [0, 3, 1, 1, 0]]  # at s = -1
SLOPE = [[0] * 5, [0] * 5, [0] * 5, [0] * 5, [0, 0, 0, -1, 0]]
REST = [[1, 0, 0, 2, 0], [3, 0, 0, 0, 0], [4, 0, 0, -1, 0], [0, 0, 0, 0, 0], [0, 5, 0, 1, 0]]  # over 64
FAST = [2, 0, -3, 0, 1]
RESIDUAL, RESIDUAL_Z = [1, 2, 3, 4, 5], 6
FORCE, P = 7, 3  # the expansion's lambda_N, and p~
SHARE, LEAST_RATE = LAG / RATE, RATE * fmpq(15, 16)
SMALL = (fmpq(3, 64), fmpq(1, 64))  # delta from 1/32 to 1/16: middle and radius
TURNED = [[2, 0, 0, 1, 0], [0, 1, 0, 0, 0], [0, 0, 4, 0, 0], [0, 0, 0, 1, 0], [0, 0, 0, 2, 1]]
CENTRE = [1, 0, -2, 3, -1]
RADII = [fmpq(1, 8), fmpq(1, 16), fmpq(1, 8), fmpq(1, 4), fmpq(1, 32)]


class Given:
    """Equations with given numbers, which remember what they were asked."""

    delta, kappa, lag, damper, rate = (arb(value) for value in (DELTA, KAPPA, LAG, DAMPER, RATE))
    share, least_rate, small = arb(SHARE), arb(LEAST_RATE), arb(SMALL[0], (1, -6))
    size, p, b, y, v = SIZE, 1, 2, 3, 4
    trajectory = SimpleNamespace(order=ORDER)

    def __init__(self) -> None:
        self.tubes: list[list[arb]] = []
        self.reaches: list[fmpq] = []
        self.places: list[arb] = []

    def lagged(self, bound: arb, v: arb) -> arb:
        return (bound + self.share * self.delta * v.abs_upper()).upper()

    def limit(self, s: arb) -> arb_mat:
        return arb_mat(LIMIT) + arb_mat(SLOPE) * (s + 1)

    def limit_slope(self) -> arb_mat:
        return arb_mat(SLOPE)

    def coupling(self, s: arb, tube: Sequence[arb]) -> Coupling:
        self.places.append(s)
        self.tubes.append(list(tube))
        fast = arb_mat([[arb(value, (1, -3))] for value in FAST])
        return Coupling(arb_mat(REST) * arb(fmpq(1, 64)), fast, arb(FORCE), arb(P))

    def states(self, s: arb, tube: Sequence[arb]) -> list[arb]:
        return [s, *tube]

    def residual(self, reach: fmpq) -> tuple[list[arb], arb]:
        self.reaches.append(reach)
        return [arb(value) for value in RESIDUAL], arb(RESIDUAL_Z)


def state(initial: fmpq, elapsed: fmpq, forced: fmpq, sign: int = 1) -> Deviations:
    radii, turned, centre = tuple(map(arb, RADII)), arb_mat(TURNED), tuple(arb(sign * value) for value in CENTRE)
    return Deviations(centre, radii, turned, arb(initial), elapsed, arb(forced))


def advanced(monkeypatch: pytest.MonkeyPatch, start: Deviations) -> tuple[TrackPiece, Given]:
    """One piece in the frame Y = 1, so that W = Q and nothing is wider than the page has it; Q' = Q."""
    equations: Any = Given()
    monkeypatch.setattr(module, "turned_frame", lambda columns, _: columns.mid())
    monkeypatch.setattr(module, "frame_at", lambda _, __, turned: Frame((identity(SIZE),), turned))
    with working_bits(BITS):
        found = advance(Rules(equations, POWER), start, START, END)
    assert found is not None
    return found, equations


def sizes(matrix: fmpq_mat) -> fmpq_mat:
    return fmpq_mat(matrix.nrows(), matrix.ncols(), [abs(value) for value in matrix.entries()])


def column(values: Sequence[Any]) -> fmpq_mat:
    return fmpq_mat(len(values), 1, [fmpq(value) for value in values])


Ball = tuple[fmpq, fmpq]


def times(one: Ball, other: Ball) -> Ball:
    return one[0] * other[0], abs(one[0]) * other[1] + abs(other[0]) * one[1] + one[1] * other[1]


def fed_by(tube: Sequence[Ball]) -> fmpq:
    """(3) of the page for these middles and radii of e, by hand."""
    _, place, b, y, v = tube
    lagging = times(SMALL, v)
    middle = b[0] + FORCE * place[0] - KAPPA * P * y[0] - SHARE * P * lagging[0]
    radius = b[1] + FORCE * place[1] + KAPPA * P * y[1] + SHARE * P * lagging[1]
    shrunk = DELTA ** (ORDER - 2)
    slow = SHARE * DELTA**2 * (abs(middle) + radius + shrunk * RESIDUAL[4])
    return (slow + shrunk * (DELTA * LAG * RESIDUAL[3] + DAMPER * RESIDUAL_Z)) / LEAST_RATE


def is_bound(value: arb, page: fmpq | Fraction, slack: float = 1e-7) -> bool:
    assert value.is_finite()
    top, wanted = ends(value)[1], to_fraction(page) if isinstance(page, fmpq) else page
    return wanted * (1 - Fraction(1, 10**9)) <= top <= wanted * (1 + Fraction(slack))


CASES = [
    (fmpq(0), fmpq(0), fmpq(0)),  # nothing fast but what is fed
    (fmpq(0), fmpq(0), fmpq(9)),  # what was fed before is more
    (fmpq(3), fmpq(0), fmpq(0)),  # a burst
    (fmpq(3), fmpq(1, 32), fmpq(0)),  # what is left of it
]


@pytest.mark.parametrize("sign", [1, -1])
@pytest.mark.parametrize(("initial", "elapsed", "forced"), CASES)
def test_the_end_of_a_piece_is_the_left_side_of_the_inequality(
    initial: fmpq, elapsed: fmpq, forced: fmpq, sign: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    found, equations = advanced(monkeypatch, state(initial, elapsed, forced, sign))
    turned = fmpq_mat(TURNED)
    inverse = turned.inv()
    middle = (turned * column(CENTRE) * fmpq(sign)).entries()
    largest = []  # |T|, and w+ of it
    radii = []
    for value, centre in zip(found.deviations, middle, strict=True):
        lower, upper = (fmpq(end.numerator, end.denominator) for end in ends(value))
        assert abs((lower + upper) / 2 - centre) < fmpq(1, 10**9)
        radii.append((upper - lower) / 2)
        largest.append(max(abs(lower), abs(upper)))
    guess = sizes(turned).solve(column(radii))
    length, shrunk = END - START, DELTA ** (ORDER - 2)
    everything = max(forced, fed_by(list(zip(middle, radii, strict=True))))
    burst = to_fraction(initial) * Fraction(math.exp(-30 * float(int(elapsed.p)) / int(elapsed.q)))
    # A at s = -1 and at the end: it is linear in s.
    drift = fmpq_mat(LIMIT) + fmpq_mat(REST) / 64
    matrices = [sizes(inverse * (drift + fmpq_mat(SLOPE) * part) * turned) for part in (fmpq(0), length)]
    widest = fmpq_mat(SIZE, SIZE, [max(pair) for pair in zip(*(one.entries() for one in matrices), strict=True)])
    moved = widest * (guess + sizes(column(CENTRE)))
    weight = sizes(inverse * column(FAST)) + sizes(inverse) * column([fmpq(1, 8)] * SIZE)
    rest = sizes(inverse) * column(RESIDUAL) * shrunk
    assert all(s.contains(arb(START)) and s.contains(arb(END)) for s in equations.places)
    for i, bound in enumerate(found.at_end.radii):
        page = RADII[i] + length * (moved[i, 0] + weight[i, 0] * everything + rest[i, 0])
        whole = to_fraction(page) + to_fraction(weight[i, 0]) * burst * to_fraction(DELTA / LEAST_RATE)
        assert is_bound(bound, whole), i
        assert ends(bound)[1] < to_fraction(guess[i, 0])
    left = to_fraction(initial) * Fraction(math.exp(-30 * float(int((elapsed + length).p)) / int((elapsed + length).q)))
    assert is_bound(found.fast, burst + to_fraction(everything))
    lag = to_fraction(SHARE * DELTA) * max(map(abs, ends(found.end_deviations[4])))
    assert is_bound(found.end_fast, left + to_fraction(everything) + lag)
    assert is_bound(found.at_end.forced, everything)
    assert (found.at_end.initial, found.at_end.elapsed) == (arb(initial), elapsed + length)
    low, high = (to_fraction(-KAPPA) * end for end in reversed(ends(found.deviations[3])))
    fast = ends(found.fast)[1] + to_fraction(SHARE * DELTA * largest[4])
    assert is_bound(found.force + 100, 100 + high + fast, 1e-9)
    assert is_bound(100 - found.force, 100 - low + fast, 1e-9)
    assert equations.reaches == [fmpq(1)]
    for one, other in zip(found.states, (equations.places[-1], *equations.tubes[-1]), strict=True):
        assert one.contains(other)
        assert other.contains(one)
    for passed, size in zip(equations.tubes[-1], largest, strict=True):
        assert is_bound(abs(passed), to_fraction(size * DELTA**2))


INITIAL = fmpq(40007, 8192)  # more digits than there are bits


@pytest.mark.parametrize("bits", [6, 7, 8, 9, 10])
def test_all_is_rounded_upwards(bits: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """At a few bits, with the guess 64 for each coordinate: the first and the last part of (c), and the bounds of f."""
    monkeypatch.setattr(module, "frame_at", lambda _, __, turned: Frame((identity(SIZE),), turned))
    monkeypatch.setattr(module, "turned_frame", lambda columns, _: columns.mid())
    monkeypatch.setattr(module, "larger", lambda _: arb(64))
    equations: Any = Given()
    with working_bits(bits):
        found = advance(Rules(equations, POWER), state(INITIAL, fmpq(0), fmpq(1, 3)), START, END)
    assert found is not None
    turned = fmpq_mat(TURNED)
    inverse, length, shrunk = turned.inv(), END - START, DELTA ** (ORDER - 2)
    tube = zip((turned * column(CENTRE)).entries(), (sizes(turned) * column([64] * SIZE)).entries(), strict=True)
    fed = fed_by(list(tube))
    assert fed > fmpq(1, 3)
    weight = sizes(inverse * column(FAST)) + sizes(inverse) * column([fmpq(1, 8)] * SIZE)
    moved = sizes(inverse * (fmpq_mat(LIMIT) + fmpq_mat(REST) / 64) * turned) * (
        column([64] * SIZE) + sizes(column(CENTRE))
    )
    rest = sizes(inverse) * column(RESIDUAL) * shrunk
    for i, bound in enumerate(found.at_end.radii):
        page = (
            RADII[i]
            + weight[i, 0] * INITIAL * DELTA / LEAST_RATE
            + length * (moved[i, 0] + weight[i, 0] * fed + rest[i, 0])
        )
        assert ends(bound)[1] >= to_fraction(page)
    assert ends(found.at_end.forced)[1] >= to_fraction(fed)
    assert ends(found.fast)[1] >= ends(found.at_end.forced)[1] + to_fraction(INITIAL)
    lag = to_fraction(SHARE * DELTA) * max(map(abs, ends(found.end_deviations[4])))
    assert ends(found.end_fast)[1] >= to_fraction(fed) + lag + Fraction(math.exp(-1.875)) * to_fraction(INITIAL)


def test_the_inequality_is_strict(monkeypatch: pytest.MonkeyPatch) -> None:
    """Without a linear part the left side of (c) is one number: a guess that is equal to it does not do."""

    class Still(Given):
        def limit(self, s: arb) -> arb_mat:  # noqa: ARG002
            return arb_mat(SIZE, SIZE)

        def limit_slope(self) -> arb_mat:
            return arb_mat(SIZE, SIZE)

        def coupling(self, s: arb, tube: Sequence[arb]) -> Coupling:
            fast = arb_mat([[value] for value in FAST])
            return Coupling(arb_mat(SIZE, SIZE), fast, super().coupling(s, tube).force, arb(P))

        def residual(self, reach: fmpq) -> tuple[list[arb], arb]:  # noqa: ARG002
            return [arb(0)] * SIZE, arb(0)

    start = Deviations((arb(0),) * SIZE, (arb(1),) * SIZE, identity(SIZE), arb(0), fmpq(0), arb(64))
    left = [1 + (END - START) * abs(value) * 64 for value in FAST]
    monkeypatch.setattr(module, "frame_at", lambda _, __, turned: Frame((identity(SIZE),), turned))
    for more in (fmpq(0), fmpq(1, 2**12)):
        guesses = [arb(value + more) for value in left] * 50
        monkeypatch.setattr(module, "larger", lambda _, left=guesses: left.pop(0))
        equations: Any = Still()
        with working_bits(BITS):
            found = advance(Rules(equations, POWER), start, START, END)
        assert (found is not None) is bool(more)


def test_a_frame_that_moves(monkeypatch: pytest.MonkeyPatch) -> None:
    """W(s) = Y(s - s_k) Q: the enclosures hold W(s) u for all s of the piece, and at its end."""
    slope = [[0, 1, 2, 0, 0], [1, 0, 0, 0, 3], [0, 0, 0, -2, 0], [1, 0, 4, 0, 0], [0, 0, 1, 0, 0]]
    flow = (identity(SIZE), arb_mat(slope))
    monkeypatch.setattr(module, "frame_at", lambda _, __, turned: Frame(flow, turned))
    seen: list[arb_mat] = []

    def kept(columns: arb_mat, _: Any) -> arb_mat:
        seen.append(columns)
        return columns.mid()

    monkeypatch.setattr(module, "turned_frame", kept)
    equations: Any = Given()
    with working_bits(BITS):
        found = advance(Rules(equations, POWER), state(fmpq(0), fmpq(0), fmpq(0)), START, END)
    assert found is not None

    def columns_at(time: fmpq) -> fmpq_mat:
        return (fmpq_mat(SIZE, SIZE, [int(i == j) for i in range(SIZE) for j in range(SIZE)])
                + fmpq_mat(slope) * time) * fmpq_mat(TURNED)  # fmt: skip

    last = columns_at(END - START)
    for ball, value in zip(seen[0].entries(), last.entries(), strict=True):
        assert abs(ends(ball)[0] - to_fraction(value)) < Fraction(1, 2**90)
    radii = column([fmpq(end.numerator, end.denominator) for end in (ends(value)[1] for value in found.at_end.radii)])
    for time, balls in (
        (fmpq(0), found.deviations),
        ((END - START) / 3, found.deviations),
        (END - START, found.deviations),
        (END - START, found.end_deviations),
    ):
        basis = columns_at(time)
        centre, spread = basis * column(CENTRE), sizes(basis) * radii * (1 - fmpq(1, 10**8))
        for i, ball in enumerate(balls):
            lower, upper = ends(ball)
            assert lower <= to_fraction(centre[i, 0] - spread[i, 0])
            assert upper >= to_fraction(centre[i, 0] + spread[i, 0])
            wanted = to_fraction(spread[i, 0]) * (1 + Fraction(1, 10**6))
            assert balls is found.deviations or upper - lower <= 2 * wanted


@pytest.mark.parametrize(
    ("start", "end", "reach"),
    [(fmpq(-1), fmpq(-1, 2), fmpq(1)), (fmpq(1), fmpq(9, 8), fmpq(9, 8)), (fmpq(-1, 8), fmpq(0), fmpq(1, 8))],
)
def test_the_residual_is_bounded_on_the_whole_piece(start: fmpq, end: fmpq, reach: fmpq) -> None:
    equations: Any = Given()
    with working_bits(BITS):
        advance(Rules(equations, POWER), state(fmpq(0), fmpq(0), fmpq(0)), start, end)
    assert equations.reaches == [reach]


def test_no_piece_without_a_bound(monkeypatch: pytest.MonkeyPatch) -> None:
    """Where the guesses do not end, the frame is singular, or the functions have no bound."""
    assert advanced(monkeypatch, state(fmpq(0), fmpq(0), fmpq(0)))[0].end == END
    start = state(fmpq(0), fmpq(0), fmpq(0))

    def found(equations: Any, now: Deviations = start, end: fmpq = END) -> TrackPiece | None:
        with working_bits(BITS):
            return advance(Rules(equations, POWER), now, START, end)

    assert found(Given()) is not None
    assert found(Given(), end=fmpq(5)) is None
    with monkeypatch.context() as patch:
        patch.setattr(module, "turned_frame", lambda *_: arb_mat(SIZE, SIZE))
        assert found(Given()) is None
    singular = Deviations(start.centre, start.radii, arb_mat(SIZE, SIZE), start.initial, start.elapsed, start.forced)
    assert found(Given(), singular) is None
    assert found(Unbounded(arb("nan"), arb(1))) is None
    assert found(Unbounded(arb(1), arb("nan"))) is None
    assert found(Unbounded(arb(1), arb(1))) is not None


class Unbounded(Given):
    """Functions without a bound: A, or B, is not a number."""

    def __init__(self, matrix: arb, fast: arb) -> None:
        super().__init__()
        self._factors = matrix, fast

    def coupling(self, s: arb, tube: Sequence[arb]) -> Coupling:
        whole, (matrix, fast) = super().coupling(s, tube), self._factors
        return Coupling(whole.matrix * matrix, whole.fast * fast, whole.force, whole.p)


NUMBERS = st.integers(-4, 4)


@settings(max_examples=15)
@given(st.lists(NUMBERS, min_size=75, max_size=75), st.fractions(0, 1, max_denominator=8))
def test_the_defect_of_any_frame(entries: list[int], time: Fraction) -> None:
    """A_0(s) Y - Y' at s = -1 + time, Y a polynomial of degree 2."""
    flow = [entries[25 * k : 25 * k + 25] for k in range(3)]
    place = fmpq(time.numerator, time.denominator)
    one, two, three = (fmpq_mat(SIZE, SIZE, part) for part in flow)
    limit = fmpq_mat(LIMIT) + fmpq_mat(SLOPE) * place
    page = limit * (one + two * place + three * place**2) - (two + three * (2 * place))
    equations: Any = Given()
    frame = Frame(tuple(arb_mat(SIZE, SIZE, part) for part in flow), identity(SIZE))
    with working_bits(BITS):
        found = module._defect(equations, frame, START, arb(place))
    for ball, value in zip(found.entries(), page.entries(), strict=True):
        assert ball.is_finite()
        assert ends(ball)[0] <= to_fraction(value) <= ends(ball)[1]
        assert ends(ball)[1] - ends(ball)[0] < Fraction(1, 2**90)


def test_the_next_piece_holds_the_set_in_its_own_directions(monkeypatch: pytest.MonkeyPatch) -> None:
    """gamma' is the midpoint of Q'^-1 W gamma, w' = |Q'^-1 W| w and its radius; W has a width here."""
    columns = arb_mat(SIZE, SIZE, [arb(value, (1, -6)) for row in TURNED for value in row])
    own = [[1, 0, 0, 0, 0], [1, 2, 0, 0, 0], [0, 0, 1, 0, 0], [0, 0, 0, 3, 0], [0, -1, 0, 0, 1]]
    monkeypatch.setattr(module, "turned_frame", lambda *_: arb_mat(own))
    now = state(fmpq(3), fmpq(1, 32), fmpq(9))
    with working_bits(BITS):
        found = module._turned(now, columns)
    assert found is not None
    assert (found.initial, found.elapsed, found.forced) == (now.initial, now.elapsed, now.forced)
    inverse = fmpq_mat(own).inv()
    middle = inverse * fmpq_mat(TURNED) * column(CENTRE)
    wide = fmpq(1, 64) * sizes(inverse) * fmpq_mat(SIZE, SIZE, [1] * SIZE**2)  # what the width of W adds
    widest = sizes(inverse * fmpq_mat(TURNED)) + wide
    page = widest * column(RADII) + wide * sizes(column(CENTRE))
    for centre, bound, value, wanted in zip(found.centre, found.radii, middle.entries(), page.entries(), strict=True):
        assert centre.is_exact()
        assert abs(ends(centre)[0] - to_fraction(value)) < Fraction(1, 10**9)
        assert is_bound(bound, wanted)
    with working_bits(BITS):
        assert module._turned(now, columns * arb("nan")) is None
    exact = inverse * fmpq_mat(TURNED)
    for bits in range(4, 16):
        with working_bits(bits):
            rough = module._turned(now, arb_mat(TURNED))
        assert rough is not None
        for i, (centre, bound) in enumerate(zip(rough.centre, rough.radii, strict=True)):
            away = abs(to_fraction((exact * column(CENTRE))[i, 0]) - ends(centre)[0])
            assert ends(bound)[1] >= to_fraction((sizes(exact) * column(RADII))[i, 0]) + away
    with monkeypatch.context() as patch, working_bits(8):
        patch.setattr(module, "turned_frame", lambda *_: identity(SIZE))
        patch.setattr(module, "_row_sums", lambda *_: [arb(fmpq(5, 4))] * SIZE)
        rough = module._turned(now, identity(SIZE) * arb(1, (1, -30)))  # no centre is exact
    assert rough is not None
    assert all(ends(bound)[1] > Fraction(5, 4) for bound, value in zip(rough.radii, CENTRE, strict=True) if value)
    with working_bits(BITS):
        monkeypatch.setattr(module, "turned_frame", lambda *_: arb_mat(SIZE, SIZE))
        assert module._turned(now, columns) is None


@pytest.mark.parametrize(("p", "kept"), [(fmpq(85333, 1000), True), (fmpq(85334, 1000), False), (fmpq(-500), True)])
def test_the_rate_of_phi_is_kept(p: fmpq, kept: bool) -> None:
    """(b): 15/16 g <= g - (l/g) delta^2 p~ at every delta; here g/16 = (l/g) delta_0^2 p~ at p~ = 256/3."""

    class Steep(Given):
        def coupling(self, s: arb, tube: Sequence[arb]) -> Coupling:
            return replace(super().coupling(s, tube), p=arb(p))

    equations: Any = Steep()
    start = Deviations((arb(0),) * SIZE, (arb(2) ** -20,) * SIZE, identity(SIZE), arb(0), fmpq(0), arb(0))
    with working_bits(BITS):
        found = advance(Rules(equations, POWER), start, START, START + fmpq(1, 2**14))
    assert (found is not None) is kept
