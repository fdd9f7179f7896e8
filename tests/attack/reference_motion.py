"""The model with compliant contact, phase after phase, by the plain Taylor method: nothing is bounded, all is precise.

Written from the equations of the paper, Sec. 2: in slip forwards lambda_N is lambda^+, backwards lambda^-, in stick it
is shared so that the slip velocity stays; contact opens where lambda_N falls through 0 and closes where y = z again.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction

from attack.reference_series import BITS, ORDER, Series, fixed, good_step, number, series, slope, solution, value

SLIP, STICK, REVERSE, FLIGHT = "slip", "stick", "reverse slip", "flight"
_POINTS = 24
_TINY = 1 << (BITS - 140)
"""Below 2^-140 a number is taken for 0: the method's own error is far below."""


class Unsure(Exception):
    """The reference itself cannot tell: a tie, a grazing event, a motion that leaves its numbers."""


@dataclass(frozen=True)
class Phase:
    """``rates`` of the states; ``events``: (name, function of the states); one happens where it falls through 0."""

    rates: Callable[[Sequence[Series]], Sequence[Series]]
    events: Callable[[Sequence[Series]], Mapping[str, Series]]


@dataclass
class Motion:
    """The states at times (T, phase, step's series) and the events (name, T)."""

    pieces: list[tuple[int, str, list[Series]]] = field(default_factory=list)
    events: list[tuple[str, Fraction]] = field(default_factory=list)
    end: int = 0

    def at(self, time: Fraction) -> tuple[str, list[Fraction]]:
        """The phase and the states at a time."""
        place = fixed(time)
        begin, phase, states = next(piece for piece in reversed(self.pieces) if piece[0] <= place)
        return phase, [number(value(state, place - begin)) for state in states]


Following = Callable[[str, str, Sequence[Fraction]], tuple[str, str, Sequence[Fraction]]]
"""(phase, event, states) -> (the event's name, the next phase, the states then)."""


def moved(
    phases: Mapping[str, Phase],
    first: str,
    start: Sequence[Fraction],
    until: Fraction,
    after: Following,
    most_events: int = 60,
    largest_state: int = 1 << 40,
    largest_step: Fraction = Fraction(1, 2),
) -> Motion:
    """Follow the motion to T = until, or until it has grown beyond all measure.

    :raises Unsure: an event is grazing, or two of them come together.
    """
    found, phase, now, states = Motion(), first, 0, [fixed(x) for x in start]
    end, fresh = fixed(until), True
    while now < end and len(found.events) < most_events:
        if max(map(abs, states)) >> BITS > largest_state:
            break
        series_now = solution(phases[phase].rates, states)
        step = min(good_step(series_now, fixed(largest_step)), end - now)
        events = phases[phase].events(series_now)
        hits = {
            name: hit for name, function in events.items() if (hit := _first_fall(function, step, fresh)) is not None
        }
        found.pieces.append((now, phase, series_now))
        if not hits:
            now, states, fresh = now + step, [value(state, step) for state in series_now], False
            continue
        name = min(hits, key=lambda key: hits[key])
        if any(abs(hits[other] - hits[name]) < _TINY for other in hits if other != name):
            raise Unsure(f"{' and '.join(hits)} come together at T = {float(number(now + hits[name]))}")
        now += hits[name]
        reached = [number(value(state, hits[name])) for state in series_now]
        shown, phase, following = after(phase, name, reached)
        found.events.append((shown, number(now)))
        states, fresh = [fixed(x) for x in following], True
    if any(abs(fixed(time) - end) < _TINY for _, time in found.events):
        raise Unsure("an event at the end of the time")
    found.end = now
    return found


def _first_fall(function: Series, step: int, fresh: bool) -> int | None:
    """Where the function first falls through 0 in the step. ``fresh``: it may begin at 0 there.

    :raises Unsure: it touches 0, or begins below.
    """
    begin = 0
    if abs(function[0]) < _TINY:
        if not fresh:
            raise Unsure("an event on the border of two steps")
        leading = next((k for k in range(1, 6) if abs(function[k]) >= _TINY), None)
        if leading is None:
            raise Unsure("a function of an event that begins at 0 and stays there")
        if function[leading] < 0:
            return 0 if leading == 1 else _unsure("falls below 0 at once")
        begin = _certainly_above(function, leading, step)
    elif function[0] < 0:
        raise Unsure("begins beyond an event")
    times = [begin + (step - begin) * k // _POINTS for k in range(_POINTS + 1)]
    values = [value(function, time) for time in times]
    slopes = [slope(function, time) for time in times]
    for k in range(_POINTS):
        if values[k + 1] < 0:
            return _bisected(lambda t: value(function, t), times[k], times[k + 1])
        if slopes[k] < 0 < slopes[k + 1]:
            lowest = _bisected(lambda t: -slope(function, t), times[k], times[k + 1])
            least = value(function, lowest)
            if abs(least) < _TINY:
                raise Unsure("a grazing event")
            if least < 0:
                return _bisected(lambda t: value(function, t), times[k], lowest)
    return None


def _certainly_above(function: Series, leading: int, step: int) -> int:
    """A time up to which the leading term, which is positive, is twice all that follow."""
    begin = step >> 12
    while begin >> (BITS - 240):
        rest = 0
        for k in range(ORDER, leading, -1):
            rest = (rest + abs(function[k])) * begin >> BITS
        if 2 * rest < function[leading]:
            return begin
        begin >>= 8
    return _unsure("leaves 0 for a moment only")


def _unsure(why: str) -> int:
    raise Unsure(why)


def _bisected(function: Callable[[int], int], low: int, high: int) -> int:
    """From a value >= 0 on the left to one < 0 on the right."""
    while high - low > 16:
        middle = (low + high) // 2
        low, high = (middle, high) if function(middle) >= 0 else (low, middle)
    return low


@dataclass(frozen=True)
class Model:
    """The model system and the extended example, in T = t/epsilon, Y = y/epsilon^2, V = v/epsilon, Z = z/epsilon^2.

    States: p, b, Y, V, Z, u. ``sticks``: whether slip may end; without it slip is always forwards.
    """

    epsilon: Fraction
    parameters: Mapping[str, Fraction]
    sticks: bool
    opens: bool = True

    def __getitem__(self, name: str) -> Fraction:
        return self.parameters[name]

    def phases(self) -> dict[str, Phase]:
        """All four; those that cannot occur are never entered."""
        return {name: Phase(self._rates(name), self._events(name)) for name in (SLIP, STICK, REVERSE, FLIGHT)}

    def shares(self, phase: str, force: Series) -> tuple[Series, Series]:
        """lambda^+ and lambda^-."""
        none = series(0)
        if phase == STICK:
            width = self["k_minus"] - self["k_plus"]
            forward = (force * self["k_minus"] + self["a"]) / width
            return forward, force - forward
        return {SLIP: (force, none), REVERSE: (none, force), FLIGHT: (none, none)}[phase]

    def _rates(self, phase: str) -> Callable[[Sequence[Series]], Sequence[Series]]:
        eps = self.epsilon

        def rates(states: Sequence[Series]) -> Sequence[Series]:
            p, b, Y, V, Z, _ = states
            force = series(0) if phase == FLIGHT else (Z - Y) * self["k_2"]
            forward, backward = self.shares(phase, force)
            drag = forward * self["k_plus"] + backward * self["k_minus"] + self["a"]
            return [
                (b * self["chi"] + self["alpha_1"]) * eps,
                (self["alpha_2"] - forward * (self["beta"] * self["alpha_1"])) * eps,
                V,
                b + p * forward + backward * self["p_minus"],
                (Z * -self["k_1"] - force) / self["damping"],
                series(0) if phase == STICK else drag * eps,
            ]

        return rates

    def _events(self, phase: str) -> Callable[[Sequence[Series]], Mapping[str, Series]]:
        def events(states: Sequence[Series]) -> Mapping[str, Series]:
            _, _, Y, _, Z, u = states
            if phase == FLIGHT:
                return {"touch-down": Y - Z}
            found: dict[str, Series] = {"lift-off": Z - Y} if self.opens else {}
            slip = u - self["belt_velocity"]
            if self.sticks and phase == STICK:
                forward, backward = self.shares(STICK, (Z - Y) * self["k_2"])
                if self._can_end(forward=True):
                    found["slip backwards"] = forward
                if self._can_end(forward=False):
                    found["slip forwards"] = backward
            elif self.sticks:
                found["stop"] = slip if phase == SLIP else -slip
            return found

        return events

    def _can_end(self, forward: bool) -> bool:
        """Whether the share can vanish while lambda_N > 0."""
        a = self["a"]
        return not (self["k_minus"] > 0 and a >= 0) if forward else not (self["k_plus"] < 0 and a <= 0)

    def first(self, start: Sequence[Fraction]) -> str:
        """The phase at the start."""
        _, b, Y, V, Z, _ = start
        rate = self["k_1"] / self["damping"]
        # Z - Y and its derivatives without force: Z' = -rate Z, Y' = V, V' = b, b' = epsilon alpha_2.
        third = -(rate**3) * Z - self.epsilon * self["alpha_2"]
        signs = (Z - Y, -rate * Z - V, rate * rate * Z - b, third, rate**4 * Z)
        gap = next((value for value in signs if value), Fraction(0))
        if gap == 0:
            raise Unsure("whether contact begins")
        if gap < 0 and self.opens:
            return FLIGHT
        return self._on_surface(start)

    def _on_surface(self, states: Sequence[Fraction]) -> str:
        slip = states[5] - self["belt_velocity"]
        if not self.sticks or slip > 0:
            return SLIP
        return REVERSE if slip < 0 else self._at_rest(states)

    def _at_rest(self, states: Sequence[Fraction]) -> str:
        force = self["k_2"] * (states[4] - states[2])
        # Where one of them is 0, exactly, its derivative in stick decides: Z' - V, Z' = (-k_1 Z - force)/damping.
        growth = self["k_2"] * ((-self["k_1"] * states[4] - force) / self["damping"] - states[3])
        held = ((self["k_minus"], 1, REVERSE), (-self["k_plus"], -1, SLIP))
        for k, sign, phase in held:
            part = k * force + sign * self["a"]
            if not self._can_end(forward=phase == REVERSE):
                continue
            if part == 0 and abs(k * growth) >= number(_TINY):
                part = k * growth
            elif abs(part) < number(_TINY):
                raise Unsure("whether friction holds the contact")
            if part < 0:
                return phase
        return STICK

    def after(self, phase: str, event: str, states: Sequence[Fraction]) -> tuple[str, str, Sequence[Fraction]]:
        """What follows an event."""
        if event == "lift-off":
            return event, FLIGHT, states
        if event == "touch-down":
            if self.sticks and phase == FLIGHT and abs(states[5] - self["belt_velocity"]) < number(_TINY):
                if self["a"] != 0:
                    raise Unsure("slip velocity at touch-down")
                states = [*states[:5], self["belt_velocity"]]
            return event, self._on_surface(states), states
        if event == "stop":
            held = [*states[:5], self["belt_velocity"]]
            following = self._at_rest(held)
            return {STICK: "stick", SLIP: "slip forwards", REVERSE: "slip backwards"}[following], following, held
        return event, SLIP if event == "slip forwards" else REVERSE, states
