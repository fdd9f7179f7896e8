"""Events: zeros in closed form are bracketed, grazing ones are left open.

Pages: proofs/validated_step.md; proofs/norm_step.md (an event function that starts at zero).
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest
from flint import arb, fmpq

from gspot_verified.functions.expressions import Constant, Expression, Variable
from gspot_verified.integrator.box_steps.integrate import Run
from gspot_verified.integrator.field.event import Crossing, Moment, Unclear, Watch, _Piece, first_crossing, rivals
from gspot_verified.integrator.field.field import VectorField
from gspot_verified.integrator.norm_steps.norm_run import NormRun
from gspot_verified.numbers.balls import working_bits

x, y = Variable(0), Variable(1)
OSCILLATOR = VectorField([y, -x])


def number(p: int, q: int = 1) -> Constant:
    return Constant(fmpq(p, q))


def first(function: Expression, box: list[arb], end: int = 20) -> Crossing | Unclear | None:
    watch = Watch("event", function, OSCILLATOR)
    for segment in Run(OSCILLATOR, box, arb(end)):
        found = watch.along(segment)
        if found is not None:
            return found
    return None


@pytest.mark.parametrize("bits", [64, 128, 300])
def test_the_zero_of_the_cosine(bits: int) -> None:
    with working_bits(bits):
        found = first(-x, [arb(1), arb(0)])
        assert isinstance(found, Crossing)
        half_turn = arb.pi() / 2
        assert found.time.is_finite()
        assert found.time.contains(half_turn)
        assert found.time.rad() < arb(2) ** (28 - bits)
        assert found.rate.is_finite()
        assert found.rate.contains(1)
        assert found.rate > 0
        assert found.states[0].contains(0)
        assert found.states[1].contains(-1)


def test_the_bracket_is_narrow_when_g_rises_for_long() -> None:
    """-x - 1/2 rises on many pieces of many steps before its zero at t = 2 pi/3."""
    with working_bits(128):
        found = first(-x - number(1, 2), [arb(1), arb(0)])
        assert isinstance(found, Crossing)
        assert found.time.contains(2 * arb.pi() / 3)
        assert found.time.rad() < 1e-30
        late = first(-x - number(1, 2), [arb(1), arb(0)], 2)
        assert late is None


def test_the_first_of_many() -> None:
    """sin t = 99/100 twice in each turn: the first time is taken."""
    with working_bits(100):
        found = first(-y - number(99, 100), [arb(1), arb(0)])
        assert isinstance(found, Crossing)
        assert found.time.contains(arb(fmpq(99, 100)).asin())


@pytest.mark.parametrize("offset", [fmpq(1, 10**6), fmpq(1, 10**12)])
def test_near_grazing(offset: fmpq) -> None:
    """-cos t - 1 -+ offset: it crosses near t = pi, or does not reach 0."""
    with working_bits(128):
        below = first(-x - Constant(1 + offset), [arb(1), arb(0)])
        above = first(-x - Constant(1 - offset), [arb(1), arb(0)])
        if offset == fmpq(1, 10**6):
            assert below is None
            assert isinstance(above, Crossing)
            assert above.time.contains((-arb(1 - offset)).acos())
        else:
            assert not isinstance(below, Crossing)


def test_grazing_is_unclear() -> None:
    with working_bits(128):
        found = first(-x - number(1), [arb(1), arb(0)])
        assert isinstance(found, Unclear)
        assert abs(found.time - arb.pi()) < 1e-2


def test_a_start_that_is_not_negative_is_unclear() -> None:
    with working_bits(64):
        assert isinstance(first(x, [arb(0), arb(1)]), Unclear)
        assert isinstance(first(x - number(1, 2), [arb(1), arb(0)]), Unclear)


def test_a_set_that_is_too_wide_gives_no_bracket() -> None:
    with working_bits(64):
        found = first(-x, [arb(1, "0.9"), arb(0, "0.9")])
        assert isinstance(found, Unclear)


def test_a_wide_set_gives_a_wide_bracket() -> None:
    with working_bits(64):
        found = first(-x, [arb(1, "0.01"), arb(0, "0.01")])
        assert isinstance(found, Crossing)
        for a in (-1, 1):
            for b in (-1, 1):
                start = (1 + a * arb("0.0099"), b * arb("0.0099"))
                # x = s0 cos t + s1 sin t vanishes at t = pi/2 + atan(s1/s0).
                assert found.time.contains(arb.pi() / 2 + (start[1] / start[0]).atan())


def test_nothing_happens() -> None:
    with working_bits(64):
        assert first(x - number(2), [arb(1), arb(0)]) is None


def test_from_zero() -> None:
    """-sin t falls from 0 and rises through 0 at pi; sin t does not fall; cos t - 1 falls by its second derivative."""
    with working_bits(128):
        cases = [(-x, [0, 1], 1, 1), (x, [0, 1], 1, None), (-x, [0, 1], 0, None)]
        cases += [(x - number(1), [1, 0], 1, None), (number(1) - x, [1, 0], 2, None)]
        for function, start, order, turns in cases:
            watch = Watch("event", function, OSCILLATOR, from_zero=order)
            found = next(filter(None, map(watch.along, Run(OSCILLATOR, [arb(v) for v in start], arb(20)))))
            assert isinstance(found, Crossing) is (turns is not None)
            if isinstance(found, Crossing):
                assert found.time.contains(arb.pi())
        run = Run(OSCILLATOR, [arb(1), arb(0)], arb(6))
        watch = Watch("event", x - number(1), OSCILLATOR, from_zero=2)
        assert all(watch.along(segment) is None for segment in run)
        with pytest.raises(ValueError, match="from_zero"):
            Watch("event", x, OSCILLATOR, from_zero=3)


def test_a_crossing_holds_every_state_of_its_bracket() -> None:
    """x = cos t, y = sin t, s = s_0 + 21/20 t + sin t: s always rises, so a wide start gives one long stretch on which
    x and y turn; its first and its last piece alone hold few of the states."""
    s = Variable(2)
    field = VectorField([-y, x, number(21, 20) + x])
    with working_bits(64):
        box = [arb(1), arb(0), arb(-4, "2.5")]
        watch = Watch("s", s, field)
        found = next(filter(None, map(watch.along, NormRun(field, box, arb(20)))))
        assert isinstance(found, Crossing)
        assert found.rate.is_finite()
        assert found.rate > 0
        begin, end = found.time.lower(), found.time.upper()
        assert end - begin > 4
        seen = 0
        for k in range(41):
            first = arb(-4) + arb("2.5") * (k - 20) / 20
            for j in range(41):
                t = begin + (end - begin) * j / 40
                if j in (0, 40):  # the bracket's ends, rounded outward, may lie outside of it
                    continue
                state = (t.cos(), t.sin(), first + arb(fmpq(21, 20)) * t + t.sin())
                for side, value in zip(found.states, state, strict=True):
                    assert side.is_finite()
                    assert side.contains(value)
                assert found.rate.contains(arb(fmpq(21, 20)) + t.cos())
                seen += 1
        assert seen == 41 * 39


class Scripted:
    """A segment from 0 to 1 with given boxes of (x, y): at single times, and on intervals of time."""

    def __init__(self, points: dict[str, arb], pieces: dict[tuple[str, str], tuple[arb, arb]]) -> None:
        self.time = arb(0)
        self.step = self
        self.h = arb(1)
        self._points = [(arb(fmpq(*map(int, at.split("/")))), value) for at, value in points.items()]
        self._pieces = [(*(arb(fmpq(*map(int, end.split("/")))) for end in ends), box) for ends, box in pieces.items()]

    def states(self, tau: arb) -> list[arb]:
        for at, value in self._points:
            if tau == at:
                return [value, arb(1)]
        for a, b, box in self._pieces:
            if a - arb((1, -20)) <= tau.lower() and tau.upper() <= b + arb((1, -20)):
                return list(box)
        return [arb(0, 10), arb(0, 10)]


NEGATIVE, OPEN = (arb(-2), arb(0, 1)), arb(0, 1)
RISING = (arb(0, 3), arb(1, "0.5"))


def scripted(points: dict[str, arb], pieces: dict[tuple[str, str], tuple[arb, arb]]) -> Crossing | Unclear | None:
    with working_bits(64):
        watch = Watch("x", x, VectorField([y, number(0)]))
        return watch.along(Scripted(points, pieces))  # type: ignore[arg-type]


def test_a_bracket_begins_at_the_last_negative_point() -> None:
    pieces = {("0/1", "1/2"): RISING, ("1/2", "1/1"): RISING}
    found = scripted({"0/1": arb(-2), "1/2": arb(-1), "1/1": arb(1)}, pieces)
    assert isinstance(found, Crossing)
    assert arb("0.5") <= found.begin.tau <= found.end.tau <= 1
    found = scripted({"0/1": arb(-2), "1/2": OPEN, "1/1": arb(1)}, pieces)
    assert isinstance(found, Crossing)
    assert found.begin.tau < arb("0.5")


def test_a_stretch_ends_where_g_is_negative() -> None:
    """Rising, negative, then rising from a point where g has no certain sign: what rose before does not count."""
    pieces = {("0/1", "1/4"): RISING, ("1/4", "1/2"): NEGATIVE, ("1/2", "1/1"): RISING}
    known = {"0/1": arb(-2), "1/4": OPEN, "1/1": arb(1)}
    assert isinstance(scripted({**known, "1/2": OPEN}, pieces), Unclear)
    found = scripted({**known, "1/2": arb(-1)}, pieces)
    assert isinstance(found, Crossing)
    assert found.begin.tau >= arb("0.5")


@pytest.mark.parametrize(("exponent", "clear"), [(20, True), (60, False)])
def test_the_rate_of_a_crossing_is_positive_or_it_is_unclear(exponent: int, clear: bool) -> None:
    """Rates 1 and 2^60 on one stretch: no ball holds both without 0, and then nothing is said."""
    fast = (arb(0, 3), arb((1, exponent)))
    pieces = {("0/1", "1/2"): (arb(0, 3), arb(1)), ("1/2", "1/1"): fast}
    found = scripted({"0/1": arb(-2), "1/2": OPEN, "1/1": arb(1)}, pieces)
    assert isinstance(found, Crossing) is clear
    if isinstance(found, Crossing):
        assert found.rate > 0
        assert found.rate.contains(1)
        assert found.rate.contains(arb((1, exponent)))


@pytest.mark.parametrize(
    ("begin", "rate", "end", "clear"),
    [
        ("-1", "1", "1", True),
        ("0.5", "1", "1", False),
        ("0", "1", "1", False),
        ("-1", "0", "1", False),
        ("-1", "-1", "1", False),
        ("-1", "1", "0", False),
        ("-1", "1", "-0.5", False),
    ],
)
def test_a_bracket_needs_its_three_signs(begin: str, rate: str, end: str, clear: bool) -> None:
    """Of a stretch that is given: g < 0 at its begin, dg/dt > 0 on it and g > 0 at its end; the evidence says so."""
    with working_bits(64):
        watch = Watch("x", x, VectorField([y, number(0)]))
        points = {"0/1": arb(begin), "1/1": arb(end)}
        segment: Any = Scripted(points, {("0/1", "1/1"): (arb(0, 3), arb(rate, "0.01") if rate != "0" else arb(0))})
        found = watch._bracket([_Piece(segment, arb(0), arb(1))])
        assert isinstance(found, Crossing) is clear
        if isinstance(found, Crossing):
            first, second, third = found.evidence.facts
            assert first.endswith(" < 0")
            assert second.startswith("0 < ")
            assert third.startswith("0 < ")


def test_a_crossing_is_first_by_the_signs_of_all_functions() -> None:
    """A function that was not followed may have a zero before it."""
    found = scripted({"0/1": arb(-2), "1/2": arb(-1), "1/1": arb(1)}, {("0/1", "1/2"): RISING, ("1/2", "1/1"): RISING})
    assert isinstance(found, Crossing)
    assert len(found.evidence.facts) == 3
    field = VectorField([Constant(fmpq(1))])
    crossing, other, quiet = (Watch(name, Constant(fmpq(-1)), field) for name in ("g", "other", "quiet"))
    assert other.excluded(found.end) is None
    assert first_crossing([crossing, other], [found, None]) is None
    segment = next(iter(Run(field, [arb(0)], arb(1))))
    hit = replace(found, begin=Moment(segment, arb(0)), end=Moment(segment, arb(1)))
    assert quiet.along(segment) is None
    first = first_crossing([crossing, quiet], [hit, None])
    assert first is not None
    assert first[0] is hit
    assert first[1].facts == (*hit.evidence.facts, "-1.00000 < 0")


def test_a_function_is_excluded_only_up_to_where_it_was_followed() -> None:
    """g may vanish twice on the second quarter, and is negative again at 1: that says nothing of the time before."""
    unclear = {("0/1", "1/4"): NEGATIVE, ("1/2", "1/1"): NEGATIVE}
    with working_bits(64):
        watch = Watch("x", x, VectorField([y, number(0)]))
        segment = Scripted({"1/4": arb(-2), "1/1": arb(-2)}, unclear)
        assert isinstance(watch.along(segment), Unclear)  # type: ignore[arg-type]
        assert watch.excluded(Moment(segment, arb(1))) is None  # type: ignore[arg-type]
        assert watch.excluded(Moment(segment, arb(1) / 4)) is not None  # type: ignore[arg-type]


def test_a_moment_is_certainly_by_another_one_of_its_segment_only() -> None:
    segment, other = (next(iter(Run(OSCILLATOR, [arb(1), arb(0)], arb(1)))) for _ in range(2))
    half = Moment(segment, arb(1) / 2)
    assert half.certainly_by(Moment(segment, arb(1) / 2))
    assert half.certainly_by(Moment(segment, arb(1)))
    assert not half.certainly_by(Moment(segment, arb(1) / 4))
    assert not half.certainly_by(Moment(segment, arb("0.5", "0.1")))
    assert not half.certainly_by(Moment(other, arb(1)))


def test_without_saying_so_no_function_starts_at_zero() -> None:
    """-sin t falls from 0: only who says that it starts there may leave that zero out."""
    with working_bits(64):
        found = first(-x, [arb(0), arb(1)])
        assert isinstance(found, Unclear)


def test_a_wide_set_leaves_zero_on_several_pieces() -> None:
    """g = x^2 - 2 x with x' = 1 from 0, in a set of width 0.6: g falls while x < 1, and is certainly negative when all
    of the set has passed 0, after more than a step; it comes back at x = 2."""
    field = VectorField([number(1)])
    with working_bits(64):
        watch = Watch("g", x * x - x * number(2), field, from_zero=1)
        found = next(filter(None, map(watch.along, NormRun(field, [arb(0, "0.3")], arb(3)))))
        assert isinstance(found, Crossing)
        for start in (-0.29, 0, 0.29):
            assert found.time.contains(2 - arb(start))


def test_the_first_crossing_is_before_all_others() -> None:
    """cos t = 1/2 at pi/3, in one segment with cos t = 0.49; -x - 2 has no zero; of one twice none is first."""
    early, late, never = -x + number(1, 2), -x + number(49, 100), -x - number(2)
    for functions, expected in (([late, early, never], 1), ([early, late], 0), ([early, early], None)):
        with working_bits(128):
            watches = [Watch(str(i), function, OSCILLATOR) for i, function in enumerate(functions)]
            found: list[Crossing | Unclear | None] = []
            for segment in Run(OSCILLATOR, [arb(1), arb(0)], arb(3)):
                found = [watch.along(segment) for watch in watches]
                if any(found):
                    break
            first = first_crossing(watches, found)
            hit = None if first is None else first[0]
            assert (hit is None) is (expected is None)
            if hit is None or expected is None:
                assert [rivals(one, watches, found) for one in found if isinstance(one, Crossing)] == [["1"], ["0"]]
            else:
                assert hit is found[expected]
                assert hit.time.contains(arb.pi() / 3)
                assert rivals(hit, watches, found) == []


@pytest.mark.parametrize("radius", [fmpq(1, 2**10), fmpq(1, 2**60)])
def test_a_bracket_is_as_narrow_as_the_set_lets_it_be(radius: fmpq, monkeypatch: pytest.MonkeyPatch) -> None:
    """cos t from a box of starts: signs are certain but for about the radius; few places are asked for."""
    asked: list[int] = []
    own = Watch.value

    def counted(watch: Watch, states: list[arb]) -> arb:
        asked.append(1)
        return own(watch, states)

    monkeypatch.setattr(Watch, "value", counted)
    with working_bits(128):
        found = first(-x, [arb(arb(1).mid(), arb(radius)), arb(0)])
        assert isinstance(found, Crossing)
        for moment, sign in ((found.begin, -1), (found.end, 1)):
            states = moment.states()
            assert -states[0] * sign > 0
            assert abs(states[0]).lower() < states[0].rad() * arb(2) ** -19
    assert len(asked) < 60
