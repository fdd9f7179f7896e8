"""When fast parts of a solution have died out, and how long a step that leaves them out may be. Heuristic."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from gspot_verified.integrator.norm_steps.slow_curve import FAST, SlowCurve

_SHARE = 0.12  # of the time in which eigenvalues change, for a slow step
_COUNTED = 0.02  # an eigenvalue with less in one step is not asked for its change
_LEAST_GAIN = 20.0  # in steps that resolve everything: a slow step must be worth as many
_DEAD = 0.62  # of the working bits: a part that has decayed by them is left out
_ACCEPTED = 0.8  # of the working bits that the last coefficients must be below 1
_TAIL_BITS = 16.0  # above the last one, at which the last coefficients are aimed
_LARGEST_CHANGE = 8.0  # of the length, from one slow step to the next
_RECOVERY = 1.3  # of the limit of the length, with each step that succeeds
_GAIN_AT_CONSTANT_RATES = 64.0  # in steps, where no eigenvalue changes
_RESOLVED = 5.0  # eigenvalue times length of the fastest part that is not left out


@dataclass(frozen=True, slots=True)
class DecayState:
    """What a :class:`FastDecay` has learned: eigenvalues, how far each part has decayed, lengths."""

    values: tuple[complex, ...]
    decayed: tuple[float, ...]
    scale: float
    length: float
    limit: float

    def to_json(self) -> list[Any]:
        """Plain data; floats as Python writes them, so that they are read back unchanged."""
        pairs = [[value.real, value.imag] for value in self.values]
        return [pairs, list(self.decayed), self.scale, self.length, self.limit]

    @classmethod
    def from_json(cls, data: Any) -> DecayState:
        """What was written.

        :raises ValueError: it is not of this form.
        """
        pairs, decayed, *lengths = data
        numbers = [*(part for pair in pairs for part in pair), *decayed, *lengths]
        if not all(type(x) is float for x in numbers) or len(lengths) != 3 or len(pairs) != len(decayed):
            raise ValueError("not the state of a decay")
        return cls(tuple(complex(*pair) for pair in pairs), tuple(decayed), *lengths)


class FastDecay:
    """Follows the eigenvalues from step to step: how far each has decayed, how fast all of them change."""

    def __init__(self) -> None:
        self._last: list[complex] = []
        self._decayed: list[float] = []
        self._scale = 0.0
        self._length = 0.0
        self._limit = math.inf

    @property
    def state(self) -> DecayState:
        """All that it has learned."""
        return DecayState(tuple(self._last), tuple(self._decayed), self._scale, self._length, self._limit)

    @state.setter
    def state(self, known: DecayState) -> None:
        """Go on from what was learned before."""
        self._last, self._decayed = list(known.values), list(known.decayed)
        self._scale, self._length, self._limit = known.scale, known.length, known.limit

    def passed(self, values: Sequence[complex], h: float) -> None:
        """A step of length h with these eigenvalues."""
        now = sorted(map(complex, values), key=lambda value: (-abs(value), value.imag))
        if len(self._last) != len(now):
            self._last, self._decayed = now, [0.0] * len(now)
            return
        changes = [(abs(a), abs(a - b)) for a, b in zip(now, self._last, strict=True) if abs(a) * h > _COUNTED]
        scale = min((size * h / change for size, change in changes if change > 1e-12 * size), default=math.inf)
        self._scale = _GAIN_AT_CONSTANT_RATES * h if scale == math.inf else _SHARE * scale
        self._decayed = [old - h * value.real for old, value in zip(self._decayed, now, strict=True)]
        self._last, self._length = now, 0.0

    def slow_length(self, bits: int, resolved: float) -> float:
        """The length of a slow step worth trying; 0: none is."""
        if self._length == 0.0:
            self._length = self._longest(bits)
        length = min(self._length, self._limit)
        return length if length > _LEAST_GAIN * resolved else 0.0

    def _longest(self, bits: int) -> float:
        """The longest step that leaves out the fastest directions, if they are dead, and resolves the others."""
        sizes = [abs(value) for value in self._last]
        best = 0.0
        for count in range(1, len(sizes)):
            if min(self._decayed[:count]) < _DEAD * bits * math.log(2):
                break
            length = min(self._scale, _RESOLVED / max(sizes[count], 1e-300))
            if sizes[count - 1] * length > FAST:
                best = max(best, length)
        return best

    def accepts(self, curve: SlowCurve | None, bits: int) -> bool:
        """Whether a curve is good enough; what is learned of lengths and of the time to wait."""
        if curve is None:
            self._wait(0.0)
            return False
        if curve.start > -_DEAD * bits:
            self._wait(max(0.0, -curve.start * math.log(2)))
            return False
        if curve.tail > -_ACCEPTED * bits:
            self.failed()
            return False
        change = 2 ** ((-bits + _TAIL_BITS - curve.tail) / (len(curve.jacobian) - 1))
        self._length *= min(change, _LARGEST_CHANGE)
        self._limit *= _RECOVERY
        return True

    def failed(self) -> None:
        """No step could be proved, or the series was too short for it."""
        self._limit = min(self._limit, self._length) / 2
        self._length = min(self._length, self._limit)

    def _wait(self, decayed: float) -> None:
        self._decayed = [min(old, decayed) for old in self._decayed]
        self._length = 0.0
