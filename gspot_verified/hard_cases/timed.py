"""How long the library takes for one answer: processor time, the package's caches empty before each call."""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import TypeVar

from gspot_verified.cost.times.measure import clear_caches

_REPEATS = 5  # of a short call
_LONG = 0.02  # seconds: then no further repeat

T = TypeVar("T")


def timed(call: Callable[[], T]) -> tuple[T, float]:
    """The answer and the best of five times; a long call is made once.

    >>> timed(lambda: 2)[0]
    2
    """
    seconds: list[float] = []
    while len(seconds) < _REPEATS and sum(seconds) < _LONG:
        clear_caches()
        start = time.process_time()
        answer = call()
        seconds.append(time.process_time() - start)
    return answer, min(seconds)
