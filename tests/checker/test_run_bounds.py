"""The bounds of one step of a run, each against the formula of its page in rational numbers, to the last unit.

Page: proofs/run_certificate.md, section 2.
"""

from __future__ import annotations

import math
import random
from fractions import Fraction
from types import SimpleNamespace
from typing import Any

import pytest
from must_reject import runs

limits: Any = runs.part("limits")
intervals: Any = runs.part("intervals")
model: Any = runs.part("model")
run: Any = runs.part("run")
BITS = 64
ONE = 2**BITS


def numbers() -> Any:
    return intervals.Numbers(BITS, limits.Meter(limits.Limits(), 10**9))


def up(value: Fraction) -> int:
    return -(-value.numerator // value.denominator)


def basis(blocks: list[int], rows: list[list[int]]) -> Any:
    """A basis of integers."""
    return run.Basis(numbers(), blocks, [[entry, 0] for row in rows for entry in row], len(rows))


def exactly(rows: list[list[int]]) -> list[list[tuple[int, int]]]:
    return [[(entry * ONE, entry * ONE) for entry in row] for row in rows]


IDENTITY = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]
J = [[-3, 4, 1], [2, 5, -7], [6, -2, -9]]


def test_norms_of_blocks() -> None:
    """The root of the largest row sum of |B'B|: here 25 + 22, and for the row (1, -7) 1 + 7 and 7 + 49."""
    found = basis([2, 1], IDENTITY).norms(exactly(J), basis([1, 2], IDENTITY))
    exact = [[9 + 4, max(16 + 25 + abs(4 - 35), 1 + 49 + abs(4 - 35))], [36, max(4 + 18, 81 + 18)]]
    for row, squares in zip(found, exact, strict=True):
        for norm, square in zip(row, squares, strict=True):
            assert (norm - 1) ** 2 < square * ONE**2 <= norm**2


def test_growth_of_blocks() -> None:
    """In the diagonal the largest row of the symmetric part's discs, which may be negative."""
    found = basis([2, 1], IDENTITY).growth(exactly(J))
    assert [found[0][0], found[1][1]] == [8 * ONE, -9 * ONE]  # 5 + (4 + 2)/2, and -9
    assert found[0][1] == math.isqrt(50 * ONE**2) + 1
    assert (found[1][0] - 1) ** 2 < (36 + 12) * ONE**2 <= found[1][0] ** 2
    assert basis([3], IDENTITY).growth(exactly(J)) == [[8 * ONE + 9 * ONE // 2]]  # 5 + 6/2 + 9/2


def test_growth_in_a_basis() -> None:
    """S⁻¹JS with S = (1 1; 0 1): (-5 -6; 2 7)."""
    assert basis([1, 1], [[1, 1], [0, 1]]).growth(exactly([[-3, 4], [2, 5]])) == [
        [-5 * ONE, 6 * ONE],
        [2 * ONE, 7 * ONE],
    ]


def test_reach_of_radii() -> None:
    """The rows' lengths by blocks: 5 and 2, 0 and 1, 0 and 1."""
    assert basis([2, 1], [[3, 4, 2], [0, 1, 0], [0, 0, 1]]).reach([10, 1]) == [52, 10, 1]


def curve(h: Any, unit: Any, x: Any, names: tuple[str, ...] = ("Y", "Z")) -> Any:
    return run.Curve(numbers(), SimpleNamespace(names=list(names)), h, unit, x)


@pytest.mark.parametrize(
    ("h", "unit", "c"),
    [([1, -BITS], 1, [1]), ([1, 0], BITS, [1]), ([1, 0], 1, [0] * 400), ([1, 0], 5, [2 ** (BITS + 5) - 1])],
)
def test_a_curve_at_its_limits(h: Any, unit: int, c: list[int]) -> None:
    found = curve(h, unit, {"Y": c, "Z": [0]})
    assert found.x["Y"] == [v * 2 ** (BITS - unit) for v in c]
    assert found.start["Y"] == (found.x["Y"][0],) * 2
    assert found.end["Y"] == (sum(found.x["Y"]),) * 2


@pytest.mark.parametrize(
    ("h", "unit", "c", "why"),
    [
        ([0, 0], 1, [1], "h or the unit"),
        ([-1, 0], 1, [1], "h or the unit"),
        ([1, 0], 0, [1], "h or the unit"),
        ([1, 0], BITS + 1, [1], "h or the unit"),
        ([1, 0], True, [1], "h or the unit"),
        ([1, 0], None, [1], "h or the unit"),
        ([1, 0], 1, [], "a list of coefficients"),
        ([1, 0], 1, [0] * 401, "a list of coefficients"),
        ([1, 0], 1, 5, "a list of coefficients"),
        ([1, 0], 1, {"0": 1}, "a list of coefficients"),
        ([1, 0], 5, [1, 2 ** (BITS + 5)], "a coefficient"),
        ([1, 0], 5, [1, True], "a coefficient"),
        ([1, 0], 5, ["1", 1], "a coefficient"),
    ],
)
def test_a_curve_that_is_none(h: Any, unit: Any, c: Any, why: str) -> None:
    with pytest.raises(limits.Rejected, match=why):
        curve(h, unit, {"Y": c, "Z": [0]})


def at(c: list[int], tau: Fraction) -> Fraction:
    return sum((v * tau**k for k, v in enumerate(c)), Fraction(0))


@pytest.mark.parametrize(("form", "total"), [({"Y": 1}, [5, 3, 7, 2]), ({"Y": -1, "Z": 1}, [-4, -12, -7, -2])])
def test_a_sum_on_an_interval(form: dict[str, int], total: list[int]) -> None:
    """The mean value form about the middle: all terms of the derivative have one sign, so its largest value is at b."""
    x = {"Y": [5, 3, 7, 2], "Z": [1, -9]}
    found = curve([1, 0], BITS, {name: [v * 2**40 for v in c] for name, c in x.items()})
    slope = [k * v for k, v in enumerate(total)][1:]
    for a, b in (Fraction(1, 4), Fraction(1, 4)), (Fraction(1, 2), Fraction(3, 4)), (Fraction(1, 8), Fraction(1)):
        low, high = found.on(form, int(a * ONE), int(b * ONE))
        reach = abs(at(slope, b)) * (b - a) / 2
        assert abs(low - (at(total, (a + b) / 2) - reach) * 2**40) < 8, (a, b)
        assert abs(high - (at(total, (a + b) / 2) + reach) * 2**40) < 8, (a, b)
        assert all(low <= at(total, a + (b - a) * k / 8) * 2**40 <= high for k in range(9))


def test_products_and_their_errors() -> None:
    """Each coefficient is rounded down; those that are wrong are counted, with the small ones at the end."""
    chance = random.Random(4)
    for _ in range(40):
        c = {
            name: [chance.randint(-9, 9) << chance.choice((20, 31, 33, 62)) for _ in range(chance.randint(1, 4))]
            for name in "YZ"
        }
        found = curve([1, 0], BITS, c)
        for key in ("Y",), ("Z", "Z"), ("Y", "Z", "Z"):
            (left, error), right = found.product(key[:-1]), c[key[-1]]
            whole = [sum(left[i] * right[k - i] for i in range(len(left)) if 0 <= k - i < len(right))
                     for k in range(len(left) + len(right) - 1)]  # fmt: skip
            kept, bound = found.product(key)
            assert kept == [v // ONE for v in whole][: len(kept)]
            assert all(v // ONE in (-1, 0) for v in whole[len(kept) :])
            assert len(kept) == 1 or kept[-1] not in (-1, 0)
            wrong = sum(v % ONE != 0 or k >= len(kept) for k, v in enumerate(whole))
            assert bound == up(Fraction(error * sum(map(abs, right)), ONE)) + wrong


def test_the_defect() -> None:
    """h f(x) - x' with f_Y = 5/7 Z - 2/3 Y Z + 1, f_Z = 0; an exact curve has none."""
    third, last = 2**61 // 3, [2**61, 2**60, -(2**57)]
    found = curve([3, -2], BITS, {"Y": [2**63, third, 2**40 + 1], "Z": last})
    rates = {"Y": model.Polynomial({("Y", "Z"): Fraction(-2, 3), ("Z",): Fraction(5, 7), (): Fraction(1)})}
    rates["Z"] = model.Polynomial()
    total = [Fraction(0)] * 8
    error = Fraction(0)
    for key, value in rates["Y"].items():
        c, e = found.product(key)
        error += abs(value) * e
        for k, v in enumerate(c):
            total[k] += Fraction(3, 4) * value * v
    for k, v in enumerate(found.x["Y"][1:], 1):
        total[k - 1] -= k * v
    assert found.defect(rates) == [up(sum(map(abs, total)) + Fraction(3, 4) * error), 2**60 + 2**58]
    still = curve([1, 0], BITS, {"Y": [7], "Z": [2**62, ONE]})
    assert still.defect({"Y": model.Polynomial(), "Z": model.number(1)}) == [0, 0]


class Judged(run.Step):  # type: ignore[misc]
    """A step that notes what it would have to show, and believes it."""

    def enter(self, basis: Any, before: Any, jump: Any) -> list[int]:
        self.entered = [*getattr(self, "entered", []), (before, jump)]
        return [0] * (len(basis.starts) - 1)

    def check_majorant(self, bounds: Any, M: Any, d: Any, length: int) -> None:  # noqa: ARG002
        self.lengths = [*getattr(self, "lengths", []), length]


def piece(end: list[int], *nodes: int) -> dict[str, Any]:
    entries = [[int(i == j), 0] for i in range(2) for j in range(2)]
    return {"basis": entries, "blocks": [2], "end": end, "nodes": [[[w, -BITS]] for w in nodes]}


@pytest.mark.parametrize(("first", "second"), [((8, 3, 5), (4, 7)), ((1, 2), (7, 8))])
def test_pieces_follow_each_other(first: tuple[int, ...], second: tuple[int, ...]) -> None:
    """The tube is the larger one, a unit beyond all bounds; the lengths add to 1; nothing jumps inside of a step."""
    system = SimpleNamespace(names=["Y", "Z"], rates={"Y": model.Polynomial(), "Z": model.Polynomial()},
                             jacobian=[[model.Polynomial()] * 2] * 2)  # fmt: skip
    pieces = [piece([1, -2], *first), piece([1, 0], *second)]
    jump = [(1, 2), (3, 4)]
    x = run.Curve(numbers(), system, [1, 0], 1, {"Y": [1, 3], "Z": [1, 3]})
    step = Judged(x, system, pieces, None, jump, (0, 0))
    assert step.tube == [9, 9]
    assert step.lengths == [ONE // 4, ONE - ONE // 4]
    (none, at_first), (before, later) = step.entered
    assert (none, at_first, later) == (None, jump, [(0, 0)] * 2)
    assert [before[1], step.errors[1]] == [[first[-1]], [second[-1]]]
    Y, Z = model.state("Y"), model.state("Z")
    assert step.value(model.Event(Y - Z, system.rates), 0, ONE) == (-18, 18)
    assert step.value(model.Event(Z, system.rates), 0, ONE) == (ONE // 2 - 9, 2 * ONE + 9)
    assert step.value(model.Event(Y + Y, system.rates), 0, ONE) == (ONE - 18, 4 * ONE + 18)


def bare(h: int = ONE) -> Any:
    return SimpleNamespace(numbers=numbers(), curve=SimpleNamespace(h=h))


def test_nodes() -> None:
    """Two are enough, and one unit."""
    assert run.Step.read_nodes(bare(), [[[1, -BITS]], [[1, 0]]], 1) == [[1], [ONE]]


@pytest.mark.parametrize(
    ("nodes", "why"),
    [
        (None, "not two nodes"),
        ({"a": 1, "b": 2}, "not two nodes"),
        ([[[1, 0], [1, 0]]], "not two nodes"),
        ([[[1, 0], [1, 0]], [[1, 0]]], "another number of blocks"),
        ([[[1, 0], [1, 0]], 2], "another number of blocks"),
        ([[[1, 0], [1, 0]], "ab"], "another number of blocks"),
        ([[[1, 0], [1, 0]], [[1, 0], [0, 0]]], "not positive"),
        ([[[1, 0], [-1, 0]], [[1, 0], [1, 0]]], "not positive"),
    ],
)
def test_nodes_that_are_none(nodes: Any, why: str) -> None:
    with pytest.raises(limits.Rejected, match=why):
        run.Step.read_nodes(bare(), nodes, 2)


def test_errors_in_another_basis() -> None:
    """The length of S⁻¹ times the jump, here 3/2 and 4, and the norms of S⁻¹ times the other basis, by the radii."""
    new, old = basis([1, 1], [[2, 0], [0, 1]]), basis([1, 1], [[4, 6], [0, 3]])
    jump = [(-3 * ONE, 2 * ONE), (-ONE, 4 * ONE)]
    assert run.Step.enter(bare(), new, None, jump) == [3 * ONE // 2, 4 * ONE]
    assert run.Step.enter(bare(), new, (old, [10, 1]), jump) == [3 * ONE // 2 + 23, 4 * ONE + 3]


def test_pushes() -> None:
    """|S⁻¹| (10, 12) = (5, 15) for S⁻¹ = (1/2 0; -3/10 1)."""
    half = SimpleNamespace(
        inverse=[[(ONE // 2, ONE // 2), (0, 0)], [(-ONE // 2, -ONE // 2), (ONE, ONE)]],
        lengths=lambda values: [intervals.root_up(sum(intervals.size(v) ** 2 for v in values))],
    )
    assert run.Step.pushes(bare(), half, [6, 1]) == [5]  # (3, 4)


@pytest.mark.parametrize("parts", [1, 2, 3])
def test_the_inequality_of_the_majorant(parts: int) -> None:
    """With h = l = 1/2: the largest d for which (1) holds is accepted, one unit more is not, in each block."""
    chance = random.Random(parts)
    for _ in range(60):
        M = [[4 * chance.randint(-3 if i == j else 0, 3) for j in range(3)] for i in range(3)]
        w = [[chance.randint(1, 40) for _ in range(3)] for _ in range(parts + 1)]
        driven = [[sum(M[i][j] * each[j] for j in range(3)) // 4 for i in range(3)] for each in w]
        d = [
            2 * min(parts * (w[k + 1][i] - w[k][i]) - max(driven[k][i], driven[k + 1][i]) for k in range(parts))
            for i in range(3)
        ]
        rates = [[entry * ONE for entry in row] for row in M]
        run.Step.check_majorant(bare(ONE // 2), w, rates, d, ONE // 2)
        for i in range(3):
            with pytest.raises(limits.Rejected, match="rises too slowly"):
                run.Step.check_majorant(bare(ONE // 2), w, rates, [v + (i == j) for j, v in enumerate(d)], ONE // 2)
