"""What the checker of runs concludes from the range of a function and of its derivative, at the borders.

Page: proofs/run_certificate.md, sections 3 and 4.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from itertools import pairwise
from types import SimpleNamespace
from typing import Any

import pytest
from must_reject import runs

limits: Any = runs.part("limits")
run: Any = runs.part("run")
Interval = tuple[int, int]
Range = Callable[[int, int], Interval]
END = 2**44  # of τ
ANY: Interval = (-9, 9)


class Watched:
    """A step in which one function is followed: its range and that of its derivative, as they are given."""

    def __init__(self, value: Range, slope: Range) -> None:
        self._value, self._slope, self.asked = value, slope, set[tuple[int, int]]()

    def value(self, _: Any, a: int, b: int) -> Interval:
        assert len(self.asked) < 10**3
        self.asked.add((a, b))
        return self._value(a, b)

    def slope(self, _: Any, a: int, b: int) -> Interval:
        return self._slope(a, b)


def known(value: Interval, slope: Interval, left: Interval = ANY, right: Interval = ANY) -> Watched:
    """Everywhere the same ranges; ``left``, ``right``: the values at both ends."""
    ends = {(0, 0): left, (END, END): right}
    return Watched(lambda a, b: ends.get((a, b), value), lambda _a, _b: slope)


UP, DOWN = (1, 5), (-5, -1)
SIGNS: dict[str, tuple[Watched, bool]] = {
    "by its range": (known((1, 9), ANY), True),
    "its range begins at 0": (known((0, 9), ANY), False),
    "its range is below 0": (known((-9, -1), ANY), False),
    "it rises from above 0": (known(ANY, UP, left=(1, 1)), True),
    "it rises from 0": (known(ANY, UP, left=(0, 0), right=(9, 9)), False),
    "it rises from near 0": (known(ANY, UP, left=(-1, 5), right=(9, 9)), False),
    "it falls to near 0": (known(ANY, DOWN, left=(9, 9), right=(-1, 5)), False),
    "it rises from below 0": (known(ANY, UP, left=(-1, -1), right=(9, 9)), False),
    "it may rise from below 0": (known(ANY, (0, 5), left=(-1, -1), right=(9, 9)), False),
    "it falls to above 0": (known(ANY, DOWN, right=(1, 1)), True),
    "it falls to 0": (known(ANY, DOWN, left=(9, 9), right=(0, 0)), False),
    "it falls to below 0": (known(ANY, DOWN, left=(9, 9), right=(-1, -1)), False),
    "it is above 0 at the ends": (known(ANY, ANY, left=(9, 9), right=(9, 9)), False),
    "it may fall and rise": (known(ANY, (-5, 5), left=(9, 9), right=(9, 9)), False),
    "it is above 0 on the left": (Watched(lambda _, b: (1, 9) if b <= END // 2 else ANY, lambda *_: ANY), False),
    "it is above 0 on the right": (Watched(lambda a, _: (1, 9) if a >= END // 2 else ANY, lambda *_: ANY), False),
}


@pytest.mark.parametrize("name", SIGNS)
def test_signs(name: str) -> None:
    step, expected = SIGNS[name]
    assert run.positive(step, None, 0, END) is expected


@pytest.mark.parametrize("at_the_end", [True, False])
@pytest.mark.parametrize(("halvings", "expected"), [(40, True), (41, False)])
def test_forty_halvings_about_one_end(at_the_end: bool, halvings: int, expected: bool) -> None:
    """Only so short an interval shows the sign there; each one is half of another."""
    narrow = END >> halvings
    touches: Range = (lambda _, b: ANY if b == END else UP) if at_the_end else (lambda a, _: ANY if a == 0 else UP)
    step = Watched(lambda a, b: UP if b - a <= narrow else touches(a, b), lambda *_: ANY)
    assert run.positive(step, None, 0, END) is expected
    near = [END - (END >> k) for k in range(42)] if at_the_end else [END >> k for k in range(42)]
    halves = {(a, END) if at_the_end else (0, a) for a in near} | {tuple(sorted(ends)) for ends in pairwise(near)}
    assert step.asked <= halves


class Rising(Watched):
    """A step whose states are τ itself, and an event with a rate and a curvature."""

    numbers = None

    def states(self, a: int, b: int) -> tuple[int, int]:
        assert a == 0
        assert 0 <= b <= END
        return a, b


def event(rate: Interval, curvature: Interval, most: int = END) -> Any:
    """Ranges of the derivatives as far as ``most``, beyond which nothing is known."""

    def on(found: Interval) -> Any:
        return SimpleNamespace(on=lambda states, _: found if states[1] <= most else ANY)

    return SimpleNamespace(rate=on(rate), curvature=on(curvature))


@pytest.mark.parametrize(
    ("rate", "curvature", "order", "rises"),
    [
        (UP, ANY, 1, True), (ANY, UP, 1, False), (ANY, UP, 2, True), (UP, ANY, 2, False), ((0, 5), ANY, 1, False),
        (DOWN, ANY, 1, False), ((-5, 5), ANY, 1, False), (UP, UP, 3, True),
    ],
)  # fmt: skip
def test_rising_from_0(rate: Interval, curvature: Interval, order: int, rises: bool) -> None:
    step = Rising(lambda a, b: (1, 9) if a == b else ANY, lambda *_: ANY)
    if rises:
        assert run.risen(step, event(rate, curvature), END, order) == END
    else:
        with pytest.raises(limits.Rejected, match="does not certainly rise"):
            run.risen(step, event(rate, curvature), END, order)


@pytest.mark.parametrize(("at_tau", "rises"), [((1, 1), True), ((0, 9), False), ((-1, 9), False)])
def test_rising_to_above_0(at_tau: Interval, rises: bool) -> None:
    """Up to a quarter it rises certainly, and there it has to be above 0."""
    step = Rising(lambda a, b: at_tau if a == b == END // 4 else (9, 9) if b > END // 4 else (-9, 0), lambda *_: ANY)
    if rises:
        assert run.risen(step, event(UP, ANY, END // 4), END, 1) == END // 4
    else:
        with pytest.raises(limits.Rejected, match="does not certainly rise"):
            run.risen(step, event(UP, ANY, END // 4), END, 1)


class Followed(run.Run):  # type: ignore[misc]
    """A run of one phase and an event, whose last step is given; what follows is nothing."""

    def __init__(self, value: Interval, slope: Interval) -> None:
        self.numbers = SimpleNamespace(one=END, read=lambda value: value)
        self.scene = SimpleNamespace(system=lambda _: SimpleNamespace(
            entered=lambda box, _: box, endings=["stick"], events={"stick": "stick"}))  # fmt: skip
        self.phase, self.box, self.ranges = "slip", {}, (value, slope)

    def next_line(self, *_: str) -> list[Any]:
        return ["slip", 1, "stick", [END // 4, END // 2], []]

    def steps(self, _system: Any, _count: int, event: str, left: int, right: int) -> Any:
        assert (event, left, right) == ("stick", END // 4, END // 2)
        value, slope = self.ranges
        return SimpleNamespace(
            value=lambda event, a, b: value if (event, a, b) == ("stick", right, right) else ANY,
            slope=lambda event, a, b: slope if (event, a, b) == ("stick", left, right) else ANY,
            time=lambda a, b: (a, b), states=lambda a, b: {"states": (a, b)},
        )  # fmt: skip

    def enter_next(self, _system: Any, event: str, states: Any) -> None:
        assert (event, states, self.clock) == ("stick", {"states": (END // 4, END // 2)}, (END // 4, END // 2))
        raise StopIteration


@pytest.mark.parametrize(
    ("value", "slope", "why"),
    [
        ((-9, -1), (-9, -1), ""), ((-9, 0), (-9, -1), "no change of sign"), ((-9, 9), (-9, -1), "no change of sign"),
        ((-9, -1), (-9, 0), "may touch 0"), ((-9, -1), (-9, 9), "may touch 0"), ((-9, -1), (1, 9), "may touch 0"),
    ],
)  # fmt: skip
def test_an_event_changes_the_sign_and_its_function_falls(value: Interval, slope: Interval, why: str) -> None:
    with pytest.raises(limits.Rejected if why else StopIteration, match=why or None):
        Followed(value, slope).follow()


@pytest.mark.parametrize("at_zero", ["", "lift-off"])
@pytest.mark.parametrize("count", [1, 2, 3])
def test_how_far_each_function_is_followed(count: int, at_zero: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """In steps before the last up to 1; in the last up to the right end, that of the event up to the left end."""
    left, right, rose = 20, 30, 5
    asked: list[tuple[int, str, int, int]] = []
    steps = iter(range(count))

    def positive(step: Any, name: str, since: int, until: int) -> bool:
        asked.append((step.index, name, since, until))
        return True

    def risen(step: Any, name: str, until: int, order: int) -> int:
        assert (step.index, name, order) == (0, at_zero, 2)
        assert until == (right if count == 1 else END)
        return rose

    monkeypatch.setattr(run, "positive", positive)
    monkeypatch.setattr(run, "risen", risen)
    monkeypatch.setattr(run, "Curve", lambda *_: SimpleNamespace(start={}, end={}))
    monkeypatch.setattr(
        run, "Step", lambda *_: SimpleNamespace(index=next(steps), errors=None, time=lambda a, b: (a, b))
    )
    whole = Followed(ANY, ANY)
    whole.clock, whole.at_zero, whole.order = (0, 0), at_zero, 2
    whole.next_line = lambda *_: [None] * 4  # type: ignore[method-assign]
    system = SimpleNamespace(names=[], events={"stick": "stick", "lift-off": "lift-off"})
    assert run.Run.steps(whole, system, count, "stick", left, right).index == count - 1
    first = rose if at_zero else 0
    assert asked == [
        (index, name, first if index == 0 and name == "lift-off" else 0, END if index < count - 1 else last)
        for index in range(count)
        for name, last in (("stick", left), ("lift-off", right))
    ]


@pytest.mark.parametrize(
    ("value", "text"),
    [
        ("3", "3"), ("0", "0"), ("-7", "-7"), ("1/2", "0.5"), ("-7/2", "-3.5"), ("1/3", "1/3"), ("-2/7", "-2/7"),
        ("1001/1000", "1.001"), ("-1/8", "-0.125"), ("1/20", "0.05"), ("100", "100"), ("1/64", "0.015625"),
    ],
)  # fmt: skip
def test_decimals(value: str, text: str) -> None:
    assert run.decimal(Fraction(value)) == text


def test_the_budget_of_work(monkeypatch: pytest.MonkeyPatch) -> None:
    """10⁸ for each unit of the limit, 10,000 for each byte (run_certificate.md, section 5)."""
    found: list[int] = []

    def meter(_: Any, budget: int) -> Any:
        found.append(budget)
        raise limits.Rejected

    monkeypatch.setattr(run, "Meter", meter)
    names = ("effects", "epsilon", "until", "parameters", "start", "events", "end")
    statement = dict.fromkeys(names) | {"kind": "run"}
    with pytest.raises(limits.Rejected):
        run.check_run(run.HYPOTHESES, statement, [b'{"bits":64}'], limits.Limits(work=3), 7)
    assert found == [3 * 10**8 + 7 * 10_000]
